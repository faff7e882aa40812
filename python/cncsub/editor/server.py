"""The language server: its documents, its settings, and what it tells by itself."""

from __future__ import annotations

import asyncio
import functools
import logging
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, TypeVar

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer
from pygls.protocol import LanguageServerProtocol
from pygls.protocol.language_server import lsp_method
from pygls.uris import to_fs_path

from cncsub import _core
from cncsub._core import __version__
from cncsub.editor.completing import codes_of
from cncsub.editor.diagnostics import diagnostics
from cncsub.editor.documents import Document
from cncsub.editor.memory import Memories, Settings

T = TypeVar("T")

QUIET = 0.12  # seconds after the last key before the programs are checked
QUIET_FOR_RUN = 1.0  # seconds after a check before a large document is run


def _is_no_refusal(record: logging.LogRecord) -> bool:
    """Return whether a record tells of more than an answer that the client gets as an error."""
    return not (record.exc_info and isinstance(record.exc_info[1], JsonRpcException))


logging.getLogger("pygls.protocol.json_rpc").addFilter(_is_no_refusal)


class _Protocol(LanguageServerProtocol):
    """The protocol without the documents of pygls: ours end their lines as the protocol says."""

    @lsp_method(lsp.TEXT_DOCUMENT_DID_OPEN)
    def lsp_text_document__did_open(self, params: Any) -> Iterator[Any]:
        yield from self._handed_on(lsp.TEXT_DOCUMENT_DID_OPEN, params)

    @lsp_method(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: Any) -> Iterator[Any]:
        yield from self._handed_on(lsp.TEXT_DOCUMENT_DID_CHANGE, params)

    @lsp_method(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def lsp_text_document__did_close(self, params: Any) -> Iterator[Any]:
        yield from self._handed_on(lsp.TEXT_DOCUMENT_DID_CLOSE, params)

    def _handed_on(self, name: str, params: Any) -> Iterator[Any]:
        if (handler := self.fm.features.get(name)) is not None:
            yield handler, (params,), None


class Server(LanguageServer):
    """The server of one client, with the memories of its documents."""

    def __init__(self, control: str | None = None) -> None:
        super().__init__("cncsub", __version__, protocol_cls=_Protocol)
        self.memories = Memories(settings=Settings(control), tell=self._tell)
        self.debugs = False  # whether the client has a command that debugs
        self.uris: dict[str, str] = {}  # how the client calls its documents, by path
        self._given = control
        # The loop answers what a key waits for. One thread each checks and runs in the background,
        # looks through whole documents, and does what somebody has ordered.
        self._checks = ThreadPoolExecutor(1, "cncsub-check")
        self._answers = ThreadPoolExecutor(1, "cncsub-answer")
        self._orders = ThreadPoolExecutor(1, "cncsub-order")
        self._pages: tempfile.TemporaryDirectory[str] | None = None
        self._checking: asyncio.Task[None] | None = None

    @property
    def pages(self) -> Path:
        """The folder of drawn pages, which is removed when the client shuts the server down."""
        if self._pages is None:
            self._pages = tempfile.TemporaryDirectory(prefix="cncsub-")
        return Path(self._pages.name)

    def remove_pages(self) -> None:
        """Remove the drawn pages."""
        if self._pages is not None:
            self._pages.cleanup()
            self._pages = None

    def _tell(self, message: str) -> None:
        self.window_show_message(lsp.ShowMessageParams(lsp.MessageType.Warning, message))

    def configure(self, told: Any) -> None:
        """Take the settings of the client: `control`, `run`, `maxBlocks`, `maxSeconds`, `debug`.
        Whether it has a command that debugs stays as it was told before, where nothing says it.
        """
        told = told.get("cncsub", told) if isinstance(told, dict) else {}
        control = told.get("control") or self._given
        blocks, seconds = told.get("maxBlocks"), told.get("maxSeconds")
        usual = Settings()
        self.memories.settings = Settings(
            control if isinstance(control, str) else None,
            told.get("run") is not False,
            blocks if isinstance(blocks, int) and blocks > 0 else usual.max_blocks,
            float(seconds)
            if isinstance(seconds, int | float) and seconds > 0
            else usual.max_seconds,
        )
        if "debug" in told:
            self.debugs = told["debug"] is True
        self.memories.read_disk_again()

    def checked_soon(self, path: str) -> None:
        """Check the documents when no key was pressed for a while, the one at hand first."""
        others = [each for each in self.memories.documents if each != path]
        if self._checking is not None:
            self._checking.cancel()
        self._checking = asyncio.ensure_future(self._check([path, *others]))

    async def _check(self, paths: list[str]) -> None:
        await asyncio.sleep(QUIET)
        for path in paths:
            document = self.memories.documents.get(path)
            found = await self._apart(functools.partial(self._diagnostics, path))
            if document is not None and self.memories.documents.get(path) is document:
                self.publish(path, found, document.version)
        await self._apart(lambda: self._warm_up(paths[0]))
        await self._apart(_give_back)
        await asyncio.sleep(QUIET_FOR_RUN)  # the next key cancels the run before it begins
        if await self._apart(lambda: self._run(paths[0])):
            await self._apart(_give_back)
            self._refresh()

    async def _apart(self, work: Callable[[], T]) -> T:
        """Return what some work returns that is done beside the answers to requests."""
        return await asyncio.get_running_loop().run_in_executor(self._checks, work)

    async def answered(self, path: str, document: Document | None, answer: Callable[[], T]) -> T:
        """Return an answer about one version of a document that takes long, with others answered
        beside it. Raises `JsonRpcException` where there is another version by now: the client asks
        again.
        """

        def of_version() -> T:
            self._still(path, document)
            return answer()

        found = await asyncio.get_running_loop().run_in_executor(self._answers, of_version)
        self._still(path, document)
        return found

    def _still(self, path: str, document: Document | None) -> None:
        if self.memories.documents.get(path) is not document:
            code = lsp.LSPErrorCodes.ContentModified.value
            raise JsonRpcException(message=f"{path} has changed", code=code)

    async def ordered(self, order: Callable[[], T]) -> T:
        """Return what a command returns, with requests answered beside it."""
        return await asyncio.get_running_loop().run_in_executor(self._orders, order)

    def _warm_up(self, path: str) -> None:
        """Make the list of codes, for which the first completion then does not wait."""
        snap = self.memories.snapshot(path)
        if snap is not None:
            codes_of(snap.control, snap.kind)

    def _run(self, path: str) -> bool:
        """Run a large document, and return whether an editor can be told more than before."""
        snap = self.memories.snapshot(path)
        if snap is None or snap.last_run(path) is not None:
            return False
        return snap.last_run(path, waits=True) is not None

    def _refresh(self) -> None:
        asked = self.client_capabilities.workspace
        if asked is not None and asked.inlay_hint is not None and asked.inlay_hint.refresh_support:
            self.workspace_inlay_hint_refresh(None)

    def _diagnostics(self, path: str) -> list[lsp.Diagnostic]:
        snap = self.memories.snapshot(path)
        return [] if snap is None else diagnostics(snap, path)

    def publish(self, path: str, found: list[lsp.Diagnostic], version: int | None = None) -> None:
        """Send the diagnostics of a document."""
        uri = self.uris.get(path, path)
        self.text_document_publish_diagnostics(
            lsp.PublishDiagnosticsParams(uri, found, version=version)
        )


def _give_back() -> None:
    """Give back what the versions of a text before this one have left behind."""
    _core.give_back_memory()


def path_of(uri: str) -> str:
    """Return the path of a document; of one that is no file, its whole name."""
    return (to_fs_path(uri) or uri) if uri.startswith("file:") else uri
