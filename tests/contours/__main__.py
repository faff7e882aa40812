"""Run random contours under radius compensation on every control that has it, and check the path.

    python tests/contours --contours 100000 --seed 1
    python tests/contours --show 17 --seed 1

The contours are lines and arcs that are tangent, nearly tangent, or meet in outside and inside
corners, with pieces of some increments among them. They are written in mm and inch with three and
four decimals, for mills in three planes and lathes with noses and tips. If the tool fits, there is
no alarm and its centre keeps within two increments of an offset that is computed independently of
the engine. If it does not fit, the control says so.
"""

from __future__ import annotations

import argparse
import time

from trials import Trials


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--contours", type=int, default=1000, help="how many are tried")
    parser.add_argument("--seed", type=int, default=1, help="which series of contours")
    parser.add_argument("--show", type=int, metavar="PLACE", help="print this one, run none")
    options = parser.parse_args()
    trials = Trials(options.seed)
    if options.show is not None:
        station, drawing, written = trials.contour(options.show)
        print(f"{station}, radius {drawing.radius}, side {drawing.side}\n{written.text}")
        return 0
    start = time.monotonic()
    for place in range(options.contours):
        trials.compare(place)
    print(f"{options.contours} contours, seed {options.seed}, {time.monotonic() - start:.0f} s")
    for name, count in trials.outcomes.items():
        print(f"    {count:>8}  {name}")
    print(f"{len(trials.runs)} machines; the path deviates by {trials.worst:.2f} increments")
    print("\n".join(trials.failures[:20]))
    print(f"{len(trials.failures)} failures")
    return 1 if trials.failures else 0


if __name__ == "__main__":
    raise SystemExit(main())
