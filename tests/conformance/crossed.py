"""Rows at another place of the machine: they are crossed with work offsets of three decimals, tool
offsets, wide limits and another start than the one that they name.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache
from random import Random
from typing import Any

import cncsub
from cncsub.testing.cases import Case
from cncsub.testing.outcome import execute, load
from ways import same

AXES = "XYZ"
WIDE = dict.fromkeys(AXES, (-1e8, 1e8))
# The words that name a place of the machine: codes, and variables of positions and offsets.
PLACES = re.compile(
    r"G\s*0*(?:10|22|27|28|29|30|36|37|53|54\.1|110|111|112|154)(?!\d)|G0*54\s*P"
    r"|#\s*(?:5[0234]\d\d|[27]\d{3}|1\d{4})\b|#<_|PFRAME|TRANS|\$A",
    re.IGNORECASE,
)
BEYOND = "a scale written over a scale"  # this row leads further than any limit
COLUMNS = ("step", "kind", *"xyzabc", "cx", "cy", "cz", "plane", "feed", "feed_mode", "spindle")
COLUMNS = (*COLUMNS, "tool", "skip", "cycle", "compensated")


def names_a_place(case: Case) -> bool:
    """Return whether a row says where on the machine something is."""
    texts = [case.program, case.mdi, *(case.files or {}).values(), *(case.external or {}).values()]
    named = any(PLACES.search(t if isinstance(t, str) else t.decode("latin-1")) for t in texts if t)
    setup = {"limits", "reference", "area"} & set(case.setup or {})
    return named or bool(setup) or case.final_machine is not None or BEYOND in case.claim


def told(run: cncsub.Run, *, lengths: bool) -> list[object]:
    """Return what does not depend on the place; `lengths` adds how long moves are, and take."""
    alarm = run.alarm
    columns = (*COLUMNS, "length", "time") if lengths else COLUMNS
    moves = [[getattr(move, name) for name in columns] for move in run.moves]
    where = alarm and (alarm.cause, alarm.number, alarm.program, alarm.n, alarm.line, alarm.word)
    return [run.stop, run.blocks, where, moves, run.m_codes, dict(run.variables)]


def setup_of(case: Case) -> dict[str, Any]:
    """Return the setup of a row, with the place where its axes start written out."""
    setup = dict(case.setup or {})
    start = {axis: -_zero_point(setup).get(axis, 0.0) for axis in AXES}
    return {**setup, "start": {**start, **setup.get("start", {})}}


def _zero_point(setup: Mapping[str, Any]) -> dict[str, float]:
    systems = setup.get("work_offsets", {})
    parts = [systems.get(name, {}) for name in ("EXT", "G54")]
    return {axis: sum(part.get(axis, 0.0) for part in parts) for axis in AXES}


@cache
def systems_of(control: str | cncsub.Control) -> list[str]:
    """Return the codes of G54 to G59 that are work systems on a control."""
    library = cncsub.loads("M30\n", control=control)

    def takes(name: str) -> bool:
        try:
            library.run(setup={"work_offsets": {name: {"X": 1.0}}})
        except ValueError:
            return False
        return True

    return [name for name in (f"G{number}" for number in range(54, 60)) if takes(name)]


def moved(
    setup: Mapping[str, Any], control: str | cncsub.Control, random: Random
) -> dict[str, Any]:
    """Return the setup with all zero points elsewhere, on a machine whose limits are wide."""
    offsets = {axis: round(random.uniform(-1000, 1000), 3) for axis in AXES}
    systems = {name: dict(axes) for name, axes in setup.get("work_offsets", {}).items()}
    if systems:
        own = systems.get("EXT", {})
        systems["EXT"] = {axis: own.get(axis, 0.0) + offsets[axis] for axis in AXES}
    else:
        systems = dict.fromkeys(systems_of(control), offsets)
        systems["EXT"] = {axis: round(random.uniform(-50, 50), 3) for axis in AXES}
    return {**setup, "work_offsets": systems, "limits": WIDE}


def shifted(setup: Mapping[str, Any], part: float) -> Iterator[dict[str, Any]]:
    """Yield the setup with another start, other lengths, other tool offsets: a whole number plus
    `part`.
    """
    by = {"X": 24 + 2 * part, "Y": 23 + part, "Z": -7 + part}
    yield {**setup, "start": {axis: setup["start"][axis] + by[axis] for axis in AXES}}
    lengths = setup.get("length_offsets", {})
    yield {**setup, "length_offsets": {n: lengths.get(n, 0.0) + by["Y"] for n in range(1, 20)}}
    tools = {number: dict(tool) for number, tool in setup.get("tools", {}).items()}
    for number in range(1, 10):
        tool = tools.setdefault(number, {})
        tool.update({axis: tool.get(axis, 0.0) + by[axis] for axis in "XZ"})
    yield {**setup, "tools": tools}


def changes(case: Case, control: str, random: Random) -> Iterator[str]:
    """Yield what else changes in a row besides machine positions."""
    library = load(case, cncsub.controls[control])

    def run(setup: Mapping[str, Any], *, lengths: bool) -> list[object]:
        made = execute(case, library, trace="moves", setup=cncsub.Setup(**setup))
        return told(made, lengths=lengths)

    setup = setup_of(case)
    plain = run(setup, lengths=True)
    if not plain[3]:
        return
    elsewhere = moved(setup, control, random)
    other = run(elsewhere, lengths=True)
    if not same(plain, other):
        yield f"with {elsewhere}: {_first(plain, other)}"
    # A row that does not depend on a start or an offset does not depend on its decimals either.
    plain = run(setup, lengths=False)
    fine = round(random.uniform(0, 1), 3) + 0.0004
    for whole, parts in zip(shifted(setup, 0), shifted(elsewhere, fine), strict=True):
        if same(plain, run(whole, lengths=False)):
            other = run(parts, lengths=False)
            if not same(plain, other):
                yield f"with {parts}: {_first(plain, other)}"


def _first(plain: list[object], other: list[object]) -> str:
    return next(f"{b} instead of {a}" for a, b in zip(plain, other, strict=True) if not same(a, b))
