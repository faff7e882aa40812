"""FANUC: modal macro calls, G66, G66.1, G67."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "G66 calls its macro after every block that moves an axis",
    control=ALL, source="ENG; M7V, NCT", evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 Y1.
        N40 G67
        N50 M30
        O2
        N60 M99
    """,
    runs="N10 N20 N60 N30 N60 N40 N50", calls="G66:O2 G66:O2",
)
case(
    "the G66 block calls nothing, even with axis words",
    control=ALL, source="ENG; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P2 X5. Y5.
        N20 T1
        N30 G67
        N40 #100=#5001
        N50 M30
        O2
        N60 M99
    """,
    runs="N10 N20 N30 N40 N50", calls="", vars={100: 0},
)
case(
    "a modal macro gets the arguments of its G66 block",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2 A3. I1. I2.
        N20 G0 X9.
        N30 G67
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N50 N30 N40", arguments={1: 3, 4: 1, 7: 2, 24: None},
)
case(
    "a T block calls no modal macro",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 T1
        N30 G67
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N30 N40",
)
case(
    "an assignment calls no modal macro",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 #24=5
        N30 G67
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N30 N40",
)
case(
    "a dwell calls no modal macro",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G4 X1.
        N30 G67
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N30 N40",
)
case(
    "after G67 a move calls no modal macro",
    control=ALL, source="ENG; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N20 G67
        N30 G0 X1.
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N30 N40",
)
case(
    "L of G66 repeats every modal call",
    control=ALL, source="ENG; CW-A; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P2 L2
        N20 G0 X1.
        N30 X2.
        N40 G67
        N50 M30
        O2
        N60 M99
    """,
    runs="N10 N20 N60*2 N30 N60*2 N40 N50", calls="G66:O2 G66:O2",
)
case(
    "the locals of a modal macro are not loaded again for the next move",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2 A1.
        N20 G0 X1.
        N30 X2.
        N40 G67
        N50 M30
        O2
        N60 #1=#1*3
        N70 #100=#1
        N80 M99
    """,
    runs="N10 N20 N60 N70 N80 N30 N60 N70 N80 N40 N50", vars={100: 9},
)
case(
    "a modal macro does not touch the caller's locals",
    control=ALL, source="PB304; K-H general knowledge", evidence="maker's manual",
    program="""
        O1
        N10 #1=4
        N20 G66 P2 A1.
        N30 G0 X1.
        N40 G67
        N50 M30
        O2
        N60 #1=8
        N70 M99
    """,
    runs="N10 N20 N30 N60 N70 N40 N50", vars={1: 4},
)
case(
    "a new G66 after G67 sets the arguments anew",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2 A1.
        N20 G67
        N30 G66 P2 B2.
        N40 G0 X1.
        N50 G67
        N60 M30
        O2
        N70 #100=#1
        N80 #101=#2
        N90 M99
    """,
    runs="N10 N20 N30 N40 N70 N80 N90 N50 N60", vars={100: None, 101: 2},
)
case(
    "moves inside a modal macro do not call it again",
    control=ALL, source="K-H general knowledge; NCT", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 G67
        N40 M30
        O2
        N50 Z1.
        N60 Z2.
        N70 M99
    """,
    runs="N10 N20 N50 N60 N70 N30 N40", calls="G66:O2",
)
case(
    "of two modal calls a move calls the later one",
    pins="calls_in_modal",
    control=ALL, source="NCT p.171, M7V; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G0 X1.
        N40 G67
        N50 G67
        N60 M30
        O2
        N70 M99
        O3
        N80 M99
    """,
    runs="N10 N20 N30 N80 N40 N50 N60", calls="G66:O3",
)
case(
    "three stacked modal calls call each other by the moves of their macros",
    control=ALL, source="NCT p.171, M7V; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G66 P4
        N40 G0 X1.
        N50 M30
        O2
        N60 Z3.
        N65 M99
        O3
        N70 Z2.
        N75 M99
        O4
        N80 Z1.
        N85 M99
    """,
    runs="N10 N20 N30 N40 N80 N70 N60 N65 N75 N85 N50", calls="G66:O4 G66:O3 G66:O2",
)
case(
    "G67 takes off the later of two modal calls",
    control=ALL, source="NCT; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G67
        N40 G0 X1.
        N50 G67
        N60 M30
        O2
        N70 M99
        O3
        N80 M99
    """,
    runs="N10 N20 N30 N40 N70 N50 N60", calls="G66:O2",
)
case(
    "two G67 take off two modal calls",
    control=ALL, source="NCT; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G67
        N40 G67
        N50 G0 X1.
        N60 M30
        O2
        N70 M99
        O3
        N80 M99
    """,
    runs="N10 N20 N30 N40 N50 N60",
)
case(
    "a third G67 has nothing to take off",
    control=NEW, source="ALM PS1100", evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N20 G66 P2
        N30 G67
        N40 G67
        N50 G67
        N60 M30
        O2
        N70 M99
    """,
    runs="N10 N20 N30 N40", alarm="modal-call-missing", number="PS1100", at="O1 N50",
)
case(
    "G67 without a modal call alarms",
    control=NEW, source="ALM PS1100", evidence="secondary",
    program="""
        O1
        N10 G67
        N20 M30
    """,
    runs="", alarm="modal-call-missing", number="PS1100", at="O1 N10",
)
case(
    "with 6000#0=1 G67 without a modal call is ignored",
    control=NEW, source="ALM PS1100; K-M parameter", evidence="inferred",
    program="""
        O1
        N10 G67
        N20 M30
    """,
    params={"6000#0": 1}, runs="N10 N20",
)
case(
    "the 16i ignores G67 without a modal call",
    control="fanuc-16i", source="K-L general knowledge", evidence="inferred",
    program="""
        O1
        N10 G67
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "G65 works inside a modal macro",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 G67
        N40 M30
        O2
        N50 G65 P3 A6.
        N60 M99
        O3
        N70 #100=#1
        N80 M99
    """,
    runs="N10 N20 N50 N70 N80 N60 N30 N40", vars={100: 6},
)
case(
    "a move in a subprogram calls the modal macro of the main program",
    control=ALL, source="policy; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 M98 P3
        N30 G67
        N40 M30
        O2
        N50 M99
        O3
        N60 G0 X1.
        N70 M99
    """,
    runs="N10 N20 N60 N50 N70 N30 N40", calls="M98:O3 G66:O2",
)
case(
    "a move in a G65 macro calls the modal macro of the main program",
    control=ALL, source="policy; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G65 P3
        N30 G67
        N40 M30
        O2
        N50 M99
        O3
        N60 G0 X1.
        N70 M99
    """,
    runs="N10 N20 N60 N50 N70 N30 N40", calls="G65:O3 G66:O2",
)
case(
    "G67 in a subprogram takes off the modal call of the main program",
    control=ALL, source="policy; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 M98 P3
        N30 G0 X1.
        N40 M30
        O2
        N50 M99
        O3
        N60 G67
        N70 M99
    """,
    runs="N10 N20 N60 N70 N30 N40",
)
case(
    "M30 in a modal macro ends the run",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 G67
        N40 M30
        O2
        N50 M30
        N60 M99
    """,
    runs="N10 N20 N50",
)
case(
    "G66 without P names no program",
    control=ALL, source="K-H 076; ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 G66 A1.
        N20 G0 X1.
        N30 M30
    """,
    runs="", alarm="program-number-missing", number=numbers("076", "PS0076"), at="O1 N10",
)
case(
    "a missing modal macro alarms",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 G66 P7
        N20 G0 X1.
        N30 G67
        N40 M30
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"),
)
case(
    "G as an argument of G66 is refused",
    control=ALL, source="ALM PS0129; K-H 129", evidence="secondary",
    program="""
        O1
        N10 G66 P2 G1 A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-argument", number=numbers("129", "PS0129"), at="O1 N10",
)
case(
    "an argument before G66 is refused",
    control=ALL, source="policy; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 A1. G66 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="macro-call-not-first", number=numbers("129", "PS0129"), at="O1 N10",
)
case(
    "an eleventh set in G66 is refused",
    control=NEW, source="ALM PS1095", evidence="secondary",
    program="""
        O1
        N10 G66 P2 J1. J2. J3. J4. J5. J6. J7. J8. J9. J10. J11.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="too-many-argument-sets", number="PS1095", at="O1 N10",
)
case(
    "six stacked modal calls are too many",
    control=ALL, source="ALM PS0122; K-H 122", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P2
        N30 G66 P2
        N40 G66 P2
        N50 G66 P2
        N60 G66 P2
        N70 G91 G0 X1.
        N80 M30
        O2
        Z1.
        M99
    """,
    alarm="modal-calls-too-many", number=numbers("122", "PS0122"),
)

# The text of 122 decides what counts: the modal call that is specified a fourth time is the fault.
case(
    "3 modal calls stack, and the G66 after them is refused",
    control="fanuc-16i", source="K-H 122: specified four-fold", evidence="inferred",
    program="O1\nN10 G66 P2\nN20 G66 P2\nN30 G66 P2\nN40 G66 P2\nN90 M30\nO2\nM99\n",
    runs="N10 N20 N30", alarm="modal-calls-too-many", number="122", at="O1 N40",
)
case(
    "5 modal calls stack, and the G66 after them is refused",
    control=NEW, source="ALM PS0122", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P2
        N30 G66 P2
        N40 G66 P2
        N50 G66 P2
        N60 G66 P2
        N90 M30
        O2
        M99
    """,
    runs="N10 N20 N30 N40 N50", alarm="modal-calls-too-many", number="PS0122", at="O1 N60",
)
case(
    "the 16i has no G66.1",
    pins="unlisted_codes",
    control="fanuc-16i", source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 G67
        N30 M30
        O2
        N40 M99
    """,
    runs="", alarm="g-code-not-available", number="010", at="O1 N10",
)
case(
    "under G66.1 the words of a block are arguments and move nothing",
    control=NEW, source="ALM PS0129 (every-block call); K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 X5.
        N30 G67
        N40 #101=#5001
        N50 M30
        O2
        #100=#24
        M99
    """,
    runs="N10 N20 N30 N40 N50", vars={100: 5, 101: 0},
)
case(
    "under G66.1 an M code is an argument and is not sent",
    control=NEW, source="ALM PS0129 (every-block call); K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 M8
        N30 G67
        N40 M30
        O2
        #100=#13
        M99
    """,
    runs="N10 N20 N30 N40", vars={100: 8}, m=[],
)
case(
    "under G66.1 a G code is the argument #10",
    control=NEW, source="ALM PS0129; K-M variable numbers", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 G1 X5.
        N30 G67
        N40 M30
        O2
        #100=#10
        M99
    """,
    runs="N10 N20 N30 N40", vars={100: 1},
)
case(
    "under G66.1 L is #12 and P is #16",
    control=NEW, source="K-M variable numbers", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 X5. L3 P4
        N30 G67
        N40 M30
        O2
        #100=#12
        #101=#16
        M99
    """,
    runs="N10 N20 N30 N40", vars={100: 3, 101: 4},
)
case(
    "under G66.1 a block without a move calls",
    control=NEW, source="ALM PS0129 (every-block call); K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 S500
        N30 G67
        N40 M30
        O2
        #100=#19
        M99
    """,
    runs="N10 N20 N30 N40", vars={100: 500},
)
case(
    "after G67 the words of a block act again",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 G67
        N30 T8
        N40 M30
        O2
        M99
    """,
    runs="N10 N20 N30 N40", t=[8],
)
case(
    "a minus sign at the P of G66 is illegal",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P-2 A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "a point at the P of G66 is illegal",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P2. A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
)
case(
    "an argument of G66 without a value has no data",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P2 A
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10",
)
case(
    "a division by zero in an argument of G66 alarms at the G66",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P2 A[1/0]
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "an argument of G66 from a variable that does not exist alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G66 P2 A#40
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
)
case(
    "an axis word before G66 is refused",
    control=ALL, source="policy; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 X1. G66 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="macro-call-not-first", number=numbers("129", "PS0129"), at="O1 N10",
)
case(
    "G66.1 without P names no program",
    control=NEW, source="ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 G66.1 A1.
        N20 M30
    """,
    runs="", alarm="program-number-missing", number="PS0076", at="O1 N10",
)
case(
    "a modal macro without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 G67
        N40 M30
        O2
        N50 T5
    """,
    runs="N10 N20 N50", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2", t=[5],
)
case(
    "M99 P of a modal macro to a missing block alarms",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 G67
        N40 M30
        O2
        N50 M99 P77
    """,
    alarm="return-target-not-found", number=numbers("078", "PS0078"), at="O2 N50", calls="G66:O2",
)
case(
    "a missing subprogram of a modal macro alarms in the modal macro",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 G67
        N40 M30
        O2
        N50 M98 P3
        N60 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O2 N50", calls="G66:O2",
)
case(
    "a user alarm in a modal macro stops the whole run",
    pins="user_alarm_numbers",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X1.
        N30 G67
        N40 M30
        O2
        #3000=4(BROKEN)
        N60 M99
    """,
    runs="N10 N20", alarm="user-alarm", number=numbers("3004", "MC3004"), at="O2",
)

case(
    "G66 calls after each move, and not in its own block (F301)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="ENG; M7V; NCT; CW-A",
    evidence="secondary",
    program="""
        O1
        G90 G0
        N10 G66 P2 A5.
        N20 X1.
        N30 X2. Y1.
        N40 G67
        N50 X3.
        N60 M30
        O2
        N100 #100=#100+#1
        N110 M99
    """,
    runs="N10 N20 N100 N110 N30 N100 N110 N40 N50 N60",
    vars={100: 10},
    moves="""
        R X1
        R X2 Y1
        R X3
    """,
)

case(
    "G66 does not call after a block that moves no axis (F302)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G66 P2
        M8
        #101=1
        G4 P100
        X1.
        G67
        M30
        O2
        #100=#100+1
        M99
    """,
    vars={100: 1},
    m=[8],
)

case(
    "the locals of a G66 macro keep their values from call to call (F303)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G66 P2 A10.
        X1.
        X2.
        X3.
        G67
        M30
        O2
        #100=#1
        #1=#1+1
        M99
    """,
    vars={100: 12},
)

case(
    "G66 with L3 calls three times after a move (F305)",
    control=["fanuc-16i", "fanuc-30i"],
    source="M7V; NCT; CW-A",
    evidence="secondary",
    program="""
        O1
        G66 P2 L3
        X1.
        G67
        M30
        O2
        #100=#100+1
        M99
    """,
    vars={100: 3},
)

case(
    "a move inside the last G66's macro calls the macro of the G66 before (F307)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT p.171; M7V note 2",
    evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N11 G1 G91 Z10. F100
        N12 G66 P3
        N13 Z20.
        N14 G67
        N15 G67
        N16 Z-5.
        N17 M30
        O2
        N20 X4.
        N21 M99
        O3
        N30 Z2.
        N31 Z3.
        N32 M99
    """,
    runs="N10 N11 N20 N21 N12 N13 N30 N20 N21 N31 N20 N21 N32 N14 N15 N16 N17",
)

case(
    "the first G67 cancels the last G66 only (F308)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT p.171",
    evidence="secondary",
    program="""
        O1
        G66 P2
        G66 P3
        G67
        N10 X1.
        G67
        N20 X2.
        M30
        O2
        #100=#100+1
        M99
        O3
        #101=#101+1
        M99
    """,
    vars={100: 1, 101: None},
)

case(
    "G67 without a modal call alarms (F309)",
    control="fanuc-30i",
    source="ALM PS1100",
    evidence="maker's manual",
    program="""
        O1
        G67
        M30
    """,
    alarm="modal-call-missing",
    number="PS1100",
    at="O1",
)

case(
    "a G66 drilling macro reads the position and gives the modal codes back (F311)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT; M7V; REG; ZAP",
    evidence="secondary",
    program="""
        O1
        G90 G0 X0 Y0 Z50.
        G66 P9110 Z-20. R5. F500
        G90 X20. Y20.
        X50.
        G67
        M30
        O9110
        #1=#4001
        #3=#4003
        #5=#5003
        G00 G90 Z#18
        G01 Z#26 F#9
        G00 Z#5
        G#1 G#3
        M99
    """,
    moves="""
        R X0 Y0 Z50
        R X20 Y20
        R Z5
        F Z-20
        R Z50
        R X50
        R Z5
        F Z-20
        R Z50
    """,
)
