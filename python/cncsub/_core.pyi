"""The engine. Use it through `cncsub`; nothing here is public by itself."""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, TypeAlias, final

import numpy as np

from cncsub.tables.rows import Step

__version__: str

def causes() -> list[tuple[str, str, str]]:
    """Return the slug, meaning and cure of every cause."""

def aliases() -> list[tuple[str, str, str, str]]: ...  # name, control, source, evidence
def controls() -> list[Control]:
    """Return every control, in listing order."""

def tokens(control: Control, block: str) -> list[_Token]: ...  # of a line
def sources() -> list[tuple[str, str, str, str, str]]:
    """Return the key, title, address, controls and evidence of every source."""

def code_facts(control: Control, name: str, machine: str = "") -> dict[str, Any] | None:
    """Return what is known of a code such as G54.1 or M98, of a word of the control's language
    such as GOTOF, or of an address such as T.
    """

def keywords(control: Control) -> list[tuple[str, str, str]]:
    """Return each word of a control's language that is no G or M code, what becomes of it in a run
    (`computed`, `passed-over`, `not-computed`, `not-known`, `refused`), and what it does.
    """

def variable_number(control: Control, name: str) -> int | None: ...
def variable_name(control: Control, number: int) -> str:
    """Return a variable as programs of a control write it: `#500`, `R5`, `$TC_DP3[5,1]`."""

def names_in_block(control: Control, block: str) -> list[str]:
    """Return what a block is written with, in its order, each name once: codes, addresses with
    their numbers, words, variables, and the names that programs give.
    """

def g_codes(control: Control, machine: str = "") -> list[tuple[str, str]]:
    """Return each G code of a control on a kind of machine, and the engine's name for what it does
    there: `Neutral` and `Ignored` are skipped, `Uncomputed` and `Unknown` alarm, `None` is refused.
    """

def cited(text: str) -> list[str]:
    """Return the keys of the sources that a text cites, each once."""

def strongest(text: str, control: str) -> str:
    """Return the strongest evidence that a fact with this source may carry on a control."""

@final
class Rule:
    @property
    def name(self) -> str: ...
    @property
    def group(self) -> str: ...
    @property
    def value(self) -> bool | int | str: ...
    @property
    def family(self) -> bool | int | str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def source(self) -> str: ...
    @property
    def evidence(self) -> str: ...
    @property
    def choices(self) -> tuple[str, ...]: ...
    @property
    def entries(self) -> tuple[str, ...]: ...
    @property
    def sources(self) -> dict[str, tuple[str, str]]: ...
    @property
    def examples(self) -> tuple[str, ...]: ...

@final
class Parameter:
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> float: ...
    @property
    def meaning(self) -> str: ...
    @property
    def rule(self) -> str | None: ...
    @property
    def rules(self) -> tuple[str, ...]: ...
    @property
    def used(self) -> bool: ...
    @property
    def source(self) -> str: ...
    @property
    def evidence(self) -> str: ...

@final
class AlarmEntry:
    @property
    def cause(self) -> str: ...
    @property
    def number(self) -> str: ...
    @property
    def text(self) -> str | None: ...
    @property
    def printed(self) -> bool: ...
    @property
    def directed(self) -> dict[str, tuple[str, str | None]]: ...
    @property
    def source(self) -> str: ...
    @property
    def evidence(self) -> str: ...

@final
class VariableOption:
    @property
    def name(self) -> str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def numbers(self) -> str: ...
    @property
    def rule(self) -> str: ...
    @property
    def fitted(self) -> bool: ...
    @property
    def source(self) -> str: ...
    @property
    def evidence(self) -> str: ...

@final
class Control:
    @property
    def name(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def dialect(self) -> str: ...
    @property
    def precision(self) -> float: ...  # how exactly it reads a number; 0: in 64 bits
    @property
    def base(self) -> str: ...
    @property
    def rules(self) -> tuple[Rule, ...]: ...
    @property
    def absent(self) -> dict[str, tuple[str, str]]: ...
    @property
    def parameters(self) -> dict[str, Parameter]: ...
    @property
    def alarms(self) -> dict[str, AlarmEntry]: ...
    @property
    def variable_options(self) -> dict[str, VariableOption]: ...
    def with_parameters(self, parameters: Mapping[str, float]) -> Control: ...
    def replace(self, **rules: bool | int | str) -> Control: ...
    @staticmethod
    def from_toml(path: str | os.PathLike[str]) -> Control: ...
    def to_toml(self) -> str: ...
    def __eq__(self, value: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Control: ...
    def __deepcopy__(self, memo: object) -> Control: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Frame:
    @property
    def program(self) -> str: ...
    @property
    def n(self) -> int | None: ...
    @property
    def line(self) -> int: ...
    @property
    def file(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def called(self) -> str: ...
    @property
    def repeat(self) -> int: ...
    @property
    def repeats(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Alarm:
    @property
    def cause(self) -> str: ...
    @property
    def number(self) -> str | None: ...
    @property
    def text(self) -> str | None: ...
    @property
    def program(self) -> str: ...
    @property
    def n(self) -> int | None: ...
    @property
    def line(self) -> int: ...
    @property
    def column(self) -> int: ...
    @property
    def word(self) -> str: ...
    @property
    def file(self) -> str: ...
    @property
    def detail(self) -> str: ...
    @property
    def frames(self) -> tuple[Frame, ...]: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

def control(state: tuple[Any, ...]) -> Control: ...  # the state that __reduce__ gave
def own_control(
    base: Control,
    name: str,
    title: str,
    rules: list[tuple[str, bool | int | str, str]],
    parameters: list[tuple[str, float, str]],
    alarms: list[tuple[str, str | None, str | None, str]],
) -> Control: ...
def frame(state: tuple[Any, ...]) -> Frame: ...
def alarm(state: tuple[Any, ...]) -> Alarm: ...

# kind, text; of a word also its address, its value, and its text without blanks and comments
_Token = tuple[str, str, str, float | None, str]

@final
class ProgramData:
    """One program of a library: where it stands, and its blocks by number from 0."""
    @property
    def code(self) -> Code: ...
    @property
    def name(self) -> str: ...
    @property
    def file(self) -> str: ...
    @property
    def line(self) -> int: ...
    @property
    def text(self) -> str: ...
    def start(self, size: int) -> bytes: ...  # the first bytes of the text
    @property
    def span(self) -> tuple[int, int, int]: ...  # its file, the first byte of its text, the end
    @property
    def has_head(self) -> bool: ...  # its text gives its name, not its file
    @property
    def system(self) -> bool: ...  # of the control itself, not of the user
    @property
    def inside(self) -> bool: ...  # a part of another program
    @property
    def comment(self) -> str: ...
    @property
    def external(self) -> bool: ...
    @property
    def duplicate_of(self) -> int: ...  # the program that is called instead of this one, or -1
    @property
    def blocks(self) -> int: ...
    def block(self, index: int) -> tuple[int | None, int, str]: ...  # n, line, text
    def column(self, index: int) -> int: ...  # of a block in its line, from 1
    def tokens(self, index: int) -> list[_Token]: ...

# kind, program, found, external, start, repeats, then the texts of a computed program, start and
# count, the word and its column, whether the program called has locals of its own
_CallRow = tuple[
    str,
    str | None,
    int | None,
    bool,
    int | None,
    int,
    str | None,
    str | None,
    str | None,
    str,
    int,
    bool,
]
# kind, conditional, in the caller, n, place of the block, text of a computed n, word, column
_JumpRow = tuple[str, bool, bool, int | None, int | None, str | None, str, int]
# number, name, computed, text, column
_VariableRow = tuple[int | None, str | None, bool, str, int]

def references(
    program: ProgramData, block: int
) -> tuple[
    tuple[_CallRow, ...], tuple[_JumpRow, ...], tuple[_VariableRow, ...], tuple[_VariableRow, ...]
]:
    """Return the calls, jumps, reads and writes of a block."""

def all_calls(code: Code) -> list[tuple[int, int, _CallRow]]:
    """Return every call, with the place of its program and of its block there."""

def each_call(code: Code, take: Callable[[int, int | None, int, _CallRow], None]) -> None:
    """Hand over every call: the place of its program, the number and the line of its block."""

# kind, defines, computed, in the caller, fixed, program, block, line, column, text, number, name,
# the program and the block that it names, the word of a block's number, how far it begins before
_MentionRow = tuple[
    str, bool, bool, bool, bool, int, int | None, int, int, str, int, str, int, int | None, str, int
]

def mentions(
    code: Code,
    machine: str,
    kinds: str,
    lines: tuple[str, int, int] | None = None,
    name: tuple[int, int | None, int, str] | None = None,
) -> list[_MentionRow]:
    """Return every piece of text that names a block, a program or a variable, by its place.
    `kinds`: block, program, variable, unnumbered. `lines`: only those in some lines of a file.
    `name`: only those that name one thing: its program (-1: of all), its block there, its number
    (-1: none), its name in capitals; nothing that is computed.
    """

def formatted(
    code: Code, name: str, blanks: str, indent: int, capitals: bool, points: bool
) -> tuple[list[tuple[int, int, str, str]], list[int]]:
    """Return the changes of a file to a layout: line, column, old, new; and the lines that stay as
    they are because they would be read otherwise. `name`: that of a file of the memory.
    """

def variables_used(program: ProgramData) -> list[tuple[int | None, str | None, str, int]]:
    """Return the variables that a program names, each once: number, name, the text that names it,
    the place of the first block that does.
    """

def written_variables(code: Code, most: int) -> tuple[list[int], bool]:
    """Return the first variables that blocks write and that can be read, and whether any block
    reads one.
    """

def refused_blocks(code: Code) -> list[tuple[int, int]]:
    """Return the blocks that are refused when they are reached: program and place there."""

# which of the rules, where (its words: what is wrong), the text of the line, the alarm, the calls,
# edits: file, line, column, old, new; the first of its other places with their lines, how many
# places it has
_FindingRow = tuple[
    int,
    Alarm,
    str,
    Alarm | None,
    tuple[Frame, ...],
    list[tuple[str, int, int, str, str]],
    tuple[tuple[Alarm, str], ...],
    int,
    str,
]

def lengths_without_point(
    record: Trace, machine: str
) -> tuple[int, str, float, str, int | None, int] | None: ...
def check(code: Code, main: int, machine: str, entries: Sequence[int]) -> list[_FindingRow]:
    """Return what is wrong with the programs, by their blocks. `entries`: those that something
    outside of the memory calls.
    """

def checks() -> list[tuple[str, str, str, str, str, str, str]]:
    """Return every rule: number, slug, severity, meaning, hint, example, its control."""

def told_for(control: Control) -> tuple[list[tuple[str, str]], dict[str, tuple[str, str]]]:
    """Return the words of a control: meaning and hint of every rule, by its place; meaning and cure
    of every cause, by its slug.
    """

@final
class Flows:
    """The flow graphs of all programs of a memory."""

def flows(code: Code) -> Flows: ...
def flow(
    flows: Flows,
    program: ProgramData,
) -> tuple[list[tuple[int | None, int | None, str]], list[int], list[int], list[int]]:
    """Return the edges between blocks, and the blocks that return, that end, that nothing
    leads to.
    """

def jumps(flows: Flows, program: ProgramData) -> list[tuple[int, int]]:
    """Return the blocks of a program that jump, each with the block that the jump leads to."""

def keeps_blocks(trace: Trace) -> bool: ...
def coverage(
    trace: Trace,
) -> tuple[
    np.ndarray[Any, Any],
    np.ndarray[Any, Any],
    np.ndarray[Any, Any],
    list[tuple[int, int, int, int]],
    list[tuple[int, str, int, int]],
    list[tuple[int, int, int]],
]:
    """Return by address the steps whose condition held, and failed; (loop, none, once, many);
    (caller, kind, program, count); (program, variable, count).
    """

def coverage_blocks(
    code: Code,
) -> list[tuple[list[int], list[int | None], list[int], list[str], list[str], list[bool]]]:
    """Return the own blocks of every program as columns: address, n, line, text, kind of branch,
    skip mark.
    """

def coverage_deciding(code: Code) -> tuple[np.ndarray[Any, Any], list[tuple[int, str, bool]]]:
    """Return 1 by the addresses of blocks that can be executed; address, branch and skip mark of
    the blocks that decide.
    """

@final
class Code:
    """The compiled programs of a library."""
    @property
    def control(self) -> Control: ...
    @property
    def main(self) -> int | None: ...  # the first program of the memory
    @property
    def duplicates(self) -> list[int]: ...
    def __len__(self) -> int: ...  # the number of programs
    def program(self, index: int) -> ProgramData: ...
    def place_of(self, address: int) -> tuple[int, int]: ...  # a program, and a block of it
    def names(self, external: bool = False) -> list[str]: ...  # what a name leads to
    def places(self, external: bool = False) -> list[int]: ...  # of the programs of these names
    def variable_facts(self, number: int) -> tuple[str, bool, bool] | None:
        """Return the group in which a variable is shown, such as `locals` or `work offsets`, and
        whether it can be read and written; None where the control has no such variable.
        """
    @property
    def system_variables(self) -> list[tuple[int, int, str]]: ...  # first, last, what they hold
    @property
    def variable_sign(self) -> str: ...  # what stands before the number of a variable
    @property
    def sources(self) -> list[tuple[str, str, bytes, bool]]: ...  # name, stem, UTF-8, external
    # local, common or kept; image of a level's local; control for one of the control; empty where
    # there is none
    def variable_kind(self, number: int) -> str: ...
    @property
    def leaders(self) -> list[tuple[str, int]]: ...  # file, lines before its first %
    @property
    def external_device(self) -> bool: ...
    @property
    def general_only(self) -> bool: ...
    def find(self, name: str | int, external: bool = False) -> int: ...
    def with_mdi(self, text: str) -> Code: ...  # one more program, the last

@final
class Text:
    """The bytes of a file; `compile` takes them over."""
    @property
    def utf8(self) -> bool: ...  # and without a byte-order mark: it may be compiled as it is
    def part(self, at: int, count: int) -> bytes: ...
    def __len__(self) -> int: ...

@final
class Texts:
    """Files of a folder that are UTF-8; `compile` takes them over."""
    @property
    def names(self) -> list[str]: ...  # as shown
    def file(self, index: int) -> tuple[str, str, bytes]: ...  # its name, stem and text
    def __len__(self) -> int: ...

def read_file(path: str, largest: int) -> Text | int | str:
    """Read a regular file as a `Text`. Return the number of the system's error where it cannot be
    opened, or why it is left out. Audited as `open`.
    """

def read_found(
    before: str, names: list[str], largest: int, as_utf8: bool
) -> list[Texts | tuple[int, Text | int | str]]:
    """Read files of a folder on all cores; `before` stands before their names. Return those that
    are UTF-8 together, and for others their place and what `read_file` gives. Files that are
    plainly no text are left out.
    """

def names_in(
    folder: str, no_programs: Iterable[str]
) -> tuple[list[str], list[str], list[str], bool] | int:
    """Return the regular files of a folder except those with the endings of `no_programs`, the
    folders, the entries that have to be looked at (links, hidden names, devices, ...), and whether
    they are in the order of files: not where names beyond ASCII are among them. Or return the
    number of the system's error. Audited as `os.scandir`.
    """

def unify_line_ends(text: bytes) -> bytes:
    """Return the text as `compile` reads it: each line ends with one line feed, and blanks stand
    for what else was there, so that every other byte keeps its place.
    """

def give_back_memory() -> None:
    """Give the memory back to the system that the engine keeps for the next reading, and what was
    freed, where the C library keeps it.
    """

def compile(
    control: Control,
    files: Sequence[
        tuple[str, str, Sequence[str | bytes | bytearray | Text], bool] | tuple[Texts, bool]
    ],
    external_device: bool = False,
    *,
    threads: int = 0,
    piece: int | None = None,
    general_only: bool = False,
) -> Code:
    """Compile files given as (name shown, stem that names a program without a head, text in pieces,
    external), or several given as (texts, external). `threads`: how many read (0: one for each
    core); `piece`: bytes of the pieces that the text is cut into. The programs are the same.
    `general_only`: read and run without the fast paths.
    """

@final
class Trace:
    """The record of a machine, which may go on, or of one part of a stream."""
    @property
    def control(self) -> Control: ...
    @property
    def steps(self) -> int: ...  # rows of the table of steps
    def step_row(self, index: int, row: type[Step]) -> Step: ...
    def step_column(self, name: str) -> np.ndarray[Any, Any]: ...
    def step_ways(self, first: int, last: int) -> np.ndarray[Any, Any]:
        """Return how each of some steps leads to the next: 0 to the next block, 1 past skipped
        blocks, 2 by a jump, 3 back to a caller, 4 otherwise.
        """
    def texts_after(self, index: int) -> list[str]: ...  # the blocks up to the next step's
    def step_texts(self, first: int, last: int) -> list[str]: ...  # the blocks of some rows
    def step_text_column(self) -> tuple[np.ndarray[Any, Any], list[str]]: ...  # of all rows
    @property
    def program_names(self) -> list[str]: ...
    @property
    def calls(self) -> int: ...
    def call_row(
        self, index: int
    ) -> tuple[int, int, str, str, int | None, int, int, int, int, int]: ...
    def call_column(self, name: str) -> np.ndarray[Any, Any]: ...
    @property
    def kind_names(self) -> list[str]: ...
    def call_arguments(self, index: int) -> dict[int | str, float | None]: ...
    @property
    def moves(self) -> int: ...
    def move_row(self, index: int) -> dict[str, Any]: ...
    def move_columns(self, names: Sequence[str]) -> dict[str, np.ndarray[Any, Any]]: ...
    @property
    def move_kinds(self) -> list[str]: ...
    @property
    def skip_names(self) -> list[str]: ...
    @property
    def move_axes(self) -> list[str]: ...
    @property
    def changes(self) -> int: ...  # rows of the table of what was watched
    def change_row(
        self, index: int
    ) -> tuple[int | None, int, float | None, str | None, int | None, int | None]: ...
    def change_column(self, name: str) -> np.ndarray[Any, Any]: ...
    @property
    def watched(self) -> dict[int, float | None]: ...  # before the first row
    @property
    def compared(self) -> int: ...  # rows of the table of comparisons
    @property
    def operator_texts(self) -> list[str]: ...
    def compared_row(
        self, index: int
    ) -> tuple[int, float | None, str, float | None, bool, str, int | None, int]: ...
    def compared_column(self, name: str) -> np.ndarray[Any, Any]: ...
    @property
    def path_length(self) -> float: ...  # mm
    @property
    def time(self) -> float: ...  # s
    @property
    def bounds(self) -> dict[str, tuple[float, float]]: ...
    @property
    def dropped(self) -> list[tuple[int, str, int | None, int, str, str]]: ...
    @property
    def codes(self) -> int: ...  # rows of the table of M, T and S codes
    def code_row(self, index: int) -> tuple[str, float, int, str, int | None, int]: ...
    def code_column(self, name: str) -> np.ndarray[Any, Any]: ...
    @property
    def m_codes(self) -> list[int]: ...
    @property
    def t_codes(self) -> list[int]: ...
    @property
    def diameters(self) -> int: ...  # bit 0: X
    def polyline(
        self, frame: str, tolerance: float, first: int, last: int, most: int
    ) -> tuple[np.ndarray[Any, Any], ...] | int:
        """Return x, y, z, move, begins; or the number of points, where that is more than `most`."""
    def outline(
        self,
        frame: str,
        tolerance: float,
        thinner: float,
        first: int,
        last: int,
        key: np.ndarray[Any, Any],
    ) -> tuple[Any, ...]:
        """Return x, y, z, move, key and time of the points that a picture needs, how many points
        there were before, and at how many the path begins anew. `key`: for each move that of its
        line.
        """
    @staticmethod
    def thinned(
        x: np.ndarray[Any, Any],
        y: np.ndarray[Any, Any],
        z: np.ndarray[Any, Any],
        key: np.ndarray[Any, Any],
        tolerance: float,
    ) -> np.ndarray[Any, Any]:
        """Return which points of a line are enough for it; points where `key` changes are kept."""
    @property
    def messages(self) -> list[str]: ...
    @property
    def missed_skips(self) -> list[tuple[int, str, int | None, int]]: ...  # step program n line

@final
class Machine:
    """One run of one program, whole or step by step. One thread uses it at a time: any other call
    while a thread runs it raises `RuntimeError`.
    """
    def run(self) -> bool:
        """Run on. Ctrl-C stops it as interrupted. Return whether `pause` did."""
    def pause(self, for_good: bool = True) -> None:
        """Stop the run that another thread is at, or the next one, as Ctrl-C does; where it is not
        `for_good`, not one that goes back.
        """
    def has_run(self, code: Code) -> bool:
        """Return whether it runs this code, or ran it before something was typed in."""
    @final
    class Expressions:
        """Expressions that were compiled beside the programs."""

        @property
        def are_numbers(self) -> list[bool]: ...

    def expressions(
        self, texts: list[tuple[str, int]]
    ) -> tuple[Expressions, list[tuple[str, int, int] | None]]:
        """Compile expressions, each with the program whose variables it may name. Return them, and
        of each that is none why, with the column and the width of what is wrong.
        """
    def evaluate(self, expressions: Expressions, index: int) -> float | str | None:
        """Return the value of one; a `ValueError` says why it has none."""
    def run_to(
        self, breakpoints: list[dict[str, Any]], expressions: Expressions
    ) -> tuple[list[int], tuple[int, str] | None, bool]:
        """Run to a breakpoint. Return which were reached, the one that has no value here, and
        whether `pause` stopped it.
        """
    def set_position(self, axis: str, value: float, in_machine: bool) -> None:
        """Let an axis stand elsewhere (mm). Raises `KeyError`, and `ValueError` with the reason."""

    def set_mode(self, mode: str, text: str) -> None:
        """Put a code or a word in force; a `ValueError` says why it cannot be."""
    def set_named(self, name: str, values: list[float | str], level: int = -1) -> None:
        """Give a variable its value, or those of its elements; likewise."""
    def set_next_block(self, address: int) -> None:
        """Make another block of the program that runs the next one; likewise."""
    @property
    def switches(self) -> tuple[tuple[int, ...], bool]: ...  # block skips; whether M01 stops
    def set_switches(self, on: list[int], stops: bool) -> None: ...
    def remember(self) -> None:
        """Keep snapshots from now on, for the way back."""
    def back(self, step: int) -> bool:
        """Go back to when so many blocks were executed. Return whether `pause` stopped it: then the
        machine stands where it stood.
        """
    def last_met(self, breakpoints: list[dict[str, Any]], expressions: Expressions) -> int | None:
        """Return the last step before this at which one shows a block, -1 for none; `None` where
        `pause` stopped the search.
        """
    def type_in(self, text: str) -> tuple[str, int, int, int] | None:
        """Make blocks that are typed in MDI those that run next. Return what is wrong with one of
        them: why, its line in the text, and the column and width there.
        """
    @property
    def step_of_call(self) -> int: ...  # -1 where no call is open
    @property
    def snapshots(self) -> tuple[int, int]: ...  # how many, and their bytes
    @property
    def open_frames(self) -> list[dict[str, Any]]: ...  # the main program first
    @property
    def modal_calls(self) -> int: ...  # how many are in force
    def follows_time(self, number: int) -> bool: ...  # a clock or a date
    @property
    def control_frames(self) -> dict[str, tuple[str, str | None]]:
        """Return the frames that programs may write: role and value, `None` where none makes it."""
    def assignment(self, number: int, value: float | None) -> str:
        """Return how the control assigns a value to a variable."""
    def blocks_at(self, program: int, n: int = -1, line: int = -1) -> list[int]:
        """Return the addresses of the blocks with a sequence number, or on a line."""
    @property
    def next_block(self) -> int | None: ...  # its address
    @property
    def address(self) -> int: ...  # of the block where the program stands
    def run_blocks(self, blocks: int) -> None:
        """Run on for about that many blocks."""
    def step(self, row: type[Step]) -> Step | None:
        """Execute one block and return its row as an object of the class it is given. Return None
        where the run has stopped and nothing was executed.
        """
    def interrupt(self) -> None:
        """Stop the run as Ctrl-C does."""
    def copy(self) -> Machine: ...
    def take(self) -> Trace:
        """Return what was recorded so far; the machine goes on with empty tables."""
    @property
    def trace(self) -> Trace: ...
    @property
    def code(self) -> Code: ...
    @property
    def stop(self) -> str | None: ...  # end alarm cycles limit waiting interrupted
    @property
    def waiting_for(self) -> str: ...
    def endless(self) -> dict[str, Any]:
        """Return why the program had not ended, at a limit or where it waits."""
    @property
    def alarm(self) -> Alarm | None: ...
    @property
    def stack(self) -> tuple[Frame, ...]: ...  # innermost first
    @property
    def position_in_program(self) -> tuple[str, int | None, int]: ...  # of the next block
    @property
    def blocks(self) -> int: ...  # executed so far
    @property
    def axes(self) -> list[str]: ...  # that the programs in memory name
    @property
    def memory(self) -> int: ...  # bytes of what was recorded
    def variables(self, level: int = -1) -> dict[int, float | None]: ...
    def named_variables(self, level: int = -1) -> dict[str, Any]:
        """Return the variables that programs define, by name: a number, a text, or lists."""
    def get_variable(self, number: int, level: int = -1) -> float | None: ...
    def set_variable(self, number: int, value: float | None, level: int = -1) -> None: ...
    def can_be_vacant(self, number: int) -> bool: ...
    @property
    def signals(self) -> dict[int, float]: ...  # that were set
    def get_signal(self, number: int) -> float: ...
    def set_signal(self, number: int, value: float) -> None: ...
    def reset(self) -> None: ...
    def cleared_by_reset(self, number: int) -> bool: ...
    @property
    def level(self) -> int: ...
    @property
    def position(self) -> dict[str, float]: ...
    @property
    def position_in_machine(self) -> dict[str, float]: ...
    @property
    def modal(self) -> dict[str, str]: ...
    @property
    def inch(self) -> bool: ...  # whether lengths in programs are inches now

@final
class Flattening:
    """A run as a flat program, piece by piece."""

    def next(self) -> tuple[bytes, dict[str, np.ndarray[Any, Any]]] | None:
        """Return the next piece, its text and the columns of its origins; None after the
        last one.
        """
    @property
    def refusal(self) -> tuple[str, str | None, int | None, int | None] | None:
        """Why the text is not whole: the reason, program, n and line."""
    @property
    def ends(self) -> bool:
        """Whether the run has come to an end that the text has too."""
    @property
    def stop(self) -> str: ...
    @property
    def waiting_for(self) -> str: ...
    @property
    def alarm(self) -> Alarm | None: ...
    @property
    def program_names(self) -> list[str]: ...

@final
class RuleExchange:
    """The rules of one control that another one answers otherwise, and parameters that are no
    rules.
    """

    def control(self, names: Sequence[str]) -> Control | None:
        """Return the first control with the values of the other one for these; `None` where they
        do not go together.
        """
    @property
    def untried(self) -> list[str]:
        """The rules whose values could not be given to the first control."""

# The name of a side, its run, and what runs it again: for as many blocks, with variables watched.
_Again: TypeAlias = Callable[[int | None, Sequence[int]], Machine | None]
_Side: TypeAlias = tuple[str, Machine, _Again]

def rule_exchange(one: Control, other: Control) -> RuleExchange: ...
def parting(
    question: str,
    sides: tuple[_Side, _Side],
    programs: Mapping[str, str] = ...,
    variables: Mapping[int, int] = ...,
) -> tuple[int, int, str, str] | None:
    """Return the first difference: a step of each, the text, the column of the moves."""

def rules_apart(
    exchange: RuleExchange,
    at: tuple[int, int],
    sides: tuple[_Side, _Side],
    run_on: Callable[[Control], _Again | None],
) -> list[str]:
    """Return the fewest rules and parameters that make a difference."""

def shared_variables(one: Machine, other: Machine) -> list[int]: ...
def summary(machine: Machine) -> str: ...  # how a run stopped, in a few words
def flattening(machine: Machine, comments: bool, other: Machine | None = None) -> Flattening: ...
def mode_names() -> list[str]: ...  # that `modal` may show
def machine(code: Code, main: int, **options: Any) -> Machine: ...
