"""`cncsub renumber` and `cncsub format`: what they print, write and refuse."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import cncsub
from cncsub.byte_edits import NoPlaceError, edited
from cncsub.checking import Edit
from cncsub.cli.commands import app
from cncsub.editing import format, renumber

MAIN = "O1 (\u4f60\u597d)\nN1 (\u4f60)g0x1. M98 P2\nN5 IF[#1EQ1]GOTO 1\nM30\n"
SUB = "O2\nN7 M99\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.nc").write_bytes(MAIN.replace("\n", "\r\n").encode("gbk"))
    (tmp_path / "O2.nc").write_text(SUB)
    return tmp_path


def call(*args: str, control: str = "fanuc-0i-f") -> Result:
    return CliRunner().invoke(app, [*args, "-c", control])


def test_one_file_is_printed_with_its_new_numbers(folder: Path) -> None:
    done = call("renumber", "O2.nc")
    assert (done.exit_code, done.stdout) == (0, "O2\nN10 M99\n")


def test_a_check_names_the_files_that_would_change(folder: Path) -> None:
    before = (folder / "a.nc").read_bytes()
    done = call("renumber", ".", "--check")
    assert done.exit_code == 1
    assert done.stdout == "would change: a.nc\nwould change: O2.nc\n"
    assert (folder / "a.nc").read_bytes() == before
    assert call("renumber", "O2.nc", "--check", "--start", "7").exit_code == 0


def test_written_files_keep_their_encoding_and_line_ends(folder: Path) -> None:
    assert call("renumber", ".", "--write").exit_code == 0
    wanted = MAIN.replace("N1", "N10").replace("N5", "N20").replace("GOTO 1", "GOTO 10")
    assert (folder / "a.nc").read_bytes() == wanted.replace("\n", "\r\n").encode("gbk")
    assert (folder / "O2.nc").read_text() == "O2\nN10 M99\n"
    assert call("format", "a.nc", "--write").exit_code == 0
    wanted = wanted.replace(")g0x1.", ") G0 X1.")
    assert (folder / "a.nc").read_bytes() == wanted.replace("\n", "\r\n").encode("gbk")
    assert call("format", "a.nc", "--check").exit_code == 0


def test_a_difference_is_printed_and_nothing_is_written(folder: Path) -> None:
    done = call("format", "a.nc", "--diff")
    assert done.exit_code == 1
    assert b"+N1 (\xc4\xe3) G0 X1. M98 P2\r\n" in done.stdout_bytes
    assert b"g0x1." in (folder / "a.nc").read_bytes()


def test_another_file_is_written_where_one_is_given(folder: Path) -> None:
    assert call("renumber", "a.nc", "-o", "new.nc").exit_code == 0
    assert b"GOTO 10\r\n" in (folder / "new.nc").read_bytes()
    assert call("renumber", "a.nc", "-o", "a.nc").exit_code == 2
    assert call("renumber", ".", "-o", "new.nc").exit_code == 2


def test_what_is_refused_is_named_and_not_written(folder: Path) -> None:
    (folder / "O3.nc").write_text("O3\nN1 GOTO#1\nM30\n")
    done = call("renumber", "O3.nc", "--write")
    assert done.exit_code == 1
    assert "refused: O3 N1, line 2: #1 names a block that is known only when it runs" in done.stderr
    assert (folder / "O3.nc").read_text() == "O3\nN1 GOTO#1\nM30\n"
    told = json.loads(call("renumber", "O3.nc", "--format", "json").stdout)
    assert told["refused"] == ["O3 N1, line 2: #1 names a block that is known only when it runs"]


def test_edits_are_told_as_json(folder: Path) -> None:
    done = call("renumber", "O2.nc", "--check", "--format", "json")
    assert done.exit_code == 1
    told = json.loads(done.stdout)
    assert told["edits"] == [{"file": "O2.nc", "line": 2, "column": 2, "old": "7", "new": "10"}]
    assert (told["control"], told["ran"], told["refused"]) == ("fanuc-0i-f", ["O2"], [])


@pytest.mark.parametrize(
    "options",
    [("--check", "--write"), ("--step", "0"), ("--which", "some"), ("--start", "-1")],
)
def test_wrong_use_is_told(folder: Path, options: tuple[str, ...]) -> None:
    assert call("renumber", "O2.nc", *options).exit_code == 2


def test_several_files_need_to_be_told_what_to_do(folder: Path) -> None:
    assert call("renumber", ".").exit_code == 2


def test_a_file_that_changed_meanwhile_is_not_written(folder: Path) -> None:
    made = renumber(cncsub.load("O2.nc", control="fanuc-0i-f"))
    (folder / "O2.nc").write_text("O2\nM99 (N7)\n")
    with pytest.raises(NoPlaceError, match="there is no '7' any more"):
        made.write()
    assert (folder / "O2.nc").read_text() == "O2\nM99 (N7)\n"


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "cp932", "utf-8", "latin-1"])
def test_bytes_that_no_edit_names_stay(tmp_path: Path, encoding: str) -> None:
    sign = {"cp932": "\u30c6\u30b9\u30c8", "latin-1": "\xb0\xe9"}.get(encoding, "\u6f22\xe9")
    data = f"O1 ({sign})\nN1({sign})g0x1.({sign})\nM30\n".encode(encoding)
    (tmp_path / "a.nc").write_bytes(data)
    library = cncsub.load(tmp_path / "a.nc", control="fanuc-0i-f", encoding=encoding)
    format(library).write()
    wanted = f"O1 ({sign})\nN1 ({sign}) G0 X1. ({sign})\nM30\n".encode(encoding)
    assert (tmp_path / "a.nc").read_bytes() == wanted


def test_an_edit_may_hold_letters_in_the_encoding_of_the_file() -> None:
    edit = Edit("a.nc", 1, 1, "\xff", "  \xff")
    assert edited(b"\xff91g1\n", [edit], "\xff91g1") == b"  \xff91g1\n"
    edit = Edit("a.nc", 1, 4, "\u6f22", " \u6f22")
    for encoding in ("utf-8", "gb18030"):
        line = "(\u6f22)\u6f22x1\n".encode(encoding)
        assert edited(line, [edit], "(\u6f22)\u6f22x1") == "(\u6f22) \u6f22x1\n".encode(encoding)


def test_bytes_that_are_no_text_stay() -> None:
    line = b"N1 (\xff\xfe\x81)G0 X1\n"
    shown = "N1 (\ufffd\ufffd\ufffd)G0 X1"
    edit = Edit("a.nc", 1, 9, "G0", "G00")
    assert edited(line, [edit], shown) == b"N1 (\xff\xfe\x81)G00 X1\n"
