"""New sequence numbers for blocks, with everything that names them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Literal

from cncsub import _core
from cncsub.checking import Edit
from cncsub.controls import rule_value
from cncsub.editing.edits import Edits, known_files, listed
from cncsub.editing.errors import refusal
from cncsub.editing.mentions import Mention, mentions
from cncsub.library import Library
from cncsub.option_errors import carrying

Which = Literal["all", "numbered", "targets"]
WHICH = ("all", "numbered", "targets")

_Key = tuple[int | None, int | None]  # a program and one of its blocks
_Cause = tuple[int, int | None, str]  # a program, one of its blocks, and why it is refused


def renumber(
    library: Library,
    programs: Iterable[str | int] | None = None,
    start: int = 10,
    step: int = 10,
    which: Which = "numbered",
    *,
    files: Iterable[str] | None = None,
    machine: str = "",
) -> Edits:
    """Return the edits that give the blocks of programs new sequence numbers, in order, and follow
    every jump, call, return and cycle that names one of them, in all programs of the library.

    `programs`: names or numbers; all of the memory without it. `files`: those of these files alone,
    named as in `library.files`. `start`: the number of the first
    block of each program; `step`: what is added for each next one. `which`: `"numbered"`: the
    blocks that have a number; `"all"`: every block, as far as the control takes a number there;
    `"targets"`: the blocks that something names; the others lose their number, but for those that
    have no other word. `machine`: the kind
    of machine, as in `Setup`, where P and Q of a cycle name blocks on a lathe only.

    A number that leads nowhere is kept, and no block gets it. Raises `EditError` where a number is
    computed, stands on the external device, leads to different new numbers, or would be larger than
    the control allows; `ValueError` for wrong options.

    >>> import cncsub
    >>> from cncsub.editing import renumber
    >>> text = "O1\\nN1 #1=0\\nN2 #1=#1+1\\nN3 IF [#1 LT 3] GOTO 2\\nN4 M30\\n"
    >>> made = renumber(cncsub.loads(text, control="fanuc-0i-f"))
    >>> print(made.texts["<text>"], end="")
    O1
    N10 #1=0
    N20 #1=#1+1
    N30 IF [#1 LT 3] GOTO 20
    N40 M30
    >>> made.prove().ran
    ('O1',)
    """
    _check(start, step, which)
    kinds = "block unnumbered" if which == "all" else "block"
    chosen = _chosen(library, programs)
    if files is not None:
        known = known_files(library, files)
        chosen = frozenset(i for i in chosen if library.code.program(i).file in known)
    return _Renumbering(library, chosen, kinds, machine).edits(start, step, which)


def _check(start: int, step: int, which: str) -> None:
    for name, value, least in (("start", start, 0), ("step", step, 1)):
        if isinstance(value, bool) or not isinstance(value, int):
            raise carrying(name, TypeError(f"{name} must be a whole number, not {value!r}"))
        if value < least:
            raise carrying(name, ValueError(f"{name} must be at least {least}, not {value}"))
    if which not in WHICH:
        raise carrying("which", ValueError(f"which must be {', '.join(WHICH)}, not {which!r}"))


def _chosen(library: Library, programs: Iterable[str | int] | None) -> frozenset[int]:
    code = library.code
    own = [i for i in range(len(code)) if not (code.program(i).external or code.program(i).system)]
    if programs is None:
        return frozenset(own)
    if isinstance(programs, str):
        raise TypeError(f"programs must be a list of names, not the text {programs!r}")
    found = [library[name].index for name in programs]
    # The parts of a program, which share its blocks, belong to it.
    spans = {code.program(place).span for place in found}
    inside = [i for i in own if code.program(i).inside and _lies_in(code.program(i).span, spans)]
    for place in found:
        if code.program(place).external:
            raise ValueError(
                f"{code.program(place).name} is on the external device: it is not edited"
            )
    return frozenset([*found, *inside])


def _lies_in(span: tuple[int, int, int], spans: Iterable[tuple[int, int, int]]) -> bool:
    file, first, last = span
    return any(file == at and a <= first and last <= b for at, a, b in spans)


class _Renumbering:
    """The numbers of some programs, and what names them."""

    def __init__(self, library: Library, chosen: frozenset[int], kinds: str, machine: str) -> None:
        self._library = library
        self._chosen = chosen
        self._machine = machine
        numbers = [m for m in mentions(library, kinds, machine=machine) if m.kind == "number"]
        self._own = [m for m in numbers if m.defines and m.program in chosen]
        self._uses = [m for m in numbers if not m.defines]
        self._new: dict[_Key, int | None] = {}  # None: the block loses its number
        self._notes: list[str] = []

    def edits(self, start: int, step: int, which: Which) -> Edits:
        self._refuse_computed()
        targets: set[_Key] = {
            (m.to_program, m.to_block) for m in self._uses if m.to_block is not None
        }
        self._count(start, step, which, targets)
        self._refuse_too_large(targets, which)
        edits = [*self._of_blocks(), *self._of_uses()]
        self._tell_duplicates()
        self._tell_refused()
        notes = tuple(self._notes)
        made = Edits(self._library, tuple(sorted(edits)), notes, machine=self._machine)
        return made if which != "all" else self._without_refused(made)

    # ---- what cannot be done ----

    def _refuse_computed(self) -> None:
        causes: list[_Cause] = []
        for m in self._uses:
            if not m.computed or (m.to_program is not None and m.to_program not in self._chosen):
                continue
            why = f"{m.text} names a block that is known only when it runs"
            if m.number is not None:
                why = (
                    f"{m.text} may name a block: what the code beside it means on this kind of"
                    f" machine is not known{_LATHE if not self._machine else ''}"
                )
            causes.append((m.program, m.block, why))
        if causes:
            raise refusal(self._library, causes)

    def _refuse_too_large(self, targets: set[_Key], which: Which) -> None:
        for name, counted in (("max_sequence_number", False), ("max_jump_number", True)):
            most = rule_value(self._library.control, name)
            if not isinstance(most, int):
                continue
            for (program, block), n in self._new.items():
                if n is None or n <= most or (counted and (program, block) not in targets):
                    continue
                assert program is not None
                what = "a jump reaches" if counted else "the control has"
                cure = "" if which == "targets" else ", or which='targets'"
                why = f"it would be N{n}, and {what} numbers to {most}; use a smaller step{cure}"
                raise refusal(self._library, [(program, block, why)])

    # ---- the numbers ----

    def _count(self, start: int, step: int, which: Which, targets: set[_Key]) -> None:
        kept: dict[int | None, set[int]] = {}  # numbers that lead nowhere
        for m in self._uses:
            if m.to_block is None and m.number is not None:
                kept.setdefault(m.to_program, set()).add(m.number)
        next_of: dict[int, int] = {}
        whole = self._whole_programs()
        for m in sorted(self._own, key=lambda m: (whole[m.program], m.line, m.column)):
            key = (m.program, m.block)
            if which == "targets" and key not in targets and m.word:
                self._new[key] = None
                continue
            n = next_of.get(whole[m.program], start)
            while n in kept.get(m.program, ()):
                n += step
            self._new[key] = n
            next_of[whole[m.program]] = n + step

    def _whole_programs(self) -> list[int]:
        """Return for each program the one that it is a part of: itself, or the one before."""
        whole = 0
        found = []
        for index in range(len(self._library.code)):
            whole = whole if self._library.code.program(index).inside else index
            found.append(whole)
        return found

    def _tell_refused(self) -> None:
        """Tell the blocks that the control refuses: what they name is not known."""
        lines: dict[int, list[int]] = {}
        for program, block in _core.refused_blocks(self._library.code):
            if program in self._chosen and self._new:
                line = self._library.code.program(program).block(block)[1]
                lines.setdefault(program, []).append(line)
        for program, of in lines.items():
            name = self._library.code.program(program).name
            what = "the block of line" if len(of) == 1 else "the blocks of lines"
            why = "a number that such a block names is left as it is"
            self._notes.append(f"{name}: the control refuses {what} {listed(of)}; {why}")

    def _tell_duplicates(self) -> None:
        lines: dict[tuple[int, int], list[int]] = {}
        for m in self._own:
            if m.number is not None:
                lines.setdefault((m.program, m.number), []).append(m.line)
        for (program, number), of in lines.items():
            if len(of) > 1:
                name = self._library.code.program(program).name
                told = f"N{number} is in lines {listed(of)}"
                self._notes.append(f"{name}: {told}; each has its own number now")

    # ---- the edits ----

    def _of_blocks(self) -> Iterator[Edit]:
        causes: list[_Cause] = []
        for m in self._own:
            n = self._new[m.program, m.block]
            if m.number is None:
                yield Edit(m.file, m.line, m.column, m.text, f"N{n} {m.text}")
            elif n is None:
                yield Edit(m.file, m.line, m.word_column, m.word, "")
            elif m.fixed:
                causes.append(
                    (m.program, m.block, f"N{m.number} is written so that it cannot be changed")
                )
            elif (new := _like(m.text, n)) != m.text:
                yield Edit(m.file, m.line, m.column, m.text, new)
        if causes:
            raise refusal(self._library, causes)

    def _of_uses(self) -> Iterator[Edit]:
        by_place: dict[tuple[str, int, int], list[Mention]] = {}
        for m in self._uses:
            if not m.computed:
                by_place.setdefault((m.file, m.line, m.column), []).append(m)
        causes: list[_Cause] = []
        for of_place in by_place.values():
            m = of_place[0]
            wanted = {self._wanted(each) for each in of_place}
            if len(wanted) > 1:
                told = ", ".join(sorted(f"N{n}" for n in wanted))
                why = f"{m.text} names blocks of several programs, which would become {told}"
                causes.append((m.program, m.block, why))
                continue
            n = wanted.pop()
            if n is None or n == m.number:
                continue
            if m.fixed or self._library.code.program(m.program).external:
                where = (
                    "is on the external device" if not m.fixed else "cannot be written otherwise"
                )
                causes.append((m.program, m.block, f"{m.text} names N{n}, and {where}"))
                continue
            yield Edit(m.file, m.line, m.column, m.text, _like(m.text, n))
        if causes:
            raise refusal(self._library, causes)

    def _wanted(self, m: Mention) -> int | None:
        """Return the number that a use has to name."""
        if m.to_block is None:
            return m.number
        return self._new.get((m.to_program, m.to_block), m.number)

    def _without_refused(self, made: Edits) -> Edits:
        """Leave out the numbers of blocks that take none on this control."""
        before = {(m.program, m.block) for m in self._own}
        taken = {
            (m.program, m.block)
            for m in mentions(made.after, "block")
            if m.defines and m.number is not None
        }
        refused = set(_core.refused_blocks(made.after.code)) - set(
            _core.refused_blocks(self._library.code)
        )
        lost = {key for key in before if key not in taken or key in refused}
        if not lost:
            return made
        lines = {
            (m.file, m.line, m.column)
            for m in self._own
            if (m.program, m.block) in lost and m.number is None
        }
        kept = tuple(e for e in made.edits if (e.file, e.line, e.column) not in lines)
        count = len(made.edits) - len(kept)
        note = f"{count} block{'' if count == 1 else 's'} can have no number on this control"
        return replace(made, edits=kept, notes=(*made.notes, note))


_LATHE = '; for a lathe give machine="lathe-a" (or the setup of the machine)'


def _like(old: str, n: int) -> str:
    """Return a number written as another one was: N0010 has four digits."""
    digits = "".join(old.split())
    return str(n).zfill(len(digits)) if digits.startswith("0") else str(n)
