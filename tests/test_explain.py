"""`cncsub explain`: codes, rules, parameters, questions; and the names of controls in any spelling."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub import _core
from cncsub.cli import app
from cncsub.reports.code_facts import code_named
from cncsub.reports.nearest import nearest
from cncsub.testing.outcome import execute, load

sys.path.insert(0, str(Path(__file__).with_name("conformance")))
from conformance import rows

CONTROL = "fanuc-0i-f"
CONTROL_FILES = Path(__file__).parents[1] / "cpp" / "cncsub" / "control"


def explain(*words: str, status: int = 0) -> str:
    done = CliRunner().invoke(app, ["explain", *words])
    assert done.exit_code == status, done.output
    return done.output


def facts(*words: str) -> list[dict[str, Any]]:
    told = json.loads(explain(*words, "--format", "json"))
    assert isinstance(told, list)
    return told


def on(code: str, control: str = CONTROL) -> dict[str, Any]:
    """Return what is known of a code on a control where it means one thing."""
    (fact,) = facts(code, "-c", control)
    (place,) = fact["on"]
    return {**fact, **place}


# ---- codes ----


def test_a_code_is_explained_with_its_words_rules_alarms_and_source() -> None:
    told = on("G65")
    assert told["does"] == "`G65 P2 A1.` calls O2 as a macro"
    assert [word["letters"] for word in told["words"]] == ["P", "L", "other letters"]
    assert (told["arguments"]["A"], told["arguments"]["I"]) == ("#1", "#4")
    assert {"max_macro_digits", "argument_sets", "max_macro_nesting"} <= {
        rule["name"] for rule in told["rules"]
    }
    assert ("PS0122", "macro-nesting-too-deep") in [
        (alarm["number"], alarm["cause"]) for alarm in told["alarms"]
    ]
    assert [source["rule"] for source in told["sources"]] == ["roles"]
    text = explain("G65", "-c", CONTROL)
    assert text.startswith(f"G65 on {CONTROL}\n")
    assert "PS0122  macro-nesting-too-deep: more levels of macro calls" in text


@pytest.mark.parametrize("written", ["G065", "g65", "G65.0", " G65 "])
def test_a_code_may_be_written_as_in_programs(written: str) -> None:
    assert facts(written, "-c", CONTROL) == facts("G65", "-c", CONTROL)


@pytest.mark.parametrize(
    ("code", "control", "treatment"),
    [
        ("G81", "haas-ngc", "computed"),
        ("G5.9", CONTROL, "refused"),
        ("G68.2", CONTROL, "not-computed"),
        ("G90", "gsk-928te", "not-known"),
        ("M8", CONTROL, "passed-over"),
        ("M29", "haas-ngc", "passed-over"),  # a relay, no rigid tapping
    ],
)
def test_what_becomes_of_a_code_is_said(code: str, control: str, treatment: str) -> None:
    assert on(code, control)["treatment"] == treatment


def test_a_code_of_a_lathe_and_of_a_mill_are_two() -> None:
    told = {fact["does"]: fact["on"][0]["machines"] for fact in facts("G90", "-c", CONTROL)}
    assert told == {
        "axis words are coordinates": ["mill", "lathe-b"],
        "cuts once along Z and comes back, a rectangle or a taper": ["lathe-a"],
    }


def test_without_a_control_what_a_code_does_is_grouped() -> None:
    found = facts("M97")
    assert sum(len(fact["on"]) for fact in found) == len(cncsub.controls)
    does = {fact["does"]: [of["control"] for of in fact["on"]] for fact in found}
    assert does["`M97 P20` goes to N20 of the same program"] == ["gsk-928te"]
    assert does["`M97 P20` calls the part from N20 of the same program"] == ["haas-ngc"]


def test_the_words_of_a_call_are_those_of_the_control() -> None:
    def letters(control: str) -> list[str]:
        return [word["letters"] for word in on("M98", control)["words"]]

    assert letters(CONTROL) == ["P", "L"]
    assert letters("gsk-988ta") == ["P", "L", "Q"]
    assert letters("mitsubishi-m700") == ["P", "L", "H"]


def test_a_code_that_a_parameter_registers_calls() -> None:
    control = cncsub.controls[CONTROL].with_parameters({"6050": 100, "6080": 50})
    called = _core.code_facts(control, "G100")
    assert called is not None
    assert (called["does"], called["treatment"]) == ("calls O9010 as G65", "computed")
    assert "program-not-found" in called["causes"]
    called = _core.code_facts(control, "M50")
    assert called is not None
    assert called["does"] == "calls O9020 as G65"


@pytest.mark.parametrize("letter", ["T", "D", "f", "N"])
def test_an_address_is_explained(letter: str) -> None:
    (fact,) = facts(letter, "-c", "gsk-988ta")
    assert fact["code"] == letter.upper()
    assert fact["does"]


def test_t_of_a_lathe_names_its_rules() -> None:
    assert {"tool_offset", "tool_offset_digits"} <= {
        r["name"] for r in on("T", "gsk-988ta")["rules"]
    }


def test_each_part_of_a_block_is_explained() -> None:
    found = facts("G91", "G28", "Z0", "-c", "haas-ngc")
    assert [fact["code"] for fact in found] == ["G91", "G28", "Z"]
    found = facts("N10 IF R1==2 GOTOF END", "-c", "siemens-one")
    assert [fact["code"] for fact in found] == ["N", "IF", "R1", "GOTOF"]
    found = facts("IF[#1EQ#3006]GOTO10", "-c", CONTROL)
    assert [fact["code"] for fact in found] == ["IF", "#1", "EQ", "#3006", "GOTO"]


# ---- words of the languages ----


@pytest.mark.parametrize(
    ("asked", "control", "treatment", "says"),
    [
        ("GOTOF", "siemens-one", "computed", "further on"),
        ("gotof", "siemens-828d", "computed", "further on"),
        ("TRANS", "siemens-one", "computed", "shift"),
        ("CR=", "siemens-one", "computed", "radius of an arc"),
        ("AC()", "siemens-one", "computed", "coordinate"),
        ("$AA_IW[X]", "siemens-one", "computed", "system variable"),
        ("CYCLE81", "siemens-one", "computed", "REAL RTP"),
        ("CYCLE800", "siemens-one", "not-computed", "swivel data"),
        ("TRAORI", "siemens-one", "not-computed", "kinematics"),
        ("BRISK", "siemens-one", "passed-over", "no path"),
        ("LIMS", "siemens-one", "computed", "highest speed"),
        ("ADIS", "siemens-one", "passed-over", "no path"),
        ("RNDM", "siemens-one", "computed", "rounding"),
        ("TOFFL", "siemens-one", "passed-over", "off"),
        ("R", "siemens-one", "computed", "parameter"),
        ("P", "siemens-one", "computed", "how often"),
        ("O", "siemens-one", "refused", "no address"),
        ("R", CONTROL, "computed", "radius of an arc"),
        ("WHILE", CONTROL, "computed", "repeats"),
        ("DPRNT", "gsk-988ta", "not-known", "device"),
        ("endsub", "linuxcnc", "computed", "subprogram"),
        ("#<_x>", "linuxcnc", "computed", "parameter"),
    ],
)
def test_a_word_of_a_language_is_explained(
    asked: str, control: str, treatment: str, says: str
) -> None:
    told = on(asked, control)
    assert told["treatment"] == treatment
    assert says in told["does"]
    assert all(source["source"] for source in told["sources"])


@pytest.mark.parametrize(
    ("word", "control"),
    [("TRANS", CONTROL), ("GOTOF", CONTROL), ("sub", "siemens-one"), ("POW", "gsk-988ta")],
)
def test_a_control_has_no_word_of_another_language(word: str, control: str) -> None:
    assert _core.code_facts(cncsub.controls[control], word) is None


def test_the_return_of_a_sinumerik_has_no_words_of_another_control() -> None:
    told = on("M17", "siemens-one")
    assert told["words"] == []
    assert on("G505", "siemens-one")["words"] == []
    assert "CR" in [word["letters"] for word in on("G2", "siemens-one")["words"]]


_REFUSED = ("CS101", "CS102", "CS103", "CS104", "CS105", "CS201", "CS202")
READER = CONTROL_FILES.parent / "dialect" / "sinumerik"

# Texts of the reader that are no words of the language.
_NO_WORDS = frozenset(
    re.split(
        " ",
        "CYCLE_ MPF SPF WPD DEF_ _N_ _MPF _SPF _DEF _X NCK CHAN SYNR SYNW SYNRW PHU APR APW APRP APWP"
        " APRB APWB INIPO INIRE DCM LLI ULI ACTBLOCNO PREPRO ICYCOF ICYCON AS N10 TEXT MILL_10"
        " ABC BCDFEGSX MSTDHEQ NN NNN TC TT ABCDFIJKSTUVWXYZ ABCDEFGHIJKLMNOPQRSTUVWXYZ"
        " ABCIJKUVWXYZ DFST ABCFIJKRSTUVWXYZ",
    )
)


def test_every_word_that_the_reader_of_the_sinumerik_knows_is_explained() -> None:
    control = cncsub.controls["siemens-one"]
    words = {
        word
        for file in READER.glob("*.cpp")
        for word in re.findall(r'"(\$?[A-Z][A-Z_0-9]+)"', file.read_text("utf-8"))
    }
    assert len(words) > 300
    unknown = {w for w in words - _NO_WORDS if _core.code_facts(control, w) is None}
    assert not {w for w in unknown if _core.code_facts(control, f"${w}") is None}


# Names of the language that some control reads and `explain` does not know: the short forms of
# functions, letters that several words share, text that a device prints.
_NOT_KNOWN = frozenset(
    re.split(
        " ", "RO SQ SI FI FU AB EX ET WH GO TO NOT ANDABS LEABS GTSQRT HOLE DONE TOOL NOSUCH ,A ,D"
    )
)


def _language_of(control: str) -> str:
    return "sinumerik" if control.startswith("siemens") else control.partition("-")[0]


def _names_given(library: cncsub.Library) -> set[str]:
    """Return the names that programs give: of programs, labels and variables."""
    given = {name.upper() for name in library}
    for program in library.values():
        for block in program.blocks:
            names = [name.upper() for name in _core.names_in_block(library.control, block.text)]
            given |= {token.text[:-1].upper() for token in block.tokens if token.text[-1:] == ":"}
            given |= {str(call.program).upper() for call in block.calls}
            given |= {
                name for name in names if name.removesuffix("_SPF") in library or name[:3] == "_N_"
            }
            if library.control.dialect == "okuma":  # names of locals and of blocks
                given |= {name for name in names if len(name) <= 5}
            if {"DEF", "DEFINE", "PROC", "EXTERN", "SETVN", "GOTOC"} & set(
                names
            ) or "P[" in block.text:
                given |= set(names)
    return given


def test_what_a_control_reads_is_explained() -> None:
    """Each name of each block of the rows is explained, or given by the program, or in the list."""
    seen, wrong, asked, met = set(), set(), {}, set()
    for row in rows():
        key = (_language_of(row.control), row.case.program, str(row.case.files))
        if key in seen:
            continue
        seen.add(key)
        control = cncsub.controls[row.control]
        library = load(row.case, control)
        unknown: dict[str, int | None] = {}
        for program in library.values():
            for block in program.blocks:
                for name in map(str.upper, _core.names_in_block(control, block.text)):
                    if (row.control, name) not in asked:
                        known = _core.code_facts(control, name) is not None
                        asked[row.control, name] = known
                    if not asked[row.control, name]:
                        unknown[name] = block.line
        if not unknown:
            continue
        met |= unknown.keys() & _NOT_KNOWN
        unknown = {name: unknown[name] for name in unknown.keys() - _NOT_KNOWN}
        unknown = {name: unknown[name] for name in unknown.keys() - _names_given(library)}
        refused = {finding.line for finding in library.check(rules=_REFUSED)}
        wrong |= {(name, row.control) for name, line in unknown.items() if line not in refused}
    assert not wrong, "\n".join(map(str, sorted(wrong)))
    assert met == _NOT_KNOWN
    assert len(asked) > 3000


def test_a_word_of_the_language_is_found_by_its_meaning() -> None:
    assert "STRLEN" in [
        entry.name
        for entry in nearest("how many characters has a text", [cncsub.controls["siemens-one"]])
    ]


# ---- the words and causes of the engine's rows hold ----


def _rows_of(file: str) -> Iterator[tuple[str, str]]:
    """Yield the words and the causes of each row of a .def file, as the compiler reads them."""
    text = (CONTROL_FILES / file).read_text("utf-8")
    names = dict(re.findall(r"^#define (\w+) (.+)$", text, re.MULTILINE))

    def joined(parts: str) -> str:
        found = re.findall(r'"([^"]*)"|(\w+)', parts)
        return "".join(joined(names[name]) if name else text for text, name in found)

    for row in re.findall(r"^(?:MEANING|ROLE)\((.*)\)$", text, re.MULTILINE):
        *_, words, causes = re.findall(r'(?:"[^"]*"|[^",])+', row)
        yield joined(words), joined(causes)


@pytest.mark.parametrize("file", ["meanings.def", "roles.def"])
def test_rows_name_causes_rules_and_letters_that_there_are(file: str) -> None:
    known = {rule.name for control in cncsub.controls.values() for rule in control.rules}
    count = 0
    for words, causes in _rows_of(file):
        count += 1
        for cause in causes.split():
            slug, *conditions = cause.removeprefix("+").split("!")
            assert slug in cncsub.causes
            assert {condition.partition("=")[0] for condition in conditions} <= known
        for item in filter(None, words.split("; ")):
            found = re.fullmatch(
                r"(axes|other letters|[A-Z](?: [A-Z])*|\{\w+\}): [^\[\];:]+(?: \[([\w ]+)\])?", item
            )
            assert found, item
            assert set((found[2] or "").split()) <= known, item
            assert found[1].strip("{}") in known or not found[1].startswith("{")
    assert count > 20


# Causes of a block or of its place, which any code may meet.
_ANY_CODE = (
    "address-given-twice group-given-twice angle-no-end call-in-profile code-not-computed corner-next-move corner-no-move if-format"
    " illegal-argument illegal-decimal-point illegal-m-combination macro-call-not-first"
    " nc-and-macro-in-block pattern-first-block polar-word profile-code profile-first-block"
    " profile-first-x profile-first-z reference-with-end reference-with-m statement-format"
    " named-program-not-found program-not-found one-shot-with-motion too-many-words user-alarm jump-in-mdi code-may-not-call idle-blocks-in-offset"
)
_OF_BLOCKS = frozenset(_ANY_CODE.split())
# What the reader of an OSP says of a code before its meaning is looked at.
_OF_AN_OSP = {("G15", "motion-word-missing"), ("G65", "code-not-known")}


def _alarms_at_codes() -> Iterator[tuple[cncsub.Control, str, str, str]]:
    for row in rows():
        if not row.case.alarm:
            continue
        library = load(row.case, cncsub.controls[row.control])
        alarm = execute(row.case, library).alarm
        code = None if alarm is None else code_named(alarm.word or "")
        no_code = alarm is not None and alarm.cause in (
            "whole-number-expected",
            "value-out-of-range",
        )
        if alarm is not None and code is not None and len(code) > 1 and not no_code:
            setup = row.case.setup or {}
            yield library.control, code, alarm.cause, str(setup.get("machine", ""))


def test_the_alarms_of_a_code_are_those_that_rows_raise_at_it() -> None:
    """Where a row alarms at a G code, the code says that it can raise this alarm."""
    wrong, count = set(), 0
    for control, code, cause, machine in _alarms_at_codes():
        told = _core.code_facts(control, code, machine)
        assert told is not None
        if code[0] != "G" or cause in _OF_BLOCKS or (code, cause) in _OF_AN_OSP:
            continue
        count += 1
        if cause not in told["causes"]:
            wrong.add((code, cause, control.name))
    assert not wrong, "\n".join(map(str, sorted(wrong)))
    assert count > 1000


def test_the_words_of_linuxcnc_are_those_that_its_engine_takes() -> None:
    """The interpreter refuses a word that no code of the block uses: so each letter told is taken."""
    refused = set()
    for code, does in (
        (name, _core.code_facts(cncsub.controls["linuxcnc"], name))
        for name, _ in _core.g_codes(cncsub.controls["linuxcnc"])
    ):
        assert does is not None
        letters = {c for word in does["words"] for c in word[0].split() if c in "DEHIJKLPQR"}
        for letter in letters if does["treatment"] == "computed" else ():
            block = f"{code} X1 Y1 Z-1 {letter}1"
            alarm = cncsub.loads(f"F100 S1 M3\n{block}\nM2\n", control="linuxcnc").run().alarm
            if (
                alarm is not None
                and alarm.cause == "address-not-usable"
                and alarm.word[:1].upper() == letter
            ):
                refused.add((code, letter))
    assert not refused


# ---- rules and parameters ----


def test_every_rule_and_every_parameter_is_explained() -> None:
    for control in cncsub.controls.values():
        for name in [*(rule.name for rule in control.rules), *control.parameters]:
            kinds = {fact.get("kind") for fact in _all_facts(name, control)}
            assert kinds & {"rule", "parameter"}, (control.name, name)


def _all_facts(name: str, control: cncsub.Control) -> list[dict[str, Any]]:
    from cncsub.reports.explained import parameter_explanations, rule_explanations

    return rule_explanations(name, [control]) + parameter_explanations(name, [control])


def test_a_rule_says_its_value_with_the_source() -> None:
    (fact,) = facts("max_nesting", "-c", "gsk-988ta")
    assert fact["on"] == [
        {
            "control": "gsk-988ta", "value": 12, "example": None, "parameters": [],
            "source": "source 000, nesting", "evidence": "source document",
        }
    ]  # fmt: skip
    assert "what it may be" in explain("zero_repeats", "-c", CONTROL)
    assert len(facts("max_nesting")[0]["on"]) == len(cncsub.controls)


def test_a_parameter_says_what_it_sets() -> None:
    text = explain("6005#0", "-c", CONTROL)
    assert text.startswith("6005#0, a parameter\n  SQC:")
    assert "sets start_word, omitted_program" in text


def test_a_cause_and_a_rule_of_check_of_one_name_are_both_told() -> None:
    text = explain("nesting-too-deep", "-c", CONTROL)
    assert text.startswith("nesting-too-deep\n")
    assert "\nCS401 nesting-too-deep, error\n" in text
    found = facts("nesting-too-deep", "-c", CONTROL)
    assert [fact.get("cause", fact.get("number")) for fact in found] == [
        "nesting-too-deep",
        "CS401",
    ]


# ---- questions ----


@pytest.mark.parametrize(
    ("question", "answer"),
    [
        ("nested too deep", "nesting-too-deep"),
        ("subroutine not found", "program-not-found"),
        ("divide by zero", "division-by-zero"),
        ("spindle direction when tapping", "spindle-direction"),
        ("M99 in main program", "main_return"),
        ("how do I repeat a subroutine", "M98"),
        ("drill a hole", "G81"),
        ("empty variable", "CS601 vacant-variable"),
        ("cutter compensation left of the path", "G41"),
    ],
)
def test_a_question_finds_what_it_is_about(question: str, answer: str) -> None:
    found = [entry.name for entry in nearest(question, [cncsub.controls[CONTROL]])]
    assert answer in found[:4]
    assert answer in explain(*question.split(), "-c", CONTROL)


def test_a_question_is_answered_as_json() -> None:
    found = facts("nested", "too", "deep", "-c", CONTROL)
    assert {fact["kind"] for fact in found} == {"near"}
    assert {"name", "of", "meaning"} <= found[0].keys()


@pytest.mark.parametrize("asked", ["zork blah", "program-not-fond", "M98x", "§", "G", " "])
def test_nothing_is_explained_as_if_it_were_known(asked: str) -> None:
    if asked == "G":
        assert explain(asked, "-c", CONTROL).startswith("G on")
    else:
        assert "is called" in explain(asked, status=2)


# ---- names of controls ----


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("Fanuc 0i-F", CONTROL),
        ("FANUC_0I_F", CONTROL),
        ("0i-f", CONTROL),
        ("fanuc0if", CONTROL),
        ("FANUC Series 0i-F", CONTROL),
        ("fanuc 31i", "fanuc-30i"),
        ("988t", "gsk-988t"),
        ("GSK 988 TA", "gsk-988ta"),
        ("Haas", "haas-ngc"),
        ("M70", "mitsubishi-m700"),
        ("SINUMERIK ONE", "siemens-one"),
    ],
)
def test_a_control_is_found_by_any_spelling(name: str, meant: str) -> None:
    assert cncsub.control(name).name == meant
    assert cncsub.loads("M30\n", control=name).control.name == meant
    done = CliRunner().invoke(app, ["run", "--mdi", "G0 X1.", "-c", name])
    assert done.exit_code == 0, done.output
    told = explain("max_nesting", "-c", name).splitlines()
    if told[0].startswith("note: "):  # the name is an alias
        assert f" is taken as {meant}, " in told.pop(0)
    assert told == explain("max_nesting", "-c", meant).splitlines()


@pytest.mark.parametrize("name", list(cncsub.controls))
def test_the_name_and_the_title_of_a_control_mean_it(name: str) -> None:
    control = cncsub.controls[name]
    for written in (name, name.upper(), name.replace("-", " "), control.title):
        assert cncsub.control(written).name == name
    assert cncsub.control(control) is control


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("0i", "'0i' may be fanuc-0i-d or fanuc-0i-f: write one of them"),
        ("lathe", "may be gsk-928te, gsk-980tdi, gsk-988t or gsk-988ta"),
        ("fanuc-0i-g", "there is no control 'fanuc-0i-g'; did you mean fanuc-0i-"),
        ("f", "there is no control 'f'; did you mean"),
        ("", "there is no control ''; there are fanuc-0i-d"),
        ("--", "there is no control '--'"),
    ],
)
def test_a_name_of_several_controls_or_of_none_is_refused(name: str, told: str) -> None:
    with pytest.raises(ValueError, match=re.escape(told)):
        cncsub.control(name)
    with pytest.raises(ValueError, match=re.escape(told)):
        cncsub.loads("M30\n", control=name)


def test_the_control_of_a_project_is_found_by_any_spelling(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "cncsub.toml").write_text('[control]\nname = "our-mill"\nbase = "Fanuc 0i-F"\n')
    assert explain("max_nesting", "-c", "Our Mill").count("our-mill") == 1
    assert "our-mill: 10" in explain("max_nesting", "-c", "our_mill")


@pytest.mark.parametrize("name", ["GT101", "gt101", "dry-run-alarm"])
def test_a_rule_of_the_gate_is_explained(name: str) -> None:
    assert explain(name).startswith("GT101 dry-run-alarm, error")
