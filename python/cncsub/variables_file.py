"""Files of variables: TOML, CSV, and what a control wrote."""

from __future__ import annotations

import csv
import math
import os
import re
import struct
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from cncsub.inputs import Number, checked_variables, numbered
from cncsub.lines import lines_of, without_end
from cncsub.setup import from_toml

_VACANT = ("", "vacant", "none", "#0", "nan")
# Common variables as a FANUC punches them out: the bits of the value as a number of eight bytes,
# the highest first, all of them set where the variable is vacant. [a public decoder of such files]
_BITS = re.compile(r"G10\s*L85\s*P(\d+)\s*\(([0-9A-F]{16})\)")
_STATEMENT = re.compile(r"#(\d+)\s*=\s*([-+]?(?:\d+\.?\d*|\.\d+)|#0)")
_NO_MATTER = re.compile(r"|%|M0?2|M30|M99|[O:]\d+")
_COMMENT = re.compile(r"\([^()]*\)")


def read_variables(path: str | os.PathLike[str]) -> dict[Number, float | None]:
    """Return the variables of a file by number, `None` where one is vacant, for
    `run(variables=...)`.

    A file that ends in `.toml` has numbers for keys, `500 = 1.5`, or names as programs
    write them, `"R5" = 1.5`, in a table `variables` or without
    one; one that ends in `.csv` has a row for each variable, its number and its value, separated by
    commas, semicolons or tabs, with a head line or without. Any other file is what a control
    wrote: `G10L85P500(407F400000000000)`, the bits of a FANUC, or statements `#500=1.234`.
    `vacant`, `#0` and an empty cell are vacant.

    Raises `FileNotFoundError`, and `ValueError` with the file and the line for anything else: no
    line is skipped in silence. A variable that is there twice is refused as well.

    >>> import cncsub, pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp(), "macro.txt")
    >>> _ = file.write_text("%\\nG10L85P506(407F400000000000)\\n#507=1.25\\n#508=#0\\n%\\n")
    >>> cncsub.read_variables(file)
    {506: 500.0, 507: 1.25, 508: None}
    """
    name = os.fspath(path)
    if name.lower().endswith(".toml"):
        return from_toml(path, _from_table)
    try:
        text = Path(path).read_bytes().decode("utf-8-sig", errors="replace")
    except OSError as error:  # a device that fails names no file
        raise OSError(error.errno, error.strerror, name) from None
    rows = _csv_rows(text) if name.lower().endswith(".csv") else _punched(text)
    found: dict[Number, float | None] = {}
    for line, number, value in _checked(name, rows):
        if number in found:
            raise ValueError(f"{name}:{line}: #{number} is there twice")
        found[number] = value
    return found


def _from_table(table: Mapping[str, Any]) -> dict[Number, float | None]:
    told = table.get("variables", table)
    if not isinstance(told, Mapping) or (told is not table and len(table) > 1):
        raise ValueError(
            "a file of variables must have numbers as keys, or the one table variables"
        )
    values = {key: None if _is_vacant(value) else value for key, value in told.items()}
    return checked_variables("variables", numbered(values))


def _is_vacant(value: object) -> bool:
    return isinstance(value, str) and value.strip().lower() in _VACANT


Rows = Iterator[tuple[int, str, str | float]]  # line, number, value


def _checked(name: str, rows: Rows) -> Iterator[tuple[int, int, float | None]]:
    line = 0
    try:
        for line, number, told in rows:
            value = None if _is_vacant(told) else float(told)
            ((checked, kept),) = checked_variables("variables", {int(number): value}).items()
            yield line, int(checked), kept
    except _LineError as error:
        raise ValueError(f"{name}:{error.line}: {error}") from None
    except (ValueError, TypeError) as error:
        raise ValueError(f"{name}:{line}: {error}") from None


class _LineError(ValueError):
    def __init__(self, line: int, text: str) -> None:
        shown = text if len(text) <= 60 else text[:60] + " ..."
        super().__init__(f"not a variable: {shown!r}")
        self.line = line


def _csv_rows(text: str) -> Rows:
    lines = lines_of(text)
    head = lines[0] if lines else ""
    between = next((sign for sign in ";\t" if sign in head), ",")
    for line, row in enumerate(csv.reader(map(without_end, lines), delimiter=between), 1):
        cells = [cell.strip() for cell in row]
        if not any(cells):
            continue
        number = cells[0].removeprefix("#")
        if not number.isdecimal():
            if line == 1:  # a head
                continue
            raise _LineError(line, between.join(row))
        if len(cells) < 2 or any(cells[2:]):
            raise _LineError(line, between.join(row))
        value = cells[1].replace(",", ".") if between != "," else cells[1]
        yield line, number, value


def _punched(text: str) -> Rows:
    for line, written in enumerate(map(without_end, lines_of(text)), 1):
        block = written.strip(" \t\r\x00\x11\x12\x13\x14;").upper()
        if bits := _BITS.fullmatch(block):
            value = struct.unpack(">d", bytes.fromhex(bits[2]))[0]
            yield line, bits[1], "vacant" if math.isnan(value) else value
            continue
        block = _COMMENT.sub("", block).strip(" ;")
        if statement := _STATEMENT.fullmatch(block):
            yield line, statement[1], statement[2]
        elif not _NO_MATTER.fullmatch(block):
            raise _LineError(line, written.strip())
