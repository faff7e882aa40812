"""The pictures draw what ran and report what they leave out, and pages need nothing."""

from __future__ import annotations

import math
import pickle
import re
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.plot.page import page_of

go = pytest.importorskip("plotly.graph_objects")

CONTROL = "fanuc-0i-f"
JOB = """O1 (PART <b>)
N10 T1 M6
N20 G0 X0 Y0 Z5. S900 M3
N30 G1 Z-1. F100 (</script><script>alert 1</script>)
N40 G2 X20. Y0 I10. F200
N50 M98 P2 L2
N60 T2 M6
N70 G81 X5. Y5. Z-3. R1. F50
N80 G80 G0 Z50.
N90 M30
O2
N10 G91 G1 Y10. F300
N20 G65 P3 A1.
N30 G90
N40 M99
O3
N10 G3 X10. R5.
N20 M99
"""
COMPENSATED = "O1\nG0 X0 Y0 Z5.\nG41 D1 G1 X10. Y0 F100\nY30.\nG2 X30. Y50. R20.\nG40 X60.\nM30\n"
OFFSETS = cncsub.Setup(work_offsets={"G54": {"X": 0}, "G55": {"X": 100}})


def ran(text: str = JOB, control: str = CONTROL, **options: Any) -> cncsub.Run:
    return cncsub.loads(text, control=control, name="job.nc").run(**options)


def note(figure: Any) -> str:
    return str(figure.layout.annotations[0].text).replace("<br>", " ")


def lines(figure: Any) -> list[Any]:
    """Return the traces of a path, without those that are only entries of the legend."""
    return [t for t in figure.data if t.mode == "lines" and t.x[0] is not None]


def entries(figure: Any) -> list[Any]:
    """Return the entries of the legend."""
    return [trace for trace in figure.data if trace.showlegend]


def segments(figure: Any) -> Any:
    """Return the straight lines that a figure draws, as pairs of points."""
    found = []
    for trace in lines(figure):
        points = np.column_stack((trace.x, trace.y, trace.z)).astype(float)
        pairs = np.stack((points[:-1], points[1:]), axis=1)
        found.append(pairs[~np.isnan(pairs).any(axis=(1, 2))])
    return np.concatenate(found)


def distances(points: Any, pairs: Any) -> Any:
    a, way = pairs[:, 0], pairs[:, 1] - pairs[:, 0]
    length = np.maximum((way**2).sum(axis=1), 1e-300)
    part = np.clip(((points[:, None] - a) * way).sum(axis=2) / length, 0, 1)
    return np.sqrt(((points[:, None] - a - part[..., None] * way) ** 2).sum(axis=2)).min(axis=1)


def told_distance(figure: Any) -> float:
    return sum(float(mm) for mm in re.findall(r"within ([\d.e+-]+) mm", note(figure)))


# ---- the path ----


def test_rapid_feed_and_cycle_are_apart() -> None:
    run = ran()
    figure = run.plot(view="3d", play=False)
    assert [trace.name for trace in figure.data] == ["rapid", "feed", "canned cycle"]
    rapid, feed, cycle = lines(figure)
    assert rapid.line.dash == "dash"
    assert (-3.0 in cycle.z, -3.0 in feed.z) == (True, False)
    assert max(np.nan_to_num(rapid.z)) == 50
    assert len({trace.line.color for trace in lines(figure)}) == 3


def test_what_is_drawn_is_the_path() -> None:
    run = ran()
    path = run.polyline(0.001)
    pairs = segments(run.plot(view="3d"))
    assert distances(path.points, pairs).max() < 0.004
    ends = np.unique(pairs.reshape(-1, 3), axis=0)
    assert distances(ends, np.stack((path.points[:-1], path.points[1:]), axis=1)).max() < 0.004
    way = np.linalg.norm(pairs[:, 1] - pairs[:, 0], axis=1).sum()
    assert way == pytest.approx(run.moves.total_length, rel=1e-3)


def test_a_point_tells_its_block_its_calls_and_its_move() -> None:
    figure = ran().plot(view="3d")
    texts = [text for trace in lines(figure) for text in trace.text if text]
    at_points = {text for text in texts if "O3 N10" in text and "move 4," in text}
    (inner,) = {text.rpartition(", ")[0] for text in at_points}  # all but the time
    assert len(at_points) > 1
    assert inner.startswith("<b>O3 N10 line 17</b><br>N10 G3 X10. R5.<br>")
    assert "in G65 O3 from O2 N20" in inner
    assert "in M98 O2 from O1 N50" in inner
    assert "ccw F300, T1" in inner
    assert any("pass 2" in text and "O2 N10" in text for text in texts)
    assert any("&lt;/script&gt;" in text for text in texts)
    assert not any("<script" in text for text in texts)


@pytest.mark.parametrize(
    ("color", "names"),
    [
        ("program", ["O1", "O2", "O3"]),
        ("tool", ["T1", "T2"]),
        ("depth", ["main program", "1 call deep", "2 calls deep"]),
        (
            "call",
            ["main program", "M98 O2, call 0", "G65 O3, call 1", "G65 O3, call 2"],
        ),
    ],
)
def test_colours_are_told_by_name(color: str, names: list[str]) -> None:
    figure = ran().plot(view="3d", color=color)
    shown = entries(figure)
    assert [trace.name for trace in shown] == names
    assert len({trace.line.color for trace in shown}) == len(names)
    still = ran().plot(view="3d", color=color, play=False)
    assert [(t.name, t.line.color) for t in entries(still)] == [
        (t.name, t.line.color) for t in shown
    ]
    assert distances(ran().polyline(0.001).points, segments(figure)).max() < 0.004


@pytest.mark.parametrize("color", ["feed", "time", "z"])
def test_colours_on_a_scale(color: str) -> None:
    run = ran()
    figure = run.plot(view="3d", color=color, play=False)
    scaled = figure.data[0]
    assert scaled.line.showscale
    values, z = np.array(scaled.line.color), np.array(scaled.z, dtype=float)
    drawn = ~np.isnan(z)
    if color == "z":
        assert values[drawn].tolist() == z[drawn].tolist()
    if color == "feed":
        assert set(values[drawn].tolist()) == {100, 200, 300, 50}
        assert (scaled.line.cmin, scaled.line.cmax) == (50, 300)
    if color == "time":
        assert np.all(np.diff(values[drawn]) >= -1e-9)
        assert values[drawn][-1] <= run.moves.total_time + 1e-9
    assert distances(run.polyline(0.001).points, segments(figure)).max() < 0.004
    (beside,) = [t for t in run.plot(view="3d", color=color).data if t.marker.showscale]
    assert (beside.marker.cmin, beside.marker.cmax) == (scaled.line.cmin, scaled.line.cmax)
    assert beside.marker.colorbar.title.text == scaled.line.colorbar.title.text


def test_many_names_share_a_colour_and_say_so() -> None:
    text = "O1\n" + "M98 P2\n" * 30 + "M30\nO2\nG91 G1 X1. F100\nM99\n"
    figure = ran(text).plot(view="3d", color="call")
    names = [trace.name for trace in entries(figure)]
    assert len(names) == 12
    assert names[-1] == "19 others"


def test_coordinates_of_two_offsets_lie_apart_in_machine_coordinates() -> None:
    text = "O1\nG54 G0 X0 Y0\nG1 X10. F100\nG55 G0 X0\nG1 X10.\nM30\n"
    run = ran(text, setup=OFFSETS)
    work, machine = (
        run.plot(view="3d", play=False),
        run.plot(view="3d", coordinates="machine", play=False),
    )
    assert "Other coordinates came into force" in note(work)
    assert "Other coordinates" not in note(machine)
    assert segments(work)[..., 0].min() == -90  # the path to G55 X0 begins at G54 X10
    feed = next(trace for trace in machine.data if trace.name == "feed")
    assert [x for x in feed.x if x == x] == [0, 10, 100, 110]
    gap = np.isnan(np.array(feed.x, dtype=float))
    assert gap.sum() == 1


def test_the_tool_is_drawn_beside_the_programmed_path() -> None:
    run = ran(COMPENSATED, setup=cncsub.Setup(radius_offsets={1: 5.0}))
    figure = run.plot(view="3d")
    named = {trace.name: trace for trace in lines(figure)}
    assert {"radius compensation", "tool, radius offset"} <= set(named)
    tool = named["tool, radius offset"]
    assert tool.line.dash == "dot"
    at = run.polyline(0.001, coordinates="tool")
    points = np.column_stack((tool.x, tool.y, tool.z)).astype(float)
    points = points[~np.isnan(points[:, 0])]
    pairs = np.stack((at.points[:-1], at.points[1:]), axis=1)
    assert distances(points, pairs).max() < 0.01
    assert "tool, radius offset" not in {
        t.name for t in run.plot(view="3d", coordinates="machine").data
    }


def test_some_of_the_moves_are_drawn_alone() -> None:
    figure = ran().plot(view="3d", moves=range(2, 4))
    texts = {text for trace in lines(figure) for text in trace.text if text}
    assert {re.search(r"move (\d+)", text)[1] for text in texts} <= {"2", "3"}  # type: ignore[index]
    assert "moves 2 to 3" in figure.layout.title.text


def test_nothing_that_moved_is_a_picture_too() -> None:
    assert "moved nothing" in note(ran("O1\nM30\n").plot())
    stopped = note(ran("O1\nM98 P9\n").plot()).replace("- ", "-")  # it is wrapped
    assert "moved nothing before the alarm at O1 line 2: PS0076 program-not-found" in stopped
    assert "records them" in note(ran(trace="calls").plot(view="3d"))
    assert len(ran("O1\nG0 X0 Y0 Z0\nM30\n").plot(view="3d").data) > 0
    assert "moved nothing" in note(ran().plot(view="3d", moves=range(0)))


@pytest.mark.parametrize(
    "wrong",
    [{"color": "red"}, {"coordinates": "tool"}, {"most": 3}, {"most": True}, {"view": "top"}],
)
def test_wrong_use_of_plot(wrong: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=next(iter(wrong))):
        ran().plot(**wrong)


def test_a_lathe_is_seen_as_on_its_drawing() -> None:
    figure = ran("O1\nG0 X20. Z0\nG1 X40. Z-10. F100\nM30\n", "gsk-988ta").plot(view="3d")
    assert max(x for trace in lines(figure) for x in trace.x if x == x) == 20
    assert "X is drawn as a radius" in note(figure)
    assert (figure.layout.scene.camera.up.x, figure.layout.scene.camera.eye.y) == (1, 2)


# ---- in a plane ----


@pytest.mark.parametrize(
    ("text", "control", "kind"),
    [
        ("G0 X10. Y5. Z2.\nG1 Z-1. F100\nX20.\nY9.\n", CONTROL, "scatter"),
        ("G81 X5. Y5. Z-3. R1. F50\nX9. Z-4.\n", CONTROL, "scatter"),
        ("G0 X10. Z2.\nG1 X20. Z-1. F100\n", CONTROL, "scatter"),
        ("G0 X10. Z2.\nG1 X20. Z-1. F100\n", "gsk-988ta", "scatter"),
        ("G0 X10. Y5. Z2.\nG1 Z-1. F100\nX20.\nZ-2.\nY9.\n", CONTROL, "scatter3d"),
        ("G0 X10. Y5. Z2.\nG1 X20. Y9. Z-1. F100\n", CONTROL, "scatter3d"),
        ("G0 X20. Z0\nG3 I-20. Z-5. F100\n", CONTROL, "scatter3d"),
        ("G0 X9. Y5. Z2.\nG18 G2 X20. Z2. R9. F100\n", CONTROL, "scatter3d"),
    ],
)
def test_a_path_in_a_plane_opens_in_two_dimensions(text: str, control: str, kind: str) -> None:
    run = ran(f"O1\n{text}M30\n", control)
    assert {trace.type for trace in run.plot().data} == {kind}
    assert {trace.type for trace in run.plot(view="3d").data} == {"scatter3d"}
    assert {trace.type for trace in run.plot(view="2d").data} == {"scatter"}


@pytest.mark.parametrize("color", ["kind", "program", "feed", "z"])
def test_the_path_in_a_plane_is_the_path(color: str) -> None:
    run = ran()
    path = run.polyline(0.001).points[:, :2]
    figure = run.plot(color=color)
    found = []
    for trace in lines(figure):
        points = np.column_stack((trace.x, trace.y)).astype(float)
        pairs = np.stack((points[:-1], points[1:]), axis=1)
        found.append(pairs[~np.isnan(pairs).any(axis=(1, 2))])
    pairs = np.concatenate(found)
    assert distances(path, pairs).max() < 0.004
    assert distances(pairs.reshape(-1, 2), np.stack((path[:-1], path[1:]), axis=1)).max() < 0.004


def test_a_lathe_in_a_plane_has_z_to_the_right_and_diameters_at_the_axis() -> None:
    figure = ran("O1\nG0 X20. Z0\nG1 X40. Z-10. F100\nM30\n", "gsk-988ta").plot(play=False)
    feed = next(trace for trace in figure.data if trace.name == "feed")
    assert (list(feed.x), list(feed.y)) == ([0, -10], [20, 40])
    layout = figure.layout
    assert layout.xaxis.title.text == "Z, mm"
    assert layout.yaxis.title.text == "X diameter, mm"
    assert (layout.yaxis.scaleanchor, layout.yaxis.scaleratio) == ("x", 0.5)
    assert layout.yaxis.range[0] < 0 < 40 < layout.yaxis.range[1]


def test_holes_tool_changes_and_the_alarm_are_marked_in_a_plane() -> None:
    figure = ran(JOB.replace("N90 M30", "N85 X15.\nN90 M98 P9")).plot()
    marks = {trace.name: trace for trace in figure.data if trace.name}
    holes = marks["1 hole"]
    assert (list(holes.x), list(holes.y), list(holes.customdata)) == ([5], [5], [-3])
    assert list(holes.text) == ["1"]
    assert list(marks["tool change"].text) == ["T1", "T2"]
    alarm = marks["stopped by PS0076"]
    assert (list(alarm.x), list(alarm.y)) == ([15], [5])
    assert "O1 N90" in alarm.hovertemplate
    space = ran(JOB.replace("N90 M30", "N90 M98 P9")).plot(view="3d")
    (mark,) = (t for t in space.data if t.name == "stopped by PS0076" and t.x[0] is not None)
    assert (list(mark.x), list(mark.y), list(mark.z)) == ([5], [5], [50])
    part = ran(JOB.replace("N90 M30", "N90 M98 P9")).plot(moves=range(3))
    assert not [t for t in part.data if (t.name or "").startswith("stopped")]


def test_in_a_plane_the_slider_shows_what_is_done_and_leads_the_tool() -> None:
    figure = ran().plot()
    last = len(figure.data) - 1
    assert [figure.data[at].name for at in (last - 1, last)] == ["the path so far", "tool"]
    before = 0
    for frame in figure.frames[:-1]:
        trail, tool = frame.data[-2:]
        assert (trail.x[-1], trail.y[-1]) == (tool.x[0], tool.y[0])
        assert {trace.opacity for trace in frame.data[:-2]} == {0.3}
        assert len(trail.x) >= before - 1
        before = len(trail.x)
    done = figure.frames[-1]
    assert {trace.opacity for trace in done.data[:-2]} == {1}
    assert list(done.data[-2].x) == [None]
    assert (done.data[-1].x[0], done.data[-1].y[0]) == (5, 5)
    assert len(figure.to_json()) < 300_000


# ---- what is shown where plotly cannot draw ----


def test_figures_have_a_drawing_and_a_text() -> None:
    library = cncsub.loads(JOB, control=CONTROL)
    run = library.run(watch=[1, 100])
    for figure in (run.plot(), run.plot(view="3d"), run.calls.plot(), run.watch.plot()):
        bundle = figure._repr_mimebundle_()
        root = ET.fromstring(bundle["image/svg+xml"])
        assert root.tag == "{http://www.w3.org/2000/svg}svg"
        assert bundle["text/plain"].startswith(figure.layout.title.text)
    assert run.plot()._repr_mimebundle_()["image/svg+xml"] == run.svg()
    calls = run.calls.plot()._repr_mimebundle_()["image/svg+xml"]
    assert calls.count("<rect") == 3 + 2  # O2, O3 twice, and the legend
    graph = library.plot()._repr_mimebundle_()["image/svg+xml"]
    assert {"O1", "O2", "O3"} <= set(re.findall(r">([^<>]+)</text>", graph))
    assert graph.count("rotate(") == 2  # the heads of two arrows


def test_the_bundle_of_a_notebook_holds_the_figure_once(monkeypatch: pytest.MonkeyPatch) -> None:
    import plotly.io

    monkeypatch.setattr(plotly.io.renderers, "default", "plotly_mimetype+notebook_connected")
    bundle = ran().plot()._repr_mimebundle_()
    assert set(bundle) == {"application/vnd.plotly.v1+json", "image/svg+xml", "text/plain"}


def test_a_figure_can_be_sent() -> None:
    figure = ran().plot()
    assert pickle.loads(pickle.dumps(figure)) == figure


# ---- thinning ----


@settings(max_examples=40, deadline=None)
@given(
    seed=st.integers(0, 10_000),
    moves=st.integers(110, 400),
    reach=st.sampled_from([0.05, 1.0, 30.0]),
    turns=st.sampled_from([0.0, 0.2, 1.0]),
    color=st.sampled_from(["kind", "feed", "z"]),
)
def test_what_is_left_out_lies_as_near_as_the_picture_tells(
    seed: int, moves: int, reach: float, turns: float, color: str
) -> None:
    made = np.random.default_rng(seed)
    way = np.array([0.2, 0.1, 0.0])
    text = []
    for _ in range(moves):
        if made.random() < turns:
            way = made.uniform(-reach, reach, 3)
        path = "G0" if made.random() < 0.1 else "G1"
        text.append(f"{path} X{way[0]:.3f} Y{way[1]:.3f} Z{way[2]:.3f}")
    run = ran("O1\nG91\nF100\n" + "\n".join(text) + "\nM30\n")
    figure = run.plot(view="3d", most=100, color=color, play=False)
    line = run.polyline(0.01)
    cut = re.search(r"nothing after move ([\d,]+)", note(figure))
    points = line.points
    if cut:
        points = points[line.move < int(cut[1].replace(",", ""))]
    pairs = segments(figure)
    if len(points) > 1:
        assert distances(points, pairs).max() <= told_distance(figure) + 1e-9
    # Nothing is drawn where nothing ran.
    true = np.stack((line.points[:-1], line.points[1:]), axis=1)
    drawn = np.concatenate([pairs.mean(axis=1), pairs[:, 0], pairs[:, 1]])
    assert distances(drawn, true).max() <= told_distance(figure) + 1e-9
    assert sum(len(trace.x) for trace in lines(figure)) <= 100 * 4


def test_a_long_path_is_thinned_and_says_so() -> None:
    fine = "".join(f"X{i * 0.01:.2f} Y{math.sin(i / 900):.3f}\n" for i in range(30_000))
    run = ran(f"O1\nG1 F100\n{fine}M30\n")
    figure = run.plot(view="3d", most=1_000)
    found = re.search(r"Thinned: ([\d,]+) of ([\d,]+) points", note(figure))
    assert found
    kept, whole = (int(number.replace(",", "")) for number in found.groups())
    assert kept <= 1_000 < whole == 30_001
    assert told_distance(figure) < 0.5
    assert "Thinned" not in note(run.plot(view="3d", moves=range(500)))


def test_lines_over_lines_are_drawn_once_and_said_so() -> None:
    text = "O1\nG1 F100\n#1=0\nWHILE[#1LT90]DO1\nX0 Y0\n" + "".join(
        f"X{i % 7 * 10} Y{i * 3 % 50}\n" for i in range(40)
    )
    run = ran(text + "#1=#1+1\nEND1\nM30\n")
    figure = run.plot(view="3d", most=200)
    assert "left out lies within" in note(figure)
    assert "of the same colour are left out" in note(figure)
    assert "Cut" not in note(figure)
    assert distances(run.polyline(0.01).points, segments(figure)).max() <= told_distance(figure)


# ---- the slider ----


def drawn_until(line: Any, frame_line: Any) -> Any:
    """Return which points of a trace are drawn at an instant: those whose colour is not the
    transparent one.
    """
    stops = [(float(at), colour) for at, colour in frame_line.colorscale]
    numbers = np.array(line.color, dtype=float)
    drawn = np.zeros(len(numbers), dtype=bool)
    for (begin, colour), (end, _) in zip(stops[::2], stops[1::2], strict=True):
        if colour != "rgba(0,0,0,0)":
            drawn |= (numbers >= begin) & (numbers <= end)
    return drawn


@pytest.mark.parametrize("color", ["kind", "program", "feed", "time"])
@pytest.mark.parametrize("text", [JOB, COMPENSATED])
def test_an_instant_shows_the_path_up_to_then(color: str, text: str) -> None:
    run = ran(text, setup=cncsub.Setup(radius_offsets={1: 5.0}))
    figure = run.plot(view="3d", color=color)
    paths, marker = lines(figure), len(figure.data) - 1
    assert figure.data[marker].name == "tool"
    ends, at = run.moves.time.cumsum(), np.linspace(0, run.moves.total_time, len(figure.frames))
    for frame, now in zip(figure.frames, at, strict=True):
        assert frame.traces == (*range(len(paths)), marker)
        for path, then in zip(paths, frame.data):
            shown = drawn_until(path.line, then.line)
            texts = [t for t, seen in zip(path.text or (), shown) if seen and t]
            moves = {int(re.search(r"move (\d+),", text)[1]) for text in texts}  # type: ignore[index]
            assert all(move == 0 or ends[move - 1] <= now + 1e-9 for move in moves)
            hidden = [t for t, seen in zip(path.text or (), shown) if not seen and t]
            moves = {int(re.search(r"move (\d+),", text)[1]) for text in hidden}  # type: ignore[index]
            assert all(ends[move] >= now - 1e-9 for move in moves)
    for path, then in zip(paths, figure.frames[-1].data):
        assert np.all(drawn_until(path.line, then.line) | np.isnan(np.array(path.x, dtype=float)))
        assert path.line.colorscale == then.line.colorscale  # the picture before the slider plays


def test_the_slider_leads_the_tool_along_the_path() -> None:
    run = ran()
    figure = run.plot(view="3d")
    points = np.array([[f.data[-1].x[0], f.data[-1].y[0], f.data[-1].z[0]] for f in figure.frames])
    assert distances(points, segments(figure)).max() < 1e-6
    assert points[0].tolist() == [0, 0, 0]
    assert points[-1].tolist() == [5, 5, 50]
    (slider,) = figure.layout.sliders
    assert [step.args[0][0] for step in slider.steps] == [frame.name for frame in figure.frames]
    assert (slider.steps[0].label, slider.active) == ("0.0 s", len(figure.frames) - 1)
    assert not run.plot(view="3d", play=False).frames


def test_the_tool_is_half_way_at_half_time() -> None:
    figure = ran("O1\nG1 X100. F100\nM30\n").plot(view="3d")
    at = [
        (step.label, frame.data[-1].x[0])
        for step, frame in zip(figure.layout.sliders[0].steps, figure.frames)
    ]
    assert at[0][1] == 0
    assert at[-1] == ("1:00", 100)
    assert len(at) >= 2


# ---- calls, watched variables, programs ----


def test_calls_are_bars_below_their_callers() -> None:
    run = ran()
    figure = run.calls.plot()
    bars = {bar.name: bar for bar in figure.data}
    assert set(bars) == {"O2", "O3"}
    ends = run.moves.time.cumsum()
    outer = bars["O2"]
    assert outer.y.tolist() == [1]
    assert outer.base[0] == pytest.approx(ends[2])
    assert outer.base[0] + outer.x[0] == pytest.approx(ends[6])
    inner = bars["O3"]
    assert inner.y.tolist() == [2, 2]
    assert inner.base.tolist() == pytest.approx([ends[3], ends[5]])
    assert "called by <b>O2 N20" in inner.hovertext[0]
    steps = run.calls.plot(over="steps")
    assert steps.data[0].base.tolist() == [5]
    assert steps.data[0].x.tolist() == [12]


def test_calls_that_cannot_be_seen_are_drawn_together() -> None:
    text = "O1\nM98 P2 L1\n#1=0\nWHILE[#1LT9000]DO1\nM98 P2\n#1=#1+1\nEND1\nM30\nO2\nG91 X1.\nM99\n"
    figure = ran(f"{text}").calls.plot()
    grey = figure.data[-1]
    assert grey.name == "short calls"
    told = [re.search(r"([\d,]+) short call", text)[1] for text in grey.hovertext]  # type: ignore[index]
    assert sum(int(number.replace(",", "")) for number in told) == 9001
    assert len(grey.x) <= 1_300
    assert "Grey" in note(figure)


def test_calls_without_time_are_told() -> None:
    text = "O1\nG65 P2\nG1 X1. F100\nM98 P3\nM30\nO2\n#1=1\nM99\nO3\nX5.\nM98 P9\n"
    run = ran(text)
    figure = run.calls.plot()
    assert [bar.name for bar in figure.data] == ["O3"]
    assert "1 call took no time" in note(figure)
    machine = cncsub.loads(JOB, control=CONTROL).machine()
    for _ in range(9):
        machine.step()
    assert "1 call had not ended" in note(machine.calls.plot())
    still = ran("O1\nM98 P2\nM30\nO2\nM99\n").calls.plot()
    assert "no move took time" in note(still)
    assert still.data[0].x.tolist() == [1]
    assert "called nothing" in note(ran("O1\nM30\n").calls.plot())
    with pytest.raises(ValueError, match="time or steps"):
        run.calls.plot(over="blocks")


def test_watched_variables_are_steps_with_gaps() -> None:
    text = "O1\n#100=1\nG1 X6. F60\n#101=5\n#100=3\n#100=#0\nX12.\n#100=2\nM30\n"
    run = ran(text, watch=[100, 101, 102])
    figure = run.watch.plot()
    first, second = figure.data
    assert list(first.x) == [0, 0, 3, 4, 6, 8]
    assert list(first.y) == [None, 1, 3, None, 2, 2]
    assert list(second.y) == [None, 5, 5]
    assert first.line.shape == "hv"
    assert not first.connectgaps
    assert "Never changed: #102" in note(figure)
    assert "O1 line 5" in first.text[2]
    timed = run.watch(100).plot(over="time")
    assert list(timed.data[0].x) == pytest.approx([0, 0, 6, 6, 12, 12])
    assert len(timed.data) == 1
    with pytest.raises(KeyError, match=r"#500 is not watched: run\(watch=\[500\]\)"):
        run.watch(500)
    assert "watch=" in note(ran().watch.plot())


def test_many_changes_keep_their_highest_and_lowest() -> None:
    text = "O1\n#100=0\nN1 #100=#100+1\nIF[#100EQ12345]GOTO2\nN3 IF[#100LT40000]GOTO1\nM30\nN2 #100=-7\n#100=12345\nGOTO3\n"
    run = ran(text, watch=[100], variables={100: 0})
    assert len(run.watch) > 40_000
    figure = run.watch.plot()
    values = np.array(figure.data[0].y, dtype=float)
    assert len(values) <= 8_100
    assert (values.min(), values.max()) == (-7, 40_000)
    assert "lowest, highest and last" in note(figure)


def test_the_graph_of_a_library() -> None:
    text = "O1\nM98 P2 L3\nM98 P[#1]\nM30\nO2\nG65 P2\nM98 P9\nM99\nO7\nM99\n"
    library = cncsub.loads(text, control=CONTROL)
    figure = library.plot()
    named = {trace.name: trace for trace in figure.data if trace.name}
    assert {name: list(trace.text) for name, trace in named.items()} == {
        "main program": ["O1"],
        "called": ["O2"],
        "not reached from the main program": ["O7"],
        "missing": ["O9"],
        "computed when it runs": ["[#1]"],
    }
    middles = next(trace for trace in figure.data if trace.mode == "markers")
    assert any("M98 at line 2, 3 times" in text for text in middles.hovertext)
    assert len(middles.hovertext) == 4
    assert len(figure.layout.annotations) == 1 + 4
    at = {t: (x, y) for trace in named.values() for t, x, y in zip(trace.text, trace.x, trace.y)}
    assert len(set(at.values())) == 5
    assert at["O1"][0] < at["O2"][0] < at["O9"][0]
    beside = {t: p for trace in named.values() for t, p in zip(trace.text, trace.textposition)}
    assert beside["O2"] == "top center"  # it calls, so an arrow leads to the right
    assert beside["O9"] == "middle right"


def test_a_large_library_is_cut_and_says_so() -> None:
    text = "".join(f"O{i}\nM98 P{i + 1}\nM99\n" for i in range(1, 400))
    figure = cncsub.loads(text, control=CONTROL).plot()
    assert "150 of 400 programs are not drawn" in note(figure)


# ---- without plotly, and as pages ----


def test_a_missing_plotly_is_told(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    run = ran()
    (tmp_path / "job.nc").write_text(JOB)
    monkeypatch.setitem(sys.modules, "plotly.graph_objects", None)
    with pytest.raises(ImportError, match=r"pip install 'cncsub\[plot\]'"):
        run.plot()
    asked = ["plot", str(tmp_path / "job.nc"), "-c", CONTROL, "-o", str(tmp_path / "path.html")]
    done = CliRunner().invoke(app, asked)
    assert done.exit_code == 2
    assert "cncsub[plot]" in done.stderr


def page(tmp_path: Path, *more: str, text: str = JOB) -> Path:
    (tmp_path / "job.nc").write_text(text)
    file = tmp_path / "page.html"
    asked = ["plot", str(tmp_path / "job.nc"), "-c", CONTROL, "-o", str(file), *more]
    done = CliRunner().invoke(app, asked)
    assert done.exit_code == 0, done.output
    assert f"wrote {file}" in done.stdout
    return file


def test_the_command_writes_a_page_in_one_piece(tmp_path: Path) -> None:
    text = page(tmp_path).read_text(encoding="utf-8")
    head = text[: text.index("<script>")]
    assert "default-src 'none'" in head
    assert "<script>alert" not in text
    assert text.count("</script>") == 4  # plotly, the figure, the code, what draws
    assert '<div id="code"' in text
    assert "N30 G1 Z-1. F100 (&lt;/script&gt;" in text
    asked = CliRunner().invoke(app, ["plot", str(tmp_path / "job.nc"), "-c", CONTROL])
    assert asked.exit_code == 2
    assert "-o path.html" in asked.stderr
    for wrong in (
        ["--of", "watch"],
        ["--of", "cake"],
        ["--color", "red"],
        ["--over", "miles", "--of", "calls"],
    ):
        told = CliRunner().invoke(
            app, ["plot", str(tmp_path / "job.nc"), "-c", CONTROL, "-o", "x.html", *wrong]
        )
        assert told.exit_code == 2, wrong


def test_the_command_writes_a_drawing_without_plotly(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "plotly.graph_objects", None)
    (tmp_path / "job.nc").write_text(JOB)
    file = tmp_path / "path.svg"
    asked = ["plot", str(tmp_path / "job.nc"), "-c", CONTROL, "-o", str(file)]
    assert CliRunner().invoke(app, asked).exit_code == 0
    assert file.read_text(encoding="utf-8") == ran().svg()
    for more, told in ((["--view", "3d"], "--view"), (["--of", "calls"], "cncsub[plot]")):
        done = CliRunner().invoke(app, [*asked, *more])
        assert (done.exit_code, told in done.stderr) == (2, True)
    (tmp_path / "job.nc").write_text("O1\nM30\n")
    done = CliRunner().invoke(app, asked)
    assert (done.exit_code, "moved nothing" in done.stderr) == (2, True)


def test_the_page_of_a_long_path_is_packed(tmp_path: Path) -> None:
    text = "O1\n#1=0\nWHILE[#1LT20000]DO1\n#1=#1+1\nM98P2\nEND1\nM30\n"
    text += "O2\nG1X[20*COS[#1]]Y[20*SIN[3*#1]]Z[#1/100]F500\nM99\n"
    figure = ran(text).plot()
    assert len(page_of(figure)) < 0.25 * len(figure.to_json()) + 2_500_000


@pytest.mark.parametrize("color", ["kind", "call"])
def test_the_slider_has_as_many_instants_in_every_colour(color: str) -> None:
    calls = "".join(f"M98P{number}\n" for number in range(2, 40))
    text = f"O1\n{calls}M30\n" + "".join(
        f"O{number}\nG91G1X{number}.F100\nG0Y1.\nX-1.\nZ1.\nM99\n" for number in range(2, 40)
    )
    assert len(ran(text).plot(color=color).frames) == 120


def test_a_legend_of_many_lines_leaves_the_title_alone(browser: Any, tmp_path: Path) -> None:
    calls = "".join(f"M98P{number}\n" for number in range(2, 16))
    text = f"O1\n{calls}M30\n" + "".join(
        f"O{number}\nG91G1X{number}.F100\nM99\n" for number in range(2, 16)
    )
    file = page(tmp_path, "--of", "calls", text=text)
    opened = browser.new_page(viewport={"width": 390, "height": 800})
    opened.goto(file.as_uri())
    opened.wait_for_selector("#picture g.legend")
    box = "document.querySelector('{}').getBoundingClientRect()"
    title, legend = box.format("h1"), box.format("#picture g.legend")
    opened.wait_for_function(f"{title}.bottom <= {legend}.top", timeout=5_000)
    opened.close()


@pytest.mark.parametrize("of", ["path", "calls", "programs", "watch"])
@pytest.mark.parametrize("width", [360, 1200])
def test_a_page_is_drawn_without_a_network(
    browser: Any, tmp_path: Path, of: str, width: int
) -> None:
    file = page(tmp_path, "--of", of, "--watch", "1", text=JOB)
    opened = browser.new_page(viewport={"width": width, "height": 800})
    told: list[str] = []
    opened.on("pageerror", lambda error: told.append(str(error)))
    opened.on("console", lambda m: m.type == "error" and told.append(m.text))
    opened.on(
        "request",
        lambda asked: asked.url.startswith(("file:", "data:", "blob:")) or told.append(asked.url),
    )
    opened.goto(file.as_uri())
    opened.wait_for_selector("#picture .main-svg")
    assert told == []
    assert opened.evaluate("document.documentElement.scrollWidth") <= width
    if of == "path":
        assert opened.locator(".slider-group").count() > 0
    opened.close()


@pytest.mark.parametrize("view", ["2d", "3d"])
def test_the_code_and_the_picture_have_one_cursor(browser: Any, tmp_path: Path, view: str) -> None:
    file = page(tmp_path, "--view", view)
    opened = browser.new_page(viewport={"width": 1200, "height": 800})
    told: list[str] = []
    opened.on("pageerror", lambda error: told.append(str(error)))
    opened.goto(file.as_uri())
    opened.wait_for_function("document.getElementById('picture')._transitionData")
    code, picture = opened.locator("#code"), opened.locator("#picture")
    assert code.bounding_box()["x"] >= picture.bounding_box()["width"]
    here = opened.locator("#code tr.here")
    opened.locator("#code tr", has_text="N40 G2 X20.").hover()
    assert "N40" in here.text_content()
    cursor = "document.getElementById('picture').data.at(-1)"
    opened.wait_for_function(f"{cursor}.x.length > 9")
    xs = opened.evaluate(f"{cursor}.x.filter(x => x !== null)")
    assert (min(xs), max(xs)) == (0, 20)
    opened.evaluate("Plotly.animate(document.getElementById('picture'), ['0'])")
    opened.wait_for_function(
        "document.querySelector('#code tr.here').textContent.includes('N20 G0 X0')"
    )
    assert told == []
    opened.close()
