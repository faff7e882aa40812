"""Writes the conformance tables as one JSON file, so that another engine can be held to them.

    python tools/export_conformance.py conformance.json

docs/conformance.schema.json is its schema, docs/conformance.md says how it is used. cncsub has to
be installed. What JSON cannot hold stands in the file under `left_out`, and is told by topic.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "conformance"))

from cncsub.testing.exchange import left_out_by_topic, suite_facts
from conformance import cases


def suite() -> dict[str, Any]:
    """All rows of the tables, each with the worth of its source."""
    every = cases()
    return suite_facts(every, {case.claim: case.evidence for case in every})


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("output", type=Path, help="the file to write, such as conformance.json")
    told = suite()
    output = parser.parse_args().output
    text = json.dumps(told, ensure_ascii=False, indent=1, allow_nan=False)
    output.write_text(text + "\n", encoding="utf-8")
    counts = told["counts"]
    print(
        f"{output}: {counts['cases']} cases, {counts['rows']} rows on"
        f" {len(told['controls'])} controls, {counts['left_out']} cases left out"
    )
    for line in left_out_by_topic(told):
        print(line)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
