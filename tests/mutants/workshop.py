"""Builds the module once as it is, and again with one source changed."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ENGINE = ROOT / "cpp" / "cncsub"
MODULE = "_core" + sysconfig.get_config_var("EXT_SUFFIX")
COMPILE_SECONDS = 300


class Workshop:
    """A build tree outside the repository, and a copy of the package that takes the mutants."""

    def __init__(self, folder: Path, flags: str) -> None:
        self.folder = folder
        self.tree = folder / "build"
        self.package = folder / "package"
        self.headers = folder / "headers.hpp"
        self.flags = flags
        self.commands: dict[str, tuple[list[str], Path]] = {}

    def prepare(self) -> None:
        """Build everything as it is, upon what an earlier build left."""
        import pybind11

        configure = [
            *("cmake", "-S", str(ROOT), "-B", str(self.tree), "-G", "Ninja"),
            # Debug: no optimization across files, so that one file alone can be built again.
            *("-DCMAKE_BUILD_TYPE=Debug", f"-DCMAKE_CXX_FLAGS_DEBUG={self.flags}"),
            f"-Dpybind11_DIR={pybind11.get_cmake_dir()}",
            f"-DPython_EXECUTABLE={sys.executable}",
        ]
        _run(configure)
        _run(["cmake", "--build", str(self.tree), "--parallel", str(len(os.sched_getaffinity(0)))])
        for entry in json.loads((self.tree / "compile_commands.json").read_text()):
            command = shlex.split(entry["command"])
            output = self.tree / command[command.index("-o") + 1]
            self.commands[entry["file"]] = (command, output)
        self._precompile_headers()
        inside = self.package / "cncsub"
        shutil.rmtree(self.package, ignore_errors=True)
        inside.mkdir(parents=True)
        for file in (ROOT / "python" / "cncsub").iterdir():
            if not file.name.startswith("_core.c"):
                (inside / file.name).symlink_to(file)
        self.install()

    def _precompile_headers(self) -> None:
        """Precompile all headers of the standard library as one: they are most of the work for a
        mutant.
        """
        sources = [file for file in map(Path, self.commands) if file.is_relative_to(ENGINE)]
        includes = {
            line
            for file in [*sources, *ENGINE.rglob("*.hpp")]
            for line in file.read_text().splitlines()
            if line.startswith("#include <")
        }
        self.headers.write_text("\n".join(sorted(includes)) + "\n")
        command = self.commands[str(sources[0])][0]
        command = command[: command.index("-o")]
        _run([*command, "-x", "c++-header", "-o", f"{self.headers}.gch", str(self.headers)])

    def install(self) -> None:
        """Install the module as it is."""
        self._replace(self.tree / MODULE)

    def build(self, file: Path, source: str) -> bool:
        """Put the module with this source in place of the file's own; return False if none
        compiles.
        """
        changed, made = self.folder / file.name, self.folder / f"{file.stem}.o"
        changed.write_text(source)
        command, output = self.commands[str(file)]
        command = [str(changed) if part == str(file) else part for part in command]
        command[command.index("-o") + 1] = str(made)
        command += ["-w", "-include", str(self.headers)]
        if not _succeeds(command, self.tree):
            return False
        objects = [made if other == output else other for _, other in self.commands.values()]
        linked = self.folder / MODULE
        link = [command[0], "-shared", "-o", str(linked), *map(str, objects)]
        if not _succeeds(link, self.tree):
            return False
        self._replace(linked)
        return True

    def _replace(self, module: Path) -> None:
        """Write a new file, because the old one may be in use."""
        place = self.package / "cncsub" / MODULE
        place.unlink(missing_ok=True)
        shutil.copy(module, place)


def _run(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=_environment())
    if done.returncode:
        sys.exit(f"{shlex.join(command)}\n{done.stdout}{done.stderr}")


def _succeeds(command: list[str], folder: Path) -> bool:
    done = subprocess.run(
        command,
        cwd=folder,
        capture_output=True,
        check=False,
        timeout=COMPILE_SECONDS,
        env=_environment(),
    )
    return done.returncode == 0


def _environment() -> dict[str, str]:
    """Return the environment without a compiler cache: it would keep every mutant."""
    return {**os.environ, "CCACHE_DISABLE": "1"}
