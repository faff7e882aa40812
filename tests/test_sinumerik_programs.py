"""Generated programs of SINUMERIK do what an independent evaluator says.

`python tests/differential/sinumerik.py --programs 20000` does the same with more of them.
"""

from __future__ import annotations

import dataclasses
import typing
from collections.abc import Callable

import pytest

import cncsub
import sinumerik
import sinumerik_evaluator
import sinumerik_language as l
import sinumerik_paths
from sinumerik import DIFFERENT, NOT_COMPUTED, compare, computed, evaluated, programs_of
from sinumerik_values import FEATURES

SEED = 1
PLACES = range(300)


def test_programs_do_what_the_evaluator_says(capsys: pytest.CaptureFixture[str]) -> None:
    report = compare(SEED, PLACES)
    assert report.different == [], capsys.readouterr().out
    assert report.programs > 0.8 * len(PLACES)
    assert report.moves > 10 * len(PLACES)
    assert report.causes["jump-target-not-found"] > 0


def test_what_the_programs_leave_out_is_refused_as_not_computed() -> None:
    for feature, program in NOT_COMPUTED.items():
        assert feature in FEATURES
        run = cncsub.loads(program, control=sinumerik.CONTROL).run(max_blocks=1000)
        assert run.alarm is not None, f"cncsub computes {feature}: take it out of NOT_COMPUTED"
        assert run.alarm.cause == "code-not-computed"


def test_what_is_known_to_differ_still_does() -> None:
    for feature, (program, wanted) in DIFFERENT.items():
        assert feature in FEATURES
        last = computed(program).moves[-1]
        assert last[1] - sinumerik.OFFSET[0] != pytest.approx(wanted), f"take {feature} out"


def test_the_programs_go_over_the_whole_ground() -> None:
    programs = [programs_of(SEED, place, frozenset(FEATURES)) for place in PLACES]
    blocks = [b.action for of in programs for program in of.values() for b in program.blocks]
    kinds = {type(action) for action in blocks}
    assert kinds == set(typing.get_args(l.Action))
    opened = {action.kind for action in blocks if isinstance(action, l.Open)}
    assert opened == {"IF", "WHILE", "FOR", "LOOP", "REPEAT"}
    jumps = {way[1] for action in blocks if isinstance(action, l.Jump) for way in action.ways}
    assert jumps == {"GOTO", "GOTOF", "GOTOB", "GOTOC"}
    frames = {action.op for action in blocks if isinstance(action, l.Frame)}
    assert frames == {a + op for a in ("", "A") for op in ("TRANS", "ROT", "SCALE", "MIRROR")}
    codes = {action.code for action in blocks if isinstance(action, l.Code | l.Pole)}
    assert codes == {"G17", "G18", "G19", "G54", "G55", "G500", "G505", "G110", "G111", "G112"}
    arcs = {(action.clockwise, action.way) for action in blocks if isinstance(action, l.Arc)}
    assert arcs == {(turn, way) for turn in (True, False) for way in ("", "AC", "CR")}
    parts = {(a.only, a.ended, a.block) for a in blocks if isinstance(a, l.Again)}
    assert len(parts) == 4
    returns = {(a.after, a.levels) for a in blocks if isinstance(a, l.Back)}
    assert returns == {(after, levels) for after in (True, False) for levels in (1, 2)}
    manners = {(a.manner, a.times > 1) for a in blocks if isinstance(a, l.Call)}
    assert manners >= {("P=", True), ("P", True), ("P=+", True), ("CALL", False), ("PCALL", False)}
    levels = {b.level for of in programs for program in of.values() for b in program.blocks}
    assert levels == {None, 0, 1, 3, 9}
    types = {d.type for of in programs for program in of.values() for d in program.definitions}
    assert types == {"INT", "REAL", "BOOL", "STRING", "CHAR", "AXIS", "FRAME"}
    given = {(a.to.text, type(a.value)) for a in blocks if isinstance(a, l.FrameAssign)}
    assert {text for text, _ in given} >= {"$P_PFRAME", "$P_UIFR[1]", "$P_UIFR[2]", "$P_UIFR[5]"}
    assert {kind for _, kind in given} == {l.FrameCall, l.FrameName, l.Chain}


def _cut(value: float | int | bool | str, to: str) -> float | int | bool | str:
    if to == "STRING":
        return value or ""
    if to == "AXIS":
        return value
    return int(value) if to == "INT" else bool(value) if to == "BOOL" else float(value)


def _bare(program: l.Program) -> l.Program:
    """Return a program whose parameters have no value of their own."""
    if program.formals is None:
        return program
    formals = tuple(dataclasses.replace(of, initial=None) for of in program.formals)
    return dataclasses.replace(program, formals=formals)


def _blocks(change: Callable[[l.Block], l.Block]) -> Callable[[l.Program], l.Program]:
    return lambda program: dataclasses.replace(program, blocks=list(map(change, program.blocks)))


def _with(kind: type, **fields: object) -> Callable[[l.Block], l.Block]:
    """Return a change of the blocks of a kind."""
    return lambda block: (
        dataclasses.replace(block, action=dataclasses.replace(block.action, **fields))  # type: ignore[arg-type]
        if isinstance(block.action, kind)
        else block
    )


CHANGES = {
    "default": _bare,
    "arc": _blocks(_with(l.Arc, clockwise=True)),
    "RET": _blocks(_with(l.Back, after=False)),
    "modal call": _blocks(_with(l.Modal, name="")),
    "repeated part": _blocks(_with(l.Again, times=1)),
    "skipping": _blocks(lambda block: dataclasses.replace(block, level=None)),
}
RULES = ("rounding", "priority", "function", "plane", "pole", "chain", "part", *CHANGES)


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: f"another {rule}")
def test_another_rule_is_noticed(rule: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if rule == "rounding":
        monkeypatch.setattr(sinumerik_evaluator, "converted", lambda value, to: _cut(value, to))
    elif rule == "priority":
        monkeypatch.setitem(l.PRIORITY, "AND", 10)
    elif rule == "function":
        monkeypatch.setitem(sinumerik_evaluator.FUNCTIONS, "POT", lambda value: value * 2)
    elif rule == "plane":
        monkeypatch.setitem(sinumerik_paths.PLANES, "G18", ("X", "Z", "Y"))
    elif rule == "chain":
        chained = sinumerik_evaluator.chained
        monkeypatch.setattr(sinumerik_evaluator, "chained", lambda a, b: chained(b, a))
    elif rule == "part":
        put = sinumerik_evaluator.with_part
        monkeypatch.setattr(
            sinumerik_evaluator, "with_part", lambda of, axis, name, value: put(of, axis, name, 0)
        )
    elif rule == "pole":
        point = sinumerik_paths.Paths.point
        monkeypatch.setattr(
            sinumerik_paths.Paths, "point", lambda self, radius, angle: point(self, radius, -angle)
        )
    else:
        change = CHANGES[rule]
        monkeypatch.setattr(
            sinumerik,
            "evaluated",
            lambda of: evaluated({name: change(each) for name, each in of.items()}),
        )
    parts = (range(first, first + 20) for first in range(0, 500, 20))
    assert any(compare(SEED, part, told=False).different for part in parts)


def test_moves_are_compared_in_machine_coordinates() -> None:
    made = computed("G54 G71 F1000\nG90 G0 X1 Y2 Z3\nM30\n")
    x, y, z = sinumerik.OFFSET
    assert made.moves == [("rapid", x + 1, y + 2, z + 3)]
