"""A client of the Debug Adapter Protocol for tests: every message it gets is held to the protocol's
own schema, and every request to an answer.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import threading
from collections.abc import Iterator
from functools import cache
from importlib import resources
from pathlib import Path
from typing import IO, Any

import jsonschema

from cncsub import dap
from cncsub.cli.dap import make_session

WAIT = 20  # seconds until an answer counts as missing


@cache
def _schema() -> dict[str, Any]:
    folder = resources.files("debugpy") / "_vendored" / "pydevd" / "_pydevd_bundle"
    text = (folder / "_debug_adapter" / "debugProtocol.json").read_text("utf-8")
    schema: dict[str, Any] = json.loads(text)
    return schema


@cache
def _validator(name: str) -> Any:
    schema = _schema()
    kind = jsonschema.validators.validator_for(schema)
    return kind({"$ref": f"#/definitions/{name}", "definitions": schema["definitions"]})


def hold_to_schema(message: dict[str, Any]) -> None:
    """Raise where a message is not what the protocol says of it."""
    if message["type"] == "event":
        name = f"{message['event'][0].upper()}{message['event'][1:]}Event"
    elif message["success"]:
        command = message["command"]
        name = f"{command[0].upper()}{command[1:]}Response"
    else:
        name = "ErrorResponse"
    _validator(name).validate(message)


def framed(message: object) -> bytes:
    data = json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n%s" % (len(data), data)


class Client:
    """Sends requests over one stream and reads what comes on another."""

    def __init__(self, reads: IO[bytes], writes: IO[bytes]) -> None:
        self._reads, self._writes = reads, writes
        self._seq = 0
        self._messages: queue.Queue[dict[str, Any] | None] = queue.Queue()
        self._answers: dict[int, dict[str, Any]] = {}
        self.events: list[dict[str, Any]] = []
        self._taken = 0
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        with contextlib.suppress(OSError, ValueError):
            while line := self._reads.readline():
                length = int(line.removeprefix(b"Content-Length: "))
                assert self._reads.readline() == b"\r\n"
                self._messages.put(json.loads(self._reads.read(length)))
        self._messages.put(None)

    def raw(self, data: bytes) -> None:
        self._writes.write(data)
        self._writes.flush()

    def send(self, command: str, **arguments: Any) -> int:
        self._seq += 1
        message = {"seq": self._seq, "type": "request", "command": command}
        self.raw(framed({**message, "arguments": arguments}))
        return self._seq

    def _next(self) -> bool:
        """Take a message. Return whether there was one before the end of the stream."""
        message = self._messages.get(timeout=WAIT)
        if message is None:
            self._messages.put(None)
            return False
        hold_to_schema(message)
        if message["type"] == "event":
            self.events.append(message)
        else:
            self._answers[message["request_seq"]] = message
        return True

    def answer(self, seq: int) -> dict[str, Any]:
        while seq not in self._answers:
            assert self._next(), f"no answer to request {seq}"
        return self._answers.pop(seq)

    def ask(self, command: str, **arguments: Any) -> dict[str, Any]:
        """Return the body of the answer to a request that is carried out."""
        answer = self.answer(self.send(command, **arguments))
        assert answer["success"], answer
        body: dict[str, Any] = answer["body"]
        return body

    def refused(self, command: str, **arguments: Any) -> str:
        """Return the words with which a request is refused."""
        answer = self.answer(self.send(command, **arguments))
        assert not answer["success"], answer
        return str(answer["message"])

    def event(self, *names: str) -> dict[str, Any]:
        """Return the body of the next event of one of these names."""
        while True:
            while self._taken < len(self.events):
                event = self.events[self._taken]
                self._taken += 1
                if event["event"] in names:
                    body: dict[str, Any] = event["body"]
                    return body
            assert self._next(), f"the stream ended before {names}"

    def over(self) -> bool:
        """Return whether the other end closes the stream."""
        while self._next():
            pass
        return True

    # What most tests do.

    def launch(self, path: Path, **more: Any) -> None:
        """Go as far as the place where breakpoints are set."""
        self.ask("initialize", adapterID="cncsub", clientID="test", supportsProgressReporting=True)
        self.ask("launch", program=str(path), control="fanuc-0i-f", **more)
        self.event("initialized")

    def begin(self, path: Path, **more: Any) -> None:
        """Stand at the head of the program."""
        self.launch(path, stopOnEntry=True, **more)
        self.ask("configurationDone")
        assert self.event("stopped")["reason"] == "entry"

    def lines(self, path: Path, *rows: dict[str, Any] | int) -> list[dict[str, Any]]:
        """Set the breakpoints of a file."""
        breakpoints = [{"line": row} if isinstance(row, int) else row for row in rows]
        body = self.ask("setBreakpoints", source={"path": str(path)}, breakpoints=breakpoints)
        placed: list[dict[str, Any]] = body["breakpoints"]
        return placed

    def go(self, command: str, **arguments: Any) -> dict[str, Any]:
        """Carry out a movement, and return how it stopped."""
        self.ask(command, threadId=1, **arguments)
        return self.event("stopped", "exited")

    def stack(self) -> list[tuple[str, int]]:
        frames = self.ask("stackTrace", threadId=1)["stackFrames"]
        return [(frame["name"], frame["line"]) for frame in frames]

    def values(self, scope: str, frame: int = 0) -> dict[str, str]:
        frames = self.ask("stackTrace", threadId=1)["stackFrames"]
        scopes = self.ask("scopes", frameId=frames[frame]["id"])["scopes"]
        (found,) = [each for each in scopes if each["name"] == scope]
        rows = self.ask("variables", variablesReference=found["variablesReference"])["variables"]
        return {row["name"]: row["value"] for row in rows}


@contextlib.contextmanager
def in_process() -> Iterator[Client]:
    """A client of an adapter that runs on a thread of this process."""
    (there, here), (back, forth) = os.pipe(), os.pipe()
    files = os.fdopen(there, "rb"), os.fdopen(forth, "wb"), os.fdopen(back, "rb")
    reads, writes, comes = files
    goes = os.fdopen(here, "wb")

    def serve() -> None:
        with reads, writes:
            dap.serve(reads, writes, make_session)

    serving = threading.Thread(target=serve)
    serving.start()
    try:
        yield Client(comes, goes)
    finally:
        with contextlib.suppress(OSError):
            goes.close()
        serving.join(timeout=WAIT)
        comes.close()
    assert not serving.is_alive(), "the adapter does not end with its client"
