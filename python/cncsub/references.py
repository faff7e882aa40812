"""The references of programs, found without a run: calls, jumps, variables and the call graph."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from cncsub import _core

_PARTS = ("REPEAT", "BLOCK")  # kinds of calls that execute a part of the program itself


class Computed(NamedTuple):
    """A value that is known only when the block runs: the text of its expression."""

    expression: str


class CallTo(NamedTuple):
    """A call that a block makes.

    `kind`: the code that calls, as in the table of calls (`M98`, `G65`, `M-code`). `program`: the
    name of the called program; as the block names it where it does not exist. `exists`: whether it
    does, `None` where the name is computed. `external`: whether it is looked for on the external
    device. `start`: the sequence number it begins at, `None`: its first block. `repeats`: how often
    it runs, 0 where the call is skipped. `text`, `column`: the word that calls.
    """

    kind: str
    program: str | Computed
    exists: bool | None
    external: bool
    start: int | Computed | None
    repeats: int | Computed
    text: str
    column: int


class JumpTo(NamedTuple):
    """A jump that a block makes: GOTO, M99 P, M97.

    `n`: the sequence number it names, `None` where it names a label. `block`: the place of the
    block among those of the program, `None` where there is none or it is known only in the run.
    `in_caller`: whether the block is one of the program that called (M99 P). `text`, `column`: the
    word that names the block.
    """

    kind: str
    n: int | Computed | None
    block: int | None
    conditional: bool
    in_caller: bool
    text: str
    column: int


class VariableUse(NamedTuple):
    """A variable that a block reads or writes: its number, or its name where it has one.

    `text`, `column`: the value that it is a part of, or the variable that is written.
    """

    variable: int | str | Computed
    text: str
    column: int


class References(NamedTuple):
    """All that one block refers to."""

    calls: tuple[CallTo, ...]
    jumps: tuple[JumpTo, ...]
    reads: tuple[VariableUse, ...]
    writes: tuple[VariableUse, ...]


def references_of(program: _core.ProgramData, block: int) -> References:
    """Return what a block refers to; `block` is its place in the program."""
    calls, jumps, reads, writes = _core.references(program, block)
    return References(
        tuple(map(_call, calls)),
        tuple(map(_jump, jumps)),
        tuple(map(_use, reads)),
        tuple(map(_use, writes)),
    )


def _call(row: _core._CallRow) -> CallTo:
    kind, program, found, external, start, repeats, by_p, by_start, by_l, text, column, _ = row
    return CallTo(
        kind,
        Computed(by_p) if by_p is not None else program or "",
        None if by_p is not None else found is not None,
        external,
        Computed(by_start) if by_start is not None else start,
        Computed(by_l) if by_l is not None else repeats,
        text,
        column,
    )


def _jump(row: _core._JumpRow) -> JumpTo:
    kind, conditional, in_caller, n, block, computed, text, column = row
    to = Computed(computed) if computed is not None else n
    return JumpTo(kind, to, block, conditional, in_caller, text, column)


def _use(row: _core._VariableRow) -> VariableUse:
    number, name, computed, text, column = row
    if computed:
        return VariableUse(Computed(text), text, column)
    return VariableUse(name if name is not None else number or 0, text, column)


class Edge(NamedTuple):
    """A block that calls: `caller` is the name of its program."""

    caller: str
    n: int | None
    line: int
    kind: str
    called: str | Computed
    repeats: int | Computed
    exists: bool | None
    file: str


@dataclass(frozen=True)
class CallGraph:
    """The calls of a library, as its blocks are written.

    `programs`: the names of all programs. `edges`: every call, in the order of the blocks. `roots`:
    programs that no call names. `unreached`: programs that no chain of calls from the main program,
    or from an `entry`, leads to; a call whose program is computed may lead anywhere: see
    `computed`. `cycles`: chains
    of calls that come back to their start, one for each group of programs that call each other; a
    program that calls itself is one of one name. `deepest`: for each kind of call, and for `"any"`,
    the longest chain of such calls, which goes round no cycle. `missing`: calls of programs that do
    not exist. `computed`: calls whose program is computed.

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P2 L3\\nM30\\nO2\\nG65 P3\\nM99\\nO4\\nM98 P9\\nM99\\n"
    >>> graph = cncsub.loads(text, control="fanuc-0i-f").call_graph()
    >>> graph.roots, graph.unreached
    (('O1', 'O4'), ('O4',))
    >>> [(edge.caller, edge.n, edge.kind, edge.called) for edge in graph.missing]
    [('O2', None, 'G65', 'O3'), ('O4', None, 'M98', 'O9')]
    """

    programs: tuple[str, ...]
    edges: tuple[Edge, ...]
    roots: tuple[str, ...]
    unreached: tuple[str, ...]
    cycles: tuple[tuple[str, ...], ...]
    deepest: Mapping[str, tuple[str, ...]]

    @functools.cached_property
    def missing(self) -> tuple[Edge, ...]:
        """The calls of programs that do not exist."""
        return tuple(edge for edge in self.edges if edge.exists is False)

    @functools.cached_property
    def computed(self) -> tuple[Edge, ...]:
        """The calls whose program is computed."""
        return tuple(edge for edge in self.edges if isinstance(edge.called, Computed))

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import graph_html

        return graph_html(self)

    def __repr__(self) -> str:
        return (
            f"<CallGraph of {len(self.programs)} programs, {len(self.edges)} calls, "
            f"{len(self.missing)} missing>"
        )

    def _columns(self) -> dict[str, list[Any]]:
        """Return one row for each call; computed values stand in columns of their own."""

        def known(name: str) -> list[Any]:
            values = (getattr(edge, name) for edge in self.edges)
            return [None if isinstance(value, Computed) else value for value in values]

        def expressions(name: str) -> list[str | None]:
            values = (getattr(edge, name) for edge in self.edges)
            return [value.expression if isinstance(value, Computed) else None for value in values]

        columns = {name: known(name) for name in Edge._fields}
        columns["called_expression"] = expressions("called")
        columns["repeats_expression"] = expressions("repeats")
        return columns

    def to_pandas(self) -> Any:
        """Return the calls as a pandas `DataFrame`: a row for each edge."""
        import pandas as pd

        return pd.DataFrame(self._columns())

    def to_arrow(self) -> Any:
        """Return the calls as a pyarrow `Table`: a row for each edge."""
        import pyarrow as pa

        kinds = {"n": pa.int64(), "line": pa.int64(), "repeats": pa.int64(), "exists": pa.bool_()}
        columns = self._columns()
        schema = pa.schema([(name, kinds.get(name, pa.string())) for name in columns])
        return pa.table(columns, schema=schema)

    def to_json(self) -> str:
        """Return the whole graph as JSON, with its version."""
        columns = self._columns()
        rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        told = {
            "version": 1,
            "programs": self.programs,
            "edges": rows,
            "roots": self.roots,
            "unreached": self.unreached,
            "cycles": self.cycles,
            "deepest": dict(self.deepest),
        }
        return json.dumps(told, indent=1, ensure_ascii=False)

    def to_dot(self) -> str:
        """Return the graph in the language of Graphviz: missing programs dashed, computed ones
        dotted.
        """
        return "\n".join(["digraph calls {", *self._dot_lines(), "}"]) + "\n"

    def _dot_lines(self) -> Iterator[str]:
        for name in self.programs:
            grey = " [color=grey]" if name in self.unreached else ""
            yield f"  {_quoted(name)}{grey};"
        drawn: dict[tuple[str, str, str], int] = {}
        styles: dict[str, str] = {}
        for edge in self.edges:
            if isinstance(edge.called, Computed):
                styles[edge.called.expression] = "dotted"
                to = edge.called.expression
            else:
                to = edge.called
                if not edge.exists:
                    styles[to] = "dashed"
            key = (edge.caller, to, edge.kind)
            drawn[key] = drawn.get(key, 0) + 1
        for name, style in styles.items():
            yield f"  {_quoted(name)} [style={style}];"
        for (caller, to, kind), count in drawn.items():
            label = kind if count == 1 else f"{kind} ({count} calls)"
            yield f"  {_quoted(caller)} -> {_quoted(to)} [label={_quoted(label)}];"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'


def call_graph(code: _core.Code, starts: Iterable[int]) -> CallGraph:
    """Return the graph of all programs of a memory and its external device. `starts`: the main
    program, and those that something outside calls.
    """
    data = [code.program(index) for index in range(len(code))]
    names = tuple(program.name for program in data)
    files = [program.file for program in data]
    edges: list[Edge] = []
    ways: dict[str, list[dict[int, None]]] = {}  # the programs that each caller calls, by kind

    def take(caller: int, n: int | None, line: int, row: _core._CallRow) -> None:
        call, called = _call(row), row[2]
        to = call.program if called is None else names[called]
        edges.append(
            Edge(names[caller], n, line, call.kind, to, call.repeats, call.exists, files[caller])
        )
        if called is not None and call.kind not in _PARTS:
            if call.kind not in ways:
                ways[call.kind] = [{} for _ in data]
            ways[call.kind][caller][called] = None

    _core.each_call(code, take)
    every: list[dict[int, None]] = [{} for _ in data]
    for of_kind in ways.values():
        for caller, programs in enumerate(of_kind):
            every[caller].update(programs)
    graph = _Graph(every)
    called = {to for each in every for to in each}
    reached = graph.reached(starts)
    deepest = {kind: _Graph(each).deepest() for kind, each in ways.items()}
    if ways:
        deepest["any"] = graph.deepest()
    own = [index for index, program in enumerate(data) if not program.system]
    return CallGraph(
        tuple(names[index] for index in own),
        tuple(edges),
        tuple(names[index] for index in own if index not in called),
        tuple(names[index] for index in own if index not in reached),
        tuple(tuple(names[index] for index in cycle) for cycle in graph.cycles()),
        {kind: tuple(names[index] for index in path) for kind, path in deepest.items()},
    )


class _Graph:
    """A directed graph of numbers from 0. No function is recursive: chains may be long."""

    def __init__(self, arrows: Iterable[Iterable[int]]) -> None:
        self.next = [list(each) for each in arrows]
        self.order: list[int] = []  # each after all it leads to, but for arrows that close cycles
        self._groups: list[list[int]] = []
        self._walk()

    def reached(self, starts: Iterable[int]) -> set[int]:
        found = set(starts)
        waiting = list(found)
        while waiting:
            new = [to for to in self.next[waiting.pop()] if to not in found]
            found.update(new)
            waiting += new
        return found

    def _walk(self) -> None:
        """Find the groups of numbers that lead to each other, by Tarjan's algorithm."""
        size = len(self.next)
        index, low = [-1] * size, [0] * size
        group: list[int] = []
        place = [-1] * size  # in `group`, while it is there
        count = 0
        for root in range(size):
            if index[root] >= 0:
                continue
            work = [(root, 0)]
            while work:
                at, arrow = work.pop()
                if arrow == 0:
                    index[at] = low[at] = count
                    count += 1
                    place[at] = len(group)
                    group.append(at)
                while arrow < len(self.next[at]):
                    to = self.next[at][arrow]
                    arrow += 1
                    if index[to] < 0:
                        work += [(at, arrow), (to, 0)]
                        break
                    if place[to] >= 0:
                        low[at] = min(low[at], index[to])
                else:
                    self.order.append(at)
                    if low[at] == index[at]:
                        first = place[at]
                        self._groups.append(group[first:])
                        for each in group[first:]:
                            place[each] = -1
                        del group[first:]
                    if work:
                        low[work[-1][0]] = min(low[work[-1][0]], low[at])

    def cycles(self) -> list[list[int]]:
        """Return the shortest cycle from the first number of each group that has one."""
        found = []
        for group in self._groups:
            start, members = min(group), set(group)
            if len(group) > 1 or start in self.next[start]:
                found.append(self._round(start, members))
        return sorted(found)

    def _round(self, start: int, members: set[int]) -> list[int]:
        came: dict[int, int] = {}
        front = [start]
        while start not in came:
            ahead = []
            for at in front:
                for to in self.next[at]:
                    if to in members and to not in came:
                        came[to] = at
                        ahead.append(to)
            front = ahead
        path = [start]
        while came[path[-1]] != start:
            path.append(came[path[-1]])
        return [path[0], *reversed(path[1:])]

    def deepest(self) -> list[int]:
        """Return the longest chain; an arrow that closes a cycle is not followed."""
        place = {at: i for i, at in enumerate(self.order)}
        length = [1] * len(self.next)
        step: list[int | None] = [None] * len(self.next)
        for at in self.order:
            for to in self.next[at]:
                if place[to] < place[at] and length[to] + 1 > length[at]:
                    length[at], step[at] = length[to] + 1, to
        path: list[int] = []
        at_last: int | None = max(range(len(length)), key=lambda i: (length[i], -i), default=None)
        while at_last is not None:
            path.append(at_last)
            at_last = step[at_last]
        return path
