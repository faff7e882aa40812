"""`cncsub list`: the programs of a memory, what their heads say, and the calls between them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from dataclasses import asdict
from typing import Annotated, Any

import typer

import cncsub
from cncsub.cli.memory import idle_entries, library_of, notes_on
from cncsub.cli.options import (
    ControlName,
    Encoding,
    External,
    Format,
    Output,
    Param,
    Paths,
    Prefer,
    SearchPath,
    wrong_use,
)
from cncsub.cli.output import tell_all, write_json, write_text
from cncsub.cli.project import project_for
from cncsub.escapes import shown
from cncsub.program import named_like
from cncsub.references import Edge

MOST_NAMES = 6  # in one line


def list_programs(
    paths: Paths = None,
    control: ControlName = None,
    param: Param = None,
    external: External = None,
    search: SearchPath = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """List the programs: where they begin, their titles, what they call and who calls them."""
    with wrong_use():
        options = {**locals(), "mdi": None}
        library = library_of(options)
        project = project_for(paths)
        notes = [*notes_on(options, library), *idle_entries(options, project, [library])]
        entries = named_like(library.code, project.entry)
    rows = list(_rows(library, set(entries)))
    if format is Format.JSON:
        write_json(output, {"programs": rows, "notes": list(map(asdict, notes))})
        return
    write_text(output, lambda console: console.print("\n".join(_lines(rows)) or "no programs"))
    tell_all(notes)


def _rows(library: cncsub.Library, entries: Collection[int]) -> Iterator[dict[str, Any]]:
    edges = library.call_graph().edges
    out: dict[str, list[Edge]] = {}
    callers: dict[str, Counter[str]] = {}
    for edge in edges:
        out.setdefault(edge.caller, []).append(edge)
        if isinstance(edge.called, str):
            callers.setdefault(edge.called, Counter())[edge.caller] += 1
    main = library.main
    for program in [*library.values(), *library.external.values()]:
        yield {
            "program": program.name,
            "file": program.file,
            "line": program.line,
            "blocks": len(program.blocks),
            "comment": program.comment,
            "main": main is not None and program is main,
            "entry": program.index in entries,
            "external": program.external,
            "calls": [_call(edge) for edge in out.get(program.name, ())],
            "callers": sorted(callers.get(program.name, ())),
        }


def _call(edge: Edge) -> dict[str, Any]:
    called = edge.called
    return {
        "kind": edge.kind,
        "program": called if isinstance(called, str) else None,
        "expression": None if isinstance(called, str) else called.expression,
        "exists": edge.exists,
        "n": edge.n,
        "line": edge.line,
    }


def _lines(rows: list[dict[str, Any]]) -> Iterator[str]:
    width = max((len(row["program"]) for row in rows), default=0)
    for row in rows:
        comment = f" ({row['comment']})" if row["comment"] else ""
        blocks = f"{row['blocks']:,} block{'' if row['blocks'] == 1 else 's'}"
        marks = [word for word in ("main", "entry", "external") if row[word]]
        facts = ", ".join([blocks, *marks])
        name = shown(row["program"]).ljust(width)
        yield f"{name}  {shown(row['file'])}:{row['line']}{shown(comment)}, {facts}"
        if row["calls"]:
            yield f"    calls {_names(map(_named, row['calls']))}"
        if row["callers"]:
            yield f"    called by {_names(row['callers'])}"


def _named(call: dict[str, Any]) -> str:
    kind = f"{call['kind']} " if call["kind"][0] in "GM" else ""  # in other languages a name calls
    if call["program"] is None:
        return f"{kind}[{call['expression']}]"
    missing = ", which does not exist" if call["exists"] is False else ""
    return f"{kind}{call['program']}{missing}"


def _names(names: Iterable[str]) -> str:
    """Return each name once, with how often it occurs; of many names the first."""
    counted = Counter(names)
    told = [
        shown(name) + (f" ({times} times)" if times > 1 else "")
        for name, times in list(counted.items())[:MOST_NAMES]
    ]
    left = len(counted) - MOST_NAMES
    return "; ".join(told) + (f"; and {left:,} more" if left > 0 else "")
