"""The house is no worse than its page says; these are the measures that take seconds."""

from __future__ import annotations

import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

TOOL = Path(__file__).resolve().parent.parent / "tools" / "measure.py"


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    spec = importlib.util.spec_from_file_location("measure", TOOL)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["measure"] = module
    spec.loader.exec_module(module)
    return module


def number(figure: str) -> float:
    found = re.match(r"[\d.]+", figure)
    assert found, figure
    return float(found[0])


def test_the_page_has_a_figure_for_every_measure(tool: ModuleType) -> None:
    stated = tool.figures(tool.PAGE.read_text(encoding="utf-8"))
    assert [key for key in tool.MEASURES if not stated.get(key)] == []


def test_no_measure_is_worse_than_the_page_says(tool: ModuleType) -> None:
    stated = tool.figures(tool.PAGE.read_text(encoding="utf-8"))
    measured = tool.of_the_sources() | tool.of_the_facts()
    worse = {
        what: f"{figure}, the page says {stated[what]}"
        for what, figure in measured.items()
        if number(figure) > number(stated[what])
    }
    assert worse == {}, "mend it, or python tools/measure.py --write"
