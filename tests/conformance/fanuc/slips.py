"""FANUC: slips of the pen in real programs."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "an IF with an assignment but no THEN alarms",
    control=ALL, source="ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1EQ1] #122=5
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20", vars={122: None},
)
case(
    "DO1 without WHILE is an endless loop that a jump leaves",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        DO1
        N20 #1=#1+1
        N30 IF[#1GE2]GOTO50
        N40 END1
        N50 M30
    """,
    runs="N20 N30 N40 N20 N30 N50",
)
case(
    "two equals signs are no expression",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100==5
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "two variables without an operator are no expression",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=#101#102
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "two operators side by side are no expression",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=5*/2
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "a nested bracket that is not closed alarms",
    control=ALL, source="ALM PS1132; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #101=1
        N20 #100=[#101+[#101*2]
        N30 M30
    """,
    runs="N10", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N20",
)
case(
    "an X without its number in a long block is found before its T goes out",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 T5 G0 X Y2.
        N20 M30
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10", word="X",
    t=[],
)
case(
    "two points in one number are found before the block acts",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 T5 G0 X1..5
        N20 M30
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10", t=[],
)
case(
    "a jump target with a typing slip alarms when it is reached",
    control=ALL, source="ALM PS0128; K-H 128", evidence="secondary",
    program="""
        O1
        N10 #1=#1+1
        N20 IF[#1LT3]GOTO10
        N30 GOTO500
        N50 M30
    """,
    runs="(N10 N20)*3", alarm="jump-target-not-found", number=numbers("128", "PS0128"), at="O1 N30",
)
case(
    "a percent sign in mid-program ends the program there",
    control=ALL, source="GED; ALM PS5010", evidence="secondary",
    program="""
        %
        O1
        N10 T1
        %
        N20 T2
        N30 M30
    """,
    main="O1", runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[1],
)
case(
    "a slash before a faulty word does not hide it while the switch is off",
    control=ALL, source="ALM PS0006; GED", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T2 /M-3
        N30 M30
    """,
    runs="N10", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N20", t=[1],
)
