"""The programs of a report: what ran beside what was found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from cncsub.coverage.block_counts import percent_text
from cncsub.escapes import escape

if TYPE_CHECKING:
    from cncsub._core import Alarm
    from cncsub.checking import Finding
    from cncsub.coverage.block_counts import Counted
    from cncsub.coverage.summary import Coverage
    from cncsub.run import Run

MOST_LINES = 5_000  # of all programs together; what is marked is shown in any case
MOST_LETTERS = 400  # of a block


class Anchors:
    """The places of blocks on the page."""

    def __init__(self, run: Run, coverage: Coverage) -> None:
        self._run = run
        self._files: dict[str, int] = {}
        self._names: dict[str, str] = {}
        self._shown: set[tuple[str, int]] = set()
        shares = _shares([len(program.blocks) for program in coverage.programs], MOST_LINES)
        for program, share in zip(coverage.programs, shares):
            self._files.setdefault(program.file, len(self._files))
            self._names.setdefault(program.name, program.file)
            self._shown.update((program.file, line) for line in program.blocks.line[:share])

    def mark(self, file: str, line: int) -> None:
        """Show a block, however long its program is."""
        if file in self._files:
            self._shown.add((file, line))

    def shown(self, file: str, line: int) -> bool:
        return (file, line) in self._shown

    def name(self, file: str, line: int) -> str:
        return f"f{self._files.get(file, 0)}-l{line}"

    def head(self, program: str) -> str:
        return f"program-{program.encode('utf-8').hex()}"

    def link(self, file: str, line: int, words: str) -> str:
        """Return words that lead to a block, or only words where the page does not show it."""
        if not self.shown(file, line):
            return escape(words)
        return f'<a href="#{self.name(file, line)}">{escape(words)}</a>'

    def program(self, name: str) -> str:
        if name not in self._names:
            return escape(name)
        return f'<a href="#{self.head(name)}">{escape(name)}</a>'

    def block_of_step(self, step: int) -> tuple[str, str]:
        """Return the words for the block of a step, and the link to it."""
        row = self._run.steps[step]
        words = f"{row.program} line {row.line}" if row.n is None else f"{row.program} N{row.n}"
        file = self._names.get(row.program, "")
        at = self.name(file, row.line) if self.shown(file, row.line) else self.head(row.program)
        return words, f"#{at}"

    def of_step(self, step: int | None) -> str:
        if step is None or not 0 <= step < len(self._run.steps):
            return ""
        words, link = self.block_of_step(step)
        return f'<a href="{escape(link)}">{escape(words)}</a>'


def _shares(sizes: list[int], most: int) -> list[int]:
    """Return how many blocks of each program are shown: all of the short ones, equal shares of the
    long ones.
    """
    shares = [0] * len(sizes)
    left = most
    for rank, place in enumerate(sorted(range(len(sizes)), key=sizes.__getitem__)):
        shares[place] = min(sizes[place], left // (len(sizes) - rank))
        left -= shares[place]
    return shares


Marks = dict[tuple[str, int], list[tuple[str, str]]]
Places = Mapping[tuple[str, int], str]  # by program and line: where its moves lead on the drawing


def code_section(
    coverage: Coverage,
    findings: list[Finding],
    alarm: Alarm | None,
    anchors: Anchors,
    places: Places,
) -> Iterator[str]:
    """Yield each program, to be folded in and out."""
    marks: Marks = {}
    if alarm is not None:
        marks[alarm.file, alarm.line] = [("error", f"alarm {alarm.number or ''} {alarm.cause}")]
    for found in findings:
        words = (found.severity, f"{found.rule} {found.message}")
        marks.setdefault((found.file, found.line), []).append(words)
        for place in found.places:
            marks.setdefault((place.file, place.line), []).append(words)
    blocks, branches = coverage.blocks, coverage.branches
    yield (
        f"<p>{percent_text(coverage.percent)} covered:"
        f" {blocks.covered:,} of {len(blocks):,} blocks,"
        f" {branches.covered:,} of {len(branches):,} outcomes of branches."
        ' <span class="pale">The keys n and p lead to the next and the previous finding.</span></p>'
    )
    for program in coverage.programs:
        yield from _program(program, marks, anchors, places)


def _program(program: Counted, marks: Marks, anchors: Anchors, places: Places) -> Iterator[str]:
    done, count = program.blocks_covered(), len(program.blocks)
    found = sum((program.file, line) in marks for line in program.blocks.line)
    opened = " open" if done or found else ""
    told = f"{program.file}: {done:,} of {count:,} blocks ran"
    if found:
        told += f", {found:,} marked"
    yield (
        f'<details{opened} id="{anchors.head(program.name)}"><summary><b>{escape(program.name)}</b>'
        f' <span class="pale">{escape(told)}</span></summary><table class="code"><thead><tr>'
        "<th>line</th><th>ran</th><th>block</th><th>found</th></tr></thead><tbody>\n"
    )
    left = 0
    seen: set[int] = set()
    for place, line in enumerate(program.blocks.line):
        at = (program.file, line)
        if not anchors.shown(*at) and at not in marks:
            left += 1
            continue
        if left:
            yield _gap(left)
            left = 0
        name = "" if line in seen else anchors.name(*at)
        leads = places.get((program.name, line), "")
        yield _block(program, place, marks.get(at, []), name, leads)
        seen.add(line)
    if left:
        yield _gap(left)
    yield "</tbody></table></details>\n"


def _gap(blocks: int) -> str:
    return f'<tr><td></td><td></td><td class="pale">... {blocks:,} blocks</td><td></td></tr>\n'


def _block(
    program: Counted, place: int, marks: list[tuple[str, str]], name: str, leads: str
) -> str:
    block, count = program.blocks[place], program.count(place)
    missed = [outcome for outcome, of in program.outcomes(place) if not of]
    state = "no" if count == 0 else "part" if missed else "yes"
    told = "".join(f'<div class="{kind}">{escape(words)}</div>' for kind, words in marks)
    if count and missed:
        told += f"<div>never {escape(', '.join(missed))}</div>"
    text = block.text if len(block.text) <= MOST_LETTERS else block.text[:MOST_LETTERS] + " ..."
    marked = f'{state} mark" tabindex="-1' if marks else state
    identity = f' id="{name}"' if name else ""
    identity += f' data-at="{leads}"' if leads else ""
    ran = f"{count:,}x" if count else "not"
    return (
        f'<tr{identity} class="{marked}"><td class="number">{block.line}</td><td>{ran}</td>'
        f"<td>{escape(text)}</td><td>{told}</td></tr>\n"
    )
