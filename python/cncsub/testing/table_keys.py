"""The keys of a table of cases in TOML: what each takes, means and looks like. They are checked,
documented and written as a JSON schema from here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from cncsub.controls import did_you_mean
from cncsub.testing.cases import STOPS


class Kind(NamedTuple):
    """Values that a key takes: in words, as a test, and as a JSON schema."""

    words: str
    fits: Callable[[Any], bool]
    schema: Mapping[str, Any]


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _list_of(words: str, fits: Callable[[Any], bool], schema: Mapping[str, Any]) -> Kind:
    return Kind(
        words,
        lambda value: isinstance(value, list) and all(map(fits, value)),
        {"type": "array", "items": schema},
    )


def _table_of(words: str, fits: Callable[[Any], bool], schema: Mapping[str, Any]) -> Kind:
    return Kind(
        words,
        lambda value: isinstance(value, dict) and all(map(fits, value.values())),
        {"type": "object", "additionalProperties": schema},
    )


def _is_text(value: object) -> bool:
    return isinstance(value, str)


_TEXT = {"type": "string"}
_NUMBER = {"type": "number"}
TEXT = Kind("a text", _is_text, _TEXT)
FILE = Kind("the name of a file", _is_text, _TEXT)
NUMBER = Kind("a number", _is_number, _NUMBER)
WHOLE = Kind("a whole number", _is_whole, {"type": "integer"})
SWITCH = Kind("true or false", lambda value: isinstance(value, bool), {"type": "boolean"})
TEXTS = _list_of("a list of texts", _is_text, _TEXT)
FILES = _list_of("a list of files and folders", _is_text, _TEXT)
NUMBERS = _list_of("a list of numbers", _is_number, _NUMBER)
WHOLES = _list_of("a list of whole numbers", _is_whole, {"type": "integer"})
TEXT_TABLE = _table_of("a table of texts", _is_text, _TEXT)
NUMBER_TABLE = _table_of("a table of numbers", _is_number, _NUMBER)
TABLE = Kind("a table", lambda value: isinstance(value, dict), {"type": "object"})
VARIABLES = Kind(  # its values are looked at one by one
    "a table of variables",
    TABLE.fits,
    {
        "type": "object",
        "patternProperties": {"^#?[0-9]+$": {"anyOf": [_NUMBER, {"const": "vacant"}]}},
        "additionalProperties": False,
    },
)


STOP = Kind(f"one of {', '.join(STOPS)}", lambda value: value in STOPS, {"enum": list(STOPS)})


class Key(NamedTuple):
    """A key, the kinds of values that it takes, an example in TOML, and its meaning."""

    name: str
    takes: tuple[Kind, ...]
    example: str
    meaning: str

    @property
    def words(self) -> str:
        """What it takes, in words: `a text or a list of texts`."""
        return " or ".join(kind.words for kind in self.takes)


GROUPS: dict[str, tuple[Key, ...]] = {
    "The case": (
        Key("claim", (TEXT,), '"the macro squares"', "What has to be true: the name of the test."),
        Key(
            "control",
            (TEXT, TEXTS),
            '"fanuc-0i-f"',
            "The control; the case runs on each of a list. `--control` overrides it; without"
            " both, the setting `cncsub_control` and the control of the project are used.",
        ),
        Key(
            "source",
            (TEXT, TEXT_TABLE),
            '"manual, 3.2"',
            "The source of the claim, for the report of a failure; a table gives one for each"
            " control.",
        ),
    ),
    "The memory of the control": (
        Key(
            "load",
            (FILES,),
            '["../macros", "O1.nc"]',
            "Files and folders whose programs are the memory.",
        ),
        Key("program", (TEXT,), '"O1\\nN10 M30"', "One text: a program, or several."),
        Key("files", (TEXT_TABLE,), '{"O1.nc" = "O1\\nM30"}', "Several texts, by names of files."),
        Key(
            "external",
            (TEXT_TABLE,),
            '{"O2.nc" = "O2\\nM99"}',
            "The programs on the external device, from which M198 calls, by names of files.",
        ),
        Key(
            "encoding",
            (TEXT,),
            '"gb18030"',
            "The encoding of the files; without it, it is detected.",
        ),
    ),
    "The run": (
        Key("main", (TEXT, WHOLE), '"O1"', "The program to run; without it, the main program."),
        Key("mdi", (TEXT,), '"G65 P2 A3."', "What is typed in MDI, instead of the main program."),
        Key("start", (WHOLE,), "20", "The sequence number to start at."),
        Key(
            "variables",
            (VARIABLES, FILE),
            '{500 = 1.5, 501 = "vacant"}',
            "Variables before the run: by number, or a file as `--variables` takes it.",
        ),
        Key(
            "inputs",
            (TABLE, FILE),
            '"part.toml"',
            "What the program reads from outside while it runs: a table of inputs, or a TOML"
            " file of them.",
        ),
        Key(
            "setup",
            (TABLE, FILE),
            '"setup.toml"',
            "The settings of the machine: a table of a setup, or a TOML file of it.",
        ),
        Key("params", (NUMBER_TABLE,), '{"3401#0" = 1}', "Parameters of the control."),
        Key("replace", (TABLE,), "{max_nesting = 3}", "Rules of the control."),
        Key("skip", (WHOLES,), "[1]", "The block-skip switches that are on."),
        Key("optional_stop", (SWITCH,), "true", "Whether M01 stops."),
        Key("max_cycles", (WHOLE,), "3", "How often a main program that ends in M99 runs."),
        Key("max_blocks", (WHOLE,), "1000", "The run stops with `limit` after this many blocks."),
    ),
    "The expected results": (
        Key(
            "runs",
            (TEXT,),
            '"N10 (N30 N40)*2 O2:N20"',
            "The N of all executed blocks in order, with the program if an N is in several"
            " programs."
            " Blocks without an N are not compared.",
        ),
        Key(
            "stop",
            (STOP,),
            '"waiting"',
            "How the run stops. Without this key: `alarm` where one is expected, else `end`.",
        ),
        Key(
            "alarm",
            (TEXT,),
            '"PS0076"',
            "The alarm, by its number or by its cause (`program-not-found`).",
        ),
        Key(
            "number",
            (TEXT, TEXT_TABLE),
            '"PS0076"',
            "The number of the alarm in addition to its cause; a table gives one for each control.",
        ),
        Key("at", (TEXT,), '"O2 N30"', "The program and the block that alarms."),
        Key("word", (TEXT, TEXT_TABLE), '"P9"', "The word of the block at which it alarms."),
        Key(
            "frames",
            (TEXT,),
            '"O2 N50 G65 < O1 N10 M98"',
            "The open calls at the alarm, the innermost first.",
        ),
        Key("vars", (VARIABLES,), '{100 = 9, 101 = "vacant"}', "Variables at the stop."),
        Key("m", (WHOLES,), "[3, 8]", "The M codes that were sent to the machine."),
        Key("t", (WHOLES,), "[1]", "The T codes that were sent to the machine."),
        Key("messages", (TEXTS,), '["CHECK TOOL"]', "The messages to the operator."),
        Key("dropped", (TEXTS,), '["M8"]', "The words that the control read and ignored."),
        Key("calls", (TEXT,), '"M98:O2 G65:O3"', "The calls in order."),
        Key("tree", (TEXT,), '"M98:O2(G65:O3)"', "The calls in order, each with those inside it."),
        Key("arguments", (VARIABLES,), "{1 = 3}", "The locals at the start of the first macro."),
        Key(
            "moves",
            (TEXT,),
            '"R X10 Y0\\nF Z-5\\nCW X4 Y0 C X2 Y0"',
            "A line for each move: `R` rapid, `F` feed, `T` thread, `CW` and `CCW` an arc with its"
            " centre after `C`, `W` a dwell in seconds. An axis that is not named stays.",
        ),
        Key("moves_x", (NUMBERS,), "[10, 20]", "Only the X of each move."),
        Key("centre", (TEXT,), '"X0 Y0 | X5 Y0"', "The machine position after each move."),
        Key("final_machine", (TEXT,), '"X0 Z50"', "The machine position at the stop."),
        Key("final_work", (TEXT,), '"X0 Z50"', "The work position at the stop."),
        Key("time", (NUMBER,), "1.5", "Seconds of all moves."),
        Key("vars_after_reset", (VARIABLES,), "{500 = 5}", "Variables after the reset key."),
        Key("work_after_reset", (TEXT,), '"X0"', "The work position after the reset key."),
        Key(
            "modal_after_reset",
            (TEXT_TABLE,),
            '{plane = "G17"}',
            "Modal codes after the reset key, by group.",
        ),
    ),
}
KEYS = {key.name: key for keys in GROUPS.values() for key in keys}


def check_keys(said: Mapping[str, Any]) -> None:
    """Raise `ValueError` for a key that no case has, or a value of another kind.

    >>> from cncsub.testing.table_keys import check_keys
    >>> check_keys({"runs": ["N10"]})
    Traceback (most recent call last):
    ValueError: runs must be a text, such as "N10 (N30 N40)*2 O2:N20", not ['N10']
    """
    for name, value in said.items():
        key = KEYS.get(name)
        if key is None:
            near = did_you_mean(name, KEYS, f"; there are {', '.join(KEYS)}")
            raise ValueError(f"a case has no {name!r}{near}")
        if not any(kind.fits(value) for kind in key.takes):
            shown = repr(value)
            short = shown if len(shown) <= 60 else shown[:60] + " ..."
            raise ValueError(f"{name} must be {key.words}, such as {key.example}, not {short}")


def schema() -> dict[str, Any]:
    """Return the JSON schema of a table, for editors that know TOML."""
    properties = {
        key.name: {"description": key.meaning}
        | (dict(key.takes[0].schema) if len(key.takes) == 1 else _any_of(key.takes))
        for key in KEYS.values()
    }
    above = {name: value for name, value in properties.items() if name != "claim"}
    case = {
        "type": "object",
        "required": ["claim"],
        "additionalProperties": False,
        "properties": properties,
    }
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "Cases of NC programs, *.nctest.toml",
        "type": "object",
        "required": ["case"],
        "additionalProperties": False,
        "properties": {**above, "case": {"type": "array", "items": case}},
    }


def _any_of(kinds: tuple[Kind, ...]) -> dict[str, Any]:
    return {"anyOf": [dict(kind.schema) for kind in kinds]}
