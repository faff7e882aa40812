"""Whatever shows a variable names it as programs of its control write it: R5, not #5."""

import io
import re

import pytest

import cncsub
from cncsub import testing
from cncsub.reports.hints import without_effect
from cncsub.reports.printing import console_on, print_watch
from cncsub.testing.snapshots import told

TEXT = "N10 R5=1\nN20 R5=R5+1\nN30 R6=R5*2\nN40 M30\n"
OTHER = TEXT.replace("R5+1", "R5+3")
HASHES = re.compile(r"#\d")


def one(text=TEXT):
    return cncsub.loads(text, control="siemens-one", name="MAIN.MPF")


def plotted():
    figure = one().run(watch=[5, 6]).watch.plot()
    axes = [figure.layout.yaxis.title.text, figure.layout.yaxis2.title.text]
    return " ".join([figure.layout.title.text, *axes, *(line.name for line in figure.data)])


def of_a_row_that_fails():
    case = testing.case("R5 is 7", control="siemens-one", source="none", program=TEXT, vars={5: 7})
    with pytest.raises(AssertionError) as failed:
        testing.check_case(case)
    return str(failed.value)


def not_read():
    library = one("N10 M30\n")
    return " ".join(note.message for note in without_effect(library, {"variables": {5: 1.0}}))


def without_a_value():
    with pytest.raises(KeyError) as failed:
        del one().machine().variables[7]
    return str(failed.value)


def watched_in_the_terminal():
    shown = io.StringIO()
    print_watch(console_on(shown), one().run(watch=[5, 6]))
    return shown.getvalue()


FACES = {
    "the watch of the terminal": watched_in_the_terminal,
    "the state of a restart": lambda: str(one().resume(at="MAIN:N30").state),
    "the picture of watched variables": plotted,
    "the picture of nothing": lambda: one().run().watch.plot().layout.annotations[0].text,
    "the changes of a new version": lambda: str(cncsub.compare(one(), one(OTHER))),
    "a row that fails": of_a_row_that_fails,
    "a snapshot": lambda: told(one().run()),
    "the notebook": lambda: one().run().variables._repr_html_(),
    "an option without effect": not_read,
    "a variable without a value": without_a_value,
}


@pytest.mark.parametrize("face", FACES)
def test_a_variable_has_the_name_of_its_language(face):
    if face.startswith("the picture"):
        pytest.importorskip("plotly")
    shown = FACES[face]()
    assert re.search(r"\bR\d", shown), shown
    assert not HASHES.search(shown), shown


def test_what_a_loop_waits_for_has_its_name_too():
    text = "N10 LOOP\nN20 IF $A_IN[1]==1\nN30 R1=1\nN40 ENDIF\nN50 ENDLOOP\nN60 M30\n"
    run = one(text).run(max_blocks=10_000)
    assert "$A_IN[1]" in str(run.endless)
    assert not HASHES.search(str(run.endless))
