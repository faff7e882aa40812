"""What a SINUMERIK program writes to a part of a frame is what it reads."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import cncsub

FRAMES = ("FRAME1", "$P_PFRAME", "$P_UIFR[2]", "$P_IFRAME")
AXES = ("X", "Y", "Z")


def _numbers(low: float, high: float) -> st.SearchStrategy[str]:
    """Return numbers as programs write them, of up to nine digits after the point."""
    return st.builds(
        lambda value, digits: f"{value:.{digits}f}", st.floats(low, high), st.integers(0, 9)
    )


VALUES = {
    "TR": _numbers(-9999, 9999),
    "FI": _numbers(-9, 9),
    "SC": _numbers(0.01, 99).filter(lambda text: float(text) > 0),
    "MI": st.sampled_from(("0", "1")),
    "RT": _numbers(-180, 180),
}


@st.composite
def parts(draw: st.DrawFn) -> tuple[str, str, str]:
    axis, part = draw(st.sampled_from(AXES)), draw(st.sampled_from(tuple(VALUES)))
    # About Y less than a quarter of a turn is read; more is the same as turns about X and Z.
    low = part == "RT" and axis == "Y"
    return axis, part, draw(_numbers(-89.9, 89.9) if low else VALUES[part])


def _part(frame: str, axis: str, part: str) -> str:
    return f"{frame[:-1]},{axis},{part}]" if frame.endswith("]") else f"{frame}[{axis},{part}]"


def _read(frame: str, written: dict[tuple[str, str], str], blocks: list[str]) -> dict[int, float]:
    """Run blocks and return what R0, R1, ... then read of the parts."""
    reads = [f"R{n}={_part(frame, *place)}" for n, place in enumerate(written)]
    text = "\n".join(["DEF FRAME FRAME1", *blocks, *reads, "M30", ""])
    run = cncsub.loads(text, control="siemens-one").run()
    assert run.alarm is None, run.alarm
    return {n: float(run.variables[n] or 0) for n in range(len(written))}


@settings(max_examples=150, deadline=None)
@given(frame=st.sampled_from(FRAMES), said=st.lists(parts(), min_size=1, max_size=9))
def test_each_part_that_is_written_is_read_again(
    frame: str, said: list[tuple[str, str, str]]
) -> None:
    written = {(axis, part): value for axis, part, value in said}
    blocks = [f"{_part(frame, axis, part)}={value}" for axis, part, value in said]
    read = _read(frame, written, blocks)
    assert list(read.values()) == [float(value) for value in written.values()]


FUNCTIONS = {"TR": "CTRANS", "FI": "CFINE", "RT": "CROT", "SC": "CSCALE"}


@settings(max_examples=100, deadline=None)
@given(frame=st.sampled_from(FRAMES), said=st.lists(parts(), min_size=1, max_size=6))
def test_so_is_what_a_function_of_frames_says(frame: str, said: list[tuple[str, str, str]]) -> None:
    part = said[0][1]
    written = {(axis, p): value for axis, p, value in said if p == part and part in FUNCTIONS}
    if not written:
        return
    values = ",".join(f"{axis},{value}" for (axis, _), value in written.items())
    read = _read(frame, written, [f"{frame}={FUNCTIONS[part]}({values})"])
    assert list(read.values()) == [float(value) for value in written.values()]


@settings(max_examples=60, deadline=None)
@given(turn=_numbers(-180, 180), shift=_numbers(-999, 999), factor=VALUES["SC"])
def test_a_chain_with_a_shift_keeps_them(turn: str, shift: str, factor: str) -> None:
    written = {("Z", "RT"): turn, ("Y", "SC"): factor}
    chain = f"FRAME1=CTRANS(X,{shift}):CROT(Z,{turn}):CTRANS(Y,{shift})"
    read = _read("FRAME1", written, [chain, f"FRAME1[Y,SC]={factor}"])
    assert list(read.values()) == [float(turn), float(factor)]


@pytest.mark.parametrize(
    ("function", "read"),
    [  # the first two stand in the manual
        ("X,10,Y,90,Z,40", (0, 90, 30)),
        ("X,190,Y,0,Z,-200", (-170, 0, 160)),
        ("Z,400", (0, 0, 40)),
        ("Y,100", (180, 80, 180)),
        ("Y,-90,X,5", (0, -90, 5)),
        ("Z,-540", (0, 0, 180)),
    ],
)
def test_angles_out_of_their_range_are_read_inside(
    function: str, read: tuple[float, float, float]
) -> None:
    text = "R1=$P_UIFR[1,X,RT] R2=$P_UIFR[1,Y,RT] R3=$P_UIFR[1,Z,RT]\nM30\n"
    run = cncsub.loads(f"$P_UIFR[1]=CROT({function})\n{text}", control="siemens-one").run()
    assert run.alarm is None
    found = tuple(float(run.variables[n] or 0) for n in (1, 2, 3))
    assert [abs(a) % 360 for a in found] == [abs(b) % 360 for b in read]
    assert found[1] == read[1]
