"""Runs the notebooks of the examples and stores their outputs for those who only read them.

python tools/notebooks.py            # writes examples/notebooks
python tools/notebooks.py --check    # exit status 1 where outputs would be others

Of a figure the drawing and the text are stored: the figure itself is large, and comes with a run.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

NOTEBOOKS = Path(__file__).resolve().parent.parent / "examples" / "notebooks"
_LEFT_OUT = ("application/vnd.plotly.v1+json",)


def ran(file: Path) -> str:
    """Return the notebook with the outputs of a run, as it is stored."""
    import nbclient
    import nbformat

    book = nbformat.read(file, as_version=4)
    options = {"resources": {"metadata": {"path": str(file.parent)}}, "record_timing": False}
    nbclient.NotebookClient(book, timeout=120, kernel_name="python3", **options).execute()
    for cell in book.cells:
        for output in cell.get("outputs", ()):
            for kind in _LEFT_OUT:
                output.get("data", {}).pop(kind, None)
    before = json.loads(file.read_text(encoding="utf-8"))
    book.metadata = before["metadata"]  # without the version of this Python
    text: str = nbformat.writes(book, version=4)
    return text.rstrip("\n") + "\n"


def changed(file: Path, write: bool) -> bool:
    text = ran(file)
    same = text == file.read_text(encoding="utf-8")
    if write and not same:
        file.write_text(text, encoding="utf-8")
    return not same


def main() -> int:
    options: Any = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--check", action="store_true", help="write nothing")
    asked = options.parse_args()
    found = [file for file in sorted(NOTEBOOKS.glob("*.ipynb")) if changed(file, not asked.check)]
    for file in found:
        print(f"{file.name}: {'other outputs' if asked.check else 'written'}")
    return 1 if asked.check and found else 0


if __name__ == "__main__":
    raise SystemExit(main())
