"""`cncsub run --listing`: what ran, block by block, as lines or as JSON lines."""

from __future__ import annotations

import contextlib
import json
import sys
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Annotated, Any

import typer

import cncsub
from cncsub.escapes import shown
from cncsub.writing import opened

Listing = Annotated[
    bool,
    typer.Option(
        "--listing",
        help="Print each executed block and what it did; with json one object per line.",
    ),
]
Where = Annotated[
    list[str] | None,
    typer.Option(
        "--where",
        help="Print only the blocks with program=O2, depth=1, n=30 or variable=100.",
        metavar="NAME=VALUE",
    ),
]

_NUMBERS = ("depth", "n", "variable")


def filters(texts: Iterable[str]) -> dict[str, Any]:
    """Return texts such as `depth=1` as options of `Run.listing`."""
    asked: dict[str, Any] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        name = name.strip()
        if not equals or name not in (*_NUMBERS, "program"):
            raise ValueError(f"--where must be program=, depth=, n= or variable=, not {text!r}")
        if name in asked:
            raise ValueError(f"--where {name} is given twice")
        if name == "program":
            asked[name] = value.strip()
            continue
        digits = value.strip().lstrip("#Nn")
        if not digits.isdecimal():
            raise ValueError(f"--where {name}= must be a whole number, not {value!r}")
        asked[name] = int(digits)
    return asked


def write_listing(blocks: Iterator[cncsub.Listed], output: Path | None, *, as_json: bool) -> None:
    """Write a line for each block, as they are made: a run may have millions."""
    lines = _lines(blocks, as_json=as_json)
    with contextlib.nullcontext(sys.stdout) if output is None else opened(output, "w") as file:
        for line in lines:
            file.write(line + "\n")


def _lines(blocks: Iterator[cncsub.Listed], *, as_json: bool) -> Iterator[str]:
    for block in blocks:
        if as_json:
            yield json.dumps(_facts(block), allow_nan=False)
        else:
            yield from map(shown, str(block).split("\n"))


def _facts(block: cncsub.Listed) -> dict[str, Any]:
    facts = asdict(block)
    facts["moves"] = [
        {name: value for name, value in move.items() if value is not None}
        for move in facts["moves"]
    ]
    return facts
