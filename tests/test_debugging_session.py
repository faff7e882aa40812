"""What the faces of the debugger share: movements, breakpoints, scopes, values."""

from __future__ import annotations

import threading
import time
from typing import Any

import pytest
from debugged import ROW

import cncsub
from cncsub.debugging import Pause, PausePoint, Reason, Session

CONTROL = "fanuc-0i-f"


@pytest.fixture
def session() -> Session:
    return Session(cncsub.loads({"row.nc": ROW}, control=CONTROL))


def at(session: Session) -> int | None:
    return None if session.next is None else session.next.n


def at_text(session: Session) -> str:
    return "" if session.next is None else session.next.text


def scope(session: Session, name: str, frame: int = 0) -> dict[str, tuple[str, bool]]:
    (found,) = [each for each in session.scopes(frame) if each.name == name]
    return {value.name: (value.text, value.changed) for value in found.values}


def moves(session: Session, *names: str) -> list[tuple[str, int | None]]:
    return [(getattr(session, name)().reason, at(session)) for name in names]


def test_steps_go_into_over_and_out_of_calls(session: Session) -> None:
    assert session.start().reason is Reason.ENTRY
    assert moves(session, "into", "into", "into", "out") == [
        ("step", 20), ("step", 110), ("step", 120), ("step", 25),
    ]  # fmt: skip
    assert moves(session, "over", "over") == [("step", 30), ("end", None)]
    assert session.ended


def test_over_runs_all_passes_and_into_goes_through_each(session: Session) -> None:
    session.set_points("lines", [PausePoint("O1:N25")])
    session.run()
    assert moves(session, "into", "over", "over", "over", "over", "over") == [
        ("step", 200), ("step", 210), ("step", 200), ("step", 210), ("step", 30), ("end", None),
    ]  # fmt: skip


def test_to_return_pauses_before_the_block_that_leaves(session: Session) -> None:
    session.into()
    session.into()
    assert moves(session, "to_return", "into", "to_return", "into") == [
        ("step", 190), ("step", 25), ("step", 30), ("end", None),
    ]  # fmt: skip


def test_back_goes_one_block_over_a_call_and_to_the_call(session: Session) -> None:
    session.run()
    assert moves(session, "back", "back", "back_over", "back_over", "back_over", "back_over") == [
        ("step", 30), ("step", 210), ("step", 200), ("step", 210), ("step", 200), ("step", 25),
    ]  # fmt: skip
    assert moves(session, "back", "back_to_call", "back", "back") == [
        ("step", 190), ("step", 20), ("entry", 10), ("entry", 10),
    ]  # fmt: skip


def test_reverse_goes_to_the_breakpoint_met_last_and_to_the_head(session: Session) -> None:
    session.set_points("lines", [PausePoint("O9100:N150", when="#30 LT 2"), PausePoint("call O3")])
    session.run()
    session.set_points("lines", [PausePoint("O9100:N150", when="#30 LT 2")])
    session.run()
    session.run()
    assert session.ended
    assert moves(session, "reverse", "reverse", "reverse") == [
        ("breakpoint", 150), ("breakpoint", 150), ("entry", 10),
    ]  # fmt: skip


def test_a_line_without_a_block_moves_to_the_next_and_says_so(session: Session) -> None:
    (placed, beyond, other) = session.set_points(
        "lines", [PausePoint("row.nc:6"), PausePoint("row.nc:99"), PausePoint("rov.nc:5")]
    )
    assert placed.block is not None
    assert placed.block.line == 7
    assert placed.moved == "line 6 has no block; the next one is on line 7"
    assert beyond.refused.startswith("no block on line 99 of row.nc")
    assert other.refused == "no file and no program rov.nc; did you mean row.nc?"
    assert session.run().breakpoints == (placed,)
    assert session.points.placed == [placed, beyond, other]


@pytest.mark.parametrize(
    ("hits", "passes"),
    [
        (None, [0, 1, 2]), ("2", [1]), (">=2", [1, 2]), (">2", [2]), ("<2", [0]), ("<=2", [0, 1]),
        ("%2", [1]), ("==3", [2]), ("=1", [0]), ("9", []),
    ],
)  # fmt: skip
def test_hits_are_conditions_on_the_count(
    session: Session, hits: str | None, passes: list[int]
) -> None:
    session.set_points("lines", [PausePoint("O9100:N150", hits=hits)])
    seen = []
    while session.run().reason is Reason.BREAKPOINT:
        seen.append(session.machine.variables[30])
    assert seen == passes


@pytest.mark.parametrize("hits", ["", "x", "-1", "0", "%0", "3.5", "1" * 12, "> 2 3", "²"])
def test_what_is_no_count_is_refused(session: Session, hits: str) -> None:
    (placed,) = session.set_points("lines", [PausePoint("O9100:N150", hits=hits)])
    assert (hits == "") == (placed.refused == "")
    assert hits == "" or placed.refused.startswith("hits must be such as '3'")


def test_counts_go_back_with_the_machine_and_stay_with_their_point(session: Session) -> None:
    point = PausePoint("O9100:N150", hits="2")
    session.set_points("lines", [point])
    session.run()
    session.set_points("lines", [PausePoint("O1:N30"), point])
    assert session.points.placed[0].point == point
    session.back_to(0)
    assert session.run().text == "breakpoint O9100:N150"
    assert session.machine.variables[30] == 1
    assert session.run().text == "breakpoint O1:N30"


def test_a_log_point_writes_in_the_order_of_the_program(session: Session) -> None:
    told: list[str] = []
    session.output = lambda output: told.append(output.text)
    points = [
        PausePoint("O9100:N150", log="hole {#30+1} of {#6} at {X} {{{#101}}}"),
        PausePoint("O9100:N190", log="row {#[1/0]}"),
    ]
    session.set_points("lines", points)
    pause = session.run()
    assert pause.reason is Reason.END
    assert [(each.text, each.kind, each.line) for each in pause.output] == [
        ("hole 1 of 4 at 0 {vacant}", "log", 11),
        ("hole 2 of 4 at 20 {vacant}", "log", 11),
        ("hole 3 of 4 at 40 {vacant}", "log", 11),
        ("X  60.00", "message", 0),
        ("row {#[1/0]: the divisor is 0}", "log", 17),
    ]
    assert told == [each.text for each in pause.output]
    (refused,) = session.set_points("lines", [PausePoint("O9100:N150", log="{#1 GTT 2}")])
    assert refused.refused.startswith("when: ")


def test_an_alarm_pauses_unless_it_is_not_wanted() -> None:
    library = cncsub.loads("O1\nN10 G0 X1.\nN20 M98 P9\n", control=CONTROL)
    session = Session(library)
    pause = session.run()
    assert (pause.reason, pause.text, at(session)) == (
        Reason.ALARM, "alarm PS0076 program-not-found at O1 N20", 20,
    )  # fmt: skip
    assert session.back().reason is Reason.ENTRY
    assert at(session) == 10
    session.pauses_at_alarm = lambda number, cause: number == "PS0077"
    assert session.run().reason is Reason.END


def test_what_a_program_waits_for_and_limits_are_reasons() -> None:
    waiting = cncsub.loads("O1\nN10 IF[#500 EQ #0]GOTO 10\nN20 M30\n", control=CONTROL)
    assert Session(waiting).run().reason is Reason.WAITING
    endless = cncsub.loads("O1\nN10 #1=#1+1\nN20 GOTO10\n", control=CONTROL)
    assert Session(endless, max_blocks=100).run().reason is Reason.LIMIT


def test_a_condition_without_a_value_pauses_and_says_so(session: Session) -> None:
    session.set_points("lines", [PausePoint("O9100:N150", when="1/[#30-1] GT 0")])
    session.run()
    assert "has no value here: the divisor is 0" in session.at.text
    assert session.machine.variables[30] == 1
    assert session.run().reason is Reason.BREAKPOINT


def test_frames_have_passes_arguments_and_levels(session: Session) -> None:
    session.into()
    session.into()
    assert [(f.title, f.level, f.block.n) for f in session.frames() if f.block] == [
        ("O9100 (#4=20, #6=4, #9=120)", 1, 110), ("O1", 0, 20),
    ]  # fmt: skip
    session.set_points("lines", [PausePoint("O3:N200", hits="2")])
    session.run()
    assert [f.title for f in session.frames()] == ["O3 pass 2 of 2", "O1"]
    assert session.restart_frame().reason is Reason.STEP
    assert [f.title for f in session.frames()] == ["O3 pass 1 of 2", "O1"]
    assert session.restart_frame(1).reason is Reason.ENTRY
    with pytest.raises(ValueError, match="there is no frame 1; there are 0 to 0"):
        session.restart_frame(1)


def test_scopes_show_what_changed_since_the_last_pause(session: Session) -> None:
    session.into()
    session.into()
    session.into()
    assert scope(session, "locals of level 1") == {
        "#4 (I)": ("20", False), "#6 (K)": ("4", False), "#9 (F)": ("120", False),
        "#30": ("0", True), "#31": ("vacant", False),
    }  # fmt: skip
    session.into()
    assert scope(session, "locals of level 1")["#30"] == ("0", False)
    assert scope(session, "system: position") == {"#5001": ("0", False)}
    session.into()
    session.into()
    assert scope(session, "modes")["cycle"] == ("G81", True)
    assert scope(session, "tool, spindle and feed")["F (feed)"] == ("120", True)
    assert scope(session, "position") == {
        "X": ("0", False), "Y": ("0", False), "Z": ("50", False),
        "X (machine)": ("0", False), "Y (machine)": ("0", False), "Z (machine)": ("50", False),
    }  # fmt: skip
    names = [each.name for each in session.scopes(1)]
    assert "locals of level 1" not in names
    session.out()
    assert "locals of level 1" not in [each.name for each in session.scopes()]


def test_the_tool_the_switches_and_signals_are_set_by_the_names_that_are_shown() -> None:
    text = "O1\nN10 G90 G54 G0 X5. Z2.\n/N20 #100=#1004\nN30 G91 X1.\nN40 M1\nN50 M30\n"
    setup = {"work_offsets": {"G54": {"X": 10.125}}}
    session = Session(cncsub.loads(text, control="fanuc-0i-f"), setup=setup)
    session.into()
    assert scope(session, "switches") == {
        "block_skip": ("off", False), "optional_stop": ("off", False),
    }  # fmt: skip
    assert session.set("X", "#100+20") == "20"
    assert session.set("z (machine)", "-3") == "-3"
    assert session.set("#1004", "1") == "1"
    assert session.set("block_skip", "2, 3") == "2 3"
    assert session.set("optional_stop", "on") == "on"
    assert scope(session, "system: signals") == {"#1004": ("1", True)}
    assert scope(session, "switches")["block_skip"] == ("2 3", True)
    assert scope(session, "position")["X"] == ("20", True)
    for name, shown in (
        ("X", "20"), ("X (machine)", "30.125"), ("Z", "-3"), ("#1004", "1"), ("block_skip", "2 3"),
    ):  # fmt: skip
        assert session.evaluate(name) == shown
    session.into()
    session.into()
    assert (session.machine.variables[100], session.machine.position["X"]) == (1, 21)
    assert session.set("block_skip", "no") == "off"
    for name, value, why in (
        ("X", "vacant", "X always stands somewhere"),
        ("X", "#99999", "99999"),
        ("A", "1", "'A' cannot be set: it is no variable, mode, axis or switch"),
        ("#5001", "1", "5001"),
        ("optional_stop", "3", "optional_stop is on or off, not '3'"),
    ):
        with pytest.raises((KeyError, ValueError), match=why):
            session.set(name, value)


def test_a_signal_is_set_by_the_name_that_the_control_gives_it() -> None:
    text = "N5 R7=0\nN10 IF $A_IN[3]==TRUE GOTOF ENDE\nN20 R7=1\nN30 ENDE: M30\n"
    session = Session(cncsub.loads(text, control="siemens-one"))
    session.into()
    assert session.set("$A_IN[3]", "1") == "1"
    assert session.set("$a_in[4]", "1") == "1"
    assert session.machine.signals["$A_IN[3]"] == 1
    session.run()
    assert session.machine.variables["R7"] == 0


def test_names_that_a_program_does_not_define_are_set_as_it_would() -> None:
    text = "#<depth>=5\n#<_all>=3\nG0 X#<depth> Z#<_all>\nM2\n"
    session = Session(cncsub.loads(text, control="linuxcnc"))
    session.into()
    session.into()
    assert scope(session, "named variables") == {"#<depth>": ("5", False), "#<_all>": ("3", True)}
    assert session.set("#<depth>", "#<_all>*2") == "6"
    session.into()
    assert session.machine.position == {"X": 6, "Y": 0, "Z": 3}
    for name, value, why in (
        ("#<nobody>", "1", "cannot be set"), ("#<depth>", "1/0", "the divisor is 0"), ("1+2", "5", "cannot be set"),
    ):  # fmt: skip
        with pytest.raises((KeyError, ValueError), match=why):
            session.set(name, value)
    assert (session.evaluate("#<depth>"), session.machine.alarm) == ("6", None)


def test_a_control_whose_variables_begin_at_0_has_that_one_set() -> None:
    for control, text, name in (
        ("hnc-21m", "%1\nM98 P2 A3\nM30\n%2\n#1=#0\nM99\n", "#0"),
        ("siemens-one", "N10 R0=3\nN20 R1=R0\nN30 M30\n", "R0"),
    ):
        session = Session(cncsub.loads({"P.MPF": text}, control=control))
        session.into()
        assert session.set(name, "7") == "7"
        session.into()
        assert session.evaluate(name.replace("0", "1")) == "7"


def test_named_variables_are_shown_and_set() -> None:
    text = 'DEF INT SIDES[2]=SET(3,4)\nDEF STRING[8] NAME="A"\nDEF REAL DEPTH=5\nR1=DEPTH\nM30\n'
    session = Session(cncsub.loads({"A.MPF": text}, control="siemens-one"))
    for _ in range(3):
        session.into()
    assert scope(session, "named variables") == {
        "SIDES": ("[3, 4]", False), "NAME": ('"A"', False), "DEPTH": ("5", True),
    }  # fmt: skip
    assert session.set("DEPTH", "2*3") == "6"
    assert session.set("SIDES", "[7, 1+1]") == "[7, 2]"
    assert session.set("NAME", '"HOLE"') == '"HOLE"'
    session.into()
    assert (session.evaluate("R1"), session.evaluate("depth")) == ("6", "6")
    assert scope(session, "commons") == {"R1": ("6", True)}
    assert session.set("R1", "DEPTH/4") == "1.5"


def test_variables_with_names_of_their_own_are_shown() -> None:
    text = "#<depth>=1\n#<_all>=#<depth>\no100 sub\n#<inner>=#1\no100 endsub\no100 call [5]\nM2\n"
    session = Session(cncsub.loads(text, control="linuxcnc"))
    session.into()
    assert scope(session, "named variables") == {"#<depth>": ("1", True)}
    session.into()
    session.into()
    session.into()
    assert at_text(session) == "o100 call [5]"
    assert scope(session, "named variables")["#<_all>"] == ("1", False)
    (shown,) = [each for each in session.scopes() if each.name == "named variables"]
    assert all(value.can_set for value in shown.values)


def test_values_are_read_and_set_as_the_program_of_a_frame_sees_them(session: Session) -> None:
    session.set("#4", "1.5")
    session.into()
    session.into()
    assert [session.evaluate("#4", frame) for frame in (0, 1)] == ["20", "1.5"]
    assert session.set("#4 (I)", "#6*2", 1) == "8"
    assert session.set("#6", "vacant") == "vacant"
    assert [session.evaluate("#4", frame) for frame in (0, 1)] == ["20", "8"]
    assert session.evaluate("#4+1") == "21"
    with pytest.raises(ValueError, match="in O1 ask for a variable by its number or name"):
        session.evaluate("#4+1", 1)
    assert session.set("work", "G55") == "G55"
    assert (session.evaluate("work"), session.evaluate("F")) == ("G55", "0")
    for name in ("nobody", "A"):
        with pytest.raises(KeyError, match="cannot be set"):
            session.set(name, "1")


def test_hover_tells_the_value_and_the_meaning(session: Session) -> None:
    session.into()
    session.into()
    known = "a local variable of the program that runs, at its level: #1 to #33"
    assert session.hover("#6") == f"#6 = 4\n{known}"
    assert session.hover("#5221").startswith("#5221 = 0\nan offset of a work coordinate system")
    assert session.hover("G81").startswith("mill: drills a hole\nlathe-")
    assert session.hover("?!") == ""


def test_completions_begin_where_the_word_begins(session: Session) -> None:
    session.into()
    session.into()
    found = session.completions("#30+#", 6)
    assert ("#6", 5, "variable", "4") in found
    assert session.completions("di", 3)[0][:3] == ("distance", 1, "mode")
    assert session.completions("zzz", 4) == []


def test_a_search_finds_who_wrote_last(session: Session) -> None:
    session.set_points("lines", [PausePoint("O9100:N180")])
    session.run()
    found = session.search("#30")
    assert [(each.block.n, each.value) for each in found] == [
        (160, "3"), (160, "2"), (160, "1"), (110, "0"),
    ]  # fmt: skip
    assert found[0].step < session.machine.blocks
    assert at(session) == 180
    with pytest.raises(ValueError, match="changes: "):
        session.search("#30 +")


def test_another_block_is_made_the_next_one(session: Session) -> None:
    session.set_points("lines", [PausePoint("O9100:N140", when="#30 EQ 1")])
    session.run()
    blocks = session.machine.blocks
    pause = session.goto("row.nc:12")
    assert (pause.reason, at(session), session.machine.blocks) == (Reason.GOTO, 160, blocks)
    with pytest.raises(ValueError, match="line 4 is a block of O1; the program that runs is O9100"):
        session.goto("O1:N25")
    assert (session.at, at(session)) == (pause, 160)
    session.set_points("lines", [PausePoint("O9100:N180")])
    session.run()
    holes = [move.x for move in session.machine.moves if move.z == -8]
    assert holes == [0, 20]  # one was jumped over
    session.back()
    assert at(session) == 130
    session.back_to(blocks - 1)
    assert at(session) == 130


def test_what_is_no_block_is_refused_by_name(session: Session) -> None:
    with pytest.raises(ValueError, match="mdi: "):
        session.mdi("G0 X[")


def test_to_the_call_with_no_call_open_stays(session: Session) -> None:
    session.into()
    pause = session.back_to_call()
    assert (pause.text, at(session)) == ("no call is open: the main program runs", 20)


def test_locals_that_a_subprogram_inside_a_macro_changes_are_marked() -> None:
    text = "O1\nN10 G65 P2 A1.\nN20 M30\nO2\nN30 M98 P3\nN40 M99\nO3\nN50 #1=5\nN60 M99\n"
    session = Session(cncsub.loads(text, control="fanuc-0i-f"))
    session.set_points("lines", [PausePoint("O3:N50")])
    session.run()
    session.into()
    (level,) = [scope for scope in session.scopes() if scope.name == "locals of level 1"]
    assert [(value.name, value.text, value.changed) for value in level.values] == [
        ("#1 (A)", "5", True)
    ]
    session.into()
    (level,) = [scope for scope in session.scopes() if scope.name == "locals of level 1"]
    assert [value.changed for value in level.values] == [False]


def test_a_condition_without_a_value_is_named(session: Session) -> None:
    session.set_points("lines", [PausePoint("O1:N20", when="1/#140")])
    assert session.run().text.startswith("the condition '1/#140' has no value here: ")


def test_a_movement_back_and_a_search_are_paused() -> None:
    text = "O1\nN10 #100=1\nN20 #1=#1+1\nN30 IF[#1 LT 400000]GOTO20\nN40 M30\n"
    session = Session(cncsub.loads(text, control="fanuc-0i-f"), trace="blocks")
    session.run()
    blocks = session.machine.blocks
    session.pause()  # for the next movement
    pause = session.back_to("#100")
    assert (pause.reason, pause.text) == (
        Reason.PAUSE, "going back was paused; the machine stands where it stood",
    )  # fmt: skip
    assert session.machine.blocks == blocks
    found: list[str] = []

    def search() -> None:
        try:
            session.search("#100")
        except InterruptedError as stopped:
            found.append(str(stopped))

    searching = threading.Thread(target=search)
    searching.start()
    while searching.is_alive() and not session.stop_search():
        time.sleep(0.001)
    searching.join(20)
    assert found == ["the search was paused"]
    session.tick()  # has no movement back end
    assert session.back_to("#100").reason is Reason.STEP
    assert session.machine.blocks == 0


def test_a_point_at_the_first_block_counts_where_nobody_has_seen_it(session: Session) -> None:
    session.set_points("lines", [PausePoint("O1:N10", when="#1 EQ #0"), PausePoint("O1:N20")])
    assert session.run(here=True).text == "breakpoint O1:N10"
    assert session.run().text == "breakpoint O1:N20"
    session.start()
    assert session.run().text == "breakpoint O1:N20"


def test_a_watch_on_a_local_means_the_call_where_it_was_set() -> None:
    text = (
        "O1\nN10 #1=5\nN20 G65 P2 A7.\nN30 #1=6\nN40 M30\nO2\nN50 #1=8\nN60 G65 P3 A1.\n"
        "N70 #1=9\nN80 M99\nO3\nN90 #1=2\nN95 M99\n"
    )
    session = Session(cncsub.loads(text, control=CONTROL))
    session.set_points("lines", [PausePoint("O3:N95")])
    session.run()
    assert [session.level_opener(i) for i in range(3)] == [1, 0, -1]
    points = [PausePoint("changes #1", call=0), PausePoint("changes #1", call=-1)]
    session.set_points("data", points)
    assert [(session.run().breakpoints[0].point.call, at(session)) for _ in range(2)] == [
        (0, 80), (-1, 40),
    ]  # fmt: skip
    assert session.run().reason is Reason.END


def test_a_point_is_toggled(session: Session) -> None:
    assert session.toggle("O9100:N150") is not None
    assert session.run().reason is Reason.BREAKPOINT
    assert session.toggle("O9100:N150") is None
    assert session.run().reason is Reason.END


def test_starting_again_keeps_the_points(session: Session) -> None:
    session.set_points("lines", [PausePoint("O9100:N150", hits="2")])
    first: list[Pause] = [session.run(), session.run()]
    assert session.start().reason is Reason.ENTRY
    assert session.machine.blocks == 0
    assert [session.run(), session.run()] == first


def test_options_of_a_run_are_those_of_a_session() -> None:
    library = cncsub.loads("O1\n/N10 X1.\nN20 #1=#500\nN30 M30\n", control=CONTROL)
    session = Session(library, block_skip=[1], variables={500: 7})
    session.into()
    assert session.evaluate("#1") == "7"
    options: dict[str, Any] = {"no_such": 1}
    with pytest.raises(TypeError, match="no option 'no_such'"):
        Session(library, **options)


LOOP = "O1\nN10 #1=#1+1\nN20 #2=#1*2\nN30 IF[#1 LT {}]GOTO10\nN40 M30\n"


def test_another_thread_pauses_a_movement_that_goes_on_later() -> None:
    library = cncsub.loads(LOOP.format(99999999), control=CONTROL)
    session = Session(library, max_blocks=2**40)
    threading.Timer(0.05, session.pause).start()
    assert session.run().reason is Reason.PAUSE
    before = session.machine.variables[1]
    assert before is not None
    session.into()
    session.into()
    session.into()
    assert session.machine.variables[1] == before + 1
    threading.Timer(0.05, session.pause).start()
    assert session.out().reason is Reason.PAUSE


def test_ticks_lose_no_breakpoint_and_no_change() -> None:
    library = cncsub.loads(LOOP.format(3000), control=CONTROL)
    session = Session(library)
    session.set_points(
        "all",
        [
            PausePoint("O1:N30", when="#1 GT 0", log="{#1}"),
            PausePoint("changes #2", log="change {#1}"),
        ],
    )
    told: list[int] = []
    session.progress = told.append
    done = threading.Event()

    def tick() -> None:
        while not done.wait(0.0005):
            session.tick()

    ticking = threading.Thread(target=tick)
    ticking.start()
    try:
        pause = session.run()
    finally:
        done.set()
        ticking.join()
    assert pause.reason is Reason.END
    assert [each.text for each in pause.output if " " not in each.text] == [
        str(number) for number in range(1, 3001)
    ]
    assert len(pause.output) == 6000
    assert told


def test_an_element_of_an_array_and_a_whole_frame_are_set() -> None:
    text = "DEF INT GRID[2,3]\nDEF REAL ONE\nR1=GRID[1,2]\nM30\n"
    session = Session(cncsub.loads(text, control="siemens-one"))
    for _ in range(2):
        session.into()
    assert session.set("GRID[1,2]", "7") == "7"
    assert session.set("grid[R2,1]", "3") == "3"
    assert session.machine.variables.named["GRID"] == [[0, 3, 0], [0, 0, 7]]
    for wrong in ("GRID[2,0]", "GRID[0]", "GRID[0,-1]"):
        with pytest.raises(KeyError, match=r"GRID has no element"):
            session.set(wrong, "1")
    session.into()
    assert session.evaluate("R1") == "7"
    assert session.set("$P_UIFR[1]", "CTRANS(X,5):CROT(Z,30)") == '"CTRANS(X,5):CROT(Z,30)"'
    with pytest.raises(KeyError, match="'100' cannot be set"):
        session.set("100", "5")
