"""The tool in a restart's head: its change, edge and length, the spindle and the coolant."""

from __future__ import annotations

from typing import Any

from cncsub.resume.draft import Draft
from cncsub.resume.errors import refused
from cncsub.resume.state import roles_of

_CLAMPS = (50, 92)  # the G codes that set the highest speed of the spindle beside S


def change_tool(draft: Draft) -> None:
    """Call the tool of the run and change it, then the tool that the run has chosen since."""
    state = draft.state
    if state.tool is not None:
        digits = str(state.tool)
        word = f"T{'0' * (draft.lathe and len(digits) > 2 and len(digits) % 2)}{digits}"
        changes = roles_of(draft.machine).get("tool-change", ())
        used = [code for code in changes if code in draft.machine.m_codes]
        change = f" M{used[0]:02d}" if used else ""
        if not draft.add(f"{word}{change}") and not draft.add(word, change.strip()):
            raise refused(f"the control takes no block '{word}{change}' here", state.block)
    chosen = state.modal.get("T")
    if chosen is not None and draft.modal.get("T") != chosen:
        draft.add(f"T{chosen}")


def choose_edge(draft: Draft) -> None:
    """Choose the edge of the tool, where D does that: no axis may move before."""
    edge = draft.state.modal.get("D", "0")
    if "length" not in draft.power_on and draft.modal.get("D", edge) != edge:
        draft.add(f"D{edge}")


def clamp_speed(draft: Draft) -> None:
    """Write the highest speed of the spindle that the program has set last."""
    found = draft.before.last_executed(_sets_clamp)
    if found is not None:
        words = [word for line in draft.before.flat_text(found) for word in draft.words(line)]
        wanted = [w.text for w in words if w.address == "S" or w.value in _CLAMPS]
        draft.repeat([" ".join(wanted)])


def turn_spindle(draft: Draft) -> None:
    """Turn the spindle and the coolant on, as in the run."""
    state = draft.state
    speed = state.modal.get("S", "0")
    turn = f" {state.spindle}" if state.spindle else ""
    code = state.modal.get("surface")
    told = "surface" in draft.modal
    written = code and ((draft.lathe and told) or not draft.in_force("surface"))
    first = f"{code} " if written else ""
    if speed != "0" or turn:
        word = f"S{speed}" if speed != "0" else ""
        draft.add(f"{first}{word}{turn}".strip())
    for coolant in state.coolant:
        draft.add(coolant)


def put_length_in_force(draft: Draft) -> None:
    """Put the length of the tool in force before any axis moves: without it the tool would go
    too deep.
    """
    if not has_length(draft) or length_is_right(draft):
        return
    for words in length_words(draft):
        if words and draft.add_where(lambda _: length_is_right(draft), words):
            return
    raise refused(
        f"{draft.state.modal['length']} H{draft.state.modal['H']} cannot be put in force before"
        " the head moves",
        draft.state.block,
    )


def has_length(draft: Draft) -> bool:
    """Return whether the length of the tool is in force at the place."""
    return draft.used("length") and draft.state.modal.get("H", "0") != "0"


def length_words(draft: Draft) -> list[str]:
    """Return the words that may put the length of the tool in force."""
    modal = draft.state.modal
    found = draft.before.block_that_changed("length")
    lines = [] if found is None else draft.before.flat_text(found[1])
    own = (word for line in lines for word in draft.words(line))
    kept = [w.text for w in own if w.address == "H" or f"{w.text}" == modal["length"]]
    return [f"{modal['length']} H{modal['H']}", " ".join(kept)]


def length_is_right(draft: Draft) -> bool:
    """Return whether it is as the run has it."""
    return all(draft.modal.get(name) == draft.state.modal.get(name) for name in ("length", "H"))


def _sets_clamp(block: Any) -> bool:
    words = block.words
    return any(w.address == "S" for w in words) and any(
        w.address == "G" and w.value in _CLAMPS for w in words
    )
