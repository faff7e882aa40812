"""Another number or name for a block, a label, a program or a variable, with all that names it."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from cncsub import _core
from cncsub.checking import Edit
from cncsub.controls import rule_value
from cncsub.editing.edits import Edits
from cncsub.editing.errors import EditError, refusal
from cncsub.editing.mentions import Mention, mention_at, mentions, thing
from cncsub.editing.proof import same_as_written
from cncsub.library import Library
from cncsub.program import find_program


def rename(
    library: Library,
    what: Mention | tuple[str, int, int] | str,
    new: str | int,
    *,
    program: str | int | None = None,
    machine: str = "",
) -> Edits:
    """Return the edits that give one block, label, program or variable another number or name, and
    follow everything that names it, in all programs of the library.

    `what`: a `Mention` of it, the place of one (file, line, column), or the thing as it is called:
    `N10`, `O2`, `#100`, `R1`, a label, the name of a variable. `program`: the program of a block, a
    label or a local variable that is given so; the main program without it. `new`: the number or
    name, as `20`, `N20`, `O3`, `#150`. `machine`: as for `renumber`.

    A program that its file names needs another name of the file: `Edits.files` tells it. Raises
    `EditError` where the new one is taken already, or the old one is named by something that cannot
    be written otherwise or is computed; `KeyError` where there is no such thing; `ValueError` for a
    new number or name that none can be.

    >>> import cncsub
    >>> from cncsub.editing import rename
    >>> text = "O1\\nN10 M98 P30002\\nN20 M30\\nO2\\nN30 M99\\n"
    >>> made = rename(cncsub.loads(text, control="fanuc-0i-f"), "O2", "O7")
    >>> [(edit.line, edit.column, edit.old, edit.new) for edit in made.edits]
    [(2, 11, '0002', '0007'), (4, 2, '2', '7')]
    """
    every = mentions(library, machine=machine)
    found = _mentioned(library, every, what, program, machine)
    job = _Renaming(library, every, found, _plain(library, found, new))
    made = replace(job.edits(), machine=machine)
    same_as_written(made)
    return made


def _mentioned(
    library: Library,
    every: Sequence[Mention],
    what: Mention | tuple[str, int, int] | str,
    program: str | int | None,
    machine: str,
) -> Mention:
    """Return a mention of the thing that is meant."""
    if isinstance(what, Mention):
        return what
    if isinstance(what, tuple):
        found = mention_at(library, *what, machine=machine)
        if found is None:
            file, line, column = what
            raise KeyError(f"nothing at {file}:{line}:{column} can be renamed")
        return found
    if not isinstance(what, str):
        raise TypeError(f"what must be a Mention, a place or a name, not {what!r}")
    index = _program_of(library, program)
    sign = _sign(library)
    for m in every:
        if m.computed or not (_spelled(m, what, sign) or _is_program(library, m, what)):
            continue
        if m.kind == "program" or m.to_program in (index, None):
            return m
    where = "" if program is None else f" in {program}"
    raise KeyError(f"there is no {what}{where} that could be renamed")


def _program_of(library: Library, program: str | int | None) -> int | None:
    if program is not None:
        return library[program].index
    return None if library.main is None else library.main.index


def _is_program(library: Library, m: Mention, what: str) -> bool:
    return (
        m.kind == "program"
        and m.to_program is not None
        and find_program(library.code, what) == m.to_program
    )


def _spelled(m: Mention, what: str, sign: str) -> bool:
    """Return whether a text is how a thing is called."""
    text = what.strip().upper()
    if m.kind == "variable":
        own = m.name.upper() if m.number is None else f"{sign}{m.number}"
        return text in (own, f"{sign}{own}", f"{sign}<{own}>")
    return text == m.shown.upper()


def _sign(library: Library) -> str:
    return library.code.variable_sign


def _plain(library: Library, m: Mention, new: str | int) -> str:
    """Return the number or the name alone of what `new` writes; `ValueError` if it is none."""
    if isinstance(new, bool) or not isinstance(new, str | int):
        raise TypeError(f"new must be a number or a name, not {new!r}")
    text = str(new).strip()
    sign = {"number": "N", "label": "", "program": "O", "variable": _sign(library)}[m.kind]
    if text.upper().startswith(sign) and text[len(sign) :][:1].isdecimal() and m.number is not None:
        text = text[len(sign) :]
    elif m.kind == "variable" and sign == "#":
        text = text.removeprefix(sign).removeprefix("<").removesuffix(">")
    if m.number is not None:
        if not (text.isascii() and text.isdecimal() and len(text) <= 15):
            raise ValueError(f"{m.shown} has a number: {new!r} is none")
        return str(int(text))
    if m.kind in ("label", "program") and m.name.isdecimal() != text.isdecimal():
        raise ValueError(f"{m.shown} and {new!r} have to be two numbers, or two names")
    plain = text.replace("_", "").replace("-", "").replace(".", "")
    if not (
        plain.isascii() and plain.isalnum() and text[0].isascii() and not text[0].isdecimal()
    ) and not (m.kind in ("label", "program") and text.isdecimal()):
        raise ValueError(f"{new!r} is no name")
    return text


class _Renaming:
    def __init__(
        self, library: Library, every: Sequence[Mention], found: Mention, new: str
    ) -> None:
        self._library = library
        self._every = every
        self._found = found
        self._new = new
        self._things = self._meant()
        self._places = {place for _, place, *_ in self._things}

    def _meant(self) -> set[tuple[object, ...]]:
        """Return what counts as the thing: a local is one of all programs that share it."""
        own = thing(self._found)
        if not self._is_local():
            return {own}
        kind, program, called = own
        group = self._sharing(program)
        return {(kind, each, called) for each in group}

    def _is_local(self) -> bool:
        found = self._found
        return (
            found.kind == "variable" and found.to_program is not None and found.number is not None
        )

    def _sharing(self, program: object) -> set[object]:
        """Return the programs that a local of this one is a variable of: subprograms have the
        locals of their callers.
        """
        code = self._library.code
        pairs: dict[object, set[object]] = {}
        for caller, _, row in _core.all_calls(code):
            if row[2] is not None and not row[11]:
                pairs.setdefault(caller, set()).add(row[2])
                pairs.setdefault(row[2], set()).add(caller)
        group, waiting = {program}, [program]
        while waiting:
            for other in pairs.get(waiting.pop(), set()) - group:
                group.add(other)
                waiting.append(other)
        return group

    def edits(self) -> Edits:
        own = [m for m in self._every if not m.computed and thing(m) in self._things]
        if self._found.number is not None and self._new == str(self._found.number):
            return Edits(self._library, ())
        self._refuse_taken()
        self._refuse_computed()
        self._refuse_unwritable(own)
        edits = tuple(
            sorted(
                {
                    Edit(m.file, m.line, m.column, m.text, self._written(m))
                    for m in own
                    if not m.fixed and self._written(m) != m.text
                }
            )
        )
        self._refuse_too_large(own)
        return self._with_names(own, edits)

    def _written(self, m: Mention) -> str:
        digits = "".join(m.text.split())
        if m.number is None or not digits.startswith("0"):
            return self._new
        if len(self._new) > len(digits) and len(digits) == 4 and m.kind == "program":
            return self._new
        return self._new.zfill(len(digits))

    # ---- what cannot be done ----

    def _refuse_taken(self) -> None:
        found, new = self._found, self._new
        for m in self._every:
            if m.computed or m.kind != found.kind or thing(m) in self._things:
                continue
            called = str(m.number) if m.number is not None else m.name
            near = m.kind == "program" or m.to_program in self._places
            if near and called.upper() == new.upper():
                raise self._refused(m, f"{m.shown} stands here already")
        if found.kind == "program" and self._is_of_control():
            raise self._refused(found, f"{found.shown} is a program of the control")
        if found.kind == "program" and self._has_namesake():
            raise self._refused(found, f"two programs are called {found.shown}")
        if found.kind == "program" and self._taken_program():
            raise self._refused(found, f"there is a program {new} already")
        if found.kind == "variable" and found.number is not None:
            self._refuse_other_kind(int(new))

    def _refused(self, at: Mention, why: str) -> EditError:
        return refusal(self._library, [(at.program, at.block, why)])

    def _is_of_control(self) -> bool:
        to = self._found.to_program
        return to is not None and self._library.code.program(to).system

    def _has_namesake(self) -> bool:
        code, to = self._library.code, self._found.to_program
        if to is None:
            return False
        own = code.program(to)
        others = (code.program(i) for i in range(len(code)) if i != to)
        return any((of.name, of.external) == (own.name, own.external) for of in others)

    def _taken_program(self) -> bool:
        other = find_program(
            self._library.code, int(self._new) if self._new.isdecimal() else self._new
        )
        return other >= 0 and other != self._found.to_program

    def _refuse_other_kind(self, new: int) -> None:
        """Refuse a variable of another kind: a local for a common, or one of the control."""
        old = self._found.number
        assert old is not None
        kinds = [self._library.code.variable_kind(n) for n in (old, new)]
        if kinds[0] != kinds[1] or kinds[0] not in _OF_USERS:
            control = self._library.control
            told = [
                f"{_core.variable_name(control, n)} is {kind or 'no variable'}"
                for n, kind in zip((old, new), kinds, strict=True)
            ]
            raise self._refused(self._found, " and ".join(told))

    def _refuse_computed(self) -> None:
        found = self._found
        causes = [(m.program, m.block, f"{m.text} is a local of a level") for m in self._images()]
        for m in self._every:
            if not m.computed or m.kind != ("number" if found.kind == "label" else found.kind):
                continue
            elsewhere = m.to_program is not None and m.to_program not in self._places
            if m.kind == "number" and elsewhere:
                continue
            if m.kind == "variable" and found.number is None:
                continue
            if m.number is None:
                why = f"{m.text} is computed, and may name {found.shown}"
            elif m.number == found.number:
                why = f"{m.text} may name {found.shown}: what the code beside it means is not known"
            else:
                continue
            causes.append((m.program, m.block, why))
        if causes:
            raise refusal(self._library, causes)

    def _images(self) -> list[Mention]:
        """Return what reads or writes locals by the number of their level, if one is renamed."""
        kind = self._library.code.variable_kind
        return [
            m
            for m in self._every
            if self._is_local() and m.kind == "variable" and m.number and kind(m.number) == "image"
        ]

    def _refuse_unwritable(self, own: Sequence[Mention]) -> None:
        causes = []
        for m in own:
            of_file = m.kind == "program" and m.defines and not m.text
            if m.fixed and not of_file:
                why = f"{m.text.strip()} means {self._found.shown}, and cannot be written otherwise"
                causes.append((m.program, m.block, why))
            elif self._library.code.program(m.program).external:
                causes.append(
                    (m.program, m.block, "a program of the external device is not edited")
                )
        if self._is_local():
            causes += self._of_arguments(int(self._new))
        if causes:
            raise refusal(self._library, causes)

    def _of_arguments(self, new: int) -> Iterator[tuple[int, int | None, str]]:
        """Yield the arguments of calls that set the new local, or may set the old one."""
        for m in self._every:
            if m.kind != "variable" or not m.fixed:
                continue
            word = f"{m.text.strip()} of a call"
            if m.number == new and (m.computed or m.to_program in self._places):
                yield m.program, m.block, f"{word} sets #{new}"
            if m.number == self._found.number and m.computed:
                yield m.program, m.block, f"{word} may set {self._found.shown}"

    def _refuse_too_large(self, own: Sequence[Mention]) -> None:
        rules = {
            "number": ("max_sequence_number", "max_jump_number"),
            "program": ("max_program_number",),
        }
        for name in rules.get(self._found.kind, ()):
            most = rule_value(self._library.control, name)
            if self._new.isdecimal() and isinstance(most, int) and int(self._new) > most:
                raise self._refused(own[0], f"the control has numbers to {most}")

    # ---- names of programs and files ----

    def _with_names(self, own: Sequence[Mention], edits: tuple[Edit, ...]) -> Edits:
        if self._found.kind == "variable" and self._found.number is not None:
            return Edits(self._library, edits, variables={self._found.number: int(self._new)})
        if self._found.kind != "program" or self._found.to_program is None:
            return Edits(self._library, edits)
        at = self._found.to_program
        data = self._library.code.program(at)
        files, notes = {}, []
        old = data.name
        if not data.has_head:
            files[data.file] = self._file_named(data.file, old)
            notes.append(f"{old}: its file has to be called {Path(files[data.file]).name}")
        new = f"O{self._new}" if self._found.number is not None else self._new
        made = Edits(self._library, edits, tuple(notes), files)
        code = made.after.code
        name = code.program(at).name if at < len(code) else ""  # the proof finds that it is gone
        return Edits(self._library, edits, tuple(notes), files, {name or new: old})

    def _file_named(self, file: str, old: str) -> str:
        path = Path(file)
        at = path.name.upper().find(old.upper())
        new = (
            f"O{self._new}"
            if self._found.number is not None and old[:1].upper() == "O"
            else self._new
        )
        name = path.name[:at] + new + path.name[at + len(old) :] if at >= 0 else new + path.suffix
        return os.fspath(path.with_name(name))


_OF_USERS = ("local", "common", "kept")
