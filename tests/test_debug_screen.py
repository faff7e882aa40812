"""The debugger in the terminal, driven key by key: what its screen shows, and that no key ends it."""

from __future__ import annotations

import asyncio
import re
import sys
import time
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from loops import run_apart

import cncsub
import pictures
from cncsub.debugging import PausePoint, Session

pytest.importorskip("textual", reason="textual is not installed")

from textual import events
from textual.keys import key_to_character
from textual.pilot import Pilot
from textual.widgets import Input, OptionList
from typer.testing import CliRunner

from cncsub.cli import app as commands
from cncsub.terminal.app import DebugApp
from cncsub.terminal.keys import KEYS, help_text, name_of

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "guides" / "debugging-terminal.md"
CONTROL = "fanuc-0i-f"
SIZES = [(80, 24), (120, 40), (40, 12)]
ROW = """O1
N10 G90 G54 G0 X0 Y0 Z50.
N20 G65 P9100 I20. K4. F120.
N30 M30
O9100 (ROW OF HOLES: I PITCH, K COUNT)
N110 #30=0
N120 #31=#5001
N130 WHILE[#30 LT #6-1]DO1
N140 G81 X#31 Z-8. R2. F#9
N150 #31=#31+#4
N160 #30=#30+1
N170 END1
N180 G80
N190 M99
"""
ENDLESS = "O1\nN10 #100=#100+1\nN20 GOTO10\n"


class Screen:
    """The debugger with a hand on its keys and an eye on its screen."""

    def __init__(self, app: DebugApp, pilot: Pilot[None]) -> None:
        self.app, self.pilot = app, pilot

    async def press(self, *keys: str) -> None:
        """Press keys, each after what the one before it began has come to rest."""
        for key in keys:
            typed = {"minus": "-", "slash": "/"}.get(key) or key_to_character(key)
            self.app.post_message(events.Key(key, typed))
            await self.rest()

    async def tap(self, *keys: str) -> None:
        """Press keys while a program runs: the pilot would wait for a process that is idle."""
        for key in keys:
            self.app.simulate_key(key)
            await asyncio.sleep(0.05)

    async def sees(self, text: str) -> None:
        """Wait for a text on the screen while a program runs."""
        end = time.monotonic() + 10
        while text not in self.text and time.monotonic() < end:
            await asyncio.sleep(0.02)
        assert text in self.text

    async def rest(self) -> None:
        """Wait until no program runs and no part of the screen has a message left.

        Twice in a row, for what is taken out of one queue goes into another. The pilot would wait for
        a process that is idle instead, a tenth of a second for each key.
        """
        end = time.monotonic() + 60
        times = 0
        while times < 2 and time.monotonic() < end:
            await self.pilot.pause(0.005 if self.app.moving else 0)
            await self.app.animator.wait_until_complete()
            parts = [self.app, *self.app.screen.walk_children(with_self=True)]
            busy = self.app.moving or any(part.message_queue_size for part in parts)
            times = 0 if busy else times + 1

    async def letters(self, text: str) -> None:
        """Type a text, letter by letter."""
        names = {" ": "space", "#": "number_sign", ":": "colon", "-": "minus"}
        await self.press(*(names.get(letter, letter) for letter in text))

    async def answer(self, *texts: str | None) -> None:
        """Fill in the fields of a question, `None` leaves one as it is, and press Enter."""
        for field, text in zip(self.app.screen.query(Input), texts):
            if text is not None:
                field.value = text
        await self.press("enter")

    @property
    def text(self) -> str:
        strips = self.app.screen._compositor.render_strips()
        return "\n".join("".join(segment.text for segment in strip) for strip in strips)

    @property
    def foot(self) -> str:
        return str(self.app.query_one("#status").content)  # type: ignore[attr-defined]

    @property
    def messages(self) -> str:
        return "\n".join(strip.text for strip in self.app.board.messages.lines)

    def rows(self, pane: str) -> list[str]:
        options = self.app.query_one(f"#{pane}", OptionList).options
        return [str(option.prompt).strip() for option in options]

    @property
    def at(self) -> int | None:
        block = self.app.session.next
        return None if block is None else block.n


def drive(
    text: str | dict[str, str],
    steps: Callable[[Screen], Awaitable[None]],
    *,
    size: tuple[int, int] = (80, 24),
    control: str = CONTROL,
    notes: tuple[str, ...] = (),
    **options: Any,
) -> None:
    """Open the debugger on a program and do some steps on it."""

    async def run() -> None:
        library = cncsub.loads(
            text if isinstance(text, dict) else {"row.nc": text}, control=control
        )
        app = DebugApp(Session(library, **options), "cncsub debug", notes)
        async with app.run_test(size=size) as pilot:
            screen = Screen(app, pilot)
            await screen.rest()
            await steps(screen)

    run_apart(run())


# ---- movements ----


def test_steps_go_into_over_out_and_to_the_return() -> None:
    async def steps(screen: Screen) -> None:
        seen = []
        for key in ("s", "s", "n", "t", "s", "n"):
            await screen.press(key)
            seen.append(screen.at)
        assert seen == [20, 110, 120, 190, 30, None]
        assert "the program has ended" in screen.foot
        assert "stopped: the program ended, after 23 blocks" in screen.messages
        await screen.press("R", "s", "s", "o")
        assert screen.at == 30

    drive(ROW, steps)


@pytest.mark.parametrize(("key", "other"), [("s", "f11"), ("n", "f10"), ("c", "f5"), ("b", "f9")])
def test_a_key_and_its_function_key_do_the_same(key: str, other: str) -> None:
    actions = {}
    for group in KEYS.values():
        for each in group:
            actions.update(dict.fromkeys(each.keys.split(","), each.action))
    assert actions[key] == actions[other]


def test_steps_go_back_over_a_call_to_the_call_and_to_the_head() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("c")
        seen = []
        for key in ("u", "U", "u", "l", "u", "u"):
            await screen.press(key)
            seen.append(screen.at)
        assert seen == [30, 20, 10, 10, 10, 10]
        await screen.press("s", "s", "s", "s", "l")
        assert screen.at == 20

    drive(ROW, steps)


def test_a_breakpoint_is_toggled_on_the_line_of_the_cursor() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press(*["down"] * 8, "b")
        assert screen.rows("points") == ["● row.nc:10"]
        assert "●10 › N150" in screen.text
        await screen.press("c")
        assert screen.at == 150
        assert screen.foot == "O9100 N150: breakpoint row.nc:10; 6 blocks ran"
        assert "●10 ▶ N150" in screen.text
        await screen.press("c", "c", "c", "r")
        assert screen.at == 150
        assert "#30" in screen.text
        await screen.press("r", "r", "r")
        assert screen.at == 10
        await screen.press(*["down"] * 8, "b")
        assert screen.rows("points") == []
        await screen.press("c")
        assert screen.app.session.ended

    drive(ROW, steps)


def test_a_breakpoint_on_a_line_without_a_block_moves_and_goes_again() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("up", "b")
        assert screen.foot == "line 1 has no block; the next one is on line 2"
        assert screen.rows("points") == ["● row.nc:1"]
        await screen.press("down", "b")
        assert screen.rows("points") == []

    drive(ROW, steps)


def test_breakpoints_have_conditions_counts_and_texts() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("B")
        await screen.answer("O9100:N150", "#30 GTT 1", "", "")
        assert "when: " in screen.text  # refused, and the question stays
        await screen.answer(None, "#30 GE 1", "2", "")
        assert screen.rows("points") == ["◉ O9100:N150 when #30 GE 1, hits 2"]
        await screen.press("B")
        await screen.answer("O9100:N160", "", "", "hole {#30} at {X}")
        assert screen.rows("points")[1] == "◆ O9100:N160, writes hole {#30} at {X}"
        await screen.press("c")
        assert (screen.at, screen.app.session.evaluate("#30")) == (150, "2")
        assert "row.nc:11: hole 0 at 0" in screen.messages
        assert "row.nc:11: hole 1 at 20" in screen.messages
        await screen.press("4", "home", "enter")
        await screen.answer(None, "", "3", "")
        assert screen.rows("points")[-1] == "◉ O9100:N150, hits 3"
        await screen.press("end", "delete")
        assert screen.rows("points") == ["◆ O9100:N160, writes hole {#30} at {X}"]
        await screen.press("home", "x", "x")
        assert screen.rows("points") == []
        assert "choose a breakpoint" in screen.foot

    drive(ROW, steps)


def test_a_watchpoint_is_on_what_is_chosen() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s", "s", "1")
        pane = screen.app.board.variables
        pane.highlighted = screen.rows("variables").index("#30    vacant")
        await screen.press("w")
        assert next(field.value for field in screen.app.screen.query(Input)) == "changes #30"
        await screen.press("enter", "c")
        assert (screen.at, screen.rows("points")) == (120, ["● changes #30"])
        await screen.press("2")
        screen.app.board.modes.highlighted = 1
        await screen.press("w", "enter", "3", "w")
        await screen.answer("passes Z -5")
        assert screen.rows("points")[1:] == ["● mode motion", "● passes Z -5"]
        await screen.press("c")
        assert screen.at == 150
        assert "passes Z -5" in screen.foot

    drive(ROW, steps)


def test_it_runs_to_the_cursor_and_back_to_it() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press(*["down"] * 8, "g")
        assert (screen.at, screen.rows("points")) == (150, [])
        await screen.press("c")
        screen.app.board.show_program(screen.app.session.library["O9100"], 9)
        await screen.press("G")
        assert (screen.at, screen.app.session.evaluate("#30")) == (140, "2")
        screen.app.board.source.go(14)
        await screen.press("G")
        assert "was not met" in screen.foot
        assert screen.at == 140
        screen.app.board.source.go(9)
        await screen.press("f")
        assert screen.at == 110

    drive(ROW, steps)


# ---- values ----


def test_what_changed_since_the_last_pause_is_marked() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s", "s", "s")
        assert "* #30    0" in screen.text
        await screen.press("s")
        assert screen.rows("variables")[4] == "#30    0"
        assert "* #31    0" in screen.text
        await screen.press("s", "s")
        await screen.press("2")
        assert "* cycle" in screen.text
        assert "F (feed)" in "".join(screen.rows("modes"))

    drive(ROW, steps)


def test_position_is_shown_in_work_and_machine_coordinates() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s")
        bare = screen.text.replace("│", " ")  # without borders
        lines = [line.split() for line in bare.splitlines() if re.search(r"\*[XZ]", line)]
        assert [words[-3:] for words in lines] == [["*X", "5", "15"], ["*Z", "2", "2"]]

    drive("O1\nN10 G54 G0 X5. Z2.\nN20 M30\n", steps, setup={"work_offsets": {"G54": {"X": 10}}})


def test_expressions_are_evaluated_and_completed() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s", "s", "e")
        await screen.answer("#6-1")
        assert "#6-1 = 3" in screen.text
        await screen.answer("#6 LTT 1")
        assert "evaluate: " in screen.text
        field = screen.app.screen.query_one(Input)
        assert field.suggester is not None
        assert await field.suggester.get_suggestion("#6+dist") == "#6+distance"
        assert await field.suggester.get_suggestion(" ") is None
        await screen.press("escape")
        assert "#6-1 = 3" in screen.messages

    drive(ROW, steps)


def test_values_are_set_by_key_and_by_enter() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s", "s", "equals_sign")
        await screen.answer("#6", "5")
        assert screen.foot == "set #6 = 5"
        assert "#6 (K) 5" in screen.text
        pane = screen.app.board.variables
        await screen.press("1")
        pane.highlighted = 2
        await screen.press("enter")
        fields = [field.value for field in screen.app.screen.query(Input)]
        assert fields == ["#6", "5"]
        await screen.answer(None, "nothing")
        assert "nothing" in screen.text
        await screen.answer("nobody", "1")
        assert "'nobody' cannot be set" in screen.text
        await screen.press("escape", "c")
        holes = [move for move in screen.app.session.machine.moves if move.z == -8]
        assert len(holes) == 4

    drive(ROW, steps)


def test_the_line_of_the_cursor_is_made_the_next_block() -> None:
    async def steps(screen: Screen) -> None:
        machine = screen.app.session.machine
        await screen.press("s", "s", "s", "0", *["down"] * 6, "N")
        assert machine.next is not None
        assert machine.next.n == 180
        assert screen.foot == "row.nc:13: made the next block"
        assert machine.blocks == 3
        await screen.press("home", "N")
        assert screen.foot.startswith("no block on line 1 of row.nc")
        assert machine.next.n == 180
        await screen.press("c")
        assert screen.app.session.ended
        assert not [move for move in machine.moves if move.z == -8]

    drive(ROW, steps)


def test_blocks_are_typed_where_the_program_stands_and_the_run_goes_on() -> None:
    async def steps(screen: Screen) -> None:
        machine = screen.app.session.machine
        await screen.press("n")
        await screen.press("m")
        await screen.answer("G0 X[")
        assert "mdi: " in screen.text
        assert machine.blocks == 1
        await screen.press("escape")
        await screen.press("m")
        await screen.answer("G0 X5. Y3.")
        assert "the typed blocks are executed" in screen.text
        assert machine.position == {"X": 5, "Y": 3, "Z": 50}
        assert machine.next.n == 20
        screen.app.session.set_points("x", [PausePoint("O9100:N120")])
        await screen.press("m")
        await screen.answer("G65 P9100 K3.")
        assert "N120 #31=#5001" in screen.text
        assert "MDI" in screen.text
        await screen.press("u", "u", "u", "u")
        assert (machine.blocks, machine.position["X"]) == (0, 0)

    drive(ROW, steps)


def test_switches_and_signals_are_set() -> None:
    text = "O1\n/N10 #100=1\nN20 M01\nN30 #101=#1004\nN40 M30\n"

    async def steps(screen: Screen) -> None:
        await screen.press("S")
        await screen.answer("one", "", "")
        assert "a block-skip switch is a whole number, not 'one'" in screen.text
        await screen.answer("99", "", "")
        assert "must be 1 to 10" in screen.text
        await screen.answer("1", "maybe", "")
        assert "M01 stops: yes or no" in screen.text
        await screen.answer("1", "no", "1004=x")
        assert "a signal is given as 1004=1" in screen.text
        await screen.answer("1", "no", "1004=1")
        machine = screen.app.session.machine
        assert (machine.block_skip, machine.optional_stop, screen.at) == ((1,), False, 20)
        await screen.press("c")
        assert screen.app.session.evaluate("#101") == "1"

    drive(text, steps)


def test_what_is_known_of_a_block_and_of_a_value_is_told() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press(*["down"] * 7, "i")
        assert "drills a hole" in screen.text
        await screen.press("escape", "s", "s", "1")
        screen.app.board.variables.highlighted = 2
        await screen.press("i")
        assert "a local variable of the program that runs" in screen.text
        await screen.press("escape", "0", "home", "i")
        assert "no block on this line" in screen.text

    drive(ROW, steps)


# ---- the whole run ----


def test_a_search_finds_who_wrote_last_and_goes_there() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("c", "slash")
        await screen.answer("#30")
        assert "no block so far" in screen.foot
        await screen.press("u", "l", "escape")
        await screen.press("R", *["down"] * 11, "g", "slash")
        await screen.answer("#30")
        assert "3  O9100  N160 #30=#30+1" in screen.text
        await screen.press("enter")
        assert (screen.at, screen.app.session.evaluate("#30")) == (160, "2")
        await screen.press("slash")
        await screen.answer("#30 +")
        assert "changes: " in screen.foot
        await screen.press("slash")
        await screen.answer("#999")
        assert "no block so far gave #999 another value" in screen.foot
        await screen.press("slash")
        await screen.answer("  ")
        assert "give a variable" in screen.text

    drive(ROW, steps)


def test_another_program_is_opened() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("O")
        assert "O7 SECOND other.nc:1" in screen.text
        await screen.press("end", "enter")
        assert "O7  other.nc" in screen.text
        await screen.press("b", "escape")
        assert "O1  row.nc" in screen.text
        await screen.press("c")
        assert screen.at == 1
        assert "O7  other.nc" in screen.text

    drive({"row.nc": "O1\nN10 M98 P7\nN20 M30\n", "other.nc": "O7 (SECOND)\nN1 X1.\nM99\n"}, steps)


def test_a_call_is_chosen_with_its_source_and_its_locals() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s", "s", "s", "5")
        assert screen.rows("calls") == ["G65 O9100 N120 (#4=20, #6=4, #9=120)", "O1 N20"]
        await screen.press("down", "enter")
        assert screen.app.board.source.cursor == 3
        assert "locals of level 1" not in screen.rows("variables")
        assert "3 ▷ N20" in screen.text
        await screen.press("f")
        assert screen.at == 10

    drive(ROW, steps)


def test_passes_are_shown() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s", "s", "s")
        assert screen.rows("calls")[0] == "M98 O2 N20 pass 2 of 3"

    drive("O1\nN10 M98 P2 L3\nN15 M30\nO2\nN20 X1.\nN30 M99\n", steps)


# ---- how a program stops ----


def test_an_alarm_is_shown_as_the_command_line_prints_it() -> None:
    text = "O1\nN10 G0 X1.\nN20 M98 P77\nN30 M30\n"

    async def steps(screen: Screen) -> None:
        await screen.press("c")
        printed = [
            "stopped: alarm, after 1 block",
            "PS0076 program-not-found: O77 is not in the memory",
            "  --> O1 N20, row.nc:3:9",
            "   | N20 M98 P77",
            "   |         ^^^",
            "cure: load the program, or correct the call",
        ]
        assert [line.rstrip() for line in screen.messages.splitlines()] == printed
        assert "alarm PS0076 program-not-found at O1 N20" in screen.foot
        assert "!3 ▶ N20 M98 P77" in screen.text
        assert all(line in screen.text for line in printed)
        await screen.press("u")
        assert screen.at == 10
        assert "!3" not in screen.text

    async def whole(screen: Screen) -> None:
        await screen.press("c")
        for part in ("stopped: alarm", "PS0076", "row.nc:3:9", "^^^", "cure: load", "N20 M98 P77"):
            assert part in screen.text

    drive(text, steps, size=(140, 50))
    drive(text, whole, size=(80, 24))


def test_a_program_waits_and_goes_on_after_the_input() -> None:
    text = "O1\nN10 IF[#500 EQ #0]GOTO10\nN20 M30\n"

    async def steps(screen: Screen) -> None:
        await screen.press("c")
        assert "waits for" in screen.foot
        assert "stopped: waiting" in screen.messages
        await screen.press("equals_sign")
        await screen.answer("#500", "1")
        await screen.press("c")
        assert "the program has ended" in screen.foot

    drive(text, steps)


def test_a_limit_says_whether_the_program_ever_ends() -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("c")
        assert "a limit" in screen.foot
        assert "why: " in screen.messages
        await screen.press("c", "s", "u")
        assert screen.app.session.machine.blocks == 999

    drive("O1\nN10 GOTO10\n", steps, max_blocks=1000)


def test_an_endless_program_leaves_the_screen_alive_and_is_paused() -> None:
    async def steps(screen: Screen) -> None:
        screen.app.session.set_points("slow", [PausePoint("O1:N10", hits="999999999")])
        await screen.tap("c")
        await asyncio.sleep(0.5)
        assert screen.app.moving == "running"
        assert re.match(r"running: \d+ s, [\d,]+ blocks; p pauses", screen.foot)
        await screen.tap("s", "b", "e", "slash", "S", "i", "escape", "1", "enter", "question_mark")
        await screen.sees("one block; into a call")
        await screen.tap("escape", "p")
        await screen.rest()
        assert "paused" in screen.foot
        before = screen.app.session.machine.blocks
        await screen.press("s")
        assert screen.app.session.machine.blocks == before + 1

    drive(ENDLESS, steps, max_blocks=2**40, trace="none")


def test_it_is_left_while_a_program_runs() -> None:
    async def steps(screen: Screen) -> None:
        await screen.tap("c", "q")
        await screen.rest()
        assert not screen.app.is_running or screen.app._exit

    drive(ENDLESS, steps, max_blocks=2**40, trace="none")


def test_messages_of_the_program_are_shown_while_it_runs() -> None:
    text = "O1\nN10 POPEN\nN20 DPRNT[X#1[52]]\nN30 #1=#1+1\nN40 IF[#1 LT 5000]GOTO20\nN50 M30\n"

    async def steps(screen: Screen) -> None:
        await screen.press("c")
        assert "message: X  4999.00" in screen.messages
        assert re.search(r"\.\.\. [\d,]+ lines before", screen.messages)

    drive(text, steps, variables={1: 0})


# ---- programs of every kind ----


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("", SIZES[0]),
        ("", SIZES[2]),
        ("%\n%\n", SIZES[1]),
        ("O1\n", SIZES[0]),
        ("O1\nM30", SIZES[2]),
    ],
)
def test_an_empty_program_is_shown(text: str, size: tuple[int, int]) -> None:
    async def steps(screen: Screen) -> None:
        await screen.press("s", "b", "c", "u", "i", "slash", "escape", "G", "g", "end", "home")
        assert screen.app.is_running

    drive(text, steps, size=size)


def test_a_long_file_opens_at_once_and_scrolls() -> None:
    text = "O1\n" + "".join(f"N{i} G1 X{i % 500}. F100\n" for i in range(1, 99_999)) + "M30\n"
    library = cncsub.loads({"long.nc": text}, control=CONTROL)

    async def run() -> None:
        began = time.perf_counter()
        app = DebugApp(Session(library), "cncsub debug")
        async with app.run_test(size=(80, 24)) as pilot:
            screen = Screen(app, pilot)
            await screen.rest()
            assert "N5 G1" in screen.text
            assert time.perf_counter() - began < 5  # a second, on a machine that does nothing else
            began = time.perf_counter()
            await screen.press("end", *["pageup"] * 3, "home", *["pagedown"] * 3, "end")
            assert "N99998 G1" in screen.text
            assert time.perf_counter() - began < 5
            await screen.press("up", "g")
            assert screen.at == 99_998
            await screen.press("u")
            assert screen.at == 99_997

    run_apart(run())


HOSTILE = (
    "O1 ([red]RED[/red] \u202eDEL\u202c \x1b[2J \u200b \u0301 \u4e2d\u6587 [/])\n"
    "N10 #3006=1([bold]SEE [/nothing] \x07 $x [@click=app.quit]q[/])\n"
    "N20 X[#1+[2]] ([link=file:///]x)\n"
    "N30 M98 P[[[\n"
)


@pytest.mark.parametrize("size", SIZES)
def test_odd_characters_are_shown_as_they_stand(size: tuple[int, int]) -> None:
    async def steps(screen: Screen) -> None:
        assert "[red]RED[/red]" in screen.text
        await screen.press("B")
        await screen.answer("O1:N20", "", "", "[red]{#1}[/red]")
        assert "[red]{#1}[/red]" in "".join(screen.rows("points"))
        await screen.press("i", "escape", "c", "c", "O", "escape", "slash")
        await screen.answer("[/red]")
        await screen.press("e")
        await screen.answer("[/red]")
        assert "[/red]" in screen.text
        for letter in "\u202e\x1b\x07\u200b":
            assert letter not in screen.text
            assert letter not in screen.messages
        await screen.press("escape")
        if size[0] > 40:
            assert "[bold]SEE [/nothing]" in screen.messages

    drive({"[red]\u202ex.nc": HOSTILE}, steps, size=size, notes=("note: [/red]\u202e",))


# ---- every key, and any ----


@pytest.mark.parametrize("size", SIZES)
def test_every_key_does_something_at_every_size(size: tuple[int, int]) -> None:
    async def steps(screen: Screen) -> None:
        for group in KEYS.values():
            for key in group:
                if key.action == "quit":
                    continue
                for one in key.keys.split(",")[: 2 if size == SIZES[0] else 1]:
                    await screen.press(one)
                    if len(screen.app.screen_stack) > 1:
                        await screen.press("escape")
                    assert len(screen.app.screen_stack) == 1
                    assert screen.app.is_running

    drive(ROW, steps, size=size)


def test_the_help_lists_every_key() -> None:
    text = help_text()
    for group in KEYS.values():
        for key in group:
            assert key.told in text
            for one in key.keys.split(","):
                assert f" {name_of(one)} " in text

    async def steps(screen: Screen) -> None:
        await screen.press("question_mark")
        assert "run to the next breakpoint" in screen.text
        await screen.press("end", "escape")

    drive(ROW, steps)


def test_it_is_dark_or_light_and_changes_its_size() -> None:
    async def steps(screen: Screen) -> None:
        assert screen.app.current_theme.dark
        await screen.press("d")
        assert not screen.app.current_theme.dark
        for size in ((20, 5), (200, 60), (1, 1), (80, 24)):
            await screen.pilot.resize_terminal(*size)
            await screen.press("s", "B", "escape")
        assert "N120" in screen.text

    drive(ROW, steps)


_ALL_KEYS = sorted(
    {key for group in KEYS.values() for each in group for key in each.keys.split(",")}
)
_MORE_KEYS = ["enter", "tab", "shift+tab", "up", "down", "left", "right", "space", "pageup", "end",
              "number_sign", "3", "0", "backspace", "ctrl+u", "x", "G", "1", "left_square_bracket", "home"]  # fmt: skip


def test_no_keys_end_it() -> None:
    keys = st.lists(st.sampled_from(sorted({*_ALL_KEYS, *_MORE_KEYS} - {"q"})), max_size=25)
    sizes = st.sampled_from(SIZES)
    library = cncsub.loads({"row.nc": ROW, "bad.nc": "O5\nN1 #1=1/0\nM99\n"}, control=CONTROL)

    @settings(
        max_examples=settings.default.max_examples // 20,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )
    @given(keys, sizes)
    def check(pressed: list[str], size: tuple[int, int]) -> None:
        async def run() -> None:
            app = DebugApp(Session(library), "cncsub debug")
            async with app.run_test(size=size) as pilot:
                screen = Screen(app, pilot)
                await screen.press(*pressed)
                assert app.is_running

        run_apart(run())

    check()


# ---- the page ----

_NAMED = {"Tab": "tab", "Enter": "enter", "Esc": "escape", "Del": "delete", "Home": "home",
          "Ctrl+U": "ctrl+u", "/": "slash", "=": "equals_sign"}  # fmt: skip


def test_the_page_shows_what_happens() -> None:
    page = PAGE.read_text(encoding="utf-8")
    (text,) = re.findall(r'^```nc title="row.nc"\n(.*?)^```$', page, re.M | re.S)
    rows = re.findall(r"^\| (`.*?) \| .*? \|(.*) \|$", page, re.M)
    assert len(rows) == 17

    async def steps(screen: Screen) -> None:
        for keys, seen in rows[:-1]:
            for key in re.findall(r"`(.*?)`", keys):
                if key in _NAMED or len(key) == 1:
                    await screen.press(_NAMED.get(key, key))
                else:
                    await screen.letters(key)
            for text in re.findall(r"`(.*?)`", seen):
                assert text in screen.text, (keys, text, screen.text)
        holes = [round(move.x or 0) for move in screen.app.session.machine.moves if move.z == -8]
        assert holes == [0, 20, 40, 60]

    drive(text, steps)
    mended = text.replace("[#30 LT #6-1]", "[#30 LT #6]")
    run = cncsub.loads(mended, control=CONTROL).run()
    assert len([move for move in run.moves if move.z == -8]) == 4


def test_the_picture_of_the_screen_shows_the_same() -> None:
    def words(svg: str) -> list[str]:
        return sorted(re.findall(r">([^<>]+)</text>", svg))

    assert words(pictures.SCREEN.read_text(encoding="utf-8")) == words(pictures.screen())


def test_every_key_that_the_page_names_is_one() -> None:
    known = {
        name_of(key) for group in KEYS.values() for each in group for key in each.keys.split(",")
    }
    page = PAGE.read_text(encoding="utf-8")
    after = page.partition("## What is worth knowing")[2]
    assert set(re.findall(r"`([A-Za-z=/?])`", after)) <= known


# ---- the command ----


def command(*arguments: str, terminal: bool = True) -> tuple[int, str, list[Any]]:
    """Call `cncsub debug`; return its status, what it printed, and what was opened."""
    opened: list[Any] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("cncsub.cli.debug.on_terminal", lambda: terminal)
        patch.setattr(DebugApp, "run", lambda app: opened.append(app))
        result = CliRunner().invoke(commands, ["debug", *arguments])
    return result.exit_code, result.output, opened


def test_without_a_terminal_it_is_refused_in_one_line() -> None:
    status, printed, opened = command("examples/fanuc/repeats.nc", "-c", CONTROL, terminal=False)
    assert (status, opened) == (2, [])
    assert printed == "cncsub: debug shows a screen: run it in a terminal, without a pipe\n"


@pytest.mark.parametrize("missing", ["textual", "plotille"])
def test_what_is_not_installed_is_named_with_the_command(
    missing: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [missing, *(n for n in sys.modules if n.startswith(f"{missing}."))]:
        monkeypatch.setitem(sys.modules, name, None)
    for name in [n for n in sys.modules if n.startswith("cncsub.terminal")]:
        monkeypatch.delitem(sys.modules, name)
    with monkeypatch.context() as patch:
        patch.setattr("cncsub.cli.debug.on_terminal", lambda: True)
        result = CliRunner().invoke(commands, ["debug", "x.nc", "-c", CONTROL])
    told = (
        f"cncsub: the debugger in the terminal needs {missing}, which is not installed:"
        " pip install 'cncsub[debug]'\n"
    )
    assert (result.exit_code, result.output) == (2, told)


def test_the_options_are_those_of_run(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text("O1\nN10 #100=#500\n/N20 #101=1\nN30 M30\nO2\nM30\n")
    more = ("--set", "500=7", "--skip", "1", "--start", "10")
    status, printed, (app,) = command(str(file), "-c", CONTROL, *more)
    assert (status, printed) == (0, "")
    assert app.session.run().text == "the program has ended"
    assert app.session.evaluate("#100") == "7"
    assert app.session.evaluate("#101") == "vacant"
    assert app._notes[-1].startswith("--start 10: begins at N10 with the modes of power-on")
    assert app._heading == "cncsub debug: O1 on FANUC Series 0i-F"
    assert command(str(file), "-c", CONTROL, "--main", "O2")[2][0]._heading.startswith(
        "cncsub debug: O2"
    )


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["none.nc", "-c", CONTROL], "none.nc"),
        (["-", "-c", CONTROL], "the standard input"),
        ([], "which control?"),
        (["examples/fanuc/repeats.nc", "-c", CONTROL, "--main", "O99"], "no program O99"),
    ],
)
def test_wrong_use_is_told_before_the_screen_opens(arguments: list[str], told: str) -> None:
    status, printed, opened = command(*arguments)
    assert (status, opened) == (2, [])
    assert told in printed
    assert printed.count("\n") == 1


def test_a_title_shows_the_end_of_a_long_path_and_a_cut_line_its_mark() -> None:
    file = f"{'folder/' * 12}row.nc"
    text = ROW.replace("N10 G90", f"N10 ({'A LONG COMMENT ' * 5}) G90")

    async def steps(screen: Screen) -> None:
        title = str(screen.app.board.source.border_title)
        assert title.startswith("O1  …")
        assert title.endswith("folder/row.nc")
        assert "row.nc ─" in screen.text
        (line,) = [each for each in screen.text.splitlines() if "A LONG COMMENT" in each]
        assert "…" in line

    drive({file: text}, steps)
