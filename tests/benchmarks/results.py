"""The figures that a run of the benchmark measured."""

from __future__ import annotations

import statistics
from collections import defaultdict
from dataclasses import dataclass, field
from typing import Any

from workloads import Size, Workload

Figures = dict[str, Any]
Key = tuple[str, str]  # the name of a workload, and who ran it


@dataclass
class Results:
    """The figures of every round, and the workloads that a peer could not run."""

    size: Size
    workloads: list[Workload]
    figures: dict[Key, list[Figures]] = field(default_factory=lambda: defaultdict(list))
    refused: dict[Key, str] = field(default_factory=dict)
    missing: dict[str, str] = field(default_factory=dict)  # for each peer, where it comes from
    versions: dict[str, str] = field(default_factory=dict)

    def workload(self, name: str) -> Workload:
        return next(workload for workload in self.workloads if workload.name == name)

    def has(self, workload: str, who: str) -> bool:
        return bool(self.figures.get((workload, who)))

    def median(self, workload: str, who: str = "cncsub", key: str = "seconds") -> float:
        return float(statistics.median(figures[key] for figures in self.figures[workload, who]))

    def best(self, workload: str, who: str, key: str) -> float:
        return float(min(figures[key] for figures in self.figures[workload, who]))

    def last(self, workload: str, who: str, key: str) -> Any:
        return self.figures[workload, who][-1][key]

    def ratio(self, workload: str, who: str) -> float:
        """Return how many times the seconds of cncsub `who` takes."""
        return self.median(workload, who) / self.median(workload)
