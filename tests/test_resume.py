"""A run that is started again in the middle: the state there, and a restart program that does what
the whole run does from there on.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
import restart_programs
from cncsub.cli import app
from cncsub.resume.data import can_be_read
from cncsub.resume.proof import Part, parting
from conformance import rows

CONTROL = "fanuc-0i-f"
JOB = """O1
N10 T5 M6
N20 G90 G54 G0 X10. Y0
N25 G43 H1 Z50.
N30 S2000 M3
N35 M8
N40 M98 P2 L3
N50 G65 P3 A3. B#100
N70 M30
O2
N100 G91 X10.
N110 G90 G1 Z-5. F200
N120 G0 Z50.
N125 #100=#100+1
N130 M99
O3
N200 #1=#1-1
N210 G0 X[#1*10]
N220 WHILE[#1 GT 0]DO1
N230 #1=#1-1
N240 G1 Z-#1
N250 END1
N260 M99
"""


HOME = {"start": {"X": 0.0, "Y": 0.0, "Z": 0.0}}


@pytest.fixture
def job() -> cncsub.Library:
    return cncsub.loads({"job.nc": JOB}, control=CONTROL)


def again(library: cncsub.Library, resumed: cncsub.Resume) -> cncsub.Run:
    """Run the restart program beside the programs that it calls."""
    for text in resumed.files.values():
        library = library.with_program(text)
    return library.run(next(iter(resumed.files)).removesuffix(".nc"))


def test_the_state_is_that_of_the_run_before_the_block(job: cncsub.Library) -> None:
    state = job.resume(at="O2:N120", times=2).state
    assert (state.block.n, state.step, state.tool, state.spindle) == (120, 13, 5, "M3")
    assert state.coolant == ("M8",)
    assert (state.modal["motion"], state.modal["F"], state.work) == ("G01", "200", "G54")
    assert state.position == {"X": 30.0, "Y": 0.0, "Z": -5.0}
    assert [(f.called, f.repeat, f.repeats) for f in state.stack] == [("O2", 2, 3)]
    assert state.variables == {100: 1.0}
    told = str(state).splitlines()
    assert told[0] == "block     O2 N120, line 13: N120 G0 Z50."
    assert told[1] == "called    O2 from O1 N40 (M98, pass 2 of 3)"


def test_a_restart_program_goes_on_with_calls_and_passes(job: cncsub.Library) -> None:
    resumed = job.resume(at="O2:N120", times=2)
    assert resumed.form == "calls"
    assert resumed.files == {
        "O9001.nc": "O9001\nG21 G17 G94 G40 G80 G90\nG54\n#100=1\nT5 M06\nS2000 M3\nM8\n"
        "G00 G43 H1 Z50.\nG00 X30. Y0.\nG01 Z-5. F200\nM98 P9002\nM98 P2\n"
        "N50 G65 P3 A3. B#100\nN70 M30\n",
        "O9002.nc": "O9002\nN120 G0 Z50.\nN125 #100=#100+1\nN130 M99\n",
    }
    whole, rest = job.run(), again(job, resumed)
    count = len(whole.moves) - resumed.state.moves
    for column in ("x", "y", "z", "mx", "my", "mz", "feed", "length"):
        assert list(rest.moves[column][-count:]) == list(whole.moves[column][-count:])
    assert dict(rest.variables) == dict(whole.variables)


def test_a_loop_is_gone_through_to_its_end_with_the_locals_of_the_macro(
    job: cncsub.Library,
) -> None:
    resumed = job.resume(at="O3:N240", times=1)
    macro = resumed.files["O9002.nc"].splitlines()
    assert macro[:6] == [
        "O9002",
        "#1=1",
        "#2=3",
        "N240 G1 Z-#1",
        "N220 WHILE[#1 GT 0]DO1",
        "N230 #1=#1-1",
    ]
    assert "G65 P9002" in resumed.files["O9001.nc"].splitlines()
    assert dict(again(job, resumed).variables) == dict(job.run().variables)


@pytest.mark.parametrize(
    ("at", "n"),
    [
        ("O1:N10", 10),
        ("T5", 10),
        ("job.nc:5", 30),
        (("O1", 50), 50),
        (0, 20),
        ("X10,Y0,Z50", 25),
        ({"X": 30.0, "Z": 2.0}, 110),
        ("call O3", 200),
        (cncsub.Breakpoint("O2:N110", hits=3), 110),
        (cncsub.Breakpoint("O2:N110", when="#100 EQ 2"), 110),
    ],
)
def test_a_place_is_a_block_a_line_a_move_a_tool_or_the_nearest(
    job: cncsub.Library, at: Any, n: int
) -> None:
    resumed = job.resume(at=at, setup=HOME)
    assert resumed.state.block.n == n
    resumed.verify()


@pytest.mark.parametrize(
    ("at", "times", "kind", "why"),
    [
        ("O1:N99", 1, KeyError, "no block N99 in O1"),
        ("O2:N120", 4, cncsub.ResumeError, "the run does not come to 'O2:N120' 4 times: end"),
        (500, 1, ValueError, "the moves are 0 to"),
        ("A5", 1, ValueError, "the run does not move A"),
        ({"Q": 1}, 1, ValueError, "a place names axes such as X, not 'Q'"),
        ("nowhere", 1, ValueError, "is no breakpoint"),
        ("O1:N10", 0, ValueError, "times must be at least 1"),
        (None, 1, TypeError, "until must be a Block"),
    ],
)
def test_a_wrong_place_is_refused(
    job: cncsub.Library, at: Any, times: int, kind: type[Exception], why: str
) -> None:
    with pytest.raises(kind, match=why):
        job.resume(at=at, times=times)


def test_a_start_inside_radius_compensation_names_the_block_that_begins_it() -> None:
    text = "O1\nN10 G0 X0 Y0\nN20 G41 D1 G1 X5. F100\nN30 Y10.\nN40 X20.\nN50 G40 Y30.\nN60 M30\n"
    library = cncsub.loads(text, control=CONTROL)
    setup = cncsub.Setup(radius_offsets={1: 2.0}, **HOME)
    with pytest.raises(
        cncsub.ResumeError, match="start at O1 N20, which begins it, or at O1 N60, after"
    ) as error:
        library.resume(at="O1:N40", setup=setup)
    assert (error.value.program, error.value.n) == ("O1", 40)
    assert library.resume(at="O1:N20", setup=setup).state.block.n == 20


def test_a_run_that_does_not_end_is_refused() -> None:
    library = cncsub.loads("O1\nN10 G0 X1.\nN20 M98 P9\nN30 M30\n", control=CONTROL)
    with pytest.raises(cncsub.ResumeError, match="the whole run does not end: alarm"):
        library.resume(at="O1:N20")


HEADS: list[tuple[str, str, str, dict[str, Any], list[str]]] = [
    (
        CONTROL,
        "O1\nN10 G20\nN20 G10 L2 P1 X2.\nN30 G91 G0 X1.5\nN40 X1.\nN50 M30\n",
        "O1:N40",
        HOME,
        ["G20 G17 G94 G40 G80 G49 G90", "G54", "#5221=2", "G00 Z0.", "G00 X-0.5 Y0.", "G91"],
    ),
    (
        CONTROL,
        "O1\nN10 G0 Z20.\nN20 G81 X10. Z-5. R2. F100\nN30 R3. X20.\nN40 X30.\nN50 G80\nN60 M30\n",
        "O1:N40",
        HOME,
        ["G21 G17 G94 G40 G80 G49 G90", "G54", "G00 Z20.", "G00 X20. Y0.", "G81 Z-5. R3. F100 K0"],
    ),
    (
        CONTROL,
        "O1\nN10 G0 X5.\nN20 G52 X3.\nN30 G0 X7.\nN40 X8.\nN50 M30\n",
        "O1:N40",
        HOME,
        ["G21 G17 G94 G40 G80 G49 G90", "G54", "G00 Z0.", "G00 X10. Y0.", "G52 X3."],
    ),
    (
        CONTROL,
        "O1\nN10 T0303\nN20 G50 S800\nN30 G96 S150 M3\nN40 G0 X40. Z2.\nN50 G1 X30. F0.2\nN60 M30\n",
        "O1:N50",
        {"machine": "lathe-a"},
        ["T0303", "G50 S800", "G96 S150 M3", "G00 Z2.", "G00 X40."],
    ),
    (
        "siemens-one",
        "N10 G0 X5 Z10\n$P_UIFR[1]=CTRANS(X,2):CROT(Z,90)\nG54\n$P_PFRAME=CTRANS(Y,1)\n"
        "N30 G0 X7\nN40 X8\nN50 M30\n",
        "MAIN:N40",
        HOME,
        [
            "G71 G17 G94 G40 G90",
            "$P_UIFR[1]=CTRANS(X,2):CROT(Z,90)",
            "G54",
            "G00 Z10.",
            "$P_PFRAME=CTRANS(Y,1)",
        ],
    ),
    (
        "linuxcnc",
        "G0 X0 Y0 Z5\nG1 Z-1 F100\nG2 X10 Y10 I10 J0\nF90\nX20 Y0 J-10\nM2\n",
        "MAIN:4",
        HOME,
        ["G00 X10. Y10.", "G01 Z-1. F100", "F90", "G02 X20 Y0 J-10", "M2"],
    ),
    (
        "siemens-one",
        "N10 G0 X5 Z10\nN20 TRANS X3\nN30 G0 X7\nN40 X8\nN50 M30\n",
        "MAIN:N40",
        HOME,
        ["G71 G17 G94 G40 G90", "G54", "G00 Z10.", "TRANS X3", "G00 X7. Y0."],
    ),
]


@pytest.mark.parametrize(("control", "text", "at", "setup", "head"), HEADS)
def test_a_head_puts_in_force_what_the_run_has(
    control: str, text: str, at: str, setup: dict[str, Any], head: list[str]
) -> None:
    resumed = cncsub.loads(text, control=control).resume(at=at, setup=cncsub.Setup(**setup))
    lines = resumed.text.splitlines()
    assert [line for line in lines if line in head] == head
    assert len(lines) - lines.index(head[-1]) <= 5


def test_a_frame_that_a_return_has_restored_is_in_force_by_its_value() -> None:
    job = {
        "A.MPF": "N10 G0 X5 Y0 Z10\nN20 TRANS X3\nASIDE\nN30 G0 X7\nN40 Y2\nN50 M30\n",
        "ASIDE.SPF": "PROC ASIDE SAVE\nROT Z30\nG0 X1\nM17\n",
    }
    resumed = cncsub.loads(job, control="siemens-one").resume(at="A:N40", setup=HOME)
    lines = resumed.text.splitlines()
    assert "$P_PFRAME=CTRANS(X,3)" in lines
    assert not [line for line in lines if line.startswith("ROT")]


def test_numbers_of_32_bits_are_written_as_the_control_reads_them() -> None:
    text = "o100 sub\nG1 X#1 F100\nY[8/4]\no100 endsub\nG0 X0 Y0 Z5\no100 call [6.148]\nM2\n"
    library = cncsub.loads(text, control="grblhal")
    flat = library.flatten()
    assert "G1 X6.148 F100" in flat.text
    flat.verify()
    library.resume(at="O100:2", setup=HOME).verify()


def test_the_safe_height_and_the_order_of_axes_are_chosen(job: cncsub.Library) -> None:
    resumed = job.resume(at="O2:N120", safe_height=80, order=["Y", "X", "Z"])
    lines = resumed.text.splitlines()
    assert "G01 Z-5." in job.resume(at="O2:N120", order=["X"]).text  # what it does not name, last
    at = lines.index("G00 G43 H1 Z80.")
    assert lines[at + 1 : at + 5] == ["G00 Y0.", "G00 X20.", "G00 Z50.", "G01 Z-5. F200"]


@pytest.mark.parametrize("order", [["Q"], ["XY", "Y"], [], "X Z"])
def test_an_order_that_names_no_axes_is_refused(job: cncsub.Library, order: Any) -> None:
    with pytest.raises(ValueError, match="order must name axes, each once"):
        job.resume(at="O2:N120", order=order)
    with pytest.raises(ValueError, match="safe_height must be a number"):
        job.resume(at="O2:N120", safe_height=float("nan"))


@pytest.mark.parametrize(
    ("control", "text", "at", "why"),
    [
        ("linuxcnc", "o1 sub\nG91 G0 X1\no1 endsub\nG0 Z5\nN20 o1 call\nN30 G90 X5\no1 call\nM2\n", "MAIN:N30", "move 1 of the rest differs in kind"),
        (CONTROL, "O1\nN10 G66 P2 A1.\nN20 G0 X5.\nN30 X6.\nN40 G67\nN50 M30\nO2\nG91 Z#1\nG90\nM99\n", "O1:N30", "a modal call is in force"),
    ],
)  # fmt: skip
def test_a_rest_that_cannot_go_on_with_calls_is_flat_and_says_so(
    control: str, text: str, at: str, why: str
) -> None:
    resumed = cncsub.loads(text, control=control).resume(at=at, setup=HOME)
    assert resumed.form == "flat"
    assert len(resumed.notes) == 1
    assert resumed.notes[0] == (
        f"the rest stands without calls and loops, it sets no variables: {why}"
    )


@pytest.mark.parametrize(
    ("changed", "to", "told"),
    [
        ("N70 M30", "M5\nN70 M30", "code 0 of the rest"),
        ("N120 G0 Z50.", "N120 G0 Z49.", "differs in z"),
        ("N120 G0 Z50.", "N120 G0 Z50.\nG4 X1.", "differs in"),
        ("N125 #100=#100+1", "N125 #100=#100+2", "#100 is 3 at the end of the program, 4 of"),
        ("N70 M30", "N70 M98 P8888", "the program stops with end, the restart with alarm"),
        ("N70 M30", "#3006=1(LOOK)\nN70 M30", "message 0 of the rest is none in the program"),
    ],
)
def test_the_proof_sees_what_differs(job: cncsub.Library, changed: str, to: str, told: str) -> None:
    resumed = job.resume(at="O2:N120", times=2)
    library = job
    for text in resumed.files.values():
        library = library.with_program(text.replace(changed, to))
    head = resumed.files["O9001.nc"].splitlines().index("M98 P9002") - 1
    whole = Part(job.run(), resumed.state.step, 0)
    found = parting(whole, Part(library.run("O9001"), head, 0), variables=True)
    assert found is not None
    assert told in found


def test_a_restart_is_written_as_one_file_or_a_file_a_program(
    job: cncsub.Library, tmp_path: Path
) -> None:
    resumed = job.resume(at="O2:N120")
    resumed.write(tmp_path / "restart.nc")
    assert (tmp_path / "restart.nc").read_text() == resumed.text
    resumed.write(tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {"restart.nc", *resumed.files}


def test_the_command_prints_the_state_and_writes_the_program(tmp_path: Path) -> None:
    (tmp_path / "job.nc").write_text(JOB)
    line = ["resume", str(tmp_path / "job.nc"), "-c", CONTROL, "--at", "O2:N120", "--pass", "2"]
    done = CliRunner().invoke(app, [*line, "--out", str(tmp_path / "again.nc")])
    assert done.exit_code == 0, done.output
    assert "tool      T5\nspindle   M3 S2000\ncoolant   M8\n" in done.stdout
    assert (tmp_path / "again.nc").read_text().startswith("O9001\nG21")
    shown = CliRunner().invoke(app, line)
    assert shown.stdout == f"{done.stdout}\n{(tmp_path / 'again.nc').read_text()}"
    wrong = CliRunner().invoke(app, [*line[:-3], "O2:N999"])
    assert wrong.exit_code == 2
    assert "no block N999 in O2" in wrong.stderr
    assert CliRunner().invoke(app, line[:4]).exit_code == 2


def test_a_main_program_with_a_name_goes_on_with_its_calls_and_loops() -> None:
    text = "F100 R1=1\nWHILE R1<4\nN20 SUB\nR1=R1+1\nN30 G0 X=R1\nENDWHILE\nM30\n"
    job = {"A.MPF": text, "SUB.SPF": "G91 Z1\nG90\nM17\n"}
    resumed = cncsub.loads(job, control="siemens-one").resume(at="A:N30", times=2, setup=HOME)
    assert resumed.form == "calls"
    assert resumed.files == {
        "RESTART.MPF": "G71 G17 G94 G40 G90\nG54\nR1=3\nG00 Z3.\nG00 X2. Y0.\nG00 Z2.\nF100\nN30 G0 X=R1\n"
        "WHILE R1<4\nN20 SUB\nR1=R1+1\nN30 G0 X=R1\nENDWHILE\nM30\n"
    }
    inside = cncsub.loads(job, control="siemens-one").resume(at="SUB:2", setup=HOME)
    assert inside.form == "flat"


# ---- laws ----


def test_what_a_control_says_it_can_read_is_what_it_reads() -> None:
    """A head asks instead of reading each number in vain."""
    for name in cncsub.controls:
        machine = cncsub.loads("O1\nM30\n", control=name).machine()
        for number in range(1000, 20000, 37):
            try:
                machine.core.get_variable(number)
                read = True
            except (KeyError, ValueError):
                read = False
            assert can_be_read(machine.core.code, number) == read, (name, number)


def test_rows_are_started_again_at_any_step() -> None:
    """`python tests/differential/restart_programs.py --rows 1` does the same with all of them."""
    restarts = restart_programs.Restarts()
    restart_programs.of_rows(restarts, rows()[7::120])
    assert sum(restarts.made.values()) > 150
    compensation = sum(n for why, n in restarts.refused.items() if "radius compensation" in why)
    others = sum(restarts.refused.values()) - compensation
    assert others < 0.05 * sum(restarts.made.values()), restarts.report()


def test_generated_programs_are_started_again_on_every_control() -> None:
    """`python tests/differential/restart_programs.py --programs 1000` does the same with more."""
    restarts = restart_programs.Restarts()
    restart_programs.of_calls(restarts, range(1))
    restart_programs.of_macros(restarts, range(2))
    restart_programs.of_other_languages(restarts, range(4))
    assert sum(restarts.made.values()) > 100
    assert restarts.made["calls"] > restarts.made["flat"]
    assert restarts.share_refused < 0.03, restarts.report(shows=True)


def test_programs_of_every_language_are_started_again_on_each_control() -> None:
    """`python tests/differential/restart_programs.py --each 10000` does the same with more."""
    restarts = restart_programs.Restarts(places=1)
    for count, control in enumerate(cncsub.controls, 1):
        restart_programs.of_control(restarts, control, 4 * count)
    assert restarts.share_refused < 0.03, restarts.report(shows=True)


def test_examples_are_started_again() -> None:
    restarts = restart_programs.Restarts()
    restart_programs.of_examples(restarts, every=9)
    assert sum(restarts.made.values()) > 40
    assert not [why for why in restarts.refused if "radius compensation" not in why]
