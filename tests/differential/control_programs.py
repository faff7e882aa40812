"""Generated programs for one control: of each kind that is written for its language, by turns."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import count
from random import Random
from typing import Any, NamedTuple

import cncsub
import grblhal
import o_words
import sinumerik
from comparison import Comparison
from flat_programs import MOST_BLOCKS, SEED, in_other_languages
from machines import OTHER_LANGUAGES, Station
from macros import program as macro
from programs import MILLING, TURNING, generate
from spelling import Speller


class Job(NamedTuple):
    """A library, and the options of its run."""

    library: cncsub.Library
    options: dict[str, Any]


Kind = Callable[[int], Job]  # of programs: one for each place in the series


def jobs_on(control: str, first: int = 0) -> Iterator[Job]:
    """Yield programs for a control without end."""
    kinds = kinds_on(control)
    for place in count(first):
        yield kinds[place % len(kinds)](place)


def kinds_on(control: str) -> list[Kind]:
    """Return the kinds of programs that are generated for a control, those that come to an end."""
    dialect = cncsub.controls[control].dialect
    if dialect == "sinumerik":
        return [partial(_calls_of_another, control, "siemens-one"), partial(_sinumerik, control)]
    if dialect == "linuxcnc":
        return [partial(_calls_of_another, control, "linuxcnc"), partial(_o_word, control)]
    if control in OTHER_LANGUAGES:
        return [partial(_grblhal, control)]
    comparison = Comparison(SEED)
    calls: list[Kind] = [
        partial(_calls, comparison, each) for each in comparison.stations if each.control == control
    ]
    macros = partial(_macro, control)
    ends = any(str(job.library.run(**job.options).stop) == "end" for job in map(macros, range(20)))
    return [*calls, macros] if ends else calls


def _calls(comparison: Comparison, station: Station, place: int) -> Job:
    random = comparison.random(place, station.name)
    mills = station.mills() and random.random() < 0.5
    meant = generate(random, MILLING if mills else TURNING)
    text = Speller(station.style, random).write(meant)
    return Job(cncsub.loads(text, control=station.control), {"setup": station.setup})


def _macro(control: str, place: int) -> Job:
    text = macro(Random(f"{SEED} {place}"))
    return Job(cncsub.loads(text, control=control), {"max_blocks": MOST_BLOCKS})


def _calls_of_another(control: str, language_of: str, place: int) -> Job:
    _, texts = in_other_languages(Comparison(SEED), place)
    return Job(cncsub.loads(texts[language_of], control=control), {})


def _o_word(control: str, place: int) -> Job:
    text = o_words.generate(SEED, place)
    return Job(cncsub.loads(text, control=control), {"max_blocks": MOST_BLOCKS})


def _sinumerik(control: str, place: int) -> Job:
    programs = sinumerik.programs_of(SEED, place, sinumerik.USED)
    text = sinumerik.text(programs, Random(f"{SEED} {place} text"))
    zeros = {name: dict(zip("XYZ", at, strict=True)) for name, at in sinumerik.ZEROS.items()}
    options = {
        "setup": cncsub.Setup(work_offsets=zeros),
        "block_skip": tuple(level + 1 for level in sinumerik.SKIPPED),
        "max_blocks": MOST_BLOCKS,
    }
    return Job(cncsub.loads(text, control=control), options)


def _grblhal(control: str, place: int) -> Job:
    files = grblhal.write(SEED, place)
    return Job(cncsub.loads(files, control=control), {"max_blocks": grblhal.MAX_BLOCKS})
