"""The package for JavaScript in Node, where it was built: `sh tools/playground.sh`."""

from __future__ import annotations

import json
import re
import shutil
import sys
from pathlib import Path

import pytest
from commands import done

import cncsub

ROOT = Path(__file__).resolve().parent.parent
BUILT = ROOT / "build" / "playground"
PACKAGE = BUILT / "package"
SELFTEST = BUILT / "wasm" / "cpp" / "selftest" / "selftest.js"
SOURCES = ROOT / "javascript"


@pytest.fixture(scope="module")
def package() -> Path:
    if not (PACKAGE / "cncsub.wasm").exists():
        pytest.skip("the package was not built: sh tools/playground.sh, which needs Emscripten")
    if shutil.which("node") is None:
        pytest.skip("there is no Node here")
    return PACKAGE


@pytest.fixture(scope="module")
def rows(package: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return all rows of the self-test, as they come out here."""
    file = tmp_path_factory.mktemp("rows") / "selftest.rows"
    done(sys.executable, ROOT / "tools" / "selftest_rows.py", file)
    return file


def node(package: Path, source: str, folder: Path) -> object:
    """Return what a module prints, which has `cncsub` and `start` of the package, as JSON."""
    file = folder / "told.mjs"
    begin = f"import * as all from {json.dumps((package / 'cncsub.js').as_uri())};\n"
    file.write_text(begin + "const { start } = all;\nconst cncsub = await start();\n" + source)
    return json.loads(done("node", file))


def test_all_rows_of_the_selftest_pass_in_node(rows: Path) -> None:
    printed = done("node", "--stack-size=4000", SELFTEST, rows)
    counted = re.search(r"(\d+) passed, 0 failed", printed)
    assert counted is not None, printed
    assert int(counted[1]) > 20_000


def test_the_rows_come_out_alike_through_the_package(package: Path, rows: Path) -> None:
    printed = done("node", ROOT / "tests" / "javascript" / "rows.js", package, rows)
    told = json.loads(printed.splitlines()[-1])
    assert told["failed"] == 0, printed[-3000:]
    assert told["rows"] == told["passed"] + sum(told["left_out"].values()) > 20_000
    assert told["passed"] > 15_000, told


def test_the_example_tells_what_python_tells(package: Path) -> None:
    printed = done("node", package / "example.js")
    assert "rapid to X 5, machine 105" in printed
    alarm = (
        cncsub.loads({"program.nc": "O1\nN10 G1 X1.\nN20 M30\n"}, control="fanuc-0i-f").run().alarm
    )
    assert str(alarm) in printed
    assert "because of zero_repeats: once and skip" in printed


@pytest.mark.parametrize("page", ["javascript/README.md", "docs/trying.md"])
def test_a_page_runs_as_it_says(package: Path, tmp_path: Path, page: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    snippets = re.findall(r"```js\n(.*?)```\n+```text\n(.*?)```", text, re.DOTALL)
    assert len(snippets) == text.count("```js\n") > 0
    shutil.copytree(package, tmp_path / "node_modules" / "cncsub")
    for source, printed in snippets:
        (tmp_path / "snippet.mjs").write_text(source)
        assert done("node", "snippet.mjs", cwd=tmp_path) == printed


def test_the_types_compile(package: Path, tmp_path: Path) -> None:
    if shutil.which("tsc") is None:
        pytest.skip("there is no TypeScript here (Debian: apt-get install node-typescript)")
    shutil.copytree(package, tmp_path / "node_modules" / "cncsub")
    shutil.copy(ROOT / "tests" / "javascript" / "types.ts", tmp_path)
    strict = ("--strict", "--noEmit", "--target", "es2022", "--module", "es2022")
    done("tsc", *strict, "--moduleResolution", "node", "types.ts", cwd=tmp_path)


def test_the_types_name_what_is_there(package: Path, tmp_path: Path) -> None:
    """A name that only the types have, or only the package, is a mistake in one of them."""
    told = node(
        package,
        """
        const names = (of) => of === null || of === Object.prototype ? []
          : [...Object.getOwnPropertyNames(of), ...names(Object.getPrototypeOf(of))];
        const classes = Object.entries(all).filter(([, one]) => typeof one === "function" && one.prototype);
        console.log(JSON.stringify(Object.fromEntries(classes.map(([name, one]) => [name, names(one.prototype)]))));
        """,
        tmp_path,
    )
    assert isinstance(told, dict)
    text = (package / "cncsub.d.ts").read_text(encoding="utf-8")
    held = {"free"}
    for name, names in told.items():
        body = re.search(rf"class {name}( extends Held)? {{\n(.*?)\n}}", text, re.DOTALL)
        assert body is not None, name
        typed = set(re.findall(r"^  (?:readonly )?(\w+)[(:]", body[2], re.MULTILINE)) - {"private"}
        there = {one for one in names if not one.startswith("_") and one != "constructor"}
        assert typed | (held if body[1] else set()) == there, name


def test_wrong_use_throws_and_says_why(package: Path, tmp_path: Path) -> None:
    told = node(
        package,
        """
        const library = cncsub.load("O1\\nN10 #100=1\\nN20 M30\\n", "fanuc-0i-f");
        const freed = cncsub.load("M30", "fanuc-0i-f");
        freed.free();
        freed.free();
        const tried = [
          () => cncsub.load("M30", "fanuc-99"),
          () => cncsub.load("M30", "fanuc-0i-f", { max_nestin: 1 }),
          () => cncsub.load("M30", "fanuc-0i-f", { max_nesting: "1\\nzero_repeats=once" }),
          () => cncsub.load({ "a.nc": 3 }, "fanuc-0i-f"),
          () => library.run({ max_blocks: 3 }),
          () => library.run({ maxBlocks: "3" }),
          () => library.run({ maxBlocks: NaN }),
          () => library.run({ record: "all" }),
          () => library.run({ main: "O7" }),
          () => library.run({ workOffsets: { G54: { XX: 1 } } }),
          () => library.run().variable(1.5),
          () => library.run().variable(999999),
          () => library.machine().runTo("O1", 99),
          () => library.machine().setVariable(0, 1),
          () => freed.run(),
        ].map((work) => { try { work(); return "nothing"; } catch (error) { return `${error.name}: ${error.message}`; } });
        const machine = library.machine();
        const values = [machine.variable(100), machine.runTo("O1", 20), machine.variable(100), library.run().step(99),
          library.run().step(-1), machine.position("q"), machine.run(), machine.stop, machine.step()];
        console.log(JSON.stringify({ tried, values, empty: cncsub.load([], "fanuc-0i-f").programs }));
        """,
        tmp_path,
    )
    assert isinstance(told, dict)
    assert told["values"] == [None, True, 1, None, None, None, False, "end", False]
    assert told["empty"] == []
    for message, why in zip(
        told["tried"],
        (
            "Error: there is no control fanuc-99; did you mean fanuc-16i, ",
            "Error: there is no rule max_nestin",
            "TypeError: max_nesting is no rule or parameter with one value",
            "TypeError: the text of a.nc must be a string or a Uint8Array",
            "TypeError: there is no option max_blocks; there are blockSkip",
            "TypeError: maxBlocks must be a number, not 3",
            "Error: there is no option max_blocks that takes this number",
            "TypeError: record is one of nothing, calls, blocks, moves, not all",
            "Error: there is no program O7",
            "TypeError: an axis is one letter, not XX",
            "TypeError: a variable must be a whole number, not 1.5",
            "RangeError: ",
            "Error: there is no block N99 in O1",
            "Error: ",
            "Error: this Library was freed",
        ),
        strict=True,
    ):
        assert message.startswith(why), message


def test_what_is_forgotten_is_freed(package: Path, tmp_path: Path) -> None:
    """Ten thousand runs, none of them freed, take no more memory than some hundred."""
    file = tmp_path / "forgotten.mjs"
    file.write_text(
        f"""
        import {{ start }} from {json.dumps((package / "cncsub.js").as_uri())};
        const cncsub = await start();
        const library = cncsub.load("O1\\nN10 #1=#1+1\\nN20 IF[#1 LT 200]GOTO10\\nM30\\n", "fanuc-0i-f");
        for (let i = 0; i < 10000; ++i) {{
          library.run();
          if (i % 200 === 0) {{ globalThis.gc(); await new Promise((done) => setTimeout(done)); }}
        }}
        console.log(process.memoryUsage().arrayBuffers + process.memoryUsage().external);
        """
    )
    assert int(done("node", "--expose-gc", file)) < 150_000_000


def test_the_package_is_whole(package: Path) -> None:
    told = json.loads((package / "package.json").read_text())
    assert told["version"] == cncsub.__version__
    named = {name.removeprefix("./") for name in (told["main"], told["types"], *told["files"])}
    assert {file.name for file in package.iterdir()} == named | {
        "package.json",
        "README.md",
        "LICENSE",
    }
