"""Generated programs of O-words do the same on cncsub and on LinuxCNC, where that is installed.

`python tests/differential/o_words.py --programs 100000 --together 50` does the same with more.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from o_words import MAX_BLOCKS, compare, generate, generate_many, on_cncsub

SEED = 1


@pytest.mark.skipif(
    shutil.which("rs274") is None, reason="rs274 is not installed: Debian package linuxcnc-uspace"
)
@pytest.mark.parametrize(("programs", "together"), [(200, 1), (500, 50)])
def test_programs_of_o_words_do_what_they_do_on_linuxcnc(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], programs: int, together: int
) -> None:
    report = compare(SEED, range(programs), "rs274", tmp_path, together)
    assert report.different == [], capsys.readouterr().out
    assert report.programs > 0.8 * programs
    assert report.moves > 3 * programs
    if together == 1:
        assert {"nesting-too-deep", "illegal-variable", "variable-name-unknown"} <= set(
            report.errors
        )


def test_the_programs_go_over_the_language() -> None:
    text = "\n".join(generate(SEED, place) for place in range(200))
    words = "sub endsub call return if elseif else endif while endwhile do repeat endrepeat break continue"
    assert [word for word in words.split() if f" {word}" not in text] == []
    assert all(
        word in text for word in ("M98 P", "M99", "#<_g>", "#<a>", "exists[", "atan[", "**", "mod")
    )


def test_a_program_of_many_ends() -> None:
    outcome = on_cncsub(generate_many(SEED, range(20)))
    assert outcome is not None
    assert outcome.error == ""
    assert MAX_BLOCKS > len(outcome.moves) > 20
