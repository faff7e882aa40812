"""Puts the package for JavaScript together: python tools/javascript.py BUILD FOLDER

BUILD holds cncsub.js and cncsub.wasm as Emscripten writes them; FOLDER gets the package, which Node
and browsers import: `import { start } from "./cncsub.js"`.
"""

from __future__ import annotations

import json
import shutil
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "javascript"


def engine(build: Path) -> str:
    """Emscripten's loader and the objects over it, as a script that is no module yet."""
    loader = (build / "cncsub.js").read_text(encoding="utf-8")
    return loader + "\n" + (SOURCES / "face.js").read_text(encoding="utf-8")


def write(build: Path, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    start = (SOURCES / "start.js").read_text(encoding="utf-8")
    (folder / "cncsub.js").write_text(engine(build) + start, encoding="utf-8")
    shutil.copy(build / "cncsub.wasm", folder)
    for name in ("cncsub.d.ts", "example.js", "README.md"):
        shutil.copy(SOURCES / name, folder)
    shutil.copy(ROOT / "LICENSE", folder)
    told = json.loads((SOURCES / "package.json").read_text(encoding="utf-8"))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    told["version"] = project["version"]
    (folder / "package.json").write_text(json.dumps(told, indent=2) + "\n", encoding="utf-8")
    size = sum(file.stat().st_size for file in folder.iterdir())
    print(f"{folder}: the package for JavaScript, {size / 1e6:.2f} MB")


if __name__ == "__main__":
    write(Path(sys.argv[1]), Path(sys.argv[2]))
