"""Wrong use is reported in plain words that name what was wrong and what to use instead."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cncsub

CONTROL = "fanuc-0i-f"
TEXT = "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G1 X1. F5\nN40 M99\n"


@pytest.fixture
def library() -> cncsub.Library:
    return cncsub.loads(TEXT, control=CONTROL)


# ---- parameters ----


@pytest.mark.parametrize(
    ("parameters", "error", "words"),
    [
        (
            {"6151": 1},
            ValueError,
            "fanuc-0i-f has no parameter 6151; the nearest are 6202, 6203, 6204",
        ),
        ({"6151": 1}, ValueError, "`cncsub controls fanuc-0i-f` lists them"),
        (
            {"6001": 1},
            ValueError,
            "no parameter 6001; the nearest are 6001#1, 6001#3, 6001#4, 6001#5",
        ),
        ({"6001#0": 1}, ValueError, "no parameter 6001#0; the nearest are 6001#1"),
        ({"6050#1": 1}, ValueError, "no parameter 6050#1; the nearest are 6050"),
        ({"6001#8": 1}, ValueError, "6001#8: the bits of a parameter are 0 to 7"),
        ({"6001#5": 2}, ValueError, "6001#5 is a bit: its value must be 0 or 1"),
        ({"6001#5": -1}, ValueError, "6001#5 is a bit: its value must be 0 or 1"),
        ({"6001#5": 0.5}, ValueError, "6001#5 is a bit: its value must be 0 or 1"),
        ({"name": 1}, ValueError, "'name' is not a parameter: write its number, such as '6050'"),
        ({"": 1}, ValueError, "'' is not a parameter"),
        ({"6001#": 1}, ValueError, "'6001#' is not a parameter"),
        ({"9" * 30: 1}, ValueError, "is not a parameter"),
        ({6050: 70}, TypeError, "the name of a parameter must be a text such as '6050'.* not 6050"),
        ({None: 70}, TypeError, "the name of a parameter must be a text"),
        ({"\ud800": 1}, TypeError, "the name of a parameter must be a text"),
        ({"6050": "70"}, TypeError, "parameter 6050 must be a number, not '70'"),
        ({"6050": None}, TypeError, "parameter 6050 must be a number, not None"),
        ({"6050": 10**400}, ValueError, "parameter 6050 must be a number up to"),
        ([("6050", 70)], TypeError, "takes a mapping such as .'6050': 70., not list"),
        (None, TypeError, "takes a mapping"),
        ("6050=70", TypeError, "takes a mapping"),
    ],
)
def test_a_parameter_that_the_control_does_not_have_is_refused(
    parameters: Any, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        cncsub.controls[CONTROL].with_parameters(parameters)


def test_zeros_in_front_of_a_parameter_may_be_missing() -> None:
    control = cncsub.controls["gsk-980tdi"].with_parameters({"19": 5, "1#0": 1})
    assert (control.parameters["019"].value, control.parameters["001#0"].value) == (5, 1)
    assert "19" not in control.parameters
    library = cncsub.loads("O1\n#100=PRM[1,1]\nM30\n", control=CONTROL)
    assert library.run().variables[100] == 0
    changed = library.control.with_parameters({"1#1": 1})
    assert cncsub.loads("O1\n#100=PRM[1,1]\nM30\n", control=changed).run().variables[100] == 1


# ---- until ----


@pytest.mark.parametrize(
    "until",
    [("O2", 30.0), ("O2", True), ("O2", None), (1.5, 30), (None, 30), (True, 30),
     ("O2", 30, 1), ["O2", 30], 1.0, True, {}],
)  # fmt: skip
def test_until_names_a_block_or_a_depth(library: cncsub.Library, until: Any) -> None:
    with pytest.raises(
        TypeError, match=r"until must be a Block, a program and a sequence number such as"
    ):
        library.machine().run(until=until)


@pytest.mark.parametrize("until", [("O2", "30"), ("O2",), "O2", "O2 N30", ""])
def test_until_takes_no_other_text(library: cncsub.Library, until: Any) -> None:
    with pytest.raises(ValueError, match="is no breakpoint: it must be such as 'O2:N30'"):
        library.machine().run(until=until)


@pytest.mark.parametrize("until", [("O2", 99), ("O9", 30), (9, 30), (-1, 30), (2**70, 30)])
def test_until_names_a_block_there_is(library: cncsub.Library, until: tuple[Any, int]) -> None:
    with pytest.raises(KeyError, match=r"no block N99 in O2|no program .* in the memory"):
        library.machine().run(until=until)


def test_until_takes_a_block_of_its_own_library(library: cncsub.Library) -> None:
    block = library["O2"].blocks[0]
    machine = library.machine()
    assert machine.run(until=block) is None
    assert [step.n for step in machine.steps] == [10]
    other = cncsub.loads(TEXT, control=CONTROL)
    with pytest.raises(ValueError, match=r"Block\(n=30, .* is a block of another library"):
        other.machine().run(until=block)
    assert library.machine().run(until=2**70) is None
    assert library.machine().run(until=-1) is not None


@pytest.mark.parametrize("until", [-2, -5, -(2**70)])
def test_until_counts_calls_from_none_on(library: cncsub.Library, until: int) -> None:
    with pytest.raises(ValueError, match=f"until: .* not {until}"):
        library.machine().run(until=until)


# ---- variables and inputs ----


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        (
            {"variables": {3000: 1}},
            ValueError,
            "variables: #3000 can be set only by a program",
        ),
        (
            {"variables": {3006: 1}},
            ValueError,
            "variables: #3006 can be set only by a program",
        ),
        ({"variables": {5001: 1}}, ValueError, "variables: #5001 cannot be written"),
        ({"variables": {1000: 1}}, ValueError, "variables: #1000 cannot be written"),
        ({"variables": {4001: 1}}, ValueError, "variables: #4001 cannot be written"),
        ({"variables": {9_999_999: 1}}, ValueError, "variables: there is no #9999999"),
        ({"variables": {0: 1}}, ValueError, "variables: #0 is always vacant"),
        (
            {"variables": {100: "5"}},
            TypeError,
            r"#100 must be a number or None \(vacant\), not '5'",
        ),
        ({"variables": {100: True}}, TypeError, "#100 must be a number"),
        (
            {"variables": {"100": 5}},
            TypeError,
            "a variable number must be a whole number such as 100",
        ),
        (
            {"inputs": {"signals": {100: 1}}},
            ValueError,
            "signals: #100 is not a signal on fanuc-0i-f",
        ),
        ({"inputs": {"writes": [{3000: 1}]}}, ValueError, "writes: #3000 can be set only"),
        ({"inputs": {"writes": [{9_999_999: 1}]}}, ValueError, "writes: there is no #9999999"),
        ({"inputs": {"skips": ["0.5"]}}, TypeError, r"skips\[0\] must be a fraction"),
    ],
)
def test_a_variable_that_cannot_be_given_is_told(
    library: cncsub.Library, options: dict[str, Any], error: type[Exception], words: str
) -> None:
    for begin in (library.run, library.machine, library.stream):
        with pytest.raises(error, match=words):
            begin(**options)


def test_signals_and_work_offsets_can_be_given(library: cncsub.Library) -> None:
    run = library.run(
        variables={5221: 3}, inputs={"signals": {1000: 1, 1032: 5}, "writes": [{1001: 1, 500: 2}]}
    )
    assert run.moves.mx[0] == 4


def test_an_unknown_option_is_told_with_what_is_near(library: cncsub.Library) -> None:
    for name in ("machine", "stream"):
        with pytest.raises(TypeError, match=f"{name} has no option 'cycles'"):
            getattr(library, name)(cycles=3)
    with pytest.raises(TypeError, match="mdi has no option 'cycles'"):
        library.mdi("M98 P2", cycles=3)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="mdi runs the text that was typed and has no main"):
        library.mdi("M98 P2", main="O1")  # type: ignore[call-arg]


@pytest.mark.parametrize("odd", ["no", b"", None, 2, [], math.nan])
def test_optional_stop_is_yes_or_no(library: cncsub.Library, odd: Any) -> None:
    with pytest.raises(TypeError, match="optional_stop must be True or False, not"):
        library.run(optional_stop=odd)
    assert library.run(optional_stop=np.bool_(True), max_seconds=np.float32(9)).stop == "end"


# ---- setup ----


@pytest.mark.parametrize(
    ("setup", "error", "words"),
    [
        ({"limits": {"X": {-1, 5}}}, TypeError, "the lowest and the highest coordinate, not"),
        ({"limits": {"X": {-1: 0, 5: 0}}}, TypeError, "the lowest and the highest coordinate"),
        ({"limits": {"X": b"12"}}, TypeError, "the lowest and the highest coordinate"),
        ({"limits": {"X": [1, 2, 3]}}, TypeError, "the lowest and the highest coordinate"),
        ({"limits": {"X": (5, 1)}}, ValueError, "5 is above 1"),
        ({"limits": {"X": (1, math.nan)}}, ValueError, "out of range: nan"),
        ({"limits": {"X": (1, 2), "x": (1, 2)}}, ValueError, "limits has X twice, also as 'x'"),
        ({"reference": {9: {"X": 1}}}, ValueError, "reference: the points must be 1 to 4, not 9"),
        ({"reference": {0: {"X": 1}}}, ValueError, "reference: the points must be 1 to 4, not 0"),
        ({"start": {"X": 1, "x": 2}}, ValueError, "start has X twice, also as 'x'"),
        ({"start": {"X": math.nan}}, ValueError, r"start\['X'\] is out of range: nan"),
        ({"start": {"X": -math.inf}}, ValueError, "out of range: -inf"),
        ({"start": {"X": b"1"}}, TypeError, r"start\['X'\] must be a number, not b'1'"),
        ({"start": {1: 1}}, ValueError, "start: 1 is not an axis"),
        ({"rapid": {"X": 1, "x": 2}}, ValueError, "rapid has X twice"),
        ({"work_offsets": {"G54.1 P999": {}}}, ValueError, "EXT and G54.1 P1 to P300"),
        ({"work_offsets": {"G54.1 P0": {}}}, ValueError, "EXT and G54.1 P1 to P300"),
        ({"work_offsets": {"G54": {}, "g54 ": {}}}, ValueError, "work_offsets has G54 twice"),
        ({"length_offsets": {1: 5, "1": 6}}, ValueError, "length_offsets has 1 twice, also as '1'"),
        ({"length_offsets": {1.5: 5}}, ValueError, "1.5 is not the number of an offset"),
    ],
)
def test_a_setup_that_means_nothing_is_refused(
    library: cncsub.Library, setup: Any, error: type[Exception], words: str
) -> None:
    for use in (lambda: cncsub.Setup(**setup), lambda: library.run(setup=setup)):
        with pytest.raises(error, match=words):
            use()


def test_a_control_has_as_many_work_coordinate_systems_as_its_rule_says() -> None:
    setup = cncsub.Setup(work_offsets={"G54.1 P49": {"X": 1}})
    control = cncsub.controls[CONTROL]
    text = "O1\nG54.1 P49 G0 X1.\nM30\n"
    with pytest.raises(ValueError, match="fanuc-0i-f has no G54.1 P49; the last is G54.1 P48"):
        cncsub.loads(text, control=control).run(setup=setup)
    run = cncsub.loads(text, control=control.replace(max_extra_systems=300)).run(setup=setup)
    assert run.moves.mx.tolist() == [2]


@pytest.mark.parametrize("name", ["G54.1 P1", "G58", "G59", "G54.1 P100"])
def test_a_sinumerik_has_no_work_coordinate_systems_of_other_controls(name: str) -> None:
    library = cncsub.loads("G0 X1\nM30\n", control="siemens-one")
    with pytest.raises(ValueError, match=f"siemens-one has no {name}"):
        library.run(setup=cncsub.Setup(work_offsets={name: {"X": 1}}))


@pytest.mark.parametrize(
    ("name", "control"),
    [("G505", CONTROL), ("G500", CONTROL), ("G505", "gsk-988ta")],
)
def test_other_controls_have_none_of_a_sinumerik(name: str, control: str) -> None:
    library = cncsub.loads("O1\nG0 X1.\nM30\n", control=control)
    with pytest.raises(ValueError, match=f"{control} has no {name}"):
        library.run(setup=cncsub.Setup(work_offsets={name: {"X": 1}}))


# ---- streams ----


def test_a_stream_that_was_read_writes_no_files(library: cncsub.Library, tmp_path: Path) -> None:
    stream = library.stream(rows=1)
    next(stream)
    with pytest.raises(ValueError, match="parts of this stream were already read"):
        stream.to_parquet(tmp_path / "half")
    assert not (tmp_path / "half").exists()
    assert len(list(stream)) == 3
    stream = library.stream()
    stream.to_parquet(tmp_path / "whole")
    with pytest.raises(ValueError, match="already read"):
        stream.to_parquet(tmp_path / "again")


def test_a_stream_that_keeps_nothing_writes_no_files(
    library: cncsub.Library, tmp_path: Path
) -> None:
    with pytest.raises(ValueError, match="trace='none' records nothing that could be written"):
        library.stream(trace="none").to_parquet(tmp_path / "none")
    assert not (tmp_path / "none").exists()
    library.stream(trace="calls").to_parquet(tmp_path / "calls")
    rows = {
        name: len(pytest.importorskip("pandas").read_parquet(tmp_path / "calls" / name))
        for name in ("steps-000000.parquet", "calls-000000.parquet", "moves-000000.parquet")
    }
    assert list(rows.values()) == [0, 1, 0]


# ---- any argument of any function ----

ODD = [
    None, True, -1, 0, 1.5, 10**400, math.nan, "", "x", "\ud800", b"1", (), [], {}, {1}, {"a": 1},
    {1: "a"}, [1, "a"], object(), 1j, len, int, cncsub, range(3),
]  # fmt: skip
RAW = ("incompatible function arguments", "No constructor defined", "Unable to cast", "_core")


def uses(odd: Any, tmp_path: Path) -> Iterator[Callable[[], object]]:
    """Yield every function and operator of the public face with an odd argument at each place."""
    known = cncsub.controls[CONTROL]
    library = cncsub.loads(TEXT, control=CONTROL)
    run = library.run()
    machine = library.machine()
    limit = {"max_blocks": 100}
    yield lambda: cncsub.load(odd, control=CONTROL)
    yield lambda: cncsub.load(tmp_path, control=odd)
    for name in ("external", "encoding"):
        yield lambda name=name: cncsub.load(tmp_path, control=CONTROL, **{name: odd})
    yield lambda: cncsub.loads(odd, control=CONTROL)
    yield lambda: cncsub.loads(TEXT, control=odd)
    for name in ("external", "encoding", "name"):
        yield lambda name=name: cncsub.loads(TEXT, control=CONTROL, **{name: odd})
    for mapping in (cncsub.controls, cncsub.causes, library, library.external, known.parameters):
        yield lambda mapping=mapping: mapping[odd]
        yield lambda mapping=mapping: odd in mapping
        yield lambda mapping=mapping: mapping.get(odd)
    yield lambda: known.with_parameters(odd)
    yield lambda: known.with_parameters()
    yield lambda: known.with_parameters(odd, odd)
    yield lambda: known.with_parameters(a=odd)
    yield lambda: known.with_parameters({odd: 1})
    yield lambda: known.with_parameters({"6050": odd})
    yield lambda: known.replace(odd)
    yield lambda: known.replace(max_nesting=odd)
    yield lambda: known.replace(angle_unit=odd)
    for kind in (cncsub.Control, cncsub.Alarm, cncsub.Frame):
        yield kind
        yield lambda kind=kind: kind(odd)
    for begin in (library.run, library.machine, library.stream):
        yield lambda begin=begin: begin(odd, **limit)
        for name in cncsub.Library.run.__kwdefaults__:
            yield lambda begin=begin, name=name: begin(**{**limit, name: odd})
    yield lambda: library.stream(rows=odd)
    yield lambda: library.stream().to_parquet(odd)
    yield lambda: library.mdi(odd)
    yield lambda: library.mdi("M98 P2", start=odd)
    for name in ("start", "limits", "tools", "reference", "machine", "increment"):
        yield lambda name=name: cncsub.Setup(**{name: odd})
        yield lambda name=name: cncsub.Setup(**{name: {"X": odd, 1: odd}})
    yield lambda: cncsub.Setup.from_toml(odd)
    for name in ("signals", "clock", "operator", "writes", "skips"):
        yield lambda name=name: cncsub.Inputs(**{name: odd})
        yield lambda name=name: cncsub.Inputs(**{name: [odd]})
    yield lambda: machine.run(until=odd)
    yield lambda: machine.run(until=(odd, 10))
    yield lambda: machine.run(until=("O1", odd))
    variables = machine.variables
    for table in (variables, run.variables):
        yield lambda table=table: table[odd]
        yield lambda table=table: odd in table
        yield lambda table=table: table.get(odd, 1)
        yield lambda table=table: table == odd
    for change in (variables.pop, variables.setdefault, variables.__delitem__, variables.level):
        yield lambda change=change: change(odd)
    yield lambda: variables.__setitem__(odd, 1)
    yield lambda: variables.__setitem__(100, odd)
    yield lambda: variables.update(odd)
    for rows in (run.steps, run.calls, run.moves, library["O1"].blocks):
        yield lambda rows=rows: rows[odd]
        yield lambda rows=rows: rows == odd
    yield lambda: run.steps.column(odd)
    yield lambda: run.calls.tree(most=odd)
    yield lambda: run.moves.bounds[odd]
    yield lambda: run.moves.bounds.get(odd)
    yield lambda: run.alarm == odd


@pytest.mark.parametrize("odd", ODD, ids=lambda odd: repr(odd)[:20])
def test_every_function_takes_every_argument_or_refuses_it_in_words(
    odd: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "O1.nc").write_text(TEXT)
    for number, use in enumerate(uses(odd, tmp_path)):
        try:
            use()
        except (ValueError, TypeError, KeyError, IndexError, OSError) as error:
            said = str(error)
            assert said, number
            assert not any(raw in said for raw in RAW), (number, said)


def test_the_part_of_a_long_line_around_the_word_is_shown() -> None:
    text = "(" + "a" * 300 + ") G1 X1. ? (" + "b" * 300 + ")\n"
    alarm = cncsub.loads(f"O1\n{text}M30\n", control="fanuc-0i-f").run().alarm
    source, mark = str(alarm).splitlines()[2:4]
    assert len(source) < 180
    assert source[mark.index("^")] == "?"
    assert "..." in source
    assert source.endswith("...")


def test_what_a_terminal_obeys_does_not_move_the_mark() -> None:
    alarm = cncsub.loads("O1\n(\x1b\x00) G1 ?\nM30\n", control="fanuc-0i-f").run().alarm
    source, mark = str(alarm).splitlines()[2:4]
    assert source.endswith("| (  ) G1 ?")
    assert source[mark.index("^")] == "?"


# ---- the command line uses its own names for things ----


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (
            "plot main.nc -o x.html --points 3",
            "--points must be a number of points from 100, not 3",
        ),
        ("plot main.nc -o x.html --color red", "--color must be one of kind"),
        ("plot main.nc -o x.html --of calls --over z", "--over must be time or steps, not 'z'"),
        (
            "plot main.nc -o x.html --of calls --color tool",
            "--color is only for --of path, not calls",
        ),
        (
            "plot main.nc -o x.html --of calls --machine",
            "--machine is only for --of path, not calls",
        ),
        ("plot main.nc -o x.html --of programs --points 500", "--points is only for --of path"),
        ("plot main.nc -o x.html --over steps", "--over is only for --of calls or watch, not path"),
        ("run main.nc --skip 12", "--skip: a block-skip switch must be 1 to 10, not 12"),
        ("run main.nc --start 7", "--start: there is no block N7 in O1"),
        ("run main.nc --start -7", "--start, a sequence number, must be at least 0, not -7"),
        (
            "run main.nc --set 100=nan",
            "--set must be NUMBER=VALUE, such as 100=23.34 or 100=vacant",
        ),
        ("run main.nc --set 100=inf", "--set must be NUMBER=VALUE"),
        ("run main.nc --set 100=1e300", "--set, --variables: #100 must be a number up to 1e+47"),
        ("run main.nc --prefer none.nc", "--prefer is"),
        ("run main.nc -", "- is the standard input, which is read alone"),
        ("batch main.nc --each x", "--each must be one of file, beside, folder, not 'x'"),
        ("batch main.nc --max-seconds -1", "--max-seconds must be more than 0 and finite"),
        ("check main.nc --rule program-mising", "'program-mising'; did you mean program-missing"),
        ("check main.nc --rule ZZ999", "no rule 'ZZ999'; there are CS101 to CS"),
        ("run dangling.nc", "a broken link; did you mean mangling.nc, main.nc?\n"),
    ],
)
def test_a_wrong_option_is_told_by_the_name_of_the_option(
    words: str, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from typer.testing import CliRunner

    from cncsub.cli import app

    monkeypatch.chdir(tmp_path)
    Path("main.nc").write_text(TEXT)
    Path("mangling.nc").write_text(TEXT)
    Path("dangling.nc").symlink_to("nowhere")
    done = CliRunner().invoke(app, [*words.split(), "-c", CONTROL])
    assert (done.exit_code, done.stdout) == (2, "")
    assert told in done.stderr
    assert done.stderr.count("\n") == 1


def test_explain_knows_what_is_near() -> None:
    from typer.testing import CliRunner

    from cncsub.cli import app

    def told(name: str) -> str:
        return CliRunner().invoke(app, ["explain", name]).output

    assert "did you mean program-missing" in told("program-mising")
    assert told("program-missing").startswith("CS201 program-missing")
    assert "did you mean CS709" in told("CS999")
    assert "did you mean PS0076" in told("PS076x")


@pytest.mark.parametrize("value", [math.nan, math.inf, np.nan, np.float64("-inf")])
def test_what_is_no_number_is_no_value_of_a_variable(library: cncsub.Library, value: float) -> None:
    with pytest.raises(ValueError, match=r"variables: #100 must be a number (or None|up to)"):
        library.run(variables={100: value})
    with pytest.raises(ValueError, match="#100 must be a number"):
        library.machine().variables[100] = value
