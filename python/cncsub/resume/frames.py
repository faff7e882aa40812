"""What lies between the words of a restart's head and the machine: rotation, scaling, mirror image,
polar coordinates and shifts, as the run has them.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from cncsub.resume.draft import BENDING, PLANES, REACHED, Draft, coordinate, stands_at

if TYPE_CHECKING:
    from cncsub.machine import Machine


def bend(draft: Draft) -> None:
    """Bend the path as the run does: rotation, scaling, mirror image and frames, by the blocks
    of the run that did so.
    """
    for name in BENDING:
        if name == "polar" or name not in draft.state.modal or not draft.used(name):
            continue
        found = draft.before.block_that_changed(name)
        asked = partial(_has_code_of, draft, name)
        for step in draft.before.steps_with(found[1] if found else 0, asked):
            draft.add_where(lambda _: True, *draft.before.flat_text(step))
    _bend_by_frame(draft)


def _bend_by_frame(draft: Draft) -> None:
    """Make the frame of the program as the run has made it; where that gives another one, as after
    a return that has restored it, by its value.
    """
    before = draft.lines, draft.now
    for step in draft.before.frame_steps():
        draft.add_where(lambda _: True, *draft.before.flat_text(step))
    if _frames_apart(draft, "program"):
        draft.lines, draft.now = before
        write_frames(draft, "program")


def write_frames(draft: Draft, *roles: str) -> None:
    """Give the frames of the control of these roles, as variables, the values that they have in the
    run.
    """
    for name in _frames_apart(draft, *roles):
        _, value = draft.frames[name]
        if value is None or not draft.add(f"{name}={value}"):
            draft.lacks.append(f"{name} cannot be given the frame that it has")


def _frames_apart(draft: Draft, *roles: str) -> list[str]:
    """Return the frames of the control of these roles that are not as the run has them."""
    here = draft.now.core.control_frames if draft.frames else {}
    return [name for name, of in draft.frames.items() if of[0] in roles and here.get(name) != of]


def _has_code_of(draft: Draft, group: str, block: Any) -> bool:
    return any(draft.is_of_group(word, group) for word in block.words)


def polar(draft: Draft) -> None:
    """Put polar coordinates in force, with the last radius and angle of the run."""
    if "polar" not in draft.state.modal or not draft.used("polar"):
        return
    found = draft.before.block_that_changed("polar")
    if found is None:
        return
    begins, *lines = draft.before.flat_text(found[1], draft.state.step) or [""]
    of_plane = PLANES.get(draft.state.modal.get("plane", ""), "")
    kept = {w.address: w.text for line in lines for w in draft.words(line)}
    if not len(draft.machine.moves):
        draft.add_where(lambda _: True, begins)
        return
    words = " ".join(kept[axis] for axis in of_plane if axis in kept)
    aim = {axis: coordinate(draft.machine.moves[-1], axis) for axis in of_plane}
    if draft.add_where(lambda _: True, begins) and words:
        draft.add_where(lambda _: stands_at(draft.now, aim, REACHED), f"G00 {words}")


def shift_first(draft: Draft) -> set[str]:
    """Write where the tool stands, as the run has done, where only that gives axes a place. Return
    these axes.
    """
    starts = draft.starts
    axes = [a for a in draft.state.position if starts.says_where(a)]
    if not axes:
        return set()
    words = " ".join(f"{axis}{draft.text(axis, starts.start_in_work(axis))}" for axis in axes)
    for code in (92, 50):
        line = f"G{code} {words}"
        if draft.writes(code) and draft.add_where(
            lambda _: all(
                abs(draft.now.position[a] - starts.start_in_work(a)) < draft.near for a in axes
            ),
            line,
        ):
            draft.note(f"start it where the program starts: {line} says where the tool stands")
            return set(axes)
    return set()


def shift(draft: Draft) -> None:
    """Put the shift of the work coordinates in force that the program has set."""
    wanted = draft.state.position
    here = draft.now.position
    off = {axis: here[axis] - wanted[axis] for axis in wanted if axis in here}
    if all(abs(each) < draft.near for each in off.values()) or draft.used("rotation"):
        return
    shifted = [axis for axis, value in off.items() if abs(value) > draft.near]
    by = " ".join(f"{axis}{draft.text(axis, off[axis])}" for axis in shifted)
    to = " ".join(f"{axis}{draft.text(axis, wanted[axis])}" for axis in shifted)
    used = [code for code in (52, 92, 50) if draft.writes(code)]
    for code in used:
        if _shifts(draft, f"G{code} {by if code == 52 else to}"):
            return
    _shifts(draft, f"TRANS {by}")


def _shifts(draft: Draft, line: str) -> bool:
    wanted = draft.state.position

    def right(before: Machine) -> bool:
        here = draft.now.position
        unmoved = len(draft.now.moves) == len(before.moves)
        return unmoved and all(abs(here[axis] - wanted[axis]) < draft.near for axis in wanted)

    return draft.add_where(right, line)
