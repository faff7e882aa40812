"""Reading files, folders and texts as the memory of a control: `load` and `loads`."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from cncsub import _core
from cncsub._core import Control
from cncsub.controls import control_of
from cncsub.files import (
    TEXT,
    CoreFile,
    StrPath,
    check_encoding,
    read_paths,
    shown_and_stem,
    text_pieces,
)
from cncsub.library import Library, read_again
from cncsub.option_errors import carrying
from cncsub.search_path import Search, with_folder, with_search


def load(
    *paths: StrPath,
    control: str | Control,
    external: StrPath | None = None,
    encoding: str | None = None,
    prefer: StrPath | Iterable[StrPath] = (),
    general_only: bool = False,
    search: Search | None = None,
) -> Library:
    """Read files and folders as the memory of a control.

    A folder gives every program file in it and below it; `Library.skipped` lists what is left out.
    `external` is the folder of the external device, which M198 reads. `encoding` is that of
    comments and names; without it, it is detected. Of several programs of one name the first
    counts; `prefer` names files whose programs count before those of the others. `general_only`
    reads and runs every block without the fast paths for common blocks: slower, with the same
    outcome. It shows whether a fast path is to blame for what is seen. `search`: for a control with
    a search path, folders on the disk that stand for folders of the control, `{"CUS.DIR":
    "cycles"}`; they are read too. A folder that has its name on the disk, `CUS.DIR`, needs none.

    Raises `FileNotFoundError` for a missing path and `ValueError` for an unknown control, a folder
    without programs or an unknown encoding; each suggests similar names. A program a control would
    refuse raises nothing: it alarms when it runs. Ctrl-C raises `KeyboardInterrupt`, as anywhere
    else, and nothing is kept.

    >>> import cncsub, pathlib, tempfile
    >>> job = pathlib.Path(tempfile.mkdtemp())
    >>> for name, text in {"O1.nc": "O1\\nM98 P2\\nM30\\n", "O2.nc": "O2\\nM99\\n"}.items():
    ...     _ = (job / name).write_text(text)
    >>> library = cncsub.load(job, control="fanuc-0i-f")
    >>> list(library), library.main.name, library.run().stop
    (['O1', 'O2'], 'O1', <Stop.END: 'end'>)
    """
    return load_with(paths, (), control, external, encoding, prefer, general_only, search)


def load_with(
    paths: Sequence[StrPath],
    siblings: Sequence[StrPath],
    control: str | Control,
    external: StrPath | None = None,
    encoding: str | None = None,
    prefer: StrPath | Iterable[StrPath] = (),
    general_only: bool = False,
    search: Search | None = None,
) -> Library:
    """Read as `load` does, with files beside the paths that nobody named."""
    known = with_search(control_of(control), search)
    if not paths:
        raise ValueError("load needs a file or a folder; loads takes the text of a program")
    paths = [with_folder(path, known) for path in (*paths, *(search or {}).values())]
    siblings = [with_folder(path, known) for path in siblings]
    reading = read_paths(paths, siblings=siblings, encoding=encoding, without=external)
    names = reading.names
    outside, skipped = _external_files(external, encoding)
    rows = reading.rows(False) + outside
    code = _core.compile(known, rows, external is not None, general_only=bool(general_only))
    library = Library(code, names, [*reading.skipped, *skipped])
    return _preferring(library, prefer)


def loads(
    text: str | bytes | Sequence[str | bytes] | Mapping[str, str | bytes],
    control: str | Control,
    external: StrPath | None = None,
    name: str | None = None,
    encoding: str | None = None,
    general_only: bool = False,
) -> Library:
    """Read texts as the memory of a control: one text, a list of texts, or texts by the names of
    their files. A text holds one program or several, as they would stand in a file.

    `name` is what the file of one text would be called; the stem of the name of a file names a
    program that has no name of its own. `external`, `encoding` and `general_only` are as for
    `load`.

    >>> import cncsub
    >>> cncsub.loads("N10 M30\\n", control="gsk-988ta", name="T0023.CNC").main.name
    'T0023'
    >>> library = cncsub.loads(["O1\\nM98 P2\\nM30\\n", "O2\\nM99\\n"], control="fanuc-0i-f")
    >>> list(library), library.files
    (['O1', 'O2'], ('<text 1>', '<text 2>'))
    >>> list(cncsub.loads({"main.nc": "M98 P2\\nM30\\n", "O2": "M99\\n"}, control="fanuc-0i-f"))
    ['main', 'O2']
    """
    known = control_of(control)
    check_encoding(encoding)
    texts = _texts(text, name)
    files: list[CoreFile] = [
        (shown, stem, text_pieces(of, encoding), False) for shown, stem, of in texts
    ]
    outside, skipped = _external_files(external, encoding)
    code = _core.compile(
        known, [*files, *outside], external is not None, general_only=bool(general_only)
    )
    return Library(code, [shown for shown, _, _ in texts], skipped)


def _texts(text: Any, name: object) -> list[tuple[str, str, Any]]:
    """Return the texts that `loads` was given, each with the name of its file and the stem."""
    if isinstance(text, str | bytes | bytearray | memoryview):
        return [(*shown_and_stem(name), text)]
    if isinstance(text, os.PathLike) or not isinstance(text, Sequence | Mapping):
        raise TypeError(
            f"loads needs the text of a program, not {type(text).__name__}; load takes paths"
        )
    if name is not None:
        raise TypeError("name is for one text; give several texts as a mapping from name to text")
    if isinstance(text, Mapping):
        if None in text:
            raise TypeError("the keys must be names of files, not None")
        return [(*shown_and_stem(of), each) for of, each in text.items()]
    return [(f"{TEXT[:-1]} {place}>", "", each) for place, each in enumerate(text, 1)]


def _preferring(library: Library, prefer: StrPath | Iterable[StrPath]) -> Library:
    """Return the memory in which the programs of some files count before those of the others."""
    paths = [prefer] if isinstance(prefer, str | os.PathLike) else list(prefer)
    if not paths:
        return library
    wanted = {os.path.realpath(path) for path in paths}
    preferred = {name for name in library.files if os.path.realpath(name) in wanted}
    if len(preferred) < len(wanted):
        missing = Path(min(wanted - {os.path.realpath(name) for name in preferred}))
        alike = [name for name in library.files if Path(name).name == missing.name]
        near = f"; there is {', '.join(alike)}" if alike else ""
        raise carrying(
            "prefer",
            ValueError(f"prefer is {missing}, which is not one of the files that are read{near}"),
        )
    sources = sorted(library.code.sources, key=lambda source: source[0] not in preferred)
    main = library.main
    return read_again(
        library.control,
        sources,
        library.code.external_device,
        sorted(library.files, key=lambda name: name not in preferred),
        library.left_out,
        None if main is None else main.name,
        library.code.general_only,
    )


def _external_files(
    external: StrPath | None, encoding: str | None
) -> tuple[list[CoreFile], list[tuple[str, str]]]:
    if external is None:
        return [], []
    reading = read_paths([external], encoding=encoding)
    return reading.rows(True), reading.skipped
