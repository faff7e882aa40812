"""What a run executed, as one program without calls, jumps and variables."""

from __future__ import annotations

import functools
import os
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

from cncsub._core import Control
from cncsub.comparison import Pair, Parting
from cncsub.controls import control_of
from cncsub.library import Library, Options, loads
from cncsub.program import Block, Program, Word
from cncsub.rows import Step
from cncsub.run import Run, Stop
from cncsub.signatures import spelled_out
from cncsub.tables import optional_module

if TYPE_CHECKING:
    import numpy as np

_SYSTEM = 1000  # from here on a variable may be the control's own
_WITH_CALL = {"M98": "PLHQ", "M198": "PLHQ"}  # what belongs to the call and not to the block
_LEFT_OUT = {"M97", "M98", "M99", "M198", "G67"}
_INDIRECT = re.compile(r"#(?!\d)")  # #[#1], ##1, #<name>
_VARIABLE = re.compile(r"#(\d+)")
_RESULTS = range(100, 150)  # where a value is computed again
_Evaluator = Callable[[str, int], Library]
_DIGITS = (12, 3, 4)  # decimals of computed values
_NEAR = 1e-9  # s
_ORIGINS = ("program", "n", "line", "call", "pass")


class FlattenError(ValueError):
    """Raised where no flat program exists or none can be written. `.reason`; `.program`, `.n` and
    `.line` tell the block, `None` where it is no single one.
    """

    def __init__(
        self,
        reason: str,
        program: str | None = None,
        n: int | None = None,
        line: int | None = None,
    ) -> None:
        place = "" if n is None else f" N{n}"
        super().__init__(reason if program is None else f"{program}{place}, line {line}: {reason}")
        self.reason, self.program, self.n, self.line = reason, program, n, line

    def __reduce__(self) -> tuple[Any, ...]:
        return FlattenError, (self.reason, self.program, self.n, self.line)


class Origins:
    """Where the blocks of a flat program come from, a row for each in order. Columns: `program`,
    `n` (-1: none), `line`, `call` (the row of `run.calls`, -1: the main program) and `pass`.
    """

    columns = _ORIGINS

    def __init__(self, rows: list[tuple[str, int, int, int, int]]) -> None:
        self._rows = rows

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, name: str) -> np.ndarray[Any, Any]:
        import numpy as np

        if name not in _ORIGINS:
            raise KeyError(f"there is no column {name!r}; the columns are {', '.join(_ORIGINS)}")
        at = _ORIGINS.index(name)
        return np.asarray([row[at] for row in self._rows], dtype=object if at == 0 else "int64")

    def to_pandas(self) -> Any:
        """As a pandas DataFrame."""
        return optional_module("pandas").DataFrame({name: self[name] for name in _ORIGINS})

    def to_arrow(self) -> Any:
        """As an Arrow table."""
        return optional_module("pyarrow").table({name: self[name] for name in _ORIGINS})


class _FlatPair(Pair):
    """A program and its flat one: variables, calls and steps are not to be the same."""

    def _partings(self, a: Run, b: Run) -> Iterator[Parting]:
        yield from self._of_moves(a, b)
        for name in ("m_codes", "t_codes", "messages"):
            yield from self._of_list(a, b, name)
        if len(a.moves) == len(b.moves):
            apart = abs(a.moves.time - b.moves.time) > _NEAR  # dwells are time and no way
            if apart.any():
                at = int(apart.argmax())
                steps = (int(a.moves.step[at]), int(b.moves.step[at]))
                yield self._say((a, b), steps, (f"move {at}", f"move {at} of another time"))
        if a.stop != b.stop or b.alarm is not None:
            yield self._say((a, b), (len(a.steps), len(b.steps)), ("", ""))


class Flat:
    """A flat program: `text`, and `origins` with a row for each block of it."""

    def __init__(self, text: str, origins: Origins, parts: Callable[[str], Parting | None]) -> None:
        self.text = text
        self.origins = origins
        self._parts = parts

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the text to a file."""
        Path(path).write_text(self.text, encoding="utf-8", newline="")

    def verify(self) -> None:
        """Run the program and the text once more, and raise `AssertionError` with the first
        difference between the two in moves (1e-9 mm), M and T codes, messages and the stop.
        `flatten` has done so already; a text that was edited since may differ.
        """
        parting = self._parts(self.text)
        if parting is not None:
            raise AssertionError(parting.what)

    def __repr__(self) -> str:
        return f"<Flat: {len(self.origins)} blocks>"


@spelled_out(Library.run, "mode")
def flatten(
    library: Library,
    main: str | int | None = None,
    *,
    control: str | Control | None = None,
    comments: bool = False,
    **options: Unpack[Options],
) -> Flat:
    """Write what `main` executes as one program without calls, jumps and variables.

    `control`: the one that the flat program is for, the library's where it is not given.
    `comments`: the origin of each block behind it. `options` are those of `Library.run`. The flat
    program is run and compared before it is returned: moves to 1e-9 mm, M and T codes, messages and
    the stop. Raises `FlattenError` where it cannot be written or does not run alike: a run that
    does not end, a value that is an expression, a block that writes a variable of the control.

    >>> import cncsub
    >>> text = "O1\\nG90 G0\\nM98 P2 L2\\nM30\\nO2\\nX#100\\n#100=#100+5\\nM99\\n"
    >>> library = cncsub.loads(text, control="fanuc-0i-f")
    >>> print(cncsub.flatten(library, variables={100: 0}).text, end="")
    O1
    G90 G0
    X0.
    X5.
    M30
    """
    if options.get("trace", "moves") != "moves" or "watch" in options:
        raise TypeError("flatten looks at all that a run does and takes no trace and no watch")
    run = library.run(main, **options)
    if run.stop not in (Stop.END, Stop.CYCLES):
        raise _does_not_end(run)
    target = library.control if control is None else control_of(control)
    # A control rounds computed ends to its increment and cuts written ones off: which digits it
    # takes is told by what it does.
    for digits in _DIGITS:
        writer = _Writer(library, main, comments, digits)
        writer.write_all(library.machine(main, **options), run)
        flat, parting = _tried(writer, target, run, library, main, options)
        if parting is None or not writer.computed:
            break
    if parting is None:
        return flat
    step = run.steps[min(parting.first, len(run.steps) - 1)]
    reason = f"the flat program would not run alike\n{parting.what}"
    raise FlattenError(reason, step.program, step.n, step.line)


def _tried(
    writer: _Writer,
    control: Control,
    run: Run,
    library: Library,
    main: str | int | None,
    options: Options,
) -> tuple[Flat, Parting | None]:
    """The flat program, and where it parts from the run."""
    again: Options = {**options, "max_cycles": 1}
    again.pop("start", None)  # the flat program begins there

    def parts(text: str, before: Run | None = None) -> Parting | None:
        flat = loads(text, control=control)
        pair = _FlatPair((library, flat), ("program", "flat"), main, options, same_texts=False)
        other = flat.run(**again)
        if len(other.calls):
            raise FlattenError("the flat program would still call", *_place(run))
        return pair.parting(before or library.run(main, **options), other)

    text = "\n".join(writer.lines) + "\n"
    return Flat(text, Origins(writer.origins), parts), parts(text, run)


def _place(run: Run) -> tuple[str, int | None, int]:
    """The block that makes the first call, or the first block."""
    step = run.steps[run.calls[0].caller_step if len(run.calls) else 0]
    return step.program, step.n, step.line


def _does_not_end(run: Run) -> FlattenError:
    alarm = run.alarm
    if alarm is not None:
        return FlattenError(
            f"the run ends by an alarm: {alarm.number or ''} {alarm.cause}",
            alarm.program,
            alarm.n,
            alarm.line,
        )
    waits = f" for {run.waiting_for}" if run.waiting_for else ""
    return FlattenError(f"the run does not end: it stopped with {run.stop.value}{waits}")


def _evaluator_of(control: Control) -> _Evaluator:
    @functools.cache
    def read(expression: str, result: int) -> Library:
        """A program that computes the expression, read once for each."""
        return loads(f"O1\n#{result}={expression}\nM30\n", control=control)

    return read


class _Writer:
    """The lines of the flat program, and where they come from."""

    def __init__(
        self, library: Library, main: str | int | None, comments: bool, digits: int
    ) -> None:
        program = library.main if main is None else library[main]
        name = "" if program is None else program.name
        begins = program is not None and program.text.lstrip("%\r\n ").startswith(name.lstrip("%"))
        self.lines: list[str] = [name] if begins else []
        self.origins: list[tuple[str, int, int, int, int]] = []
        self._comments = comments
        self._digits = digits
        self.computed = False
        self._evaluator = _evaluator_of(library.control)
        self._blocks = _blocks_by_place(library)
        self._words: dict[tuple[str, int], tuple[Block, list[Word]]] = {}

    def write_all(self, machine: Any, run: Run) -> None:
        while True:
            level = machine._core.level  # of the block: a modal call behind it opens another one
            step = machine.step()
            if step is None:
                break
            block, kept = self._kept(step)
            if kept:
                self.note(step)
                words = [
                    self._written(word, block, machine, level) if word.value is None else word.text
                    for word in kept
                ]
                self.lines.append(" ".join(words) + self._comment(step))
        if run.stop is Stop.CYCLES:
            self.lines.append("M99")
            self.note(run.steps[len(run.steps) - 1])

    def _written(self, word: Word, block: Block, machine: Any, level: int) -> str:
        if level > machine._core.level:
            raise _refused(block, f"the value of {word.text} belongs to a call that has ended")
        self.computed = True
        value = _value(word, block, machine, level, self._evaluator)
        if word.address in "GMTSDHPL" and value == int(value):
            return f"{word.address}{int(value)}"
        return word.address + f"{value:.{self._digits}f}".rstrip("0")

    def note(self, step: Step) -> None:
        n = -1 if step.n is None else step.n
        self.origins.append((step.program, n, step.line, step.frame, step.repeat))

    def _comment(self, step: Step) -> str:
        if not self._comments:
            return ""
        return f" ({step.program}{'' if step.n is None else f' N{step.n}'} LINE {step.line})"

    def _kept(self, step: Step) -> tuple[Block, list[Word]]:
        place = (step.program, step.line)
        if place not in self._words:
            blocks = self._blocks.get(place, [])
            if len(blocks) != 1:
                reason = "it is not clear which block of the line ran"
                raise FlattenError(reason, step.program, step.n, step.line)
            self._words[place] = blocks[0], _kept(blocks[0])
        return self._words[place]


def _blocks_by_place(library: Library) -> dict[tuple[str, int], list[Block]]:
    programs: list[Program] = [library[name] for name in library]
    places: dict[tuple[str, int], list[Block]] = {}
    for program in programs:
        for block in program.blocks:
            places.setdefault((program.name, block.line), []).append(block)
    return places


def _kept(block: Block) -> list[Word]:
    """The words of a block that stand in the flat program."""
    for use in block.writes:
        if isinstance(use.variable, int) and use.variable >= _SYSTEM:
            raise _refused(block, f"the block writes #{use.variable}, a variable of the control")
    words = [word for word in block.words if word.address not in ("N", "O", "#", "/", "")]
    gone = {word.text for word in words if word.text in _LEFT_OUT}
    for call in block.calls:
        if call.kind not in _WITH_CALL:
            return []  # all words are arguments
        gone.add(call.text)
    if gone - {"G67"}:
        words = [word for word in words if word.address not in "PLHQ"]
    return [word for word in words if word.text not in gone]


def _refused(block: Block, reason: str) -> FlattenError:
    return FlattenError(reason, block.program.name, block.n, block.line)


def _value(word: Word, block: Block, machine: Any, level: int, evaluator: _Evaluator) -> float:
    """What the control makes of the expression: it computes it again from the same variables."""
    expression = word.text[len(word.address) :].strip()
    if _INDIRECT.search(expression):
        raise _refused(block, f"the value of {word.text} is an expression")
    numbers = {int(number) for number in _VARIABLE.findall(expression)} - {0}
    if any(number >= _SYSTEM for number in numbers):
        raise _refused(block, f"the value of {word.text} is an expression of the control's own")
    result = next(number for number in _RESULTS if number not in numbers)
    try:
        values = {number: machine._core.get_variable(number, level) for number in numbers}
        value = evaluator(expression, result).run(variables=values, trace="none").variables[result]
    except (LookupError, ValueError):
        raise _refused(block, f"the value of {word.text} is an expression") from None
    if value is None:
        raise _refused(block, f"the value of {word.text} is vacant")
    return value
