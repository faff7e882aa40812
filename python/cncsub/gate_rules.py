"""The rules that only a gate has, beside those of `check`."""

from __future__ import annotations

from cncsub.checking import CheckRule

_MILL = "fanuc-0i-f"
RULES = (
    CheckRule(
        "GT001",
        "unreadable",
        "error",
        "a file that cannot be read, or whose language no control here reads",
        "name the programs, or the folder that holds nothing else",
        "",
        _MILL,
    ),
    CheckRule(
        "GT101",
        "dry-run-alarm",
        "error",
        "the program alarms when it runs",
        "mend what the alarm names: `cncsub run FILE` shows the block and the calls to it",
        "O1\nG2 X1. R0.1 F100\nM30\n",
        _MILL,
    ),
    CheckRule(
        "GT102",
        "dry-run-unfinished",
        "error",
        "the program does not come to its end: it waits, or goes on without an end",
        "end every loop, or give the limit that it needs: --max-blocks, --max-seconds",
        "O1\nN10 GOTO 10\nM30\n",
        _MILL,
    ),
    CheckRule(
        "GT201",
        "head-missing",
        "error",
        "a file whose first program has no number",
        "begin the program with its number: O1000",
        "G0 X1.\nM30\n",
        _MILL,
    ),
    CheckRule(
        "GT202",
        "half-a-file",
        "error",
        "a file that begins with % and does not end with it, or the other way round",
        "write % in the first and in the last line; where one is missing, the file may be cut off",
        "%\nO1\nM30\n",
        _MILL,
    ),
    CheckRule(
        "GT203",
        "no-percent-signs",
        "warning",
        "a file that neither begins nor ends with %, between which a control reads a file",
        "write % in the first and in the last line",
        "O1\nM30\n",
        _MILL,
    ),
)
