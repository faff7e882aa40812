"""What a restart program does before its first block of the run: a machine obeys it, so it says
nothing on a guess and drops nothing in silence.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

CONTROL = "fanuc-0i-f"
TWO_SYSTEMS = """O1
N10 T5 M6
N20 G90 G55 G0 X10. Y0
N25 G43 H1 Z50.
N30 S2000 M3
N40 G54 X0 Y0 Z20.
N50 G1 Z-5. F100
N60 X10.
N70 M30
"""
OFFSETS = {"length_offsets": {1: 100.0}, "work_offsets": {"G54": {"Z": -300}, "G55": {"Z": -200}}}


def head_of(text: str, at: str, control: str = CONTROL, **options: Any) -> list[str]:
    """Return the blocks before that of the place, without the name of the program."""
    resumed = cncsub.loads(text, control=control).resume(at=at, **options)
    resumed.verify()
    lines = resumed.text.splitlines()
    return lines[lines[0].startswith("O") : lines.index(resumed.state.block.text)]


# ---- the safe height ----


def test_the_safe_height_is_the_highest_machine_z_in_the_offsets_of_the_place() -> None:
    head = head_of(TWO_SYSTEMS, "O1:N60", setup=OFFSETS)
    assert head[4:] == [
        "G00 G43 H1 Z150.",  # Z50. of G55 in G54
        "G00 X0. Y0.",
        "G00 Z20.",
        "G01 Z-5. F100",
    ]


def test_heights_of_other_offsets_count_only_where_the_setup_gives_the_offsets() -> None:
    assert "G00 G43 H1 Z20." in head_of(TWO_SYSTEMS, "O1:N60")  # that of G54
    only_one = {**OFFSETS, "work_offsets": {"G54": {"Z": -300}}}
    assert "G00 G43 H1 Z20." in head_of(TWO_SYSTEMS, "O1:N60", setup=only_one)


def test_the_safe_height_is_not_above_the_travel_limits() -> None:
    limited = {**OFFSETS, "limits": {"Z": (-500, -50)}, "start": {"Z": 100}}
    assert "G00 G43 H1 Z150." in head_of(TWO_SYSTEMS, "O1:N60", setup=limited)
    with pytest.raises(ValueError, match="above the travel limit of Z, -50"):
        head_of(TWO_SYSTEMS, "O1:N60", setup=limited, safe_height=151)


def test_a_safe_height_below_the_place_is_refused() -> None:
    with pytest.raises(ValueError, match="safe_height 10 lies below the place, which is at Z20"):
        head_of(TWO_SYSTEMS, "O1:N50", safe_height=10)


def test_a_height_that_nothing_gives_is_asked_for() -> None:
    with pytest.raises(cncsub.ResumeError, match="no safe height is known: the run has not moved"):
        head_of(TWO_SYSTEMS, "O1:N25")
    given = head_of(TWO_SYSTEMS, "O1:N25", safe_height=80)
    assert given[3:] == ["G00 Z80.", "G00 X10. Y0."]  # and stays there: the run begins there, too
    started = head_of(TWO_SYSTEMS, "O1:N25", setup={**OFFSETS, "start": {"Z": 90}})
    assert started[3:] == ["G00 Z150.", "G00 X10. Y0.", "G00 Z-10."]  # Z90. of G54 in G55


@pytest.mark.parametrize("control", ["fanuc-0i-f", "linuxcnc", "haas-ngc", "mitsubishi-m700"])
def test_the_length_of_the_tool_is_in_force_before_an_axis_moves(control: str) -> None:
    text = "O1\nN10 T5 M6\nN15 G0 X1. Y1.\nN20 G43 H1 Z50.\nN30 X5.\nN40 M30\n"
    if control == "linuxcnc":
        text = text.replace("O1\n", "")
    name = "MAIN" if control == "linuxcnc" else "O1"
    lines = cncsub.loads(text, control=control).resume(at=f"{name}:N30").text.splitlines()
    first = next(line for line in lines if line.startswith("G00"))
    assert first == "G00 G43 H1 Z50."


TWO_TOOLS = """O1
N10 T1 M6
N12 G90 G54 G0 X0 Y0
N14 G43 H1 Z50.
N20 G91 G28 Z0
N30 G90 T2 M6
N32 G55
N34 G0 X5. Y5.
N36 G43 H2 Z30.
N40 M30
"""


def test_a_place_on_the_machine_is_given_in_machine_coordinates() -> None:
    """After G28 the work coordinate follows from offsets that nobody gave."""
    told = ["G43 H1", "G91 G28 Z0.", "G90", "G00 X0. Y0.", "G91"]
    assert head_of(TWO_TOOLS, "O1:N30")[3:] == told
    given = {"work_offsets": {"G54": {"Z": -300}, "G55": {"Z": -300}}, "length_offsets": {1: 100.0}}
    assert head_of(TWO_TOOLS, "O1:N30", setup=given)[3:] == told
    direct = TWO_TOOLS.replace("G91 G28 Z0", "G53 Z-10.")
    assert "G53 G00 Z-10." in head_of(direct, "O1:N30")


def test_a_place_under_offsets_that_nobody_gave_is_refused() -> None:
    with pytest.raises(cncsub.ResumeError, match="X stands where a block under other offsets has"):
        head_of(TWO_TOOLS, "O1:N34")
    systems = {name: {"X": 1.0, "Y": 2.0, "Z": 3.0} for name in ("G54", "G55")}
    given = {"work_offsets": systems, "length_offsets": {1: 100.0}}
    assert "G00 X0. Y0." in head_of(TWO_TOOLS, "O1:N34", setup=given)


@pytest.mark.parametrize(
    ("control", "text", "at", "why"),
    [
        ("linuxcnc", "G54 G0 X0 Y0\nN20 G59.1\nN30 G43 H1 Z5\nN40 X1\nM2\n", "MAIN:N30", "no safe height"),
        ("linuxcnc", "G54 G0 X0 Y0\nN20 G59.1\nN30 G43 H1 Z5\nN40 X1\nM2\n", "MAIN:N40", "X stands where a"),
        ("haas-ngc", "O1\nN20 G154 P2 G0 X1. Y1.\nN30 G43 H3 Z1.\nN40 G28 G91 Z0\nN50 M30\n", "O1:N30", "no safe height"),
    ],
)  # fmt: skip
def test_an_offset_that_a_setup_has_no_name_for_is_not_known(
    control: str, text: str, at: str, why: str
) -> None:
    with pytest.raises(cncsub.ResumeError, match=why):
        head_of(text, at, control)


def test_a_place_that_was_reached_in_other_units_is_reached_in_them() -> None:
    text = "O1\nN10 G21 G90 G0 X7. Y5. Z30.\nN20 G20\nN30 X1. Y1.\nN40 M30\n"
    head = head_of(text, "O1:N30")
    assert head[0].startswith("G21 ")
    assert head[2:] == ["G00 Z30.", "G00 X7. Y5.", "G20"]


def test_a_block_that_a_control_wants_first_is_the_first() -> None:
    text = "O1\nN10 G21 G90\nN20 G0 X0 Y0 Z5.\nN30 G1 X9. F100\nN40 M30\n"
    assert head_of(text, "O1:N10", "hnc-21m", safe_height=5) == []
    assert head_of(text, "O1:N30", "hnc-21m") != []


MIXED = """O1
N10 G21 G90 G0 X0 Y0 Z5.
N20 G1 F300
N30 #103=-91.5714
N40 G20
N50 G0 X[#103/30]
N60 G21
N70 G1 Y108. Z-50. F525
N80 X1.
N90 M30
"""


@pytest.mark.parametrize(
    ("at", "words"),
    [
        ("O1:N50", ["G21 G17 G94 G40 G80 G49 G90", "G00 Z5.", "G21", "F300", "G20"]),
        ("O1:N60", ["G00 X-3.0524 Y0.", "G21", "G00 Z5.", "G20"]),
        ("O1:N70", ["G00 X-77.5319 Y0.", "G20", "G00 X-3.0524", "G21", "F300"]),
        ("O1:N80", ["G00 X-77.5319 Y108.", "G20", "G00 X-3.0524", "G21", "G01 Z-50. F525"]),
    ],
)
def test_axes_that_stand_between_increments_are_moved_in_the_units_of_their_words(
    at: str, words: list[str]
) -> None:
    start = {"start": {"X": 0, "Y": 0, "Z": 0}}
    left = iter(head_of(MIXED, at, "fanuc-16i", setup=start))
    assert all(word in left for word in words), words


# ---- axes ----


HALF = """O1
N10 G19 G91 G0 X-1. Y-0.43 F27.9
N20 Z-.49 X4.9
N30 Z-.016 X2.5 Y.25
N40 Z5. X-16. Y-38.
N50 G3 R6.865 Z10.984 Y8.238
N60 M30
"""


@pytest.mark.parametrize("n", [30, 40, 50])
def test_a_half_circle_by_its_radius_has_the_same_centre_from_every_start(n: int) -> None:
    """What rounding leaves of the square of its height, the root makes a thousandth of a mm."""
    start = {"start": {"X": 0.033, "Y": 1.4, "Z": 27.0}}
    assert head_of(HALF, f"O1:N{n}", "fanuc-16i", setup=start)


def test_every_axis_is_moved_to_the_place_also_where_the_start_is_assumed_there() -> None:
    """The start of a run is taken for X0 Y0; a machine may stand anywhere."""
    text = "O1\nN10 G90 G54 G0 X0 Y0 Z20.\nN20 G1 Z-5. F100\nN30 X5.\nN40 M30\n"
    assert head_of(text, "O1:N20")[2:] == ["G00 Z20.", "G00 X0. Y0."]


def test_an_axis_that_the_run_has_not_moved_is_not_moved() -> None:
    text = "O1\nN10 G90 G54 G0 X5. Z20.\nN20 X7.\nN30 M30\n"
    resumed = cncsub.loads(text, control=CONTROL).resume(at="O1:N20")
    assert "G00 X5." in resumed.text.splitlines()
    assert resumed.notes == ("the head does not move Y: the run has not moved it before",)
    assert "(THE HEAD DOES NOT MOVE Y: THE RUN HAS NOT MOVED IT BEFORE)" in resumed.text


def test_a_place_that_depends_on_the_start_is_refused_with_the_axis() -> None:
    text = "O1\nN10 G91 G0 X5.\nN20 G1 X7. F100\nN30 G90 X1.\nN40 M30\n"
    start = {"Y": 0.0, "Z": 0.0}
    with pytest.raises(cncsub.ResumeError, match=r"where X stands depends .* give the start of X"):
        head_of(text, "O1:N20", setup={"start": start})
    head = head_of(text, "O1:N20", setup={"start": {**start, "X": 1.0}})
    assert "G00 X6. Y0." in head


def test_a_cut_is_entered_with_feed_from_the_height_of_the_cut() -> None:
    text = "O1\nN10 G0 X0 Y0 Z50.\nN15 Z2.\nN20 G1 Z-5. F100\nN25 X3. Z-6.\nN30 X5.\nN40 M30\n"
    assert head_of(text, "O1:N30")[2:] == ["G00 Z50.", "G00 X3. Y0.", "G00 Z2.", "G01 Z-6. F100"]
    assert head_of(text, "O1:N20")[2:] == ["G00 Z50.", "G00 X0. Y0.", "G00 Z2."]


def test_a_depth_that_was_reached_with_feed_is_entered_with_feed_after_a_rapid_in_it() -> None:
    """Nothing says that the slot is there: the tool may have broken in it."""
    text = "O1\nN10 G0 X0 Y0 Z5.\nN20 G1 Z-2. F100\nN30 X40. F200\nN40 G0 X0\nN50 G1 Y3.\nN60 M30\n"
    down = ["G01 Z-2. F200"]
    assert head_of(text, "O1:N50")[2:] == ["G00 Z5.", "G00 X0. Y0.", *down, "G00"]
    assert head_of(text, "O1:N60")[2:] == ["G00 Z5.", "G00 X0. Y3.", *down]
    in_air = text.replace("G1 Z-2. F100", "Z-2. F100").replace("N30 X40", "N30 G1 X40")
    assert "G00 Z-2." in head_of(in_air, "O1:N50")


# ---- where the tool stands (G92, G50) ----

LATHE = "O1\nN10 T0101\nN15 G50 X100. Z50.\nN20 X80.\nN30 G0 X50. Z2.\nN40 G1 Z-10. F0.2\nN60 M30\n"


@pytest.mark.parametrize("control", ["gsk-988ta", "gsk-980tdi", "gsk-928te"])
def test_a_shift_that_says_where_the_tool_stands_comes_before_the_moves(control: str) -> None:
    resumed = cncsub.loads(LATHE, control=control).resume(at="O1:N40")
    lines = resumed.text.splitlines()
    at = lines.index("G50 X100. Z50.")
    assert lines[at + 1 : at + 3] == ["G00 Z2.", "G00 X50."]
    told = "start it where the program starts: G50 X100. Z50. says where the tool stands"
    assert told in resumed.notes
    assert f"({told.upper()})" in lines


def test_a_shift_of_a_known_place_is_written_there() -> None:
    setup = {"start": {"X": 0, "Z": 0}}
    resumed = cncsub.loads(LATHE, control="gsk-988ta").resume(at="O1:N40", setup=setup)
    lines = resumed.text.splitlines()
    assert lines.index("G50 X50. Z2.") > lines.index("G00 X-50.")


# ---- modes ----

BENT = """O1
N10 G90 G54 G0 X0 Y0 Z50.
N20 G68 X0 Y0 R30.
N40 G1 X10. F100
N42 X12.
N50 G69
N60 G51 X0 Y0 P2000
N70 X5.
N75 Y5.
N80 G50
N85 G16
N87 X5. Y30.
N88 Y40.
N89 G15
N91 X1. Y1.
N93 G51.1 X0
N100 X5.
N105 Y3.
N110 G50.1 X0
N111 Y9.
N112 M30
"""


@pytest.mark.parametrize(
    ("at", "words"),
    [
        ("N42", ["G68 X0 Y0 R30.", "G00 X10. Y0."]),
        ("N75", ["G51 X0 Y0 P2000"]),
        ("N88", ["G16", "G00 X5. Y30."]),
        ("N105", ["G51.1 X0", "G00 X5. Y1."]),
    ],
)
def test_what_bends_the_path_is_put_in_force(at: str, words: list[str]) -> None:
    head = head_of(BENT, f"O1:{at}")
    assert [line for line in head if line in words] == words


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("N20 TRANS X3\nN25 AROT RPL=30\nN30 G0 X7\n", ["TRANS X3", "AROT RPL=30"]),
        ("N20 ROT RPL=30\nN25 ATRANS X5 Y=2\nN30 G0 X7\n", ["ROT RPL=30", "ATRANS X5 Y=2"]),
        ("N20 ROT RPL=30\nN25 TRANS X5\nN30 G0 X7\n", ["TRANS X5"]),
        ("N20 TRANS X3\nN25 AMIRROR X0\nN30 G0 X7\n", ["TRANS X3", "AMIRROR X0"]),
    ],
)
def test_the_frames_of_a_program_are_put_in_force(text: str, words: list[str]) -> None:
    whole = f"N10 G0 X5 Y0 Z10\n{text}N40 X8\nN50 M30\n"
    head = head_of(whole, "MAIN:N40", "siemens-one")
    frames = ("TRANS", "ROT", "AROT", "ATRANS", "AMIRROR")
    assert [line for line in head if line.split()[0] in frames] == words


def test_a_row_of_a_rigid_tapping_cycle_is_gone_on_with() -> None:
    text = (
        "O1\nN10 G90 G54 G0 X0 Y0 Z50.\nN20 M29 S500\nN30 G84 Z-5. R2. F1.\nN40 X20.\nN50 X25.\n"
        "N60 G80\nN70 M30\n"
    )
    head = head_of(text, "O1:N50")
    assert head[-2:] == ["M29 S500", "G84 Z-5. R2. F1. K0"]


def test_modes_that_the_run_had_otherwise_are_written() -> None:
    """A run that was broken off may have left them."""
    text = "O1\nN10 G99 G0 X0 Y0 Z5.\nN20 G98 X1.\nN30 X2.\nN40 M30\n"
    assert "G98" in head_of(text, "O1:N30")
    lathe = "O1\nN10 G96 S100 M3\nN15 G0 X50. Z2.\nN20 G97 S500\nN30 G1 X40. F0.2\nN40 M30\n"
    assert "G97 S500 M3" in head_of(lathe, "O1:N30", "gsk-988ta")


# ---- what is not repeated ----


def test_functions_that_are_not_repeated_are_told() -> None:
    text = (
        "O1\nN5 M43\nN10 M3 S500\nN15 M8\nN20 G90 G54 G0 X0 Y0 Z5.\nN30 M11\nN40 G0 B90. M51\n"
        "N50 M11\nN60 X5.\nN70 M30\n"
    )
    resumed = cncsub.loads(text, control=CONTROL).resume(at="O1:N60")
    told = [note for note in resumed.notes if "not repeated" in note]
    assert told == [
        "M43 ran at O1 N5 and is not repeated",
        "M51 ran at O1 N40 and is not repeated",
        "M11 ran at O1 N50 and is not repeated",
    ]
    for note in told:
        assert f"({note.upper()})" in resumed.text.splitlines()
    assert "S500 M3" in resumed.text.splitlines()


def test_the_words_of_a_function_are_told_with_it() -> None:
    text = "N10 G0 X0 Y0 Z5.\nN20 M64 P1\nN30 X5.\nM2\n"
    notes = cncsub.loads(text, control="linuxcnc").resume(at="MAIN:N30").notes
    assert notes == ("M64 P1 ran at MAIN N20 and is not repeated",)
    text = "N10 G0 X0 Y0 Z5\nN20 M2=3 S2=500\nN30 X5\nM30\n"
    resumed = cncsub.loads(text, control="siemens-one").resume(at="MAIN:N30")
    assert [note.split()[0] for note in resumed.notes] == ["M2=3", "S2=500"]
    assert resumed.text.startswith("; M2=3 RAN AT MAIN N20 AND IS NOT REPEATED\n")


def test_an_oriented_spindle_is_not_turned() -> None:
    text = "O1\nN10 M3 S500\nN20 G0 X0 Y0 Z5.\nN30 M19\nN40 X5.\nN50 M30\n"
    resumed = cncsub.loads(text, control=CONTROL).resume(at="O1:N40")
    assert resumed.state.spindle is None
    assert not any(line.endswith("M3") for line in resumed.text.splitlines())
    assert "M19 ran at O1 N30 and is not repeated" in resumed.notes


# ---- places ----


def test_a_line_of_another_program_of_the_file_is_refused_with_its_name() -> None:
    text = "O1\nN10 G0 X1.\nM30\nO2\nN20 X3.\nM99\n"
    library = cncsub.loads({"job.nc": text}, control=CONTROL)
    told = "line 5 of job.nc lies in O2, not in O1: give O2:5, or job.nc:5"
    with pytest.raises(KeyError, match=told):
        library.resume(at="O1:5")
    machine = library.machine()
    with pytest.raises(KeyError, match=told):
        machine.run(until="O1:5")
    inside = "o1 sub\nG0 X1\no1 endsub\nG0 Z5\nN20 o1 call\nM2\n"
    called = cncsub.loads({"job.ngc": inside}, control="linuxcnc").machine()
    assert called.run(until="job:2") is None  # a subprogram that is defined in the program
    assert called.next is not None
    assert called.next.line == 2


@pytest.mark.parametrize("at", ["X10,Y0", 3, {"X": 1.0}, cncsub.Breakpoint("O1:N50")])
def test_a_pass_of_a_place_that_is_met_once_is_refused(at: Any) -> None:
    library = cncsub.loads(TWO_SYSTEMS, control=CONTROL)
    with pytest.raises(ValueError, match=r"times \(--pass\) must be 1 here, not 2"):
        library.resume(at=at, times=2)


def test_a_refusal_names_the_cause_and_places_that_work() -> None:
    text = (
        "O1\nN5 G90 G0 X0 Y0 Z5.\nN10 G68 X0 Y0 R30.\nN20 G0 X10.\nN30 G69\nN40 G1 Y5. F100\n"
        "N50 X3.\nN60 M30\n"
    )
    with pytest.raises(cncsub.ResumeError, match="between the increments of the control") as error:
        head_of(text, "O1:N40")
    assert "it can be started at O1 N60 or O1 N30" in error.value.reason


# ---- files ----


def resume_command(*line: str) -> Any:
    return CliRunner().invoke(app, ["resume", *line])


def test_a_program_of_a_folder_is_not_written_over(tmp_path: Path) -> None:
    job, out = tmp_path / "job.nc", tmp_path / "out"
    job.write_text(TWO_SYSTEMS)
    out.mkdir()
    line = [str(job), "-c", CONTROL, "--at", "O1:N60", "-o", str(out)]
    assert resume_command(*line).exit_code == 0
    assert resume_command(*line).exit_code == 0  # the same program
    (out / "O9001.nc").write_text("O9001(PROBING)\nM99\n")
    refused = resume_command(*line)
    assert refused.exit_code == 2
    assert "O9001.nc holds another program; --force writes over it" in refused.stderr
    assert (out / "O9001.nc").read_text() == "O9001(PROBING)\nM99\n"
    assert resume_command(*line, "--force").exit_code == 0
    assert "N60 X10." in (out / "O9001.nc").read_text()


@pytest.mark.parametrize(
    ("text", "at", "status"),
    [
        ("O1\nN10 G0 X1.\nN20 M98 P99\nN30 M30\n", "O1:N10", 1),
        ("O1\nN10 G91 G0 X1.\nN20 X5.\nN30 M30\n", "O1:N20", 1),
        ("O1\nN10 GOTO10\nN30 M30\n", "O1:N10", 4),
        ("O1\nN10 G0 X1.\nN30 M30\n", "O1:N99", 2),
    ],
)
def test_the_status_says_whether_the_use_was_wrong(
    tmp_path: Path, text: str, at: str, status: int
) -> None:
    (tmp_path / "job.nc").write_text(text)
    job = str(tmp_path / "job.nc")
    done = resume_command(job, "-c", CONTROL, "--at", at, "--max-blocks", "1000")
    assert done.exit_code == status, done.output
    assert "Traceback" not in done.output


def test_numbers_are_those_that_the_control_takes() -> None:
    control = cncsub.controls[CONTROL].replace(max_program_number=500)
    text = "O1\nN10 G0 X0 Y0 Z5.\nN15 G66 P2\nN20 X5.\nN30 X6.\nN40 G67\nN50 M30\nO2\nM99\n"
    resumed = cncsub.loads(text, control=control).resume(at="O1:N30")
    assert resumed.form == "flat"
    assert list(resumed.files) == ["O402.nc"]


def test_the_name_of_a_program_has_the_sign_of_the_control() -> None:
    text = "%1\nN10 G00 X100 Z50\nN20 G01 X90 F80\nN30 Z40\nN40 M02\n"
    resumed = cncsub.loads(text, control="gsk-928te").resume(at="%1:N30")
    assert resumed.text.startswith("%156\n")
    assert list(resumed.files) == ["%156.nc"]


def test_a_file_between_marks_goes_on_between_marks(tmp_path: Path) -> None:
    job, out = tmp_path / "job.nc", tmp_path / "again.nc"
    job.write_text(f"%\n{TWO_SYSTEMS}%\n")
    resumed = cncsub.load(job, control=CONTROL).resume(at="O1:N60")
    resumed.write(out)
    assert out.read_text() == f"%\n{resumed.text}%\n"
    assert cncsub.load(out, control=CONTROL).run().stop == "end"


def test_line_ends_are_kept_and_zero_bytes_are_told(tmp_path: Path) -> None:
    job, out = tmp_path / "job.nc", tmp_path / "again.nc"
    text = TWO_SYSTEMS.replace("N70", "N65 X1\0\0 Y2.\nN70").replace("\n", "\r\n")
    job.write_bytes(text.encode())
    resumed = cncsub.load(job, control=CONTROL).resume(at="O1:N60")
    resumed.write(out)
    data = out.read_bytes()
    assert data.count(b"\r\n") == data.count(b"\n") > 5
    assert b"\0" not in data
    assert "bytes of zero in its blocks are left out" in resumed.notes
