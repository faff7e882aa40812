"""The references of blocks, and the call graph, without running anything."""

import json
import sys
from pathlib import Path
from random import Random

import pytest

import cncsub
from cncsub import CallTo, Computed, testing

sys.path.insert(0, str(Path(__file__).with_name("conformance")))
from conformance import rows

MILL = "fanuc-0i-f"
PROGRAMS = "O2\nN30 M99\nO3\nM99\nO10\nN5 M99\n"


def block_of(text: str, control: str, behind: str = PROGRAMS) -> cncsub.Block:
    library = cncsub.loads(f"O1\n{text}\nN10 M30\n{behind}", control=control)
    return library["O1"].blocks[0]


# block, control, kind, program, exists, start, repeats, word that calls, column
CALLS = [
    ("M98 P2", MILL, "M98", "O2", True, None, 1, "M98", 1),
    ("N7 M98 P2 L3", MILL, "M98", "O2", True, None, 3, "M98", 4),
    ("M98 P30002", MILL, "M98", "O2", True, None, 3, "M98", 1),
    ("M98 P7", MILL, "M98", "O7", False, None, 1, "M98", 1),
    ("G0 X1. M98 P2", MILL, "M98", "O2", True, None, 1, "M98", 8),
    ("M98 P#100 L2", MILL, "M98", Computed("#100"), None, None, 2, "M98", 1),
    ("M98 P[#1+2] L#2", MILL, "M98", Computed("[#1+2]"), None, None, Computed("#2"), "M98", 1),
    ("M98 P2 L#2", MILL, "M98", "O2", True, None, Computed("#2"), "M98", 1),
    ("G65 P3 A1. B#2", MILL, "G65", "O3", True, None, 1, "G65", 1),
    ("G66 P3 L2", MILL, "G66", "O3", True, None, 2, "G66", 1),
    ("M98 P2 H30", "mitsubishi-m700", "M98", "O2", True, 30, 1, "M98", 1),
    ("M98 P2 H#1", "mitsubishi-m700", "M98", "O2", True, Computed("#1"), 1, "M98", 1),
    ("M97 P10 L2", "haas-ngc", "M97", "O1", True, 10, 2, "M97", 1),
    ("IF [#1 EQ 30] M98 P2 L2", "haas-ngc", "M98", "O2", True, None, 2, "M98", 15),
    ("IF [#1 EQ 30] THEN G65 P3 A1.", "haas-ngc", "G65", "O3", True, None, 1, "G65", 20),
]


@pytest.mark.parametrize("row", CALLS, ids=lambda row: f"{row[1]}: {row[0]}")
def test_a_call_is_told(row: tuple[object, ...]) -> None:
    text, control, kind, program, exists, start, repeats, word, column = row
    calls = block_of(str(text), str(control)).calls
    assert [(c.kind, c.program, c.exists, c.start, c.repeats, c.text, c.column) for c in calls] == [
        (kind, program, exists, start, repeats, word, column)
    ]


@pytest.mark.parametrize("row", [row for row in CALLS if row[4]], ids=lambda row: str(row[0]))
def test_what_a_call_tells_is_what_it_does(row: tuple[object, ...]) -> None:
    text, control, kind, program, _, start, repeats, _, _ = row
    library = cncsub.loads(f"O1\n{text}\nN10 M30\n{PROGRAMS}", control=str(control))
    first = [*library.run(variables={1: 30, 2: 1}).calls, *library.mdi(f"{text}\nX1.").calls]
    told = [call for call in first if call.kind == kind]
    assert told, "nothing was called"
    assert told[0].program == program
    if not isinstance(start, Computed):
        assert told[0].start_n == start
    if not isinstance(repeats, Computed):
        assert told[0].repeats == repeats


def test_a_code_that_calls_is_a_call() -> None:
    control = cncsub.controls[MILL].with_parameters({"6050": 81})
    block = cncsub.loads("O1\nG81 X1.\nM30\n", control=control)["O1"].blocks[0]
    assert [(c.kind, c.program, c.exists) for c in block.calls] == [("G-code", "O9010", False)]


# block, control, kind, n, place of the block, conditional, in the caller
JUMPS = [
    ("GOTO10", MILL, "GOTO", 10, 1, False, False),
    ("GOTO99", MILL, "GOTO", 99, None, False, False),
    ("GOTO#1", MILL, "GOTO", Computed("#1"), None, False, False),
    ("IF[#1EQ2]GOTO10", MILL, "GOTO", 10, 1, True, False),
    ("IF[#1EQ2]THEN GOTO10", "gsk-988ta", "GOTO", 10, 1, True, False),
    ("M99 P20", MILL, "M99", 20, None, False, True),
    ("M99 P#1", MILL, "M99", Computed("#1"), None, False, True),
    ("M99 P10", "haas-ngc", "M99", 10, 1, False, False),
    ("G65 H80 P10", "gsk-980tdi", "G65", 10, None, False, False),
    ("G65 H81 P10 Q#200 R3", "gsk-980tdi", "G65", 10, None, True, False),
]


@pytest.mark.parametrize("row", JUMPS, ids=lambda row: f"{row[1]}: {row[0]}")
def test_a_jump_is_told(row: tuple[object, ...]) -> None:
    text, control, *told = row
    jumps = block_of(str(text), str(control)).jumps
    assert [[j.kind, j.n, j.block, j.conditional, j.in_caller] for j in jumps] == [told]


# block, control, reads, writes
VARIABLES: list[tuple[str, str, list[object], list[object]]] = [
    ("#100=#1+#2", MILL, [1, 2], [100]),
    ("#1=-5.", MILL, [], [1]),
    ("#100=#0", MILL, [], [100]),
    ("#3006=1(WAIT)", MILL, [], [3006]),
    ("#500=#5041*2", MILL, [5041], [500]),
    ("#[#1+2]=#3", MILL, [3, 1], [Computed("#[#1+2]")]),
    ("#1=#[#2]", MILL, [2, Computed("#[#2]")], [1]),
    ("G1 X#1 Y[#2*SIN[#3]] F#9", MILL, [9, 1, 2, 3], []),
    ("G#1 X1.", MILL, [1], []),
    ("M98 P#100 L#101", MILL, [100, 101], []),
    ("G65 P3 A#1 B[#2+1]", MILL, [1, 2], []),
    ("IF[#1GT#2]GOTO#3", MILL, [1, 2, 3], []),
    ("IF[#1GT2]THEN #3=#4", MILL, [1, 4], [3]),
    ("WHILE[#1LT5]DO1\nEND1", MILL, [1], []),
    ("DPRNT[X#100[53]]", MILL, [100], []),
    ("/#1=#2", MILL, [2], [1]),
    ("G1 X#1 /Y#2", MILL, [1, 2], []),
    ("#9100=1", "gsk-980tdi", [100], [Computed("#9100")]),
    ("G65 H2 P#200 Q#201 R#202", "gsk-980tdi", [201, 202], [200]),
    ("#<a>=[#<a>+#5]", "linuxcnc", ["a", 5], ["a"]),
    ("#<_g>=1", "linuxcnc", [], ["_g"]),
    ("R1=R2+1", "siemens-one", [2], [1]),
    ("[#ABC]=[#ABC]+1", "fanuc-30i", ["ABC"], ["ABC"]),
    ("M98 P[#1] L2", "hnc-21m", [1], []),
    ("#1=#2+#2", MILL, [2], [1]),
    ("G1 X1 (NO VARIABLE #5)", MILL, [], []),
    ("G1 X1.5.", MILL, [], []),  # refused
]


@pytest.mark.parametrize("row", VARIABLES, ids=lambda row: f"{row[1]}: {row[0]}")
def test_variables_are_told(row: tuple[str, str, list[object], list[object]]) -> None:
    text, control, reads, writes = row
    block = cncsub.loads(f"{text}\n", control=control, name="A.MPF").main.blocks[0]  # type: ignore[union-attr]
    assert [use.variable for use in block.reads] == reads
    assert [use.variable for use in block.writes] == writes


def test_texts_are_what_is_written() -> None:
    library = cncsub.loads("O1\r\n\tN10 #1=#2 ;[#AB]=[#1 + 2]\r\nM30\r\n", control="fanuc-30i")
    uses = [use for block in library["O1"].blocks for use in (*block.reads, *block.writes)]
    assert [(use.text, use.column) for use in uses] == [
        ("#2", 9), ("#1", 6), ("[#1 + 2]", 19), ("#AB", 14),
    ]  # fmt: skip


def test_columns_count_characters() -> None:
    block = cncsub.loads("O1\nN1 (é漢) M98 P2\nM30\n", control=MILL)["O1"].blocks[0]
    assert block.calls[0].column == 9


def test_a_return_calls_nothing_on_linuxcnc() -> None:
    library = cncsub.loads("O1\nG0 X1\nM99\nO2\nM98 P1\nM99\n", control="linuxcnc")
    calls = [call.program for p in library.values() for b in p.blocks for call in b.calls]
    assert set(calls) == {"O1"}
    assert library.call_graph().missing == ()


def test_calls_by_label_lead_to_heads_and_files() -> None:
    text = "o100 sub\no100 endsub\no100 call [#3]\no200 call\nM98 P100 L2\nM2\n"
    main = cncsub.loads(text, control="linuxcnc").main
    assert main is not None
    calls = [call for block in main.blocks for call in block.calls]
    assert [(c.kind, c.program, c.exists, c.repeats) for c in calls] == [
        ("O", "O100", True, 1),
        ("O", "200", False, 1),
        ("M98", "O100", True, 2),
    ]


def test_labels_are_blocks() -> None:
    text = "AA:\nGOTOB AA\nIF R1>2 GOTOF BB\nBB:\nM30\n"
    main = cncsub.loads(text, control="siemens-one", name="A.MPF").main
    assert main is not None
    jumps = [jump for block in main.blocks for jump in block.jumps]
    assert [(j.n, j.block, j.conditional) for j in jumps] == [(None, 0, False), (None, 3, True)]


# ---- who calls whom ----

JOB = (
    "O1\nN10 M98 P2\nN20 M98 P#100\nM30\nO2\nG65 P3\nG65 P3\nM99\nO3\nG65 P4\nM99\n"
    "O4\nM98 P9\nM99\nO5\nM98 P6\nM99\nO6\nM98 P5\nM99\nO7\nM98 P7\nM99\nO8\nM99\n"
)


def test_a_graph_tells_who_calls_whom() -> None:
    graph = cncsub.loads(JOB, control=MILL).call_graph()
    assert graph.programs == ("O1", "O2", "O3", "O4", "O5", "O6", "O7", "O8")
    assert [(e.caller, e.n, e.line, e.kind, e.called) for e in graph.edges][:4] == [
        ("O1", 10, 2, "M98", "O2"),
        ("O1", 20, 3, "M98", Computed("#100")),
        ("O2", None, 6, "G65", "O3"),
        ("O2", None, 7, "G65", "O3"),
    ]
    assert graph.roots == ("O1", "O8")
    assert graph.unreached == ("O5", "O6", "O7", "O8")
    assert graph.cycles == (("O5", "O6"), ("O7",))
    assert [(e.caller, e.called) for e in graph.missing] == [("O4", "O9")]
    assert [e.called for e in graph.computed] == [Computed("#100")]
    assert graph.deepest["any"] == ("O1", "O2", "O3", "O4")
    assert graph.deepest["G65"] == ("O2", "O3", "O4")
    assert len(graph.deepest["M98"]) == 2


def test_a_graph_of_nothing() -> None:
    graph = cncsub.loads("", control=MILL, name="PART.NC").call_graph()
    assert (graph.edges, graph.roots, graph.unreached, graph.cycles) == ((), ("PART",), (), ())
    assert graph.deepest == {}


def test_programs_of_the_external_device_are_in_it(tmp_path: Path) -> None:
    text = "O1\nM198 P50\nM30\n"
    (tmp_path / "O50").write_text("O50\nM99\n")
    library = cncsub.loads(text, control=MILL, external=tmp_path)
    graph = library.call_graph()
    assert [(e.kind, e.called, e.exists) for e in graph.edges] == [("M198", "O50", True)]
    assert graph.unreached == ()
    call = library["O1"].blocks[0].calls[0]
    assert isinstance(call, CallTo)
    assert call.external


def test_a_long_chain_and_a_large_cycle() -> None:
    count = 9000
    chain = "".join(f"O{i}\nM98 P{i + 1}\nM99\n" for i in range(1, count))
    graph = cncsub.loads(f"{chain}O{count}\nM99\n", control=MILL).call_graph()
    assert len(graph.deepest["any"]) == count
    assert graph.cycles == ()
    graph = cncsub.loads(f"{chain}O{count}\nM98 P1\nM99\n", control=MILL).call_graph()
    assert [len(cycle) for cycle in graph.cycles] == [count]
    assert graph.roots == ()


def test_a_graph_is_a_table_a_text_and_a_picture() -> None:
    graph = cncsub.loads(JOB, control=MILL).call_graph()
    frame = graph.to_pandas()
    assert len(frame) == len(graph.edges)
    assert frame["called_expression"].dropna().tolist() == ["#100"]
    table = graph.to_arrow()
    assert table.num_rows == len(graph.edges)
    assert table["n"].to_pylist()[:3] == [10, 20, None]
    told = json.loads(graph.to_json())
    assert told["version"] == 1
    assert told["cycles"] == [["O5", "O6"], ["O7"]]
    assert told["edges"][1]["called_expression"] == "#100"
    dot = graph.to_dot()
    assert '"O2" -> "O3" [label="G65 (2 calls)"];' in dot
    assert '"O9" [style=dashed];' in dot
    assert '"#100" [style=dotted];' in dot


def test_what_a_graph_tells_is_what_a_run_does() -> None:
    text = "O1\nM98 P2\nG65 P3 A1.\nM30\nO2\nG65 P3\nM99\nO3\nM99\n"
    library = cncsub.loads(text, control=MILL)
    calls = library.run().calls
    caller = {None: "O1", **{c.call: c.program for c in calls}}
    ran = {(caller[c.parent], c.program) for c in calls}
    assert ran == {(edge.caller, edge.called) for edge in library.call_graph().edges}


def test_every_call_of_a_row_is_in_the_graph() -> None:
    """A modal call belongs to whatever moves, but the graph shows it where it is switched on."""
    seen = 0
    for row in rows():
        if row.case.mdi is not None or row.control == "linuxcnc":
            continue  # there the blocks of a sub are its own, wherever they stand
        library = testing.outcome.load(row.case, cncsub.controls[row.control])
        run = testing.outcome.execute(row.case, library)
        if not len(run.calls):
            continue
        graph = library.call_graph()
        known = {(edge.caller, edge.called) for edge in graph.edges}
        computed = {edge.caller for edge in graph.edges if isinstance(edge.called, Computed)}
        programs = {None: run.steps[0].program, **{c.call: c.program for c in run.calls}}
        for call in run.calls:
            caller = programs[call.parent]
            seen += 1
            told = (caller, call.program) in known or caller in computed
            # A modal call follows the moves of any program; MCALL calls as a name does. Among
            # programs of one name CALLPATH chooses while it runs.
            main = library.code.program(0).text
            modal = call.kind.startswith("G66") or "MCALL" in main
            bare = {(edge.caller, str(edge.called).rpartition("/")[2]) for edge in graph.edges}
            chosen = "CALLPATH" in main and (caller, call.program.rpartition("/")[2]) in bare
            assert told or modal or chosen, (str(row), caller, call.program)
    assert seen > 4000


def test_words_by_arithmetic_are_words_of_their_block() -> None:
    text = "O1\nN10 G0 X#5+7. Y2.-#1 Z#1 MOD 4 A#1+SIN[30]*2 B10./#2 /Y3\nM30\n"
    words = cncsub.loads(text, control="mitsubishi-m700")["O1"].blocks[0].words
    assert [w.text for w in words] == [
        "N10", "G0", "X#5+7.", "Y2.-#1", "Z#1MOD4", "A#1+SIN[30]*2", "B10./#2", "/", "Y3",
    ]  # fmt: skip
    assert [w.value for w in words[2:7]] == [None] * 5


@pytest.mark.parametrize("control", ["fanuc-0i-f", "linuxcnc", "siemens-one"])
def test_words_end_on_characters(control: str) -> None:
    random = Random(control)
    parts = [
        "MOD",
        "ATAN",
        "G0",
        "X",
        "#",
        "<",
        ">",
        "[",
        "]",
        "=",
        "/",
        "(",
        '"',
        "1.",
        "$",
        "O",
        "中",
        "é",
        "😀",
        " ",
        "IF",
    ]
    for _ in range(2000):
        text = "".join(random.choices(parts, k=random.randint(1, 8)))
        for program in cncsub.loads(f"N1 {text}\n", control=control).values():
            for block in program.blocks:
                assert all(word.text or word.width for word in block.words), text
