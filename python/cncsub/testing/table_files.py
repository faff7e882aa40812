"""Tables of cases as files: Python, TOML and JSON."""

from __future__ import annotations

import importlib.util
from pathlib import Path

from cncsub.testing.cases import Case, collected
from cncsub.testing.exchange import cases_of_json
from cncsub.testing.toml import table_in


def load_table(path: str | Path) -> tuple[Case, ...]:
    """Return the cases of a file: of Python, whose calls of `case` they are; of TOML
    (`*.nctest.toml`), where each `[[case]]` holds the words of `case` and what stands above holds
    for all of them; or of JSON, a conformance suite as `tools/export_conformance.py` writes it.

    In TOML the numbers of variables are keys: `vars = {100 = 9}`; `load = ["macros/O9010.nc"]`
    names files and folders beside the table or elsewhere in its project, whose texts are the
    memory. Raises `ValueError` for a table that says what no case can, `OSError` for a file that
    cannot be read.
    """
    file = Path(path)
    if file.suffix == ".toml":
        return table_in(file)
    if file.suffix == ".json":
        return cases_of_json(file)
    spec = importlib.util.spec_from_file_location(f"cncsub_table_{file.stem}", file)
    if spec is None or spec.loader is None:
        raise ValueError(f"{file} is not a table of cases: write it in Python, TOML or JSON")
    with collected() as found:
        spec.loader.exec_module(importlib.util.module_from_spec(spec))
    return tuple(found)
