"""What an editor is told of programs: each answer from one version of a memory."""

from __future__ import annotations

from pathlib import Path

import pytest
from lsprotocol import types

from cncsub.editing import EditError
from cncsub.editor import completing, explaining, navigation, rewriting, shown, symbols
from cncsub.editor.diagnostics import actions, diagnostics
from cncsub.editor.documents import Document, character_of, split, units_before
from cncsub.editor.memory import Memories, Settings
from cncsub.editor.project_names import names_at
from cncsub.editor.snapshot import Snapshot

CONTROL = "fanuc-0i-f"
SIEMENS = "siemens-840d-sl"
PATH = "/nowhere/part.nc"
TEXT = """\
O1 (MAIN)
(ROUGHING)
N10 T1 M6
N20 G65 P2 A5. B#100
N30 M98 P30003
#100=#100+1
IF[#100LT3]GOTO20
N40 G1 X[#100*2] F100
N50 M98 P77
N60 M30
O2 (MACRO)
#101=#1 (DEPTH)
#102=#2+#1 (WIDTH)
WHILE[#1GT0]DO1
#1=#1-1
END1
M99
O3
G91 G0 X1.
M99
"""


def snapshot(text: str = TEXT, control: str = CONTROL, path: str = PATH) -> Snapshot:
    memories = Memories(settings=Settings(control))
    memories.put(path, Document.of(text))
    snap = memories.snapshot(path)
    assert snap is not None
    return snap


def at(snap: Snapshot, line: int, word: str, path: str = PATH) -> tuple[int, int]:
    """Return the place of a word on a line, both from 0."""
    return line, snap.document(path).line(line).index(word)


def defined(word: str, line: int, text: str = TEXT, control: str = CONTROL) -> list[str]:
    snap = snapshot(text, control)
    found = navigation.definition(snap, PATH, *at(snap, line, word))
    return [f"{each.range.start.line}:{each.range.start.character}" for each in found]


# ---- names ----


@pytest.mark.parametrize(
    ("line", "word", "leads_to"),
    [
        (3, "P2", ["10:0"]),  # the macro
        (3, "G65", ["10:0"]),
        (4, "P30003", ["17:0"]),  # three times O3
        (6, "20", ["3:0"]),  # the block that GOTO names
        (6, "#100", ["5:1"]),  # the last writer before
        (
            11,
            "#1 ",
            ["3:11", "14:1"],
        ),  # no writer before: those there are, and the letter of the call
        (8, "P77", []),  # no such program
        (7, "F100", []),
    ],
)
def test_a_word_leads_to_what_it_names(line: int, word: str, leads_to: list[str]) -> None:
    assert defined(word, line) == leads_to


def test_an_argument_leads_to_the_calls_that_give_it() -> None:
    assert defined("#2", 12) == ["3:15"]


@pytest.mark.parametrize(
    ("control", "text", "line", "word", "leads_to"),
    [
        ("linuxcnc", "o100 sub\n#<a>=1\nG1 X#<a> F9\no100 endsub\no100 call\nM2\n", 4, "o100", ["0:0"]),
        ("linuxcnc", "o100 sub\n#<a>=1\nG1 X#<a> F9\no100 endsub\no100 call\nM2\n", 2, "a>", ["1:2"]),
        ("siemens-one", "N10 GOTOF DONE\nN20 X1\nDONE: M30\n", 0, "DONE", ["2:0"]),
        ("gsk-988ta", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99\n", 1, "P2", ["3:0"]),
    ],
)  # fmt: skip
def test_every_language_is_followed(
    control: str, text: str, line: int, word: str, leads_to: list[str]
) -> None:
    assert defined(word, line, text, control) == leads_to


def test_the_references_of_a_variable_are_its_places_in_every_value() -> None:
    snap = snapshot()
    found = navigation.references(snap, PATH, *at(snap, 5, "#100"), definitions=True)
    places = [(each.range.start.line, each.range.start.character) for each in found]
    assert places == [(3, 17), (5, 1), (5, 6), (6, 4), (7, 10)]
    local = navigation.references(snap, PATH, *at(snap, 11, "#1 "), definitions=True)
    assert {each.range.start.line for each in local} == {
        3,
        11,
        12,
        13,
        14,
    }  # with the A of the call


def test_the_references_of_a_program_and_of_a_block() -> None:
    snap = snapshot()
    calls = navigation.references(snap, PATH, *at(snap, 10, "O2"), definitions=False)
    assert [each.range.start.line for each in calls] == [3]
    jumps = navigation.references(snap, PATH, *at(snap, 3, "N20"), definitions=True)
    assert [(each.range.start.line, each.range.start.character) for each in jumps] == [
        (3, 1),
        (6, 15),
    ]


def test_the_calls_of_a_program_go_both_ways() -> None:
    snap = snapshot()
    (item,) = navigation.prepare_calls(snap, PATH, *at(snap, 3, "P2"))
    assert item.name == "O2"
    assert [each.from_.name for each in navigation.incoming(snap, item)] == ["O1"]
    (main,) = navigation.prepare_calls(snap, PATH, 2, 0)
    assert [each.to.name for each in navigation.outgoing(snap, main)] == ["O2", "O3"]


# ---- the text beside a word ----


def told(line: int, word: str, text: str = TEXT, control: str = CONTROL) -> str:
    snap = snapshot(text, control)
    found = explaining.hover(snap, PATH, *at(snap, line, word))
    return "" if found is None else found.contents.value


def test_a_code_is_told_with_its_rules_sources_and_alarms() -> None:
    text = told(3, "G65")
    assert "calls O2 as a macro" in text
    assert "`max_macro_nesting` = 5 (general knowledge; inferred)" in text
    assert "PS0076: the called program is not in the control's memory" in text
    assert "`A` #1 DEPTH" in text  # what the macro reads, with its comments


@pytest.mark.parametrize(
    ("machine", "g92", "g70"),
    [
        (None, "sets the work coordinates", "is not computed here"),
        ("mill", "sets the work coordinates", "is not computed here"),
        ("lathe-a", "cuts a thread once", "cuts along a profile"),
    ],
)
def test_a_code_means_what_it_does_on_the_machine_of_the_project(
    tmp_path: Path, machine: str | None, g92: str, g70: str
) -> None:
    setup = 'setup = "machine.toml"\n' if machine else ""
    (tmp_path / "cncsub.toml").write_text(f'control = "{CONTROL}"\n{setup}')
    (tmp_path / "machine.toml").write_text(f'machine = "{machine or "mill"}"\n')
    memories, path = Memories(), str(tmp_path / "O1.nc")
    memories.put(path, Document.of("O1\nG92 X1.\nG70 P1 Q2\nM30\n"))
    snap = memories.snapshot(path)
    assert snap is not None
    for line, does in ((1, g92), (2, g70)):
        (head,) = [
            row
            for row in explaining.hover(snap, path, line, 0).contents.value.split("\n")
            if row.startswith("**G")
        ]
        assert does in head
    items = {each.label: each.detail for each in completing.completions(snap, path, 1, 1)}
    assert g92 in items["G92"]
    assert g70 in items["G70"]


def test_the_last_writer_of_a_long_program_is_found_and_what_is_near_is_lit() -> None:
    body = "G1 X#101\n" * 30_000
    snap = snapshot(f"O1\n#101=1\n{body}M30\n")
    (writer,) = navigation.definition(snap, PATH, 25_000, 5)
    assert (writer.range.start.line, writer.range.start.character) == (1, 1)
    lit = [each.range.start.line for each in navigation.highlights(snap, PATH, 25_000, 5)]
    assert lit == list(range(25_000 - 2_000, 25_000 + 2_001))
    short = snapshot(f"O1\n#101=1\n{body[: 9 * 9_000]}M30\n")
    assert len(navigation.highlights(short, PATH, 5_000, 5)) == 9_001


def test_a_value_is_told_as_the_last_run_had_it() -> None:
    assert "in the last run: 1, 2, 3" in told(5, "#100")
    assert "in the last run: 6" in told(7, "X[")
    assert "3 times O3" in told(4, "P30003")


def test_a_variable_that_can_only_be_written_hides_no_values() -> None:
    text = "O1\n#100=5\nIF[#100GT9]GOTO30\nM30\nN30 #3000=1(NO)\nM30\n"
    assert "in the last run: 5" in told(1, "#100", text)


def test_a_word_of_the_language_is_told() -> None:
    assert "asks a condition" in told(6, "IF")
    assert "further on in the program" in told(0, "GOTOF", "GOTOF A\nA: M30\n", "siemens-one")


# ---- what can be written ----


def labels(line: int, before: str, text: str = TEXT, control: str = CONTROL) -> list[str]:
    lines = text.splitlines()
    lines[line] = before
    snap = snapshot("\n".join(lines) + "\n", control)
    return [each.label for each in completing.completions(snap, PATH, line, len(before))]


def test_a_call_is_completed_with_the_programs_there_are() -> None:
    assert labels(8, "N50 M98 P") == ["P1", "P2", "P3"]


def test_a_jump_is_completed_with_the_numbers_of_the_program() -> None:
    assert labels(6, "IF[#100LT3]GOTO") == ["10", "20", "30", "40", "50", "60"]


def test_a_macro_call_is_completed_with_the_arguments_it_lacks() -> None:
    assert labels(3, "N20 G65 P2 A5. ")[0] == "B"
    assert labels(3, "N20 G65 P2 ")[:2] == ["A", "B"]


def test_codes_and_variables_are_completed() -> None:
    assert {"G54", "G81", "M98"} <= set(labels(2, "N10 "))
    assert labels(5, "#")[0] == "#100"
    assert labels(2, "N10 (a comment ") == []


def completed(line: int, before: str, label: str, text: str = TEXT, control: str = CONTROL) -> str:
    """Return a line as it is after an item was taken."""
    lines = text.splitlines()
    lines[line] = before
    snap = snapshot("\n".join(lines) + "\n", control)
    for each in completing.completions(snap, PATH, line, len(before)):
        if each.label == label:
            at = each.text_edit.range
            assert (at.start.line, at.end.character) == (line, len(before))
            return before[: at.start.character] + each.text_edit.new_text
    return ""


def test_an_item_goes_on_with_what_was_begun() -> None:
    assert completed(5, "N30 #100=#10", "#100") == "N30 #100=#100"
    assert completed(6, "IF[#100LT3]GOTO4", "40") == "IF[#100LT3]GOTO40"
    assert completed(8, "N50 M98P", "P2") == "N50 M98P2"
    assert completed(2, "N10G5", "G54") == "N10G54"
    assert completed(2, "N10 g5", "G54") == "N10 G54"
    assert labels(2, "N10 G5") == [label for label in labels(2, "N10 ") if label.startswith("G5")]


def test_the_variables_of_the_control_are_completed() -> None:
    assert {"#3000", "#5201", "#5041"} <= set(labels(5, "N30 #100=#"))
    assert set(labels(5, "#522")) == {f"#{number}" for number in range(5220, 5230)}


@pytest.mark.parametrize(
    ("control", "text", "before", "label"),
    [
        ("siemens-one", "R5=1\nG0 X=\nM30\n", "G0 X=R", "R5"),
        ("siemens-one", "DEF REAL DEPTH\nG0 X=\nM30\n", "G0 X=DE", "DEPTH"),
        ("siemens-one", "R5=1\nG0 X=\nM30\n", "R1=$P_AXN", ""),
        ("linuxcnc", "#<depth>=1\nG0\nM2\n", "G0 X#<d", "#<depth>"),
        ("fanuc-30i", "[#DEPTH]=3\nG0\nM30\n", "G0 X[#D", "#DEPTH"),
    ],
)
def test_variables_are_completed_as_the_language_writes_them(
    control: str, text: str, before: str, label: str
) -> None:
    if label:
        assert label in labels(1, before, text, control)
        assert completed(1, before, label, text, control).endswith(label)
    else:
        assert all(each.startswith("$P_") for each in labels(1, before[:-3], text, control))


def test_the_parameters_that_a_program_sets_are_completed() -> None:
    text = "O1\nG10 L52\nN\nG11\nN\nM30\n"
    found = labels(2, "N60", text, "fanuc-30i")
    assert "N6001" in found
    assert labels(4, "N60", text, "fanuc-30i") == []
    lines = snapshot(text, "fanuc-30i")
    [item] = [i for i in completing.completions(lines, PATH, 2, 1) if i.label == "N6001"]
    assert "bit 5: TCS" in item.documentation


def test_controls_and_parameters_are_completed_where_a_project_names_them() -> None:
    def names(text: str, path: str) -> list[str]:
        line = text.splitlines()[-1]
        return [
            each.label for each in names_at(Document.of(text), path, text.count("\n"), len(line))
        ]

    assert names("(cncsub: control=fanuc-0", PATH) == ["fanuc-0i-d", "fanuc-0i-f"]
    assert "linuxcnc" in names("; cncsub: control=", PATH)
    assert names("G1 X1 F", PATH) == []
    assert names('control = "haas', "/p/cncsub.toml") == ["haas-ngc"]
    assert names("setup = ", "/p/cncsub.toml") == []
    told = names('control = "fanuc-30i"\n[parameters]\n"6001#', "/p/cncsub.toml")
    assert "6001#5" in told


def test_the_signature_of_a_code_is_its_words() -> None:
    snap = snapshot("O1\nG81 X1. Z-5. R2. F100\nM30\n")
    found = completing.signature(snap, PATH, 1, len("G81 X1. Z-5. R"))
    assert found is not None
    [told] = found.signatures
    assert told.label.startswith("G81 ")
    assert told.parameters[found.active_parameter].label.startswith("R: ")


def test_the_signature_of_a_macro_is_what_it_reads() -> None:
    snap = snapshot()
    found = completing.signature(snap, PATH, 3, len("N20 G65 P2 A5. B"))
    assert found is not None
    assert found.signatures[0].label == "G65 O2 (MACRO): A=#1 DEPTH, B=#2 WIDTH"
    assert found.active_parameter == 1
    assert completing.signature(snap, PATH, 4, 5) is None


def test_a_variable_is_told_as_the_control_writes_it() -> None:
    assert "**R5**" in told(0, "R5", "R5=1\nM30\n", "siemens-one")


# ---- what is shown ----


def test_hints_say_repeats_values_and_positions() -> None:
    snap = snapshot()
    hints = [(h.position.line, h.label) for h in shown.inlay_hints(snap, PATH, 0, 30)]
    assert hints == [
        (3, " = vacant, 1, 2"), (4, " = 3 times O3"), (7, " = 6"),
        (7, "-> X15 Y0 Z0"), (18, "-> X9 Y0 Z0"),
    ]  # fmt: skip


def test_lenses_stand_at_programs_that_nothing_calls() -> None:
    snap = snapshot()
    titles = [
        (c.range.start.line, c.command.title) for c in shown.code_lenses(snap, PATH, debugs=True)
    ]
    assert titles == [(0, "Run"), (0, "Debug"), (0, "Plot"), (0, "0:03 min, 15 mm, 89 blocks")]
    assert len(shown.code_lenses(snap, PATH, debugs=False)) == 3


def test_the_outline_has_programs_numbers_tools_and_headings() -> None:
    found = symbols.document_symbols(snapshot(), PATH)
    assert [(p.name, p.detail) for p in found] == [("O1", "MAIN"), ("O2", "MACRO"), ("O3", None)]
    assert [c.name for c in found[0].children] == [
        "ROUGHING", "N10", "T1", "N20", "N30", "N40", "N50", "N60",
    ]  # fmt: skip
    assert [each.name for each in symbols.workspace_symbols(snapshot(), "macro")] == ["O2 MACRO"]


def test_an_outline_that_is_too_long_tells_what_it_leaves_out() -> None:
    body = "".join(f"N{n} #1=#1+1\nIF[#1LT3]GOTO{n}\n" for n in range(1, 2_501))
    (program,) = symbols.document_symbols(snapshot(f"O1\n{body}M30\n"), PATH)
    names = [each.name for each in program.children]
    assert names[1_999:] == ["N2000", "500 more blocks that jumps lead to"]


def test_programs_loops_and_tools_are_folded() -> None:
    found = [(f.start_line, f.end_line) for f in symbols.folding(snapshot(), PATH)]
    assert found == [(0, 9), (2, 9), (3, 6), (10, 16), (13, 15), (17, 19)]


LINUXCNC = """\
#<i> = 0
o1 while [#<i> lt 3]
#<i> = [#<i> + 1]
o1 endwhile
o2 sub
G0 X[#1]
o2 endsub
o2 call [#<i>]
M2
"""


def test_the_statements_of_linuxcnc_are_listed_folded_and_told() -> None:
    snap = snapshot(LINUXCNC, "linuxcnc", "/nowhere/part.ngc")
    path = "/nowhere/part.ngc"
    (program,) = symbols.document_symbols(snap, path)
    assert [(each.name, each.range.end.line) for each in program.children] == [("O2", 6)]
    folded = [(each.start_line, each.end_line) for each in symbols.folding(snap, path)]
    assert folded == [(0, 8), (1, 3), (4, 6)]
    for character in (8, 9, 10, 11):  # each of #<i>
        assert [place.range.start.line for place in navigation.definition(snap, path, 2, 8)] == [0]
        assert explaining.hover(snap, path, 2, character).contents.value.startswith("**i**")


def test_a_name_that_is_no_word_of_the_language_is_not_told_by_its_letter() -> None:
    text = "SUBP(R1)\nMCALL CYCLE81(10,0,2,-5)\nLAB:\nIF R1<3 GOTOB LA\nR2=SIN(R1)\nM30\n"
    assert told(0, "SUBP", text, SIEMENS) == ""
    assert told(1, "CYCLE81", text, SIEMENS).startswith("**CYCLE81**")
    assert "**GOTOB**" in told(3, "GOTOB", text, SIEMENS)
    assert "**IF**" in told(3, "IF", text, SIEMENS)
    assert "**SIN**" in told(4, "SIN", text, SIEMENS)
    snap = snapshot(text, SIEMENS)
    for character in (14, 16):  # before the name, and after some letters of it
        labels = [each.label for each in completing.completions(snap, PATH, 3, character)]
        assert labels == ["LAB"], character


def test_words_have_the_colour_of_what_they_are() -> None:
    snap = snapshot("O1\nN10 G1 X1. (to) M98 P1\n#1=2\nM30\n")
    found = [row[3] for row in shown.coloured(snap, PATH, 0, 9)]
    assert found == [
        "label",
        "keyword",
        "number",
        "comment",
        "function",
        "number",
        "variable",
        "keyword",
    ]
    data = shown.semantic_tokens(snap, PATH).data
    assert data[:10] == [1, 0, 3, shown.TYPES.index("label"), 0, 0, 4, 2, 0, 0]


# ---- findings ----


def test_findings_are_diagnostics_with_rule_alarm_and_cure() -> None:
    found = {each.code: each for each in diagnostics(snapshot(), PATH)}
    missing = found["CS201"]
    assert missing.range == types.Range(types.Position(8, 8), types.Position(8, 11))
    assert missing.message.startswith("O77 is not in the memory [alarm PS0076]\n")
    assert missing.severity is types.DiagnosticSeverity.Error


def test_a_finding_shows_the_calls_that_lead_to_it() -> None:
    snap = snapshot("O1\nM98 P2\nM30\nO2\nGOTO 5\nM99\n")
    (found,) = [each for each in diagnostics(snap, PATH) if each.code == "CS202"]
    (call,) = found.related_information
    assert call.message == "O1 calls O2 (M98)"
    assert call.location.range.start.line == 1


def test_a_certain_correction_is_an_edit() -> None:
    text = "O1\n(\U0001f600) G1 XO. F1,5\nM30\n"
    snap = snapshot(text)
    every = types.Range(types.Position(0, 0), types.Position(9, 0))
    found = actions(snap, PATH, every)
    assert found[0].title == "Change XO to X0"
    (edit,) = found[0].edit.changes[f"file://{PATH}"]
    assert (
        Document.of(text)
        .edited(edit.new_text, edit.range)
        .line(1)
        .startswith("(\U0001f600) G1 X0.")
    )
    (other,) = actions(snap, PATH, types.Range(types.Position(0, 0), types.Position(0, 2)))
    assert other.command.command == "cncsub.renumber"


# ---- changes ----


def after(snap: Snapshot, edit: types.WorkspaceEdit) -> str:
    document = snap.document(PATH)
    for change in sorted(edit.changes[f"file://{PATH}"], key=_last_first):
        document = document.edited(change.new_text, change.range)
    return document.text


def _last_first(edit: types.TextEdit) -> tuple[int, int]:
    return -edit.range.start.line, -edit.range.start.character


@pytest.mark.parametrize(
    ("line", "word", "new", "changed"),
    [
        (3, "20", "25", {3: "N25 G65 P2 A5. B#100", 6: "IF[#100LT3]GOTO25"}),
        (10, "2 ", "7", {3: "N20 G65 P7 A5. B#100", 10: "O7 (MACRO)"}),
        (7, "100", "150", {3: "N20 G65 P2 A5. B#150", 5: "#150=#150+1", 6: "IF[#150LT3]GOTO20",
                           7: "N40 G1 X[#150*2] F100"}),
    ],
)  # fmt: skip
def test_a_rename_changes_all_that_names_it(
    line: int, word: str, new: str, changed: dict[int, str]
) -> None:
    snap = snapshot()
    place = at(snap, line, word)
    prepared = rewriting.prepare_rename(snap, PATH, *place)
    assert prepared.placeholder == word.strip()
    lines = after(snap, rewriting.renamed(snap, PATH, *place, new)).splitlines()
    expected = [changed.get(n, text) for n, text in enumerate(TEXT.splitlines())]
    assert lines == expected


def test_what_cannot_be_renamed_is_refused() -> None:
    snap = snapshot()
    assert rewriting.prepare_rename(snap, PATH, *at(snap, 7, "F100")) is None
    with pytest.raises(EditError):
        rewriting.renamed(snap, PATH, *at(snap, 3, "20"), "30")


def test_a_program_named_by_its_file_moves_the_file(tmp_path: Path) -> None:
    memories, path = job(tmp_path), str(tmp_path / "O1.nc")
    (tmp_path / "O2.nc").write_text("M99\n")
    memories.put(path, Document.of("O1\nM98 P2\nM30\n"))
    snap = memories.snapshot(path)
    edit = rewriting.renamed(snap, path, 1, 5, "7")
    *texts, move = edit.document_changes
    assert [each.new_text for change in texts for each in change.edits] == ["7"]
    assert (move.old_uri, move.new_uri) == tuple(
        (tmp_path / name).as_uri() for name in ("O2.nc", "O7.nc")
    )


def test_blocks_are_laid_out_and_numbered_anew() -> None:
    snap = snapshot("O1\nN1g91g1x10f100(\U0001f600)\nN2GOTO1\nM30\n")
    edits = rewriting.formatted(snap, PATH, types.FormattingOptions(2, True))
    text = after(snap, types.WorkspaceEdit(changes={f"file://{PATH}": edits}))
    assert text == "O1\nN1 G91 G1 X10 F100 (\U0001f600)\nN2 GOTO1\nM30\n"
    some = rewriting.formatted(snap, PATH, types.FormattingOptions(2, True), 2, 2)
    assert {edit.range.start.line for edit in some} == {2}
    assert after(snap, rewriting.renumbered(snap, PATH)).splitlines()[1:3] == [
        "N10g91g1x10f100(\U0001f600)",
        "N20GOTO10",
    ]


def test_only_the_file_at_hand_is_numbered_anew(tmp_path: Path) -> None:
    for name in ("a.nc", "b.nc"):
        (tmp_path / name).write_text("O1\nN3 G4 P1\nM30\n")
    memories = Memories(folders=(str(tmp_path),), settings=Settings(CONTROL))
    path = str(tmp_path / "b.nc")
    memories.put(path, Document.of((tmp_path / "b.nc").read_text()))
    snap = memories.snapshot(path)
    assert snap is not None
    assert list(rewriting.renumbered(snap, path).changes) == [f"file://{path}"]


# ---- memories ----


def job(folder: Path) -> Memories:
    (folder / "O1.nc").write_text("O1\nM98 P2\nM30\n")
    (folder / "O2.nc").write_text("O2\nM99\n")
    return Memories(folders=(str(folder),), settings=Settings(CONTROL))


def test_a_wrong_setup_of_a_project_is_told_once_and_left_out(tmp_path: Path) -> None:
    (tmp_path / "cncsub.toml").write_text('control = "fanuc-0i-f"\nsetup = "machine.toml"\n')
    (tmp_path / "machine.toml").write_text("[nonsense]\nX = 1\n")
    messages: list[str] = []
    memories = Memories(tell=messages.append)
    path = str(tmp_path / "a.nc")
    for text in ("O1\n#100=5\nM30\n", "O1\n#100=6\nM30\n"):
        memories.put(path, Document.of(text))
        snap = memories.snapshot(path)
        assert snap is not None
        assert diagnostics(snap, path) == []
        assert explaining.hover(snap, path, 1, 1) is not None
    assert len(messages) == 1
    assert "nonsense" in messages[0]


def test_a_folder_is_one_memory_and_unsaved_text_counts(tmp_path: Path) -> None:
    memories, path = job(tmp_path), str(tmp_path / "O1.nc")
    memories.put(path, Document.of("O1\nM98 P2\nM98 P3\nM30\n"))
    snap = memories.snapshot(path)
    (head,) = navigation.definition(snap, path, 1, 5)
    assert head.uri == (tmp_path / "O2.nc").as_uri()
    assert [(link.range.start.line, link.target) for link in navigation.links(snap, path)] == [
        (1, f"{(tmp_path / 'O2.nc').as_uri()}#L1")
    ]
    assert [each.code for each in diagnostics(snap, path)] == ["CS201"]
    new = str(tmp_path / "O3.nc")  # a document that is no file yet
    memories.put(new, Document.of("O3\nM99\n"))
    assert diagnostics(memories.snapshot(path), path) == []
    memories.close(new)
    assert [each.code for each in diagnostics(memories.snapshot(path), path)] == ["CS201"]


def test_the_control_is_named_by_the_file_the_project_or_the_client(tmp_path: Path) -> None:
    memories, path = job(tmp_path), str(tmp_path / "O1.nc")
    memories.put(path, Document.of("O1\nM30\n"))
    assert memories.snapshot(path).control.name == CONTROL
    (tmp_path / "cncsub.toml").write_text('control = "gsk-988ta"\n')
    memories.read_disk_again()
    assert memories.snapshot(path).control.name == "gsk-988ta"
    memories.put(path, Document.of("O1 (cncsub: control=Haas NGC)\nM30\n"))
    assert memories.snapshot(path).control.name == "haas-ngc"


def test_a_missing_and_an_unknown_control_are_told_once(tmp_path: Path) -> None:
    said: list[str] = []
    memories = Memories(tell=said.append)
    path = str(tmp_path / "a.nc")
    memories.put(path, Document.of("O1\nM30\n"))
    assert memories.snapshot(path) is None
    assert memories.snapshot(path) is None
    (message,) = said
    assert "no control is named" in message
    memories.put(path, Document.of("O1 (cncsub: control=fanuc-0i-g)\nM30\n"))
    assert memories.snapshot(path) is None
    assert "did you mean" in said[1]


def test_a_project_of_somebody_else_names_nothing_outside_its_folder(tmp_path: Path) -> None:
    inside, outside = tmp_path / "in", tmp_path / "out"
    inside.mkdir()
    outside.mkdir()
    (outside / "O9.nc").write_text("O9\nM99\n")
    (inside / "cncsub.toml").write_text(f'control = "{CONTROL}"\nexternal = "../out"\n')
    said: list[str] = []
    memories = Memories(tell=said.append)
    path = str(inside / "O1.nc")
    memories.put(path, Document.of("O1\nM30\n"))
    assert memories.snapshot(path) is None
    assert "outside the folder of the project" in said[0]


def test_a_large_folder_is_not_read_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cncsub.editor.memory.MOST_FILES", 1)
    said: list[str] = []
    memories = job(tmp_path)
    memories.tell = said.append
    path = str(tmp_path / "O1.nc")
    memories.put(path, Document.of("O1\nM30\n"))
    assert memories.snapshot(path).library.files == (path,)
    assert "each file is read with those that it calls" in said[0]


def test_a_file_of_no_folder_is_read_with_those_that_it_calls(tmp_path: Path) -> None:
    job(tmp_path)
    (tmp_path / "O3.nc").write_text("O3\nM99\n")
    memories, path = Memories(settings=Settings(CONTROL)), str(tmp_path / "O1.nc")
    memories.put(path, Document.of("O1\nM98 P3\nM98 P4\nM30\n"))  # not as it is on the disk
    snap = memories.snapshot(path)
    assert snap.library.files == (path, str(tmp_path / "O3.nc"))
    assert [each.range.start.line for each in diagnostics(snap, path)] == [2]


def test_a_file_beside_the_folders_of_its_project_is_read_too(tmp_path: Path) -> None:
    (tmp_path / "programs").mkdir()
    job(tmp_path / "programs")
    (tmp_path / "cncsub.toml").write_text(f'control = "{CONTROL}"\nfolders = ["programs"]\n')
    memories, path = Memories(), str(tmp_path / "try.nc")
    memories.put(path, Document.of("O9\nM98 P2\nM98 P4\nM30\n"))
    snap = memories.snapshot(path)
    assert [each.range.start.line for each in diagnostics(snap, path)] == [2]


def test_ten_megabytes_of_anything_are_answered() -> None:
    line = "N1 G1 X1.\x00 (\U0001f600\u5f84) #1=#1+[ \ufeff;((\r"
    snap = snapshot(line * 120_000)
    found = diagnostics(snap, PATH)
    assert found
    assert all(each.range.start.line < 240_000 for each in found)
    assert shown.semantic_tokens(snap, PATH) is None
    assert shown.semantic_tokens(snap, PATH, 100_000, 100_020).data
    explaining.hover(snap, PATH, 100_000, 4)


# ---- texts ----


def test_lines_end_as_the_protocol_says() -> None:
    assert split("a\r\nb\rc\n\x0bd\u2028e\x00") == ["a\r\n", "b\r", "c\n", "\x0bd\u2028e\x00"]


def test_columns_are_counted_in_the_units_of_the_client() -> None:
    line = "(\u5f84\U0001f600)X1"
    assert [units_before(line, 3, units) for units in ("utf-16", "utf-8", "utf-32")] == [4, 8, 3]
    assert [character_of(line, n, "utf-16") for n in (0, 1, 2, 4, 5, 99)] == [0, 1, 2, 3, 4, 6]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_places_are_the_same_whatever_ends_a_line(end: str) -> None:
    snap = snapshot(TEXT.replace("\n", end))
    assert [each.range for each in diagnostics(snap, PATH)] == [
        each.range for each in diagnostics(snapshot(), PATH)
    ]
