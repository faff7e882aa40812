"""Where the zero point of a program lies on the machine changes machine positions and nothing else:
rows, contours and corners at random places.
"""

from __future__ import annotations

from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

import cncsub
from conformance import cases
from crossed import changes, moved, names_a_place, told
from trials import Trials
from ways import same

FOLDERS = sorted({case.topic.split("/")[0] for case in cases()} - {"shared"})
FOLDERS += sorted({"/".join(c.topic.split("/")[:2]) for c in cases() if "shared" in c.topic})


@pytest.mark.parametrize("folder", FOLDERS)
def test_rows_that_name_no_place_of_the_machine_are_the_same_elsewhere(folder: str) -> None:
    random = Random(f"crossed {folder}")
    found = []
    for case in cases():
        if case.topic.startswith(folder + "/") and not names_a_place(case):
            control = random.choice(case.controls) if len(case.controls) > 4 else None
            for name in [control] if control else case.controls:
                found += [f"{case.topic}: {case.claim} [{name}]: {change}"
                          for change in changes(case, name, random)]  # fmt: skip
    assert not found, f"{len(found)} rows:\n" + "\n".join(found[:20])


def runs_elsewhere(text: str, control: str | cncsub.Control, setup: dict, random: Random) -> None:
    library = cncsub.loads(text, control=control)
    start = {"start": dict.fromkeys("XYZ", 0.0), **setup}
    plain = told(library.run(setup=start), lengths=True)
    for _ in range(3):
        place = moved(start, random)
        assert same(plain, told(library.run(setup=place), lengths=True)), f"{place}\n{text}"


def test_contours_are_the_same_elsewhere() -> None:
    trials = Trials(11)
    for place in range(150):
        station, drawing, written = trials.contour(place)
        setup = trials.setup(station, drawing, written)
        runs_elsewhere(written.text, station.made(), setup, Random(f"contour {place}"))


def thousandths(low: int, high: int) -> st.SearchStrategy[str]:
    return st.integers(low, high).map(lambda value: f"{value / 1000:.3f}".rstrip("0"))


LATHES = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-16i", "fanuc-30i", "gsk-988ta", "gsk-988t"]
LATHES += ["mitsubishi-m700", "mitsubishi-m800"]


@given(
    control=st.sampled_from(LATHES),
    corner=st.sampled_from(["I", "K", ",C", ",R"]),
    x=thousandths(20_000, 40_000),
    z=thousandths(10_000, 30_000),
    size=thousandths(100, 5000),
    by_setting=st.booleans(),
    seed=st.integers(0, 10**6),
)
def test_corners_are_the_same_elsewhere(
    control: str, corner: str, x: str, z: str, size: str, by_setting: bool, seed: int
) -> None:
    random = Random(seed)
    made = cncsub.controls[control]
    takes = next(rule.value for rule in made.rules if rule.name == "chamfer_ik")
    if corner in "IK" and not takes:
        return
    first, second = (f"Z{z}", "X60.") if corner != "K" else (f"X{x}", "Z-50.")
    sign = "-" if corner in "IK" and random.random() < 0.5 else ""
    head = f"G50 X{random.randint(-(10**6), 10**6) / 1000:.3f}\n" if by_setting else ""
    text = f"O1\n{head}N10 G0 X{x} Z0\n" if corner != "K" else f"O1\n{head}N10 G0 X10. Z{z}\n"
    text += f"N20 G98 G1 {first} {corner}{sign}{size} F300\nN30 {second}\nM30\n"
    setup = {"machine": "lathe-a"}
    library = cncsub.loads(text, control=made)
    plain = library.run(setup=setup)
    assert plain.alarm is None or plain.alarm.cause != "corner-taper", plain.alarm
    runs_elsewhere(text, made, setup, random)
