"""A flat program does what the program does, or is refused with the reason."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
import flat_programs
from cncsub.cli import app
from conformance import rows

CASES = {
    "calls and repeats": (
        "O1\nN10 G90 G0\nN20 M98 P2 L2\nM30\nO2\nG91 X1.\nM99\n",
        "O1\nG90 G0\nG91 X1.\nG91 X1.\nM30\n",
    ),
    "a loop, and a variable that it counts": (
        "O1\n#100=1\nWHILE[#100 LE 2]DO1\nG0 X#100\n#100=#100+1\nEND1\nM30\n",
        "O1\nG0 X1.\nG0 X2.\nM30\n",
    ),
    "a skipped block is not written": (
        "O1\n/G0 X1.\n/2 G0 Y1.\nM30\n",
        "O1\nG0 Y1.\nM30\n",
    ),
    "arguments of a macro": (
        "O1\nG65 P2 A7.\nM30\nO2\nG0 X-#1\nM99\n",
        "O1\nG0 X-7.\nM30\n",
    ),
    "an expression": (
        "O1\n#1=2\nG65 P2 A3.\nM30\nO2\nG0 X[#1*SIN[30]+1] Y-[#1]\nG4 P[#1*100]\nM99\n",
        "O1\nG0 X2.5 Y-3.\nG4 P300\nM30\n",
    ),
    "a computed end is rounded to the increment": (
        "O1\n#1=10/3\nG0 X#1\nX[#1*2]\nM30\n",
        "O1\nG0 X3.333\nX6.667\nM30\n",
    ),
    "to that of the units in force": (
        "O1\n#1=1/3\nG20\nG0 X#1\nG21\nX#1\nM30\n",
        "O1\nG20\nG0 X0.3333\nG21\nX0.333\nM30\n",
    ),
    "a modal macro after each move": (
        "O1\nG66 P2\nG0 X1.\nG67\nM30\nO2\nM8\nM99\n",
        "O1\nG0 X1.\nM8\nM30\n",
    ),
    "a main program that starts over": ("O1\nG0 X1.\nM99\n", "O1\nG0 X1.\nM99\n"),
    "words are spelled as they were": (
        "O0001(PART)\nN10 G00 X10.0 Z-0.50 M08\nT0101(TOOL)\nX#1 G01 F.2\nN20 M30\n",
        "O0001\nG00 X10.0 Z-0.50 M08\nT0101\nG01 F.2\nM30\n",
    ),
    "a value between two increments, where nothing rounds it": (
        "O1\n#1=100/3\nG68 X0 Y0 R#1\nG69\nG4 X[1/3]\nM30\n",
        "O1\nG68 X0 Y0 R[33.3333333333+0.000000000033336]\nG69\nG4 X0.333\nM30\n",
    ),
    "what the control knows of itself": (
        "O1\nG0 X[#5041+1]\n#1=100\n#101=4\nY#[#1+1]\nM30\n",
        "O1\nG0 X1.\nY4.\nM30\n",
    ),
    "an offset": (
        "O1\n#100=5\nWHILE[#100 LT 7]DO1\n#[5216+#100]=#100/3\n#100=#100+1\nEND1\nG0 X1.\nM30\n",
        "O1\n#5221=1.66666666666+0.0000000000066667\n#5222=2\nG0 X1.\nM30\n",
    ),
    "messages": (
        "O1\n#1=1.5\nPOPEN\nDPRNT[X#1[53] OK]\nPCLOS\n#3006=1(LOOK AT IT)\nM30\n",
        "O1\nPOPEN\n#1=1.5\nDPRNT[X#1[53]OK]\nPCLOS\n#3006=1(LOOK AT IT)\nM30\n",
    ),
    "an alarm of its own": (
        "O1\nG0 X1.\nIF[#1 EQ #0]GOTO9\nM30\nN9 #3000=7(OFF)\n",
        "O1\nG0 X1.\n#3000=7(OFF)\n",
    ),
    "computed codes": (
        "O1\n#1=90\nG#1 G0 X1.\n#2=8\nM#2\n#3=30\nM#3\n",
        "O1\nG90 G0 X1.\nM8\nM[30]\n",
    ),
    "a jump out of a subprogram": (
        "O1\nM98 P2\nG0 X1.\nN9 Y1.\nM30\nO2\nZ1.\nM99 P9\n",
        "O1\nZ1.\nY1.\nM30\n",
    ),
}
LATHE = {
    "the profile of a cycle is renumbered": (
        "O1\nG0 X100. Z2.\n#1=20\nG71 U2. R1.\nG71 P50 Q70 U0.4 W0.1 F0.2\n"
        "N50 G0 X#1\nG1 Z-10. F0.1\nN70 X60.\nG70 P50 Q70\nM30\n",
        "O1\nG0 X100. Z2.\nG71 U2. R1.\nG71 P1 Q2 U0.4 W0.1 F0.2\n"
        "N1 G0 X20.\nG1 Z-10. F0.1\nN2 X60.\nG70 P1 Q2\nM30\n",
    ),
    "and stands after the end where the cycle does not pass over it": (
        "O1\nG0 X100. Z2.\nG70 P50 Q70\nM30\nN50 G0 X20.\nG1 Z-10. F0.1\nN70 X60.\n",
        "O1\nG0 X100. Z2.\nG70 P1 Q2\nM30\nN1 G0 X20.\nG1 Z-10. F0.1\nN2 X60.\n",
    ),
    "a whole value that would count increments": (
        "O1\nG0 X100. Z2.\n#1=5\nG75 R1.\nG75 X80. Z-20. P#1 Q#1 F0.1\nM30\n",
        "O1\nG0 X100. Z2.\nG75 R1.\nG75 X80. Z-20. P5 Q[5] F0.1\nM30\n",
    ),
}
REFUSED = {
    "O1\nG0 X1.\nM98 P9\nM30\n": "ends by an alarm",
    "O1\nN10 GOTO 10\nM30\n": "does not end: it stopped with (waiting|limit)",
    "O1\nWHILE[#1000 EQ 0]DO1\nEND1\nM30\n": "stopped with waiting for #1000",
    "O1\nG0 X1.\nM99\n": "does not end: it stopped with limit",
}


def test_modes_that_a_call_keeps_are_no_part_of_a_flat_program() -> None:
    text = "o1 sub\nM73\nG91 G20\no1 endsub\nG0 X5\no1 call\nG0 X1\nM2\n"
    with pytest.raises(cncsub.FlattenError, match="M70 to M73"):
        cncsub.loads(text, control="linuxcnc").flatten()
    kept = cncsub.loads("M70\nG91 G0 X5\nM72\nG0 X1\nM2\n", control="linuxcnc").flatten()
    kept.verify()
    assert kept.text == "M70\nG91 G0 X5\nM72\nG0 X1\nM2\n"


@pytest.mark.parametrize(
    ("block", "reason"),
    [("POSA[X]=5", "code-not-computed, .*POSA: the axis moves on")],
)
def test_a_refusal_names_the_block_and_the_reason(block: str, reason: str) -> None:
    library = cncsub.loads(f"N10 {block}\nN20 M30\n", control="siemens-one")
    with pytest.raises(cncsub.FlattenError, match=f"MAIN N10, line 1: .*{reason}"):
        library.flatten()


BESIDE = (
    "G0 X5 Y0\nPOS[X]=R1+15 POS[Y]=IC(4) FA[X]=R1+600 FA[Y]=600\nX20\nG91 G1 Y1 F100\n"
    "POS[X]=3\nY2\nM30\n"
)


def test_axes_beside_the_path_are_written_as_they_are() -> None:
    library = cncsub.loads(BESIDE, control="siemens-one", name="MAIN")
    flat = library.flatten()
    flat.verify()
    assert "POS[X]=(15) POS[Y]=IC(4) FA[X]=(600) FA[Y]=600\n" in flat.text
    other = library.flatten(control="siemens-828d")
    other.verify()
    assert other.text == flat.text


def test_axes_beside_the_path_become_path_moves_of_a_control_without_them() -> None:
    flat = cncsub.loads(BESIDE, control="siemens-one", name="MAIN").flatten(control="fanuc-0i-f")
    flat.verify()
    lines = flat.text.split("\n")
    at = lines.index("G01 X9. Y4. F848.5281374238571")
    assert lines[at + 1 : at + 4] == ["G01 X15. F600.", "G00", "X20."]
    assert "G90 G01 X23. F600." in lines


@pytest.mark.parametrize(
    ("word", "lacking"),
    [
        ("G1 X20 CHF=2 F100", "CHF"), ("G2 X10 Y0 I5 J0 TURN=1 F100", "TURN"), ("G1 X20 RNDM=1 F100", "RNDM"),
        ("G1 X20 RND=1 FRC=50 F100", "FRC"), ("G41 G1 X20 OFFN=1 F100", "OFFN"),
    ],
)  # fmt: skip
def test_a_word_that_the_other_control_lacks_is_named(word: str, lacking: str) -> None:
    library = cncsub.loads(f"G0 X0 Y0\n{word}\nG1 Y20\nM30\n", control="siemens-one", name="MAIN")
    library.flatten().verify()
    library.flatten(control="siemens-828d").verify()
    with pytest.raises(
        cncsub.FlattenError, match=f"line 2: .*no word that says what {lacking} says"
    ):
        library.flatten(control="fanuc-0i-f")


def test_data_of_tools_are_written_by_their_names() -> None:
    text = (
        '$TC_DP3[1,1]=10\n$TC_DP6[1,1]=R7+3\n$TC_TP2[1]="MILL"\nT="MILL" M6\nD1\n'
        "G0 X=$TC_DP3[1,1] Z=100\nG1 G41 X20 Y5 F100\nX40\nG40 Y50\nM30\n"
    )
    library = cncsub.loads(text, control="siemens-one")
    flat = library.flatten()
    flat.verify()
    assert flat.text.startswith('$TC_DP3[1,1]=10\n$TC_DP6[1,1]=3\n$TC_TP2[1]="MILL"\nT1 M6\n')
    with pytest.raises(cncsub.FlattenError, match=r"\$TC_DP3\[1,1\] gets a value"):
        library.flatten(control="fanuc-0i-f")


def test_a_flat_program_holds_the_blocks_of_a_part_that_texts_name() -> None:
    text = (
        '%_N_MAIN_MPF\nDEF STRING[9] ONE="ONE1"\nG0 X0\nCALL "PART" BLOCK ONE TO TWO2\nM30\n'
        "%_N_PART_SPF\nX9\nONE1: X1\nTWO2: X2\nX8\nM17\n"
    )
    flat = cncsub.loads(text, control="siemens-one").flatten()
    flat.verify()
    assert [line for line in flat.text.split("\n") if "X" in line] == ["G0 X0", "X1", "X2"]


@pytest.mark.parametrize("word", ["AX[X]=IC(2)", "G91 AX[X]=AC(2)", "AX[AXX]=IC(2)"])
def test_a_form_whose_word_names_no_address_is_not_lost(word: str) -> None:
    library = cncsub.loads(f"DEF AXIS AXX=X\nG0 X5 F100\nG1 {word}\nM30\n", control="siemens-one")
    flat = library.flatten()
    flat.verify()
    assert word.replace("AX[AXX]", "X") in flat.text


def test_arcs_about_a_pole_and_tangential_arcs_are_written_as_they_are() -> None:
    text = "G1 X10 Y0 F100\nCT X20 Y10\nG111 X0 Y0\nG2 AP=0\nG96 S100 M3\nG34 Z5 K2 F0.1\nM30\n"
    flat = cncsub.loads(text, control="siemens-one").flatten()
    flat.verify()
    assert flat.text == text


@pytest.mark.parametrize("name", CASES)
def test_what_is_written(name: str) -> None:
    text, expected = CASES[name]
    flat = cncsub.flatten(cncsub.loads(text, control="fanuc-0i-f"), block_skip=1)
    flat.verify()
    assert flat.text == expected
    assert len(flat.origins) == expected.count("\n") - 1


@pytest.mark.parametrize("name", LATHE)
def test_what_is_written_for_a_lathe(name: str) -> None:
    text, expected = LATHE[name]
    library = cncsub.loads(text, control="fanuc-0i-f")
    flat = library.flatten(setup={"machine": "lathe-a"})
    flat.verify()
    assert flat.text == expected
    assert len(flat.origins) == expected.count("\n") - 1


@pytest.mark.parametrize("text", REFUSED)
def test_what_is_refused(text: str) -> None:
    library = cncsub.loads(text, control="fanuc-0i-f")
    with pytest.raises(cncsub.FlattenError, match=REFUSED[text]) as caught:
        cncsub.flatten(library, max_blocks=50, max_cycles=1000)
    assert pickle.loads(pickle.dumps(caught.value)).args == caught.value.args


def test_a_value_that_cannot_be_written_is_refused_with_its_block() -> None:
    control = cncsub.controls["fanuc-0i-f"].replace(statements="-[")
    library = cncsub.loads("O1\n#1=100/3\nN20 G68 X0 Y0 R#1\nM30\n", control=control)
    with pytest.raises(cncsub.FlattenError, match="the value of R cannot be written") as caught:
        library.flatten()
    assert (caught.value.program, caught.value.n, caught.value.line) == ("O1", 20, 3)


def test_a_code_that_calls_stands_in_brackets_where_it_did_not_call() -> None:
    control = cncsub.controls["fanuc-0i-f"].with_parameters({"6080": 60})
    library = cncsub.loads("O1\nM60\nM30\nO9020\nM60\nG0 X1.\nM99\n", control=control)
    flat = library.flatten()
    flat.verify()
    assert flat.text == "O1\nM[60]\nG0 X1.\nM30\n"


WORDS = (
    "O0012(PART)\nN10 G21 G17 G90 G0 X1. Y0 Z5.\n#1=10/3\nN20 G1 X#1 F100\nM98 P2 L2\n"
    "G2 X5. Y0 R4.\nG3 X1. Y0 R2.\nG4 P500\nG4 X1.5\nM8\nT3 M6\nS500 M3\nM30\n"
    "O2\nG91 Y500\nG90\nM99\n"
)


def test_the_codes_of_a_range_are_those_that_call() -> None:
    """G68, G69 and G70 call; the first number is negative, so they call modally."""
    numbers = {"6038": -70, "6039": 3000, "6040": 3}
    control = cncsub.controls["fanuc-0i-f"].with_parameters(numbers)
    flat = cncsub.loads("O1\n#1=69\nG#1 G0 X5.\nM30\n", control=control).flatten()
    flat.verify()
    assert flat.text == "O1\nG[69] G0 X5.\nM30\n"


def test_for_a_control_of_another_language() -> None:
    """Head, codes, numbers, dwells and the end are those of the other control."""
    library = cncsub.loads(WORDS, control="fanuc-0i-f")
    flat = library.flatten(control="linuxcnc", comments=True)
    flat.verify()
    assert flat.text.splitlines()[:2] == ["G98", "G21 G17 G90 G00 X1. Y0. Z5. ;O0012 N10 LINE 2"]
    flat = library.flatten(control="linuxcnc")
    assert flat.text == (
        "G98\nG21 G17 G90 G00 X1. Y0. Z5.\nG01 X3.333 F100.\nG91 Y0.5\nG90\nG91 Y0.5\nG90\n"
        "G02 X5. Y0. R4.\nG03 X1. Y0. R2.\nG04 P0.5\nG04 P1.5\nM8\nT3 M6\nS500 M3\nM30\n"
    )
    assert len(flat.origins) == flat.text.count("\n")
    flat = library.flatten(control="siemens-one", comments=True)
    flat.verify()
    assert "G02 X5. Y0. CR=4. ;O0012 LINE 6" in flat.text
    flat = library.flatten(control="siemens-one")
    assert flat.text == (
        "%_N_PROG0012_MPF\nG00\nG710 G17 G90 G00 X1. Y0. Z5.\nG01 X3.333 F100.\nG91 Y0.5\nG90\n"
        "G91 Y0.5\nG90\nG02 X5. Y0. CR=4.\nG03 X1. Y0. CR=2.\nG04 F0.5\nG04 F1.5\nM8\nT3 M6\n"
        "S500 M3\nM30\n"
    )
    assert len(flat.origins) == flat.text.count("\n") - 1
    assert flat.origins[0] == cncsub.Origin("O0012", None, 1, -1, 1)


def test_from_other_languages() -> None:
    text = "o<sub> sub\nG91 X1\no<sub> endsub\nG21 G90 G0 X1 Y0\no<sub> call\nG4 P0.5\nM2\n"
    library = cncsub.loads(text, control="linuxcnc")
    assert library.flatten(control="hnc-21m").text == (
        "%1\nG99\nG21\nG90 G00 X1. Y0.\nG91 X1.\nG04 P0.5\nM2\n"
    )
    flat = library.flatten(control="gsk-980mdi")
    assert flat.text == "O1\nG99\nG21\nG90 G00 X1. Y0.\nG91 X1.\nG04 P500\nM2\n"
    assert len(flat.origins) == flat.text.count("\n") - 1
    text = "%_N_PART_MPF\nG90 G1 X1 F100\nG4 F2\nG2 X3 Y0 CR=1\nM30\n"
    library = cncsub.loads(text, control="siemens-one")
    assert library.flatten(control="fanuc-0i-f").text == (
        "O1\nG01\nG90 G01 X1. F100.\nG04 P2000\nG02 X3. Y0. R1.\nM30\n"
    )


@pytest.mark.parametrize(
    ("text", "control", "reason"),
    [
        (
            "G81 X1. R2. Z-1. F100\nM30\n",
            "siemens-one",
            "siemens-one has no code that does what G81",
        ),
        ("#3000=1(NO)\n", "linuxcnc", "#3000 gets a value, and the control has no statement"),
        ("G0 X1.\nM99\n", "linuxcnc", "the program starts over at its end, and linuxcnc does not"),
        ("G91 G0 X1.\nM30\n", "gsk-980tdi", "the program is one of a mill, and gsk-980tdi is a"),
        ("#1=1/3\nG0 X1.\nG61\nM30\n", "siemens-one", "has no code that does what G61 does here"),
    ],
)
def test_what_has_no_words_on_another_control(text: str, control: str, reason: str) -> None:
    library = cncsub.loads("O1\n" + text, control="fanuc-0i-f")
    with pytest.raises(cncsub.FlattenError, match=reason):
        library.flatten(control=control)


@pytest.mark.parametrize(
    ("name", "control", "head"),
    [
        ("part 7.ngc", "siemens-one", "%_N_part_7_MPF"),
        ("xy;M30.ngc", "siemens-one", "%_N_xy_M30_MPF"),
        ("ab\u5de5.ngc", "siemens-one", "%_N_ab__MPF"),
        ("AB)(C.ngc", "siemens-one", "%_N_AB__C_MPF"),
        ("PART20231125.ngc", "fanuc-0i-f", "O20231125"),
        ("PART20231125.ngc", "haas-ngc", "O1"),  # such a number does not exist there
        ("part12345.ngc", "gsk-980mdi", "O1"),
        ("0000.ngc", "mitsubishi-m700", "O1"),
        ("part123456789012345678901.ngc", "fanuc-0i-f", "O1"),
    ],
)
def test_the_name_for_another_control_is_one_there(
    tmp_path: Path, name: str, control: str, head: str
) -> None:
    file = tmp_path / name
    file.write_text("g21 g90 g0 x1 y2\nm2\n", encoding="utf-8")
    flat = cncsub.load(file, control="linuxcnc").flatten(control=control)
    flat.verify()
    assert flat.text.split("\n")[0] == head


def test_for_another_control() -> None:
    library = cncsub.loads(CASES["an expression"][0], control="fanuc-0i-f")
    flat = cncsub.flatten(library, control="mitsubishi-m700")
    assert flat.text == CASES["an expression"][1]
    library = cncsub.loads("O1\nG5.4 P1\nM98 P2\nM30\nO2\nM99\n", control="fanuc-0i-f")
    if library.run().stop == cncsub.Stop.END:
        with pytest.raises(cncsub.FlattenError, match="is a control of a lathe-a"):
            library.flatten(control="gsk-928te")


def test_the_command(tmp_path: Path) -> None:
    text, expected = CASES["calls and repeats"]
    program, out = tmp_path / "p.nc", tmp_path / "flat.nc"
    program.write_text(text)
    command = ["flatten", str(program), "-c", "fanuc-0i-f"]
    done = CliRunner().invoke(app, [*command, "-o", str(out)])
    assert done.exit_code == 0, done.output
    assert out.read_text() == expected
    assert CliRunner().invoke(app, command).output == expected
    program.write_text("O1\nM98 P9\nM30\n")
    done = CliRunner().invoke(app, [*command, "-o", str(out)])
    assert done.exit_code == 2
    assert out.read_text() == expected  # a refused program has written nothing


def test_origins_are_a_table() -> None:
    library = cncsub.loads(CASES["calls and repeats"][0], control="fanuc-0i-f")
    flat = cncsub.flatten(library, comments=True)
    origins = flat.origins
    assert [origins.programs[code] for code in origins["program"]] == ["O1", "O2", "O2", "O1"]
    assert origins.n.tolist() == [10, -1, -1, -1]
    assert origins.line.tolist() == [2, 6, 6, 4]
    assert origins["call"].tolist() == [-1, 0, 0, -1]
    assert origins["pass"].tolist() == [1, 1, 2, 1]
    assert origins[2] == cncsub.Origin("O2", None, 6, 0, 2)
    assert getattr(origins[2], "pass") == 2
    assert [row.line for row in origins] == [2, 6, 6, 4]
    assert origins.to_pandas()["program"].tolist() == ["O1", "O2", "O2", "O1"]
    arrow = origins.to_arrow()
    assert arrow.column_names == origins.columns
    assert arrow["program"].to_pylist() == ["O1", "O2", "O2", "O1"]
    assert repr(origins).splitlines()[0].split() == origins.columns
    with pytest.raises(KeyError, match="blocks have no column 'x'"):
        origins["x"]
    assert "(O1 N10 LINE 2)" in flat.text
    run = library.run()
    assert [run.calls[c].program for c in origins["call"].tolist() if c >= 0] == ["O2", "O2"]


def test_a_long_program_is_written_in_pieces(tmp_path: Path, monkeypatch: Any) -> None:
    text = "O1\nM98 P2 L9999\nM98 P2 L9999\nM30\nO2\nG91 G1 X0.5 Y-0.25 F1000.\nZ#1\nX1.M99\n"
    library = cncsub.loads(text.replace("X1.M99", "X1.\nM99"), control="fanuc-0i-f")
    whole = library.flatten()
    assert len(list(whole.pieces())) == 1
    monkeypatch.setattr("cncsub.analysis.flattening._KEPT", 1000)  # as for a text of over 16 MB
    text = "O1\nM98 P3 L200\nM30\nO3\nM98 P2 L200\nM99\n" + text[text.index("O2") :].replace(
        "X1.M99", "X1.\nM99"
    )
    flat = cncsub.loads(text, control="fanuc-0i-f").flatten()
    pieces = list(flat.pieces())
    assert len(pieces) > 1
    assert all(piece.endswith("\n") for piece in pieces)
    assert repr(flat) == "<Flat: 80,001 blocks>"
    out = tmp_path / "flat.nc"
    flat.write(out)
    assert out.read_text() == "".join(pieces) == flat.text
    assert len(flat.origins) == 80_001
    assert flat.origins.call[-2] == 200
    flat.verify()


# ---- all rows, examples and generated programs ----


def test_every_row_that_ends_is_flattened_or_refused() -> None:
    """`python tests/differential/flat_programs.py --rows` does the same with all of them."""
    refused, done = flat_programs.of_rows(rows()[3::10])
    assert not set(refused) - flat_programs.REASONS
    assert done > 50 * sum(refused.values()), (done, refused)


def test_every_example_is_flattened() -> None:
    assert flat_programs.of_examples() > 100


def test_generated_programs_are_flattened_on_every_control() -> None:
    """`python tests/differential/flat_programs.py --programs 10000` does the same with more."""
    assert flat_programs.of_calls(range(10)) > 100
    assert flat_programs.of_macros(range(60)) > 300
    assert flat_programs.of_other_languages(range(40)) > 100


def test_generated_programs_are_flattened_for_other_controls() -> None:
    """`python tests/differential/flat_programs.py --others 1000` does the same with more."""
    refused, done = flat_programs.of_others(range(0, 6, 2))
    assert not refused, refused
    assert done > 100


def test_verify_runs_both_again() -> None:
    text = "O1\nG90 G0\nM98 P2 L2\nM30\nO2\nG91 X5.\nG90\nM99\n"
    flat = cncsub.flatten(cncsub.loads(text, control="fanuc-0i-f"))
    flat.verify()
    flat.text = flat.text.replace("X5.", "X6.", 1)
    with pytest.raises(AssertionError, match="x = 6"):
        flat.verify()
    flat.text = "O1\nM98 P2\nM30\nO2\nM99\n"
    with pytest.raises(AssertionError):
        flat.verify()


def test_an_end_that_returns_is_not_written_flat() -> None:
    text = "O1\nG0\nM98 P2\nX2.\nM30\nO2\nX9.\nM30\n"
    with pytest.raises(ValueError, match="M02 or M30 returns from a subprogram"):
        cncsub.loads(text, control="syntec-22ma").flatten()


@pytest.mark.parametrize("control", ["gsk-988t", "fanuc-0i-f", "linuxcnc", "siemens-one"])
@pytest.mark.parametrize("name", ["(b)G0X99(", "a%", "MSG, b", 'a"b', "{b}[c]", "b;G0X99"])
def test_a_comment_does_not_end_itself(tmp_path: Path, control: str, name: str) -> None:
    """A program of a file is called as the file, and its name stands in the comments."""
    (tmp_path / f"{name}.nc").write_text("G0 X1.\nM30\n")
    flat = cncsub.load(tmp_path / f"{name}.nc", control=control).flatten(comments=True)
    flat.verify()
    plain = cncsub.load(tmp_path / f"{name}.nc", control=control).flatten().text
    lines = zip(flat.text.splitlines(), plain.splitlines(), strict=True)
    for line, code in lines:
        comment = line.removeprefix(code).strip()
        assert comment[0] in "(;"
        assert not set(comment[1:-1]) & set('()[]{}%,;"')
    assert cncsub.loads(flat.text, control=control).run().stop == "end"


def test_a_message_stays_one_beside_the_comment_of_its_block() -> None:
    """LinuxCNC prints the last comment of a line in brackets."""
    text = "o1 sub\nG0 X1\n(MSG, hello)\n(debug, #1 there)\no1 endsub\no1 call [2]\nM2\n"
    flat = cncsub.loads(text, control="linuxcnc").flatten(comments=True)
    flat.verify()
    again = cncsub.loads(flat.text, control="linuxcnc").run()
    assert list(again.messages) == [" hello", " 2.000000 there"]
    assert "LINE 3" in flat.text


def test_logs_and_prints_of_linuxcnc_stay_what_they_are() -> None:
    text = "#2=50\n(LOGOPEN,a.txt)\n(LOG,x is #2)\n(LOGCLOSE)\n(PRINT, x#2)\n(MSG, hi)\nM2\n"
    library = cncsub.loads(text, control="linuxcnc")
    flat = library.flatten()
    assert flat.text.splitlines() == [
        "(LOGOPEN,a.txt)",
        "(LOG,x is 50.000000)",
        "(LOGCLOSE)",
        "(PRINT, x50.000000)",
        "(MSG, hi)",
        "M2",
    ]
    assert list(cncsub.loads(flat.text, control="linuxcnc").run().messages) == list(
        library.run().messages
    )
    with pytest.raises(cncsub.FlattenError, match="a log is written"):
        library.flatten(control="fanuc-0i-f")


def test_comments_of_flatten_is_true_or_false() -> None:
    library = cncsub.loads("O1\nM30\n", control="fanuc-0i-f")
    with pytest.raises(TypeError, match="comments must be True or False, not 'x'"):
        library.flatten(comments="x")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("words", "flat"),
    [
        ("G1 X=AC(R1+1) Y=IC(R1*2) F100", "G1 X=AC(21) Y=IC(40) F100"),
        ("G2 X10 Y20 I=AC(R1/4) J=IC(R1/2) F100", "G2 X10 Y20 I=AC(5) J=IC(10) F100"),
        ("G1 A=DC(R1) B=ACP(R1+1) C=ACN(R1+2) F100", "G1 A=DC(20) B=ACP(21) C=ACN(22) F100"),
        ("G111 X5 Y5", "G111 X5 Y5"),
        ("G1 RP=R1 AP=IC(R1+10) F100", "G1 RP=20. AP=IC(30) F100"),
        ("G1 X=IC(R1/3) F100", "G1 X=IC(6.667) F100"),
    ],
)
def test_a_computed_value_keeps_the_form_of_its_word(words: str, flat: str) -> None:
    text = f"R1=20\nG111 X1 Y2\nG0 G54 X0 Y0\n{words}\nM30\n"
    setup = {"work_offsets": {"G54": {"X": 100.125, "Y": -20.25}}}
    made = cncsub.loads(text, control="siemens-one").flatten(setup=setup)
    made.verify()
    assert made.text.splitlines()[2].strip() == flat
