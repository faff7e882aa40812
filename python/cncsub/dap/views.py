"""What a client sees of the machine while it stands: frames, scopes, values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from cncsub.dap.adapter import Adapter
from cncsub.dap.arguments import Arguments, RequestError
from cncsub.dap.sources import source_of
from cncsub.dap.stops import THREAD
from cncsub.debugging import Session, StackFrame, Value

MOST_REFERENCES = 100_000  # to scopes and arrays, at one pause


@dataclass(frozen=True)
class Held:
    """What a `variablesReference` leads to: the values of a scope or of an array, as the program of
    a frame sees them. `call` opened the level of its locals; `None` where they are none.
    """

    values: Sequence[Value]
    frame: int
    call: int | None = None
    indexed: bool = False

    def named(self, name: str) -> Value | None:
        return next((each for each in self.values if each.name == name), None)


def threads(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    name = "program"
    if adapter.session is not None and adapter.session.library.main is not None:
        name = adapter.session.library.main.name
    return {"threads": [{"id": THREAD, "name": name}]}


# ---- frames ----


def stack_trace(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    frames = adapter.running().frames()
    first = max(0, arguments.number("startFrame", 0))
    levels = arguments.number("levels", 0)
    shown = frames[first : first + levels] if levels > 0 else frames[first:]
    return {
        "stackFrames": [_frame(adapter, each) for each in shown],
        "totalFrames": len(frames),
    }


def _frame(adapter: Adapter, frame: StackFrame) -> dict[str, Any]:
    body: dict[str, Any] = {"id": adapter.frame_id(frame.index), "name": frame.title or "the end"}
    body["line"] = body["column"] = 0
    if frame.block is not None:
        program = frame.block.program
        body["source"] = source_of(adapter, program)
        body["line"] = adapter.line_out(frame.block.line)
        column = min((token.column for token in frame.block.tokens), default=1)
        body["column"] = adapter.column_out(column)
        body["endLine"] = body["line"]
        body["endColumn"] = body["column"] + len(frame.block.text)
        if program.data.system:
            body["presentationHint"] = "subtle"
    return body


def frame_of(adapter: Adapter, arguments: Arguments) -> int:
    """Return the index of the frame that a request names, the innermost where it names none."""
    asked = arguments.number("frameId", 0)
    if asked == 0:
        return 0
    if asked not in adapter.frames:
        raise RequestError(f"there is no frame {asked} at this pause")
    return adapter.frames[asked]


# ---- scopes and values ----


def scopes(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    arguments.number("frameId")
    session, frame = adapter.running(), frame_of(adapter, arguments)
    opener = session.level_opener(frame)
    rows = []
    for scope in session.scopes(frame):
        of_level = scope.name.startswith("locals") or scope.name == "named variables"
        held = Held(scope.values, frame, opener if of_level else None)
        rows.append(
            {
                "name": scope.name,
                "variablesReference": _reference(adapter, held),
                "namedVariables": len(scope.values),
                "expensive": False,
                **({"presentationHint": "locals"} if of_level else {}),
            }
        )
    return {"scopes": rows}


def _reference(adapter: Adapter, held: Held) -> int:
    if len(adapter.variables) >= MOST_REFERENCES:
        raise RequestError("this pause has given away too many references: take a step")
    adapter.variables.append(held)
    return len(adapter.variables)


def variables(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Answer with the values of a scope or an array, or with some of them."""
    held = held_by(adapter, arguments.number("variablesReference"))
    wanted = arguments.text("filter", "")
    if wanted and wanted != ("indexed" if held.indexed else "named"):
        return {"variables": []}
    first = max(0, arguments.number("start", 0))
    count = arguments.number("count", 0)
    shown = held.values[first : first + count] if count > 0 else held.values[first:]
    return {"variables": [_variable(adapter, each, held) for each in shown]}


def held_by(adapter: Adapter, reference: int) -> Held:
    """Return what a `variablesReference` of this pause leads to."""
    if not 0 < reference <= len(adapter.variables):
        raise RequestError(f"there is no variablesReference {reference} at this pause")
    held: Held = adapter.variables[reference - 1]
    return held


def _variable(adapter: Adapter, value: Value, held: Held) -> dict[str, Any]:
    body: dict[str, Any] = {
        "name": value.name,
        "value": value.text,
        "evaluateName": value.expression,
        "variablesReference": 0,
    }
    if value.parts:
        parts = Held(value.parts, held.frame, held.call, indexed=True)
        body["variablesReference"] = _reference(adapter, parts)
        body["indexedVariables"] = len(value.parts)
    if not value.can_set:
        body["presentationHint"] = {"attributes": ["readOnly"]}
    return body


# ---- setting and asking ----


def set_variable(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    held = held_by(adapter, arguments.number("variablesReference"))
    name = arguments.text("name")
    value = held.named(name)
    if value is None:
        raise RequestError(f"there is no {name!r} among these")
    text = adapter.running().set(value.expression, arguments.text("value"), held.frame)
    _invalidated(adapter)
    return {"value": text, "variablesReference": 0}


def set_expression(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    frame = frame_of(adapter, arguments)
    expression, value = arguments.text("expression"), arguments.text("value")
    text = adapter.running().set(expression, value, frame)
    _invalidated(adapter)
    return {"value": text}


def _invalidated(adapter: Adapter) -> None:
    """Have the client ask for the values again: one that was set may show in several scopes."""
    if adapter.client.get("supportsInvalidatedEvent"):
        adapter.after_answer(lambda: adapter.event("invalidated", {"areas": ["variables"]}))


def evaluate(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Answer with a value; in the console also set one, search or explain."""
    session, text = adapter.running(), arguments.text("expression").strip()
    frame, context = frame_of(adapter, arguments), arguments.text("context", "")
    if context == "hover":
        if not (told := session.hover(text, frame)):
            raise RequestError(f"nothing is known of {text[:60]!r}")
        return _result(told)
    if context == "repl":
        return _result(_command(adapter, text, frame))
    return _result(session.evaluate(text, frame))


def _result(text: str) -> dict[str, Any]:
    return {"result": text, "variablesReference": 0}


def _command(adapter: Adapter, text: str, frame: int) -> str:
    """Carry out what is typed into the console: `search NAME` tells who wrote, `explain WORD` what
    is known of it, `NAME=VALUE` sets, an expression is evaluated, and everything else is run as a
    block typed in MDI.
    """
    session = adapter.running()
    word, _, rest = text.partition(" ")
    if word == "search" and rest.strip():
        found = session.search(rest.strip())
        lines = [
            f"step {each.step}  {each.block.program.file}:{each.block.line}"
            f"  {each.block.text}  ->  {each.value}"
            for each in found
        ]
        return "\n".join(lines) or f"no block wrote {rest.strip()}"
    if word == "explain" and rest.strip():
        return session.hover(rest, frame) or f"nothing is known of {rest.strip()[:60]!r}"
    name, equals, value = text.partition("=")
    try:
        if equals and not value.startswith("=") and name[-1:] not in ("<", ">", "!"):
            told = session.set(name.strip(), value.strip(), frame)
            _invalidated(adapter)
            return told
        return session.evaluate(text, frame)
    except (KeyError, ValueError) as error:
        return _typed(adapter, text, frame, error)


def _typed(adapter: Adapter, text: str, frame: int, error: Exception) -> str:
    """Run what is no expression as a block typed in MDI; `error` says why it is none."""
    session = adapter.started_session()
    if frame:
        raise error
    try:
        session.type_in(text)
    except ValueError as refused:
        told = f"{error.args[0]}\nnor is it a block that can be run here: {refused.args[0]}"
        raise ValueError(told) from None
    adapter.after_answer(
        lambda: adapter.event("continued", {"threadId": THREAD, "allThreadsContinued": True})
    )
    adapter.move(Session.run_typed)
    return "run as typed in MDI"


def completions(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    text, frame = arguments.text("text"), frame_of(adapter, arguments)
    line = adapter.line_in(arguments.number("line", adapter.line_out(1)))
    lines = text.split("\n")
    text = lines[line - 1] if 0 < line <= len(lines) else ""
    column = adapter.column_in(arguments.number("column"))
    targets = []
    for each in adapter.running().completions(text, column, frame):
        target = {
            "label": each.text,
            "detail": each.told[:200],
            "type": {"variable": "variable", "mode": "property"}.get(each.kind, "keyword"),
            "start": each.start - 1,
            "length": max(0, min(column, len(text) + 1) - each.start),
        }
        targets.append(target)
    return {"targets": targets}
