"""The answers of the tools, each with the schema that it is checked by."""

from __future__ import annotations

import json
from typing import Any, Self

from pydantic import BaseModel, Field

LARGEST_ANSWER = 60_000  # characters of an answer as JSON

Facts = dict[str, Any]


class Answer(BaseModel):
    """An answer; `left_out` says how many entries of a list it has no room for."""

    left_out: dict[str, int] = Field(default_factory=dict)

    def fitted(self) -> Self:
        """Shorten the longest list until the answer is not too large, and return it."""
        while len(self.model_dump_json()) > LARGEST_ANSWER:
            lists = {
                name: value
                for name, value in self.__dict__.items()
                if isinstance(value, list | str) and value and name != "stop"
            }
            if not lists:
                break
            longest = max(lists, key=lambda name: _size(lists[name]))
            kept = len(lists[longest]) // 2
            gone = len(lists[longest]) - kept
            setattr(self, longest, lists[longest][:kept])
            self.left_out[longest] = self.left_out.get(longest, 0) + gone
        return self


def _size(value: Any) -> int:
    return len(json.dumps(value, default=str))


class RunAnswer(Answer):
    """How a run stopped, and what it did."""

    stop: str
    waiting_for: str | None
    alarm: Facts | None
    endless: Facts | None
    blocks: int
    seconds: float
    length: float
    bounds: dict[str, list[float]]
    position: dict[str, float]
    modal: dict[str, str]
    variables: dict[str, float | None]
    messages: list[str]
    m_codes: list[int]
    t_codes: list[int]
    calls: list[Facts]
    moves: list[Facts]
    dropped: list[Facts]
    notes: list[str]


class CheckAnswer(Answer):
    """The findings of `check`."""

    findings: list[Facts]
    programs: list[str]
    notes: list[str]


class ExplainAnswer(Answer):
    """What is known of a name, or the names nearest to a question."""

    found: list[Facts]
    nearest: list[Facts]


class CompareAnswer(Answer):
    """Where two controls part, and the rules that cause it."""

    same: bool
    what: str
    where: list[Facts | None]
    rules: list[str]
    parameters: list[str]


class FlattenAnswer(Answer):
    """A program without calls, or why there is none."""

    text: str
    refusal: str | None


class TreeAnswer(Answer):
    """The calls of a run, each with those that it makes."""

    stop: str
    calls: list[Facts]


class ListingAnswer(Answer):
    """The executed blocks that were asked for, each with what it did."""

    stop: str
    blocks: list[str]


class ControlsAnswer(Answer):
    """Controls by name and title."""

    controls: list[dict[str, str]]


class RulesAnswer(Answer):
    """The rules of a control, with values, sources and how sure they are."""

    control: str
    rules: list[Facts]
