"""The page on debugging in an editor: what it sends is sent, and what it gets comes."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from dap_client import Client, in_process

PAGE = Path(__file__).parent.parent / "docs" / "guides" / "dap.md"
MACRO = Path(__file__).parent.parent / "docs" / "guides" / "debugging.md"


def macro() -> str:
    """The program of the page on debugging, whose fault this page mends."""
    found = re.search(r'>>> text = """(.*?)\.\.\. """', MACRO.read_text("utf-8"), re.S)
    assert found is not None
    return found[1].replace("... ", "")


def conversations() -> list[tuple[str, list[str]]]:
    text = PAGE.read_text("utf-8")
    blocks = re.findall(r'^```text title="(.*?)"\n(.*?)^```', text, re.M | re.S)
    return [(title, words.splitlines()) for title, words in blocks]


def holds(told: Any, got: Any) -> bool:
    """Return whether a message has what the page tells of it; it may have more."""
    if isinstance(told, dict):
        return all(name in got and holds(value, got[name]) for name, value in told.items())
    if isinstance(told, list):
        return len(told) == len(got) and all(map(holds, told, got))
    return bool(told == got)


def play(client: Client, path: Path, line: str, answers: list[dict[str, Any]]) -> None:
    line = line.replace('"row.nc"', json.dumps(str(path)))
    sign, _, rest = line.partition(" ")
    if sign == "edit":
        old, new = rest.partition(": ")[2].split(" -> ")
        assert old in path.read_text()
        path.write_text(path.read_text().replace(old, new))
        return
    name, brace, body = rest.partition("{")
    given = json.loads(brace + body)
    if sign == "->":
        answers.append(client.ask(name.strip(), **given))
    elif name.strip():
        got = client.event("stopped", "output", "exited")
        assert holds(given, got), (line, got)
    else:
        assert holds(given, answers[-1]), (line, answers[-1])


def test_the_page_leads_from_the_first_breakpoint_to_the_mended_fault(tmp_path: Path) -> None:
    path = tmp_path / "row.nc"
    path.write_text(macro())
    with in_process() as client:
        client.launch(path, stopOnEnd=True)
        answers: list[dict[str, Any]] = []
        told = conversations()
        assert len(told) == 5
        for _, lines in told:
            for line in lines:
                play(client, path, line, answers)
        client.ask("disconnect")


def test_the_settings_of_the_page_are_read() -> None:
    from cncsub.dap.arguments import Arguments
    from cncsub.dap.launching import KEYS, launch_of

    found = re.search(
        r'^```json title="launch.json"\n(.*?)^```', PAGE.read_text("utf-8"), re.M | re.S
    )
    assert found is not None
    (configuration,) = json.loads(found[1])["configurations"]
    launch = launch_of(Arguments(configuration))
    assert launch.unknown == ()
    assert launch.stop_on_end
    rows = re.findall(r"^\| (`.*?`) \|", PAGE.read_text("utf-8"), re.M)
    assert {key for row in rows for key in re.findall(r"`(\w+)`", row)} == KEYS
