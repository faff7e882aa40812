"""However deep a program, a folder or an argument is nested, the stack of the machine is not. Each
is tried in a thread of 256 kB, in a process of its own.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

# The frames of the sanitizers are several times as large.
STACK = (256 if "libasan" not in os.environ.get("LD_PRELOAD", "") else 2048) << 10
START = """
import copy, pickle, threading
import cncsub
NAMES = sorted(cncsub.controls)
ANY = dict(
    max_brackets=999999999, max_nesting=999999999, max_macro_nesting=999999999, max_loops=999999999,
    max_ifs=999999999, max_total_nesting=0, max_condition_length=0, self_call="allowed",
    second_modal_call="stacks", max_profile_blocks=0, max_pockets=0, max_constant_digits=99,
)
def runs(text, stops=("end", "alarm"), **options):
    "Runs a text on every control, with its own limits and with none, as a mill and as a lathe."
    seen = set()
    for name in NAMES:
        own = cncsub.controls[name]
        rules = {rule.name for rule in own.rules}
        wide = own.replace(**{rule: most for rule, most in ANY.items() if rule in rules})
        for control in (own, wide):
            for machine in ("mill", "lathe-a", "lathe-b"):
                asked = dict(setup={"machine": machine}, max_blocks=100_000, **options)
                run = cncsub.loads(text, control=control).run(**asked)
                assert (run.alarm is not None) == (run.stop == "alarm")
                str(run.alarm), repr(run), repr(run.calls)
                seen.add(str(run.stop.value))
    assert set(stops) & seen, seen
    return seen
def work():
"""
END = f"""
thrown = []
def whole():
    try:
        work()
    except BaseException as error:
        thrown.append(error)
threading.stack_size({STACK})
thread = threading.Thread(target=whole)
thread.start()
thread.join()
if thrown:
    raise thrown[0]
print("whole")
"""


def small_stack(work: str, folder: Path | None = None) -> None:
    body = "".join(f"    {line}\n" for line in work.strip().splitlines())
    done = subprocess.run(
        [sys.executable, "-"], input=START + body + END,
        capture_output=True, text=True, timeout=300, cwd=folder, check=False,
    )  # fmt: skip
    assert done.returncode == 0, (done.returncode, done.stderr[-2000:])
    assert done.stdout == "whole\n"


PROFILE = "N10 G0 X20. Z1.\nG1 Z-30.\nN90 G1 X100. Z-40.\nM30\n"
ISLANDS = (
    "N10 G0 X20. Z1.\n"
    + "".join(f"G1 Z-{2 * k}.5\nX60.\nZ-{2 * k + 1}.\nX20.\n" for k in range(1, 40))
    + "N90 G1 X100. Z-900.\nM30\n"
)
START_POINT = "O1\nS500 M3 F0.2\nG0 X100. Z5.\n"
# Nested texts of programs, as expressions that give them.
DEEP = {
    "turning of very many levels": [
        f"{START_POINT}{first}\nG{code} P10 Q90 U0.4 W0.1 F0.2\n{PROFILE}"
        for code, first in (
            (71, "G71 U1 R1"), (71, "G71 U0.001 R0.1"), (72, "G72 W0.001 R0.1"), (73, "G73 U9. W9. R9999"),
        )
    ],
    "pockets of very many levels and islands": [
        f"{START_POINT}G{code} {word}0.02 R0.1\nG{code} P10 Q90 U0.4 W0.1 F0.2\n{ISLANDS}"
        for code, word in ((71, "U"), (72, "W"))
    ],
    "drilling and grooving in very small pecks": [
        f"{START_POINT}{words}\nM30\n"
        for words in (
            "G83 X1. Z-99. R1. Q.002 F100", "G73 X1. Z-99. R1. Q.002 F100", "G74 R0\nG74 Z-90. Q2 F1",
            "G75 R0\nG75 X0 P2 F1", "G76 P990060 Q1 R0\nG76 X20. Z-90. P9000 Q2 F1.",
        )
    ],
    "long chains of corners, angles and offsets": [
        f"O1\nG1 F100\n{first}" + "".join(body.format(k, k + 1) for k in range(1, 3000)) + "M30\n"
        for first, body in (
            ("", "G1 X{1}. ,R.1\nZ{1}. ,C.1\n"), ("", "G1 X{0}. C.1\nZ{1}. R.1\n"), ("", "G1 A30.\nX{1}. Z{1}. A60.\n"),
            ("G41 D1\n", "G1 X{0}.\nY{1}.\n"), ("G41 D1\n", "G1 Z{0}.\n"), ("G42\n", "G1 X{0}. Z{1}.\nX{1}.\n"),
        )
    ],
    "expressions nested in each other": [
        f"O1\n{block}\nM30\n%1\n{block}\nM30\n"
        for depth in (5, 64, 65, 200, 5000)
        for block in (
            "#1=" + "[" * depth + "1" + "]" * depth, "#1=" + "SIN[" * depth + "1" + "]" * depth,
            "#1=" + "#[" * depth + "1" + "]" * depth, "#" + "[#" * depth + "1" + "]" * depth + "=1",
            "#1=" + "-[" * depth + "1" + "]" * depth, "#1=" + "1+[2*[" * depth + "1" + "]]" * depth,
            "#1=" + "ATAN[1]/[" * depth + "1" + "]" * depth, "#1=" + "POW[2," * depth + "1" + "]" * depth,
            "#1=" + "-" * depth + "1", "X" + "-[" * depth + "1" + "]" * depth, "#1=1" + "+1" * depth,
            "IF " + "NOT " * depth + "TRUE\nENDIF", "IF " + "NOT [" * depth + "1 EQ 1" + "]" * depth + "\nENDIF",
            "IF[" + "[" * depth + "1EQ1" + "]" * depth + "]GOTO9\nN9", "IF[1EQ1]THEN " * depth + "#1=1",
            "X1" + "/X1" * depth, "X1" + "".join(f"/{k % 9 + 1}X1" for k in range(depth)), "G65 P2 X1" + "=1" * depth,
        )
    ],
    # Every operator of a level waits for its right operand, and more operands wait than there are
    # brackets.
    "values that wait for each other": [
        f"{head}{to}={unit * depth}{value}{close * depth}\nM30\n"
        for depth in (5, 20, 49, 64, 90, 99)
        for head, to, close, value, units in (
            ("%1\n", "R1", ")", "R2", ("R2+R2*(", "R2>R2+R2*(", "R2 OR R2 AND R2>R2+R2*(")),
            ("O1\n", "#1", "]", "#2", ("#2+#2*[", "1-SIN[", "#2EQ#2+#2*[", "POW[#2,#2+#2*[", "#2 OR #2 AND #2 GT #2+#2*[")),
            ("", "#1", "]", "#2", ("#2+#2*[", "#2 or #2 and #2 gt #2+#2*#2**[", "#2**[", "1+[")),
        )
        for unit in units
    ],
    "loops and branches nested in each other": [
        "O1\n" + "WHILE[1EQ1]DO1\n" * 5000 + "END1\n" * 5000 + "M30\n",
        "O1\n" + "".join(f"DO{k % 3 + 1}\n" for k in range(5000)) + "M30\n",
        "%1\n" + "IF 1 EQ 1\n" * 5000 + "ENDIF\n" * 5000 + "M30\n",
        "%1\n" + "WHILE 1 EQ 1\n" * 5000 + "ENDW\n" * 5000 + "M30\n",
    ],
}  # fmt: skip


@pytest.mark.parametrize("name", DEEP)
def test_the_stack_does_not_grow_with(name: str) -> None:
    small_stack(f"for text in {DEEP[name]!r}:\n    runs(text, stops=('end', 'alarm', 'limit'))")


def test_programs_that_call_each_other_are_frames_of_ours() -> None:
    calls = ["M98 P1", "G65 P1 A1.", "G66 P1\nX1.", "G66.1 P1\nX1.", "M198 P1", "M98 P1 L9"]
    small_stack(
        f"for calls in {calls!r}:\n"
        "    for trace in ('none', 'calls', 'moves'):\n"
        "        runs(f'O1\\nG91 X1.\\n{calls}\\nM99\\n', ('limit', 'alarm'), trace=trace)\n"
    )


def test_an_alarm_below_very_many_calls_is_a_value_like_any_other() -> None:
    small_stack(
        """
control = cncsub.controls["fanuc-0i-f"].replace(**ANY)
run = cncsub.loads("O1\\nIF[#100GT50000]GOTO9\\n#100=#100+1\\nM98 P1\\nN9 G999\\nM99\\n", control=control).run()
assert len(run.alarm.frames) == 50_001
for protocol in range(6):
    assert pickle.loads(pickle.dumps(run.alarm, protocol)) == run.alarm
assert copy.deepcopy(run.alarm) == run.alarm and hash(run.alarm) and str(run.alarm)
tree = run.calls.tree()
assert repr(tree) and len(run.calls) == 50_001
del tree, run
"""
    )


def test_folders_are_read_however_deep_they_are(tmp_path: Path) -> None:
    folders = [tmp_path / "job"]
    for _ in range(1200):
        folders.append(Path(f"{folders[-1]}/d"))
    files = [folder / f"O{number}.nc" for number, folder in enumerate(folders, 1)]
    for folder, file in zip(folders, files, strict=True):
        folder.mkdir()
        file.write_text("N10 M98 P601\nM30\n" if folder == folders[0] else "M99\n")
    try:
        small_stack(
            """
for way in (dict(), dict(external="job/d")):
    library = cncsub.load("job", control="fanuc-0i-f", **way)
    count = len(library) + len(library.external)
    assert count == 1201, (count, library.skipped[:1])
    assert pickle.loads(pickle.dumps(library)).run("O1").stop == library.run("O1").stop
""",
            tmp_path,
        )
    finally:  # pytest descends into folders by recursive calls
        for folder, file in zip(reversed(folders), reversed(files), strict=True):
            file.unlink()
            folder.rmdir()


def test_links_to_links_without_end_lead_nowhere(tmp_path: Path) -> None:
    (tmp_path / "l0").symlink_to("l3000")
    for number in range(3000):
        (tmp_path / f"l{number + 1}").symlink_to(f"l{number}")
    (tmp_path / "job").mkdir()
    (tmp_path / "job" / "O1.nc").write_text("M30\n")
    (tmp_path / "job" / "down").symlink_to(".")
    (tmp_path / "job" / "far").symlink_to("../l2000")
    small_stack(
        """
for path, external in (("l3000", None), ("l3000", "l2999"), ("job", "l2999"), ("job/far", "job")):
    try:
        cncsub.load(path, control="fanuc-0i-f", external=external)
    except FileNotFoundError as error:
        assert "a broken link" in str(error)
    else:
        assert False, path
assert len(cncsub.load("job", control="fanuc-0i-f")) == 1
""",
        tmp_path,
    )


def test_arguments_nested_in_each_other_are_refused(tmp_path: Path) -> None:
    (tmp_path / "deep.toml").write_text("a = " + "[" * 50_000)
    (tmp_path / "dots.toml").write_text("a" + ".a" * 50_000 + " = 1")
    (tmp_path / "tables.toml").write_text("a = " + "{a=" * 50_000)
    small_stack(
        """
library = cncsub.loads("M30", control="fanuc-0i-f")
for name in ("deep", "dots", "tables"):
    try:
        cncsub.Setup.from_toml(f"{name}.toml")
    except ValueError as error:
        assert name in str(error)
    else:
        assert False, name
deep, wide = [], {}
for _ in range(100_000):
    deep, wide = [deep], {"X": wide}
for value in (deep, wide):
    for option in ("main", "start", "variables", "block_skip", "inputs", "setup", "max_seconds", "trace", "watch"):
        for given in (value, {option: value}, {1: value}, {"X": value}, {"start": value}, {"signals": value}):
            try:
                library.run(**{option: given})
            except (KeyError, TypeError, ValueError, RecursionError) as error:
                str(error)
while deep:
    deep = deep[0]
while wide:
    wide = wide["X"]
""",
        tmp_path,
    )
