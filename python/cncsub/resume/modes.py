"""The modes that a restart's head puts in force: before it moves, and after."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import partial
from typing import Any

from cncsub.resume.draft import BENDING, PLANES, Draft
from cncsub.resume.errors import ResumeError, place_text, refused
from cncsub.resume.frames import write_frames
from cncsub.resume.state import roles_of
from cncsub.setup import AXES

_DIGITS = 10  # of a value of `modal`: one that has as many may have more
# Modes that a head cancels before it moves, by their codes at power-on; and those that it writes.
_CANCELLED = ("radius", "cycle", *BENDING)
# Modes that an aborted run may have left otherwise: a head writes them where the run has.
_LEFT = ("surface", "return", "path", "stroke")
_WRITTEN = ("units", "plane", "feed_mode")
_WORDS = ("F", "S", "T", "H", "D")
# Modes that a block may have to say itself: where the head cannot, the proof shows whether it has.
_SOFT = ("motion", "cycle")
_N = re.compile(r"\s*(?:N\d+\s*)?", re.IGNORECASE)


def write_modes_first(draft: Draft, *, units_late: bool) -> None:
    """Write units, plane and feed mode, cancel what bends a path, and choose absolute values
    and the work offset. `units_late`: the head moves in the units of power-on.
    """
    modal = draft.state.modal
    moving = {**modal, "units": draft.power_on["units"]} if units_late else modal
    codes = [moving[name] for name in _WRITTEN if name in modal]
    codes += [
        code
        for name in _CANCELLED
        if (code := draft.power_on.get(name))
        and (name in _CANCELLED[:2] or draft.used(name) or draft.changed(name))
    ]
    if "length" in modal and not draft.used("length"):
        codes.append(modal["length"])  # of the tool before
    codes += ["G90"] if "distance" in modal else []
    for code in codes:
        _add_if_right(draft, code)
    _join(draft, codes)
    write_frames(draft, "stored", "basic")
    if "work" in modal and not draft.add(modal["work"]):
        raise refused(f"the control takes no block '{modal['work']}' here", draft.state.block)
    write_frames(draft, "settable")
    _modes_left(draft)


def _modes_left(draft: Draft) -> None:
    """Write the modes that are as at power-on at the place, but were otherwise in the run."""
    for name in _LEFT:
        code = draft.state.modal.get(name)
        if code is not None and code == draft.power_on.get(name) and draft.changed(name):
            draft.add_mode(name, [code])


def _add_if_right(draft: Draft, code: str) -> None:
    """Add a code, unless it changes a mode that is right without it: a control may count the
    feed and the surface speed as one group.
    """
    keep = [
        name
        for name, mode in draft.modal.items()
        if mode == draft.state.modal.get(name) and name != "distance" and name not in _CANCELLED
    ]
    draft.add_where(lambda before: all(draft.in_force(name) for name in keep), code)


def _join(draft: Draft, codes: list[str]) -> None:
    """Write the codes as one block, where the control takes them so with the same effect."""
    joined = draft.run([" ".join(draft.lines)])
    if joined.alarm is None and dict(joined.modal) == draft.modal:
        draft.lines = [" ".join(draft.lines)] if codes else []
        draft.now = joined


def write_modes_last(draft: Draft, *, but_motion: bool = False) -> None:
    """Put in force what the run has in force; raise `ResumeError` where that cannot be."""
    modal = draft.state.modal
    last = ("motion", "distance", "cycle")
    late = [name for name in modal if len(name) > 1 and name not in last]
    order = (*late, *_WORDS, "cycle", "distance", "motion")
    if draft.used("cycle"):  # a code of motion would end the cycle
        order = (*late, "motion", "cycle", *_WORDS, "distance")
    for name in order:
        if name not in modal or draft.in_force(name) or (but_motion and name in _SOFT):
            continue
        if not draft.add_mode(name, texts_for(draft, name)):
            lacking = _lacking(draft, name)
            if name not in _SOFT:
                raise lacking
            draft.lacks.append(lacking.reason)


def with_motion(draft: Draft, lines: Iterable[str]) -> list[str]:
    """Return blocks of which the first that moves says the code of the motion in force, as `G2 X5
    I3`, or the cycle with its data: some controls take them in no other block. Where one says
    another motion before, they stay as they are.
    """
    said, motion = list(lines), _motion_words(draft)
    for index, line in enumerate(said):
        words = list(draft.words(line))
        if any(draft.is_of_group(word, "motion") for word in words):
            break
        if any(word.address in AXES for word in words):
            own = {word.address for word in words}
            missing = [text for address, text in motion if address == "G" or address not in own]
            said[index] = _N.sub(rf"\g<0>{' '.join(missing)} ", line, count=1)
            break
    return said


def _motion_words(draft: Draft) -> list[tuple[str, str]]:
    """Return the words that a block needs to move as the run does: the code of its motion, or the
    cycle with its data; each with its address.
    """
    found = draft.before.block_that_changed("cycle") if draft.used("cycle") else None
    if found is None:
        return [("G", draft.state.modal["motion"])]
    data = _cycle_data(draft, draft.before.flat_text(found[1], draft.state.step))
    return [(word.address, word.text) for word in draft.words(data)]


def texts_for(draft: Draft, name: str) -> Iterator[str]:
    """Yield the blocks that may put a mode in force as the run has it."""
    code = draft.state.modal[name]
    found = (
        None if name in _WORDS and len(code) < _DIGITS else draft.before.block_that_changed(name)
    )
    if name in _WORDS:
        words = [] if found is None else _words_at(draft, found[1], name)
        if found is not None and not words:  # other units have changed its value
            step = draft.before.last_executed(partial(_has, name))
            words = [] if step is None else _words_at(draft, step, name)
        yield from (word.text for word in words)
        here = draft.modal.get("units", "")
        others = [unit for unit in draft.codes_of_group("units") if unit != here]
        # It may have been given in other units.
        yield from (f"{unit}\n{word.text}\n{here}" for word in words for unit in others)
        yield from (f"{name}{code}", f"{name}{code}.")
        return
    if name == "cycle" and found is not None:
        data = _cycle_data(draft, draft.before.flat_text(found[1], draft.state.step))
        lead = _rigid_before(draft, found[1])
        chosen = draft.before.block_that_changed("distance")
        if chosen is not None and chosen[1] <= found[1]:
            lead += f"{draft.state.modal['distance']} "  # its data may be increments
        yield from (f"{lead}{data} {count}" for count in ("K0", "L0"))
        return
    if name in BENDING and found is not None:
        return  # a code of these says nothing without its words
    yield code
    if found is None:
        return
    yield from draft.before.flat_text(found[1])


def _words_at(draft: Draft, step: int, address: str) -> list[Any]:
    return [word for word in draft.words_of(step) if word.address == address]


def _has(address: str, block: Any) -> bool:
    return any(word.address == address for word in block.words)


def _rigid_before(draft: Draft, step: int) -> str:
    """Return the block that made the tapping cycle of a step rigid; empty where none did."""
    roles = roles_of(draft.machine)
    moves = draft.machine.moves.step
    for code in reversed(list(draft.machine.codes)):
        if code.step > step or code.kind != "M":
            continue
        if ((moves >= code.step) & (moves < step)).any():
            return ""
        if code.value in roles.get("rigid-tapping", ()):
            words = draft.words_of(code.step)
            return " ".join(w.text for w in words if w.address in "MS") + "\n"
    return ""


def _cycle_data(draft: Draft, lines: list[str]) -> str:
    """Return the words of a cycle's blocks that stay in force, the last of each address."""
    of_place = PLANES.get(draft.state.modal.get("plane", ""), "")
    kept: dict[str, str] = {}
    for word in (word for line in lines for word in draft.words(line)):
        if word.address not in ("G", "N", "O", "K", "L", "M", "T", "S", *of_place):
            kept[word.address] = word.text
    return " ".join([draft.state.modal["cycle"], *kept.values()])


def _lacking(draft: Draft, name: str) -> ResumeError:
    code = draft.state.modal[name]
    found = draft.before.block_that_changed(name)
    shown = f"{name}{code}" if name in _WORDS else f"{code} ({name})"
    since = (
        f"; it is in force since {place_text(found[0])}: start there" if found is not None else ""
    )
    return refused(f"{shown} cannot be put in force without a move{since}", draft.state.block)
