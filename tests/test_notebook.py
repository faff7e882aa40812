"""What a notebook shows: bounded pages of HTML without scripts."""

from __future__ import annotations

import re

import pytest

import cncsub

CONTROL = "fanuc-0i-f"


def text_of(html: str) -> str:
    return re.sub(r"<[^>]*>", "", html)


@pytest.fixture
def library() -> cncsub.Library:
    text = "O1 (PART <1>)\nN10 M98 P2 L2\nN20 G1 X10. F100 (CUT)\nN30 M98 P7\nO2\nN5 G0 Z5.\nM99\n"
    return cncsub.loads(text, control=CONTROL, name="part.nc")


def test_a_run_shows_how_it_ended_and_what_it_called(library: cncsub.Library) -> None:
    html = library.run()._repr_html_()
    shown = text_of(html)
    assert shown.startswith("stopped: alarm, 6 blocks, 3 moves, ")
    assert "PS0076 program-not-found" in shown
    assert "N30 M98 P7" in shown
    assert "^^" in shown
    assert "M98 O2, 2 passes (4 blocks)" in shown
    assert "<td>X</td><td>0</td><td>10</td>" in html


def test_a_run_that_does_not_end_says_why() -> None:
    run = cncsub.loads("O1\nN10 #1=1\nN20 GOTO 10\n", control=CONTROL).run(max_blocks=50)
    assert "an endless loop, proven" in run._repr_html_()


def test_messages_are_few(library: cncsub.Library) -> None:
    text = "O1\nPOPEN\n" + "DPRNT[A]\n" * 30 + "M30\n"
    shown = text_of(cncsub.loads(text, control=CONTROL).run()._repr_html_())
    assert shown.count("message: A") == 8
    assert "... and 22 more" in shown


def test_a_memory_shows_its_programs_and_notes() -> None:
    many = "".join(f"O{i} (P{i})\nM99\n" for i in range(1, 31)) + "O3\nM30\n"
    html = cncsub.loads(many, control=CONTROL)._repr_html_()
    assert text_of(html).startswith("FANUC Series 0i-F: 30 programs")
    assert html.count("<tr>") == 21
    assert "O1 (main)" in html
    assert "... and 10 more" in html
    assert "note: " in html


def test_a_program_shows_its_lines(library: cncsub.Library) -> None:
    html = library["O1"]._repr_html_()
    assert '<span style="opacity:.55">(CUT)</span>' in html
    assert "(PART &lt;1&gt;)" in html
    lines = text_of(html).splitlines()
    assert lines[0] == "O1, part.nc:1, 3 blocks     1  O1 (PART &lt;1&gt;)"
    assert lines[-1] == "     4  N30 M98 P7"


def test_of_a_long_program_the_middle_is_left_out() -> None:
    text = "O1\n" + "".join(f"N{i} G4 X1.\n" for i in range(1, 101)) + "M30" + "(" + "x" * 5000
    html = cncsub.loads(text, control="gsk-988ta")["O1"]._repr_html_()
    assert len(html) < 10_000
    assert "... 62 lines" in text_of(html)


def test_the_calls_are_a_tree(library: cncsub.Library) -> None:
    assert text_of(library.run().calls._repr_html_()).splitlines()[-1] == "1 call"
