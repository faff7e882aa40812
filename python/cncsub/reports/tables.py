"""The tables of a report, whose heads sort them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from cncsub.analysis.static_tree import letters
from cncsub.escapes import escape

if TYPE_CHECKING:
    from cncsub.reports.code import Anchors
    from cncsub.run import Run


def table(name: str, heads: Sequence[str], rows: Sequence[Sequence[str]], whole: int) -> str:
    """Return a table of cells that are HTML already; nothing where it has no rows."""
    if not rows:
        return ""
    head = "".join(
        f'<th scope="col"><button type="button">{escape(word)}</button></th>' for word in heads
    )
    body = "".join(f"<tr>{''.join(map(_cell, row))}</tr>\n" for row in rows)
    left = whole - len(rows)
    more = f'<p class="pale">... and {left:,} more rows</p>' if left > 0 else ""
    return (
        f'<h3>{escape(name)}</h3><div class="scroll" tabindex="0" role="region"'
        f' aria-label="{escape(name)}"><table><thead><tr>{head}</tr></thead>'
        f"<tbody>{body}</tbody></table></div>{more}\n"
    )


def _cell(inner: str) -> str:
    try:
        float(inner)
    except ValueError:
        return f"<td>{inner}</td>"
    return f'<td class="number">{inner}</td>'


def calls_rows(
    run: Run, anchors: Anchors, most: int
) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return the heads and the first rows of the calls."""
    rows: list[tuple[str, ...]] = [
        (
            str(row.call),
            escape(row.kind),
            anchors.program(row.program),
            anchors.of_step(row.caller_step),
            str(row.repeats),
            str(row.level),
            escape(letters(row.arguments)),
            "" if row.last_step is None else str(row.last_step - row.first_step + 1),
        )
        for row in run.calls[:most]
    ]
    return ("call", "kind", "program", "from", "passes", "level", "arguments", "blocks"), rows
