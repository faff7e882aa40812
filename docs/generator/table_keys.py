"""The keys of tables of cases, for the page of these tables."""

from __future__ import annotations

from cncsub.testing.table_keys import GROUPS
from generator.markdown import code, table, words


def keys() -> str:
    """A table of keys for each group."""
    return "\n".join(
        f"### {group}\n\n"
        + table(
            ("key", "takes", "example", "meaning"),
            (
                [code(key.name), key.words, code(key.example), words(key.meaning)]
                for key in group_keys
            ),
        )
        for group, group_keys in GROUPS.items()
    )
