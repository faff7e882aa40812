"""Any input has a defined outcome: reading never fails, and every run ends as a `Run`."""

from __future__ import annotations

import encodings
import itertools
from pkgutil import iter_modules

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import cncsub

controls = st.sampled_from(list(cncsub.controls))


def _is_taken(encoding: str) -> bool:
    try:
        return cncsub.loads(b"", control="fanuc-0i-f", encoding=encoding) is not None
    except ValueError:
        return False


ENCODINGS = sorted(filter(_is_taken, {module.name for module in iter_modules(encodings.__path__)}))

# Pieces that programs are made of, so that random texts get past the first letter.
PIECES = [
    *"%ONGMPLQHFXYZIJKRSTUW#[]()<>=;:/,.-+*&\0 \n",
    *"0123456789",
    *["O1", "N10", "M98", "M99", "M198", "M97", "M30", "P1", "P2", "P10002", "L3", "Q10", "H10"],
    *["G65", "G66", "G67", "G66.1", "G0", "G1", "G2", "G41", "G71", "G76", "G81", "X1.", "Z-2."],
    *["#1", "#100", "#[", "#0", "#3000=1", "#3006=1", "#5001", "=", "SIN[", "ATAN[1]/[2]", "MOD"],
    *["IF[", "GOTO10", "THEN", "WHILE[", "DO1", "END1", "ENDIF", "ELSE", " EQ ", " LT ", "GE"],
    *["POPEN", "DPRNT[X#1[53]]", "PCLOS", "SETVN1[A]", "[#_UI]", "加工", "\r", "\n", "\n", "\n"],
]
texts = st.lists(st.sampled_from(PIECES), max_size=80).map("".join)


def check(library: cncsub.Library, max_blocks: int = 300) -> None:
    run = library.run(max_blocks=max_blocks)
    assert isinstance(run.stop, cncsub.Stop)
    assert (run.alarm is not None) == (run.stop is cncsub.Stop.ALARM)
    assert len(run.steps) <= max_blocks
    assert len(run.steps.n) == len(run.steps)
    if run.alarm is not None:
        assert run.alarm.cause in cncsub.causes
        assert run.alarm.cause in str(run.alarm)
        assert run.alarm.line >= 0
    assert str(run.calls)
    assert run.steps._repr_html_()
    assert [record.step for record in run.steps] == list(range(len(run.steps)))
    _ = dict(run.variables), run.position, run.modal, run.moves.bounds


@given(st.binary(max_size=400), controls)
@example(b"", "fanuc-0i-f")
@example(b"\x80", "linuxcnc")
@example(b"\0" * 1000, "gsk-988ta")
@example(b"(", "mitsubishi-m700")
@example(b"O1\n" * 50, "hnc-21m")
def test_any_bytes_load_and_run(data: bytes, control: str) -> None:
    check(cncsub.loads(data, control=control))


@given(st.binary(max_size=200), st.sampled_from(ENCODINGS), controls)
@example(b"O1\nG\xff\\x", "utf-7", "fanuc-0i-f")
def test_any_bytes_load_in_any_encoding(data: bytes, encoding: str, control: str) -> None:
    check(cncsub.loads(data, control=control, encoding=encoding))


@given(texts, controls)
def test_any_text_of_the_language_loads_and_runs(text: str, control: str) -> None:
    check(cncsub.loads(text, control=control))


@given(texts, controls)
def test_any_text_runs_as_mdi(text: str, control: str) -> None:
    library = cncsub.loads("O1\nN10 M98 P2\nN20 M99\nO2\nN30 M99\n", control=control)
    assert isinstance(library.mdi(text, max_blocks=300).stop, cncsub.Stop)


@given(texts, controls)
def test_a_machine_steps_as_a_run_runs(text: str, control: str) -> None:
    library = cncsub.loads(text, control=control)
    run = library.run(max_blocks=200)
    machine = library.machine(max_blocks=200)
    assert [step.line for step in machine] == run.steps.line.tolist()
    assert machine.stop == run.stop
    assert str(machine.alarm) == str(run.alarm)


@given(texts, controls)
def test_a_run_can_be_repeated(text: str, control: str) -> None:
    library = cncsub.loads(text, control=control)
    first, second = (library.run(max_blocks=200) for _ in range(2))
    assert first.steps.line.tolist() == second.steps.line.tolist()
    assert dict(first.variables) == dict(second.variables)


@given(texts, controls, st.integers(0, 60))
def test_a_copy_of_a_machine_goes_on_like_the_machine(text: str, control: str, steps: int) -> None:
    machine = cncsub.loads(text, control=control).machine(max_blocks=200)
    for _ in range(steps):
        machine.step()
    copy = machine.copy()
    rest = [step.line for step in machine]
    assert [step.line for step in copy] == rest
    assert copy.stop == machine.stop


@given(texts, controls)
def test_programs_show_what_was_written(text: str, control: str) -> None:
    library = cncsub.loads(text, control=control)
    for program in [*library.values(), *library.duplicates]:
        for block in program.blocks:
            assert block.line >= program.line
            assert all(word.text for word in block.words)
            tokens = block.tokens
            assert "".join(token.text for token in tokens) == block.text
            assert all(one.end == other.column for one, other in itertools.pairwise(tokens))
            assert [token.word for token in tokens if token.kind == "word"] == list(block.words)
            start = tokens[0].column - 1 if tokens else 0
            line = text.splitlines()[block.line - 1] if text.isprintable() else ""
            assert not line or line[start:].startswith(block.text.split("\n")[0])
        assert program.name in repr(program)


@pytest.mark.parametrize("control", cncsub.controls)
@pytest.mark.parametrize(
    "text",
    [
        "O1\nN10 " + "X1 " * 300_000 + "\nN20 M30\n",
        "O1\n(" + "A" * 3_000_000,
        "O1\nN10 #1=" + "[" * 200_000,
        "O1\n" + "N10 #1=#1+1\n" * 100_000 + "M30\n",
        "\0" * 3_000_000,
        "O1\nM98 P1\n" * 10_000,
        "O1\nN10 #100=" + "9" * 200_000 + "\n",
    ],
    ids=["line", "comment", "brackets", "blocks", "zeros", "programs", "digits"],
)
def test_large_inputs_have_an_outcome(control: str, text: str) -> None:
    run = cncsub.loads(text, control=control).run(max_blocks=1000, trace="blocks")
    assert isinstance(run.stop, cncsub.Stop)
    assert len(str(run.alarm)) < 20_000
