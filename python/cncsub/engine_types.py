"""The words of `help()` and the pages of notebooks for the types that the engine makes: the engine
knows neither.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from cncsub import _core

_ALARM = """What stopped a program on its control: a value, never parsed out of a message.

`str(alarm)` is the message for people, with the marked word and the blocks that called.

>>> import cncsub
>>> alarm = cncsub.loads("O1\\nN10 M98 P2\\n", control="fanuc-0i-f").run().alarm
>>> alarm.cause, alarm.number, alarm.program, alarm.n, alarm.word
('program-not-found', 'PS0076', 'O1', 10, 'P2')
"""
_FRAME = """An open call: the block that called, and the pass it is in.

>>> import cncsub
>>> text = "O1\\nN10 M98 P2 L3\\nO2\\nN20 M98 P9\\n"
>>> (frame,) = cncsub.loads(text, control="fanuc-0i-f").run().alarm.frames
>>> frame.program, frame.n, frame.called, frame.repeat, frame.repeats
('O1', 10, 'O2', 1, 3)
"""
_CONTROL = """One model of CNC: its rules, parameters and alarm list, each with its source.

>>> import cncsub
>>> control = cncsub.controls["fanuc-0i-f"].with_parameters({"6005#0": 1})
>>> control.title, control.parameters["6005#0"].value
('FANUC Series 0i-F', 1.0)
"""

_DOCS: Mapping[type, tuple[str, Mapping[str, str]]] = {
    _core.Alarm: (
        _ALARM,
        {
            "cause": "What happened, as a slug: a key of `cncsub.causes`.",
            "number": "The control's own number, `None` where no source gives one.",
            "text": "The control's own text, `None` where no source gives one.",
            "program": "The program whose block stopped.",
            "n": "The sequence number of the block, `None` where it has none.",
            "line": "The line of the file, from 1.",
            "column": "The column of the word, from 1.",
            "word": "The word as it is written.",
            "file": "The file of the program.",
            "detail": "What is wrong, with its values.",
            "frames": "The open calls, the innermost first: a tuple of `Frame`.",
        },
    ),
    _core.Frame: (
        _FRAME,
        {
            "program": "The program that called.",
            "n": "The sequence number of the block that called, `None` where it has none.",
            "line": "The line of that block, from 1.",
            "file": "The file of the program that called.",
            "kind": "The code that called, such as `M98`.",
            "called": "The program that was called.",
            "repeat": "The pass it is in, from 1.",
            "repeats": "How many passes were asked for.",
        },
    ),
    _core.Control: (
        _CONTROL,
        {
            "name": "The key in `cncsub.controls`; of a changed control also the changes.",
            "title": "The name for people.",
            "dialect": "The language of its programs, such as `iso`, `linuxcnc` or `okuma`.",
            "base": "The built-in control that it was made from: a key of `cncsub.controls`.",
            "rules": "How it answers each question, a tuple of rules with their sources.",
            "parameters": "Its settings by name, such as `6005#0`, with what they mean.",
            "alarms": "Cause to number and text.",
            "precision": "How exactly it reads a number, relative to it; 0: in 64 bits.",
        },
    ),
}


_REPR_HTML = "_repr_html_"


def tell_engine_types() -> None:
    """Give the types their words, and notebooks their pages."""
    for kind, (doc, properties) in _DOCS.items():
        kind.__doc__ = doc
        for name, words in properties.items():
            getattr(kind, name).__doc__ = words
    for kind, page in ((_core.Alarm, "alarm"), (_core.Frame, "frame"), (_core.Control, "control")):
        setattr(kind, _REPR_HTML, _page(page))


def _page(name: str) -> Any:
    def _repr_html_(self: Any) -> str:
        from cncsub import notebook_values  # not imported before a notebook asks

        html: str = getattr(notebook_values, f"{name}_html")(self)
        return html

    return _repr_html_
