"""Edits of programs: new sequence numbers, another layout, other names, each proved by a run."""

from cncsub.checking import Edit
from cncsub.editing.edits import Edits
from cncsub.editing.errors import EditError
from cncsub.editing.formatting import format
from cncsub.editing.mentions import Mention, mention_at, mentions
from cncsub.editing.renaming import rename
from cncsub.editing.renumbering import renumber

__all__ = [
    "Edit",
    "EditError",
    "Edits",
    "Mention",
    "format",
    "mention_at",
    "mentions",
    "rename",
    "renumber",
]
