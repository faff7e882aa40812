"""The rooms of the engine and of the package, and the direction of the arrows between them."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import cncsub

ROOT = Path(__file__).parent.parent
ENGINE = ROOT / "cpp" / "cncsub"

# The rooms that a room may know. A dialect knows no other dialect, and no room knows a dialect; the
# reader of libraries gets them as an argument.
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
    # Two runs compared. Only what is above the engine uses this room: the bindings and the library.
    "comparison": {"system", "text", "control", "code", "dialect", "trace", "motion", "machine"},
    # What a run executed, as a program: this room runs it, and only the bindings use this room.
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
        if name not in {"controls/list.def", "dialect/list.def"}:  # the build writes these
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


# The rooms inside the large rooms: each knows those before it. Files beside them know all.
INNER = {
    "motion": ["state", "frame", "path", "cycle", "block"],
    "machine": ["state", "values", "statements", "calls", "run"],
}


@pytest.mark.parametrize("of", INNER)
def test_the_arrows_inside_a_room_point_one_way(of: str) -> None:
    def height(path: Path) -> int:
        inner = path.relative_to(ENGINE / of).parts[:-1]
        return INNER[of].index(inner[0]) if inner else len(INNER[of])

    files = [file for file in sources() if room(file) == of]
    assert {height(file) for file in files} == set(range(len(INNER[of]) + 1))
    wrong = [
        f"{file.relative_to(ROOT)} includes {name}"
        for file in files
        for name, path in included(file)
        if room(path) == of and height(path) > height(file)
    ]
    assert not wrong


# A dialect whose control reads the blocks of another one beside a language of its maker.
BUILT_ON = {"syntec": "iso"}


def test_no_dialect_knows_another() -> None:
    folders = [f for f in sorted((ENGINE / "dialect").iterdir()) if f.is_dir()]
    for folder in folders:
        others = {other.name for other in folders} - {folder.name, BUILT_ON.get(folder.name)}
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


# ---- the package ----

PACKAGE = ROOT / "python" / "cncsub"

# The modules at the top are three rooms: `base`, the programs, controls and options; `face`, the
# objects that users hold; and `package`, the names that `import cncsub` gives.
_FACE = {"library", "machine", "run", "stream", "loading", "sibling_files"}
MAY_IMPORT = {
    "base": set(),
    "tables": {"base"},
    "coverage": {"base"},
    "analysis": {"base", "tables"},
    "drawing": {"base", "tables"},
    "resume": {"base", "tables", "analysis"},
    "face": {"base", "tables", "coverage", "analysis", "drawing", "resume"},
    "comparison": {"base", "tables", "analysis", "face"},
    "questions": {"base", "tables", "face"},
    "editing": {"base", "tables", "analysis", "face"},
    "plot": {"base", "tables", "drawing"},
    "reports": {"base", "tables", "coverage", "analysis", "drawing", "face"},
    "debugging": {"base", "tables", "face", "reports"},
    "terminal": {"base", "tables", "analysis", "drawing", "face", "reports", "debugging"},
    "dap": {"base", "face", "debugging"},
    "archive": {"base", "tables", "face", "reports"},
    "package": {"base", "tables", "coverage", "analysis", "face", "comparison", "reports"}
    | {"archive", "resume"},
    "testing": {"base", "analysis", "face", "package"},
    "cli": {"base", "tables", "coverage", "analysis", "face", "comparison", "editing", "plot"}
    | {"reports", "archive", "package", "resume", "dap", "debugging", "terminal", "questions"},
    # The servers for editors and for agents: commands of their own, which no other room imports.
    "agents": {"base", "tables", "face", "reports", "package", "cli"},
    "editor": {"base", "tables", "analysis", "face", "editing", "reports", "cli"},
}


def modules() -> dict[str, Path]:
    """Return the modules of the package by name; `cncsub.plot` stands for its `__init__`."""
    files = sorted(PACKAGE.rglob("*.py"))
    parts = {file: file.relative_to(PACKAGE.parent).with_suffix("").parts for file in files}
    return {".".join(p[:-1] if p[-1] == "__init__" else p): f for f, p in parts.items()}


MODULES = modules()


def room_of(module: str) -> str:
    name, _, inner = module.removeprefix("cncsub").removeprefix(".").partition(".")
    if not name or name == "__main__":
        return "package" if not name else "cli"
    if inner or MODULES[module].name == "__init__.py":
        return name
    return "face" if name in _FACE else "base"


def imports_of(module: str) -> Iterator[str]:
    """Yield the modules of the package that a module imports, in functions too.

    Imports for annotations do not count. A method `plot` may import what draws, because plotly is
    needed only if a picture is asked for.
    """
    waiting: list[tuple[ast.AST, bool]] = [(ast.parse(MODULES[module].read_text("utf-8")), False)]
    while waiting:
        node, draws = waiting.pop()
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            continue
        draws |= isinstance(node, ast.FunctionDef) and node.name == "plot"
        named: list[str] = []
        if isinstance(node, ast.Import):
            named = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{module}: a relative import"
            inner = [f"{node.module}.{alias.name}" for alias in node.names]
            named = [
                name if name in MODULES or name == "cncsub._core" else str(node.module)
                for name in inner
            ]
        for name in named:
            if name in MODULES and not (draws and room_of(name) == "plot"):
                yield name
        waiting += [(child, draws) for child in ast.iter_child_nodes(node)]


@pytest.mark.parametrize("of", MAY_IMPORT)
def test_the_imports_of_a_room_of_the_package_point_one_way(of: str) -> None:
    wrong = [
        f"{module} imports {name}"
        for module in MODULES
        if room_of(module) == of
        for name in imports_of(module)
        if room_of(name) not in {of, *MAY_IMPORT[of]}
    ]
    assert not wrong


def test_every_module_of_the_package_stands_in_a_room() -> None:
    assert {room_of(module) for module in MODULES} == set(MAY_IMPORT)


def test_no_modules_of_the_package_import_each_other() -> None:
    arrows = {module: set(imports_of(module)) - {module} for module in MODULES}
    try:
        TopologicalSorter(arrows).prepare()
    except CycleError as error:
        pytest.fail(f"a circle: {' <- '.join(error.args[1])}")


def test_the_names_that_are_imported_later_stand_below_the_package() -> None:
    later = {f"cncsub.{module}" for module in cncsub._LATER.values()}
    assert later <= set(MODULES)
    assert {room_of(module) for module in later} <= MAY_IMPORT["package"]


# ---- the options of a run ----


def test_an_option_of_a_run_is_stated_in_three_files() -> None:
    """The files that pass options on name none of them: the library, the commands, the stubs."""
    stated_in = {
        "python/cncsub/run_options.py",
        "python/bindings/options.cpp",
        "cpp/cncsub/machine/state/options.hpp",
    }
    page = (ROOT / "docs" / "adding-an-option.md").read_text("utf-8")
    assert all(f"`{name}`" in page for name in stated_in)
    handed_on = [PACKAGE / "library.py", PACKAGE / "_core.pyi", *PACKAGE.glob("comparison/*.py")]
    assert not [f for f in handed_on if _names(f, "max_memory|max_seconds|optional_stop")]
    assert not [f for f in PACKAGE.glob("cli/*.py") if _names(f, "max_memory|max_cycles")]
    # An option that only the engine asks for stands in these files and where it is obeyed.
    files = [
        str(file.relative_to(ROOT))
        for folder in (PACKAGE / "cli", PACKAGE / "analysis", ROOT / "python" / "bindings", ENGINE)
        for file in [*folder.rglob("*.py"), *folder.rglob("*.?pp"), PACKAGE / "run_options.py"]
        if _names(file, "max_memory")
    ]
    assert set(files) == {*stated_in, "cpp/cncsub/machine/state/limits.cpp"}


# ---- what is added ----


def _files_naming(word: str) -> set[str]:
    folders = (ENGINE, ROOT / "cpp" / "controls", ROOT / "python" / "cncsub")
    files = [file for folder in folders for file in folder.rglob("*") if file.is_file()]
    named = [f for f in files if f.suffix in (".cpp", ".hpp", ".def", ".py") and _names(f, word)]
    return {str(file.relative_to(ROOT)) for file in named}


def test_a_code_with_motion_is_added_in_the_files_that_the_page_names() -> None:
    page = (ROOT / "docs" / "adding-a-code.md").read_text("utf-8")
    files = _files_naming("Tapping|63=tapping")
    assert files - {"cpp/controls/siemens/family.cpp"} == {
        "cpp/cncsub/control/meanings.def",
        "cpp/cncsub/control/motion_lists.hpp",
        "cpp/cncsub/motion/block/block.cpp",
    }
    assert all(f"`{file}`" in page for file in files if file.startswith("cpp/cncsub"))


def test_a_rule_of_check_is_added_in_the_files_that_the_page_names() -> None:
    page = (ROOT / "docs" / "adding-a-rule-of-check.md").read_text("utf-8")
    files = _files_naming("InputAhead|check_read_ahead")
    assert files == {
        f"cpp/cncsub/analysis/{name}"
        for name in ("checks.def", "read_ahead.cpp", "checker.hpp", "check.cpp")
    }
    assert all(f"`{name}`" in page for name in ("checker.hpp", "check.cpp"))


def _names(file: Path, words: str) -> bool:
    return re.search(rf"\b(?:{words})\b", file.read_text("utf-8")) is not None
