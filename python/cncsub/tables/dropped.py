"""Words that a control dropped, with a warning where it matters."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from cncsub._core import Control
from cncsub.program import words_of
from cncsub.tables.rows import Dropped

Row = tuple[int, str, int | None, int, str, str]  # of the engine

_SPINDLE = re.compile(r"M0*(\d+)=spindle-(?:forward|backward)")
_COOLANT = (7, 8)  # as ISO 6983 numbers them: to a control they are codes as any other


def dropped_words(rows: Iterable[Row], control: Control) -> Iterator[Dropped]:
    """Yield the rows of the engine. An M code that would start the spindle or the coolant warns,
    and a tool called by a name that nothing gives.
    """
    starts: dict[float | None, str] | None = None
    for row in rows:
        words = words_of(control, row[-1])
        warning = None
        if words and words[0].address == "M":
            starts = _starts(control) if starts is None else starts
            warning = starts.get(words[0].value)
        elif words and words[0].value is None and words[0].address.rstrip("0123456789") == "T":
            warning = "no tool of the setup has this name: give it as `name` under its `tools`"
        yield Dropped(*row, warning=warning)


def _starts(control: Control) -> dict[float | None, str]:
    """Return by M code what is said where it is dropped; by None where it is computed."""
    rules = {rule.name: rule.value for rule in control.rules}
    if "m_codes_per_block" not in rules:  # an M code of another spindle
        return {}
    allows = _allows(control, rules["m_codes_per_block"])
    spindle = dict.fromkeys(map(int, _SPINDLE.findall(str(rules["roles"]))), "spindle")
    what = {**dict.fromkeys(_COOLANT, "coolant"), **spindle}
    told: dict[float | None, str] = {None: f"it may start the spindle or the coolant: {allows}"}
    return told | {code: f"it would start the {name}: {allows}" for code, name in what.items()}


def _allows(control: Control, most: object) -> str:
    """Return how a block may have more M codes."""
    apart = "write it in a block of its own"
    for name, parameter in control.parameters.items():
        if "m_codes_per_block" in parameter.rules and not parameter.value:
            return f"--param {name}=1 lets the control execute more M codes of a block, or {apart}"
    count = "one M code" if most == 1 else f"{most} M codes"
    return f"the control executes {count} of a block, {apart}"
