"""Start rows, examples and generated programs again in the middle.

    python tests/differential/restart_programs.py --rows 1 --examples --programs 1000
    python tests/differential/restart_programs.py --each 10000 --control fanuc-0i-f

A restart program is proved when it is made; what is refused is counted by its reason. `--each` tries
so many programs that end on every control, each of them at one place.
"""

from __future__ import annotations

import argparse
import dataclasses
import re
import sys
from collections import Counter
from collections.abc import Iterable
from random import Random
from typing import Any

import cncsub
import o_words
from cncsub.resume import ResumeError
from cncsub.resume.start import given_setup, systems_of, with_start
from cncsub.setup import work_system
from cncsub.testing.cases import Row
from comparison import Comparison
from control_programs import jobs_on
from flat_programs import (
    EXAMPLES,
    MOST_BLOCKS,
    SEED,
    examples,
    in_other_languages,
    runnable,
    written_calls,
    written_macros,
)

PLACES = 3  # of each program
SHOWN = 20  # how many programs of a reason are named


class Restarts:
    """How many restarts of programs were made, by their form, and why others were refused."""

    def __init__(self, seed: object = SEED, places: int = PLACES) -> None:
        self.random = Random(f"restarts {seed}")
        self.places = places
        self.programs = 0  # those that ended
        self.made: Counter[str] = Counter()
        self.refused: Counter[str] = Counter()
        self.shown: dict[str, str] = {}
        self.name = ""  # of the program, where it has one
        self.names: dict[str, list[str]] = {}  # of those that were refused, by reason

    def of(self, library: cncsub.Library, main: str | None = None, **options: Any) -> None:
        """Start a program again at several steps, if it ends. The setup says where all axes start:
        else a place that depends on that is refused.
        """
        fresh = library.machine(main, **{**options, "max_blocks": 0})
        given = given_setup(options).start
        start = {axis: at for axis, at in fresh.position.items() if axis not in given}
        options = _with_offsets(library, main, with_start(options, start))
        run = library.run(main, **options)
        if run.stop not in (cncsub.Stop.END, cncsub.Stop.CYCLES) or not len(run.steps):
            return
        self.programs += 1
        count = len(run.steps)
        for step in sorted(self.random.sample(range(count), min(count, self.places))):
            self._at(library, main, run, step, options)

    def _at(
        self,
        library: cncsub.Library,
        main: str | None,
        run: cncsub.Run,
        step: int,
        options: dict[str, Any],
    ) -> None:
        try:
            resumed = library.resume(main, at=run.steps[step], **options)
        except ResumeError as error:
            reason = shape(error.reason)
            self.refused[reason] += 1
            self.names.setdefault(reason, []).append(self.name)
            self.shown.setdefault(
                reason, f"{library.control.name} step {step}: {error}\n{_texts(library)}"
            )
            return
        except Exception as error:
            error.add_note(f"{library.control.name} step {step}\n{_texts(library)}")
            raise
        self.made[resumed.form] += 1

    @property
    def share_refused(self) -> float:
        refused = sum(self.refused.values())
        return refused / max(1, refused + sum(self.made.values()))

    def report(self, shows: bool = False) -> str:
        forms = ", ".join(f"{count:,} {form}" for form, count in sorted(self.made.items()))
        lines = [
            f"{self.programs:,} programs: {forms}; {sum(self.refused.values()):,} refused"
            f" ({self.share_refused:.1%})"
        ]
        for reason, count in self.refused.most_common():
            names = " ".join(filter(None, self.names[reason][:SHOWN]))
            lines.append(f"  {count}: {reason}{names and f' (--from {names})'}")
            if shows:
                lines.append("    " + self.shown[reason].replace("\n", "\n    "))
        return "\n".join(lines)


def _with_offsets(
    library: cncsub.Library, main: str | None, options: dict[str, Any]
) -> dict[str, Any]:
    """Return the options with a setup that gives all offsets, those that were not given as zero."""
    setup = given_setup(options)
    zero = dict.fromkeys(library.machine(main, **{**options, "max_blocks": 0}).position, 0.0)
    given = {work_system("work", name): at for name, at in setup.work_offsets.items()}
    systems = {name: {**zero, **given.get(name, {})} for name in systems_of(library)}
    lengths = {**dict.fromkeys(range(1, 100), 0.0)}
    for number in (*setup.length_offsets, *setup.tools):
        lengths.pop(int(number), None)
    changed = dataclasses.replace(
        setup,
        work_offsets={**given, **systems},
        length_offsets={**lengths, **setup.length_offsets},
    )
    return {**options, "setup": changed}


def _texts(library: cncsub.Library) -> str:
    return "\n".join(each.text for each in library.values())


def shape(reason: str) -> str:
    """Return a reason without what is of one program: the part that differs is named."""
    differs = re.findall(r"differs in (\w+)|(code|message) \d+ of the rest|(#)\d+ is", reason)
    what = ["".join(each) for each in differs]
    first = reason.splitlines()[0]
    first = re.sub(r"\b[A-Z]*\d[\d.]*\b", "_", first)
    return f"{first}: {', '.join(what)}" if what else first


def of_rows(restarts: Restarts, rows: Iterable[Row]) -> None:
    for library, options in runnable(rows):
        restarts.of(library, **options)


def of_examples(restarts: Restarts, every: int = 1) -> None:
    for path, control in list(examples())[::every]:
        library = cncsub.load(path, control=control)
        for name in library:
            restarts.of(library, name, max_blocks=MOST_BLOCKS)


def of_calls(restarts: Restarts, places: Iterable[int]) -> None:
    for library, setup in written_calls(places):
        restarts.of(library, setup=setup)


def of_other_languages(restarts: Restarts, places: Iterable[int]) -> None:
    comparison = Comparison(SEED)
    for place in places:
        _, texts = in_other_languages(comparison, place)
        for control, text in texts.items():
            restarts.of(cncsub.loads(text, control=control))
        o_word = cncsub.loads(o_words.generate(SEED, place), control="linuxcnc")
        restarts.of(o_word, max_blocks=MOST_BLOCKS)


def of_macros(restarts: Restarts, places: Iterable[int]) -> None:
    for library in written_macros(places):
        restarts.of(library, max_blocks=MOST_BLOCKS)


def of_control(restarts: Restarts, control: str, count: int, first: int = 0) -> None:
    """Start so many programs again that end on a control, each of them at one place."""
    jobs = enumerate(jobs_on(control, first), first)
    while restarts.programs < count:
        place, job = next(jobs)
        restarts.random, restarts.name = Random(f"restarts {control} {place}"), str(place)
        restarts.of(job.library, **job.options)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", type=int, default=0, help="every so manieth row of the tables")
    parser.add_argument("--examples", action="store_true", help="every example")
    parser.add_argument("--programs", type=int, default=0, help="so many generated programs")
    parser.add_argument("--each", type=int, default=0, help="so many programs for each control")
    parser.add_argument("--control", action="append", help="one of these controls; all if left out")
    parser.add_argument("--from", type=int, default=0, dest="first", help="the first of them")
    parser.add_argument("--show", action="store_true", help="a program for each reason")
    asked = parser.parse_args()
    if asked.rows:
        sys.path.insert(0, str(EXAMPLES.parent / "tests" / "conformance"))
        from conformance import rows

        restarts = Restarts()
        of_rows(restarts, rows()[:: asked.rows])
        print("rows:", restarts.report(asked.show))
    if asked.examples:
        restarts = Restarts()
        of_examples(restarts)
        print("examples:", restarts.report(asked.show))
    places = range(asked.first, asked.first + asked.programs)
    for made in (of_calls, of_macros, of_other_languages) if asked.programs else ():
        restarts = Restarts(asked.first)
        made(restarts, places)
        print(f"{made.__name__}:", restarts.report(asked.show), flush=True)
    for control in (asked.control or list(cncsub.controls)) if asked.each else ():
        restarts = Restarts(asked.first, places=1)
        of_control(restarts, control, asked.each, asked.first)
        print(f"{control}:", restarts.report(asked.show), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
