"""The same programs on two controls, two versions of programs on one: where they part, and why."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

sys.path.insert(0, str(Path(__file__).with_name("benchmarks")))
import exchanged

MILL = "fanuc-0i-f"


def changed(program: str, control: str = MILL, **rules: Any) -> cncsub.Comparison:
    """Compare a program on a control with the same control that has other values for some rules."""
    one = cncsub.controls[control]
    library = cncsub.loads(program, control=one)
    return cncsub.compare(library, controls=[one, one.replace(**rules)])


CALL = "O1\nN10 M98 P2 L0\nN20 M30\nO2\nN30 M99\n"


def test_the_same_is_the_same() -> None:
    compared = cncsub.compare(
        cncsub.loads(CALL, control=MILL), controls=["fanuc-0i-f", "fanuc-0i-d"]
    )
    assert compared.same
    assert (compared.where, compared.rules, str(compared)) == (None, (), "the same")
    assert [run.stop for run in compared.runs] == ["end", "end"]


# program, rules changed, what is reported of each
CHANGES: list[tuple[str, dict[str, Any], str]] = [
    (
        CALL,
        {"zero_repeats": "skip"},
        "fanuc-0i-f: O1 N10, line 2: M98 O2, 1 pass\n"
        "fanuc-0i-f + zero_repeats=skip: no further call until the end",
    ),
    (
        "O1\nN10 #100=1\nN20 M98 P2\nM30\nO2\nM98 P3\nM99\nO3\nM99\n",
        {"max_nesting": 1},
        "fanuc-0i-f: O2, line 6: M98 O3, 1 pass\n"
        "fanuc-0i-f + max_nesting=1: no further call until alarm PS0077 nesting-too-deep at O2",
    ),
]


@pytest.mark.parametrize(("program", "rules", "what"), CHANGES)
def test_what_makes_the_difference_is_named(program: str, rules: dict[str, Any], what: str) -> None:
    compared = changed(program, **rules)
    assert not compared.same
    assert compared.rules == tuple(rules)
    assert compared.what == what


def test_a_variable_that_one_control_calls_by_two_numbers_is_one() -> None:
    library = cncsub.loads("O1\nN10 #100=1\nN20 #500=3\nN30 M30\n", control="haas-ngc")
    assert dict(library.run().variables) == {100: 1.0, 500: 3.0}
    assert library.run().variables[10100] == 1.0
    for controls in (["haas-ngc", MILL], [MILL, "haas-ngc"]):
        assert cncsub.compare(library, controls=controls).same


def test_what_a_control_calls_the_program_of_a_file_is_no_difference(tmp_path: Path) -> None:
    """M700 calls a main program by its file; FANUC calls it by its head."""
    file = tmp_path / "part.nc"
    file.write_text("O1\nN10 G0 X1.\nN20 M98 P2\nN30 M30\nO2\nN40 G1 X5. F100.\nN50 M99\n")
    assert cncsub.compare(file, controls=[MILL, "mitsubishi-m700"]).same
    file.write_text("O1\nN10 G0 X1.\nN20 M98 P9\nN30 M30\n")
    assert cncsub.compare(file, controls=[MILL, "mitsubishi-m700"]).same
    file.write_text("O1\nN10 G0 X10\nN20 M30\n")
    compared = cncsub.compare(file, controls=[MILL, "mitsubishi-m800"])
    assert compared.rules == ("whole_numbers",)


def test_the_block_that_a_call_begins_at_is_told() -> None:
    text = "O1\nN10 M98 P2 Q5\nN20 M30\nO2\nN4 G0 X1.\nN5 G0 X2.\nN6 M99\n"
    compared = cncsub.compare(cncsub.loads(text, control=MILL), controls=[MILL, "gsk-988ta"])
    assert compared.rules == ("start_word",)
    assert "O2, 1 pass" in compared.what
    assert "O2 from N5, 1 pass" in compared.what


def test_two_rules_that_make_it_together() -> None:
    program = "O1\nM98 P2 L0\nM98 P3\nM30\nO2\nM99\nO3\nM99\n"
    compared = changed(program, zero_repeats="skip", max_nesting=0)
    assert compared.rules == ("zero_repeats",)  # the first difference alone


def test_a_difference_of_languages_is_no_rule() -> None:
    library = cncsub.loads("G0 X1.\nM2\n", control="linuxcnc", name="A.NC")
    compared = cncsub.compare(library, controls=["linuxcnc", "siemens-one"])
    assert compared.rules == ()


BEFORE = "O1\nN10 G0 X1. Y2.\nN20 M98 P2 L2\nN30 M3\n#100=5\n#3006=1(A)\nM30\nO2\nM99\n"


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("Y2.", "Y3.", "before: O1 N10, line 2: move 0 goes to y = 2\nafter: O1 N10, line 2: move 0 goes to y = 3"),
        ("L2", "L3", "before: O1 N20, line 3: M98 O2, 2 passes\nafter: O1 N20, line 3: M98 O2, 3 passes"),
        ("M3\n", "M4\n", "before: O1 N30, line 4: M3\nafter: O1 N30, line 4: M4"),
        ("N30 M3\n", "", "before: O1 N30, line 4: M3\nafter: no further M code until the end"),
        ("#100=5", "#100=6", "before: O1, line 5: #100 = 5\nafter: O1, line 5: #100 = 6"),
        ("#100=5\n", "", "before: O1, line 5: #100 = 5\nafter: no further change until the end"),
        ("(A)", "(B)", "before: O1, line 6: message 'A'\nafter: O1, line 6: message 'B'"),
        ("M30", "M99", "before: stopped: end\nafter: stopped: cycles"),
        ("P2 L2", "P7", "before: O1 N20, line 3: M98 O2, 2 passes\nafter: no further call until alarm PS0076 program-not-found at O1 N20"),
    ],
)  # fmt: skip
def test_what_a_new_version_changed(old: str, new: str, what: str) -> None:
    assert old in BEFORE
    before, after = (
        cncsub.loads(text, control=MILL) for text in (BEFORE, BEFORE.replace(old, new, 1))
    )
    compared = cncsub.compare(before, after)
    assert compared.what == what
    assert compared.rules == ()


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("G0 X10000.01", "G0 X10000.02", ("x = 10000.01", "x = 10000.02")),
        ("#100=1000.0004", "#100=1000.0006", ("#100 = 1000.0004", "#100 = 1000.0006")),
        ("T12345678", "T12345679", ("T12345678", "T12345679")),
        ("G0 X100.4", "G0 X200.5", ("x = 100.4", "x = 200.5")),
        ("#3006=1(IT'S)", "#3006=1(ITS)", ('message "IT\'S"', "message 'ITS'")),
    ],
)
def test_what_differs_is_written_differently(old: str, new: str, told: tuple[str, str]) -> None:
    before, after = (cncsub.loads(f"O1\nN10 {text}\nM30\n", control=MILL) for text in (old, new))
    lines = cncsub.compare(before, after).what.splitlines()
    assert [line.partition(", line 2: ")[2].removeprefix("move 0 goes to ") for line in lines] == [
        *told
    ]


@pytest.mark.parametrize(
    "after",
    [
        BEFORE.replace("N20", "(A COMMENT)\nN20"),
        BEFORE.replace("X1. Y2.", "Y2.0 X1.000"),
        BEFORE.replace("M98 P2 L2", "M98 P20002"),
    ],
)
def test_what_does_the_same_is_the_same(after: str) -> None:
    before, later = (cncsub.loads(text, control=MILL) for text in (BEFORE, after))
    assert cncsub.compare(before, later).same


def test_paths_are_read(tmp_path: Path) -> None:
    for name, text in (("a", BEFORE), ("b", BEFORE.replace("X1.", "X2."))):
        (tmp_path / name).mkdir()
        (tmp_path / name / "O1.NC").write_text(text)
    compared = cncsub.compare(tmp_path / "a", tmp_path / "b", control=MILL)
    assert compared.where is not None
    assert [step and step.n for step in compared.where] == [10, 10]
    assert cncsub.compare(tmp_path / "a", controls=[MILL, "fanuc-30i"]).same


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"controls": [MILL]}, "two controls"),
        ({"controls": MILL}, "two controls"),
        ({}, "a second library, or controls="),
        ({"controls": [MILL, "fanuc-30i"], "second": "x"}, "not both"),
        ({"second": "x"}, "give control="),
        ({"controls": [MILL, "fanuc-30i"], "trace": "none"}, "leave out trace"),
    ],
)
def test_wrong_use_is_told(arguments: dict[str, Any], says: str) -> None:
    library = cncsub.loads(BEFORE, control=MILL)
    with pytest.raises(TypeError, match=says):
        cncsub.compare(library, **arguments)


def test_unknown_controls_are_errors() -> None:
    with pytest.raises(ValueError, match="fanuc-0i-f"):
        cncsub.compare(cncsub.loads(BEFORE, control=MILL), controls=[MILL, "fanuc-0i-g"])


# ---- all blocks that do otherwise ----


def changes(old: str, new: str, **options: Any) -> list[str]:
    before, after = (cncsub.loads(text, control=MILL) for text in (old, new))
    return [str(change) for change in cncsub.compare(before, after, **options).changes]


LONG = "O1\nN10 G0 X1. Y2.\nN20 M98 P2 L2\nN30 M3\n#100=5\nN40 G1 X#100 F100\nM30\nO2\nN50 G0 Z1.\nM99\n"


def test_every_change_is_told_by_its_block() -> None:
    new = LONG.replace("Y2.", "Y3.").replace("M3\n", "M4\n").replace("L2", "L3")
    assert changes(LONG, new.replace("#100=5", "#100=7")) == [
        "O1 N10, line 2: moves: y = 2 -> y = 3",
        "O1 N20, line 3: calls: M98 O2 2 times -> M98 O2 3 times",
        "O1 N30, line 4: codes: M3 -> M4",
        "O1, line 5: variables: #100 = 5 -> #100 = 7",
        "O1 N40, line 6: moves: x = 5, y = 2 -> x = 7, y = 3",
        "O2 N50, line 9: runs: 2 times -> 3 times",
        "O2 N50, line 9: moves: y = 2 -> y = 3",
        "O2, line 10: runs: 2 times -> 3 times",
    ]


def test_blocks_that_are_gone_or_new() -> None:
    assert changes(LONG, LONG.replace("N30 M3\n", "").replace("M99", "N60 G0 Y9.\nM99")) == [
        "O1 N30, line 4 is gone: N30 M3",
        "O1 N40, line 5 (was O1 N40, line 6): moves: y = 2 -> y = 9",
        "O2 N50, line 8 (was O2 N50, line 9): moves: y = 2 -> y = 9",
        "O2 N60, line 9 is new: N60 G0 Y9.",
    ]


def test_a_program_with_another_name_is_the_same_program() -> None:
    renamed = LONG.replace("P2 L2", "P5 L2").replace("O2", "O5")
    assert changes(LONG, renamed) == [
        "O1 N20, line 3: calls: M98 O2 2 times -> M98 O5 2 times",
    ]
    assert changes(LONG, renamed.replace("Z1.", "Z2."))[0].startswith("O1 N20")


def test_a_block_that_an_alarm_keeps_from_running() -> None:
    assert changes(LONG, LONG.replace("N30 M3", "N30 M98 P7"))[-1] == (
        "O1, line 7: runs: once -> never"
    )


def test_programs_without_an_end_are_compared_as_far_as_they_ran() -> None:
    endless = "O1\nN10 G0 X1.\nN20 GOTO 10\n"
    library = cncsub.loads(endless, control=MILL)
    compared = cncsub.compare(library, controls=[MILL, "mitsubishi-m700"], max_blocks=10_000)
    assert compared.same
    counted = endless.replace("N20", "N15 #100=#100+1\nN20")
    assert "O1 N15, line 3 is new: N15 #100=#100+1" in changes(endless, counted, max_blocks=10_000)


def test_the_same_has_no_changes() -> None:
    assert changes(LONG, LONG.replace("N20", "(A COMMENT)\nN20")) == []


def test_a_parameter_that_is_no_rule_is_named() -> None:
    one = cncsub.controls[MILL]
    library = cncsub.loads("O1\nN20 G100 A1.\nM30\nO9010\n#500=#1\nM99\n", control=one)
    other = one.with_parameters({"6050": 100, "3401#0": 1})
    compared = cncsub.compare(library, controls=[one, other])
    assert (compared.rules, compared.parameters) == ((), ("6050",))
    assert "\nbecause of the parameter 6050, " in str(compared)


def test_diff_prints_what_blocks_do(tmp_path: Path) -> None:
    for name, text in (("a.nc", LONG), ("b.nc", LONG.replace("Y2.", "Y3."))):
        (tmp_path / name).write_text(text)
    words = ["diff", str(tmp_path / "a.nc"), str(tmp_path / "b.nc"), "-c", MILL]
    done = CliRunner().invoke(app, words)
    assert done.exit_code == 1
    assert "what the blocks do differently:\n  O1 N10, line 2: moves: y = 2 -> y = 3" in done.stdout
    facts = json.loads(CliRunner().invoke(app, [*words, "--format", "json"]).stdout)
    assert facts["changes"][0] == {
        "what": "moves", "old": "y = 2", "new": "y = 3",
        "before": {"program": "O1", "n": 10, "line": 2}, "after": {"program": "O1", "n": 10, "line": 2},
    }  # fmt: skip


# ---- a rule that was changed is the rule that is named ----


def test_the_rule_that_was_exchanged_is_named() -> None:
    """This looks at a few pairs, tests/benchmarks/exchanged.py at 1,000."""
    right, wrong = exchanged.look(60, seed=3)
    assert wrong == []
    assert right == 60


@pytest.mark.parametrize(("one", "other"), [("fanuc-0i-f", "linuxcnc"), ("linuxcnc", "haas-ngc")])
def test_two_libraries_of_two_languages_are_compared_by_what_they_do(one: str, other: str) -> None:
    """They are compared like two controls: heads, and codes that end programs, do not count."""
    texts = {"linuxcnc": "G0 X1.\nG1 X5. F10.\nM3 S1\nM30\n"}
    before, after = (
        cncsub.loads(texts.get(name, "O1\nG0 X1.\nG1 X5. F10.\nM3 S1\nM30\n"), control=name)
        for name in (one, other)
    )
    assert cncsub.compare(before, after).same
    moved = cncsub.loads("G0 X1.\nG1 X6. F10.\nM3 S1\nM30\n", control="linuxcnc")
    told = cncsub.compare(
        cncsub.loads("O1\nG0 X1.\nG1 X5. F10.\nM30\n", control="fanuc-0i-f"), moved
    )
    assert "x = 5" in told.what
    assert "x = 6" in told.what


# ---- in words, and after the first difference ----

ARC = "O1\nN10 G2 X10. R5. F100\nN20 M30\n"


def test_modes_that_differ_are_named_with_the_rule() -> None:
    library = cncsub.loads(ARC, control=MILL)
    compared = cncsub.compare(library, controls=[MILL, "gsk-988ta"])
    assert str(compared).splitlines() == [
        "fanuc-0i-f: O1 N10, line 2: move 0 is in the plane of G17",
        "gsk-988ta: O1 N10, line 2: move 0 is in the plane of G18",
        "G17 in force on fanuc-0i-f, G18 on gsk-988ta (rule machine: mill, lathe-a)",
    ]


@pytest.mark.parametrize(
    ("program", "rules", "mode"),
    [
        ("O1\nN10 G0 X1.\nN20 M30\n", {"power_on": "G20"}, "G21 in force on fanuc-0i-f, G20 on fanuc-0i-f + power_on=G20"),
        ("O1\nN5 G0 X1.\nN10 X1.\nN20 M30\n", {"power_on": "G91"}, "G90 in force on fanuc-0i-f, G91 on fanuc-0i-f + power_on=G91"),
    ],
)  # fmt: skip
def test_a_mode_at_power_on_is_named(program: str, rules: dict[str, str], mode: str) -> None:
    compared = changed(program, **rules)
    assert compared.rules == ("power_on",)
    assert compared.differences[0].why[0].startswith(f"{mode} (rule power_on: ")


def test_a_mode_that_decides_nothing_is_not_named() -> None:
    library = cncsub.loads("O1\nN10 G4 P1\nN20 G0 X10\nM30\n", control=MILL)
    told = str(cncsub.compare(library, controls=[MILL, "mitsubishi-m700"]))
    assert "in force" not in told
    assert "because of the rule whole_numbers, a length written without a point:" in told


TWO = "O1\nN10 M98 P2 L0\nN20 G0 X10\nN30 M98 P20003\nM30\nO2\nM99\nO3\nM99\n"


def test_all_differences_are_found_one_after_the_other() -> None:
    library = cncsub.loads(TWO, control=MILL)
    controls = [MILL, "mitsubishi-m700"]
    compared = cncsub.compare(library, controls=controls, all_differences=True)
    assert [found.rules for found in compared.differences] == [
        ("zero_repeats",), ("whole_numbers",), ("program_word",),
    ]  # fmt: skip
    assert compared.rules == ("zero_repeats",)
    assert compared.rest.endswith("does the same as mitsubishi-m700")
    assert str(compared).count("because of the rule") == 3
    first = cncsub.compare(library, controls=controls)
    assert first.differences == compared.differences[:1]
    assert first.rest == ""


def test_after_a_difference_that_no_rule_makes_nothing_is_compared() -> None:
    library = cncsub.loads("O1\nN10 G0 X1.\nM30\n", control=MILL)
    compared = cncsub.compare(library, controls=[MILL, "siemens-one"], all_differences=True)
    assert len(compared.differences) == 1
    assert compared.rest.startswith("what comes after is not compared")


def test_all_differences_are_of_two_controls() -> None:
    library = cncsub.loads(ARC, control=MILL)
    with pytest.raises(TypeError, match="all_differences is of two controls"):
        cncsub.compare(library, library, all_differences=True)
    assert cncsub.compare(library, controls=[MILL, MILL], all_differences=True).rest == ""


def test_the_command_goes_on_after_the_first_difference(tmp_path: Path) -> None:
    file = tmp_path / "two.nc"
    file.write_text(TWO)
    words = ["compare", str(file), "-c", "0i-f", "-c", "Mitsubishi M700"]
    done = CliRunner().invoke(app, words)
    assert done.stdout.endswith("--all goes on after this difference\n")
    done = CliRunner().invoke(app, [*words, "--all"])
    assert (done.exit_code, done.stdout.count("because of the rule")) == (1, 3)
    told = json.loads(CliRunner().invoke(app, [*words, "--all", "--format", "json"]).stdout)
    assert [found["rules"] for found in told["differences"]][1] == ["whole_numbers"]
