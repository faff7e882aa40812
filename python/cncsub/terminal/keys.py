"""The keys of the debugger, each with what it does: the screen, its help and its page have them
from here.
"""

from __future__ import annotations

from typing import NamedTuple

from textual.binding import Binding


class Key(NamedTuple):
    """A key or several for one action. `short`: what the foot of the screen calls it, empty where
    it is not shown there.
    """

    keys: str
    action: str
    told: str
    short: str = ""


KEYS: dict[str, tuple[Key, ...]] = {
    "Forwards": (
        Key("s,f11", "move('into')", "one block; into a call", "into"),
        Key("n,f10", "move('over')", "one block, over what it calls", "over"),
        Key("o", "move('out')", "out of this program, with all its passes", "out"),
        Key("t", "move('to_return')", "to the block that leaves this program"),
        Key("c,f5", "move('run')", "run to the next breakpoint, or to the end", "run"),
        Key("g", "to_cursor", "run to the line of the cursor"),
        Key("N", "set_next", "make the line of the cursor the next one; run nothing"),
        Key("p,f6", "pause", "pause a program that runs"),
    ),
    "Back": (
        Key("u", "move('back')", "one block back", "back"),
        Key("U", "move('back_over')", "one block back, over what it called"),
        Key("l", "move('back_to_call')", "back to the block that called this program"),
        Key("r", "move('reverse')", "back to the breakpoint that was met last"),
        Key("G", "back_to_cursor", "back to where the line of the cursor ran last"),
        Key("f", "restart_frame", "back to the first block of the chosen call"),
        Key("R", "move('start')", "start again, as after power-on; breakpoints stay"),
        Key("slash", "ask('search')", "who wrote a variable, over all blocks so far; and go there",
            "search"),
    ),
    "Breakpoints": (
        Key("b,f9", "toggle_point", "a breakpoint on the line of the cursor, or none any more",
            "point"),
        Key("B", "ask('point')", "one with a condition, a count of hits, or a text to write"),
        Key("w", "ask('watch')", "pause where a variable, a mode or an axis changes (as chosen)",
            "watch"),
        Key("delete,x", "remove_point", "take the chosen breakpoint away (pane 4)"),
    ),
    "Values": (
        Key("e", "ask('evaluate')", "evaluate an expression of the control", "eval"),
        Key("equals_sign", "ask('set')", "set a variable, mode, axis or switch; so does Enter"),
        Key("m", "ask('mdi')", "type blocks as in MDI, and run them here"),
        Key("S", "ask('switches')", "block-skip switches, optional stop, signals"),
        Key("i", "tell", "what is known of the block, or of the chosen value"),
    ),
    "The screen": (
        Key("1", "pane('variables')", "variables (*: changed since the last pause)"),
        Key("2", "pane('modes')", "modes, offsets, tool, spindle, feed, switches"),
        Key("3", "pane('path')", "the path so far, and the last moves"),
        Key("4", "pane('points')", "breakpoints; Enter changes one"),
        Key("5", "pane('calls')", "the calls; Enter shows one with its locals"),
        Key("6", "pane('messages')", "messages, alarms, notes"),
        Key("0,escape", "follow", "the source, at the next block"),
        Key("O", "ask('open')", "open another program"),
        Key("d", "dark", "dark or light"),
        Key("question_mark,f1", "help", "this help", "help"),
        Key("q", "quit", "leave the debugger", "quit"),
    ),
}  # fmt: skip

_SIGNS = {
    "slash": "/", "equals_sign": "=", "question_mark": "?", "delete": "Del", "escape": "Esc",
}  # fmt: skip


def name_of(key: str) -> str:
    """Return how a key is written.

    >>> name_of("f11"), name_of("slash"), name_of("U")
    ('F11', '/', 'U')
    """
    return _SIGNS.get(key) or (key.upper() if len(key) > 1 else key)


def bindings() -> list[Binding]:
    """Return the keys as the screen takes them."""
    return [
        Binding(
            key.keys, key.action, key.short or key.told, show=bool(key.short),
            key_display=name_of(key.keys.partition(",")[0]),
        )
        for group in KEYS.values() for key in group
    ]  # fmt: skip


def help_text() -> str:
    """Return all keys with what they do, in groups, and what the marks mean."""
    lines = []
    for group, keys in KEYS.items():
        lines.append(group)
        for key in keys:
            names = " ".join(map(name_of, key.keys.split(",")))
            lines.append(f"  {names:<6} {key.told}")
        lines.append("")
    return "\n".join([*lines, *_MARKS])


_MARKS = (
    "Marks",
    "  ▶      the block that runs next        ▷  the block that called",
    "  ●      breakpoint                      ◉  with a condition or a count",
    "  ◆      writes a line                   x  refused, and why in pane 4",
    "  !      the place of an alarm           *  changed since the last pause",
    "",
    "Tab goes from pane to pane, arrows and Page keys move in one.",
)
