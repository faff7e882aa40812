"""A page for each control: how far to trust it, its rules by group, parameters, alarms, variables
by option and G codes, each with where it is known from."""

from __future__ import annotations

import re
from collections.abc import Iterator

import cncsub
from cncsub import _core
from cncsub.controls import EVIDENCE, aliases, evidence_words, inferred_rules, sources_of
from cncsub.reports.facts import effect_of
from generator.evidence import weighted
from generator.markdown import cited, code, source_anchor, table, words

_GROUPS = {
    "common": "Of the whole control",
    "reading": "Reading",
    "calls": "Calls and returns",
    "macros": "Macros and variables",
    "motion": "Motion",
    "turning": "Turning",
}


def names() -> list[str]:
    return [f"controls/{name}.md" for name in cncsub.controls]


def pages() -> dict[str, str]:
    return {f"controls/{name}.md": _page(c) for name, c in cncsub.controls.items()}


# ---- the table of all ----


def table_of_controls() -> str:
    heads = (
        "`-c`",
        "control",
        "levels",
        "P of M98",
        "start word",
        "names",
        "macros",
        "M198",
        "rules",
        "inferred",
    )
    return table(heads, map(_row, cncsub.controls.values()))


# What controls with a language of their own say otherwise, which no rule of the ISO family tells.
_OWN_LANGUAGE = {
    "grblhal": {
        "levels": "10 of both kinds",
        "names": "names of files",
        "macros": "O-words, G65",
    },
    "linuxcnc": {
        "levels": "9 of both kinds",
        "P": "number",
        "names": "names of files",
        "macros": "O-words",
    },
    "okuma-osp-p300": {
        "levels": "8",
        "names": "names of programs",
        "macros": "CALL, MODIN",
    },
    **{
        name: {"names": "names of programs", "macros": "PROC, MCALL"}
        for name in ("siemens-828d", "siemens-840d-sl", "siemens-one")
    },
}
_P = {
    "number": "number",
    "count-and-number": "count + number",
    "sequence-number": "N of the same program",
}


def _row(control: cncsub.Control) -> list[str]:
    rules = {rule.name: rule.value for rule in control.rules}
    roles = _roles(control)
    told = {
        "levels": levels(control),
        "P": _P.get(str(rules.get("program_word")), "-") if "call" in roles.values() else "-",
        "start": _start_word(control) if "call" in roles.values() else "-",
        "names": _names(rules),
        "macros": ", ".join(_macros(control)) or "-",
        "M198": "yes" if "external-call" in roles.values() else "-",
        **_OWN_LANGUAGE.get(control.name, {}),
    }
    name = f"[`{control.name}`]({control.name}.md)"
    share = f"{100 * inferred_rules(control) / len(control.rules):.0f} %"
    kinds = " / ".join(map(str, worth(control)))
    return [name, words(control.title), *told.values(), kinds, share]


def table_of_aliases() -> str:
    rows = (
        [
            code(alias.name),
            f"[`{alias.control}`]({alias.control}.md)",
            f"{cited(alias.source, '../')}; *{alias.evidence}*",
        ]
        for alias in aliases.values()
    )
    return table(("name", "taken as", "who says so"), rows)


def _names(rules: dict[str, object]) -> str:
    heads = str(rules.get("program_heads", "")).split()
    told = ["`P[NAME]`"] if rules.get("bracket_names") else []
    told += ["`<NAME>`"] if "name" in heads else []
    told += ["`%n`"] if "percent" in heads else []
    return ", ".join(told) or "-"


def _macros(control: cncsub.Control) -> list[str]:
    """The codes that call macros, and what else passes arguments."""
    rules = {rule.name: rule.value for rule in control.rules}
    listed = str(rules.get("g_codes", "")).split()
    told = [
        name
        for name, role in _roles(control).items()
        if "macro-call" in role or "modal-call" in role
        if not listed or name.lstrip("G") in listed
    ]
    told += ["G65 H"] if rules.get("h_codes") else []
    return told + (["M98 passes A-Z"] if rules.get("call_passes_words") else [])


def _roles(control: cncsub.Control) -> dict[str, str]:
    (roles,) = (str(rule.value) for rule in control.rules if rule.name == "roles")
    return dict(entry.split("=") for entry in roles.split())


def _start_word(control: cncsub.Control) -> str:
    rule = next((rule for rule in control.rules if rule.name == "start_word"), None)
    if rule is None:  # the language of its programs does not ask
        return "-"
    if rule.value != "none":
        return str(rule.value)
    set_by = [p for p in control.parameters.values() if rule.name in p.rules]
    return f"Q ({set_by[0].name})" if set_by else "-"


def levels(control: cncsub.Control) -> str:
    """How many calls may be open, and of which kinds."""
    rules = {rule.name: rule.value for rule in control.rules}
    subprograms, macros = rules["max_nesting"], rules.get("max_macro_nesting")
    if not macros or not _macros(control):
        return str(subprograms)
    if not rules.get("nesting_counts_macros"):
        return f"{subprograms} + {macros}"
    return (
        f"{subprograms} of both kinds"
        if macros == subprograms
        else f"{subprograms}, of them {macros} macros"
    )


def worth(control: cncsub.Control) -> list[int]:
    """How many rules, and entries of rules, stand on each kind of evidence, the strongest first."""
    told = [str(rule.evidence) for rule in control.rules]
    told += [str(how) for rule in control.rules for _, how in rule.sources.values()]
    return [told.count(kind) for kind in EVIDENCE]


# ---- a page ----


def _page(control: cncsub.Control) -> str:
    parts = [_head(control), _rules(control), _codes(control), _words(control)]
    parts += [_parameters(control), _options(control), _alarms(control), _sources(control)]
    return "\n".join(filter(None, parts))


def _head(control: cncsub.Control) -> str:
    total = sum(worth(control))
    rows = (
        [kind, str(count), f"{100 * count / total:.0f} %"]
        for kind, count in zip(EVIDENCE, worth(control), strict=True)
    )
    numbered = sum(1 for alarm in control.alarms.values() if alarm.number)
    absent = "".join(
        f"It has no rules of {words(group)} ({cited(source, '../')}; {how}).\n\n"
        for group, (source, how) in control.absent.items()
    )
    return (
        f"# {words(control.title)}\n\n`{control.name}`: open calls {levels(control)};"
        f" {len(control.parameters)} parameters, {numbered} causes with a number on its screen.\n\n"
        f"```console\n$ cncsub run program.nc -c {control.name}\n```\n\n"
        "## How far to trust it\n\n"
        "How many of its rules, and of their entries, have which evidence:\n\n"
        + table(("evidence", "count", "share"), rows)
        + f"\nOf its rules alone {evidence_words(control)} are inferred. {_weighted(control)}\n"
        + "\n[What each is worth](../reference/sources.md). A rule that is inferred is general"
        " knowledge or our choice: try it on the machine before you rely on it.\n\n" + absent
    )


def _weighted(control: cncsub.Control) -> str:
    """How much of what programs depend on is inferred."""
    found = weighted(control.name)
    return (
        f"Another value of {len(found.touched)} of them changes what one of {found.programs}"
        f" programs does (the examples of its maker, and rows of real programs): of these"
        f" {len(found.inferred)} are inferred ({100 * found.share:.0f} %)."
        f" [The open questions](../questions/{control.name}.md) are what the owner of a machine can"
        " settle."
    )


def _rules(control: cncsub.Control) -> str:
    text = (
        "## Rules\n\nWhat it does where controls differ: `control.replace(max_nesting=10)` changes"
        " one.\n\n"
    )
    for group, title in _GROUPS.items():
        rules = [rule for rule in control.rules if rule.group == group]
        if rules:
            rows = (_rule_row(rule) for rule in rules)
            text += f"### {title}\n\n"
            text += table(("rule", "value", "what it is", "source"), rows) + "\n"
    return text


def _rule_row(rule: _core.Rule) -> list[str]:
    meaning = words(rule.meaning)
    examples = dict(zip(rule.choices or rule.entries, rule.examples, strict=True))
    chosen = [str(rule.value)] if rule.choices else str(rule.value).split() if rule.entries else []
    shown = [words(examples[one]) for one in chosen if one in examples]
    if shown:
        meaning += ": " + "; ".join(shown)
    source = _worth(rule.source, rule.evidence)
    if rule.sources:
        source += "".join(
            f"<br>{code(entry)}: {_worth(text, how)}" for entry, (text, how) in rule.sources.items()
        )
    return [code(rule.name), _value(rule.value), meaning, source]


def _worth(source: str, evidence: str) -> str:
    return f"{cited(source, '../')}; *{evidence}*" if source else f"*{evidence}*"


def _value(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return " ".join(code(part) for part in str(value).split()) or "none"


def _parameters(control: cncsub.Control) -> str:
    if not control.parameters:
        return ""
    rows = (
        [
            code(p.name),
            f"{p.value:g}",
            words(p.meaning) + (f" ({effect})" if (effect := effect_of(p, code)) else ""),
            _worth(p.source, p.evidence),
        ]
        for p in control.parameters.values()
    )
    return (
        "## Parameters\n\nThe values as delivered, as far as they are known."
        " `--param NAME=VALUE`, or"
        " `control.with_parameters({...})`, sets one.\n\n"
        + table(("parameter", "value", "what it is", "source"), rows)
    )


def _options(control: cncsub.Control) -> str:
    if not control.variable_options:
        return ""
    rows = (
        [
            code(o.name),
            words(o.numbers),
            words(o.meaning),
            "fitted" if o.fitted else "-",
            _worth(o.source, o.evidence),
        ]
        for o in control.variable_options.values()
    )
    return (
        "## Variables by option\n\nOptions that a shop bought are given by"
        " `control.replace`: [Parameters and rules](../guides/parameters.md).\n\n"
        + table(("option", "variables", "what it is", "", "source"), rows)
    )


def _alarms(control: cncsub.Control) -> str:
    text = "## Alarms\n\n"
    if not control.alarms:
        return (
            text + "No source gives numbers: an alarm has only its cause"
            " ([all causes](../causes/index.md)).\n"
        )
    rows = sorted(
        (
            [
                code(a.number) or "-",
                f"[{slug}](../causes/{slug}.md)",
                words(a.text or "-"),
                _worth(a.source, a.evidence),
            ]
            for slug, a in control.alarms.items()
        ),
        key=lambda row: (row[0] == "-", row[0]),
    )
    return text + table(("number", "cause", "text", "source"), rows)


# ---- G codes ----

_FATES = {
    "computed": "Computed",
    "passed": "Ignored: they do not change the path",
    "not computed": "Not computed: the control has them, and a run stops at them with"
    " [code-not-computed](../causes/code-not-computed.md)",
    "not known": "Not known: no source says whether the control has them; a run stops at them with"
    " [code-not-known](../causes/code-not-known.md)",
    "refused": "Refused",
}
_FATE_OF = {
    "Neutral": "passed",
    "Ignored": "passed",
    "Uncomputed": "not computed",
    "Unknown": "not known",
    "None": "refused",
}


def _codes(control: cncsub.Control) -> str:
    asked = {rule.name: str(rule.value) for rule in control.rules}
    others = asked.get("unlisted_codes", "refused")  # a language with a list of its own
    text = "## G codes\n\n"
    for machine, title in _machines(control):
        fates: dict[str, list[str]] = {fate: [] for fate in _FATES}
        for name, meaning in _core.g_codes(control, machine):
            fate = _FATE_OF.get(meaning, "computed")
            fates[fate].append(f"{name} {_spelled(meaning)}" if fate == "computed" else name)
        text += f"### {title}\n\n" if title else ""
        for fate, told in _FATES.items():
            if fates[fate]:
                text += f"{told}: {', '.join(map(code, fates[fate]))}.\n\n"
        text += (
            "Every other G code is refused: the control does not have it.\n\n"
            if others == "refused"
            else "For every other G code no source says whether the control has it.\n\n"
        )
    return text


_WORDS = {
    "computed": "Computed, or obeyed as the control obeys them",
    "passed-over": "Told as dropped, for no path depends on them",
    "not-computed": "Not computed: a run stops there with `code-not-computed`",
    "not-known": "No source says whether the control has them",
    "refused": "Letters that are no address of the language",
}


def _words(control: cncsub.Control) -> str:
    """The words of the language that are no codes, by what becomes of them."""
    text = (
        "## Words of its language\n\nBesides G and M codes and axes."
        f" `cncsub explain WORD -c {control.name}` says what each does, and where that is known"
        " from.\n\n"
    )
    fates: dict[str, list[str]] = {fate: [] for fate in _WORDS}
    for name, treatment, _ in _core.keywords(control):
        fates[treatment].append(name)
    for fate, told in _WORDS.items():
        if fates[fate]:
            text += f"{told}: {', '.join(map(code, fates[fate]))}.\n\n"
    return text if any(fates.values()) else ""


def _machines(control: cncsub.Control) -> Iterator[tuple[str, str]]:
    (kind,) = (str(r.value) for r in control.rules if r.name == "machine")
    turning = any(rule.group == "turning" for rule in control.rules)
    if kind == "mill" and turning:
        yield from (
            ("mill", "As a mill"),
            ("lathe-a", "As a lathe, system A"),
            ("lathe-b", "As a lathe, system B"),
        )
    else:
        yield kind, ""


def _spelled(meaning: str) -> str:
    """`set coordinate` of `SetCoordinate`."""
    return (
        re.sub(r"(?<=[a-z])(?=[A-Z0-9])", " ", meaning)
        .lower()
        .replace(" xy", " XY")
        .replace(" zx", " ZX")
        .replace(" yz", " YZ")
    )


def _sources(control: cncsub.Control) -> str:
    rows = (
        [
            f"[{words(s.key)}](../reference/sources.md#{source_anchor(s.key)})",
            words(s.title),
            s.on(control.name),
        ]
        for s in sources_of(control)
    )
    return "## Sources\n\n" + table(("key", "what it is", "worth here"), rows)
