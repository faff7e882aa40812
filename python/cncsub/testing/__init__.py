"""Tests of NC programs: cases with their expected outcome, tables of cases, and the language of
executed blocks and of moves. The conformance tables of cncsub itself are written in it.

With pytest installed, the plugin `cncsub_pytest` is loaded by it: a fixture `cnc`, `--control`, and
`*.nctest.toml` as tests.
"""

from cncsub.testing.cases import Case, case
from cncsub.testing.outcome import check_case
from cncsub.testing.table_files import load_table

__all__ = ["Case", "case", "check_case", "load_table"]
