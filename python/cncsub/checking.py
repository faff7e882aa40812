"""The findings of a check: what is wrong in programs or will surprise, found without a run."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from cncsub import _core
from cncsub.controls import controls, did_you_mean

if TYPE_CHECKING:
    RULES: tuple[CheckRule, ...]

SEVERITIES = ("error", "warning", "note")


class CheckRule(NamedTuple):
    """A rule of `Library.check`.

    `number`: such as `CS201`. `name`: its slug. `severity`: `"error"`, `"warning"` or `"note"`.
    `meaning`: what it finds. `hint`: what to write instead. `example`: a program in which it is
    found on `control`.
    """

    number: str
    name: str
    severity: str
    meaning: str
    hint: str
    example: str
    control: str


def _rules() -> Iterator[CheckRule]:
    """Yield the rules, each in the words of the control of its example."""
    told = {}
    for index, row in enumerate(_core.checks()):
        rule = CheckRule(*row)
        if rule.control not in told:
            told[rule.control] = _core.told_for(controls[rule.control])[0]
        meaning, hint = told[rule.control][index]
        yield rule._replace(meaning=meaning, hint=hint)


@functools.cache
def all_rules() -> tuple[CheckRule, ...]:
    """Return every rule, by its number. They are put into words when one is asked for."""
    return tuple(_rules())


@functools.cache
def _by_name() -> dict[str, CheckRule]:
    return {key: rule for rule in all_rules() for key in (rule.number, rule.name)}


def __getattr__(name: str) -> Any:
    if name != "RULES":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return all_rules()


class Edit(NamedTuple):
    """A certain change of a file's text: `old` at `line` and `column` becomes `new`. Where `old` is
    empty, `new` is put at the end of the line.
    """

    file: str
    line: int
    column: int
    old: str
    new: str


class Place(NamedTuple):
    """Another place of a finding: the program, the block and the word that it is about."""

    program: str
    n: int | None
    file: str
    line: int
    column: int
    word: str


@dataclass(frozen=True)
class Finding:
    """A finding of `Library.check`; there is one for each cause.

    `rule`: its number, such as `CS201`; `name`: its slug; `severity`: `"error"`, `"warning"` or
    `"note"`. `program`, `n`, `line`, `column`, `file`, `word`: where, as in an `Alarm`. `message`:
    what is wrong there. `hint`: what to write instead. `alarm`: what the control raises when the
    block runs, `None` if it raises nothing or no source says what. `path`: the calls that lead
    there, the outermost first. `fix`: edits that correct it, `None` if none is certain. `places`:
    where the same cause is found again, the first 1,000 by their blocks; `count`: how often in all.
    """

    rule: str
    name: str
    severity: str
    program: str
    n: int | None
    line: int
    column: int
    file: str
    word: str
    message: str
    hint: str
    alarm: _core.Alarm | None
    path: tuple[_core.Frame, ...]
    fix: tuple[Edit, ...] | None
    source: str  # the text of the line
    places: tuple[Place, ...] = ()
    count: int = 1

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import finding_html

        return finding_html(self)

    @property
    def told(self) -> str:
        """The message, with the number of further places."""
        if self.count == 1:
            return self.message
        more = self.count - 1
        return f"{self.message} (and in {more:,} more place{'s' if more > 1 else ''})"

    def __str__(self) -> str:
        number = f" [{self.alarm.number}]" if self.alarm is not None and self.alarm.number else ""
        at = self.program if self.n is None else f"{self.program} N{self.n}"
        before, shown, width = _clipped(self.source, self.column - 1, len(self.word))
        blank = "".join("\t" if letter == "\t" else " " for letter in before)
        lines = [
            f"{self.severity} {self.rule} {self.name}{number}: {self.told}",
            f"  --> {at}, {self.file}:{self.line}:{self.column}",
            f"   | {shown}",
            f"   | {blank}{'^' * max(1, width)}",
        ]
        if self.places:
            lines.append(f"also in {_listed(self.file, self.places, self.count - 1)}")
        for frame in reversed(self.path):
            caller = frame.program if frame.n is None else f"{frame.program} N{frame.n}"
            lines.append(f"called from {caller} ({frame.kind}), {frame.file}:{frame.line}")
        lines.append(f"hint: {self.hint}")
        return "\n".join(lines)


_LISTED = 12  # lines of other places


def _listed(file: str, places: Sequence[Place], count: int) -> str:
    """Return the lines of places, such as `lines 5, 9, sub.nc line 3, and 40 more`."""
    lines: dict[str, dict[int, None]] = {}
    for place in places[:_LISTED]:
        lines.setdefault(place.file, {})[place.line] = None
    told = [
        f"{'' if name == file else name + ' '}line{'s' if len(of) > 1 else ''} "
        + ", ".join(map(str, of))
        for name, of in lines.items()
    ]
    left = count - min(len(places), _LISTED)
    return ", ".join(told) + (f", and {left:,} more" if left else "")


_WIDE = 160  # letters of a line that are shown


def _clipped(source: str, at: int, width: int) -> tuple[str, str, int]:
    """Return the text before a word in its line as it is shown, the shown line, and the width of
    the word. A long line is clipped around the word.
    """
    if len(source) <= _WIDE:
        return source[:at], source, width
    first = 0 if at < _WIDE // 2 else at - _WIDE // 4
    last = first + _WIDE
    head = "..." if first else ""
    shown = head + source[first:last] + ("..." if last < len(source) else "")
    return head + source[first:at], shown, min(width, last - at)


def rule_named(name: str) -> CheckRule:
    """Return the rule of a number or a slug; `KeyError` names similar ones.

    >>> from cncsub.checking import rule_named
    >>> rule_named("CS201").name
    'program-missing'
    """
    rules = _by_name()
    found = rules.get(name) or rules.get(name.upper()) or rules.get(name.lower())
    if found is None:
        first, last = all_rules()[0].number, all_rules()[-1].number
        there = f"; there are {first} to {last}, and CS1, CS2 ... for the groups of them"
        raise KeyError(f"check has no rule {name!r}{did_you_mean(name, rules, there)}")
    return found


def rule_names() -> list[str]:
    """Return the slugs of all rules."""
    return [rule.name for rule in all_rules()]


def chosen_rules(names: Iterable[str] | None) -> frozenset[str]:
    """Return the numbers of the rules that are named by numbers, slugs or beginnings of numbers
    (`CS2`); of all rules without names.
    """
    if names is None:
        return frozenset(rule.number for rule in all_rules())
    if isinstance(names, str):
        raise TypeError(f"rules must be a list of names, not the text {names!r}")
    chosen: set[str] = set()
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"the name of a rule must be a text such as CS201, not {name!r}")
        group = {rule.number for rule in all_rules() if rule.number.startswith(name.upper())}
        is_group = re.fullmatch(r"CS\d?", name.upper()) is not None and bool(group)
        chosen |= group if is_group else {rule_named(name).number}
    return frozenset(chosen)


def check(
    code: _core.Code,
    main: int,
    rules: Iterable[str] | None,
    machine: str | None,
    entries: Sequence[int] = (),
) -> list[Finding]:
    """Return the findings of the chosen rules, by their places."""
    chosen = chosen_rules(rules)
    told = _core.told_for(code.control)
    found = (_finding(told, *row) for row in _core.check(code, main, machine or "", entries))
    return [finding for finding in found if finding.rule in chosen]


def _finding(
    told: tuple[list[tuple[str, str]], dict[str, tuple[str, str]]],
    index: int,
    place: _core.Alarm,
    source: str,
    alarm: _core.Alarm | None,
    path: tuple[_core.Frame, ...],
    edits: Sequence[tuple[str, int, int, str, str]],
    again: Sequence[tuple[_core.Alarm, str]],
    count: int,
    cure_here: str,
) -> Finding:
    rule = all_rules()[index]
    meaning, hint = told[0][index]
    detail = place.detail or (alarm.detail if alarm is not None else "")
    if alarm is not None:
        meaning, cure = told[1][alarm.cause]
        hint = cure if rule.name in _OF_ANY_CAUSE else hint
    message = detail or meaning
    hint = cure_here or hint
    return Finding(
        rule.number,
        rule.name,
        rule.severity,
        place.program,
        place.n,
        max(1, place.line),  # an empty file has no lines
        place.column,
        place.file,
        place.word,
        message,
        hint,
        alarm,
        path,
        tuple(Edit(*edit) for edit in edits) or _fixes(rule, alarm, ((place, source), *again)),
        source,
        tuple(
            Place(at.program, at.n, at.file, max(1, at.line), at.column, at.word) for at, _ in again
        ),
        count,
    )


# These rules find many causes, each with a remedy of its own.
_OF_ANY_CAUSE = ("refused", "code-not-available", "variable-not-available")


def _fixes(
    rule: CheckRule, alarm: _core.Alarm | None, places: Iterable[tuple[_core.Alarm, str]]
) -> tuple[Edit, ...] | None:
    """Return edits after which the control does the same, or does what a refused block can only
    mean. They mend all places that have an edit.
    """
    fixes = (_fix(rule, place, alarm, line) for place, line in places)
    return tuple(edit for fix in fixes for edit in fix or ()) or None


def _fix(
    rule: CheckRule, place: _core.Alarm, alarm: _core.Alarm | None, source: str
) -> tuple[Edit, ...] | None:
    word = place.word
    if rule.name == "g99-for-m99" and (at := word.upper().find("G99")) >= 0:
        return (Edit(place.file, place.line, place.column + at, word[at : at + 3], "M99"),)
    # IF[#1 EQ 2]#3=4: an assignment after a condition has no other meaning.
    if rule.name == "if-without-then":
        after = source[place.column - 1 :]
        name, equals, _ = after.partition("=")
        name = name.strip()
        if name.startswith("#") and name[1:].isdecimal() and equals:
            column = place.column + len(after) - len(after.lstrip())
            return (Edit(place.file, place.line, column, name, f"THEN {name}"),)
    return None if alarm is None else _mended_word(place, alarm, source)


def _mended_word(place: _core.Alarm, alarm: _core.Alarm, source: str) -> tuple[Edit, ...] | None:
    """Mend XO. to X0. and X1,5 to X1.5: the control refuses them, and nothing else can be meant."""
    word = place.word
    text = source[place.column - 1 :]
    if alarm.cause == "address-without-value" and text[:1].isupper() and text[0] != "O":
        size = 2 if text[1:2] in ("+", "-") else 1
        value = text[size : size + 1]
        if value == "O" and text[size + 1 : size + 2] in (*"0123456789.; \t", ""):
            before = text[:size]
            return (Edit(place.file, place.line, place.column, before + value, f"{before}0"),)
    if alarm.cause == "value-without-address" and text.startswith(word) and word[1:].isdecimal():
        before = source[: place.column - 1]
        signed = before.rstrip("0123456789")
        letter = (signed[:-1] if signed.endswith(("+", "-")) else signed)[-1:]
        if word[0] == "," and signed != before and letter.isascii() and letter.isalpha():
            return (Edit(place.file, place.line, place.column, word, f".{word[1:]}"),)
    return None


def counts(findings: Iterable[Finding]) -> Iterator[tuple[str, int]]:
    """Yield how many findings there are of each severity."""
    every = [finding.severity for finding in findings]
    for severity in SEVERITIES:
        if severity in every:
            yield severity, every.count(severity)


class FlowEdge(NamedTuple):
    """An edge from one block to another, as places among the blocks of the program.

    `to` is the number of blocks for the end of the program. A computed jump may reach any block
    with a number: `to` is `None` there, and `block` is `None` in the edge that goes on from it.
    `kind`: `"next"`, `"jump"`, `"computed"` or `"returned"` (by M99 P of a called program).
    """

    block: int | None
    to: int | None
    kind: str


@dataclass(frozen=True)
class Flow:
    """The flow graph of a program, as its blocks are written.

    `blocks`: how many blocks it has. `edges`: the edges between them. `returns`, `ends`: the blocks
    that may return to a caller and that may end the run. `unreached`: the blocks that no jump or
    call reaches.

    >>> import cncsub
    >>> text = "O1\\nN10 GOTO 30\\nN20 G4 P1\\nN30 M30\\n"
    >>> flow = cncsub.loads(text, control="fanuc-0i-f").flow("O1")
    >>> [(edge.block, edge.to, edge.kind) for edge in flow.edges], flow.ends, flow.unreached
    ([(0, 2, 'jump'), (1, 2, 'next')], (2,), (1,))
    """

    program: str
    blocks: int
    edges: tuple[FlowEdge, ...]
    returns: tuple[int, ...]
    ends: tuple[int, ...]
    unreached: tuple[int, ...]

    def to_dot(self) -> str:
        """Return the graph in the language of Graphviz."""

        def name(place: int | None) -> str:
            return "anywhere" if place is None else "end" if place == self.blocks else str(place)

        ways = (
            f"  {name(edge.block)} -> {name(edge.to)}"
            + ("" if edge.kind == "next" else f' [label="{edge.kind}"]')
            + ";"
            for edge in self.edges
        )
        return "\n".join(["digraph flow {", *ways, "}"]) + "\n"


def flow_of(flows: _core.Flows, data: _core.ProgramData, blocks: int) -> Flow:
    edges, returns, ends, unreached = _core.flow(flows, data)
    return Flow(
        data.name,
        blocks,
        tuple(FlowEdge(*row) for row in edges),
        tuple(returns),
        tuple(ends),
        tuple(unreached),
    )
