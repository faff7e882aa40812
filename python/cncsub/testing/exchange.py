"""Cases as JSON, so that another engine can be held to them: `docs/conformance.schema.json`."""

from __future__ import annotations

import base64
import dataclasses
import json
import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

import cncsub
from cncsub.inputs import numbered, values_of_table
from cncsub.testing import moves as motion
from cncsub.testing.cases import UNKNOWN, Case, Text, read_case

FORMAT = "cncsub-conformance"
VERSION = 1  # of the format; it grows when a key changes its meaning or is removed

# The names of fields of a case in the JSON, where these are other words.
_GIVEN = {"params": "parameters", "replace": "rules", "setup": "setup", "mdi": "mdi"}
_GIVEN |= {"encoding": "encoding"}
_EXPECTED = {
    name: name
    for name in ("stop", "alarm", "at", "runs", "m", "t", "messages", "dropped", "calls", "tree")
}
_EXPECTED |= {name: name for name in ("frames", "arguments", "variables", "moves_x", "centre")}
_EXPECTED |= {name: name for name in ("final_machine", "final_work", "time")}
_EXPECTED |= {"vars_after_reset": "variables_after_reset"}
_EXPECTED |= {name: name for name in ("work_after_reset", "modal_after_reset")}
_NUMBERED = ("variables", "arguments", "vars_after_reset")
_LISTS = ("runs", "frames", "calls", "centre")  # tuples in a case


def suite_facts(
    cases: Sequence[Case], evidence: Mapping[str, Mapping[str, str]] | None = None
) -> dict[str, Any]:
    """Return cases as JSON can hold them, with what their words mean and what is left out.

    `evidence`: the worth of the source of a case, by claim and control, where it is known. A case
    that JSON cannot hold is not dropped: `left_out` names it, its topic and the reason.

    >>> from cncsub.testing import case
    >>> from cncsub.testing.exchange import suite_facts
    >>> text = "O1\\nN10 M98 P2\\nN20 M30\\nO2\\nN30 M99"
    >>> row = case("M98 calls", control="fanuc-0i-f", program=text, runs="N10 N30 N20")
    >>> suite_facts([row])["cases"][0]["expect"]
    {'stop': 'end', 'runs': ['N10', 'N30', 'N20']}
    """
    written, left_out = [], []
    for case in cases:
        try:
            written.append(case_facts(case, (evidence or {}).get(case.claim, {})))
        except ValueError as error:
            left_out.append({"topic": case.topic, "claim": case.claim, "reason": str(error)})
    controls = {name for case in written for name in case["controls"]}
    alarms = {case["expect"].get("alarm") for case in written}
    rules = {rule for case in written for rule in case.get("rules", ())}
    return {
        "format": FORMAT,
        "version": VERSION,
        "cncsub": cncsub.__version__,
        "counts": {
            "cases": len(written),
            "rows": sum(len(case["controls"]) for case in written),
            "left_out": len(left_out),
        },
        "tolerances": {"variable": 2e-5, "coordinate": motion.TOLERANCE, "time": 0.002},
        "controls": {n: _control(c, alarms) for n, c in cncsub.controls.items() if n in controls},
        "causes": {slug: c.meaning for slug, c in cncsub.causes.items() if slug in alarms},
        "rules": {
            rule.name: rule.meaning
            for control in cncsub.controls.values()
            for rule in control.rules
            if rule.name in rules
        },
        "cases": written,
        "left_out": left_out,
    }


def _control(control: cncsub.Control, causes: Iterable[str]) -> dict[str, Any]:
    """Return the facts of a control. It has texts of alarms only from printed lists: no other
    engine has to use our words.
    """
    machine = next(rule.value for rule in control.rules if rule.name == "machine")
    texts = {
        cause: entry.text
        for cause, entry in control.alarms.items()
        if cause in causes and entry.printed
    }
    return {"title": control.title, "machine": machine, "texts": texts}


def case_facts(case: Case, evidence: Mapping[str, str]) -> dict[str, Any]:
    """Return one case; raise `ValueError` for what JSON cannot hold."""
    facts: dict[str, Any] = {"claim": case.claim, "topic": case.topic}
    facts["controls"] = {name: _on(case, name, evidence) for name in case.controls}
    for name in ("program", "files", "external"):
        value = getattr(case, name)
        if value is not None:
            facts[name] = (
                {file: _text(text) for file, text in value.items()}
                if isinstance(value, Mapping)
                else _text(value)
            )
    for name, key in _GIVEN.items():
        value = getattr(case, name)
        if value is not None and value != {}:
            facts[key] = _plain(key, value)
    if case.options:
        facts["run"] = _plain("run", case.options)
    expect = {key: getattr(case, name) for name, key in _EXPECTED.items()}
    facts["expect"] = {
        key: _plain(key, value)
        for key, value in expect.items()
        if value is not None and not (key == "variables" and not value)
    }
    if case.moves is not None:
        facts["expect"]["moves"] = [_move(move) for move in case.moves]
    return facts


def _on(case: Case, control: str, evidence: Mapping[str, str]) -> dict[str, Any]:
    """Return what a case says of one of its controls alone."""
    facts: dict[str, Any] = {"source": case.source_on(control)}
    if control in evidence:
        facts["evidence"] = evidence[control]
    number = case.number_on(control)
    if case.alarm is not None and number is not UNKNOWN:
        facts["number"] = number
    word = case.word_on(control)
    if word is not None:
        facts["word"] = word
    return facts


def _text(text: Text) -> Any:
    if isinstance(text, bytes):
        return {"base64": base64.b64encode(text).decode("ascii")}
    return _plain("a program", text)


def _move(move: motion.Move) -> dict[str, Any]:
    facts: dict[str, Any] = {"kind": move.kind}
    if move.kind == "dwell":
        return facts | {"seconds": move.seconds}
    facts["end"] = dict(move.end)
    return facts | ({"centre": dict(move.centre)} if move.centre else {})


def _plain(what: str, value: Any) -> Any:
    """Return a value as JSON has it: keys are texts, a time is written as ISO 8601 has it."""
    if isinstance(value, Mapping):
        return {str(key): _plain(what, inner) for key, inner in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(what, inner) for inner in value]
    if isinstance(value, datetime):
        return value.isoformat()
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{what} has {value}, which JSON cannot have")
    if isinstance(value, str):
        try:
            value.encode()
        except UnicodeEncodeError:
            raise ValueError(f"{what} has a text that is not Unicode") from None
    if value is None or isinstance(value, bool | int | float | str):
        return value
    raise ValueError(f"{what} has a {type(value).__name__}, which JSON cannot have")


# ---- back ----


def cases_of_json(file: Path) -> tuple[Case, ...]:
    """Return the cases of a suite; see `load_table`. Cases that the suite left out are not among
    them.
    """
    try:
        told = json.loads(file.read_text(encoding="utf-8"))
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"{file}: {error}") from None
    if not isinstance(told, dict) or told.get("format") != FORMAT:
        raise ValueError(f'{file}: not a conformance suite: it has no "format": "{FORMAT}"')
    if told.get("version") != VERSION:
        raise ValueError(f"{file}: version {told.get('version')!r}; this cncsub reads {VERSION}")
    found = []
    for number, row in enumerate(told["cases"], 1):
        try:
            found.append(_case(row, number))
        except (KeyError, TypeError, AttributeError, ValueError) as error:
            claim = row.get("claim") if isinstance(row, dict) else row
            raise ValueError(f"{file}: case {number}, {claim!r}: {error}") from None
    return tuple(found)


def _case(row: Mapping[str, Any], number: int) -> Case:
    expect, on = dict(row["expect"]), row["controls"]
    fields = {name: expect[key] for name, key in _EXPECTED.items() if key in expect}
    for name in _NUMBERED:
        if name in fields:
            fields[name] = numbered(fields[name])
    for name in _LISTS:
        if name in fields:
            fields[name] = tuple(fields[name])
    if "moves" in expect:
        fields["moves"] = tuple(motion.Move(**move) for move in expect["moves"])
    if "number" in next(iter(on.values())) or fields.get("alarm"):
        fields["number"] = {name: told.get("number", UNKNOWN) for name, told in on.items()}
    words = {name: told["word"] for name, told in on.items() if "word" in told}
    fields["word"] = words or None
    fields["options"] = _options(row.get("run", {}))
    # A valid case is made first, and takes what was read: `read_case` reads the languages of
    # tables.
    shell = read_case(
        row["claim"],
        control=list(on),
        source={name: told["source"] for name, told in on.items()},
        topic=row["topic"],
        line=number,
        program=_text_of(row["program"]) if "program" in row else None,
        files=_texts_of(row.get("files")),
        external=_texts_of(row.get("external")),
        mdi=row.get("mdi"),
        encoding=row.get("encoding"),
        params=row.get("parameters"),
        replace=row.get("rules"),
        setup=row.get("setup"),
        stop=fields["stop"],
        alarm=fields.get("alarm"),
        runs="",
    )
    return dataclasses.replace(shell, **{"runs": None, **fields})


def _text_of(text: Any) -> Text:
    if isinstance(text, Mapping):
        return base64.b64decode(text["base64"], validate=True)
    if not isinstance(text, str):
        raise TypeError(f"a program must be a text or base64, not {type(text).__name__}")
    return text


def _texts_of(files: Mapping[str, Any] | None) -> dict[str, Text] | None:
    return None if files is None else {name: _text_of(text) for name, text in files.items()}


def _options(told: Mapping[str, Any]) -> dict[str, Any]:
    options = dict(told)
    if "block_skip" in options:
        options["block_skip"] = tuple(options["block_skip"])
    if "variables" in options:
        options["variables"] = numbered(options["variables"])
    if "inputs" in options:
        inputs = dict(options["inputs"])
        if isinstance(inputs.get("clock"), str):
            inputs["clock"] = datetime.fromisoformat(inputs["clock"])
        options["inputs"] = values_of_table(inputs)
    return options


def left_out_by_topic(suite: Mapping[str, Any]) -> Iterable[str]:
    """Yield a line for each topic of which cases were left out, with their count and the
    reasons.
    """
    counts = Counter((row["topic"], row["reason"]) for row in suite["left_out"])
    for (topic, reason), count in sorted(counts.items()):
        yield f"{topic}: {count} left out: {reason}"
