"""`cncsub lsp` as an editor talks to it: over its pipes and over a port."""

from __future__ import annotations

import asyncio
import socket
import subprocess
import sys
import time
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
from loops import run_apart
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.lsp.client import LanguageClient

from cncsub.editor.documents import Document
from cncsub.editor.requests import server_for

SERVER = [sys.executable, "-m", "cncsub", "lsp"]
MAIN = "O1 (MAIN)\nN10 M98 P2\nN20 #100=5\nN30 G1 X[#100] F100\nN40 M98 P9\nN50 M30\n"
SUB = "O2 (SUB)\nM99\n"
PATIENCE = 60.0  # seconds


class Client(LanguageClient):
    """The client of pygls, which keeps what the server tells."""

    def __init__(self, *units: str) -> None:
        super().__init__("test", "1")
        self.units = units
        self.said: list[str] = []
        self.found: asyncio.Queue[list[lsp.Diagnostic]] = asyncio.Queue()

        @self.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def published(params: lsp.PublishDiagnosticsParams) -> None:
            self.found.put_nowait(list(params.diagnostics))

        @self.feature(lsp.WINDOW_SHOW_MESSAGE)
        def message(params: lsp.ShowMessageParams) -> None:
            self.said.append(params.message)

    async def begin(self, folder: Path) -> None:
        """Begin a session about a folder."""
        units = [lsp.PositionEncodingKind(unit) for unit in self.units] or None
        capabilities = lsp.ClientCapabilities(
            general=lsp.GeneralClientCapabilities(position_encodings=units)
        )
        folders = [lsp.WorkspaceFolder(folder.as_uri(), "job")]
        await self.initialize_async(lsp.InitializeParams(capabilities, workspace_folders=folders))
        self.initialized(lsp.InitializedParams())

    async def end(self) -> None:
        """End the session, and with it the server."""
        await self.shutdown_async(None)
        self.exit(None)
        await self.stop()


def job(folder: Path) -> Path:
    (folder / "cncsub.toml").write_text('control = "fanuc-0i-f"\n')
    (folder / "O1.nc").write_text(MAIN)
    (folder / "O2.nc").write_text(SUB)
    return folder / "O1.nc"


def talk(folder: Path, ask: Callable[[Any], Awaitable[None]], *units: str) -> None:
    """Talk with a server that serves a folder, in a session that counts in these units."""

    async def whole() -> None:
        client = Client(*units)
        await client.start_io(*SERVER)
        try:
            await asyncio.wait_for(client.begin(folder), PATIENCE)
            await asyncio.wait_for(ask(client), PATIENCE)
        finally:
            await asyncio.wait_for(client.end(), PATIENCE)

    run_apart(whole())


def show(client: Any, path: Path, text: str | None = None) -> lsp.TextDocumentIdentifier:
    uri = path.as_uri()
    text = path.read_text() if text is None else text
    client.text_document_did_open(
        lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(uri, "nc", 1, text))
    )
    return lsp.TextDocumentIdentifier(uri)


def write(
    client: Any, uri: str, version: int, text: str, place: tuple[int, int, int, int] | None = None
) -> None:
    """Put a text in the place of a range, or of all."""
    change: Any = lsp.TextDocumentContentChangeWholeDocument(text)
    if place is not None:
        ends = lsp.Position(*place[:2]), lsp.Position(*place[2:])
        change = lsp.TextDocumentContentChangePartial(range=lsp.Range(*ends), text=text)
    client.text_document_did_change(
        lsp.DidChangeTextDocumentParams(lsp.VersionedTextDocumentIdentifier(version, uri), [change])
    )


async def found(client: Any) -> list[lsp.Diagnostic]:
    """Return the diagnostics that come next."""
    told: list[lsp.Diagnostic] = await client.found.get()
    return told


def test_a_client_gets_its_answers(tmp_path: Path) -> None:
    main = job(tmp_path)

    async def ask(client: Any) -> None:
        shown = show(client, main)
        (missing,) = await found(client)
        assert (missing.code, missing.range.start.line) == ("CS201", 4)
        at = lsp.Position(1, 9)
        definition = await client.text_document_definition_async(lsp.DefinitionParams(shown, at))
        (place,) = definition
        assert place.uri == (tmp_path / "O2.nc").as_uri()
        hover = await client.text_document_hover_async(lsp.HoverParams(shown, lsp.Position(1, 5)))
        assert "calls O2" in hover.contents.value
        outline = await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(shown))
        assert [each.name for each in outline] == ["O1"]
        folded = await client.text_document_folding_range_async(lsp.FoldingRangeParams(shown))
        assert [(each.start_line, each.end_line) for each in folded] == [(0, 5)]
        every = lsp.Range(lsp.Position(0, 0), lsp.Position(9, 0))
        hints = await client.text_document_inlay_hint_async(lsp.InlayHintParams(shown, every))
        assert " = 5" in [each.label for each in hints]
        colours = await client.text_document_semantic_tokens_full_async(
            lsp.SemanticTokensParams(shown)
        )
        assert len(colours.data) % 5 == 0
        words = await client.text_document_completion_async(
            lsp.CompletionParams(shown, lsp.Position(1, 9))
        )
        assert [each.label for each in words.items] == ["P1", "P2"]
        symbols = await client.workspace_symbol_async(lsp.WorkspaceSymbolParams("sub"))
        assert [each.name for each in symbols] == ["O2 SUB"]

    talk(tmp_path, ask)


def test_an_edit_is_checked_soon_and_unsaved_text_counts(tmp_path: Path) -> None:
    main = job(tmp_path)

    async def edit(client: Any) -> None:
        shown = show(client, main)
        assert [each.code for each in await found(client)] == ["CS201"]
        write(client, shown.uri, 2, "2", (4, 9, 4, 10))  # P9 becomes P2
        assert await found(client) == []
        write(client, shown.uri, 3, MAIN)
        assert [each.code for each in await found(client)] == ["CS201"]
        show(client, tmp_path / "O9.nc", "O9\nM99\n")  # a program that was never saved
        assert await found(client) == []

    talk(tmp_path, edit)


@pytest.mark.parametrize(
    ("units", "begin"),
    [((), 14), (("utf-16",), 14), (("utf-8", "utf-16"), 18), (("utf-32",), 13)],
)
def test_columns_are_those_of_the_client(
    tmp_path: Path, units: tuple[str, ...], begin: int
) -> None:
    main = job(tmp_path)

    async def ask(client: Any) -> None:
        show(client, main, "O1\nN10 (\U0001f600\u5f84) M98 P9\nM30\n")
        (missing,) = await found(client)
        assert (missing.range.start.character, missing.range.end.character) == (begin, begin + 2)

    talk(tmp_path, ask, *units)


def test_the_settings_of_a_client_name_the_control(tmp_path: Path) -> None:
    part = tmp_path / "part.nc"

    async def ask(client: Any) -> None:
        shown = show(client, part, "O1\nM30\n")
        at = lsp.HoverParams(shown, lsp.Position(1, 0))
        assert await client.text_document_hover_async(at) is None
        assert any("no control is named" in text for text in client.said)
        client.workspace_did_change_configuration(
            lsp.DidChangeConfigurationParams({"cncsub": {"control": "haas-ngc"}})
        )
        hover = await client.text_document_hover_async(at)
        assert "haas-ngc" in hover.contents.value

    talk(tmp_path, ask)


def test_names_layout_and_numbers_are_changed(tmp_path: Path) -> None:
    main = job(tmp_path)

    async def change(client: Any) -> None:
        shown = show(client, main, "O1\nN1G1X1.F9\nN2M98P2\nM30\n")
        at = lsp.Position(2, 6)
        prepared = await client.text_document_prepare_rename_async(
            lsp.PrepareRenameParams(shown, at)
        )
        assert prepared.placeholder == "2"
        renamed = await client.text_document_rename_async(lsp.RenameParams(shown, at, "5"))
        told = renamed.changes or {
            each.text_document.uri: each.edits
            for each in renamed.document_changes
            if isinstance(each, lsp.TextDocumentEdit)
        }
        assert {uri.rsplit("/", 1)[-1] for uri in told} == {"O1.nc", "O2.nc"}
        with pytest.raises(Exception, match="O1"):
            await client.text_document_rename_async(lsp.RenameParams(shown, at, "1"))
        layout = lsp.FormattingOptions(2, True)
        edits = await client.text_document_formatting_async(
            lsp.DocumentFormattingParams(shown, layout)
        )
        assert edits
        some = await client.text_document_range_formatting_async(
            lsp.DocumentRangeFormattingParams(
                shown, lsp.Range(lsp.Position(2, 0), lsp.Position(2, 5)), layout
            )
        )
        assert {edit.range.start.line for edit in some} == {2}

    talk(tmp_path, change)


def test_commands_run_and_draw_a_program(tmp_path: Path) -> None:
    main = job(tmp_path)
    main.write_text(MAIN.replace("P9", "P2"))

    async def run(client: Any) -> None:
        show(client, main)
        lenses = await client.text_document_code_lens_async(
            lsp.CodeLensParams(lsp.TextDocumentIdentifier(main.as_uri()))
        )
        command = lenses[0].command
        told = await client.workspace_execute_command_async(
            lsp.ExecuteCommandParams(command.command, command.arguments)
        )
        assert "O1" in told
        assert "end" in told
        page = await client.workspace_execute_command_async(
            lsp.ExecuteCommandParams("cncsub.plot", command.arguments)
        )
        assert "<html>" in Path(page).read_text(encoding="utf-8")[:100]

    talk(tmp_path, run)


def test_what_is_no_program_is_answered_too(tmp_path: Path) -> None:
    main = job(tmp_path)

    async def ask(client: Any) -> None:
        text = "\x00\x01%%%((((\ufeff\u2028;;;" * 50 + "\n" + "[" * 5000 + "\nO1O1O1\n#=#=#[\n"
        shown = show(client, main, text)
        await found(client)
        for line in range(5):
            at = lsp.Position(line, 3)
            await client.text_document_hover_async(lsp.HoverParams(shown, at))
            await client.text_document_definition_async(lsp.DefinitionParams(shown, at))
        await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(shown))
        other = lsp.TextDocumentIdentifier("untitled:Untitled-1")
        assert not await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(other))

    talk(tmp_path, ask)


def test_a_large_program_is_opened_and_edited_while_one_types(tmp_path: Path) -> None:
    main = job(tmp_path)
    body = "".join(f"N{n} G1 X{n % 300 / 10:.3f} Y{n % 77}.5 F200.\n" for n in range(1, 100_001))

    async def edit(client: Any) -> None:
        begun = time.monotonic()
        shown = show(client, main, f"O1\n{body}M30\n")
        await found(client)
        opened = time.monotonic() - begun
        begun = time.monotonic()
        write(client, shown.uri, 2, "M98 P77 ", (50_000, 7, 50_000, 7))
        at = lsp.Position(50_000, 9)
        await client.text_document_completion_async(lsp.CompletionParams(shown, at))
        answered = time.monotonic() - begun
        codes = [each.code for each in await found(client)]
        checked = time.monotonic() - begun
        assert codes == ["CS201"]
        # A free machine takes 0.4 s, 50 ms and 0.2 s; this one may have other work.
        assert opened < 10
        assert answered < 3
        assert checked < 6

    talk(tmp_path, edit)


def test_a_key_does_not_wait_for_what_takes_long(tmp_path: Path) -> None:
    main = job(tmp_path)
    body = "".join(f"N{n} #1=#1+1\nIF[#1LT3]GOTO{n}\n" for n in range(1, 20_001))

    async def ask(client: Any) -> None:
        shown = show(client, main, f"O1\n{body}M30\n")
        await found(client)
        order = []

        async def asked(what: str, answer: Awaitable[Any]) -> None:
            await answer
            order.append(what)

        at = lsp.CompletionParams(shown, lsp.Position(20_001, 1))
        outline = client.text_document_document_symbol_async(lsp.DocumentSymbolParams(shown))
        words = client.text_document_completion_async(at)
        await asyncio.gather(asked("outline", outline), asked("completion", words))
        assert order == ["completion", "outline"]

    talk(tmp_path, ask)


def test_an_answer_about_a_text_that_has_changed_is_an_error(tmp_path: Path) -> None:
    server, path = server_for("fanuc-0i-f"), str(tmp_path / "a.nc")
    server.memories.put(path, Document.of("O1\nM30\n"))
    shown = server.memories.documents[path]

    def answer() -> int:
        server.memories.put(path, Document.of("O2\nM30\n"))
        return 1

    for answered in (answer, lambda: 1):  # it changes while it is looked at, and before
        with pytest.raises(JsonRpcException, match="has changed") as told:
            run_apart(server.answered(path, shown, answered))
        assert told.value.code == lsp.LSPErrorCodes.ContentModified.value
    assert run_apart(server.answered(path, server.memories.documents[path], lambda: 1)) == 1


def test_a_server_on_a_port_serves_one_client(tmp_path: Path) -> None:
    main = job(tmp_path)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    server = subprocess.Popen([*SERVER, "--port", str(port)])

    async def ask() -> None:
        client = Client()
        for _ in range(100):
            try:
                await client.start_tcp("127.0.0.1", port)
                break
            except OSError:
                await asyncio.sleep(0.1)
        await client.begin(tmp_path)
        show(client, main)
        assert [each.code for each in await found(client)] == ["CS201"]
        await client.end()

    def page() -> bytes:
        """Return what a page in a browser is told that sends a message to the port."""
        message = b'{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}'
        request = b"POST / HTTP/1.1\r\nContent-Length: %d\r\n\r\n%s" % (len(message), message)
        for _ in range(100):
            try:
                with socket.create_connection(("127.0.0.1", port)) as connection:
                    connection.settimeout(20)
                    connection.sendall(request)
                    return connection.recv(4096)
            except ConnectionResetError:
                return b""
            except OSError:
                time.sleep(0.1)
        raise AssertionError("the server does not listen")

    try:
        assert page() == b""
        run_apart(asyncio.wait_for(ask(), 60))
    finally:
        server.terminate()
        server.wait(20)


def test_settings_that_say_nothing_of_debugging_leave_its_lens() -> None:
    server = server_for(None)
    server.configure({"debug": True})
    server.configure({"cncsub": {"control": "haas-ngc"}})
    assert server.debugs
    assert server.memories.settings.control == "haas-ngc"
    server.configure({"debug": False})
    assert not server.debugs


def test_drawn_pages_are_removed_with_the_server() -> None:
    server = server_for(None)
    folder = server.pages
    assert folder.is_dir()
    assert server.pages == folder
    server.remove_pages()
    assert not folder.exists()
