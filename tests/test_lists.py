"""A code of a control's own list is never refused with the control's number."""

from __future__ import annotations

import pytest

import cncsub

MACHINES = ("mill", "lathe-a", "lathe-b")
# Codes that are read before their moves are asked for: calls and their ends.
CALLS = {"65", "66", "66.1", "67"}


def codes(control: cncsub.Control) -> list[str]:
    return str(next(rule.value for rule in control.rules if rule.name == "g_codes")).split()


def stopped(control: cncsub.Control, machine: str, code: str) -> cncsub.Alarm | None:
    text = f"O1\nN10 G{code}\nN20 M30\n"
    return cncsub.loads(text, control=control).run(setup=cncsub.Setup(machine=machine)).alarm


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("name", list(cncsub.controls))
def test_a_listed_code_is_run_or_not_computed_here(name: str, machine: str) -> None:
    control = cncsub.controls[name]
    refused = []
    for code in codes(control):
        alarm = stopped(control, machine, code)
        if alarm is not None and alarm.cause in ("g-code-not-available", "code-not-known"):
            refused.append(code)
        if alarm is not None and alarm.cause == "code-not-computed":
            assert alarm.number is None
    assert refused == []


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("name", list(cncsub.controls))
def test_a_code_outside_the_list_is_refused_or_not_known(name: str, machine: str) -> None:
    control = cncsub.controls[name]
    complete = next(rule.value for rule in control.rules if rule.name == "g_codes_complete")
    listed = set(codes(control)) | CALLS
    none = {"10", "15", "16", "31", "45", "46", "47", "48", "96"} if name == "hnc-21m" else set()
    every = {f"{tenths / 10:g}" for tenths in range(1000)} - listed
    entry = control.alarms.get("g-code-not-available")
    for code in sorted(every, key=float):
        alarm = stopped(control, machine, code)
        assert alarm is not None, code
        if complete or code in none:
            assert alarm.cause == "g-code-not-available", code
            assert alarm.number == (entry.number if entry else None)
        else:
            assert (alarm.cause, alarm.number) == ("code-not-known", None), code
