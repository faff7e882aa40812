"""The variables and the signals of a machine, as mappings."""

from __future__ import annotations

import operator
from collections.abc import Iterator, Mapping, MutableMapping
from typing import Any

from cncsub import _core
from cncsub.controls import did_you_mean
from cncsub.files import one_line
from cncsub.inputs import by_number, checked_variables, is_whole, number_of
from cncsub.pickling import NotPicklable
from cncsub.setup import checked_number


class Variables(NotPicklable, Mapping[int, float | None]):
    """Variables by number: a mapping of those that hold a value. `variables[100]` of any other
    number that the control has is `None`, the vacant value. A name as programs of the control write
    it is as good as the number: `variables["R5"]`.

    Iteration and `len` count each variable under one number (the HNC also shows the locals of the
    open levels under `#200` and so on). Reading a number the control does not have, or that cannot
    be read, is a `KeyError`.

    >>> import cncsub
    >>> run = cncsub.loads("O1\\n#100=5\\nM30\\n", control="fanuc-0i-f").run()
    >>> run.variables, run.variables[101], 101 in run.variables, run.variables.get(101, 0)
    ({100: 5}, None, False, 0)
    """

    _instead = "send dict(variables)"

    def __init__(self, core: _core.Machine, level: int) -> None:
        self._core = core
        self._level = level

    def __getitem__(self, name: int | str) -> float | None:
        number = self._number(name)
        if isinstance(number, bool) or not hasattr(number, "__index__"):
            raise KeyError(f"a variable number must be a whole number such as 100, not {number!r}")
        try:
            return self._core.get_variable(operator.index(number), self._level)
        except (TypeError, LookupError) as error:
            raise _no_variable(number, error) from None

    @property
    def named(self) -> dict[str, Any]:
        """The variables that the program of the level defines, and those of all programs, by name
        in capitals: a number, a text, an axis, or lists for an array.

        >>> import cncsub
        >>> text = 'DEF INT SIDES[2]=SET(3,4)\\nDEF STRING[8] NAME="A"<<SIDES[1]\\nM30\\n'
        >>> run = cncsub.loads(text, control="siemens-one").run()
        >>> run.variables.named
        {'SIDES': [3, 4], 'NAME': 'A4'}
        """
        return self._core.named_variables(self._level)

    def __iter__(self) -> Iterator[int]:
        return (number for number, value in self._set().items() if value is not None)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __contains__(self, number: object) -> bool:
        try:
            return self[number] is not None  # type: ignore[index]
        except KeyError:
            return False

    def get(self, number: int | str, default: Any = None) -> Any:
        """Return the value, or `default` where the variable is vacant or there is none."""
        try:
            value = self[number]
        except KeyError:
            return default
        return default if value is None else value

    def _number(self, name: Any) -> Any:
        """Return the number of a variable that is named as programs of the control write it."""
        if not isinstance(name, str):
            return name
        try:
            return number_of("variables", self._core.code.control, name)
        except ValueError as error:
            defined = next((of for of in self.named if of.upper() == name.upper()), None)
            cure = "" if defined is None else f" by number: give variables.named[{defined!r}]"
            raise KeyError(f"{str(error).removeprefix('variables: ')}{cure}") from None

    def _set(self) -> dict[int, float | None]:
        return self._core.variables(self._level)

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import variables_html

        return variables_html(self, self._core.code.control)

    def _name(self, number: object) -> str:
        try:
            return _core.variable_name(self._core.code.control, operator.index(number))  # type: ignore[arg-type]
        except TypeError:  # no whole number, or one that no control has
            return f"variable {number!r}"

    def __repr__(self) -> str:
        numbered = (f"{number}: {self[number]:g}" for number in self)
        named = (f"{name}: {value!r}" for name, value in self.named.items())
        return "{" + ", ".join((*numbered, *named)) + "}"


def _no_variable(number: object, error: Exception) -> KeyError:
    # The engine's own words; for a number beyond its 64 bits it has none.
    known = isinstance(error, LookupError) and error.args
    return KeyError(error.args[0] if known else f"there is no variable {number}")


class MachineVariables(Variables, MutableMapping[int, float | None]):
    """The variables of a machine, to read and to set; `None` makes one vacant. `#1` and so on are
    those of one level.

    Taking a variable out of the mapping (`del`, `pop`, `popitem`, `clear`) makes it vacant. The
    control's own variables, such as the work offsets, always have a value: `del` and `pop` of one
    are a `KeyError`, `popitem` and `clear` leave them.
    """

    @property
    def named(self) -> NamedVariables:
        """The variables that the program of the level defines, and those of all programs, by name
        in capitals, to read and to set: a number, a text, an axis, or lists for an array, which is
        set as a whole.

        Raises `KeyError` for a name that is not there and `ValueError` for a value of another type.

        >>> import cncsub
        >>> text = "DEF INT SIDES[2]=SET(3,4)\\nDEF REAL DEPTH=5\\nR1=DEPTH*SIDES[1]\\nM30\\n"
        >>> machine = cncsub.loads(text, control="siemens-one").machine()
        >>> _ = machine.step(), machine.step()
        >>> machine.variables.named["DEPTH"] = 2.5
        >>> machine.variables.named["SIDES"] = [3, 6]
        >>> _ = machine.step()
        >>> machine.evaluate("R1")
        15.0
        """
        return NamedVariables(self._core, self._level)

    def __setitem__(self, number: int | str, value: float | None) -> None:
        asked = self._number(number)
        if is_whole(asked) and not 0 <= int(asked) < 2**31:
            raise KeyError(f"there is no {self._name(asked)}")
        named = checked_variables("variables", {asked: value})
        ((checked, number_or_none),) = by_number(
            "variables", self._core.code.control, named
        ).items()
        try:
            self._core.set_variable(checked, number_or_none, self._level)
        except LookupError as error:
            raise _no_variable(number, error) from None

    def __delitem__(self, name: int | str) -> None:
        number = self._number(name)
        if number not in self:
            raise KeyError(f"{self._name(number)} has no value")
        if not self._core.can_be_vacant(operator.index(number)):
            raise KeyError(f"{self._name(number)} is a system variable and always has a value")
        self[number] = None

    def setdefault(self, number: int | str, default: float | None = None) -> float | None:
        """Return the value; a vacant variable is set to `default` first."""
        if number not in self:
            self[number] = default
        return self[number]

    def pop(self, number: int | str, *default: Any) -> Any:
        """Make a variable vacant and return its value. Where it is vacant already, return `default`
        or raise `KeyError`.
        """
        if default and number not in self:
            return default[0]
        value = self[number]
        del self[number]
        return value

    def popitem(self) -> tuple[int, float | None]:
        """Make one variable vacant and return its number and value."""
        for number in self._clearable():
            return number, self.pop(number)
        raise KeyError("no variable has a value that can be removed")

    def clear(self) -> None:
        """Make all commons and the locals of this level vacant."""
        for number in self._clearable():
            del self[number]

    def _clearable(self) -> list[int]:
        return [number for number in self if self._core.can_be_vacant(number)]

    def level(self, level: int) -> MachineVariables:
        """Return the same variables with the locals of another level, 0 for those of the main
        program.
        """
        if isinstance(level, bool) or not hasattr(level, "__index__"):
            raise TypeError(f"a level must be a whole number, not {level!r}")
        if not 0 <= level <= self._core.level:
            raise ValueError(f"the open levels are 0 to {self._core.level}, not {level}")
        return MachineVariables(self._core, level)


class _ByName(dict[str, Any]):
    """Values by name, as they were when they were asked for. What sets one sets it in the machine;
    none can be added or taken out.
    """

    def _put(self, name: str, value: Any) -> Any:
        """Set a value in the machine and return what holds there now."""
        raise NotImplementedError

    def __setitem__(self, name: str, value: Any) -> None:
        if name not in self:
            known = f"; there are {', '.join(self)}" if self else ""
            raise KeyError(f"there is no {name!r} to be set{did_you_mean(name, self, known)}")
        super().__setitem__(name, self._put(name, value))

    def update(self, *given: Any, **named: Any) -> None:
        for name, value in dict(*given, **named).items():
            self[name] = value

    def __ior__(self, given: Any) -> Any:  # type: ignore[misc]
        self.update(given)
        return self

    def _refuse(self, *_: Any) -> Any:
        raise TypeError("a value of a machine cannot be taken out or added; it can be set")

    __delitem__ = pop = popitem = clear = setdefault = _refuse


_WITH_CODE = {"H": "modal['length'] = 'G43 H1'", "D": "modal['radius'] = 'G41 D1'"}


class Modes(_ByName):
    """The modal codes of a machine by group, and the values of F, S, T, H and D."""

    def __init__(self, core: _core.Machine) -> None:
        super().__init__(core.modal)
        self._core = core

    def _put(self, name: str, value: Any) -> str:
        if len(name) == 1:
            if isinstance(value, bool) or not isinstance(value, int | float | str):
                raise TypeError(f"modal[{name!r}] must be a number, not {value!r}")
            text = f"{name}{value}" if isinstance(value, str) else f"{name}{value:.10g}"
            if isinstance(value, float) and "." not in text:
                text += "."
        elif isinstance(value, str):
            text = value
        else:
            raise TypeError(f"modal[{name!r}] must be a code such as 'G91', not {value!r}")
        try:
            self._core.set_mode(name, one_line(text))
        except ValueError as error:
            cure = f" (give it with its code: {_WITH_CODE[name]})" if name in _WITH_CODE else ""
            raise ValueError(f"modal[{name!r}] = {value!r}: {error}{cure}") from None
        return self._core.modal[name]


class Position(_ByName):
    """The position of a machine by axis, mm: work coordinates, or those of the machine."""

    def __init__(self, core: _core.Machine, *, in_machine: bool) -> None:
        self._core = core
        self._in_machine = in_machine
        super().__init__(self._now())

    def _now(self) -> dict[str, float]:
        return self._core.position_in_machine if self._in_machine else self._core.position

    def _put(self, name: str, value: Any) -> float:
        what = f"{'machine_' if self._in_machine else ''}position[{name!r}]"
        number = checked_number(what, value)
        try:
            self._core.set_position(name, number, self._in_machine)
        except ValueError as error:
            raise ValueError(f"{what} = {value!r}: {error}") from None
        return self._now()[name]


class _Array(list[Any]):
    """The elements of a variable, which is set as a whole."""

    def __setitem__(self, index: Any, value: Any) -> None:
        raise TypeError("set the whole variable: variables.named['SIDES'] = [5, 6]")


def _array(values: Any) -> Any:
    return _Array(map(_array, values)) if isinstance(values, list) else values


def _flat(what: str, values: Any) -> list[Any]:
    """Return the values of a variable, of an array row by row; `what` names it in an error."""
    if isinstance(values, list | tuple):
        return [each for value in values for each in _flat(what, value)]
    if not isinstance(values, int | float | str):
        raise TypeError(f"{what} must be a number or a text, not {values!r}")
    try:
        return [values if isinstance(values, str) else float(values)]
    except OverflowError:
        raise ValueError(f"{what} must be a number of 64 bits, not {str(values)[:20]}...") from None


class NamedVariables(_ByName):
    """The variables of a machine that programs define, by name."""

    def __init__(self, core: _core.Machine, level: int) -> None:
        super().__init__(
            (name, _array(value)) for name, value in core.named_variables(level).items()
        )
        self._core = core
        self._level = level

    def _put(self, name: str, value: Any) -> Any:
        values = _flat(f"named[{name!r}]", value)
        try:
            self._core.set_named(name, values, self._level)
        except ValueError as error:
            raise ValueError(f"named[{name!r}] = {value!r}: {error}") from None
        return _array(self._core.named_variables(self._level)[name])


class Signals(NotPicklable, MutableMapping[int, float]):
    """The interface inputs of a machine by variable number, to read and to set. A signal that was
    never set is 0; iteration gives those that were set.

    A number or a name that is no signal of the control is a `KeyError`.

    >>> import cncsub
    >>> text = "O1\\nN10 #100=#1004\\nN20 M30\\n"
    >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
    >>> machine.signals[1004] = 1
    >>> machine.step().n, machine.variables[100], machine.signals
    (10, 1.0, {1004: 1})
    """

    _instead = "send dict(signals)"

    def __init__(self, core: _core.Machine) -> None:
        self._core = core

    def _number(self, name: Any) -> Any:
        if not isinstance(name, str):
            return name
        try:
            return number_of("signals", self._core.code.control, name)
        except ValueError as error:
            raise KeyError(str(error).removeprefix("signals: ")) from None

    def __getitem__(self, name: int | str) -> float:
        number = self._number(name)
        if isinstance(number, bool) or not hasattr(number, "__index__"):
            raise KeyError(f"a signal must be a whole number such as 1004, not {number!r}")
        try:
            return self._core.get_signal(operator.index(number))
        except (TypeError, LookupError) as error:
            raise _no_variable(number, error) from None

    def __setitem__(self, number: int | str, value: float) -> None:
        named = checked_variables("signals", {self._number(number): value})
        ((checked, number_or_none),) = by_number("signals", self._core.code.control, named).items()
        try:
            self._core.set_signal(checked, number_or_none or 0.0)
        except LookupError as error:
            raise _no_variable(number, error) from None

    def __delitem__(self, number: int | str) -> None:
        self[number] = 0

    def __iter__(self) -> Iterator[int]:
        return iter(self._core.signals)

    def __len__(self) -> int:
        return len(self._core.signals)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{number}: {self[number]:g}" for number in self) + "}"
