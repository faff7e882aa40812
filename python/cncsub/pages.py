"""The frame of the pages of HTML: reports, coverage and plots have one head, look and header. A
page needs no network.
"""

from __future__ import annotations

from collections.abc import Iterable
from importlib.resources import files

from cncsub.escapes import escape

_ALLOWED = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'"


def html_page(
    title: str,
    kind: str,
    body: Iterable[str],
    *,
    parts: Iterable[tuple[str, str]] = (),
    style: str = "",
    script: str = "",
    allowed: str = "",
) -> str:
    """Return a whole page. `kind`: what it is, in the header; `parts`: the links of the header,
    each the id of a part and its words; `style` and `script`: what the page needs besides the
    common look; `allowed`: what else its policy allows.
    """
    common = files("cncsub").joinpath("pages.css").read_text("utf-8")
    links = "".join(f'<a href="#{escape(at)}">{escape(words)}</a>' for at, words in parts)
    head = f'<b>cncsub <span class="pale">{escape(kind)}</span></b>'
    run = f"<script>{script}</script>" if script else ""
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{_ALLOWED}{allowed}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(title)}</title><style>{common}{style}</style></head>\n<body>"
        '<a class="skip" href="#main">to the content</a>'
        f'<nav aria-label="Parts">{head}{links}</nav>'
        f'<main id="main"><h1>{escape(title)}</h1>{"".join(body)}</main>{run}</body></html>\n'
    )
