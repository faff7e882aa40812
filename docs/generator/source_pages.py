"""The sources, each key once."""

from __future__ import annotations

import cncsub
from cncsub.controls import EVIDENCE, sources_of
from generator.markdown import code, source_anchor, table, words

_PAGE = "reference/sources.md"

_HEAD = """\
# Sources

Every rule, parameter and alarm of a control cites its source by a key of this page
(`cncsub.sources` holds them all). The evidence given here holds on the controls that the source is
about; on any other control the source is secondary at best:

| evidence | what it is |
| --- | --- |
| source document | one of the documents that the project was made from |
| maker's manual | a manual of the maker, of this very control |
| secondary | a book, a forum, a clone, a relative of the control |
| inferred | general knowledge, or our choice where no source says anything |

"""


def names() -> list[str]:
    return [_PAGE]


def pages() -> dict[str, str]:
    users = {key: [] for key in cncsub.sources}  # type: dict[str, list[str]]
    for control in cncsub.controls.values():
        for source in sources_of(control):
            users[source.key].append(control.name)
    text = _HEAD
    for strength in EVIDENCE:
        found = [source for source in cncsub.sources.values() if source.evidence == strength]
        if not found:
            continue
        rows = (_row(source, users[source.key]) for source in found)
        text += f"## {strength[0].upper()}{strength[1:]}\n\n"
        text += table(("key", "what it is", "about", "cited by"), rows) + "\n"
    return {_PAGE: text}


def _row(source: cncsub.Source, users: list[str]) -> list[str]:
    at = source.address
    title = f"[{words(source.title)}]({at})" if at.startswith("http") else words(source.title)
    if at and not at.startswith("http"):
        title += f" ({words(at)})"
    return [
        f'<a id="{source_anchor(source.key)}"></a>{code(source.key)}',
        title,
        ", ".join(_linked(name) for name in source.controls) or "-",
        ", ".join(_linked(name) for name in users) or "-",
    ]


def _linked(name: str) -> str:
    return f"[{name}](../controls/{name}.md)" if name in cncsub.controls else code(name)
