"""Check that `cncsub.compare` names the rule that was exchanged, over many generated pairs.

    python tests/benchmarks/exchanged.py            # 1,000 pairs that differ
    python tests/benchmarks/exchanged.py 50 --seed 7

A pair is a control and the same control with another value for one rule. The program is that of a
row, changed at random (blocks are doubled, left out or moved). Prints how many pairs were named
rightly and each that was not.
"""

from __future__ import annotations

import argparse
import random
import sys
from collections.abc import Iterator
from pathlib import Path

import cncsub

sys.path.insert(0, str(Path(__file__).parents[1] / "conformance"))
import mutation
from cncsub.testing import outcome
from conformance import Case, rows


def changed(text: str, chance: random.Random) -> str:
    """Return the program with up to two blocks doubled, left out or moved."""
    lines = text.split("\n")
    for _ in range(chance.randrange(3)):
        at, to = chance.randrange(len(lines)), chance.randrange(len(lines))
        what = chance.randrange(3)
        if what == 0:
            lines.insert(to, lines[at])
        elif what == 1 and len(lines) > 3:
            del lines[at]
        else:
            lines.insert(to, lines.pop(at))
    return "\n".join(lines)


def pairs(seed: int) -> Iterator[tuple[Case, str, cncsub.Control, cncsub.Control, str]]:
    """Yield a case, its changed program, a control, the control with a changed rule, that rule."""
    chance = random.Random(seed)
    known = [
        row
        for row in rows()
        if row.case.pins
        and row.case.mdi is None
        and isinstance(row.case.program, str)
        and row.case.files is None
        and row.case.setup is None
    ]
    while True:
        row = chance.choice(known)
        case = row.case
        control = cncsub.controls[row.control]
        if case.replace:
            control = control.replace(**case.replace)
        if case.params:
            control = control.with_parameters(dict(case.params))
        word = chance.choice(case.pins)
        mutants = list(mutation.mutants(control, word))
        if mutants:
            text = changed(str(case.program), chance)
            yield case, text, control, chance.choice(mutants), word.partition(":")[0]


def named(
    case: Case, text: str, one: cncsub.Control, other: cncsub.Control, rule: str
) -> tuple[str, str]:
    """Return `"same"`, `"named"` or `"misnamed"`, and what is wrong."""
    options = {"max_blocks": 2000, **case.options}
    external = None if case.external is None else outcome._folder(case, "external")
    library = cncsub.loads(text, control=one, external=external)
    try:
        compared = cncsub.compare(library, controls=[one, other], **options)
    except (KeyError, ValueError) as error:  # the text has no such main program or start
        return "same", str(error)
    if compared.same:
        return "same", ""
    if compared.rules == (rule,):
        return "named", ""
    told = f"{one.name}: {rule} was exchanged, {compared.rules} named\n{text}\n{compared}"
    return "misnamed", told


def look(count: int, seed: int) -> tuple[int, list[str]]:
    """Return how many of `count` pairs that differ were named rightly, and the faults of others."""
    right, wrong = 0, []
    for pair in pairs(seed):
        found, told = named(*pair)
        right += found == "named"
        if found == "misnamed":
            wrong.append(told)
        if right + len(wrong) == count:
            return right, wrong
    raise AssertionError("pairs do not end")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("count", type=int, nargs="?", default=1000)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    right, wrong = look(asked.count, asked.seed)
    print(*wrong, sep="\n\n")
    print(f"{right} of {asked.count} pairs that differ: the rule that was exchanged is named")
    raise SystemExit(bool(wrong))


if __name__ == "__main__":
    main()
