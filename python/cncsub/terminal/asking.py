"""What the debugger asks for, and what it does with the answers: breakpoints, values, searches."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from textual.content import Content

from cncsub.debugging import Pause, PausePoint, PlacedPoint, Reason, Session, Value, Written
from cncsub.escapes import shown
from cncsub.program import Program
from cncsub.terminal.dialogs import Answer, Ask, Choose, Field
from cncsub.terminal.panes import point_text

if TYPE_CHECKING:
    from cncsub.terminal.app import DebugApp

POINTS = "screen"  # the set of points that the screen places
MOST_PROGRAMS = 10_000  # listed to be opened
_NO = ("", "no", "off", "0", "false")
_YES = ("yes", "on", "1", "true")


def answered(put: Callable[[], str], *, closes: bool = True) -> Answer:
    """Return what came out of something that may be refused."""
    try:
        return Answer(put(), closes)
    except (InterruptedError, KeyError, TypeError, ValueError) as error:
        return Answer(str(error.args[0]), False, True)


# ---- breakpoints ----


def ask_point(app: DebugApp, held: PlacedPoint | None = None, at: str | None = None) -> Ask:
    """Ask for a breakpoint with all it may have. `held`: the one that is changed."""
    point = PausePoint(at or app.board.place_of_cursor()) if held is None else held.point
    place = point.at if isinstance(point.at, str) else point_text(point)
    fields = [
        Field("where, or after which event", place,
              "O2:N30, job.nc:12, call O2, alarm, M6, changes #100, passes Z -5, mode distance"),
        Field("only when", point.when or "", "#30 GE 2"),
        Field("hits", point.hits or "", "3 (the third time), >=3, %2 (each second)"),
        Field("write instead of pausing", point.log or "", "hole {#30} at {X}"),
    ]  # fmt: skip

    def put(given: list[str]) -> Answer:
        at, when, hits, log = (text.strip() for text in given)
        wanted = PausePoint(at, when or None, hits or None, log or None)
        if wanted.at == place:
            wanted = replace(wanted, at=point.at)
        return place_point(app, wanted, instead_of=held)

    return Ask("Breakpoint", fields, put, partial(completion, app))


def place_point(app: DebugApp, wanted: PausePoint, instead_of: PlacedPoint | None = None) -> Answer:
    """Place a point among those of the screen; where it is refused they stay as they were."""
    session = app.session
    before = [each.point for each in session.points.placed_in(POINTS)]
    old = None if instead_of is None else instead_of.point
    kept = [point for point in before if point not in (old, wanted)]
    placed = session.set_points(POINTS, [*kept, wanted])[-1]
    if placed.refused:
        session.set_points(POINTS, before)
        return Answer(placed.refused, False, True)
    app.board.show_points()
    return Answer(placed.moved or f"breakpoint set: {point_text(placed.point)}")


def toggle(app: DebugApp, at: str) -> Answer:
    """Take away the breakpoints on the line of the cursor, or set one there."""
    source = app.board.source
    programs = {each.index for each in source.text.programs}
    for placed in app.session.points.placed_in(POINTS):
        block = placed.block
        if block is not None and block.program.index in programs and block.line == source.cursor:
            return remove_point(app, placed)
    return place_point(app, PausePoint(at))


def remove_point(app: DebugApp, placed: PlacedPoint) -> Answer:
    session = app.session
    left = [each.point for each in session.points.placed_in(POINTS) if each.id != placed.id]
    session.set_points(POINTS, left)
    app.board.show_points()
    return Answer(f"breakpoint taken away: {point_text(placed.point)}")


def run_to(session: Session, at: str) -> Pause:
    """Run to a place, and leave no breakpoint there. Raises `ValueError` for a wrong place."""
    (placed,) = session.set_points("cursor", [PausePoint(at)])
    if placed.refused:
        raise ValueError(placed.refused)
    try:
        return session.run()
    finally:
        session.set_points("cursor", [])


def ask_watch(app: DebugApp) -> Ask:
    """Ask for a watchpoint, on what is chosen in the list that has the focus."""
    return ask_point(app, at=app.board.watched_place())


# ---- values ----


def chosen_expression(app: DebugApp) -> str:
    value = app.board.chosen_value
    return "" if value is None else value.expression


def completion(app: DebugApp, typed: str) -> str | None:
    """Return what is typed with its end completed, `None` where nothing is known of it."""
    if not typed.strip():
        return None
    for found in app.session.completions(typed, len(typed) + 1, app.frame):
        whole_text = typed[: found.start - 1] + found.text
        if whole_text.startswith(typed) and len(whole_text) > len(typed):
            return whole_text
    return None


def known_of(app: DebugApp) -> tuple[str, str]:
    """Return what is known of the chosen value, or of the words of the block at the cursor, below a
    title.
    """
    if value := app.board.chosen_value:
        return value.expression, app.session.hover(value.expression, app.frame) or value.text
    source = app.board.source
    blocks = list(source.text.blocks_on(source.cursor))
    words = dict.fromkeys(word.text for block in blocks for word in block.words)
    told = [app.session.hover(word, app.frame) for word in words]
    lines = [f"{word}\n  " + text.replace("\n", "\n  ") for word, text in zip(words, told) if text]
    title = " ".join(block.text.strip() for block in blocks) or "no block on this line"
    return title, "\n".join(lines) or "nothing is known of its words alone"


def ask_evaluate(app: DebugApp) -> Ask:
    def put(given: list[str]) -> Answer:
        text = given[0].strip()
        answer = answered(lambda: f"{text} = {app.session.evaluate(text, app.frame)}", closes=False)
        if not answer.wrong:
            app.write(answer.text)
        return answer

    field = Field("expression, variable, mode or axis", chosen_expression(app), "#30 LT #6-1")
    return Ask("Evaluate", [field], put, partial(completion, app))


def change_state(app: DebugApp, change: Callable[[], str]) -> Answer:
    """Change something, and show the state after it."""
    answer = answered(lambda: while_awake(app.session, change))
    if not answer.wrong:
        app.look_again()
    return answer


def while_awake(session: Session, change: Callable[[], str]) -> str:
    """Change something. A program that waits goes one block back then, so that it looks for its
    input again; what goes back forgets the change, so it is made twice.
    """
    told = change()
    if session.at.reason is Reason.WAITING:
        session.back()
        told = change()
    return told


def ask_set(app: DebugApp, value: Value | None = None) -> Ask:
    name = chosen_expression(app) if value is None else value.expression
    held = value.text if value is not None and value.can_set else ""

    def put(given: list[str]) -> Answer:
        name, text = (each.strip() for each in given)

        def change() -> str:
            return f"set {name} = {app.session.set(name, text, app.frame)}"

        return change_state(app, change)

    fields = [Field("variable, mode, axis or switch", name, "#100"),
              Field("value", held, "an expression, vacant, or a code such as G91")]  # fmt: skip
    return Ask("Set", fields, put, partial(completion, app))


def ask_mdi(app: DebugApp) -> Ask:
    def put(given: list[str]) -> Answer:
        def type_in() -> str:
            app.session.type_in(given[0])
            return "running what was typed"

        answer = answered(type_in)
        if not answer.wrong:
            app.move(app.session.run_typed, "running")
        return answer

    field = Field("blocks", "", "G0 X10., #100=5, M98 P2")
    return Ask("MDI", [field], put, partial(completion, app))


def ask_switches(app: DebugApp) -> Ask:
    """Ask for the block-skip switches that are on, whether M01 stops, and a signal."""
    machine = app.session.machine
    fields = [
        Field("block-skip switches that are on", " ".join(map(str, machine.block_skip)), "1 3"),
        Field("M01 stops", "yes" if machine.optional_stop else "no", "yes or no"),
        Field("signal to set", "", "1004=1"),
    ]

    def change(given: list[str]) -> str:
        skips, stops, signal = (text.strip() for text in given)
        on = [whole(word, "a block-skip switch") for word in skips.replace(",", " ").split()]
        if stops.lower() not in (*_YES, *_NO):
            raise ValueError(f"M01 stops: yes or no, not {stops!r}")
        name, _, value = signal.removeprefix("#").partition("=")
        number = whole(name, "a signal") if signal else 0
        try:
            level = float(value) if signal else 0.0
        except ValueError:
            raise ValueError(f"a signal is given as 1004=1, not {signal!r}") from None
        machine.block_skip = on
        machine.optional_stop = stops.lower() in _YES
        if signal:
            machine.signals[number] = level
        return "switches set"

    def put(given: list[str]) -> Answer:
        return change_state(app, lambda: change(given))

    return Ask("Switches and signals", fields, put)


def whole(text: str, what: str) -> int:
    """Return a whole number that was typed; `ValueError` for anything else."""
    digits = text.strip()
    if not (digits.isascii() and digits.isdecimal()) or len(digits) > 9:
        raise ValueError(f"{what} is a whole number, not {text!r}")
    return int(digits)


# ---- searches and programs ----


def ask_search(app: DebugApp) -> Ask:
    def put(given: list[str]) -> Answer:
        what = given[0].strip()
        if not what:
            return Answer("give a variable or an expression, such as #105", False, True)
        app.search(what)
        return Answer()

    field = Field("who wrote", chosen_expression(app), "#105, or any expression")
    return Ask("Where was it written?", [field], put, partial(completion, app))


def choose_written(app: DebugApp, what: str, found: list[Written]) -> Choose:
    """Offer the blocks that gave a variable another value, the last one first."""

    def rows() -> Iterator[tuple[Content, object]]:
        for each in found:
            block = each.block
            place = f"{block.program.name} {f'line {block.line}' if block.n is None else ''}"
            yield (
                Content.assemble(
                    (f"{each.step:>10,}  ", "$text-muted"), (shown(each.value), "$text-warning"),
                    f"  {shown(place.strip())}  ", (shown(block.text.strip()), "$text-primary"),
                ),
                each,
            )  # fmt: skip

    def take(chosen: object) -> None:
        if isinstance(chosen, Written):
            app.go_back_to(chosen.step)

    return Choose(shown(f"{what} got another value (step, value, block), the last one first"),
                  rows(), take)  # fmt: skip


def first_line(program: Program) -> int:
    return program.blocks[0].line if len(program.blocks) else program.line


def choose_program(app: DebugApp) -> Choose:
    """Offer the programs of the library."""
    programs = [*app.session.library.values(), *app.session.library.external.values()]

    def rows() -> Iterator[tuple[Content, object]]:
        for program in programs[:MOST_PROGRAMS]:
            name, comment = shown(program.name), shown(program.comment)
            where = shown(f"{program.file}:{program.line}")
            yield (
                Content.assemble((name, "$text-primary"), f" {comment} ", (where, "$text-muted")),
                program,
            )
        if (left := len(programs) - MOST_PROGRAMS) > 0:
            yield Content(f"... {left:,} more"), None

    def take(chosen: object) -> None:
        if isinstance(chosen, Program):
            app.board.show_program(chosen, first_line(chosen))
            app.board.source.focus()

    return Choose("Programs", rows(), take)


ASKING: dict[str, Callable[[DebugApp], Ask | Choose]] = {
    "point": ask_point,
    "watch": ask_watch,
    "evaluate": ask_evaluate,
    "set": ask_set,
    "mdi": ask_mdi,
    "switches": ask_switches,
    "search": ask_search,
    "open": choose_program,
}
