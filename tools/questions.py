"""Writes python/cncsub/questions/programs.json: for each rule, and each entry of a set, that is
inferred on some control, short programs that tell values of it apart. They are what is left of the
programs of conformance rows after every line without which they still do has been taken away.

    python tools/questions.py            # minutes
"""

from __future__ import annotations

import json
import re
import sys
import textwrap
from collections.abc import Iterable, Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FILE = ROOT / "python/cncsub/questions/programs.json"
CONFORMANCE = ROOT / "tests/conformance"

sys.path[:0] = [str(ROOT / "python"), str(CONFORMANCE)]

import cncsub  # noqa: E402
from cncsub.questions.asking import MOST_LINES, MOST_VALUES, open_words  # noqa: E402
from cncsub.questions.outcome import Short, seen  # noqa: E402
from cncsub.questions.values import answers, changed  # noqa: E402
from conformance import Row, rows  # noqa: E402

MOST_TRIED = 60  # programs of a rule that are tried on a control
LONGEST = 20  # lines of a program that may become short


def programs_of(row: Row) -> Iterator[Short]:
    """Yield the program of a row, for the kind of machine that the row is about. What else the row
    says, parameters or offsets, is left away: the program has to tell by itself.
    """
    case = row.case
    if not isinstance(case.program, str) or case.mdi or not case.program.isascii():
        return
    text = textwrap.dedent(case.program).strip() + "\n"
    if len(text.splitlines()) > LONGEST or re.search(r"[^\n -~]", text):
        return
    machine = str((case.setup or {}).get("machine", ""))
    yield Short(text, machine)
    own = str(answers(row.control).get("machine", "mill"))
    if not machine and own != "mill":
        yield Short(text, own)


def by_word() -> dict[str, list[Short]]:
    """Return the programs of rows by what the rows pin or raise, the shortest first."""
    found: dict[str, dict[Short, None]] = {}
    for row in rows():
        words = list(row.case.pins)
        words += [f"refuses:{row.case.alarm}"] if row.case.alarm else []
        for word in words:
            for program in programs_of(row):
                found.setdefault(word, {})[program] = None
    return {word: sorted(of, key=lambda p: (p.lines, len(p.text))) for word, of in found.items()}


class Telling:
    """Whether a program tells values of one rule of one control apart."""

    def __init__(self, control: cncsub.Control, word: str) -> None:
        self.control = control
        self.mutants = [mutant for _, mutant in changed(control, word)][: MOST_VALUES - 1]

    def __call__(self, program: Short) -> bool:
        own = seen(program, self.control)
        return own is not None and any(seen(program, m) not in (own, None) for m in self.mutants)

    def shortened(self, program: Short) -> Short:
        """Return the program without the lines that it does not need to tell."""
        lines = program.text.splitlines()
        for place in reversed(range(len(lines))):
            fewer = lines[:place] + lines[place + 1 :]
            if fewer and self(Short("\n".join(fewer) + "\n", program.machine)):
                lines = fewer
        return Short("\n".join(lines) + "\n", program.machine)

    def first(self, programs: Iterable[Short]) -> Short | None:
        """Return the first program that tells, in five lines or fewer."""
        for program in programs:
            if self(program):
                if program.lines > MOST_LINES:
                    program = self.shortened(program)
                if program.lines <= MOST_LINES:
                    return program
        return None


def main() -> None:
    pinning = by_word()
    kept: dict[str, dict[Short, None]] = {}
    for control in cncsub.controls.values():
        for word in open_words(control):
            tells = Telling(control, word)
            mine = kept.setdefault(word, {})
            if tells.first(mine) is None:
                found = tells.first(pinning.get(word, [])[:MOST_TRIED])
                if found is not None:
                    mine[found] = None
        print(control.name, sum(map(len, kept.values())), file=sys.stderr, flush=True)
    told = {word: [list(program) for program in of] for word, of in sorted(kept.items()) if of}
    FILE.write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")
    print(f"{len(told)} rules and entries, {sum(map(len, told.values()))} programs")


if __name__ == "__main__":
    main()
