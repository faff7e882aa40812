"""Coverage: what is counted, what is added up, and the formats."""

from __future__ import annotations

import re
import threading
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.coverage import Coverage, collecting, summary

IF = "O1\nN10 IF[#100EQ1]GOTO30\nN20 #101=1\nN30 M30\n"
WHILE = (
    "O1\nN10 #1=0\nN20 WHILE[#1LT#100]DO1\nN30 #1=#1+1\nN40 END1\nN50 #2=#2+1\n"
    "N60 IF[#2LT2]GOTO10\nN70 M30\n"
)


def outcomes(coverage: Coverage, n: int | None = None) -> dict[str, int]:
    return {row.outcome: row.count for row in coverage.branches if n is None or row.n == n}


def covered(text: str, control: str = "fanuc-0i-f", **options: object) -> Coverage:
    return cncsub.loads(text, control=control).run(**options).coverage()  # type: ignore[arg-type]


@pytest.mark.parametrize(("value", "taken"), [(1, 1), (2, 0)])
def test_an_if_goto_is_counted_by_its_condition(value: int, taken: int) -> None:
    found = covered(IF, variables={100: value})
    assert outcomes(found) == {"taken": taken, "not taken": 1 - taken}
    assert [row.count for row in found.blocks] == [1, 1 - taken, 1]


def test_a_jump_to_the_next_block_is_taken() -> None:
    assert outcomes(covered("O1\nIF[1EQ1]GOTO20\nN20 M30\n")) == {"taken": 1, "not taken": 0}


@pytest.mark.parametrize(
    ("passes", "outcome"), [(0, "none"), (1, "once"), (2, "many"), (9, "many")]
)
def test_the_passes_of_a_while_are_counted_for_each_entry(passes: int, outcome: str) -> None:
    found = covered(WHILE, variables={100: passes})
    assert outcomes(found, 20) == {"none": 0, "once": 0, "many": 0} | {outcome: 2}


def test_a_loop_that_is_left_by_goto_ends_there() -> None:
    text = (
        "O1\nN10 WHILE[1EQ1]DO1\nN20 #1=#1+1\nN30 IF[#1EQ1]GOTO50\nN40 END1\nN50 #2=#2+1\n"
        "N60 IF[#2EQ1]GOTO10\nN70 IF[#2EQ2]GOTO90\nN90 M30\n"
    )
    found = covered(text, max_blocks=100)
    assert outcomes(found, 10)["once"] == 1


def test_a_loop_left_by_m99_in_each_pass_of_a_call_is_entered_each_time() -> None:
    text = "O1\nM98 P2 L3\nM30\nO2\nWHILE[1EQ1]DO1\nM99\nEND1\n"
    assert outcomes(covered(text)) == {"none": 0, "once": 3, "many": 0}


def test_loops_of_calls_inside_loops_are_apart() -> None:
    text = (
        "O1\nN10 WHILE[#1LT3]DO1\nN20 G65 P2 A#1\nN30 #1=#1+1\nN40 END1\nM30\n"
        "O2\nN50 WHILE[#1GT0]DO1\nN60 #1=#1-1\nN70 END1\nM99\n"
    )
    found = covered(text, variables={})
    assert outcomes(found, 10) == {"none": 0, "once": 0, "many": 1}
    assert outcomes(found, 50) == {"none": 1, "once": 1, "many": 1}


@pytest.mark.parametrize("value", [1, 2])
def test_an_if_then_is_counted_whatever_it_executes(value: int) -> None:
    found = covered("O1\nN10 IF[#100EQ1]THEN #101=5\nM30\n", variables={100: value})
    assert outcomes(found) == {"taken": int(value == 1), "not taken": int(value != 1)}


@pytest.mark.parametrize("value", [1, 2])
def test_an_h_code_that_compares_is_a_branch(value: int) -> None:
    text = f"O1\nN10 G65 H81 P30 Q{value} R1\nN20 G4 X1\nN30 M30\n"
    found = covered(text, "gsk-980tdi")
    assert outcomes(found) == {"taken": int(value == 1), "not taken": int(value != 1)}


def test_o_words_of_linuxcnc() -> None:
    text = (
        "#1=0\no1 while [#1 LT 2]\n#1=[#1+1]\no2 if [#1 EQ 1]\nG4 P1\no2 elseif [#1 EQ 5]\n"
        "G4 P2\no2 endif\no1 endwhile\no3 repeat [3]\nG4 P0\no3 endrepeat\nM2\n"
    )
    found = covered(text, "linuxcnc")
    kinds = {(row.kind, row.outcome): row.count for row in found.branches}
    assert kinds["while", "many"] == kinds["repeat", "many"] == 1
    assert (kinds["if", "taken"], kinds["if", "not taken"]) == (1, 1)
    assert kinds["elseif", "taken"] == 0


def test_siemens_if_and_while() -> None:
    text = "R1=0\nN10 WHILE R1<2\nR1=R1+1\nN20 IF R1==1\nR2=1\nENDIF\nENDWHILE\nM30\n"
    name = next(name for name in cncsub.controls if name.startswith("siemens"))
    found = covered(text, name)
    assert outcomes(found, 10)["many"] == 1
    assert outcomes(found, 20) == {"taken": 1, "not taken": 1}


def test_calls_and_arguments() -> None:
    text = (
        "O1\nN10 G65 P2 A1 B2\nN20 IF[1EQ1]GOTO40\nN30 M98 P3\nN40 M30\n"
        "O2\n#100=#1+#3\nM99\nO3\nM99\n"
    )
    found = covered(text)
    assert [(r.n, r.kind, r.called, r.count) for r in found.calls] == [
        (10, "G65", "O2", 1),
        (30, "M98", "O3", 0),
    ]
    assert [(r.letter, r.count, r.covered) for r in found.arguments] == [
        ("A", 1, True),
        ("B", 1, True),
        ("C", 0, False),
    ]


def test_blocks_that_were_skipped_or_raised_the_alarm_are_not_covered() -> None:
    skipped = covered("O1\nN10 G0 X1\n/N20 G0 X2\nN30 M30\n", block_skip=1)
    assert [row.covered for row in skipped.blocks] == [True, False, True]
    alarmed = covered("O1\nN10 G0 X1\nN20 M98 P9\nN30 M30\n")
    assert not alarmed.blocks[-1].covered
    meant = covered("O1\nN10 #3000=1 (STOP)\nN30 M30\n")
    assert [row.covered for row in meant.blocks] == [True, False]
    faulty = covered("O1\nN10 G0 X[1\nN20 M30\n")
    assert [row.covered for row in faulty.blocks] == [False, False]


def test_sums_of_runs_of_one_library_and_of_others_with_the_same_programs() -> None:
    one, other = (cncsub.loads(IF, control="fanuc-0i-f", name="a.nc") for _ in range(2))
    runs = [one.run(variables={100: 1}), one.run(), other.run()]
    total = sum(run.coverage() for run in runs)
    assert isinstance(total, Coverage)
    assert outcomes(total) == {"taken": 1, "not taken": 2}
    assert total.percent == 100
    changed = cncsub.loads(IF.replace("#101=1", "#101=2"), control="fanuc-0i-f", name="a.nc")
    with pytest.raises(ValueError, match=r"O1 of a\.nc has another text"):
        total + changed.run().coverage()


@pytest.mark.parametrize("trace", ["none", "calls"])
def test_a_run_without_blocks_names_the_cure(trace: str) -> None:
    run = cncsub.loads(IF, control="fanuc-0i-f").run(trace=trace)
    with pytest.raises(ValueError, match='trace="blocks"'):
        run.coverage()


@pytest.mark.parametrize("text", [IF, WHILE, "O1\nM98 P2 L3\nM30\nO2\nG65 P3 A1\nM99\nO3\nM99\n"])
def test_counts_are_what_a_machine_sees_step_by_step(text: str) -> None:
    library = cncsub.loads(text, control="fanuc-0i-f")
    options = {"variables": {100: 3}}
    seen = Counter((s.program, s.line) for s in library.machine(**options))  # type: ignore[arg-type]
    found = library.run(**options).coverage()  # type: ignore[arg-type]
    assert {(b.program, b.line): b.count for b in found.blocks if b.count} == seen


def test_collecting_adds_up_the_runs_of_all_threads() -> None:
    library = cncsub.loads(IF, control="fanuc-0i-f")
    with collecting() as collected:
        threads = [threading.Thread(target=library.run) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        library.run(trace="none")
    library.run()
    assert (collected.runs, collected.left_out) == (8, 1)
    assert collected.total.blocks[0].count == 8


def test_a_run_whose_files_clash_is_left_out_and_counted() -> None:
    with collecting() as collected:
        for text in (IF, WHILE, IF):
            cncsub.loads(text, control="fanuc-0i-f", name="a.nc").run()
    assert (collected.runs, collected.left_out) == (2, 1)
    assert repr(collected) == "<Collected: 2 runs, 1 left out>"


def test_texts_without_a_file_count_each_for_itself() -> None:
    with collecting() as collected:
        for text in (IF, WHILE, IF):
            cncsub.loads(text, control="fanuc-0i-f").run()
    assert (collected.runs, collected.left_out) == (3, 0)
    files = [program.file for program in collected.total.programs]
    assert files == ["<text>", "<text> 2"]
    blocks = [row.count for row in collected.total.blocks if row.text == "N10 IF[#100EQ1]GOTO30"]
    assert blocks == [2]
    tracefile = collected.total.to_lcov()
    assert tracefile.count("SF:") == len(set(re.findall("SF:.*", tracefile))) == 2


def test_a_file_is_one_however_its_path_is_written(tmp_path: Path) -> None:
    (tmp_path / "tests").mkdir()
    (tmp_path / "job.nc").write_text(IF)
    with collecting() as collected:
        for path in (tmp_path / "job.nc", tmp_path / "tests" / ".." / "job.nc"):
            cncsub.load(path, control="fanuc-0i-f").run()
        (tmp_path / "job.nc").write_text(WHILE)
        cncsub.load(tmp_path / "tests" / ".." / "job.nc", control="fanuc-0i-f").run()
    assert (collected.runs, collected.left_out) == (2, 1)
    assert [program.file for program in collected.total.programs] == [str(tmp_path / "job.nc")]
    assert collected.total.blocks[0].count == 2


def test_runs_of_what_was_typed_are_added() -> None:
    library = cncsub.loads("O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99\n", control="fanuc-0i-f")
    typed = [library.mdi(text) for text in ("M98 P2", "G0 X1.", "M98 P2")]
    total = sum((run.coverage() for run in typed), library.run().coverage())
    assert {row.text: row.count for row in total.blocks} == {
        "N10 M98 P2": 1, "N20 M30": 1, "N30 M99": 3, "M98 P2": 2, "G0 X1.": 1,
    }  # fmt: skip


def test_what_was_read_again_is_looked_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    looked = []
    programs = summary.programs_of
    monkeypatch.setattr(summary, "programs_of", lambda raw: looked.append(raw) or programs(raw))
    with collecting() as collected:
        for _ in range(20):
            cncsub.loads(IF, control="fanuc-0i-f", name="a.nc").run()
    assert (collected.total.percent, looked) == (80, [])
    assert [row.count for row in collected.total.blocks][:1] == [20]
    assert len(looked) == 1


def test_lcov_tells_lines_and_branches() -> None:
    lines = covered(IF).to_lcov().splitlines()
    assert lines[0] == "TN:"
    assert lines[-1] == "end_of_record"
    assert [line for line in lines if line[:3] in ("DA:", "BRD")] == [
        "BRDA:2,0,0,0",
        "BRDA:2,0,1,1",
        "DA:2,1",
        "DA:3,1",
        "DA:4,1",
    ]
    assert {"LF:3", "LH:3", "BRF:2", "BRH:1"} <= set(lines)


# The children and the attributes that the elements of coverage-04.dtd must have.
DTD = {
    "coverage": (
        ["sources", "packages"],
        "line-rate branch-rate lines-covered lines-valid branches-covered branches-valid complexity"
        " version timestamp",
    ),
    "sources": (["source"], ""),
    "source": ([], ""),
    "packages": (["package"], ""),
    "package": (["classes"], "name line-rate branch-rate complexity"),
    "classes": (["class"], ""),
    "class": (["methods", "lines"], "name filename line-rate branch-rate complexity"),
    "methods": ([], ""),
    "lines": (["line"], ""),
    "line": ([], "number hits"),
}


def test_cobertura_keeps_the_rules_of_its_dtd() -> None:
    text = covered(IF).to_cobertura()
    root = ET.fromstring(text.split("\n", 2)[2])
    for element in root.iter():
        children, attributes = DTD[element.tag]
        assert list(dict.fromkeys(child.tag for child in element)) == children
        assert set(attributes.split()) <= set(element.keys())
    (branch,) = (line for line in root.iter("line") if line.get("branch") == "true")
    assert branch.get("condition-coverage") == "50% (1/2)"


def test_the_page_opens_what_is_missed() -> None:
    assert "<details open><summary><b>O1</b> (&lt;text&gt;)" in covered(IF).to_html()
    whole = covered("O1\nN10 M30\n").to_html()
    assert "<details><summary><b>O1</b> (&lt;text&gt;)" in whole


def test_the_page_is_escaped_and_stands_alone(tmp_path: Path) -> None:
    found = covered("O1\nN10 #1=1 (<script>alert(1)</script>)\nN20 M30\n")
    page = found.to_html(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == page
    assert "<script" not in page
    assert "&lt;script" in page
    assert "://" not in page


def test_the_command_prints_a_table_writes_reports_and_keeps_a_limit(tmp_path: Path) -> None:
    (tmp_path / "job.nc").write_text(IF)
    call = ["coverage", str(tmp_path / "job.nc"), "-c", "fanuc-0i-f"]
    fine = CliRunner().invoke(app, [*call, "--lcov", str(tmp_path / "lcov"), "--fail-under", "80"])
    assert fine.exit_code == 0
    assert "O1  blocks 3/3  branches 1/2  missed branches: lines 2  " in fine.output
    assert (tmp_path / "lcov").read_text().startswith("TN:\n")
    below = CliRunner().invoke(app, [*call, "--fail-under", "80.1"])
    assert below.exit_code == 1
    assert "below 80.1 %" in below.output


def test_the_command_lists_the_sum_first_and_on_request_only_what_is_missing(
    tmp_path: Path,
) -> None:
    (tmp_path / "job.nc").write_text("O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99\nO3\nN40 M99\n")
    call = ["coverage", str(tmp_path), "-c", "fanuc-0i-f"]
    lines = CliRunner().invoke(app, call).output.splitlines()
    assert [line.split()[0] for line in lines] == ["Coverage:", "O1", "O2", "O3"]
    lines = CliRunner().invoke(app, [*call, "--skip-covered"]).output.splitlines()
    assert [line.split()[0] for line in lines] == ["Coverage:", "O3", "2"]


def test_nothing_measured_is_0_percent_and_fails_a_limit(tmp_path: Path) -> None:
    assert Coverage().percent == 0
    assert not Coverage().measured
    assert repr(Coverage()).startswith("<Coverage: nothing was measured, 0 of 0 blocks")
    assert "<p>nothing was measured: 0 of 0 blocks" in Coverage().to_html()
    assert 'line-rate="0.0000" branch-rate="0.0000"' in Coverage().to_cobertura()
    (tmp_path / "job.nc").write_text("O1\n(NOTHING)\n")
    call = ["coverage", str(tmp_path), "-c", "fanuc-0i-f"]
    assert CliRunner().invoke(app, call).exit_code == 0
    gate = CliRunner().invoke(app, [*call, "--fail-under", "0"])
    assert gate.exit_code == 1
    assert "measured nothing (0 of 0 blocks), and must reach 0 %" in gate.output


def test_reports_name_files_from_the_folder_that_holds_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    job = tmp_path / "a b" / "job.nc"
    job.parent.mkdir()
    job.write_text(IF)
    found = cncsub.load(job, control="fanuc-0i-f").run().coverage()
    assert f"SF:{job}\n" in found.to_lcov()
    assert "SF:job.nc\n" in found.to_lcov(root=job.parent)
    monkeypatch.chdir(tmp_path)
    assert "SF:a b/job.nc\n" in found.to_lcov()
    assert 'filename="a b/job.nc"' in found.to_cobertura()
    assert "(a b/job.nc)" in found.to_html()
    (tmp_path / "link").symlink_to(job.parent)
    assert "SF:job.nc\n" in found.to_lcov(root="link")
    assert "SF:<text>\n" in covered(IF).to_lcov(root=tmp_path / "a b")


def test_the_command_tells_lines_that_did_not_run_and_why_a_run_stopped(tmp_path: Path) -> None:
    (tmp_path / "job.nc").write_text("O1\nN10 M98 P9\nN20 G0 X1\nN30 M30\n")
    result = CliRunner().invoke(app, ["coverage", str(tmp_path / "job.nc"), "-c", "fanuc-0i-f"])
    assert "not executed: lines 2-4" in result.output
    assert "stopped early: PS0076" in result.output


@pytest.mark.parametrize("wrong", [["-c", "fanuc"], ["-c", "fanuc-0i-f", "--main", "O7"]])
def test_wrong_use_of_the_command_is_told_with_exit_status_2(
    wrong: list[str], tmp_path: Path
) -> None:
    (tmp_path / "job.nc").write_text(IF)
    result = CliRunner().invoke(app, ["coverage", str(tmp_path / "job.nc"), *wrong])
    assert result.exit_code == 2


def test_a_machine_is_counted_as_far_as_it_went() -> None:
    library = cncsub.loads(IF, control="fanuc-0i-f")
    machine = library.machine(trace="blocks", variables={100: 0})
    machine.step()
    assert [row.count for row in machine.coverage().blocks] == [1, 0, 0]
    done = machine.run()
    assert done is not None
    assert [row.count for row in machine.coverage().blocks] == [1, 1, 1]
    assert outcomes(machine.coverage() + library.run(variables={100: 1}).coverage()) == {
        "taken": 1, "not taken": 1,
    }  # fmt: skip
    # A machine always keeps its blocks.
    assert library.machine(trace="none").coverage().percent == 0


def test_a_stream_says_what_to_do_instead() -> None:
    stream = cncsub.loads(IF, control="fanuc-0i-f").stream()
    with pytest.raises(ValueError, match=r'library.run\(..., trace="blocks"\)'):
        stream.coverage()


SKIP = "O1\nN10 G4 P1\n/N20 G4 P2\n/2N25 G4 P3\nN30 M30\n"


@pytest.mark.parametrize(
    ("text", "n", "switches", "skipped", "executed"),
    [
        (SKIP, 20, (), 0, 1),
        (SKIP, 20, (1,), 1, 0),
        (SKIP, 25, (1,), 0, 1),
        (SKIP, 25, (1, 2), 1, 0),
        ("O1\n/N10 G4 P1\nN20 M30\n", 10, (1,), 1, 0),
        ("O1\nN5 GOTO 20\n/N10 G4 P1\nN20 M30\n", 10, (1,), 0, 0),  # the run never came there
        ("O1\nN5 GOTO 10\n/N10 G4 P1\nN20 M30\n", 10, (1,), 1, 0),
        ("O1\nN5 M98 P2 L3\nN6 M30\nO2\n/N10 G4 P1\nN20 M99\n", 10, (1,), 3, 0),
        ("O1\nN5 M98 P2\n/N10 G4 P1\nN6 M30\nO2\nN20 M99\n", 10, (1,), 1, 0),
        ("O1\n#1=0\nWHILE[#1LT4]DO1\n#1=#1+1\n/N10 G4 P1\nEND1\nM30\n", 10, (1,), 4, 0),
        ("O1\n#1=0\nWHILE[#1LT4]DO1\n#1=#1+1\nEND1\n/N10 G4 P1\nM30\n", 10, (1,), 1, 0),
        ("O1\n#1=0\nN4 #1=#1+1\nIF[#1LT4]GOTO4\n/N10 G4 P1\nM30\n", 10, (1,), 1, 0),
        ("O1\n#1=0\nN4 #1=#1+1\nIF[#1EQ4]GOTO9\n/N10 G4 P1\nGOTO4\nN9 M30\n", 10, (1,), 3, 0),
        ("O1\n/N10 #1=#1+1\nN15 #2=#2+1\nIF[#2GT3]GOTO30\nM99\nN30 M30\n", 10, (1,), 4, 0),
        ("O1\n/N10 #1=#1+1\nN15 #2=#2+1\nIF[#2GT3]GOTO30\nM99 P15\nN30 M30\n", 10, (1,), 1, 0),
        ("O1\nG66 P2\nX1.\n/N10 G4 P1\nG67\nM30\nO2\nM99\n", 10, (1,), 0, 0),  # not reported
    ],
)  # fmt: skip
def test_a_block_skip_is_a_branch(
    text: str, n: int, switches: tuple[int, ...], skipped: int, executed: int
) -> None:
    found = covered(text, block_skip=switches, max_cycles=9)
    assert outcomes(found, n) == {"skipped": skipped, "not skipped": executed}
    kinds = {row.kind for row in found.branches if row.n == n}
    assert kinds == {"block-skip"}


def test_both_ways_of_a_block_skip_make_it_whole() -> None:
    library = cncsub.loads("O1\n/N20 IF[1EQ1]GOTO30\nN30 M30\n", control="fanuc-0i-f")
    on = library.run(block_skip=(1,)).coverage()
    both = on + library.run().coverage()
    assert [(row.kind, row.outcome, row.count) for row in both.branches] == [
        ("block-skip", "skipped", 1),
        ("block-skip", "not skipped", 1),
        ("if-goto", "taken", 1),
        ("if-goto", "not taken", 0),
    ]
    assert both.percent == pytest.approx(100 * 5 / 6)
    assert "BRDA:2,0,0,1" in on.to_lcov()


@given(
    st.lists(
        st.sampled_from(
            ["N{0} G0 X1.", "/N{0} M98 P2", "N{0} G65 P3 A1.", "N{0} IF[#1 EQ 1]GOTO {1}", "N{0} M99", "O2", "O3",
             "N{0} M30", "N{0} WHILE[#1 LT 2]DO1", "N{0} END1", "N{0} #1=#1+1", "/2N{0} G91", "(A)", ""]
        ),
        max_size=30,
    ),
    st.sampled_from(sorted(cncsub.controls)),
)  # fmt: skip
def test_the_percentage_is_that_of_the_rows(lines: list[str], control: str) -> None:
    text = "O1\n" + "\n".join(line.format(i, i * 7 % 30) for i, line in enumerate(lines)) + "\n"
    coverage = cncsub.loads(text, control=control).run(max_blocks=500, block_skip=[2]).coverage()
    quick = coverage.percent
    rows = [row.covered for table in (coverage.blocks, coverage.branches) for row in table]
    assert quick == pytest.approx(100 * sum(rows) / len(rows) if rows else 0)
    assert coverage.percent == quick  # now with its programs
