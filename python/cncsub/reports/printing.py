"""Runs, controls and alarms as text for people: in colour on a terminal, plain elsewhere."""

from __future__ import annotations

import functools
import heapq
import itertools
import os
import sys
import textwrap
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import IO, TYPE_CHECKING, Any

from cncsub._core import variable_name
from cncsub.analysis.conditions import conditions_on
from cncsub.analysis.static_tree import letters
from cncsub.controls import cure_of
from cncsub.escapes import shown
from cncsub.number_text import number_text
from cncsub.run import Stop
from cncsub.tables.call_tree import CallTree
from cncsub.tables.rows import Change, Compared

if TYPE_CHECKING:
    from cncsub.run import Run
    from cncsub.stream import Stream

if TYPE_CHECKING:
    import rich.console

MOST_CALLS = 100_000  # drawn in a tree
MOST_LINES = 200  # printed of it
MOST_MISSED = 20  # blocks of G31
MOST_CHANGES = 200  # of watched variables


class Text:
    """A text in parts, each with its style."""

    def __init__(self, text: str, style: str = "") -> None:
        self.parts = [(text, style)]

    @classmethod
    def assemble(cls, *parts: str | tuple[str, str]) -> Text:
        made = cls("")
        made.parts = [(part, "") if isinstance(part, str) else part for part in parts]
        return made


class Console:
    """The place where text is printed: by rich on a terminal, in plain letters elsewhere. There
    rich would take longer to import than most programs to run.
    """

    def __init__(self, file: IO[str]) -> None:
        self._file = file
        self._rich: rich.console.Console | None = None
        # These make rich take a file for a terminal, or not.
        told = any(os.environ.get(name) for name in ("FORCE_COLOR", "TTY_COMPATIBLE"))
        if told or file.isatty():
            from rich.console import Console

            self._rich = Console(
                file=file, highlight=False, markup=False, emoji=False, soft_wrap=True
            )

    @property
    def width(self) -> int | None:
        """The columns of a terminal; `None` elsewhere, where a line may have any length."""
        return self._rich.width if self._rich is not None and self._file.isatty() else None

    def print(self, text: str | Text = "", end: str = "\n") -> None:
        """Print a text; nothing is wrapped or marked up."""
        parts = [(text, "")] if isinstance(text, str) else text.parts
        if self._rich is None:
            self._file.write("".join(part for part, _ in parts) + end)
            self._file.flush()
            return
        from rich.text import Text as RichText

        self._rich.print(RichText.assemble(*parts), end=end)


def console_on(file: IO[str]) -> Console:
    """Return a console that has colour on a terminal only. What was printed before it stands before
    it in a log that holds both streams too.
    """
    if file is sys.stderr:
        sys.stdout.flush()
    return Console(file)


_COLOURS = {"end": "green", "cycles": "green", "alarm": "bold red"}


def print_run(console: Console, run: Run, title: str) -> None:
    print_tree(console, run, title)
    print_stop(console, run)
    if len(run.moves):
        console.print(f"{run.moves.size_words()}, length {run.moves.total_length:,.3f} mm,", end="")
        console.print(f" time {run.moves.time_words}")
        for axis, (low, high) in run.moves.bounds.items():
            console.print(f"  {axis} {low:.10g} to {high:.10g}")
    print_watch(console, run)
    for message in run.messages:
        console.print(f"message: {shown(message)}")
    missed = Counter(map(str, run.missed_skips))
    for block, times in itertools.islice(missed.items(), MOST_MISSED):
        console.print(f"skip: {shown(block)}{f', {times:,} times' if times > 1 else ''}")
    if len(missed) > MOST_MISSED:
        console.print(f"... {len(missed) - MOST_MISSED:,} more blocks got no skip signal")
    words = Counter((w.program, w.n, w.line, w.file, w.text, w.warning) for w in run.dropped)
    for (program, n, line, file, text, warning), times in itertools.islice(
        words.items(), MOST_MISSED
    ):
        place = program if n is None else f"{program} N{n}"
        often = "" if times == 1 else f", {times} times"
        console.print(f"dropped: {shown(text)} at {shown(f'{place}, {file}:{line}')}{often}")
        if warning is not None:
            console.print(f"warning: {shown(text)} does nothing: {warning}")
    if len(words) > MOST_MISSED:
        console.print(f"... {len(words) - MOST_MISSED:,} more words were dropped")


def print_watch(console: Console, run: Run) -> None:
    """Print the watched variables: their values at the beginning, and each change with
    its block.
    """
    name = functools.partial(variable_name, run.recorded.control)
    now = dict(run.watch.beginning)
    for first, last, value in _beginnings(now):
        verb, span = ("begins", "") if first == last else ("begin", f" to {name(last)}")
        console.print(f"watch: {name(first)}{span} {verb} {number_text(value)}")
    told: list[Iterable[Change | Compared]] = [run.watch, conditions_on(run, set(now))]
    rows = heapq.merge(*told, key=lambda row: row.step or 0)
    for row in itertools.islice(rows, MOST_CHANGES):
        place = row.program if row.n is None else f"{row.program} N{row.n}"
        step = f"{shown(str(place))}, line {row.line}, step {row.step}"
        if isinstance(row, Compared):
            console.print(f"watch: {row} at {step}")
            continue
        was, now[row.variable] = now[row.variable], row.value
        values = f"{number_text(was)} -> {number_text(row.value)}"
        console.print(f"watch: {name(row.variable)} {values} at {step}")
    if left := sum(1 for _ in rows):
        console.print(f"... {left:,} more; --format json and run.watch have all")


def _beginnings(values: Mapping[int, float | None]) -> Iterator[tuple[int, int, float | None]]:
    """Yield the values, each with its first and last number; neighbouring vacant variables
    are one.
    """
    first = last = -2
    value: float | None = None
    for number, now in values.items():
        if number == last + 1 and now is None and value is None:
            last = number
            continue
        if first >= 0:
            yield first, last, value
        first, last, value = number, number, now
    if first >= 0:
        yield first, last, value


def print_tree(console: Console, run: Run, title: str, *, callers: bool = False) -> None:
    """Print the calls; with `callers` each with its arguments and the block that called."""
    console.print(Text(shown(title), style="bold"))
    told = (lambda call: call_words(run, call)) if callers else None
    lines = _tree_lines(run.calls.tree(most=MOST_CALLS), told)
    for line in itertools.islice(lines, MOST_LINES):
        console.print(line)
    left = sum(1 for _ in lines)
    if left:
        console.print(f"... {left:,} more lines")
    if len(run.calls) > MOST_CALLS:
        console.print(f"... only the first {MOST_CALLS:,} of {len(run.calls):,} calls")


def call_words(run: Run, call: CallTree) -> str:
    """Return what was given to a call, and by which block: ` A=1 B=2, from O1 N10`."""
    words = f" {letters(call.arguments)}" if call.arguments else ""
    if call.varied:
        words += " (the first; they differ)"
    if call.caller_step is not None and call.caller_step < len(run.steps):
        step = run.steps[call.caller_step]
        at = f"line {step.line}" if step.n is None else f"N{step.n}"
        words += f", from {step.program} {at}"
    return words


def _tree_lines(
    trees: list[CallTree], told: Callable[[CallTree], str] | None = None
) -> Iterator[Text]:
    waiting = [(call, "", call is trees[-1]) for call in reversed(trees)]
    while waiting:
        call, stem, last = waiting.pop()
        head = shown(f"{call.kind} {call.program}")
        branch = stem + ("`-- " if last else "|-- ")
        words = shown(str(call) + (told(call) if told else "")).removeprefix(head)
        yield Text.assemble((branch, "dim"), (head, "cyan"), words)
        below = stem + ("    " if last else "|   ")
        waiting += [(inner, below, inner is call.calls[-1]) for inner in reversed(call.calls)]


def print_stop(console: Console, run: Run | Stream) -> None:
    stop = Text(f"stopped: {stop_text(run)}", style=_COLOURS.get(str(run.stop), "yellow"))
    console.print(stop)
    if run.endless is not None and run.stop is not Stop.WAITING:
        console.print(f"why: {shown(str(run.endless))}")
    if run.alarm is not None:
        for line in map(shown, str(run.alarm).split("\n")):
            mark = line.strip(" |")
            console.print(Text(line, style=_COLOURS["alarm"] if mark.strip("^") == "" else ""))
        console.print(f"cure: {cure_of(run.alarm, run.core.code.control)}")


def stop_text(run: Run | Stream) -> str:
    """Return how a run ended, in words."""
    blocks = f"{run.blocks:,} block{'s' if run.blocks != 1 else ''}"
    if run.stop is Stop.WAITING:
        return f"waiting for {run.waiting_for or 'an input that is not given'}, after {blocks}"
    assert run.stop is not None, "a stream is written to its end"
    reasons = {
        Stop.END: "the program ended",
        Stop.ALARM: "alarm",
        Stop.CYCLES: (
            "M99 starts the program over, and all passes asked for have run (--max-cycles)"
        ),
        Stop.LIMIT: "the limit of blocks or memory is reached (--max-blocks)",
        Stop.INTERRUPTED: "interrupted",
    }
    return f"{reasons[run.stop]}, after {blocks}"


def print_pairs(console: Console, pairs: Mapping[str, str]) -> None:
    width = max(map(len, pairs))
    for name, text in pairs.items():
        console.print(Text.assemble((name.ljust(width), "cyan"), f"  {text}"))


def print_wrapped(console: Console, line: str) -> None:
    """Print a line, wrapped on a terminal below the place where its text begins."""
    indent = line[: len(line) - len(line.lstrip())] + "  "
    for part in wrapped(console, line, indent):
        console.print(part)


def wrapped(console: Console, text: str, indent: str) -> list[str]:
    """Return the text in lines of a terminal; the lines after the first are indented."""
    if console.width is None or len(text) <= console.width:
        return [text]
    options: Any = {"break_long_words": False, "break_on_hyphens": False}
    return textwrap.wrap(text, max(40, console.width), subsequent_indent=indent, **options)


def print_explanations(console: Console, facts: list[dict[str, Any]]) -> None:
    for place, fact in enumerate(facts):
        if place:
            console.print()
        console.print(Text(fact["cause"], style="bold"))
        console.print(f"  raised by: {fact['meaning']}")
        kin: dict[tuple[str, str], list[str]] = {}
        for one in fact["beside"]:
            kin.setdefault((one["cause"], one["meaning"]), []).append(one["number"])
        for (cause, meaning), numbers in kin.items():
            console.print(f"  similar: {', '.join(numbers)} {cause}, {meaning}")
        console.print(f"  cure: {fact['cure']}")
        for alarm in fact["alarms"]:
            directed = ", ".join(f"{number} {way}" for way, number in alarm["directed"].items())
            number = alarm["number"] or directed or "no number"
            text = f" {alarm['text']}" if alarm["text"] else ""
            console.print(Text.assemble((f"  {alarm['control']}: ", "cyan"), f"{number}{text}"))
            console.print(Text(f"      [{alarm['source']}; {alarm['evidence']}]", style="dim"))
        if not fact["alarms"]:
            console.print("  no source gives a number")
