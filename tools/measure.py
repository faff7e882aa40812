"""Measures the house: how large its files, functions and classes are, and how true its facts.

    python tools/measure.py                        # what the sources and the controls tell: seconds
    python tools/measure.py --rows                 # and what the rows tell: minutes
    python tools/measure.py --functions build/dev  # and what clang-tidy tells of a build: minutes
    python tools/measure.py --write ...            # the same, put into docs/developers.md

What was not measured keeps the figure of the page.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
ENGINE, FACTS = ROOT / "cpp" / "cncsub", ROOT / "cpp" / "controls"
CONFORMANCE = ROOT / "tests" / "conformance"
PAGE = ROOT / "docs" / "developers.md"
BEGIN, END = "<!-- measures -->", "<!-- end of measures -->"

# A function that is longer or more complex than this is told by the linter.
LINES, COMPLEXITY = 40, 20


class Measure(NamedTuple):
    what: str
    aim: str


MEASURES = {
    "engine-file": Measure("lines of the largest C++ file of the engine", "400"),
    "facts-file": Measure("lines of the largest C++ file of facts", "400"),
    "control-file": Measure("lines of a control's file, median", "60"),
    "long-functions": Measure(f"functions over {LINES} lines, besides the exceptions", "0"),
    "complicated": Measure(
        f"functions of a cognitive complexity over {COMPLEXITY}, besides the exceptions", "0"
    ),
    "complexity": Measure("highest cognitive complexity, besides the exceptions", str(COMPLEXITY)),
    "exceptions": Measure("functions that say why they are an exception", "5"),
    "class": Measure("functions of the largest class", "25"),
    "booleans": Measure("rules that are plain booleans", "40"),
    "relative": Measure("files that name a relative of a known control", "3"),
    "sources": Measure("rules stronger than inferred that cite no known source", "0"),
    "texts": Measure("alarm texts unlike the printed list of their number", "0"),
    "entries": Measure("entries of lists that no row notices", "0"),
    "words": Measure("motion alarms of rows that point at another word than the row says", "0"),
}


# ---- the sources ----


def sources(folder: Path) -> Iterator[Path]:
    yield from (file for file in sorted(folder.rglob("*")) if file.suffix in (".cpp", ".hpp"))


def lines_of(file: Path) -> int:
    return len(file.read_text(encoding="utf-8").splitlines())


def largest(folder: Path) -> str:
    lines, file = max((lines_of(file), file) for file in sources(folder))
    return f"{lines}: {file.relative_to(folder)}"


def control_files() -> list[Path]:
    """The files that hold one control each: those in a folder of a maker, less the families."""
    return [f for f in sorted(FACTS.glob("*/*.cpp")) if not f.stem.startswith("family")]


_NOISE = re.compile(
    r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'|^\s*#[^\n]*", re.S | re.M
)
_HEAD = re.compile(r"\b(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^;{]*)?\{")
_FUNCTION = re.compile(r"(?:[\w>&*\]]\s+[&*]*|^\s*|~)(operator\S+|~?\w+)\s*\([^;]*$", re.S)


def functions_of_classes() -> Iterator[tuple[int, str]]:
    """How many functions each class declares, by its name."""
    for file in sources(ENGINE):
        text = _NOISE.sub(" ", file.read_text(encoding="utf-8"))
        for head in _HEAD.finditer(text):
            yield sum(map(_declares_function, _members(text, head.end()))), head[1]


def _members(text: str, place: int) -> Iterator[str]:
    """What stands between the braces of a class, member by member, without the inner braces."""
    depth, member = 1, ""
    for c in text[place:]:
        depth += (c == "{") - (c == "}")
        if depth == 0:
            return
        if (c == ";" and depth == 1) or (c == "}" and depth == 1):
            yield member
            member = ""
        elif depth == 1 and c != "}":
            member += c


def _declares_function(member: str) -> bool:
    member = re.sub(r"\b(?:public|private|protected)\s*:", " ", member).strip()
    before, paren, _ = member.partition("(")
    if (
        not paren
        or "=" in before.replace("operator=", "")
        or re.match(r"using|friend|static_assert|enum", member)
    ):
        return False
    return _FUNCTION.search(before + "(") is not None


def exceptions() -> int:
    """Functions that the checks of size and complexity leave out, each with its reason."""
    marks = (
        re.findall(r"NOLINT\w*\(readability-function-", file.read_text()) for file in _all_sources()
    )
    return sum(map(len, marks))


def _all_sources() -> Iterator[Path]:
    yield from sources(ENGINE)
    yield from sources(FACTS)


def files_of_a_relative() -> str:
    """Of the control that the fewest files name, those files: its facts, its rows, its example."""
    names = {file: name_of(file) for file in control_files()}
    tracked = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    counts = {name: {file} for file, name in names.items()}
    for file in map(ROOT.joinpath, tracked.stdout.splitlines()):
        # A source says which controls it is of; `entries.json` is written by `entries.py`.
        if (
            file.suffix in (".svg", ".md")
            or file.name in ("sources.def", "entries.json")
            or not file.is_file()
        ):
            continue
        text = file.read_text(encoding="utf-8", errors="ignore")
        for name in counts:
            if re.search(rf"\b{re.escape(name)}\b", text):
                counts[name].add(file)
    fewest = min(counts, key=lambda name: len(counts[name]))
    return f"{len(counts[fewest])}: {fewest}"


def name_of(file: Path) -> str:
    return f"{file.parent.name}-{file.stem.replace('_', '-')}"


def of_the_sources() -> dict[str, str]:
    count, name = max(functions_of_classes())
    return {
        "engine-file": largest(ENGINE),
        "facts-file": largest(FACTS),
        "control-file": f"{statistics.median(map(lines_of, control_files())):g}",
        "class": f"{count}: {name}",
        "exceptions": str(exceptions()),
        "relative": files_of_a_relative(),
    }


# ---- the facts ----


def of_the_facts() -> dict[str, str]:
    import cncsub
    from cncsub import _core

    every = [(control, rule) for control in cncsub.controls.values() for rule in control.rules]
    lacking = {
        f"{control.name}: {rule.name}"
        for control, rule in every
        if rule.evidence != "inferred" and not _core.cited(rule.source)
    }
    unlike = [
        f"{control.name}: {alarm.number}"
        for control in cncsub.controls.values()
        for alarm in control.alarms.values()
        if alarm.number and alarm.printed and alarm.text not in printed(control.name, alarm.number)
    ]
    return {
        "booleans": str(len({rule.name for _, rule in every if isinstance(rule.value, bool)})),
        "sources": _told(sorted(lacking)),
        "texts": _told(unlike),
    }


def printed(control: str, number: str) -> set[str]:
    """The texts of a number in the lists of the control's maker."""
    found: set[str] = set()
    for file in (FACTS / control.partition("-")[0]).glob("*.def"):
        for listed, text in re.findall(
            r'LISTED\("([^"]*)", "(.*?)"[,)]', file.read_text(encoding="utf-8")
        ):
            found |= {text.replace('\\"', '"')} if listed == number else set()
    return found


def of_the_rows() -> dict[str, str]:
    sys.path.insert(0, str(CONFORMANCE))
    import cncsub
    from cncsub.testing.outcome import execute, load
    from conformance import motion_causes, rows
    from entries import unnoticed

    causes, wrong = motion_causes(), []
    for row in rows():
        if row.case.alarm in causes:
            alarm = execute(row.case, load(row.case, cncsub.controls[row.control])).alarm
            if alarm is None or alarm.word != row.case.word_on(row.control):
                wrong.append(str(row))
    return {"entries": _told(unnoticed()), "words": _told(wrong)}


def _told(faults: list[str]) -> str:
    for fault in faults:
        print(fault, file=sys.stderr)
    return str(len(faults))


# ---- the functions, by the linter ----


def of_the_functions(build: Path) -> dict[str, str]:
    """Sizes and complexities as clang-tidy counts them, function by function."""
    options = {
        "readability-function-size.LineThreshold": str(LINES),
        "readability-function-size.StatementThreshold": "none",
        "readability-function-cognitive-complexity.Threshold": str(COMPLEXITY),
        "readability-function-cognitive-complexity.IgnoreMacros": "true",
    }
    checks = "-*,readability-function-size,readability-function-cognitive-complexity"
    config = json.dumps({"Checks": checks, "CheckOptions": options})
    tool = Path(sys.executable).parent / "clang-tidy"
    command = [str(tool if tool.exists() else tool.name), "-quiet", f"-p={build}"]
    command += [f"--config={config}", "--header-filter=cpp/(cncsub|controls)/"]
    command += ["-extra-arg=-Wno-everything"]

    def told(file: Path) -> str:
        asked = [*command, str(file)]
        return subprocess.run(asked, capture_output=True, text=True, check=False).stdout

    files = [file for file in _all_sources() if file.suffix == ".cpp"]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        text = "\n".join(pool.map(told, files))
    long = _found(text, r"exceeds (?:.*\n){3}.*?note: (\d+) lines including")
    complicated = _found(text, r"has cognitive complexity of (\d+)")
    for what, those in (("lines", long), ("complexity", complicated)):
        for count, name, place in those:
            print(f"{os.path.relpath(place, ROOT)}: {name}: {what} {count}", file=sys.stderr)
    highest = complicated[0] if complicated else (COMPLEXITY, "at most", "")
    return {
        "long-functions": str(len(long)),
        "complicated": str(len(complicated)),
        "complexity": f"{highest[0]}: {highest[1]}",
    }


def _found(text: str, told: str) -> list[tuple[int, str, str]]:
    """What the linter tells of functions, each once: the largest count first, name, place."""
    pattern = rf"^(\S+?:\d+):\d+: warning: function '([^']+)' {told}"
    found = {(int(m[3]), m[2], m[1]) for m in re.finditer(pattern, text, re.MULTILINE)}
    return sorted(found, reverse=True)


# ---- the page ----


def figures(text: str) -> dict[str, str]:
    """The figures of a table that stands on the page."""
    named = {measure.what: key for key, measure in MEASURES.items()}
    rows = re.findall(r"^\| (.*?) \| (.*?) \| (.*?) \|$", text, re.M)
    return {named[what]: figure for what, figure, _ in rows if what in named}


def table(found: Mapping[str, str]) -> str:
    head = ["| measure | now | aim |", "| --- | --: | --: |"]
    return "\n".join(
        head + [f"| {m.what} | {found.get(key, '')} | {m.aim} |" for key, m in MEASURES.items()]
    )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--rows", action="store_true", help="what the rows tell")
    parser.add_argument(
        "--functions", type=Path, metavar="BUILD", help="the folder of compile_commands.json"
    )
    parser.add_argument("--write", action="store_true", help=f"put the table into {PAGE.name}")
    asked = parser.parse_args()
    text = PAGE.read_text(encoding="utf-8") if PAGE.exists() else ""
    found = figures(text) | of_the_sources() | of_the_facts()
    if asked.rows:
        found |= of_the_rows()
    if asked.functions:
        found |= of_the_functions(asked.functions)
    print(table(found))
    if asked.write:
        before, _, rest = text.partition(BEGIN)
        _, _, behind = rest.partition(END)
        PAGE.write_text(f"{before}{BEGIN}\n{table(found)}\n{END}{behind}", encoding="utf-8")


if __name__ == "__main__":
    main()
