"""The requests of an editor, each answered from one version of its memory."""

from __future__ import annotations

import contextlib
import functools
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from typing import Any, TypeVar

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException

from cncsub.editing import EditError
from cncsub.editor import completing, explaining, navigation, rewriting, shown, symbols
from cncsub.editor.commands import plot_program, run_program
from cncsub.editor.diagnostics import RENUMBER, actions
from cncsub.editor.documents import UNITS, Document
from cncsub.editor.memory import is_project
from cncsub.editor.project_names import names_at
from cncsub.editor.server import Server, path_of
from cncsub.editor.snapshot import Snapshot

T = TypeVar("T")
U = TypeVar("U")

_TRIGGERS = ["#", "$", "P", "O", "N", "=", '"', " "]  # after which a client asks what can follow


def server_for(control: str | None) -> Server:
    """Return a server that answers all requests; `control` is that of files that name none."""
    server = Server(control)
    _register_life(server)
    _register_documents(server)
    _register_navigation(server)
    _register_words(server)
    _register_looks(server)
    _register_changes(server)
    _register_commands(server)
    return server


def _asked(server: Server, uri: str, answer: Callable[[Snapshot, str], T], otherwise: U) -> T | U:
    path = path_of(uri)
    snap = server.memories.snapshot(path)
    return otherwise if snap is None else answer(snap, path)


Later = Generator[Any, Any, T]  # of pygls: what it waits for, then the answer


def _later(server: Server, uri: str, answer: Callable[[Snapshot, str], T]) -> Later[T | None]:
    """Answer a request that looks at much: others are answered meanwhile."""
    path = path_of(uri)
    document = server.memories.documents.get(path)  # as it is now

    def asked() -> T | None:
        return _asked(server, uri, answer, None)

    found: T | None = yield server.answered, (path, document, asked), None
    return found


def _at(
    server: Server, params: Any, answer: Callable[[Snapshot, str, int, int], T], otherwise: T
) -> T:
    """Answer a request about a place."""

    return _asked(server, params.text_document.uri, _placed(params, answer), otherwise)


def _placed(
    params: Any, answer: Callable[[Snapshot, str, int, int], T]
) -> Callable[[Snapshot, str], T]:
    def placed(snap: Snapshot, path: str) -> T:
        line, character = snap.document(path).place(params.position)
        return answer(snap, path, line, character)

    return placed


def _register_life(server: Server) -> None:
    @server.feature(lsp.INITIALIZE)
    def initialize(ls: Server, params: lsp.InitializeParams) -> None:
        encoding = ls.workspace.position_encoding
        units = getattr(encoding, "value", encoding)
        ls.memories.units = units if units in UNITS else UNITS[0]
        folders = [folder.uri for folder in params.workspace_folders or ()]
        folders = folders or ([params.root_uri] if params.root_uri else [])
        ls.memories.folders = tuple(map(path_of, folders))
        ls.configure(params.initialization_options or {})

    @server.feature(lsp.SHUTDOWN)
    def shut_down(ls: Server, params: None) -> None:
        ls.remove_pages()

    @server.feature(lsp.WORKSPACE_DID_CHANGE_CONFIGURATION)
    async def configured(ls: Server, params: lsp.DidChangeConfigurationParams) -> None:
        settings = params.settings
        asked = ls.client_capabilities.workspace
        if not settings and asked is not None and asked.configuration:
            items = [lsp.ConfigurationItem(section="cncsub")]
            [settings] = await ls.workspace_configuration_async(lsp.ConfigurationParams(items))
        if settings:
            ls.configure(settings)
        for path in ls.memories.documents:
            ls.checked_soon(path)

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(ls: Server, params: lsp.DidChangeWorkspaceFoldersParams) -> None:
        ls.memories.folders = tuple(map(path_of, ls.workspace.folders))
        ls.memories.read_disk_again()

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(ls: Server, params: lsp.DidChangeWatchedFilesParams) -> None:
        ls.memories.read_disk_again()
        for path in list(ls.memories.documents)[:1]:
            ls.checked_soon(path)


def _register_documents(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def opened(ls: Server, params: lsp.DidOpenTextDocumentParams) -> None:
        item = params.text_document
        path = path_of(item.uri)
        ls.uris[path] = item.uri
        ls.memories.put(path, Document.of(item.text, ls.memories.units, item.version))
        ls.checked_soon(path)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def changed(ls: Server, params: lsp.DidChangeTextDocumentParams) -> None:
        path = path_of(params.text_document.uri)
        document = ls.memories.documents.get(path)
        if document is None:
            return
        for change in params.content_changes:
            document = document.edited(change.text, getattr(change, "range", None))
        version = params.text_document.version
        ls.memories.put(path, Document(document.lines, document.units, version))
        ls.checked_soon(path)

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def saved(ls: Server, params: lsp.DidSaveTextDocumentParams) -> None:
        ls.memories.read_disk_again()
        ls.checked_soon(path_of(params.text_document.uri))

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def closed(ls: Server, params: lsp.DidCloseTextDocumentParams) -> None:
        path = path_of(params.text_document.uri)
        ls.memories.close(path)
        ls.publish(path, [])


def _register_navigation(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    def definition(ls: Server, params: lsp.DefinitionParams) -> list[lsp.Location]:
        return _at(ls, params, navigation.definition, [])

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    def references(ls: Server, params: lsp.ReferenceParams) -> Later[list[lsp.Location] | None]:
        def answer(snap: Snapshot, path: str, line: int, character: int) -> list[lsp.Location]:
            wanted = params.context.include_declaration
            return navigation.references(snap, path, line, character, definitions=wanted)

        return (yield from _later(ls, params.text_document.uri, _placed(params, answer)))

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    def highlight(ls: Server, params: lsp.DocumentHighlightParams) -> list[lsp.DocumentHighlight]:
        return _at(ls, params, navigation.highlights, [])

    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
    def prepare(ls: Server, params: lsp.CallHierarchyPrepareParams) -> list[lsp.CallHierarchyItem]:
        return _at(ls, params, navigation.prepare_calls, [])

    @server.feature(lsp.CALL_HIERARCHY_INCOMING_CALLS)
    def incoming(
        ls: Server, params: lsp.CallHierarchyIncomingCallsParams
    ) -> list[lsp.CallHierarchyIncomingCall]:
        return _hierarchy(ls, params.item, navigation.incoming)

    @server.feature(lsp.CALL_HIERARCHY_OUTGOING_CALLS)
    def outgoing(
        ls: Server, params: lsp.CallHierarchyOutgoingCallsParams
    ) -> list[lsp.CallHierarchyOutgoingCall]:
        return _hierarchy(ls, params.item, navigation.outgoing)

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_LINK)
    def links(ls: Server, params: lsp.DocumentLinkParams) -> Later[list[lsp.DocumentLink] | None]:
        return (yield from _later(ls, params.text_document.uri, navigation.links))


def _hierarchy(
    ls: Server,
    item: lsp.CallHierarchyItem,
    answer: Callable[[Snapshot, lsp.CallHierarchyItem], list[T]],
) -> list[T]:
    """Answer from the memory that has the file of the item, which may not be open."""
    path = path_of(item.uri)
    for shown_path in [path, *ls.memories.documents]:
        snap = ls.memories.snapshot(shown_path)
        if snap is not None and snap.programs_of(path, inside=True):
            return answer(snap, item)
    return []


def _register_words(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_HOVER)
    def hover(ls: Server, params: lsp.HoverParams) -> Later[lsp.Hover | None]:
        uri, answer = params.text_document.uri, _placed(params, explaining.hover)
        if _asked(ls, uri, Snapshot.awaits_run, False):
            return (yield from _later(ls, uri, answer))
        return _asked(ls, uri, answer, None)

    @server.feature(
        lsp.TEXT_DOCUMENT_COMPLETION, lsp.CompletionOptions(trigger_characters=_TRIGGERS)
    )
    def completion(ls: Server, params: lsp.CompletionParams) -> lsp.CompletionList:
        path = path_of(params.text_document.uri)
        document = ls.memories.documents.get(path)
        if document is not None:
            found = names_at(document, path, *document.place(params.position))
            if found or is_project(path):
                return lsp.CompletionList(is_incomplete=False, items=found)
        none: list[lsp.CompletionItem] = []
        items = _at(ls, params, completing.completions, none)
        # More digits of a variable tell more of them.
        more = len(items) >= completing.MOST_ITEMS or any(i.label[:1] == "#" for i in items)
        return lsp.CompletionList(is_incomplete=more, items=items)

    @server.feature(
        lsp.TEXT_DOCUMENT_SIGNATURE_HELP, lsp.SignatureHelpOptions(trigger_characters=[" "])
    )
    def signature(ls: Server, params: lsp.SignatureHelpParams) -> lsp.SignatureHelp | None:
        return _at(ls, params, completing.signature, None)

    @server.feature(
        lsp.TEXT_DOCUMENT_CODE_ACTION,
        lsp.CodeActionOptions(
            [lsp.CodeActionKind.QuickFix, lsp.CodeActionKind.SourceFixAll, RENUMBER]
        ),
    )
    def action(ls: Server, params: lsp.CodeActionParams) -> Later[list[lsp.CodeAction] | None]:
        def answer(snap: Snapshot, path: str) -> list[lsp.CodeAction]:
            return actions(snap, path, params.range)

        return (yield from _later(ls, params.text_document.uri, answer))


def _register_looks(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def outline(
        ls: Server, params: lsp.DocumentSymbolParams
    ) -> Later[list[lsp.DocumentSymbol] | None]:
        return (yield from _later(ls, params.text_document.uri, symbols.document_symbols))

    @server.feature(lsp.WORKSPACE_SYMBOL)
    def workspace(ls: Server, params: lsp.WorkspaceSymbolParams) -> list[lsp.WorkspaceSymbol]:
        snaps = {id(s): s for path in ls.memories.documents if (s := ls.memories.snapshot(path))}
        return [each for s in snaps.values() for each in symbols.workspace_symbols(s, params.query)]

    @server.feature(lsp.TEXT_DOCUMENT_FOLDING_RANGE)
    def folding(ls: Server, params: lsp.FoldingRangeParams) -> Later[list[lsp.FoldingRange] | None]:
        return (yield from _later(ls, params.text_document.uri, symbols.folding))

    @server.feature(lsp.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, shown.LEGEND)
    def colours(ls: Server, params: lsp.SemanticTokensParams) -> Later[lsp.SemanticTokens | None]:
        return (yield from _later(ls, params.text_document.uri, shown.semantic_tokens))

    @server.feature(lsp.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE, shown.LEGEND)
    def some(ls: Server, params: lsp.SemanticTokensRangeParams) -> lsp.SemanticTokens | None:
        first, last = params.range.start.line, params.range.end.line

        def answer(snap: Snapshot, path: str) -> lsp.SemanticTokens | None:
            return shown.semantic_tokens(snap, path, first, last)

        return _asked(ls, params.text_document.uri, answer, None)

    @server.feature(lsp.TEXT_DOCUMENT_INLAY_HINT)
    def hints(ls: Server, params: lsp.InlayHintParams) -> Later[list[lsp.InlayHint] | None]:
        first, last = params.range.start.line, params.range.end.line

        def answer(snap: Snapshot, path: str) -> list[lsp.InlayHint]:
            return shown.inlay_hints(snap, path, first, last)

        return (yield from _later(ls, params.text_document.uri, answer))

    @server.feature(lsp.TEXT_DOCUMENT_CODE_LENS)
    def lenses(ls: Server, params: lsp.CodeLensParams) -> Later[list[lsp.CodeLens] | None]:
        def answer(snap: Snapshot, path: str) -> list[lsp.CodeLens]:
            return shown.code_lenses(snap, path, debugs=ls.debugs)

        return (yield from _later(ls, params.text_document.uri, answer))


def _register_changes(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_RENAME)
    def prepare(ls: Server, params: lsp.PrepareRenameParams) -> lsp.PrepareRenamePlaceholder | None:
        return _at(ls, params, rewriting.prepare_rename, None)

    @server.feature(lsp.TEXT_DOCUMENT_RENAME, lsp.RenameOptions(prepare_provider=True))
    def rename(ls: Server, params: lsp.RenameParams) -> Later[lsp.WorkspaceEdit | None]:
        def answer(snap: Snapshot, path: str, line: int, at: int) -> lsp.WorkspaceEdit | None:
            with _refusals():
                return rewriting.renamed(snap, path, line, at, params.new_name)

        return (yield from _later(ls, params.text_document.uri, _placed(params, answer)))

    @server.feature(lsp.TEXT_DOCUMENT_FORMATTING)
    def format(
        ls: Server, params: lsp.DocumentFormattingParams
    ) -> Later[list[lsp.TextEdit] | None]:
        def answer(snap: Snapshot, path: str) -> list[lsp.TextEdit]:
            return rewriting.formatted(snap, path, params.options)

        return (yield from _later(ls, params.text_document.uri, answer))

    @server.feature(lsp.TEXT_DOCUMENT_RANGE_FORMATTING)
    def format_some(
        ls: Server, params: lsp.DocumentRangeFormattingParams
    ) -> Later[list[lsp.TextEdit] | None]:
        first, last = params.range.start.line, params.range.end.line

        def answer(snap: Snapshot, path: str) -> list[lsp.TextEdit]:
            return rewriting.formatted(snap, path, params.options, first, last)

        return (yield from _later(ls, params.text_document.uri, answer))


@contextlib.contextmanager
def _refusals() -> Iterator[None]:
    """Answer a change that cannot be made with the reason."""
    try:
        yield
    except (EditError, KeyError, ValueError) as error:
        raise JsonRpcException(
            message=str(error.args[0] if isinstance(error, KeyError) else error),
            code=lsp.LSPErrorCodes.RequestFailed.value,
        ) from None


def _register_commands(server: Server) -> None:
    @server.command("cncsub.renumber")
    def renumber(ls: Server, path: str) -> Later[None]:
        def answer() -> lsp.WorkspaceEdit | None:
            snap = ls.memories.snapshot(path)
            with _refusals():
                return None if snap is None else rewriting.renumbered(snap, path)

        document = ls.memories.documents.get(path)
        edit: lsp.WorkspaceEdit | None = yield ls.answered, (path, document, answer), None
        if edit is not None:
            ls.workspace_apply_edit(lsp.ApplyWorkspaceEditParams(edit, "Number the blocks anew"))

    @server.command("cncsub.run")
    async def run(ls: Server, path: str, program: str | None = None) -> str:
        return await _command(ls, path, program, run_program)

    @server.command("cncsub.plot")
    async def plot(ls: Server, path: str, program: str | None = None) -> str:
        def draw(snap: Snapshot, path: str, program: str | None) -> str:
            return plot_program(snap, path, program, ls.pages)

        told = await _command(ls, path, program, draw)
        if Path(told).is_file():
            uri = Path(told).as_uri()
            ls.window_show_document(lsp.ShowDocumentParams(uri, external=True))
        return told


async def _command(
    ls: Server, path: str, program: str | None, command: Callable[[Snapshot, str, str | None], str]
) -> str:
    snap = ls.memories.snapshot(path)
    told = f"{path} is not open"
    if snap is not None:
        told = await ls.ordered(functools.partial(command, snap, path, program))
    ls.window_show_message(lsp.ShowMessageParams(lsp.MessageType.Info, told))
    return told
