"""Several threads read texts that are cut anywhere, with the result that one thread makes."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import cncsub
from cncsub import _core
from cncsub.library import Library
from conformance import rows

CONTROL = "fanuc-0i-f"
File = tuple[str, str, str]  # name, stem, text


def read(control: str, files: list[File], threads: int, piece: int | None = None) -> Library:
    rows = [(name, stem, [text], False) for name, stem, text in files]
    core = cncsub.controls[control]
    code = _core.compile(core, rows, threads=threads, piece=piece)
    return Library(code, [name for name, _, _ in files], [])


def programs_of(library: Library) -> list[Any]:
    """Return every program, also those that another one hides, with all that its blocks say."""
    code = library.code
    found: list[Any] = [code.leaders]
    for place in range(len(code)):
        program = code.program(place)
        blocks = [(program.block(i), program.tokens(i)) for i in range(program.blocks)]
        found.append(
            (program.name, program.file, program.line, program.text, program.comment,
             program.duplicate_of, blocks)
        )  # fmt: skip
    return found


def meaning_of(library: Library) -> list[Any]:
    """Return what the blocks refer to, and what a run of each program does."""
    found: list[Any] = []
    for name, program in library.items():
        found += [(b.calls, b.jumps, b.reads, b.writes) for b in program.blocks]
        run = library.run(name, max_blocks=300, max_cycles=2)
        found += [run.stop, str(run.alarm), list(run.steps), list(run.calls), run.messages]
        found += [run.m_codes, run.dropped, repr(dict(run.variables))]
        found += [[repr(move) for move in run.moves]]
    return found


def check(control: str, files: list[File], piece: int, *, deep: bool = True) -> None:
    alone = read(control, files, 1)
    shared = read(control, files, 3, piece)
    assert programs_of(shared) == programs_of(alone)
    if deep:
        assert meaning_of(shared) == meaning_of(alone)


def texts_of_rows() -> dict[str, list[str]]:
    """Return, by control, the programs of the rows."""
    texts: defaultdict[str, list[str]] = defaultdict(list)
    for row in rows():
        given = [row.case.program, *(row.case.files or {}).values()]
        texts[row.control] += [text for text in given if isinstance(text, str)]
    return texts


TEXTS = texts_of_rows()


@pytest.mark.parametrize("end", ["\n\r\r", "\r\n", "\r", "\n\r", "\r\r\n", "\n\n\r\r"])
def test_lines_end_the_same_wherever_a_text_is_cut(end: str) -> None:
    text = end.join(["%", *(f"O{i}\nN10 X{i}.\rN20 M99" for i in range(1, 40)), "%"])
    for piece in (17, 18, 19, 50):
        check(CONTROL, [("part.nc", "part", text)], piece, deep=False)


@pytest.mark.parametrize("control", sorted(TEXTS))
def test_the_programs_of_all_rows_are_the_same_however_they_are_read(control: str) -> None:
    texts = list(dict.fromkeys(TEXTS[control]))
    check(control, [(f"{i}.nc", str(i), text) for i, text in enumerate(texts)], 100, deep=False)
    check(control, [("all.nc", "all", "\n".join(texts))], 97, deep=False)
    some = texts[::11][:40]
    check(control, [(f"{i}.nc", str(i), text) for i, text in enumerate(some)], 60)
    check(control, [("all.nc", "all", "\n".join(some))], 61)


LINES = st.sampled_from(
    """O1|O2 (PART)|:3|%|%9|<SUB>|N10 G1 X1. F100|N20 Y2|X[#1+1.] Z#2|G90 G17 M3|G91 G2 X1 I1|#1=#1+1|#500=[#1*2]
    IF[#1LT3]GOTO20|WHILE[#1LT3]DO1|END1|M98 P2|M98 P2 L3|M98 P#1|G65 P3 A1. B#2|G66 P2 X1|G67|M99|M99 P20|M30
    (open|)|G1 X1 (in) Y2|/N5 X1;Y2|N1 G54 G0 X1;N2 M99|DPRNT[A#1[3]]|POPEN|#3000=1(NO)|#3006=2(YES)|X1.2.3|Q|G999
    N7 S100 M3 M8|G4 P1.|M198 P2|GOTO 10|T1 M6|X1 X2|#[1]=2|SETVN100[A,B]|N20 GOTO#1||   |é (ü)|G68.2 X1""".replace(
        "\n    ", "|"
    ).split("|")
)
ENDS = st.sampled_from(["\n"] * 6 + ["\r\n", "\r", "\n\n"])


@given(
    st.lists(st.lists(st.tuples(LINES, ENDS), max_size=40), min_size=1, max_size=4),
    st.integers(1, 60),
    st.sampled_from([CONTROL, "gsk-988ta", "gsk-980tdi", "mitsubishi-m700", "hnc-21m", "linuxcnc"]),
)
@example([[("N10 Y2", "\n"), ("%", "\n"), ("N10 Y2", "\r"), ("%", "\n")]], 1, CONTROL)
def test_any_text_is_the_same_wherever_it_is_cut(
    texts: list[list[tuple[str, str]]], piece: int, control: str
) -> None:
    files = [(f"P{i}.nc", f"P{i}", "".join(map("".join, lines))) for i, lines in enumerate(texts)]
    check(control, files, piece)


def test_large_texts_are_the_same_on_all_cores() -> None:
    """The texts are those that `load` cuts: a long program, many of some length, and many small
    files.
    """
    moves = "".join(f"N{n} G1 X{n % 1000}. Y{n % 7}.5\n" for n in range(1, 60_000))
    long = f"O1\nG1 F100\n{moves}(END)\nM30\n"
    several = "".join(f"O{n} (P{n})\n{moves[: 997 * (n % 50)]}\nM99\n" for n in range(2, 60))
    small = [
        (f"{n}.nc", str(n), f"O{n}\nG1 X{n}. F#1\nM98 P{n + 1}\nM99\n") for n in range(100, 30_100)
    ]
    headless = f"{moves}%\n{moves}M30\n"  # lines before the first % may be no program
    for files in (
        [("1.nc", "1", long)],
        [("2.nc", "2", several)],
        [("3.nc", "3", headless)],
        small,
    ):
        assert sum(len(text) for _, _, text in files) > 1 << 20
        alone, shared = read(CONTROL, files, 1), read(CONTROL, files, 0)
        assert programs_of(shared) == programs_of(alone)
    library = read(CONTROL, [("1.nc", "1", long), ("2.nc", "2", several)], 4)
    run = library.run("O1", trace="blocks")
    assert run.stop == cncsub.Stop.END
    assert (run.steps.line[-1], len(run.steps)) == (60_003, 60_001)
    assert library["O1"].blocks[49_000].n == 49_000


NUMBERS = st.sampled_from([1, 2, 3, 255, 256, 257, 9_998, 65_536, 99_999])


@given(st.lists(NUMBERS | st.integers(1, 99_999), min_size=1, max_size=60))
def test_blocks_are_found_by_numbers_in_any_order(numbers: list[int]) -> None:
    """If a number stands twice, the nearest block after the jump is found."""
    blocks = "".join(f"N{n} #1={place}\n" for place, n in enumerate(numbers))
    for wanted in {*numbers[:3], *numbers[-3:]}:
        library = cncsub.loads(f"O1\nGOTO{wanted}\n{blocks}M30\n", control="gsk-988ta")
        run = library.run(trace="blocks")
        assert run.stop == cncsub.Stop.END, run.alarm
        assert run.steps.line[1] == 3 + numbers.index(wanted)


def test_numbers_that_begin_again_and_again_are_found_in_a_long_program() -> None:
    rounds, last = 30, 4_000
    blocks = "".join(f"N{n} #1=1\n" for _ in range(rounds) for n in range(1, last))
    library = cncsub.loads(f"O1\n{blocks}GOTO17\n", control="gsk-988ta")
    run = library.run(trace="blocks", max_blocks=rounds * (last - 1) + 2)
    assert run.steps.line[-1] == 18
