"""Compares the moves that every machine makes of generated programs with those that were meant."""

from __future__ import annotations

from collections import Counter
from random import Random

from machines import LINUXCNC, LinuxCnc, Moves, Station, stations, table
from programs import MILLING, TURNING, Program, generate, moves_of
from spelling import Speller, Style

TOLERANCE = 0.0002  # mm; rs274 prints four decimals
SHOWN = 10  # how many differences are printed


class Comparison:
    """Programs by their place in the series of a seed."""

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self.stations = stations()
        self.runs: Counter[str] = Counter()
        self.moves = 0
        self.calls: Counter[int] = Counter()  # number of programs by the depth of their calls
        self.differences = 0

    def program(self, place: int) -> Program:
        return generate(self.random(place, "program"), TURNING if place % 2 else MILLING)

    def random(self, place: int, what: str) -> Random:
        return Random(f"{self.seed} {place} {what}")

    def text(self, place: int, program: Program, station: Station) -> str:
        """Return the text; controls that want the same words get the same one."""
        return Speller(station.style, self.random(place, str(station.style))).write(program)

    def on(self, place: int) -> list[Station]:
        return [station for station in self.stations if place % 2 or station.mills()]

    def compare(self, places: tuple[int, ...], linuxcnc: LinuxCnc | None) -> None:
        programs = [self.program(place) for place in places]
        expected = [table(moves_of(program)) for program in programs]
        for place, program, meant in zip(places, programs, expected, strict=True):
            self.moves += len(meant)
            self.calls[program.depth] += 1
            texts: dict[Style, str] = {}
            for station in self.on(place):
                if station.style not in texts:
                    texts[station.style] = self.text(place, program, station)
                text = texts[station.style]
                self.judge(place, station.name, text, meant, station.moves(text))
        if linuxcnc is not None:
            self.compare_linuxcnc(linuxcnc, places, programs, expected)

    def compare_linuxcnc(
        self,
        linuxcnc: LinuxCnc,
        places: tuple[int, ...],
        programs: list[Program],
        expected: list[Moves],
    ) -> None:
        text = linuxcnc.text(programs, self.random(places[0], LINUXCNC))
        made = linuxcnc.moves(text, len(programs))
        if isinstance(made, str) and len(programs) > 1:
            # Some program of the file stopped it, so each runs by itself.
            for place, program, meant in zip(places, programs, expected, strict=True):
                self.compare_linuxcnc(linuxcnc, (place,), [program], [meant])
            return
        results = [made] if isinstance(made, str) else made
        for place, meant, result in zip(places, expected, results, strict=True):
            self.judge(place, LINUXCNC, text, meant, result)

    def judge(self, place: int, name: str, text: str, meant: Moves, made: Moves | str) -> None:
        self.runs[name] += 1
        difference = _difference(meant, made)
        if difference is None:
            return
        self.differences += 1
        if self.differences <= SHOWN:
            shown = text if len(text) < 5000 else "(one of a file of many)"
            print(f"program {place} on {name}: {difference}\n{shown}")


def _difference(meant: Moves, made: Moves | str) -> str | None:
    if isinstance(made, str):
        return f"stopped: {made.strip()}"
    if len(meant) != len(made):
        return f"{len(made)} moves instead of {len(meant)}"
    for row, (wanted, got) in enumerate(zip(meant, made, strict=True)):
        if abs(wanted - got).max() > TOLERANCE:
            return f"move {row} is {got} instead of {wanted}"
    return None
