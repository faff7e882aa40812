"""Limits hold: every program ends in time, at `max_blocks`, `max_seconds` or an alarm.

The bounds on time are generous, for machines that have other work to do.
"""

from __future__ import annotations

import itertools
import math
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import cncsub

NAMES = sorted(cncsub.controls)
SANITIZED = "libasan" in os.environ.get("LD_PRELOAD", "")
SECONDS = 0.2  # the limit of a run
SLACK = 20.0  # the time that a block, a busy machine and a sanitizer may add to it


def nested(levels: int, body: str = "", call: str = "M98 P{} L9999", back: str = "M99") -> str:
    """Return programs that call each other 9999 times on each of so many levels."""
    calls = [f"O{k}\n{call.format(k + 1)}\n{back}\n" for k in range(2, levels + 1)]
    head = f"O1\n{call.format(2)}\nM30\n"
    return head + "".join(calls) + f"O{levels + 1}\n{body}\n{back}\n"


WORDS = {"okuma-osp-p300": ("CALL O{} Q9999", "RTS")}  # of calls and returns, where M98 is none


CUTS = "N10 G0 X1.\n" + "G1 X1. W-1.\n" * 90 + "N20 G1 X2. F1\n"
LONG_PROFILES = cncsub.controls["gsk-988ta"].replace(max_profile_blocks=0)
ENDLESS = {
    "a jump": ("fanuc-0i-f", "O1\nN10 GOTO10\n"),
    "a loop": ("fanuc-0i-f", "O1\nWHILE[1EQ1]DO1\n#1=#1+1\nEND1\n"),
    "M99": ("fanuc-0i-f", "O1\nM99\n"),
    "a jump of the MELDAS": ("mitsubishi-meldas", "O1\nM98\n"),
    "a loop of the HNC": ("hnc-21m", "%1\nWHILE TRUE\n#1=#1+1\nENDW\n"),
    "M97": ("gsk-928te", "%1\nN10 M97 P10\n"),
    "H80": ("gsk-980tdi", "O1\nN10 G65 H80 P10\n"),
    "blocks that are skipped": ("fanuc-0i-f", "O1\nN10 X1.\n" + "/X1.\n" * 100_000 + "GOTO10\n"),
    "ten levels": ("fanuc-0i-f", nested(10)),
    "twelve levels": ("gsk-988ta", nested(12, "X1.")),
    "a long expression": ("fanuc-0i-f", "O1\nN10 #1=1" + "+SIN[#2]*3" * 50_000 + "\nGOTO10\n"),
    "many arguments": ("fanuc-0i-f", "O1\nN10 G65 P2 " + "A[1+#2]" * 50_000 + "\nGOTO10\nO2\nM99\n"),
    "long output": ("fanuc-0i-f", "O1\nN10 DPRNT[" + "A" * 100_000 + "]\nGOTO10\n"),
    "much output": ("fanuc-0i-f", "O1\nN10 DPRNT[" + "#1[99]" * 50_000 + "]\nGOTO10\n"),
    "long messages": ("fanuc-0i-f", "O1\nN10 #3006=1(" + "A" * 100_000 + ")\nGOTO10\n"),
    "holes": ("fanuc-0i-f", "O1\nZ5.\nN10 G91 G81 X1. Z-1. R1. F100 K90000\nGOTO10\n"),
    "pecks": ("fanuc-0i-f", "O1\nZ5.\nN10 G83 X1. Z-99. R1. Q.001 F100\nGOTO10\n"),
    "levels of a contour": (
        "gsk-988ta", f"O1\nG0 X900. Z1.\nG71 U.01 R.1\nN5 G71 P10 Q20 U0 W0 F1\n{CUTS}GOTO5\n",
    ),
    "passes of a contour": (
        "gsk-988ta", f"O1\nG0 X9. Z1.\nG73 U1. W1. R9999\nN5 G73 P10 Q20 U0 W0 F1\n{CUTS}GOTO5\n",
    ),
    "a long profile": (
        LONG_PROFILES, "O1\nN5 G70 P10 Q20 F1\nGOTO5\nN10 G0 X1.\n" + "X1.\n" * 50_000 + "N20 G1 X2.\n",
    ),
}  # fmt: skip


WITHOUT_BOUNDS = cncsub.controls["fanuc-0i-f"].replace(
    max_nesting=999_999_999, max_macro_nesting=999_999_999, max_total_nesting=0
)
# Programs that keep more and more: each kind of data that a run keeps, in few blocks and in many.
GROWING = {
    "steps": ("fanuc-0i-f", "O1\nN10 GOTO10\n"),
    "steps of blocks without a word": ("fanuc-0i-f", "O1\nN10 (A)\nN11\nGOTO10\n"),
    "moves": ("fanuc-0i-f", "O1\nG91 F1\nN10 G1 X1.\nGOTO10\n"),
    "moves of one block": ("fanuc-0i-f", "O1\nZ5.\nN10 G83 X1. Z-900. R1. Q.002 F1\nGOTO10\n"),
    "one message": ("fanuc-0i-f", "O1\nN10 #3006=1(" + "A" * 2_000_000 + ")\nGOTO10\n"),
    "long messages": ("fanuc-0i-f", "O1\nN10 #3006=1(" + "A" * 60_000 + ")\nGOTO10\n"),
    "messages": ("fanuc-0i-f", "O1\nN10 #3006=1(" + "A" * 900 + ")\nGOTO10\n"),
    "messages after THEN": ("fanuc-0i-f", "O1\nN10 IF[1EQ1]THEN #3006=1(" + "A" * 900 + ")\nGOTO10\n"),
    "printed lines": ("fanuc-0i-f", "O1\nN10 DPRNT[" + "A" * 900 + "]\nGOTO10\n"),
    "one printed line": ("fanuc-0i-f", "O1\nN10 DPRNT[" + "#1[44]" * 200_000 + "]\nGOTO10\n"),
    "M and T codes": ("fanuc-0i-f", "O1\nN10 M3 T1\nGOTO10\n"),
    "calls and their arguments": ("fanuc-0i-f", "O1\nN10 G65 P2 A1. B2. C3. I4.\nGOTO10\nO2\nM99\n"),
    "open calls": (WITHOUT_BOUNDS, "O1\nM98 P1\n"),
    "levels of locals": (WITHOUT_BOUNDS, "O1\nG65 P1 A1.\n"),
    "names of variables": ("fanuc-0i-f", "O1\nN10 SETVN 100[" + ",".join(f"A{k}" for k in range(200_000)) + "]\nGOTO10\n"),
    "moves held back": ("fanuc-0i-f", "O1\nG41 D1 G1 X9. F1\n" + "Z1.\nZ2.\n" * 100_000 + "M30\n"),
    "a profile": (LONG_PROFILES, "O1\nN5 G70 P10 Q20 F1\nGOTO5\nN10 G0 X1.\n" + "X1.\n" * 100_000 + "N20 G1 X2.\n"),
}  # fmt: skip
KEEPS_NOTHING = {
    "open calls",
    "levels of locals",
    "names of variables",
    "a profile",
    "one message",
    "long messages",
}


@pytest.mark.parametrize(
    ("name", "trace"),
    [*((name, "moves") for name in GROWING), *((name, "none") for name in sorted(KEEPS_NOTHING))],
)
def test_everything_that_a_run_keeps_counts(name: str, trace: str) -> None:
    control, text = GROWING[name]
    most = 1 << 20
    run = cncsub.loads(text, control=control).run(
        max_memory=most, max_blocks=2**62, max_cycles=2**62, max_seconds=60, trace=trace
    )
    assert run.stop is cncsub.Stop.LIMIT
    longest = max(map(len, text.split("\n")))
    assert run.core.memory < most + (most // 2) + longest
    assert sum(map(len, run.messages)) < most + (most // 2) + longest


SKIPPED = {
    "and nothing else": "O1\n" + "/X1\n" * 1_000_000 + "M99\n",
    "and a block": "O1\n" + "/X1\n" * 500_000 + "#1=1\nM99\n",
    "around a jump": "O1\nN1\n" + "/X1\n" * 900_000 + "GOTO1\n",
}


@pytest.mark.parametrize("name", SKIPPED)
def test_blocks_that_are_skipped_take_time_too(name: str) -> None:
    library = cncsub.loads(SKIPPED[name], control="fanuc-0i-f")
    begun = time.process_time()
    run = library.run(max_seconds=SECONDS, max_blocks=2**62, max_cycles=2**62, block_skip=1)
    assert run.stop is cncsub.Stop.LIMIT
    assert time.process_time() - begun < SECONDS + 2.0


def test_the_time_of_a_run_in_pieces_is_that_of_all_pieces() -> None:
    library = cncsub.loads("O1\nN10 #1=#1+1\nN20 GOTO10\n", control="fanuc-0i-f")
    limits: dict[str, Any] = {"max_seconds": 0.005, "max_blocks": 2**62}
    begun = time.process_time()
    for _ in library.stream(rows=1000, trace="none", **limits):
        pass
    machine = library.machine(max_memory=2**40, **limits)
    while machine.stop is None:
        machine.run(until=("O1", 10))
    stepped = library.machine(max_memory=2**40, **limits)
    steps = sum(1 for _ in stepped)
    assert stepped.stop is cncsub.Stop.LIMIT
    assert len(stepped.steps) == steps
    assert time.process_time() - begun < SLACK


@pytest.mark.parametrize("trace", ["none", "moves"])
@pytest.mark.parametrize("name", ENDLESS)
def test_max_seconds_holds_however_long_the_blocks_are(name: str, trace: str) -> None:
    control, text = ENDLESS[name]
    library = cncsub.loads(text, control=control)
    begun = time.monotonic()
    run = library.run(
        max_seconds=SECONDS, max_blocks=2**62, max_cycles=2**62, block_skip=1, trace=trace
    )
    assert run.stop is cncsub.Stop.LIMIT, run
    assert time.monotonic() - begun < SECONDS + SLACK


@pytest.mark.parametrize("name", ENDLESS)
def test_max_blocks_is_met_exactly(name: str) -> None:
    control, text = ENDLESS[name]
    run = cncsub.loads(text, control=control).run(max_blocks=5, max_cycles=2**62, block_skip=1)
    assert run.stop is cncsub.Stop.LIMIT
    assert len(run.steps) == 5


def test_no_block_is_executed_where_none_is_allowed() -> None:
    run = cncsub.loads("O1\n#100=1\nM30\n", control="fanuc-0i-f").run(max_blocks=0)
    assert run.stop is cncsub.Stop.LIMIT
    assert len(run.steps) == 0
    assert 100 not in run.variables


def test_at_its_limit_a_machine_stands_at_the_same_block_however_it_came_there() -> None:
    library = cncsub.loads("O1\nN10 M3\n/N20 M4\nN30 M30\n", control="fanuc-0i-f")
    stepped, run = (library.machine(max_blocks=1, block_skip=1) for _ in range(2))
    assert [step.n for step in stepped] == [10]
    run.run()
    assert repr(run) == repr(stepped)
    assert "next block O1 N20" in repr(run)


@pytest.mark.parametrize("control", NAMES)
def test_one_level_too_many_is_an_alarm_at_once(control: str) -> None:
    text = nested(40, "", *WORDS.get(control, ()))
    run = cncsub.loads(text, control=control).run()
    assert run.alarm is not None
    assert len(run.steps) < 40


def test_all_moves_of_a_profile_count_together() -> None:
    grooves = "G75 R0\nG75 X0 Z-99. P1 Q1 R0 F1\n" * 400
    text = f"O1\nG0 X99. Z1.\nN5 G70 P10 Q20 F1\nM30\nN10 G0 X100.\n{grooves}N20 G1 X2.\n"
    for control in NAMES:
        begun = time.monotonic()
        cncsub.loads(text, control=control).run(max_seconds=SECONDS)
        assert time.monotonic() - begun < SLACK


def test_a_contour_of_many_pieces_in_many_levels_is_refused() -> None:
    cuts = "N10 G0 X1.\n" + "G1 X1. W-.001\n" * 50_000 + "N20 G1 X900. F1\n"
    text = f"O1\nG0 X900. Z1.\nG71 U.001 R.1\nG71 P10 Q20 U0 W0 F1\n{cuts}M30\n"
    alarm = cncsub.loads(text, control=LONG_PROFILES).run().alarm
    assert alarm is not None
    assert alarm.cause == "value-out-of-range"


def test_a_parameter_that_asks_for_endless_finishing_passes_is_refused() -> None:
    control = cncsub.controls["fanuc-0i-f"].with_parameters({"5142": 2e8})
    library = cncsub.loads("O1\nG0 X30. Z5.\nG76 X18. Z-20. P1000 Q1000 F2.\n", control=control)
    alarm = library.run(setup={"machine": "lathe-a"}).alarm
    assert alarm is not None
    assert alarm.cause == "value-out-of-range"


# ---- edges of values ----

VALUES = [
    0, 1, -1, 0.5, 1 / 3, -0.0, 2.0**31 - 1, 2.0**31, -(2.0**31), 2.0**32, 2.0**53, 2.0**53 + 1,
    2.0**63, -(2.0**63), 2.0**64, 1e47, -1e47, 1e300, 1e308, -1e308, 5e-324, None,
]  # fmt: skip
# Every number below 20,000, and the numbers around the ends of the ranges above.
NUMBERS = [
    *range(20_100),
    *(n + d for n in (100_000, 110_000, 200_000, 500_000, 980_000) for d in range(-2, 60)),
    *(2**31 - 2, 2**31 - 1, 2**31, 2**32, 2**53, 2**63 - 1, 2**63, -1, -(2**63) - 1),
]


@pytest.mark.parametrize("control", NAMES)
def test_every_variable_takes_every_value_or_refuses_it(control: str) -> None:
    text = "O1\nG0 X1.\nG65 P2 A1.\nG1 X9. F9\nM30\nO2\nX3.\nM99\n"
    machine = cncsub.loads(text, control=control).machine(max_blocks=100)
    machine.step()
    machine.step()
    variables = machine.variables
    values = itertools.cycle(VALUES)
    for number in NUMBERS:
        for _ in range(5):
            try:
                variables[number] = next(values)
                value = variables[number]
            except (KeyError, ValueError):
                continue
            assert value is None or math.isfinite(value)
    assert all(variables[number] is not None for number in variables)
    machine.run()
    assert machine.stop is not None
    assert all(map(math.isfinite, machine.position.values()))
    repr(machine.moves)


EDGES = [
    "0", "-0", "1", "-1", ".5", ".", "0.0000001", "32768", "65536", "99999", "999999", "99999999",
    "999999999", "2147483648", "-2147483649", "4294967296", "9007199254740993",
    "9223372036854775808", "18446744073709551616", "1" + "0" * 309, "#0", "#100", "#[-1]",
    "#[0.5]", "#[2147483648]", "[1/3]", "[EXP[110]*EXP[110]]", "--1", "1.5.5", "#99999999999",
]  # fmt: skip


def ends(text: str, control: str) -> None:
    run = cncsub.loads(text, control=control).run(max_blocks=50, max_cycles=2, max_seconds=SECONDS)
    assert (run.alarm is not None) == (run.stop == "alarm")
    assert all(map(math.isfinite, run.position.values()))
    str(run.alarm)


@pytest.mark.parametrize("control", NAMES)
def test_every_address_takes_every_number_or_refuses_it(control: str) -> None:
    for letter, edge in itertools.product("ABCDEFGHIJKLMNOPQRSTUVWXYZ", EDGES):
        ends(
            f"O1\n#100=1/3\nG1 F9 S9 M3 X1.\n{letter}{edge}\n{letter}{edge} X2. Z3.\nM30\n", control
        )


@pytest.mark.parametrize("control", NAMES)
@pytest.mark.parametrize("statement", [
    "GOTO{0}", "M98 P{0}", "M98 P2 L{0}", "M98 P2 Q{0}", "M98 P2 H{0}", "M198 P{0}", "G65 P{0}",
    "G65 P2 L{0}", "G66 P2 L{0}\nX1.", "G65 H{0} P#101 Q1 R1", "G65 H5 P#101 Q{0} R{0}", "M99 P{0}",
    "M99 L{0}", "M97 P{0}", "N{0} M99 P{0}", "#[{0}]={0}", "#101=#[{0}]", "#101=PRM[{0}]",
    "#101=BCD[{0}]", "#3000={0}", "DPRNT[#100[{0}]]", "G10 L2 P{0} X{0}", "G54.1 P{0}",
])  # fmt: skip
def test_every_statement_takes_every_number_or_refuses_it(control: str, statement: str) -> None:
    for edge in EDGES:
        ends(f"O1\n#100=2\n{statement.format(edge)}\nM30\nO2\nM99\n", control)


@pytest.mark.parametrize("number", ["0", "00000000", "1" * 30, "9" * 400, "2147483648", "99999999"])
def test_programs_of_every_number_are_found_or_refused(number: str) -> None:
    for control in NAMES:
        ends(f"O1\nM98 P{number}\nM30\nO{number}\nN{number} M99\n", control)


# ---- edges of arguments ----

WRONG = (ValueError, TypeError, KeyError)
ARGUMENTS = [
    -1, 0, 0.5, 2**31, 2**63, -(2**63) - 1, 10**400, 1e308, math.inf, -math.inf, math.nan, "", "x",
    b"1", [], {}, {1}, object(), True, 1j, "\ud800", "\0", np.float64(2), np.int64(3), [math.nan],
    {1: math.inf}, {100: 1e308}, {-1: 1}, {2**31: 1}, {"X": math.nan}, {1: {"X": 1e308}},
]  # fmt: skip
FIELDS = {
    "setup": [
        "machine", "start", "work_offsets", "length_offsets", "radius_offsets", "tools",
        "reference", "rapid", "limits", "stroke_area", "increment", "nothing",
    ],
    "inputs": ["signals", "clock", "operator", "writes", "skips", "nothing"],
}  # fmt: skip
TEXT = """O1
N10 G0 X1. Y#100 Z[#500]
N20 G43 H1 Z5.
N30 G41 D1 G1 X20. F100
N40 G40 X30.
N50 #101=#1000+#1032+#3001+#3011+#3012
N60 G31 X50. F10
N70 M00
N80 IF[#500 EQ 7]GOTO80
N90 G28 Z0
N100 M30
"""


def with_every_argument() -> Iterator[tuple[str, dict[str, object]]]:
    options = [
        "main", "mode", "start", "variables", "block_skip", "optional_stop", "max_cycles",
        "max_blocks", "max_seconds", "trace", "inputs", "setup", "watch",
    ]  # fmt: skip
    for name, value in itertools.product(options, ARGUMENTS):
        yield name, {name: value}
    for option, names in FIELDS.items():
        for name, value in itertools.product(names, ARGUMENTS):
            yield f"{option}.{name}", {option: {name: value}}
            yield f"{option}.{name}", {option: {name: [value]}}
            yield f"{option}.{name}", {option: {name: {1: value, "X": value, "G54": value}}}


@pytest.mark.parametrize("control", ["fanuc-30i", "gsk-988ta", "mitsubishi-m800", "hnc-21m"])
def test_every_argument_is_taken_or_refused_in_words(control: str) -> None:
    library = cncsub.loads(TEXT, control=control)
    for name, options in with_every_argument():
        said = "taken"
        try:
            run = library.run(**{"max_blocks": 100, **options})  # type: ignore[arg-type]
        except WRONG as error:
            said = str(error)
        else:
            assert all(map(math.isfinite, run.position.values())), options
        assert said, name


@pytest.mark.parametrize(
    ("use", "words"),
    [
        (lambda lib: lib.run(start=999), "N999"),
        (lambda lib: lib.run("O1", start=2**40), "N1099511627776"),
        (lambda lib: lib.run(variables={9_999_999: 1}), "#9999999"),
        (lambda lib: lib.run(variables={1000: 1}), "#1000"),
        (lambda lib: lib.run(max_seconds=10**400), "max_seconds"),
        (lambda lib: lib.control.with_parameters({"6050": math.nan}), "6050"),
        (lambda lib: lib.run(setup={"length_offsets": {100_000: 1}}), "length_offsets"),
        (lambda lib: lib.control.replace(max_nesting=2**64), "18446744073709551616"),
        (lambda lib: lib.control.replace(angle_unit="\ud800"), "ud800"),
    ],
)  # fmt: skip
def test_an_argument_that_names_nothing_is_refused(
    use: Callable[[cncsub.Library], object], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        use(cncsub.loads(TEXT, control="fanuc-0i-f"))


def test_an_offset_above_those_of_the_control_has_no_wear() -> None:
    library = cncsub.loads("O1\nG43 H9999 Z1.\nG41 D9999 G1 X9. F9\nM30\n", control="fanuc-0i-f")
    run = library.run(setup={"length_offsets": {9999: 5}, "radius_offsets": {9999: 1}})
    assert run.stop is cncsub.Stop.END
    assert run.moves.mz[0] == 6.0


@pytest.mark.parametrize("control", ["fanuc-30i", "gsk-988ta", "mitsubishi-meldas", "hnc-21m"])
def test_every_rule_may_be_set_to_its_edges(control: str) -> None:
    known = cncsub.controls[control]
    text = TEXT + "O2\nM98 P2 L2\nWHILE[#1LT3]DO1\n#1=#1+[[1]]\nEND1\nM99\n"
    for rule in known.rules:
        edges = rule.choices or {
            bool: (True, False), int: (0, 1, 999_999_999), str: ("", "=")
        }[type(rule.value)]  # fmt: skip
        for edge in edges:
            changed = known.replace(**{rule.name: edge})
            library = cncsub.loads(text, control=changed)
            for main in library:
                library.run(main, max_blocks=100, max_seconds=1)


def test_every_parameter_takes_every_value_or_refuses_it() -> None:
    for control in NAMES:
        known = cncsub.controls[control]
        for name, value in itertools.product(known.parameters, VALUES[:-1]):
            try:
                changed = known.with_parameters({name: value})
            except ValueError:
                assert value not in (0, 1) if "#" in name else abs(value) > 999_999_999
                continue
            cncsub.loads("O1\nG0 X1.\nG65 P1\nM30\n", control=changed).run(max_blocks=20)


MOST_KEPT = 110  # bytes of memory for each byte of text, for the worst text there is
SHORT_LINES = ["M98", "O1", "G65", "M99", "#", "X", "[", "G", "O{i}", "M98P1", "#1=", "N1X", "%{i}"]
READ = """
import resource, sys, cncsub
text = "".join(sys.argv[1].format(i=i) + "\\n" for i in range(200_000))
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
library = cncsub.loads(text, control=sys.argv[2])
print((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024 / len(text))
"""


@pytest.mark.skipif(SANITIZED, reason="a sanitizer keeps memory of its own")
@pytest.mark.parametrize("line", SHORT_LINES)
def test_reading_keeps_no_more_than_a_hundred_times_the_text(line: str) -> None:
    for control in ("fanuc-0i-f", "gsk-928te"):
        done = subprocess.run(
            [sys.executable, "-c", READ, line, control], capture_output=True, text=True, check=True
        )
        assert float(done.stdout) < MOST_KEPT
