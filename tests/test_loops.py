"""The harness of the tests that need a loop, beside a loop that runs already."""

from __future__ import annotations

import asyncio

import pytest
from loops import run_apart


async def _answer() -> str:
    await asyncio.sleep(0)
    process = await asyncio.create_subprocess_exec("true")
    return f"ended with {await process.wait()}"


async def _failure() -> None:
    raise LookupError("told")


def test_a_loop_runs_apart_from_the_one_of_its_thread() -> None:
    """The browser leaves a loop running in the thread of the tests, as this one does."""

    async def outside() -> None:
        assert run_apart(_answer()) == "ended with 0"
        with pytest.raises(LookupError, match="told"):
            run_apart(_failure())

    asyncio.run(outside())
    assert run_apart(_answer()) == "ended with 0"
