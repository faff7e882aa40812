"""What leads on from an alarm, and which options had no effect: said beside a run, never in it."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from cncsub._core import Alarm, Control
from cncsub.beside import files_named
from cncsub.library import Library
from cncsub.notes import Note
from cncsub.project import project_for
from cncsub.references import Computed
from cncsub.run import Run, Stop

MOST_BLOCKS = 20_000  # of a run that is tried again, and of a memory that is searched
MOST_SECONDS = 1.0
MOST_TOLD = 3
MOST_TEXT = 20_000  # letters of a program that are looked at

# How programs of other languages look, and the control here that reads them, if there is one.
_LANGUAGES: tuple[tuple[str, str, str | None], ...] = (
    (r"^\s*\d+\s+BEGIN PGM\b", "Heidenhain (Klartext)", None),
    (
        r"^\s*(?:N\d+\s+)?R\d+\s*=|^\s*(?:N\d+\s+)?M17\b|^%_N_\w+_(?:MPF|SPF)",
        "SINUMERIK",
        "siemens-one",
    ),
    (r"^\s*o(?:\d+|<\w+>)\s+(?:sub|call|if|while)\b|^\s*#<\w+>\s*=", "LinuxCNC", "linuxcnc"),
    (r"^\s*(?:N\w+\s+)?(?:CALL\s+O\w+|RTS\b|V[CZ]\d*\w*\s*=)", "Okuma (OSP)", None),
    (r"^\s*(?:N\d+\s*)?G65\s*H\d+\s*P#", "GSK 980 or FANUC macro A", "gsk-980tdi"),
)


def hints_of(library: Library, run: Run, asked: Mapping[str, Any], main: Any = None) -> list[str]:
    """What leads on from the alarm of a run; `asked` are the options it ran with."""
    alarm = run.alarm
    if alarm is None:
        return []
    hints = list(_missing_program(library, alarm))
    if (other := _language(library, alarm)) is not None:
        hints.append(other)
    elif not hints:
        hints += _allowed(library, run, alarm, asked, main)
    return hints


# ---- a program that is missing ----


def _missing_program(library: Library, alarm: Alarm) -> Iterator[str]:
    if not alarm.cause.endswith("program-not-found"):
        return
    name = (alarm.detail or "").split(" ")[0]
    outside = alarm.cause == "external-program-not-found"
    if outside and not library.external:
        yield "--external FOLDER names what M198 reads; without it the external device is empty"
    if outside and name in library:
        yield f"{name} is in the memory, where M98 calls it"
    if not outside and name in library.external:
        yield f"{name} is on the external device, where M198 calls it"
    beside = files_named(Path(alarm.file).parent, name, library) if alarm.file else ()
    for file in beside:
        yield f"{file} was not read: name it, or its folder, too"


# ---- another language ----


def _language(library: Library, alarm: Alarm) -> str | None:
    """The language that a program seems to be written in, where the control reads another one."""
    program = library.get(alarm.program)
    if program is None:
        return None
    text = program.text[:MOST_TEXT]
    for pattern, name, control in _LANGUAGES:
        if control == library.control.name or not re.search(pattern, text, re.M | re.I):
            continue
        if control is None:
            return f"it seems to be written in the language of {name}, which no control here reads"
        read = library.read_for(control).run(max_blocks=1_000, trace="none")
        if read.alarm is None or read.blocks > 0:
            return f"it seems to be written for {name}: -c {control}"
    return None


# ---- what allows what was refused ----


def _allowed(
    library: Library, run: Run, alarm: Alarm, asked: Mapping[str, Any], main: Any
) -> Iterator[str]:
    """Parameters and options with which the run goes past the block: each is tried."""
    if run.blocks > MOST_BLOCKS:
        return
    end = time.monotonic() + MOST_SECONDS
    options = {**asked, "trace": "calls", "watch": (), "max_blocks": run.blocks + 1}
    told = 0
    for words, control in _changed(library.control):
        if told == MOST_TOLD or time.monotonic() > end:
            return
        again = library.read_for(control).run(main, **options)
        if again.alarm is None and again.stop is not Stop.WAITING and again.blocks >= run.blocks:
            told += 1
            yield words


def _changed(control: Control) -> Iterator[tuple[str, Control]]:
    """The control with one parameter or one option changed, and how to ask for that."""
    for parameter in control.parameters.values():
        if "#" in parameter.name and parameter.value in (0, 1):
            value = 1 - int(parameter.value)
            words = f"--param {parameter.name}={value} lets it pass: {parameter.meaning}"
            yield words, control.with_parameters({parameter.name: value})
    for option in control.variable_options.values():
        if not option.fitted:
            try:
                changed = control.replace(**{option.rule: option.name})
            except (TypeError, ValueError):
                continue
            yield f"the control's option {option.name} lets it pass: {option.numbers}", changed


# ---- options nobody gave, and options without effect ----


def defaulted(options: Mapping[str, Any]) -> Iterator[Note]:
    """A note where the control is the project's, because no option named one."""
    project = project_for(options.get("paths"))
    if options["control"] is None and project.control is not None:
        told = f"the control is {project.control}, which the project names"
        yield Note("defaulted", told, str(project.file))


def without_effect(library: Library, asked: Mapping[str, Any]) -> Iterator[Note]:
    """A note for each option that no block asks for, where the blocks can be read through."""
    programs = [*library.values(), *library.external.values()]
    if sum(len(program.blocks) for program in programs) > MOST_BLOCKS:
        return
    if variables := asked.get("variables"):
        read = _read_variables(library)
        for number in variables if read is not None else ():
            if number not in (read or ()):
                yield _note("--set, --variables", f"no block reads #{number}")
    text = "\n".join(program.text for program in programs)
    if len(library.external) and not any(e.kind == "M198" for e in library.call_graph().edges):
        yield _note("--external", "no block calls a program of the external device by M198")
    if asked.get("block_skip") and "/" not in text:
        yield _note("--skip", "no block has a slash")
    if asked.get("optional_stop") and not re.search(r"M0?1(?!\d)", text, re.I):
        yield _note("--optional-stop", "no block has M01")
    inputs = asked.get("inputs")
    if inputs is not None:
        if inputs.skips and not re.search(r"G\s*(?:0*31|36|37|38|04|4)(?!\d)", text, re.I):
            yield _note("--inputs", "skips are told, but no block waits for a skip signal")
        for code in inputs.answers:
            number = code[1:].lstrip("0") or "0"
            if not re.search(rf"{code[0]}0*{number}(?!\d)", text, re.I):
                yield _note("--inputs", f"an answer to {code} is told, which no block names")


def _note(option: str, message: str) -> Note:
    return Note("no-effect", f"no effect: {message}", option)


def _read_variables(library: Library) -> set[int] | None:
    """The variables that blocks read by number; `None` where one is computed."""
    found: set[int] = set()
    for program in [*library.values(), *library.external.values()]:
        for block in program.blocks:
            for use in block.reads:
                if isinstance(use.variable, Computed):
                    return None
                if isinstance(use.variable, int):
                    found.add(use.variable)
    return found
