"""Write the blocks, definitions and heads of a SINUMERIK program."""

from __future__ import annotations

from random import Random

from sinumerik_language import (
    LENGTH,
    Action,
    Again,
    Arc,
    Assign,
    Back,
    Call,
    Case,
    Close,
    Code,
    Definition,
    Else,
    Expression,
    Flow,
    Frame,
    FrameAssign,
    Jump,
    MachineMove,
    Modal,
    Move,
    Moving,
    Number,
    Open,
    Passed,
    Polar,
    Pole,
    Program,
    Return,
    Word,
    frame_written,
    written,
)


def text_of(action: Action) -> str:
    match action:
        case Assign(targets):
            return " ".join(f"{written(to)}={written(value)}" for to, value in targets)
        case FrameAssign(to, value):
            return f"{to.text}={frame_written(value)}"
        case Passed(text) | Code(text):
            return text
        case Frame(op, words):
            return " ".join(
                [op, *(f"{a}={written(v)}" if v is not None else f"{a}0" for a, v in words)]
            )
        case Pole(code, words):
            return " ".join([code, *(f"{name}={written(value)}" for name, value in words)])
        case Move() | MachineMove() | Polar() | Arc():
            return _moving(action)
    return _flow(action)


def _moving(action: Moving) -> str:
    match action:
        case Move(code, words) | MachineMove(code, words):
            return " ".join([code, *map(_word, words)]).strip()
        case Polar(code, radius, angle, manners, along):
            given = zip(("RP", "AP"), (radius, angle), manners, strict=True)
            words = [_word(Word(name, v, manner)) for name, v, manner in given if v is not None]
            return " ".join([code, *words, *([_word(along)] if along else [])]).strip()
        case Arc(clockwise, to, way, words):
            centre = [_word(Word(name, v, way.removeprefix("CR"))) for name, v in words]
            return " ".join(["G2" if clockwise else "G3", *map(_word, to), *centre])


def _flow(action: Flow) -> str:
    match action:
        case Open("FOR", value, counter, last):
            assert value is not None
            assert counter is not None
            assert last is not None
            return f"FOR {counter.name}={written(value)} TO {written(last)}"
        case Open(kind, value):
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
        case Call():
            return _call(action)
        case Modal(name, values):
            return f"MCALL {name}{_values(values)}" if name else "MCALL"
        case Again(first, last, block=True):
            return f"CALL BLOCK {first} TO {last}"
        case Again(first, last, times, only):
            return " ".join([f"REPEAT{'B' * only}", first, *([last] if last else []), f"P={times}"])
        case Return(word):
            return word
        case Back(target, after, levels):
            rest = f",{int(after)},{levels}" if levels > 1 else ",1" * after
            return f'RET("{target}"{rest})'


def _values(values: tuple[Expression | None, ...] | None) -> str:
    inner = [written(v) if v is not None else "" for v in values or ()]
    return f"({','.join(inner)})" if values is not None else ""


def _call(of: Call) -> str:
    if of.times == 1 and of.manner == "CALL" and of.values is None:
        return f'CALL "{of.name}"'
    if of.times == 1 and of.manner == "PCALL":
        return f"PCALL {of.name}{_values(of.values)}"
    count = {"P": f" P{of.times}", "P=+": f" P={of.times - 1}+1"}.get(of.manner, f" P={of.times}")
    return f"{of.name}{_values(of.values)}" + (count if of.times > 1 else "")


def _word(word: Word) -> str:
    if isinstance(word.value, Number) and not word.manner and len(word.axis) == 1:
        return f"{word.axis}{word.value.text}"
    inner = written(word.value)
    return f"{word.axis}={word.manner}({inner})" if word.manner else f"{word.axis}={inner}"


def definitions_text(program: Program, random: Random) -> list[str]:
    """Write the DEFs of a program; some have several variables of one type."""
    lines: list[str] = []
    before = None
    for of in program.definitions:
        line = definition_text(of)
        if before and of.type == before and random.random() < 0.4:
            lines[-1] += "," + line.split(" ", 2)[2]
        else:
            lines.append(line)
        before = of.type
    return lines


def extern_text(program: Program) -> str:
    types = [f"{'VAR ' * of.by_reference}{of.type}" for of in program.formals or ()]
    return f"EXTERN {program.name}({','.join(types)})"


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
