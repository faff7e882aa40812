"""The rows of the conformance tables: the content of a row and how it is written.

The topics stand in folders: a folder for each family of controls, and `shared` for what several
families say. A file calls `case` once per claim, and `rows()` reads all files. `cncsub.testing`
compares what a row says with the engine.
"""

from __future__ import annotations

import dataclasses
import functools
import importlib.util
import re
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from cncsub import _core
from cncsub.testing import cases as cases_of

FOLDER = Path(__file__).parent
EVIDENCE = ("source document", "maker's manual", "secondary", "inferred")
UNKNOWN = cases_of.UNKNOWN


@dataclass(frozen=True, kw_only=True)
class Case(cases_of.Case):
    """A case of these tables, with the worth of its source and the rules that it pins."""

    evidence: Mapping[str, str]  # of each control: as stated, but no stronger than its source there
    pins: tuple[str, ...]  # rules that make the row fail if they have another value

    def told_on(self, control: str) -> str:
        return f"{super().told_on(control)} ({self.evidence[control]})"


class Row(NamedTuple):
    """A case on one of its controls."""

    case: Case
    control: str

    def __str__(self) -> str:
        return f"{self.case.topic}: {self.case.claim} [{self.control}]"


_cases: list[Case] = []


def case(
    claim: str,
    *,
    control: str | Sequence[str],
    source: str | Mapping[str, str],
    evidence: str | Mapping[str, str] | None = None,
    pins: str = "",
    **said: Any,
) -> None:
    """Write one row: what `cncsub.testing.case` takes, and what the row is worth.

    `pins` are the rules that make the row fail if they have another value (`mutation.py`). Without
    `evidence` the source has to be one of the source documents. `source`, `evidence`, `number` and
    `word` are mappings if the controls of a row differ in them.
    """
    caller = sys._getframe(1)
    topic = Path(caller.f_code.co_filename).relative_to(FOLDER).with_suffix("").as_posix()
    line = caller.f_lineno
    try:
        made = cases_of.read_case(
            claim, control=control, source=source, topic=topic, line=line, **said
        )
        if not isinstance(evidence, str | None) and not set(evidence) <= set(made.controls):
            raise ValueError(f"{claim!r} gives evidence for other controls than it runs on")
    except ValueError as error:
        raise ValueError(f"{topic}.py:{line}: {error}") from None
    worth = {name: _evidence(source, evidence, name) for name in made.controls}
    fields = {field.name: getattr(made, field.name) for field in dataclasses.fields(made)}
    _cases.append(Case(**fields, evidence=worth, pins=tuple(pins.split())))


# Rules that no row can notice on a control, with the reason: rows give these besides `unpinned.py`.
_inert: dict[str, dict[str, str]] = {}


def inert(rules: str, *, control: str, reason: str) -> None:
    """Say that no row can notice these rules on a control, and why."""
    for rule in rules.split():
        _inert.setdefault(rule, {})[control] = reason


def inert_rules() -> Mapping[str, Mapping[str, str]]:
    """Return what the rows say by `inert`: for each rule and control, the reason."""
    cases()
    return _inert


def _evidence(
    source: str | Mapping[str, str], stated: str | Mapping[str, str] | None, control: str
) -> str:
    """Return what a row is worth on a control, empty where it does not say."""
    text = source if isinstance(source, str) else source.get(control, "")
    said = stated if isinstance(stated, str | None) else stated.get(control)
    if said is None and re.match(r"source 00\d", text):
        said = "source document"
    if said not in EVIDENCE:
        return ""
    return max(said, _core.strongest(text, control), key=EVIDENCE.index)


def topic_files() -> list[Path]:
    """Return the files that hold rows: all in the folders; the harness stands outside of them."""
    return sorted(FOLDER.glob("*/**/*.py"))


@functools.cache
def cases() -> tuple[Case, ...]:
    """Return the cases of all topic files."""
    for file in topic_files():
        # Two families have topics of one name, so a module is not named by its file alone.
        name = ".".join(("conformance_rows", *file.relative_to(FOLDER).with_suffix("").parts))
        spec = importlib.util.spec_from_file_location(name, file)
        assert spec is not None
        assert spec.loader is not None
        spec.loader.exec_module(importlib.util.module_from_spec(spec))
    return tuple(_cases)


def motion_causes() -> set[str]:
    """Return the causes of the motion, each of which points at a word of its block: those that
    follow the missing feed in the list of causes. A code that is not computed is the claim of its
    row, and a position is read in an expression.
    """
    slugs = [slug for slug, *_ in _core.causes()]
    of_motion = set(slugs[slugs.index("no-feed") :])
    return of_motion - {"code-not-computed", "position-in-offset"}


@functools.cache
def rows() -> tuple[Row, ...]:
    """Return every case once for each of its controls."""
    return tuple(Row(case, control) for case in cases() for control in case.controls)
