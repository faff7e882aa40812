"""Everything that reports a line counts lines in one way, however they end."""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.lines import lines_of, without_end
from cncsub.notebook import program_html
from cncsub.variables_file import read_variables

CONTROL = "fanuc-0i-f"
PUNCHED = b"\n\r\r"  # the end of a block on a FANUC
ENDS = [b"\n", b"\r", b"\r\n", PUNCHED, b"\n\r", b"\r\r\n"]
TEXT = [b"%", b"O1 (PART)", b"", b"N10 M8", b"  N20 G1 X1. F100 XX", b"", b"", b"N30 M30", b"%"]


def text_with(ends: list[bytes]) -> bytes:
    return b"".join(map(b"".join, zip(TEXT, itertools.cycle(ends), strict=False)))


MIXED = [PUNCHED, b"\r\n", b"\n"]


@pytest.mark.parametrize("ends", [[end] for end in ENDS] + [MIXED], ids=repr)
def test_an_alarm_has_the_line_and_the_column_that_people_count(ends: list[bytes]) -> None:
    library = cncsub.loads(text_with(ends), control=CONTROL)
    alarm = library.run().alarm
    assert alarm is not None
    assert (alarm.line, alarm.column, alarm.word, alarm.n) == (5, 19, "XX", 20)
    assert str(alarm).splitlines()[2] == "   |   N20 G1 X1. F100 XX"
    assert [(block.line, block.n) for block in library.main.blocks] == [(4, 10), (5, 20), (8, 30)]
    assert library.main.line == 2
    (finding,) = (f for f in library.check() if f.n == 20 and f.severity == "error")
    assert (finding.line, finding.column) == (5, 19)


@pytest.mark.parametrize("ends", [[end] for end in ENDS] + [MIXED], ids=repr)
def test_all_that_tells_lines_tells_the_same(ends: list[bytes]) -> None:
    text = text_with(ends).replace(b" XX", b"")
    library = cncsub.loads(text, control=CONTROL)
    run = library.run()
    assert run.steps.line.tolist() == [4, 5, 8]
    assert [listed.line for listed in run.listing()] == [4, 5, 8]
    assert [row.line for row in run.coverage().blocks] == [4, 5, 8]
    assert [row.line for row in library.flatten().origins if row.line > 2] == [4, 5, 8]
    assert program_html(library.main).count("\n") == len(TEXT) - 3  # from its head to its end
    plain = [line.replace(b" XX", b"") for line in TEXT]
    assert [without_end(line) for line in lines_of(text)] == plain


@pytest.mark.parametrize("end", ENDS, ids=repr)
def test_a_file_that_is_mended_keeps_its_ends_of_lines(end: bytes, tmp_path: Path) -> None:
    lines = [b"O1", b"N10 M98 P2", b"N20 M30", b"O2", b"N30 G0 X1.5 (\xe4)", b"G99", b""]
    file = tmp_path / "part.nc"
    file.write_bytes(end.join(lines))
    arguments = ["check", str(file), "-c", CONTROL, "--fix", "--rule", "CS706"]
    assert CliRunner().invoke(app, arguments).exit_code == 0
    assert file.read_bytes() == end.join(lines).replace(b"G99", b"M99")


@pytest.mark.parametrize("end", ENDS, ids=repr)
def test_a_block_that_is_added_ends_as_the_others_do(end: bytes, tmp_path: Path) -> None:
    lines = [b"O1", b"N10 M98 P2", b"N20 M30", b"O2", b"N30 G0 X1.5", b"O3", b"N40 M30", b""]
    file = tmp_path / "part.nc"
    file.write_bytes(end.join(lines))
    arguments = ["check", str(file), "-c", CONTROL, "--fix", "--rule", "CS303"]
    CliRunner().invoke(app, arguments)
    lines.insert(5, b"M99")
    assert file.read_bytes() == end.join(lines)


@pytest.mark.parametrize("end", ENDS, ids=repr)
def test_a_file_of_variables_is_refused_at_its_line(end: bytes, tmp_path: Path) -> None:
    file = tmp_path / "variables.txt"
    file.write_bytes(end.join([b"%", b"#500=1.5", b"#501=2", b"#502=x", b"%", b""]))
    with pytest.raises(ValueError, match=r"variables\.txt:4: not a variable: '#502=x'"):
        read_variables(str(file))


def test_what_is_no_end_of_a_line_ends_none() -> None:
    text = "O1\nN10 M8 (A\x0bB\x0cC\x1cD\x85E\u2028F)\nN20 M30\n"
    library = cncsub.loads(text, control=CONTROL)
    assert [block.line for block in library.main.blocks] == [2, 3]
    assert len(lines_of(text)) == 3
    assert program_html(library.main).count("N20") == 1
