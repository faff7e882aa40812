"""The drawings in SVG: true to scale, with ticks, holes, tool changes and the alarm's place."""

from __future__ import annotations

import re
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
import pytest

import cncsub
from cncsub.drawing.axes import Frame, round_step, tick_text
from cncsub.drawing.marks import Moved, holes_of, tool_changes
from cncsub.drawing.path import ABOVE, FRONT, SIDE, TURNING, View
from cncsub.drawing.svg import Picture

CONTROL = "fanuc-0i-f"
SVG = "{http://www.w3.org/2000/svg}"
DRILLED = """O1
N10 T1 M6
N20 G0 X0 Y0 Z50.
N30 G81 X10. Y5. Z-3. R1. F100
N40 X30.
N50 X30. Y20.
N60 G80 G0 X0 Y0
N70 T2 M6
N80 G83 X30. Y5. Z-9. R1. Q2. F50
N90 G80 G0 Z50.
N95 M30
"""


def ran(text: str, control: str = CONTROL, **options: Any) -> cncsub.Run:
    return cncsub.loads(text, control=control, name="job.nc").run(**options)


def moved(run: cncsub.Run) -> Moved:
    return Moved(run.recorded, "work", bool(run.recorded.diameters & 1))


def holes(text: str, view: View = ABOVE) -> list[list[float]]:
    found = holes_of(moved(ran(text)), view)
    places: list[list[float]] = np.round(found.at, 6).tolist()
    return places


def drawing(run: cncsub.Run) -> ET.Element:
    return ET.fromstring(run.svg())


def group(root: ET.Element, name: str) -> ET.Element:
    found = [g for g in root.iter(f"{SVG}g") if g.get("class") == name]
    assert found, name
    return found[0]


def texts(of: ET.Element) -> list[str]:
    return [text.text or "" for text in of.iter(f"{SVG}text")]


def titles(of: ET.Element) -> list[str]:
    return [title.text or "" for title in of.iter(f"{SVG}title")]


# ---- holes and tool changes ----


def test_holes_of_cycles_are_in_the_order_in_which_they_were_begun() -> None:
    found = holes_of(moved(ran(DRILLED)), ABOVE)
    assert found.at.tolist() == [[10, 5, -3], [30, 5, -9], [30, 20, -3]]
    assert found.passes.tolist() == [1, 2, 1]


def test_a_hole_of_plain_moves_is_a_hole() -> None:
    plunge = "O1\nG0 X5. Y6. Z2.\nG1 Z-4. F100\nG0 Z2.\nX9.\nG1 Z-1.\nG4 X1.\nG1 Z2.\nG0 X0\nM30\n"
    assert holes(plunge) == [[5, 6, -4], [9, 6, -1]]
    assert holes("O1\nG0 X5. Y6. Z2.\nG1 Z-4. F100\nM30\n") == [[5, 6, -4]]


def test_the_begin_and_the_end_of_a_slot_are_no_holes() -> None:
    slot = "O1\nG0 X5. Y6. Z2.\nG1 Z-4. F100\nX20.\nG1 Z2.\nG0 X0\nM30\n"
    assert holes(slot) == []
    circle = "O1\nG0 X5. Y6. Z2.\nG1 Z-4. F100\nG2 I5.\nG0 Z2.\nX0\nM30\n"
    assert holes(circle) == []


def test_holes_across_are_seen_from_their_side() -> None:
    across = "O1\nG18\nG0 X5. Y9. Z2.\nG81 X5. Z2. Y-3. R8. F100\nX10.\nG80\nM30\n"
    assert holes(across) == []
    assert [place[1] for place in holes(across, FRONT)] == [-3, -3]


def test_the_tools_of_one_place_are_one_mark() -> None:
    found = tool_changes(moved(ran(DRILLED)), ABOVE, 9)
    assert [change.tools for change in found] == [(1, 2)]
    apart = "O1\nT1 M6\nG0 X5.\nT2 M6\nG0 X9.\nT1 M6\nG0 X20.\nM30\n"
    found = tool_changes(moved(ran(apart)), ABOVE, 9)
    assert [(change.at[0], change.tools) for change in found] == [(0, (1,)), (5, (2,)), (9, (1,))]
    assert len(tool_changes(moved(ran(apart)), ABOVE, 2)) == 2
    assert tool_changes(moved(ran("O1\nG0 X5.\nM30\n")), ABOVE, 9) == []


def test_a_drawing_numbers_its_holes_and_tells_each() -> None:
    root = drawing(ran(DRILLED))
    rings = group(root, "holes")
    assert titles(rings) == [
        "hole 1: X10 Y5 Z-3",
        "hole 2: X30 Y5 Z-9, 2 times",
        "hole 3: X30 Y20 Z-3",
    ]
    assert texts(rings) == ["1", "2", "3"]
    assert titles(group(root, "tools")) == ["tool change: T1 T2 at X0 Y0 Z0"]
    legend = ["rapid", "hole, numbered in order", "tool change", "start"]  # a cycle is its holes
    assert texts(group(root, "legend")) == legend


def test_many_holes_are_dots_and_stay_small() -> None:
    grid = "".join(f"X{i % 100}. Y{i // 100}.\n" for i in range(1, 5_000))
    svg = ran(f"O1\nG0 Z5.\nG81 X0 Y0 Z-3. R1. F100\n{grid}G80\nM30\n").svg()
    assert len(svg) < 250_000
    root = ET.fromstring(svg)
    assert "5,000 holes" in texts(group(root, "legend"))
    assert texts(group(root, "holes")) == []
    (dots,) = group(root, "holes").iter(f"{SVG}path")
    assert (dots.get("d") or "").count("h0") == 5_000


# ---- the view that suits ----


@pytest.mark.parametrize(
    ("text", "control", "view"),
    [
        ("G0 X10. Y5. Z2.\nG1 Z-1. F100\nX20.\n", CONTROL, ABOVE),
        ("G0 X10. Z2.\nG1 X20. Z-1. F100\n", CONTROL, FRONT),
        ("G0 Y10. Z2.\nG1 Y20. Z-1. F100\n", CONTROL, SIDE),
        ("G0 X10. Y5. Z2.\nG18 G2 X20. Z2. R5. F100\n", CONTROL, FRONT),
        ("G0 X10. Y5. Z2.\nG19 G2 Y20. Z2. R9. F100\n", CONTROL, SIDE),
        ("G0 X10. Y5. Z2.\nG2 X20. R9. F100\nG18 G2 X30. Z2. R9.\n", CONTROL, ABOVE),
        ("G0 X10. Z2.\nG1 X20. Z-1. F100\n", "gsk-988ta", TURNING),
        ("G0 X10.\n", CONTROL, ABOVE),
        ("G0 Z10.\n", CONTROL, FRONT),
    ],
)
def test_the_view_suits_the_path(text: str, control: str, view: View) -> None:
    assert Picture(ran(f"O1\n{text}M30\n", control)).path.view == view


def test_a_lathe_is_drawn_as_on_its_drawing_with_diameters_at_the_axis() -> None:
    run = ran("O1\nG0 X40. Z5.\nG1 X40. Z-100. F100\nX100.\nM30\n", "gsk-988ta")
    picture = Picture(run)
    frame = picture.frame()
    (near, far) = frame.placed(np.array([[20.0, 0, 0], [50.0, 0, -100.0]])).tolist()
    assert far[0] < near[0]  # Z to the right
    assert far[1] < near[1]  # X upwards
    root = drawing(run)
    ticks = texts(group(root, "ticks"))
    assert ticks[-2:] == ["Z, mm", "X diameter, mm"]
    upwards = list(frame.ticks(1))
    for tick in upwards:
        radius = float(tick.text) / 2
        assert frame.placed(np.array([[radius, 0, 0]]))[0, 1] == pytest.approx(tick.at)


# ---- axes ----


@pytest.mark.parametrize(
    ("least", "step"),
    [(1, 1), (1.1, 2), (2.2, 5), (7, 10), (0.3, 0.5), (0.06, 0.1), (4e6, 5e6), (10, 10)],
)
def test_steps_are_round(least: float, step: float) -> None:
    assert round_step(least) == pytest.approx(step)


def test_numbers_of_ticks_have_the_digits_of_their_step() -> None:
    told = [tick_text(v, s) for v, s in ((0.5, 0.5), (10, 5), (-1e-17, 0.1), (0.02, 0.02))]
    assert told == ["0.5", "10", "0", "0.02"]


@pytest.mark.parametrize("size", [1e-4, 0.03, 1.0, 77.0, 5e3, 2e6])
@pytest.mark.parametrize("ratio", [0.001, 0.3, 1.0, 40.0])
def test_ticks_lie_where_their_number_is_and_a_millimetre_is_as_long_both_ways(
    size: float, ratio: float
) -> None:
    points = np.array([[-size / 3, 5.0, 0.0], [size, 5.0 + size * ratio, 0.0]])
    frame = Frame(points, ABOVE, diameters=False, inch=False)
    placed = frame.placed(points)
    assert (placed[:, 0] >= 54).all()
    assert (placed[:, 0] <= 480 - 16).all()
    assert (placed[:, 1] >= 24).all()
    assert (placed[:, 1] <= 24 + frame.inner).all()
    way = np.abs(placed[1] - placed[0]) / np.abs(points[1, :2] - points[0, :2])
    assert way[0] == pytest.approx(way[1])
    for side in (0, 1):
        ticks = list(frame.ticks(side))
        assert len(ticks) <= 10
        for tick in ticks:
            at = np.array([[float(tick.text)] * 3])
            assert frame.placed(at)[0, side] == pytest.approx(tick.at, abs=0.5)
    assert len(list(frame.ticks(0))) + len(list(frame.ticks(1))) >= 3


def test_a_program_in_inches_has_ticks_in_inches() -> None:
    root = drawing(ran("O1\nG20\nG0 X0 Y0\nG1 X3. Y2. F10.\nM30\n"))
    ticks = texts(group(root, "ticks"))
    assert ticks[-2:] == ["X, inch", "Y, inch"]
    assert "3.0" in ticks
    assert "3 x 2 inch" in (root.get("aria-label") or "")
    holes = drawing(ran("O1\nG20\nG81 X3. Y2. Z-1. R.1 F10.\nG80\nM30\n"))
    assert titles(group(holes, "holes")) == ["hole 1: X3 Y2 Z-1"]


# ---- alarms, and what is hard to draw ----


def test_the_place_of_an_alarm_is_marked() -> None:
    run = ran("O1\nN10 G0 X10. Y10.\nN20 G1 X50. F100\nN30 M98 P9\nN40 X90.\nM30\n")
    assert run.alarm is not None
    mark = group(drawing(run), "alarm")
    assert titles(mark) == ["PS0076 at O1 N30: the tool was at X50 Y10 Z0"]
    assert texts(mark) == ["PS0076 at O1 N30"]
    ((x, y),) = Picture(run).frame().placed(np.array([[50.0, 10.0, 0.0]])).tolist()
    (ring,) = mark.iter(f"{SVG}circle")
    assert (float(ring.get("cx") or 0), float(ring.get("cy") or 0)) == pytest.approx(
        (x, y), abs=0.1
    )
    fine = drawing(ran("O1\nG0 X5.\nM30\n"))
    assert [g for g in fine.iter(f"{SVG}g") if g.get("class") == "alarm"] == []


def test_labels_stay_within_the_drawing() -> None:
    text = "O1\nN10 G0 X10. Y10.\nN20 G1 X{} F100\nN30 M98 P9\nM30\n"
    for end in ("500.", "-500."):
        root = drawing(ran(text.format(end)))
        (words,) = group(root, "alarm").iter(f"{SVG}text")
        x = float(words.get("x") or 0)
        assert x >= 0
        assert x + 6.6 * len(words.text or "") <= 480


def test_what_did_not_move_has_no_drawing() -> None:
    assert ran("O1\nM30\n").svg() == ""
    assert ran("O1\nN10 M98 P9\n").svg() == ""
    assert ran(DRILLED, trace="calls").svg() == ""


@pytest.mark.parametrize("text", ["G0 X0 Y0 Z0\n", "G4 X1.\n", "G1 X0.0001 F100\n", "G0 Z5.\n"])
def test_a_path_of_one_point_is_a_drawing(text: str) -> None:
    root = drawing(ran(f"O1\n{text}M98 P9\nM30\n"))
    assert group(root, "alarm") is not None
    assert "nan" not in ET.tostring(root, encoding="unicode")


def test_a_long_path_stays_small() -> None:
    fine = "".join(f"X{i % 317 * 0.3:.2f} Y{i % 211 * 0.4:.2f}\n" for i in range(100_000))
    assert len(ran(f"O1\nG1 F100\n{fine}M30\n").svg()) < 80_000


def test_a_drawing_says_what_it_leaves_out() -> None:
    wide = "".join(f"X{i * i * 31 % 9973} Y{i * i * i % 9967}\n" for i in range(40_000))
    notes = " ".join(texts(group(drawing(ran(f"O1\nG1 F100\n{wide}M30\n")), "legend notes")))
    found = re.search(r"nothing after move ([\d,]+) of 40,000", notes)
    assert found
    fine = "".join(f"X{i * 0.01:.2f} Y{i % 5 * 0.01:.2f}\n" for i in range(40_000))
    notes = " ".join(texts(group(drawing(ran(f"O1\nG1 F100\n{fine}M30\n")), "legend notes")))
    assert re.search(r"Thinned: [\d,]+ of 40,001 points; what is left out lies within", notes)


def test_texts_of_programs_are_escaped() -> None:
    setup = "O1\nN10 G0 X1.\nN20 #3000=1(<script>)\nM30\n"
    assert "<script" not in ran(setup).svg()


def test_wrong_coordinates_are_told() -> None:
    with pytest.raises(ValueError, match="coordinates must be work or machine, not 'tool'"):
        ran(DRILLED).svg(coordinates="tool")


def test_machine_coordinates_have_the_offsets() -> None:
    setup = cncsub.Setup(work_offsets={"G54": {"X": 100}})
    run = ran(DRILLED, setup=setup)
    root = ET.fromstring(run.svg(coordinates="machine"))
    assert titles(group(root, "holes"))[0].startswith("hole 1: X110 Y5 ")


def test_a_run_in_a_notebook_shows_its_path() -> None:
    run = ran(DRILLED)
    page = run._repr_html_()
    assert page.count("<svg") == 1
    assert run.svg() in page
    assert "<svg" not in ran("O1\nM30\n")._repr_html_()
    assert re.search(r"<script|style>", page) is None
