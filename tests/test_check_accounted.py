"""Over all rows that end well and over all examples, each finding is accounted for: what the run
did, or what is written, shows that it is true.
"""

from __future__ import annotations

import json
import re
import shlex
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

sys.path.insert(0, str(Path(__file__).with_name("conformance")))
from cncsub.testing import outcome
from conformance import Row, rows

EXAMPLES = Path(__file__).parent.parent / "examples"


class Seen(NamedTuple):
    """A finding, and the run of its programs."""

    finding: cncsub.Finding
    library: cncsub.Library
    run: cncsub.Run
    ran: set[tuple[str, int]]
    options: dict[str, Any]

    @property
    def reached(self) -> bool:
        return (self.finding.program, self.finding.line) in self.ran

    @property
    def text(self) -> str:
        return self.library[self.finding.program].text


def never_ran(seen: Seen) -> bool:
    """Return whether the block did not run, or may run without what is wrong in it."""
    partly = re.search(r"/|IF|THEN|CONTINUE", seen.finding.source, re.IGNORECASE)
    return not seen.reached or partly is not None


def not_called(seen: Seen) -> bool:
    name = seen.finding.program  # a program of this name on the device is another one
    outside = name in seen.library.external
    return outside or all(call.program != name for call in seen.run.calls)


def is_vacant_there(seen: Seen) -> bool:
    """Return whether the variable has no value when the block first runs.

    A variable that was given before the run counts as vacant.
    """
    named = re.match(r"#<(\w+)>", seen.finding.message)
    if named is not None:
        return no_assignment_ran(seen, named[1])
    number = int(re.findall(r"#(\d+)", seen.finding.message)[0])
    if number in (seen.options.get("variables") or {}):
        return True
    machine = seen.library.machine(**seen.options)
    while True:
        before = machine.variables.get(number)
        step = machine.step()
        if step is None:  # the block was not reached
            return not seen.reached
        if (step.program, step.line) == (seen.finding.program, seen.finding.line):
            return before is None


def no_assignment_ran(seen: Seen, name: str) -> bool:
    """Return whether no block that ran before it in its program gives the variable a value."""
    of_program = seen.library[seen.finding.program].blocks
    text = {block.line: block.text for block in of_program}
    for step in seen.run.steps:
        if step.program != seen.finding.program:
            continue
        if step.line == seen.finding.line:
            return True
        if re.search(rf"#<{name}>\s*=", text[step.line]):
            return False
    return not seen.reached


def dropped(seen: Seen) -> bool:
    lines = {(word.program, word.line) for word in seen.run.dropped}
    return (seen.finding.program, seen.finding.line) in lines or not seen.reached


def written(pattern: str) -> Callable[[Seen], bool]:
    return lambda seen: re.search(pattern, seen.finding.source) is not None


def lines_have_the_number(seen: Seen) -> bool:
    told = re.match(r"(N\d+) is in lines ([\d, .]+)", seen.finding.message)
    if told is None:  # a label, of which a language has any number
        return re.match(r"it leads to line \d+, and line \d+ has", seen.finding.message) is not None
    return len(re.findall(r"\d+", told[2])) > 1


def of_labels(seen: Seen) -> bool:
    """Return whether the control misses the end of a branch or a loop only when it needs it, as
    LinuxCNC and SINUMERIK do, or the block did not run.
    """
    return seen.library.control.dialect in ("linuxcnc", "sinumerik") or never_ran(seen)


def ends_there(seen: Seen) -> bool:
    last = seen.run.steps[len(seen.run.steps) - 1]
    return (last.program, last.line) == (
        seen.finding.program,
        seen.finding.line,
    ) or not seen.reached


def runs_into_its_end(seen: Seen) -> bool:
    """Return whether the control takes it, no end is reached, or a parameter makes it a reset."""
    if seen.finding.alarm is None or not seen.reached:
        return True
    last = seen.run.steps[len(seen.run.steps) - 1]
    return last.program == seen.finding.program or "3404" in str(seen.library.control.parameters)


def anything(seen: Seen) -> bool:
    """Return whether the word of the finding is in the program, for a finding about the text."""
    return seen.finding.word in seen.finding.source


ACCOUNTS: dict[str, Callable[[Seen], bool]] = {
    "CS101": never_ran, "CS102": never_ran, "CS103": never_ran, "CS104": never_ran,
    "CS105": lambda seen: never_ran(seen) or dropped(seen), "CS201": never_ran, "CS202": never_ran, "CS203": never_ran,
    "CS204": lines_have_the_number,
    "CS205": lambda seen: bool(seen.library.duplicates) or of_labels(seen),
    "CS206": never_ran, "CS207": of_labels, "CS208": of_labels, "CS209": of_labels,
    "CS301": lambda seen: not seen.reached, "CS302": not_called, "CS303": runs_into_its_end,
    "CS304": ends_there, "CS305": lambda seen: not_called(seen) or seen.finding.line > 1,
    "CS401": never_ran, "CS403": never_ran, "CS402": lambda seen: seen.finding.message.count(">") >= 1,
    "CS501": lambda seen: bool(seen.finding.word), "CS502": written("M98|G65"),
    "CS503": written("M98|G65|M97"),
    "CS601": is_vacant_there, "CS602": written("#|=|DO|IF"), "CS603": is_vacant_there,
    "CS604": anything, "CS605": written("#"), "CS606": written("#"),
    "CS701": written(r"[XYZUVW]-?\d+(?![.\d])"), "CS702": written(r"P\d{5}"),
    "CS703": written("L0"), "CS704": dropped, "CS705": written("(?i)AND|OR"),
    "CS706": written("G99"), "CS707": written("M0*(97|98|99|198)"), "CS801": dropped, "CS802": written(";"),
    "CS803": written("[a-z]"), "CS607": written("#"), "CS708": written("G0*(73|74|76|8[1-9])"),
    "CS709": written("[LK]"), "CS710": written("#"), "CS711": written("WHILE|IF"),
    "CS804": written(r"\([^)]*$"),
}  # fmt: skip


def look_at(library: cncsub.Library, run: cncsub.Run, options: dict[str, Any]) -> Counter[str]:
    setup = options.get("setup")
    machine = {"machine": setup.machine} if setup is not None and setup.machine else None
    findings = library.check(setup=machine)
    ran = {(step.program, step.line) for step in run.steps} if findings else set()
    each = [place for finding in findings for place in of_each_place(finding, library)]
    for finding in each:
        seen = Seen(finding, library, run, ran, options)
        assert ACCOUNTS[finding.rule](seen), f"{library.control.name}: {finding}"
    return Counter(finding.rule for finding in each)


def of_each_place(finding: cncsub.Finding, library: cncsub.Library) -> Iterator[cncsub.Finding]:
    """Yield the finding, and one like it for each of its other places."""
    yield replace(finding, places=(), count=1)
    for place in finding.places:
        program = (library if place.program in library else library.external)[place.program]
        source = ";".join(b.text for b in program.blocks if b.line == place.line)
        yield replace(finding, **place._asdict(), source=source, places=(), count=1)


def ends_well(row: Row) -> bool:
    return row.case.mdi is None and row.case.stop in ("end", "cycles")


def test_findings_in_rows_that_end_well_are_true() -> None:
    counted: Counter[str] = Counter()
    checked = 0
    for row in rows():
        if not ends_well(row):
            continue
        library = outcome.load(row.case, cncsub.controls[row.control])
        options = outcome._options(row.case)
        checked += 1
        if library.check():
            counted += look_at(library, outcome.execute(row.case, library), options)
    assert checked > 8000
    assert sum(counted[rule] for rule in ("CS101", "CS104", "CS201", "CS202")) > 50
    assert sum(counted.values()) > 2000


# The findings in the examples, checked as their heads say, and why they are no mistakes.
IN_EXAMPLES: dict[tuple[str, str], set[str]] = {
    ("gsk/980mdi-m-code-call.nc", "CS704"): {"O0001 N30"},  # the example shows that L says nothing
    ("gsk/980tdi-macro.nc", "CS102"): {"O0001 N130"},  # the head says how G100 is registered
    ("gsk/988t-self-call.nc", "CS403"): {"O0001 N20"},  # the example shows the alarm
    ("mitsubishi/meldas_jump.nc", "CS301"): {"O1 N30"},  # the block that the jump skips
    ("mitsubishi/meldas_l0.nc", "CS703"): {"O1 N10", "O1 N20"},  # the example shows what L0 does
    ("mitsubishi/meldas_too_deep.nc", "CS401"): {"O5 N51"},  # the example shows the alarm
}  # fmt: skip


def example_checks() -> list[tuple[str, list[str]]]:
    """Return the example and the words of `check` for each command in its head."""
    found: dict[tuple[str, ...], str] = {}
    for file in sorted(EXAMPLES.rglob("*")):
        if not file.is_file() or file.suffix in (".toml", ".ipynb"):
            continue
        head = cncsub.files.decode(file.read_bytes())[:4000]
        for command in re.findall(r"cncsub (?:run|tree) ([^\n]*)", head):
            words = check_words(shlex.split(command.split(")")[0]))
            if words:
                found.setdefault(tuple(words), str(file.relative_to(EXAMPLES)))
    return [(name, list(words)) for words, name in found.items()]


def check_words(words: list[str]) -> list[str]:
    """Return the words of a run that `check` takes too: what is read, and on which control."""
    taken: list[str] = []
    each = iter(words)
    for word in each:
        if word in ("-c", "--control", "--param", "-p", "--external", "--setup"):
            taken += [word, next(each)]
        elif word.startswith("--mdi"):
            return []
        elif word.startswith("-"):
            next(each, None)
        else:
            taken.append(word)
    return taken


def test_findings_in_examples_are_accounted_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(EXAMPLES.parent)
    told: dict[tuple[str, str], set[str]] = {}
    for name, words in example_checks():
        done = CliRunner().invoke(app, ["check", *words, "--format", "json"])
        assert done.exit_code in (0, 1), (name, words, done.output)
        for finding in json.loads(done.stdout)["findings"]:
            for place in (finding, *finding["places"]):
                where = f"{place['program']} N{place['n']}"
                told.setdefault((name, finding["rule"]), set()).add(where)
    assert told == IN_EXAMPLES
