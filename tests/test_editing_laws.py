"""Laws of edits, over the rows of the conformance tables, the examples and generated programs."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from makers import CONTROLS

import cncsub
from cncsub import testing
from cncsub.editing import EditError, Edits, Mention, format, mentions, rename, renumber
from cncsub.editing.mentions import mentions_in_line, mentions_of, thing
from conformance import rows

EXAMPLES = Path(__file__).parent.parent / "examples"
EVERY = 29  # rows of which one is looked at; all of them differ in no more than what is named below

# Programs that read the number of the block that ran last: another number is another program.
READS_NUMBERS = ("#4014", "#4114", "#4107", "#4214", "#4314")

EDITS: dict[str, Callable[[cncsub.Library, str], Edits]] = {
    "format": lambda library, _: format(library),
    "format without blanks": lambda library, _: format(library, spacing="none", points=True),
    "numbered": lambda library, machine: renumber(library, machine=machine),
    "all": lambda library, machine: renumber(library, which="all", machine=machine),
    "targets": lambda library, machine: renumber(library, which="targets", machine=machine),
}


def libraries() -> Iterator[tuple[str, cncsub.Library, dict[str, object]]]:
    for row in rows()[3::EVERY]:
        library = testing.outcome.load(row.case, cncsub.controls[row.control])
        setup = row.case.setup
        yield str(row), library, {"max_blocks": 20_000, **({"setup": setup} if setup else {})}


@pytest.mark.parametrize("what", EDITS)
def test_an_edited_row_does_the_same_and_is_not_edited_again(what: str) -> None:
    done = refused = 0
    for name, library, options in libraries():
        setup = options.get("setup") or {}
        machine = str(setup.get("machine", ""))  # type: ignore[attr-defined]
        try:
            made = EDITS[what](library, machine)
        except EditError:
            refused += 1
            continue
        text = "".join(program.text for program in library.values())
        if any(word in text for word in READS_NUMBERS):
            continue
        made.prove(**options)  # type: ignore[arg-type]
        assert EDITS[what](made.after, machine).empty, name
        words = [_words(each) for each in (library, made.after)]
        if what.startswith("format"):
            assert words[0] == words[1], name
        done += 1
    assert done > 650
    assert refused < 30


NEW = {"number": "7777", "label": "NEWLABEL", "program": "8765", "variable": "NEWNAME"}
NEW_VARIABLE = {"local": 21, "common": 147, "kept": 577}


def new_for(library: cncsub.Library, mention: Mention) -> str | int:
    """Return a number or a name of the same kind that no row has."""
    if mention.kind == "variable" and mention.number is not None:
        known = NEW_VARIABLE.get(library.code.variable_kind(mention.number), 5)
        return 77 if library.code.variable_sign == "R" else known
    if mention.kind == "program" and mention.number is not None:
        return 123 if library.control.name == "gsk-928te" else 8765
    if mention.kind == "program":
        return "9876" if mention.name.isdecimal() else "NEWPROG"
    if mention.kind == "label" and mention.name.isdecimal():
        return "654"
    return NEW[mention.kind]


def test_a_renamed_thing_of_a_row_is_the_same_thing() -> None:
    done: dict[str, int] = {}
    for name, library, options in islice(libraries(), 0, None, 3):
        text = "".join(program.text for program in library.values())
        if any(word in text for word in READS_NUMBERS):
            continue
        machine = str((options.get("setup") or {}).get("machine", ""))  # type: ignore[attr-defined]
        seen = set()
        for mention in mentions(library, machine=machine):
            if mention.computed or thing(mention) in seen or len(seen) > 5:
                continue
            seen.add(thing(mention))
            try:
                made = rename(library, mention, new_for(library, mention), machine=machine)
            except EditError:
                continue
            try:
                made.prove(**options)  # type: ignore[arg-type]
            except EditError as error:
                raise AssertionError(f"{name}: {mention.shown}\n{made.diff()}") from error
            done[mention.kind] = done.get(mention.kind, 0) + 1
    assert done["number"] > 500
    assert done["program"] > 200
    assert done["variable"] > 40


def _words(library: cncsub.Library) -> list[object]:
    """Return the words of all blocks but for their blanks, points and small letters."""
    return [
        [(word.address.upper(), word.value) for word in block.words]
        for program in library.values()
        for block in program.blocks
    ]


@pytest.mark.parametrize("maker", CONTROLS)
@pytest.mark.parametrize("what", EDITS)
def test_an_edited_example_does_the_same(maker: str, what: str) -> None:
    files = [
        file
        for file in sorted((EXAMPLES / maker).rglob("*"))
        if file.suffix.lower() in (".nc", ".cnc", ".ngc", ".mpf", ".spf", ".min")
    ]
    assert files
    for file in files:
        library = cncsub.load(file, control=CONTROLS[maker])
        try:
            made = EDITS[what](library, "")
        except EditError:
            continue
        made.prove(max_blocks=20_000)
        assert EDITS[what](made.after, "").empty, file


BLANK = st.sampled_from(["", " ", "  ", "\t"])
WORDS = st.sampled_from(
    ["G0", "g1", "X10.", "y-5", "F100", "M8", "(note)", "G 4", "P#1", "Z[#2+1.]"]
)


@st.composite
def programs(draw: st.DrawFn) -> str:
    """Return a program with jumps to blocks of any numbers, among them none and the same twice."""
    lines = ["O1"]
    numbers = draw(st.lists(st.integers(1, 12), min_size=1, max_size=8))
    for n in numbers:
        blank = draw(BLANK)
        body = blank.join(draw(st.lists(WORDS, max_size=4)))
        target = draw(st.integers(1, 12))
        jump = draw(
            st.sampled_from(["", f"IF[#1EQ{target}]GOTO{target}", f"#1=#1+{target}", "M98P2"])
        )
        lines += [f"{draw(BLANK)}N{n}{blank}{body}", jump] if draw(st.booleans()) else [body, jump]
    lines += ["M30", "O2", "N7 #2=#2+1", f"M99{draw(st.sampled_from(['', 'P3', 'P30']))}"]
    return "\n".join(lines) + "\n"


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(text=programs(), control=st.sampled_from(["fanuc-0i-f", "haas-ngc", "gsk-988ta"]))
def test_a_generated_program_does_the_same(text: str, control: str) -> None:
    library = cncsub.loads(text, control=control)
    for edits_of in EDITS.values():
        try:
            made = edits_of(library, "")
        except EditError:
            continue
        made.prove(max_blocks=2_000)
        assert edits_of(made.after, "").empty
        assert made.texts.keys() <= {"<text>"}
        assert len(made.after.code.sources[0][2].split(b"\n")) == len(text.split("\n"))


SINUMERIK_WORDS = st.sampled_from(
    ["g0", "G1", "X10", "y=r1", "f100", "M8", 'msg("a  b")', "Z=(R2+1)", "R2=R1*2", "LAB"]
)
LINUXCNC_WORDS = st.sampled_from(
    ["g0", "G1", "x10", "y[#1 + 1]", "f100", "m8", "(msg,a  B)", "#2=[#1*2]", "(debug, #1  x)"]
)
SYNTEC_WORDS = st.sampled_from(["g0", "G1", "x10.", "Y#1", "f100", "M8", "(note)", "#2 := #1*2;"])


@st.composite
def other_programs(draw: st.DrawFn) -> tuple[str, str]:
    """Return a program of another language than those above, with its jumps, and the control."""
    control = draw(st.sampled_from(["siemens-one", "siemens-840d-sl", "linuxcnc", "syntec-22ma"]))
    words, jump, end = {
        "s": (SINUMERIK_WORDS, ["R1=R1+1", "if r1<3 gotob {}", "IF R1==2 GOTOF {}", ""], "M30"),
        "l": (LINUXCNC_WORDS, ["#1=[#1+1]", "o1 if [#1 gt 2]\no1 endif", ""], "m2"),
        "y": (SYNTEC_WORDS, ["#1:=#1+1;", "IF #1<3 THEN GOTO {}; END_IF;", ""], "M30"),
    }["y" if control.startswith("syn") else control[0]]
    signs = ["N", ":", "n"] if control.startswith("siemens") else ["N"]
    lines = []
    for n in draw(st.lists(st.integers(1, 12), min_size=1, max_size=8)):
        body = draw(st.sampled_from([" ", "  "])).join(draw(st.lists(words, max_size=3)))
        number = f"{draw(st.sampled_from(signs))}{n} " if draw(st.booleans()) else ""
        lines += [number + body, draw(st.sampled_from(jump)).format(draw(st.integers(1, 12)))]
    return "\n".join([*lines, end]) + "\n", control


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(other_programs())
def test_a_generated_program_of_another_language_does_the_same(of: tuple[str, str]) -> None:
    text, control = of
    library = cncsub.loads(text, control=control)
    for edits_of in EDITS.values():
        try:
            made = edits_of(library, "")
        except EditError:
            continue
        made.prove(max_blocks=500)
        assert edits_of(made.after, "").empty


def test_a_long_program_is_edited_at_once() -> None:
    blocks = 100_000
    body = "".join(f"N{n} G1 X{n % 97}. Y{n % 89}. (cut)\n" for n in range(1, blocks))
    library = cncsub.loads(f"O1\nF100\n{body}N{blocks} M30\n", control="fanuc-0i-f")
    for edits_of in (
        lambda: renumber(library, start=1, step=2),
        lambda: renumber(library, which="all", step=1),
        lambda: format(library, spacing="none"),
    ):
        began = time.perf_counter()
        made = edits_of()
        assert len(made.texts["<text>"]) > blocks
        assert time.perf_counter() - began < 12  # a second or two where nothing else runs


def test_mentions_that_are_asked_for_are_those_of_all() -> None:
    """Those of a line and of a thing are found without the others; they are the same."""
    for _, library, _ in libraries():
        every = mentions(library)
        lines: dict[tuple[str, int], list[Mention]] = {}
        things: dict[tuple[object, ...], list[Mention]] = {}
        for m in every:
            lines.setdefault((m.file, m.line), []).append(m)
            key = named(m)
            if key is not None:
                things.setdefault(key, []).append(m)
        for (file, line), found in list(lines.items())[:20]:
            assert mentions_in_line(library, file, line) == found
        for (kind, program, block, variable), found in list(things.items())[:20]:
            assert mentions_of(library, kind, program, block, variable) == found


def named(m: Mention) -> tuple[Any, ...] | None:
    """Return what a mention names, as `mentions_of` is asked for it."""
    if m.computed:
        return None
    if m.kind == "variable":
        called = m.name.upper() if m.number is None else m.number
        return ("variable", m.to_program, None, called)
    if m.to_program is None:
        return None
    if m.kind == "program":
        return ("program", m.to_program, None, "")
    return None if m.to_block is None else ("block", m.to_program, m.to_block, "")
