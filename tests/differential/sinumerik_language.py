"""The parts of a SINUMERIK program: expressions and blocks, and how they are written.

An expression is a tree and a program a list of blocks, so that the evaluator beside it
(`sinumerik_evaluator.py`) reads no text: what the brackets mean is decided here, by the manual's
table of priorities, and not by the engine's parser.
"""

from __future__ import annotations

from dataclasses import dataclass, field

# The manual's priorities (NC programming, "Priority of the operations"), the strongest first.
PRIORITY = {
    **dict.fromkeys(("NOT", "B_NOT", "NEGATIVE"), 1),
    **dict.fromkeys(("*", "/", "DIV", "MOD"), 2),
    **dict.fromkeys(("+", "-"), 3),
    "B_AND": 4,
    "B_XOR": 5,
    "B_OR": 6,
    "AND": 7,
    "XOR": 8,
    "OR": 9,
    "<<": 10,
    **dict.fromkeys(("==", "<>", "<", ">", "<=", ">="), 11),
}

LENGTH = 200  # of a STRING; no text of a program becomes longer


@dataclass(frozen=True)
class Number:
    """A number as it is written: with a point it is REAL, without one INT."""

    text: str


@dataclass(frozen=True)
class Text:
    """A text between quotation marks."""

    value: str


@dataclass(frozen=True)
class Truth:
    """TRUE or FALSE."""

    value: bool


@dataclass(frozen=True)
class Variable:
    """A variable of DEF, or a parameter of PROC."""

    name: str


@dataclass(frozen=True)
class Parameter:
    """An R parameter; its number may be computed."""

    number: int | Expression


@dataclass(frozen=True)
class Element:
    """An element of an array."""

    name: str
    indices: tuple[Expression, ...]


@dataclass(frozen=True)
class Unary:
    op: str
    value: Expression


@dataclass(frozen=True)
class Binary:
    op: str
    left: Expression
    right: Expression


@dataclass(frozen=True)
class Function:
    name: str
    values: tuple[Expression, ...]


Target = Variable | Parameter | Element
Expression = Number | Text | Truth | Variable | Parameter | Element | Unary | Binary | Function


def written(of: Expression) -> str:
    """Return the text of an expression, with no more brackets than the priorities need."""
    match of:
        case Number(text):
            return text
        case Text(inside):
            return f'"{inside}"'
        case Truth(value):
            return "TRUE" if value else "FALSE"
        case Variable(name):
            return name
        case Parameter(int() as number):
            return f"R{number}"
        case Parameter(number):
            return f"R[{written(number)}]"  # type: ignore[arg-type]
        case Element(name, indices):
            return f"{name}[{','.join(map(written, indices))}]"
        case Function(name, values):
            return f"{name}({','.join(map(written, values))})"
        case Unary(op, value):
            bracket = isinstance(value, Unary | Binary)
            inner = f"({written(value)})" if bracket else written(value)
            return f"-{inner}" if op == "NEGATIVE" else f"{op} {inner}"
        case Binary(op, left, right):
            mine = PRIORITY[op]
            one = _side(left, PRIORITY.get(getattr(left, "op", ""), 0) > mine)
            # Operations of one priority are computed from the left.
            other = _side(right, PRIORITY.get(getattr(right, "op", ""), 0) >= mine)
            space = " " if op[0].isalpha() else ""
            return f"{one}{space}{op}{space}{other}"


def _side(of: Expression, bracket: bool) -> str:
    return f"({written(of)})" if bracket else written(of)


# ---- blocks ----


@dataclass(frozen=True)
class Assign:
    targets: tuple[tuple[Target, Expression], ...]


@dataclass(frozen=True)
class Word:
    """The word of an axis: `manner` is "", "IC" or "AC"."""

    axis: str
    value: Expression
    manner: str = ""


@dataclass(frozen=True)
class Move:
    code: str  # G0, G1, G90 G0, ...; may be empty
    words: tuple[Word, ...]


@dataclass(frozen=True)
class Open:
    """IF, WHILE, FOR, LOOP or REPEAT. `value` is the condition, of FOR the first value."""

    kind: str
    value: Expression | None = None
    counter: Variable | None = None
    last: Expression | None = None


@dataclass(frozen=True)
class Else:
    pass


@dataclass(frozen=True)
class Close:
    """The end of a structure. `until` is the condition of UNTIL."""

    kind: str
    until: Expression | None = None


@dataclass(frozen=True)
class Jump:
    """Jumps tested in order, each with its condition or none."""

    ways: tuple[tuple[Expression | None, str, str], ...]  # condition, GOTOF ..., destination


@dataclass(frozen=True)
class Case:
    value: Expression
    branches: tuple[tuple[int, str, str], ...]
    default: tuple[str, str] | None


@dataclass(frozen=True)
class Call:
    name: str
    values: tuple[Expression | None, ...] | None  # None: without brackets
    times: int = 1


@dataclass(frozen=True)
class Again:
    """REPEAT of a part of the program: from a label, to another or to this block."""

    first: str
    last: str | None
    times: int
    only: bool = False  # REPEATB


@dataclass(frozen=True)
class Frame:
    op: str
    words: tuple[tuple[str, Expression | None], ...]


@dataclass(frozen=True)
class Return:
    word: str  # M17, RET, M30


Action = Assign | Move | Open | Else | Close | Jump | Case | Call | Again | Frame | Return


@dataclass
class Block:
    action: Action
    number: int | None = None
    label: str = ""
    mate: int = -1  # of a structure: the block where it goes on (ELSE, the end, the beginning)
    inside: tuple[int, ...] = ()  # the structures around it


@dataclass(frozen=True)
class Definition:
    type: str
    name: str
    initial: Expression | None = None
    size: tuple[int, ...] = ()
    fill: tuple[Expression | None, ...] = ()  # the values of SET
    all: Expression | None = None  # the value of REP


@dataclass(frozen=True)
class Formal:
    """A parameter of PROC."""

    type: str
    name: str
    by_reference: bool = False
    initial: Expression | None = None


@dataclass
class Program:
    name: str
    formals: tuple[Formal, ...] | None = None  # None: without PROC
    definitions: list[Definition] = field(default_factory=list)
    blocks: list[Block] = field(default_factory=list)
    save: bool = False  # the G codes and the frame are again those of the caller after its return


def text_of(action: Action) -> str:
    match action:
        case Assign(targets):
            return " ".join(f"{written(to)}={written(value)}" for to, value in targets)
        case Move(code, words):
            return " ".join([code, *map(_word, words)]).strip()
        case Open(kind, value, counter, last):
            if kind == "FOR":
                assert value is not None
                assert counter is not None
                assert last is not None
                return f"FOR {counter.name}={written(value)} TO {written(last)}"
            return f"{kind} {written(value)}" if value is not None else kind
        case Else():
            return "ELSE"
        case Close(kind, until):
            return f"UNTIL {written(until)}" if until is not None else f"END{kind}"
        case Jump(ways):
            return " ".join(
                (f"IF {written(condition)} " if condition is not None else "") + f"{word} {to}"
                for condition, word, to in ways
            )
        case Case(value, branches, default):
            ways = " ".join(f"{constant} {word} {to}" for constant, word, to in branches)
            rest = f" DEFAULT {default[0]} {default[1]}" if default else ""
            return f"CASE({written(value)}) OF {ways}{rest}"
        case Call(name, values, times):
            inner = [written(v) if v is not None else "" for v in values or ()]
            brackets = f"({','.join(inner)})" if values is not None else ""
            return f"{name}{brackets}" + (f" P={times}" if times > 1 else "")
        case Again(first, last, times, only):
            return " ".join([f"REPEAT{'B' * only}", first, *([last] if last else []), f"P={times}"])
        case Frame(op, words):
            return " ".join(
                [op, *(f"{a}={written(v)}" if v is not None else f"{a}0" for a, v in words)]
            )
        case Return(word):
            return word


def _word(word: Word) -> str:
    if isinstance(word.value, Number) and not word.manner:
        return f"{word.axis}{word.value.text}"
    inner = written(word.value)
    return f"{word.axis}={word.manner}({inner})" if word.manner else f"{word.axis}={inner}"


def definition_text(of: Definition) -> str:
    size = f"[{','.join(map(str, of.size))}]" if of.size else ""
    if of.fill:
        values = ",".join("" if v is None else written(v) for v in of.fill)
        return f"DEF {of.type} {of.name}{size}=SET({values})"
    if of.all is not None:
        return f"DEF {of.type} {of.name}{size}=REP({written(of.all)})"
    initial = f"={written(of.initial)}" if of.initial is not None else ""
    length = f"[{LENGTH}]" if of.type == "STRING" else ""
    return f"DEF {of.type}{length} {of.name}{size}{initial}"


def head_text(program: Program) -> str:
    formals = []
    for of in program.formals or ():
        initial = f"={written(of.initial)}" if of.initial is not None else ""
        formals.append(f"{'VAR ' * of.by_reference}{of.type} {of.name}{initial}")
    brackets = f"({', '.join(formals)})" if formals else ""
    return f"PROC {program.name}{brackets}" + " SAVE" * program.save
