"""The files that are read: those that are named, and those of the given folders, and no others."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub import system
from cncsub.cli import app, project

C = ("-c", "fanuc-0i-f")
MAIN = "O1\nN10 M98 P77\nN20 M30\n"
SUB = "O77\nN30 G0 X77\nN40 M99\n"


def command(*words: object) -> tuple[int, str, str]:
    done = CliRunner().invoke(app, list(map(str, words)))
    if done.exception is not None and not isinstance(done.exception, SystemExit):
        raise done.exception
    return done.exit_code, done.stdout, done.stderr


@pytest.fixture
def job(tmp_path: Path) -> Path:
    """A program that calls another one, and, outside of its folder, files that it must not read."""
    (tmp_path / "job").mkdir()
    (tmp_path / "out").mkdir()
    (tmp_path / "job" / "main.nc").write_text(MAIN)
    (tmp_path / "out" / "real.nc").write_text(SUB)
    (tmp_path / "out" / "O0077.nc").write_text(SUB)
    try:
        (tmp_path / "probe").symlink_to("out")
    except OSError:
        pytest.skip("this system makes no links")
    return tmp_path / "job"


def is_read(job: Path, *words: object) -> bool:
    """Return whether the program that is called was found, by every command alike."""
    status, _, _ = command("run", *(words or (job / "main.nc",)), *C)
    listed = command("list", *(words or (job / "main.nc",)), *C)[1]
    assert (status == 0) == ("O77, which does not exist" not in listed)
    return status == 0


LINKS = [
    "../out/real.nc",
    "../out/O0077.nc",
    "../job/../out/real.nc",
    "nowhere.nc",
    "O0077.nc",  # to itself
    "/dev/zero",
    "../out",
]


@pytest.mark.parametrize("to", LINKS)
@pytest.mark.parametrize("name", ["O0077.nc", "77", "o77.NC", "O77."])
def test_a_link_that_leads_out_of_the_folder_is_read_by_neither(
    job: Path, to: str, name: str
) -> None:
    (job / name).symlink_to(to if to != "O0077.nc" else name)
    assert not is_read(job)
    assert not is_read(job, job)


def test_a_link_that_is_left_alone_is_told_and_read_when_it_is_named(job: Path) -> None:
    link = job / "O0077.nc"
    link.symlink_to("../out/real.nc")
    status, _, told = command("run", job / "main.nc", *C)
    assert status == 1
    assert f"{link} was not read: a link to a place outside the folder; give it too" in told
    assert is_read(job, job / "main.nc", link)


def test_a_link_within_the_folder_is_read_by_both(job: Path) -> None:
    (job / "store").mkdir()
    (job / "store" / "x.nc").write_text(SUB)
    (job / "O0077.nc").symlink_to("store/x.nc")
    assert is_read(job)


def test_a_folder_that_is_a_link_is_the_folder_that_was_given(job: Path) -> None:
    (job / "O0077.nc").write_text(SUB)
    link = job.parent / "link"
    link.symlink_to("job")
    assert is_read(job, link / "main.nc")
    (job / "O0077.nc").unlink()
    (job / "O0077.nc").symlink_to("../out/real.nc")
    assert not is_read(job, link / "main.nc")


def test_links_beside_what_a_link_leads_to_stay_in_its_folder(job: Path) -> None:
    (job.parent / "desk").mkdir()
    named = job.parent / "desk" / "today.nc"
    named.symlink_to("../job/main.nc")
    assert not is_read(job, named)
    (job / "O0077.nc").symlink_to("../out/real.nc")
    assert not is_read(job, named)
    (job / "O0077.nc").unlink()
    (job / "O0077.nc").write_text(SUB)
    assert is_read(job, named)


@pytest.mark.parametrize("name", ["O0077.png", "O0077.bak", ".O0077", "O0077.\x1b"])
def test_what_a_folder_leaves_alone_is_left_alone_beside_a_file(job: Path, name: str) -> None:
    (job / name).write_text(SUB)
    assert not is_read(job)


@pytest.mark.parametrize("data", [b"\x89PNG\r\n\x1a\n" + bytes(50), b"PK\x03\x04" + bytes(50)])
def test_a_file_beside_that_is_no_program_is_told(job: Path, data: bytes) -> None:
    (job / "O0077.nc").write_bytes(data)
    assert not is_read(job)
    assert "O0077.nc: left out: " in command("run", job / "main.nc", *C)[2]


def test_a_subprogram_of_linuxcnc_is_looked_for_in_the_folder_alone(job: Path) -> None:
    (job / "main.ngc").write_text("o<sub> call\nM2\n")
    (job.parent / "out" / "sub.ngc").write_text("o<sub> sub\nG0 X1\no<sub> endsub\n")
    (job / "sub.ngc").symlink_to("../out/sub.ngc")
    assert command("run", job / "main.ngc", "-c", "linuxcnc")[0] == 1
    (job / "sub.ngc").unlink()
    (job / "sub.ngc").write_text("o<sub> sub\nG0 X1\no<sub> endsub\n")
    assert command("run", job / "main.ngc", "-c", "linuxcnc")[0] == 0


def test_no_folder_outside_is_searched_for_a_hint(job: Path) -> None:
    (job / "macros").symlink_to("../out")
    assert "out" not in command("run", job / "main.nc", *C)[2]


def test_a_batch_reads_beside_a_file_what_its_folder_holds(job: Path) -> None:
    pytest.importorskip("pyarrow")
    (job / "O0077.nc").symlink_to("../out/real.nc")
    rows = cncsub.run_many([job / "main.nc"], control=C[1], each="beside", jobs=1)
    assert rows["cause"].to_pylist() == ["program-not-found"]


# ---- files that a project names ----

EXTERNAL = "O1\nN10 M198 P77\nN20 M30\n"
NAMED = {
    "external": "out",
    "setup": "setup.toml",
    "inputs": "inputs.toml",
    "variables": "variables.csv",
}


@pytest.fixture
def shop(job: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of foreign programs with a project, and next to it files that it may name."""
    (job / "main.nc").write_text(EXTERNAL)
    out = job.parent / "out"
    (out / "real.nc").unlink()
    (out / "setup.toml").write_text("rapid = { X = 1 }\n")
    (out / "inputs.toml").write_text("clock_ms = 5\n")
    (out / "variables.csv").write_text("100,1\n")
    (job.parent / "desk").mkdir()
    monkeypatch.chdir(job.parent / "desk")
    return job


def place(shop: Path, key: str, lead: str) -> str:
    """Return the line of a project that names something by its path."""
    name = NAMED[key]
    return f'control = "fanuc-0i-f"\n{key} = "{lead}{"" if name == "out" else "/" + name}"\n'


@pytest.mark.parametrize("key", NAMED)
@pytest.mark.parametrize("file", ["cncsub.toml", "pyproject.toml"])
def test_a_project_beside_foreign_programs_names_nothing_outside(
    shop: Path, key: str, file: str
) -> None:
    head = "[tool.cncsub]\n" if file == "pyproject.toml" else ""
    for lead in ("../out", str(shop.parent / "out"), "link", "../job/../out"):
        if lead == "link":
            (shop / "link").symlink_to("../out")
        (shop / file).write_text(head + place(shop, key, lead))
        status, out, told = command("run", shop / "main.nc")
        assert (status, out) == (2, "")
        assert f"{shop / file}: {key} is outside the folder" in told
        assert f"give --{key} {shop / lead}" in told
        assert (command("check", shop)[0] == 2) == (key in ("external", "setup"))


def test_what_is_given_by_hand_is_read_whatever_a_project_names(shop: Path) -> None:
    (shop / "cncsub.toml").write_text(place(shop, "external", "../out"))
    assert command("run", shop / "main.nc", "--external", shop.parent / "out")[0] == 0


def test_one_s_own_project_names_what_it_likes_and_that_is_told(
    shop: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (shop / "cncsub.toml").write_text(place(shop, "external", "../out"))
    monkeypatch.chdir(shop)
    status, _, told = command("run", "main.nc")
    assert status == 0
    assert f"note: {shop.parent / 'out'}: the project file gives it as external" in told
    monkeypatch.setattr(system, "is_ours", lambda path: False)  # another user has it
    status, _, told = command("run", "main.nc")
    assert status == 2
    assert "external is outside the folder" in told


def test_a_project_beside_foreign_programs_names_what_lies_in_its_folder(shop: Path) -> None:
    (shop / "usb").mkdir()
    (shop / "usb" / "O77.nc").write_text(SUB)
    (shop / "cncsub.toml").write_text('control = "fanuc-0i-f"\nexternal = "usb"\n')
    status, _, told = command("run", shop / "main.nc")
    assert status == 0
    assert "names it for" not in told


def test_a_project_that_is_a_link_is_no_way_out(shop: Path) -> None:
    (shop.parent / "out" / "cncsub.toml").write_text('control = "fanuc-0i-f"\n')
    (shop / "cncsub.toml").symlink_to("../out/cncsub.toml")
    status, _, told = command("run", shop / "main.nc")
    assert status == 2
    assert "is a link to a file outside its folder, and is not read" in told


def test_the_programs_of_another_user_s_project_lie_in_its_folder(
    shop: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (shop / "cncsub.toml").write_text('control = "fanuc-0i-f"\nfolders = ["../out"]\n')
    monkeypatch.chdir(shop)
    assert command("list")[0] == 0
    monkeypatch.setattr(system, "is_ours", lambda path: False)
    assert command("list")[0] == 2
    assert command("check")[0] == 2


def test_a_project_that_nests_too_deep_is_told(shop: Path) -> None:
    for text in ("a=" + "[" * 5000, ".".join("a" * 5000) + "=1", "a=" + "{b=" * 3000):
        (shop / "cncsub.toml").write_text(text)
        with pytest.raises(ValueError, match=r"cncsub\.toml: "):
            project.find_project(shop)


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="this system has no such owners")
def test_a_file_of_another_user_is_not_ours(tmp_path: Path) -> None:
    file = tmp_path / "cncsub.toml"
    file.write_text("")
    assert system.is_ours(file)
    if os.geteuid() == 0:
        os.chown(file, 12345, -1)
        assert not system.is_ours(file)


def test_a_file_that_cannot_be_read_is_named(job: Path) -> None:
    broken = Path("/proc/self/mem")
    if not broken.exists():
        pytest.skip("this system has no file that fails")
    for option in ("--setup", "--inputs", "--variables"):
        status, _, told = command("run", job / "main.nc", *C, option, broken)
        assert (status, told) == (5, f"cncsub: {broken}: Input/output error\n")
    (job / "cncsub.toml").write_text('setup = "a\\u0000b"\n')
    assert command("run", job / "main.nc", *C)[0] == 2
    assert command("batch", job, *C, "-j", "9" * 30)[0] == 2
