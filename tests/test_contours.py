"""Random contours under radius compensation, on every control that has it.

`python tests/contours --contours 100000` does the same with more of them.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import cncsub
from curves import Curve
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
    assert {station.control for station in trials.stations} == set(cncsub.controls)
    assert set(trials.runs) == {str(station) for station in trials.stations}
    assert trials.outcomes["refused"] > CONTOURS / 30
    contours = [trials.contour(place) for place in range(300)]
    assert {written.inch for _, _, written in contours} == {True, False}
    assert {round(math.log10(written.least)) for _, _, written in contours} == {-3, -4}
    assert {written.plane for _, _, written in contours} == {17, 18, 19}
    turns = np.concatenate([drawing.corners() for _, drawing, _ in contours])
    assert {-1, 0, 1} == set(np.sign(np.round(turns, 3)))
    assert any("R" in written.text for _, _, written in contours)


def test_the_distance_to_an_arc_is_that_to_its_nearest_point() -> None:
    arc = Curve(np.array([2.0, 0.0]), np.array([0.0, 2.0]), np.zeros(2), math.pi / 2)
    points = np.array([[3.0, 0.0], [0.0, 0.0], [1.0, 1.0], [-1.0, 2.0], [2.0, -2.0]])
    expected = [1.0, 2.0, 2 - math.sqrt(2), 1.0, 2.0]
    np.testing.assert_allclose(arc.distances(points), expected, atol=1e-12)
