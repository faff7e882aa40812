"""Measure `cncsub lsp` while somebody types: `python tests/benchmarks/typing_in_editor.py`.

Starts the server, opens a program of 100,000 blocks and presses keys in the middle of it. After
each key an editor asks something at once, and the time from the key to the answer counts, as does
the time to the diagnostics of that text; in brackets stand the milliseconds of the processor that
the server's main thread took until the answer, where the system tells them: other work on the
machine does not count in them. Prints the table; `--write docs/performance.md` puts it there.
"""

from __future__ import annotations

import argparse
import itertools
import json
import math
import os
import queue
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mixed
import report
import texts

SERVER = [sys.executable, "-m", "cncsub", "lsp"]
MARK = "typing"
PATIENCE = 120.0  # seconds

Figures = dict[str, Any]


class Program:
    """A text, the control that it is for, and the line in which somebody types."""

    def __init__(self, title: str, control: str, text: str) -> None:
        self.title = title
        self.control = control
        self.text = text
        self.lines = text.split("\n")
        self.line = self._typed_in()

    def _typed_in(self) -> int:
        """Return the first line after the middle that moves an axis."""
        middle = len(self.lines) // 2
        return next(at for at in itertools.count(middle) if "X" in self.lines[at])


def loops(blocks: int) -> str:
    """Return small loops of a macro one after the other, all with variables and jumps."""
    each = (
        "N{0} #100=#100+1\nN{1} #[101+#100]=SIN[#100]*{0}\nN{2} G1 X#101 Y[#100/3.]\n"
        "N{3} IF[#100LT3]GOTO{0}\n"
    )
    rounds = range(1, blocks // 4 * 4, 4)
    return "O1\n" + "".join(each.format(n, n + 1, n + 2, n + 3) for n in rounds) + "M30\n"


def programs(blocks: int) -> list[Program]:
    """Return the programs that are typed in."""
    sinumerik = "".join(f"N{n} G1 X{n % 300 / 10} Y=R{n % 9}\n" for n in range(1, blocks))
    linuxcnc = "".join(f"N{n} G1 X{n % 300 / 10} Y[#{n % 9 + 1}]\n" for n in range(1, blocks))
    return [
        Program("a milling program", "fanuc-0i-f", mixed.milling(blocks)),
        Program("flat G1", "fanuc-0i-f", texts.flat(blocks)),
        Program("a turning program", "gsk-988ta", mixed.turning(blocks)),
        Program("loops of a macro", "fanuc-0i-f", loops(blocks)),
        Program("SINUMERIK", "siemens-840d-sl", f"{sinumerik}M30\n"),
        Program("LinuxCNC", "linuxcnc", f"{linuxcnc}M2\n"),
    ]


class Editor:
    """A client of the protocol that notes when each message came."""

    def __init__(self, folder: Path) -> None:
        self.server = subprocess.Popen(
            SERVER, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=folder
        )
        self.uri = (folder / "part.nc").as_uri()
        self._numbers = itertools.count(1)
        self._came: queue.SimpleQueue[tuple[float, Figures]] = queue.SimpleQueue()
        self._answers: dict[int, float] = {}
        self._found: dict[int, float] = {}
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.server.stdout is not None
        while head := self.server.stdout.readline():
            length = 0
            while head.strip():
                name, _, value = head.partition(b":")
                length = int(value) if name.lower() == b"content-length" else length
                head = self.server.stdout.readline()
            data = self.server.stdout.read(length)
            came = time.perf_counter()
            self._came.put((came, json.loads(data)))

    def send(self, **message: Any) -> None:
        assert self.server.stdin is not None
        data = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.server.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(data), data))
        self.server.stdin.flush()

    def ask(self, method: str, **params: Any) -> int:
        """Send a request and return its number."""
        number = next(self._numbers)
        self.send(id=number, method=method, params=params)
        return number

    def answered(self, number: int) -> float:
        """Return when a request was answered."""
        self._wait(lambda: number in self._answers)
        return self._answers.pop(number)

    def diagnosed(self, version: int) -> float:
        """Return when the diagnostics of a version came."""
        self._wait(lambda: version in self._found)
        return self._found[version]

    def _wait(self, done: Callable[[], bool]) -> None:
        while not done():
            came, message = self._came.get(timeout=PATIENCE)
            if message.get("method") == "textDocument/publishDiagnostics":
                self._found[message["params"]["version"]] = came
            elif "id" in message and "method" not in message:
                if "error" in message:
                    raise SystemExit(message["error"]["message"])
                self._answers[message["id"]] = came

    def begin(self, control: str) -> None:
        """Begin a session."""
        options = {"control": control}
        self.answered(
            self.ask("initialize", capabilities={}, processId=None, initializationOptions=options)
        )
        self.send(method="initialized", params={})

    def open(self, text: str) -> float:
        """Show a text, and return when that was."""
        item = {"uri": self.uri, "languageId": "nc", "version": 1, "text": text}
        began = time.perf_counter()
        self.send(method="textDocument/didOpen", params={"textDocument": item})
        return began

    def press(self, version: int, text: str, line: int, column: int, width: int = 0) -> float:
        """Put a text in the place of some characters, and return when that was."""
        ends = {"line": line, "character": column}, {"line": line, "character": column + width}
        change = {"range": {"start": ends[0], "end": ends[1]}, "text": text}
        document = {"uri": self.uri, "version": version}
        began = time.perf_counter()
        self.send(
            method="textDocument/didChange",
            params={"textDocument": document, "contentChanges": [change]},
        )
        return began

    def memory(self, field: str) -> int:
        """Return the bytes that the server holds now (VmRSS) or has held at most (VmHWM)."""
        for row in Path(f"/proc/{self.server.pid}/status").read_text().splitlines():
            if row.startswith(f"{field}:"):
                return int(row.split()[1]) * 1024
        return 0

    def worked(self) -> float:
        """Return the seconds of the processor that the main thread of the server has taken."""
        told = Path(f"/proc/{self.server.pid}/schedstat")
        return int(told.read_text().split()[0]) / 1e9 if told.exists() else float("nan")

    def end(self) -> None:
        self.answered(self.ask("shutdown"))
        self.send(method="exit")
        self.server.wait(20)


# What an editor asks of a place, of the lines that it shows, and of a whole document.
OF_PLACE = ("hover", "completion", "signatureHelp", "documentHighlight", "definition")
OF_LINES = ("inlayHint", "semanticTokens/range", "codeAction")
OF_DOCUMENT = ("codeLens", "documentLink", "foldingRange", "documentSymbol")
ASKED = (*OF_PLACE, *OF_LINES, *OF_DOCUMENT)
AFTER_PAUSE = "completion, after a pause"  # while the program is run in the background


def asked(editor: Editor, what: str, line: int, column: int) -> int:
    """Ask something, and return the number of the request."""
    params: Figures = {"textDocument": {"uri": editor.uri}}
    if what in OF_PLACE:
        params["position"] = {"line": line, "character": column}
    elif what in OF_LINES:
        ends = {"line": line - 30, "character": 0}, {"line": line + 30, "character": 0}
        params |= {"range": {"start": ends[0], "end": ends[1]}, "context": {"diagnostics": []}}
    return editor.ask(f"textDocument/{what}", **params)


def measured(program: Program, keys: int) -> Figures:
    """Type in a program, and return the seconds of every answer by what was asked."""
    with tempfile.TemporaryDirectory() as name:
        editor = Editor(Path(name))
        editor.begin(program.control)
        idle = editor.memory("VmRSS")
        began = editor.open(program.text)
        found: Figures = {"open": editor.diagnosed(1) - began, "diagnostics": []}
        versions = itertools.count(2)
        for what in (*ASKED, AFTER_PAUSE):
            found[what] = []
            for key in range(keys if what != AFTER_PAUSE else min(keys, PAUSES)):
                if what == AFTER_PAUSE:
                    time.sleep(PAUSE)
                answered, diagnosed = typed(editor, program, what, next(versions), key)
                found[what].append(answered)
                found["diagnostics"].append((diagnosed, float("nan")))
        found["most"] = editor.memory("VmHWM") - idle
        time.sleep(RESTING)
        found["memory"] = editor.memory("VmRSS") - idle
        editor.end()
    return found


PAUSE, PAUSES = 1.2, 5  # seconds, and how many
RESTING = 3.0  # seconds after the last key


def typed(
    editor: Editor, program: Program, what: str, version: int, key: int
) -> tuple[tuple[float, float], float]:
    """Press a key, and return the seconds to the answer, of the clock and of the server's main
    thread, and those to the diagnostics.
    """
    worked = editor.worked()
    column = program.lines[program.line].index("X") + 1
    began = editor.press(version, "" if key % 2 else "1", program.line, column, key % 2)
    number = asked(editor, what.split(",")[0], program.line, column)
    answered = editor.answered(number) - began
    return (answered, editor.worked() - worked), editor.diagnosed(version) - began


# ---- tables ----


def table(found: dict[str, Figures], of: list[Program]) -> str:
    """Return what was measured: a column for each program."""
    sizes = {each.title: len(each.text.encode()) for each in of}
    rows = [
        ("text", *(report.megabytes(sizes[title]) for title in found)),
        ("memory, times the text", *(f"{f['memory'] / sizes[t]:.1f}" for t, f in found.items())),
        ("the most of it", *(f"{f['most'] / sizes[t]:.1f}" for t, f in found.items())),
        (
            "open to the first diagnostics",
            *(report.seconds_text(f["open"]) for f in found.values()),
        ),
        *(
            (f"key to {what}", *(percentiles(f[what]) for f in found.values()))
            for what in ("diagnostics", *ASKED, AFTER_PAUSE)
        ),
    ]
    return "\n".join(report.markdown(["median, 95 of 100", *found], rows))


def percentiles(seconds: list[tuple[float, float]]) -> str:
    """Return the median and the 95th percentile of the clock, the median of the processor."""
    ordered = sorted(clock for clock, _ in seconds)
    high = ordered[min(len(ordered) - 1, int(0.95 * len(ordered)))]
    worked = statistics.median(worked for _, worked in seconds)
    told = "" if math.isnan(worked) else f" ({worked * 1e3:.0f})"
    return f"{statistics.median(ordered) * 1e3:.0f}, {high * 1e3:.0f} ms{told}"


def load() -> str:
    """Return what else the machine did meanwhile, where the system tells it."""
    if not hasattr(os, "getloadavg"):
        return ""
    return f"; {os.getloadavg()[1]:.1f} processes at work on average, this one included."


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--blocks", type=int, default=100_000)
    options.add_argument("--keys", type=int, default=20, help="for each thing that is asked")
    options.add_argument("--only", help="the programs whose titles hold this text")
    options.add_argument("--write", type=Path, help="the page that shows the table")
    given = options.parse_args()
    chosen = [each for each in programs(given.blocks) if (given.only or "") in each.title]
    found = {each.title: measured(each, given.keys) for each in chosen}
    text = f"{table(found, chosen)}\n\n{report.machine()}{load()}"
    print(text)
    if given.write:
        report.write(given.write, MARK, text)


if __name__ == "__main__":
    main()
