"""Programs of the control itself, such as standard cycles: they run, and are no programs of the user."""

from __future__ import annotations

import pickle

import cncsub

ONE = "siemens-one"
DRILL = "N10 G0 X5 Y7 Z60 F100\nN20 CYCLE81(50,30,2,-10)\nN30 M30\n"


def test_a_cycle_is_no_program_of_the_library() -> None:
    library = cncsub.loads(DRILL, control=ONE)
    assert list(library) == ["MAIN"]
    assert len(library) == 1
    assert library.main is not None
    assert library.main.name == "MAIN"
    assert [name for name, *_ in library.code.sources] == ["<text>"]
    assert library.notes == ()


def test_a_library_that_calls_no_cycle_holds_none() -> None:
    assert len(cncsub.loads("N10 G0 X1\nN20 M30\n", control=ONE).code) == 1
    assert len(cncsub.loads(DRILL, control=ONE).code) == 2


def test_a_cycle_that_calls_nothing_else_is_read_once() -> None:
    library = cncsub.loads("N10 CYCLE81(9,0,1,-1)\nN20 cycle81(9,0,1,-2)\nN30 M30\n", control=ONE)
    assert len(library.code) == 2


def test_calls_and_frames_show_the_cycle() -> None:
    library = cncsub.loads("N20 CYCLE81(50,50,2,0,10)\nN30 M30\n", control=ONE)
    run = library.run()
    alarm = run.alarm
    assert alarm is not None
    assert (alarm.number, alarm.text) == ("61101", "reference plane incorrectly defined")
    assert (alarm.program, [(frame.program, frame.n) for frame in alarm.frames]) == (
        "CYCLE81",
        [("MAIN", 20)],
    )
    assert [call.program for call in run.calls] == ["CYCLE81"]


def test_the_call_graph_leads_to_cycles_and_does_not_look_into_them() -> None:
    text = "N10 MCALL CYCLE83(50,30,2,-10,,20)\nN20 HOLES2(0,0,5,0,0,3)\nN30 MCALL\nN40 M30\n"
    graph = cncsub.loads(text, control=ONE).call_graph()
    assert graph.programs == ("MAIN",)
    assert [(edge.caller, edge.called, edge.exists) for edge in graph.edges] == [
        ("MAIN", "CYCLE83", True),
        ("MAIN", "HOLES2", True),
    ]
    assert graph.unreached == ()
    assert graph.missing == ()


def test_check_finds_nothing_in_a_cycle() -> None:
    every = "".join(
        f"N{number} {cycle}(50,30,2,-10)\n"
        for number, cycle in enumerate(
            (
                "CYCLE81",
                "CYCLE82",
                "CYCLE83",
                "CYCLE85",
                "CYCLE86",
                "CYCLE87",
                "CYCLE88",
                "CYCLE89",
            ),
            20,
        )
    )
    patterns = "N40 HOLES1(0,0,0,0,5,2)\nN41 HOLES2(0,0,5,0,0,3)\nN42 CYCLE801(0,0,0,5,5,2,2)\n"
    text = f"N10 G0 X5 Y7 Z60 F100\n{every}{patterns}N90 M30\n"
    assert cncsub.loads(text, control=ONE).check() == []


def test_coverage_counts_the_blocks_of_the_user() -> None:
    coverage = cncsub.loads(DRILL, control=ONE).run().coverage()
    assert {row.program for row in coverage.blocks} == {"MAIN"}
    assert len(coverage.blocks) == 3
    assert coverage.percent == 100


def test_a_flat_program_has_the_moves_of_the_cycle() -> None:
    flat = cncsub.loads(DRILL, control=ONE).flatten()
    flat.verify()
    assert "CYCLE81" not in flat.text


def test_a_library_with_a_cycle_can_be_copied_and_changed() -> None:
    library = cncsub.loads(DRILL, control=ONE)
    copy = pickle.loads(pickle.dumps(library))
    assert list(copy) == ["MAIN"]
    assert len(copy.run().moves) == 4
    own = library.with_program(
        "PROC CYCLE81(REAL RTP, REAL RFP, REAL SDIS, REAL DP)\nG0 X=DP\nM17\n", name="CYCLE81.SPF"
    )
    assert len(own.run().moves) == 2


def test_the_feeds_of_a_cycle_and_the_feed_after_it() -> None:
    def feeds(call: str) -> list[float]:
        text = f"N10 G0 X5 Z60 F100\nN20 {call}\nN30 G1 X9\nN40 M30\n"
        moves = cncsub.loads(text, control=ONE).run().moves
        return [move.feed for move in moves if move.kind == "feed"]

    assert feeds("CYCLE83(50,30,2,10,,20,,0,0,0,0.5)") == [50, 100, 100, 100]
    assert feeds("CYCLE83(50,30,2,10,,20)") == [100, 100, 100, 100]
    assert feeds("CYCLE85(50,30,2,10,,0,80,200)") == [80, 200, 100]
    assert feeds("CYCLE85(50,30,2,10,,0,80)") == [80, 80, 100]
    assert feeds("CYCLE85(50,30,2,10)") == [100, 100, 100]
    assert feeds("CYCLE89(50,30,2,10)") == [100, 100, 100]


def test_no_cycle_touches_an_r_parameter() -> None:
    run = cncsub.loads("N5 R1=7\n" + DRILL, control=ONE).run()
    assert run.variables[1] == 7
    assert all(run.variables[number] is None for number in range(2, 100))
