"""FANUC: arguments of macro calls, specification I and II, with and without a point."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


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
    "I after K opens a new set",
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
    "an I after E overwrites nothing of it, a J does",
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
    "E after the second J overwrites it",
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
    "F after the second K overwrites it",
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
    "G65 puts each letter into the variable of argument specification I (F201)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="source 002, argument specification I; ZAP; INT",
    evidence="source document",
    program="""
        O1
        G65 P2 A1. B2. C3. D7. E8. F9. H11. I4. J5. K6. M13. Q17. R18. S19. T20. U21. V22. W23. X24. Y25. Z26.
        M30
        O2
        #500=#1*1000000+#2*10000+#3*100+#4
        #501=#5*1000000+#6*10000+#7*100+#8
        #502=#9*1000000+#11*10000+#13*100+#17
        #503=#18*1000000+#19*10000+#20*100+#21
        #504=#22*1000000+#23*10000+#24*100+#25
        #505=#26
        #506=#10
        #507=#27
        M99
    """,
    vars={
        500: 1020304,
        501: 5060708,
        502: 9111317,
        503: 18192021,
        504: 22232425,
        505: 26,
        506: None,
        507: None,
    },
    arguments={
        1: 1,
        2: 2,
        3: 3,
        7: 7,
        8: 8,
        9: 9,
        11: 11,
        4: 4,
        5: 5,
        6: 6,
        13: 13,
        17: 17,
        18: 18,
        19: 19,
        20: 20,
        21: 21,
        22: 22,
        23: 23,
        24: 24,
        25: 25,
        26: 26,
        10: None,
        27: None,
    },
)

case(
    "ten sets of I, J and K fill #4 to #33 (F203)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, argument specification II; ZAP",
    evidence="source document",
    program="""
        O1
        G65 P2 A1. B2. C3. I4. J5. K6. I7. J8. K9. I10. J11. K12. I13. J14. K15. I16. J17. K18. I19. J20. K21. I22. J23. K24. I25. J26. K27. I28. J29. K30. I31. J32. K33.
        M30
        O2
        #100=0
        #101=1
        WHILE[#101 LE 33]DO1
        IF[#[#101] NE #101] THEN #100=#100+1
        #101=#101+1
        END1
        M99
    """,
    vars={100: 0, 101: 34},
    arguments={1: 1, 4: 4, 9: 9, 31: 31, 33: 33},
)

case(
    "D after a second I wins #7, and an I before it keeps #4 (F204)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304",
    evidence="maker's manual",
    program="""
        O1
        G65 A1.0 B2.0 I-3.0 I4.0 D5.0 P1000
        M30
        O1000
        #101=#1
        #102=#2
        #103=#3
        #104=#4
        #105=#5
        #106=#6
        #107=#7
        M99
    """,
    vars={101: 1, 102: 2, 103: None, 104: -3, 105: None, 106: None, 107: 5},
)

case(
    "A30. B45. I-3. I4. D5. gives #1, #2, #4 and #7 as the book says (F205)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, mixed arguments",
    evidence="source document",
    program="""
        O1
        G65 P9100 A30. B45. I-3. I4. D5.
        M30
        O9100
        #101=#1
        #102=#2
        #104=#4
        #107=#7
        M99
    """,
    vars={101: 30, 102: 45, 104: -3, 107: 5},
    arguments={1: 30, 2: 45, 4: -3, 7: 5},
)

case(
    "a second I after D wins #7 (F206)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, mixed arguments; PB304",
    evidence="source document",
    program="""
        O1
        G65 P2 D5. I-3. I4.
        M30
        O2
        #107=#7
        M99
    """,
    vars={107: 4},
)

case(
    "a letter not later in the alphabet than the one before begins a new set (F207)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304 fits; the rule: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 I1. K2. J3. I4.
        M30
        O2
        #104=#4
        #105=#5
        #106=#6
        #107=#7
        #108=#8
        #110=#10
        M99
    """,
    vars={104: 1, 105: None, 106: 2, 107: None, 108: 3, 110: 4},
)

case(
    "with 6008#7 at 1, K J I are #6 #5 #4 in any order (F209)",
    control=["fanuc-30i", "fanuc-0i-d"],
    source="source 002, parameter 6008.7; CW-A; the order: general knowledge of the FANUC manuals",
    evidence="source document",
    program="""
        O1
        G65 P2 K1. J2. I3.
        M30
        O2
        #101=#6
        #102=#5
        #103=#4
        M99
    """,
    params={"6008#7": 1},
    vars={101: 1, 102: 2, 103: 3},
)

case(
    "an eleventh set of I alarms (F210)",
    control="fanuc-30i",
    source="ALM PS1095",
    evidence="maker's manual",
    program="""
        O1
        G65 P2 I1. I2. I3. I4. I5. I6. I7. I8. I9. I10. I11.
        M30
        O2
        M99
    """,
    alarm="too-many-argument-sets",
    number="PS1095",
    at="O1",
)

case(
    "a G code as an argument of G65 alarms (F211)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0129; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G65 P2 A1. G28.
        M30
        O2
        M99
    """,
    alarm="illegal-argument",
    number={"fanuc-16i": "129", "fanuc-30i": "PS0129"},
    at="O1",
)

case(
    "arguments are computed with the caller's variables (F215)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        #1=10
        #2=3
        G65 P2 A#2 B[#1+#2]
        M30
        O2
        #100=#1
        #101=#2
        M99
    """,
    vars={100: 3, 101: 13},
)

case(
    "with 3401#0 at 1 an argument without a point counts as it stands (F218)",
    control=["fanuc-30i", "fanuc-0i-d"],
    source="3401#0 DPI: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 X10
        M30
        O2
        #100=#24
        M99
    """,
    params={"3401#0": 1},
    vars={100: 10},
)

case(
    "an argument before G65 alarms (F226)",
    control=["fanuc-16i", "fanuc-30i"],
    source="policy; X-65 wants G65 first",
    evidence="inferred",
    program="""
        O1
        A1. G65 P2 B2.
        M30
        O2
        M99
    """,
    alarm="macro-call-not-first",
    number={"fanuc-16i": "129", "fanuc-30i": "PS0129"},
    at="O1",
)
