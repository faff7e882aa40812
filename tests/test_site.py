"""The pages that the build makes are complete, and their links lead somewhere."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import PurePosixPath

import pytest

import cncsub
import generator
from cncsub import _core
from cncsub.checking import RULES
from cncsub.cli import COMMANDS
from cncsub.controls import inferred_rules
from generator import api, assembling, control_pages, house
from generator.markdown import source_anchor, words


@pytest.fixture(scope="module")
def pages() -> dict[str, str]:
    return assembling.site_pages()


def test_every_control_and_every_cause_has_a_page(pages: dict[str, str]) -> None:
    assert {f"controls/{name}.md" for name in cncsub.controls} <= set(pages)
    assert {f"causes/{slug}.md" for slug in cncsub.causes} <= set(pages)
    assert set(generator.GENERATED) <= set(pages)


def test_a_page_of_a_control_tells_every_rule_parameter_and_alarm(pages: dict[str, str]) -> None:
    for name, control in cncsub.controls.items():
        text = pages[f"controls/{name}.md"]
        for rule in control.rules:
            assert f"\n| `{rule.name}` |" in text, (name, rule.name)
        for parameter in control.parameters:
            assert f"\n| `{parameter}` |" in text, (name, parameter)
        for slug, alarm in control.alarms.items():
            shown = f"`{alarm.number}`" if alarm.number else "-"
            assert f"\n| {shown} | [{slug}](../causes/{slug}.md) |" in text, (name, slug)


def test_each_g_code_of_a_control_is_told_once(pages: dict[str, str]) -> None:
    for name in ("fanuc-30i", "gsk-988ta", "linuxcnc"):
        control = cncsub.controls[name]
        text = pages[f"controls/{name}.md"].partition("## G codes")[2].partition("\n## ")[0]
        for machine, title in control_pages._machines(control):
            part = text.partition(f"### {title}\n")[2].partition("\n### ")[0] if title else text
            told = Counter(re.findall(r"`(G\d+(?:\.\d)?)(?: [^`]*)?`", part))
            assert told == Counter(code for code, _ in _core.g_codes(control, machine))


def test_what_a_code_is_called_is_what_it_does() -> None:
    meanings = dict(_core.g_codes(cncsub.controls["fanuc-0i-f"], "mill"))
    assert meanings["G01"] == "Line"
    assert meanings["G43"] == "LengthPlus"
    assert meanings["G68.2"] == "Uncomputed"
    lathe = dict(_core.g_codes(cncsub.controls["fanuc-0i-f"], "lathe-a"))
    assert (lathe["G92"], lathe["G71"]) == ("ThreadCycle", "RoughTurn")


def test_nearly_every_cause_has_a_program_that_raises_it(pages: dict[str, str]) -> None:
    without = [
        s for s in cncsub.causes if "A program that raises it" not in pages[f"causes/{s}.md"]
    ]
    assert len(without) <= 12, without
    told = pages["causes/repeat-given-twice.md"]
    assert "293 repeat-given-twice" in told
    assert re.search(r"^\| \[gsk-988ta\]\(\S+\) \| `293` \|", told, re.MULTILINE)


def test_every_source_stands_once(pages: dict[str, str]) -> None:
    text = pages["reference/sources.md"]
    anchors = re.findall(r'<a id="([^"]+)">', text)
    assert sorted(anchors) == sorted(source_anchor(key) for key in cncsub.sources)
    assert len(set(anchors)) == len(anchors)


def test_every_rule_of_check_shows_what_it_finds(pages: dict[str, str]) -> None:
    text = pages["reference/check.md"]
    for rule in RULES:
        section = text.partition(f"\n### {rule.number} ")[2].partition("\n### ")[0]
        assert f"{rule.number} {rule.name}" in section
        assert rule.example.strip() in section


def test_every_command_and_public_name_is_told(pages: dict[str, str]) -> None:
    for name in COMMANDS:
        assert f"\n## cncsub {name}\n" in pages["reference/commands.md"]
    assert api.documented() == set(cncsub.__all__) - {"__version__"}


def test_every_written_page_stands_in_the_list_of_contents(pages: dict[str, str]) -> None:
    settings = assembling.settings()
    listed = re.findall(r"^ *- (?:[^:\n]+: )?([\w/-]+\.md)$", settings, re.MULTILINE)
    assert len(listed) == len(set(listed))
    causes = {name for name in pages if re.match(r"causes/(?!index)", name)}
    assert set(listed) == set(pages) - causes  # their index leads to them, and the search


def test_links_lead_to_pages(pages: dict[str, str]) -> None:
    there = {
        *pages,
        *(f.relative_to(assembling.DOCS).as_posix() for f in assembling.DOCS.rglob("*.*")),
    }
    for name, text in pages.items():
        told = re.sub(r"^```.*?^```$|`[^`\n]*`", "", text, flags=re.MULTILINE | re.DOTALL)
        for target in re.findall(r"\]\(([^)\s#]+)[^)]*\)", told):
            if not re.match(r"[a-z]+:", target):
                place = assembling._joined(PurePosixPath(name).parent, target)
                assert place in there, (name, target)


def test_links_of_the_repository_become_those_of_the_site() -> None:
    turned = assembling.for_the_site(
        "[a](../../README.md#x) [b](running.md) ![c](../pictures/path.svg) [d](../../LICENSE)"
        " [e](https://x.y/z)\n```text\n[f](g.md)\n```",
        "docs/guides/setup.md",
    )
    assert turned == (
        "[a](../index.md#x) [b](running.md) ![c](../pictures/path.svg) d (`LICENSE`)"
        " [e](https://x.y/z)\n```text\n[f](g.md)\n```"
    )


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("gsk-988ta", "12, of them 4 macros | count + number | Q | `P[NAME]` | G65, G66 | yes"),
        ("gsk-928te", "18 | N of the same program | - | `%n` | - | -"),
        ("fanuc-0i-f", "10 + 5 | count + number | Q (6005#0) | `<NAME>` | G65, G66, G66.1 | yes"),
        ("hnc-21m", "9 | number | - | `%n` | M98 passes A-Z | -"),
        ("mitsubishi-meldas", "4 of both kinds | number | H | - | G65, G66, G66.1 | -"),
        ("haas-ngc", "9 + 9 | number | - | - | G65 | -"),
    ],
)
def test_the_table_of_controls_says_what_the_rules_do(name: str, wanted: str) -> None:
    rows = control_pages.table_of_controls().splitlines()
    (row,) = (row for row in rows if row.startswith(f"| [`{name}`]"))
    counts = " / ".join(map(str, control_pages.worth(cncsub.controls[name])))
    control = cncsub.controls[name]
    inferred = f"{100 * inferred_rules(control) / len(control.rules):.0f} %"
    assert row.endswith(f"| {wanted} | {counts} | {inferred} |")


def test_the_worth_of_a_control_counts_its_rules_and_their_entries() -> None:
    control = cncsub.controls["gsk-988ta"]
    entries = sum(len(rule.sources) for rule in control.rules)
    assert sum(control_pages.worth(control)) == len(control.rules) + entries


def test_the_drawing_shows_the_arrows_of_the_rooms() -> None:
    arrows = house.arrows()
    assert arrows["text"] == set()
    assert "control" in arrows["code"]
    assert house.drawing().count("<rect") == len(arrows)


def test_words_stay_as_they_are() -> None:
    assert words("a|b `c|d` <e> f_g*h") == "a\\|b `c\\|d` &lt;e&gt; f\\_g\\*h"
