"""How the client hears that a movement is over."""

from __future__ import annotations

from typing import Any

from cncsub.dap.adapter import Adapter
from cncsub.dap.arguments import Arguments, RequestError
from cncsub.debugging import Pause, Reason
from cncsub.run import Stop

THREAD = 1  # the one program that runs
_EXITS = {Stop.ALARM: 1, Stop.WAITING: 3, Stop.LIMIT: 4}
# What the protocol calls the reasons; the others keep their names.
_REASONS = {Reason.ALARM: "exception"}
_SETS = {"function": "function breakpoint", "data": "data breakpoint"}


def tell_pause(adapter: Adapter, pause: Pause) -> None:
    """Tell where the session stands; at the end of the program that it is over, unless the client
    wants to look at it there.
    """
    assert adapter.launch is not None
    if pause.reason is Reason.END and not (adapter.launch.stop_on_end and pause.text):
        end(adapter)
        return
    session = adapter.running()
    reason = _REASONS.get(pause.reason, str(pause.reason))
    for kind, told in _SETS.items():
        if pause.breakpoints and all(
            any(each is one for one in session.points.placed_in(kind)) for each in pause.breakpoints
        ):
            reason = told
    body: dict[str, Any] = {
        "reason": reason,
        "description": pause.text.splitlines()[0] if pause.text else reason,
        "threadId": THREAD,
        "allThreadsStopped": True,
    }
    # They may be left out, and dap-python, which does not name itself, takes them for texts.
    if pause.breakpoints and adapter.client.get("clientID"):
        body["hitBreakpointIds"] = [each.id for each in pause.breakpoints]
    if pause.reason is Reason.ALARM:
        body["text"] = str(session.machine.alarm)
    adapter.event("stopped", body)


def end(adapter: Adapter) -> None:
    """Tell that the program is over, with the exit status of `cncsub run`."""
    session = adapter.running()
    if session.machine.alarm is not None:
        adapter.tell(str(session.machine.alarm), "stderr")
    stop = session.machine.stop
    adapter.session = None
    adapter.started = False
    adapter.event("exited", {"exitCode": _EXITS.get(stop, 0) if stop is not None else 0})
    adapter.event("terminated")


def exception_info(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Answer with the alarm at which the program stands."""
    alarm = adapter.running().machine.alarm
    if alarm is None:
        raise RequestError("the program does not stand at an alarm")
    wanted = adapter.running().pauses_at_alarm(alarm.number or "", alarm.cause)
    return {
        "exceptionId": alarm.number or alarm.cause,
        "description": alarm.detail or alarm.cause,
        "breakMode": "always" if wanted else "never",
        "details": {
            "message": alarm.detail,
            "typeName": alarm.cause,
            "fullTypeName": f"{alarm.number} {alarm.cause}" if alarm.number else alarm.cause,
            "stackTrace": str(alarm),
        },
    }
