"""Runs, controls and alarms as plain values: what the command line writes as JSON."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from cncsub._core import Alarm, Control, Frame, Parameter, keywords
from cncsub.analysis.conditions import conditions_on
from cncsub.controls import (
    aliases_of,
    causes,
    cure_of,
    did_you_mean,
    inferred_rules,
    sources_of,
)
from cncsub.loading import loads
from cncsub.tables.call_tree import CallTree
from cncsub.tables.table import records

if TYPE_CHECKING:
    from cncsub.analysis.endless import Endless
    from cncsub.comparison.changes import BlockChange
    from cncsub.comparison.compare import Comparison
    from cncsub.run import Run


def effect_of(parameter: Parameter, name: Callable[[str], str] = str) -> str:
    """Return what a parameter does, where it does not register codes; `name` writes the name
    of a rule.
    """
    if parameter.rules:
        return f"sets {', '.join(map(name, parameter.rules))}"
    return "" if parameter.used else "cncsub computes nothing from it"


def run_facts(run: Run, title: str) -> dict[str, Any]:
    return {
        "title": title,
        "stop": run.stop.value,
        "waiting_for": run.waiting_for or None,
        "endless": None if run.endless is None else endless_facts(run.endless),
        "alarm": None if run.alarm is None else alarm_facts(run.alarm, run.core.code.control),
        "steps": len(run.steps),
        "calls": [dict(record) for record in records(run.calls)],
        "length": run.moves.total_length,
        "time": run.moves.total_time,
        "bounds": {axis: list(pair) for axis, pair in run.moves.bounds.items()},
        "messages": run.messages,
        "missed_skips": [asdict(missed) for missed in run.missed_skips],
        "dropped": [asdict(word) for word in run.dropped],
        "m_codes": run.m_codes,
        "t_codes": run.t_codes,
        "codes": [dict(record) for record in records(run.codes)],
        "variables": {str(number): value for number, value in run.variables.items()},
        "named_variables": run.variables.named,
        "position": run.position,
        "modal": run.modal,
        "watch": watch_facts(run),
        "moves": [dict(record) for record in records(run.moves)],
    }


def watch_facts(run: Run) -> dict[str, Any] | None:
    if not run.watch.beginning:
        return None
    return {
        "beginning": {str(number): value for number, value in run.watch.beginning.items()},
        "changes": [asdict(run.watch[row]) for row in range(len(run.watch))],
        "conditions": [asdict(row) for row in conditions_on(run, run.watch.beginning)],
    }


def endless_facts(endless: Endless) -> dict[str, Any]:
    return {**asdict(endless), "message": str(endless)}


def alarm_facts(alarm: Alarm, control: Control) -> dict[str, Any]:
    names = "cause number text program n line column word file detail".split()  # noqa: SIM905
    return {
        **{name: getattr(alarm, name) for name in names},
        "cure": cure_of(alarm, control),
        "frames": [_frame_facts(frame) for frame in alarm.frames],
        "message": str(alarm),
    }


def _frame_facts(frame: Frame) -> dict[str, Any]:
    names = "program n line file kind called repeat repeats".split()  # noqa: SIM905
    return {name: getattr(frame, name) for name in names}


def comparison_facts(compared: Comparison) -> dict[str, Any]:
    return {
        "version": 1,
        "same": compared.same,
        "where": _steps_facts(compared.where or ()),
        "what": compared.what,
        "rules": list(compared.rules),
        "untried": list(compared.untried),
        "parameters": list(compared.parameters),
        "differences": [
            {
                "where": _steps_facts(difference.where),
                "what": difference.what,
                "rules": list(difference.rules),
                "parameters": list(difference.parameters),
                "untried": list(difference.untried),
                "why": list(difference.why),
            }
            for difference in compared.differences
        ],
        "rest": compared.rest or None,
        "changes": [_change_facts(change) for change in compared.changes],
    }


def _steps_facts(steps: Iterable[Any]) -> list[dict[str, Any] | None]:
    return [None if step is None else asdict(step) for step in steps]


def _change_facts(change: BlockChange) -> dict[str, Any]:
    def place(of: Any) -> dict[str, Any] | None:
        return None if of is None else of._asdict()

    return {
        "what": change.what,
        "before": place(change.before),
        "after": place(change.after),
        "old": change.old,
        "new": change.new,
    }


def tree_facts(run: Run, title: str) -> dict[str, Any]:
    return {
        "title": title,
        "stop": run.stop.value,
        "alarm": None if run.alarm is None else alarm_facts(run.alarm, run.core.code.control),
        "dropped": [asdict(word) for word in run.dropped],
        "calls": [_call_facts(run, call) for call in run.calls.tree()],
    }


def _call_facts(run: Run, call: CallTree) -> dict[str, Any]:
    step = call.caller_step
    caller = None if step is None or step >= len(run.steps) else run.steps[step]
    return {
        "kind": call.kind,
        "program": call.program,
        "start_n": call.start_n,
        "repeats": call.repeats,
        "blocks": call.blocks,
        "count": call.count,
        "caller": None if caller is None else caller.program,
        "caller_n": None if caller is None else caller.n,
        "caller_line": None if caller is None else caller.line,
        "arguments": {str(number): value for number, value in call.arguments.items()},
        "arguments_vary": call.varied,
        "calls": [_call_facts(run, inner) for inner in call.calls],
    }


def listed_facts(control: Control) -> dict[str, Any]:
    """Return what the list of controls says of one."""
    return {
        "name": control.name,
        "title": control.title,
        "aliases": aliases_of(control) if control.name == control.base else [],
        "rules": len(control.rules),
        "inferred": inferred_rules(control),
    }


def control_facts(control: Control) -> dict[str, Any]:
    return {
        "name": control.name,
        "title": control.title,
        "aliases": listed_facts(control)["aliases"],
        "inferred": inferred_rules(control),
        "rules": [
            {
                "name": rule.name,
                "group": rule.group,
                "value": rule.value,
                "family": rule.family,
                "meaning": rule.meaning,
                "choices": list(rule.choices or rule.entries),
                "source": rule.source,
                "evidence": rule.evidence,
                "sources": {
                    entry: {"source": source, "evidence": evidence}
                    for entry, (source, evidence) in rule.sources.items()
                },
            }
            for rule in control.rules
        ],
        "absent": {
            group: {"source": source, "evidence": evidence}
            for group, (source, evidence) in control.absent.items()
        },
        "parameters": [
            {
                "name": parameter.name,
                "value": parameter.value,
                "meaning": parameter.meaning,
                "rules": list(parameter.rules),
                "used": parameter.used,
                "source": parameter.source,
                "evidence": parameter.evidence,
            }
            for parameter in control.parameters.values()
        ],
        "variable_options": [
            {
                "name": option.name,
                "meaning": option.meaning,
                "numbers": option.numbers,
                "fitted": option.fitted,
                "rule": option.rule,
                "source": option.source,
                "evidence": option.evidence,
            }
            for option in control.variable_options.values()
        ],
        "alarms": [
            {"cause": alarm.cause, **_alarm_entry(alarm)} for alarm in control.alarms.values()
        ],
        "sources": [
            {
                "key": source.key,
                "title": source.title,
                "address": source.address or None,
                "evidence": source.on(control.base),
            }
            for source in sources_of(control)
        ],
    }


# ---- alarms ----


def explanations(asked: str, among: list[Control]) -> list[dict[str, Any]]:
    """Return what is known about a cause or a number: one entry for each cause, with its
    controls.
    """
    wanted = asked.strip().casefold()
    slugs = [slug for slug in causes if slug == wanted]
    if not slugs:
        slugs = _causes_of_number(wanted, among)
    by_number = wanted not in causes
    told = [_explanation(slug, among, wanted if by_number else None) for slug in slugs]
    if not slugs or re.fullmatch(r"[0-9]{4}", wanted):  # 3020 is said for MC3020 too
        raised = [(c, number) for c in among if (number := _user_alarm_number(c, wanted))]
        told += [_user_alarm(raised)] if raised else []
    return told


def _user_alarm_number(control: Control, wanted: str) -> str | None:
    """Return the alarm of this number that a program can raise by #3000; the control itself is
    asked.
    """
    figures = re.fullmatch(r"[a-z]*([0-9]{1,4})", wanted)
    if figures is None or not (number := int(figures[1]) % 1000):
        return None
    alarm = loads(f"O1\n#3000={number}\n", control=control).run().alarm
    raised = "" if alarm is None or alarm.cause != "user-alarm" else alarm.number or ""
    same = raised.casefold() == wanted or (figures[1] == wanted and raised.endswith(wanted))
    return raised if same else None


def _user_alarm(raising: list[tuple[Control, str]]) -> dict[str, Any]:
    """Return what is known of an alarm that only a program raises, on the controls with its
    number.
    """
    number = raising[0][1]
    raised: dict[str, Any] = {
        "text": "the message that the program gives",
        "printed": None,
        "directed": {},
        "source": f"a program raises it with #3000={int(number[-3:])}",
        "evidence": "see the rules of the control",
    }
    told = _explanation("user-alarm", [control for control, _ in raising], None)
    alarms = [{"control": control.name, "number": own, **raised} for control, own in raising]
    return {**told, "alarms": alarms}


# Causes that people confuse, because a relative of the control raises the other number.
_ALIKE = ("program-not-found", "named-program-not-found", "external-program-not-found")


def _beside(slug: str) -> list[str]:
    return [kin for kin in _ALIKE if kin != slug] if slug in _ALIKE else []


def _kin(slug: str, controls: list[Control]) -> list[dict[str, Any]]:
    """Return the numbers of a cause like another one, each once."""
    numbers = dict.fromkeys(c.alarms[slug].number for c in controls if slug in c.alarms)
    meaning = causes[slug].meaning
    return [{"number": n, "cause": slug, "meaning": meaning} for n in numbers if n]


def _causes_of_number(wanted: str, among: list[Control]) -> list[str]:
    entries = [alarm for control in among for alarm in control.alarms.values()]
    exact = {a.cause for a in entries if any(_same(n, wanted) for n in _numbers(a))}
    loose = {a.cause for a in entries if any(_alike(n, wanted) for n in _numbers(a))}
    return [slug for slug in causes if slug in (exact or loose)]


def _numbers(entry: Any) -> list[str]:
    """Return the number of an alarm, and those of its directions."""
    return [entry.number, *(number for number, _ in entry.directed.values())]


def _same(number: str | None, wanted: str) -> bool:
    return bool(number) and (number or "").casefold() == wanted


def _alike(number: str | None, wanted: str) -> bool:
    """Return whether two numbers name one alarm: `76` stands for `076` and for `PS0076`."""
    return bool(number) and _figures(number) == _figures(wanted) != ""


def _figures(number: str | None) -> str:
    text = (number or "").casefold().strip()
    for prefix in ("ps", "sr", "p/s", "p", "no.", "#"):
        if text.startswith(prefix) and text[len(prefix) :].strip().isdigit():
            text = text[len(prefix) :].strip()
            break
    return text.lstrip("0") if text.isdigit() else ""


def _explanation(slug: str, among: list[Control], wanted: str | None) -> dict[str, Any]:
    cause = causes[slug]
    entries = [(c, c.alarms[slug]) for c in among if slug in c.alarms]
    if wanted is not None:
        exact = [(c, a) for c, a in entries if any(_same(n, wanted) for n in _numbers(a))]
        entries = exact or [
            (c, a) for c, a in entries if any(_alike(n, wanted) for n in _numbers(a))
        ]
    return {
        "cause": slug,
        "meaning": cause.meaning,
        "cure": cause.cure,
        "beside": [fact for kin in _beside(slug) for fact in _kin(kin, [c for c, _ in entries])],
        "alarms": [{"control": control.name, **_alarm_entry(entry)} for control, entry in entries],
    }


def _alarm_entry(entry: Any) -> dict[str, Any]:
    return {
        "number": entry.number or None,
        "text": entry.text,
        "printed": entry.printed,
        "directed": {way: number for way, (number, _) in entry.directed.items()},
        "source": entry.source,
        "evidence": entry.evidence,
    }


def unknown_alarm(asked: str, among: list[Control], rules: Iterable[str]) -> str:
    numbers = [n for c in among for a in c.alarms.values() for n in _numbers(a) if n]
    of_controls = [name for c in among for name in (*(r.name for r in c.rules), *c.parameters)]
    words = [word for c in among for word, _, _ in keywords(c)]
    known = dict.fromkeys([*causes, *rules, *numbers, *of_controls, *words])
    where = f" on {among[0].name}" if len(among) == 1 else ""
    what = "code, alarm, cause, rule or parameter"
    return f"no {what} is called {asked!r}{where}{did_you_mean(asked, known)}"
