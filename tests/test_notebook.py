"""The view of objects in a notebook: bounded pages of HTML without scripts."""

from __future__ import annotations

import doctest
import inspect
import re
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

import cncsub
import cncsub.testing
from cncsub import editing

CONTROL = "fanuc-0i-f"


def text_of(html: str) -> str:
    return re.sub(r"<[^>]*>", "", html)


@pytest.fixture
def library() -> cncsub.Library:
    text = "O1 (PART <1>)\nN10 M98 P2 L2\nN20 G1 X10. F100 (CUT)\nN30 M98 P7\nO2\nN5 G0 Z5.\nM99\n"
    return cncsub.loads(text, control=CONTROL, name="part.nc")


def test_a_run_shows_how_it_ended_and_what_it_called(library: cncsub.Library) -> None:
    html = library.run()._repr_html_()
    shown = text_of(html)
    assert shown.startswith("stopped: alarm, 6 blocks, 3 moves, ")
    assert "PS0076 program-not-found" in shown
    assert "N30 M98 P7" in shown
    assert "^^" in shown
    assert "M98 O2, 2 passes (4 blocks)" in shown
    assert "<td>X</td><td>0</td><td>10</td>" in html


def test_a_run_that_does_not_end_says_why() -> None:
    run = cncsub.loads("O1\nN10 #1=1\nN20 GOTO 10\n", control=CONTROL).run(max_blocks=50)
    assert "an endless loop, proven" in run._repr_html_()


def test_messages_are_few(library: cncsub.Library) -> None:
    text = "O1\nPOPEN\n" + "DPRNT[A]\n" * 30 + "M30\n"
    shown = text_of(cncsub.loads(text, control=CONTROL).run()._repr_html_())
    assert shown.count("message: A") == 8
    assert "... and 22 more" in shown


def test_a_memory_shows_its_programs_and_notes() -> None:
    many = "".join(f"O{i} (P{i})\nM99\n" for i in range(1, 31)) + "O3\nM30\n"
    html = cncsub.loads(many, control=CONTROL)._repr_html_()
    assert text_of(html).startswith("FANUC Series 0i-F: 30 programs")
    assert html.count("<tr>") == 21
    assert "O1 (main)" in html
    assert "... and 10 more" in html
    assert "note: " in html


def test_a_program_shows_its_lines(library: cncsub.Library) -> None:
    html = library["O1"]._repr_html_()
    assert '<span style="opacity:.55">(CUT)</span>' in html
    assert "(PART &lt;1&gt;)" in html
    lines = text_of(html).splitlines()
    assert lines[0] == "O1, part.nc:1, 3 blocks     1  O1 (PART &lt;1&gt;)"
    assert lines[-1] == "     4  N30 M98 P7  &larr; CS201 O7 is not in the memory"


def test_of_a_long_program_the_middle_is_left_out() -> None:
    text = "O1\n" + "".join(f"N{i} G4 X1.\n" for i in range(1, 101)) + "M30" + "(" + "x" * 5000
    html = cncsub.loads(text, control="gsk-988ta")["O1"]._repr_html_()
    assert len(html) < 10_000
    assert "... 62 lines" in text_of(html)


def test_the_calls_are_a_tree(library: cncsub.Library) -> None:
    assert text_of(library.run().calls._repr_html_()).splitlines()[-1] == "1 call"


# ---- single values ----


def test_an_alarm_shows_its_caret_and_its_cure(library: cncsub.Library) -> None:
    alarm = library.run().alarm
    assert alarm is not None
    shown = text_of(alarm._repr_html_())  # type: ignore[attr-defined]
    assert "PS0076 program-not-found" in shown
    assert "^^" in shown
    assert cncsub.causes[alarm.cause].cure in shown


def test_a_program_shows_what_is_wrong_with_its_lines(library: cncsub.Library) -> None:
    shown = text_of(library["O1"]._repr_html_())
    assert "N30 M98 P7  &larr; CS201 O7 is not in the memory" in shown


def test_a_control_shows_its_facts_with_their_sources() -> None:
    control = cncsub.controls[CONTROL]
    html = control._repr_html_()  # type: ignore[attr-defined]
    shown = text_of(html)
    assert f"{len(control.alarms):,} alarms" in shown
    assert control.rules[0].source in shown.replace("&#x27;", "'").replace("&amp;", "&")
    assert html.count("<details>") == 3


def test_findings_graphs_coverage_comparisons_and_variables_have_pages() -> None:
    text = "O1\nN10 #100=<1>\nN20 M98 P2\nN30 IF[#1 EQ #0]GOTO 20\nM30\nO2\n#100=2.5\nM99\n"
    library = cncsub.loads(text, control=CONTROL)
    run = library.run(max_blocks=50)
    values = [*library.check(), library.call_graph(), run.coverage(), run.coverage().blocks]
    values += [run.coverage().branches, run.variables]
    values.append(cncsub.compare(library, controls=[CONTROL, "mitsubishi-m700"]))
    for value in values:
        html = value._repr_html_()
        assert html.startswith("<div>")
        assert "<1>" not in html
    assert "O1</td><td>3</td><td>M98</td><td>O2" in library.call_graph()._repr_html_()


def test_many_variables_are_cut() -> None:
    library = cncsub.loads("O1\nM30\n", control=CONTROL)
    run = library.run(variables=dict.fromkeys(range(100, 200), 1.0))
    assert "... and 40 more" in run.variables._repr_html_()


# ---- help ----


def test_only_public_names_are_listed_and_all_have_words() -> None:
    assert dir(cncsub) == sorted(cncsub.__all__)
    for name in cncsub.__all__:
        assert name == "__version__" or (getattr(cncsub, name).__doc__ or "").strip(), name
    for kind in (cncsub.Alarm, cncsub.Frame, cncsub.Control):
        members = [name for name in dir(kind) if not name.startswith("_")]
        assert [name for name in members if not getattr(kind, name).__doc__] == []


def public_classes() -> list[type]:
    """Return the classes that have a public name, and those of the objects that a user gets."""
    machine = cncsub.loads("O1\nM30\n", control=CONTROL).machine()
    handed = [machine.steps, machine.calls, machine.moves, machine.watch, machine.codes]
    handed += [machine.variables, machine.signals, machine.coverage(), machine.coverage().blocks]
    handed += [cncsub.controls, machine.steps.program]
    named = [getattr(cncsub, name) for name in cncsub.__all__ if name != "__version__"]
    for module in (cncsub.testing, editing):
        named += [getattr(module, name) for name in module.__all__]
    classes = [value for value in named if inspect.isclass(value)]
    return [*classes, *map(type, handed)]


def members(kind: type) -> list[tuple[str, Any]]:
    """Return the public names of a class that the package gives it, and their values."""
    own = [base for base in kind.__mro__ if base.__module__.startswith("cncsub")]
    found = {name: value for base in reversed(own) for name, value in vars(base).items()}
    return [(name, value) for name, value in found.items() if not name.startswith("_")]


def functions(value: Any) -> list[Any]:
    """Return the functions of a member of a class."""
    for name in ("__func__", "fget", "func"):
        value = getattr(value, name, None) or value
    return [value] if callable(value) else []


@pytest.mark.parametrize("kind", public_classes(), ids=lambda kind: kind.__name__)
def test_every_member_has_words_and_names_its_options(kind: type) -> None:
    assert (kind.__doc__ or "").strip()
    for name, value in members(kind):
        for function in functions(value):
            assert (inspect.getdoc(value) or "").strip(), f"{kind.__name__}.{name}"
            if inspect.isfunction(function):
                parameters = inspect.signature(function).parameters.values()
                assert not any(p.kind is p.VAR_KEYWORD for p in parameters), name


def test_every_function_has_words_and_names_its_options() -> None:
    found = [getattr(cncsub, name) for name in cncsub.__all__ if name != "__version__"]
    for module in (cncsub.testing, editing):
        found += [getattr(module, name) for name in module.__all__]
    some = [function for function in found if inspect.isfunction(function)]
    assert len(some) > 8
    for function in some:
        assert (function.__doc__ or "").strip(), function
        parameters = inspect.signature(function).parameters.values()
        assert not any(p.kind is p.VAR_KEYWORD for p in parameters), function


def test_the_import_brings_no_heavy_module() -> None:
    """The time of the import is measured by `tests/benchmarks`: the clock of a busy machine is no
    test.
    """
    code = "import sys, cncsub; print(*{name.partition('.')[0] for name in sys.modules})"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    heavy = {"numpy", "pandas", "pyarrow", "plotly", "typer", "rich", "pytest", "dask", "pydantic"}
    assert heavy.isdisjoint(told.stdout.split())


@pytest.mark.parametrize(
    ("missing", "extra", "use"),
    [
        ("plotly", "plot", lambda run: run.plot()),
        ("plotly", "plot", lambda run: run.calls.plot()),
        ("plotly", "plot", lambda run: run.watch.plot()),
        ("pandas", "pandas", lambda run: run.moves.to_pandas()),
        ("pyarrow", "arrow", lambda run: run.moves.to_arrow()),
        ("pyarrow", "arrow", lambda run: run.steps.__arrow_c_stream__()),
        ("pyarrow", "arrow", lambda run: cncsub.run_many([], CONTROL)),
    ],
)
def test_what_is_not_installed_is_told_with_what_installs_it(
    missing: str, extra: str, use: Callable[[Any], Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [name for name in sys.modules if name.partition(".")[0] == missing]:
        monkeypatch.setitem(sys.modules, name, None)
    monkeypatch.setitem(sys.modules, missing, None)
    run = cncsub.loads("O1\nG0 X1.\nM30\n", control=CONTROL).run(watch=[100])
    told = rf"this needs {missing}; install it with: pip install 'cncsub\[{extra}\]'"
    with pytest.raises(ImportError, match=told):
        use(run)


def test_the_examples_of_the_engines_types() -> None:
    for kind in (cncsub.Alarm, cncsub.Frame, cncsub.Control):
        parser, runner = doctest.DocTestParser(), doctest.DocTestRunner()
        found = parser.get_doctest(kind.__doc__ or "", {}, kind.__name__, None, 0)
        assert found.examples
        assert runner.run(found).failed == 0


@pytest.mark.parametrize(
    "function",
    [
        cncsub.Library.run, cncsub.Library.mdi, cncsub.Library.machine, cncsub.Library.stream,
        cncsub.Library.flatten, cncsub.compare, cncsub.translate, cncsub.flatten,
    ],
)  # fmt: skip
def test_signatures_name_every_option(function: object) -> None:
    parameters = inspect.signature(function).parameters  # type: ignore[arg-type]
    assert not any(p.kind is p.VAR_KEYWORD for p in parameters.values())
    assert parameters["max_blocks"].default == 10_000_000


def test_run_many_names_its_options() -> None:
    parameters = inspect.signature(cncsub.run_many).parameters
    assert "trace" not in parameters
    assert "setup" in parameters
    assert parameters["max_blocks"].default == 1_000_000
