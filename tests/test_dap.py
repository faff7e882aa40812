"""The debug adapter: each request of the protocol, any order of them, and clients that lie."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from dap_client import Client, framed, in_process
from debugged import ENDLESS, ROW


@pytest.fixture
def row(tmp_path: Path) -> Path:
    path = tmp_path / "row.nc"
    path.write_text(ROW)
    return path


@pytest.fixture
def client() -> Iterator[Client]:
    with in_process() as client:
        yield client


def test_a_program_runs_to_its_end(client: Client, row: Path) -> None:
    client.launch(row)
    client.ask("configurationDone")
    assert client.event("output") == {"category": "stdout", "output": "X  60.00\n"}
    assert client.event("exited") == {"exitCode": 0}
    client.event("terminated")
    client.ask("disconnect")
    assert client.over()


def test_blocks_are_typed_in_the_console(client: Client, row: Path) -> None:
    client.launch(row, stopOnEntry=True)
    client.ask("configurationDone")
    client.event("stopped")
    client.go("next")
    typed = client.ask("evaluate", expression="G0 X5. Y3.", context="repl")
    assert typed["result"] == "run as typed in MDI"
    client.event("continued")
    assert client.event("stopped")["description"] == "the typed blocks are executed"
    assert client.values("position")["X"] == "5"
    assert client.stack() == [("O1", 3)]
    assert client.ask("evaluate", expression="#100=5", context="repl")["result"] == "5"
    client.lines(row, 19)
    client.ask("evaluate", expression="M98 P3", context="repl")
    assert client.event("stopped")["reason"] == "breakpoint"
    assert client.stack() == [("O3", 19), ("MDI", 1), ("O1", 3)]
    client.go("stepBack")
    client.go("stepBack")
    assert client.values("position")["X"] == "0"
    assert "nor is it a block" in client.refused("evaluate", expression="G0 X[", context="repl")
    assert (
        client.ask("evaluate", expression="explain G0", context="repl")["result"]
        == "moves at rapid"
    )
    client.refused("evaluate", expression="G0 X1.", context="watch")


def test_a_cancelled_request_leaves_the_others_alone(client: Client, row: Path) -> None:
    client.launch(row, stopOnEntry=True)
    done = client.send("configurationDone")
    for _ in range(200):
        client.send("cancel", requestId=10**9)  # none that waits
    assert client.answer(done)["success"]
    client.event("stopped")
    moving = client.send("next", threadId=1)
    for _ in range(50):
        client.send("cancel", requestId=moving)
    answer = client.answer(moving)
    if answer["success"]:
        assert client.event("stopped")["reason"] == "step"
    else:
        assert answer["message"] == "cancelled"
    assert client.go("next")["reason"] == "step"


def test_lines_pause_and_move_to_the_next_block(client: Client, row: Path) -> None:
    client.launch(row)
    placed = client.lines(row, 6, 99, {"line": 11, "condition": "#30 GE 2"})
    assert [each["verified"] for each in placed] == [True, False, True]
    assert (placed[0]["line"], placed[0]["message"]) == (
        7, "line 6 has no block; the next one is on line 7",
    )  # fmt: skip
    assert placed[0]["source"]["path"] == str(row)
    client.ask("configurationDone")
    stopped = client.event("stopped")
    assert (stopped["reason"], stopped["hitBreakpointIds"]) == ("breakpoint", [placed[0]["id"]])
    assert client.stack() == [("O9100 (#4=20, #6=4, #9=120)", 7), ("O1", 3)]
    assert client.go("continue")["hitBreakpointIds"] == [placed[2]["id"]]
    assert client.values("locals of level 1")["#30"] == "2"
    assert client.go("continue") == {"exitCode": 0}


def test_counts_and_log_points(client: Client, row: Path) -> None:
    client.launch(row)
    client.lines(
        row,
        {"line": 11, "hitCondition": "%2"},
        {"line": 12, "logMessage": "hole {#30+1} at {X}"},
        {"line": 13, "hitCondition": "x"},
    )
    client.ask("configurationDone")
    client.event("stopped")
    assert client.values("locals of level 1")["#30"] == "1"
    assert client.go("continue") == {"exitCode": 0}
    logs = [e["body"] for e in client.events if e["body"].get("category") == "console"]
    assert [each["output"] for each in logs] == [
        "hole 1 at 0\n", "hole 2 at 20\n", "hole 3 at 40\n",
    ]  # fmt: skip
    assert logs[0]["line"] == 12
    assert logs[0]["source"]["path"] == str(row)


def test_steps_go_forwards_and_back(client: Client, row: Path) -> None:
    client.begin(row)
    assert client.refused("setInstructionBreakpoints") == (
        "setInstructionBreakpoints is not supported"
    )
    places = []
    for command in ("next", "stepIn", "stepIn", "stepOut", "stepBack", "stepBack", "next", "next"):
        assert client.go(command)["reason"] in ("step", "entry")
        places.append(client.stack()[0][1])
    assert places == [3, 7, 8, 4, 3, 2, 3, 4]
    assert client.go("reverseContinue")["reason"] == "entry"
    client.lines(row, 12)
    client.ask("setFunctionBreakpoints", breakpoints=[{"name": "O3"}])
    for _ in range(4):
        stopped = client.go("continue")
    assert stopped["reason"] == "function breakpoint"
    assert client.go("reverseContinue")["reason"] == "breakpoint"
    assert client.values("locals of level 1")["#30"] == "2"


def test_a_frame_and_the_program_start_again(client: Client, row: Path) -> None:
    client.begin(row)
    client.lines(row, 19)
    client.go("continue")
    client.go("continue")
    frames = client.ask("stackTrace", threadId=1)["stackFrames"]
    assert [each["name"] for each in frames] == ["O3 pass 2 of 2", "O1"]
    client.ask("restartFrame", frameId=frames[0]["id"])
    client.event("stopped")
    assert client.stack()[0] == ("O3 pass 1 of 2", 19)
    assert client.refused("restartFrame", frameId=frames[0]["id"]).startswith("there is no frame")
    row.write_text(ROW.replace("L2", "L3"))
    client.ask("restart")
    assert client.event("stopped")["reason"] == "entry"
    client.go("continue")
    assert client.stack()[0] == ("O3 pass 1 of 3", 19)


def test_the_stack_comes_in_pages(client: Client, row: Path) -> None:
    client.begin(row)
    client.go("stepIn")
    client.go("stepIn")
    body = client.ask("stackTrace", threadId=1, startFrame=1, levels=1)
    assert [each["name"] for each in body["stackFrames"]] == ["O1"]
    assert body["totalFrames"] == 2
    assert client.refused("stackTrace", threadId=2) == (
        "there is no thread 2; the program is thread 1"
    )


def test_values_are_shown_set_and_asked(client: Client, row: Path) -> None:
    client.begin(row)
    client.go("next")
    client.go("stepIn")
    frames = client.ask("stackTrace", threadId=1)["stackFrames"]
    names = [each["name"] for each in client.ask("scopes", frameId=frames[0]["id"])["scopes"]]
    assert names == [
        "locals of level 1", "system: position", "position", "modes", "offsets in force",
        "tool, spindle and feed", "switches",
    ]  # fmt: skip
    (held, *_) = client.ask("scopes", frameId=frames[0]["id"])["scopes"]
    reference = held["variablesReference"]
    rows = client.ask("variables", variablesReference=reference, start=1, count=2)["variables"]
    assert [(each["name"], each["value"]) for each in rows] == [("#6 (K)", "4"), ("#9 (F)", "120")]
    set_ = client.ask("setVariable", variablesReference=reference, name="#6 (K)", value="2+3")
    assert set_["value"] == "5"
    assert client.ask("setExpression", expression="#100", value="#6*2")["value"] == "10"
    for context, text, result in (
        ("watch", "#6*2+#100", "20"), ("repl", "#101=7", "7"), ("repl", "#101", "7"),
        ("repl", "work=G55", "G55"), ("repl", "X=2.5*2", "5"), ("watch", "X (machine)", "5"),
        ("repl", "optional_stop=on", "on"), ("watch", "block_skip", "off"),
        ("hover", "#6", "#6 = 5\na local variable of the program that runs, at its level: #1 to #33"),
        ("watch", "work", "G55"), ("clipboard", "Z", "50"),
    ):  # fmt: skip
        body = client.ask("evaluate", expression=text, context=context, frameId=frames[0]["id"])
        assert body["result"] == result
    assert client.ask("evaluate", expression="explain G81", context="repl")["result"].startswith(
        "mill: "
    )
    assert client.refused("evaluate", expression="#99999", context="watch") == (
        "there is no #99999"
    )
    assert client.refused("evaluate", expression="#1 GTT 2", context="watch").startswith("evaluate")
    assert client.refused("evaluate", expression="?!", context="hover") == (
        "nothing is known of '?!'"
    )
    assert client.refused("setVariable", variablesReference=reference, name="#7", value="1") == (
        "there is no '#7' among these"
    )
    assert client.refused("variables", variablesReference=999).startswith("there is no variablesR")


def test_the_tool_and_the_switches_are_set_where_they_are_shown(client: Client, row: Path) -> None:
    client.begin(row)
    client.go("next")
    frame = client.ask("stackTrace", threadId=1)["stackFrames"][0]["id"]
    scopes = {s["name"]: s for s in client.ask("scopes", frameId=frame)["scopes"]}
    for scope, name, value, text in (
        ("position", "X", "7", "7"), ("position", "Z (machine)", "12", "12"),
        ("switches", "block_skip", "1 3", "1 3"), ("switches", "optional_stop", "on", "on"),
    ):  # fmt: skip
        reference = scopes[scope]["variablesReference"]
        rows = client.ask("variables", variablesReference=reference)["variables"]
        (shown,) = [each for each in rows if each["name"] == name]
        assert "presentationHint" not in shown
        body = client.ask("setVariable", variablesReference=reference, name=name, value=value)
        assert body["value"] == text
        assert client.values(scope)[name] == text
        asked = client.ask("evaluate", expression=shown["evaluateName"], context="variables")
        assert asked["result"] == text
    reference = scopes["position"]["variablesReference"]
    for name, value, why in (
        ("X", "vacant", "X always stands somewhere: give a value, mm"),
        ("X", "100000*100000", "position['X']"),
        ("Q", "1", "there is no 'Q' among these"),
    ):
        told = client.refused("setVariable", variablesReference=reference, name=name, value=value)
        assert told.startswith(why)
    reference = scopes["switches"]["variablesReference"]
    told = client.refused(
        "setVariable", variablesReference=reference, name="block_skip", value="99"
    )
    assert told == "block_skip: a block-skip switch must be 1 to 10, not 99"
    told = client.refused("setExpression", expression="optional_stop", value="perhaps")
    assert told == "optional_stop is on or off, not 'perhaps'"


def test_another_line_is_made_the_next_one(client: Client, row: Path) -> None:
    client.begin(row)
    client.lines(row, {"line": 10, "condition": "#30 EQ 1"})
    client.go("continue")
    source = {"path": str(row)}
    (target,) = client.ask("gotoTargets", source=source, line=12)["targets"]
    assert (target["label"], target["line"]) == ("O9100 N160 #30=#30+1", 12)
    stopped = client.go("goto", targetId=target["id"])
    assert stopped["reason"] == "goto"
    assert client.stack()[0][1] == 12
    assert client.values("locals of level 1")["#30"] == "1"
    (other,) = client.ask("gotoTargets", source=source, line=4)["targets"]
    assert client.refused("goto", threadId=1, targetId=other["id"]) == (
        "line 4 is a block of O1; the program that runs is O9100"
    )
    assert client.refused("gotoTargets", source=source, line=6) == "line 6 of row.nc has no block"
    for wrong in (0, -5, 10**6):
        assert client.refused("goto", threadId=1, targetId=wrong).startswith("there is no target")
    assert client.stack()[0][1] == 12


def test_a_search_tells_who_wrote(client: Client, row: Path) -> None:
    client.begin(row)
    client.lines(row, 14)
    client.go("continue")
    found = client.ask("evaluate", expression="search #30", context="repl")["result"]
    first = found.splitlines()[0]
    assert first.endswith("N160 #30=#30+1  ->  3")
    assert ":12  " in first


def test_completions_have_their_place(client: Client, row: Path) -> None:
    client.begin(row)
    client.go("next")
    client.go("stepIn")
    targets = client.ask("completions", text="1+#", column=4)["targets"]
    assert {"label": "#6", "detail": "4", "type": "variable", "start": 2, "length": 1} in targets
    targets = client.ask("completions", text="x\ndist", column=5, line=2)["targets"]
    assert targets == [
        {"label": "distance", "detail": "G90", "type": "property", "start": 0, "length": 4}
    ]


def test_data_breakpoints_are_of_variables_axes_and_modes(client: Client, row: Path) -> None:
    client.begin(row)
    client.go("next")
    client.go("stepIn")
    frames = client.ask("stackTrace", threadId=1)["stackFrames"]
    scopes = {s["name"]: s for s in client.ask("scopes", frameId=frames[0]["id"])["scopes"]}
    local = client.ask(
        "dataBreakpointInfo",
        name="#30",
        variablesReference=scopes["locals of level 1"]["variablesReference"],
    )
    axis = client.ask(
        "dataBreakpointInfo",
        name="Z",
        variablesReference=scopes["position"]["variablesReference"],
    )
    mode = client.ask("dataBreakpointInfo", name="cycle")
    assert client.ask("dataBreakpointInfo", name="#30 +")["dataId"] is None
    switch = client.ask("dataBreakpointInfo", name="block_skip")
    assert switch == {"dataId": None, "description": "block_skip is no value that is watched"}
    placed = client.ask(
        "setDataBreakpoints",
        breakpoints=[
            {"dataId": local["dataId"], "hitCondition": ">1"},
            {"dataId": axis["dataId"], "condition": "-5"},
            {"dataId": axis["dataId"]},
            {"dataId": mode["dataId"], "accessType": "write"},
        ],
    )["breakpoints"]
    assert [each["verified"] for each in placed] == [True, True, False, True]
    seen = []
    while (stopped := client.go("continue")).get("reason") == "data breakpoint":
        seen.append((client.stack()[0][1], stopped["hitBreakpointIds"]))
    of_local, of_axis, _, of_mode = (each["id"] for each in placed)
    assert seen[:3] == [
        (11, [of_axis, of_mode]), (13, [of_local]), (11, [of_axis]),
    ]  # fmt: skip
    assert any(ids == [of_local] for _, ids in seen)


def test_alarms_pause_by_filter_and_number(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "a.nc"
    path.write_text("O1\nN10 G0 X1.\nN20 M98 P9\n")
    client.launch(path)
    body = client.ask("setExceptionBreakpoints", filters=["alarm", "others"])
    assert [each["verified"] for each in body["breakpoints"]] == [True, False]
    client.ask("configurationDone")
    stopped = client.event("stopped")
    assert stopped["reason"] == "exception"
    assert stopped["description"] == "alarm PS0076 program-not-found at O1 N20"
    info = client.ask("exceptionInfo", threadId=1)
    assert (info["exceptionId"], info["details"]["typeName"]) == ("PS0076", "program-not-found")
    assert "N20 M98 P9" in info["details"]["stackTrace"]
    body = client.ask(
        "setExceptionBreakpoints",
        filters=[],
        filterOptions=[
            {"filterId": "alarm", "condition": "PS0077, arc-radius"},
            {"filterId": "alarm", "condition": "9999"},
        ],
    )
    assert [each["verified"] for each in body["breakpoints"]][1] is False
    assert client.go("stepBack")["reason"] == "entry"
    assert client.refused("exceptionInfo", threadId=1).startswith("the program does not stand")
    assert client.go("continue") == {"exitCode": 1}


def test_a_program_that_stops_otherwise_says_why(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "w.nc"
    path.write_text("O1\nN10 IF[#500 EQ #0]GOTO 10\nN20 M30\n")
    client.launch(path)
    client.ask("configurationDone")
    stopped = client.event("stopped")
    assert (stopped["reason"], stopped["description"][:5]) == ("waiting", "waits")
    client.go("stepBack")
    client.ask("evaluate", expression="#500=1", context="repl")
    assert client.go("continue") == {"exitCode": 0}


def test_the_end_may_be_looked_at(client: Client, row: Path) -> None:
    client.launch(row, stopOnEnd=True)
    client.ask("configurationDone")
    assert client.event("stopped")["reason"] == "end"
    assert client.stack() == [("O1", 5)]
    client.go("stepBack")
    client.go("stepBack")
    assert client.stack() == [("O1", 4)]
    assert client.go("continue")["reason"] == "end"
    assert client.go("next") == {"exitCode": 0}


def test_an_endless_program_is_paused_and_told_of(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "e.nc"
    path.write_text(ENDLESS)
    client.launch(path, maxBlocks=2**31 - 1)
    client.ask("configurationDone")
    started = client.event("progressStart")
    assert started["cancellable"]
    assert client.refused("stackTrace", threadId=1).startswith("notStopped")
    placed = client.lines(path, {"line": 3, "condition": "#1 LT 0"})
    assert placed[0]["verified"]
    client.ask("threads")
    client.ask("pause", threadId=1)
    assert client.event("stopped")["reason"] == "pause"
    client.ask("continue", threadId=1)
    client.event("progressStart")
    client.lines(path, 4)
    assert client.event("stopped")["reason"] == "breakpoint"
    client.lines(path)
    client.ask("continue", threadId=1)
    progress = client.event("progressStart")["progressId"]
    client.ask("cancel", progressId=progress)
    assert client.event("stopped")["reason"] == "pause"
    client.ask("continue", threadId=1)
    client.ask("restart")
    client.ask("pause", threadId=1)
    assert client.event("stopped")["reason"] == "pause"
    client.ask("continue", threadId=1)
    client.ask("terminate")
    client.event("terminated")
    client.ask("disconnect")
    assert client.over()


def test_a_client_that_disconnects_or_vanishes_ends_an_endless_run(tmp_path: Path) -> None:
    path = tmp_path / "e.nc"
    path.write_text(ENDLESS)
    for leave in (True, False):
        with in_process() as client:
            client.launch(path, maxBlocks=2**31 - 1)
            client.ask("configurationDone")
            client.event("progressStart")
            if leave:
                client.ask("disconnect")
                assert client.over()


def test_sources_are_the_files_of_the_library_and_no_others(client: Client, row: Path) -> None:
    client.begin(row)
    (source,) = client.ask("loadedSources")["sources"]
    assert source == {"name": "row.nc", "path": str(row)}
    assert client.ask("source", source=source, sourceReference=0)["content"] == ROW
    assert "no such source" in client.refused(
        "source", source={"path": "/etc/passwd"}, sourceReference=0
    )
    body = client.ask("breakpointLocations", source=source, line=5, endLine=8)
    assert [each["line"] for each in body["breakpoints"]] == [5, 7, 8]


def test_lines_and_columns_may_begin_at_0(client: Client, row: Path) -> None:
    client.ask("initialize", adapterID="x", linesStartAt1=False, columnsStartAt1=False)
    client.ask("launch", program=str(row), control="fanuc-0i-f")
    assert client.lines(row, 6)[0]["line"] == 6
    client.ask("configurationDone")
    client.event("stopped")
    frame = client.ask("stackTrace", threadId=1)["stackFrames"][0]
    assert (frame["line"], frame["column"]) == (6, 0)
    assert client.ask("completions", text="1+#", column=3)["targets"][0]["start"] == 2


def test_a_launch_says_what_is_wrong_and_may_be_repeated(client: Client, row: Path) -> None:
    client.ask("initialize", adapterID="x")
    for wrong, words in (
        ({"program": "nowhere.nc", "control": "fanuc-0i-f"}, "nowhere.nc"),
        ({"program": str(row)}, "which control?"),
        ({"program": str(row), "control": "fanuc"}, "fanuc"),
        ({"program": 5}, "program must be a text, not 5"),
        ({"program": str(row), "control": "fanuc-0i-f", "variables": {"1": "x"}}, "variables"),
        ({"program": str(row), "control": "fanuc-0i-f", "main": "O7"}, "O7"),
        ({"control": "fanuc-0i-f"}, "which program?"),
    ):  # fmt: skip
        assert words in client.refused("launch", **wrong)
    client.ask(
        "launch",
        programs=[str(row)],
        control="fanuc-0i-f",
        variables={"500": 7, "501": None},
        stopOnEntri=True,
        __sessionId="x",
    )
    told = client.event("output")
    assert (told["category"], told["output"]) == (
        "important",
        "'stopOnEntri' means nothing in a launch configuration;"
        " did you mean stopOnEntry, stopOnEnd?\n",
    )
    client.lines(row, 2)
    client.ask("configurationDone")
    client.event("stopped")
    assert client.values("commons") == {"#500": "7"}
    assert client.refused("launch", program=str(row)).startswith("a program is launched already")


def test_without_debugging_nothing_pauses(client: Client, row: Path) -> None:
    client.launch(row, noDebug=True)
    assert client.lines(row, 3) == [{"verified": False, "message": "noDebug"}]
    client.ask("configurationDone")
    assert client.event("stopped", "exited") == {"exitCode": 0}


@pytest.mark.parametrize(
    "command",
    ["continue", "stackTrace", "setBreakpoints", "evaluate", "restart", "terminate", "pause"],
)
def test_what_comes_too_early_is_refused(client: Client, command: str) -> None:
    assert client.refused(command) == "initialize comes first"
    client.ask("initialize", adapterID="x")
    assert client.refused(command) == "no program is launched: launch comes first"
    assert client.refused("attach").startswith("attach: nothing runs")
    assert client.refused("initialize", adapterID="x") == "initialize comes once"


# ---- clients that lie ----


@pytest.mark.parametrize(
    "message",
    [
        b"{", b"[]", b"null", b"\xff\xfe", b'"x"', b"{}", b'{"seq": "1"}', b'{"seq": true}',
        b'{"seq": 1, "type": "event", "event": "x"}', b'{"seq": 1, "type": "request"}',
        b'{"seq": 1, "type": "request", "command": 5}', b"[" * 100_000, b"",
        b'{"seq": 1, "type": "request", "command": "threads", "arguments": 5}',
    ],
)  # fmt: skip
def test_what_is_no_request_gets_an_error_and_the_next_one_its_answer(
    client: Client, message: bytes
) -> None:
    client.raw(b"content-length:%d\nX: y\r\n\r\n%s" % (len(message), message))
    client.answer(1 if b'"seq": 1' in message else 0)
    client.raw(framed({"seq": 7, "type": "response", "request_seq": 1, "success": True}))
    client.ask("initialize", adapterID="x")
    client.ask("threads")


@pytest.mark.parametrize(
    "header",
    [
        b"Content-Length: -5\r\n\r\n", b"Content-Length: 99999999999\r\n\r\n", b"\r\n\r\n",
        b"Content-Length: x\r\n\r\n", b"x" * 10_000, b"A: b\r\n" * 50, b"GET / HTTP/1.1\r\n\r\n",
        b"Content-Length: 16777217\r\n\r\n",
    ],
)  # fmt: skip
def test_a_header_without_a_length_ends_the_connection(client: Client, header: bytes) -> None:
    client.raw(header)
    assert client.event("output")["output"].startswith("the connection ends: ")
    assert client.over()


def test_a_message_that_breaks_off_ends_the_connection() -> None:
    with in_process() as client:
        client.raw(b"Content-Length: 100\r\n\r\n{")


def test_a_flood_is_answered(client: Client, row: Path) -> None:
    client.begin(row)
    seqs = [client.send("evaluate", expression=f"{i}+1") for i in range(3000)]
    assert all(client.answer(seq)["success"] for seq in seqs)


WRONG: list[Any] = [None, True, -1, 0, 1, 2**40, 1.5, "", "x", "#1", [], [1], {}, {"line": "x"}]


@pytest.mark.parametrize("wrong", WRONG, ids=repr)
def test_arguments_of_wrong_types_are_refused_or_obeyed(
    client: Client, row: Path, wrong: Any
) -> None:
    from cncsub.dap.handlers import HANDLERS

    names = (
        "threadId", "frameId", "variablesReference", "source", "breakpoints", "filters", "name",
        "expression", "value", "text", "column", "line", "levels", "startFrame", "start", "count",
        "filterOptions", "dataId", "context", "lines", "sourceReference", "progressId", "requestId",
    )  # fmt: skip
    client.begin(row, stopOnEnd=True)
    for command in HANDLERS:
        if command in ("disconnect", "terminate"):
            continue
        client.answer(client.send(command, **dict.fromkeys(names, wrong)))
        for name in names:
            right = {"threadId": 1, "name": "#1", "expression": "#1", "text": "#", "value": "1"}
            client.answer(client.send(command, **{**right, name: wrong}))
    client.ask("threads")
