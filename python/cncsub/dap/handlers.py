"""The requests of the protocol, each with the function that answers it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from cncsub.dap import breaks, sources, stops, views
from cncsub.dap.adapter import Adapter, Handler
from cncsub.dap.arguments import Arguments, RequestError
from cncsub.dap.launching import Launch, launch_of
from cncsub.debugging import Pause, Session

_CAN = (
    "ConfigurationDoneRequest", "FunctionBreakpoints", "ConditionalBreakpoints",
    "HitConditionalBreakpoints", "EvaluateForHovers", "StepBack", "SetVariable", "RestartFrame",
    "CompletionsRequest", "RestartRequest", "ExceptionInfoRequest", "ExceptionFilterOptions",
    "DelayedStackTraceLoading", "LoadedSourcesRequest", "LogPoints", "SetExpression",
    "TerminateRequest", "DataBreakpoints", "CancelRequest", "BreakpointLocationsRequest",
    "ClipboardContext", "GotoTargetsRequest",
)  # fmt: skip
CAPABILITIES: Mapping[str, Any] = {
    **{f"supports{name}": True for name in _CAN},
    "completionTriggerCharacters": ["#", "$"],
    "exceptionBreakpointFilters": [
        {
            "filter": "alarm",
            "label": "Alarms",
            "description": "Pause where the control stops the program with an alarm.",
            "default": True,
            "supportsCondition": True,
            "conditionDescription": "numbers or causes, such as PS0076, program-not-found",
        }
    ],
}


# ---- the session as a whole ----


def initialize(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    if adapter.initialized:
        raise RequestError("initialize comes once")
    arguments.text("adapterID")
    adapter.client = {
        **arguments.given,
        "linesStartAt1": arguments.given.get("linesStartAt1") is not False,
        "columnsStartAt1": arguments.given.get("columnsStartAt1") is not False,
    }
    adapter.initialized = True
    return dict(CAPABILITIES)


def launch(adapter: Adapter, arguments: Arguments) -> None:
    if adapter.session is not None:
        raise RequestError("a program is launched already: terminate or restart it")
    _begin(adapter, launch_of(arguments))
    adapter.after_answer(lambda: adapter.event("initialized"))


def _begin(adapter: Adapter, asked: Launch) -> None:
    """Make a session and have it tell what it writes."""
    session = adapter.make_session(asked.options, adapter.tell)
    session.output = lambda output: sources.write_output(adapter, output)
    session.progress = adapter.between
    for words in asked.unknown:
        adapter.tell(words, "important")
    adapter.session, adapter.launch, adapter.started = session, asked, False


def attach(adapter: Adapter, arguments: Arguments) -> None:
    raise RequestError("attach: nothing runs that could be attached to; use launch")


def configuration_done(adapter: Adapter, arguments: Arguments) -> None:
    if adapter.started:
        raise RequestError("configurationDone came already")
    adapter.started = True
    _run_from_head(adapter)


def _run_from_head(adapter: Adapter) -> None:
    assert adapter.launch is not None
    stops_here = adapter.launch.stop_on_entry
    adapter.move(lambda session: session.at if stops_here else session.run(here=True))


def restart(adapter: Adapter, arguments: Arguments) -> None:
    """Read the programs again and begin at the head; breakpoints stay."""
    old = adapter.running()
    asked = arguments.table("arguments", {})
    assert adapter.launch is not None
    _begin(adapter, launch_of(asked) if asked.given else adapter.launch)
    session = adapter.running()
    before = {each.id: each for each in old.points.placed}
    session.points.adopt(old.points)
    session.pauses_at_alarm = old.pauses_at_alarm
    for each in session.points.placed:
        told = breaks.breakpoint_body(adapter, each)
        if each.id not in before or told != breaks.breakpoint_body(adapter, before[each.id]):
            adapter.event("breakpoint", {"reason": "changed", "breakpoint": told})
    adapter.started = True
    _run_from_head(adapter)


def terminate(adapter: Adapter, arguments: Arguments) -> None:
    adapter.after_answer(lambda: stops.end(adapter))


def disconnect(adapter: Adapter, arguments: Arguments) -> None:
    adapter.leaving = True


def cancel(adapter: Adapter, arguments: Arguments) -> None:
    adapter.cancel(arguments.number("requestId", None), arguments.text("progressId", None))


# ---- movements ----


def _moves(movement: Callable[[Session], Pause], **more: Any) -> Handler:
    def answer(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
        _check_thread(arguments)
        session = adapter.running()
        if session.ended and movement in _FORWARDS:
            adapter.after_answer(lambda: stops.end(adapter))
        else:
            adapter.move(movement)
        return more

    return Handler(answer)


_FORWARDS = (Session.run, Session.over, Session.into, Session.out)


def _check_thread(arguments: Arguments) -> None:
    if (thread := arguments.number("threadId")) != stops.THREAD:
        raise RequestError(f"there is no thread {thread}; the program is thread {stops.THREAD}")


def restart_frame(adapter: Adapter, arguments: Arguments) -> None:
    arguments.number("frameId")
    index = views.frame_of(adapter, arguments)
    adapter.move(lambda session: session.restart_frame(index))


def goto(adapter: Adapter, arguments: Arguments) -> None:
    """Make what `gotoTargets` named the next block. Where it cannot be, this request is refused."""
    _check_thread(arguments)
    session = adapter.started_session()
    standing = session.goto(sources.target(adapter, arguments.number("targetId")))
    adapter.move(lambda session: standing)


def pause(adapter: Adapter, arguments: Arguments) -> None:
    _check_thread(arguments)
    adapter.pause()


def exception_info(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    _check_thread(arguments)
    return stops.exception_info(adapter, arguments)


def stack_trace(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    _check_thread(arguments)
    return views.stack_trace(adapter, arguments)


HANDLERS: Mapping[str, Handler] = {
    "initialize": Handler(initialize, launched=False),
    "launch": Handler(launch, launched=False),
    "attach": Handler(attach, launched=False),
    "configurationDone": Handler(configuration_done),
    "restart": Handler(restart, ends=True),
    "terminate": Handler(terminate, ends=True),
    "disconnect": Handler(disconnect, launched=False, ends=True),
    "cancel": Handler(cancel, launched=False, runs=True, at_once=True),
    "pause": Handler(pause, runs=True),
    "continue": _moves(Session.run, allThreadsContinued=True),
    "next": _moves(Session.over),
    "stepIn": _moves(Session.into),
    "stepOut": _moves(Session.out),
    "stepBack": _moves(Session.back_over),
    "reverseContinue": _moves(Session.reverse),
    "restartFrame": Handler(restart_frame),
    "gotoTargets": Handler(sources.goto_targets, runs=True),
    "goto": Handler(goto),
    "setBreakpoints": Handler(breaks.set_breakpoints, runs=True),
    "setFunctionBreakpoints": Handler(breaks.set_function_breakpoints, runs=True),
    "setDataBreakpoints": Handler(breaks.set_data_breakpoints, runs=True),
    "setExceptionBreakpoints": Handler(breaks.set_exception_breakpoints, runs=True),
    "dataBreakpointInfo": Handler(breaks.data_breakpoint_info),
    "breakpointLocations": Handler(breaks.breakpoint_locations, runs=True),
    "threads": Handler(views.threads, launched=False, runs=True),
    "stackTrace": Handler(stack_trace),
    "scopes": Handler(views.scopes),
    "variables": Handler(views.variables),
    "setVariable": Handler(views.set_variable),
    "setExpression": Handler(views.set_expression),
    "evaluate": Handler(views.evaluate),
    "completions": Handler(views.completions),
    "source": Handler(sources.source, runs=True),
    "loadedSources": Handler(sources.loaded_sources, runs=True),
    "exceptionInfo": Handler(exception_info),
}
