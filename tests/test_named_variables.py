"""The variables that programs define, by name."""

import cncsub

TEXT = """
N10 DEF INT COUNT=2, SIDES[2,3]=SET(1,2,3,4,5,6)
N20 DEF REAL DEPTH=-2.5
N30 DEF BOOL FLAG=TRUE
N40 DEF STRING[8] NAME="A", TAGS[2]
N50 DEF AXIS WAY=Y
N60 NAME=NAME<<COUNT
N70 TAGS[1]="ä"
N80 R1=5
N90 DEF REAL LATE=7
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


def test_a_run_of_a_control_without_names_has_none() -> None:
    assert cncsub.loads("O1\n#100=5\nM30\n", control="fanuc-0i-f").run().variables.named == {}
