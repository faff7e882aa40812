"""A flat program does what the program does, or is refused with the reason."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.testing.outcome import load
from conformance import rows

CASES = {
    "calls and repeats": (
        "O1\nN10 G90 G0\nN20 M98 P2 L2\nM30\nO2\nG91 X1.\nM99\n",
        "O1\nG90 G0\nG91 X1.\nG91 X1.\nM30\n",
    ),
    "a loop, and a variable that it counts": (
        "O1\n#100=1\nWHILE[#100 LE 2]DO1\nG0 X#100\n#100=#100+1\nEND1\nM30\n",
        "O1\nG0 X1.\nG0 X2.\nM30\n",
    ),
    "a skipped block is not written": (
        "O1\n/G0 X1.\n/2 G0 Y1.\nM30\n",
        "O1\nG0 Y1.\nM30\n",
    ),
    "arguments of a macro": (
        "O1\nG65 P2 A7.\nM30\nO2\nG0 X-#1\nM99\n",
        "O1\nG0 X-7.\nM30\n",
    ),
    "an expression": (
        "O1\n#1=2\nG65 P2 A3.\nM30\nO2\nG0 X[#1*SIN[30]+1] Y-[#1]\nG4 P[#1*100]\nM99\n",
        "O1\nG0 X2.5 Y-3.\nG4 P300\nM30\n",
    ),
    "a computed end is rounded to the increment": (
        "O1\n#1=10/3\nG0 X#1\nX[#1*2]\nM30\n",
        "O1\nG0 X3.333\nX6.667\nM30\n",
    ),
    "a modal macro behind each move": (
        "O1\nG66 P2\nG0 X1.\nG67\nM30\nO2\nM8\nM99\n",
        "O1\nG0 X1.\nM8\nM30\n",
    ),
    "a main program that starts over": ("O1\nG0 X1.\nM99\n", "O1\nG0 X1.\nM99\n"),
}
REFUSED = {
    "O1\nG0 X[#5041+1]\nM30\n": "is an expression",
    "O1\n#1=100\nG0 X#[#1+1]\nM30\n": "is an expression",
    "O1\n#5221=5\nM30\n": "a variable of the control",
    "O1\n#3000=1(OFF)\nM30\n": "ends by an alarm",
    "O1\nN10 GOTO 10\nM30\n": "does not end",
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_written(name: str) -> None:
    text, expected = CASES[name]
    flat = cncsub.flatten(cncsub.loads(text, control="fanuc-0i-f"), block_skip=1)
    flat.verify()
    assert flat.text == expected
    assert len(flat.origins) == expected.count("\n") - 1


@pytest.mark.parametrize("text", REFUSED)
def test_what_is_refused(text: str) -> None:
    library = cncsub.loads(text, control="fanuc-0i-f")
    with pytest.raises(cncsub.FlattenError, match=REFUSED[text]) as caught:
        cncsub.flatten(library, max_blocks=50)
    assert pickle.loads(pickle.dumps(caught.value)).args == caught.value.args


def test_for_another_control() -> None:
    library = cncsub.loads(CASES["an expression"][0], control="fanuc-0i-f")
    flat = cncsub.flatten(library, control="mitsubishi-m700")
    assert flat.text == CASES["an expression"][1]


def test_the_command(tmp_path: Path) -> None:
    text, expected = CASES["calls and repeats"]
    program, out = tmp_path / "p.nc", tmp_path / "flat.nc"
    program.write_text(text)
    done = CliRunner().invoke(app, ["flatten", str(program), "-c", "fanuc-0i-f", "-o", str(out)])
    assert done.exit_code == 0, done.output
    assert out.read_text() == expected
    program.write_text("O1\n#5221=5\nM30\n")
    done = CliRunner().invoke(app, ["flatten", str(program), "-c", "fanuc-0i-f"])
    assert done.exit_code == 2


def test_origins_name_block_call_and_pass() -> None:
    library = cncsub.loads(CASES["calls and repeats"][0], control="fanuc-0i-f")
    flat = cncsub.flatten(library, comments=True)
    assert flat.origins["program"].tolist() == ["O1", "O2", "O2", "O1"]
    assert flat.origins["call"].tolist() == [-1, 0, 0, -1]
    assert "(O1 N10 LINE 2)" in flat.text


def test_every_row_that_ends_is_flattened_or_refused() -> None:
    """`flatten` itself runs and compares; anything else than a refusal is a defect."""
    known = (
        "would not run alike",
        "expression",
        "of the control",
        "vacant",
        "not clear which",
        "call that has ended",
    )
    done = 0
    reasons: list[str] = []
    for row in rows()[::10]:
        if row.case.mdi is not None:
            continue
        try:
            library = load(row.case, cncsub.controls[row.control])
            if library.run(max_blocks=300).stop != cncsub.Stop.END:
                continue
        except (ValueError, KeyError):
            continue
        try:
            cncsub.flatten(library, max_blocks=300)
            done += 1
        except cncsub.FlattenError as error:
            reasons.append(error.reason)
    strange = [reason for reason in reasons if not any(text in reason for text in known)]
    assert not strange
    assert done > 5 * len(reasons), (done, len(reasons))


def test_verify_runs_both_again() -> None:
    text = "O1\nG90 G0\nM98 P2 L2\nM30\nO2\nG91 X5.\nG90\nM99\n"
    flat = cncsub.flatten(cncsub.loads(text, control="fanuc-0i-f"))
    flat.verify()
    flat.text = flat.text.replace("X5.", "X6.", 1)
    with pytest.raises(AssertionError, match="x = 6"):
        flat.verify()
