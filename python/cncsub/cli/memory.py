"""The programs that the options of a command name, read as the memory of its control."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import cncsub
from cncsub.analysis.notes import Note, program_in_its_place, same_blocks
from cncsub.cli.options import control_for, search_of
from cncsub.cli.output import tell_all
from cncsub.cli.project import PLACES, Project, project_for
from cncsub.loading import load_with
from cncsub.program import named_like
from cncsub.sibling_files import with_files_beside

_WRITTEN = ("output", "html", "lcov", "cobertura")  # options that name a file to write
_READ = ("setup", "inputs", "variables")  # options that name a file to read beside the programs


def library_of(options: Mapping[str, Any]) -> cncsub.Library:
    library = _read(options)
    written = [Path(path) for name in _WRITTEN if (path := options.get(name)) is not None]
    project = project_for(options.get("paths")) if written else Project()
    read: list[str | Path] = [*library.files, *_files_beside_programs(options, project)]
    external = options.get("external") or project.places.get("external")
    for place, path in enumerate(written):
        _refuse_to_overwrite(path, read, written[:place], external)
    return library


def _files_beside_programs(options: Mapping[str, Any], project: Project) -> list[Path]:
    """Return the files of setup, inputs and variables that the options or the project name, and the
    file of the project itself.
    """
    named = [options.get(name) or project.places.get(name) for name in _READ]
    return [Path(path) for path in (*named, project.file) if path is not None]


def _refuse_to_overwrite(
    path: Path, read: Sequence[str | Path], written: Sequence[Path], external: Path | None
) -> None:
    """Refuse to write over a file that was read, whatever name it goes by, or to write
    one twice.
    """
    real = Path(os.path.realpath(path))
    if str(path) == "-":
        raise ValueError(
            "- cannot be written as a file; without -o the output goes to the standard output"
        )
    if any(real == Path(os.path.realpath(other)) for other in written):
        raise ValueError(f"{path} cannot be written twice; give a different file for each output")
    if not path.exists():
        return
    for other in read:
        if Path(other).exists() and path.samefile(other):
            what = "the program" if str(path) == str(other) else f"{other}, which was read"
            raise ValueError(f"{path} is {what}; give another file for the output")
    if external is not None and real.is_relative_to(os.path.realpath(external)):
        raise ValueError(f"{path} is a file of the external device; give another file")


def _read(options: Mapping[str, Any]) -> cncsub.Library:
    project = project_for(options.get("paths"))
    places: dict[str, Any] = {
        "control": control_for(options, project),
        "external": options["external"] or project.external,
    }
    paths = options["paths"] or project.folders
    searched = list(search_of(options).values())
    if options.get("prefer") and (not paths or paths == ["-"]):
        raise ValueError("--prefer chooses between files: give the files or folders to read")
    if "-" in paths and len(paths) > 1:
        raise ValueError(
            "- is the standard input, which is read alone: leave out either - or the files"
        )
    if paths == ["-"]:
        text = sys.stdin.buffer.read()
        return cncsub.loads(text, encoding=options["encoding"], **places)
    if paths:
        prefer = options.get("prefer") or ()

        def load(named: Sequence[str], siblings: Sequence[str] = ()) -> cncsub.Library:
            wanted = {"encoding": options["encoding"], "prefer": prefer, **places}
            return load_with(named, siblings, **wanted)

        _refuse_words_of_mdi(options["paths"] or (), options["mdi"])
        if searched or not _is_one_file(paths):
            return load([*paths, *searched])
        return with_files_beside(paths[0], load)
    if options["mdi"] is None:
        raise ValueError("which program? Give a file, a folder or --mdi")
    return cncsub.loads("", **places)


def _refuse_words_of_mdi(paths: Sequence[str], mdi: str | None) -> None:
    """Refuse words split off by the shell: it makes a text and a file of `--mdi G65 P9100`."""
    word = next((p for p in paths if re.fullmatch(r"[A-Z][-+.\d]+", p, re.I)), None)
    if mdi is not None and word is not None and not Path(word).exists():
        whole = f'--mdi "{mdi} {word}"'
        raise ValueError(f"{word}: no such file; put quotes around a text with blanks: {whole}")


def _is_one_file(paths: Sequence[str]) -> bool:
    return len(paths) == 1 and Path(paths[0]).is_file()


def files_beside(options: Mapping[str, Any], library: cncsub.Library) -> list[str]:
    """Return the files that were read because the named file calls their programs."""
    return list(library.files[1:]) if _is_one_file(options["paths"] or ()) else []


def notes_on(options: Mapping[str, Any], library: cncsub.Library) -> list[Note]:
    """Return the notes on a memory, except on files that the options name themselves."""
    project = project_for(options.get("paths"))
    known = {os.path.realpath(file) for file in _files_beside_programs(options, project)}
    siblings = [
        Note("beside", "also read, because a call names its program", file)
        for file in files_beside(options, library)
    ]
    return [*defaulted(options), *outside(options, project), *siblings] + [
        note
        for note in library.notes
        if note.kind != "left-out" or os.path.realpath(note.file) not in known
    ]


def defaulted(options: Mapping[str, Any]) -> Iterator[Note]:
    """Yield a note where the control is the project's, because no option named one."""
    project = project_for(options.get("paths"))
    if options["control"] is None and project.control is not None:
        told = f"the control is {project.control}, from the project file"
        yield Note("defaulted", told, str(project.file))


def outside(options: Mapping[str, Any], project: Project) -> Iterator[Note]:
    """Yield a note for each file and folder that the project names outside its own folder."""
    places = [
        (name, place)
        for name in PLACES
        if name in options and options[name] is None and (place := project.outside(name))
    ]
    if not options.get("paths"):
        places += [("folders", place) for place in project.programs_outside]
    for name, place in places:
        told = f"the project file gives it as {name}, and it is outside the folder of the project"
        yield Note("outside", told, str(place))


def idle_entries(
    options: Mapping[str, Any], project: Project, libraries: Sequence[cncsub.Library]
) -> Iterator[Note]:
    """Yield a note for each entry of the project that is the name of none of its programs."""
    for pattern in () if options.get("paths") else project.entry:
        if not any(named_like(library.code, [pattern]) for library in libraries):
            yield Note(
                "no-effect", "no program has such a name", f"entry {pattern} of {project.file}"
            )


def typed_in(run: cncsub.Run) -> cncsub.Program:
    """Return what was typed in MDI, as a program: the last one of the memory."""
    code = run.core.code
    return cncsub.Program(code.program(len(code) - 1), len(code) - 1)


def memory_of(
    options: Mapping[str, Any], tell: Callable[[Sequence[Note]], None] | None = None
) -> cncsub.Library:
    """Return the library as `library_of` does, for a run. The notes are reported on the error
    stream, or by `tell`. Of two different programs of one number one has to be chosen, because a
    control's memory holds only one.
    """
    library = library_of(options)
    chosen = {os.path.realpath(path) for path in options.get("prefer") or ()}
    for program in library.duplicates:
        counts = program_in_its_place(library, program)
        if os.path.realpath(counts.file) not in chosen and not same_blocks(program, counts):
            places = f"{counts.file}:{counts.line} and {program.file}:{program.line}"
            cure = _cure_of_two(library, program, counts)
            raise ValueError(f"{counts.name} exists twice with different blocks: {places}; {cure}")
    notes = notes_on(options, library)
    if notes:
        (tell or tell_all)(notes)
    return library


def _cure_of_two(library: cncsub.Library, program: cncsub.Program, counts: cncsub.Program) -> str:
    """Return what makes one of two programs of one name the only one."""
    from cncsub.reports.hints import other_reading

    if program.file != counts.file:
        return f"choose one with --prefer {counts.file}, or leave a file out"
    return other_reading(library, program.file) or "remove one of them"
