"""Any order of requests ends in an answer to each, and the adapter ends with its client."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from dap_client import Client, in_process
from debugged import ENDLESS, ROW
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from cncsub.dap.handlers import HANDLERS

ids = st.sampled_from([0, 1, 2, 3, 7, -1])
texts = st.sampled_from(
    ["#1", "#30", "#1=5", "1/0", "", "work", "search #30", "X", "O3", "%2", ">1"]
)
lines = st.integers(0, 25)
points = st.lists(
    st.fixed_dictionaries(
        {"line": lines, "name": texts, "dataId": texts},
        optional={"condition": texts, "hitCondition": texts, "logMessage": st.just("{#1}")},
    ),
    max_size=3,
)
arguments = st.fixed_dictionaries(
    {"threadId": st.just(1), "breakpoints": points, "filters": st.just(["alarm"])},
    optional={
        "frameId": ids, "variablesReference": ids, "expression": texts, "name": texts,
        "value": texts, "text": texts, "column": ids, "line": lines, "endLine": lines,
        "context": st.sampled_from(["repl", "hover", "watch"]), "requestId": ids,
        "sourceReference": ids, "start": ids, "count": ids, "levels": ids, "startFrame": ids,
        "targetId": st.integers(-1, 25),
    },
)  # fmt: skip
MOVES = ["continue", "next", "stepIn", "stepOut", "stepBack", "reverseContinue"]
requests = st.tuples(
    st.one_of(
        st.sampled_from(sorted(set(HANDLERS) - {"disconnect"})),
        st.sampled_from(MOVES),
        st.sampled_from(["pause", "setBreakpoints", "launch", "configurationDone", "stackTrace"]),
    ),
    arguments,
)


def asked(client: Client, command: str, given: dict[str, Any], path: Path) -> int:
    more = {"source": {"path": str(path)}}
    if command == "launch":
        more = {"program": str(path), "control": "fanuc-0i-f", "maxBlocks": 10**9}
    return client.send(command, **{**given, **more})


@settings(deadline=None, max_examples=40, suppress_health_check=[HealthCheck.too_slow])
@given(
    text=st.sampled_from([ROW, ENDLESS, ROW.replace("P3", "P9")]),
    order=st.lists(requests, max_size=30),
    stands=st.booleans(),
)
def test_every_request_of_any_order_gets_its_answer(
    text: str, order: list[tuple[str, dict[str, Any]]], stands: bool
) -> None:
    with tempfile.TemporaryDirectory() as folder, in_process() as client:
        path = Path(folder) / "part.nc"
        path.write_text(text)
        begun = [("initialize", {"adapterID": "x"}), ("launch", {"stopOnEntry": True})]
        begun += [("configurationDone", {})]
        waiting = [
            asked(client, command, given, path)
            for command, given in [*(begun if stands else []), *order]
        ]
        waiting.append(client.send("disconnect"))
        for seq in waiting:
            client.answer(seq)
        assert client.over()
