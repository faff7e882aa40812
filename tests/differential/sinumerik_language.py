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

# The frames of work systems, and the codes with which they take effect.
SYSTEMS = {"$P_UIFR[1]": "G54", "$P_UIFR[2]": "G55", "$P_UIFR[5]": "G505"}

LENGTH = 200  # of a STRING; no text of a program becomes longer


@dataclass(frozen=True)
class Number:
    """A number as it is written: with a point or EX it is REAL, else INT, also as 'H1F' and 'B101'."""

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


@dataclass(frozen=True)
class AxisName:
    """The name of an axis as a value."""

    axis: str


@dataclass(frozen=True)
class FrameName:
    """A frame: a variable of DEF, $P_PFRAME, or $P_UIFR[1]."""

    text: str


@dataclass(frozen=True)
class FrameCall:
    """CTRANS, CFINE, CROT, CSCALE or CMIRROR: axes, or variables of them, with their values."""

    name: str
    words: tuple[tuple[str, Expression | None], ...]


@dataclass(frozen=True)
class Chain:
    left: FrameValue
    right: FrameValue


@dataclass(frozen=True)
class Part:
    """A part of a frame: TR, FI, RT, SC or MI of an axis, or of a variable of one."""

    frame: FrameName
    axis: str
    part: str


FrameValue = FrameName | FrameCall | Chain
Target = Variable | Parameter | Element | Part
Expression = (
    Number
    | Text
    | Truth
    | Variable
    | Parameter
    | Element
    | Unary
    | Binary
    | Function
    | AxisName
    | Part
)


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
        case AxisName(axis):
            return axis
        case Part(frame, axis, part):
            kept = frame.text.removesuffix("]")
            return f"{kept}{',' if kept != frame.text else '['}{axis},{part}]"
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


def frame_written(of: FrameValue) -> str:
    match of:
        case FrameName(text):
            return text
        case FrameCall(name, words):
            values = (f"{a},{written(v)}" if v is not None else a for a, v in words)
            return f"{name}({','.join(values)})"
        case Chain(left, right):
            return f"{frame_written(left)}:{frame_written(right)}"


# ---- blocks ----


@dataclass(frozen=True)
class Assign:
    targets: tuple[tuple[Target, Expression], ...]


@dataclass(frozen=True)
class FrameAssign:
    to: FrameName
    value: FrameValue


@dataclass(frozen=True)
class Word:
    """The word of an axis, or AX[...] of a variable of one: `manner` is "", "IC" or "AC"."""

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
    manner: str = "P="  # how it is written: P=2, P2, P=1+1, CALL "NAME", PCALL NAME


@dataclass(frozen=True)
class Again:
    """REPEAT of a part of the program: from a label, to another or to this block."""

    first: str
    last: str | None
    times: int
    only: bool = False  # REPEATB
    ended: bool = False  # ENDLABEL ends the part
    block: bool = False  # CALL BLOCK: the part runs once more


@dataclass(frozen=True)
class Modal:
    """MCALL: the program is called after each block that moves. Without a name it ends."""

    name: str = ""
    values: tuple[Expression | None, ...] | None = None


@dataclass(frozen=True)
class Code:
    """G17 to G19, and the zero points: a block with this code alone."""

    code: str


@dataclass(frozen=True)
class Passed:
    """A block that changes no value and no path."""

    text: str


@dataclass(frozen=True)
class MachineMove:
    """G53, G153 or SUPA: the frames do not count in this block."""

    word: str
    words: tuple[Word, ...]


@dataclass(frozen=True)
class Pole:
    code: str  # G110 G111 G112
    words: tuple[tuple[str, Expression], ...]  # two axes, or RP and AP


@dataclass(frozen=True)
class Polar:
    """A move in polar coordinates; `along` is the word of the axis across the plane."""

    code: str
    radius: Expression | None
    angle: Expression | None
    manners: tuple[str, str] = ("", "")
    along: Word | None = None


@dataclass(frozen=True)
class Arc:
    """An arc to a point by its radius (`way` "CR") or its centre ("", or "AC": absolute)."""

    clockwise: bool
    to: tuple[Word, ...]
    way: str
    words: tuple[tuple[str, Expression], ...]


@dataclass(frozen=True)
class Frame:
    op: str
    words: tuple[tuple[str, Expression | None], ...]


@dataclass(frozen=True)
class Return:
    word: str  # M17, RET, M30


@dataclass(frozen=True)
class Back:
    """RET with values: to a block of the caller, or to the one after it, over so many levels."""

    target: str
    after: bool = False
    levels: int = 1


Moving = Move | MachineMove | Polar | Arc
Flow = Open | Else | Close | Jump | Case | Call | Again | Modal | Return | Back
Action = Assign | FrameAssign | Frame | Code | Pole | Passed | Moving | Flow


@dataclass
class Block:
    action: Action
    number: int | None = None
    label: str = ""
    mate: int = -1  # of a structure: the block where it goes on (ELSE, the end, the beginning)
    inside: tuple[int, ...] = ()  # the structures around it
    level: int | None = None  # of skipping: / is /0


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
