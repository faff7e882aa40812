"""The same programs on two controls, or two versions of them on one: where they part, and why."""

from __future__ import annotations

import operator
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Unpack

from cncsub import _core
from cncsub._core import Control, variable_name
from cncsub.analysis.pairs import Again, Pair, Parting, Question, variables_lacking
from cncsub.comparison.changes import BlockChange, block_changes
from cncsub.comparison.reasons import modes_apart, reasons
from cncsub.controls import control_of
from cncsub.inputs import by_number
from cncsub.library import Library
from cncsub.loading import load
from cncsub.option_errors import wrong_value
from cncsub.run import Run
from cncsub.run_options import MdiOptions, takes
from cncsub.setup import machine_of
from cncsub.tables.rows import Step

MOST_DIFFERENCES = 20  # that are looked for one after the other


@dataclass(frozen=True)
class Difference:
    """A difference of two runs.

    `where`: the step of each that the other does not do likewise, `None` for one that has stopped
    before. `what`: what each does. `rules`: names of rules that make the difference: the first
    control with the second one's values for these does what the second one does. Empty where
    programs are compared, and where no rules make it: then it lies in the languages, or in tables
    of a control that are no rules. `parameters`: names of parameters that are no rules and make the
    difference, such as 6050, which registers a code that calls. `untried`: rules whose values could
    not be exchanged. `why`: these in words, with the modes in force that differ.
    """

    where: tuple[Step | None, Step | None]
    what: str
    rules: tuple[str, ...] = ()
    parameters: tuple[str, ...] = ()
    untried: tuple[str, ...] = ()
    why: tuple[str, ...] = ()

    def __str__(self) -> str:
        return "\n".join([self.what, *self.why])


@dataclass(frozen=True)
class Comparison:
    """The comparison of two runs.

    `same`: whether they make the same calls, moves, codes, messages and variables and stop alike;
    of the same programs in one language, whether they execute the same blocks too. Of two controls,
    codes that end a program are compared by the stop: one sends them to the machine and another
    does not; of two languages what they do is compared, not by which blocks and calls. Moves are
    the same where the tool goes the same path: X of a lathe is a diameter. An alarm is the same by
    its cause and place: its number is each control's own. `differences`: the first difference; with
    `all_differences` those after it too, each found with the rules of the ones before it exchanged.
    `rest`: why no more were looked for, or that there are none. `where`, `what`, `rules`,
    `parameters`, `untried`: those of the first difference. `changes`: where programs are compared,
    all that their blocks do otherwise.

    >>> import cncsub
    >>> library = cncsub.loads("O1\\nN10 M98 P2 L0\\nM30\\nO2\\nM99\\n", control="fanuc-0i-f")
    >>> compared = cncsub.compare(library, controls=["fanuc-0i-f", "mitsubishi-m700"])
    >>> compared.same, compared.rules
    (False, ('zero_repeats',))
    """

    same: bool
    runs: tuple[Run, Run] = field(repr=False)
    differences: tuple[Difference, ...] = ()
    rest: str = ""
    changes: tuple[BlockChange, ...] = field(default=(), repr=False)

    @property
    def where(self) -> tuple[Step | None, Step | None] | None:
        """The steps of the first difference, one of each run; `None` where there is none."""
        return self.differences[0].where if self.differences else None

    @property
    def what(self) -> str:
        """The first difference in words, or `"the same"`."""
        return self.differences[0].what if self.differences else "the same"

    @property
    def rules(self) -> tuple[str, ...]:
        """The rules that cause the first difference."""
        return self.differences[0].rules if self.differences else ()

    @property
    def parameters(self) -> tuple[str, ...]:
        """The parameters that cause the first difference."""
        return self.differences[0].parameters if self.differences else ()

    @property
    def untried(self) -> tuple[str, ...]:
        """The rules that could not be tried for the first difference."""
        return self.differences[0].untried if self.differences else ()

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import comparison_html

        return comparison_html(self)

    def __str__(self) -> str:
        if self.same:
            return "the same"
        told = "\n\n".join(map(str, self.differences))
        return f"{told}\n\n{self.rest}" if self.rest else told


@takes(MdiOptions)
def compare(
    first: Library | str | os.PathLike[str],
    second: Library | str | os.PathLike[str] | None = None,
    *,
    controls: Sequence[str | Control] | None = None,
    control: str | Control | None = None,
    main: str | int | None = None,
    all_differences: bool = False,
    **options: Unpack[MdiOptions],
) -> Comparison:
    """Run the same programs on two `controls`, or two versions of programs, and return where they
    part.

    `first`, `second`: libraries, or paths, which `control` reads. `controls`: two of them, names or
    objects; then there is no `second`. `main` and `options` are those of `Library.run`, for both.
    `all_differences`: of two controls, go on after the first difference: the rules that make it are
    exchanged, and the next one is looked for. Raises what `load` and `run` raise, and `TypeError`
    where it is not clear what to compare.

    >>> import cncsub
    >>> before = cncsub.loads("O1\\nN10 G0 X1.\\nM30\\n", control="fanuc-0i-f")
    >>> after = cncsub.loads("O1\\n(ROUGH)\\nN10 G0 X2.\\nM30\\n", control="fanuc-0i-f")
    >>> print(cncsub.compare(before, after))
    before: O1 N10, line 2: move 0 goes to x = 1
    after: O1 N10, line 3: move 0 goes to x = 2
    """
    if options.get("trace", "moves") != "moves":
        raise TypeError("compare records all that a run does; leave out trace")
    if controls is not None:
        if second is not None:
            raise TypeError("compare needs either a second library or two controls, not both")
        two = _two_controls(controls)
        library = _library(first, control or two[0])
        return _OfControls(library, two, main, options).compared(every=all_differences)
    if all_differences:
        raise TypeError("all_differences is of two controls; `changes` holds those of two versions")
    if second is None:
        raise TypeError("compare needs a second library, or controls=[one, another]")
    a, b = _library(first, control), _library(second, control)
    one_language = a.control.dialect == b.control.dialect
    question: Question = "versions" if one_language else "controls"
    pair = Pair(question, (a, b), ("before", "after"), main, options)
    runs = pair.runs()
    parting = pair.parting(*runs)
    if parting is None:
        return Comparison(True, runs)
    changes = block_changes((a, b), runs, pair.watched(*runs))
    return Comparison(False, runs, (Difference(_where(runs, parting), parting.what),), "", changes)


def _library(of: Library | str | os.PathLike[str], control: str | Control | None) -> Library:
    if isinstance(of, Library):
        return of
    if control is None:
        raise TypeError(f"compare reads {os.fspath(of)} for a control: give control=")
    return load(of, control=control)


def _two_controls(controls: Sequence[str | Control]) -> tuple[Control, Control]:
    if isinstance(controls, str | Control) or len(controls) != 2:
        raise TypeError("compare needs two controls: controls=[one, another]")
    return control_of(controls[0]), control_of(controls[1])


def _where(runs: tuple[Run, Run], parting: Parting) -> tuple[Step | None, Step | None]:
    steps = (parting.first, parting.second)
    one, other = (
        run.steps[at] if at < len(run.steps) else None for run, at in zip(runs, steps, strict=True)
    )
    return one, other


class _OfControls:
    """The same programs on two controls: their differences, one after the other."""

    def __init__(
        self,
        library: Library,
        controls: tuple[Control, Control],
        main: str | int | None,
        options: MdiOptions,
    ) -> None:
        one, other = controls
        self._library = library
        self._controls = controls
        self._names = (one.name, other.name) if one.name != other.name else ("first", "second")
        self._main = main
        self._options = options
        for each in controls:
            if lacking := variables_lacking(
                each, by_number("variables", each, options.get("variables") or {})
            ):
                name = variable_name(each, lacking[0])
                raise wrong_value("variables", f"variables: {each.name} has no {name}")
        self._other = library.read_for(other)

    def compared(self, *, every: bool) -> Comparison:
        """Return the first difference, or every one until none is left or no rule makes it."""
        one = self._controls[0]
        pair = self._pair(one)
        runs = first = pair.runs()
        found: list[Difference] = []
        while (parting := pair.parting(*runs)) is not None:
            changed, difference = self._difference(one, pair, runs, parting)
            found.append(difference)
            if not every or changed is None or len(found) == MOST_DIFFERENCES:
                break
            one = changed
            pair = self._pair(one)
            runs = pair.run(0), runs[1]
        rest = self._rest(found, ended=parting is None) if every and found else ""
        return Comparison(not found, first, tuple(found), rest)

    def _rest(self, found: list[Difference], *, ended: bool) -> str:
        one, other = self._names
        if ended:
            return f"with these rules of {other}, {one} does the same as {other}"
        if len(found) == MOST_DIFFERENCES:
            return f"no more than {MOST_DIFFERENCES} differences are looked for"
        return "what comes after is not compared: no rule is known to make this difference"

    def _pair(self, one: Control) -> Pair:
        texts = (self._library.read_for(one), self._other)
        return Pair("controls", texts, self._names, self._main, self._options)

    def _difference(
        self, one: Control, pair: Pair, runs: tuple[Run, Run], parting: Parting
    ) -> tuple[Control | None, Difference]:
        """Return a difference, and the first control with the rules exchanged that make it."""
        other = self._controls[1]

        def run_on(control: Control) -> Again | None:
            try:
                again = self._pair(control).again(0)
            except (KeyError, ValueError):
                return None

            def run(most: int | None, watch: Sequence[int]) -> _core.Machine | None:
                try:
                    return again(most, watch)
                except (KeyError, ValueError):  # read so, there is no such main program or variable
                    return None

            return run

        exchange = _core.rule_exchange(one, other)
        made = _core.rules_apart(exchange, parting[:2], pair.sides(*runs), run_on)
        rules = tuple(name for name in made if name not in one.parameters)
        parameters = tuple(name for name in made if name in one.parameters)
        untried = tuple(exchange.untried)
        both = (one, other)
        modes = list(self._modes(both, pair, runs, parting))
        why = reasons(both, self._names, modes, rules, parameters, untried)
        where = _where(runs, parting)
        difference = Difference(where, parting.what, rules, parameters, untried, why)
        return exchange.control(made) if made else None, difference

    def _modes(
        self,
        both: tuple[Control, Control],
        pair: Pair,
        runs: tuple[Run, Run],
        parting: Parting,
    ) -> Iterator[str]:
        """Yield the modes in force at a move that both make, each its own way."""
        ended = (len(run.steps) for run in runs)
        if not parting.column or any(map(operator.ge, parting[:2], ended)):
            return
        one, other = (
            pair.run(side, max_blocks=at + 1).modal for side, at in enumerate(parting[:2])
        )
        machine = machine_of(self._options.get("setup"))
        yield from modes_apart(both, self._names, (one, other), parting.column, machine)
