"""The controls, the causes of alarms, and the sources of both."""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeVar

from cncsub import _core
from cncsub._core import Alarm
from cncsub._core import Control as Control

T = TypeVar("T")
_FIRST_MADE = 9001  # number of the first program that is made


class Cause(NamedTuple):
    """A cause that can stop a program, by our own name for it: slug, meaning and cure."""

    slug: str
    meaning: str
    cure: str


EVIDENCE = ("source document", "maker's manual", "secondary", "inferred")


class Source(NamedTuple):
    """A source of facts: the key they cite it by, what it is, where it can be read, the controls it
    is about, and how strong it is on these.
    """

    key: str
    title: str
    address: str
    controls: tuple[str, ...]
    evidence: str

    def on(self, control: str) -> str:
        """Return the strongest evidence that the source can be on a control: another control's
        manual or document is secondary at best.

        >>> import cncsub
        >>> cncsub.sources["TA"].on("gsk-988ta"), cncsub.sources["TA"].on("gsk-988t")
        ("maker's manual", 'secondary')
        """
        own = control in self.controls
        return self.evidence if own else max(self.evidence, "secondary", key=EVIDENCE.index)


def near_names(name: object, names: Iterable[str], *, most: int = 3) -> list[str]:
    """Return the names that somebody who wrote `name` most likely meant, the likeliest first."""
    import difflib

    folded = {known.casefold(): known for known in names}
    wanted = str(name).casefold()
    near = difflib.get_close_matches(wanted, folded, n=most, cutoff=0.5)
    near += [known for known in folded if wanted and wanted in known and known not in near]
    return [folded[known] for known in near[:most]]


def did_you_mean(name: object, names: Iterable[str], otherwise: str = "") -> str:
    """Return `; did you mean ...?` for the end of a message, or `otherwise`."""
    near = near_names(name, names)
    return f"; did you mean {', '.join(near)}?" if near else otherwise


def names_beginning(letters: str) -> list[str]:
    """Return the names of controls that begin with `letters`, for the completion of a shell; their
    aliases, where no name does.
    """
    names = [name for name in controls if name.startswith(letters)]
    return names or [alias for alias in aliases if alias.startswith(letters)]


class Named(Mapping[str, T]):
    """A mapping whose `KeyError` suggests similar names. `others` are further names of entries:
    they are found, and not listed.
    """

    def __init__(
        self,
        what: str,
        read: Callable[[], dict[str, T]],
        others: Callable[[], Mapping[str, str]] = dict,
    ) -> None:
        self._what = what
        self._read = read
        self._read_others = others

    @functools.cached_property
    def _entries(self) -> dict[str, T]:
        return self._read()

    @functools.cached_property
    def _others(self) -> Mapping[str, str]:
        return self._read_others()

    def __getitem__(self, name: str) -> T:
        try:
            return self._entries[self._others.get(name, name)]
        except (KeyError, TypeError):
            there = f"; there are {', '.join(self._entries)}"
            known = did_you_mean(name, [*self._entries, *self._others], there)
            raise KeyError(f"there is no {self._what} {name!r}{known}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def __repr__(self) -> str:
        return f"<{len(self)} {self._what}s: {', '.join(self)}>"


class Alias(NamedTuple):
    """Another name of a control, and who says that it is the same one."""

    name: str
    control: str
    source: str
    evidence: str


aliases: Mapping[str, Alias] = Named(
    "alias", lambda: {name: Alias(name, *rest) for name, *rest in _core.aliases()}
)
"""The other names of controls: models of one series, and names that people write.

>>> import cncsub
>>> cncsub.aliases["fanuc-31i"].control
'fanuc-30i'
"""

controls: Mapping[str, Control] = Named(
    "control",
    lambda: {c.base: c for c in _core.controls()},
    lambda: {alias.name: alias.control for alias in aliases.values()},
)
"""Every control by its name, in listing order; an alias finds its control, and is not listed.

>>> import cncsub
>>> cncsub.controls["fanuc-0i-f"].alarms["program-not-found"].number
'PS0076'
>>> cncsub.controls["fanuc-31i"].name
'fanuc-30i'
"""


def aliases_of(control: Control) -> list[str]:
    """Return the other names of a control."""
    return [alias.name for alias in aliases.values() if alias.control == control.base]


def alias_named(name: str) -> Alias | None:
    """Return the alias that a name means in any spelling; `None` where it is a control's own."""
    letters = "".join(_words(name))
    for whole in (True, False):
        if any(letters in _spellings(known, whole) for known in controls):
            return None
        for alias in aliases.values():
            if letters in _spellings(alias.name, whole):
                return alias
    return None


def inferred_rules(control: Control) -> int:
    """Return how many of the rules that a control answers are inferred: no source says them.

    >>> import cncsub
    >>> control = cncsub.controls["linuxcnc"]
    >>> inferred_rules(control) < len(control.rules)
    True
    """
    return sum(evidence_of(rule) == EVIDENCE[-1] for rule in control.rules)


def evidence_of(rule: _core.Rule) -> str:
    """Return how far a rule may be trusted: a list as far as the weakest of the entries that it
    has. An entry without a source of its own may be trusted as far as the rule says.
    """
    sources = rule.sources
    told = (
        sources.get(entry) or sources.get(entry.partition("=")[0])
        for entry in str(rule.value).split()
    )
    how = [entry[1] if entry else rule.evidence for entry in told]
    return max(how or [rule.evidence], key=EVIDENCE.index)


def evidence_words(control: Control) -> str:
    """Return in words how many rules of a control are inferred: `20 of 52 (38 %)`."""
    count, total = inferred_rules(control), len(control.rules)
    return f"{count} of {total} ({100 * count / total:.0f} %)"


causes: Mapping[str, Cause] = Named(
    "cause", lambda: {slug: Cause(slug, *rest) for slug, *rest in _core.causes()}
)
"""Every cause of an alarm by its slug: what happened, and how to cure it.

>>> import cncsub
>>> cncsub.causes["program-not-found"].meaning
"the called program is not in the control's memory"
"""


def _read_sources() -> dict[str, Source]:
    rows = _core.sources()
    return {key: Source(key, title, at, tuple(of.split()), how) for key, title, at, of, how in rows}


sources: Mapping[str, Source] = Named("source", _read_sources)
"""Every source by the key that rules, alarms and rows cite it by.

>>> import cncsub
>>> cncsub.sources["Talm"].title
'988T alarm list, 000 to 289, with remedies'
"""


def sources_of(control: Control) -> list[Source]:
    """Return the sources that the facts of a control cite, in the order of `sources`."""
    texts = {rule.source for rule in control.rules}
    texts |= {source for rule in control.rules for source, _ in rule.sources.values()}
    texts |= {source for source, _ in control.absent.values()}
    texts |= {parameter.source for parameter in control.parameters.values()}
    texts |= {option.source for option in control.variable_options.values()}
    texts |= {alarm.source for alarm in control.alarms.values()}
    keys = {key for text in texts for key in _core.cited(text)}
    return [source for key, source in sources.items() if key in keys]


def control_named(name: str, among: Mapping[str, Control] = controls) -> Control:
    """Return the control that a name means in any spelling: `Fanuc 0i-F`, `FANUC_0I_F`, `0i-f`.

    Words of its title will do as well, where they are those of one control. `ValueError` lists the
    controls that a name may mean, or names what is near.
    """
    if name in among:
        return among[name]
    meant = _meant(name, among)
    if len(meant) == 1:
        return among[meant[0]]
    if meant:
        raise ValueError(f"{name!r} may be {_either(meant)}: write one of them")
    known = did_you_mean(name, [*among, *aliases], f"; there are {', '.join(among)}")
    raise ValueError(f"there is no control {name!r}{known}")


def _meant(name: str, among: Mapping[str, Control]) -> list[str]:
    """Return the names of the controls that are meant: by the whole name, else by a part of it,
    each time by those of the controls before their aliases; else by words of the title.
    """
    words = _words(name)
    letters = "".join(words)
    if len(letters) < 2:
        return []
    for whole in (True, False):
        if found := [known for known in among if letters in _spellings(known, whole)]:
            return found
        other = [a.control for a in aliases.values() if letters in _spellings(a.name, whole)]
        if found := [known for known in dict.fromkeys(other) if known in among]:
            return found
    return [
        known
        for known, control in among.items()
        if set(words) <= {*_words(known), *_words(control.title)}
    ]


def _words(text: str) -> list[str]:
    return re.findall(r"[^\W_]+", text.casefold())


def _spellings(name: str, whole: bool) -> set[str]:
    """Return the letters of a name, or those of each of its parts, without marks between."""
    words = _words(name)
    if whole:
        return {"".join(words)}
    count = len(words)
    return {"".join(words[i:k]) for i in range(count) for k in range(i + 1, count + 1)}


def _either(names: Sequence[str]) -> str:
    return f"{', '.join(names[:-1])} or {names[-1]}"


def control(name: str | Control) -> Control:
    """Return a control by its name, in any spelling that means one control.

    Raises `ValueError` where a name may be that of several controls, or of none, and names those
    that are near. A control is returned as it is.

    >>> import cncsub
    >>> [cncsub.control(name).name for name in ("Fanuc 0i-F", "FANUC_0I_F", "0i-f")]
    ['fanuc-0i-f', 'fanuc-0i-f', 'fanuc-0i-f']
    >>> cncsub.control("0i")
    Traceback (most recent call last):
    ValueError: '0i' may be fanuc-0i-d or fanuc-0i-f: write one of them
    """
    if isinstance(name, Control):
        return name
    if not isinstance(name, str):
        raise TypeError(
            "control must be a name such as 'fanuc-0i-f' or a cncsub.Control,"
            f" not {type(name).__name__}"
        )
    return control_named(name)


control_of = control


@functools.cache
def rule_value(control: Control, name: str) -> object:
    """Return the value of a rule of a control; `None` where it has none of that name."""
    return _rule_values(control).get(name)


@functools.lru_cache(maxsize=64)
def _rule_values(control: Control) -> dict[str, object]:
    """Return the values of all rules of a control, which never change: they are 250 objects."""
    return {rule.name: rule.value for rule in control.rules}


def first_made_number(control: Control) -> int:
    """Return the number of the first program that is made for a control: O9001, or less where its
    programs have no such numbers.
    """
    most = rule_value(control, "max_program_number")
    return min(_FIRST_MADE, int(str(most)) - 98) if most is not None else _FIRST_MADE


def cure_of(alarm: Alarm, control: Control) -> str:
    """Return what to change in a program that raised an alarm, in the words of the control."""
    return _core.told_for(control)[1][alarm.cause][1]
