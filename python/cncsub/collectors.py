"""The collectors of every finished run of this process: see `cncsub.coverage.collecting`."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from cncsub import _core

Collector = Callable[[_core.Trace, _core.Code], None]

_collectors: list[Collector] = []
_lock = threading.Lock()


@contextmanager
def told(collector: Collector) -> Iterator[None]:
    """Tell the collector of what finishes meanwhile, in any thread."""
    with _lock:
        _collectors.append(collector)
    try:
        yield
    finally:
        with _lock:
            _collectors.remove(collector)


def tell(trace: _core.Trace, code: _core.Code) -> None:
    """Tell the collectors that a run has finished."""
    for each in tuple(_collectors):
        each(trace, code)
