"""The conformance tables as JSON: they match their schema, nothing a row needs is missing, and
LinuxCNC's interpreter agrees with them.
"""

from __future__ import annotations

import dataclasses
import datetime
import json
import runpy
import shutil
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest

import cncsub
from cncsub.testing import case, load_table, outcome
from cncsub.testing.cases import Row
from cncsub.testing.exchange import case_facts, left_out_by_topic, suite_facts
from cncsub.testing.outcome import differences, report
from conformance import cases, rows

ROOT = Path(__file__).parents[1]
TOOLS = ROOT / "tools"
SCHEMA = json.loads((ROOT / "docs" / "conformance.schema.json").read_text(encoding="utf-8"))
SAMPLE = 20  # one row of so many is run


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All rows, as the tool writes them."""
    written = tmp_path_factory.mktemp("suite") / "conformance.json"
    _tool("export_conformance", str(written))
    return written


@pytest.fixture(scope="module")
def suite(file: Path) -> dict[str, Any]:
    told: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    return told


def _tool(name: str, *arguments: str) -> int:
    before = sys.argv, sys.path[:]
    sys.argv = [name, *arguments]
    try:
        runpy.run_path(str(TOOLS / f"{name}.py"), run_name="__main__")
    except SystemExit as ended:
        return int(ended.code or 0)
    finally:
        sys.argv, sys.path[:] = before
    raise AssertionError("a tool ends with a status")


def test_every_row_is_exported(suite: dict[str, Any]) -> None:
    assert suite["left_out"] == []
    assert [row["claim"] for row in suite["cases"]] == [case.claim for case in cases()]
    rows = sum(len(case.controls) for case in cases())
    assert suite["counts"] == {"cases": len(cases()), "rows": rows, "left_out": 0}
    assert list(suite["controls"]) == list(cncsub.controls)
    raised = {row["expect"]["alarm"] for row in suite["cases"] if "alarm" in row["expect"]}
    assert set(suite["causes"]) == raised
    assert suite["rules"].keys() == {
        rule for row in suite["cases"] for rule in row.get("rules", ())
    }


def test_the_suite_matches_its_schema(suite: dict[str, Any]) -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    # A hundred copies of one case teach nothing more, so one of each shape is validated.
    shapes = {repr(_shape(row)): row for row in suite["cases"]}
    jsonschema.validate({**suite, "cases": list(shapes.values())}, SCHEMA)
    assert len(shapes) > 200


def _shape(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _shape(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return sorted({repr(_shape(inner)) for inner in value})
    return type(value).__name__


@pytest.mark.parametrize(
    "change",
    [
        {"claim": None},
        {"controls": {}},
        {"extra": 1},
        {"expect": {}},
        {"expect": {"stop": "never"}},
        {"expect": {"stop": "end", "moves": [{"kind": "cw", "end": {"X": 1}}]}},
        {"setup": {"start": {"Q": 1}}},
        {"run": {"variables": {"#100": 1}}},
    ],
)
def test_the_schema_refuses_what_is_no_case(suite: dict[str, Any], change: dict[str, Any]) -> None:
    changed = {**suite, "cases": [{**suite["cases"][0], **change}]}
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(changed, SCHEMA)


def test_rows_read_back_say_the_same(file: Path, suite: dict[str, Any]) -> None:
    read = load_table(file)
    evidence = {
        row["claim"]: {n: on["evidence"] for n, on in row["controls"].items()}
        for row in suite["cases"]
    }
    again = [json.loads(json.dumps(case_facts(case, evidence[case.claim]))) for case in read]
    assert again == suite["cases"]


def test_a_sample_runs_from_the_json_alone(file: Path) -> None:
    read = load_table(file)
    rows = [Row(case, control) for case in read for control in case.controls][::SAMPLE]
    rows += [Row(case, case.controls[0]) for case in read if "inputs" in case.options]
    rows += [Row(case, case.controls[0]) for case in read if case.external or case.files]
    assert len(rows) > 1000
    for row in rows:
        found = list(differences(row.case, cncsub.controls[row.control]))
        assert found == [], report(row, found)


def test_what_a_row_expects_is_read(file: Path, tmp_path: Path, suite: dict[str, Any]) -> None:
    """If a value of any kind of expectation is changed in the JSON, its row fails."""
    changes: dict[str, Any] = {
        "at": "O1 N99999", "runs": ["N99999"], "variables": {"100": 99}, "m": [77], "t": [77],
        "messages": ["no"], "dropped": ["no"], "calls": ["no"], "tree": "no", "frames": ["no"],
        "arguments": {"1": 99}, "moves": [{"kind": "feed", "end": {"X": 99}}], "moves_x": [99],
        "centre": [{"X": 99}], "final_machine": {"X": 99}, "final_work": {"X": 99}, "time": 1e6,
        "variables_after_reset": {"1": 99}, "work_after_reset": {"X": 99},
        "modal_after_reset": {"motion": "G99"}, "stop": "limit",
    }  # fmt: skip
    changed = []
    for name, value in changes.items():
        row = next(row for row in suite["cases"] if name in row["expect"])
        changed.append({**row, "expect": {**row["expect"], name: value}})
    numbered = next(
        row for row in suite["cases"] if "number" in next(iter(row["controls"].values()))
    )
    first, on = next(iter(numbered["controls"].items()))
    changed.append({**numbered, "controls": {first: {**on, "number": "99999"}}})
    file = tmp_path / "changed.json"
    file.write_text(json.dumps({**suite, "cases": changed}))
    for read in load_table(file):
        assert list(differences(read, cncsub.controls[read.controls[0]])) != [], read.claim
    expected = set(SCHEMA["$defs"]["expect"]["properties"])
    assert expected - set(changes) == {"alarm"}


def test_what_json_cannot_hold_is_counted_by_topic() -> None:
    said: dict[str, Any] = {"control": "fanuc-0i-f", "program": "O1\nN10 M30", "runs": "N10"}
    rows = [
        case("of a clock", **said, inputs={"clock": datetime.datetime(2026, 3, 9)}),
        case("of no number", **said, variables={100: float("nan")}),
        case("of no end", **said, variables={100: float("inf")}),
    ]
    told = suite_facts(rows)
    assert told["counts"] == {"cases": 1, "rows": 1, "left_out": 2}
    assert told["cases"][0]["run"]["inputs"] == {"clock": "2026-03-09T00:00:00"}
    assert list(left_out_by_topic(told)) == [
        "test_conformance_suite: 1 left out: run has inf, which JSON cannot have",
        "test_conformance_suite: 1 left out: run has nan, which JSON cannot have",
    ]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("{", "Expecting"),
        ("[]", "not a conformance suite"),
        ('{"format": "cncsub-conformance", "version": 2}', "version 2; this cncsub reads 1"),
        (
            '{"format": "cncsub-conformance", "version": 1, "cases": [{"claim": "x"}]}',
            "case 1, 'x'",
        ),
        ('{"format": "cncsub-conformance", "version": 1, "cases": [3]}', "case 1, 3"),
    ],
)
def test_a_file_that_is_no_suite_is_refused(tmp_path: Path, text: str, told: str) -> None:
    file = tmp_path / "bad.json"
    file.write_text(text)
    with pytest.raises(ValueError, match=told):
        load_table(file)


# ---- LinuxCNC ----

STUB = """#!{python}
import sys
main = open(sys.argv[-1]).read()
print("    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)")
if "G0 X1" in main:
    print("    2 N10    STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)")
if "G2" in main:
    print("    3 N20    SELECT_PLANE(CANON_PLANE_XZ)")
    print("    4 N20    ARC_FEED(0.0000, 3.0000, 0.0000, 2.0000, -1, 0.0000, 0.0, 0.0, 0.0)")
if "X[1/0]" in main:
    print("executing\\nAttempt to divide by zero\\nN20 X[1/0]", file=sys.stderr)
"""


def _linuxcnc_suite(*rows: dict[str, Any]) -> dict[str, Any]:
    made = [case(**{"control": "linuxcnc", "source": "rs274 2.9", **row}) for row in rows]
    return suite_facts(made)


def test_the_adapter_tells_agreement_differences_and_what_it_leaves_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    stub = tmp_path / "rs274"
    stub.write_text(STUB.replace("{python}", sys.executable))
    stub.chmod(0o755)
    arc = "N10 G0 X1\nN20 G18 G2 X3 Z0 I1 K0\nN30 M2"
    told = _linuxcnc_suite(
        {"claim": "a rapid", "program": "N10 G0 X1\nN20 M2", "moves": "R X1"},
        {"claim": "an arc in XZ", "program": arc, "moves": "R X1\nCW X3 Z0 C X2 Z0"},
        {"claim": "no rapid", "program": "N10 G0 X1 Y2\nN20 M2", "moves_x": [5]},
        {"claim": "an alarm", "program": "N10 G0 X1\nN20 X[1/0]", "alarm": "division-by-zero", "at": "MAIN N20"},
        {"claim": "no alarm", "program": "N10 G0 X1\nN20 X[1/ 0]", "alarm": "division-by-zero"},
        {"claim": "a setup", "program": "N10 G0 X1\nN20 M2", "moves_x": [1], "setup": {"start": {"X": 5}}},
        {"claim": "no order", "program": "N10 G0 X1\nN20 M2", "runs": "N20 N30"},
    )  # fmt: skip
    suite = tmp_path / "suite.json"
    suite.write_text(json.dumps(told))
    assert _tool("rs274_conformance", str(suite), "--rs274", str(stub)) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        "test_conformance_suite: no rapid",
        "    moves_x: expected [5], got [1.0]",
        "test_conformance_suite: no alarm",
        "    stop: expected the alarm division-by-zero, got the end",
        "test_conformance_suite: no order",
        "    runs: N10 makes a call out of the order N20 N30",
        "7 rows of linuxcnc: 3 agree, 3 part, 1 left out",
        "left out: 1: rs274 takes no setup",
    ]


def test_the_adapter_wants_an_interpreter_and_a_suite(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    suite = tmp_path / "suite.json"
    suite.write_text("{}")
    assert _tool("rs274_conformance", str(suite), "--rs274", str(tmp_path / "none")) == 2
    assert "install linuxcnc-uspace, or give --rs274 PATH" in capsys.readouterr().err
    assert _tool("rs274_conformance", str(suite), "--rs274", sys.executable) == 2
    assert "not a conformance suite of version 1" in capsys.readouterr().err


@pytest.mark.skipif(
    shutil.which("rs274") is None, reason="rs274 is not installed: Debian package linuxcnc-uspace"
)
def test_linuxcnc_agrees_with_its_rows(
    tmp_path: Path, suite: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    every = [row for row in suite["cases"] if "linuxcnc" in row["controls"]]
    part = tmp_path / "part.json"
    part.write_text(json.dumps({**suite, "cases": every}))
    _tool("rs274_conformance", str(part))
    told = capsys.readouterr().out
    parted = [line for line in told.splitlines() if line.startswith("linuxcnc/")]
    known = {
        # cncsub has no machine: it refuses what rs274 prints of one.
        "linuxcnc/variables: what tells of a machine is not computed here",
        # The machine of the packaged rs274 counts in inches, and has no tool table.
        "linuxcnc/frame: #5161 is the reference point, and may be written",
        "linuxcnc/frame: a bare G30 goes to the second reference point",
        "linuxcnc/motion: G10 L1 writes the table of tools",
        "linuxcnc/frame: #5210 tells whether the shift counts, #5211 what it is",
        "linuxcnc/frame: G30.1 stores the second point, #5181 tells it",
        "linuxcnc/frame: one that #5210 says is in force too",
        "linuxcnc/frame: a shift that is written counts for nothing but the point where a system is chosen",
        "linuxcnc/frame: G10 L20 takes off the shift that is written in #5211, not the one in force",
        "linuxcnc/frame: G92.2 beside G92 puts the shift aside that it sets",
        "linuxcnc/refused: where the radius is 0 one is",
        "linuxcnc/motion: L10 puts the tool at the point",
        "linuxcnc/motion: L11 puts the tool at the point of G59.3",
        "linuxcnc/motion: an M3 of its line starts it after that",
        "linuxcnc/motion: nor a zero point and a length",
        # Behaviour that the manual leaves undefined, and planes of axes that cncsub does not have.
        "linuxcnc/lines: the moves of G18.1 are not computed on LinuxCNC",
        "linuxcnc/lines: the moves of G19.1 are not computed on LinuxCNC",
        "linuxcnc/lines: the moves of G87 are not told, with its words",
        "linuxcnc/lines: the moves of G88 are not told, with its words",
        "linuxcnc/motion: nor is what G88 does",
        "linuxcnc/refused: there it is not computed",
        "linuxcnc/motion: what G87 does is not told",
        # rs274 does not print the path of a spline, or where a tap in another plane ends.
        "linuxcnc/arcs: G5 is a curve to its end by the directions at both ends",
        "linuxcnc/arcs: after it one without I and J goes on in its direction",
        "linuxcnc/motion: a tap outside of G17 takes its axes for each other",
        # A limit of cncsub: a position beyond all machines.
        "shared/reading/number_ends: a word that leads beyond every position is refused in a plain"
        " move as in any other",
    }
    # The adapter indents the lines that belong to a row, but not its last line.
    parted += [line for line in told.splitlines() if line.startswith("shared/")]
    assert set(parted) == known, told
    assert " agree" in told


def test_a_row_that_is_gone_does_not_lend_its_files_to_the_next() -> None:
    row = next(row for row in rows() if row.case.files is not None and row.case.paths == ())
    for n in range(1, 300):
        case = dataclasses.replace(row.case, files={"O1.NC": f"O1\nN{n} M30\n"})
        assert outcome.load(case, cncsub.controls[row.control]).main.blocks[0].n == n
        del case
