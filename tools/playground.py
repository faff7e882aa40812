"""Puts the page for trying programs together: python tools/playground.py BUILD FOLDER

BUILD holds cncsub.js and cncsub.wasm; FOLDER gets the page, which opens from the disk. All that a
browser would not load from there stands in `made.js`: the worker as text, the engine packed, the
examples.
"""

from __future__ import annotations

import gzip
import importlib.util
import json
import re
import shutil
import sys
from pathlib import Path

import javascript

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "playground"
_COMMAND = re.compile(r"cncsub run examples/\S+ -c ([a-z0-9-]+)")


def examples() -> list[dict[str, str]]:
    """The examples that are one file and say by which control they are run."""
    found = []
    for file in sorted((ROOT / "examples").glob("*/*.*")):
        if file.suffix.lower() not in (".nc", ".mpf", ".ngc"):
            continue
        text = file.read_text(encoding="utf-8")
        if (command := _COMMAND.search(text)) is not None:
            name = f"{file.parent.name}/{file.name}"
            found.append({"name": name, "control": command[1], "text": text})
    first = "fanuc/bolt_circle.nc"
    return sorted(found, key=lambda one: (one["name"] != first, one["name"]))


# What a text in JavaScript cannot hold as it is, which stands as the character 256 further on.
_NOT_PLAIN = {0, 10, 13, 34, 92}


def seven_bits(data: bytes) -> str:
    """Bytes as characters of seven bits each: a sixth shorter than base64."""
    padded = data + bytes(-len(data) % 7)
    characters = []
    for at in range(0, len(padded), 7):
        group = int.from_bytes(padded[at : at + 7], "big")
        characters += [group >> shift & 127 for shift in range(49, -1, -7)]
    return "".join(chr(one + 256 if one in _NOT_PLAIN else one) for one in characters)


def made(build: Path) -> str:
    worker = [javascript.engine(build), (PAGE / "worker.js").read_text(encoding="utf-8")]
    packed = gzip.compress((build / "cncsub.wasm").read_bytes(), 9, mtime=0)
    told = {
        "worker": "\n".join(worker),
        "size": len(packed),
        "examples": examples(),
    }
    wasm = seven_bits(packed)
    return f'"use strict";\nconst PLAYGROUND = {json.dumps(told)};\nPLAYGROUND.wasm = "{wasm}";\n'


def write(build: Path, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for file in PAGE.iterdir():
        if file.name != "worker.js" and file.suffix in (".html", ".css", ".js"):
            shutil.copy(file, folder)
    (folder / "made.js").write_bytes(made(build).encode())
    plotly = importlib.util.find_spec("plotly")
    if plotly is None or plotly.origin is None:
        print("there is no plotly here: the page has no view in space (pip install plotly)")
    else:
        shutil.copy(Path(plotly.origin).parent / "package_data" / "plotly.min.js", folder)
    size = sum(file.stat().st_size for file in folder.iterdir() if file.name != "plotly.min.js")
    print(f"{folder}/index.html: {size / 1e6:.2f} MB before the library for the view in space")


if __name__ == "__main__":
    write(Path(sys.argv[1]), Path(sys.argv[2]))
