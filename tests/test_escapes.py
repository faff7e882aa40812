"""The contents of programs and the names of files are escaped for each kind of output."""

from __future__ import annotations

import csv
import io
import json
import os
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from typer.testing import CliRunner

from cncsub.cli import app
from cncsub.escapes import cell, escape, for_github, for_xml, referred, shown

EVIL = "\x1b[31m\x1b]0;own\x07\x9b31m\x08\x7f\u202e\u2066\u200f\u2028\x85\u200b\ufeff\U000e0041"
OBEYED = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\U000e0041]"
)
PROGRAMS = {
    "fanuc-0i-f": f"O1(T{EVIL})\n(c {EVIL})\nN10 G0 X1. ({EVIL})\nM98 P2\nM30\nO2({EVIL})\n"
    f"POPEN\nDPRNT[X{EVIL}]\nIF[#1EQ2]#3=4 ({EVIL})\nM99\nO3\n#1=XO.{EVIL}\n#3000=1({EVIL})\n",
    "linuxcnc": f"(MSG, {EVIL})\nG0 X1\no<a> sub\nG0 X2\no<a> endsub\no<a> call\no<b{EVIL}> call\n",
    "gsk-988ta": f"G0 X1\nM98 P[a{EVIL}]\nM30\n",
    "siemens-one": f'MSG("{EVIL}")\nG0 X1\nUP{EVIL}\nM30\n',
}
SAID = [
    *("run P", "run P --format json", "run P --format csv", "run P --listing", "run P --watch 1-5"),
    *("run P --listing --format json", "tree P", "tree P --static", "tree P --format json"),
    *("list P", "list P --format json", "check P", "check P --apart", "check P --format json"),
    *("check P --format sarif", "check P --format junit", "check P --format github"),
    *("compare P -c haas-ngc", "compare P -c haas-ngc --translate --format json", "diff P Q"),
    *("coverage P --html F.html --lcov F.lcov --cobertura F.xml", "report P -o F.html"),
    *("plot P -o F.html", "plot P --of calls -o F.html", "plot P --of programs -o F.html"),
    *("run P --setup E", "run P --external E", "run P --prefer E", "run P --main E", "run P -o E/E"),
]  # fmt: skip


@pytest.mark.parametrize("control", PROGRAMS)
@pytest.mark.skipif(os.name == "nt", reason="files have no such names there")
def test_no_output_holds_what_a_terminal_obeys(
    tmp_path: Path, control: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / f"d{EVIL}"
    folder.mkdir()
    places = {"P": folder / f"p{EVIL}.nc", "Q": folder / f"q{EVIL}.nc", "E": Path(EVIL)}
    places["P"].write_text(PROGRAMS[control])
    places["Q"].write_text(PROGRAMS[control].replace("X1", "X3"))
    for line in SAID:
        words = [re.sub(r"\b[PQE]\b", lambda m: str(places[m[0]]), word) for word in line.split()]
        done = CliRunner().invoke(app, [*words, "-c", control])
        assert done.exception is None or isinstance(done.exception, SystemExit), line
        assert done.stdout + done.stderr, line
        assert not OBEYED.search(done.stdout + done.stderr), line
        for file in tmp_path.glob("F.*"):
            assert not OBEYED.search(file.read_bytes().decode()), (line, file)
            file.unlink()


def lines_of(*words: str, terminal: bool, monkeypatch: pytest.MonkeyPatch) -> str:
    """Return what a command writes to a terminal, or to a pipe."""
    out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="")
    monkeypatch.setattr(out, "isatty", lambda: terminal, raising=False)
    with monkeypatch.context() as of:
        of.setattr(sys, "stdout", out)
        with pytest.raises(SystemExit):
            app([*words], prog_name="cncsub")
    out.flush()
    assert isinstance(out.buffer, io.BytesIO)
    return out.buffer.getvalue().decode("utf-8", "surrogateescape")


@pytest.mark.parametrize("command", ["flatten", "check --diff"])
def test_programs_are_written_as_they_are_but_to_a_terminal(
    tmp_path: Path, command: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TERM", "dumb")  # without colours
    file = tmp_path / "O1.nc"
    file.write_text(f"O1\nPOPEN\nDPRNT[X]\nIF[#1EQ2]#3=4 ({EVIL})\nG0 X1 ({EVIL})\nM30\n")
    control = "fanuc-0i-f"
    if command == "flatten":
        file.write_text(f"(MSG, {EVIL})\nG0 X1\nM2\n")
        control = "linuxcnc"
    words = [*command.split(), str(file), "-c", control]
    piped = lines_of(*words, terminal=False, monkeypatch=monkeypatch)
    assert EVIL in piped
    if command == "flatten":
        CliRunner().invoke(app, [*words, "-o", str(tmp_path / "flat.nc")])
        assert (tmp_path / "flat.nc").read_bytes().decode() == piped
    seen = lines_of(*words, terminal=True, monkeypatch=monkeypatch)
    assert not OBEYED.search(seen)
    assert seen == "".join(f"{shown(line)}\n" for line in piped.splitlines())


def test_a_cell_of_csv_computes_nothing(tmp_path: Path) -> None:
    (tmp_path / '=HYPERLINK("x").ngc').write_text("G0 X-1\nM2\n")
    done = CliRunner().invoke(
        app, ["run", str(tmp_path / '=HYPERLINK("x").ngc'), "-c", "linuxcnc", "--format", "csv"]
    )
    (row,) = csv.DictReader(io.StringIO(done.stdout))
    assert (row["program"], float(row["x"])) == ('\'=HYPERLINK("x")', -1.0)


def test_each_kind_of_escape() -> None:
    every = "".join(map(chr, [*range(0x3000), 0xFFFE, 0xFEFF, 0x1F600]))
    assert shown(every).isprintable()
    assert not OBEYED.search(escape(every))
    assert escape("a<b>&\"'\t\u4e2d\u3000\u00a0\xad") == (
        "a&lt;b&gt;&amp;&quot;&#x27;\t\u4e2d\u3000\u00a0\xad"
    )
    xml = ElementTree.Element("a", b=for_xml(every))
    xml.text = for_xml(every)
    text = referred(ElementTree.tostring(xml, encoding="unicode"))
    assert text.replace("\n", "").isprintable()
    assert ElementTree.fromstring(text).get("b") == xml.get("b")
    assert for_github("a%\r\n:,\x1b\u4e2d") == "a%25%0D%0A:, \u4e2d"
    assert for_github("a%\r\n:,\x1b", property=True) == "a%25%0D%0A%3A%2C "
    assert [cell(text) for text in ("=1", " @a", "+", "-5", "O1", "a=", "")] == [
        "'=1", "' @a", "'+", "'-5", "O1", "a=", "",
    ]  # fmt: skip


def test_json_comes_out_whole_however_long_it_is(tmp_path: Path) -> None:
    (tmp_path / "O1.nc").write_text("O1\n" + "G1 X1. Y2. F5 (\u4e2d)\nG0 X5.\n" * 2_000 + "M30\n")
    out = tmp_path / "out.json"
    words = ["run", str(tmp_path / "O1.nc"), "-c", "fanuc-0i-f", "--format", "json"]
    done = CliRunner().invoke(app, words)
    CliRunner().invoke(app, [*words, "-o", str(out)])
    assert out.read_text() == done.stdout
    assert len(json.loads(done.stdout)["moves"]) == 4_000
