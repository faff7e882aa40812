"""Calls are rewritten for another control, which then does what the first did, or are refused."""

from __future__ import annotations

import itertools
import json
import pickle
from collections import Counter
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub import TranslateError, translate
from cncsub.cli import app

SUB = "O2\nN30 G0 X1.\nN40 G0 X2.\nN50 M99\n"


def moves(run: cncsub.Run) -> list[tuple[str, float, float]]:
    return [(move.kind, move.x, move.z) for move in run.moves]


def texts(made: cncsub.Translation, program: str) -> list[str]:
    return [block.text for block in made.library[program].blocks]


@pytest.mark.parametrize(
    ("source", "call", "target", "rewritten"),
    [
        ("fanuc-0i-f", "M98 P30002", "mitsubishi-m700", "M98 P2 L3"),
        ("fanuc-0i-f", "M98P0030002(P9)", "haas-ngc", "M98 P2 L3 (P9)"),
        ("fanuc-0i-f", "M98 P2 L3", "gsk-980mdi", "M98 P30002"),
        ("mitsubishi-m700", "M98 P2 L3", "gsk-980mdi", "M98 P30002"),
        ("mitsubishi-m700", "M98 L3 P2", "fanuc-0i-f", "M98 L3 P2"),
        ("fanuc-0i-f", "M98 P2 L0", "mitsubishi-m700", "M98 P2"),
        ("mitsubishi-m700", "M98 P2 L0", "fanuc-0i-f", ""),
        ("mitsubishi-m700", "G0 X7. M98 P2 L0", "fanuc-0i-f", "G0 X7."),
    ],
)
def test_the_count_is_written_as_the_control_takes_it(
    source: str, call: str, target: str, rewritten: str
) -> None:
    library = cncsub.loads(f"O1\nN10 {call}\nN20 M30\n{SUB}", control=source)
    made = translate(library, target)
    assert texts(made, "O1")[0].strip() == f"N10 {rewritten}".strip()
    assert moves(made.library.run()) == moves(library.run())
    assert made.unproved == ()
    assert made.added == {}


@pytest.mark.parametrize(
    ("call", "rewritten"),
    [
        ("M98 P 2 L 3", "M98 P30002"),
        ("M 98 P2 (P9) L3", "M 98 P30002 (P9)"),
        ("/2 M98 P2 L3", "/2 M98 P30002"),
        ("M98(M98 P5)P2L3", "M98 P30002 (M98 P5)"),
    ],
)
def test_words_are_found_where_they_stand_whatever_stands_between_them(
    call: str, rewritten: str
) -> None:
    library = cncsub.loads(f"O1\n{call}\nN20 M30\nO2\nM99\n", control="fanuc-0i-f")
    made = translate(library, "gsk-980tdi")
    assert " ".join(texts(made, "O1")[0].split()) == rewritten


def test_a_call_under_a_condition_keeps_it() -> None:
    library = cncsub.loads(f"O1\nIF[#1 EQ 2] THEN M98 P2 L3\nM30\n{SUB}", control="haas-ngc")
    words = [word.text for word in library["O1"].blocks[0].words]
    assert words == ["IF[#1EQ2]THEN", "M98", "P2", "L3"]


def test_more_passes_than_one_call_takes_are_several_calls() -> None:
    text = f"O1\nN10 G0 X5. M98 P2000002\nN20 M30\n{SUB}"
    library = cncsub.loads(text, control="fanuc-0i-f")
    made = translate(library, "haas-ngc")
    assert texts(made, "O1")[1:3] == ["M98 P2 L99", "M98 P2 L2"]
    assert moves(made.library.run()) == moves(library.run())


def test_the_start_block_is_named_by_the_word_of_the_control() -> None:
    text = f"O1\nN10 M98 P2 H40 L2\nN20 M30\n{SUB}"
    library = cncsub.loads(text, control="mitsubishi-m800")
    lathe = {"machine": "lathe-a"}
    made = translate(library, "gsk-988ta", setup=lathe)
    assert texts(made, "O1")[0] == "N10 M98 P2 L2 Q40"
    (edit,) = made.edits["O1"]
    assert edit == ("<text>", 2, 5, "M98 P2 H40 L2", "M98 P2 L2 Q40")
    back = translate(made.library, "mitsubishi-m800", setup=lathe)
    assert texts(back, "O1")[0] == "N10 M98 P2 L2 H40"


def test_where_no_word_names_it_the_blocks_become_a_program() -> None:
    library = cncsub.loads(f"O1\nN10 M98 P2 H40 L2\nN20 M30\n{SUB}", control="mitsubishi-m800")
    made = translate(library, "fanuc-0i-f")
    assert texts(made, "O1")[0] == "N10 M98 P9001 L2"
    assert made.added == {"O9001": "O9001\nN40 G0 X2.\nN50 M99\n"}


HAAS = (
    "%\nO1\nN10 M97 P100 L2\nN20 M97 P100\nN30 G0 X9.\nN40 M30\nN100 G0 X1.\nN110 G0 X2.\nM99\n%\n"
)


def test_m97_becomes_a_program_of_its_own() -> None:
    library = cncsub.loads(HAAS, control="haas-ngc")
    made = translate(library, "fanuc-0i-f")
    assert texts(made, "O1")[:2] == ["N10 M98 P9001 L2", "N20 M98 P9001"]
    assert made.added == {"O9001": "O9001\nN100 G0 X1.\nN110 G0 X2.\nM99\n"}
    assert made.texts["<text>"].endswith("M99\nO9001\nN100 G0 X1.\nN110 G0 X2.\nM99\n%\n")
    assert "+N10 M98 P9001 L2\n" in made.diff()
    assert moves(made.library.run()) == moves(library.run())


def test_p_that_names_a_block_becomes_a_program_of_its_own() -> None:
    text = "%100\nN10 M98 P0100 L2\nN20 M30\nN100 G0 X1.\nN110 M99\n"
    library = cncsub.loads(text, control="gsk-928te")
    made = translate(library, "hnc-21m", setup={"machine": "lathe-a"})
    assert made.library.main is not None
    assert made.library.main.blocks[0].text == "N10 M98 P9001 L2"
    assert list(made.added) == ["O9001"]


def test_a_program_without_a_head_calls_as_the_other_control_does() -> None:
    """LinuxCNC's main program holds the blocks of those after it; each block is rewritten once."""
    library = cncsub.loads(f"N10 M98 P2 L3\nN20 M30\n{SUB}", control="linuxcnc")
    made = translate(library, "gsk-980mdi")
    assert made.texts["<text>"].startswith("N10 M98 P30002\nN20 M30\nO2\n")


def test_calls_in_what_is_copied_are_rewritten_there_too() -> None:
    text = f"O1\nN10 M97 P100\nN40 M30\nN100 M98 P2 L2\nN110 M99\n{SUB}"
    made = translate(cncsub.loads(text, control="haas-ngc"), "gsk-980mdi")
    assert texts(made, "O9001") == ["N100 M98 P20002", "N110 M99"]


def test_lines_end_with_a_line_feed(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_bytes(HAAS.replace("\n", "\r\n").replace("O1", "O1 (\u5b54)").encode("gbk"))
    made = translate(file, "fanuc-0i-f", control="haas-ngc")
    (written,) = made.write(tmp_path / "new")
    text = Path(written).read_bytes().decode()
    assert "O1 (\u5b54)\nN10 M98 P9001 L2\n" in text
    assert "\r" not in text


RETURNS = "O1\nN10 M98 P2 L3\nN20 G0 X9.\nN70 G0 X3.\nN80 M30\nO2\nN30 G0 X1.\nN40 M99 P70\n"


@pytest.mark.parametrize(
    ("source", "target", "call"),
    [
        # At once: the first M99 P ends the passes. At the last pass: all passes are made before.
        ("fanuc-0i-f", "mitsubishi-m700", "N10 M98 P2"),
        ("mitsubishi-m700", "fanuc-0i-f", "N10 M98 P2 L3"),
        ("fanuc-0i-f", "haas-ngc", "N10 M98 P2"),
    ],
)
def test_m99_p_becomes_m99_and_a_jump_behind_the_call(source: str, target: str, call: str) -> None:
    library = cncsub.loads(RETURNS, control=source)
    made = translate(library, target)
    assert texts(made, "O1")[:2] == [call, "GOTO 70"]
    assert texts(made, "O2")[-1].strip() == "N40 M99"
    assert moves(made.library.run()) == moves(library.run())


def test_a_call_that_is_skipped_takes_its_jump_along() -> None:
    library = cncsub.loads(RETURNS.replace("N10", "/2 N10"), control="fanuc-0i-f")
    made = translate(library, "haas-ngc")
    assert texts(made, "O1")[1] == "/2GOTO 70"
    for switches in ((), (2,)):
        runs = [each.run(block_skip=switches) for each in (library, made.library)]
        assert moves(runs[0]) == moves(runs[1])


def test_m99_p_of_one_pass_stays() -> None:
    library = cncsub.loads(RETURNS.replace(" L3", ""), control="fanuc-0i-f")
    assert translate(library, "mitsubishi-m700").edits == {}


def test_m99_p_of_a_main_program_is_a_jump() -> None:
    text = "O1\nN10 G0 X1.\nN20 M99 P40\nN30 G0 X2.\nN40 M30\n"
    library = cncsub.loads(text, control="fanuc-0i-f")
    assert translate(library, "haas-ngc").edits == {}
    with pytest.raises(
        TranslateError, match=r"^O1 N20, line 3: the other control has no words to jump"
    ):
        translate(library, "linuxcnc")


def test_m99_l_is_left_out_where_the_first_control_does_not_look_at_it() -> None:
    text = "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.\nN40 M99 L5\n"
    made = translate(cncsub.loads(text, control="fanuc-16i"), "fanuc-30i")
    assert texts(made, "O2")[-1].strip() == "N40 M99"
    with pytest.raises(TranslateError, match="O2 N40, line 6: M99 L counts passes"):
        translate(cncsub.loads(text, control="fanuc-30i"), "fanuc-16i", max_blocks=100)


def test_the_head_of_a_main_program_goes_where_the_control_takes_none() -> None:
    library = cncsub.loads(f"O1 (PART)\nN10 M98 P20002\nN20 M30\n{SUB}", control="fanuc-0i-f")
    made = translate(library, "linuxcnc")
    assert made.texts["<text>"].startswith("(PART)\nN10 M98 P2 L2\n")


# ---- programs that are refused ----


@pytest.mark.parametrize(
    ("text", "source", "target", "reason", "line"),
    [
        (f"O1\nN10 M98 P2 L3000\nM30\n{SUB}", "fanuc-0i-f", "haas-ngc", "O2, 3000 passes", 2),
        (
            f"O1\nN10 G4 P10 M98 P20002\nM30\n{SUB}",
            "fanuc-0i-f",
            "haas-ngc",
            "is in the block twice",
            2,
        ),
        (f"O1\nN10 M98 P2\nM30\n{SUB}", "fanuc-0i-f", "gsk-928te", "O2, 1 pass, as M98 does", 2),
        (
            "O1\nN10 M98 P2\nN70 M30\nO2\nN20 IF[#1EQ1]GOTO 40\nN30 M99 P70\nN40 M99\n",
            "fanuc-0i-f",
            "haas-ngc",
            "one of several ways back",
            6,
        ),
        (
            "O1\nN10 M98 P2\nN70 M30\nO2\nN30 M99 P#1\n",
            "fanuc-0i-f",
            "haas-ngc",
            "computed cannot be told apart",
            5,
        ),
        (
            RETURNS.replace("M98 P2 L3", "G65 P2 L3"),
            "fanuc-0i-f",
            "haas-ngc",
            "that a macro calls",
            8,
        ),
        (RETURNS, "fanuc-0i-f", "linuxcnc", "the other control has no words to go on at N70", 2),
        (
            "O1\nN5 G0 X1.\nN10 M97 P20\nN15 M30\nN20 #1=#1+1\nN30 IF[#1LT3]GOTO 5\nN40 M99\n",
            "haas-ngc",
            "fanuc-0i-f",
            "jumps to before N20",
            6,
        ),
        ("O1\nN10 M97 P50\nN20 M30\n", "haas-ngc", "fanuc-0i-f", "O1 has no N50", 2),
    ],
)
def test_what_cannot_be_said_is_refused_with_its_block(
    text: str, source: str, target: str, reason: str, line: int
) -> None:
    with pytest.raises(TranslateError, match=reason) as caught:
        translate(cncsub.loads(text, control=source), target)
    assert caught.value.line == line
    assert pickle.loads(pickle.dumps(caught.value)).args == caught.value.args


def test_what_the_words_do_not_make_is_found_by_running() -> None:
    """A code that the other control reads otherwise is no word of a call."""
    library = cncsub.loads(
        "O1\nN10 G91 G0 X1.\nN20 G82 Z-1. R0 P1000 F100.\nM30\n", control="fanuc-0i-f"
    )
    with pytest.raises(
        TranslateError, match=r"O1 N\d0, line \d: rewritten, it does not do the same"
    ) as caught:
        translate(library, "gsk-980tdi")
    assert "gsk-980tdi" in caught.value.reason


def test_a_dwell_of_another_length_is_found() -> None:
    library = cncsub.loads("O1\nN10 G4 P1500.\nM30\n", control="mitsubishi-m700")
    with pytest.raises(TranslateError, match="O1 N10, line 2"):
        translate(library, "haas-ngc")


def test_programs_of_the_external_device_are_not_rewritten(tmp_path: Path) -> None:
    for name, text in (
        ("job/O1.nc", "O1\nN10 M98 P20002\nN20 M198 P7\nM30\n"),
        ("job/sub/O2.nc", SUB),
        ("ext/O0007", "O7\nN80 M98 P2\nM99\n"),
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    def library() -> cncsub.Library:
        job, device = tmp_path / "job", tmp_path / "ext"
        return cncsub.load(job, control="fanuc-0i-f", external=device)

    made = translate(library(), "mitsubishi-m700")
    assert [Path(p).relative_to(tmp_path) for p in made.write(tmp_path / "new")] == [
        Path("new/O1.nc"),
        Path("new/sub/O2.nc"),
    ]
    (tmp_path / "ext/O0007").write_text("O7\nN80 M98 P20002\nM99\n")
    with pytest.raises(TranslateError, match="N80, line 2: a program of the external device"):
        translate(library(), "mitsubishi-m700")


def test_what_does_not_end_proves_nothing() -> None:
    text = "O1\nN10 M98 P2\nM30\nO2\nN20 #3000=1(NO)\nM99\n"
    with pytest.raises(TranslateError, match="O2 N20, line 5: fanuc-0i-f does not run to its end"):
        translate(cncsub.loads(text, control="fanuc-0i-f"), "haas-ngc")
    endless = cncsub.loads("O1\nN10 GOTO 10\n", control="fanuc-0i-f")
    with pytest.raises(TranslateError, match="O1 N10, line 2: .* the translation cannot be proved"):
        translate(endless, "haas-ngc", max_blocks=50)


def test_what_is_computed_is_told() -> None:
    text = f"O1\nN10 #1=2\nN20 M98 P#1\nN30 M30\n{SUB}"
    made = translate(cncsub.loads(text, control="fanuc-0i-f"), "mitsubishi-m700")
    assert made.unproved == ("O1, line 3",)
    assert translate(cncsub.loads(text, control="fanuc-0i-f"), "fanuc-0i-d").unproved == ()


def test_wrong_use_is_told() -> None:
    library = cncsub.loads(f"O1\nM30\n{SUB}", control="fanuc-0i-f")
    with pytest.raises(TypeError, match="leave out trace"):
        translate(library, "haas-ngc", trace="blocks")
    with pytest.raises(TypeError, match="give control="):
        translate("part.nc", "haas-ngc")
    with pytest.raises(ValueError, match="there is no control 'nosuch'"):
        translate(library, "nosuch")


# ---- all pairs ----

PROGRAMS = {
    "a call": f"O1\nN10 M98 P2\nN20 M30\n{SUB}",
    "a count in P": f"O1\nN10 M98 P30002\nN20 M30\n{SUB}",
    "a count in L": f"O1\nN10 M98 P2 L3\nN20 M30\n{SUB}",
    "no pass": f"O1\nN10 M98 P2 L0\nN20 M30\n{SUB}",
    "two levels": "O1\nN10 M98 P3\nN20 M30\nO3\nN60 M98 P2\nN70 M98 P2\nN80 M99\n" + SUB,
    "M99 P": RETURNS,
    "M97": HAAS,
    "H": f"O1\nN10 M98 P2 H40\nN20 M30\n{SUB}",
    "Q": f"O1\nN10 M98 P2 Q40\nN20 M30\n{SUB}",
}


def outcome(library: cncsub.Library, target: str, machine: str) -> cncsub.Translation | str:
    """Return the translation, or why there is none."""
    try:
        return translate(library, target, setup={"machine": machine})
    except TranslateError as error:
        known = error.program is not None or "reads the programs otherwise" in error.reason
        return "refused" if error.reason and known else f"no place: {error}"
    except ValueError as error:  # a control that cannot be a lathe
        return "no such machine" if machine in str(error) else str(error)


def machine_of(*names: str) -> str:
    """Return the lathe if one of the controls is one, else a mill."""
    own = [r.value for name in names for r in cncsub.controls[name].rules if r.name == "machine"]
    return next((str(machine) for machine in own if machine != "mill"), "mill")


def test_every_pair_of_controls_is_translated_or_refused_with_a_reason() -> None:
    """Each pair is tried with two of the programs, and each program with many pairs."""
    told: Counter[str] = Counter()
    names = list(PROGRAMS)
    for place, (source, target) in enumerate(itertools.product(cncsub.controls, repeat=2)):
        for claim in (names[place % len(names)], names[(place + 4) % len(names)]):
            library = cncsub.loads(PROGRAMS[claim], control=source)
            machine = machine_of(source, target)
            made = outcome(library, target, machine)
            if isinstance(made, str):
                assert made in ("refused", "no such machine"), (claim, source, target)
                told[made] += 1
                continue
            told[f"{claim}: proved"] += 1
            runs = [each.run(setup={"machine": machine}) for each in (library, made.library)]
            assert moves(runs[0]) == moves(runs[1]), (claim, source, target)
            assert runs[0].stop == runs[1].stop
    proved = {claim: told[f"{claim}: proved"] for claim in names}
    assert min(proved.values()) >= 10, told
    assert sum(proved.values()) >= 300, told


# ---- the command ----


def test_the_command_prints_the_changes_or_writes_the_files(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text(HAAS)
    said = ["compare", str(file), "-c", "haas-ngc", "-c", "fanuc-0i-f", "--translate"]
    runner = CliRunner()
    shown = runner.invoke(app, said)
    assert shown.exit_code == 0, shown.output
    assert "-N10 M97 P100 L2\n" in shown.stdout
    assert "2 blocks rewritten, 1 programs added: the same, as both ran" in shown.stderr
    facts = json.loads(runner.invoke(app, [*said, "--format", "json"]).stdout)
    assert facts["control"] == "fanuc-0i-f"
    assert [edit["new"] for edit in facts["edits"]["O1"]] == ["M98 P9001 L2", "M98 P9001"]
    written = runner.invoke(app, [*said, "-o", str(tmp_path / "new")])
    assert written.exit_code == 0, written.output
    made = cncsub.load(tmp_path / "new", control="fanuc-0i-f")
    assert moves(made.run("O1")) == moves(cncsub.load(file, control="haas-ngc").run())
    again = runner.invoke(app, [*said, "-o", str(tmp_path)])
    assert again.exit_code == 2
    assert "was read: give another folder" in again.stderr
    refused = runner.invoke(app, [*said[:5], "gsk-928te", "--translate"])
    assert refused.exit_code == 2
