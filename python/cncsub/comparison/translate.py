"""Programs rewritten for another control so that they do the same, proved by running both."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Unpack

from cncsub._core import Control, variable_name
from cncsub.analysis.pairs import Pair, variables_lacking
from cncsub.checking import Edit
from cncsub.comparison.rewriting import Rewriting, TranslateError
from cncsub.controls import control_of
from cncsub.inputs import by_number
from cncsub.library import Library
from cncsub.lines import diff_of
from cncsub.loading import load
from cncsub.run import Run, Stop
from cncsub.run_options import MdiOptions, takes
from cncsub.setup import machine_of
from cncsub.writing import write_whole


@dataclass(frozen=True)
class Translation:
    """Programs that make another control do what the first one did, as a run of both has shown.

    `library`: the programs as the memory of the other control. `edits`: what changed in each
    program, by its name; an edit whose `new` has several lines adds blocks. `added`: programs that
    were made, name to text; they stand at the end of the file they were taken from. `texts`: every
    file that changed, whole. `unproved`: blocks whose call or jump is computed, as `O1, line 4`:
    they stay as they are, and are the same in this run only. `runs`: both runs.
    """

    library: Library
    edits: Mapping[str, tuple[Edit, ...]]
    added: Mapping[str, str]
    texts: Mapping[str, str]
    unproved: tuple[str, ...]
    runs: tuple[Run, Run] = field(repr=False)
    _before: Mapping[str, str] = field(repr=False)

    def diff(self) -> str:
        """Return the changes as a unified diff; empty where nothing had to change."""
        texts = self.texts.items()
        return "".join(diff_of(self._before[file], text, file) for file, text in texts)

    def write(self, folder: str | os.PathLike[str]) -> list[str]:
        """Write all files, changed or not, into a folder, which is made where it is missing; return
        their paths. The files are UTF-8 with a line feed after each line. Raises `ValueError` where
        a file that was read would be overwritten.
        """
        into = Path(folder)
        whole = {**self._before, **self.texts}
        paths = [Path(name) for name in whole]
        top = Path(os.path.commonpath([path.parent for path in paths])) if paths else Path()
        written = []
        for path, text in zip(paths, whole.values(), strict=True):
            own = path.relative_to(top) if path.name != "<text>" else Path("program.nc")
            target = into / own
            if target.exists() and path.exists() and target.samefile(path):
                raise ValueError(f"{path} was read: give another folder")
            target.parent.mkdir(parents=True, exist_ok=True)
            write_whole(target, text.encode("utf-8", "surrogateescape"))
            written.append(str(target))
        return written


@takes(MdiOptions)
def translate(
    of: Library | str | os.PathLike[str],
    to: str | Control,
    *,
    control: str | Control | None = None,
    main: str | int | None = None,
    **options: Unpack[MdiOptions],
) -> Translation:
    """Rewrite calls of programs so that control `to` does what the control of `of` did.

    The rewriting covers the count in P and in L, the start block in H and in Q, calls of a block of
    the same program (M97, M98 H) as programs of their own, M99 P, and how often a drilling cycle is
    repeated, in K and in L. `of`: a library, or a path, which `control` reads. `main` and `options`
    are those of `Library.run`; both programs are run with them, and have to make the same moves,
    codes, messages and variables and to stop alike. The proof holds for this run. Raises
    `TranslateError` for what cannot be rewritten, does not do the same, or does not come to its
    end, with the block and the reason; and what `load` and `run` raise.

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P30002\\nN20 M30\\nO2\\nN30 G91 G0 X1.\\nN40 M99\\n"
    >>> made = cncsub.translate(cncsub.loads(text, control="fanuc-0i-f"), "mitsubishi-m700")
    >>> made.library["O1"].blocks[0].text
    'N10 M98 P2 L3'
    """
    if options.get("trace", "moves") != "moves":
        raise TypeError("translate records all that a run does; leave out trace")
    target = control_of(to)
    if isinstance(of, Library):
        library = of
    elif control is None:
        raise TypeError(f"translate reads {os.fspath(of)} for a control: give control=")
    else:
        library = load(of, control=control)
    if lacking := variables_lacking(
        target, by_number("variables", target, options.get("variables") or {})
    ):
        name = variable_name(target, lacking[0])
        raise TranslateError(f"{target.name} has no {name}, to which a value is given")
    rewriting = Rewriting(library, target, machine_of(options.get("setup")))
    rewriting.rewrite()
    return _proved(rewriting, main, options)


def _proved(rewriting: Rewriting, main: str | int | None, options: MdiOptions) -> Translation:
    source = rewriting.library
    made = rewriting.made()
    names = (source.control.name, rewriting.target.name)
    pair = Pair("translated", (source, made), names, main, options)
    first = pair.run(0)
    if first.stop not in (Stop.END, Stop.CYCLES):
        reached = first.alarm or first.steps[len(first.steps) - 1]
        reason = (
            f"{source.control.name} does not run to its end, so the translation cannot be proved: "
        )
        reason += first.summary()
        raise TranslateError(reason, reached.program, reached.n, reached.line)
    try:
        second = pair.run(1)
    except KeyError as error:
        reason = f"{rewriting.target.name} reads the programs differently: {error.args[0]}"
        raise TranslateError(reason) from None
    parting = pair.parting(first, second)
    if parting is not None:
        at = first.steps[min(parting.first, len(first.steps) - 1)]
        reason = f"rewritten, it does not do the same:\n{parting.what}"
        raise TranslateError(reason, at.program, at.n, at.line)
    return Translation(
        made,
        {name: tuple(edits) for name, edits in rewriting.edits.items()},
        {name: made[name].text for name in rewriting.added_names()},
        rewriting.texts(),
        tuple(rewriting.unproved),
        (first, second),
        rewriting.before(),
    )
