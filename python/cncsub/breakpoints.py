"""Breakpoints: where a machine pauses, and after which events."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from cncsub import _core
from cncsub.controls import did_you_mean
from cncsub.files import one_line
from cncsub.inputs import is_whole
from cncsub.program import Block, block_at, find_program, place_of_program
from cncsub.setup import AXES

_FORMS = (
    "'O2:N30' (program and sequence number), 'job.nc:12' (file or program and line), 'call',"
    " 'call O2', 'return', 'return O2', 'alarm', 'alarm 078', 'M6', 'T3', 'M', 'T',"
    " 'changes #100', 'passes Z -5', 'mode' or 'mode distance'"
)

At = Block | tuple[str | int, int] | str


@dataclass(frozen=True, slots=True)
class Breakpoint:
    """A place before which a machine pauses, or an event after whose block it does.

    `at` is a `Block`, a program and a sequence number such as `("O2", 30)`, or a text:

    | text | pauses |
    | --- | --- |
    | `"O2:N30"` | before the blocks N30 of the program O2 |
    | `"job.nc:12"`, `"O2:12"` | before the block on line 12 of the file, which lies in O2 |
    | `"call"`, `"call O2"` | after a call, at the first block of what was called |
    | `"return"`, `"return O2"` | after a program was left, at the block of the caller |
    | `"alarm"`, `"alarm 078"` | at an alarm, by its number or its cause |
    | `"M6"`, `"T3"`, `"S500"`, `"M"` | after a block that sent the code, or any M code |
    | `"changes #100"` | after a block that changed the value of an expression, or gave it one |
    | `"passes Z -5"` | after a block whose moves end beyond Z-5 (mm) or at it, from either side |
    | `"mode distance"`, `"mode"` | after a block that changed the code of a group of `modal` |

    `when` is an expression in the language of the control, read by its reader: the breakpoint
    counts only where it holds. `hits`: it pauses from the so manieth time on that it is met.
    Locals such as `#1` in `changes` are those of the level that is open when the machine runs on.

    Raises `TypeError` and `ValueError` for what is none of these. Whether the program, the block
    and the expression exist is seen when a machine runs to it.

    >>> import cncsub
    >>> text = "O1\\nN10 #100=0\\nN20 #100=#100+1\\nN30 IF[#100 LT 9]GOTO20\\nN40 M30\\n"
    >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
    >>> machine.run(until=cncsub.Breakpoint("O1:N20", when="#100 EQ 4"))
    >>> machine.variables[100], machine.next.n
    (4.0, 20)
    """

    at: At
    when: str | None = None
    hits: int = 1

    def __post_init__(self) -> None:
        if not isinstance(self.at, Block | str) and not _is_place(self.at):
            raise wrong_place(self.at)
        if self.when is not None and not isinstance(self.when, str):
            raise TypeError(f"when must be an expression such as '#100 GT 3', not {self.when!r}")
        if isinstance(self.hits, bool) or not isinstance(self.hits, int):
            raise TypeError(f"hits must be a whole number from 1 on, not {self.hits!r}")
        if not 1 <= self.hits < 2**31:
            raise ValueError(f"hits must be 1 to {2**31 - 1}, not {self.hits}")


def wrong_place(given: object, what: str = "until") -> TypeError:
    return TypeError(
        f"{what} must be a Block, a program and a sequence number such as ('O2', 30), a number of"
        f" open calls, a Breakpoint or several, or a text such as {_FORMS}; not {given!r}"
    )


def _is_place(given: object) -> bool:
    return (
        isinstance(given, tuple)
        and len(given) == 2
        and isinstance(given[0], str | int)
        and not isinstance(given[0], bool)
        and is_whole(given[1])
    )


class Compiled:
    """Breakpoints as the engine takes them, with the expressions that they name."""

    def __init__(self, core: _core.Machine, given: Iterable[Breakpoint]) -> None:
        self._core = core
        self._texts: list[tuple[str, int]] = []
        self._what: list[str] = []
        self.rows = [self._row(each) for each in given]
        self.expressions = compiled(core, self._texts, self._what)

    def run(self, depths: Iterable[int] = ()) -> tuple[list[int], tuple[int, str] | None, bool]:
        """Run the machine to one of the breakpoints, or until no more than so many calls are open.
        Return which were reached, the depths after the breakpoints; the one that has no value here,
        and why; and whether `pause` stopped it.
        """
        rows = [*self.rows, *({"kind": "depth", "number": depth} for depth in depths)]
        return self._core.run_to(rows, self.expressions)

    def last_met(self) -> int | None:
        """Return the last step before this at which one was met, -1 for none, and `None` where
        `pause` stopped the search.
        """
        return self._core.last_met(self.rows, self.expressions)

    def _row(self, of: Breakpoint) -> dict[str, Any]:
        row = self._event(of.at) if isinstance(of.at, str) else self._place(of.at)
        if of.when is not None:
            blocks = row.get("blocks")
            row["condition"] = self._expression(of.when, "when", blocks[0] if blocks else None)
        row["hits"] = of.hits
        return row

    def _expression(self, text: str, what: str, block: int | None = None) -> int:
        address = self._core.address if block is None else block
        self._texts.append((text, self._core.code.place_of(address)[0]))
        self._what.append(what)
        return len(self._texts) - 1

    def _place(self, at: Block | tuple[str | int, int]) -> dict[str, Any]:
        if isinstance(at, Block):
            if not self._core.has_run(at.program.data.code):
                raise ValueError(f"{at!r} is a block of another library")
            return self._blocks(at.program.index, line=at.line)
        return self._numbered(at[0], int(at[1]))

    def _blocks(self, program: int, n: int = -1, line: int = -1) -> dict[str, Any]:
        return {"kind": "block", "blocks": self._core.blocks_at(program, n, line)}

    def _numbered(self, name: str | int, n: int) -> dict[str, Any]:
        index = place_of_program(self._core.code, name)
        row = self._blocks(index, n=n if 0 <= n < 2**31 else 2**31)
        if not row["blocks"]:
            program = self._core.code.program(index)
            every = (program.block(i)[0] for i in range(program.blocks))
            numbers = {number for number in every if number is not None}
            nearest = sorted(numbers, key=lambda number: (abs(number - n), number))[:3]
            near = ", ".join(f"N{number}" for number in sorted(nearest))
            cure = f"; near it are {near}" if near else ": give a line, such as 'job.nc:12'"
            raise KeyError(f"no block N{n} in {program.name}{cure}")
        return row

    def _event(self, text: str) -> dict[str, Any]:
        word, _, rest = one_line(text).strip().partition(" ")
        rest = rest.strip()
        if word in ("call", "return"):
            called = place_of_program(self._core.code, rest, of_control=True) if rest else -1
            return {"kind": word, "number": called}
        if word == "alarm":
            return {"kind": word, "name": self._alarm(rest)}
        if word == "changes" and rest:
            return {"kind": "value", "expression": self._expression(rest, "changes")}
        if word == "passes":
            return self._axis(rest)
        if word == "mode":
            if rest and rest not in (modes := _core.mode_names()):
                raise ValueError(f"no mode is called {rest!r}; there are {', '.join(modes)}")
            return {"kind": word, "name": rest}
        if code := re.fullmatch(r"([MTS])(\d{0,9})", text.strip()):
            return {"kind": "code", "letter": code[1], "number": int(code[2] or -1)}
        name, colon, place = text.strip().rpartition(":")
        if not colon or not re.fullmatch(r"[Nn]?\d{1,15}", place):
            raise ValueError(f"{text!r} is no breakpoint: it must be such as {_FORMS}")
        if place[0] in "Nn":
            return self._numbered(name, int(place[1:]))
        return self._on_line(name, int(place))

    def _axis(self, text: str) -> dict[str, Any]:
        axis, _, value = text.partition(" ")
        try:
            if len(axis) == 1 and axis.upper() in AXES and math.isfinite(float(value)):
                return {"kind": "axis", "letter": axis.upper(), "value": float(value)}
        except ValueError:
            pass
        raise ValueError(f"'passes {text}' must name an axis and a value in mm: 'passes Z -5'")

    def _alarm(self, name: str) -> str:
        control = self._core.code.control
        known = {slug: alarm.number for slug, alarm in control.alarms.items()}
        if name and name not in known and name not in known.values():
            near = did_you_mean(name, [*known, *(n for n in known.values() if n)])
            raise ValueError(f"{control.name} has no alarm {name}{near}")
        return name

    @cached_property
    def _programs_of_files(self) -> dict[str, list[int]]:
        """The places of the programs of each file: many breakpoints of many programs ask for it."""
        code = self._core.code
        found: dict[str, list[int]] = {}
        for place in range(len(code)):
            found.setdefault(code.program(place).file, []).append(place)
        return found

    def _on_line(self, name: str, line: int) -> dict[str, Any]:
        """Return the blocks on a line of a file, or of a program."""
        code, files = self._core.code, self._programs_of_files
        ending = (of for file, of in files.items() if file.rpartition("/")[2] == name)
        found = files.get(name) or sorted(itertools.chain.from_iterable(ending))
        index = -1
        if not found:
            index = find_program(code, name)
            if index < 0:
                names = [*code.names(), *files]
                raise KeyError(f"no file and no program {name}{did_you_mean(name, names)}")
            found = self._parts_of(index)
        blocks = [block for i in found for block in self._core.blocks_at(i, -1, line)]
        if not blocks:
            if index >= 0:
                self._refuse_other_program(index, line)
            programs = map(code.program, found)
            lines = sorted(p.block(i)[1] for p in programs for i in range(p.blocks))
            before = max((each for each in lines if each < line), default=None)
            after = min((each for each in lines if each > line), default=None)
            near = " and ".join(str(each) for each in (before, after) if each is not None)
            cure = f"; the nearest have lines {near}" if near else ""
            raise KeyError(f"no block on line {line} of {name}{cure}")
        return {"kind": "block", "blocks": blocks}

    def _parts_of(self, index: int) -> list[int]:
        """Return a program with the subprograms that are defined inside of its text."""
        program = self._core.code.program(index)
        _, first, end = program.span
        parts = [index]
        for place in self._programs_of_files[program.file]:
            other = self._core.code.program(place)
            if other.inside and place != index and first <= other.span[1] < end:
                parts.append(place)
        return parts

    def _refuse_other_program(self, index: int, line: int) -> None:
        """Raise `KeyError` where a line of the file of a program lies in another program."""
        code = self._core.code
        program = code.program(index)
        for place in self._programs_of_files[program.file]:
            if self._core.blocks_at(place, -1, line):
                other = code.program(place).name
                raise KeyError(
                    f"line {line} of {program.file} lies in {other}, not in {program.name}: give"
                    f" {other}:{line}, or {program.file}:{line}"
                )


def blocks_of(core: _core.Machine, breakpoint: Breakpoint) -> list[int]:
    """Return where the blocks of a breakpoint are, none where it is an event. Raises what is wrong
    with it, as `Machine.run` does.
    """
    found: list[int] = Compiled(core, [breakpoint]).rows[0].get("blocks", [])
    return found


def addresses_of(core: _core.Machine, at: At) -> list[int]:
    """Return where the blocks of a place are. Raises `TypeError` and `ValueError` for what is no
    place, and `KeyError` for a program, a block or a line that is not there.
    """
    if not isinstance(at, Block | str) and not _is_place(at):
        raise TypeError(
            "a block is given as a Block, a program and a sequence number such as ('O2', 30), or a"
            f" text such as 'O2:N30' or 'job.nc:12'; not as {at!r}"
        )
    found = blocks_of(core, Breakpoint(at))
    if not found:
        raise ValueError(f"{at!r} is an event; a block is given as 'O2:N30' or 'job.nc:12'")
    if isinstance(at, Block):
        found = [a for a in found if block_at(core.code, a) == at] or found
    return found


def compiled(
    core: _core.Machine, texts: list[tuple[str, int]], what: list[str]
) -> _core.Machine.Expressions:
    """Compile expressions of the control's language; a `ValueError` says which is none, and why."""
    cleaned = [(one_line(text), program) for text, program in texts]
    expressions, faults = core.expressions(cleaned)
    for (text, _), name, fault in zip(cleaned, what, faults, strict=True):
        if fault is not None:
            detail, column, width = fault
            caret = " " * (column - 1) + "^" * max(1, min(width, len(text) - column + 1))
            raise ValueError(
                f"{name}: {detail or 'this is no expression'}, on {core.code.control.name}\n"
                f"  {text}\n  {caret}"
            )
    for is_number, name, (text, _) in zip(expressions.are_numbers, what, cleaned, strict=True):
        if name == "when" and not is_number:
            raise ValueError(f"when: a condition is a number, and the value of {text!r} is none")
    return expressions


def as_breakpoints(given: object, what: str = "until") -> list[Breakpoint]:
    """Return what `until` and `to` may give as a list: one breakpoint or place, or several."""
    if isinstance(given, Breakpoint):
        return [given]
    if isinstance(given, Block | str) or _is_place(given):
        return [Breakpoint(given)]  # type: ignore[arg-type]
    if isinstance(given, Iterable) and not isinstance(given, Mapping | bytes):
        return [one for each in given for one in _one_breakpoint(each, what)]
    raise wrong_place(given, what)


def _one_breakpoint(given: object, what: str) -> list[Breakpoint]:
    if isinstance(given, Iterable) and not isinstance(given, str | tuple):
        raise wrong_place(given, what)
    return as_breakpoints(given, what)
