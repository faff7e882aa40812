"""What conditions compared: `run(conditions=True).conditions`, the listing, and what is watched."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

LOOP = "O1\nN10 #1=0\nN20 WHILE[#1 LT 2]DO1\nN30 #1=#1+1\nN40 END1\nN50 M30\n"


def compared(text: str, control: str = "fanuc-0i-f", **options: object) -> list[str]:
    run = cncsub.loads(text, control=control).run(conditions=True, **options)
    return [f"{row.step} {row}" for row in run.conditions]


@pytest.mark.parametrize(
    ("control", "text", "told"),
    [
        ("fanuc-0i-f", LOOP, ["1 0 LT 2: true", "4 1 LT 2: true", "7 2 LT 2: false"]),
        ("fanuc-0i-f", "O1\nIF[#1 EQ #0]GOTO9\nN9 M30\n", ["0 vacant EQ vacant: true"]),
        ("fanuc-0i-f", "O1\n#2=1\nIF[#1 LT #2]GOTO9\nN9 M30\n", ["1 vacant LT 1: true"]),
        ("fanuc-0i-f", "O1\nIF[#100+1 GE #101]GOTO9\nN9 M30\n", ["0 1 GE vacant: true"]),
        ("fanuc-0i-f", "O1\nIF[#1 GE [#2+#3]]GOTO9\nN9 M30\n", ["0 0 GE 0: true"]),
        ("fanuc-0i-f", "O1\nIF[2 NE 1+1]THEN #1=1\nM30\n", ["0 2 NE 2: false"]),
        (
            "fanuc-0i-f",
            "O1\n#1=0.1+0.2\nIF[#1 EQ 0.3]GOTO9\nN9 M30\n",
            ["1 0.30000000000000004 EQ 0.3: false"],
        ),
        (
            "mitsubishi-m800",
            "O1\nIF[[1 EQ 1] AND [2 GT 3]]GOTO9\nN9 M30\n",
            ["0 1 EQ 1: true", "0 2 GT 3: false"],
        ),
        ("gsk-980tdi", "O1\nG65 H82 P9 Q#100 R4\nN9 M30\n", ["0 0 NE 4: true"]),
        ("siemens-one", "R1=1\nIF R1==2\nR2=1\nENDIF\nM30\n", ["1 1 == 2: false"]),
        (
            "linuxcnc",
            "#1=1\no1 while [#1 lt 2]\n#1=[#1+1]\no1 endwhile\nm2\n",
            ["1 1 lt 2: true", "4 2 lt 2: false"],
        ),
        ("linuxcnc", "#1=1\no1 if [#1 eq 1]\n#2=5\no1 endif\nm2\n", ["1 1 eq 1: true"]),
        ("linuxcnc", "o1 repeat [2]\no1 endrepeat\nm2\n", []),
        ("linuxcnc", "#1=1\no1 if [#1]\n#2=5\no1 endif\nm2\n", ["1 1: true"]),
    ],
)
def test_each_comparison_has_its_values(control: str, text: str, told: list[str]) -> None:
    assert compared(text, control) == told


def test_a_condition_whose_block_alarms_leaves_no_row() -> None:
    assert compared("O1\nIF[1 EQ 1]GOTO99\nM30\n") == []
    assert compared("O1\nIF[1 LT 1/0]GOTO9\nN9 M30\n") == []
    assert compared("O1\nIF[[1 LT 2] EQ [1/0]]GOTO9\nN9 M30\n") == []


def test_nothing_is_kept_where_nobody_asks() -> None:
    assert len(cncsub.loads(LOOP, control="fanuc-0i-f").run().conditions) == 0


def test_parts_of_a_stream_have_the_rows_of_the_run() -> None:
    library = cncsub.loads(LOOP.replace("LT 2", "LT 900"), control="fanuc-0i-f")
    whole = [str(row) for row in library.run(conditions=True).conditions]
    parts = [
        str(row) for part in library.stream(rows=100, conditions=True) for row in part.conditions
    ]
    assert len(whole) == 901
    assert parts == whole


@pytest.mark.parametrize("file", sorted(Path("examples").rglob("*.nc"))[::7], ids=str)
def test_keeping_conditions_changes_no_run(file: Path) -> None:
    control = {"hnc": "hnc-21m", "gsk": "gsk-988ta", "linuxcnc": "linuxcnc"}.get(
        file.parent.name, "fanuc-0i-f"
    )
    library = cncsub.load(file, control=control)
    plain, kept = (library.run(max_blocks=10_000, conditions=c) for c in (False, True))
    assert (plain.stop, plain.blocks, str(plain.alarm)) == (kept.stop, kept.blocks, str(kept.alarm))
    assert plain.variables == kept.variables
    assert plain.position == kept.position


def test_columns_hold_what_rows_say() -> None:
    table = cncsub.loads(LOOP, control="fanuc-0i-f").run(conditions=True).conditions
    assert table.columns == ["step", "left", "operator", "right", "holds", "program", "n", "line"]
    assert [table.operators[code] for code in table.operator] == ["LT"] * 3
    assert table.holds.tolist() == [1, 1, 0]
    assert table.right.tolist() == [2.0, 2.0, 2.0]
    assert table.to_pandas()["operator"].tolist() == ["LT"] * 3


JUMPS = """O1
N10 #1=5
N20 IF[#1 EQ 5]GOTO50
N30 M30
/N50 M8
N60 G65 P2
N65 G81 X1. Y2. Z-5. R2. F100
N70 M30
O2
N10 M99 P65
"""


def test_a_listing_says_what_was_asked_and_where_it_went_on(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text(JUMPS)
    words = ["run", str(file), "-c", "fanuc-0i-f", "--listing", "--skip", "1"]
    lines = CliRunner().invoke(app, words).stdout.splitlines()
    assert lines == [
        "     0  O1:2  N10 #1=5",
        "     1  O1:3  N20 IF[#1 EQ 5]GOTO50  ->  5 EQ 5: true, on to N60",
        "     2  O1:6  N60 G65 P2  ->  calls O2",
        "     3  | O2:10  N10 M99 P65  ->  back to O1 N65",
        "     4  O1:7  N65 G81 X1. Y2. Z-5. R2. F100  ->  4 moves",
        "          rapid X1 Y2 Z0",
        "          rapid X1 Y2 Z2",
        "          feed  X1 Y2 Z-5",
        "          rapid X1 Y2 Z0",
        "     5  O1:8  N70 M30",
    ]


def test_a_listing_names_the_skipped_blocks() -> None:
    text = "O1\nN10 G0 X1.\n/N20 X2.\n/N30 X3.\nN40 M30\n"
    listed = list(cncsub.loads(text, control="fanuc-0i-f").run(block_skip=1).listing())
    assert listed[0].skipped == ("/N20 X2.", "/N30 X3.")
    assert str(listed[0]).splitlines()[1:] == [
        "          skipped: /N20 X2.",
        "          skipped: /N30 X3.",
    ]


def test_values_that_differ_look_different() -> None:
    text = "O1\n#100=1/3*3\n#101=0.1+0.2\nG0 X12345.678\nM30\n"
    run = cncsub.loads(text, control="fanuc-0i-f").run(watch=[100, 101])
    done = [str(block).partition("  ->  ")[2] for block in run.listing()]
    assert done == ["#100 = 1", "#101 = 0.30000000000000004", "rapid X12345.678 Y0 Z0", ""]


def test_lengths_without_a_point_are_told(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"

    def note(text: str, control: str = "fanuc-0i-f") -> str:
        file.write_text(text)
        return CliRunner().invoke(app, ["run", str(file), "-c", control]).stderr

    assert note("O1\nN10 G0 X10 Y20\nN20 Z5\nM30\n") == (
        "note: O1: 3 lengths have no decimal point: X10 at O1 N10 is 0.010 mm\n"
    )
    assert "X10 at O1 line 2 is 0.0010 inch" in note("O1\nG20 X10\nM30\n")
    assert note("O1\nG0 X10. Y0 Z[5]\nM30\n") == ""
    assert note("g0 x10\nm2\n", "linuxcnc") == ""  # 10 mm


def test_a_probe_that_meets_nothing_brings_inputs_that_answer(tmp_path: Path) -> None:
    file = tmp_path / "probe.nc"
    file.write_text("O1\nG0 Z10.\nG31 Z-5. F50\n#100=#5063\nM30\n")
    told = CliRunner().invoke(app, ["run", str(file), "-c", "fanuc-0i-f"]).stderr
    first, *lines = told.splitlines()
    assert first.startswith("hint: describe what the probe touches with --inputs FILE")
    inputs = tmp_path / "inputs.toml"
    inputs.write_text("\n".join(line.strip() for line in lines))
    assert tomllib.loads(inputs.read_text())["workpiece"]["stylus"] == 3
    words = ["run", str(file), "-c", "fanuc-0i-f", "--inputs", str(inputs), "--watch", "100"]
    done = CliRunner().invoke(app, words)
    assert "no skip signal" not in done.stdout
    assert "#100 vacant -> 5.5" in done.stdout


@pytest.mark.parametrize(
    ("block", "told"),
    [
        ("GO X10.", "is the letter O meant as the digit 0?"),
        ("G0 X1O.", "is the letter O meant as the digit 0?"),
        ("MO3", "is the letter O meant as the digit 0?"),
        ("#1=O.5", "is the letter O meant as the digit 0?"),
        ("G0 \uff38\uff11", "it is a full-width X, type the plain one"),
        ("G0 X10.\u3000Y5.", "it is a full-width blank, type a plain one"),
    ],
)
def test_signs_that_look_like_others_are_named(block: str, told: str) -> None:
    alarm = cncsub.loads(f"O1\n{block}\nM30\n", control="fanuc-0i-f").run().alarm
    assert alarm is not None
    assert told in str(alarm)


def test_an_alarm_brings_its_cure_before_a_parameter(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text("O1\nM98 P5\nM30\n")
    done = CliRunner().invoke(app, ["run", str(file), "-c", "fanuc-0i-f"])
    assert done.stdout.splitlines()[-1] == "cure: load the program, or correct the call"
