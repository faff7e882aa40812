"""The findings of check, and near misses that it leaves alone."""

from __future__ import annotations

import json
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

import cncsub
from cncsub.checking import RULES, CheckRule
from cncsub.cli import app
from cncsub.reports.findings import Mended, finding_facts, github_annotations, junit, sarif

sys.path.insert(0, str(Path(__file__).with_name("conformance")))
from cncsub.testing import outcome
from conformance import rows

MILL = "fanuc-0i-f"
EXAMPLES = Path(__file__).parent.parent / "examples"


def found(text: str, control: str = MILL, **options: Any) -> list[str]:
    """Return the rules and their blocks, as `CS201 N20`; by the line if there is no N."""
    findings = cncsub.loads(text, control=control).check(**options)
    return [
        f"{f.rule} {f':{at.line}' if at.n is None else f'N{at.n}'}"
        for f in findings
        for at in (f, *f.places)
    ]


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.name)
def test_the_example_of_a_rule_is_found(rule: CheckRule) -> None:
    findings = cncsub.loads(rule.example, control=rule.control).check()
    own = [finding for finding in findings if finding.rule == rule.number]
    assert len(own) == 1
    assert (own[0].name, own[0].severity) == (rule.name, rule.severity)
    assert own[0].message
    assert own[0].hint


# The example of each rule with one thing mended: the rule then finds nothing.
NEAR: dict[str, tuple[str, str]] = {
    "CS101": ("X1.5.2", "X1.52"), "CS102": ("G5.9", "G1"), "CS103": ("]#501", "]THEN #501"),
    "CS104": ("#0=", "#100="), "CS105": ("G7.1 C1.", "G0 X1."), "CS201": ("P9", "P1 (L0)"),
    "CS202": ("GOTO 50", "GOTO 20"), "CS203": ("P50", "P20"), "CS204": ("N50 G4 P2", "N51 G4 P2"),
    "CS205": ("O2\nM99\nO2", "O2\nM99\nO3"), "CS206": ("GOTO 30", "GOTO 20"),
    "CS207": ("N30 M30", "N25 END1\nN30 M30"), "CS208": ("o2 sub\ng0 x2\no2 endsub\no1 endsub", "o1 endsub\no2 sub\ng0 x2\no2 endsub"),
    "CS209": ("o1 break", "o1 continue"), "CS301": ("GOTO 40", "IF[#500 EQ 1]GOTO 40"),
    "CS302": ("O1\n", "O1\nM98 P2\n"), "CS303": ("G4 P1", "M2"), "CS304": ("O2\nN10 M30", "O2\nN10 M99"),
    "CS305": ("N100 G0", "N90 M30\nN100 G0"), "CS401": ("M98 P6", "G4 P6"), "CS402": ("O3\nM98 P2", "O3\nG4 P2"),
    "CS403": ("O2\nM98 P2\nM99", "O2\nM98 P2 Q5\nM99\nN5 M99"), "CS501": ("N20 M99", "N20 G90\nN21 M99"),
    "CS502": ("N20 M99", "N20 G49\nN21 M99"), "CS503": ("N20 M99", "N20 G54\nN21 M99"),
    "CS601": ("N10 #2", "N5 #1=0\nN10 #2"), "CS602": ("GOTO 30", "GOTO 20"), "CS603": ("A1.", "A1. B2."),
    "CS604": (" B2.", ""), "CS605": ("M98 P2", "G65 P2"), "CS606": ("O2\nN10 #100=0\nN20 G4 P#100", "O2\nN10 #101=0\nN20 G4 P#101"),
    "CS701": ("X10\n", "X10.\n"), "CS702": ("O21000", "O2100"), "CS703": ("L0", "L1"),
    "CS704": ("M3 M8", "M3"), "CS705": ("#2+#3 AND 7", "#2+[#3 AND 7]"), "CS706": ("G99", "M99"),
    "CS707": ("M97 P30", "M97"),
    "CS801": ("G0 G1", "G90 G1"), "CS802": ("; N20", "\nN20"), "CS803": ("x1.", "X1. (x)"),
    "CS607": ("GOTO 30", "GOTO 20"), "CS708": ("X10. R1.", "X10. Z-1. R1."), "CS709": ("L3", "K3"),
    "CS710": ("N20 IF", "N15 G103 P1\nN20 IF"), "CS711": ("+0.1", "+0.25"), "CS804": ("Y2.", "Y2.)"),
}  # fmt: skip


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.name)
def test_a_near_miss_of_a_rule_is_left_alone(rule: CheckRule) -> None:
    wrong, right = NEAR[rule.number]
    assert wrong in rule.example
    text = rule.example.replace(wrong, right, 1)
    findings = cncsub.loads(text, control=rule.control).check()
    assert [str(finding) for finding in findings if finding.rule == rule.number] == []


END = "N90 M30\n"

# Programs, and all that is found in them.
TABLE: dict[str, tuple[str, str, str]] = {
    # Blocks that the control refuses
    "a fault that is never reached": ("", "O1\nN10 GOTO 30\nN20 G0 X1.5.2\nN30 M30\n", "CS101 N20, CS301 N20"),
    "a fault after a slash": ("", "O1\n/N10 M98 P-2\nN20 M30\n", "CS101 N10"),
    "a fault after THEN": ("", "O1\nN10 IF[#500 EQ 1]THEN #501=[1\nN20 M30\n", "CS101 N10"),
    "codes of another kind of machine": ("gsk-988ta", "O1\nN10 G43 H1\nN20 M30\n", "CS102 N10"),
    "a code no source tells of": ("hnc-21m", "%1\nN10 G5.9\nN20 M30\n", "CS102 N10"),
    "#3000 and #3006 are written by statements": ("", "O1\nN10 #3006=1(LOOK)\nN20 IF[#500 EQ 1]THEN #3000=1(NO)\n" + END, ""),
    "a variable only to be read": ("", "O1\nN10 #5021=1\n" + END, "CS104 N10"),
    "a common that is not fitted": ("fanuc-16i", "O1\nN10 #200=1\n" + END, "CS104 N10"),
    "moves that are not computed": ("", "O1\nN10 G7.1 C1.\n" + END, "CS105 N10"),
    "statements that are not computed": ("siemens-one", "N10 CALL ONE1\nN20 G0 X=R2\nN30 CALL TWO2\nN40 M30\n", "CS105 N10, CS105 N30"),
    "an arc without a centre": ("haas-ngc", "O1\nN10 G2 X1. F9.\nN20 G3 G17 X1. Y2. F9.\n" + END, "CS101 N10, CS101 N20"),
    "an arc without a centre that is a line": ("", "O1\nN10 G2 X1. F9.\n" + END, ""),
    "arcs with a centre, and G2 alone": ("haas-ngc", "O1\nN10 G2 F9.\nN20 X1. R5.\nN30 G2 X2. J1.\n" + END, ""),
    "an arc by a radius in words": ("siemens-one", "N10 G2 X10 CR=5 F100\nN20 M30\n", ""),
    # Targets of calls and jumps
    "a program that is missing": ("", "O1\nN10 M98 P9\nN20 G65 P8\n" + END, "CS201 N10, CS201 N20"),
    "a computed program may be there": ("", "O1\nN10 M98 P#500\n" + END, ""),
    "a start that is missing": ("gsk-988ta", "O1\nN10 M98 P2 Q5\nN20 M30\nO2\nN6 G4 P1\nN7 M99\n", "CS201 N10"),
    "a jump to nowhere, taken or not": ("", "O1\nN10 IF[1 EQ 2]GOTO 77\n" + END, "CS202 N10"),
    "a jump by G65 H80": ("gsk-980tdi", "O1\nN10 G65 H80 P77\n" + END, "CS202 N10"),
    "the profile of a cycle": ("gsk-988ta", "O1\nN10 G71 P20 Q50 U1. W0.\nN20 G0 X1.\n" + END, "CS202 N10"),
    "a return to nowhere": ("", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 P25\n", "CS203 N30"),
    "a return that one of two callers has": (
        "", "O1\nN10 M98 P2\nN15 M98 P3\nN20 M30\nO2\nN30 M99 P20\nO3\nN10 M98 P2\nN11 M99\n", "CS203 N30"),
    "a return that both have": (
        "", "O1\nN10 M98 P2\nN15 M98 P3\nN20 M30\nO2\nN30 M99 P20\nO3\nN10 M98 P2\nN20 M99\n", ""),
    "M99 P of a main program that starts over": ("", "O1\nN10 G4 P1\nN20 M99 P10\n", ""),
    "M99 P of a main program that leads nowhere": ("", "O1\nN10 G4 P1\nN20 M99 P15\n", "CS203 N20"),
    "two blocks of a number": ("", "O1\nN10 GOTO 50\nN50 G4 P1\nN50 G4 P2\n" + END, "CS204 N10"),
    "two blocks of a number that nobody asks for": ("", "O1\nN50 G4 P1\nN50 G4 P2\n" + END, ""),
    "two programs of a number": ("", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99\nO2\nN40 M99\n", "CS205 :6"),
    "a jump inside a loop": ("", "O1\nN5 #1=0\nN10 WHILE[#1 LT 3]DO1\nN20 #1=#1+1\nN30 IF[#1 EQ 2]GOTO 50\nN40 G4 P1\nN50 END1\n" + END, ""),
    "a jump out of a loop, and to its head": ("", "O1\nN5 #1=0\nN6 IF[#500 EQ 1]GOTO 10\nN10 WHILE[#1 LT 3]DO1\nN20 #1=#1+1\nN30 IF[#1 EQ 2]GOTO 90\nN50 END1\n" + END, ""),
    "a jump into the inner loop from the outer one": (
        "", "O1\nN5 #1=0\nN10 WHILE[#1 LT 3]DO1\nN15 GOTO 30\nN20 WHILE[#1 LT 5]DO2\nN30 #1=#1+1\nN40 END2\nN50 END1\n" + END,
        "CS206 N15"),
    # Blocks that run and blocks that do not
    "blocks after M30": ("", "O1\nN10 M30\nN20 G4 P1\nN30 M99\n", "CS301 N20"),
    "M99 after M30 is a habit": ("", "O1\nN10 G4 P1\nN20 M30\nN30 M99\n", ""),
    "a skipped GOTO": ("", "O1\n/N10 GOTO 30\nN20 G4 P1\nN30 M30\n", ""),
    "a computed GOTO may lead to every number": ("", "O1\nN10 GOTO #500\nG4 P1\nN20 G4 P1\n" + END, "CS301 :3"),
    "a start by Q": ("gsk-988ta", "O1\nN10 M98 P2 Q50\nN20 M30\nO2\nN40 M99\nN50 G4 P1\nN60 M99\n", ""),
    "#3000 ends what comes to it": ("", "O1\nN10 IF[#500 EQ 1]GOTO 30\nN20 M30\nN30 #3000=1(NO)\n", ""),
    "a profile after M30 is cut by its cycle": (
        "gsk-988ta", "O1\nN5 G0 X50. Z2.\nN10 G71 U1. R1.\nN15 G71 P30 Q50 U0 W0 F0.1\nN20 M30\nN30 G0 X10.\nN40 G1 Z-10.\nN50 X20.\n", ""),
    "a subprogram that nobody calls": ("", "O1\nN10 M30\nO2\nN20 M99\n", "CS302 N20"),
    "a second main program": ("", "O1\nN10 M30\nO2\nN20 M30\n", ""),
    "a computed call may call it": ("", "O1\nN5 G65 P#500\nN10 M30\nO2\nN20 M99\n", ""),
    "a program without an end": ("", "O1\nN10 G4 P1\nO2\nN20 M30\n", "CS303 N10"),
    "a way that has no end": ("", "O1\nN10 IF[#500 EQ 1]GOTO 30\nN20 M30\nN30 G4 P1\n", "CS303 N30"),
    "where labels lead the way nobody knows": ("linuxcnc", "o1 sub\nN10 G0 X1\no1 endsub\n", ""),
    "M30 in a called program": ("", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M30\n", "CS304 N30"),
    "M2 in a subprogram with a label": (
        "linuxcnc", "o1 sub\nG0 X1\nN5 M2\no1 endsub\no1 call\nG0 X5\nM2\n", "CS304 N5"),
    "M2 on one way of a subprogram with a label": (
        "linuxcnc", "o1 sub\no2 if [#1 gt 5]\nM2\no2 endif\nG0 X1\no1 endsub\no1 call [1]\nG0 X5\nM2\n", ""),
    "M30 on one way of it": ("", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 IF[#500 EQ 1]GOTO 50\nN40 M30\nN50 M99\n", ""),
    "M20 starts the program over": ("gsk-928te", "%1\nN10 G0 X1\nN20 M20\n", ""),
    # Depth of nesting
    "a part of the own program": ("gsk-928te", "%1\nN10 M98 P30\nN20 M2\nN30 G0 X1\nN40 M99\n", ""),
    "a program that calls itself": ("", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M98 P2\nN40 M99\n", "CS402 N30"),
    "a program that calls itself until a condition holds": (
        "", "O1\nN5 #100=0\nN10 M98 P2\nN20 M30\nO2\nN25 #100=#100+1\nN28 IF[#100 GE 3]GOTO 40\nN30 M98 P2\nN40 M99\n", ""),
    "a call of the own program whose start is dropped": ("mitsubishi-m800", "O1\nN10 M98 Q5\n" + END, "CS704 N10"),
    "a code does not call in the program that it calls": ("gsk-988ta", "O1\nN20 M30\n", ""),
    # State that a called program leaves
    "G91 where the caller moves on": ("", "O1\nN10 G90 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G91\nN50 M99\n", "CS501 N20"),
    "G91 where the caller says G90 first": ("", "O1\nN10 G90 G0 X0\nN20 M98 P2\nN30 G90 X5.\n" + END + "O2\nN40 G91\nN50 M99\n", ""),
    "G91 that is found on": ("", "O1\nN10 G91 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G91\nN50 M99\n", ""),
    "G91 that is switched off": ("", "O1\nN10 G90 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G91 X1.\nN45 G90\nN50 M99\n", ""),
    "G91 through two calls": (
        "", "O1\nN10 G90 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 M98 P3\nN50 M99\nO3\nN60 G91\nN70 M99\n", "CS501 N20"),
    "a plane": ("", "O1\nN10 G17 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G18\nN50 M99\n", "CS501 N20"),
    "a cycle": ("", "O1\nN10 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G81 Z-1. R1. F100\nN50 M99\n", "CS501 N20"),
    "a cycle that G80 ends": ("", "O1\nN10 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G81 Z-1. R1. F100\nN45 G80\nN50 M99\n", ""),
    "inches": ("", "O1\nN10 G21 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G20\nN50 M99\n", "CS501 N20"),
    # Variables
    "a vacant local": ("", "O1\nN10 G0 X[#1+1.]\n" + END, "CS601 N10"),
    "a local compared with #0": ("", "O1\nN10 IF[#1 EQ #0]THEN #1=1.\nN20 G0 X[#1+1.]\n" + END, ""),
    "a local set in a subprogram": ("", "O1\nN10 M98 P2\nN20 G0 X[#1+1.]\n" + END + "O2\nN30 #1=1.\nN40 M99\n", ""),
    "a local that some number writes": ("", "O1\nN10 #[#500]=1\nN20 G0 X[#1+1.]\n" + END, ""),
    "a local on one way": ("", "O1\nN10 IF[#500 EQ 1]GOTO 30\nN20 #1=1.\nN30 G0 X[#1+1.]\n" + END, "CS602 N30"),
    "a word alone that may be vacant is left out on purpose": (
        "", "O1\nN10 IF[#500 EQ 1]GOTO 30\nN20 #1=1.\nN30 G0 X#1\n" + END, ""),
    "a main program that starts over keeps its locals": ("", "O1\nN10 G0 X[#500+1.]\nN20 #1=1.\nN30 M99\n", ""),
    "a macro alone": ("", "O9010\nN10 G0 X[#24+1.]\nN20 M99\n", ""),
    "an argument given": ("", "O1\nN10 G65 P2 B1.\n" + END + "O2\nN30 G0 X[#2+1.]\nN40 M99\n", ""),
    "an argument of one call of two": (
        "", "O1\nN10 G65 P2 A1. B1.\nN20 G65 P2 A1.\n" + END + "O2\nN30 G0 X[#2+#1]\nN40 M99\n", "CS602 N30"),
    "an argument never given": ("", "O1\nN10 G65 P2 A1.\n" + END + "O2\nN30 G0 X[#2+#1]\nN40 M99\n", "CS603 N30"),
    "arguments that are left out of a block of words": (
        "", "O1\nN10 G65 P2 Z10. F300.\n" + END + "O2\nN30 G31 X#24 Y#25 Z#26 F#9\nN40 M99\n", ""),
    "an argument that is copied, and left out": (
        "", "O1\nN10 G65 P2 Z10.\n" + END + "O2\nN30 #1=#24\nN35 G0 X#1 Z#26\nN40 M99\n", ""),
    "an argument that is left out of a sum": (
        "", "O1\nN10 G65 P2 Z10.\n" + END + "O2\nN30 G0 X[#24+1.] Z#26\nN40 M99\n", "CS603 N30"),
    "an argument in a word whose letter may be mistaken": (
        "", "O1\nN10 G65 P2 A10.\n" + END + "O2\nN30 G0 X#24\nN40 M99\n", "CS604 N10, CS603 N30"),
    "an argument in a word of a macro that is given none": (
        "", "O1\nN10 G65 P2\n" + END + "O2\nN30 G0 X#24\nN40 M99\n", "CS603 N30"),
    "an argument never read": ("", "O1\nN10 G65 P2 A1. B1.\n" + END + "O2\nN30 G0 X[#2+1.]\nN40 M99\n", "CS604 N10"),
    "an argument never read is told at the first of its calls": (
        "", "O1\nN10 G65 P2 A1. B1.\nN20 G65 P2 A1. B2.\n" + END + "O2\nN30 G0 X[#2+1.]\nN40 M99\n", "CS604 N10"),
    "an argument that a subprogram of the macro reads": (
        "", "O1\nN10 G65 P2 A1.\n" + END + "O2\nN30 M98 P3\nN40 M99\nO3\nN50 G0 X#1\nN60 M99\n", ""),
    "a counter that a subprogram uses too": (
        "", "O1\nN10 #1=0\nN20 WHILE[#1 LT 3]DO1\nN30 M98 P2\nN40 #1=#1+1\nN50 END1\n" + END
        + "O2\nN60 #1=0\nN70 G0 X#1\nN80 M99\n", "CS605 N40"),
    "the same by G65, which has its own": (
        "", "O1\nN10 #1=0\nN20 WHILE[#1 LT 3]DO1\nN30 G65 P2\nN40 #1=#1+1\nN50 END1\n" + END
        + "O2\nN60 #1=0\nN70 G0 X#1\nN80 M99\n", ""),
    "a common that is handed over": (
        "", "O1\nN10 #100=5.\nN15 G0 Z#100\nN20 G65 P2\nN30 G0 X#100\n" + END + "O2\nN40 #100=#100+1.\nN50 M99\n", ""),
    "a common that comes back as a result": (
        "", "O1\nN10 #100=5.\nN20 G65 P2\nN30 G0 X#100\n" + END + "O2\nN40 #100=7.\nN50 M99\n", ""),
    "commons of two numbers": (
        "", "O1\nN10 #100=5.\nN15 G0 Z#100\nN20 G65 P2\nN30 G0 X#100\n" + END + "O2\nN40 #101=7.\nN45 G0 Y#101\nN50 M99\n", ""),
    # Paths through a program: starts, parts, blocks that run into a part
    "a start by Q that does not lead back is no recursion": (
        "gsk-988ta", "O1\nN10 M98 P2 Q10\nN20 M30\nO2\nN10 M98 P3\nN20 M99\nN30 G0 X1.\nN40 M99\nO3\nN50 M98 P2 Q30\nN60 M99\n", ""),
    "a start by H that leads back is recursion": (
        "mitsubishi-m700", "O1\nN10 M98 P2\nN20 M30\nO2\nN11 M98 P3\nN20 M99\nN30 G0 X1.\nN35 GOTO 11\nO3\nN50 M98 P2 H30\nN60 M99\n", "CS402 N11"),
    "a part that calls another one": (
        "haas-ngc", "O1\nN10 M97 P100\nN20 M30\nN100 M97 P200\nN110 M99\nN200 G0 X1.\nN210 M99\n", ""),
    "parts that call each other": (
        "haas-ngc", "O1\nN10 M97 P100\nN20 M30\nN100 M97 P200\nN110 M99\nN200 M97 P100\nN210 M99\n", "CS402 N200"),
    "parts nested too deep": (
        "haas-ngc", "O1\nM97 P1\nM30\n" + "".join(f"N{i} M97 P{i + 1}\nM99\n" for i in range(1, 12)) + "N12 M99\n", "CS401 N9"),
    "a program that is open is refused": (
        "gsk-988ta", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M98 P3\nN40 M99\nO3\nN50 M98 P2\nN60 M99\n", "CS403 N50"),
    "a program that is open may be called at a start": (
        "gsk-988ta", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M98 P3\nN40 M99\nN45 M99\nO3\nN50 M98 P2 Q45\nN60 M99\n", ""),
    "only the main program is refused": (
        "gsk-980tdi", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M98 P1\nN40 M99\n", "CS403 N30"),
    "a part that is fallen into": ("haas-ngc", "O1\nN10 M97 P100\nN20 G0 X1.\nN100 G0 Y1.\nN110 M99\n", "CS305 N100"),
    "a part after M30": ("haas-ngc", "O1\nN10 M97 P100\nN20 G0 X1.\nN30 M30\nN100 G0 Y1.\nN110 M99\n", ""),
    "a part that is jumped to": ("haas-ngc", "O1\nN10 M97 P100\nN20 GOTO 100\nN30 M30\nN100 G0 Y1.\nN110 M99\n", ""),
    "a called program may run into its part for the last pass": (
        "haas-ngc", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M97 P100\nN100 G0 Y1.\nN110 M99\n", ""),
    "the seventeenth caller of M99 P": (
        "", "O1\n" + "".join(f"M98 P{i}\n" for i in range(10, 27)) + "N90 M30\n" + "".join(f"O{i}\nM98 P2\nN20 M99\n" for i in range(10, 26)) + "O26\nM98 P2\nM99\nO2\nN30 M99 P20\n", "CS203 N30"),
    "L0 of a jump is passed over": ("mitsubishi-meldas", "O1\nN10 M98 H40 L0\nN20 G4 P1\nN40 M30\n", "CS703 N10"),
    "a block that may have been the end": ("", "O1\nN10 G0 X1. M9 M30\n", "CS101 N10"),
    # Loops
    "loops that cross": ("", "O1\nN5 #1=0\nN10 WHILE[#1 LT 3]DO1\nN20 WHILE[#1 LT 5]DO2\nN30 #1=#1+1\nN40 END1\nN50 END2\n" + END, "CS207 N20, CS207 N50"),
    "loops inside each other": ("", "O1\nN5 #1=0\nN10 WHILE[#1 LT 3]DO1\nN20 WHILE[#1 LT 5]DO2\nN30 #1=#1+1\nN40 END2\nN50 END1\n" + END, ""),
    "an END without its loop": ("gsk-988ta", "O1\nN10 END1\n" + END, "CS207 N10"),
    "an IF without its ENDIF": ("siemens-one", "N10 IF R1==1\nN20 G0 X1\nN30 M30\n", "CS207 N10"),
    "a label that two blocks have": ("siemens-one", "G0 X1\nGOTOF LAB\nLAB: X2\nLAB: X3\nM30\n", "CS204 :2"),
    "two labels that nobody jumps to": ("siemens-one", "G0 X1\nLAB: X2\nLAB: X3\nM30\n", ""),
    "what a subprogram with a label leaves on": (
        "linuxcnc", "o<a> sub\nN5 g91 g0 x1\no<a> endsub\nN10 g90 g0 x0\nN20 o<a> call\nN30 g1 x10 f100\nN40 m2\n", "CS501 N20"),
    "what it leaves as it was": (
        "linuxcnc", "o<a> sub\nN5 g91 g0 x1\nN6 g90\no<a> endsub\nN10 g90 g0 x0\nN20 o<a> call\nN30 g1 x10 f100\nN40 m2\n", ""),
    "labels that call in a circle": (
        "linuxcnc", "o<a> sub\nN5 o<b> call\no<a> endsub\no<b> sub\nN6 o<a> call\no<b> endsub\nN20 o<a> call\nN40 m2\n", "CS402 N6"),
    "a label that calls itself under a condition": (
        "linuxcnc", "o<f> sub\no1 if [#1 gt 1]\nN5 o<f> call [#1-1]\no1 endif\no<f> endsub\nN20 o<f> call [5]\nN40 m2\n", ""),
    "labels that call too deep": (
        "linuxcnc", "".join(f"o{i} sub\nN{i} o{i + 1} call\no{i} endsub\n" for i in range(100, 109))
        + "o109 sub\ng0 x1\no109 endsub\nN10 o100 call\nN20 m2\n", "CS401 N108"),
    "labels that call as deep as they may": (
        "linuxcnc", "".join(f"o{i} sub\nN{i} o{i + 1} call\no{i} endsub\n" for i in range(100, 108))
        + "o108 sub\ng0 x1\no108 endsub\nN10 o100 call\nN20 m2\n", ""),
    "an argument that a subprogram with a label never reads": (
        "linuxcnc", "o<a> sub\ng0 x#1\no<a> endsub\nN10 o<a> call [1] [2]\nN20 m2\n", "CS604 N10"),
    "a common that a subprogram with a label takes": (
        "linuxcnc", "o<a> sub\n#100=1\ng0 y#100\no<a> endsub\nN10 #100=2\nN20 g0 z#100\nN30 o<a> call\nN40 g0 x#100\nN50 m2\n", "CS606 N40"),
    "a macro that is called by M98 too": (
        "", "O1\nN10 G65 P2 A1.\nN20 M98 P2\nN30 M30\nO2\nN40 G0 X[#1+1.]\nN50 M99\n", "CS602 N40"),
    "by M98 where the caller has set it": (
        "", "O1\nN5 #1=2.\nN10 G65 P2 A1.\nN20 M98 P2\nN30 M30\nO2\nN40 G0 X[#1+1.]\nN50 M99\n", ""),
    "a subprogram that reads what nothing sets": ("", "O1\nN20 M98 P2\nN30 M30\nO2\nN40 G0 X[#1+1.]\nN50 M99\n", "CS601 N40"),
    "an argument that is the caller's own by M98": (
        "", "O1\nN5 #1=3.\nN6 G0 Z#1\nN10 G65 P2 A1.\nN20 M98 P2\nN25 G0 X#1\nN30 M30\nO2\nN40 #1=#1+1.\nN45 G0 Y#1\nN50 M99\n", "CS605 N25"),
    "a label whose head is refused": (
        "linuxcnc", "o1 if [#<_metric_machine>]\ng0 x1\no1 else\ng0 x2\no1 endif\nm2\n", "CS105 :1"),
    "a label without its end": ("linuxcnc", "#1=1\no1 while [#1 lt 3]\n#1=[#1+1]\nm2\n", "CS207 :2"),
    "an end without its label": ("linuxcnc", "o1 endif\nm2\n", "CS207 :1"),
    "labels that cross": ("linuxcnc", "#1=1\no1 while [#1 lt 3]\no2 if [#1 gt 1]\n#1=[#1+1]\no1 endwhile\no2 endif\nm2\n", "CS207 :3"),
    "labels inside each other": (
        "linuxcnc", "#1=1\no1 while [#1 lt 3]\no2 if [#1 gt 1]\n#1=[#1+1]\no2 elseif [1]\no2 else\no2 endif\no3 do\no1 continue\no3 while [0]\no1 endwhile\no4 repeat [2]\no4 endrepeat\nm2\n", ""),
    "a label means something in its subprogram": (
        "linuxcnc", "o100 sub\no1 if [#1]\ng0 x1\no1 endif\no100 endsub\no1 if [0]\no1 endif\no100 call [1]\nm2\n", ""),
    "a subprogram after the end of the main program": ("linuxcnc", "g0 x0\no100 call\nm2\no100 sub\ng0 x1\no100 endsub\n", ""),
    "a subprogram that another label ends": (
        "linuxcnc", "o1 sub\ng0 x1\no2 endsub\no1 call\nm2\n", "CS207 :3, CS207 :1"),
    "a subprogram without its end": ("linuxcnc", "o1 sub\ng0 x1\no2 sub\no2 endsub\no1 call\no2 call\nm2\n", "CS207 :1"),
    "a subprogram inside another one that ends": (
        "linuxcnc", "o1 sub\ng0 x1\no2 sub\ng0 x2\no2 endsub\no1 endsub\no1 call\no2 call\nm2\n", "CS208 :3"),
    "a break before a do loop": (
        "linuxcnc", "o1 while [1]\ng0 x1\no1 break\no1 endwhile\no2 do\ng0 x2\no2 while [0]\nm2\n", "CS209 :3"),
    "a break after it": ("linuxcnc", "o2 do\ng0 x2\no2 while [0]\no1 while [1]\ng0 x1\no1 break\no1 endwhile\nm2\n", ""),
    "a break out of the do loop": (
        "linuxcnc", "o1 do\ng0 x1\no1 break\no1 while [1]\no2 do\ng0 x2\no2 while [0]\nm2\n", ""),
    "two subprograms of a label": ("linuxcnc", "o100 sub\no100 endsub\no100 sub\ng0 x1\no100 endsub\nm2\n", "CS205 :3"),
    # Jumps and returns whose targets are texts
    "a jump by a text leads to labels": (
        "siemens-one", 'N10 R1=2\nN15 GOTOF "LAB"<<R1\nG0 X1\nLAB1: X3\nLAB2: X2\nN30 M30\n', "CS301 :3"),
    "one of several jumps by a text": (
        "siemens-one", 'DEF STRING[9] WAY="LAB"\nN10 IF R1==1 GOTOF WAY IF R1==0 GOTOF WAY\nGOTOF OUT\nG0 X1\nLAB: X2\nOUT: M30\n', "CS301 :4"),
    "a CASE by a text": (
        "siemens-one", 'DEF STRING[9] WAY="LAB"\nCASE(R1) OF 1 GOTOF WAY DEFAULT GOTOF OUT\nG0 X1\nLAB: X2\nOUT: M30\n', "CS301 :3"),
    "a return to a label": (
        "siemens-one", '%_N_MAIN_MPF\nN10 PART\nN15 M30\nLAB: G0 X1\nN30 M30\n%_N_PART_SPF\nN60 RET("LAB")\n', ""),
    "a return to a block number, and the block after it": (
        "siemens-one", '%_N_MAIN_MPF\nN10 PART\nN15 M30\nN20 G0 X1\nN30 M30\n%_N_PART_SPF\nN60 RET("N15",1)\n', ""),
    "a return over two levels": (
        "siemens-one", '%_N_MAIN_MPF\nN10 PART\nN15 M30\nG0 X1\nLAB: X2\nN30 M30\n%_N_PART_SPF\nN60 PART2\nM17\n%_N_PART2_SPF\nN70 RET("LAB",,2)\n',
        "CS301 :4"),
    "a return to a label that the caller has not": (
        "siemens-one", '%_N_MAIN_MPF\nN10 PART\nN15 M30\n%_N_PART_SPF\nN60 RET("LAB")\n', "CS203 N60"),
    "a return to a block of the main program ends the run": (
        "siemens-one", 'N10 RET("N20")\nN20 G0 X1\nM30\n', "CS301 N20"),
    "a part that texts name": (
        "siemens-one", 'DEF STRING[9] ONE="LAB"\nN10 CALL BLOCK ONE TO ONE\nN20 M30\nG0 X1\nLAB: X2\nN30 M30\n', "CS301 :4"),
    "a part of another program": (
        "siemens-one", '%_N_MAIN_MPF\nN10 CALL "PART" BLOCK ONE1 TO ONE1\nN20 M30\n%_N_PART_SPF\nN30 M17\nONE1: R1=1\nN40 M17\n', ""),
    "a part of a program that is not there": ("siemens-one", 'N10 CALL "NONE" BLOCK AA1 TO AA2\nN20 M30\n', "CS201 N10"),
    "a part of a program that lacks its end": (
        "siemens-one", '%_N_MAIN_MPF\nN10 CALL "PART" BLOCK ONE1 TO TWO2\nN20 M30\n%_N_PART_SPF\nN30 M17\nONE1: R1=1\nN40 M17\n', "CS202 N10"),
    "a jump to a label that is nowhere": ("siemens-one", "N10 GOTOF LAB\nN20 M30\n", "CS202 N10"),
    # Modes that are restored, and modes of the caller
    "a mode that a computed code puts back": (
        "", "O1\nN10 G90 G0 X0\nN20 G65 P2\nN30 X5.\n" + END + "O2\nN40 #33=#4003\nN50 G91 X1.\nN60 G#33\nN70 M99\n", ""),
    "a mode that the caller puts back by a computed code": (
        "", "O1\nN10 G90 G0 X0\nN15 #33=#4003\nN20 M98 P2\nN25 G#33\nN30 X5.\n" + END + "O2\nN50 G91 X1.\nN70 M99\n", ""),
    "modes that M73 keeps": (
        "linuxcnc", "o<a> sub\nM73\ng91 g0 x1\no<a> endsub\nN10 g90 g0 x0\nN20 o<a> call\nN30 g1 x10 f100\nN40 m2\n", ""),
    "modes that M72 takes back": (
        "linuxcnc", "o<a> sub\nM70\ng91 g0 x1\nM72\no<a> endsub\nN10 g90 g0 x0\nN20 o<a> call\nN30 g1 x10 f100\nN40 m2\n", ""),
    "a cycle is none of the modes that M73 keeps": (
        "linuxcnc", "o<a> sub\nM73\ng81 x1 z-1 r1 f100\no<a> endsub\nN10 g90 g0 x0\nN20 o<a> call\nN30 x10\nN40 m2\n", "CS501 N20"),
    "G90 that is left on where the caller has chosen G91": (
        "", "O1\nN10 G91 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G90 X1.\nN50 M99\n", "CS501 N20"),
    "G90 that is left on where the caller says G91 again": (
        "", "O1\nN10 G91 G0 X0\nN20 M98 P2\nN30 G91 X5.\n" + END + "O2\nN40 G90 X1.\nN50 M99\n", ""),
    "G17 that is left on where the caller has chosen G18": (
        "", "O1\nN10 G18 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G17 X1.\nN50 M99\n", "CS501 N20"),
    "what the caller had on may be switched off": (
        "", "O1\nN10 G81 X0 Z-1. R1. F9\nN20 M98 P2\nN30 X5.\nN40 G80\n" + END + "O2\nN50 G80 X1.\nN60 M99\n", ""),
    "a mode that leaks around a loop": (
        "", "O1\nN5 #1=0\nN10 WHILE[#1 LT 2]DO1\nN15 G0 X5.\nN20 M98 P2\nN25 #1=#1+1\nN30 END1\n" + END + "O2\nN50 G91 X1.\nN60 M99\n", "CS501 N20"),
    "a mode that each pass of a loop chooses": (
        "", "O1\nN5 #1=0\nN10 WHILE[#1 LT 2]DO1\nN15 G90 G0 X5.\nN20 M98 P2\nN25 #1=#1+1\nN30 END1\n" + END + "O2\nN50 G91 X1.\nN60 M99\n", ""),
    # Returns into loops, calls in profiles
    "M99 P of a main program to a number that two blocks have": ("", "O1\nN10 G0 X1.\nN10 G0 X2.\nN20 M99 P10\n", "CS204 N20"),
    "M99 P into a loop of the caller": (
        "", "O1\nN10 M98 P2\nN15 #1=0\nN20 WHILE[#1 LT 3]DO1\nN30 G4 P1\nN35 #1=#1+1\nN40 END1\n" + END + "O2\nN60 M99 P30\n", "CS602 N35, CS206 N60"),
    "M99 P inside the loop that calls": (
        "", "O1\nN15 #1=0\nN20 WHILE[#1 LT 3]DO1\nN25 M98 P2\nN30 #1=#1+1\nN40 END1\n" + END + "O2\nN60 M99 P30\n", ""),
    "a call in the profile of a cycle": (
        "gsk-988ta", "O1\nN5 G0 X50. Z2.\nN10 G71 U1. R1.\nN15 G71 P30 Q50 U0 W0 F0.1\nN30 G0 X10.\nN40 M98 P2\nN50 G1 X20.\n"
        + END + "O2\nN70 G1 Z-5.\nN80 M99\n", "CS101 N40"),
    "a call after the profile of a cycle": (
        "gsk-988ta", "O1\nN5 G0 X50. Z2.\nN10 G71 U1. R1.\nN15 G71 P30 Q50 U0 W0 F0.1\nN30 G0 X10.\nN50 G1 X20.\nN60 M98 P2\n"
        + END + "O2\nN70 G1 Z-5.\nN80 M99\n", ""),
    "profiles that have their numbers again": (
        "gsk-988ta", "O1\nN5 G0 X50. Z2.\nG71 U1. R1.\nG71 P30 Q50 U0 W0 F0.1\nN30 G0 X10.\nN50 G1 X20.\n"
        "G71 U1. R1.\nG71 P30 Q50 U0 W0 F0.1\nN30 G0 X9.\nN50 G1 X20.\n" + END, ""),
    # Values under conditions, names
    "a local that one condition sets": ("", "O1\nN10 IF[#500 EQ 1]THEN #1=5.\nN20 G0 X[#1+1.]\n" + END, "CS602 N20"),
    "a local that two conditions set": (
        "", "O1\nN10 IF[#500 EQ 1]THEN #1=5.\nN15 IF[#500 NE 1]THEN #1=6.\nN20 G0 X[#1+1.]\n" + END, ""),
    "a local that is read where its condition is asked again": (
        "", "O1\nN10 IF[#500 EQ 1]THEN #1=5.\nN15 IF[#500 NE 1]GOTO 90\nN20 G0 X[#1+1.]\n" + END, ""),
    "a name without a value": ("linuxcnc", "g0 x[#<a>+1]\nm2\n", "CS601 :1"),
    "a name has its value in its own subprogram": (
        "linuxcnc", "o<s> sub\n#<a>=1\no<s> endsub\no<s> call\ng0 x[#<a>+1]\nm2\n", "CS601 :5"),
    "a name of the caller in a subprogram": (
        "linuxcnc", "o<s> sub\ng0 x[#<a>+1]\no<s> endsub\n#<a>=1\ng0 y#<a>\no<s> call\nm2\n", "CS601 :2"),
    "a name that EXISTS asks for": ("linuxcnc", "o1 if [EXISTS[#<a>]]\no1 else\n#<a>=5\no1 endif\ng0 x[#<a>]\nm2\n", ""),
    "a name with a value on each way": (
        "linuxcnc", "o1 if [#5220 eq 1]\n#<a>=4\no1 else\n#<a>=5\no1 endif\ng0 x[#<a>]\nm2\n", ""),
    "a name of all programs that a subprogram takes": (
        "linuxcnc", "o<a> sub\n#<_n>=1\ng0 y#<_n>\no<a> endsub\nN10 #<_n>=2\nN20 g0 z#<_n>\nN30 o<a> call\nN40 g0 x#<_n>\nN50 m2\n", "CS606 N40"),
    "a name of its own that a subprogram has too": (
        "linuxcnc", "o<a> sub\n#<n>=1\ng0 y#<n>\no<a> endsub\nN10 #<n>=2\nN20 g0 z#<n>\nN30 o<a> call\nN40 g0 x#<n>\nN50 m2\n", ""),
    "a common of LinuxCNC that has the number of a name's place": (
        "linuxcnc", "#<a>=1\n#<b>=#<a>\no<a> sub\n#31=1\ng0 y#31 z#32\n#32=1\no<a> endsub\nN10 #31=2\nN20 g0 z#31\nN30 o<a> call\nN40 g0 x#31\nN50 m2\n", "CS606 N40"),
    "a result in a name of all programs": (
        "linuxcnc", "o<a> sub\n#<_n>=1\no<a> endsub\nN10 #<_n>=2\nN20 g0 z#<_n>\nN30 o<a> call\nN40 g0 x#<_n>\nN50 m2\n", ""),
    # Points
    "a centre without a point": ("", "O1\nN10 G0 X0.5\nN20 G2 X1.5 I10 F100\n" + END, "CS701 N20"),
    "a radius without a point": ("", "O1\nN10 G0 X0.5\nN20 G2 X1.5 R10 F100\n" + END, "CS701 N20"),
    "the R of a cycle without a point": ("", "O1\nN10 G0 X0.5\nN20 G81 Z-5. R2 F100\nN30 G80\n" + END, "CS701 N20"),
    "the count of a cycle needs no point": ("", "O1\nN10 G91 G0 X0.5\nN20 G81 X1. Z-5. R2. F100 K5\nN30 G80\n" + END, ""),
    "an argument without a point": ("", "O1\nN10 G0 X0.5\nN20 G65 P2 A5\n" + END + "O2\nN40 G0 X#1\nN50 M99\n", "CS701 N20"),
    "an argument that is no length": ("", "O1\nN10 G0 X0.5\nN20 G65 P2 H5\n" + END + "O2\nN40 G0 X#11\nN50 M99\n", ""),
    "an argument where a number is millimetres": ("mitsubishi-m800", "O1\nN10 G0 X0.5\nN20 G65 P2 A5\n" + END + "O2\nN40 G0 X#1\nN50 M99\n", ""),
    # IF without THEN
    "the end of a loop whose head is refused": (
        "", "O1\nN10 WH[[#500 GE 1]AND[#501 GE 2]]DO1\nN20 G0 X1.\nN30 END1\n" + END, "CS101 N10"),
    "the ELSE of an IF that is refused": (
        "mitsubishi-m800", "O1\nN10 IF[#500 EQ ]THEN\nN20 G0 X1.\nN30 ELSE\nN40 G0 X2.\nN50 ENDIF\n" + END, "CS101 N10"),
    "conditions that are joined where the control joins none": (
        "", "O1\nN10 IF[[#500 EQ 1]AND[#501 EQ 2]]GOTO 90\n" + END, "CS101 N10"),
    "what a refused assignment would have set": ("", "O1\nN10 #1=[2+3\nN20 G0 X[#1+1.]\n" + END, "CS101 N10"),
    "an IF with a code after it": ("mitsubishi-m700", "O1\nN10 IF[#500 EQ 1] M8\n" + END, "CS103 N10"),
    "an IF with nothing after it": ("", "O1\nN10 IF[#500 EQ 1]\n" + END, "CS101 N10"),
    # Offsets, shifts and calls that leak
    "G52 that is left on": ("", "O1\nN10 G54 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G52 X10.\nN50 M99\n", "CS501 N20"),
    "G52 that is taken back": ("", "O1\nN10 G54 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G52 X10.\nN45 G52 X0 Y0\nN50 M99\n", ""),
    "a work coordinate system": ("", "O1\nN10 G54 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G55\nN50 M99\n", "CS503 N20"),
    "the system of the caller": ("", "O1\nN10 G54 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G55 X1.\nN45 G54\nN50 M99\n", ""),
    "an origin by G92": ("", "O1\nN10 G54 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G92 X10.\nN50 M99\n", "CS503 N20"),
    "a rotation": ("", "O1\nN10 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G68 X0 Y0 R45.\nN50 M99\n", "CS501 N20"),
    "a rotation that is ended": ("", "O1\nN10 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G68 X0 Y0 R45.\nN45 G69\nN50 M99\n", ""),
    "a modal macro call": ("", "O1\nN10 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G66 P3\nN50 M99\nO3\nN60 M99\n", "CS501 N20"),
    "a modal macro call that is ended": ("", "O1\nN10 G0 X0\nN20 M98 P2\nN30 X5.\n" + END + "O2\nN40 G66 P3\nN45 X1.\nN46 G67\nN50 M99\nO3\nN60 M99\n", ""),
    "a feed per revolution where the caller feeds per minute": ("", "O1\nN10 G94 G0 X0\nN20 M98 P2\nN30 G1 X5. F100\n" + END + "O2\nN40 G95\nN50 M99\n", "CS501 N20"),
    "a kind of feed that the caller did not choose": ("", "O1\nN10 G0 X0\nN20 M98 P2\nN30 G1 X5. F100\n" + END + "O2\nN40 G95\nN50 M99\n", ""),
    "a constant surface speed": ("gsk-988ta", "O1\nN10 G97 S100 G0 Z0\nN20 M98 P2\nN30 G1 Z1. F1\n" + END + "O2\nN40 G96 S100\nN50 M99\n", "CS501 N20"),
    # Variables through several calls
    "a counter that a subprogram of a subprogram uses too": (
        "", "O1\nN10 #1=0\nN20 WHILE[#1 LT 3]DO1\nN30 M98 P2\nN40 #1=#1+1\nN50 END1\n" + END
        + "O2\nN55 M98 P3\nN56 M99\nO3\nN60 #1=0\nN70 G0 X#1\nN80 M99\n", "CS605 N40"),
    "the same where a macro is between them": (
        "", "O1\nN10 #1=0\nN20 WHILE[#1 LT 3]DO1\nN30 M98 P2\nN40 #1=#1+1\nN50 END1\n" + END
        + "O2\nN55 G65 P3\nN56 M99\nO3\nN60 #1=0\nN70 G0 X#1\nN80 M99\n", ""),
    "a common that a macro of a subprogram uses too": (
        "", "O1\nN10 #100=0\nN20 WHILE[#100 LT 3]DO1\nN30 M98 P2\nN40 #100=#100+1\nN50 END1\n" + END
        + "O2\nN55 G65 P3\nN56 M99\nO3\nN60 #100=0\nN70 G0 X#100\nN80 M99\n", "CS606 N40"),
    "a copy of an argument that one call of two gives": (
        "", "O1\nN10 G65 P2 A1.\nN20 G65 P2 B1.\n" + END + "O2\nN30 IF[#1 EQ #0]GOTO 50\nN40 #3=#1\nN50 #4=#2\nN60 G0 X#3 Y#4\nN70 M99\n", ""),
    # Logic
    "logic in a word": ("", "O1\nN10 G0 X[#500+1 AND 7]\n" + END, "CS705 N10"),
    "logic in an argument": ("", "O1\nN10 G65 P2 A[#500+1 AND 7]\n" + END + "O2\nN20 G0 X#1\nN30 M99\n", "CS705 N10"),
    "logic in the number of a jump": ("", "O1\nN10 GOTO[#500+1 AND 3]\nN20 M30\n", "CS705 N10"),
    "logic of words in a comment": ("", "O1\nN10 G0 X[#500+1] ([A+1 AND B])\n" + END, ""),
    "logic after a comment": ("", "O1\nN10 #1=#500+#501 (A OR B) AND 7\nN20 G0 X#1\n" + END, "CS705 N10"),
    "logic that stands in a comment alone": ("", "O1\nN10 #1=#500+#501 (A AND B)\nN20 G0 X#1\n" + END, ""),
    "logic beside a function of two arguments": (
        "haas-ngc", "O1\nN10 #1=ATAN[#500]/[#501] AND 7\nN20 G0 X#1\n" + END, "CS705 N10"),
    "conditions that are joined where logic comes last": (
        "mitsubishi-m700", "O1\nN10 IF[#500 EQ 1 AND #501 EQ 2]GOTO 90\n" + END, ""),
    "AND after OR where both bind alike": (
        "mitsubishi-m700", "O1\nN10 IF[[#500 EQ 1] OR [#501 EQ 2] AND [#502 EQ 3]]GOTO 90\n" + END, "CS705 N10"),
    "OR after AND is read as it looks": (
        "mitsubishi-m700", "O1\nN10 IF[[#500 EQ 1] AND [#501 EQ 2] OR [#502 EQ 3]]GOTO 90\n" + END, ""),
    "AND after OR from left to right": ("linuxcnc", "#1=1\no1 if [#1 eq 1 or #1 eq 2 and #1 eq 3]\no1 endif\nm2\n", "CS705 :2"),
    "AND after OR of named variables": (
        "linuxcnc", "#<a>=1\no1 if [#<a> eq 1 or #<a> eq 2 and #<_b> eq 3]\no1 endif\nm2\n", "CS705 :2"),
    "AND beside comparisons in LinuxCNC": ("linuxcnc", "#1=1\no1 if [#1 eq 1 and #1 lt 3]\no1 endif\nm2\n", ""),
    # Values that are easily mistaken
    "no point on a control of increments": ("", "O1\nN10 G0 X1.5 Y20\n" + END, "CS701 N10"),
    "no point where a number is millimetres": ("mitsubishi-m800", "O1\nN10 G0 X1.5 Y20\n" + END, ""),
    "no point anywhere": ("", "O1\nN10 G0 X1500 Y20\n" + END, ""),
    "many increments are meant": ("", "O1\nN10 G0 X1.5 Y20000\n" + END, ""),
    "X0 needs no point": ("", "O1\nN10 G0 X0 Y2.5\n" + END, ""),
    "a count in P that is meant": ("", "O1\nN10 M98 P21000\nN20 M30\nO1000\nN30 M99\n", ""),
    "L0 that alarms is a refusal": ("gsk-988ta", "O1\nN10 M98 P2 L0\nN20 M30\nO2\nN30 M99\n", "CS101 N10"),
    "a start block on a control that has none": ("fanuc-0i-f", "O1\nN10 M98 P2 Q5\nN15 M98 P2 H5\nN20 M30\nO2\nN5 M99\n", "CS704 N10, CS704 N15"),
    "a word that is not computed is told": (
        "siemens-one", "N10 T1 M6\nN20 H1 G0 X10\nN30 H2 BRISK\nN40 H0\nN50 M30\n", "CS105 N20, CS105 N30, CS105 N40"),
    "a start block on one that has it": ("gsk-988ta", "O1\nN10 M98 P2 Q5\nN20 M30\nO2\nN5 M99\n", ""),
    "H of a length offset in a block that calls": ("fanuc-0i-f", "O1\nN10 G43 H5 M98 P2\nN20 M30\nO2\nN5 M99\n", ""),
    "L where the count stands in P": ("gsk-980mdi", "O1\nN10 M98 P2 L3\nN20 M30\nO2\nN5 M99\n", "CS704 N10"),
    "L of M99": ("fanuc-16i", "O1\nN10 M98 P2\nN20 M30\nO2\nN5 M99 L2\n", "CS704 N5"),
    "L of M99 that counts": ("fanuc-0i-f", "O1\nN10 M98 P2\nN20 M30\nO2\nN5 M99 L0\n", ""),
    "M198 on a control without a device": ("hnc-21m", "%1\nN10 M198 P5\n" + END, "CS707 N10"),
    "what M97 would call elsewhere": ("", "O1\nN10 M97 P20\nN15 M30\nN20 G0 X1.\nN30 M99\n", "CS707 N10"),
    "M97 that calls": ("haas-ngc", "O1\nN10 M97 P20\nN15 M30\nN20 M99\n", ""),
    "M97 that jumps": ("mitsubishi-meldas", "O1\nN10 G4 P1\n" + END, ""),
    "M198 of LinuxCNC is a code of the machine's own": ("linuxcnc", "M198 P5\nM2\n", ""),
    "one M code too many": ("fanuc-0i-f", "O1\nN10 M8 M9\n" + END, "CS704 N10"),
    "brackets around what belongs together": ("mitsubishi-m800", "O1\nN10 IF[[#500 EQ 1] AND [#501 EQ 2]]GOTO 90\nN20 #502=[#503 AND 7]+1\n" + END, ""),
    "a sign is no operation": ("", "O1\nN10 #502=#503 AND -7\n" + END, ""),
    # Cycles
    "a cycle whose Z is forgotten at G80": (
        "", "O1\nN10 G0 X0 Z5.\nN20 G81 X1. Z-1. R1. F9\nN30 G80\nN40 G81 X2. R1.\nN50 G80\n" + END, "CS708 N40"),
    "a cycle that goes on from another one": (
        "", "O1\nN10 G0 X0 Z5.\nN20 G81 X1. Z-1. R1. F9\nN30 X2.\nN40 G83 X3. Q1.\nN50 G80\n" + END, ""),
    "a cycle that has its Z on one of two ways": (
        "", "O1\nN10 G0 X0 Z5.\nN20 G81 X1. Z-1. R1. F9\nN25 IF[#500 EQ 1]GOTO 40\nN30 G80\nN40 G81 X2. R1.\nN50 G80\n" + END, ""),
    "a cycle that stores its words and drills nothing on purpose": (
        "", "O1\nN10 G0 X0 Z5.\nN20 G81 R1. F9 K0\nN30 X1. Z-1.\nN50 G80\n" + END, ""),
    "a cycle whose Z comes with its first place": (
        "", "O1\nN10 G0 X0 Z5.\nN20 G81 R1. F9\nN30 X1. Z-1.\nN50 G80\n" + END, ""),
    "a cycle whose places come after it": (
        "", "O1\nN10 G0 X0 Z5.\nN20 G81 R1. F9\nN30 X1.\nN40 X2.\nN50 G80\n" + END, "CS708 N20"),
    "a cycle without a place": ("", "O1\nN10 G0 X0 Z5.\nN20 G81 F9\nN30 X1. Z-1. R1.\nN50 G80\n" + END, ""),
    "a cycle of a called program may have the Z of its caller": (
        "", "O1\nN10 G0 X0 Z5.\nN20 G81 Z-1. R1. F9 K0\nN30 M98 P2\nN40 G80\n" + END + "O2\nN60 G81 X2.\nN70 M99\n", ""),
    "a cycle in another plane": ("", "O1\nN10 G18 G0 X0 Y5.\nN20 G81 X1. Y-1. R1. F9\nN50 G80\n" + END, ""),
    "the cycles of a lathe": ("gsk-988ta", "O1\nN10 G0 X20. Z5.\nN20 G90 X18. W-5. F0.1\nN30 X16.\n" + END, ""),
    "K where the control counts by L": (
        "haas-ngc", "O1\nN10 G91 G0 X0\nN20 G81 X1. Z-1. R-1. F9. K3\nN30 G80\n" + END, "CS709 N20"),
    "K of a cycle that shifts or pecks": (
        "haas-ngc", "O1\nN10 G91 G0 X0\nN20 G73 X1. Z-1. R-1. Q1. F9. K3\nN30 G80\n" + END, ""),
    "K in a block after the cycle": (
        "haas-ngc", "O1\nN10 G91 G0 X0\nN20 G81 X1. Z-1. R-1. F9.\nN25 X1. K3\nN30 G80\n" + END, "CS709 N25"),
    "L in a block after the cycle": (
        "", "O1\nN10 G91 G0 X0\nN20 G81 X1. Z-1. R-1. F9.\nN25 Y1.\nN26 X1. L3\nN30 G80\n" + END, "CS709 N26"),
    "L after the end of the cycle": (
        "", "O1\nN10 G91 G0 X0\nN20 G81 X1. Z-1. R-1. F9.\nN25 G80\nN26 X1. L3\n" + END, ""),
    "both letters where both count": (
        "gsk-980mdi", "O1\nN10 G91 G0 X0\nN20 G81 X1. Z-1. R-1. F9. L3\nN25 X1. K3\nN30 G80\n" + END, ""),
    # Allowances and called programs without points
    "allowances in increments": (
        "gsk-988ta", "O1\nN5 G0 X50. Z2.\nN10 G71 U1. R1.\nN15 G71 P30 Q50 U500 W100 F0.1\nN30 G0 X10.\nN50 G1 X20.\n" + END, ""),
    "a called program without points beside a main program with points": (
        "", "O1\nN10 G0 X1.5\nN20 M98 P2000\n" + END + "O2000\nN40 G91 G1 X10 F100\nN50 G90\nN60 M99\n", "CS701 N40"),
    "programs that do not call each other": ("", "O1\nN10 G0 X1.5\n" + END + "O2\nN40 G1 X10 F100\nN60 M30\n", ""),
    # Commons
    "a common that a called program sets": (
        "", "O1\nN10 M98 P2\nN30 G0 X#100\n" + END + "O2\nN40 #100=1.\nN50 M99\n", ""),
    "a common that no program sets": ("", "O1\nN30 G0 X#100\n" + END, ""),
    "a common that is kept at power-off": (
        "", "O1\nN10 IF[#501 EQ 1]GOTO 30\nN20 #500=1.\nN30 G0 X#500\n" + END, ""),
    "a common that is compared with #0": (
        "", "O1\nN10 IF[#500 EQ 1]GOTO 25\nN20 #100=1.\nN25 IF[#100 EQ #0]GOTO 90\nN30 G0 X#100\n" + END, ""),
    "a common that is set below the move": ("", "O1\nN10 G0 X#100\nN20 #100=1.\n" + END, "CS607 N10"),
    "a common that is taken by another one of its numbers": (
        "haas-ngc", "O1\nN10 #100=0\nN20 WHILE [#100 LT 3] DO1\nN30 M98 P2\nN40 #10100=#100+1\nN50 END1\n" + END
        + "O2\nN60 #100=5\nN70 G0 X#100\nN80 M99\n", "CS606 N40"),
    # Loops over fractions
    "a loop that never meets its end": (
        "", "O1\nN10 #1=0\nN20 WHILE[#1 NE 1.]DO1\nN30 #1=#1+0.1\nN40 END1\n" + END, "CS711 N20"),
    "a loop whose end is no fraction": (
        "", "O1\nN10 #1=0\nN20 WHILE[#1 LE 1.]DO1\nN30 #1=#1+0.1\nN40 END1\n" + END, ""),
    "a loop of halves": ("", "O1\nN10 #1=0\nN20 WHILE[#1 NE 1.]DO1\nN30 #1=#1+0.5\nN40 END1\n" + END, ""),
    "a loop by GOTO": (
        "", "O1\nN10 #1=0\nN20 G0 X#1\nN30 #1=#1+0.1\nN40 IF[#1 LT 1.]GOTO 20\n" + END, "CS711 N40"),
    "a loop that a condition leaves": (
        "", "O1\nN10 #1=0\nN20 #1=#1+0.1\nN30 IF[#1 EQ 1.]GOTO 90\nN40 GOTO 20\n" + END, "CS711 N30"),
    "a loop that a condition leaves in time": (
        "", "O1\nN10 #1=0\nN20 #1=#1+0.1\nN30 IF[#1 GT 1.05]GOTO 90\nN40 GOTO 20\n" + END, ""),
    "a loop whose counter is rounded": (
        "", "O1\nN10 #1=0\nN20 WHILE[#1 LT 1.]DO1\nN30 #1=ROUND[#1*10+1]/10\nN40 END1\n" + END, ""),
    "a loop whose step and limit are variables": (
        "", "O1\nN5 #2=0.1\nN6 #3=1.\nN10 #1=0\nN20 WHILE[#1 LT #3]DO1\nN30 G0 X#1\nN40 #1=#1+#2\nN50 END1\n" + END, "CS711 N20"),
    "a loop whose step changes": (
        "", "O1\nN5 #2=0.1\nN10 #1=0\nN20 WHILE[#1 LT 1.]DO1\nN30 #2=#2*2\nN40 #1=#1+#2\nN50 END1\n" + END, ""),
    "a loop whose step is an argument": (
        "", "O1\nN5 G65 P2 B0.1\nN6 M30\nO2\nN10 #1=0\nN20 WHILE[#1 LT 1.]DO1\nN40 #1=#1+#2\nN50 END1\nN60 M99\n", ""),
    "a loop of labels": (
        "linuxcnc", "#1=0\no100 while [#1 lt 1]\ng0 x#1\n#1=[#1+0.1]\no100 endwhile\nm2\n", "CS711 :2"),
    "a loop of labels that counts a name of all programs": (
        "linuxcnc", "#<_n>=0\no100 while [#<_n> lt 1]\ng0 x#<_n>\n#<_n>=[0.1+#<_n>]\no100 endwhile\nm2\n", "CS711 :2"),
    "a loop of labels that counts a name": (
        "linuxcnc", "#<x>=0\no<edge> do\ng0 x#<x>\n#<x>=[#<x>+0.1]\no<edge> while [#<x> lt 1]\nm2\n", "CS711 :5"),
    "a loop of labels whose end is no fraction": (
        "linuxcnc", "#1=0\no100 while [#1 le 1.05]\ng0 x#1\n#1=[#1+0.1]\no100 endwhile\nm2\n", ""),
    "a loop of labels inside another one": (
        "linuxcnc", "#2=0\no99 while [#2 lt 3]\n#1=0\no100 while [#1 lt 1]\n#1=[#1+0.1]\no100 endwhile\n#2=[#2+1]\no99 endwhile\nm2\n", "CS711 :4"),
    "a loop of labels that compares for equality, which takes what is near": (
        "linuxcnc", "#1=0\no100 while [#1 ne 1]\n#1=[#1+0.1]\no100 endwhile\nm2\n", ""),
    # Inputs
    "an input after G103": ("haas-ngc", "O1\nN10 G103 P1\nN20 IF[#1001 EQ 1]GOTO 90\nN30 G4 P1\n" + END, ""),
    "an input where G103 is taken back": (
        "haas-ngc", "O1\nN10 G103 P1\nN15 G103\nN20 IF[#1001 EQ 1]GOTO 90\nN30 G4 P1\n" + END, "CS710 N20"),
    "an input in a macro whose caller has no limit": (
        "haas-ngc", "O1\nN10 G0 X0\nN20 G65 P9000 A1.\n" + END + "O9000\nN30 IF [#1004 EQ 0] GOTO 50\nN40 G0 X#1\nN50 M99\n", "CS710 N30"),
    "an input in a macro whose caller has one": (
        "haas-ngc", "O1\nN10 G103 P1\nN20 G65 P9000 A1.\n" + END + "O9000\nN30 IF [#1004 EQ 0] GOTO 50\nN40 G0 X#1\nN50 M99\n", ""),
    "an input in a macro that limits for itself": (
        "haas-ngc", "O1\nN10 G0 X0\nN20 G65 P9000 A1.\n" + END + "O9000\nN25 G103 P1\nN30 IF [#1004 EQ 0] GOTO 50\nN40 G0 X#1\nN50 G103\nN60 M99\n", ""),
    "an output that is set while the control waits": (
        "haas-ngc", "O1\nN10 #1101=1\nN20 G4 P1.\nN30 #1101=0\n" + END, "CS710 N10, CS710 N30"),
    "an output after G103": (
        "haas-ngc", "O1\nN5 G103 P1\nN10 #1101=1\nN20 G4 P1.\nN30 #1101=0\n" + END, ""),
    "a position, which is read when its block runs": (
        "haas-ngc", "O1\nN10 G0 X1.\nN20 #100=#5021\nN30 G0 Z#100\n" + END, ""),
    # Results of a call that is refused
    "blocks that a refused call would lead to": (
        "", "O1\nN10 M98 Q50\nN20 M30\nN50 G0 X1.\nN60 M99\n", "CS101 N10"),
    "blocks that a refused jump would lead to": ("", "O1\nN10 GOTO 77\nN20 G0 X1.\n" + END, "CS202 N10"),
    "a comment that is closed later in its line": ("", "O1\nN10 G0 X1. (A) (B)\n" + END, ""),
    "an open comment of a control that refuses it": ("gsk-980mdi", "O1\nN10 G0 X1. (A\n" + END, "CS101 N10"),
    # Spelling of blocks
    "an IF without THEN is refused": ("", "O1\nN10 IF[#500 EQ 1]#501=5\n" + END, "CS103 N10"),
    "an IF with THEN": ("", "O1\nN10 IF[#500 EQ 1]THEN #501=5\n" + END, ""),
    "two codes of a group": ("", "O1\nN10 G90 G91 X1.\n" + END, "CS801 N10"),
    "three codes of a group": ("", "O1\nN10 G0 G1 G2 X1. R1. F9\n" + END, "CS801 N10, CS801 N10"),
    "two codes of a group that the control refuses": ("gsk-980mdi", "O1\nN10 G0 G1 X1. F9\n" + END, "CS101 N10"),
    "codes of two groups": ("", "O1\nN10 G90 G1 G17 X1. F9\n" + END, ""),
    "a code twice": ("", "O1\nN10 G1 G1 X1. F9\n" + END, ""),
    "a block after a semicolon": ("", "O1\nN10 G0 X1. ; N20 Z1.\n" + END, "CS802 N20"),
    "two blocks after semicolons": ("", "O1\nN10 G0 X1.;N20 Z1.; N30 Y1.;\n" + END, "CS802 N20, CS802 N30"),
    "a semicolon at the end of its line": ("", "O1;\nN10 G0 X1.; \nN90 M30;\n", ""),
    "a semicolon before a comment": ("", "O1\nN10 G0 X1.;(N20 Z1.)\n" + END, ""),
    "a semicolon in a comment": ("", "O1\nN10 G0 X1. (A; N20 Z1.)\n" + END, ""),
    "a semicolon that begins a comment": ("hnc-21m", "%1\nN10 G0 X1.;N20 Z1.\n" + END, ""),
    "a small letter": ("", "O1\nN10 G0 X1. y2.\n" + END, "CS803 N10"),
    "small letters of a statement": ("", "O1\nN10 if[#500 eq 1]goto90\n" + END, "CS803 N10"),
    "a small o": ("", "O1\nN10 M98 P2\nN20 M30\no2\nN30 M99\n", "CS803 :4"),
    "small letters in a comment": ("", "O1\nN10 G0 X1. (up and away)\n" + END, ""),
    "small letters that are printed": ("", "O1\nN10 POPEN\nN20 DPRNT[abc]\nN30 PCLOS\n" + END, ""),
    "a program in small letters": ("", "O1\nn10 g0 x1.\nN20 Z1.\nn90 m30\n", "CS803 N10"),
    "a language that takes small letters": ("linuxcnc", "g0 x1\nm2\n", ""),
    "G99 where M99 is meant is one finding": ("", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.\nN40 G99\n", "CS706 N40"),
    "a code that is none of the control": ("mitsubishi-m800", "O1\nN10 G999\n" + END, "CS102 N10"),
    "a variable that a language refuses where it is read": ("linuxcnc", "N10 #6000=1\nM2\n", "CS104 N10"),
    "a parameter that the control lacks": ("siemens-one", "N10 R99999=1\nN20 M30\n", "CS104 N10"),
    "G99 in the middle": ("gsk-988ta", "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G99\nN40 M99\n", ""),
}  # fmt: skip


@pytest.mark.parametrize("claim", TABLE)
def test_table(claim: str) -> None:
    control, text, expected = TABLE[claim]
    assert ", ".join(found(text, control or MILL)) == expected


def test_a_finding_says_where_and_what_and_how() -> None:
    (finding,) = cncsub.loads(
        "O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 P25\n", control=MILL, name="part.nc"
    ).check()
    assert str(finding) == (
        "error CS203 return-target-missing [PS0078]: there is no N25 in O1\n"
        "  --> O2 N30, part.nc:5:9\n"
        "   | N30 M99 P25\n"
        "   |         ^^^\n"
        "called from O1 N10 (M98), part.nc:2\n"
        "hint: give that block its number in the caller, or return without P"
    )
    assert (finding.word, finding.file, finding.line, finding.column) == ("P25", "part.nc", 5, 9)
    assert finding.alarm is not None
    assert (finding.alarm.cause, finding.alarm.number) == ("return-target-not-found", "PS0078")
    assert [frame.program for frame in finding.path] == ["O1"]


def test_the_path_of_what_is_too_deep() -> None:
    chain = "".join(f"O{i}\nN{i} M98 P{i + 1}\nM99\n" for i in range(1, 8)) + "O8\nM99\n"
    (finding,) = cncsub.loads(chain, control="fanuc-16i").check(rules=["CS401"])
    assert [(f.program, f.called) for f in finding.path] == [
        ("O1", "O2"), ("O2", "O3"), ("O3", "O4"), ("O4", "O5"),
    ]  # fmt: skip
    assert finding.alarm is not None
    run = cncsub.loads(
        chain.replace("O1\nN1 M98 P2\nM99", "O1\nN1 M98 P2\nM30"), control="fanuc-16i"
    ).run()
    assert run.alarm is not None
    assert (run.alarm.number, run.alarm.program) == (finding.alarm.number, finding.program)


def test_a_common_is_told_by_its_number_and_a_name_by_its_name() -> None:
    sub = "o<a> sub\n#31=1\ng0 y#31\no<a> endsub\n"
    main = "#<n>=1\n#31=#<n>\ng0 z#31\no<a> call\ng0 x[#31+#<m>]\nm2\n"
    found = cncsub.loads(sub + main, control="linuxcnc").check()
    assert [finding.message for finding in found] == [
        "#<m> has no value here",
        "a, called in line 8, has overwritten #31",
    ]


def test_an_argument_that_no_call_by_a_code_gives() -> None:
    control = cncsub.controls[MILL].with_parameters({"6050": 100})
    text = "O1\nN10 G100 A5.\n" + END + "O9010\nN30 G0 X[#1+#2]\nN40 M99\n"
    assert [(f.rule, f.n) for f in cncsub.loads(text, control=control).check()] == [("CS603", 30)]


def test_rules_are_chosen_and_switched_off() -> None:
    text = "O1\nN10 M98 P9 (cncsub: ignore CS201)\nN20 M98 P8 (CNCSUB: IGNORE)\nN30 M98 P7 (cncsub: ignore CS202)\nN40 M3 M8\nN50 M30\n"
    assert found(text) == ["CS201 N30", "CS704 N40"]
    assert found(text, rules=["CS7"]) == ["CS704 N40"]
    assert found(text, rules=["program-missing"]) == ["CS201 N30"]
    assert found(text, rules=[]) == []
    with pytest.raises(KeyError, match="CS999"):
        found(text, rules=["CS999"])
    with pytest.raises(TypeError, match="a list"):
        found(text, rules="CS201")
    with pytest.raises(KeyError, match="O77"):
        found(text, main="O77")


def test_one_cause_is_one_finding_with_its_places() -> None:
    text = "O1\nN10 M98 P9 (cncsub: ignore)\nN20 M98 P9\nN30 M98 P9\nN40 M98 P8\nN50 M30\nO2\nN60 M98 P9\nM99\n"
    first, second, _ = cncsub.loads(text, control=MILL, name="part.nc").check()
    assert (first.rule, first.n, first.count, first.message) == (
        "CS201", 20, 3, "O9 is not in the memory",
    )  # fmt: skip
    assert [(p.program, p.n, p.line, p.column, p.word) for p in first.places] == [
        ("O1", 30, 4, 9, "P9"), ("O2", 60, 8, 9, "P9"),
    ]  # fmt: skip
    assert (second.n, second.count, second.places) == (40, 1, ())
    told = str(first)
    assert "O9 is not in the memory (and in 2 more places)" in told
    assert "\nalso in lines 4, 8\n" in told
    facts = finding_facts([first])["findings"][0]
    assert (facts["count"], [place["line"] for place in facts["places"]]) == (3, [4, 8])
    (result,) = sarif([first])["runs"][0]["results"]
    assert len(result["relatedLocations"]) == 2
    assert "(and in 2 more places)" in github_annotations([first])


def test_very_many_places_are_counted_and_the_first_are_told() -> None:
    (finding,) = cncsub.loads("O1\n" + "M98 P9\n" * 3000 + "M30\n", control=MILL).check()
    assert (finding.count, len(finding.places)) == (3000, 1000)
    assert str(finding).splitlines()[4].endswith("12, 13, 14, and 2,987 more")


def test_the_numbers_that_callers_lack_are_one_finding() -> None:
    callers = "".join(f"O{i}\nM98 P9000\nM99\n" for i in range(1, 30))
    (finding,) = cncsub.loads(callers + "O9000\nN5 M99 P5\n", control=MILL).check(rules=["CS203"])
    assert finding.message == "there is no N5 in O1, nor in 28 more callers"


def test_what_is_dropped_names_the_parameter() -> None:
    text = "O1\nN10 M3 M8 S100\nN20 M98 P2 Q5\nN30 M30\nO2\nN5 M99\n"
    codes, call = cncsub.loads(text, control=MILL).check(rules=["CS704"])
    assert "parameter 3404#7" in codes.message
    assert "parameter 6005#0" in call.message


def test_the_kind_of_machine_comes_from_the_setup() -> None:
    text = "O1\nN10 G71 U1. R1.\nN20 M30\n"
    assert found(text, "fanuc-16i") == ["CS105 N10"]
    assert found(text, "fanuc-16i", setup={"machine": "lathe-a"}) == []


# Causes that a block has whatever ran before it: each such alarm is found without running.
STATIC = {
    "address-without-value", "illegal-character", "start-not-found",
    "illegal-minus-sign", "external-program-not-found", "named-program-not-found",
}  # fmt: skip


def test_alarms_that_a_block_has_by_itself_are_found() -> None:
    seen = 0
    for row in rows():
        if row.case.mdi is not None or row.case.stop != "alarm":
            continue
        library = outcome.load(row.case, cncsub.controls[row.control])
        alarm = outcome.execute(row.case, library).alarm
        if alarm is None or alarm.cause not in STATIC or "#" in (alarm.word or ""):
            continue
        setup = (
            {"machine": row.case.setup["machine"]}
            if row.case.setup and "machine" in row.case.setup
            else None
        )
        causes = {
            (f.line, f.alarm.cause) for f in library.check(setup=setup) if f.alarm is not None
        }
        block = library[alarm.program].text if alarm.program in library else ""
        computed = any(word in block for word in ("#", "G66", "COD", "MCALL", "STRING"))
        seen += 1
        assert (alarm.line, alarm.cause) in causes or computed, (row, str(alarm))
    assert seen > 300


def test_examples_are_without_errors() -> None:
    for folder in ("fanuc/names_30i", "fanuc/probing"):
        findings = cncsub.load(EXAMPLES / folder, control="fanuc-30i").check()
        assert [str(f) for f in findings if f.severity == "error"] == []


@given(
    st.lists(
        st.sampled_from(
            ["N{0} G0 X1.", "N{0} M98 P2", "N{0} G65 P3 A1.", "N{0} IF[#1 EQ 1]GOTO {1}", "N{0} GOTO {1}",
             "N{0} M99", "N{0} M99 P{1}", "N{0} M30", "O2", "O3", "N{0} WHILE[#1 LT 2]DO1", "N{0} END1",
             "N{0} #1=#1+1", "N{0} GOTO#1", "/N{0} M98 P3", "N{0} G91", "N{0} #100=#100+1", "N{0} G66 P3"]
        ),
        max_size=40,
    ),
    st.sampled_from(sorted(cncsub.controls)),
)  # fmt: skip
def test_any_program_is_checked_and_nothing_that_ran_is_unreachable(
    lines: list[str], control: str
) -> None:
    text = "O1\n" + "\n".join(line.format(i, i * 7 % 40) for i, line in enumerate(lines)) + "\n"
    library = cncsub.loads(text, control=control)
    findings = library.check()
    run = library.run(max_blocks=2000, max_cycles=3)
    ran = {(step.program, step.line) for step in run.steps}
    for finding in findings:
        if finding.rule == "CS301":
            assert (finding.program, finding.line) not in ran, str(finding)
    labels = control == "linuxcnc"  # labels decide the path at run time
    if (
        run.alarm is not None
        and not labels
        and run.alarm.cause in ("program-not-found", "end-of-record")
    ):
        assert any(f.alarm is not None and f.alarm.cause == run.alarm.cause for f in findings)


@given(
    st.text(alphabet="OGMNPLQXYZ#0123456789.-+*/[]()%; \n\t\x00oIFGTWHLEDOND1é", max_size=300),
    st.sampled_from(sorted(cncsub.controls)),
)
def test_any_text_is_checked(text: str, control: str) -> None:
    library = cncsub.loads(text, control=control)
    for finding in library.check():
        assert finding.message
        assert str(finding)
    for name in library:
        library.flow(name)
    run = library.run(max_blocks=200)
    assert 0 <= run.coverage().percent <= 100


def test_no_block_that_a_row_executes_is_told_as_unreachable() -> None:
    seen, wrong = set(), []
    for row in rows():
        case = row.case
        dialect = row.control if row.control in ("linuxcnc", "siemens-one") else "iso"
        if (case.program, dialect) in seen or not case.program:
            continue
        seen.add((case.program, dialect))
        library = outcome.load(case, cncsub.controls[row.control])
        unreached = {(f.program, f.line) for f in library.check(rules=["CS301"])}
        if unreached:
            ran = {(step.program, step.line) for step in outcome.execute(case, library).steps}
            wrong += [f"{row}: {place}" for place in unreached & ran]
    assert not wrong
    assert len(seen) > 3000


def test_flow_holds_every_way_that_a_run_takes() -> None:
    text = "O1\nN10 #1=0\nN20 WHILE[#1 LT 3]DO1\nN30 IF[#1 EQ 1]GOTO 50\nN40 M98 P2\nN50 #1=#1+1\nN60 END1\nN70 M30\nO2\nN80 M99\n"
    library = cncsub.loads(text, control=MILL)
    flow = library.flow("O1")
    ways = {(edge.block, edge.to) for edge in flow.edges}
    own = [step.line - 2 for step in library.run().steps if step.program == "O1"]
    assert set(pairwise(own)) <= ways
    assert (flow.returns, flow.ends, flow.unreached) == ((), (6,), ())
    assert flow.to_dot().startswith("digraph flow {")
    with pytest.raises(KeyError, match="O9"):
        library.flow("O9")


# ---- outputs ----

WRONG = "O1\nN10 G0 X1.5 (<&>)\nN20 M98 P2\nN30 M98 P9\nN40 M30\nO2\nN50 M99 P7\n"


def wrong() -> list[cncsub.Finding]:
    return cncsub.loads(WRONG, control=MILL, name="a b/part.nc").check()


def test_json_is_what_the_schema_says() -> None:
    facts = json.loads(json.dumps(finding_facts(wrong())))
    schema = json.loads((Path(__file__).parent.parent / "docs/findings.schema.json").read_text())
    jsonschema.validate(facts, schema)
    last = cncsub.loads("O1\nM98 P2\nM30\nO2\nG99\n", control=MILL).check()
    jsonschema.validate(json.loads(json.dumps(finding_facts(last))), schema)
    assert facts["version"] == 1
    assert {len(row) for row in facts["findings"]} == {16}
    first = facts["findings"][0]
    assert (first["rule"], first["alarm"]["number"], first["path"]) == ("CS201", "PS0076", [])


def test_sarif_names_rules_places_and_calls() -> None:
    log = sarif(wrong())
    (run,) = log["runs"]
    assert log["version"] == "2.1.0"
    assert [rule["id"] for rule in run["tool"]["driver"]["rules"]] == [r.number for r in RULES]
    for result in run["results"]:
        assert run["tool"]["driver"]["rules"][result["ruleIndex"]]["id"] == result["ruleId"]
        place = result["locations"][0]["physicalLocation"]
        assert place["artifactLocation"]["uri"] == "a%20b/part.nc"
        assert 1 <= place["region"]["startColumn"] < place["region"]["endColumn"]
    (flow,) = [r["codeFlows"] for r in run["results"] if "codeFlows" in r]
    assert len(flow[0]["threadFlows"][0]["locations"]) == 2


def test_junit_and_annotations() -> None:
    suite = ElementTree.fromstring(junit(wrong(), ["a b/part.nc", "good.nc"]))
    assert (suite.get("tests"), suite.get("failures")) == ("2", "1")
    lines = github_annotations(wrong()).splitlines()
    assert len(lines) == len(wrong())
    assert lines[0].startswith(
        "::error file=a b/part.nc,line=4,col=9,title=CS201 program-missing::"
    )


def test_notes_alone_are_no_failure_of_junit() -> None:
    note = cncsub.loads("O1\nN10 G7.1 C1.\nN20 M30\n", control=MILL, name="a.nc").check()
    suite = ElementTree.fromstring(junit(note, ["a.nc"]))
    assert (suite.get("failures"), suite.find("testcase/failure")) == ("0", None)
    told = suite.findtext("testcase/system-out")
    assert told is not None
    assert told.startswith("note CS105 not-computed")


def command(*words: str, folder: Path | None = None) -> tuple[int, str]:
    done = CliRunner().invoke(app, list(words))
    return done.exit_code, done.output


@pytest.fixture
def part(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "part.nc"
    file.write_text("O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.5 (\u4e2d)\nG99\n", encoding="gbk")
    return file


def test_the_command_tells_and_its_status_says_whether(part: Path) -> None:
    status, output = command("check", "part.nc", "-c", MILL)
    assert status == 1
    assert "warning CS706 g99-for-m99 [PS5010]: G99 does not return" in output
    assert output.endswith("checked: 2 programs on FANUC Series 0i-F: 1 warning\n")
    assert command("check", "part.nc", "-c", MILL, "--ignore", "CS303", "--ignore", "CS7")[0] == 0
    status, output = command("check", "part.nc", "-c", MILL, "--rule", "CS999")
    assert (status, output.startswith("cncsub: check has no rule 'CS999'")) == (2, True)


def test_files_are_checked_apart_with_what_they_call(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for place, name, text in (
        ("a", "main.nc", "O1\nN10 M98 P2\nN20 M30\n"),
        ("a", "O2.nc", "O2\nN30 M98 P9\nN40 M99\n"),
        ("b", "main.nc", "O1\nN10 G4 P1\nN20 M30\n"),
    ):
        Path(place).mkdir(exist_ok=True)
        Path(place, name).write_text(text)
    files = [str(Path(place, "main.nc")) for place in "ab"]
    status, told = command("check", *files, "-c", MILL)
    assert (status, "program-missing" in told, "duplicate-program" in told) == (1, True, True)
    status, told = command("check", "--apart", *files, *files, "-c", MILL)
    assert (status, told) == (0, "checked: 3 programs on FANUC Series 0i-F: nothing found\n")
    status, told = command("check", "--apart", str(Path("a", "O2.nc")), "-c", MILL)
    assert (status, "O9 is not in the memory" in told) == (1, True)


def test_a_finding_whose_edit_fits_no_more_is_left() -> None:
    text = "O1\nN10 g0 x1. (x1.)\nN20 M30\n"
    (small,) = cncsub.loads(text, control=MILL, name=__file__).check(rules=["CS803"])
    mended = Mended([small])
    assert (mended.left, mended.mends(small), mended.diff()) == (1, False, "")


def test_certain_edits_are_shown_and_written(part: Path) -> None:
    before = part.read_bytes()
    _, output = command("check", "part.nc", "-c", MILL, "--diff")
    assert "-G99\n+M99\n" in output
    assert part.read_bytes() == before
    status, output = command("check", "part.nc", "-c", MILL, "--fix", "--rule", "CS706")
    assert (status, "mended: part.nc" in output) == (0, True)
    assert part.read_bytes() == before.replace(b"G99", b"M99")
    assert command("check", "part.nc", "-c", MILL)[0] == 0


MENDED = {
    "CS101": "O1\nN10 G0 XO. Y1.\nN20 G1 X1,5 F100\nN30 G0 Z-O.5\nN90 M30\n",
    "CS303": "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.5 (\u4e2d)\nO3\nN40 M30\n",
    "CS103": "O1\nN10 IF[#500 EQ 0]#501=5\nN20 IF [#501 EQ 5] #502=#501 (\u4e2d #)\nN90 M30\n",
    "CS706": "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.5\nG99\n",
    "CS803": "O1\nN10 g0 x1. Y2. x1. (up)\nN15 m98 p2\nN20 #500=sin[30.]\nN90 M30\nG4\no2\nM99\n",
}  # fmt: skip


@pytest.mark.parametrize("rule", MENDED)
def test_a_certain_edit_mends_and_changes_nothing_else(rule: str, tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text(MENDED[rule], encoding="utf-8")
    before = cncsub.load(file, control=MILL)
    assert [f.rule for f in before.check(rules=[rule]) if f.fix]
    assert command("check", str(file), "-c", MILL, "--rule", rule, "--fix")[0] == 0
    after = cncsub.load(file, control=MILL)
    assert after.check(rules=[rule]) == []
    run = after.run()
    assert run.stop is cncsub.Stop.END
    was = before.run()
    if was.alarm is None:  # a program that ran does the same
        assert run.steps.line.tolist() == was.steps.line.tolist()
        assert dict(run.variables) == dict(was.variables)
        assert run.position == was.position
    else:  # a program that was refused runs as far as before, and further
        assert run.steps.line.tolist()[: len(was.steps)] == was.steps.line.tolist()
        assert len(run.steps) > len(was.steps)


@pytest.mark.parametrize(
    "rule",
    [rule for rule in RULES if rule.number in ("CS706", "CS803")],
    ids=lambda rule: rule.name,
)
def test_the_example_of_a_rule_with_a_certain_edit_is_mended(
    rule: CheckRule, tmp_path: Path
) -> None:
    file = tmp_path / "part.nc"
    file.write_text(rule.example)
    command("check", str(file), "-c", rule.control, "--rule", rule.number, "--fix")
    assert cncsub.load(file, control=rule.control).check(rules=[rule.number]) == []


PART = "N20 M30\nN30 G0 X20.\n"


@pytest.mark.parametrize(
    ("control", "text", "fixed"),
    [
        ("gsk-928te", f"%00\nN10 M98 P30\n{PART}", True),
        ("haas-ngc", f"O1\nN10 M97 P30\n{PART}", True),
        ("haas-ngc", f"O1\nM98 P2\nM30\nO2\nN10 M97 P30\nM99\n{PART[8:]}", True),
        ("gsk-928te", f"%00\nN10 M98 P30\n{PART[8:]}", False),  # the main program comes there too
        ("haas-ngc", "O1\nN10 M97 P30\nGOTO 40\nN30 G0 X2.\nN40 X1.\n", False),
    ],
)
def test_a_part_that_is_called_and_runs_into_the_end_gets_its_return(
    control: str, text: str, fixed: bool
) -> None:
    (finding,) = cncsub.loads(text, control=control).check(rules=["CS303"])
    assert (finding.fix is not None) is fixed
    if finding.fix is not None:
        (edit,) = finding.fix
        mended = cncsub.loads(f"{text[:-1]}{edit.new}\n", control=control)
        assert mended.check(rules=["CS303"]) == []
        assert mended.run().stop is cncsub.Stop.END


def test_what_is_not_certain_has_no_edit() -> None:
    text = "O1\nN10 IF[#500 EQ 0]M8\nN20 G0 G1 X1. F9\nN30 G0 X1.5\nN40 Y10\nN50 X1.;Z1.\nN90 M30\n"
    findings = cncsub.loads(text, control=MILL).check()
    assert {f.rule for f in findings} >= {"CS103", "CS701", "CS801", "CS802"}
    assert [f for f in findings if f.fix] == []


def test_a_project_says_what_no_command_needs_again(part: Path, tmp_path: Path) -> None:
    file = tmp_path / "cncsub.toml"
    file.write_text('control = "fanuc-0i-f"\nfolders = ["."]\n[check]\nignore = ["CS303"]\n')
    status, output = command("check")
    assert (status, output.count("CS706")) == (1, 1)
    file.write_text(file.read_text() + '[check.severity]\nCS706 = "note"\n')
    assert command("check")[0] == 0
    assert "PS5010" in command("run")[1]
    for text, told in (
        ("contro1 = 1", "'contro1'; did you mean control"),
        ("control = 1", "control must be a text"),
        ('[check]\nignore = ["CS999"]', "CS999"),
        ('[check]\nrules = ["CS1"]', "ignore and severity"),
        ("control", "cncsub.toml"),
    ):
        file.write_text(text)
        status, output = command("check", "part.nc", "-c", MILL)
        assert status == 2
        assert told in output, output
    file.unlink()
    (tmp_path / "pyproject.toml").write_text('[tool.cncsub]\ncontrol = "gsk-988ta"\n')
    assert "GSK 988TA" in command("check", "part.nc")[1]


def test_a_rule_is_explained() -> None:
    status, output = command("explain", "cs201")
    assert status == 0
    assert output.startswith("CS201 program-missing, error\n  finds: a call of a program")
    assert (
        json.loads(command("explain", "CS201", "--format", "json")[1])["name"] == "program-missing"
    )
    assert command("explain", "CS999")[0] == 2


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["missing.nc"], "missing.nc: no such file or folder"),
        (["part.nc", "--main", "O7"], "no program O7"),
        (["part.nc", "--rule", "CS9"], "check has no rule 'CS9'"),
        (["part.nc", "--format", "xml"], "'xml' is not one of"),
        (["part.nc", "--param", "x"], "NAME=VALUE"),
        (["part.nc", "--setup", "no.toml"], "no.toml: No such file"),
        (["part.nc", "--encoding", "klingon"], "unknown encoding 'klingon'"),
        (["part.nc", "-o", "no/such/folder.json", "--format", "json"], "No such file or directory"),
        (["-", "--fix"], "give its file"),
        (["empty"], "there is no program in the folder"),
    ],
)
def test_wrong_use_is_told_with_exit_status_2(part: Path, words: list[str], told: str) -> None:
    (part.parent / "empty").mkdir()
    status, output = command("check", *words, "-c", MILL)
    assert (status, told in output) == (2, True), output
    assert "Traceback" not in output


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[tool.cncsub]\n", "its keys belong at the top"),
        ("folders = [1]", "folders must be a list of texts, not 1"),
        ("parameters = 3", "parameters must be a table"),
        ('parameters = {a = "b"}', "the parameter a must be a number"),
        ('[check]\nseverity = {CS201 = "fatal"}', "a severity must be error, warning, note"),
        ("\udcff\udcfe", "it is not a text in UTF-8"),
        ('control = "fanuc-0i-x"', "did you mean fanuc-0i-f"),
    ],
)
def test_a_project_that_means_nothing_is_told(part: Path, text: str, told: str) -> None:
    (part.parent / "cncsub.toml").write_bytes(text.encode(errors="surrogateescape"))
    status, output = command("check", "part.nc")
    assert (status, told in output) == (2, True), output


@pytest.mark.parametrize(
    ("data", "status"),
    [
        (b"", 1),
        (bytes(range(256)) * 40, 1),
        (b"O1\nN10 G0 X" + b"1" * 3_000_000 + b"\nM30\n", 1),
        (b"O1\nN10 (" + b"a" * 3_000_000 + b")\nM30\n", 0),
        ("O1\nM30\n".encode("utf-16"), 0),
    ],
    ids=["empty", "binary", "a long word", "a long comment", "utf-16"],
)
@pytest.mark.parametrize("format", ["text", "json", "sarif", "junit", "github"])
def test_any_file_has_a_defined_outcome(
    tmp_path: Path, data: bytes, status: int, format: str
) -> None:
    file = tmp_path / "any.nc"
    file.write_bytes(data)
    done, output = command("check", str(file), "-c", MILL, "--format", format)
    assert done == status
    if format == "text":
        assert max(map(len, output.splitlines()), default=0) < 1000
    if format == "json":
        assert all(finding["line"] >= 1 for finding in json.loads(output)["findings"])


def test_m99_is_put_behind_the_last_line_with_the_ends_of_its_file(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_bytes(b"O1\r\nM98 P2\r\nM30\r\nO2\r\nG0 X1. (\xd6\xd0)\r\n%\r\n")
    assert "+M99" in command("check", str(file), "-c", MILL, "--diff")[1]
    assert command("check", str(file), "-c", MILL, "--fix")[0] == 0
    assert file.read_bytes().endswith(b"G0 X1. (\xd6\xd0)\r\nM99\r\n%\r\n")


def test_paths_lead_from_the_program_that_is_run() -> None:
    text = "O1\nN10 M98 P2\nM30\nO2\nN20 G65 P3 A1.\nM99\nO3\nN30 G0 X#1\nN40 M98 P9\nM99\n"
    library = cncsub.loads(text, control=MILL)
    (finding,) = library.check()
    assert [(f.program, f.n, f.kind) for f in finding.path] == [
        ("O1", 10, "M98"), ("O2", 20, "G65"),
    ]  # fmt: skip
    assert finding.alarm is not None
    run = library.run()
    assert run.alarm is not None
    frames = [(f.program, f.n, f.kind) for f in run.alarm.frames]
    assert [(f.program, f.n, f.kind) for f in finding.alarm.frames] == frames
    assert library.check("O2")[0].path[0].program == "O2"


# ---- brackets around logic ----


@pytest.mark.parametrize(
    ("control", "written", "mended"),
    [
        ("fanuc-0i-f", "#1=#2+#3 AND 7", "#1=#2+[#3 AND 7]"),
        ("fanuc-0i-f", "IF[#1 AND 3 EQ 3]GOTO 90", "IF[[#1 AND 3] EQ 3]GOTO 90"),
        ("fanuc-0i-f", "G0 X[#2*2 OR #3]", "G0 X[[#2*2] OR #3]"),
        ("fanuc-0i-f", "#1=[[[[#2+#3 AND 7]]]]", None),  # there would be too many brackets
        ("fanuc-0i-f", "#1=ATAN[#1]/[2] AND 7", None),  # it is not certain to which the / belongs
        ("hnc-21m", "#1=#2+#3 AND 7", "#1=[#2+#3] AND 7"),
        ("mitsubishi-m700", "#1=#2+#3 AND 7", "#1=#2+[#3 AND 7]"),
        ("linuxcnc", "#1=[#2 OR #3 AND 7]", "#1=[[#2 OR #3] AND 7]"),
    ],
)
def test_brackets_are_offered_that_keep_what_is_done(
    control: str, written: str, mended: str | None
) -> None:
    head = {"linuxcnc": "", "hnc-21m": "%1\n"}.get(control, "O1\n")
    text = f"{head}N10 {written}\n{END}"
    (finding,) = (f for f in cncsub.loads(text, control=control).check() if f.rule == "CS705")
    if mended is None:
        assert finding.fix is None
        return
    assert finding.fix is not None
    (edit,) = finding.fix
    assert written.replace(edit.old, edit.new, 1) == mended
    text = text.replace(written, mended)
    assert not [f for f in cncsub.loads(text, control=control).check() if f.rule == "CS705"]


@given(st.randoms(use_true_random=False))
def test_brackets_that_are_offered_keep_the_value(random: Any) -> None:
    def value(depth: int) -> str:
        kind = random.randint(0, 6)
        if kind == 0 and depth < 2:
            return f"[{expression(depth + 1)}]"
        if kind == 1 and depth < 2:
            return f"ABS[{expression(depth + 1)}]"
        return random.choice((f"#{random.randint(1, 9)}", f"-#{random.randint(1, 9)}", "3", "6"))

    def expression(depth: int) -> str:
        names = ("+", "-", "*", " AND ", " OR ", " XOR ", " MOD ")
        parts = [value(depth)]
        for _ in range(random.randint(0, 3)):
            parts += [random.choice(names), value(depth)]
        return "".join(parts)

    control = random.choice(("fanuc-0i-f", "hnc-21m", "gsk-988ta", "mitsubishi-m700", "haas-ngc"))
    written = expression(0)
    head = "%1" if control == "hnc-21m" else "O1"
    text = f"{head}\nN10 #100={written}\n{END}"
    found = [f for f in cncsub.loads(text, control=control).check() if f.rule == "CS705"]
    if not found or found[0].fix is None:
        return
    (edit,) = found[0].fix
    mended = text.replace(edit.old, edit.new, 1)
    given_values = {number: float(number * 5 % 13) for number in range(1, 10)}
    runs = [cncsub.loads(t, control=control).run(variables=given_values) for t in (text, mended)]
    assert runs[0].variables[100] == runs[1].variables[100], (text, mended)
    assert [run.alarm is None for run in runs] in ([True, True], [False, False])
