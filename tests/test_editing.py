"""Renumbering, renaming and formatting: what changes, what is refused, and that it does the same."""

from __future__ import annotations

import pickle

import pytest

import cncsub
from cncsub.editing import EditError, Edits, format, mention_at, mentions, rename, renumber

MILL = "fanuc-0i-f"


def loaded(
    text: str | dict[str, str], control: str = MILL, name: str | None = None
) -> cncsub.Library:
    return cncsub.loads(text, control=control, name=name)


def after(made: Edits) -> str:
    """Return the text that one file has afterwards."""
    [(name, _, data, _)] = made.library.code.sources
    return made.texts.get(name, data.decode())


# text, control, options, text afterwards
RENUMBERED: list[tuple[str, str, dict[str, object], str]] = [
    (
        "O1\nN1 #1=0\nN2 #1=#1+1\nN3 IF[#1LT3]GOTO2\nM30\n",
        MILL,
        {},
        "O1\nN10 #1=0\nN20 #1=#1+1\nN30 IF[#1LT3]GOTO20\nM30\n",
    ),
    (
        "O1\nN1 M98 P2\nN2 M98 P2\nN9 M30\nO2\nN1 M99 P9\n",
        MILL,
        {"start": 100, "step": 5},
        "O1\nN100 M98 P2\nN105 M98 P2\nN110 M30\nO2\nN100 M99 P110\n",
    ),
    (
        "O1\nG0 X1.\n/M98 P2\nN7 M30\nO2\nM99 P7\n",
        MILL,
        {"which": "all"},
        "O1\nN10 G0 X1.\n/N20 M98 P2\nN30 M30\nO2\nN10 M99 P30\n",
    ),
    (
        "O1\nN1 G0 X1.\nN2 GOTO 4\nN3\nN4 M30\n",
        MILL,
        {"which": "targets"},
        "O1\nG0 X1.\nGOTO 20\nN10\nN20 M30\n",
    ),
    ("O1\nN0010 GOTO 0020\nN0020 M30\n", MILL, {"step": 7}, "O1\nN0010 GOTO 0017\nN0017 M30\n"),
    (
        "O1\nN1 M98 P2 H7\nM30\nO2\nG4 X1.\nN7 M99\n",
        "mitsubishi-m700",
        {},
        "O1\nN10 M98 P2 H10\nM30\nO2\nG4 X1.\nN10 M99\n",
    ),
    (
        "O1\nN1 M97 P7 L2\nM30\nN7 G4 P1.\nM99\n",
        "haas-ngc",
        {},
        "O1\nN10 M97 P20 L2\nM30\nN20 G4 P1.\nM99\n",
    ),
    (
        "O1\nG0 X50 Z2\nG71 U1 R1\nG71 P1 Q2 U0.5 W0.1 F0.2\nN1 G0 X10\nN2 G1 X20 Z-10\nG70 P1 Q2\nM30\n",
        "gsk-980tdi",
        {},
        "O1\nG0 X50 Z2\nG71 U1 R1\nG71 P10 Q20 U0.5 W0.1 F0.2\nN10 G0 X10\nN20 G1 X20 Z-10\n"
        "G70 P10 Q20\nM30\n",
    ),
    (
        "O1\nG65 H81 P5 Q#200 R1\nN4 #201=1\nN5 M30\n",
        "gsk-980tdi",
        {},
        "O1\nG65 H81 P20 Q#200 R1\nN10 #201=1\nN20 M30\n",
    ),
    (
        "N1 R1=0\nN2 R1=R1+1\nIF R1<3 GOTOB N2\nREPEAT N1 N2 P=2\nREPEATB N2\n"
        "CASE R1 OF 1 GOTOF N8 DEFAULT GOTOF N9\nN8 R2=1\nN9 M17\n",
        "siemens-one",
        {"which": "all"},
        "N10 R1=0\nN20 R1=R1+1\nN30 IF R1<3 GOTOB N20\nN40 REPEAT N10 N20 P=2\nN50 REPEATB N20\n"
        "N60 CASE R1 OF 1 GOTOF N70 DEFAULT GOTOF N80\nN70 R2=1\nN80 M17\n",
    ),
    (
        "o100 repeat [2]\ng4 p1\no100 endrepeat\nm2\n",
        "linuxcnc",
        {"which": "all"},
        "N10 o100 repeat [2]\nN20 g4 p1\nN30 o100 endrepeat\nN40 m2\n",
    ),
]


@pytest.mark.parametrize("row", RENUMBERED, ids=lambda row: f"{row[1]}: {row[0][:24]!r}")
def test_blocks_get_new_numbers_with_all_that_names_them(
    row: tuple[str, str, dict[str, object], str],
) -> None:
    text, control, options, expected = row
    library = loaded(text, control, "A.MPF" if control.startswith("siemens") else None)
    made = renumber(library, **options)  # type: ignore[arg-type]
    assert after(made) == expected
    assert made.prove()
    again = renumber(made.after, **options)  # type: ignore[arg-type]
    assert again.empty


def test_a_jump_to_one_of_two_blocks_of_a_number_keeps_its_block() -> None:
    library = loaded("O1\nN5 #1=#1+1\nIF[#1GT3]GOTO9\nGOTO5\nN5 GOTO6\nN6 G4 X1.\nN9 M30\n")
    before = [jump.block for block in library["O1"].blocks for jump in block.jumps]
    made = renumber(library)
    assert [j.block for block in made.after["O1"].blocks for j in block.jumps] == before
    assert made.notes == ("O1: N5 is in lines 2, 5; each has its own number now",)


def test_a_number_that_leads_nowhere_is_kept_and_no_block_gets_it() -> None:
    made = renumber(loaded("O1\nN1 GOTO 20\nN2 G4 X1.\nN3 M30\n"))
    assert after(made) == "O1\nN10 GOTO 20\nN30 G4 X1.\nN40 M30\n"


# text, control, options, the beginning of each cause
REFUSED: list[tuple[str, str, dict[str, object], list[str]]] = [
    ("O1\nN1 GOTO#1\nN2 M30\n", MILL, {}, ["O1 N1, line 2: #1 names a block that is known only"]),
    (
        "O1\nN1 M98 P2\nM30\nO2\nM99 P#1\nO3\nN7 M30\n",
        MILL,
        {},
        ["O2, line 5: #1 names a block that is known only"],
    ),
    (
        "O1\nG4 X1.\nM98 P3\nN9 M30\nO2\nM98 P3\nN8 G4 X1.\nN9 M99\nO3\nM99 P9\n",
        MILL,
        {},
        ["O3, line 10: 9 names blocks of several programs, which would become N10, N20"],
    ),
    ("O1\nN1 M98 P2 H#1\nM30\nO2\nN7 M99\n", "mitsubishi-m700", {}, ["O1 N1, line 2: #1 names"]),
    (
        "O1\nN1 G0\nN2 G0\nN3 M30\n",
        "fanuc-16i",
        {"start": 99999},
        ["O1 N2, line 3: it would be N100009, and the control has numbers to 99999"],
    ),
]


@pytest.mark.parametrize("row", REFUSED, ids=lambda row: f"{row[1]}: {row[0][:24]!r}")
def test_what_cannot_be_followed_is_refused_by_name(
    row: tuple[str, str, dict[str, object], list[str]],
) -> None:
    text, control, options, causes = row
    with pytest.raises(EditError) as refused:
        renumber(loaded(text, control), **options)  # type: ignore[arg-type]
    found = refused.value.reasons
    assert len(found) == len(causes)
    for cause, beginning in zip(found, causes, strict=True):
        assert cause.startswith(beginning)


def test_only_the_programs_that_are_named_get_new_numbers() -> None:
    library = loaded("O1\nN1 M98 P2\nN2 M30\nO2\nN3 M99 P2\n")
    assert after(renumber(library, ["O1"])) == "O1\nN10 M98 P2\nN20 M30\nO2\nN3 M99 P20\n"


def test_wrong_options_are_told() -> None:
    library = loaded("O1\nM30\n")
    for options in ({"start": -1}, {"step": 0}, {"which": "some"}):
        with pytest.raises(ValueError, match=next(iter(options))):
            renumber(library, **options)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="step"):
        renumber(library, step=1.5)  # type: ignore[arg-type]
    with pytest.raises(KeyError):
        renumber(library, ["O7"])


# text, control, what, new, text afterwards
RENAMED = [
    (
        "O1\nN1 M98 P30002\nG65 P2 A1.\nM98 P0002 L2\nM30\nO2 (t)\nM99\n",
        MILL,
        "O2",
        "O7",
        "O1\nN1 M98 P30007\nG65 P7 A1.\nM98 P0007 L2\nM30\nO7 (t)\nM99\n",
    ),
    (
        "O1\n#1=2\n#100=#1+#10\nM98 P2\nM30\nO2 (#1)\n#3=#1*2\nM99\n",
        MILL,
        "#1",
        "#7",
        "O1\n#7=2\n#100=#7+#10\nM98 P2\nM30\nO2 (#1)\n#3=#7*2\nM99\n",
    ),
    (
        "O1\n#100=1\nG65 P2\nM30\nO2\n#1=#100\nDPRNT[X#100[53]]\nM99\n",
        MILL,
        "#100",
        "#120",
        "O1\n#120=1\nG65 P2\nM30\nO2\n#1=#120\nDPRNT[X#120[53]]\nM99\n",
    ),
    ("O1\nN1 GOTO20\nN20 M30\n", MILL, "N20", 100, "O1\nN1 GOTO100\nN100 M30\n"),
    (
        "AGAIN: R1=R1+1\nIF R1<3 GOTOB AGAIN\nM17\n",
        "siemens-one",
        "AGAIN",
        "NEXT",
        "NEXT: R1=R1+1\nIF R1<3 GOTOB NEXT\nM17\n",
    ),
    (
        'DEF REAL LENG=3\nLENG=LENG*2\nMSG("LENG")\nR1=LENG ; LENG\nM17\n',
        "siemens-one",
        "LENG",
        "WIDE",
        'DEF REAL WIDE=3\nWIDE=WIDE*2\nMSG("LENG")\nR1=WIDE ; LENG\nM17\n',
    ),
    (
        "%1\nN1 M98 P2\nM30\n%2\nM99\n",
        "hnc-21m",
        "O2",
        9,
        "%1\nN1 M98 P9\nM30\n%9\nM99\n",
    ),
    ("R1=2\nR2=R1*R11\nM17\n", "siemens-one", "R1", "R5", "R5=2\nR2=R5*R11\nM17\n"),
    (
        "o<ab> sub\n#<x>=1\n(debug, #<x>)\no<ab> endsub\no<ab> call [1]\nm2\n",
        "linuxcnc",
        "ab",
        "cd",
        "o<cd> sub\n#<x>=1\n(debug, #<x>)\no<cd> endsub\no<cd> call [1]\nm2\n",
    ),
    (
        "o100 repeat [2]\ng4 p1\no100 endrepeat\nm2\n",
        "linuxcnc",
        "100",
        "200",
        "o200 repeat [2]\ng4 p1\no200 endrepeat\nm2\n",
    ),
]


@pytest.mark.parametrize("row", RENAMED, ids=lambda row: f"{row[1]}: {row[2]}")
def test_a_thing_is_renamed_with_all_that_names_it(row: tuple[str, str, str, object, str]) -> None:
    text, control, what, new, expected = row
    library = loaded(text, control, "A.MPF" if control.startswith("siemens") else None)
    made = rename(library, what, new)  # type: ignore[arg-type]
    assert after(made) == expected
    assert made.prove().ran


def test_the_place_of_any_mention_names_the_thing() -> None:
    library = loaded("O1\nN1 GOTO20\nN20 M30\n")
    texts = {
        after(rename(library, ("<text>", line, column), 30)) for line, column in ((2, 8), (3, 3))
    }
    assert texts == {"O1\nN1 GOTO30\nN30 M30\n"}
    assert mention_at(library, "<text>", 3, 6) is None
    with pytest.raises(KeyError, match="nothing at <text>:3:6"):
        rename(library, ("<text>", 3, 6), 30)


def test_a_program_that_its_file_names_tells_the_new_name_of_the_file() -> None:
    job = {"MAIN.MPF": "SUBA(3)\nM17\n", "SUBA.SPF": "PROC SUBA(REAL LEN)\nR1=LEN\nM17\n"}
    made = rename(loaded(job, "siemens-one"), "SUBA", "SUBB")
    assert made.files == {"SUBA.SPF": "SUBB.SPF"}
    assert made.texts == {
        "MAIN.MPF": "SUBB(3)\nM17\n",
        "SUBA.SPF": "PROC SUBB(REAL LEN)\nR1=LEN\nM17\n",
    }
    assert made.prove().ran == ("MAIN",)


# text, control, what, new, a part of the first cause
NOT_RENAMED = [
    ("O1\nN1 GOTO20\nN20 M30\n", MILL, "N20", 1, "N1 stands here already"),
    ("O1\nM98 P2\nM30\nO2\nM99\nO3\nM99\n", MILL, "O2", 3, "O3 stands here already"),
    ("O1\nM98 P2\nM98 P#1\nM30\nO2\nM99\n", MILL, "O2", 3, "#1 is computed, and may name O2"),
    ("O1\n#1=#[#2]\nM30\n", MILL, "#1", 5, "computed, and may name #1"),
    ("O1\n#1=2\n#5=1\nM30\n", MILL, "#1", 5, "#5 stands here already"),
    ("O1\n#1=2\nM30\n", MILL, "#1", 100, "#1 is local and #100 is common"),
    ("O1\nG65 P2 A1.\nM30\nO2\n#3=#1\nM99\n", MILL, ("<text>", 5, 5), 5, "A1. means #1"),
    ("O1\nM98 P2\nM30\nO2\nM99\n", "gsk-928te", "O2", 300, "the control has numbers to 254"),
    (
        "N1 CYCLE84(5,0,1,-5,,,,3,,1)\nM30\n",
        "siemens-one",
        ("<text>", 1, 5),
        "NEWER",
        "a program of the control",
    ),
    ("#1=#<_x>\nM2\n", "linuxcnc", ("<text>", 1, 7), "new", "_x means"),
    ("O1\nN1 GOTO20\nN20 M30\n", "fanuc-16i", "N20", 100000, "the control has numbers to 99999"),
]


@pytest.mark.parametrize("row", NOT_RENAMED, ids=lambda row: f"{row[2]} to {row[3]}: {row[4]}")
def test_a_name_that_would_mean_something_else_is_refused(
    row: tuple[str, str, str, int, str],
) -> None:
    text, control, what, new, cause = row
    with pytest.raises(EditError) as refused:
        rename(loaded(text, control), what, new)
    assert cause in refused.value.reasons[0]


# text, control, options, text afterwards
FORMATTED: list[tuple[str, str, dict[str, object], str]] = [
    (
        "O1\nWHILE[#1LT3]DO1\ng91g 1x10f100(cut)\n#1=#1+1\nEND1\n/2N20G4X1\nM30\n%\n",
        MILL,
        {},
        "O1\nWHILE[#1LT3]DO1\n  G91 G1 X10 F100 (cut)\n  #1=#1+1\nEND1\n/2N20 G4 X1\nM30\n%\n",
    ),
    ("O1\nG0  X1.  Y2. (a) (b)\nM30\n", MILL, {"spacing": "none"}, "O1\nG0X1.Y2.(a)(b)\nM30\n"),
    ("O1\n  g0 x1.\nM30\n", MILL, {"indent": None}, "O1\n  G0 X1.\nM30\n"),
    ("O1\ng0x1.\nM30\n", MILL, {"capitals": False}, "O1\ng0 x1.\nM30\n"),
    (
        'if R1==2\nmsg("hello; a"); note\nelse\nG0 x=r1\nENDIF\nM17\n',
        "siemens-one",
        {},
        'IF R1==2\n  MSG("hello; a") ; note\nELSE\n  G0 X=R1\nENDIF\nM17\n',
    ),
    (
        "o<ab> sub\ng1 x1 f100 (Aa)\no<ab> endsub\no1 do\n#<x>=[#<x>+1]\no1 while [#<x> lt 3]\nm2\n",
        "linuxcnc",
        {"capitals": False},
        "o<ab> sub\n  g1 x1 f100 (Aa)\no<ab> endsub\no1 do\n  #<x>=[#<x>+1]\no1 while [#<x> lt 3]\nm2\n",
    ),
    # loops that ask at their end
    (
        "o1 do\no2 if [#<x> gt 1]\ng0 x1\no2 endif\n#<x>=[#<x>+1]\no1 while [#<x> lt 3]\nm2\n",
        "grblhal",
        {"capitals": False},
        "o1 do\n  o2 if [#<x> gt 1]\n    g0 x1\n  o2 endif\n  #<x>=[#<x>+1]\no1 while [#<x> lt 3]\nm2\n",
    ),
    (
        "%@MACRO\n#1 := 0;\nREPEAT\n#1 := #1+1;\nREPEAT\n#2 := #2+1;\nUNTIL #2 > 3 END_REPEAT;\n"
        "UNTIL #1 > 3 END_REPEAT;\nM30;\n",
        "syntec-22ma",
        {},
        "%@MACRO\n#1 := 0;\nREPEAT\n  #1 := #1+1;\n  REPEAT\n    #2 := #2+1;\n  UNTIL #2 > 3 END_REPEAT;\n"
        "UNTIL #1 > 3 END_REPEAT;\nM30;\n",
    ),
    (
        "REPEAT\nR1=R1+1\nUNTIL R1>3\nM30\n",
        "siemens-one",
        {},
        "REPEAT\n  R1=R1+1\nUNTIL R1>3\nM30\n",
    ),
]


@pytest.mark.parametrize("row", FORMATTED, ids=lambda row: f"{row[1]}: {row[0][:20]!r}")
def test_blocks_are_laid_out_alike(row: tuple[str, str, dict[str, object], str]) -> None:
    text, control, options, expected = row
    library = loaded(text, control, "A.MPF" if control.startswith("siemens") else None)
    made = format(library, **options)  # type: ignore[arg-type]
    assert after(made) == expected
    assert format(made.after, **options).empty  # type: ignore[arg-type]
    made.prove()


def test_points_are_added_only_where_they_mean_nothing() -> None:
    text = "O1\nG0X10Y-5\nG4X1\nM30\n"
    kinds = {}
    for name, control in cncsub.controls.items():
        if control.rules and any(rule.name == "whole_numbers" for rule in control.rules):
            value = next(rule.value for rule in control.rules if rule.name == "whole_numbers")
            kinds.setdefault(value, name)
    pointed = format(loaded(text, kinds["millimetres"]), points=True)
    assert after(pointed) == "O1\nG0 X10. Y-5.\nG4 X1\nM30\n"
    stays = format(loaded(text, kinds["increments"]), points=True)
    assert after(stays) == "O1\nG0 X10 Y-5\nG4 X1\nM30\n"
    assert "no point is added" in stays.notes[0]


LITERAL = [
    ("O1\nPOPEN\ndprnt[x#100[53]y  #101[53]abc]\nPCLOS\nM30\n", MILL, "[x#100[53]y  #101[53]abc]"),
    ("O1\nPOPEN\nbprnt [c**x#100[3]y  z]\nPCLOS\nM30\n", MILL, "[c**x#100[3]y  z]"),
    ("O1\nPOPEN\nif[#1EQ#0]then dprnt[a  b]\nPCLOS\nM30\n", MILL, "[a  b]"),
    ("o1\ndprnt[x  #1[32]]\nm30\n", "haas-ngc", "[x  #1[32]]"),
    ("o1\ndprnt[x  #1[32]]\nm30\n", "mitsubishi-m800", "[x  #1[32]]"),
    ("o1\n#3006=1(check  the tool)\nm30\n", MILL, "(check  the tool)"),
    ("(msg, hello  there)\n(debug,x is  #1)\ng0x1\nm2\n", "linuxcnc", "(debug,x is  #1)"),
    ('msg("hello  x1")\ng0x1\nm30\n', "siemens-one", '"hello  x1"'),
    (
        '%@MACRO\nmsg(100,"say (x  =1) g0");\ng0x1;\nm30;\n',
        "syntec-22ma",
        '(100,"say (x  =1) g0")',
    ),
    ('%@MACRO\nalarm(3,"a (b) ;// c");\ng0x1;\nm30;\n', "syntec-22ma", '(3,"a (b) ;// c")'),
]


@pytest.mark.parametrize("row", LITERAL, ids=lambda row: f"{row[1]}: {row[2]}")
def test_what_a_block_prints_stays_as_it_is_written(row: tuple[str, str, str]) -> None:
    text, control, literal = row
    made = format(loaded(text, control))
    assert literal in after(made)
    assert after(made) != text
    made.prove()


def test_the_number_of_a_main_block_is_laid_out_and_renumbered() -> None:
    text = "g0x1\n:20 g1x2f100\nn30 m30\n"
    made = format(loaded(text, "siemens-840d-sl"))
    assert after(made) == "G0 X1\n:20 G1 X2 F100\nN30 M30\n"
    assert made.prove().ran == ("MAIN",)
    made = renumber(loaded(text, "siemens-840d-sl"), start=100)
    assert after(made) == "g0x1\n:100 g1x2f100\nn110 m30\n"
    text = ":20 G0 X1\nN30 GOTOF 50\nN40 G0 X9\n:50 M30\n"
    made = rename(loaded(text, "siemens-one"), "N50", 70)
    assert after(made) == text.replace("50", "70")


def test_files_that_nobody_read_are_told() -> None:
    for edit in (format, renumber):
        with pytest.raises(KeyError, match="no file 'O9.nc' was read"):
            edit(loaded("O1\nM30\n"), files=["O9.nc"])
        with pytest.raises(TypeError, match="a list of names"):
            edit(loaded("O1\nM30\n"), files="<text>")


PROFILE = "O1\nN1 G0 X9. Z5.\nN3 G71 P4 Q6 U0.5 W0.1 F0.2\nN4 G0 X2.\nN6 X9.\nN8 M30\n"


def test_a_cycle_that_a_mill_has_not_may_name_blocks() -> None:
    with pytest.raises(EditError, match=r"P4 may name a block: .* lathe") as told:
        renumber(loaded(PROFILE))
    assert "known only when" not in str(told.value)
    with pytest.raises(EditError, match="P4 may name N4"):
        rename(loaded(PROFILE), "N4", 5)
    assert "N9 M30" in after(rename(loaded(PROFILE), "N8", 9))
    assert after(rename(loaded(PROFILE), "N4", 5, machine="lathe-a")) == PROFILE.replace("4", "5")


def test_a_place_is_read_for_the_kind_of_machine() -> None:
    at = ("<text>", 3, PROFILE.splitlines()[2].index("P4") + 2)
    found = rename(loaded(PROFILE), at, 5, machine="lathe-a")
    assert after(found) == PROFILE.replace("4", "5")


def test_an_error_goes_to_another_process_and_back() -> None:
    with pytest.raises(EditError) as told:
        renumber(loaded("O1\nN1 GOTO#1\nN2 GOTO#2\nM30\n"))
    again = pickle.loads(pickle.dumps(told.value))
    assert (str(again), again.reasons) == (str(told.value), told.value.reasons)
    assert len(again.reasons) == 2


def test_a_variable_is_called_as_the_control_writes_it() -> None:
    found = mentions(loaded("R5=1\nG0 X=R5\nM30\n", "siemens-one"), "variable")
    assert [m.shown for m in found] == ["R5", "R5"]
    with pytest.raises(EditError, match="R5 is .* and R90000 is no variable"):
        rename(loaded("R5=1\nM30\n", "siemens-one"), "R5", 90000)


def test_every_mention_is_where_it_says() -> None:
    text = "O1 (é)\nN1 (漢) M98 P2\nGOTO 1\n#100=#1\nM30\nO2\nM99 P1\n"
    library = loaded(text)
    lines = text.split("\n")
    found = [m for m in mentions(library) if m.text]
    assert len(found) > 7
    for m in found:
        assert lines[m.line - 1][m.column - 1 : m.end - 1] == m.text


def test_a_part_whose_block_a_text_names_is_not_renumbered() -> None:
    text = 'N1 DEF STRING[20] END1="N40"\nN15 CALL BLOCK ONE1 TO END1\nN30 ONE1: R1=1\nN40 R2=2\nN60 M30\n'
    library = cncsub.loads(text, control="siemens-one")
    with pytest.raises(EditError, match="END1"):
        renumber(library)
