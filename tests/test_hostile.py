"""Programs written to break the reader or the machine: each ends soon, with or without an alarm."""

from __future__ import annotations

import itertools
import os
import random
import subprocess
import sys
import time

import pytest

import cncsub

NAMES = sorted(cncsub.controls)
MANY = 100_000
SANITIZED = "libasan" in os.environ.get("LD_PRELOAD", "")
INFINITE = "*".join(["EXP[110]"] * 7)  # above the largest double


def ends(text: str, control: str | cncsub.Control) -> cncsub.Run:
    """Return the run of a program that must come to an end, whatever that is."""
    run = cncsub.loads(text, control=control).run(max_blocks=10_000, max_seconds=20)
    assert run.stop in {"end", "alarm", "cycles", "limit", "waiting"}
    assert (run.alarm is not None) == (run.stop == "alarm")
    return run


def cause(text: str, control: str | cncsub.Control) -> str | None:
    alarm = ends(text, control).alarm
    return alarm and alarm.cause


NESTED = {
    "brackets": "O1\nN1 #1=" + "[" * MANY + "1" + "]" * MANY + "\nM30\n",
    "brackets in a word": "O1\nN1 X" + "-[" * MANY + "1" + "]" * MANY + "\nM30\n",
    "functions": "O1\nN1 #1=" + "SIN[" * MANY + "1" + "]" * MANY + "\nM30\n",
    "variables of variables": "O1\nN1 " + "#[" * MANY + "1" + "]" * MANY + "=1\nM30\n",
    "comments": "O1\nN1 " + "(" * MANY + ")" * MANY + "\nM30\n",
    "comments in a number": "O1\nN1 X" + "(a)" * MANY + "1\nM30\n",
    "NOT": "%1\nN1 IF " + "NOT " * MANY + "TRUE\nENDIF\nM30\n",
    "NOT of structured programs": "%@MACRO\n#1 := " + "NOT " * MANY + "1;\nM30;\n",
    "signs": "%@MACRO\n#1 := " + "-+" * MANY + "1;\nM30;\n",
    "THEN": "O1\nN1 " + "IF[1EQ1]THEN " * MANY + "#1=1\nM30\n",
    "slashes": "O1\nN1 X1" + "/X1" * MANY + "\nM30\n",
    "equals signs": "O1\nN1 G65 P2 X1" + "=1" * MANY + "\nM30\n",
    "loops": "O1\n" + "WHILE[1EQ1]DO1\n" * 20_000 + "END1\n" * 20_000 + "M30\n",
    "IF blocks": "O1\n" + "IF[1EQ1]\n" * 20_000 + "ENDIF\n" * 20_000 + "M30\n",
    "definitions": "".join(f"o{i} sub\n" for i in range(50_000)),
    "closed definitions": "".join(f"o{i} sub\no{i} endsub\n" for i in range(50_000)) + "M2\n",
    "branches and breaks": "".join(f"o{i} if [1]\n" for i in range(50_000)) + "o7 break\n" * 50_000,
    "names": "%1\n" + "P[A]" * MANY + "M98\nM30\n",
    "words": "O1\nN1 G65 P2 " + "A1I1J1K1" * MANY + "\nM30\n",
    "digits": "O" + "1" * MANY + "\nN1 X" + "1" * MANY + "\nM30\n",
}


@pytest.mark.parametrize("name", NESTED)
def test_what_is_nested_or_repeated_without_end_is_read_to_its_end(name):
    for control in NAMES:
        ends(NESTED[name], control)


LONG = {
    "brackets": "(" * MANY,
    "codes": "G1 " * (MANY // 3),
    "quotes": '"' * MANY,
    "marks": "$" * MANY,
    "letters": "A B " * (MANY // 4),
    "sums": "R1=" + "1+" * (MANY // 2),
    "square brackets": "R[" * (MANY // 2),
    "statements": "IF " * (MANY // 3),
    "equals signs": "X=" * (MANY // 2),
}


@pytest.mark.parametrize("name", LONG)
def test_a_line_that_is_wrong_costs_what_it_is_long(name):
    """A cost in proportion to the line is some thousandths of a second. If each of its words looked
    at all of the line, it would be a minute.
    """
    for control in NAMES:
        begun = time.process_time()
        library = cncsub.loads(LONG[name] + "\nM30\n", control=control)
        library.run(max_seconds=20)
        library.check()
        assert time.process_time() - begun < 3, control


def numbered(*lines: str, count: int) -> str:
    """Return each of these lines for every number from 1 on, in place of its #."""
    return "".join(f"{line}\n".replace("#", str(k)) for k in range(1, count + 1) for line in lines)


SUB = "o1 sub\no1 endsub\n"
STRUCTURES = {
    "subprograms": numbered("o# sub", "o# endsub", count=50_000),
    "subprograms without an end": numbered("o# sub", count=40_000),
    "subprograms that share an end": numbered("o# sub", count=40_000) + "o1 endsub\n",
    "calls": SUB + "o1 call\n" * 40_000,
    "calls with a value": SUB + "o1 call [1]\n" * 20_000,
    "branches, and exits without a loop": numbered("o# if [1]", count=40_000) + "o0 break\n" * 40_000,
    "loops beside calls": SUB + numbered("o# repeat [1]", "o1 call", "o# endrepeat", count=40_000),
}  # fmt: skip


@pytest.mark.parametrize("control", ["grblhal"])
@pytest.mark.parametrize("name", STRUCTURES)
def test_structures_cost_what_they_are_long(name: str, control: str) -> None:
    """Each costs less than a second and 200 MB. If one looked at all others, it would be many."""
    code = f"""
import resource, sys, time, cncsub
text = sys.stdin.read() + "M2\\n"
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
library = cncsub.loads(text, control={control!r})
library.check()
library.run(max_blocks=100_000, max_seconds=20)
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
print(time.process_time(), (peak - before) // 1024)
"""
    done = subprocess.run(
        [sys.executable, "-c", code], input=STRUCTURES[name], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    seconds, mebibytes = map(float, done.stdout.split())
    assert seconds < (40 if SANITIZED else 4)
    assert SANITIZED or mebibytes < 200


def test_blanks_in_a_program_name_are_cut_in_one_go():
    ends("<" + " " * 1_000_000 + "A>\nM30\n", "fanuc-30i")
    ends("<" + " " * 1_000_000 + "A>\nM30\n", "gsk-988ta")


@pytest.mark.parametrize("function", ["SIN", "COS", "TAN", "FIX", "ROUND", "BIN", "ABS"])
def test_a_value_above_all_numbers_is_an_overflow_wherever_it_stands(function):
    assert cause(f"O1\nN1 #1={function}[{INFINITE}]\nN2 M30\n", "fanuc-30i") == "overflow"
    assert cause(f"O1\nN1 #1=1/{function}[{INFINITE}]\nN2 M30\n", "gsk-988ta") == "overflow"


def test_a_word_takes_no_value_that_a_variable_does_not_take():
    program = "O1\nN1 G0 X[EXP[110]*EXP[110]*EXP[110]]\nN2 M30\n"
    assert cause(program, "fanuc-30i") == "overflow"
    assert cause(program, "gsk-988ta") == "overflow"


@pytest.mark.parametrize("code", ["M1111111111111", "M" + "9" * 30, "G" + "9" * 30, "M-5", "G-4"])
def test_no_code_is_too_large_or_too_small_to_be_refused(code):
    for control in NAMES:
        asked = {rule.name for rule in cncsub.controls[control].rules}
        lenient = {"max_digits": 0, "minus_addresses": "GM"}
        changed = cncsub.controls[control].replace(
            **{rule: value for rule, value in lenient.items() if rule in asked}
        )
        for known in (control, changed):
            assert cause(f"O1\nN1 {code}\nN2 M30\n", known) is not None


@pytest.mark.parametrize("value", ["EXP[108]", "-EXP[108]", "9999999999", "EXP[-108]"])
@pytest.mark.parametrize(
    "control", ["fanuc-30i", "gsk-988ta", "gsk-980mdi", "mitsubishi-m700", "hnc-21m"]
)
def test_every_word_takes_values_beyond_every_range(control, value):
    for letter in "ABCDEFHIJKLMNOPQRSTUVWXYZ":
        ends(
            f"O1\n#100={value}\nG1 F100 X1 S1 M3\n{letter}#100\nG0 {letter}#100 X1\nM30\n", control
        )
    for code in (
        2,
        4,
        10,
        28,
        30,
        31,
        41,
        43,
        50,
        51,
        52,
        53,
        54,
        68,
        70,
        71,
        72,
        73,
        74,
        75,
        76,
        81,
        83,
        90,
        92,
        96,
    ):
        words = " ".join(f"{letter}#100" for letter in "XYZUWRIJKPQLFDH")
        ends(
            f"O1\n#100={value}\nG1 F100 X1 S1 M3\nG{code} {words}\nG{code} X1 Z-5 {words}\nM30\n",
            control,
        )
        ends(
            f"O1\n#100={value}\nG1 F100 X1 S1 M3\nG{code} P#100 R#100\nG{code} L#100 P1\nM30\n",
            control,
        )


@pytest.mark.parametrize("statement", [
    "GOTO#100", "M98 P#100", "M98 P2 L#100", "G65 P#100", "G65 H#100", "G65 H99999999999999", "M99 P#100",
    "M97 P#100", "#[#100]=1", "#1=#[#100]", "#3000=#100", "DPRNT[#100[99]]", "BPRNT[#100[9]]", "#1=RAND[#100]",
    "#1=BCD[#100]", "#1=#100 AND 1", "#3001=#100", "#5221=#100", "#1=PRM[#100]", "G65 H31 P#101 Q#100 R#100",
])  # fmt: skip
def test_statements_take_values_beyond_every_range(statement):
    for control in NAMES:
        for value in ("EXP[108]", "-EXP[108]", "9999999999"):
            ends(f"O1\n#100={value}\n{statement}\nM30\n", control)


STUCK = {
    "a cut too fine to see": "G0 X99999. Z1.\nG71 U.0000001 R.1\nG71 P10 Q20 U0 W0 F1\n",
    "passes": "G0 X100. Z1.\nG73 U1. W1. R9999999\nG73 P10 Q20 U0 W0 F1\n",
    "grooves": "G0 X100. Z0\nG75 X0 Z-99999. P1 Q1 R0 F1\n",
}


@pytest.mark.parametrize("name", STUCK)
def test_no_block_of_a_lathe_makes_moves_without_end(name):
    program = f"O1\n{STUCK[name]}N10 G0 X1.\nN20 G1 Z-10.\nM30\n"
    assert cause(program, "gsk-988ta") in ("value-out-of-range", "cycle-depth", "too-many-digits")


def test_no_canned_cycle_makes_moves_without_end():
    stuck = "O1\n#1=EXP[60]\nG90 G98 G83 X1. Z-#1 R1. Q.001 F100\nM30\n"
    assert cause(stuck, "fanuc-0i-f") == "value-out-of-range"
    holes = "O1\nG90 G98 G81 X1. Z-10. R1. F100 K9999999\nM30\n"
    assert cause(holes, "fanuc-0i-f") == "value-out-of-range"


def test_a_profile_that_holds_its_own_cycle_does_not_follow_itself():
    for code in (70, 71, 72, 73):
        program = f"O1\nG1 F100\nN10 G0 X1.\nN15 G{code} P10 Q20\nN20 G1 X2.\nM30\n"
        assert cause(program, "gsk-988ta") is not None
        for control in NAMES:
            ends(program, control)


def test_a_profile_may_begin_with_the_first_block_of_the_memory():
    program = "O1\nN10 G0 X1.\nN20 G1 X2. F1\nN30 G70 P10 Q20\nN40 M30\n"
    assert cause(program, "gsk-988ta") is None


def test_loops_that_m97_leaves_are_closed():
    program = "O1\nN1 #1=#1+1\nIF[#1GT50]GOTO9\nDO1\nDO2\nDO3\nM97 P1\nEND3\nEND2\nEND1\nN9 M30\n"
    for control in NAMES:
        assert cause(program, control) not in ("loops-too-deep", "missing-do")


@pytest.mark.parametrize("calls", [
    "M98P1", "M98P1Q1", "M98H1", "G65P1", "G65P2A#1", "G66P2\nX1", "G66.1P2\nX1Y1", "M98P2",
])  # fmt: skip
def test_programs_that_call_themselves_come_to_an_end(calls):
    for control in NAMES:
        ends(f"O1\nN1 {calls}\nM30\nO2\nN1 {calls}\nX1\nG67\nM99\n", control)


def test_bytes_that_are_no_program_are_read():
    chance = random.Random(1)
    letters = "OGNMPXYZIJKRFL#[]()=/;,.-+*0123456789 \n%<>IFWHILEDOENDGOTOTHEN\0\x7f\u00e9"
    for _ in range(100):
        ends("O1\n" + "".join(chance.choices(letters, k=500)), chance.choice(NAMES))


ENDS = [
    "M#1 G67", "G66 P2 M#1", "G65 P2 M#1", "M#1 M98 P2", "M#1 M99", "G66.1 P2 M#1", "M98 P2 M#1",
    "M#1 M97 P9",
]  # fmt: skip


@pytest.mark.parametrize("name", sorted(cncsub.controls))
def test_a_computed_code_that_ends_or_restarts_stands_beside_calls(name: str) -> None:
    control = cncsub.controls[name].replace(roles="M77=start-over")
    for block, code, modal in itertools.product(ENDS, (2, 30, 77), ("", "G66 P2\n")):
        text = f"O1\n#1={code}\n{modal}N9 {block}\nX1. M98 P3\nM30\nO2\nM99\nO3\n{block}\nM99\n"
        library = cncsub.loads(text, control=control)
        run = library.run(max_blocks=50, max_cycles=3)
        machine = library.machine(max_blocks=50, max_cycles=3)
        while machine.step():
            pass
        assert machine.stop == run.stop


@pytest.mark.parametrize(
    "text", ["é(", "(" + "é" * 5000, "X" + "é" * 5000, "N1 G1 X\u4e2d(", "O1\nX1é2\n"]
)
@pytest.mark.parametrize("control", cncsub.controls)
def test_an_alarm_shows_whole_characters(control, text):
    for more in ("", " "):
        run = cncsub.loads(more + text, control=control).run()
        if run.alarm is not None:
            assert str(run.alarm)
            assert run.alarm.word is not None


def test_the_head_of_a_program_may_hold_any_characters() -> None:
    for control in ("siemens-one", "siemens-828d"):
        library = cncsub.loads("%_N_TEIL\u00dc_MPF\nM30", control=control)
        assert library.check() == []
        assert library.run().stop == cncsub.Stop.END
