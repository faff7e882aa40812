"""The debug adapter as a process, and clients of the protocol that were not written here."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from dap_client import WAIT, Client, hold_to_schema
from debugged import ENDLESS, ROW

PAGE = Path(__file__).parent.parent / "docs" / "guides" / "dap.md"
COMMAND = [sys.executable, "-m", "cncsub", "dap"]


@pytest.fixture
def row(tmp_path: Path) -> Path:
    path = tmp_path / "row.nc"
    path.write_text(ROW)
    return path


@contextlib.contextmanager
def over_stdio() -> Iterator[tuple[Client, subprocess.Popen[bytes]]]:
    """A client of the command, which ends with it, in peace and without a word of its own."""
    pipe = subprocess.PIPE
    process = subprocess.Popen(COMMAND, stdin=pipe, stdout=pipe, stderr=pipe)
    assert process.stdin is not None
    assert process.stdout is not None
    assert process.stderr is not None
    try:
        yield Client(process.stdout, process.stdin), process
        with contextlib.suppress(OSError):
            process.stdin.close()
        assert process.wait(timeout=WAIT) == 0
        assert process.stderr.read() == b""
    finally:
        process.kill()
        process.wait()
        for stream in (process.stdout, process.stderr):
            stream.close()


@contextlib.contextmanager
def listening() -> Iterator[tuple[str, int]]:
    """The command on a free port, which it tells."""
    process = subprocess.Popen([*COMMAND, "--port", "0"], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    try:
        told = process.stdout.readline().strip()
        where, _, port = told.removeprefix("cncsub dap: listening on ").rpartition(":")
        assert where == "127.0.0.1"
        yield where, int(port)
    finally:
        process.send_signal(signal.SIGINT)
        try:
            assert process.wait(timeout=WAIT) == 130
        finally:
            process.kill()
            process.stdout.close()


def test_the_standard_streams_carry_the_protocol_alone(row: Path) -> None:
    with over_stdio() as (client, process):
        client.launch(row)
        client.lines(row, 11)
        client.ask("configurationDone")
        assert client.event("stopped")["reason"] == "breakpoint"
        assert client.stack()[0] == ("O9100 (#4=20, #6=4, #9=120)", 11)
        client.ask("disconnect")
        assert client.over()
        assert process.wait(timeout=WAIT) == 0  # the client still holds its end open


def test_the_process_ends_with_a_client_that_vanishes(tmp_path: Path) -> None:
    path = tmp_path / "e.nc"
    path.write_text(ENDLESS)
    with over_stdio() as (client, _):
        client.launch(path, maxBlocks=2**31 - 1)
        client.ask("configurationDone")
        client.event("progressStart")


def test_a_port_serves_several_clients_one_of_which_lies(row: Path) -> None:
    with listening() as (host, port):
        with socket.create_connection((host, port)) as liar:
            liar.sendall(b"Content-Length: x\r\n\r\n")
            liar.settimeout(WAIT)
            while liar.recv(4096):
                pass
        for _ in range(2):
            with socket.create_connection((host, port)) as one:
                client = Client(one.makefile("rb"), one.makefile("wb"))
                client.begin(row)
                client.ask("disconnect")
                assert client.over()


@pytest.mark.parametrize(
    "first", [b"POST / HTTP/1.1\r\n", b"P", b"OPTIONS * HTTP/1.1\r\n", b"\r\n"]
)
def test_a_page_in_a_browser_gets_no_word(first: bytes) -> None:
    message = b'{"seq":1,"type":"request","command":"initialize","arguments":{"adapterID":"x"}}'
    body = b"Content-Length: %d\r\n\r\n%s" % (len(message), message)
    with listening() as (host, port):
        assert host == "127.0.0.1"
        with socket.create_connection((host, port)) as page:
            page.settimeout(WAIT)
            page.sendall(first)
            with contextlib.suppress(OSError):
                page.sendall(body)
            with contextlib.suppress(ConnectionError):
                assert page.recv(4096) == b""


def test_a_port_that_is_taken_is_told() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        done = subprocess.run([*COMMAND, "--port", port], capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr.startswith(f"cncsub: --port {port} on 127.0.0.1: ")


# ---- dap-python ----


class Peer:
    """The client of dap-python over a socket; its models read each answer."""

    def __init__(self, address: tuple[str, int]) -> None:
        dap = pytest.importorskip(
            "dap", reason="dap-python is not installed: pip install dap-python"
        )
        self._socket = socket.create_connection(address)
        self._socket.settimeout(WAIT)
        self.client = dap.Client("cncsub")
        self.answers: dict[int, Any] = {}
        self.events: list[Any] = []
        self._read = self.client.handler.handle_response
        self.client.handler.handle_response = self._take

    def _take(self, response: Any) -> Any:
        """Note an answer. Some models of this client read the body as a whole answer; those are
        left out: what the protocol says of it holds.
        """
        hold_to_schema({k: v for k, v in response.model_dump().items() if v is not None})
        try:
            body = self._read(response)
        except ValueError:
            # It wants an exceptionID, and texts as ids of targets, which are numbers.
            misread = ("setExceptionBreakpoints", "exceptionInfo", "gotoTargets")
            assert not response.body or response.command in misread
            body = response
        self.answers[response.request_seq] = (response.success, body)
        return body

    def _receive(self) -> None:
        data = self._socket.recv(65536)
        assert data, "the adapter closed the connection"
        for message in self.client.receive(data):
            if type(message).__name__.endswith("Event"):
                self.events.append(message)

    def answer(self, seq: int) -> tuple[bool, Any]:
        self._socket.sendall(self.client.send())
        while seq not in self.answers:
            self._receive()
        success, body = self.answers.pop(seq)
        return success, body

    def ask(self, request: str, *args: Any, **more: Any) -> Any:
        success, body = self.answer(getattr(self.client, request)(*args, **more))
        assert success, (request, body)
        return body

    def refused(self, request: str, *args: Any, **more: Any) -> str:
        success, body = self.answer(getattr(self.client, request)(*args, **more))
        assert not success, (request, body)
        return str(body.message)

    def event(self, name: str) -> Any:
        while not any(type(each).__name__ == f"{name}Event" for each in self.events):
            self._receive()
        place = next(i for i, e in enumerate(self.events) if type(e).__name__ == f"{name}Event")
        found = self.events[place]
        del self.events[: place + 1]
        return found

    def go(self, request: str, *args: Any) -> Any:
        self.ask(request, *args)
        return self.event("Stopped")

    def close(self) -> None:
        self._socket.close()


@pytest.fixture
def peer() -> Iterator[Peer]:
    with listening() as address:
        peer = Peer(address)
        yield peer
        peer.close()


def test_dap_python_makes_every_request_that_it_has(peer: Peer, row: Path) -> None:
    source = {"path": str(row)}
    success, capabilities = peer.answer(1)
    assert success
    assert capabilities.supportsStepBack
    assert peer.refused("attach").startswith("attach: ")
    success, _ = peer.answer(
        peer.client.send_request(
            "launch", {"program": str(row), "control": "fanuc-0i-f", "stopOnEntry": True}
        )
    )
    assert success
    peer.event("Initialized")
    assert [each.name for each in peer.ask("threads").threads] == ["O1"]
    placed = peer.ask("set_breakpoints", source, [{"line": 6}, {"line": 11}]).breakpoints
    assert [(each.verified, each.line) for each in placed] == [(True, 7), (True, 11)]
    peer.ask("set_function_breakpoints", [{"name": "O3"}])
    peer.ask("set_exception_breakpoints", ["alarm"], None, None)
    assert peer.ask("breakpoint_locations", source, 5, None, 8).breakpoints[-1].line == 8
    peer.ask("configuration_done")
    assert peer.event("Stopped").reason == "entry"
    assert peer.go("next", 1).reason == "step"
    assert peer.go("step_in", 1).reason == "breakpoint"
    frames = peer.ask("stack_trace", 1, 0, 1)
    assert (frames.stackFrames[0].name, frames.totalFrames) == ("O9100 (#4=20, #6=4, #9=120)", 2)
    frame = frames.stackFrames[0].id
    scope = peer.ask("scopes", frame).scopes[0].variablesReference
    assert peer.ask("variables", scope, None, 0, 1).variables[0].name == "#4 (I)"
    assert peer.ask("set_variable", scope, "#6 (K)", "3+1").value == "4"
    assert peer.ask("set_expression", "#100", "7", frame).value == "7"
    assert peer.ask("evaluate", "#100*2", frame, context="watch").result == "14"
    assert peer.ask("completions", "#10", 4, None, frame).targets[0].label == "#100"
    data = peer.ask("data_breakpoint_info", "#30", scope)
    assert peer.ask("set_data_breakpoints", [{"dataId": data.dataId}]).breakpoints[0].verified
    assert peer.go("continue_", 1).reason == "data breakpoint"
    assert peer.go("continue_", 1).reason == "breakpoint"
    assert peer.go("step_back", 1).reason == "step"
    assert peer.go("reverse_continue", 1).reason == "breakpoint"
    assert peer.go("step_out", 1).reason == "data breakpoint"
    frame = peer.ask("stack_trace", 1).stackFrames[0].id
    assert peer.go("restart_frame", frame).reason == "step"
    (target,) = peer.ask("goto_targets", source, 8).body["targets"]
    assert (target["label"], target["line"]) == ("O9100 N120 #31=#5001", 8)
    assert peer.go("goto", 1, target["id"]).reason == "goto"
    assert peer.ask("loaded_sources").sources[0].path == str(row)
    assert peer.ask("source", 1).content == ROW
    assert peer.refused("exception_info", 1).startswith("the program does not stand")
    peer.ask("pause", 1)
    peer.ask("cancel", 10**6)
    for name, args in (
        ("step_in_targets", (frame,)),
        ("modules", ()), ("disassemble", ("x", 1)), ("read_memory", ("x", 1)),
        ("write_memory", ("x", "")), ("terminate_threads", ([1],)),
        ("set_instruction_breakpoints", ([],)),
    ):  # fmt: skip
        assert peer.refused(name, *args).endswith("is not supported")
    assert peer.go("restart").reason == "entry"
    peer.ask("terminate")
    peer.event("Terminated")
    peer.ask("disconnect")


def test_dap_python_sees_an_alarm(peer: Peer, tmp_path: Path) -> None:
    path = tmp_path / "a.nc"
    path.write_text("O1\nN10 M98 P9\n")
    peer.client.send_request("launch", {"program": str(path), "control": "fanuc-0i-f"})
    peer.ask("configuration_done")
    assert peer.event("Stopped").reason == "exception"
    assert peer.ask("exception_info", 1).body["exceptionId"] == "PS0076"


# ---- Emacs ----

EMACS = """;;; -*- lexical-binding: t -*-
(require 'package)
(package-initialize)
SETTINGS
(setq lsp-verify-signature nil dap-auto-configure-features nil)
(defvar seen '())
(defun note (words) (push words seen) (princ (concat words "\\n") 'external-debugging-output))
(defun frame-text (session)
  (let ((frame (dap--debug-session-active-frame session)))
    (if frame (format "%s:%s" (gethash "name" frame) (gethash "line" frame)) "nowhere")))
(defun ask (session command arguments then)
  (dap--send-message (dap--make-request command arguments) then session))
(setq dap-stopped-hook nil dap-stack-frame-changed-hook nil dap-terminated-hook nil)
(defvar steps 0)
(add-hook 'dap-stack-frame-changed-hook
  (lambda (session)
    (when (dap--debug-session-active-frame session)
      (note (format "at %s" (frame-text session)))
      (setq steps (1+ steps))
      (pcase steps
        (1 (ask session "evaluate"
             (list :expression "#6*2" :context "watch"
                   :frameId (gethash "id" (dap--debug-session-active-frame session)))
             (lambda (answer)
               (note (format "#6*2 is %s" (gethash "result" (gethash "body" answer))))
               (dap-next session))))
        (2 (dap--send-message (dap--make-request "stepBack" (list :threadId 1))
                              (lambda (_) (note "went back")) session))
        (3 (dap-continue session 1))
        (4 (dap-disconnect session))))))
(add-hook 'dap-terminated-hook (lambda (_) (note "over")))
(with-current-buffer (find-file-noselect "FILE")
  (goto-char (point-min)) (forward-line 6) (dap-breakpoint-add)
  (goto-char (point-min)) (forward-line 13) (dap-breakpoint-add)
  (dap-debug (list :type "cncsub" :request "launch" :name "row" :program "FILE"
                   :control "fanuc-0i-f")))
(let ((until (+ (float-time) 40)))
  (while (and (< (float-time) until) (not (member "over" seen)) (< steps 5))
    (accept-process-output nil 0.1)))
"""


def has_dap_mode() -> bool:
    return shutil.which("emacs") is not None and any(
        Path("/usr/share/emacs/site-lisp/elpa").glob("dap-mode-*")
    )


@pytest.mark.skipif(
    not has_dap_mode(), reason="there is no Emacs with dap-mode: apt-get install elpa-dap-mode"
)
def test_dap_mode_of_emacs_steps_forwards_and_back(row: Path, tmp_path: Path) -> None:
    script = tmp_path / "debug.el"
    command = f'("{sys.executable}" "-m" "cncsub" "dap")'
    settings = re.search(r"^```lisp\n(.*?)^```", PAGE.read_text("utf-8"), re.M | re.S)
    assert settings is not None
    assert '("cncsub" "dap")' in settings[1]
    told_to = settings[1].replace('("cncsub" "dap")', command)
    script.write_text(EMACS.replace("SETTINGS", told_to).replace("FILE", str(row)))
    home = tmp_path / "home"
    home.mkdir()
    done = subprocess.run(
        ["emacs", "--batch", "-l", str(script)],
        capture_output=True,
        text=True,
        timeout=90,
        cwd=tmp_path,
        env={**os.environ, "HOME": str(home)},
    )
    begins = ("at ", "#", "went", "over")
    told = [line for line in done.stderr.splitlines() if line.startswith(begins)]
    frame = "at O9100 (#4=20, #6=4, #9=120)"
    assert told == [
        f"{frame}:7", "#6*2 is 8", f"{frame}:8", "went back", f"{frame}:7", f"{frame}:14", "over",
    ], done.stderr[-3000:]  # fmt: skip
