"""`cncsub mcp` as an agent talks to it, through the client of the official package."""

from __future__ import annotations

import asyncio
import json
import os
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import jsonschema
import mcp
from loops import run_apart

from cncsub.agents.answers import LARGEST_ANSWER

CONTROL = "fanuc-0i-f"
PROGRAMS = {
    "O1.nc": "O1\nN10 M98 P2\nN20 M98 P9\nN30 M30\n",
    "O2.nc": "O2\n#100=#100+1\nG91 G0 X5.\nM99\n",
}


def talk(ask: Callable[[Any], Awaitable[None]], *folders: Path) -> None:
    """Talk with a server over its pipes."""

    async def whole() -> None:
        words = ["-m", "cncsub", "mcp", *map(str, folders)]
        server = mcp.StdioServerParameters(command=sys.executable, args=words, env=dict(os.environ))
        async with mcp.Client(mcp.stdio_client(server)) as client:
            await ask(client)

    run_apart(asyncio.wait_for(whole(), 120))


async def answer(client: Any, tool: str, **given: Any) -> dict[str, Any]:
    """Return what a tool answers, which its schema describes."""
    told = await client.call_tool(tool, given)
    assert not told.is_error, told.content
    tools = {each.name: each for each in (await client.list_tools()).tools}
    jsonschema.validate(told.structured_content, tools[tool].output_schema)
    assert json.loads(told.content[0].text) == told.structured_content
    return dict(told.structured_content)


async def refusal(client: Any, tool: str, **given: Any) -> str:
    told = await client.call_tool(tool, given)
    assert told.is_error
    return str(told.content[0].text)


def test_an_agent_tries_a_program_on_the_control() -> None:
    async def ask(client: Any) -> None:
        tools = {each.name for each in (await client.list_tools()).tools}
        for each in (await client.list_tools()).tools:
            assert each.input_schema["additionalProperties"] is False
        assert tools == {
            "run", "check", "explain", "compare", "flatten", "tree", "listing", "controls", "rules",
        }  # fmt: skip
        found = await answer(client, "check", control=CONTROL, programs=PROGRAMS)
        assert [each["rule"] for each in found["findings"]] == ["CS201"]
        ran = await answer(client, "run", control=CONTROL, programs=PROGRAMS, variables={"100": 4})
        assert (ran["stop"], ran["alarm"]["number"], ran["alarm"]["n"]) == ("alarm", "PS0076", 20)
        assert ran["variables"]["100"] == 5.0
        assert ran["moves"][0]["x"] == 5.0
        mended = {**PROGRAMS, "O1.nc": PROGRAMS["O1.nc"].replace("P9", "P2")}
        ran = await answer(client, "run", control=CONTROL, programs=mended)
        assert (ran["stop"], ran["position"]["X"]) == ("end", 10.0)
        tree = await answer(client, "tree", control=CONTROL, programs=mended)
        assert {call["program"] for call in tree["calls"]} == {"O2"}
        listed = await answer(
            client, "listing", control=CONTROL, programs=mended, program="O2", watch=[100]
        )
        assert "#100 = 2" in " ".join(listed["blocks"])
        flat = await answer(client, "flatten", control=CONTROL, programs=mended)
        assert "M98" not in flat["text"]
        assert "X5." in flat["text"]

    talk(ask)


def test_an_agent_asks_what_is_known() -> None:
    async def ask(client: Any) -> None:
        listed = await answer(client, "controls")
        assert CONTROL in [each["name"] for each in listed["controls"]]
        told = await answer(client, "explain", asked="G65", control=CONTROL)
        assert told["found"][0]["on"][0]["sources"][0]["evidence"] == "source document"
        near = await answer(client, "explain", asked="nested too deep", control=CONTROL)
        assert "nesting-too-deep" in [each["name"] for each in near["nearest"]]
        rules = await answer(client, "rules", control=CONTROL, words="max_nesting")
        assert rules["rules"][0]["name"] == "max_nesting"
        text = {"a.nc": "O1\nM98 P51002\nM30\nO1002\nM99\nO51002\nM99\n"}
        parted = await answer(
            client, "compare", controls=[CONTROL, "mitsubishi-m700"], programs=text
        )
        assert not parted["same"]
        assert parted["rules"]

    talk(ask)


def test_files_are_read_below_the_folders_alone(tmp_path: Path) -> None:
    inside, outside = tmp_path / "in", tmp_path / "out"
    for folder in (inside, outside):
        folder.mkdir()
        for name, text in PROGRAMS.items():
            (folder / name).write_text(text)
    (inside / "link.nc").symlink_to(outside / "O1.nc")

    async def ask(client: Any) -> None:
        ran = await answer(client, "run", control=CONTROL, paths=["."])
        assert ran["alarm"]["number"] == "PS0076"
        ran = await answer(client, "run", control=CONTROL, paths=["O2.nc"])
        assert ran["blocks"] > 0
        for path in ("../out/O1.nc", str(outside), "link.nc", "/etc/passwd", "O1.nc\0"):
            assert (
                "not" in await refusal(client, "run", control=CONTROL, paths=[path]) or "\0" in path
            )

    talk(ask, inside)
    (outside / "O3.nc").write_text("O3\nG4 P1\nM30\n")

    async def second(client: Any) -> None:
        ran = await answer(client, "run", control=CONTROL, paths=["O3.nc"])
        assert ran["blocks"] == 2
        assert "there is no O4.nc in" in await refusal(
            client, "run", control=CONTROL, paths=["O4.nc"]
        )

    talk(second, inside, outside)

    async def none(client: Any) -> None:
        told = await refusal(client, "run", control=CONTROL, paths=["O1.nc"])
        assert "programs={name: text}" in told

    talk(none)


def test_wrong_questions_are_refused_with_the_reason() -> None:
    async def ask(client: Any) -> None:
        wrong = [
            ("run", {"control": "fanuc-0i-g", "programs": PROGRAMS}, "did you mean"),
            ("run", {"control": CONTROL}, "give either programs"),
            ("run", {"control": CONTROL, "programs": PROGRAMS, "main": "O77"}, "no program O77"),
            (
                "run",
                {"control": CONTROL, "programs": PROGRAMS, "variables": {"x": 1}},
                "by its number",
            ),
            ("check", {"control": CONTROL, "programs": PROGRAMS, "rules": ["CS999"]}, "no rule"),
            ("rules", {"control": "nothing"}, "no control"),
            ("compare", {"controls": [CONTROL], "programs": PROGRAMS}, "2"),
            (
                "run",
                {"control": CONTROL, "programs": PROGRAMS, "maxblocks": 5},
                "run has no argument 'maxblocks'; did you mean max_blocks?",
            ),
            ("controls", {"name": "x"}, "controls has no argument 'name'; it has none"),
        ]
        for tool, given, reason in wrong:
            assert reason in await refusal(client, tool, **given), (tool, given)

    talk(ask)


def test_time_blocks_and_answers_have_limits() -> None:
    async def ask(client: Any) -> None:
        endless = {"a.nc": "O1\nN10 #100=#100+1\nGOTO10\n"}
        ran = await answer(client, "run", control=CONTROL, programs=endless, max_blocks=10**12)
        assert ran["stop"] == "limit"
        assert ran["blocks"] <= 1_000_000
        long = {
            "a.nc": "O1\n" + "".join(f"G91 G1 X{n}. F100 (text)\n" for n in range(5000)) + "M30\n"
        }
        told = await client.call_tool("run", {"control": CONTROL, "programs": long})
        assert len(told.content[0].text) < 3 * LARGEST_ANSWER
        assert told.structured_content["left_out"]["moves"] > 4000
        flat = await answer(client, "flatten", control=CONTROL, programs=long)
        assert flat["left_out"]["text"] > 0
        assert len(flat["text"]) <= LARGEST_ANSWER

    talk(ask)
