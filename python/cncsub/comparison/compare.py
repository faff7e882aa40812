"""The same programs on two controls, or two versions of them on one: where they part, and why."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Unpack

from cncsub._core import Alarm, Control
from cncsub.analysis.first_difference import column_of, first_difference
from cncsub.analysis.pairs import LISTS, OtherControlPair, Pair, Parting, variables_lacking
from cncsub.comparison.changes import BlockChange, block_changes
from cncsub.comparison.rule_bisection import rules_between
from cncsub.controls import control_of
from cncsub.library import Library
from cncsub.loading import load
from cncsub.option_errors import wrong_value
from cncsub.run import Run
from cncsub.run_options import MdiOptions, takes
from cncsub.tables.rows import Step


@dataclass(frozen=True)
class Comparison:
    """The comparison of two runs.

    `same`: whether they make the same calls, moves, codes, messages and variables and stop alike;
    of the same programs in one language, whether they execute the same blocks too. Of two controls,
    codes that end a program are compared by the stop: one sends them to the machine and another
    does not; of two languages what they do is compared, not by which blocks and calls. Moves are
    the same where the tool goes the same path: X of a lathe is a diameter. An alarm is the same by
    its cause and place: its number is each control's own. `where`: the first step of each that the
    other does not do likewise, `None` for one that has stopped before. `what`: what each does.
    `rules`: names of rules that make the difference: the first control with the second one's values
    for these does what the second one does. Empty where programs are compared, and where no rules
    make it: then it lies in the languages, or in tables of a control that are no rules. `untried`:
    rules whose values could not be exchanged. `parameters`: names of parameters that are no rules
    and make the difference, such as 6050, which registers a code that calls. `changes`: where
    programs are compared, all that their blocks do otherwise.

    >>> import cncsub
    >>> library = cncsub.loads("O1\\nN10 M98 P2 L0\\nM30\\nO2\\nM99\\n", control="fanuc-0i-f")
    >>> compared = cncsub.compare(library, controls=["fanuc-0i-f", "mitsubishi-m700"])
    >>> compared.same, compared.rules
    (False, ('zero_repeats',))
    """

    same: bool
    where: tuple[Step | None, Step | None] | None
    what: str
    rules: tuple[str, ...]
    untried: tuple[str, ...]
    runs: tuple[Run, Run] = field(repr=False)
    parameters: tuple[str, ...] = ()
    changes: tuple[BlockChange, ...] = field(default=(), repr=False)

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import comparison_html

        return comparison_html(self)

    def __str__(self) -> str:
        if self.same:
            return "the same"
        lines = [self.what]
        if self.rules:
            lines.append("the rules that cause it: " + ", ".join(self.rules))
        if self.parameters:
            lines.append("the parameters that cause it: " + ", ".join(self.parameters))
        if self.untried:
            lines.append("rules that could not be tried: " + ", ".join(self.untried))
        return "\n".join(lines)


@takes(MdiOptions)
def compare(
    first: Library | str | os.PathLike[str],
    second: Library | str | os.PathLike[str] | None = None,
    *,
    controls: Sequence[str | Control] | None = None,
    control: str | Control | None = None,
    main: str | int | None = None,
    **options: Unpack[MdiOptions],
) -> Comparison:
    """Run the same programs on two `controls`, or two versions of programs, and return where they
    part.

    `first`, `second`: libraries, or paths, which `control` reads. `controls`: two of them, names or
    objects; then there is no `second`. `main` and `options` are those of `Library.run`, for both.
    Raises what `load` and `run` raise, and `TypeError` where it is not clear what to compare.

    >>> import cncsub
    >>> before = cncsub.loads("O1\\nN10 G0 X1.\\nM30\\n", control="fanuc-0i-f")
    >>> after = cncsub.loads("O1\\n(ROUGH)\\nN10 G0 X2.\\nM30\\n", control="fanuc-0i-f")
    >>> print(cncsub.compare(before, after))
    before: O1 N10, line 2: move 0 with x = 1
    after: O1 N10, line 3: move 0 with x = 2
    """
    if options.get("trace", "moves") != "moves":
        raise TypeError("compare records all that a run does; leave out trace")
    if controls is not None:
        if second is not None:
            raise TypeError("compare needs either a second library or two controls, not both")
        return _compare_controls(first, controls, control, main, options)
    if second is None:
        raise TypeError("compare needs a second library, or controls=[one, another]")
    a, b = _library(first, control), _library(second, control)
    kind = Pair if a.control.dialect == b.control.dialect else _ControlPair
    pair = kind((a, b), ("before", "after"), main, options)
    runs = pair.runs()
    parting = pair.parting(*runs)
    compared = _told(pair, runs, parting, (), ())
    if compared.same:
        return compared
    return replace(compared, changes=block_changes((a, b), runs, pair.watched(*runs)))


def _library(of: Library | str | os.PathLike[str], control: str | Control | None) -> Library:
    if isinstance(of, Library):
        return of
    if control is None:
        raise TypeError(f"compare reads {os.fspath(of)} for a control: give control=")
    return load(of, control=control)


def _compare_controls(
    of: Library | str | os.PathLike[str],
    controls: Sequence[str | Control],
    control: str | Control | None,
    main: str | int | None,
    options: MdiOptions,
) -> Comparison:
    if isinstance(controls, str | Control) or len(controls) != 2:
        raise TypeError("compare needs two controls: controls=[one, another]")
    one, other = (control_of(each) for each in controls)
    library = _library(of, control or one)
    texts = (library.read_for(one), library.read_for(other))
    names = (one.name, other.name) if one.name != other.name else ("first", "second")
    for each in (one, other):
        if lacking := variables_lacking(each, options.get("variables") or {}):
            raise wrong_value("variables", f"variables: {each.name} has no #{lacking[0]}")
    pair = _ControlPair(texts, names, main, options)
    runs = pair.runs()
    parting = pair.parting(*runs)
    if parting is None:
        return _told(pair, runs, None, (), ())
    blocks = min(parting.first, parting.second) + 1  # as far as the first difference
    limit = min(blocks, options.get("max_blocks", 10_000_000))
    wanted = pair.run(texts[1], max_blocks=limit)

    def explains(control: Control) -> bool:
        try:
            exchanged = library.read_for(control)
            tried = pair.run(exchanged, max_blocks=limit)
        except (KeyError, ValueError):  # read so, there is no such main program or variable
            return False
        other = _ControlPair((exchanged, texts[1]), names, main, options)
        return other.parting(tried, wanted) is None

    made, untried = rules_between(one, other, explains)
    rules = tuple(name for name in made if name not in one.parameters)
    parameters = tuple(name for name in made if name in one.parameters)
    return replace(_told(pair, runs, parting, rules, untried), parameters=parameters)


def _told(
    pair: Pair,
    runs: tuple[Run, Run],
    parting: Parting | None,
    rules: tuple[str, ...],
    untried: tuple[str, ...],
) -> Comparison:
    if parting is None:
        return Comparison(True, None, "the same", (), (), runs)
    steps = (parting.first, parting.second)
    where = tuple(run.steps[at] if at < len(run.steps) else None for run, at in zip(runs, steps))
    return Comparison(False, (where[0], where[1]), parting.what, rules, untried, runs)


class _ControlPair(OtherControlPair):
    """The same texts on two controls. Programs are compared by their files and lines: what a
    control calls a program without a name of its own is no difference. Nor is a level of locals
    that one control opens for a call: the locals are compared where they do something.
    """

    _of_a_call = ("kind", "program", "start_n", "repeats")

    def _called(self, run: Run, library: Library) -> dict[str, str]:
        return _ends_of(run, library)

    def _place(self, alarm: Alarm) -> tuple[object, ...]:
        return (alarm.file, alarm.line)

    def _partings(self, a: Run, b: Run) -> Iterator[Parting]:
        """Yield the differences. Blocks and calls are compared within one language only: another
        language counts heads of programs as blocks, or a call once for each pass, and does the
        same.
        """
        yield from self._of_moves(a, b)
        for name in LISTS:
            yield from self._of_list(a, b, name)
        yield from self._of_dwells(a, b)
        yield from self._of_variables(a, b)
        one, other = (library.control.dialect for library in self.libraries)
        if one == other:
            yield from self._of_calls(a, b)
            yield from self._of_steps(a, b)
        yield from self._of_stop(a, b)

    def _of_steps(self, a: Run, b: Run) -> Iterator[Parting]:
        programs = [
            column_of(run.steps, "program", _files_of(library))
            for run, library in zip((a, b), self.libraries, strict=True)
        ]
        lines = column_of(a.steps, "line"), column_of(b.steps, "line")
        at = first_difference([(programs[0], programs[1]), lines])
        if at is not None:
            yield self._say((a, b), (at, at), ("", ""))


def _files_of(library: Library) -> dict[str, str]:
    """Return the files of the programs, by their names."""
    return {of.name: of.file for of in (*library.external.values(), *library.values())}


def _ends_of(run: Run, library: Library) -> dict[str, str]:
    """Return by name the files and last lines of the programs that a run has called. These are the
    same whatever a control calls the programs.
    """
    found = {}
    for name in run.calls.programs:
        program = library.get(name) or library.external.get(name)
        if program is not None and program.blocks:
            found[name] = f"{program.file}:{program.blocks[-1].line}"
    return found
