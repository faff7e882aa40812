"""Random contours under radius compensation, on every control that has it.

`python tests/contours --contours 100000` does the same with more of them.
"""

from __future__ import annotations

import math
import re
import shutil
import subprocess
from pathlib import Path
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import cncsub
from curves import Curve
from drawing import draw
from stations import NONE, Station, Writer
from trials import Trials

CONTOURS = 460
SEED = 20


@pytest.fixture(scope="module")
def trials() -> Trials:
    done = Trials(SEED)
    for place in range(CONTOURS):
        done.compare(place)
    return done


def test_the_tool_goes_beside_every_contour_into_which_it_fits(trials: Trials) -> None:
    assert trials.failures == []
    assert trials.worst < 2
    assert trials.outcomes["taken"] > CONTOURS / 2


def test_the_contours_go_over_the_whole_ground(trials: Trials) -> None:
    assert {station.control for station in trials.stations} == {*cncsub.controls} - NONE
    assert set(trials.runs) == {str(station) for station in trials.stations}
    assert trials.outcomes["refused"] > CONTOURS / 30
    contours = [trials.contour(place) for place in range(300)]
    assert {written.inch for _, _, written in contours} == {True, False}
    assert {round(math.log10(written.least)) for _, _, written in contours} == {-3, -4}
    assert {written.plane for _, _, written in contours} == {17, 18, 19}
    turns = np.concatenate([drawing.corners() for _, drawing, _ in contours])
    assert {-1, 0, 1} == set(np.sign(np.round(turns, 3)))
    assert any("R" in written.text for _, _, written in contours)


@pytest.mark.parametrize("control", ["gsk-988ta", "gsk-980tdi", "fanuc-0i-f"])
def test_a_block_without_a_move_after_the_smallest_step_changes_no_path(control: str) -> None:
    """A step of an increment of a diameter counts as a move: two blocks without one are met nowhere."""
    blocks = "G1 Z97.119 X-61.304\nG1 X-61.303\n{}G1 Z102.555 X-36.284\nG1 Z94.659 X0.562\n"
    head = "O1\nT0101\nG0 Z98.315 X-106.946\nG98 G41 G1 Z99.83 X-105.672 F100.\n"
    setup = {"machine": "lathe-a", "tools": {1: {"R": 0.4, "tip": 4}}}
    paths = []
    for between in ("", "M8\n"):
        text = head + blocks.format(between) + "G40 G1 Z92. X0.6\nM30\n"
        run = cncsub.loads(text, control=control).run(setup=setup)
        paths.append({(round(move.mx, 6), round(move.mz, 6)) for move in run.moves})
    assert paths[0] == paths[1]


def test_the_distance_to_an_arc_is_that_to_its_nearest_point() -> None:
    arc = Curve(np.array([2.0, 0.0]), np.array([0.0, 2.0]), np.zeros(2), math.pi / 2)
    points = np.array([[3.0, 0.0], [0.0, 0.0], [1.0, 1.0], [-1.0, 2.0], [2.0, -2.0]])
    expected = [1.0, 2.0, 2 - math.sqrt(2), 1.0, 2.0]
    np.testing.assert_allclose(arc.distances(points), expected, atol=1e-12)


# ---- LinuxCNC, compared with its interpreter ----


def _as_for_linuxcnc(place: int) -> tuple[str, float]:
    """Return a contour in G17 that names the diameter of the tool, and its unit in mm."""
    random = Random(f"{SEED} linuxcnc {place}")
    while True:
        drawing = draw(random)
        written = Writer(random, Station("linuxcnc", "mill")).write(drawing)
        plain = written.plane == 17 and "Z" not in written.text
        if written.meant and plain and not drawing.tight:
            break
    unit = 25.4 if written.inch else 1.0
    text = re.sub(
        r"G4([12]) D1",
        rf"G4\1.1 D{2 * drawing.radius / unit:.6f}",
        written.text.replace("O1\n", ""),
    )
    return text.replace("M30", "M2"), unit


@pytest.mark.skipif(
    shutil.which("rs274") is None, reason="rs274 is not installed: Debian package linuxcnc-uspace"
)
def test_linuxcnc_goes_beside_contours_as_its_interpreter_does(tmp_path: Path) -> None:
    """Both refuse a contour without room, after the same moves."""
    refused = 0
    for place in range(80):
        text, unit = _as_for_linuxcnc(place)
        file = tmp_path / f"{place}.ngc"
        file.write_text(text)
        theirs = subprocess.run(
            ["rs274", "-g", str(file)],
            capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=30, check=False, cwd=tmp_path,
        )  # fmt: skip
        ends = re.findall(
            r"(?:STRAIGHT_FEED|STRAIGHT_TRAVERSE|ARC_FEED)\((-?[\d.]+), (-?[\d.]+)", theirs.stdout
        )
        run = cncsub.loads(text, control="linuxcnc").run(setup=cncsub.Setup(machine="mill"))
        wrong = theirs.stderr.replace("executing\n", "").splitlines()
        assert (run.alarm is not None) == bool(wrong), f"{run.alarm}\n{wrong}\n{text}"
        refused += bool(wrong)
        ours = np.stack([run.moves.mx, run.moves.my], axis=1) / unit
        np.testing.assert_allclose(
            _moved(ours), _moved(np.array(ends, float)), atol=2e-3 / unit, err_msg=text
        )
    assert 5 < refused < 40


def _moved(points: np.ndarray) -> np.ndarray:
    """Return the points without those that are equal to the point before."""
    return points[np.append(True, np.abs(np.diff(points, axis=0)).max(axis=1) > 1e-3)]


# ---- the order of the moves ----

PLANES = {17: tuple("XYIJZ"), 18: tuple("ZXKIY"), 19: tuple("YZJKX")}
MILLS = [name for name in cncsub.controls if name not in {"gsk-980tdi"} | NONE]
MILLS = [name for name in MILLS if not name.startswith("gsk-988")]


@st.composite
def climbs(draw: st.DrawFn) -> tuple[int, list[str]]:
    """Draw blocks of a compensated contour in a plane, while the axis across it only ever rises."""
    plane = draw(st.sampled_from(sorted(PLANES)))
    a, b, i, j, c = PLANES[plane]
    places = st.integers(-60, 60)
    height, blocks = 0, []
    for _ in range(draw(st.integers(2, 10))):
        kind = draw(
            st.sampled_from(["line", "line", "arc", "step", "corner", "rise", "other", "helix"])
        )
        at = f"{a}{draw(places)}. {b}{draw(places)}."
        if kind in ("rise", "helix"):
            height += draw(st.integers(1, 9))
        if kind == "rise":
            blocks.append(f"{draw(st.sampled_from(['G1', 'G0']))} {c}{height}.")
        elif kind == "helix":
            blocks.append(f"G1 {at} {c}{height}.")
        elif kind == "arc":
            way, middle = draw(st.sampled_from(["G2", "G3"])), draw(st.integers(2, 20))
            blocks.append(f"G1 {at}")
            blocks.append(f"G91 {way} {a}{2 * middle}. {i}{middle}. {j}0. {c}1.")
            blocks.append("G90")
            height += 1
        elif kind == "step":  # a step of some increments
            way = " ".join(f"{name}{draw(st.integers(-9, 9)) / 1000}" for name in (a, b))
            blocks += [f"G91 G1 {way}", "G90"]
        elif kind == "corner":
            cut = draw(st.sampled_from([",C1.", ",R2."]))
            blocks.append(f"G1 {at} {cut}")
        elif kind == "other":
            blocks.append(
                draw(st.sampled_from(["G4 P1", "M8", "M98 P2", "D2", "G41", "G42", "S5"]))
            )
        else:
            blocks.append(f"{draw(st.sampled_from(['G1', 'G1', 'G0']))} {at}")
    return plane, blocks


@given(
    control=st.sampled_from(MILLS),
    climb=climbs(),
    radius=st.sampled_from([0.01, 0.5, 3.0]),
    around=st.booleans(),
    end=st.sampled_from(["G40 {a}200.", "G40", "G40 {c}99.", "M30"]),
)
def test_steps_never_go_back_and_an_axis_across_the_plane_never_returns(
    control: str, climb: tuple[int, list[str]], radius: float, around: bool, end: str
) -> None:
    plane, blocks = climb
    a, b, _, _, c = PLANES[plane]
    head = [f"G90 G{plane} G0 {a}0. {b}-99. {c}0.", f"G41 D1 G1 {a}5. {b}-70. F100."]
    body = [*head, *blocks, end.format(a=a, c=c)]
    text = "\n".join(["O1", *body, "M30", "O2", "S7", "M9", "M99", ""])
    made = cncsub.controls[control]
    if around:
        made = made.replace(start_up="type-b")
    setup = {"machine": "mill", "radius_offsets": {1: radius, 2: radius / 2}}
    moves = cncsub.loads(text, control=made).run(setup=setup).moves
    assert (np.diff(moves.step) >= 0).all()
    assert (np.diff(getattr(moves, "m" + c.lower())) >= -1e-9).all()
