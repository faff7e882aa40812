"""The pages of single values in a notebook: alarms, controls, findings, graphs, coverage, tables of
variables.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice
from typing import TYPE_CHECKING, Any

from cncsub._core import Alarm, Control, Frame, variable_name
from cncsub.controls import causes
from cncsub.escapes import escape
from cncsub.notebook_pieces import few, line, marked, page, plain, table

if TYPE_CHECKING:
    from cncsub.checking import Finding
    from cncsub.comparison.compare import Comparison
    from cncsub.coverage.summary import Coverage
    from cncsub.references import CallGraph

MOST_ROWS = 300  # of one table of facts
MOST_VARIABLES = 60


def alarm_html(alarm: Alarm) -> str:
    """Return the message with its marked word, what raises such an alarm, and the cure."""
    cause = causes[alarm.cause]
    told = (("raised by", cause.meaning), ("cure", cause.cure))
    return page([marked(str(alarm)), table(("", alarm.cause), told)])


def frame_html(frame: Frame) -> str:
    """Return what called what, and the pass it is in."""
    return page([line(str(repr(frame)).strip("<>"))])


def control_html(control: Control) -> str:
    """Return the facts of a control, to be folded out, each with its source."""
    rules = ((r.name, str(r.value), r.meaning, f"{r.source}; {r.evidence}") for r in control.rules)
    parameters = (
        (p.name, f"{p.value:g}", p.meaning, f"{p.source}; {p.evidence}")
        for p in control.parameters.values()
    )
    alarms = (
        (a.number or "-", a.cause, a.text or causes[a.cause].meaning, f"{a.source}; {a.evidence}")
        for a in control.alarms.values()
    )
    return page(
        [
            line(f"{control.title} ({control.name})", strong=True),
            _folded("rules", ("rule", "value", "meaning", "source"), rules),
            _folded("parameters", ("parameter", "value", "meaning", "source"), parameters),
            _folded("alarms", ("number", "cause", "text", "source"), alarms),
        ]
    )


def _folded(what: str, heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    told = list(rows)
    left = len(told) - MOST_ROWS
    more = line(f"... and {left:,} more") if left > 0 else ""
    inner = table(heads, told[:MOST_ROWS])
    return f"<details><summary>{len(told):,} {escape(what)}</summary>{inner}{more}</details>"


def finding_html(finding: Finding) -> str:
    """Return the place with its marked word, what is wrong there, and the hint."""
    return page([marked(str(finding)) if finding.severity == "error" else plain(str(finding))])


def graph_html(graph: CallGraph) -> str:
    """Return the calls of a graph, and what stands out."""

    def told(value: Any) -> str:
        return value if isinstance(value, str) else f"[{value.expression}]"

    def rows() -> Iterator[tuple[str, ...]]:
        for e in islice(graph.edges, MOST_ROWS):
            repeats = str(e.repeats) if isinstance(e.repeats, int) else f"[{e.repeats.expression}]"
            exists = "does not exist" if e.exists is False else ""
            yield e.caller, str(e.line), e.kind, told(e.called), repeats, exists

    parts = [line(repr(graph)[1:-1], strong=True)]
    parts.append(table(("caller", "line", "kind", "called", "passes", ""), rows()))
    if (left := len(graph.edges) - MOST_ROWS) > 0:
        parts.append(line(f"... and {left:,} more"))
    parts += few("cycle", (" -> ".join((*cycle, cycle[0])) for cycle in graph.cycles))
    parts += few("unreached", graph.unreached)
    return page(parts)


def coverage_html(coverage: Coverage) -> str:
    """Return how much of each program ran."""
    rows = (
        (p.name, f"{p.blocks_covered():,} of {len(p.blocks):,}", p.file)
        for p in islice(coverage.programs, MOST_ROWS)
    )
    return page([line(repr(coverage)[1:-1], strong=True), table(("program", "blocks", ""), rows)])


def comparison_html(compared: Comparison) -> str:
    """Return whether both do the same, or where they part."""
    return page([plain(str(compared)) if compared.same else marked(str(compared))])


def variables_html(variables: Mapping[int, float | None], control: Control) -> str:
    """Return the variables that have a value."""
    held = [
        (variable_name(control, n), f"{value:.10g}")
        for n, value in variables.items()
        if value is not None
    ]
    parts = [table(("variable", "value"), held[:MOST_VARIABLES])]
    if not held:
        parts = [line("no variable has a value")]
    if (left := len(held) - MOST_VARIABLES) > 0:
        parts.append(line(f"... and {left:,} more"))
    return page(parts)


def rows_html(name: str, rows: Iterable[Any], count: int) -> str:
    """Return rows that are data classes, as a table."""
    shown = list(islice(rows, MOST_VARIABLES))
    parts = [line(name)]
    if shown:
        heads = list(type(shown[0]).__dataclass_fields__)
        cells = ([str("-" if (v := getattr(r, h)) is None else v) for h in heads] for r in shown)
        parts.append(table(heads, cells))
    if (left := count - len(shown)) > 0:
        parts.append(line(f"... and {left:,} more"))
    return page(parts)
