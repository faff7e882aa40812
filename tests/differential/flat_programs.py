"""Flatten rows, examples and generated programs, and run both.

    python tests/differential/flat_programs.py --rows --examples --programs 10000

A flat program that is not refused has to do the same.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from random import Random
from typing import Any

import cncsub
import o_words
from cncsub.testing.cases import Row
from cncsub.testing.outcome import MAX_BLOCKS, load
from comparison import Comparison
from machines import OTHER_LANGUAGES
from macros import program
from programs import MILLING, Program, generate, moves_of
from spelling import SiemensSpeller, Speller, Style

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "examples"
SEED = 5
MOST_BLOCKS = 20_000

# The reasons for which rows that end are refused.
REASONS = {
    "a frame of the control gets a value that no functions make: it shears",
    "axes that go beside the path cannot be written as a block of another program",
    "M02 or M30 returns from a subprogram, and the flat program would end there",
    "a code starts the program over, and the flat program goes on after it",
    "the run ends by an alarm: user-alarm",
    "the program raises an alarm with a number of its own",
    "the program raises an alarm with a text of its own",
    "a return brings back the frame of the caller, and a flat program has no calls",
    "M70 to M73 save and restore the modes of each call, and a flat program has no calls",
    "its program restores the codes of the caller, and a flat program has no calls",
}


def ended(library: cncsub.Library, main: str | None = None, **options: Any) -> bool:
    """Return whether a run comes to an end, or to an alarm of the program itself."""
    run = library.run(main, **options)
    own = run.alarm is not None and run.alarm.cause == "user-alarm"
    return own or run.stop in (cncsub.Stop.END, cncsub.Stop.CYCLES)


def proved(library: cncsub.Library, main: str | None = None, **options: Any) -> bool:
    """Return whether a program ends; if it does, its flat program must do the same."""
    if not ended(library, main, **options):
        return False
    flat = library.flatten(main, **options)
    try:
        flat.verify()
    except AssertionError as error:
        texts = "\n".join(each.text for each in library.values())
        raise AssertionError(
            f"{library.control.name}: {error}\n{texts}\n---\n{flat.text}"
        ) from None
    return True


def runnable(rows: Iterable[Row]) -> Iterator[tuple[cncsub.Library, dict[str, Any]]]:
    """Yield the library of each row that automatic mode runs at all, with the options of its run."""
    for case, control in rows:
        options: dict[str, Any] = {"max_blocks": MAX_BLOCKS, **case.options}
        if case.mdi is not None or options.pop("mode", "auto") == "mdi":
            continue
        if case.setup is not None:
            options["setup"] = cncsub.Setup(**case.setup)
        for name in ("trace", "watch", "conditions"):  # what a run records
            options.pop(name, None)
        try:
            library = load(case, cncsub.controls[control])
            library.run(**options)
        except (ValueError, KeyError):
            continue
        yield library, options


def of_rows(rows: Iterable[Row]) -> tuple[Counter[str], int]:
    """Return the reasons for which rows that end are refused, and how many are not."""
    refused: Counter[str] = Counter()
    done = 0
    for library, options in runnable(rows):
        try:
            done += proved(library, **options)
        except cncsub.FlattenError as error:
            refused[error.reason] += 1
    return refused, done


def of_examples() -> int:
    """Return how many programs of the examples are flattened, on every control of their makers."""
    done = 0
    for path, control in examples():
        library = cncsub.load(path, control=control)
        done += sum(proved(library, name, max_blocks=MOST_BLOCKS) for name in library)
    return done


def examples() -> Iterator[tuple[Path, str]]:
    for control in cncsub.controls:
        for path in sorted((EXAMPLES / control.split("-")[0]).iterdir()):
            if path.is_dir() or path.suffix.lower() in {".nc", ".ngc", ".mpf"}:
                yield path, control


def written_calls(places: Iterable[int]) -> Iterator[tuple[cncsub.Library, cncsub.Setup]]:
    """Yield generated calls, on every control and kind of machine."""
    comparison = Comparison(SEED)
    for place in places:
        meant = comparison.program(place)
        for station in comparison.on(place):
            text = comparison.text(place, meant, station)
            yield cncsub.loads(text, control=station.control), station.setup


def of_calls(places: Iterable[int]) -> int:
    """Return how many generated calls were flattened, on every control and kind of machine."""
    return sum(proved(library, setup=setup) for library, setup in written_calls(places))


def in_other_languages(comparison: Comparison, place: int) -> tuple[Program, dict[str, str]]:
    """Return a generated program with its calls, and its texts in other languages by control."""
    random = comparison.random(place, "another language")
    meant = generate(random, MILLING)
    speller = Speller(Style(), random)
    behind = [line for below in meant.called() for line in speller.below(below)]
    return meant, {  # LinuxCNC looks for a program after the one that calls it
        "linuxcnc": "\n".join([*speller.body(meant), "M30", *behind]) + "\n",
        "siemens-one": SiemensSpeller(Style(), random).write(meant),
    }


def of_other_languages(places: Iterable[int]) -> int:
    """Return how many generated programs of other languages end and were flattened: calls and
    O-words of LinuxCNC, and calls of Siemens.
    """
    comparison = Comparison(SEED)
    done = 0
    for place in places:
        meant, texts = in_other_languages(comparison, place)
        for control, text in texts.items():
            library = cncsub.loads(text, control=control)
            run = library.run()
            made = [move for move in moves_of(meant) if move.kind in ("cw", "ccw")]
            if run.stop is not cncsub.Stop.END or len(run.moves) < len(made):
                raise AssertionError(f"{control}: {run}\n{text}")
            done += proved(library)
        library = cncsub.loads(o_words.generate(SEED, place), control="linuxcnc")
        try:
            done += proved(library, max_blocks=MOST_BLOCKS)
        except cncsub.FlattenError as error:
            if error.reason not in REASONS:  # the program itself has (abort, ...)
                raise
    return done


# Of 32-bit numbers a half circle by its radius has another centre: the proof says so, rightly.
COARSE = ("grblhal",)


def of_others(places: Iterable[int]) -> tuple[Counter[str], int]:
    """Flatten generated calls of every mill for every mill that can say its words.

    Returns what was refused, and how many were flattened.
    """
    comparison = Comparison(SEED)
    mills = [
        name
        for name, control in cncsub.controls.items()
        if any(rule.name == "machine" and rule.value == "mill" for rule in control.rules)
    ]
    refused: Counter[str] = Counter()
    done = 0
    for place in places:
        meant = comparison.program(place)
        for station in comparison.on(place):
            if not station.mills():
                continue
            library = cncsub.loads(comparison.text(place, meant, station), control=station.control)
            for control in mills:
                try:
                    library.flatten(control=control, setup=station.setup)
                    done += 1
                except cncsub.FlattenError as error:
                    if not (control in COARSE and re.search(r" has c[xyz] = ", str(error))):
                        refused[f"{station.name} for {control}: {error}"] += 1
    return refused, done


def written_macros(places: Iterable[int]) -> Iterator[cncsub.Library]:
    """Yield generated macros, on every control of the ISO language."""
    controls = [name for name in cncsub.controls if name not in OTHER_LANGUAGES]
    for place in places:
        text = program(Random(f"{SEED} {place}"))
        for control in controls:
            yield cncsub.loads(text, control=control)


def of_macros(places: Iterable[int]) -> int:
    """Return how many generated macros end and were flattened, on every control of the ISO
    language.
    """
    return sum(proved(library, max_blocks=MOST_BLOCKS) for library in written_macros(places))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", action="store_true", help="every row of the tables")
    parser.add_argument("--examples", action="store_true", help="every example")
    parser.add_argument("--programs", type=int, default=0, help="so many generated programs")
    parser.add_argument("--others", type=int, default=0, help="so many for every other control")
    parser.add_argument("--from", type=int, default=0, dest="first", help="the first of them")
    asked = parser.parse_args()
    if asked.rows:
        sys.path.insert(0, str(EXAMPLES.parent / "tests" / "conformance"))
        from conformance import rows

        refused, done = of_rows(rows())
        print(f"rows: {done:,} flattened, {sum(refused.values())} refused")
        for reason, count in refused.most_common():
            print(f"  {count}: {reason}")
    if asked.examples:
        print(f"examples: {of_examples():,} flattened")
    if asked.programs:
        places = range(asked.first, asked.first + asked.programs)
        print(f"{len(places):,} programs of calls: {of_calls(places):,} flattened")
        print(f"{len(places):,} programs of macros: {of_macros(places):,} flattened")
        print(f"{len(places):,} of other languages: {of_other_languages(places):,} flattened")
    if asked.others:
        refused, done = of_others(range(asked.first, asked.first + asked.others))
        print(f"for other controls: {done:,} flattened, {sum(refused.values())} refused")
        for reason, count in refused.most_common():
            print(f"  {count}: {reason}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
