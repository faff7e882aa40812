"""The extension for VS Code: its colours beside the words of the engine, its parts, its package."""

from __future__ import annotations

import json
import logging
import shutil
import subprocess
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
import vsix
from makers import CONTROLS

import cncsub
from cncsub.dap.launching import KEYS

ROOT = Path(__file__).parent.parent
FOLDER = ROOT / "editors" / "vscode"
PACKAGE: dict[str, Any] = json.loads((FOLDER / "package.json").read_text("utf-8"))
GRAMMAR = json.loads((FOLDER / "syntaxes" / "nc.tmLanguage.json").read_text("utf-8"))


# ---- colours ----


@pytest.fixture(scope="module")
def coloured() -> Any:
    """Return a function that gives the scope of each piece of a line."""
    base = pytest.importorskip(
        "textmate_grammar.parsers.base", reason="pip install textmate-grammar-python"
    )
    logging.getLogger("textmate_grammar").setLevel(logging.ERROR)
    parser = base.LanguageParser(GRAMMAR)

    def scopes(line: str) -> list[tuple[int, str, str]]:
        element = parser.parse_string(line + "\n")
        pieces = [] if element is None else element.flatten()
        return [(at[1], text, kinds[-1]) for at, text, kinds in pieces if at[0] == 0]

    return scopes


WORDS = [
    ("N10", "entity.name.label.nc"),
    ("G54.1", "keyword.other.code.nc"),
    ("M98", "keyword.other.code.nc"),
    ("X-1.5", "constant.numeric.word.nc"),
    ("P9000", "constant.numeric.word.nc"),
    ("#100", "variable.other.nc"),
    ("#<depth>", "variable.other.nc"),
    ("(A COMMENT)", "comment.block.nc"),
    ("IF", "keyword.control.nc"),
    ("GOTO", "keyword.control.nc"),
    ("SIN", "support.function.nc"),
]


@pytest.mark.parametrize(("word", "scope"), WORDS)
def test_each_kind_of_word_has_its_colour(coloured: Any, word: str, scope: str) -> None:
    assert coloured(word) == [(0, word, scope)]


def _blocks() -> Iterator[Any]:
    for folder, control in CONTROLS.items():
        for file in sorted((ROOT / "examples" / folder).rglob("*")):
            if file.suffix.lower() in (".nc", ".ngc", ".mpf", ".spf"):
                library = cncsub.load(file, control=control)
                for program in library.values():
                    yield from program.blocks


def test_words_and_comments_begin_where_the_engine_begins_them(coloured: Any) -> None:
    """Token by token beside `Block.tokens`, over all examples: a comment is a comment and nothing
    else is; N, G and M have their colours; a word with an address and a number is one piece.
    """
    count = 0
    for block in _blocks():
        scopes = [""] * len(block.text)
        for at, text, scope in coloured(block.text):
            scopes[at : at + len(text)] = [scope] * len(text)
        column = block.tokens[0].column if block.tokens else 1
        for token in block.tokens:
            place = (block.program.file, block.line, token.text)
            letters = {
                *scopes[token.column - column : token.column - column + len(token.text.rstrip())]
            }
            is_comment = all(scope.startswith("comment") for scope in letters)
            if token.kind in ("comment", "word"):
                assert (token.kind == "comment") == is_comment, (*place, letters)
            word = token.word
            if (
                word is None
                or word.value is None
                or not word.address.isalpha()
                or len(word.address) > 1
            ):
                continue
            count += 1
            wanted = {"N": "entity.name.label", "G": "keyword.other", "M": "keyword.other"}
            assert len(letters) == 1, (*place, letters)
            assert letters.pop().startswith(wanted.get(word.address, "constant.numeric.word")), (
                place
            )
    assert count > 500


# ---- parts ----


def test_what_the_package_names_is_there() -> None:
    contributes = PACKAGE["contributes"]
    named = [
        PACKAGE["main"],
        *(each["configuration"] for each in contributes["languages"]),
        *(each["path"] for each in contributes["grammars"]),
        *(
            step["media"]["markdown"]
            for walk in contributes["walkthroughs"]
            for step in walk["steps"]
        ),
    ]
    assert not [name for name in named if not (FOLDER / name).is_file()]
    code = (FOLDER / "extension.js").read_text("utf-8")
    settings = contributes["configuration"]["properties"]
    assert not [name for name in settings if f'get("{name.removeprefix("cncsub.")}")' not in code]
    assert PACKAGE["version"] == cncsub.__version__


def test_the_debug_configuration_is_one_that_the_adapter_takes() -> None:
    (debugger,) = PACKAGE["contributes"]["debuggers"]
    given = dict.fromkeys(debugger["configurationAttributes"]["launch"]["properties"])
    assert not [name for name in given if name not in KEYS]


STUB = """
const Module = require("module");
const registered = [], told = [];
const disposable = { dispose() {} };
const vscode = {
  window: { showWarningMessage: (text) => told.push(text), activeTextEditor: undefined },
  workspace: {
    getConfiguration: () => ({ get: (name) => (name === "command" ? ["cncsub"] : null) }),
    createFileSystemWatcher: () => disposable,
  },
  commands: { registerCommand: (name) => (registered.push(name), disposable) },
  debug: { registerDebugAdapterDescriptorFactory: (kind, made) => {
    const adapter = made.createDebugAdapterDescriptor(); told.push(`${kind}: ${adapter.words}`); return disposable; } },
  tasks: { registerTaskProvider: (kind, made) => {
    for (const task of made.provideTasks()) told.push(`task: ${task.words}`); return disposable; } },
  DebugAdapterExecutable: class { constructor(p, a) { this.words = [p, ...a].join(" "); } },
  ProcessExecution: class { constructor(p, a) { this.words = [p, ...a].join(" "); } },
  Task: class { constructor(d, s, n, o, e) { this.words = e.words; } },
  TaskScope: { Workspace: 2 },
};
const started = [];
const library = { LanguageClient: class {
  constructor(id, name, server, options) { started.push({ server, options }); }
  async start() {} async stop() {} } };
const load = Module._load;
Module._load = (name, ...rest) => {
  if (name === "vscode") return vscode;
  if (name.startsWith("vscode-languageclient")) {
    if (process.argv[3] === "bare") throw new Error("not packed");
    return library;
  }
  return load(name, ...rest);
};
const extension = require(process.argv[2]);
extension.activate({ subscriptions: [] }).then(async () => {
  await extension.deactivate();
  console.log(JSON.stringify({ registered, told, started }));
});
"""


def activated(folder: Path, *words: str) -> dict[str, Any]:
    """Return what the extension does when it is started in a VS Code without windows."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("Node.js is not installed: apt-get install nodejs")
    stub = folder / "stub.js"
    stub.write_text(STUB)
    done = subprocess.run(
        [node, str(stub), str(FOLDER / "extension.js"), *words],
        capture_output=True, text=True, timeout=60, check=True,
    )  # fmt: skip
    told: dict[str, Any] = json.loads(done.stdout)
    return told


def test_the_extension_starts_the_server_the_adapter_and_the_tasks(tmp_path: Path) -> None:
    told = activated(tmp_path)
    commands = [each["command"] for each in PACKAGE["contributes"]["commands"]]
    assert sorted(told["registered"]) == sorted(commands)
    (started,) = told["started"]
    assert started["server"] == {"command": "cncsub", "args": ["lsp"]}
    assert started["options"]["synchronize"]["configurationSection"] == "cncsub"
    assert {"scheme": "file", "pattern": "**/cncsub.toml"} in started["options"]["documentSelector"]
    assert set(started["options"]["initializationOptions"]) == {
        "control", "run", "maxBlocks", "maxSeconds", "debug",
    }  # fmt: skip
    assert told["told"] == [
        "cncsub: cncsub dap",
        "task: cncsub check ${file}",
        "task: cncsub run ${file}",
    ]


def test_an_extension_without_the_client_says_so(tmp_path: Path) -> None:
    told = activated(tmp_path, "bare")
    assert any("packed without vscode-languageclient" in text for text in told["told"])
    assert told["started"] == []


# ---- the package ----


def test_the_package_is_a_vsix_and_the_same_each_time(tmp_path: Path) -> None:
    first, second = tmp_path / "a.vsix", tmp_path / "b.vsix"
    assert vsix.main([str(FOLDER), str(first)]) == 0
    assert vsix.main([str(FOLDER), str(second)]) == 0
    assert first.read_bytes() == second.read_bytes()
    with zipfile.ZipFile(first) as packed:
        names = packed.namelist()
        assert names[:2] == ["extension.vsixmanifest", "[Content_Types].xml"]
        root = ElementTree.fromstring(packed.read("extension.vsixmanifest"))
        types = ElementTree.fromstring(packed.read("[Content_Types].xml"))
    space = "{http://schemas.microsoft.com/developer/vsx-schema/2011}"
    identity = root.find(f"{space}Metadata/{space}Identity")
    assert identity is not None
    assert (identity.get("Id"), identity.get("Version")) == ("cncsub", cncsub.__version__)
    assets = [each.get("Path") for each in root.iter(f"{space}Asset")]
    assert not [path for path in assets if path not in names]
    endings = {each.get("Extension") for each in types}
    assert {Path(name).suffix for name in names[2:]} <= endings


def test_what_npm_installed_is_packed_and_what_is_hidden_is_not(tmp_path: Path) -> None:
    folder = tmp_path / "vscode"
    shutil.copytree(FOLDER, folder, ignore=shutil.ignore_patterns("node_modules"))
    client = folder / "node_modules" / "vscode-languageclient"
    client.mkdir(parents=True)
    (client / "node.js").write_text("")
    (folder / ".hidden").write_text("")
    names = vsix.pack(folder, tmp_path / "c.vsix")
    assert "extension/node_modules/vscode-languageclient/node.js" in names
    assert not [name for name in names if ".hidden" in name]
