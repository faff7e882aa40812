"""How much of what programs depend on is inferred: the weight of a rule is whether another value of
it changes what an example, or a row of real programs, does on the control.
"""

from __future__ import annotations

import functools
import re
import sys
import textwrap
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import cncsub
from cncsub.controls import EVIDENCE, evidence_of
from cncsub.files import decode
from cncsub.questions.outcome import Short, seen
from cncsub.questions.values import answers, changed, entries_of

_ROOT = Path(__file__).resolve().parents[2]
_ROWS = _ROOT / "tests" / "conformance"
_MOST_VALUES = 2  # other values of a rule that are tried
_MOST_PROGRAMS = 10  # of a control: every example, and rows from the first to the last


class Weighted(NamedTuple):
    """The rules that programs depend on, those of them that are inferred, and how many programs."""

    touched: tuple[str, ...]
    inferred: tuple[str, ...]
    programs: int

    @property
    def share(self) -> float:
        return len(self.inferred) / len(self.touched) if self.touched else 0.0


@functools.cache
def weighted(name: str) -> Weighted:
    """Return what the programs of a control depend on."""
    control = cncsub.controls[name]
    before = [(program, there) for program in programs(name) if (there := seen(program, control))]
    touched = tuple(
        rule.name
        for rule in control.rules
        if any(
            seen(program, other) != there
            for other in _others(control, rule)
            for program, there in before
        )
    )
    evidence = {rule.name: evidence_of(rule) for rule in control.rules}
    inferred = tuple(name for name in touched if evidence[name] == EVIDENCE[-1])
    return Weighted(touched, inferred, len(before))


def _others(control: cncsub.Control, rule: Any) -> Iterator[cncsub.Control]:
    """Yield the control with other values of a rule; of a set, without each of its entries."""
    if isinstance(rule.value, int) and not isinstance(rule.value, bool) and rule.value == 0:
        # 0 is no bound at all: the tightest one that another control has is tried, not 1.
        bounds = {answers(other).get(rule.name, 0) for other in cncsub.controls} - {0}
        yield from (control.replace(**{rule.name: bound}) for bound in sorted(bounds)[:1])
        return
    entries = [entry for entry in entries_of(rule) if entry in str(rule.value).split()]
    words = [f"{rule.name}:{entry}" for entry in entries] if entries_of(rule) else [rule.name]
    for word in words:
        yield from (mutant for _, mutant in islice(changed(control, word), _MOST_VALUES))


def programs(name: str) -> list[Short]:
    """Return the examples of the control's maker, and the rows of real programs on the control."""
    maker = name.partition("-")[0]
    files = [f for f in sorted((_ROOT / "examples" / maker).rglob("*")) if f.is_file()]
    texts = [decode(file.read_bytes()) for file in files if file.suffix not in {".toml", ".txt"}]
    real = list(dict.fromkeys(_real(name)))
    step = max(1, -(-len(real) // max(1, _MOST_PROGRAMS - len(texts))))
    return list(dict.fromkeys([*map(Short, texts), *real[::step]]))


def _real(name: str) -> Iterator[Short]:
    """Yield the programs of rows that say that real programs hold them."""
    sys.path.insert(0, str(_ROWS))
    try:
        from conformance import cases
    finally:
        sys.path.remove(str(_ROWS))
    for case in cases():
        if name not in case.controls or not isinstance(case.program, str):
            continue
        source = case.source if isinstance(case.source, str) else case.source.get(name, "")
        if re.search(r"real program|shops|real_programs", f"{source} {case.topic}"):
            machine = str((case.setup or {}).get("machine", ""))
            yield Short(textwrap.dedent(case.program).strip() + "\n", machine)
