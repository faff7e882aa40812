"""What a gate finds in one memory: refused and not computed codes, missing heads and ends, and the
alarm of a dry run.
"""

from __future__ import annotations

import fnmatch
from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import PurePath
from typing import Any, NamedTuple

from cncsub.checking import Finding
from cncsub.gate_rules import RULES
from cncsub.interrupts import uninterrupted
from cncsub.library import Library
from cncsub.program import Program
from cncsub.run import Run, Stop

_BY_NAME = {rule.name: rule for rule in RULES}
_NOT_COMPUTED = "not-computed"  # a rule of `check`: what cncsub cannot compute, nobody has proved


class Allowed(NamedTuple):
    """An entry of an allow list: what may be found, and in which files.

    `what`: a word such as `G187`, the number or the name of a rule, the number of an alarm, or `*`.
    `files`: a pattern that the path of a file, or its name, matches. `line`: of the list.
    """

    what: str
    files: str
    line: int

    def allows(self, path: str, finding: Finding) -> bool:
        """Return whether the entry lets a finding in a file pass."""
        name = PurePath(path)
        if not any(fnmatch.fnmatch(each, self.files) for each in (name.as_posix(), name.name)):
            return False
        number = finding.alarm.number if finding.alarm is not None else None
        told = (finding.rule, finding.name, finding.word.strip(), number or "", "*")
        return self.what.upper() in (each.upper() for each in told)


_ONLY_OF_GATE = ("rules", "entry", "allow")


def options_of_run(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options of a gate without those that a run has not."""
    return {name: value for name, value in options.items() if name not in _ONLY_OF_GATE}


def gated(library: Library, files: Iterable[str], options: Mapping[str, Any]) -> list[Finding]:
    """Return what a gate finds in a memory, in these files of it: what `Library.check` finds, the
    form of the files, and the alarm of a run. `options`: `setup`, `rules`, `entry` of `check`, and
    those of `Library.run`.
    """
    own = set(files)
    asked = {name: options[name] for name in ("rules", "setup", "entry") if name in options}
    found = [finding for finding in library.check(**asked) if finding.file in own]
    found = [_in_earnest(finding) for finding in found]
    found += _forms(library, own)
    run = uninterrupted(_without_allowed(library, found, options).run(**options_of_run(options)))
    found += [finding for finding in _stopped(library, run) if not _known(finding, found)]
    return sorted(found, key=lambda finding: (finding.file, finding.line, finding.column))


def _in_earnest(finding: Finding) -> Finding:
    """Make an error of what is not computed: a gate lets nothing pass that nobody looked at."""
    return replace(finding, severity="error") if finding.name == _NOT_COMPUTED else finding


def _without_allowed(
    library: Library, found: Iterable[Finding], options: Mapping[str, Any]
) -> Library:
    """Return the memory with blanks for the blocks that have a code the allow list lets pass: the
    machine knows what they do, and a run would stop there.
    """
    allowed = {
        at
        for finding in found
        if any(entry.allows(finding.file, finding) for entry in options.get("allow", ()))
        and (finding.alarm is not None or finding.name == _NOT_COMPUTED)
        for at in ((finding.file, finding.line), *((p.file, p.line) for p in finding.places))
    }
    if not allowed:
        return library
    texts = {
        name: data.decode("utf-8", "surrogateescape").split("\n")
        for name, data in _texts(library).items()
    }
    for program in library.values():
        for block in program.blocks:
            if (program.file, block.line) in allowed:
                lines = texts[program.file]
                left_out = lines[block.line - 1].replace(block.text, " " * len(block.text), 1)
                lines[block.line - 1] = left_out
    return library.with_texts(
        library.control, {name: "\n".join(lines) for name, lines in texts.items()}
    )


def _known(finding: Finding, found: Iterable[Finding]) -> bool:
    """Return whether the check has found the block that alarms already."""
    return any(
        of.alarm is not None
        and finding.alarm is not None
        and (of.file, of.line, of.alarm.cause) == (finding.file, finding.line, finding.alarm.cause)
        for of in found
    )


def gate_finding(
    name: str, program: str, line: int, file: str, source: str, **more: Any
) -> Finding:
    """Return a finding of a rule that only a gate has."""
    rule = _BY_NAME[name]
    told: dict[str, Any] = {
        "n": None,
        "column": 1,
        "word": "",
        "message": rule.meaning,
        "hint": rule.hint,
        "alarm": None,
        "path": (),
        "fix": None,
        **more,
    }
    return Finding(
        rule.number, name, rule.severity, program, line=line, file=file, source=source, **told
    )


# ---- the form of a file ----


def _texts(library: Library) -> dict[str, bytes]:
    """Return the texts of all files, which the engine copies each time."""
    return {name: data for name, _, data, _ in library.code.sources}


def _forms(library: Library, files: Container[str]) -> Iterator[Finding]:
    """Yield what is missing in files of a control that calls programs by their numbers."""
    if not any(rule.name == "max_program_number" for rule in library.control.rules):
        return
    firsts: dict[str, Program] = {}
    for program in library.values():
        if program.file in files:
            firsts.setdefault(program.file, program)
    texts = _texts(library)
    for file, first in firsts.items():
        yield from _form(first, texts[file])


def _form(first: Program, text: bytes) -> Iterator[Finding]:
    """Yield what is missing in a file, by its first program and its text."""
    if not first.data.has_head:
        yield _at_head("head-missing", first)
    lines = text.strip(b" \t\r\n\0").split(b"\n")
    begins, ends = (line.lstrip().startswith(b"%") for line in (lines[0], lines[-1]))
    if len(lines) > 1 and begins != ends:
        yield _at_head("half-a-file", first)
    elif not begins:
        yield _at_head("no-percent-signs", first)


def _at_head(name: str, program: Program) -> Finding:
    source = program.beginning(200).split("\n")[0].rstrip()
    return gate_finding(name, program.name, 1, program.file, source)


# ---- the dry run ----


def _line_of(library: Library, file: str, line: int) -> str:
    """Return the text of a line of a file; empty where there is none."""
    lines = _texts(library).get(file, b"").split(b"\n")
    return lines[line - 1].decode(errors="replace").rstrip() if 0 < line <= len(lines) else ""


def _stopped(library: Library, run: Run) -> Iterator[Finding]:
    alarm = run.alarm
    if alarm is not None:
        number = f"{alarm.number} " if alarm.number else ""
        detail = f": {alarm.detail}" if alarm.detail else ""
        yield gate_finding(
            "dry-run-alarm",
            alarm.program,
            max(1, alarm.line),
            alarm.file,
            _line_of(library, alarm.file, alarm.line),
            n=alarm.n,
            column=max(1, alarm.column),
            word=alarm.word,
            message=f"{number}{alarm.cause}{detail}",
            alarm=alarm,
            path=tuple(alarm.frames[1:]) if len(alarm.frames) > 1 else (),
        )
    elif run.stop not in (Stop.END, Stop.CYCLES):
        last = run.steps[-1] if len(run.steps) else None
        program = library[last.program] if last is not None else library.main
        if program is not None:
            line = program.line if last is None else last.line
            yield gate_finding(
                "dry-run-unfinished",
                program.name,
                line,
                program.file,
                "",
                n=None if last is None else last.n,
                message=run.summary(),
            )
