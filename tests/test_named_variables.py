"""The variables that programs define, by name."""

import pytest

import cncsub
from cncsub import _core

TEXT = """
N10 DEF INT COUNT=2, SIDES[2,3]=SET(1,2,3,4,5,6)
N20 DEF REAL DEPTH=-2.5
N30 DEF BOOL FLAG=TRUE
N40 DEF STRING[8] NAME="A", TAGS[2]
N50 DEF AXIS WAY=Y
N55 DEF REAL LATE=7
N60 NAME=NAME<<COUNT
N70 TAGS[1]="ä"
N80 R1=5
N95 M30
"""


def test_values_are_those_of_their_types() -> None:
    named = cncsub.loads(TEXT, control="siemens-one").run().variables.named
    assert named == {
        "COUNT": 2,
        "SIDES": [[1, 2, 3], [4, 5, 6]],
        "DEPTH": -2.5,
        "FLAG": True,
        "NAME": "A2",
        "TAGS": ["", "ä"],
        "WAY": "Y",
        "LATE": 7.0,
    }
    assert [type(named[name]) for name in ("COUNT", "DEPTH", "FLAG", "NAME")] == [
        int,
        float,
        bool,
        str,
    ]


def test_a_variable_is_there_from_its_definition_on() -> None:
    machine = cncsub.loads(TEXT, control="siemens-one").machine()
    assert machine.variables.named == {"SIDES": [[0] * 3] * 2, "TAGS": ["", ""]}
    machine.step()
    assert machine.variables.named["COUNT"] == 2
    assert "DEPTH" not in machine.variables.named


def test_they_stand_behind_the_numbers() -> None:
    text = "DEF INT COUNT=2\nR1=COUNT\nM30\n"
    run = cncsub.loads(text, control="siemens-one").run()
    assert repr(run.variables) == "{1: 2, COUNT: 2}"
    assert dict(run.variables) == {1: 2.0}


def test_each_level_has_its_own() -> None:
    text = (
        "%_N_MAIN_MPF\nDEF INT COUNT=1\nPART(5)\nM30\n"
        '%_N_PART_SPF\nPROC PART(REAL WIDE)\nDEF STRING[3] COUNT="A"\nG0 X=WIDE\nM17\n'
    )
    machine = cncsub.loads(text, control="siemens-one").machine()
    for _ in range(4):
        machine.step()
    assert machine.variables.named == {"WIDE": 5.0, "COUNT": "A"}
    assert machine.variables.level(0).named == {"COUNT": 1}


def test_those_of_all_programs_come_last() -> None:
    main = "DEF INT COUNT=1\nTOTAL=TOTAL+COUNT\nM30\n"
    texts = {"UGUD.DEF": "DEF NCK REAL TOTAL=0.5\nM30\n", "MAIN.MPF": main}
    library = cncsub.loads(texts, control="siemens-one")
    assert library.main is not None
    assert library.main.name == "MAIN"
    assert library.run().variables.named == {"COUNT": 1, "TOTAL": 1.5}


def test_a_block_that_alarms_changes_no_variable() -> None:
    text = (
        'DEF REAL GRID[3]=SET(1,2,3)\nDEF STRING[5] NAME="A"\nDEF INT AT=1\n'
        'NAME="B"<<AT GRID[1]=7 GRID[AT+1]=SET(8,9) AT=5\nM30\n'
    )
    run = cncsub.loads(text, control="siemens-one").run()
    assert run.alarm is not None
    assert run.alarm.cause == "array-element"
    assert run.variables.named == {"GRID": [1.0, 2.0, 3.0], "NAME": "A", "AT": 1}
    moved = cncsub.loads(text.replace("=SET(8,9)", "=8 G1 X1"), control="siemens-one").run()
    assert moved.alarm is not None
    assert moved.alarm.cause == "no-feed"
    assert moved.variables.named == {"GRID": [1.0, 2.0, 3.0], "NAME": "A", "AT": 1}


def test_a_loop_is_endless_where_no_element_changes() -> None:
    text = "DEF INT COUNTS[2]\nWHILE COUNTS[1]<100\nCOUNTS[1]=COUNTS[1]+1\nENDWHILE\nM30\n"
    counting = cncsub.loads(text, control="siemens-one").run(max_blocks=50)
    standing = cncsub.loads(text.replace("+1", "*1"), control="siemens-one").run(max_blocks=50)
    assert counting.endless is not None
    assert standing.endless is not None
    assert (counting.endless.proven, standing.endless.proven) == (False, True)


def test_a_file_of_definitions_is_no_subprogram_that_nobody_calls() -> None:
    texts = {"UGUD.DEF": "DEF NCK REAL TOTAL=0.5\nM17\n", "MAIN.MPF": "R1=TOTAL\nM30\n"}
    assert cncsub.loads(texts, control="siemens-one").check() == []


def test_a_definition_that_is_refused_is_found_by_check() -> None:
    texts = {"UGUD.DEF": "DEF NCK REAL TOTAL\nDEF NCK INT TOTAL\nM17\n", "MAIN.MPF": "M30\n"}
    (finding,) = cncsub.loads(texts, control="siemens-one").check()
    assert (finding.program, finding.line, finding.word) == ("UGUD", 2, "TOTAL")


def test_a_run_of_a_control_without_names_has_none() -> None:
    assert cncsub.loads("O1\n#100=5\nM30\n", control="fanuc-0i-f").run().variables.named == {}


def test_variables_are_named_as_programs_of_the_control_write_them() -> None:
    library = cncsub.loads("N10 R1=5\nN20 G0 X=R1\nM30\n", control="siemens-one")
    run = library.run(watch=[1])
    assert repr(run.watch).endswith("1 change of R1")
    assert str(next(iter(run.listing()))).endswith("->  R1 = 5")
    with pytest.raises(ValueError, match="R9 was not watched"):
        run.listing(variable=9)
    with pytest.raises(KeyError, match="R9 is not watched"):
        run.watch(9)
    with pytest.raises(AssertionError, match="variables: R1 = 5"):
        run.assert_alarm("illegal-variable")
    control = library.control
    assert _core.variable_name(control, 1_902_400_041) == "$TC_DP3[2,1]"
    assert [_core.variable_name(control, 2_000_000_000 + n) for n in (5001, 5002, 1001, 6002)] == [
        "$AA_IW[X]", "$AA_IW[Y]", "$A_IN[1]", "$P_UIFR[1]"
    ]  # fmt: skip
    assert _core.variable_name(cncsub.controls["fanuc-0i-f"], 500) == "#500"
