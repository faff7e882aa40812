"""The debug adapter: reads requests, answers each, and runs the session on a thread of its own."""

from __future__ import annotations

import queue
import threading
import traceback
from collections.abc import Callable, Mapping
from typing import IO, Any, NamedTuple

from cncsub.dap.arguments import Arguments, RequestError
from cncsub.dap.launching import Launch
from cncsub.dap.messages import LostError, NoMessageError, Writer, read_message
from cncsub.debugging import Pause, Session

TICK = 0.25  # seconds between two looks at a movement
_MOST_WAITING = 1000  # requests; a client that sends more waits until some are answered
MakeSession = Callable[[Mapping[str, Any], Callable[[str], None]], Session]


class Handler(NamedTuple):
    """The function that answers a request. `launched`: it needs a session. `runs`: it is answered
    while the program runs, too. `ends`: a movement ends for it. `at_once`: it overtakes others.
    """

    answer: Callable[[Adapter, Arguments], dict[str, Any] | None]
    launched: bool = True
    runs: bool = False
    ends: bool = False
    at_once: bool = False


class _Request(NamedTuple):
    seq: int
    command: str
    arguments: Arguments
    handler: Handler
    done: threading.Event


class Adapter:
    """One client and its session."""

    def __init__(
        self,
        reads: IO[bytes],
        writes: IO[bytes],
        make_session: MakeSession,
        handlers: Mapping[str, Handler],
        tell_pause: Callable[[Adapter, Pause], None],
    ) -> None:
        self.tell_pause = tell_pause
        self.make_session = make_session
        self.session: Session | None = None
        self.launch: Launch | None = None
        self.client: Mapping[str, Any] = {}  # the arguments of its `initialize`
        self.initialized = False
        self.started = False  # the client has set its breakpoints
        self.moving = False
        self.leaving = False
        self.variables: list[Any] = []  # what the references of this pause lead to
        self.frames: dict[int, int] = {}  # the indices of frames by their ids
        self.paths: dict[str, str] = {}  # of files, by which the client named them
        self._reads, self._writer = reads, Writer(writes)
        self._handlers = handlers
        self._waiting: queue.Queue[_Request | None] = queue.Queue(_MOST_WAITING)
        self._later: list[Callable[[], None]] = []  # done after the answer
        self._postponed: list[_Request] = []  # until the movement has ended
        self._cancelling = threading.Lock()  # of the three below
        self._begun: int | None = None  # the request that is carried out
        self._open: set[int] = set()  # requests that wait for an answer
        self._cancelled: set[int] = set()  # those of them that are to be refused
        self._progress = ""
        self._ids = 0
        self._closed = threading.Event()

    # ---- what is written ----

    def event(self, name: str, body: Mapping[str, Any] | None = None) -> None:
        self._writer.write({"type": "event", "event": name, "body": dict(body or {})})

    def tell(self, text: str, category: str = "console") -> None:
        """Show a line in the console of the client."""
        self.event("output", {"category": category, "output": f"{text}\n"})

    def _answer(self, request: _Request, body: Mapping[str, Any] | None) -> None:
        self._write_answer(
            request.seq, request.command, {"success": True, "body": dict(body or {})}
        )

    def _refuse(self, seq: int, command: str, words: str) -> None:
        error = {"id": 1, "format": words.replace("{", "{{").replace("}", "}}"), "showUser": False}
        self._write_answer(
            seq, command, {"success": False, "message": words, "body": {"error": error}}
        )

    def _write_answer(self, seq: int, command: str, rest: Mapping[str, Any]) -> None:
        self._writer.write({"type": "response", "request_seq": seq, "command": command, **rest})

    # ---- reading ----

    def serve(self) -> None:
        """Answer requests until the client leaves."""
        worker = threading.Thread(target=self._work, daemon=True)
        ticker = threading.Thread(target=self._tick, daemon=True)
        worker.start()
        ticker.start()
        try:
            while not self.leaving and not self._writer.broken and self._read_one():
                pass
        finally:
            self.leaving = True
            self._closed.set()
            if self.session is not None:
                self.session.pause()
            self._waiting.put(None)
            worker.join(timeout=10)
            ticker.join(timeout=10)

    def _read_one(self) -> bool:
        """Read and answer a request. Return whether another can be read."""
        try:
            message = read_message(self._reads)
        except NoMessageError as error:
            self._refuse(0, "", str(error))
            return True
        except (LostError, OSError, ValueError) as error:
            self.tell(f"the connection ends: {error}", "stderr")
            return False
        if message is None:
            return False
        seq, command = message.get("seq"), message.get("command")
        if not isinstance(seq, int) or isinstance(seq, bool):
            self._refuse(0, "", "seq must be a whole number")
        elif message.get("type") == "response":
            pass  # no request goes to the client
        elif message.get("type") != "request" or not isinstance(command, str):
            self._refuse(seq, "", "the message must be a request with a command")
        else:
            self._receive(seq, command, message.get("arguments"))
        return True

    def _receive(self, seq: int, command: str, given: Any) -> None:
        handler = self._handlers.get(command)
        try:
            if handler is None:
                raise RequestError(f"{command[:60]} is not supported")
            request = _Request(seq, command, Arguments(given), handler, threading.Event())
            if handler.at_once:
                self._answer_at_once(request)
                return
            with self._cancelling:
                self._open.add(seq)
            self._waiting.put(request)
            if self.moving and self.session is not None:
                self.session.tick()
            if command == "disconnect":
                request.done.wait(timeout=10)  # the last one, unless it is refused
        except RequestError as error:
            self._refuse(seq, command[:60], str(error))

    # ---- carrying out ----

    def _work(self) -> None:
        while (request := self._waiting.get()) is not None:
            self._carry_out(request)

    def between(self, blocks: int) -> None:
        """Answer what came while the program runs; the session calls it at a tick."""
        while True:
            try:
                request = self._waiting.get_nowait()
            except queue.Empty:
                break
            if request is None:
                self._waiting.put(None)
                break
            self._carry_out(request)
        self._tell_progress(blocks)

    def _carry_out(self, request: _Request) -> None:
        """Answer one request, whatever becomes of it."""
        if self.moving and request.handler.ends:
            self._postponed.append(request)
            self.pause()
            return
        try:
            body = self._body_for(request)
        except RequestError as error:
            self._refuse(request.seq, request.command, str(error))
        except (LookupError, ValueError, TypeError, NotImplementedError, OSError) as error:
            words = error.args[0] if len(error.args) == 1 else error
            self._refuse(request.seq, request.command, str(words))
        except Exception:  # a mistake made here: the client gets its answer all the same
            traceback.print_exc()
            self._refuse(request.seq, request.command, "a mistake of cncsub: see its error stream")
        else:
            self._answer(request, body)
            later, self._later = self._later, []
            for act in later:
                act()
        self._later.clear()
        request.done.set()

    def _answer_at_once(self, request: _Request) -> None:
        """Answer one request in the thread that reads, while the other one may carry out another:
        what that one does after its answer is no business of this.
        """
        try:
            self._check(request)
            body = request.handler.answer(self, request.arguments)
        except RequestError as error:
            self._refuse(request.seq, request.command, str(error))
        else:
            self._answer(request, body)

    def _body_for(self, request: _Request) -> dict[str, Any] | None:
        with self._cancelling:
            self._open.discard(request.seq)
            if request.seq in self._cancelled:
                self._cancelled.discard(request.seq)
                raise RequestError("cancelled")
            self._begun = request.seq
        try:
            self._check(request)
            return request.handler.answer(self, request.arguments)
        finally:
            self._begun = None

    def _check(self, request: _Request) -> None:
        if not self.initialized and request.command not in ("initialize", "disconnect"):
            raise RequestError("initialize comes first")
        if request.handler.launched:
            self.running()
        if self.moving and not request.handler.runs:
            raise RequestError("notStopped: the program runs; pause it first")

    def after_answer(self, act: Callable[[], None]) -> None:
        """Do something once the request that is carried out has its answer."""
        self._later.append(act)

    # ---- movements ----

    def move(self, movement: Callable[[Session], Pause]) -> None:
        """Have the session move once the request is answered, and tell where it stands then."""
        session = self.started_session()
        self.moving = True
        self.variables, self.frames = [], {}

        def go() -> None:
            try:
                pause = movement(session)
            except (LookupError, ValueError, TypeError, RuntimeError, MemoryError) as error:
                self.tell(str(error.args[0] if error.args else error), "stderr")
                pause = session.at
            self.moving = False
            self._end_progress()
            postponed, self._postponed = self._postponed, []
            for request in postponed:
                self._carry_out(request)
            if not postponed and not self.leaving:
                self.tell_pause(self, pause)

        self.after_answer(go)

    def running(self) -> Session:
        if self.session is None:
            raise RequestError("no program is launched: launch comes first")
        return self.session

    def started_session(self) -> Session:
        """Return the session once it may move."""
        if not self.started:
            raise RequestError("configurationDone comes first")
        return self.running()

    def pause(self) -> None:
        """Have a movement end soon."""
        if self.session is not None and self.moving:
            self.session.pause()

    def cancel(self, request: int | None, progress: str | None) -> None:
        with self._cancelling:
            if request in self._open:  # nobody has begun with it
                self._cancelled.add(request)
            elif request == self._begun and self.session is not None:
                self.session.stop_search()
        if progress is not None and progress == self._progress:
            self.pause()

    def frame_id(self, index: int) -> int:
        """Return the id of a frame, which holds until the session moves."""
        for known, its in self.frames.items():
            if its == index:
                return known
        self._ids += 1
        self.frames[self._ids] = index
        return self._ids

    # ---- progress ----

    def _tick(self) -> None:
        while not self._closed.wait(TICK):
            if self.moving and self.session is not None:
                self.session.tick()

    def _tell_progress(self, blocks: int) -> None:
        if not self.moving or not self.client.get("supportsProgressReporting"):
            return
        told = f"{blocks:,} blocks"
        if not self._progress:
            self._ids += 1
            self._progress = f"run-{self._ids}"
            body = {"title": "running", "cancellable": True, "message": told}
            self.event("progressStart", {"progressId": self._progress, **body})
        else:
            self.event("progressUpdate", {"progressId": self._progress, "message": told})

    def _end_progress(self) -> None:
        if self._progress:
            self.event("progressEnd", {"progressId": self._progress})
            self._progress = ""

    # ---- lines and columns ----

    def line_in(self, line: int) -> int:
        """Return a line of the client as it is counted here, from 1."""
        return line if self.client.get("linesStartAt1", True) else line + 1

    def line_out(self, line: int) -> int:
        return line if self.client.get("linesStartAt1", True) else line - 1

    def column_in(self, column: int) -> int:
        return column if self.client.get("columnsStartAt1", True) else column + 1

    def column_out(self, column: int) -> int:
        return column if self.client.get("columnsStartAt1", True) else column - 1
