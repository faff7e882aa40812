"""Breakpoints as the protocol has them."""

from __future__ import annotations

from typing import Any

from cncsub.dap.adapter import Adapter
from cncsub.dap.arguments import Arguments
from cncsub.dap.sources import known_file, source_of
from cncsub.dap.views import held_by
from cncsub.debugging import PausePoint, PlacedPoint
from cncsub.debugging.points import blocks_between, programs_of
from cncsub.debugging.values import is_state_name

_MOST_LOCATIONS = 10_000  # lines with blocks of one answer


def set_breakpoints(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Place the breakpoints of one file."""
    session = adapter.running()
    asked = arguments.table("source")
    file = known_file(session.machine.core.code, asked)
    if (path := asked.text("path", "")) and file in session.library.files:
        adapter.paths[file] = path
    rows = arguments.tables("breakpoints")
    if not rows:
        rows = [Arguments({"line": line}) for line in arguments.sequence("lines", [])]
    points = [_point(row, f"{file}:{adapter.line_in(row.number('line'))}") for row in rows]
    return _placed(adapter, f"source:{file}", points)


def set_function_breakpoints(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Place breakpoints at the calls of programs."""
    rows = arguments.tables("breakpoints")
    points = [_point(row, f"call {row.text('name').strip()}") for row in rows]
    return _placed(adapter, "function", points)


def set_data_breakpoints(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Place breakpoints at what `dataBreakpointInfo` named."""
    return _placed(adapter, "data", [_data_point(row) for row in arguments.tables("breakpoints")])


def _data_point(row: Arguments) -> PausePoint:
    at, _, call = row.text("dataId").partition(_CALL)
    point = _point(row, at, int(call) if call.lstrip("-").isdecimal() else None)
    if at.startswith("passes ") and len(at.split()) == 2:
        # The value that the axis passes is what the client asks for as a condition.
        return PausePoint(f"{at} {point.when or ''}".strip(), None, point.hits)
    return point


_CALL = "@call "


def _point(row: Arguments, at: str, call: int | None = None) -> PausePoint:
    return PausePoint(
        at,
        row.text("condition", None) or None,
        row.text("hitCondition", None) or None,
        row.text("logMessage", None) or None,
        call,
    )


def _placed(adapter: Adapter, name: str, points: list[PausePoint]) -> dict[str, Any]:
    assert adapter.launch is not None
    if not adapter.launch.debug:
        return {"breakpoints": [{"verified": False, "message": "noDebug"} for _ in points]}
    placed = adapter.running().set_points(name, points)
    return {"breakpoints": [breakpoint_body(adapter, each) for each in placed]}


def breakpoint_body(adapter: Adapter, placed: PlacedPoint) -> dict[str, Any]:
    body: dict[str, Any] = {"id": placed.id, "verified": not placed.refused}
    if placed.refused or placed.moved:
        body["message"] = placed.refused or placed.moved
    if placed.block is not None:
        body["source"] = source_of(adapter, placed.block.program)
        body["line"] = adapter.line_out(placed.block.line)
    return body


def set_exception_breakpoints(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Choose the alarms that pause: all, or those of some numbers and causes."""
    session = adapter.running()
    control = session.library.control
    known = {entry.number for entry in control.alarms.values()} | set(control.alarms)
    names: set[str] = set()
    rows: list[dict[str, Any]] = []
    every = False
    filters = [Arguments({"filterId": each}) for each in arguments.sequence("filters", [])]
    for row in (*filters, *arguments.tables("filterOptions")):
        if (filter_id := row.text("filterId")) != "alarm":
            rows.append({"verified": False, "message": f"there is no filter {filter_id[:60]!r}"})
            continue
        asked = [name.strip() for name in (row.text("condition", None) or "").split(",")]
        asked = [name for name in asked if name]
        wrong = [name for name in asked if name not in known]
        every = every or not asked
        names.update(asked)
        told = f"{control.name} has no alarm {', '.join(wrong)}" if wrong else ""
        rows.append({"verified": not wrong, **({"message": told} if told else {})})
    session.pauses_at_alarm = lambda number, cause: every or number in names or cause in names
    return {"breakpoints": rows}


def data_breakpoint_info(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Tell how a value is named for `setDataBreakpoints`."""
    session, name = adapter.running(), arguments.text("name")
    reference = arguments.number("variablesReference", 0)
    held = held_by(adapter, reference) if reference else None
    value = None if held is None else held.named(name)
    expression = value.expression if value is not None else name.strip()
    if expression in session.machine.modal and (held is None or value is not None):
        return _info(f"mode {expression}", f"the mode {expression} changes")
    if expression.upper() in session.machine.position:
        axis = expression.upper()
        told = f"{axis} passes the value that the condition gives, such as -5"
        return _info(f"passes {axis}", told)
    if is_state_name(session.machine.core, expression):
        return {"dataId": None, "description": f"{expression} is no value that is watched"}
    if expression.split(" ")[0] in ("changes", "passes", "mode"):
        at = expression
    else:
        at = f"changes {expression}"
    call = None if held is None else held.call
    placed = session.points.tried(PausePoint(at))
    if placed.refused:
        return {"dataId": None, "description": placed.refused}
    return _info(at if call is None else f"{at}{_CALL}{call}", f"{expression} changes")


def _info(data_id: str, told: str) -> dict[str, Any]:
    return {"dataId": data_id, "description": told, "accessTypes": ["write"], "canPersist": False}


def breakpoint_locations(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Answer with the lines between two that have blocks."""
    code = adapter.running().library.code
    first = adapter.line_in(arguments.number("line"))
    last = adapter.line_in(arguments.number("endLine", adapter.line_out(first)))
    last = min(last, first + _MOST_LOCATIONS)
    file = known_file(code, arguments.table("source"))
    lines = {
        block.line
        for program in programs_of(code, file)
        for block in blocks_between(program, first, last)
    }
    return {"breakpoints": [{"line": adapter.line_out(line)} for line in sorted(lines)]}
