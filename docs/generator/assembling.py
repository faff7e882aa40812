"""The pages of the site, written and made, in one folder that a builder takes: links of the
repository become those of the site, and the list of contents is written out."""

from __future__ import annotations

import re
import shutil
from pathlib import Path, PurePosixPath

import generator

DOCS = generator.ROOT / "docs"
_NOT_OF_THE_SITE = ("generator", "playground", "site.yml")

# Pages that stand at the head of the repository, and where they stand in the site.
HEAD_PAGES = {
    "README.md": "index.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "SECURITY.md": "security.md",
}
_LINK = re.compile(r"!?\[([^\]]*)\]\(([^)\s#]+)((?:#[^)\s]*)?)\)")
_FENCE = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)


def assemble(folder: Path) -> None:
    """Write `folder/pages` and `folder/mkdocs.yml` anew."""
    pages = folder / "pages"
    shutil.rmtree(pages, ignore_errors=True)
    shutil.copytree(DOCS, pages, ignore=shutil.ignore_patterns(*_NOT_OF_THE_SITE))
    for name, text in site_pages().items():
        file = pages / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    (folder / "mkdocs.yml").write_text(settings(), encoding="utf-8")


def site_pages() -> dict[str, str]:
    """Every page of the site by its path."""
    written = {
        file.relative_to(DOCS).as_posix(): generator.filled(file.read_text(encoding="utf-8"))
        for file in sorted(DOCS.rglob("*.md"))
    }
    told = {name: for_the_site(text, f"docs/{name}") for name, text in written.items()}
    for source, name in HEAD_PAGES.items():
        told[name] = for_the_site((generator.ROOT / source).read_text(encoding="utf-8"), source)
    return {**told, **generator.pages()}


def settings() -> str:
    """`site.yml` with the pages that it names as `folder/*.md` written out."""
    text = (DOCS / "site.yml").read_text(encoding="utf-8")

    def listed(line: re.Match[str]) -> str:
        made = (name for name in generator.GENERATED if name.startswith(line[2]))
        others = (name for name in made if f"- {name}\n" not in text)
        return "".join(f"{line[1]}- {name}\n" for name in others)

    return re.sub(r"^( *)- ([\w/]+/)\*\.md\n", listed, text, flags=re.MULTILINE)


# ---- links ----


def for_the_site(text: str, source: str) -> str:
    """A page of the repository with its links as they are in the site."""
    here = PurePosixPath(_place(source)).parent

    def turned(link: re.Match[str]) -> str:
        words, target, anchor = link.groups()
        if re.match(r"[a-z]+:", target):
            return link[0]
        path = _joined(PurePosixPath(source).parent, target)
        if not path.startswith("docs/") and path not in HEAD_PAGES:
            return f"{words} (`{path}`)"  # only whoever has the sources sees it
        start = link[0][: link[0].index("(") + 1]
        return f"{start}{_from(here, _place(path))}{anchor})"

    parts = _FENCE.split(text)
    return "".join(part if part.startswith("```") else _LINK.sub(turned, part) for part in parts)


def _place(path: str) -> str:
    """Where a file of the repository stands in the site."""
    return HEAD_PAGES.get(path, path.removeprefix("docs/"))


def _joined(folder: PurePosixPath, target: str) -> str:
    parts: list[str] = list(folder.parts)
    for part in PurePosixPath(target).parts:
        if part == "..":
            parts.pop()
        else:
            parts.append(part)
    return "/".join(parts)


def _from(folder: PurePosixPath, place: str) -> str:
    ups, parts = list(folder.parts), place.split("/")
    while ups and parts[:-1] and ups[0] == parts[0]:
        ups.pop(0)
        parts.pop(0)
    return "../" * len(ups) + "/".join(parts)
