"""GSK: variables."""

from conformance import case

case(
    "a vacant variable counts as 0 in a word of the 980TDi (TD-009)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G0 X#1
        M30
    """,
    moves_x=[0],
)

case(
    "a value assigned to #0 alarms on the 980TDi (TD-024)",
    control="gsk-980tdi",
    source="MDia 117 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        #0=1
        M30
    """,
    moves_x=[],
    alarm="vacant-assigned",
    number="0117",
    at="O1",
)

case(
    "#9100 is the variable whose number stands in #100 (TD-026)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        #100=205
        #205=500
        G0 X#9100
        M30
    """,
    moves_x=[500],
)

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def values_980(claim, statement, expected, **row):
    """Write a row: a statement of the 980TDi, #1 and #150 vacant, #100=205, #110=500, #120=2.5."""
    row = {"source": "TDi28, variables", "evidence": MANUAL, **row}
    case(
        f"GSK 980TDi: {claim}",
        control=TDI, program=f"O1\nN10 {statement}\nN20 M30\n",
        variables={1: None, 100: 205, 110: 500, 120: 2.5, 150: None, 101: 110},
        runs="N10 N20", vars=expected, **row,
    )


values_980("#9101 is the variable whose number stands in #101", "#130=#9101", {130: 500})
values_980("#9101 can be written", "#9101=7", {110: 7, 101: 110})
values_980("#9101 may stand on both sides", "#9101=#9101+1", {110: 501})
values_980("#[#101] is the variable whose number stands in #101", "#130=#[#101]", {130: 500})
values_980("#[#101+10] computes the number", "#130=#[#101+10]", {130: 2.5})
values_980("#[expression] can be written", "#[#101+20]=8", {130: 8})
values_980("a vacant variable assigned stays vacant", "#2=#1", {2: None})
values_980("#0 assigned makes a variable vacant", "#100=#0", {100: None})
values_980("a vacant variable times five is zero", "#2=#1*5", {2: 0})
values_980("a vacant variable plus itself is zero", "#2=#1+#1", {2: 0})
values_980("in a comparison vacant equals zero", "IF[#1 EQ 0]THEN #130=1", {130: 1})
values_980("in a comparison zero equals vacant", "IF[0 EQ #0]THEN #130=1", {130: 1})
values_980("vacant is not unequal to vacant", "IF[#1 NE #0]THEN #130=1", {130: None})
values_980("vacant is greater or equal to vacant", "IF[#1 GE #0]THEN #130=1", {130: 1})
values_980("vacant is not greater than vacant", "IF[#1 GT #0]THEN #130=1", {130: None})
values_980("G65 H sees vacant as zero", "G65 H02 P#130 Q#1 R3", {130: 3})
values_980("#500 is a common variable", "#500=#120", {500: 2.5})
values_980("#999 is a common variable", "#999=#120", {999: 2.5})
values_980("#33 is a local variable", "#33=#120", {33: 2.5})
values_980("#199 is a common variable", "#199=#120", {199: 2.5})
case(
    "GSK 980TDi: a vacant variable as a value of an axis is zero",
    control=TDI, source="TDi28, vacant variables (1)", evidence=MANUAL,
    program="O1\nN10 G0 X100 Z50\nN20 G0 X90 Z#1\nN30 M30\n",
    runs="N10 N20 N30", moves_x=[100, 90], final_work="X90 Z0",
)
case(
    "GSK 980TDi: an axis takes the negative of a variable",
    control=TDI, source="TDi28, reference to variables (1)", evidence=MANUAL,
    program="O1\nN10 G0 X100 Z-#110\nN20 M30\n", variables={110: 250},
    runs="N10 N20", final_work="X100 Z-250",
)
case(
    "GSK 980TDi: an axis takes a variable by way of #9100",
    control=TDI, source="TDi28, reference to variables (2)", evidence=MANUAL,
    program="O1\nN10 G0 X#9100 Z-#9100\nN20 M30\n", variables={100: 120, 120: 30},
    runs="N10 N20", final_work="X30 Z-30",
)
case(
    "GSK 980: #0 cannot be written",
    control=FAMILY_980, source="MDia 117; TDi28", evidence=MANUAL,
    program="O1\nN10 #100=1\nN20 #0=#100\nN30 M30\n",
    runs="N10", alarm="vacant-assigned", number="0117", at="O1 N20",
)
case(
    "GSK 980: there is no #34",
    control=FAMILY_980, source="MDia 111; TDi28, variables", evidence=MANUAL,
    program="O1\nN10 #100=1\nN20 #34=1\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20",
)
case(
    "GSK 980: #34 cannot be read either",
    control=FAMILY_980, source="MDia 111; TDi28, variables", evidence=MANUAL,
    program="O1\nN10 #100=1\nN20 #100=#34\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20", vars={100: 1},
)
case(
    "GSK 980: there is no #99",
    control=FAMILY_980, source="MDia 111; TDi28, variables", evidence=MANUAL,
    program="O1\nN10 #100=1\nN20 #99=1\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20",
)
case(
    "GSK 980: #99 cannot be read either",
    control=FAMILY_980, source="MDia 111; TDi28, variables", evidence=MANUAL,
    program="O1\nN10 #100=1\nN20 #100=#99\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20", vars={100: 1},
)
case(
    "GSK 980TDi: #9101 is refused where #101 names no variable",
    control=TDI, source="MDia 111; TDi28", evidence=INFERRED,
    program="O1\nN10 #101=50\nN20 #9101=1\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20",
)
case(
    "GSK 988: there is no #50",
    control=FAMILY_988, source="Talm 203", evidence=SECONDARY,
    program="O1\nN10 #100=1\nN20 #50=1\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="203", at="O1 N20",
)
case(
    "GSK 988: #50 cannot be read either",
    control=FAMILY_988, source="Talm 203", evidence=SECONDARY,
    program="O1\nN10 #100=1\nN20 #100=#50\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="203", at="O1 N20", vars={100: 1},
)
case(
    "GSK 980TDi: #4001 is only to be read",
    control=TDI, source="TDi28, system variables; number from MDia 120", evidence=INFERRED,
    program="O1\nN10 #100=1\nN20 #4001=1\nN30 M30\n",
    runs="N10", alarm="variable-write-protected", number="0120", at="O1 N20",
)
case(
    "GSK 980TDi: #5041 is only to be read",
    control=TDI, source="TDi28, system variables; number from MDia 120", evidence=INFERRED,
    program="O1\nN10 #100=1\nN20 #5041=1\nN30 M30\n",
    runs="N10", alarm="variable-write-protected", number="0120", at="O1 N20",
)
