"""Every pair of controls: what they do alike is reported as alike, and a program made for another
control does the same there or is refused with a reason.
"""

from __future__ import annotations

import itertools
import random
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.questions.asking import ISO_FAMILY

CONTROLS = list(cncsub.controls)
MILL = {"machine": "mill"}
ISO = [name for name in CONTROLS if cncsub.controls[name].dialect in ISO_FAMILY]

# Blocks that all controls read alike; X of a mill and of a lathe is not the same.
_ALONG_Z = "N10 G0 Z50.\nN20 Z10.\nN30 M8\nN40 M3 S500\nN50 G0 Z100.\nN60 M5\nN70 M30\n"
_IN_THE_PLANE = """N10 G17 G90 G94 G0 X10. Y5.
N20 G1 X50. F100.
N30 G91 X10.
N40 G90
N50 G2 X70. Y15. I10. J0.
N60 M8
N70 G0 Z100.
N80 M2
"""
_CALLS = """O1
N10 G90 G94 G0 X10. Y5.
N20 M98 P2
N30 G0 Z100.
N40 M30
O2
N50 G1 X20. F100.
N60 M99
"""
_DRILLS = """O1
N10 G90 G94 G0 X10. Y5. Z50.
N20 G98 G81 X20. Y6. R2. Z-5. F100.
N30 X30.
N40 G80
N50 G0 Z100.
N60 M30
"""
SIEMENS = tuple(name for name in CONTROLS if name.startswith("siemens"))
_LACK = {
    _ALONG_Z: (),
    _IN_THE_PLANE: ("gsk-928te", "gsk-980tdi"),  # these have no G17, or no G91
    _CALLS: (
        "gsk-928te",
        "grblhal",
        "okuma-osp-p300",
        *SIEMENS,
    ),  # these have no line O1, or no M98
    _DRILLS: (
        "gsk-928te",
        "gsk-980tdi",
        "gsk-988t",
        "gsk-988ta",
        "grblhal",
        "okuma-osp-p300",
        *SIEMENS,
    ),
}


@pytest.mark.parametrize("text", _LACK, ids=["along Z", "in the plane", "calls", "drills"])
def test_what_every_pair_does_alike_is_the_same(text: str) -> None:
    setup = None if text == _ALONG_Z else MILL
    names = [name for name in CONTROLS if name not in _LACK[text]]
    for one, other in itertools.permutations(names, 2):
        library = cncsub.loads(text, control=one)
        compared = cncsub.compare(library, controls=[one, other], setup=setup)
        assert compared.same, compared.what


@pytest.mark.parametrize("other", ["linuxcnc", "siemens-one", "mitsubishi-m700"])
def test_what_two_controls_do_otherwise_stands_behind_no_head_and_no_end(other: str) -> None:
    text = "N10 G1 X10. F100.\nN20 G4 P100\nN30 M30\n"
    compared = cncsub.compare(
        cncsub.loads(text, control="fanuc-0i-f"), controls=["fanuc-0i-f", other], setup=MILL
    )
    assert compared.same == (other == "mitsubishi-m700")
    assert compared.same or compared.where is not None
    if compared.where is not None:
        assert [step.line if step else 2 for step in compared.where] == [2, 2]


def test_a_head_that_one_language_counts_as_a_block_hides_no_difference() -> None:
    text = "O1\nN10 M98 P2 L2\nN20 M30\nO2\nN30 #100=#100+1\nN40 G0 X#100\nN50 M99\n"
    compared = cncsub.compare(
        cncsub.loads(text, control="fanuc-0i-f"), controls=["fanuc-0i-f", "linuxcnc"]
    )
    assert not compared.same
    assert compared.where is not None
    assert compared.where[0] is not None
    assert [step.n for step in compared.where if step] == [30]  # LinuxCNC wants brackets here
    written = text.replace("#100+1", "[#100+1]")
    library = cncsub.loads(written, control="fanuc-0i-f")
    assert cncsub.compare(library, controls=["fanuc-0i-f", "linuxcnc"], variables={100: 0}).same


def test_other_blocks_of_the_same_moves_are_a_difference() -> None:
    text = "O1\nN10 IF[#100 EQ #0]GOTO 40\nN20 #101=1\nN40 G0 X1.\nN50 M30\n"
    library = cncsub.loads(text, control="fanuc-0i-f")
    control = cncsub.controls["fanuc-0i-f"].replace(vacant_comparison="zero")
    assert cncsub.compare(library, controls=["fanuc-0i-f", control]).same


# ---- a diameter is a diameter ----


@pytest.mark.parametrize("pair", [("gsk-988ta", "fanuc-0i-f"), ("fanuc-0i-f", "gsk-980tdi")])
def test_x_of_a_lathe_is_none_of_a_mill(pair: tuple[str, str]) -> None:
    one, other = pair
    library = cncsub.loads("O1\nN10 G0 X100. Z0\nN20 M30\n", control=one)
    with pytest.raises(cncsub.FlattenError, match="lathe"):
        library.flatten(control=other)
    compared = cncsub.compare(library, controls=[one, other])
    assert not compared.same
    assert "mm long" in compared.what
    along_z = cncsub.loads("O1\nN10 G0 Z100.\nN20 M30\n", control=one).flatten(control=other)
    along_z.verify()


# ---- repeats of a cycle ----

_REPEATED = """O1
N10 G90 G94 G0 X0. Y0. Z50.
N20 G91 G98 G81 X10. Y0. R-40. Z-15. F100. {letter}3
N30 X5. {letter}2
N40 G80
N50 M98 P2
N60 M30
O2
N70 G90 G0 Z60.
N80 M99
"""
_COUNTS = {
    name: str(
        next(rule.value for rule in cncsub.controls[name].rules if rule.name == "cycle_repeats")
    )
    for name in CONTROLS
    if name not in _LACK[_DRILLS]
}


def test_counts_of_cycles_are_written_as_the_other_control_counts() -> None:
    iso = [name for name in _COUNTS if name in ISO]
    for one, other in itertools.permutations(iso, 2):
        library = cncsub.loads(_REPEATED.format(letter=_COUNTS[one][0]), control=one)
        made = cncsub.translate(library, other, setup=MILL)
        assert (
            f" {_COUNTS[other][0]}3" in made.library["O1"].text
            or one == other
            or (_COUNTS[one][0] in _COUNTS[other])
        )
        assert "M98 P2" in made.library["O1"].text
        library.flatten(control=other, setup=MILL).verify()


def test_a_cycle_written_for_another_control_keeps_its_dwell_and_its_holes() -> None:
    """P is thousandths or seconds; an L or K that counts nothing here is not written where it
    counts.
    """
    mills = ["fanuc-0i-f", "gsk-980mdi", "haas-ngc", "hnc-21m", "mitsubishi-m700", "linuxcnc"]
    for one, other in itertools.permutations(mills, 2):
        head = "" if one == "linuxcnc" else "%1\n" if one == "hnc-21m" else "O1\n"
        dwell = "P0.5" if one in ("hnc-21m", "linuxcnc") else "P500"
        counts = "" if one == "linuxcnc" else "L3" if one == "fanuc-0i-f" else "K3"
        if one in ("gsk-980mdi", "hnc-21m"):  # there both count, or K is something else
            counts = ""
        text = f"{head}G90 G0 Z5.\nG98 G82 X5. Z-5. R2. {dwell} F100. {counts}\nG80\nM30\n"
        library = cncsub.loads(text, control=one)
        flat = cncsub.flatten(library, control=other)
        made = cncsub.loads(flat.text, control=other).run()
        assert [(m.kind, m.time) for m in made.moves if m.kind == "dwell"] == [("dwell", 0.5)]
        assert len(made.moves) == len(library.run().moves), (one, other)


def test_a_line_before_any_feed_is_written_where_it_moves() -> None:
    """LinuxCNC refuses G01 without an axis while no feed is in force; here it is in force at
    power-on.
    """
    for blocks in (
        "G0 X1.\nG1\nF100\nX5.",
        "F100\nX5.",
        "G1 F100\nX5.",
        "G1 X5. F100",
        "G4 P500\nF100\nX5.",
        "G81 X1. Z-5. R-1. F100\nX3.\nG80\nX9.",
        "G1\nG81 X1. Z-5. R-1. F100\nG80\nG1 X9.",
        "G1\nG0 X1.\nX2.",
        "G21 G1\nF100\nX5.",
    ):
        library = cncsub.loads(f"O1\n{blocks}\nM30\n", control="mitsubishi-m700")
        flat = cncsub.flatten(library, control="linuxcnc")
        made = cncsub.loads(flat.text, control="linuxcnc").run()
        assert made.stop == cncsub.Stop.END, flat.text
        assert len(made.moves) == len(library.run().moves), flat.text


def test_a_count_that_is_computed_keeps_its_expression() -> None:
    text = _REPEATED.format(letter="K").replace("K3", "K#100")
    made = cncsub.translate(
        cncsub.loads(text, control="fanuc-0i-f"), "haas-ngc", setup=MILL, variables={100: 3}
    )
    assert "L#100" in made.library["O1"].text


# ---- a program that verifies, or a refusal ----


def test_values_of_variables_that_the_other_control_lacks() -> None:
    library = cncsub.loads("O1\nN10 G0 X#100\nN20 M30\n", control="fanuc-0i-f")
    flat = library.flatten(control="siemens-one", variables={100: 5})
    assert "X5" in flat.text
    with pytest.raises(ValueError, match="siemens-one has no R100"):
        cncsub.compare(library, controls=["fanuc-0i-f", "siemens-one"], variables={100: 5})
    with pytest.raises(cncsub.TranslateError, match="siemens-one has no R100"):
        cncsub.translate(library, "siemens-one", variables={100: 5})


@pytest.mark.parametrize("control", CONTROLS)
def test_an_alarm_that_a_program_may_not_raise_is_refused(control: str) -> None:
    library = cncsub.loads("O1\nN10 #3000=-1\nN20 M30\n", control="fanuc-0i-f")
    with pytest.raises(cncsub.FlattenError, match="alarm"):
        library.flatten(control=control)


_WORDS = """G0 X10.|G1 X3 Z2. F100|X-5|G91|G90|G4 P100|M3 S500|M8|M98 P2|M98 P2 L2|#100=1|#100=#100+1.
G0 X#100|#3000=5(TEXT)|#3000=-1|IF[#100 LT 3]GOTO 20|GOTO 30|G81 X3. R2. Z-5. F100. K2|G83 X1. Z-9. R1. Q2. F80. L3
G80|G20|G21|G55|G10 L2 P1 X5.|T0101|M6|G41 D1|G40|G2 X10. Y2. R50.|G3 X3. Y7. I5. J0|G96 S100|G50 S2000|G92 X3.
G52 X1.|G65 P2 A1. B2.|G66 P2 A1.|G67|M99 P30|#5221=3.|DPRNT[X#100[42]]|#[100]=3|WHILE[#100 LT 3]DO1|END1|M0|M2|M30
M97 P30|M17|RET|R1=5|X=R1|#<a>=3|G28 U0 W0|G53 X0|G68 X0 Y0 R30.|G69|G51 X0 Y0 P2.|G7|G8|%|O3|<NAME>|中|é\udcff|MSG("x")
G94|G95|G98|G99|G32 Z-5. F1.|G04 F2|G4 S3|/X3.|N30 X1.|M198 P2|X1/2|X-|M3 M4|M71|#0=1|G43 H1|G49|LAB: IF R1==1|ENDIF"""


def _program(rng: random.Random) -> bytes:
    words = [word for line in _WORDS.splitlines() for word in line.split("|")]
    lines = [rng.choice(words) for _ in range(rng.randint(1, 6))]
    body = "".join(f"N{i}0 {line}\n" for i, line in enumerate(lines, 1))
    head = rng.choice(["O1\n", "", "%\nO1\n", "%_N_MAIN_MPF\n"])
    sub = rng.choice(["O2\n", "%_N_L2_SPF\n"]) + rng.choice(words) + "\n"
    text = head + body + "M30\n" + sub + rng.choice(["M99", "M17", ""]) + "\n"
    return text.encode("utf-8", "surrogateescape")


@pytest.mark.parametrize("seed", range(20))
def test_random_programs_between_controls(seed: int) -> None:
    rng = random.Random(seed)
    for _ in range(10):
        text = _program(rng)
        one, other = rng.choice(CONTROLS), rng.choice(CONTROLS)
        setup = rng.choice([None, MILL, {"machine": "lathe-a"}])
        library = cncsub.loads(text, control=one)
        cncsub.compare(library, controls=[one, other], setup=setup, max_blocks=300)
        for make in (_flat, _translated):
            reason = make(library, other, setup)
            assert reason is None or reason.strip()


def _flat(library: cncsub.Library, other: str, setup: dict[str, str] | None) -> str | None:
    """Return why there is no flat program for another control; `None` if there is one that
    verifies.
    """
    try:
        library.flatten(control=other, setup=setup, max_blocks=300).verify()
    except ValueError as refusal:
        return str(refusal)
    return None


def _translated(library: cncsub.Library, other: str, setup: dict[str, str] | None) -> str | None:
    try:
        cncsub.translate(library, other, setup=setup, max_blocks=300)
    except ValueError as refusal:
        return str(refusal)
    return None


# ---- the words of a language belong to the language ----

_RETURNS = dict.fromkeys(SIEMENS, "M17")


def _files(folder: Path, control: str) -> Path:
    if control in SIEMENS:
        (folder / "MAIN.MPF").write_text("N10 SUB_A\nN20 SUB_A\nN30 M30\n")
        (folder / "SUB_A.SPF").write_text("N40 G0 X1\n")
        return folder / "SUB_A.SPF"
    (folder / "O1.nc").write_text("O1\nN10 M98 P2\nN20 M98 P2\nN30 M30\n")
    (folder / "O2.nc").write_text("O2\nN40 G0 X1.\n")
    return folder / "O2.nc"


# LinuxCNC needs the label of a return, a file of grblHAL returns where it ends, and no code of an
# OSP is a return.
_ADD_NO_RETURN = ("linuxcnc", "grblhal", "gsk-928te", "okuma-osp-p300")


@pytest.mark.parametrize("control", [n for n in CONTROLS if n not in _ADD_NO_RETURN])
def test_a_return_that_is_added_is_the_controls_own_and_is_added_once(
    control: str, tmp_path: Path
) -> None:
    sub = _files(tmp_path, control)
    command = ["check", str(tmp_path), "-c", control, "--rule", "CS303", "--main"]
    command.append("MAIN" if control in SIEMENS else "O1")
    runner = CliRunner()
    before = runner.invoke(app, command)
    assert "CS303" in before.output
    assert _RETURNS.get(control, "M99") in before.output
    assert runner.invoke(app, [*command, "--fix"]).exit_code == 0
    mended = sub.read_text()
    assert mended.splitlines()[-1] == _RETURNS.get(control, "M99")
    assert "CS303" not in runner.invoke(app, [*command, "--fix"]).output
    assert sub.read_text() == mended


@pytest.mark.parametrize("control", ["siemens-one", "linuxcnc"])
def test_texts_of_a_language_name_no_words_of_another(control: str) -> None:
    main = (
        "N10 IF R1==1\nN20 G0 X1\n" if control == "siemens-one" else "N10 (debug,#1)\nN20 G0 X1\n"
    )
    told = [f"{f.message} {f.hint}" for f in cncsub.loads(main, control=control).check()]
    assert told
    for text in told:
        assert "#0" not in text
        assert "G65" not in text
        if control == "siemens-one":
            assert "M99" not in text


def test_the_count_of_a_call_is_named_as_it_is_written() -> None:
    text = "%_N_MAIN_MPF\nN10 L100 P10000\nN20 M30\n%_N_L100_SPF\nN40 M17"
    alarm = cncsub.loads(text, control="siemens-one").run().alarm
    assert alarm is not None
    assert "P is 10000" in str(alarm)


def test_modes_that_proc_saves_are_not_left_on() -> None:
    text = "%_N_MAIN_MPF\nN10 G90 G0 X0\nN20 SUB_A\nN30 X5\nN40 M30\n%_N_SUB_A_SPF\nPROC SUB_A{save}\nN50 G91 X3\nN60 M17\n"
    for save, found in (("", ["CS501"]), (" SAVE", []), ("(REAL A) SAVE DISPLOF", [])):
        library = cncsub.loads(text.format(save=save), control="siemens-one")
        assert [f.rule for f in library.check(rules=["CS501"])] == found
