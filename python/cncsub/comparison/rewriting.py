"""Calls and jumps rewritten in the words of another control."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from cncsub import _core
from cncsub._core import Control
from cncsub.analysis.block_errors import BlockError
from cncsub.checking import Edit
from cncsub.comparison.cycle_counts import CycleCounts, letters_of
from cncsub.controls import first_made_number, rule_value
from cncsub.library import Library
from cncsub.loading import loads
from cncsub.program import Block, Program, Token, tokens_of
from cncsub.references import CallTo, Computed, JumpTo

_CODES = ("M97", "M98", "M198", "M99")
_CALL_WORDS = "PLHQ"  # the words that belong to a call and not to the rest of its block
_MOST_CALLS = 20  # calls that may replace one call
# What decides how a control takes words of a call that are computed.
_OF_COMPUTED = ("program_word", "count_and_l", "max_program_digits", "call_values", "start_word")
_OF_COUNTS = ("zero_repeats", "max_repeats", "too_many_repeats", "return_with_p")


class TranslateError(BlockError):
    """The error where a program cannot be rewritten to do the same on the other control. `.reason`;
    `.program`, `.n` and `.line` give the block, `None` where no single block is the cause.
    """


class _Tail(NamedTuple):
    """A program made of another program's blocks, from one block on."""

    number: int
    file: str
    first: int  # line numbers
    last: int


def _number(program: str) -> int | None:
    """Return the number by which P names a program; `None` for a name of another kind."""
    found = re.fullmatch(r"[O%:]?0*(\d+)", program)
    return int(found[1]) if found else None


class Rewriting:
    """The texts of a library and the edits that they need for another control."""

    def __init__(self, library: Library, target: Control, machine: str = "") -> None:
        self.library = library
        self.target = target
        self._machine = machine
        self.read = library.read_for(target)
        self.edits: dict[str, list[Edit]] = {}
        self.unproved: list[str] = []
        self._seen: set[tuple[str, int]] = set()
        self._tails: dict[tuple[str, int], _Tail] = {}
        self._sources = list(library.code.sources)
        self._lines = {
            # The engine's texts have blanks for carriage returns.
            name: [line.rstrip() for line in data.decode("utf-8", "surrogateescape").split("\n")]
            for name, _, data, outside in self._sources
            if not outside
        }
        self._written: dict[tuple[int, int | None, int], str | None] = {}
        edges = library.call_graph().edges
        self._called_programs = {e.called for e in edges if isinstance(e.called, str)}
        self._returns = _Returns(self)

    def _rules(self, name: str) -> tuple[object, object]:
        """Return the values of a rule on both controls."""
        return rule_value(self.library.control, name), rule_value(self.target, name)

    # ---- what changes ----

    def rewrite(self) -> None:
        """Find all edits; raise `TranslateError` for what the other control cannot express."""
        self._main_head()
        self._returns.look()
        for program in self.library.values():
            there = self.read[program.name].blocks if program.name in self.read else ()
            for index, block in enumerate(program.blocks):
                # The block as the target reads it; on another line it belongs to another program.
                own = there[index] if index < len(there) else None
                same = own is not None and own.line == block.line
                self._block(block, own if same else None)
        self._cycle_counts()
        self._external()

    def _cycle_counts(self) -> None:
        """Write K3 of a drilling cycle as L3 where the other control counts by L."""
        letters = letters_of(self.target)
        counts = CycleCounts(self.library.control, self._machine)
        done: set[tuple[str, int]] = set()
        for program in self.library.values():
            for block, letter in counts.words(program):
                place = (block.program.file, block.line)
                if letter in letters or not letters or place in done:
                    continue
                done.add(place)
                counts_of = _words(block, letter)
                if counts_of:
                    self.replace(block, counts_of, letters[0] + counts_of[0].text[1:])

    def _external(self) -> None:
        """Refuse a program of the external device that would have to change: it is not
        written to.
        """
        # Programs are matched by position: a control may name a program by its file.
        there = list(self.read.external.values())
        for place, program in enumerate(self.library.external.values()):
            blocks = there[place].blocks if place < len(there) else ()
            for index, block in enumerate(program.blocks):
                other = blocks[index] if index < len(blocks) else None
                own = (list(map(_called, block.calls)), list(map(_jumps, block.jumps)))
                if other is None or own != (
                    list(map(_called, other.calls)),
                    list(map(_jumps, other.jumps)),
                ):
                    raise self.refused(block, "a program of the external device is not rewritten")

    def _main_head(self) -> None:
        """Remove the head of the main program where the target, whose main program has no head,
        reads it as the head of a subprogram.
        """
        main, read = self.library.main, self.read.main
        if main is None or read is None or main.name in self._called_programs:
            return
        line = self._lines[main.file][main.line - 1]
        tokens = tokens_of(_core.tokens(self.library.control, line), 1)
        head = next((token for token in tokens if token.word is not None), None)
        headed = head is not None and head.word is not None and head.word.address == "O"
        if head is None or not headed or _number(read.name) == _number(main.name):
            return
        edit = Edit(main.file, main.line, 1, line, line[head.end - 1 :].strip())
        self.edits.setdefault(main.name, []).append(edit)

    def _block(self, block: Block, read: Block | None) -> None:
        # A program may contain the blocks of other programs: each block is looked at once.
        place = (block.program.file, block.line)
        if place in self._seen:
            return
        self._seen.add(place)
        # A return may be reported as a call without a program.
        calls = [call for call in block.calls if call.kind in _CODES and call.program != ""]
        jumps = [jump for jump in block.jumps if jump.kind in _CODES]
        if not self._called_programs & {block.program.name}:  # M99 P of a main program
            jumps = [jump._replace(in_caller=False) for jump in jumps]
        if any(map(_computed, calls)) or any(isinstance(jump.n, Computed) for jump in jumps):
            if any(a != b for a, b in (self._rules(name) for name in (*_OF_COMPUTED, *_OF_COUNTS))):
                self.unproved.append(f"{block.program.name}, line {block.line}")
            return
        behind = self._returns.behind(block)
        if calls:
            read_calls = read.calls if read is not None else ()
            wanted = self._returns.counted(calls[0])
            if behind or _called(wanted) not in map(_called, read_calls):
                self._call(block, wanted, behind)
        elif jumps and not self._returns.rewrites(block):
            self._jump(block, jumps[0], read.jumps if read is not None else ())
        elif self._returns.rewrites(block):
            self.replace(block, _words(block, "P"), "")
        self._return_count(block)

    def _call(self, block: Block, call: CallTo, behind: str) -> None:
        spans = [_code(block, call), *_words(block, _CALL_WORDS)]
        letters = [token.text[0].upper() for token in spans[1:]]
        if len(set(letters)) < len(letters):
            raise self.refused(block, "a word of the call is in the block twice")
        code = "M98" if call.kind == "M97" else spans[0].text
        if call.repeats == 0:
            self.replace(block, spans, "", behind)
            return
        assert isinstance(call.program, str)
        assert isinstance(call.repeats, int)
        number = _number(call.program)
        start = call.start if isinstance(call.start, int) else None
        if number is None:
            raise self.refused(block, f"{call.program} has no number that P could give")
        words = self.written(number, start, call.repeats, external=call.external)
        if words is None and start is not None:
            number = self._tail(block, call.program, start)
            start = None
            words = self.written(number, None, call.repeats, external=False)
        most = rule_value(self.target, "max_repeats")
        if words is None and isinstance(most, int) and call.repeats > most:
            words, more = self._split(number, start, call, most)
            behind = "\n".join([*(f"{code} {each}" for each in more), *filter(None, [behind])])
        if words is None:
            passes = f"{call.repeats} pass{'es' if call.repeats != 1 else ''}"
            raise self.refused(
                block,
                f"the other control has no words to call {call.program}, {passes}, as"
                f" {call.kind} does",
            )
        self.replace(block, spans, f"{code} {words}", behind)

    def _split(
        self, number: int, start: int | None, call: CallTo, most: int
    ) -> tuple[str | None, list[str]]:
        """Return the words of several calls that together make the passes; none where one cannot be
        written.
        """
        assert isinstance(call.repeats, int)
        full, rest = divmod(call.repeats, most)
        counts = [most] * full + ([rest] if rest else [])
        if len(counts) > _MOST_CALLS:
            return None, []
        words = [self.written(number, start, n, external=call.external) for n in counts]
        known = [each for each in words if each is not None]
        return (known[0], known[1:]) if len(known) == len(words) else (None, [])

    def written(
        self, number: int, start: int | None, repeats: int, *, external: bool
    ) -> str | None:
        """Return the words by which the target makes a call, or `None`. Each candidate is read as
        the target reads it.
        """
        key = (-number if external else number, start, repeats)
        if key not in self._written:
            self._written[key] = next(self._candidates(number, start, repeats, external), None)
        return self._written[key]

    def _candidates(
        self, number: int, start: int | None, repeats: int, external: bool
    ) -> Iterator[str]:
        code = "M198" if external else "M98"
        programs = [f"P{number}", f"P{number:04d}"]
        counts = [""] if repeats == 1 else []
        counts += [f" L{repeats}"]
        forms = [p + count for count in counts for p in programs]
        forms += [f"P{repeats}{number:04d}", f"P{repeats:04d}{number:04d}"]
        starts = [""] if start is None else [f" H{start}", f" Q{start}"]
        wanted = (number, repeats, start)
        for form, begin in itertools.product(forms, starts):
            words = form + begin
            text = f"O1\n{code} {words}\nM30\nO{number}\nN{start or 1}\nM99\n"
            program = next(iter(loads(text, control=self.target).values()), None)
            blocks = program.blocks if program is not None else ()
            calls = [call for block in blocks for call in block.calls]
            if any(_called(call) == wanted for call in calls):
                yield words

    def _tail(self, block: Block, program: str, start: int) -> int:
        """Return the number of a new program with the blocks of `program` from N`start` on."""
        key = (program, start)
        if key not in self._tails:
            whole = self.library[program]
            blocks = whole.blocks
            first = next((i for i, b in enumerate(blocks) if b.n == start), None)
            if first is None:
                raise self.refused(block, f"{program} has no N{start}")
            for inner in blocks[first:]:
                before = [j for j in inner.jumps if j.block is not None and j.block < first]
                if before and not before[0].in_caller:
                    reason = f"jumps to before N{start}, where a program of its own would begin"
                    raise self.refused(inner, reason)
            taken = {_number(name) for name in self.library} | {
                tail.number for tail in self._tails.values()
            }
            free = itertools.count(first_made_number(self.target))
            number = next(n for n in free if n not in taken)
            last = blocks[len(blocks) - 1].line
            self._tails[key] = _Tail(number, whole.file, blocks[first].line, last)
        return self._tails[key].number

    def _jump(self, block: Block, jump: JumpTo, read: Sequence[JumpTo]) -> None:
        if not self._called_programs & {block.program.name}:
            read = [other._replace(in_caller=False) for other in read]
        if any(_jumps(jump) == _jumps(other) for other in read):
            return
        words = self.jump_words(jump.n) if isinstance(jump.n, int) else None
        if jump.conditional or jump.in_caller or words is None:
            raise self.refused(block, f"the other control has no words to jump as {jump.kind} does")
        spans = [_code(block, jump), *_words(block, "P")]
        self.replace(block, spans, words)

    def jump_words(self, n: int) -> str | None:
        """Return the words by which the target jumps to a block of the same program, or `None`."""
        for words in (f"GOTO {n}", f"M99 P{n}", f"M97 P{n}"):
            text = f"O1\n{words}\nN{n}\nM30\nO2\nM98 P1\nM30\n"
            program = next(iter(loads(text, control=self.target).values()), None)
            blocks = program.blocks if program is not None else ()
            if any(j.n == n and not j.in_caller for block in blocks for j in block.jumps):
                return words
        return None

    def _return_count(self, block: Block) -> None:
        """Remove the L of M99 where the library's control ignores it and the target does not;
        refuse it where the library's control counts passes by it.
        """
        is_return = any(word.address == "M" and word.value == 99 for word in block.words)
        spans = _words(block, "L") if is_return else []
        if not spans:
            return
        own, other = self._rules("return_with_l")
        if own == other:
            return
        if own != "ignored":
            raise self.refused(block, "M99 L counts passes, and the other control ignores it")
        self.replace(block, spans, "")

    # ---- the texts ----

    def refused(self, block: Block, reason: str) -> TranslateError:
        return TranslateError(reason, block.program.name, block.n, block.line)

    def _line(self, block: Block) -> str:
        return self._lines[block.program.file][block.line - 1]

    def replace(self, block: Block, spans: Sequence[Token], new: str, behind: str = "") -> None:
        """Put `new` in the place of the words `spans`, and `after` on lines of its own."""
        line = self._line(block)
        mine = self.edits.get(block.program.name, ())
        if any((edit.file, edit.line) == (block.program.file, block.line) for edit in mine):
            raise self.refused(block, "one block would have to be rewritten twice")
        first = min((token.column - 1 for token in spans), default=len(line))
        rest = line[first:]
        for token in sorted(spans, key=lambda token: token.column, reverse=True):
            rest = rest[: token.column - 1 - first] + rest[token.end - 1 - first :]
        joined = f"{new} {rest.strip()}".strip() if new else rest.strip()
        words = block.words
        if behind and any(not word.address for word in words):  # IF[...] THEN before the words
            raise self.refused(block, "what must follow it would not be under its condition")
        # A block that is skipped takes the lines after it along.
        own = words[0].text if words and words[0].address == "/" else ""
        written = "\n".join([joined, *(own + each for each in behind.split("\n") if each)])
        edit = Edit(block.program.file, block.line, first + 1, line[first:], written)
        self.edits.setdefault(block.program.name, []).append(edit)

    def _edited(self) -> dict[str, list[str]]:
        lines = {name: list(of) for name, of in self._lines.items()}
        for edit in (edit for edits in self.edits.values() for edit in edits):
            line = lines[edit.file][edit.line - 1]
            lines[edit.file][edit.line - 1] = line[: edit.column - 1] + edit.new
        return lines

    def _texts(self) -> dict[str, str]:
        edited = self._edited()
        added: dict[str, list[str]] = {}
        for tail in self._tails.values():
            own = edited[tail.file][tail.first - 1 : tail.last]
            added.setdefault(tail.file, []).extend([f"O{tail.number:04d}", *own])
        for name, more in added.items():
            lines = edited[name]
            end = len(lines)
            while end and lines[end - 1].strip() in ("", "%"):
                end -= 1
            lines[end:end] = more
        return {name: "\n".join(lines) for name, lines in edited.items()}

    def before(self) -> dict[str, str]:
        return {name: "\n".join(lines) for name, lines in self._lines.items()}

    def texts(self) -> dict[str, str]:
        """Return the files that change, with their new texts."""
        before = self.before()
        return {name: text for name, text in self._texts().items() if text != before[name]}

    def added_names(self) -> list[str]:
        return [f"O{tail.number:04d}" for tail in self._tails.values()]

    def made(self) -> Library:
        """Return the library with the rewritten programs on the other control."""
        return self.library.with_texts(self.target, self._texts())


def _called(call: CallTo) -> tuple[object, object, object]:
    """Return what a call does. The program is given by number: its name differs between
    controls.
    """
    named = call.program if isinstance(call.program, str) else None
    number = _number(named) if named is not None else None
    return (number if number is not None else named, call.repeats, call.start)


def _jumps(jump: JumpTo) -> tuple[object, bool, bool]:
    return (jump.n, jump.conditional, jump.in_caller)


def _computed(call: CallTo) -> bool:
    return any(isinstance(each, Computed) for each in (call.program, call.repeats, call.start))


def _code(block: Block, of: CallTo | JumpTo) -> Token:
    """Return the word that calls or jumps."""
    for token in block.tokens:
        if token.word is not None and token.word[:2] == (of.kind[0], int(of.kind[1:])):
            return token
    reason = f"its {of.kind} is not written in a form that can be rewritten"
    raise TranslateError(reason, block.program.name, block.n, block.line)


def _words(block: Block, addresses: str) -> list[Token]:
    """Return the words of a block that have one of these addresses."""
    return [t for t in block.tokens if t.word is not None and t.word.address in tuple(addresses)]


class _Returns:
    """The blocks M99 P that the other control does not read, or reads in another pass. Each becomes
    M99, and the jump is written after the call.
    """

    def __init__(self, rewriting: Rewriting) -> None:
        self._rewriting = rewriting
        self._to: dict[int | None, int] = {}  # from a program's number to the N it returns to
        self._rule = rule_value(rewriting.library.control, "return_with_p")

    def look(self) -> None:
        library, target = self._rewriting.library, self._rewriting.target
        graph = library.call_graph()
        for program in library.values():
            back = [(b, j) for b in program.blocks for j in b.jumps if j.in_caller]
            edges = [edge for edge in graph.edges if edge.called == program.name]
            if not back or not edges:
                continue
            once = all(edge.repeats == 1 for edge in edges)
            other = rule_value(target, "return_with_p")
            kinds = {self._rule, other}
            alike = len(kinds) == 1 or (once and kinds <= {"at-once", "last-pass"})
            if alike and self._known(target):
                continue
            if any(edge.kind not in _CODES for edge in edges):
                reason = (
                    "M99 P of a program that a macro calls, and the other control does not have it"
                )
                raise self._rewriting.refused(back[0][0], reason)
            self._to[_number(program.name)] = self._only(program, back, bool(graph.computed))

    @staticmethod
    def _known(target: Control) -> bool:
        """Return whether a control reads M99 P as a return to a block of the caller."""
        read = loads("O1\nM98 P2\nN7\nM30\nO2\nM99 P7\n", control=target)
        return any(j.in_caller for p in read.values() for b in p.blocks for j in b.jumps)

    def _only(self, program: Program, back: list[tuple[Block, JumpTo]], computed: bool) -> int:
        """Return the one block to which a program always returns; refuse a program with several."""
        block, jump = back[0]
        refused = self._rewriting.refused
        returns = [b for b in program.blocks if any(w[:2] == ("M", 99) for w in b.words)]
        if computed or isinstance(jump.n, Computed) or jump.n is None:
            raise refused(block, "M99 P and a call that is computed cannot be told apart")
        if len(returns) != len(back) or len({j.n for _, j in back}) != 1:
            raise refused(
                block, "M99 P is one of several ways back, and the other control does not have it"
            )
        return jump.n

    def rewrites(self, block: Block) -> bool:
        """Return whether the block is an M99 P that loses its P."""
        own = _number(block.program.name) in self._to
        return own and any(jump.in_caller for jump in block.jumps)

    def counted(self, call: CallTo) -> CallTo:
        """Return the call with the passes that it makes: the first M99 P may end them."""
        if isinstance(call.program, str) and _number(call.program) in self._to:
            return call._replace(repeats=1) if self._rule == "at-once" else call
        return call

    def behind(self, block: Block) -> str:
        """Return the jump that is written after a call; empty where none is needed."""
        for call in block.calls:
            n = self._to.get(_number(call.program)) if isinstance(call.program, str) else None
            if n is None:
                continue
            words = self._rewriting.jump_words(n)
            if words is None:
                raise self._rewriting.refused(
                    block, f"the other control has no words to go on at N{n}"
                )
            return words
        return ""
