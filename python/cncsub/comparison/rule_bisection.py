"""The rules of two controls that make a difference, found by exchanging them until it goes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from cncsub._core import Control

Value = bool | int | str


class RuleExchange:
    """The rules of one control that another one answers otherwise, and parameters that are no
    rules. `untried`: rules whose values could not be given to the first control.
    """

    def __init__(self, one: Control, other: Control) -> None:
        self._one = one
        self._changes: dict[str, Value] = {}
        self._parameters = _other_parameters(one, other)
        values = {rule.name: rule.value for rule in other.rules}
        untried = []
        for rule in one.rules:
            if rule.name not in values or rule.value == values[rule.name]:
                continue
            written = _written(one, rule.name, values[rule.name])
            if written is None:
                untried.append(rule.name)
            else:
                self._changes[rule.name] = written
        self.untried = tuple(untried)

    def control(self, names: Sequence[str]) -> Control:
        """Return the first control with the values of the other one for these rules and
        parameters. `ValueError`: these values do not go together.
        """
        rules = {name: self._changes[name] for name in names if name in self._changes}
        control = self._one.replace(**rules)
        given = {name: self._parameters[name] for name in names if name in self._parameters}
        return control.with_parameters(given) if given else control

    def fewest(self, explains: Callable[[Control], bool]) -> tuple[str, ...]:
        """Return the fewest rules and parameters with which the first control becomes one that
        `explains`; none where even all of them do not explain.
        """

        def explained(names: Sequence[str]) -> bool:
            try:
                control = self.control(names)
            except ValueError:
                return False
            return explains(control)

        return tuple(_fewest([*self._changes, *self._parameters], explained))


def _other_parameters(one: Control, other: Control) -> dict[str, float]:
    """Return the parameters of one family of controls that differ and are no rules, with the
    other's values.
    """
    if one.parameters.keys() != other.parameters.keys():
        return {}
    return {
        name: other.parameters[name].value
        for name, own in one.parameters.items()
        if own.rule is None and not own.rules and own.value != other.parameters[name].value
    }


def _written(control: Control, name: str, value: Value) -> Value | None:
    """Return how a rule is given this value: a set is merged, unless = stands before it."""
    for written in (value, f"= {value}"):
        try:
            changed = control.replace(**{name: written})
        except (TypeError, ValueError):
            continue
        if any(rule.name == name and rule.value == value for rule in changed.rules):
            return written
    return None


def _fewest(names: list[str], explains: Callable[[Sequence[str]], bool]) -> list[str]:
    """Return a set of names that explains and of which none can be left out; none where all of them
    do not explain.
    """
    if not explains(names):
        return []
    parts = 2
    while len(names) > 1:
        size = -(-len(names) // parts)
        pieces = [names[i : i + size] for i in range(0, len(names), size)]
        for i, piece in enumerate(pieces):
            rest = [name for other in pieces[:i] + pieces[i + 1 :] for name in other]
            if explains(piece):
                names, parts = piece, 2
                break
            if len(pieces) > 2 and explains(rest):
                names, parts = rest, max(parts - 1, 2)
                break
        else:
            if size == 1:
                break
            parts = min(len(names), 2 * parts)
    return names
