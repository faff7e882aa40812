"""Looks at a site that was built: it has every page, its links lead somewhere, and it loads nothing
from elsewhere.

python tools/check_site.py build/docs/site
"""

from __future__ import annotations

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "docs"))

# What a browser loads by itself.
_LOADED = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href"}


class _Page(HTMLParser):
    """The links, the names that links may lead to, and what is loaded."""

    def __init__(self) -> None:
        super().__init__()
        self.links: list[str] = []
        self.names: set[str] = {""}
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        told = dict(attrs)
        for name in ("id", "name"):
            if told.get(name):
                self.names.add(str(told[name]))
        if tag == "a" and told.get("href"):
            self.links.append(str(told["href"]))
        target = told.get(_LOADED.get(tag, ""))
        if target and told.get("rel") not in ("canonical", "next", "prev"):
            self.loaded.append(target)


def faults(site: Path, wanted: set[str]) -> list[str]:
    """What is wrong, a line each."""
    pages = {file: _Page() for file in sorted(site.rglob("*.html"))}
    for file, page in pages.items():
        page.feed(file.read_text(encoding="utf-8"))
    built = {file.relative_to(site).as_posix() for file in pages}
    found = [f"{name}: is missing" for name in sorted(wanted - built)]
    for file, page in pages.items():
        name = file.relative_to(site)
        found += [f"{name}: loads {at}" for at in page.loaded if urlsplit(at).netloc]
        if name.name == "404.html":
            continue  # of a server, which shows it in any folder
        found += [f"{name}: leads to {at}" for at in page.links if not _leads(at, file, pages)]
    for style in site.rglob("*.css"):
        text = style.read_text(encoding="utf-8")
        found += [
            f"{style}: loads {at}" for at in re.findall(r"url\(\s*[\"']?(https?:[^)\"']+)", text)
        ]
    return found


def _leads(link: str, file: Path, pages: dict[Path, _Page]) -> bool:
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return True
    target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
    if target in pages:
        return unquote(parts.fragment) in pages[target].names
    return target.is_file()


def main() -> int:
    from generator.assembling import site_pages

    site = Path(sys.argv[1]).resolve()
    wanted = {f"{name.removesuffix('.md')}.html" for name in site_pages()}
    found = faults(site, wanted)
    print("\n".join([*found, f"{len(wanted)} pages, {len(found)} faults"]))
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
