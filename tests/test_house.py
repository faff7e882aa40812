"""The rooms of the engine, and which way their arrows point."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
ENGINE = ROOT / "cpp" / "cncsub"

# What a room may know besides itself. A dialect knows no other dialect, and nobody knows a dialect
# but the reader of libraries, which is handed it.
KNOWS = {
    "system": set(),
    "text": {"system"},
    "control": {"system", "text"},
    "code": {"system", "text", "control"},
    "dialect": {"system", "text", "control", "code"},
    "trace": {"system", "text", "control", "code"},
    "motion": {"system", "text", "control", "code", "trace"},
    "machine": {"system", "text", "control", "code", "trace", "motion"},
    "analysis": {"system", "text", "control", "code", "trace"},
    # What a run executed, as a program: it has to run one, and nobody runs it but the bindings.
    "flat": {"system", "text", "control", "code", "trace", "motion", "machine"},
    "controls": {"text", "control"},
}


def room(path: Path) -> str:
    parts = path.relative_to(ROOT / "cpp").parts
    return parts[0] if parts[0] == "controls" else parts[1]


def sources() -> Iterator[Path]:
    for folder in (ENGINE, ROOT / "cpp" / "controls"):
        yield from (f for f in sorted(folder.rglob("*")) if f.suffix in {".hpp", ".cpp"})


def included(file: Path) -> Iterator[tuple[str, Path]]:
    for name in re.findall(r'^#include "([^"]+)"', file.read_text("utf-8"), re.MULTILINE):
        if name not in {"controls/list.def", "dialect/list.def"}:  # written by the build
            yield name, ROOT / "cpp" / name


def test_every_file_stands_in_a_room() -> None:
    assert {room(file) for file in sources()} == set(KNOWS)


@pytest.mark.parametrize("of", KNOWS)
def test_the_arrows_of_a_room_point_one_way(of: str) -> None:
    wrong = [
        f"{file.relative_to(ROOT)} includes {name}"
        for file in sources()
        if room(file) == of
        for name, path in included(file)
        if room(path) not in {of, *KNOWS[of]}
    ]
    assert not wrong


def test_no_dialect_knows_another() -> None:
    folders = [f for f in sorted((ENGINE / "dialect").iterdir()) if f.is_dir()]
    for folder in folders:
        others = {other.name for other in folders} - {folder.name}
        for file in folder.glob("*.?pp"):
            for name, _ in included(file):
                assert not any(f"dialect/{other}/" in name for other in others), (file, name)


def test_the_engine_knows_neither_python_nor_a_terminal() -> None:
    forbidden = re.compile(r"pybind11|Python\.h|<iostream>|std::cout|std::cerr|\bprintf\(")
    wrong = [
        str(file.relative_to(ROOT))
        for file in sources()
        if forbidden.search(file.read_text("utf-8"))
    ]
    assert not wrong
