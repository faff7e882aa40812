"""The rows of the tables of a run, as small objects."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar

from cncsub.number_text import number_text

if TYPE_CHECKING:
    from cncsub import _core
    from cncsub.program import Block


@dataclass(frozen=True, slots=True)
class Dropped:
    """A word that the control read and ignored, as it is written; a G code by its name.
    `warning`: what does not happen because of that, and what to do; `None` if nothing depends on
    the word.
    """

    step: int
    program: str
    n: int | None
    line: int
    file: str
    text: str
    warning: str | None = None


class _Placed:
    """A row that knows its block, and looks it up when asked."""

    __slots__ = ("_address", "_code", "_text")
    _code: _core.Code | None  # set by the engine
    _address: int
    _text: str  # the text, where the row came without its block
    _of_engine: ClassVar[tuple[str, ...]]  # the fields that the engine sets, in its order


@dataclass(frozen=True, slots=True)
class Step(_Placed):
    """One executed block. `frame` is the number of its call, its row in `run.calls`; -1 in
    the main program.

    >>> import cncsub
    >>> step = cncsub.loads("O1\\nN10 G4 X1.\\nM30\\n", control="fanuc-0i-f").run().steps[0]
    >>> step.text, step.block.words[-1].value, step.block.program.name
    ('N10 G4 X1.', 1.0, 'O1')
    """

    step: int
    program: str
    n: int | None
    line: int
    depth: int
    frame: int
    repeat: int

    _of_engine: ClassVar[tuple[str, ...]] = (
        *("step", "program", "n", "line", "depth", "frame", "repeat"),
        *("_code", "_address"),
    )

    @property
    def text(self) -> str:
        """The block as it is written."""
        block = self.block
        return getattr(self, "_text", "") if block is None else block.text

    @property
    def block(self) -> Block | None:
        """The block that was executed, with its words and its program. `None` where the step came
        from another process: it travels with its text alone.
        """
        code = getattr(self, "_code", None)
        if code is None:
            return None
        from cncsub.program import block_at

        return block_at(code, self._address)

    def __getstate__(self) -> tuple[Any, ...]:
        return (*(getattr(self, name) for name in self.__match_args__), self.text)

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        for name, value in zip((*self.__match_args__, "_text"), state, strict=True):
            object.__setattr__(self, name, value)


@dataclass(frozen=True, slots=True)
class Call:
    """One entered subprogram or macro; steps are rows of `run.steps`.

    `parent` is the call it was made in, `None` for the main program; `last_step` is `None` where
    the call did not come to its end. `arguments` are the local variables it was given, by number
    or name.
    """

    call: int
    parent: int | None
    kind: str
    program: str
    start_n: int | None
    repeats: int
    level: int
    first_step: int
    last_step: int | None
    caller_step: int
    arguments: dict[int | str, float | None] = field(default_factory=dict, compare=False)


@dataclass(frozen=True, slots=True, repr=False)
class Move:
    """One motion; `run.moves.column_facts` says what each field holds. Lengths are in mm, times in
    s. What does not apply is `None`, and only what applies is printed. `program`, `n` and `line`
    are `None` where the block is no longer known.
    """

    move: int
    step: int
    kind: str
    x: float | None = None
    y: float | None = None
    z: float | None = None
    a: float | None = None
    b: float | None = None
    c: float | None = None
    u: float | None = None
    v: float | None = None
    w: float | None = None
    mx: float | None = None
    my: float | None = None
    mz: float | None = None
    ma: float | None = None
    mb: float | None = None
    mc: float | None = None
    mu: float | None = None
    mv: float | None = None
    mw: float | None = None
    cx: float | None = None
    cy: float | None = None
    cz: float | None = None
    plane: int | None = None
    feed: float | None = None
    feed_mode: str | None = None
    spindle: float | None = None
    tool: int | None = None
    h: int | None = None
    d: int | None = None
    length: float = 0.0
    time: float = 0.0
    skip: str = "no"
    program: str | None = None
    n: int | None = None
    line: int | None = None
    sx: float | None = None
    sy: float | None = None
    sz: float | None = None
    msx: float | None = None
    msy: float | None = None
    msz: float | None = None
    mcx: float | None = None
    mcy: float | None = None
    mcz: float | None = None
    cycle: bool = False
    compensated: bool = False

    def __repr__(self) -> str:
        told = ((name, getattr(self, name)) for name in self.__match_args__)
        return (
            f"Move({', '.join(f'{name}={value!r}' for name, value in told if value is not None)})"
        )


@dataclass(frozen=True, slots=True)
class SentCode:
    """A code that was sent to the machine. `kind`: `"M"`, `"T"` or `"S"`; `value`: its number, with
    a fraction where it has one. `step` is its row in `run.steps`.
    """

    kind: str
    value: float
    step: int
    program: str
    n: int | None
    line: int


@dataclass(frozen=True, slots=True)
class Change:
    """A change of a watched variable by a step; `value` is `None` where it is vacant now.

    `step`, `program`, `n` and `line` are those of the block, `None` where the variable was set from
    outside between two steps.
    """

    step: int | None
    variable: int
    value: float | None
    program: str | None
    n: int | None
    line: int | None


@dataclass(frozen=True, slots=True)
class Compared:
    """A comparison that the condition of a step made: `left operator right`, and whether it
    `holds`. A value is `None` where it is vacant. Of a condition that compares nothing, such as
    `IF[#1]`, `left` is the value and `operator` is empty.

    >>> print(Compared(7, 5.0, "LT", 5.0, False, "O1", None, 4))
    5 LT 5: false
    """

    step: int
    left: float | None
    operator: str
    right: float | None
    holds: bool
    program: str
    n: int | None
    line: int

    def __str__(self) -> str:
        compared = number_text(self.left)
        if self.operator:
            compared += f" {self.operator} {number_text(self.right)}"
        return f"{compared}: {'true' if self.holds else 'false'}"


@dataclass(frozen=True, slots=True)
class MissedSkip:
    """A block of G31 that got no skip signal. `step` is its row in `run.steps`."""

    step: int
    program: str
    n: int | None
    line: int

    def __str__(self) -> str:
        where = f"line {self.line}" if self.n is None else f"N{self.n}"
        return f"{self.program} {where} got no skip signal"


@dataclass(frozen=True, slots=True)
class Origin:
    """The origin of one block of a flat program: a block of `program`, executed in the call `call`
    (-1: the main program), in its pass `repeat`, which is the column `pass`.
    """

    program: str
    n: int | None
    line: int
    call: int
    repeat: int


# `pass` is a keyword and cannot be the name of a field.
setattr(Origin, "pass", property(lambda self: self.repeat, doc="The pass of the call, from 1."))
