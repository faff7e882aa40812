"""FANUC: macro calls (G65, G66, G66.1, calls by code) and the macro language."""

from datetime import datetime

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]
OLD = ["fanuc-16i", "fanuc-0i-d"]
NOT_D = ["fanuc-16i", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """The number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


# G65: the call

case(
    "G65 calls a macro and goes on behind the call",
    control=ALL, source="source 002, simple call", evidence="source document",
    program="""
        O1
        N10 G65 P2
        N20 T1
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N40 N20 N30", calls="G65:O2",
)
case(
    "L repeats a macro call",
    control=ALL, source="source 002, l: repeat count; X-65, INT", evidence="source document",
    program="""
        O1
        N10 G65 P2 L3
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*3 N20", calls="G65:O2",
)
case(
    "P and L may stand behind the arguments of G65",
    control=ALL, source="PB304 (its example has P last)", evidence="maker's manual",
    program="""
        O1
        N10 G65 A4. L2 P2
        N20 M30
        O2
        N30 #100=#100+#1
        N40 M99
    """,
    runs="N10 (N30 N40)*2 N20", vars={100: 8},
)
case(
    "G65 does not split a count off P",
    control=LATE, source="source 002; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P12345
        N20 M30
        O2345
        N30 M99
        O12345
        N40 M99
    """,
    runs="N10 N40 N20", calls="G65:O12345",
)
case(
    "the P of G65 may be a variable",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=2
        N20 G65 P#100 A1.
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30", calls="G65:O2",
)
case(
    "the L of G65 may be a variable",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=2
        N20 G65 P2 L#100
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40*2 N30",
)
case(
    "a macro is called by its name",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 <POCKET> A2.
        N20 M30
        <POCKET>
        N30 #100=#1
        N40 M99
    """,
    runs="N10 N30 N40 N20", vars={100: 2},
)
case(
    "a named macro that is not in memory is a file not found",
    control=LATE, source="ALM PS0310", evidence="secondary",
    program="""
        O1
        N10 G65 <POCKET> A2.
        N20 M30
    """,
    alarm="named-program-not-found", number="PS0310", at="O1 N10",
)
case(
    "words of a G65 block are arguments: its T is not sent to the machine",
    control=ALL, source="PMI39", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 T5.
        N20 M30
        O2
        N30 #100=#20
        N40 M99
    """,
    runs="N10 N30 N40 N20", vars={100: 5}, t=[],
)
case(
    "words of a G65 block are arguments: its X moves nothing",
    control=ALL, source="PMI39", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 X5.
        N20 M30
        O2
        N30 #100=#5001
        N35 #101=#24
        N40 M99
    """,
    runs="N10 N30 N35 N40 N20", vars={100: 0, 101: 5},
)
case(
    "words of a G65 block are arguments: its M is not sent to the machine",
    control=ALL, source="PMI39; ZAP", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 M3
        N20 M30
        O2
        N30 #100=#13
        N40 M99
    """,
    runs="N10 N30 N40 N20", vars={100: 3}, m=[],
)
case(
    "a calling M code behind G65 is an argument, not a call",
    control=ALL, source="PMI39; ZAP", evidence="inferred",
    program="""
        O1
        N10 G65 P2 M50
        N20 M30
        O2
        N30 #100=#13
        N40 M99
        O9020
        N50 M99
    """,
    params={"6080": 50}, runs="N10 N30 N40 N20", calls="G65:O2", vars={100: 50},
)
case(
    "G65 without P names no program",
    pins="h_codes",
    control=ALL, source="K-H 076; ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 G65 L2 B3.
        N30 M30
    """,
    runs="N10", alarm="program-number-missing", number=numbers("076", "PS0076"), at="O1 N20",
)
case(
    "a missing macro alarms at the G65",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 G65 P77 A1.
        N30 M30
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N20", t=[1],
)
case(
    "a missing macro of a macro alarms in the macro",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G65 P3
        N40 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O2 N30", calls="G65:O2",
)
case(
    "a minus sign at the P of G65 is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 G65 P-2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "a point at the P of G65 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 G65 P2. A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="P2.",
)
case(
    "a point at the L of G65 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 G65 P2 L2. A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="L2.",
)
case(
    "an argument without a value has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A B1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10", word="A",
)
case(
    "two points in an argument are illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A1.2.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
)
case(
    "G as an argument is refused",
    control=ALL, source="ALM PS0129; K-H 129", evidence="secondary",
    program="""
        O1
        N10 G65 P2 G1 A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-argument", number=numbers("129", "PS0129"), at="O1 N10", word="G1",
)
case(
    "a word before G65 is refused",
    pins="words_before_macro_call",
    control=ALL, source="policy; X-65, PMI39; ALM PS0129", evidence="inferred",
    program="""
        O1
        N10 X5. G65 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="macro-call-not-first", number=numbers("129", "PS0129"), at="O1 N10",
)
case(
    "a G code before G65 is refused",
    control=ALL, source="policy; X-65, PMI39; ALM PS0129", evidence="inferred",
    program="""
        O1
        N10 G90 G65 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="macro-call-not-first", number=numbers("129", "PS0129"), at="O1 N10",
)
case(
    "N and block skip may stand before G65",
    control=ALL, source="policy; K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 G65 P2 A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "two G65 in one block are two macro calls",
    control=NEW, source="ALM PS1092", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A1. G65 P3
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
    """,
    runs="", alarm="macro-call-given-twice", number="PS1092", at="O1 N10",
)
case(
    "a faulty argument is found before the macro runs",
    control=ALL, source="ALM PS0112; policy: nothing changes before a block has been checked",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P2 A[1/0]
        N30 M30
        O2
        N40 T2
        N50 M99
    """,
    runs="N10", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N20", t=[1],
)

# G65: argument specification I

case(
    "the arguments of source 002 reach the local variables it names",
    control=ALL, source="source 002, argument specification I", evidence="source document",
    program="""
        O1
        N10 G65 P2 A30. B45. I50. R-58. X100. Y-200. Z-80.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 30, 2: 45, 4: 50, 18: -58, 24: 100, 25: -200, 26: -80},
)
case(
    "argument C is #3",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 C7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={3: 7.5, 2: None},
)
case(
    "argument D is #7",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 D7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={7: 7.5, 6: None},
)
case(
    "argument H is #11",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 H7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={11: 7.5, 10: None},
)
case(
    "argument J is #5",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 J7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={5: 7.5, 4: None},
)
case(
    "argument K is #6",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 K7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={6: 7.5, 5: None},
)
case(
    "argument Q is #17",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 Q7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={17: 7.5, 16: None},
)
case(
    "argument S is #19",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 S7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={19: 7.5, 18: None},
)
case(
    "argument U is #21",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 U7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={21: 7.5, 20: None},
)
case(
    "argument V is #22",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 V7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={22: 7.5, 21: None},
)
case(
    "argument W is #23",
    control=ALL, source="source 002, table 5.2-3; ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 W7.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={23: 7.5, 22: None},
)
case(
    "the order of the letters does not matter, but for I J K",
    control=ALL, source="source 002, argument specification I", evidence="source document",
    program="""
        O1
        N10 G65 P2 Z3. Y2. X1. A9.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 9, 24: 1, 25: 2, 26: 3},
)
case(
    "no letter reaches #10, #12, #14 to #16",
    control=ALL, source="ZAP, INT", evidence="secondary",
    program="""
        O1
        N10 G65 P2 F1. H2. M3. Q4.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
    arguments={9: 1, 10: None, 11: 2, 12: None, 13: 3, 14: None, 15: None, 16: None, 17: 4},
)
case(
    "an argument may be negative at an address that otherwise takes no sign",
    control=ALL, source="X-65", evidence="secondary",
    program="""
        O1
        N10 G65 P2 M-3. S-5. T-2.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={13: -3, 19: -5, 20: -2},
)
case(
    "an argument may have a point at an address that otherwise takes none",
    control=ALL, source="X-65", evidence="secondary",
    program="""
        O1
        N10 G65 P2 D1.5 H2.25 M3.125 T4.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={7: 1.5, 11: 2.25, 13: 3.125, 20: 4.5},
)
case(
    "of two equal letters the later counts",
    control=ALL, source="source 002, repeated assignment", evidence="source document",
    program="""
        O1
        N10 G65 P2 A1. B5. A2.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 2, 2: 5},
)
case(
    "an argument keeps all its digits",
    control=ALL, source="PB304; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A1.23456
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 1.23456},
)
case(
    "an argument may be an expression",
    control=ALL, source="X-65; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A[2*3+1] B-[4/8]
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 7, 2: -0.5},
)
case(
    "an argument may be a negated variable",
    control=ALL, source="X-65; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5=8
        N20 G65 P2 A-#5
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30", arguments={1: -8},
)
case(
    "an argument may be a function",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A[SQRT[16]]
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 4},
)
case(
    "an argument may be an indirect variable",
    control=ALL, source="JIX; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5=100
        N20 #100=6
        N30 G65 P2 C#[#5]
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N30 N50 N40", arguments={3: 6},
)
case(
    "a vacant argument leaves its variable vacant",
    control=ALL, source="X-65; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A#0 B#5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: None, 2: None},
)
case(
    "a variable as an argument is not scaled by the least input increment",
    control=ALL, source="PB304; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5=10
        N20 G65 P2 X#5
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30", arguments={24: 10},
)
case(
    "an expression as an argument is not scaled by the least input increment",
    control=ALL, source="PB304; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 X[10]
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={24: 10},
)

# G65: argument specification II and mixtures

case(
    "the mixture of source 002 leaves the later word in #7",
    pins="argument_sets",
    control=ALL, source="source 002, mixed assignment", evidence="source document",
    program="""
        O1
        N10 G65 P2 A30. B45. I-3. I4. D5.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 30, 2: 45, 4: -3, 5: None, 6: None, 7: 5},
)
case(
    "a second I is #7",
    control=ALL, source="source 002, argument specification II; ZAP", evidence="source document",
    program="""
        O1
        N10 G65 P2 I1. I2.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 7: 2},
)
case(
    "the second set is #7, #8 and #9",
    control=ALL, source="source 002, argument specification II; ZAP", evidence="source document",
    program="""
        O1
        N10 G65 P2 I1. J2. K3. I4. J5. K6.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 5: 2, 6: 3, 7: 4, 8: 5, 9: 6},
)
case(
    "the third set is #10, #11 and #12",
    control=ALL, source="source 002, argument specification II; ZAP", evidence="source document",
    program="""
        O1
        N10 G65 P2 I1. I2. I3. J4. K5.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 7: 2, 10: 3, 11: 4, 12: 5},
)
case(
    "the tenth set is #31, #32 and #33",
    control=ALL, source="source 002, argument specification II; ZAP", evidence="source document",
    program="""
        O1
        N10 G65 P2 I1. I2. I3. I4. I5. I6. I7. I8. I9. I10. J11. K12.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={28: 9, 31: 10, 32: 11, 33: 12},
)
case(
    "a repeated J opens a new set",
    control=ALL, source="source 002; ZAP; K-H counting rule", evidence="secondary",
    program="""
        O1
        N10 G65 P2 J1. J2. J3.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: None, 5: 1, 8: 2, 11: 3},
)
case(
    "a repeated K opens a new set",
    control=ALL, source="source 002; ZAP; K-H counting rule", evidence="secondary",
    program="""
        O1
        N10 G65 P2 K1. K2.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={6: 1, 9: 2},
)
case(
    "I behind K opens a new set",
    control=ALL, source="K-H counting rule", evidence="inferred",
    program="""
        O1
        N10 G65 P2 K1. I2.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={6: 1, 4: None, 7: 2},
)
case(
    "K J I are three sets",
    control=ALL, source="K-H counting rule, parameter 6008", evidence="inferred",
    program="""
        O1
        N10 G65 P2 K1. J2. I3.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={6: 1, 8: 2, 10: 3, 4: None, 5: None},
)
case(
    "I and K without J stay in one set",
    control=ALL, source="K-H counting rule", evidence="inferred",
    program="""
        O1
        N10 G65 P2 I1. K2.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 5: None, 6: 2, 7: None},
)
case(
    "other letters between I J K do not open a set",
    control=ALL, source="K-H counting rule", evidence="inferred",
    program="""
        O1
        N10 G65 P2 I1. X9. J2. A8. K3.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 8, 4: 1, 5: 2, 6: 3, 24: 9, 7: None},
)
case(
    "an I behind E overwrites nothing of it, a J does",
    control=ALL, source="source 002, mixed assignment; ZAP", evidence="source document",
    program="""
        O1
        N10 G65 P2 E5. I1. I2. J3.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 7: 2, 8: 3},
)
case(
    "E behind the second J overwrites it",
    control=ALL, source="source 002, mixed assignment; ZAP", evidence="source document",
    program="""
        O1
        N10 G65 P2 I1. I2. J3. E5.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 7: 2, 8: 5},
)
case(
    "F behind the second K overwrites it",
    control=ALL, source="source 002, mixed assignment; ZAP", evidence="source document",
    program="""
        O1
        N10 G65 P2 I1. J2. K3. I4. J5. K6. F7.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={9: 7, 8: 5, 7: 4},
)
case(
    "with 6008#7=1 a repeated I overwrites the first",
    control=ALL, source="source 002, PRM 6008.7; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 I1. I2.
        N20 M30
        O2
        N30 M99
    """,
    params={"6008#7": 1}, runs="N10 N30 N20", arguments={4: 2, 7: None},
)
case(
    "with 6008#7=1 K J I are one set",
    control=ALL, source="source 002, PRM 6008.7; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 K3. J2. I1.
        N20 M30
        O2
        N30 M99
    """,
    params={"6008#7": 1}, runs="N10 N30 N20", arguments={4: 1, 5: 2, 6: 3, 7: None, 8: None},
)
case(
    "with 6008#7=1 D is not touched by a second I",
    control=ALL, source="source 002, PRM 6008.7; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 D5. I-3. I4.
        N20 M30
        O2
        N30 M99
    """,
    params={"6008#7": 1}, runs="N10 N30 N20", arguments={4: 4, 7: 5},
)
case(
    "an eleventh set is refused",
    control=NEW, source="ALM PS1095", evidence="secondary",
    program="""
        O1
        N10 G65 P2 K1. K2. K3. K4. K5. K6. K7. K8. K9. K10. K11.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="too-many-argument-sets", number="PS1095", at="O1 N10", word="K11.",
)
case(
    "ten sets are not too many",
    control=NEW, source="ALM PS1095", evidence="secondary",
    program="""
        O1
        N10 G65 P2 K1. K2. K3. K4. K5. K6. K7. K8. K9. K10.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={6: 1, 33: 10},
)

# G65: arguments without a point

case(
    "without a point X Y Z count in thousandths of a millimetre",
    pins="whole_numbers",
    control=ALL, source="PB304; K-M table", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 X10 Y-2500 Z1
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={24: 0.01, 25: -2.5, 26: 0.001},
)
case(
    "without a point I J K count in thousandths of a millimetre",
    control=ALL, source="PB304; K-M table", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 I10 J2000 K1
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 0.01, 5: 2, 6: 0.001},
)
case(
    "without a point Q R U V W count in thousandths of a millimetre",
    control=ALL, source="PB304; K-M table", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 Q100 R2000 U1 V2 W3000
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={17: 0.1, 18: 2, 21: 0.001, 22: 0.002, 23: 3},
)
case(
    "without a point A B C count in thousandths of a degree",
    control=ALL, source="PB304; K-M table", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 A90000 B500 C1
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={1: 90, 2: 0.5, 3: 0.001},
)
case(
    "without a point D E H M S T are whole numbers",
    control=ALL, source="PB304; K-M table", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 D1 E2 H3 M4 S500 T6
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={7: 1, 8: 2, 11: 3, 13: 4, 19: 500, 20: 6},
)
case(
    "without a point F is millimetres per minute in G94",
    control=ALL, source="PB304; K-L table", evidence="inferred",
    program="""
        O1
        N10 G65 P2 F200
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={9: 200},
)
case(
    "without a point F counts in hundredths of a millimetre in G95",
    control=ALL, source="PB304; K-L table", evidence="inferred",
    program="""
        O1
        N10 G95
        N20 G65 P2 F25
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30", arguments={9: 0.25},
)
case(
    "without a point X counts in ten-thousandths of an inch in G20",
    control=ALL, source="PB304; K-M table", evidence="inferred",
    program="""
        O1
        N10 G20
        N20 G65 P2 X10000 I5
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30", arguments={24: 1, 4: 0.0005},
)
case(
    "without a point A counts in thousandths of a degree in G20 as well",
    control=ALL, source="PB304; K-M table", evidence="inferred",
    program="""
        O1
        N10 G20
        N20 G65 P2 A90000
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30", arguments={1: 90},
)
case(
    "a point and no point may stand in one block",
    control=ALL, source="PB304; K-M table", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 X1 Y1. Z1.0
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={24: 0.001, 25: 1, 26: 1},
)
case(
    "with 3401#0=1 X without a point is millimetres",
    control=ALL, source="K-H parameter; GED", evidence="inferred",
    program="""
        O1
        N10 G65 P2 X10 I2 Q3
        N20 M30
        O2
        N30 M99
    """,
    params={"3401#0": 1}, runs="N10 N30 N20", arguments={24: 10, 4: 2, 17: 3},
)
case(
    "with 3401#0=1 A without a point is degrees",
    control=ALL, source="K-H parameter; GED", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A90 C-5
        N20 M30
        O2
        N30 M99
    """,
    params={"3401#0": 1}, runs="N10 N30 N20", arguments={1: 90, 3: -5},
)
case(
    "with 3401#0=1 D and T without a point are whole numbers as before",
    control=ALL, source="K-H parameter; GED", evidence="inferred",
    program="""
        O1
        N10 G65 P2 D5 T6
        N20 M30
        O2
        N30 M99
    """,
    params={"3401#0": 1}, runs="N10 N30 N20", arguments={7: 5, 20: 6},
)

# G65: local variables, repeats, nesting

case(
    "a macro starts with vacant locals even if the caller has set them",
    control=ALL, source="PB304, VAC", evidence="maker's manual",
    program="""
        O1
        N10 #3=5
        N20 G65 P2 A1.
        N30 M30
        O2
        N40 #100=#3
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={3: 5, 100: None},
)
case(
    "a macro cannot change the locals of its caller",
    control=ALL, source="PB304, NCT", evidence="maker's manual",
    program="""
        O1
        N10 #1=5
        N20 G65 P2 A1.
        N30 M30
        O2
        N40 #1=77
        N50 #2=78
        N60 M99
    """,
    runs="N10 N20 N40 N50 N60 N30", vars={1: 5, 2: None},
)
case(
    "a macro may change common variables",
    control=ALL, source="ZAP, JIX", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A4.
        N20 M30
        O2
        N30 #500=#1*2
        N40 M99
    """,
    runs="N10 N30 N40 N20", vars={500: 8},
)
case(
    "the second pass of a repeated macro finds the locals of the first",
    control=ALL, source="HAA; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 L3 A10.
        N20 M30
        O2
        N30 #1=#1+1
        N40 #100=#1
        N50 M99
    """,
    runs="N10 (N30 N40 N50)*3 N20", vars={100: 13, 1: None},
)
case(
    "a second call of a macro starts with vacant locals again",
    control=ALL, source="PB304, VAC", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2
        N20 G65 P2
        N30 M30
        O2
        N40 #5=#5+1
        N50 #100=#5
        N60 M99
    """,
    runs="N10 N40 N50 N60 N20 N40 N50 N60 N30", vars={100: 1},
)
case(
    "M99 P out of a macro restores the caller's locals",
    control=ALL, source="source 002, source 003; PB304", evidence="source document",
    program="""
        O1
        N10 #1=5
        N20 G65 P2 A1.
        N30 T1
        N40 #100=#1
        N50 M30
        O2
        N60 M99 P40
    """,
    runs="N10 N20 N60 N40 N50", vars={100: 5}, t=[],
)
case(
    "M99 P out of a macro to a missing block alarms",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A1.
        N20 M30
        O2
        N30 M99 P35
    """,
    alarm="return-target-not-found", number=numbers("078", "PS0078"), at="O2 N30",
)
case(
    "M99 P out of a repeated macro leaves at once",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 G65 P2 L4
        N20 T1
        N30 M30
        O2
        N40 M99 P30
    """,
    runs="N10 N40 N30", t=[],
)
case(
    "a macro calls a macro with its own arguments as arguments",
    control=ALL, source="PB304; K-H general knowledge", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2 A3. B4.
        N20 M30
        O2
        N30 G65 P3 A#2 B#1
        N40 M99
        O3
        N50 #100=#1-#2
        N60 M99
    """,
    runs="N10 N30 N50 N60 N40 N20", vars={100: 1},
)
case(
    "macro levels deeper than four do not exist on the 16i",
    pins="max_macro_nesting",
    control="fanuc-16i", source="PB304; K-L number", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G65 P3
        N40 M99
        O3
        N50 G65 P2
        N60 M99
    """,
    alarm="macro-nesting-too-deep", number="077", at="O3 N50",
)
case(
    "macro levels deeper than five do not exist",
    pins="max_macro_nesting",
    control=NEW, source="ALM PS0122; K-H depth", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G65 P3
        N40 M99
        O3
        N50 G65 P2
        N60 M99
    """,
    alarm="macro-nesting-too-deep", number="PS0122", at="O2 N30",
)
case(
    "five macro levels are legal",
    control=NEW, source="K-H depth", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A1.
        N20 M30
        O2
        N30 IF[#1 EQ 5]GOTO50
        N40 G65 P2 A[#1+1]
        N50 M99
    """,
    runs="N10 (N30 N40)*4 N30 N50*5 N20",
)
case(
    "a macro call by an M code counts as a macro level on the 16i",
    control="fanuc-16i", source="PB304; K-L number", evidence="inferred",
    program="""
        O1
        N10 M50
        N20 M30
        O9020
        N30 G65 P2
        N40 M99
        O2
        N50 #100=#100+1
        N60 G65 P2
        N70 M99
    """,
    params={"6080": 50}, alarm="macro-nesting-too-deep", number="077", at="O2 N60", vars={100: 3},
)
case(
    "a macro call by an M code counts as a macro level",
    control=NEW, source="ALM PS0122; PB304", evidence="inferred",
    program="""
        O1
        N10 M50
        N20 M30
        O9020
        N30 G65 P2
        N40 M99
        O2
        N50 #100=#100+1
        N60 G65 P2
        N70 M99
    """,
    params={"6080": 50}, alarm="macro-nesting-too-deep", number="PS0122", at="O2 N60",
    vars={100: 4},
)
case(
    "M98 between macros is no macro level",
    control=NEW, source="PB304; ALM PS0122", evidence="maker's manual",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 M98 P3
        N50 M99
        O3
        N60 G65 P2
        N70 M99
    """,
    alarm="macro-nesting-too-deep", number="PS0122", at="O3 N60", vars={100: 5},
)
case(
    "the loop of a caller goes on behind a macro call",
    control=ALL, source="policy; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 G65 P2 A9.
        N30 #1=#1+1
        N40 END1
        N50 M30
        O2
        N60 DO1
        N70 M99
        N80 END1
    """,
    runs="(N10 N20 N60 N70 N30 N40)*2 N10 N50", vars={1: 2},
)

# G66, G66.1, G67

case(
    "G66 calls its macro behind every block that moves an axis",
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
    "behind G67 a move calls no modal macro",
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
    "a new G66 behind G67 sets the arguments anew",
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
# The text of 122 says what counts: the modal call that is specified a fourth time is the fault.
for controls, count, number in [("fanuc-16i", 3, "122"), (NEW, 5, "PS0122")]:
    blocks = "".join(f"N{10 * i} G66 P2\n" for i in range(1, count + 2))
    case(
        f"{count} modal calls stack, and the G66 behind them is refused",
        control=controls, source="K-H 122: specified four-fold" if count == 3 else "ALM PS0122",
        evidence="inferred",
        program=f"O1\n{blocks}N90 M30\nO2\nM99\n",
        runs=" ".join(f"N{10 * i}" for i in range(1, count + 1)), alarm="modal-calls-too-many",
        number=number, at=f"O1 N{10 * count + 10}",
    )
case(
    "the 16i has no G66.1",
    pins="g_codes_complete",
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
    "behind G67 the words of a block act again",
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

# Calls by G, M, T, S, B and ASCII codes

case(
    "PRM6050=70 makes G70 call O9010",
    control=ALL, source="source 002, specific calls", evidence="source document",
    program="""
        O1
        N10 G70 A1. B2.
        N20 M30
        O9010
        N30 M99
    """,
    params={"6050": 70}, runs="N10 N30 N20", calls="G-code:O9010", arguments={1: 1, 2: 2},
)
case(
    "PRM6051=71 makes G71 call O9011",
    control=ALL, source="source 002, specific calls", evidence="source document",
    program="""
        O1
        N10 G71 A1.
        N20 M30
        O9010
        N30 M99
        O9011
        N40 M99
    """,
    params={"6050": 70, "6051": 71}, runs="N10 N40 N20", calls="G-code:O9011",
)
case(
    "PRM6080=50 makes M50 call O9020 with arguments",
    control=ALL, source="source 002, specific calls", evidence="source document",
    program="""
        O1
        N10 M50 A1. X5.
        N20 M30
        O9020
        N30 M99
    """,
    params={"6080": 50}, runs="N10 N30 N20", calls="M-code:O9020", arguments={1: 1, 24: 5}, m=[],
)
case(
    "PRM6071=60 makes M60 call O9001",
    control=ALL, source="source 002, specific calls", evidence="source document",
    program="""
        O1
        N10 M60
        N20 M30
        O9001
        N30 M99
    """,
    params={"6071": 60}, runs="N10 N30 N20", calls="M-code:O9001", m=[],
)
case(
    "PRM6001.5=1 makes every T code call O9000",
    control=ALL, source="source 002, specific calls", evidence="source document",
    program="""
        O1
        N10 T1
        N20 T2
        N30 M30
        O9000
        N40 M99
    """,
    params={"6001#5": 1}, runs="N10 N40 N20 N40 N30", calls="T-code:O9000 T-code:O9000", t=[],
)
case(
    "without parameter 6050 G199 is no call, and no G code either",
    pins="g_codes_complete",
    control=ALL, source="source 002; ALM PS0010", evidence="inferred",
    program="""
        O1
        N10 G199 A1.
        N20 M30
        O9010
        N30 M99
    """,
    runs="", alarm="g-code-not-available", number=numbers("010", "PS0010"), at="O1 N10",
)
case(
    "without parameter 6080 M50 goes to the machine",
    control=ALL, source="source 002; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M50
        N20 M30
        O9020
        N30 M99
    """,
    runs="N10 N20", m=[50],
)
case(
    "without parameter 6001#5 T codes go to the machine",
    control=ALL, source="source 002; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T12
        N20 M30
        O9000
        N30 M99
    """,
    runs="N10 N20", t=[12],
)
case(
    "the last G parameter calls O9019",
    control=ALL, source="source 002; K-H range 6050-6059", evidence="inferred",
    program="""
        O1
        N10 G170
        N20 M30
        O9019
        N30 M99
    """,
    params={"6059": 170}, runs="N10 N30 N20", calls="G-code:O9019",
)
case(
    "the last M parameter for macros calls O9029",
    control=ALL, source="source 002; K-H range 6080-6089", evidence="inferred",
    program="""
        O1
        N10 M59 C3.
        N20 M30
        O9029
        N30 M99
    """,
    params={"6089": 59}, runs="N10 N30 N20", calls="M-code:O9029", arguments={3: 3},
)
case(
    "the last M parameter for subprograms calls O9009",
    control=ALL, source="source 002; K-H range 6071-6079", evidence="inferred",
    program="""
        O1
        N10 M69
        N20 M30
        O9009
        N30 M99
    """,
    params={"6079": 69}, runs="N10 N30 N20", calls="M-code:O9009",
)
case(
    "L repeats a macro called by a G code",
    control=ALL, source="source 002, l: repeat count", evidence="source document",
    program="""
        O1
        N10 G70 L3 A1.
        N20 M30
        O9010
        N30 M99
    """,
    params={"6050": 70}, runs="N10 N30*3 N20", calls="G-code:O9010",
)
case(
    "L repeats a macro called by an M code",
    control=ALL, source="source 002, l: repeat count", evidence="source document",
    program="""
        O1
        N10 M50 L2
        N20 M30
        O9020
        N30 M99
    """,
    params={"6080": 50}, runs="N10 N30*2 N20",
)
case(
    "the words of a calling G code's block are arguments: its X moves nothing",
    control=ALL, source="PMI39; K-H general knowledge", evidence="maker's manual",
    program="""
        O1
        N10 G70 X5.
        N20 M30
        O9010
        N30 #100=#5001
        N40 #101=#24
        N50 M99
    """,
    params={"6050": 70}, runs="N10 N30 N40 N50 N20", vars={100: 0, 101: 5},
)
case(
    "a calling G code takes sets of I J K",
    control=ALL, source="source 002; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G70 I1. I2.
        N20 M30
        O9010
        N30 M99
    """,
    params={"6050": 70}, runs="N10 N30 N20", arguments={4: 1, 7: 2},
)
case(
    "a macro called by a G code has locals of its own",
    control=ALL, source="PB304; source 002", evidence="maker's manual",
    program="""
        O1
        N10 #1=6
        N20 G70 A1.
        N30 M30
        O9010
        N40 #1=9
        N50 M99
    """,
    params={"6050": 70}, runs="N10 N20 N40 N50 N30", vars={1: 6},
)
case(
    "a subprogram called by an M code shares the locals",
    control=ALL, source="PB304; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=6
        N20 M60
        N30 M30
        O9001
        N40 #1=#1+1
        N50 M99
    """,
    params={"6071": 60}, runs="N10 N20 N40 N50 N30", vars={1: 7},
)
case(
    "other words of the block run before a subprogram called by an M code",
    control=ALL, source="PMI39", evidence="maker's manual",
    program="""
        O1
        N10 M60 T5
        N20 M30
        O9001
        N30 T6
        N40 M99
    """,
    params={"6071": 60}, runs="N10 N30 N40 N20", t=[5, 6],
)
case(
    "the T code is in #149 when O9000 runs",
    control=ALL, source="PMI39; source 002", evidence="maker's manual",
    program="""
        O1
        N10 T0113
        N20 M30
        O9000
        N30 #100=#149
        N40 M99
    """,
    params={"6001#5": 1}, runs="N10 N30 N40 N20", vars={100: 113}, t=[],
)
case(
    "an axis move in the block of a calling T code comes first",
    control=ALL, source="PMI39", evidence="maker's manual",
    program="""
        O1
        N10 T5 G0 X3.
        N20 M30
        O9000
        N30 #100=#5001
        N40 M99
    """,
    params={"6001#5": 1}, runs="N10 N30 N40 N20", vars={100: 3},
)
case(
    "T inside O9000 is the real T code",
    pins="code_cascade",
    control=ALL, source="PMI39; K-H general knowledge", evidence="maker's manual",
    program="""
        O1
        N10 T5
        N20 M30
        O9000
        N30 T7
        N40 M99
    """,
    params={"6001#5": 1}, runs="N10 N30 N40 N20", t=[7],
)
case(
    "with 6007#2=1 a B code calls O9028 and is in #146",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 B30
        N20 M30
        O9028
        N30 #100=#146
        N40 M99
    """,
    params={"6007#2": 1}, runs="N10 N30 N40 N20", calls="B-code:O9028", vars={100: 30},
)
case(
    "with 6007#1=1 an S code calls O9029 and is in #147",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 S300
        N20 M30
        O9029
        N30 #100=#147
        N40 M99
    """,
    params={"6007#1": 1}, runs="N10 N30 N40 N20", calls="S-code:O9029", vars={100: 300},
)
case(
    "parameter 6090=72 makes H call O9004 with its value in #146",
    control=ALL, source="PMI39; K-M general knowledge", evidence="maker's manual",
    program="""
        O1
        N10 H12
        N20 M30
        O9004
        N30 #100=#146
        N40 M99
    """,
    params={"6090": 72}, runs="N10 N30 N40 N20", calls="ASCII:O9004", vars={100: 12},
)
case(
    "parameter 6091=68 makes D call O9005 with its value in #147",
    control=ALL, source="PMI39; K-M general knowledge", evidence="maker's manual",
    program="""
        O1
        N10 D7
        N20 M30
        O9005
        N30 #100=#147
        N40 M99
    """,
    params={"6091": 68}, runs="N10 N30 N40 N20", calls="ASCII:O9005", vars={100: 7},
)
case(
    "parameters 6038 to 6040 make a range of G codes call a range of programs",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G202 A1.
        N20 M30
        O3002
        N30 M99
    """,
    params={"6038": 200, "6039": 3000, "6040": 3}, runs="N10 N30 N20", calls="G-code:O3002",
    arguments={1: 1},
)
case(
    "a G code behind the range of 6038 to 6040 calls nothing",
    control=NEW, source="K-M general knowledge; ALM PS0010", evidence="inferred",
    program="""
        O1
        N10 G203 A1.
        N20 M30
        O3003
        N30 M99
    """,
    params={"6038": 200, "6039": 3000, "6040": 3}, runs="", alarm="g-code-not-available",
    number="PS0010", at="O1 N10",
)
case(
    "parameters 6044 to 6046 make a range of M codes call subprograms",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=5
        N20 M201
        N30 M30
        O4001
        N40 #100=#1
        N50 M99
    """,
    params={"6044": 200, "6045": 4000, "6046": 2}, runs="N10 N20 N40 N50 N30", calls="M-code:O4001",
    vars={100: 5},
)
case(
    "an M code behind the range of 6044 to 6046 goes to the machine",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M202
        N20 M30
        O4002
        N30 M99
    """,
    params={"6044": 200, "6045": 4000, "6046": 2}, runs="N10 N20", m=[202],
)
case(
    "parameters 6047 to 6049 make a range of M codes call macros",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M301 A8.
        N20 M30
        O5001
        N30 M99
    """,
    params={"6047": 300, "6048": 5000, "6049": 2}, runs="N10 N30 N20", calls="M-code:O5001",
    arguments={1: 8},
)
case(
    "a negative G parameter makes a modal call",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G70 A3.
        N20 G0 X1.
        N30 G67
        N40 X2.
        N50 M30
        O9010
        N60 #100=#100+#1
        N70 M99
    """,
    params={"6050": -70}, runs="N10 N20 N60 N70 N30 N40 N50", vars={100: 3},
)
case(
    "M98 inside a program called by a G code works",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G70
        N20 M30
        O9010
        N30 M98 P3
        N40 M99
        O3
        N50 M99
    """,
    params={"6050": 70}, runs="N10 N30 N50 N40 N20", calls="G-code:O9010 M98:O3",
)
case(
    "a calling T code inside a program called by an M code is an ordinary T code",
    control=ALL, source="K-H general knowledge; RW table 20-K", evidence="inferred",
    program="""
        O1
        N10 M60
        N20 M30
        O9001
        N30 T4
        N40 M99
        O9000
        N50 M99
    """,
    params={"6071": 60, "6001#5": 1}, runs="N10 N30 N40 N20", t=[4],
)
case(
    "a calling M code inside O9000 is an ordinary M code",
    control=ALL, source="K-H general knowledge; RW table 20-K", evidence="inferred",
    program="""
        O1
        N10 T4
        N20 M30
        O9000
        N30 M60
        N40 M99
        O9001
        N50 M99
    """,
    params={"6071": 60, "6001#5": 1}, runs="N10 N30 N40 N20", m=[60], t=[],
)
case(
    "a macro-calling M code inside a program called by a G code is an ordinary M code",
    control=ALL, source="K-H general knowledge; RW table 20-K", evidence="inferred",
    program="""
        O1
        N10 G70
        N20 M30
        O9010
        N30 M50
        N40 M99
        O9020
        N50 M99
    """,
    params={"6050": 70, "6080": 50}, runs="N10 N30 N40 N20", m=[50],
)
case(
    "a calling T code inside a macro called by an M code is an ordinary T code",
    control=ALL, source="K-H general knowledge; RW table 20-K", evidence="inferred",
    program="""
        O1
        N10 M50
        N20 M30
        O9020
        N30 T4
        N40 M99
        O9000
        N50 M99
    """,
    params={"6080": 50, "6001#5": 1}, runs="N10 N30 N40 N20", t=[4],
)
case(
    "a calling G code inside a program called by an M code is an ordinary G code",
    control=ALL, source="K-H general knowledge; RW table 20-K; ALM PS0010", evidence="inferred",
    program="""
        O1
        N10 M60
        N20 M30
        O9001
        N30 G199
        N40 M99
        O9010
        N50 M99
    """,
    params={"6071": 60, "6050": 199}, runs="N10", alarm="g-code-not-available",
    number=numbers("010", "PS0010"), at="O9001 N30",
)
case(
    "calling codes work inside a program called by M98",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M60
        N40 M99
        O9001
        N50 M99
    """,
    params={"6071": 60}, runs="N10 N30 N50 N40 N20", calls="M98:O2 M-code:O9001",
)
case(
    "calling codes work inside a macro called by G65",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G70 A1.
        N40 M99
        O9010
        N50 M99
    """,
    params={"6050": 70}, runs="N10 N30 N50 N40 N20", calls="G65:O2 G-code:O9010",
)
case(
    "with 6008#6=1 a calling M code works inside a program called by a G code",
    control=NEW, source="K-M general knowledge; RW table 20-J", evidence="inferred",
    program="""
        O1
        N10 G70
        N20 M30
        O9010
        N30 M60
        N40 M99
        O9001
        N50 M99
    """,
    params={"6050": 70, "6071": 60, "6008#6": 1}, runs="N10 N30 N50 N40 N20",
    calls="G-code:O9010 M-code:O9001", m=[],
)
case(
    "with 6008#6=1 a calling G code works inside a program called by an M code",
    control=NEW, source="K-M general knowledge; RW table 20-J", evidence="inferred",
    program="""
        O1
        N10 M60
        N20 M30
        O9001
        N30 G70
        N40 M99
        O9010
        N50 M99
    """,
    params={"6050": 70, "6071": 60, "6008#6": 1}, runs="N10 N30 N50 N40 N20",
    calls="M-code:O9001 G-code:O9010",
)
case(
    "with 6008#6=1 a code still does not call from a program called by its own kind",
    control=NEW, source="K-M general knowledge; RW table 20-J", evidence="inferred",
    program="""
        O1
        N10 M60
        N20 M30
        O9001
        N30 M61
        N40 M99
        O9002
        N50 M99
    """,
    params={"6071": 60, "6072": 61, "6008#6": 1}, runs="N10 N30 N40 N20", m=[61],
)
case(
    "a missing O9010 alarms at the calling G code",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 G70 A1.
        N20 M30
    """,
    params={"6050": 70}, alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10",
)
case(
    "a missing O9000 alarms at the T code",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 M30
    """,
    params={"6001#5": 1}, alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10",
    t=[],
)
case(
    "a missing O9020 alarms at the calling M code",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M50 A1.
        N20 M30
    """,
    params={"6080": 50}, alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10",
    m=[],
)
case(
    "G as an argument of a calling M code is refused",
    control=ALL, source="ALM PS0129; K-H 129", evidence="inferred",
    program="""
        O1
        N10 M50 G1 A1.
        N20 M30
        O9020
        N30 M99
    """,
    params={"6080": 50}, runs="", alarm="illegal-argument", number=numbers("129", "PS0129"),
    at="O1 N10",
)
case(
    "M99 P of a program called by an M code returns to a block of the caller",
    control=ALL, source="source 002, macro return; source 003", evidence="source document",
    program="""
        O1
        N10 M60
        N20 T1
        N30 M30
        O9001
        N40 M99 P30
    """,
    params={"6071": 60}, runs="N10 N40 N30", t=[],
)

# Macro statements and NC words

case(
    "an axis word and an assignment in one block alarm",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 X5. #1=3
        N20 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N10",
    vars={1: None},
)
case(
    "a G code and an assignment in one block alarm",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 G0 #1=3
        N30 M30
    """,
    runs="N10", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N20",
)
case(
    "an M code before GOTO alarms",
    pins="bare_g",
    control=[*ALL, "haas-ngc"], source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 M3 GOTO30
        N20 M4
        N30 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number={**numbers("127", "PS0127"), "haas-ngc": None}, at="O1 N10", m=[],
)
case(
    "an axis word before IF alarms",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 X1. IF[1 EQ 1]GOTO30
        N20 M4
        N30 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N10",
)
case(
    "an axis word before WHILE alarms",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 X1. WHILE[#1 LT 1]DO1
        N20 #1=1
        N30 END1
        N40 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N10",
)
case(
    "N and block skip may stand before an assignment",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 #100=1
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)

# Variables

case(
    "a variable that was never set is vacant",
    control=ALL, source="JIX, VAC", evidence="secondary",
    program="""
        O1
        N10 #100=5
        N20 M30
    """,
    runs="N10 N20", vars={100: 5, 101: None, 1: None, 500: None},
)
case(
    "an assignment does not scale its value by the least input increment",
    control=ALL, source="JIX, XIA", evidence="secondary",
    program="""
        O1
        N10 #100=123
        N20 M30
    """,
    runs="N10 N20", vars={100: 123},
)
case(
    "#100=#0 makes a variable vacant",
    control=ALL, source="JIX, X-NUL", evidence="secondary",
    program="""
        O1
        N10 #100=#0
        N20 M30
    """,
    variables={100: 5}, runs="N10 N20", vars={100: None},
)
case(
    "#33, #149, #500 and #531 exist",
    control=ALL, source="JIX, GED, XIA", evidence="secondary",
    program="""
        O1
        N10 #33=1
        N20 #149=2
        N30 #500=3
        N40 #531=4
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", vars={33: 1, 149: 2, 500: 3, 531: 4},
)
case(
    "#99 does not exist",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #99=1
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "a variable that does not exist cannot be read",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 #100=#50
        N20 M30
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
    vars={100: None},
)
case(
    "a negative variable number does not exist",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 #[2-5]=1
        N20 M30
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
)
case(
    "a variable that does not exist cannot stand at an address",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 T#60
        N20 M30
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10", t=[],
)
case(
    "#0 cannot be assigned by way of an expression",
    control=ALL, source="JIX; K-M 116", evidence="secondary",
    program="""
        O1
        N10 #[1-1]=5
        N20 M30
    """,
    runs="", alarm="vacant-assigned", number=numbers("116", "PS0116"), at="O1 N10",
)
case(
    "#0 cannot be assigned",
    control=ALL, source="JIX; K-M 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #0=#1
        N30 M30
    """,
    runs="N10", alarm="vacant-assigned", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "a variable number may be an expression in brackets",
    control=ALL, source="JIX, NCT", evidence="secondary",
    program="""
        O1
        N10 #1=100
        N20 #2=13
        N30 #[#1+#2-12]=7
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={101: 7},
)
case(
    "variable numbers may be nested",
    control=ALL, source="JIX, NCT", evidence="secondary",
    program="""
        O1
        N10 #1=2
        N20 #2=3
        N30 #3=9
        N40 #100=#[#[#1]]
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", vars={100: 9},
)
case(
    "a variable number is rounded",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #[100.6]=4
        N20 M30
    """,
    runs="N10 N20", vars={101: 4, 100: None},
)
case(
    "a variable at M is rounded, half up",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #1=7.5
        N20 M#1
        N30 M30
    """,
    runs="N10 N20 N30", m=[8],
)
case(
    "an expression at M is rounded",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 M[3.4]
        N20 M30
    """,
    runs="N10 N20", m=[3],
)
case(
    "an expression at T is rounded, half up",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 T[10/4]
        N20 M30
    """,
    runs="N10 N20", t=[3],
)
case(
    "a literal at M with a point is illegal although a variable is not",
    control=ALL, source="SIN; ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M3.0
        N20 M30
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="M3.0", m=[],
)
case(
    "a literal at T with a point is illegal",
    control=ALL, source="SIN; ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 T3.
        N20 M30
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10", t=[],
)
case(
    "the sign at an address stands before #",
    control=ALL, source="JIX, 52S", evidence="secondary",
    program="""
        O1
        N10 #1=-8
        N20 M-#1
        N30 M30
    """,
    runs="N10 N20 N30", m=[8],
)
case(
    "a vacant variable at M makes the word vanish",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 M#5
        N20 M30
    """,
    runs="N10 N20", m=[],
)
case(
    "a vacant variable at T makes only its own word vanish",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 M8 T#5
        N20 M30
    """,
    runs="N10 N20", m=[8], t=[],
)
case(
    "a zero at T is sent, a vacant is not",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 #1=0
        N20 T#1
        N30 T#2
        N40 M30
    """,
    runs="N10 N20 N30 N40", t=[0],
)
case(
    "in an expression at an address a vacant variable counts zero",
    control=ALL, source="M7V; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T[#5+4]
        N20 M30
    """,
    runs="N10 N20", t=[4],
)
case(
    "a vacant variable at X leaves the axis where it is",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 G0 X4.
        N20 X#5 Y2.
        N30 #100=#5001
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 4},
)
case(
    "adding to a vacant variable counts it as zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=#5+3
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "multiplying a vacant variable gives zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=#5*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "the sum of two vacant variables is zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=#5+#6
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "zero minus a vacant variable is zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=0-#5
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "a function of a vacant variable counts it as zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=COS[#5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "copying a vacant variable copies the vacancy",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=7
        N20 #100=#5
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: None},
)
case(
    "dividing by a vacant variable divides by zero",
    control=ALL, source="X-NUL; ALM PS0112", evidence="secondary",
    program="""
        O1
        N10 #100=4/#5
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "a result beyond the range of numbers alarms",
    pins="max_constant_digits",
    control=ALL, source="JIX; ALM PS0111", evidence="secondary",
    program="""
        O1
        N10 #1=10000000
        N20 #1=#1*#1
        N30 GOTO20
    """,
    alarm="overflow", number=numbers("111", "PS0111"), at="O1 N20",
)
case(
    "1E49 is beyond the range of numbers on the 16i",
    control="fanuc-16i", source="JIX", evidence="secondary",
    program="""
        O1
        N10 #1=10000000
        N20 #2=#1*#1*#1*#1*#1*#1*#1
        N30 M30
    """,
    runs="N10", alarm="overflow", number="111", at="O1 N20",
)
case(
    "nine digits in a constant are too many on the 16i",
    control="fanuc-16i", source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=123456789
        N20 M30
    """,
    runs="", alarm="too-many-digits", number="003", at="O1 N10",
)
case(
    "nine digits in a constant are not too many",
    control="fanuc-30i", source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=123456789
        N20 M30
    """,
    runs="N10 N20", vars={100: 123456789},
)
case(
    "thirteen digits in a constant are too many",
    control="fanuc-30i", source="ALM PS0003; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=1234567890123
        N20 M30
    """,
    runs="", alarm="too-many-digits", number="PS0003", at="O1 N10",
)
case(
    "a user name for a variable is set by SETVN",
    control="fanuc-30i", source="ALM PS1139, PS1141; K-M syntax", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[TOOLNO,WORKNO]
        N20 [#WORKNO]=5
        N30 M30
    """,
    runs="N10 N20 N30", vars={510: None, 511: 5},
)
case(
    "a name that nobody has registered alarms",
    control="fanuc-30i", source="ALM PS1098; K-M syntax", evidence="secondary",
    program="""
        O1
        N10 #100=[#NOSUCH]
        N20 M30
    """,
    runs="", alarm="variable-name-unknown", number="PS1098", at="O1 N10",
)
case(
    "a name with an asterisk is refused by SETVN",
    control="fanuc-30i", source="ALM PS1141; K-M syntax", evidence="secondary",
    program="""
        O1
        N10 SETVN 510[TOOL*]
        N20 M30
    """,
    runs="", alarm="illegal-variable-name", number="PS1141", at="O1 N10",
)
for text, fault in [
    ("[TOOLNO]", "without a variable"), ("510.5[TOOLNO]", "of a variable that is not whole"),
    ("510[TOOLNO", "with an open list"), ("510 TOOLNO", "without brackets"),
]:
    case(
        f"SETVN {fault} is refused: SETVN {text}",
        control="fanuc-30i", source="ALM PS1139; K-M syntax", evidence="secondary",
        program=f"O1\nN10 T1\nN20 SETVN {text}\nN30 M30\n",
        runs="N10", alarm="setvn-format", number="PS1139", at="O1 N20", t=[1],
    )

# Vacant and zero in comparisons (9.2.8)

case(
    "#1 EQ #0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 EQ #0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 EQ #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 NE 0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 NE 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 NE 0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 NE 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 GE #0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 GE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 GE #0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 GE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "#1 GT 0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 GT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 GT 0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 GT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 LE #0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 LE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 LE #0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 LE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "#1 LT 0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 LT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 LT 0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 LT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 NE #0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 NE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 NE #0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 NE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "#1 EQ 0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 EQ 0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 EQ 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "two vacant variables are equal",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ #2]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "a vacant variable in WHILE counts as zero for LT",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N40",
)

# Expressions: priority, brackets, format

case(
    "multiplication comes before addition",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=2+3*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 14},
)
case(
    "division comes before subtraction",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=10-6/2
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "equal priorities go from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=20/2*5
        N20 M30
    """,
    runs="N10 N20", vars={100: 50},
)
case(
    "subtraction goes from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=10-4-3
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "AND comes before addition",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=5+6 AND 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "AND has the priority of multiplication and goes from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=10 AND 4*3
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "OR has the priority of addition",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=1 OR 2*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 9},
)
case(
    "XOR has the priority of addition and goes from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=9-4 XOR 2
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "OR comes after AND",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=8 OR 6 AND 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 10},
)
case(
    "a function comes before multiplication",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=2*SQRT[9]
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "brackets come first",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=[2+3]*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 20},
)
case(
    "a minus sign stands before a bracket",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=-[2+3]
        N20 M30
    """,
    runs="N10 N20", vars={100: -5},
)
case(
    "a minus sign stands before a variable",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N5 #4=7
        N10 #100=-#4+1
        N20 M30
    """,
    runs="N5 N10 N20", vars={100: -6},
)
case(
    "a number may begin with its point",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=.5+1
        N20 M30
    """,
    runs="N10 N20", vars={100: 1.5},
)
case(
    "a number may end with its point",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=5.*2.
        N20 M30
    """,
    runs="N10 N20", vars={100: 10},
)
case(
    "a slash in an expression divides",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=9/2
        N20 M30
    """,
    runs="N10 N20", vars={100: 4.5},
)
case(
    "a slash in an expression divides while block skip is on",
    control=ALL, source="GED; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=9/2
        N20 M30
    """,
    skip=(1,), runs="N10 N20", vars={100: 4.5},
)
case(
    "five brackets deep is legal, the function's own counted",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 #100=ABS[[[[[0-4]]]]]
        N20 M30
    """,
    runs="N10 N20", vars={100: 4},
)
case(
    "six brackets deep is too deep",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 #100=[[[[[[1]]]]]]
        N20 M30
    """,
    runs="", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N10",
)
case(
    "six brackets deep at an address is too deep",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 T[[[[[[1]]]]]]
        N20 M30
    """,
    runs="", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N10", t=[],
)
case(
    "brackets one behind the other are not nested",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 #100=[1]+[1]+[1]+[1]+[1]+[1]+[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "a closing bracket too few alarms",
    control=ALL, source="ALM PS1132; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=[1+2
        N20 M30
    """,
    runs="", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N10",
)
case(
    "a closing bracket too many alarms",
    control=ALL, source="ALM PS1131; K-H 114", evidence="secondary",
    program="""
        O1
        N10 #100=1+2]
        N20 M30
    """,
    runs="", alarm="bracket-not-opened", number=numbers("114", "PS1131"), at="O1 N10",
)
case(
    "a function without its closing bracket alarms",
    control=ALL, source="ALM PS1132; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[4
        N20 M30
    """,
    runs="", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N10",
)
case(
    "a variable alone in a block lacks its equals sign",
    control=NEW, source="ALM PS1133", evidence="secondary",
    program="""
        O1
        N10 #100
        N20 M30
    """,
    runs="", alarm="missing-equals", number="PS1133", at="O1 N10",
)
case(
    "an expression alone in a block lacks its equals sign",
    control=NEW, source="ALM PS1133", evidence="secondary",
    program="""
        O1
        N10 #100+5
        N20 M30
    """,
    runs="", alarm="missing-equals", number="PS1133", at="O1 N10",
)
case(
    "POW with one argument lacks its comma",
    control=LATE, source="ALM PS1134", evidence="secondary",
    program="""
        O1
        N10 #100=POW[2]
        N20 M30
    """,
    runs="", alarm="missing-comma", number="PS1134", at="O1 N10",
)
case(
    "an expression that ends in an operator alarms",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=5+
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "an expression that begins with a multiplication alarms",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=*5
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "an assignment without a value alarms",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "empty brackets alarm",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[]
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "two values without an operator alarm",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=[5][6]
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "the result of a comparison is no number",
    control=ALL, source="MEX; ALM PS1125", evidence="secondary",
    program="""
        O1
        N10 #100=[3 GT 2]
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "a statement whose condition is false has to be right all the same",
    control=ALL, source="policy: a control reads a block when it reaches it", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 2]THEN #100=5+
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)

# Functions

case(
    "SIN takes degrees",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=SIN[30]
        N20 M30
    """,
    runs="N10 N20", vars={100: 0.5},
)
case(
    "COS takes degrees",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=COS[60]
        N20 M30
    """,
    runs="N10 N20", vars={100: 0.5},
)
case(
    "TAN takes degrees",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=TAN[45]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "ASIN of a negative value lies between 270 and 360",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 270},
)
case(
    "ASIN of a positive value lies between 0 and 90",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[0.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 30},
)
case(
    "with 6004#0=1 ASIN of a negative value is negative",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[-0.5]
        N20 M30
    """,
    params={"6004#0": 1}, runs="N10 N20", vars={100: -30},
)
case(
    "ACOS lies between 0 and 180",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ACOS[-0.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 120},
)
case(
    "ATAN takes two operands and knows the second quadrant",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[1]/[-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 135},
)
case(
    "ATAN in the third quadrant is above 180",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[-1]/[-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 225},
)
case(
    "ATAN in the fourth quadrant is above 270",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[-1]/[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 315},
)
case(
    "with 6004#0=1 ATAN in the fourth quadrant is negative",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[-1]/[1]
        N20 M30
    """,
    params={"6004#0": 1}, runs="N10 N20", vars={100: -45},
)
case(
    "the second slash behind ATAN divides",
    control=ALL, source="ALI; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=ATAN[1]/[1]/9
        N20 M30
    """,
    runs="N10 N20", vars={100: 5},
)
case(
    "ATAN takes a comma on later controls",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=ATAN[1,-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 135},
)
case(
    "ATAN with one operand is the arc tangent on later controls",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=ATAN[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 45},
)
case(
    "SQRT is the square root",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[2.25]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1.5},
)
case(
    "ABS drops the sign",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ABS[3-10]
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "LN is the natural logarithm",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=LN[EXP[2]]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "EXP is the power of e",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=EXP[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2.7182818},
)
case(
    "ROUND rounds to a whole number in a macro statement",
    control=ALL, source="CSD, ALI", evidence="secondary",
    program="""
        O1
        N10 #100=ROUND[1.2345]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "ROUND rounds half up",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #100=ROUND[2.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "ROUND rounds a negative half away from zero",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 #100=ROUND[-2.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: -3},
)
case(
    "FIX drops the fraction",
    control=ALL, source="CSD", evidence="secondary",
    program="""
        O1
        N10 #100=FIX[1.9]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "FIX of a negative value goes toward zero",
    control=ALL, source="CSD; K-H sign", evidence="inferred",
    program="""
        O1
        N10 #100=FIX[-1.9]
        N20 M30
    """,
    runs="N10 N20", vars={100: -1},
)
case(
    "FUP goes to the next whole number",
    control=ALL, source="CSD", evidence="secondary",
    program="""
        O1
        N10 #100=FUP[1.1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "FUP of a negative value goes away from zero",
    control=ALL, source="CSD; K-H sign", evidence="inferred",
    program="""
        O1
        N10 #100=FUP[-1.1]
        N20 M30
    """,
    runs="N10 N20", vars={100: -2},
)
case(
    "FUP of a whole number leaves it",
    control=ALL, source="CSD", evidence="secondary",
    program="""
        O1
        N10 #100=FUP[3]
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "BIN reads a value as binary-coded decimal",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BIN[37]
        N20 M30
    """,
    runs="N10 N20", vars={100: 25},
)
case(
    "BCD writes a value as binary-coded decimal",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BCD[25]
        N20 M30
    """,
    runs="N10 N20", vars={100: 37},
)
case(
    "AND works on bits",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=12 AND 10
        N20 M30
    """,
    runs="N10 N20", vars={100: 8},
)
case(
    "OR works on bits",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=12 OR 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 15},
)
case(
    "XOR works on bits",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=12 XOR 10
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "AND rounds its operands",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=5.6 AND 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "MOD is the remainder",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=17 MOD 5
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "MOD has the priority of multiplication",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=2+17 MOD 5*3
        N20 M30
    """,
    runs="N10 N20", vars={100: 8},
)
case(
    "POW raises to a power",
    control=LATE, source="ALM PS1120; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=POW[2,10]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1024},
)
case(
    "PRM reads a parameter",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=PRM[6050]
        N20 M30
    """,
    params={"6050": 70}, runs="N10 N20", vars={100: 70},
)
case(
    "PRM reads a bit of a parameter",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=PRM[6001,5]
        N20 M30
    """,
    params={"6001#5": 1}, runs="N10 N20", vars={100: 1},
)
case(
    "the first two letters of a function suffice on the 16i",
    control="fanuc-16i", source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=RO[SQ[6.3]]
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "the square root of a negative value alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[-4]
        N20 M30
    """,
    runs="", alarm="square-root-of-negative", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "the logarithm of zero alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=LN[0]
        N20 M30
    """,
    runs="", alarm="logarithm-of-non-positive",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "the logarithm of a negative value alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=LN[-1]
        N20 M30
    """,
    runs="", alarm="logarithm-of-non-positive",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "ASIN of 1.5 alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[1.5]
        N20 M30
    """,
    runs="", alarm="arc-sine-out-of-range",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "ACOS of -2 alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=ACOS[-2]
        N20 M30
    """,
    runs="", alarm="arc-sine-out-of-range",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "TAN of 90 degrees alarms on the 16i",
    control="fanuc-16i", source="K-L general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=TAN[90]
        N20 M30
    """,
    runs="", alarm="tangent-infinite", number="112", at="O1 N10",
)
case(
    "TAN of 270 degrees alarms on the 16i",
    control="fanuc-16i", source="K-L general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=TAN[270]
        N20 M30
    """,
    runs="", alarm="tangent-infinite", number="112", at="O1 N10",
)
case(
    "EXP of 150 overflows on the 16i",
    control="fanuc-16i", source="ALI, JIX", evidence="secondary",
    program="""
        O1
        N10 #100=EXP[150]
        N20 M30
    """,
    runs="", alarm="overflow", number="111", at="O1 N10",
)
case(
    "BCD of a negative value alarms",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BCD[-1]
        N20 M30
    """,
    runs="", alarm="argument-out-of-range", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "BIN of a value that is no decimal code alarms",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BIN[10]
        N20 M30
    """,
    runs="", alarm="argument-out-of-range", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "a division by zero alarms",
    control=ALL, source="ALM PS0112; K-H 112", evidence="secondary",
    program="""
        O1
        N10 #100=3/[2-2]
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "a division by zero at an address alarms before the block acts",
    control=ALL, source="ALM PS0112; K-H 112", evidence="secondary",
    program="""
        O1
        N10 T5 M[1/0]
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10", t=[],
)
case(
    "a division by zero in a condition alarms",
    control=ALL, source="ALM PS0112; K-H 112", evidence="secondary",
    program="""
        O1
        N10 IF[1/0 GT 1]GOTO20
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "ROUND in a condition rounds to a whole number",
    control=ALL, source="CSD, ALI", evidence="secondary",
    program="""
        O1
        N10 IF[ROUND[1.6] EQ 2]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30", t=[],
)

# GOTO and IF

case(
    "GOTO jumps forward",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30", t=[],
)
case(
    "GOTO jumps backward",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=#1+1
        N20 IF[#1 EQ 3]GOTO40
        N30 GOTO10
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N20 N40",
)
case(
    "GOTO takes a variable",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=40
        N20 GOTO#1
        N30 T1
        N40 M30
    """,
    runs="N10 N20 N40", t=[],
)
case(
    "GOTO takes an expression",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=2
        N20 GOTO[#1*10+20]
        N30 T1
        N40 M30
    """,
    runs="N10 N20 N40", t=[],
)
case(
    "GOTO to a missing block alarms at the GOTO",
    control=ALL, source="ALM PS0128; K-H 128", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO77
        N30 M30
    """,
    runs="N10", alarm="jump-target-not-found", number=numbers("128", "PS0128"), at="O1 N20",
)
case(
    "GOTO does not look into other programs",
    control=ALL, source="NCT p.188; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 GOTO50
        N20 M30
        O2
        N50 M99
    """,
    runs="", alarm="jump-target-not-found", number=numbers("128", "PS0128"), at="O1 N10",
)
case(
    "IF GOTO to a missing block alarms only if the condition is true",
    control=ALL, source="ALM PS0128; policy: reading never fails", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 2]GOTO77
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "GOTO 0 is out of range",
    control=ALL, source="X-GO, ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 GOTO0
        N20 M30
    """,
    runs="", alarm="illegal-jump-number", number=numbers("128", "PS1128"), at="O1 N10",
)
case(
    "GOTO 100000 is out of range where N has five digits",
    control=OLD, source="X-GO, PB155", evidence="secondary",
    program="""
        O1
        N10 #1=100000
        N20 GOTO#1
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number", number={"fanuc-16i": "128", "fanuc-0i-d": "PS1128"},
    at="O1 N20",
)
case(
    "GOTO 99999 is in range",
    control=ALL, source="X-GO, PB155", evidence="secondary",
    program="""
        O1
        N10 GOTO99999
        N20 T1
        N99999 M30
    """,
    runs="N10 N99999", t=[],
)
case(
    "GOTO 123456789 is out of range",
    control="fanuc-30i", source="ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 #1=123456789
        N20 GOTO#1
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number", number="PS1128", at="O1 N20",
)
case(
    "GOTO takes an eight-digit number",
    control="fanuc-30i", source="ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 GOTO12345678
        N20 T1
        N12345678 M30
    """,
    runs="N10 N12345678", t=[],
)
case(
    "of two equal N behind it GOTO takes the nearer",
    control=ALL, source="policy; FIN", evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 T1
        N40 #100=1
        N50 M30
        N40 #100=2
        N60 M30
    """,
    runs="N10 N40 N50", vars={100: 1},
)
case(
    "of two equal N before it GOTO takes the first of the program",
    control=ALL, source="policy; FIN", evidence="inferred",
    program="""
        O1
        N5 #1=#1+1
        N10 #100=#100+1
        N10 #101=#101+1
        N20 IF[#1 GE 2]GOTO50
        N30 #1=2
        N40 GOTO10
        N50 M30
    """,
    runs="N5 N10*2 N20 N30 N40 N10*2 N20 N50", vars={100: 2, 101: 2},
)
case(
    "GOTO without a number is no statement",
    control=ALL, source="ALM PS0125; K-H 114", evidence="inferred",
    program="""
        O1
        N10 GOTO
        N20 M30
    """,
    runs="", alarm="statement-format", number=numbers("114", "PS0125"), at="O1 N10",
)
case(
    "an IF whose condition is true jumps",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 IF[2 GT 1]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "an IF whose condition is false goes on with the next block",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 IF[1 GT 2]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N20 N30", t=[1],
)
case(
    "EQ compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 EQ 2]THEN #100=1
        N20 IF[2 EQ 3]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "NE compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 NE 3]THEN #100=1
        N20 IF[2 NE 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "GT compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[3 GT 2]THEN #100=1
        N20 IF[2 GT 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "GE compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 GE 2]THEN #100=1
        N20 IF[2 GE 3]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "LT compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 LT 3]THEN #100=1
        N20 IF[2 LT 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "LE compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 LE 2]THEN #100=1
        N20 IF[3 LE 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "both sides of a comparison may be expressions",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=3
        N20 IF[#1*2 EQ [#1+3]]GOTO40
        N30 T1
        N40 M30
    """,
    runs="N10 N20 N40", t=[],
)
case(
    "IF THEN takes an assignment",
    control=ALL, source="X-GO, FIN", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=2*3
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "IF THEN with a false condition assigns nothing",
    control=ALL, source="X-GO, FIN", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 2]THEN #100=1
        N20 M30
    """,
    runs="N10 N20", vars={100: None},
)
case(
    "IF THEN with an NC word alarms",
    control=ALL, source="FIN; ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]THEN M8
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10", m=[],
)
case(
    "IF THEN takes one statement, not two",
    control=ALL, source="FIN; ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=1 #101=2
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10", vars={100: None},
)
case(
    "IF without GOTO or THEN alarms",
    control=ALL, source="ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10",
)
case(
    "IF without brackets alarms",
    control=ALL, source="ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF 1 EQ 1 GOTO20
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10",
)
case(
    "with 6006#0=1 AND joins two conditions",
    control=NEW, source="K-M parameter", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 1] AND [2 EQ 3]]GOTO30
        N20 T1
        N30 M30
    """,
    params={"6006#0": 1}, runs="N10 N20 N30", t=[1],
)
case(
    "with 6006#0=1 OR joins two conditions",
    control=NEW, source="K-M parameter", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 1] OR [2 EQ 3]]GOTO30
        N20 T1
        N30 M30
    """,
    params={"6006#0": 1}, runs="N10 N30", t=[],
)
case(
    "without 6006#0 AND between conditions alarms",
    control=NEW, source="K-M parameter; ALM PS1137", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 1] AND [2 EQ 2]]GOTO30
        N20 T1
        N30 M30
    """,
    runs="", alarm="if-format", number="PS1137", at="O1 N10",
)

# WHILE, DO, END

case(
    "WHILE repeats while its condition is true",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 3]DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    runs="(N10 N20 N30)*3 N10 N40", vars={1: 3},
)
case(
    "WHILE with a false condition goes on behind its END",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 WHILE[1 EQ 2]DO2
        N20 T1
        N30 END2
        N40 M30
    """,
    runs="N10 N40", t=[],
)
case(
    "DO without WHILE repeats for ever",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    max_blocks=60, stop="limit",
)
case(
    "loops may be nested three deep",
    pins="max_loop_number max_loops",
    control=[*ALL, "haas-ngc"], source="ISO; X-GO", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 #2=0
        N30 WHILE[#2 LT 2]DO2
        N40 #3=0
        N50 WHILE[#3 LT 2]DO3
        N60 #3=#3+1
        N65 #100=#100+1
        N70 END3
        N80 #2=#2+1
        N90 END2
        N100 #1=#1+1
        N110 END1
        N120 M30
    """,
    vars={100: 8},
)
case(
    "a loop number may be used again behind its END",
    control=ALL, source="ISO; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO1
        N20 #1=#1+1
        N30 END1
        N40 WHILE[#2 LT 1]DO1
        N50 #2=#2+1
        N60 END1
        N70 M30
    """,
    runs="N10 N20 N30 N10 N40 N50 N60 N40 N70",
)
case(
    "the numbers of nested loops may stand in any order",
    control=ALL, source="ISO; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO3
        N20 WHILE[#2 LT 1]DO1
        N30 #2=1
        N40 END1
        N50 #1=1
        N60 END3
        N70 M30
    """,
    runs="N10 N20 N30 N40 N20 N50 N60 N10 N70",
)
case(
    "DO 4 is no loop number",
    control=ALL, source="ISO, ALM PS0126", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 3]DO4
        N20 #1=9
        N30 END4
        N40 M30
    """,
    runs="", alarm="illegal-loop-number", number=numbers("126", "PS0126"), at="O1 N10",
)
case(
    "DO 0 is no loop number",
    control=ALL, source="ISO, ALM PS0126", evidence="secondary",
    program="""
        O1
        N10 DO0
        N20 END0
        N30 M30
    """,
    runs="", alarm="illegal-loop-number", number=numbers("126", "PS0126"), at="O1 N10",
)
case(
    "a DO without its END alarms",
    control=ALL, source="ALM PS0124", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 DO1
        N30 #1=1
        N40 M30
    """,
    alarm="missing-end", number=numbers("124", "PS0124"), t=[1],
)
case(
    "an END with another number does not end a DO",
    control=ALL, source="ALM PS0124", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 3]DO1
        N20 #1=#1+1
        N30 END2
        N40 M30
    """,
    alarm="missing-end", number=numbers("124", "PS0124"),
)
case(
    "an END of another program does not end a DO",
    control=ALL, source="ALM PS0124; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 M30
        O2
        N30 END1
        N40 M99
    """,
    alarm="missing-end", number=numbers("124", "PS0124"),
)
case(
    "an END without its DO alarms",
    control=ALL, source="ALM PS1124; K-H 124", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 END1
        N30 M30
    """,
    runs="N10", alarm="missing-do", number=numbers("124", "PS1124"), at="O1 N20",
)
case(
    "a jump into a loop alarms at its END",
    control=ALL, source="K-H general knowledge; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 WHILE[#1 LT 3]DO1
        N30 #1=#1+1
        N40 END1
        N50 M30
    """,
    runs="N10 N30", alarm="missing-do", number=numbers("124", "PS1124"), at="O1 N40",
)
case(
    "a jump out of a loop leaves it, and it can be entered again at its DO",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #2=0
        DO1
        N20 #1=#1+1
        N30 IF[#1 EQ 1]GOTO50
        N35 IF[#1 EQ 3]GOTO60
        N40 END1
        N50 GOTO10
        N60 M30
    """,
    runs="N10 N20 N30 N50 N10 N20 N30 N35 N40 N20 N30 N35 N60", vars={1: 3},
)
case(
    "a jump inside a loop stays in it",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 #1=#1+1
        N30 GOTO50
        N40 T1
        N50 END1
        N60 M30
    """,
    runs="(N10 N20 N30 N50)*2 N10 N60", t=[],
)
case(
    "M99 inside a loop leaves the loop of the subprogram",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L2
        N20 M30
        O2
        N30 DO1
        N40 M99
        N50 END1
    """,
    runs="N10 (N30 N40)*2 N20",
)
case(
    "an END in a subprogram does not end the DO of its caller",
    control=ALL, source="policy; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 END1
        N60 M99
    """,
    runs="N10 N20", alarm="missing-do", number=numbers("124", "PS1124"), at="O2 N50",
)
case(
    "WHILE without DO alarms",
    control=NEW, source="ALM PS1138", evidence="secondary",
    program="""
        O1
        N10 WHILE[1 EQ 2]
        N20 M30
    """,
    runs="", alarm="while-format", number="PS1138", at="O1 N10",
)
case(
    "WHILE without brackets alarms",
    control=NEW, source="ALM PS1138", evidence="secondary",
    program="""
        O1
        N10 WHILE #1 LT 2 DO1
        N20 END1
        N30 M30
    """,
    runs="", alarm="while-format", number="PS1138", at="O1 N10",
)
case(
    "a GOTO in a subprogram's loop does not disturb the caller's loop",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 WHILE[#100 LT 2]DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 DO1
        N60 #100=#100+1
        N70 GOTO90
        N80 END1
        N90 M99
    """,
    runs="(N10 N20 N50 N60 N70 N90 N30)*2 N10 N40", vars={100: 2},
)

# Messages and output

case(
    "#3000=1 is alarm 3001",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 T1
        #3000=1(TOOL MISSING)
        N30 M30
    """,
    runs="N10", alarm="user-alarm", number=numbers("3001", "MC3001"), at="O1",
)
case(
    "#3000=200 is alarm 3200",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 T1
        #3000=200(LAST ONE)
        N30 M30
    """,
    runs="N10", alarm="user-alarm", number=numbers("3200", "MC3200"), at="O1",
)
case(
    "#3000 takes an expression",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 T1
        #3000=10+5(NUMBER BY EXPRESSION)
        N30 M30
    """,
    runs="N10", alarm="user-alarm", number=numbers("3015", "MC3015"), at="O1",
)
case(
    "#3000 needs no text",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 T1
        #3000=7
        N30 M30
    """,
    runs="N10", alarm="user-alarm", number=numbers("3007", "MC3007"), at="O1",
)
case(
    "with 6008#1=1 the number of #3000 is shown as it is",
    control=NEW, source="K-M parameter", evidence="inferred",
    program="""
        O1
        N10 T1
        #3000=91(PROBE)
        N30 M30
    """,
    params={"6008#1": 1}, runs="N10", alarm="user-alarm", number="MC0091", at="O1",
)
case(
    "#3000 in a macro stops the whole run",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A1.
        N20 M30
        O2
        #3000=2(NO DIAMETER)
        N40 M99
    """,
    runs="N10", alarm="user-alarm", number=numbers("3002", "MC3002"), at="O2", calls="G65:O2",
)
case(
    "IF THEN may raise an alarm",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 T1
        IF[#1 EQ #0]THEN #3000=5(NO #1)
        N30 M30
    """,
    runs="N10", alarm="user-alarm", number=numbers("3005", "MC3005"), at="O1",
)
case(
    "IF THEN with a false condition raises no alarm",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 #1=0
        N20 IF[#1 EQ #0]THEN #3000=5(NO #1)
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#3006=1 shows its text and the program goes on at cycle start",
    control=ALL, source="ZAP", evidence="secondary",
    program="""
        O1
        N10 #3006=1(CHECK TOOL)
        N20 T1
        N30 M30
    """,
    runs="N10 N20 N30", t=[1], messages=["CHECK TOOL"],
)
case(
    "two #3006 show two texts in order",
    control=ALL, source="ZAP", evidence="secondary",
    program="""
        O1
        N10 #3006=1(FIRST)
        N20 #3006=1(SECOND)
        N30 M30
    """,
    runs="N10 N20 N30", messages=["FIRST", "SECOND"],
)
case(
    "a comment elsewhere is no message",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 #100=1(NOT A MESSAGE)
        N20 M30
    """,
    runs="N10 N20", vars={100: 1}, messages=[],
)
case(
    "DPRNT puts out its letters, an asterisk as a space",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 POPEN
        N20 DPRNT[HOLE*DONE]
        N30 PCLOS
        N40 M30
    """,
    runs="N10 N20 N30 N40", messages=["HOLE DONE"],
)
case(
    "with 6001#1=1 DPRNT puts out a variable without leading blanks",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=1.5
        N20 POPEN
        N30 DPRNT[X#100[53]]
        N40 PCLOS
        N50 M30
    """,
    params={"6001#1": 1}, runs="N10 N20 N30 N40 N50", messages=["X1.500"],
)
case(
    "with 6001#1=0 DPRNT fills leading places with blanks",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=128.47398
        N20 POPEN
        N30 DPRNT[X#100[53]]
        N40 PCLOS
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", messages=["X   128.474"],
)
case(
    "DPRNT puts out a minus sign behind the letter",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=-91.2
        N20 POPEN
        N30 DPRNT[Y#100[53]]
        N40 PCLOS
        N50 M30
    """,
    params={"6001#1": 1}, runs="N10 N20 N30 N40 N50", messages=["Y-91.200"],
)
case(
    "DPRNT with no decimals puts out no point",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=23
        N20 POPEN
        N30 DPRNT[T#100[20]]
        N40 PCLOS
        N50 M30
    """,
    params={"6001#1": 1}, runs="N10 N20 N30 N40 N50", messages=["T23"],
)
case(
    "DPRNT puts out several variables in one line",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 #101=2
        N30 POPEN
        N40 DPRNT[X#100[31]*Y#101[31]]
        N50 PCLOS
        N60 M30
    """,
    params={"6001#1": 1}, runs="N10 N20 N30 N40 N50 N60", messages=["X1.0 Y2.0"],
)
case(
    "a variable in DPRNT without its places is a format error",
    control=NEW, source="ALM PS1143", evidence="secondary",
    program="""
        O1
        N10 POPEN
        N20 DPRNT[X#100]
        N30 PCLOS
        N40 M30
    """,
    runs="N10", alarm="output-format", number="PS1143", at="O1 N20", messages=[],
)
case(
    "DPRNT without brackets is a format error",
    control=NEW, source="ALM PS1143", evidence="secondary",
    program="""
        O1
        N10 POPEN
        N20 DPRNT X#100[53]
        N30 PCLOS
        N40 M30
    """,
    runs="N10", alarm="output-format", number="PS1143", at="O1 N20",
)
case(
    "DPRNT whose bracket is not closed is a format error",
    control=NEW, source="ALM PS1143", evidence="secondary",
    program="""
        O1
        N10 POPEN
        N20 DPRNT[X#100[53]
        N30 PCLOS
        N40 M30
    """,
    runs="N10", alarm="output-format", number="PS1143", at="O1 N20",
)

# System variables

case(
    "#3001 starts counting from the value it is set to",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 #3001=5000
        N20 IF[#3001 GE 5000]THEN #100=1
        N30 IF[#3001 GT 100000]THEN #101=1
        N90 M30
    """,
    vars={100: 1, 101: None},
)
case(
    "#3002 can be read",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 IF[#3002 GE 0]THEN #100=1
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#3003 keeps what is written",
    control=ALL, source="ZAP; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #3003=1
        N20 #100=#3003
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#3004 keeps what is written",
    control=ALL, source="ZAP", evidence="secondary",
    program="""
        O1
        N10 #3004=7
        N20 #100=#3004
        N90 M30
    """,
    vars={100: 7},
)
case(
    "#3011 is the date and #3012 the time, as digits",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 #100=#3011
        N20 #101=#3012
        N90 M30
    """,
    inputs={"clock": datetime(2026, 3, 9, 7, 5, 4)}, vars={100: 20260309, 101: 70504},
)
case(
    "#3012 is the time as six digits",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 IF[#3012 LE 235959]THEN #100=1
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#3901 keeps what is written",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #3901=12
        N20 #100=#3901
        N90 M30
    """,
    vars={100: 12},
)
case(
    "#4001 is the G code of group 1",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G1 X1. F100
        N20 #100=#4001
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#4002 is the plane",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G18
        N20 #100=#4002
        N90 M30
    """,
    vars={100: 18},
)
case(
    "#4003 is G90 or G91",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G91
        N20 #100=#4003
        N30 G90
        N40 #101=#4003
        N90 M30
    """,
    vars={100: 91, 101: 90},
)
case(
    "#4006 is G20 or G21",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G20
        N20 #100=#4006
        N90 M30
    """,
    vars={100: 20},
)
case(
    "#4014 is the work coordinate system",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 #100=#4014
        N20 G56
        N30 #101=#4014
        N90 M30
    """,
    vars={100: 54, 101: 56},
)
case(
    "#4109 is F",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 G1 X1. F250
        N20 #100=#4109
        N90 M30
    """,
    vars={100: 250},
)
case(
    "#4113 is the last M code",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 M8
        N20 #100=#4113
        N90 M30
    """,
    vars={100: 8},
)
case(
    "#4115 is the program number",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 G90
        N20 #100=#4115
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#4119 is S",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 S1200
        N20 #100=#4119
        N90 M30
    """,
    vars={100: 1200},
)
case(
    "#4120 is the last T code",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 T6
        N20 #100=#4120
        N90 M30
    """,
    vars={100: 6}, t=[6],
)
case(
    "#4115 in a subprogram is the subprogram's number",
    control=ALL, source="REG; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P20
        N20 M30
        O20
        N30 G90
        N40 #100=#4115
        N50 M99
    """,
    vars={100: 20},
)
case(
    "#5003 is the end point of the block before in Z",
    control=ALL, source="ZAP; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G90 G0 Z-7.5
        N20 #100=#5003
        N90 M30
    """,
    vars={100: -7.5},
)
case(
    "#5221 is the X offset of G54 and can be written",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5221=12.5
        N20 #100=#5221
        N90 M30
    """,
    vars={100: 12.5},
)
case(
    "#5241 is the X offset of G55, not of G54",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5241=3
        N20 #100=#5221
        N30 #101=#5241
        N90 M30
    """,
    vars={100: 0, 101: 3},
)
case(
    "#1100 keeps what is written",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1100=1
        N20 #100=#1100
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#4001 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #4001=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#4120 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #4120=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#5041 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #5041=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#1000 cannot be written",
    control=ALL, source="A51; ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #1000=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#3007 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #3007=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#3011 cannot be written on the 16i",
    control="fanuc-16i", source="REG; K-H 116", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #3011=20200101
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number="116", at="O1 N20",
)
case(
    "#3000 cannot be read",
    control=NEW, source="ALM PS1115", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#3000
        N30 M30
    """,
    runs="N10", alarm="variable-read-protected", number="PS1115", at="O1 N20",
)
case(
    "#3006 cannot be read",
    control=NEW, source="ALM PS1115", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#3006
        N30 M30
    """,
    runs="N10", alarm="variable-read-protected", number="PS1115", at="O1 N20",
)
case(
    "#3050 does not exist",
    control=ALL, source="ALM PS0115; K-H 115", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=#3050
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)

# More that alarms: in calls

case(
    "an argument from a variable that does not exist alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A#40
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
)
case(
    "the square root of a negative value in an argument alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A[SQRT[-1]]
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="square-root-of-negative", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "an argument whose bracket is not closed alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A[1+2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N10",
)
case(
    "an argument with six brackets is too deep",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A[[[[[[1]]]]]]
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N10",
)
case(
    "a division by zero in the P of G65 alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P[2/0] A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "a variable that does not exist at the P of G65 alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P#40 A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
)
case(
    "a vacant P of G65 is no P",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P#5 A1.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="program-number-missing", number=numbers("076", "PS0076"), at="O1 N10",
)
case(
    "an argument with an unknown character alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A1. $
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-character", number=numbers("009", "PS0009"), at="O1 N10",
)
case(
    "G as the last argument is refused as well",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G65 P2 A1. B2. G28
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-argument", number=numbers("129", "PS0129"), at="O1 N10",
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
    "a named macro with an asterisk in its name is a format error",
    control=LATE, source="ALM PS0311; K-H list of characters", evidence="secondary",
    program="""
        O1
        N10 G65 <A*B> A1.
        N20 M30
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a macro called by a G code without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G70 A1.
        N20 M30
        O9010
        N30 T5
    """,
    params={"6050": 70}, runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"),
    at="O9010",
)
case(
    "a second G code behind a calling G code is refused as an argument",
    control=ALL, source="ALM PS0129; K-H 129", evidence="inferred",
    program="""
        O1
        N10 G70 G1 X1.
        N20 M30
        O9010
        N30 M99
    """,
    params={"6050": 70}, runs="", alarm="illegal-argument", number=numbers("129", "PS0129"),
    at="O1 N10",
)
case(
    "an eleventh set in the block of a calling G code is refused",
    control=NEW, source="ALM PS1095", evidence="secondary",
    program="""
        O1
        N10 G70 I1. I2. I3. I4. I5. I6. I7. I8. I9. I10. I11.
        N20 M30
        O9010
        N30 M99
    """,
    params={"6050": 70}, runs="", alarm="too-many-argument-sets", number="PS1095", at="O1 N10",
)
case(
    "a missing O9001 alarms at the calling M code, its other words having run",
    control=ALL, source="ALM PS0076, PMI39; K-H 078", evidence="secondary",
    program="""
        O1
        N10 T5 M60
        N20 M30
    """,
    params={"6071": 60}, runs="N10", alarm="program-not-found", number=numbers("078", "PS0076"),
    at="O1 N10", m=[], t=[5],
)
case(
    "a missing O9028 alarms at the B code",
    control=NEW, source="ALM PS0076 (second auxiliary function)", evidence="secondary",
    program="""
        O1
        N10 B30
        N20 M30
    """,
    params={"6007#2": 1}, alarm="program-not-found", number="PS0076", at="O1 N10",
)
case(
    "a missing O9029 alarms at the S code",
    control=NEW, source="ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 S30
        N20 M30
    """,
    params={"6007#1": 1}, alarm="program-not-found", number="PS0076", at="O1 N10",
)
case(
    "a missing O9004 alarms at the ASCII code",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 H12
        N20 M30
    """,
    params={"6090": 72}, alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10",
)
case(
    "a missing program of a range of G codes alarms",
    control=NEW, source="ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 G201 A1.
        N20 M30
        O3000
        N30 M99
    """,
    params={"6038": 200, "6039": 3000, "6040": 3}, alarm="program-not-found", number="PS0076",
    at="O1 N10",
)
case(
    "a missing program of a range of M codes alarms",
    control=NEW, source="ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 M301 A1.
        N20 M30
        O5000
        N30 M99
    """,
    params={"6047": 300, "6048": 5000, "6049": 2}, alarm="program-not-found", number="PS0076",
    at="O1 N10",
)
case(
    "a subprogram called by an M code counts as a level of M98 on the 16i",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="inferred",
    program="""
        O1
        N10 M60
        N20 M30
        O9001
        N30 M98 P3
        N40 M99
        O3
        N50 #100=#100+1
        N60 M98 P3
        N70 M99
    """,
    params={"6071": 60}, alarm="nesting-too-deep", number="077", at="O3 N60", vars={100: 3},
)
case(
    "a subprogram called by a T code counts as a level of M98",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M30
        O9000
        N30 M98 P3
        N40 M99
        O3
        N50 #100=#100+1
        N60 M98 P3
        N70 M99
    """,
    params={"6001#5": 1}, alarm="nesting-too-deep", number="PS0077", at="O3 N60", vars={100: 9},
)
case(
    "M99 P of a program called by a G code to a missing block alarms",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 G70
        N20 M30
        O9010
        N30 M99 P77
    """,
    params={"6050": 70}, alarm="return-target-not-found", number=numbers("078", "PS0078"),
    at="O9010 N30",
)
case(
    "a user alarm in a modal macro stops the whole run",
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

# More that alarms: in statements

case(
    "a condition with a variable that does not exist alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[#40 EQ 1]GOTO30
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "a jump to the number in a variable that does not exist alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO#40
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "a variable whose number is a division by zero alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #[1/0]=5
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N20",
)
case(
    "a jump to a division by zero alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO[30/0]
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N20",
)
case(
    "a division by zero behind a true condition alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN #1=1/0
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N20",
)
case(
    "ASIN out of range at an address alarms",
    control=NOT_D, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T[ASIN[2]]
        N30 M30
    """,
    runs="N10", alarm="arc-sine-out-of-range",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N20", t=[1],
)
case(
    "the square root of a negative value in a condition alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[SQRT[-1] GT 1]GOTO30
        N30 M30
    """,
    runs="N10", alarm="square-root-of-negative", number=numbers("119", "PS0119"), at="O1 N20",
)
case(
    "six brackets deep in a variable number is too deep",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#[[[[[[1]]]]]]
        N30 M30
    """,
    runs="N10", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N20",
)
case(
    "a bracket at an address that is not closed alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T[3+4
        N30 M30
    """,
    runs="N10", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N20", t=[1],
)
case(
    "a GOTO to a minus number is out of range",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO[0-30]
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number", number=numbers("128", "PS1128"), at="O1 N20",
)
case(
    "IF THEN without a statement alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)
case(
    "IF THEN with an axis word alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN X5.
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)
case(
    "IF THEN with M30 alarms and does not end the program",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN M30
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)
case(
    "IF THEN with an NC word alarms even if its condition is false",
    control=ALL, source="ALM PS1137; policy: a control reads a block when it reaches it",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 2]THEN M8
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)
case(
    "END 4 is no loop number",
    control=ALL, source="ALM PS0126, ISO", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 END4
        N30 M30
    """,
    runs="N10", alarm="illegal-loop-number", number=numbers("126", "PS0126"), at="O1 N20",
)
case(
    "a spindle speed before GOTO alarms",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 S500 GOTO30
        N30 M30
    """,
    runs="N10", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N20",
)
case(
    "a T code before an assignment alarms and does not go out",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T5 #100=1
        N30 M30
    """,
    runs="N10", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N20",
    vars={100: None}, t=[1],
)
case(
    "#5021 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #5021=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#5061 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #5061=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#4115 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #4115=7
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "a DPRNT with one digit for its places is a format error",
    control=NEW, source="ALM PS1143", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 DPRNT[X#100[5]]
        N30 M30
    """,
    runs="N10", alarm="output-format", number="PS1143", at="O1 N20",
)
case(
    "a name of nine letters is too long for SETVN",
    control="fanuc-30i", source="ALM PS1142; K-M syntax", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 SETVN 510[TOOLNUMBR]
        N30 M30
    """,
    runs="N10", alarm="variable-name-too-long", number="PS1142", at="O1 N20",
)
case(
    "a negative variable number cannot be read",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#[2-5]
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "a jump into the inner of two loops alarms at its END",
    control=ALL, source="K-H general knowledge; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 WHILE[#1 LT 2]DO1
        N30 WHILE[#2 LT 2]DO2
        N40 #2=2
        N50 END2
        N60 #1=2
        N70 END1
        N80 M30
    """,
    runs="N10 N40", alarm="missing-do", number=numbers("124", "PS1124"), at="O1 N50",
)
case(
    "a jump out of a loop to before it and past its DO alarms at its END",
    control=ALL, source="K-H general knowledge; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ 1]GOTO40
        N20 WHILE[#1 LT 2]DO1
        N30 #1=#1+1
        N35 GOTO10
        N40 T4
        N50 END1
        N60 M30
    """,
    runs="N10 N20 N30 N35 N10 N40", alarm="missing-do", number=numbers("124", "PS1124"),
    at="O1 N50", t=[4],
)
