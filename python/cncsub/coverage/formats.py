"""Coverage in the formats of other programs: HTML, lcov, Cobertura."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET

from cncsub.coverage.block_counts import percent_text
from cncsub.escapes import escape, for_xml, referred, shown
from cncsub.pages import html_page

if TYPE_CHECKING:
    from cncsub.coverage.block_counts import Counted
    from cncsub.coverage.summary import Coverage


def _file_of(program: Counted, root: str | Path | None) -> str:
    """Return the name of its file as seen from a folder that holds it, with slashes; a file that
    lies elsewhere keeps its name. The current folder counts where no other is given.
    """
    if program.has_no_file:
        return program.file
    folder, file = Path(root or "").absolute(), Path(program.file).absolute()
    for seen_as in (os.path.normpath, os.path.realpath):
        near, far = Path(seen_as(folder)), Path(seen_as(file))
        if far.is_relative_to(near):
            return far.relative_to(near).as_posix()
    return program.file


def _by_file(coverage: Coverage, root: str | Path | None) -> dict[str, list[Counted]]:
    files: dict[str, list[Counted]] = {}
    for program in coverage.programs:
        files.setdefault(_file_of(program, root), []).append(program)
    return files


def _lines(programs: list[Counted]) -> dict[int, tuple[int, list[tuple[str, int]]]]:
    """Return by line of the file the executions, and the outcomes of its branch."""
    found: dict[int, tuple[int, list[tuple[str, int]]]] = {}
    for program in programs:
        for index, block in enumerate(program.blocks):
            count, outcomes = found.get(block.line, (0, []))
            new = [*outcomes, *program.outcomes(index)]
            found[block.line] = count + program.count(index), new
    return dict(sorted(found.items()))


def lcov(coverage: Coverage, root: str | Path | None = None) -> str:
    """Return one record for each file."""
    return "".join(f"{line}\n" for line in _lcov_lines(_by_file(coverage, root)))


def _lcov_lines(by_file: dict[str, list[Counted]]) -> Iterator[str]:
    for file, programs in by_file.items():
        lines = _lines(programs)
        yield "TN:"
        yield f"SF:{shown(file)}"
        outcomes = [
            (line, place, count, executed or any(count for _, count in of))
            for line, (executed, of) in lines.items()
            for place, (_, count) in enumerate(of)
        ]
        for line, place, count, executed in outcomes:
            yield f"BRDA:{line},0,{place},{count if executed else '-'}"
        if outcomes:
            yield f"BRF:{len(outcomes)}"
            yield f"BRH:{sum(count > 0 for _, _, count, _ in outcomes)}"
        for line, (count, _) in lines.items():
            yield f"DA:{line},{count}"
        yield f"LF:{len(lines)}"
        yield f"LH:{sum(count > 0 for count, _ in lines.values())}"
        yield "end_of_record"


def _rates(lines: dict[int, tuple[int, list[tuple[str, int]]]]) -> dict[str, str]:
    counts = [count for count, _ in lines.values()]
    outcomes = [count for _, of in lines.values() for _, count in of]

    def rate(values: list[int], of_none: int) -> str:
        return f"{sum(value > 0 for value in values) / len(values) if values else of_none:.4f}"

    lines_done, branches_done = rate(counts, 0), rate(outcomes, int(bool(counts)))
    return {"line-rate": lines_done, "branch-rate": branches_done, "complexity": "0"}


def cobertura(coverage: Coverage, root: str | Path | None = None) -> str:
    """Return a package with a class for each file."""
    by_file = {file: _lines(programs) for file, programs in _by_file(coverage, root).items()}
    everything = dict(enumerate(each for lines in by_file.values() for each in lines.values()))
    counts = [count for count, _ in everything.values()]
    outcomes = [count for _, of in everything.values() for _, count in of]
    totals = {
        "lines-covered": str(sum(count > 0 for count in counts)),
        "lines-valid": str(len(counts)),
        "branches-covered": str(sum(count > 0 for count in outcomes)),
        "branches-valid": str(len(outcomes)),
        "version": "1",
        "timestamp": "0",
    }
    rates = _rates(everything)
    report = ET.Element("coverage", {**rates, **totals})
    ET.SubElement(ET.SubElement(report, "sources"), "source").text = "."
    package = ET.SubElement(ET.SubElement(report, "packages"), "package", {"name": "", **rates})
    classes = ET.SubElement(package, "classes")
    for file, lines in by_file.items():
        name = for_xml(file)
        one = ET.SubElement(classes, "class", {"name": name, "filename": name, **_rates(lines)})
        ET.SubElement(one, "methods")
        listed = ET.SubElement(one, "lines")
        for line, (count, of) in lines.items():
            told = {"number": str(line), "hits": str(count), "branch": "true" if of else "false"}
            if of:
                done = sum(outcome > 0 for _, outcome in of)
                told["condition-coverage"] = f"{100 * done // len(of)}% ({done}/{len(of)})"
            ET.SubElement(listed, "line", told)
    ET.indent(report)
    head = '<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE coverage SYSTEM'
    dtd = '"http://cobertura.sourceforge.net/xml/coverage-04.dtd"'
    return f"{head} {dtd}>\n{referred(ET.tostring(report, encoding='unicode'))}\n"


def html(coverage: Coverage, root: str | Path | None = None) -> str:
    """Return the programs, each to be folded in and out, with those open of which something is
    missed; colours are given in words as well.
    """
    programs = "".join(_program(program, root) for program in coverage.programs)
    blocks, branches = coverage.blocks, coverage.branches
    percent = percent_text(coverage.percent) if coverage.measured else "nothing was measured"
    done = (
        f"{percent}: {blocks.covered} of {len(blocks)} blocks,"
        f" {branches.covered} of {len(branches)} outcomes of branches,"
        f" {coverage.calls.covered} of {len(coverage.calls)} calls,"
        f" {coverage.arguments.covered} of {len(coverage.arguments)} arguments"
    )
    return html_page("Coverage", "coverage", [f"<p>{done}</p>\n", programs])


def _program(program: Counted, root: str | Path | None) -> str:
    rows = []
    lines = _lines([program])
    for index, block in enumerate(program.blocks):
        outcomes = list(program.outcomes(index))
        count = program.count(index)
        missed = [_MISSED.get(name, name) for name, of in outcomes if not of]
        state = "no" if count == 0 else "part" if missed else "yes"
        told = f"never {', '.join(missed)}" if count and missed else ""
        ran = f"{count:,}x" if count else "not"
        rows.append(
            f'<tr class="{state}"><td class="number">{block.line}</td><td>{ran}</td>'
            f"<td>{escape(block.text)}</td><td>{told}</td></tr>\n"
        )
    done = sum(count > 0 for count, _ in lines.values())
    covered, known = program.parts()
    return (
        f"<details{' open' if covered < known else ''}><summary><b>{escape(program.name)}</b>"
        f" ({escape(_file_of(program, root))}): {done} of {len(lines)} lines</summary>\n"
        '<table class="code"><thead><tr><th>line</th><th>ran</th><th>block</th><th>missed</th></tr>'
        f"</thead><tbody>\n{''.join(rows)}</tbody></table>"
        f"{_not_used(program)}</details>\n"
    )


# The words for outcomes of a loop that no run had.
_MISSED = {"none": "left out", "once": "one pass", "many": "several passes"}


def _not_used(program: Counted) -> str:
    """Return the calls that were not made, and the arguments that no call gave."""
    lines = [
        f"line {program.blocks.line[block]}: {kind} {called} was not called"
        for block, kind, called, count in program.calls_of()
        if not count and not program.count(block)
    ]
    never = program.never_given()
    if never:
        lines.append(f"never given: {', '.join(never)}")
    return "".join(f"<p>{escape(line)}</p>\n" for line in lines)


def coverage_lines(
    coverage: Coverage, *, root: str | Path | None = None, skip_covered: bool = False
) -> Iterator[str]:
    """Yield the sum, then a line for each program: covered blocks and outcomes, and the lines where
    some are missing. `skip_covered` leaves out the programs where nothing is.
    """
    yield repr(coverage)[1:-1]
    whole = 0
    for program in coverage.programs:
        covered, known = program.parts()
        if skip_covered and covered == known:
            whole += 1
        else:
            yield _program_line(program, _file_of(program, root))
    if whole:
        are = "program is" if whole == 1 else "programs are"
        yield f"{whole} {are} fully covered and not listed"


def below_limit(coverage: Coverage, limit: float | None) -> str | None:
    """Return what is wrong with a coverage that has to reach so many percent, or `None`. Where
    there is nothing to measure, no limit is reached.
    """
    if limit is None or (coverage.measured and coverage.percent >= limit):
        return None
    if not coverage.measured:
        return f"coverage measured nothing (0 of 0 blocks), and must reach {limit:g} %"
    places = next(n for n in range(1, 20) if round(coverage.percent, n) < limit)
    return f"coverage is {coverage.percent:.{places}f} %, below {limit:g} %"


def _program_line(program: Counted, file: str) -> str:
    counts = [program.count(index) for index in range(len(program.blocks))]
    outcomes = [list(program.outcomes(index)) for index in range(len(counts))]
    missing = [block.line for block, count in zip(program.blocks, counts) if not count]
    one_sided = [
        block.line
        for block, count, of in zip(program.blocks, counts, outcomes)
        if count and not all(of_one for _, of_one in of)
    ]
    told = f"  not executed: lines {_ranges(missing)}" if missing else ""
    told += f"  missed branches: lines {_ranges(one_sided)}" if one_sided else ""
    branches = [count for of in outcomes for _, count in of]
    return f"{program.name}  blocks {_part(counts)}  branches {_part(branches)}{told}  {file}"


def _part(counts: list[int]) -> str:
    return f"{sum(count > 0 for count in counts)}/{len(counts)}"


def _ranges(lines: list[int]) -> str:
    """Return lines as `3-5, 9`."""
    found: list[list[int]] = []
    for line in lines:
        if found and line == found[-1][1] + 1:
            found[-1][1] = line
        else:
            found.append([line, line])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in found)
