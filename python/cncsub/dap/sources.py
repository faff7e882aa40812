"""The files of a library as the client sees them: on the disk, or asked for by a reference."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from cncsub import _core
from cncsub.dap.adapter import Adapter
from cncsub.dap.arguments import Arguments, RequestError
from cncsub.debugging import Output
from cncsub.debugging.points import programs_of
from cncsub.program import Block, Program, block_at

_OF_PROGRAM = 1 << 24  # the reference of the first program: below it are those of files
_MOST_TARGETS = 100  # blocks on one line


def source_of(adapter: Adapter, program: Program) -> dict[str, Any]:
    """Return the source of a program: its file, or a reference where it is not on the disk."""
    return source_named(adapter, program.file, program.index)


def source_named(adapter: Adapter, file: str, program: int = -1) -> dict[str, Any]:
    """Return the source of a file of the library; `program` is one of its programs. A file has the
    path by which the client named it.
    """
    if file in adapter.paths:
        return {"name": Path(file).name, "path": adapter.paths[file]}
    code = adapter.running().library.code
    typed = program >= len(code)
    if not typed and Path(file).is_file():
        return {"name": Path(file).name, "path": str(Path(file).absolute())}
    names = [name for name, *_ in code.sources]
    if file in names and not typed:
        return {"name": file, "sourceReference": names.index(file) + 1}
    origin = "typed in MDI" if typed else "the control"
    return {"name": file, "sourceReference": _OF_PROGRAM + program, "origin": origin}


def file_of(source: Arguments) -> str:
    """Return the file or the name that a client means by a source."""
    path = source.text("path", None) or source.text("name", None)
    if not path or "\0" in path:
        raise RequestError("source needs a path")
    return path_of_uri(path)


def path_of_uri(path: str) -> str:
    """Return the path of a `file:` URI, and any other path as it is.

    >>> path_of_uri("file:///job/row%20one.nc"), path_of_uri("row.nc")
    ('/job/row one.nc', 'row.nc')
    """
    return unquote(urlsplit(path).path) if path.startswith("file://") else path


def known_file(code: _core.Code, source: Arguments) -> str:
    """Return the file of the library that a source means; the name as it is where none is."""
    if found := _referred(code, source.number("sourceReference", 0)):
        return found[0]
    file = file_of(source)
    programs = programs_of(code, file)
    return programs[0].file if programs else file


def _referred(code: _core.Code, reference: int) -> tuple[str, str] | None:
    """Return the file and the text that a `sourceReference` means, `None` where it means none."""
    if reference <= 0:
        return None
    sources = code.sources
    if reference <= len(sources):
        name, _, text, _ = sources[reference - 1]
        return name, text.decode("utf-8", "replace")
    if 0 <= (index := reference - _OF_PROGRAM) < len(code):
        program = code.program(index)
        return program.file, program.text
    return None


def source(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Answer with the text of a file of the library, and of no other."""
    code = adapter.running().machine.core.code
    asked = arguments.table("source", {})
    reference = arguments.number("sourceReference", 0) or asked.number("sourceReference", 0)
    if found := _referred(code, reference):
        return {"content": found[1]}
    if reference == 0:
        file = known_file(code, asked)
        texts = {name: text for name, _, text, _ in code.sources}
        if file in texts:
            return {"content": texts[file].decode("utf-8", "replace")}
    raise RequestError("there is no such source among the files of the programs")


def loaded_sources(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    code = adapter.running().library.code
    return {"sources": [source_named(adapter, name) for name, *_ in code.sources]}


def goto_targets(adapter: Adapter, arguments: Arguments) -> dict[str, Any]:
    """Answer with the blocks on a line; which of them can be the next one, `goto` says."""
    machine, line = adapter.running().machine, adapter.line_in(arguments.number("line"))
    code = machine.core.code
    file = known_file(code, arguments.table("source"))
    found = [
        (address, block_at(code, address))
        for program in programs_of(code, file)
        for address in machine.core.blocks_at(program.index, -1, line)
    ]
    if not found:
        raise RequestError(f"line {adapter.line_out(line)} of {Path(file).name} has no block")
    return {
        "targets": [
            {
                "id": address + 1,
                "label": f"{block.program.name} {block.text.strip()}",
                "line": adapter.line_out(block.line),
            }
            for address, block in found[:_MOST_TARGETS]
        ]
    }


def target(adapter: Adapter, number: int) -> Block:
    """Return the block that a target is."""
    try:
        return block_at(adapter.running().machine.core.code, number - 1)
    except (IndexError, TypeError):
        raise RequestError(f"there is no target {number}: ask for gotoTargets") from None


def write_output(adapter: Adapter, output: Output) -> None:
    """Show what the program or a log point wrote, as it is written."""
    body: dict[str, Any] = {
        "category": "stdout" if output.kind == "message" else "console",
        "output": f"{output.text}\n",
    }
    if output.line:
        body["source"] = source_named(adapter, output.file)
        body["line"] = adapter.line_out(output.line)
    adapter.event("output", body)
