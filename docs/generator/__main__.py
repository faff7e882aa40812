"""Writes the pages that are made into a folder: `PYTHONPATH=docs python -m generator FOLDER`."""

import sys
from pathlib import Path

from generator import pages

for name, text in pages().items():
    file = Path(sys.argv[1], name)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
