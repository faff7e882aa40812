"""Hints that lead on from an alarm, and notes on options without effect. They stand beside a run,
never in it.
"""

from __future__ import annotations

import functools
import os
import re
import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from cncsub import _core
from cncsub._core import Alarm, Control
from cncsub.analysis.notes import Note
from cncsub.analysis.static_tree import LETTERS
from cncsub.checking import Finding
from cncsub.controls import controls
from cncsub.inputs import by_number
from cncsub.interrupts import uninterrupted
from cncsub.library import Library
from cncsub.lines import lines_of
from cncsub.number_text import length_text, number_text
from cncsub.program import Program, Word, words_of
from cncsub.run import Run, Stop
from cncsub.setup import Setup
from cncsub.sibling_files import files_named, folders_in, folders_of

MOST_BLOCKS = 20_000  # of a run that is tried again, and of a memory that is searched
MOST_SECONDS = 1.0
MOST_TOLD = 3
MOST_FILES = 200  # whose language is guessed
MOST_TEXT = 20_000  # letters of a program that are looked at

# Patterns of programs in other languages, and the control here that reads each, if there is one.
_LANGUAGES: tuple[tuple[str, str, str | None], ...] = (
    (
        r"^ *(?:\d+ +)?(?:BEGIN PGM\b|BLK FORM\b|TOOL CALL +\d|CYCL DEF +\d|CALL (?:LBL|PGM)\b"
        r"|LBL +\d+ *$|FN *\d+ *: *Q|L +[XYZABC][+-]\d|CC +[XY][+-]|CYCL CALL\b)",
        "Heidenhain (Klartext)",
        None,
    ),
    (
        r"^ *(?:\d+ +)?UNO\.? +(?:MAT|UNIT)\b|\bINITIAL-Z\b|^ *SNO\.? +TOOL\b"
        r"|^ *FIG +PTN\b|\bATC +MODE\b",
        "Mazatrol",
        None,
    ),
    (
        r"^ *(?:N\d+ +)?R\d+ *=|^ *(?:N\d+ +)?M17\b|^%_N_\w+_(?:MPF|SPF)"
        r"|^ *(?:N\d+ +)?(?:DEF +(?:INT|REAL|BOOL|CHAR|STRING|AXIS|FRAME)\b|MCALL\b|MSG *\("
        r"|(?:CYCLE|POCKET|SLOT|LONGHOLE|HOLES)\d* *\(|A?(?:TRANS|ROT) +[XYZ]|PROC +\w|EXTERN +\w)"
        r"|\bGOTO[FB] +\w|\b[XYZ] *= *(?:R\d|[AI]C *\()",
        "SINUMERIK",
        "siemens-one",
    ),
    (r"^ *o(?:\d+|<\w+>) +(?:sub|call|if|while)\b|^ *#<\w+> *=", "LinuxCNC", "linuxcnc"),
    (r"^ *(?:N\w+ +)?(?:CALL +O\w+|RTS\b|V[CZ]\d*\w* *=)", "Okuma (OSP)", "okuma-osp-p300"),
    (
        r"^ *(?:N\d+ *)?#(?:[VR]\d+ *=|(?:IF|GOTO|PRINT|INPUT|CLEAR)\b|:[A-Z])"
        r"|^ *N\d+ *O\d+ *(?:\(|$)",
        "Fadal",
        None,
    ),
    (
        r"^%[^\n,]*, *M[X-]|^ *(?:N\d+ *)?(?:\( *(?:P\d+ *=|IF P\d|CALL *\d+ *\)|RET *\))"
        r"|\$(?:IF|GOTO|FOR|WHILE|ENDIF)\b|#(?:P?CALL|MCALL|SUB|RET)\b)",
        "Fagor",
        None,
    ),
    (r"^ *(?:N\d+ *)?@\d+ *=(?!=)", "LNC", None),
    (r"^ *(?:N\d+ *)?G65 *H\d+ *P#", "GSK 980 or FANUC macro A", "gsk-980tdi"),
    (r"^ *(?:N\d+ *)?(?:END_(?:IF|WHILE|FOR|REPEAT)\b|[@#]\d+ *:=)", "Syntec", "syntec-22ma"),
    (r"^ *(?:N\d+ *)?(?:ELSE|ENDIF)\b", "the Mitsubishi M800", "mitsubishi-m800"),
    (r"^ *(?:N\d+ *)?(?:ELSE|ENDIF|ENDW)\b", "Huazhong", "hnc-21m"),
)


# Rules by which a control refuses a form of writing. A parameter of these alone is offered: the
# block means the same with either value. Any other parameter would make the program mean something
# else, which is no cure for an alarm.
_PERMITS = re.compile(
    r"refuses:.*|missing_end|cancel_alone|main_return|start_word|omitted_program|conditions:joined"
)


def hints_of(
    library: Library, run: Run, asked: Mapping[str, Any], main: Any = None, mdi: str | None = None
) -> list[str]:
    """Return what leads on from the alarm of a run, or from its waiting. `asked`: the options that
    it ran with; `mdi`: what was typed.
    """
    alarm = run.alarm
    called = None if mdi is not None else library.main if main is None else library[main]

    def again(other: Library = library, **options: Any) -> Run:
        if mdi is not None:
            tried = other.mdi(mdi, **{**asked, "trace": "calls", "watch": (), **options})
        else:
            tried = other.run(main, **{**asked, "trace": "calls", "watch": (), **options})
        return uninterrupted(tried)

    if run.stop is Stop.WAITING:
        return list(_answers(run, asked, again))
    if alarm is None:
        foreign = None if mdi is not None else foreign_language(library)
        if foreign is not None:
            return [foreign]
        return [*_unanswered_skips(run, asked, again), *_macro_as_main(library, run, asked, called)]
    hints = [*_missing_program(library, alarm), *_macro_as_main(library, run, asked, called)]
    if (other := _language(library, run, alarm, mdi, again)) is not None:
        hints.append(other)
    elif not hints:
        hints += _allowed(library, run, again)
        hints += () if hints else _joined(library, alarm, mdi)
        hints += () if hints else _lathe(library.control, alarm)
        hints += () if hints else _who_has(library.control, alarm)
    return hints


# ---- a program that is missing ----


def _missing_program(library: Library, alarm: Alarm) -> Iterator[str]:
    if not alarm.cause.endswith("program-not-found"):
        return
    name = (alarm.detail or "").split(" ")[0]
    outside = alarm.cause == "external-program-not-found"
    if outside and not library.external:
        yield (
            "give --external FOLDER, the folder from which M198 calls; without it the"
            " external device is empty"
        )
    if outside and name in library:
        yield f"{name} is in the memory, where M98 calls it"
    if not outside and name in library.external:
        yield f"{name} is on the external device, where M198 calls it"
    # What was typed in MDI is in no folder.
    files = [alarm.file] if alarm.file in library.files else library.files[:1]
    folders = {folder: None for file in files for folder in folders_of(file)}
    folders |= {inner: None for folder in list(folders) for inner in folders_in(folder)}
    device = {os.path.realpath(program.file) for program in library.external.values()}
    for file, fault in (
        found for folder in folders for found in files_named(folder, name, library)
    ):
        if os.path.realpath(file) not in device:
            cure = "give it, or its folder, too" if fault is None else f"{fault}; give it too"
            yield f"{file} was not read: {cure}"


# ---- another language ----


_NOT_COMPUTED = "code-not-computed"  # the control has it, and a run stops there all the same


def _language(
    library: Library, run: Run, alarm: Alarm, mdi: str | None, again: Callable[..., Run]
) -> str | None:
    """Return the language that a program seems to be written in, where the control reads another
    one.
    """
    program = library.get(alarm.program)
    for name, control in languages_of(mdi or "" if program is None else program.text):
        if control == library.control.base:
            continue
        if control is None:
            return _seems(name, control)
        try:
            read = again(library.read_for(control), max_blocks=1_000, trace="none")
        except (KeyError, ValueError):  # that control has no such program, variable, axis
            continue
        other = read.alarm
        if other is None or other.cause == _NOT_COMPUTED or read.blocks > run.blocks:
            return _seems(name, control)
    return None


def _seems(name: str, control: str | None) -> str:
    if control is None:
        return f"it seems to be written in the language of {name}, which no control of cncsub reads"
    return f"it seems to be written for {name}: -c {control}"


def languages_of(text: str) -> Iterator[tuple[str, str | None]]:
    """Yield the languages that a text looks like, and the control here that reads each, if there is
    one.
    """
    for pattern, name, control in _LANGUAGES:
        if re.search(pattern, text[:MOST_TEXT], re.M | re.I):
            yield name, control


def foreign_language(library: Library, files: Collection[str] | None = None) -> str | None:
    """Return, as a hint, the languages of files of the memory, or of its first file, that no
    control here reads. They are named even where their blocks would run.
    """
    sources = [(name, text) for name, _, text, _ in library.code.sources]
    if files is None:
        asked = sources[:1]
    else:
        asked = [each for each in sources if each[0] in files][:MOST_FILES]
    told: dict[str, list[str]] = {}
    for name, source in asked:
        text = source[:MOST_TEXT].decode(errors="replace")
        found = next((known for known, control in languages_of(text) if control is None), None)
        if found is not None:
            told.setdefault(found, []).append(name)
    if len(asked) == 1:
        return next((_seems(known, None) for known in told), None)
    return "; ".join(_each_seems(known, of) for known, of in told.items()) or None


def _each_seems(language: str, files: list[str]) -> str:
    more = len(files) - MOST_TOLD
    named = ", ".join(files[:MOST_TOLD]) + (f" and {more} more" if more > 0 else "")
    seem = "seems" if len(files) == 1 else "seem"
    return (
        f"{named} {seem} to be written in the language of {language}, which no control of"
        " cncsub reads"
    )


def language_beside_findings(
    library: Library,
    found: list[Finding],
    check: Callable[[Library], list[Finding]],
    files: Collection[str],
) -> str | None:
    """Return, as a hint, the language of the files that were asked for: one that no control here
    reads, or one in which a file has fewer errors.
    """
    if (foreign := foreign_language(library, files)) is not None or not found:
        return foreign
    others: dict[str, list[Finding]] = {}
    looked_at = 0
    for name, _, source, _ in library.code.sources:
        errors = _errors_in(name, found) if name in files else 0
        for language, control in languages_of(source[:MOST_TEXT].decode(errors="replace")):
            if not errors or control in (None, library.control.base) or looked_at == MOST_TOLD:
                continue
            looked_at += 1
            try:
                if control not in others:
                    others[control] = check(library.read_for(control))
            except (KeyError, ValueError):  # that control has no such program
                continue
            if _errors_in(name, others[control]) < errors:
                hint = _seems(language, control)
                return hint if len(files) == 1 else f"{name}: {hint}"
    return None


def _errors_in(file: str, found: list[Finding]) -> int:
    """Return how many places of a file have errors."""
    errors = [finding for finding in found if finding.severity == "error"]
    files = (at for f in errors for at in (f.file, *(place.file for place in f.places)))
    return sum(at == file for at in files)


def other_reading(library: Library, file: str) -> str | None:
    """Return, as a hint, the control for which a file of the memory seems to be written, where the
    file, read so, holds no two programs of one name.
    """
    sources = {name: text for name, _, text, _ in library.code.sources}
    for name, control in languages_of(sources.get(file, b"").decode(errors="replace")):
        if control == library.control.base:
            continue
        if control is None or all(
            program.file != file for program in library.read_for(control).duplicates
        ):
            return _seems(name, control)
    return None


# ---- what allows what was refused ----


def _allowed(library: Library, run: Run, again: Callable[..., Run]) -> Iterator[str]:
    """Yield parameters and options with which the run goes past the block; each is tried."""
    if run.blocks > MOST_BLOCKS:
        return
    end = time.monotonic() + MOST_SECONDS
    told = 0
    for words, control in changed_controls(library.control):
        if told == MOST_TOLD or time.monotonic() > end:
            return
        tried = again(library.read_for(control), max_blocks=run.blocks + 1)
        if tried.alarm is None and tried.stop is not Stop.WAITING and tried.blocks >= run.blocks:
            told += 1
            yield words


def changed_controls(control: Control) -> Iterator[tuple[str, Control]]:
    """Yield how to ask for one changed parameter or option, and the control that has it."""
    for parameter in control.parameters.values():
        rules = parameter.rules
        permits = bool(rules) and all(map(_PERMITS.fullmatch, rules))
        if permits and "#" in parameter.name and parameter.value in (0, 1):
            value = 1 - int(parameter.value)
            words = f"--param {parameter.name}={value} allows it: {parameter.meaning}"
            yield words, control.with_parameters({parameter.name: value})
    for option in control.variable_options.values():
        if not option.fitted:
            try:
                changed = control.replace(**{option.rule: option.name})
            except (TypeError, ValueError):
                continue
            yield f"the control's option {option.name} adds it: {option.numbers}", changed


def _lathe(control: Control, alarm: Alarm) -> Iterator[str]:
    """Yield a hint on a lathe program where the control is described as a mill alone."""
    if "turning" not in control.absent or alarm.cause not in _REFUSED:
        return
    if _g_code(control, alarm) in _OF_LATHES:
        yield (
            f"{control.name} exists only as a mill ({control.title}), and {alarm.word} is of"
            " lathes:"
            f" no lathe with this control is known here"
        )


_REFUSED = ("g-code-not-available", "code-not-known", "code-not-computed")
_OF_LATHES = (32, 33, 34, 70, 71, 72, 73, 74, 75, 76, 90, 92, 96, 97)


def _g_code(control: Control, alarm: Alarm) -> float | None:
    """Return the G code that an alarm points at."""
    words = words_of(control, alarm.word or "")
    return words[0].value if len(words) == 1 and words[0].address == "G" else None


def _joined(library: Library, alarm: Alarm, mdi: str | None) -> Iterator[str]:
    """Yield how conditions are joined, where a block joins them otherwise."""
    if alarm.cause != "if-format" or not any(map(_joins, _words_of(library, alarm, mdi))):
        return
    for parameter in library.control.parameters.values():
        if "conditions:joined" in parameter.rules:
            given = "" if parameter.value else f", with --param {parameter.name}=1"
            yield f"write joined conditions as IF[[#1EQ#2]AND[#3EQ#4]]{given}: {parameter.meaning}"


def _joins(word: Word) -> bool:
    """Whether a macro statement holds AND, OR or XOR."""
    return not word.address and any(name in word.text.upper() for name in ("AND", "OR"))


def _words_of(library: Library, alarm: Alarm, mdi: str | None) -> list[Word]:
    """Return the words of the block that alarmed."""
    program = library.get(alarm.program)
    if program is not None:
        return next((list(b.words) for b in program.blocks if b.line == alarm.line), [])
    text = "".join(lines_of(mdi or "")[alarm.line - 1 : alarm.line])
    return words_of(library.control, text)


def _who_has(control: Control, alarm: Alarm) -> Iterator[str]:
    """Yield the controls that have a G code which this control has not."""
    code = _g_code(control, alarm)
    if alarm.cause != "g-code-not-available" or code is None:
        return
    names = [
        other.name
        for other in controls.values()
        if other.name != control.base
        and any(r.name == "g_codes" and f"{code:g}" in str(r.value).split() for r in other.rules)
        and _computes(other, f"G{code:g}")
    ]
    if names:
        yield f"{alarm.word} is a code of {', '.join(names)}"


def _computes(control: Control, code: str) -> bool:
    """Return whether a control has a code and runs a block that names it alone."""
    from cncsub.loading import loads

    return not loads(f"N1 {code}\n", control=control).check(rules=["CS102", "CS105"])


# ---- what lets pass what a check finds ----


def with_ways_past(
    library: Library, found: list[Finding], check: Callable[[Library], list[Finding]]
) -> list[Finding]:
    """Return the findings, each with the parameter or option that makes it disappear; each is
    tried.
    """
    wanted = {_place(f): f for f in found if f.rule in _MAY_PASS}
    blocks = sum(len(program.blocks) for program in library.values())
    if not wanted or blocks > MOST_BLOCKS:
        return found
    end = time.monotonic() + MOST_SECONDS
    hints: dict[tuple[Any, ...], list[str]] = {}
    for words, control in changed_controls(library.control):
        if time.monotonic() > end:
            break
        left = {_place(f) for f in check(library.read_for(control))}
        alarming = {place[1:] for place in left if place[0] in _MAY_PASS}
        for place in wanted:
            if place not in left and place[1:] not in alarming:
                hints.setdefault(place, []).append(words)
    return [
        replace(f, hint="; ".join((*hints.get(_place(f), ())[:MOST_TOLD], f.hint))) for f in found
    ]


_MAY_PASS = ("CS101", "CS102", "CS103", "CS104", "CS303", "CS704")  # a parameter may allow them


def _place(finding: Finding) -> tuple[Any, ...]:
    return (finding.rule, finding.file, finding.line, finding.column)


# ---- what nobody gave ----


def _answers(run: Run, asked: Mapping[str, Any], again: Callable[..., Run]) -> Iterator[str]:
    """Yield a line for a file of inputs with which the run goes on; each is tried."""
    number = re.fullmatch(r"#(\d+)", run.waiting_for or "")
    if number is None or asked.get("inputs") is not None or run.blocks > MOST_BLOCKS:
        return
    told = int(number[1])
    for value in (1, 0):
        for words, inputs in (
            (f"signals = {{ {told} = {value} }}", {"signals": {told: value}}),
            (f"writes = [{{ {told} = {value} }}]", {"writes": [{told: value}]}),
        ):
            try:
                tried = again(max_blocks=run.blocks + 1_000, inputs=inputs)
            except ValueError:  # it is no signal, or nobody may write it
                continue
            if tried.waiting_for != run.waiting_for:
                yield f"give the answer with --inputs FILE, a file with a line such as {words}"
                return


def _unanswered_skips(
    run: Run, asked: Mapping[str, Any], again: Callable[..., Run]
) -> Iterator[str]:
    """Yield a file of inputs with which a probe touches something, where none said what it meets.
    It is tried.
    """
    if not run.missed_skips or asked.get("inputs") is not None or run.blocks > MOST_BLOCKS:
        return
    missed = run.missed_skips[0]
    move = next((m for m in run.moves if m.step == missed.step and m.skip == "missed"), None)
    if move is None or move.sx is None:
        return
    ways = {
        a: getattr(move, a) - getattr(move, f"s{a}") for a in "xyz" if getattr(move, a) is not None
    }
    axis = max(ways, key=lambda a: abs(ways[a]))
    at, faces = getattr(move, axis) - ways[axis] / 2, "-" if ways[axis] > 0 else "+"
    solid = {"plane": {axis.upper(): at}, "faces": f"{faces}{axis.upper()}"}
    tried = again(inputs={"workpiece": {"stylus": 0, "solids": [solid]}})
    if len(tried.missed_skips) < len(run.missed_skips):
        plane = f"{{ {axis.upper()} = {length_text(at)} }}"
        yield (
            "describe what the probe touches with --inputs FILE, such as a face halfway:\n"
            "[workpiece]\n"
            "stylus = 3 # the radius of its ball\n"
            f'solids = [{{ plane = {plane}, faces = "{solid["faces"]}" }}]'
        )


# ---- a macro that runs as the main program ----


def _macro_as_main(
    library: Library, run: Run, asked: Mapping[str, Any], program: Program | None
) -> Iterator[str]:
    """Yield how a main program is called that reads arguments, which only a call gives."""
    user_alarm = run.alarm is not None and run.alarm.cause == "user-alarm"
    if program is None or not (user_alarm or run.stop is Stop.CYCLES):
        return
    number = re.fullmatch(r"[O%]?0*(\d{1,8})", program.name)
    (roles,) = (str(rule.value) for rule in library.control.rules if rule.name == "roles")
    if number is None or "G65=macro-call" not in roles.split():
        return
    given = {use.variable for block in program.blocks for use in block.writes}
    read = (_read_variables([program]) or set()) - given - set(asked.get("variables") or ())
    letters = [letter for n, letter in sorted(LETTERS.items()) if n in read]
    tried = uninterrupted(library.mdi(f"G65 P{number[1]}", trace="none", max_blocks=1))
    if letters and tried.alarm is None:
        call = f"G65 P{number[1]} {' '.join(f'{letter}...' for letter in letters)}"
        yield (
            f"{program.name} reads the arguments {', '.join(letters)}, and has none as the main"
            f' program: call it with --mdi "{call}"'
        )


# ---- lengths without a point ----


def lengths_without_point(run: Run, asked: Mapping[str, Any]) -> Iterator[Note]:
    """Yield a note on lengths without a point in the programs that ran, where the control counts
    them in increments.
    """
    setup = asked.get("setup") or Setup()
    found = _core.lengths_without_point(run.recorded, setup.machine or "")
    if found is None:
        return
    count, address, value, program, n, line = found
    inches = run.modal.get("units") == "G20"
    increment = (setup.increment or 0.001) * (0.1 if inches else 1)
    length = f"{value * increment:.{4 if inches else 3}f} {'inch' if inches else 'mm'}"
    lengths = "1 length has" if count == 1 else f"{count:,} lengths have"
    place = f"{program} line {line}" if n is None else f"{program} N{n}"
    yield Note(
        "increments",
        f"{lengths} no decimal point: {address}{number_text(value)} at {place} is {length}",
        program,
    )


# ---- options without effect ----


def without_effect(
    library: Library, asked: Mapping[str, Any], typed: Program | None = None
) -> Iterator[Note]:
    """Yield a note for each option that no block asks for, where the blocks can be read through.
    `typed`: what was typed in MDI.
    """
    programs = [*library.values(), *library.external.values(), *([typed] if typed else ())]
    if sum(len(program.blocks) for program in programs) > MOST_BLOCKS:
        return
    control = library.control
    name = functools.partial(_core.variable_name, control)
    if variables := asked.get("variables"):
        read = _read_variables(programs)
        for number in by_number("variables", control, variables) if read is not None else ():
            if number not in (read or ()):
                yield _note("--set, --variables", f"no block reads {name(number)}")
    called = any(e.kind == "M198" for e in library.call_graph().edges)
    if len(library.external) and not called and not (typed and _calls_outside(typed)):
        yield _note("--external", "no block calls a program of the external device by M198")
    if asked.get("block_skip") and not _any_word(programs, "/"):
        yield _note("--skip", "no block has a slash")
    if asked.get("optional_stop") and not _any_word(programs, "M", 1):
        yield _note("--optional-stop", "no block has M01")
    if (setup := asked.get("setup")) is not None:
        yield from _of_another_machine(library.control, setup)
    inputs = asked.get("inputs")
    if inputs is not None:
        read = _read_variables(programs)
        for number in by_number("signals", control, inputs.signals) if read is not None else ():
            if number not in (read or ()):
                yield _note("--inputs", f"no block reads the signal {name(number)}")
        if (inputs.skips or inputs.workpiece) and not _any_word(programs, "G", *_PROBING):
            yield _note("--inputs", "there is a workpiece or a skip, but no block probes")
        for code in inputs.answers:
            if not _any_word(programs, code[0], int(code[1:])):
                yield _note("--inputs", f"there is an answer to {code}, but no block has {code}")


_PROBING = (31, 36, 37, 38, 4)  # G31, those of measuring, and the dwell that a signal ends


def _any_word(programs: Iterable[Program], address: str, *codes: int) -> bool:
    """Whether a block may have a word of this address with one of these whole numbers, or one
    whose number is computed; without numbers any word of the address.
    """
    return any(
        word.address == address and (not codes or word.value is None or int(word.value) in codes)
        for program in programs
        for block in program.blocks
        for word in block.words
    )


def _of_another_machine(control: Control, setup: Setup) -> Iterator[Note]:
    """Yield notes on offsets of another machine: a lathe has its offsets in `tools`, a mill in
    `length_offsets` and `radius_offsets`. Where D names an edge of a tool, a mill reads all three.
    """
    values = {rule.name: rule.value for rule in control.rules}
    machine = setup.machine or str(values["machine"])
    lathe = machine.startswith("lathe")
    if values.get("tool_edges") and not lathe:
        return
    for field in ("length_offsets", "radius_offsets") if lathe else ("tools",):
        if getattr(setup, field):
            other, kind = ("a mill", "a lathe") if lathe else ("a lathe", "a mill")
            told = f"`{field}` are offsets of {other}, but the machine is {kind} ({machine})"
            yield _note("--setup", told)


def _note(option: str, message: str) -> Note:
    return Note("no-effect", f"no effect: {message}", option)


def _calls_outside(program: Program) -> bool:
    return any(call.kind == "M198" for block in program.blocks for call in block.calls)


def _read_variables(programs: Iterable[Program]) -> set[int] | None:
    """Return the variables that blocks read by number; `None` where a number is computed."""
    from cncsub.references import Computed

    found: set[int] = set()
    for program in programs:
        for block in program.blocks:
            for use in block.reads:
                if isinstance(use.variable, Computed):
                    return None
                if isinstance(use.variable, int):
                    found.add(use.variable)
    return found
