"""A gate for the output of post processors: every file is checked and run, and passes or not."""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from cncsub._core import Control
from cncsub.archive.gating import Allowed, gate_finding, options_of_run
from cncsub.archive.many import LIMITS, Crew, Paths, jobs_of, listed_paths, task_of
from cncsub.archive.work import do_chunk
from cncsub.checking import Finding
from cncsub.files import StrPath
from cncsub.loading import loads
from cncsub.setup import Setup


def read_allow_list(path: StrPath) -> tuple[Allowed, ...]:
    """Read an allow list: an entry a line, `WHAT` or `WHAT FILES`; `#` begins a comment.

    Raises `ValueError` for a line of more words, naming it, and `OSError` for a missing file.

    >>> import pathlib, tempfile
    >>> from cncsub.archive.gate import read_allow_list
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "allow.txt"
    >>> _ = file.write_text("G187  # smoothness\\nno-decimal-point draft-*.nc\\n")
    >>> read_allow_list(file)[1]
    Allowed(what='no-decimal-point', files='draft-*.nc', line=2)
    """
    entries = []
    text = Path(path).read_text(encoding="utf-8-sig", errors="replace")
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split("#")[0].split() if not line.startswith("#") else []
        if len(words) > 2:
            raise ValueError(
                f"{path}:{number}: an entry is WHAT or WHAT FILES, not {line.strip()!r}"
            )
        if words:
            entries.append(Allowed(words[0], words[1] if len(words) > 1 else "*", number))
    return tuple(entries)


class GatedFile(NamedTuple):
    """A file at the gate. `findings`: what the allow list does not let pass; `allowed`: what it
    does; `fault`: why the file cannot be read, or is in a language of no control, which is a
    finding too.
    """

    path: str
    findings: tuple[Finding, ...]
    allowed: tuple[Finding, ...]
    fault: str | None

    def passes(self, fails: Iterable[str] = ("error",)) -> bool:
        """Return whether the file passes where findings of these severities fail."""
        return self.fault is None and not any(f.severity in fails for f in self.findings)


@dataclass(frozen=True)
class Gate:
    """The files at a gate, in the order of the paths; `unused`: entries of the allow list that let
    nothing pass; `skipped`: how many files of the folders are no programs, by reason.
    """

    files: tuple[GatedFile, ...]
    unused: tuple[Allowed, ...]
    skipped: Mapping[str, int]


def gate(
    paths: Paths,
    control: str | Control,
    *,
    allow: StrPath | Sequence[Allowed] = (),
    each: str = "file",
    external: StrPath | None = None,
    encoding: str | None = None,
    setup: Setup | Mapping[str, Any] | None = None,
    rules: Iterable[str] | None = None,
    entry: Iterable[str] = (),
    executor: Executor | None = None,
    jobs: int | None = None,
    **limits: Any,
) -> Gate:
    """Check and run every program file of some files and folders: refused and not computed codes,
    missing heads and ends, the alarm of a dry run, and with limits in `setup` the ends of travel.

    `allow`: an allow list, or the file of one: see `read_allow_list`. A block with a code that it
    allows is left out of the dry run, which would stop there. `rules` and `entry` are those
    of `Library.check`; `each`, `external`, `encoding`, `executor` and `jobs` are as for `run_many`;
    `limits` are options of `Library.run`, without which a run may take 1,000,000 blocks, 10 seconds
    and 512 MiB. What `check` tells as not computed is an error here.

    Raises `ValueError` and `TypeError` for wrong options, `FileNotFoundError` for a path that leads
    nowhere. A file that is there and cannot be read is one that does not pass.

    >>> import pathlib, tempfile
    >>> from cncsub.archive.gate import gate
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "part.nc"
    >>> _ = file.write_text("%\\nO1\\nG0 X1.\\nG987\\nM30\\n%\\n")
    >>> [(found.rule, found.word) for found in gate([file], "fanuc-0i-f").files[0].findings]
    [('CS102', 'G987')]
    """
    given = listed_paths(paths)
    for path in given:
        if not os.path.lexists(path):
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(path))
    options: dict[str, Any] = {**LIMITS, **limits}
    entries = read_allow_list(allow) if isinstance(allow, str | os.PathLike) else tuple(allow)
    asked = {
        "rules": rules,
        "setup": setup,
        "entry": tuple(entry) or None,
        "allow": entries or None,
    }
    options.update({name: value for name, value in asked.items() if value is not None})
    task = task_of("gate", control, each, external, encoding, options)
    library = loads("", control=task.control, external=external)
    library.check(rules=rules, setup=setup, entry=entry)  # wrong options are told now
    library.run(**options_of_run(options))
    skipped: dict[str, int] = {}
    rows: dict[int, list[tuple[str, list[Any]]]] = {}
    with contextlib.closing(Crew(executor, jobs)) as crew:
        for number, chunk, done in crew.done(do_chunk, task, jobs_of(given, each, skipped)):
            rows[number] = [(job.path, found) for job, found in zip(chunk, done, strict=True)]
    used: set[Allowed] = set()
    files = [_file(path, found, entries, used) for n in sorted(rows) for path, found in rows[n]]
    unused = tuple(entry for entry in entries if entry not in used)
    return Gate(tuple(files), unused, skipped)


def _file(
    path: str, rows: Sequence[Any], entries: Sequence[Allowed], used: set[Allowed]
) -> GatedFile:
    findings: list[Finding] = []
    allowed: list[Finding] = []
    fault = None
    for row in rows:
        if row[2] != "finding":
            fault = f"{row[2]}: {row[-1]}"
            findings.append(gate_finding("unreadable", "", 1, path, "", message=fault))
            continue
        letting = [entry for entry in entries if entry.allows(row[-1].file, row[-1])]
        used.update(letting)
        (allowed if letting else findings).append(row[-1])
    return GatedFile(path, tuple(findings), tuple(allowed), fault)
