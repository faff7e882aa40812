"""The place of the zero point of a program on the machine changes machine positions and nothing
else: rows, contours and corners at random places.
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
        place = moved(start, control, random)
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


@given(
    control=st.sampled_from(
        ["fanuc-0i-f", "fanuc-16i", "mitsubishi-m700", "gsk-980mdi", "haas-ngc"]
    ),
    x=st.integers(-(10**6), 10**6),
    y=st.integers(-(10**6), 10**6),
)
def test_what_just_fits_does_so_wherever_it_is_programmed(control: str, x: int, y: int) -> None:
    def at(words: str, by_x: int, by_y: int) -> str:
        return f"{words} X{(x + by_x) / 1000:.3f} Y{(y + by_y) / 1000:.3f}"

    blocks = [at("G90 G17 G0", -10_000, 20_000), at("G41 D1 G1 F100", 0, 20_000), at("", 0, 1)]
    blocks += [at("G3 I1. J0.", 1999, 0), at("G1", 1999, 20_000), at("G40", -10_000, 20_000)]
    library = cncsub.loads("O1\n" + "\n".join(blocks) + "\nM30\n", control=control)
    run = library.run(setup={"machine": "mill", "radius_offsets": {1: 1}})
    run.assert_ends()
    assert len(run.moves) == 6


# ---- contours in whole increments; many of them only just leave room for the tool ----

LIMITS = [0, 1, -1, 2, 3, 10, 2000, 5000, -3000]
RADII = [500, 999, 1000, 1001, 1500, 2000]
SIDES = [(1, 0), (0, 1), (-1, 0), (0, -1)]


def narrow_contour(random: Random) -> list[tuple[str, int, int]]:
    """Return the words before an end point, and the point, in thousandths."""
    x, y = 0, random.choice([0, 1, 2, 5000])
    blocks = [("G1", x, y)]
    for _ in range(random.randint(2, 6)):
        if random.random() < 0.45:
            x += random.choice([*LIMITS, random.randint(-9000, 9000)])
            y += random.choice([*LIMITS, random.randint(-5000, 5000)])
            blocks.append(("G1", x, y))
            continue
        radius, (i, j) = random.choice(RADII), random.choice(SIDES)
        k, m = random.choice([(-j, i), (j, -i), (i, j)])
        words = f"{random.choice(['G2', 'G3'])} I{i * radius / 1000:.3f} J{j * radius / 1000:.3f}"
        x += (i + k) * radius + random.choice([0, 0, 1, -1])
        y += (j + m) * radius + random.choice([0, 0, 1, -1])
        blocks.append((words, x, y))
    return [*blocks, ("G1", x + 3000, y + 40_000)]


@pytest.mark.parametrize("control", ["fanuc-0i-f", "mitsubishi-m700", "gsk-980mdi", "haas-ngc"])
def test_narrow_contours_are_the_same_wherever_they_are_programmed(control: str) -> None:
    random = Random(f"narrow {control}")
    for _ in range(100):
        side, radius = random.choice(["G41", "G42"]), random.choice([250, *RADII]) / 1000
        contour = narrow_contour(random)
        blocks = [("G90 G17 G0", -10_000, 20_000), (f"{side} D1 G1 F100", 0, 20_000), *contour]
        blocks.append(("G40 G1", -10_000, 20_000))
        runs = []
        for x, y in ((0, 0), (random.randint(-(10**6), 10**6), random.randint(-(10**6), 10**6))):
            lines = [f"{w} X{(x + a) / 1000:.3f} Y{(y + b) / 1000:.3f}" for w, a, b in blocks]
            text = "\n".join(["O1", *lines, "M30", ""])
            start = {"X": x / 1000, "Y": y / 1000, "Z": 0.0}
            setup = {"machine": "mill", "radius_offsets": {1: radius}, "start": start}
            run = cncsub.loads(text, control=control).run(setup=setup)
            path = [(m.kind, m.mx - start["X"], m.my - start["Y"]) for m in run.moves]
            runs.append([run.alarm and (run.alarm.cause, run.alarm.line), path, run.m_codes])
        assert same(*runs, 1e-5), f"{x} {y}\n{text}"
