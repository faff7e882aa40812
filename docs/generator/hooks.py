"""What mkdocs calls: puts the pages that are made among the written ones, and turns the links of the
repository into those of the site."""

from __future__ import annotations

import re
import sys
from pathlib import Path, PurePosixPath
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import generator

ROOT = generator.ROOT

# Pages that stand at the head of the repository, and where they stand in the site.
HEAD_PAGES = {
    "README.md": "index.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "SECURITY.md": "security.md",
}
_LINK = re.compile(r"(!?\[[^\]]*\]\()([^)\s#]+)((?:#[^)\s]*)?\))")


def on_config(config: Any) -> Any:
    """Writes out the pages that the list of contents names as `folder/*.md`."""
    config["nav"] = _written_out(config["nav"])
    return config


def _written_out(entries: list[Any]) -> list[Any]:
    listed: list[Any] = []
    for entry in entries:
        if isinstance(entry, dict):
            listed += [
                {title: _written_out(inside) if isinstance(inside, list) else inside}
                for title, inside in entry.items()
            ]
        elif entry.endswith("*.md"):
            folder = entry.removesuffix("*.md")
            made = [name for name in generator.GENERATED if name.startswith(folder)]
            listed += [name for name in made if name not in entries]
        else:
            listed.append(entry)
    return listed


def on_files(files: Any, *, config: Any) -> Any:
    """Adds what is made, and what stands outside the folder of pages."""
    from mkdocs.structure.files import File

    for name, text in generator.pages().items():
        files.append(File.generated(config, name, content=text))
    for source, name in HEAD_PAGES.items():
        text = (ROOT / source).read_text(encoding="utf-8")
        files.append(File.generated(config, name, content=for_the_site(text, source)))
    return files


def on_page_markdown(markdown: str, *, page: Any, config: Any, files: Any) -> str:
    """Fills what a written page leaves open."""
    name = page.file.src_uri
    if name in generator.GENERATED or name in HEAD_PAGES.values():
        return markdown
    return for_the_site(generator.filled(markdown), f"docs/{name}")


def for_the_site(text: str, source: str) -> str:
    """A page of the repository with its links as they are in the site."""
    here = PurePosixPath(_place(source)).parent

    def turned(link: re.Match[str]) -> str:
        target = link[2]
        if re.match(r"[a-z]+:", target):
            return link[0]
        path = _joined(PurePosixPath(source).parent, target)
        if not path.startswith("docs/") and path not in HEAD_PAGES:  # only whoever has the sources sees it
            return f"{link[1].lstrip('!')[1:-2]} (`{path}`)"
        place = _place(path)
        return f"{link[1]}{_from(here, place)}{link[3]}"

    parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
    return "".join(p if p.startswith("```") else _LINK.sub(turned, p) for p in parts)


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
