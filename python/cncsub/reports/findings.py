"""Findings for other tools: JSON, SARIF 2.1.0, JUnit, annotations of a forge; and their edits."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import quote
from xml.etree import ElementTree

from cncsub._core import Frame, __version__
from cncsub.byte_edits import place_in
from cncsub.checking import CheckRule, Edit, Finding, Place, all_rules
from cncsub.escapes import for_github, for_xml, referred
from cncsub.lines import diff_of, lines_of, without_end
from cncsub.reports.source_root import SourceRoot
from cncsub.writing import replace_whole

VERSION = 1  # of the JSON; it grows when a key changes its meaning or is removed


def finding_facts(findings: Sequence[Finding]) -> dict[str, Any]:
    """Return all findings as JSON can hold them; docs/findings.schema.json is the schema."""
    return {"version": VERSION, "findings": [_facts(finding) for finding in findings]}


def _facts(finding: Finding) -> dict[str, Any]:
    alarm = finding.alarm
    return {
        "rule": finding.rule,
        "name": finding.name,
        "severity": finding.severity,
        "program": finding.program,
        "n": finding.n,
        "file": finding.file,
        "line": finding.line,
        "column": finding.column,
        "word": finding.word,
        "message": finding.message,
        "hint": finding.hint,
        "alarm": None
        if alarm is None
        else {"cause": alarm.cause, "number": alarm.number, "text": alarm.text},
        "path": [
            {"program": f.program, "n": f.n, "file": f.file, "line": f.line, "kind": f.kind}
            for f in finding.path
        ],
        "fix": None if finding.fix is None else [edit._asdict() for edit in finding.fix],
        "count": finding.count,
        "places": [place._asdict() for place in finding.places],
    }


_LEVELS = {"error": "error", "warning": "warning", "note": "note"}


def sarif(findings: Sequence[Finding], more: Sequence[CheckRule] = ()) -> dict[str, Any]:
    """Return a log of SARIF 2.1.0; the calls that lead to a finding are its code flow. Files are
    named from the top of their repository. `more`: rules besides those of `check`.
    """
    root = _root_of(findings)
    known = (*all_rules(), *more)
    rules = [
        {
            "id": rule.number,
            "name": rule.name,
            "shortDescription": {"text": rule.meaning},
            "help": {"text": rule.hint},
            "defaultConfiguration": {"level": _LEVELS[rule.severity]},
        }
        for rule in known
    ]
    driver = {
        "name": "cncsub",
        "version": __version__,
        "semanticVersion": __version__,
        "rules": rules,
    }
    numbers = [rule.number for rule in known]
    run: dict[str, Any] = {
        "tool": {"driver": driver},
        "columnKind": "unicodeCodePoints",
        "results": [_result(finding, numbers, root) for finding in findings],
    }
    if root.folder is not None:
        run["originalUriBaseIds"] = {_BASE: {"uri": root.folder.as_uri().rstrip("/") + "/"}}
    return {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [run],
    }


_BASE = "%SRCROOT%"  # the name that readers of SARIF know for the top of a repository


def _root_of(findings: Iterable[Finding]) -> SourceRoot:
    files: dict[str, None] = {}
    for finding in findings:
        files[finding.file] = None
        files.update((place.file, None) for place in finding.places)
        files.update((frame.file, None) for frame in finding.path)
    return SourceRoot(files)


def _result(finding: Finding, numbers: Sequence[str], root: SourceRoot) -> dict[str, Any]:
    number = finding.alarm.number if finding.alarm is not None else None
    told = f"{finding.told} [alarm {number}]" if number else finding.told
    result: dict[str, Any] = {
        "ruleId": finding.rule,
        "ruleIndex": numbers.index(finding.rule),
        "level": _LEVELS[finding.severity],
        "message": {"text": f"{told}. Hint: {finding.hint}"},
        "locations": [_location(root, finding, finding.column, len(finding.word))],
    }
    if finding.places:
        result["relatedLocations"] = [
            _location(root, at, at.column, len(at.word)) for at in finding.places
        ]
    if finding.path:
        places = [
            _location(root, frame, 1, 0, f"{frame.program} {frame.kind}") for frame in finding.path
        ]
        places.append(_location(root, finding, finding.column, 0, finding.message))
        steps = [
            {"location": place, "nestingLevel": level, "executionOrder": level + 1}
            for level, place in enumerate(places)
        ]
        result["codeFlows"] = [{"threadFlows": [{"locations": steps}]}]
    if finding.fix is not None:
        result["fixes"] = [{"artifactChanges": [_change(root, edit) for edit in finding.fix]}]
    return result


def _location(
    root: SourceRoot, at: Finding | Place | Frame, column: int, width: int, text: str = ""
) -> dict[str, Any]:
    region: dict[str, Any] = {"startLine": max(1, at.line), "startColumn": max(1, column)}
    if width:
        region["endColumn"] = max(1, column) + width
    location: dict[str, Any] = {
        "physicalLocation": {"artifactLocation": _artifact(root, at.file), "region": region}
    }
    if text:
        location["message"] = {"text": text}
    return location


def _artifact(root: SourceRoot, file: str) -> dict[str, Any]:
    relative = root.relative(file)
    if relative is not None:
        return {"uri": quote(relative), "uriBaseId": _BASE}
    path = Path(file)
    return {"uri": path.as_uri() if path.is_absolute() else quote(path.as_posix())}


def _change(root: SourceRoot, edit: Edit) -> dict[str, Any]:
    deleted = {
        "startLine": edit.line,
        "startColumn": edit.column,
        "endColumn": edit.column + len(edit.old),
    }
    return {
        "artifactLocation": _artifact(root, edit.file),
        "replacements": [{"deletedRegion": deleted, "insertedContent": {"text": edit.new}}],
    }


def junit(
    findings: Sequence[Finding],
    files: Iterable[str],
    command: str = "check",
    fails: Iterable[str] = ("error", "warning"),
) -> str:
    """Return a JUnit test suite with a case for each file. The findings of a file are its failure,
    or its output where none of them has a severity that `fails`. `command`: that finds them.
    """
    severe = frozenset(fails)

    by_file: dict[str, list[Finding]] = {file: [] for file in files}
    for finding in findings:
        by_file.setdefault(finding.file, []).append(finding)
    failing = {file for file, found in by_file.items() if any(f.severity in severe for f in found)}
    suite = ElementTree.Element(
        "testsuite", name=f"cncsub {command}", tests=str(len(by_file)), failures=str(len(failing))
    )
    for file, found in by_file.items():
        case = ElementTree.SubElement(
            suite, "testcase", name=for_xml(file), classname=f"cncsub.{command}"
        )
        if not found:
            continue
        if file in failing:
            worst = next(finding for finding in found if finding.severity in severe)
            told = ElementTree.SubElement(
                case, "failure", type=worst.rule, message=for_xml(worst.told)
            )
        else:
            told = ElementTree.SubElement(case, "system-out")
        told.text = for_xml("\n\n".join(map(str, found)))
    ElementTree.indent(suite)
    text = ElementTree.tostring(suite, encoding="unicode")
    return f'<?xml version="1.0" encoding="utf-8"?>\n{referred(text)}'


def github_annotations(findings: Sequence[Finding]) -> str:
    """Return workflow commands that GitHub shows beside the lines of a change. It knows files by
    their names from the top of the repository.
    """
    root = _root_of(findings)
    kinds = {"error": "error", "warning": "warning", "note": "notice"}
    lines = (
        f"::{kinds[f.severity]} file={for_github(root.relative(f.file) or f.file, property=True)}"
        f",line={f.line},col={f.column},title={for_github(f'{f.rule} {f.name}', property=True)}"
        f"::{for_github(f'{f.told}. Hint: {f.hint}')}"
        for f in findings
    )
    return "\n".join(lines)


class Mended:
    """Files with the edits that are certain; nothing is written before `write`."""

    def __init__(self, findings: Iterable[Finding]) -> None:
        self._left: set[Edit] = set()  # the edits whose text is not where it was
        self._old: dict[str, list[bytes]] = {}  # the lines of each file
        self._new: dict[str, list[bytes]] = {}
        edits = {edit for finding in findings for edit in finding.fix or ()}
        # Edits go from the end of each line: the text before an edit stays where it is.
        for edit in sorted(edits, key=lambda edit: edit[:3], reverse=True):
            self._apply(edit)

    def _apply(self, edit: Edit) -> None:
        """Replace a word as bytes, whatever the encoding of the comments. Words of NC programs are
        ASCII: the word must stand at its column after nothing but ASCII, or once in its line.
        """
        if edit.file not in self._new:
            self._old[edit.file] = lines_of(Path(edit.file).read_bytes())
            self._new[edit.file] = list(self._old[edit.file])
        lines = self._new[edit.file]
        line, old = lines[edit.line - 1], edit.old.encode()
        if not old:
            lines[edit.line - 1] = self._lengthened(line, lines[0], edit.new.encode())
            return
        place = place_in(line, edit)
        if place is None:
            self._left.add(edit)
            return
        lines[edit.line - 1] = line[:place] + edit.new.encode() + line[place + len(old) :]

    @staticmethod
    def _lengthened(line: bytes, first: bytes, new: bytes) -> bytes:
        """Return a line with a text put at its end; new lines end as the lines of the file do."""
        words = without_end(line)
        end = line[len(words) :]
        usual = end or first[len(without_end(first)) :] or b"\n"
        return words + new.replace(b"\n", usual) + end

    @property
    def left(self) -> int:
        """How many edits are left out."""
        return len(self._left)

    def mends(self, finding: Finding) -> bool:
        """Return whether a finding has edits and all of them are made."""
        return finding.fix is not None and self._left.isdisjoint(finding.fix)

    def diff(self) -> str:
        return "".join(
            diff_of(b"".join(old), b"".join(self._new[file]), file)
            for file, old in self._old.items()
        )

    def write(self) -> list[str]:
        """Write the files that change, and return their names."""
        changed = [file for file, text in self._new.items() if text != self._old[file]]
        for file in changed:
            replace_whole(file, b"".join(self._new[file]))
        return changed


def with_severity(findings: Iterable[Finding], severities: dict[str, str]) -> list[Finding]:
    """Return the findings with the severities that a project gives its rules."""
    return [replace(f, severity=severities.get(f.rule, f.severity)) for f in findings]
