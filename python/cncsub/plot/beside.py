"""The code beside a picture of a path: which block each move comes from."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from cncsub.run import Recorded

    Numbers = np.ndarray[Any, np.dtype[Any]]


class Beside:
    """The blocks that moved, each by the name of its program and its line, and the place in this
    list of each move and of the last move of each instant of the slider.
    """

    def __init__(self, run: Recorded) -> None:
        moves = run.moves
        pairs = np.column_stack((np.asarray(moves.program), np.asarray(moves.line)))
        known, places = np.unique(pairs, axis=0, return_inverse=True)
        self.of_moves: Numbers = places.reshape(-1)
        self.of_frames: list[int] = []
        names = moves.programs
        self.blocks = [
            (names[program] if program >= 0 else "", line) for program, line in known.tolist()
        ]
