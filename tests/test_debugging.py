"""Breakpoints, watched expressions, the next block, the way back, and what can be set by name."""

from __future__ import annotations

import threading
from typing import Any

import pytest

import cncsub

CONTROL = "fanuc-0i-f"
LOOP = "O1\nN10 #1=0\nN20 WHILE[#1 LT {}]DO1\nN30 #1=#1+1\nN40 #100=#1*2\nN50 END1\nN60 M30\n"
JOB = """O1
N10 T5 M6
N20 G90 G54 G0 X10. Y0
N30 G65 P2 A3.
N40 G91 G1 Z-8. F100
N50 M3 S500
N60 M98 P3 L2
N70 M30
O2
N100 #100=#1
N110 #1=#1-1
N120 IF[#1 GT 0]GOTO110
N130 #100=0
N140 M99
O3
N200 X1.
N210 M99
"""


@pytest.fixture
def machine() -> cncsub.Machine:
    return cncsub.loads({"job.nc": JOB}, control=CONTROL).machine()


def at(machine: cncsub.Machine) -> int | None:
    """Return the sequence number of the block before which the machine stands."""
    following = machine.next
    return None if following is None else following.n


def stops(machine: cncsub.Machine, until: Any) -> list[int | None]:
    """Return the sequence numbers of the blocks before which the machine stops."""
    seen = []
    while machine.run(until=until) is None:
        seen.append(at(machine))
    return seen


@pytest.mark.parametrize(
    ("until", "before"),
    [
        ("O2:N110", [110, 110, 110]),
        (("O2", 110), [110, 110, 110]),
        ("job.nc:10", [100]),
        ("O1:4", [30]),
        ("O3:16", [200, 200]),
        ("call", [100, 200]),
        ("call O3", [200]),
        ("return", [40, 70]),
        ("return O2", [40]),
        ("M6", [20]),
        ("M", [20, 60]),
        ("T5", [20]),
        ("T4", []),
        ("S500", [60]),
        ("changes #100", [110, 140]),
        ("passes Z -5", [50]),
        ("passes Z -8", [50]),
        ("passes Z 1", []),
        ("mode distance", [50]),
        ("mode F", [50]),
        (["M6", "O3:N200"], [20, 200, 200]),
        (cncsub.Breakpoint("O2:N110", when="#1 EQ 2"), [110]),
        (cncsub.Breakpoint("O2:N110", when="#1 LT 2"), [110]),
        (cncsub.Breakpoint("O2:N110", hits=3), [110]),
        (cncsub.Breakpoint("changes #100", when="#100 EQ 0"), [140]),
        (cncsub.Breakpoint("call", when="#1 EQ 3"), [100]),
    ],
)
def test_a_machine_stops_at_breakpoints(
    machine: cncsub.Machine, until: Any, before: list[int | None]
) -> None:
    assert stops(machine, until) == before
    assert machine.reached == ()


def test_a_cycle_that_is_a_program_of_the_control_is_called_and_left() -> None:
    text = "N10 G0 X5 Z10 F100\nN20 CYCLE81(10,0,2,-5)\nN30 M30\n"
    machine = cncsub.loads({"A.MPF": text}, control="siemens-one").machine()
    assert machine.run(until="call CYCLE81") is None
    assert [frame.called for frame in machine.stack] == ["CYCLE81"]
    assert machine.run(until="return CYCLE81") is None
    assert at(machine) == 30
    with pytest.raises(KeyError, match="no program CYCLE81"):
        machine.run(until="CYCLE81:N10")


def test_reached_names_the_breakpoints_that_were_met(machine: cncsub.Machine) -> None:
    given = [cncsub.Breakpoint("M6"), cncsub.Breakpoint("T"), "O1:N70"]
    assert machine.run(until=given) is None
    assert machine.reached == (given[0], given[1])
    assert machine.run(until=given) is None
    assert [each.at for each in machine.reached] == ["O1:N70"]


@pytest.mark.parametrize("name", ["alarm", "alarm PS0076", "alarm program-not-found"])
def test_an_alarm_is_a_breakpoint(name: str) -> None:
    machine = cncsub.loads("O1\nN10 M98 P9\n", control=CONTROL).machine()
    assert machine.run(until=name) is not None
    assert [each.at for each in machine.reached] == [name]


def test_locals_are_watched_at_the_level_where_the_machine_stood() -> None:
    text = "O1\nN10 #1=5\nN20 G65 P2 A7.\nN30 #1=6\nN40 M30\nO2\nN50 #1=8\nN60 M99\n"
    machine = cncsub.loads(text, control=CONTROL).machine()
    assert stops(machine, "changes #1") == [20, 40]
    machine = cncsub.loads(text, control=CONTROL).machine()
    machine.run(until="call")
    assert stops(machine, "changes #1") == [60]


@pytest.mark.parametrize(
    ("control", "text", "condition", "n"),
    [
        ("siemens-one", {"A.MPF": "DEF INT DEPTH\nN10 DEPTH=DEPTH+1\nN20 IF DEPTH<9\nN30 R1=5\n"
          "N40 ENDIF\nN50 M30\nN60 M30\n"}, "DEPTH==1", 20),
        ("siemens-one", {"A.MPF": "N10 R1=R1+1\nN20 R2=R1\nN50 M30\n"}, "(R1>0) AND (R2==0)", 20),
        ("linuxcnc", "#<depth>=1\n#<depth>=2\nN20 G0 X1\nM2\n", "#<depth> gt 1", 20),
        ("haas-ngc", "O1\nN10 #100=1\nN20 G0 X1.\nN30 M30\n", "[#100 EQ 1] AND [#101 EQ #0]", 20),
    ],
)  # fmt: skip
def test_conditions_are_in_the_language_of_the_control(
    control: str, text: Any, condition: str, n: int
) -> None:
    machine = cncsub.loads(text, control=control).machine()
    name = machine.next.program.name  # type: ignore[union-attr]
    assert machine.run(until=cncsub.Breakpoint((name, n), when=condition)) is None
    assert at(machine) == n


def test_conditions_that_are_none_are_refused_with_their_place(machine: cncsub.Machine) -> None:
    with pytest.raises(
        ValueError, match=r"when: .* on fanuc-0i-f\n  #1 GTT 3\n     \^\^\^"
    ) as error:
        machine.run(until=cncsub.Breakpoint("O2:N110", when="#1 GTT 3"))
    assert machine.blocks == 0
    with pytest.raises(ValueError, match="changes: "):
        machine.run(until="changes #100 #101")
    for text in ("DEPTH>1", '"a"<<DEPTH', "R1+", ""):
        of_siemens = cncsub.loads("N10 M30\n", control="siemens-one").machine()
        with pytest.raises(ValueError, match="evaluate: "):
            of_siemens.evaluate(text)
    named = cncsub.loads("G0 X1\nM2\n", control="linuxcnc").machine()
    with pytest.raises(ValueError, match="#<nobody> has no value"):
        named.evaluate("#<nobody>")
    assert named.evaluate("exists[#<nobody>]") == 0
    for value in ("nan", "inf", "-inf", "1e999"):
        with pytest.raises(ValueError, match=f"'passes Z {value}' must name an axis"):
            machine.run(until=f"passes Z {value}")
    error.match("T is not a function")


def test_texts_and_frames_are_evaluated_and_watched() -> None:
    text = 'DEF STRING[9] NAME="A"\nN10 $P_UIFR[1]=CTRANS(X,10,Y,2.5):CROT(Z,30)\nN20 NAME="B"<<1\nN30 M30\n'
    machine = cncsub.loads(text, control="siemens-one").machine()
    assert machine.run(until="changes $P_UIFR[1]") is None
    assert at(machine) == 20
    assert machine.evaluate("$P_UIFR[1]") == "CTRANS(X,10,Y,2.5):CROT(Z,30)"
    assert machine.evaluate("$P_UIFR[2]") == "CTRANS()"
    assert machine.evaluate("$P_UIFR[1]:CTRANS(X,1)") != machine.evaluate("$P_UIFR[1]")
    assert machine.evaluate('"a"<<"b"') == "ab"
    assert machine.run(until="changes NAME") is None
    assert (at(machine), machine.evaluate("NAME")) == (30, "B1")
    machine.back("changes NAME")
    assert machine.evaluate('NAME=="A"') == 1
    assert machine.evaluate('NAME=="B"') == 0
    for text in ("NAME", "$P_UIFR[1]", '"X"'):
        with pytest.raises(ValueError, match="when: a condition is a number"):
            machine.run(until=cncsub.Breakpoint("MAIN:N30", when=text))


def test_a_text_that_the_run_made_equals_one_that_stands_in_no_program() -> None:
    text = 'DEF STRING[9] NAME="A"\nN10 NAME=NAME<<"B"\nN20 NAME=NAME<<"C"\nN30 M30\n'
    machine = cncsub.loads(text, control="siemens-one").machine()
    assert machine.run(until=cncsub.Breakpoint("MAIN:N30", when='NAME=="ABC"')) is None
    machine.back(0)
    assert machine.run(until='changes NAME=="AB"') is None
    assert at(machine) == 20


def test_a_variable_gets_its_first_value() -> None:
    text = "#1=1\n#<first>=2\n#<_all>=[#<first>+1]\nN40 G0 X#<_all>\nM2\n"
    machine = cncsub.loads(text, control="linuxcnc").machine()
    told = []
    while machine.run(until=["changes #<first>", "changes #<_all>", "changes #<nobody>"]) is None:
        told.append((machine.reached[0].at, machine.next.line))  # type: ignore[union-attr]
    assert told == [("changes #<first>", 3), ("changes #<_all>", 4)]


def test_a_condition_without_a_value_stops_before_its_block() -> None:
    machine = cncsub.loads(LOOP.format(9), control=CONTROL).machine()
    with pytest.raises(ValueError, match="has no value at <Machine: running, next block O1 N50"):
        machine.run(until=cncsub.Breakpoint("O1:N50", when="10/[#1-3] GT 9"))
    assert machine.variables[1] == 3
    assert machine.alarm is None
    assert machine.stop is None
    finished = machine.run()
    assert finished is not None
    assert finished.stop == "end"


@pytest.mark.parametrize("trace", ["none", "calls", "blocks", "moves"])
def test_moves_inside_a_cycle_pass_a_value_whatever_is_recorded(trace: str) -> None:
    text = "O1\nN10 G90 G0 Z5.\nN20 G81 X10. Z-8. R2. F100\nN30 G80 Z20.\nN40 M30\n"
    machine = cncsub.loads(text, control=CONTROL).machine(trace=trace)
    assert stops(machine, "passes Z -5") == [30]
    assert len(machine.moves) == (6 if trace == "moves" else 0)
    machine.back("passes Z -5")
    assert at(machine) == 20


def test_another_thread_pauses_a_run() -> None:
    machine = cncsub.loads("O1\nN10 #1=1\nN20 GOTO10\n", control=CONTROL).machine(
        max_blocks=10**15, trace="none"
    )
    for until in (None, -1, "M6"):
        timer = threading.Timer(0.05, machine.pause)
        timer.start()
        before = machine.blocks
        assert machine.run(until=until) is None
        timer.join()
        assert machine.stop == "interrupted"
        assert machine.reached == ()
        assert machine.blocks > before
    machine.pause()  # no run is under way: the next one is meant
    assert machine.run() is None
    assert machine.run(until="O1:N10") is None
    assert machine.stop is None
    assert at(machine) == 10


def test_modes_are_named_as_the_machine_shows_them(machine: cncsub.Machine) -> None:
    machine.run(until="O1:N70")
    for name in machine.modal:
        assert machine.run(until=["O1:N70", f"mode {name}"]) is not None
        machine.back("O1:N70")


def test_evaluating_changes_nothing() -> None:
    text = "O1\nN10 G65 P2 A1.\nN20 M30\nO2\nN30 #100=#3001\nN40 #101=#3001\nN50 M99\n"
    library = cncsub.loads(text, control=CONTROL)
    one, other = library.machine(), library.machine()
    for _ in other:
        one.step()
        assert one.evaluate("#3001+1/3") is not None
        with pytest.raises(ValueError, match="the divisor is 0"):
            one.evaluate("1/#0")
    assert dict(one.variables) == dict(other.variables)
    assert list(one.calls) == list(other.calls)


@pytest.mark.parametrize(
    ("wrong", "kind", "cure"),
    [
        ("O9:N1", KeyError, "no program O9 in the memory; did you mean"),
        ("O2:N7", KeyError, "no block N7 in O2; near it are N100, N110, N120"),
        ("job.nc:99", KeyError, "no block on line 99 of job.nc; the nearest have lines 17"),
        ("O3:4", KeyError, "line 4 of job.nc lies in O1, not in O3: give O1:4, or job.nc:4"),
        ("jib.nc:1", KeyError, "no file and no program jib.nc; did you mean job.nc"),
        ("O2", ValueError, "'O2' is no breakpoint: it must be such as 'O2:N30'"),
        ("call O8", KeyError, "no program O8"),
        ("alarm 9999", ValueError, "fanuc-0i-f has no alarm 9999"),
        ("mode dist", ValueError, "no mode is called 'dist'; there are motion, plane, distance"),
        ("passes Q 1", ValueError, "must name an axis and a value in mm"),
        ("passes X", ValueError, "must name an axis and a value in mm"),
        (("O2", 2**70), KeyError, "no block N"),
    ],
)
def test_a_wrong_place_is_refused_by_name(
    machine: cncsub.Machine, wrong: Any, kind: type[Exception], cure: str
) -> None:
    with pytest.raises(kind, match=cure.replace("(", r"\(")):
        machine.run(until=wrong)
    assert machine.blocks == 0


def test_a_parameter_by_reference_changes_as_long_as_its_program_is_open() -> None:
    text = (
        "%_N_MAIN_MPF\nDEF REAL WIDE=1\nN10 PART(WIDE)\nN20 WIDE=7\nN30 M30\n"
        "%_N_PART_SPF\nPROC PART(VAR REAL WID)\nN50 R1=1\nN60 WID=WID+1\nN70 M17\n"
    )
    machine = cncsub.loads(text, control="siemens-one").machine()
    machine.run(until="PART:N50")
    machine.run(until="changes WID")
    assert at(machine) == 70
    machine.run(until="changes WID")  # the return and N20 change nothing that WID names here
    assert machine.next is None


@pytest.mark.parametrize("expression", [None, 5, True, [], b"1"])
def test_what_is_no_text_is_no_expression(machine: cncsub.Machine, expression: object) -> None:
    with pytest.raises(TypeError, match="an expression is a text"):
        machine.evaluate(expression)  # type: ignore[arg-type]


@pytest.mark.parametrize("hits", [0, -1, 10**30])
def test_a_breakpoint_counts_from_one(hits: int) -> None:
    with pytest.raises(ValueError, match="hits must be 1 to"):
        cncsub.Breakpoint("M6", hits=hits)


def test_a_breakpoint_has_a_whole_count_and_an_expression() -> None:
    with pytest.raises(TypeError, match="hits must be a whole number"):
        cncsub.Breakpoint("M6", hits=True)
    with pytest.raises(TypeError, match="when must be an expression"):
        cncsub.Breakpoint("M6", when=3)  # type: ignore[arg-type]


def test_next_passes_over_skipped_blocks_and_ends() -> None:
    text = "O1\n/N10 G0 X1.\nN20 M98 P2\nN30 M30\nO2\nN40 X2.\n"
    machine = cncsub.loads(text, control=CONTROL).machine(block_skip=[1])
    seen = []
    while machine.stop is None:
        seen.append(at(machine))
        machine.step()
    assert seen == [20, 40, None]
    alarmed = cncsub.loads("O1\nN10 M98 P9\n", control=CONTROL).machine()
    alarmed.run()
    assert at(alarmed) == 10


# ---- the way back ----


def test_back_goes_where_it_is_told(machine: cncsub.Machine) -> None:
    machine.run(until="O2:N130")
    places: list[tuple[int | None, float | None]] = []
    for to in (None, "#1", "call", "M6", 0):
        machine.back(to)
        places.append((at(machine), machine.variables[100]))
    assert places == [(120, 3.0), (110, 3.0), (30, None), (10, None), (10, None)]


def test_back_to_a_place_is_the_last_time_before_it() -> None:
    machine = cncsub.loads(LOOP.format(9), control=CONTROL).machine()
    machine.run()
    machine.back("O1:N40")
    assert machine.variables[1] == 9
    machine.back("O1:N40")
    assert machine.variables[1] == 8
    machine.back(cncsub.Breakpoint("O1:N40", when="#1 EQ 3"))
    assert machine.variables[1] == 3
    machine.back("#100")
    assert (at(machine), machine.variables[100]) == (40, 2.0)
    machine.back("O1:N10")
    assert machine.blocks == 0


def test_where_there_is_nothing_to_go_back_to_the_machine_stays(machine: cncsub.Machine) -> None:
    with pytest.raises(ValueError, match="at the head of the program"):
        machine.back()
    machine.step()
    for to, why in (
        ("call", "no call is open"),
        ("#100", "'changes #100' was not met in the 1 blocks before"),
        (2, "the steps behind are 0 to 1, not 2"),
        (-1, "the steps behind are 0 to 1, not -1"),
    ):
        with pytest.raises(ValueError, match=why):
            machine.back(to)
    assert machine.blocks == 1


@pytest.mark.parametrize(
    "to",
    [
        "alarm PS0076",
        "alarm",
        cncsub.Breakpoint("alarm"),
        ["alarm"],
        ["O1:N10", "alarm program-not-found"],
        cncsub.Breakpoint("alarm", when="#100 EQ 9"),
    ],
)
def test_an_alarm_is_gone_where_the_machine_goes_back(to: Any) -> None:
    text = "O1\nN10 #100=9\nN20 M98 P#100\nN30 M30\nO2\nN40 M99\n"
    machine = cncsub.loads(text, control=CONTROL).machine()
    machine.run()
    assert machine.alarm is not None
    with pytest.raises(ValueError, match="'alarm PS0077' was not met in the 1 blocks before"):
        machine.back("alarm PS0077")
    machine.back(to)
    assert machine.alarm is None
    assert machine.next is not None
    assert machine.next.n == 20
    with pytest.raises(ValueError, match="'alarm' was not met"):
        machine.back("alarm")
    machine.variables[100] = 2
    finished = machine.run()
    assert finished is not None
    assert finished.stop == "end"


@pytest.mark.parametrize("passes", [5_000, 700_000])
def test_long_runs_go_back_anywhere(passes: int) -> None:
    """Snapshots are kept at growing distances, and what lies between them runs again."""
    library = cncsub.loads(LOOP.format(passes), control=CONTROL)
    machine = library.machine()
    machine.run()
    end = machine.blocks
    for share in (0.999, 0.75, 0.501, 0.25, 0.01):
        to = int(end * share)
        fresh = library.machine(max_blocks=to)
        fresh.run()
        for step in (to, to - 1, to - 2):
            machine.back(step)
            assert machine.blocks == step
        machine.step()
        machine.step()
        assert machine.variables[1] == fresh.variables[1]
        assert machine.variables[100] == fresh.variables[100]
        assert len(machine.steps) == to
        assert machine.steps[-1] == fresh.steps[-1]
        count, size = machine.core.snapshots
        assert count <= 256
        assert size < 64 << 20
    for _ in range(100):
        machine.back()


def test_edits_on_the_way_come_again() -> None:
    machine = cncsub.loads(LOOP.format(20_000), control=CONTROL).machine()
    machine.run(until=cncsub.Breakpoint("O1:N40", hits=9_000))
    edited = machine.blocks
    machine.variables[1] = 15_000
    machine.run(until=cncsub.Breakpoint("O1:N40", hits=1_000))
    here = machine.blocks, machine.variables[1]
    machine.run(until=cncsub.Breakpoint("O1:N40", hits=3_000))
    machine.back(here[0])
    assert (machine.blocks, machine.variables[1]) == here == (machine.blocks, 16_000)
    machine.back(edited)
    assert machine.variables[1] == 15_000
    machine.back()
    machine.step()
    assert machine.variables[1] == 9_000


def test_a_copy_goes_back_on_its_own() -> None:
    machine = cncsub.loads(LOOP.format(100), control=CONTROL).machine()
    machine.run()
    twin = machine.copy()
    twin.back(10)
    assert machine.stop == "end"
    assert twin.blocks == 10
    machine.back("#100")
    assert machine.next is not None
    assert machine.next.n == 40


# ---- what can be set by name ----


def test_a_name_that_cannot_be_set_is_refused_with_those_that_can(machine: cncsub.Machine) -> None:
    for name in ("next", "reached", "stop", "alarm", "blocks", "breakpoints", "variables"):
        with pytest.raises(
            AttributeError, match=f"'{name}' of a machine cannot be set.*; what can"
        ):
            setattr(machine, name, 5)
    with pytest.raises(AttributeError, match="block_skip, optional_stop, and the values of"):
        machine.next = 5  # type: ignore[misc,assignment]


def test_modes_are_set_as_the_control_reads_them(machine: cncsub.Machine) -> None:
    machine.run(until="O1:N40")
    modes = machine.modal
    modes["work"] = "G55"
    modes["distance"] = "G91"
    modes["F"] = 250
    assert (modes["work"], machine.modal["distance"], machine.modal["F"]) == ("G55", "G91", "250")
    for mode, code in (
        ("distance", "G55"), ("distance", "G91 X5."), ("plane", "G1"), ("F", "1 X2"),
        ("distance", "GOTO10"), ("distance", ""), ("work", "G54\nG55"), ("motion", "M3"),
    ):  # fmt: skip
        before = dict(machine.modal)
        with pytest.raises(ValueError, match="it does not set the mode"):
            machine.modal[mode] = code
        assert dict(machine.modal) == before
    with pytest.raises(KeyError, match="there is no 'distances' to be set; did you mean distance"):
        machine.modal["distances"] = "G91"
    with pytest.raises(TypeError, match="must be a code such as 'G91'"):
        machine.modal["distance"] = 91
    with pytest.raises(TypeError, match="cannot be taken out"):
        del machine.modal["distance"]
    modes["length"] = "G43 H2"
    assert (machine.modal["length"], machine.modal["H"]) == ("G43", "2")
    other = cncsub.loads("G0 X1\nM2\n", control="linuxcnc").machine()
    with pytest.raises(ValueError, match=r"H word with no G43.*modal\['length'\] = 'G43 H1'"):
        other.modal["H"] = 1


# ---- where the tool stands ----

SQUARE = """O1
N10 G90 G54 G0 X10. Y0 Z5.
N20 G1 X20. F100
N30 Y10.
N40 G91 X5.
N50 M30
"""
OFFSETS = {
    "work_offsets": {"G54": {"X": 100.125, "Y": -50, "Z": 7}},
    "length_offsets": {1: 33.5},
    "limits": {"X": (0, 500)},
}


def test_a_tool_that_is_set_elsewhere_goes_on_from_there() -> None:
    machine = cncsub.loads(SQUARE, control=CONTROL).machine(setup=OFFSETS)
    machine.run(until="O1:N30")
    machine.position["X"] = 50
    machine.machine_position["Y"] = -47
    assert machine.position == {"X": 50, "Y": 3, "Z": 5}
    assert machine.machine_position == {"X": 150.125, "Y": -47, "Z": 12}
    assert len(machine.moves) == 2
    machine.step()
    move = machine.moves[2]
    assert (move.sx, move.sy, move.msx, move.msy) == (50, 3, 150.125, -47)
    assert (move.x, move.y, move.length) == (50, 10, 7)
    assert list(machine.moves.length) == [
        pytest.approx(n) for n in (machine.moves[0].length, 10, 7)
    ]
    machine.step()
    assert machine.position["X"] == 55
    assert machine.moves.total_length == pytest.approx(machine.moves[0].length + 10 + 7 + 5)
    assert machine.core.trace.time == pytest.approx(machine.moves.time.sum())


def test_a_set_place_is_forgotten_and_set_again_on_the_way_back() -> None:
    machine = cncsub.loads(SQUARE, control=CONTROL).machine(setup=OFFSETS)
    machine.position["X"] = 4  # before the first move
    machine.step()
    assert machine.moves[0].sx == 4
    machine.run(until="O1:N40")
    machine.position["X"] = -3
    machine.run()
    whole = [move.length for move in machine.moves]
    machine.back(3)
    assert machine.position["X"] == -3
    machine.run()
    assert [move.length for move in machine.moves] == whole
    machine.back(2)
    assert machine.position["X"] == 20
    machine.run()
    assert machine.position["X"] == 25
    machine.back(0)
    assert machine.position["X"] == 4
    machine.run()
    assert machine.moves[0].sx == 4


def test_a_place_is_set_where_rows_are_forgotten_and_on_other_axes() -> None:
    text = "O1\nN10 G0 X1. Z5.\nN20 G2 X5. Y0 I2. F100\nN30 G0 A90.\nN40 #1=#99999\nN50 M30\n"
    machine = cncsub.loads(text, control=CONTROL).machine()
    machine.run(until="O1:N20")
    machine.position["X"] = -8  # the end of the arc is not on its circle
    machine.position["Z"] = -1
    machine.position["X"] = 1  # what is set last counts
    machine.step()
    assert (machine.moves[1].sx, machine.moves[1].sz) == (1, -1)
    assert machine.moves.bounds["Y"] == pytest.approx((0, 2))
    machine.step()
    machine.position["A"] = 270
    machine.mdi("G91 A10.")
    assert machine.position["A"] == 280
    assert machine.moves[-1].a == 280


def test_a_place_that_cannot_be_is_refused_with_the_reason() -> None:
    machine = cncsub.loads(SQUARE, control=CONTROL).machine(setup=OFFSETS)
    machine.run(until="O1:N30")
    before = dict(machine.position)
    for name, value, error, words in (
        ("Q", 1, KeyError, "there is no 'Q' to be set"),
        ("B", 1, KeyError, "there is no 'B' to be set"),
        ("X", "far", TypeError, r"position\['X'\] must be a number"),
        ("X", None, TypeError, r"position\['X'\] must be a number"),
        ("X", float("nan"), ValueError, "out of range"),
        ("X", 1e9, ValueError, "out of range"),
        ("X", 450, ValueError, r"position\['X'\] = 450: X would go to 550.125"),
    ):
        with pytest.raises(error, match=words):  # type: ignore[call-overload]
            machine.position[name] = value
    with pytest.raises(ValueError, match=r"machine_position\['X'\] = -1: X would go to -1"):
        machine.machine_position["X"] = -1
    with pytest.raises(TypeError, match="cannot be taken out"):
        del machine.position["X"]
    with pytest.raises(AttributeError, match="'position' of a machine cannot be set"):
        machine.position = {"X": 1}  # type: ignore[misc,assignment]
    assert machine.position == before
    machine.mdi("G41 D1 Y5.")
    with pytest.raises(ValueError, match="a move waits for the one after it, or the radius"):
        machine.position["X"] = 1


def test_a_place_in_turned_work_coordinates_is_that_of_the_work() -> None:
    text = "G10 L2 P1 X10 R90\nG54 G0 X1 Y2\nG1 X5 F100\nM2\n"
    machine = cncsub.loads(text, control="linuxcnc").machine()
    for _ in range(2):
        machine.step()
    machine.position["X"] = 3
    with pytest.raises(ValueError, match="turned"):
        machine.machine_position["X"] = 3
    machine.step()
    move = machine.moves[1]
    assert (move.length, move.sx, move.msx, move.msy) == pytest.approx((2, 3, 8, 3))


def test_what_was_set_is_set_again_on_the_way_back(machine: cncsub.Machine) -> None:
    machine.run(until="O1:N40")
    at = machine.blocks
    machine.modal["work"] = "G55"
    machine.block_skip = (2,)
    machine.optional_stop = True
    machine.run(until="O1:N70")
    machine.back(at)
    assert (machine.modal["work"], machine.block_skip, machine.optional_stop) == ("G55", (2,), True)
    machine.back()
    assert (machine.modal["work"], machine.block_skip, machine.optional_stop) == ("G54", (), False)


def test_a_skip_switch_holds_from_where_it_is_set() -> None:
    machine = cncsub.loads("O1\n/N10 X1.\n/N20 X2.\nN30 M30\n", control=CONTROL).machine()
    machine.step()
    machine.block_skip = True
    assert machine.next is not None
    assert machine.next.n == 30
    with pytest.raises(ValueError, match="must be 1 to 10"):
        machine.block_skip = (11,)
    with pytest.raises(TypeError, match="optional_stop must be True or False"):
        machine.optional_stop = 1  # type: ignore[assignment]


def test_named_variables_are_set_by_their_type() -> None:
    text = 'DEF INT SIDES[2]=SET(3,4)\nDEF REAL DEPTH=5\nDEF STRING[8] NAME="A"\nDEF BOOL ON\nM30\n'
    machine = cncsub.loads(text, control="siemens-one").machine()
    machine.run(until="mode")
    machine.back(4)
    named = machine.variables.named
    named["DEPTH"], named["NAME"], named["ON"], named["SIDES"] = 2.5, "HOLE", True, [7, 8]
    assert machine.variables.named == {"SIDES": [7, 8], "DEPTH": 2.5, "NAME": "HOLE", "ON": True}
    for name, value in (
        ("SIDES", [1.5, 2]), ("SIDES", [1]), ("DEPTH", "deep"), ("NAME", 3), ("SIDES", 2),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=f"named\\['{name}'\\]"):
            machine.variables.named[name] = value
    with pytest.raises(KeyError, match="there is no 'DEPHT' to be set; did you mean DEPTH"):
        machine.variables.named["DEPHT"] = 3
    with pytest.raises(TypeError, match="set the whole variable"):
        machine.variables.named["SIDES"][0] = 3
    machine.back(3)
    machine.step()
    assert machine.variables.named["DEPTH"] == 5


def test_another_thread_sees_the_code_while_conditions_are_evaluated() -> None:
    """A condition is evaluated with a code of its own; nobody else may see that."""
    machine = cncsub.loads(LOOP.format(400_000), control=CONTROL).machine()
    until = cncsub.Breakpoint("O1:N40", when="#1 GT 399999")
    worker = threading.Thread(target=machine.run, args=(until,))
    code = machine.core.code
    worker.start()
    while worker.is_alive():
        assert machine.core.code is code
    assert machine.variables[1] == 400_000


def test_arrays_by_reference_and_characters_are_set_and_what_is_no_number_is_refused() -> None:
    text = {
        "A.MPF": "DEF INT ONE=3\nDEF INT WHOLE[3]\nDEF CHAR SIGN\nDEF REAL QUOTA\nN10 SUB(WHOLE,ONE)\nN30 M30\n",
        "SUB.SPF": "PROC SUB(VAR INT VALS[], VAR INT BACK)\nN50 R1=VALS[1]+BACK\nM17\n",
    }
    machine = cncsub.loads(text, control="siemens-one").machine()
    machine.run(until="SUB:N50")
    named = machine.variables.named
    named["VALS"] = [4, 5, 6]
    named["BACK"] = 7
    machine.step()
    assert machine.evaluate("R1") == 12
    with pytest.raises(ValueError, match="VALS holds 3 values, not 2"):
        named["VALS"] = [1, 2]
    machine.run(until="A:N30")
    named = machine.variables.named
    assert named["WHOLE"] == [4, 5, 6]
    named["SIGN"] = "B"
    assert machine.variables.named["SIGN"] == 66
    for name, wrong in (
        ("SIGN", "BC"),
        ("QUOTA", float("nan")),
        ("QUOTA", float("inf")),
        ("ONE", 2.5),
    ):
        with pytest.raises(ValueError, match=f"a value is none of the type of {name}"):
            named[name] = wrong


def test_a_line_of_a_file_is_not_that_of_a_file_of_the_same_name_in_a_folder() -> None:
    files = {"row.nc": "O1\nN10 M98 P2\nN20 M30\n", "sub/row.nc": "O2\nN30 X1.\nN40 M99\n"}
    machine = cncsub.loads(files, control="fanuc-0i-f").machine()
    assert machine.run(until="row.nc:3") is None
    assert machine.next is not None
    assert machine.next.n == 20
    machine.back(0)
    assert machine.run(until="sub/row.nc:3") is None
    assert machine.next.n == 40


def test_what_is_no_variable_by_number_says_where_it_is() -> None:
    text = 'DEF REAL PITCH\nDEF STRING[9] LABEL="A"\nM30\n'
    machine = cncsub.loads(text, control="siemens-one").machine()
    for _ in range(2):
        machine.step()
    with pytest.raises(KeyError, match=r"give variables\.named\['PITCH'\]"):
        machine.variables["pitch"]
    with pytest.raises(KeyError, match=r"give variables\.named\['PITCH'\]"):
        machine.variables["PITCH"] = 1
    for number in (-1, 10**12, 2**70):
        with pytest.raises(KeyError, match="there is no "):
            machine.variables[number] = 1
    with pytest.raises(KeyError, match="there is no 'Q' to be set; there are X, Y, Z"):
        machine.position["Q"] = 1
    with pytest.raises(TypeError, match=r"named\['LABEL'\] must be a number or a text, not None"):
        machine.variables.named["LABEL"] = None
    with pytest.raises(ValueError, match=r"named\['PITCH'\] must be a number of 64 bits"):
        machine.variables.named["PITCH"] = 10**400


def test_a_wrong_place_to_go_back_to_is_refused_by_its_name(machine: cncsub.Machine) -> None:
    machine.run()
    with pytest.raises(TypeError, match="to must be a Block"):
        machine.back(1.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="to names no place"):
        machine.back([])  # type: ignore[arg-type]
