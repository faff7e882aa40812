"""FANUC: subprogram calls and returns (M98, M99, M198), program ends, MDI."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]
OLD = ["fanuc-16i", "fanuc-0i-d"]


def numbers(old, new):
    """The number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


# Programs and their heads (what a call can find)

case(
    "a subprogram headed by a colon is found by its number",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        :200
        N30 M99
    """,
    runs="N10 N30 N20", calls="M98:O200",
)
case(
    "leading zeros of the O number and of P do not count",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O0001
        N10 M98 P0007
        N20 M98 P7
        N30 M30
        O007
        N40 M99
    """,
    runs="N10 N40 N20 N40 N30",
)
case(
    "leading zeros of N and of the P of M99 do not count",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M3
        N0030 M30
        O2
        N40 M99 P00030
    """,
    runs="N10 N40 N30", m=[],
)
case(
    "several programs between one pair of percent signs are programs of their own",
    control=ALL, source="GED", evidence="secondary",
    program="""
        %
        O1
        N10 M98 P3
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
        %
    """,
    runs="N10 N40 N20", calls="M98:O3",
)
case(
    "a percent sign between programs does not hide the program behind it",
    control=ALL, source="GED", evidence="secondary",
    program="""
        %
        O1
        N10 M98 P2
        N20 M30
        %
        O2
        N30 M99
        %
    """,
    runs="N10 N30 N20",
)
case(
    "the title behind the O word is no block",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1 (MAIN PART)
        N10 M98 P2
        N20 M30
        O2 (HOLE)
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a word behind the O word on the same line belongs to the first block",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1 N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a file without a head is called by the number in its file name",
    control=ALL, source="policy: a file without a head is named by its stem", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P7\nN20 M30\n", "O7.NC": "N30 M99\n"}, main="O1",
    runs="N10 N30 N20",
)
case(
    "the main program may stand behind its subprogram",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
        O1
        N10 M98 P2
        N20 M30
    """,
    main="O1", runs="N10 N30 N20",
)
case(
    "a run may start at a sequence number",
    pins="statements",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 #101=1
        N30 M30
    """,
    start=20, runs="N20 N30", vars={100: None, 101: 1},
)
case(
    "a program is called by its name",
    control=LATE, source="K-H general knowledge; ALM PS0310", evidence="inferred",
    program="""
        O1
        N10 M98 <DRILL>
        N20 M30
        <DRILL>
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a name may hold digits, minus, plus, underscore and point",
    pins="name_marks",
    control=LATE, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <A-1+B_2.X>
        N20 M30
        <A-1+B_2.X>
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "the name <O123> is program number 123",
    control=LATE, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <O123>
        N20 M30
        O123
        N30 M99
    """,
    runs="N10 N30 N20", calls="M98:O123",
)
case(
    "L repeats a call by name",
    control=LATE, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <DRILL> L3
        N20 M30
        <DRILL>
        N30 M99
    """,
    runs="N10 N30*3 N20",
)
case(
    "a named program that is not in memory is a file not found",
    control=LATE, source="ALM PS0310", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M98 <SLOT>
        N30 M30
        O2
        N40 M99
    """,
    alarm="named-program-not-found", number="PS0310", at="O1 N20",
)
case(
    "a name that is not closed is a format error",
    control=LATE, source="ALM PS0311", evidence="secondary",
    program="""
        O1
        N10 M98 <DRILL
        N20 M30
        <DRILL>
        N30 M99
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "an empty name is a format error",
    control=LATE, source="ALM PS0311", evidence="secondary",
    program="""
        O1
        N10 M98 <>
        N20 M30
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a name with an asterisk is a format error",
    control=LATE, source="ALM PS0311; K-H list of characters", evidence="secondary",
    program="""
        O1
        N10 M98 <A*B>
        N20 M30
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a name of 33 characters is a format error",
    pins="max_name_length",
    control=LATE, source="ALM PS0311; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <A23456789012345678901234567890123>
        N20 M30
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a name of 32 characters is looked up",
    control=LATE, source="ALM PS0310; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <A2345678901234567890123456789012>
        N20 M30
    """,
    alarm="named-program-not-found", number="PS0310", at="O1 N10",
)

# Blocks: end of block, comments, spaces, block skip

case(
    "a semicolon ends a block",
    control=ALL, source="PB155; policy", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2; N20 M98 P2;
        N30 M30;
        O2
        N40 M99;
    """,
    runs="N10 N40 N20 N40 N30",
)
case(
    "carriage return and line feed end one block, not two",
    control=ALL, source="PB155; policy", evidence="maker's manual",
    program="O1\r\nN10 M98 P2\r\nN20 M30\r\nO2\r\nN30 M99\r\n",
    runs="N10 N30 N20",
)
case(
    "a comment between M98 and its P changes nothing",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 (CALL O3) P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "an L inside a comment does not repeat the call",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2 (L3)
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a comment that is not closed hides the rest of its block",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 (L3
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "lower case letters are read as upper case",
    control=ALL, source="policy", evidence="inferred",
    program="""
        o1
        n10 m98 p2
        n20 m30
        o2
        n30 m99
    """,
    runs="N10 N30 N20",
)
case(
    "an unknown character is an illegal address",
    control=ALL, source="policy; ALM PS0009", evidence="inferred",
    program="""
        O1
        N10 M98 P2 $
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-character", number=numbers("009", "PS0009"), at="O1 N10",
)
case(
    "an unknown character inside a comment alarms nothing",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2 ($ 5)
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a call needs no space between its words",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10M98P2L2
        N20M30
        O2
        N30M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "spaces inside words do not count",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N 10 M 9 8 P 2
        N 20 M 30
        O 2
        N 30 M 99
    """,
    runs="N10 N30 N20",
)
case(
    "block skip leaves out a call",
    control=ALL, source="GED, ISO", evidence="secondary",
    program="""
        O1
        /N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(1,), runs="N20",
)
case(
    "with the skip switch off a slash changes nothing",
    control=ALL, source="GED, ISO", evidence="secondary",
    program="""
        O1
        /N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a slash without a digit is skip 1, not skip 2",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(2,), runs="N10 N30 N20",
)
case(
    "/1 is the same as a slash alone",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /1 N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(1,), runs="N20",
)
case(
    "/9 is skipped by switch 9",
    control=ALL, source="ISO", evidence="secondary",
    program="""
        O1
        /9 N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(9,), runs="N20",
)
case(
    "/1/3 is skipped by either switch",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /1/3 N10 M98 P2
        /1/3 N20 M98 P2
        N30 M30
        O2
        N40 M99
    """,
    skip=(3,), runs="N30",
)
case(
    "a slash in mid-block hides the call behind it and keeps the words before it",
    control=ALL, source="GED; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T5 /M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(1,), runs="N10 N20", t=[5],
)
case(
    "a skipped faulty block alarms nothing",
    control=ALL, source="ISO; K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 M98 P-2
        N20 M30
    """,
    skip=(1,), runs="N20",
)
case(
    "a faulty block behind a slash alarms while the switch is off",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        /N10 M98 P-2
        N20 M30
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "M99 P finds the N of a skipped block",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M3
        /N30 M4
        N40 M30
        O2
        N50 M99 P30
    """,
    skip=(1,), runs="N10 N50 N40", m=[],
)
case(
    "GOTO finds the N of a skipped block",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 M3
        /N30 M4
        N40 M30
    """,
    skip=(1,), runs="N10 N40", m=[],
)
case(
    "block skip works inside a subprogram",
    control=ALL, source="GED, ISO", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        /N30 M3
        N40 M99
    """,
    skip=(1,), runs="N10 N40 N20", m=[],
)

# Words: numbers, signs, points, repeated addresses, M codes in one block

case(
    "P without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10", word="P",
)
case(
    "L without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10", word="L",
)
case(
    "the P of M99 without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P
    """,
    runs="N10", alarm="address-without-value", number=numbers("005", "PS0005"), at="O2 N30",
)
case(
    "a point at the P of M98 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M98 P2.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="P2.",
)
case(
    "a point at L is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L2.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="L2.",
)
case(
    "a point at the P of M99 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P20.
    """,
    runs="N10", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O2 N30",
    word="P20.",
)
case(
    "a point at M is illegal",
    control=ALL, source="ALM PS0007, SIN", evidence="secondary",
    program="""
        O1
        N10 M98. P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="M98.",
)
case(
    "two points in one number are illegal",
    control=ALL, source="ALM PS0007, SIN", evidence="secondary",
    program="""
        O1
        N10 X1.5. M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
)
case(
    "a minus sign at L is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L-1
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10", word="L-1",
)
case(
    "a minus sign at the P of M99 is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P-20
    """,
    runs="N10", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O2 N30",
    word="P-20",
)
case(
    "a minus sign at M is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M-98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "a number without an address cannot start a block",
    control=ALL, source="ALM PS0004; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        5 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10", alarm="value-without-address", number=numbers("004", "PS0004"), at="O1",
)
case(
    "nine digits at P are too many on the 16i",
    pins="max_program_digits",
    control="fanuc-16i", source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P123450002
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="too-many-digits", number="003", at="O1 N10",
)
case(
    "ten digits at P are too many",
    control=LATE, source="ALM PS0003; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P1234500002
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="too-many-digits", number="PS0003", at="O1 N10",
)
case(
    "N needs a number: a variable is refused",
    control=NEW, source="ALM PS1014; TSN, NCT", evidence="secondary",
    program="""
        O1
        N10 #3=20
        N#3 M3
        N30 M30
    """,
    runs="N10", alarm="illegal-sequence-number", number="PS1014", at="O1",
)
case(
    "of two P in a block the later counts",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 P3
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
    """,
    runs="N10 N40 N20", calls="M98:O3",
)
case(
    "of two L in a block the later counts",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L4 L2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "with 3403#6=1 two P in a block alarm",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 M98 P2 P3
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
    """,
    params={"3403#6": 1}, runs="", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O1 N10", word="P3",
)
case(
    "with 3403#6=1 two L in a block alarm",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L2 L2
        N20 M30
        O2
        N30 M99
    """,
    params={"3403#6": 1}, runs="", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O1 N10",
)
case(
    "with 3403#6=1 two G codes of one group alarm",
    control=ALL, source="ALM PS5074", evidence="secondary",
    program="""
        O1
        N10 G90 G91 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"3403#6": 1}, runs="", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O1 N10",
)
case(
    "with 3403#6=1 two G codes of different groups alarm nothing",
    control=ALL, source="ALM PS5074; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G90 G0 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"3403#6": 1}, runs="N10 N30 N20",
)
case(
    "27 words make a block with too many words",
    pins="max_words",
    control=ALL, source="ALM PS5006", evidence="secondary",
    program="""
        O1
        N10 X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.
        N20 M30
    """,
    runs="", alarm="too-many-words", number=numbers("5006", "PS5006"), at="O1 N10",
)
case(
    "20 words in a block are not too many",
    control=ALL, source="ALM PS5006", evidence="secondary",
    program="""
        O1
        N10 M98 P2 X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "with 3404#7=1 three M codes of a block go out in the order written",
    control=ALL, source="CEX487; K-H parameter", evidence="maker's manual",
    program="""
        O1
        N10 M8 M3 M7
        N20 M30
    """,
    params={"3404#7": 1}, runs="N10 N20", m=[8, 3, 7],
)
case(
    "with 3404#7=0 the last M code of a block goes out",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M8 M3
        N20 M30
    """,
    runs="N10 N20", m=[3],
)
case(
    "M98 and a machine M code cannot share a block",
    pins="m_codes_alone",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M98 P2 M8
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-m-combination", number=numbers("5016", "PS5016"), at="O1 N10", m=[],
)
case(
    "M99 and a machine M code cannot share a block",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M9 M99
    """,
    runs="N10", alarm="illegal-m-combination", number=numbers("5016", "PS5016"), at="O2 N30", m=[],
)
case(
    "M30 and a machine M code cannot share a block, not even with three M codes allowed",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M5 M30
    """,
    params={"3404#7": 1}, runs="N10", alarm="illegal-m-combination",
    number=numbers("5016", "PS5016"), at="O1 N20", m=[],
)
case(
    "M198 and a machine M code cannot share a block",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M198 P2 M8
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-m-combination",
    number=numbers("5016", "PS5016"), at="O1 N10",
)
case(
    "an M code that calls a subprogram and a machine M code cannot share a block",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M60 M8
        N20 M30
        O9001
        N30 M99
    """,
    params={"6071": 60, "3404#7": 1}, runs="", alarm="illegal-m-combination",
    number=numbers("5016", "PS5016"), at="O1 N10", m=[],
)

# Ends of programs

case(
    "M02 ends the run",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M02
        N30 T2
    """,
    runs="N10 N20", t=[1],
)
case(
    "a faulty block behind M30 alarms nothing",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        N25 M98 P
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "M30 behind a skipped slash does not end the program",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 M30
        N20 T2
        N30 M30
    """,
    skip=(1,), runs="N20 N30", t=[2],
)
case(
    "M30 behind a slash ends the program while the switch is off",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N5 T1
        /N10 M30
        N20 T2
        N30 M30
    """,
    runs="N5 N10", t=[1],
)
case(
    "a main program that runs into its end alarms",
    pins="missing_end",
    control=ALL, source="ALM PS5010", evidence="secondary",
    program="""
        %
        O1
        N10 T1
        N20 T2
        %
    """,
    runs="N10 N20", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[1, 2],
)
case(
    "the end of a main program is not the head of the next one",
    control=ALL, source="ALM PS5010", evidence="secondary",
    program="""
        O1
        N10 T1
        O2
        N20 T2
        N30 M30
    """,
    runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[1],
)
case(
    "a subprogram that runs into its end alarms",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
    """,
    runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2",
)
case(
    "a macro that runs into its end alarms",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A1.
        N20 M30
        O2
        N30 #100=#1
    """,
    runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2", vars={100: 1},
)
case(
    "a subprogram without a block alarms",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        O3
        N30 M99
    """,
    runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2",
)
case(
    "with 3404#6=1 a subprogram that runs into its end resets the control and does not return",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
    """,
    params={"3404#6": 1}, runs="N10 N30", stop="end", t=[3],
)
case(
    "with 3404#6=1 M30 and M99 work as before",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"3404#6": 1}, runs="N10 N30 N20",
)
case(
    "a main program whose only M30 is skipped runs into its end",
    control=ALL, source="ALM PS5010; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M30
    """,
    skip=(1,), runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1",
)
case(
    "M00 in a subprogram leaves the open call open",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M00
        N40 M99
    """,
    runs="N10 N30 N40 N20",
)
case(
    "M01 in a subprogram leaves the open call open",
    control=ALL, source="GED; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M01
        N40 M99
    """,
    optional_stop=True, runs="N10 N30 N40 N20",
)

# M98: P with a count, L, names

case(
    "three digits at P are a program number, called once",
    control=ALL, source="GED, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P123
        N20 M30
        O123
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "four digits at P are a program number, called once",
    control=ALL, source="GED, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P3002
        N20 M30
        O2
        N30 M99
        O3002
        N40 M99
    """,
    runs="N10 N40 N20",
)
case(
    "the digits before the last four of P are the count",
    control=ALL, source="GED, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P20003
        N20 M30
        O3
        N30 M99
        O2
        N40 M99
    """,
    runs="N10 N30*2 N20", calls="M98:O3",
)
case(
    "the last four digits of P are the program number, with their zeros",
    control=ALL, source="GED, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P31200
        N20 M30
        O1200
        N30 M99
        O200
        N40 M99
    """,
    runs="N10 N30*3 N20",
)
case(
    "a count of 12 takes six digits",
    control=ALL, source="GED, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P120002
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*12 N20",
)
case(
    "eight digits at P are the longest count and number",
    control=ALL, source="GED, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P00040002
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*4 N20",
)
case(
    "a count of 9999 in P is legal",
    pins="max_program_digits",
    control=ALL, source="ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P99990002
        N20 M30
        O2
        #100=#100+1
        M99
    """,
    runs="N10 N20", vars={100: 9999},
)
case(
    "zeros before a four-digit number are no count",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P00000002
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a count before 0000 names no program",
    control=ALL, source="policy; ALM PS0076", evidence="inferred",
    program="""
        O1
        N10 M98 P20000
        N20 M30
        O2
        N30 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10",
)
case(
    "P0 names no program",
    control=ALL, source="policy; ALM PS0076", evidence="inferred",
    program="""
        O1
        N10 M98 P0
        N20 M30
        O2
        N30 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10",
)
case(
    "a P of five digits without L does not find a five-digit program",
    control=LATE, source="K-M general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 M98 P12345
        N20 M30
        O12345
        N30 M99
        O2345
        N40 M99
    """,
    runs="N10 N40 N20", calls="M98:O2345",
)
case(
    "the missing program of a count in P is the last four digits",
    control=ALL, source="GED; ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 M98 P51003
        N20 M30
        O1002
        N30 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10",
)
case(
    "P may be a variable",
    control=ALL, source="JIX, SIN; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=3
        N20 M98 P#100
        N30 M30
        O3
        N40 M99
    """,
    runs="N10 N20 N40 N30",
)
case(
    "a variable at P may hold a count",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=20003
        N20 M98 P#100
        N30 M30
        O3
        N40 M99
    """,
    runs="N10 N20 N40*2 N30",
)
case(
    "P may be an expression",
    control=ALL, source="JIX; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=5
        N20 M98 P[#100*100+1]
        N30 M30
        O501
        N40 M99
    """,
    runs="N10 N20 N40 N30",
)
case(
    "a variable at P is rounded to a whole number",
    pins="call_values",
    control=[*ALL, "haas-ngc"], source="SIN, JIX", evidence="secondary",
    program="""
        O1
        N10 #100=2.5
        N20 M98 P#100
        N30 M30
        O2
        N40 M99
        O3
        N50 M99
    """,
    runs="N10 N20 N50 N30",
)
case(
    "a vacant P is no P",
    pins="omitted_program",
    control=[*ALL, "haas-ngc"], source="XIA, JIX; K-H 076", evidence="inferred",
    program="""
        O1
        N10 M98 P#100
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="program-number-missing", number={**numbers("076", "PS0076"), "haas-ngc": "313"}, at="O1 N10",
)
case(
    "a variable at P that names a missing program alarms",
    control=ALL, source="ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 #100=4
        N20 M98 P#100
        N30 M30
        O3
        N40 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N20",
)
case(
    "L repeats the call",
    control=ALL, source="CL198, CW-S; K-M general knowledge", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L3
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*3 N20", calls="M98:O2",
)
case(
    "L1 calls once",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L1
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "L0 calls once",
    pins="zero_repeats",
    control=[*ALL, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L0
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "L may stand before P",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 L2 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "P and L may stand before M98",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 L2 P2 M98
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "L may be a variable",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #101=2
        N20 M98 P2 L#101
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40*2 N30",
)
case(
    "a vacant L is no L",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L#101
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "L9999 is legal",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L9999
        N20 M30
        O2
        #100=#100+1
        M99
    """,
    runs="N10 N20", vars={100: 9999},
)
case(
    "L10000 is too many repeats",
    control=OLD, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L10000
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="repeat-count-digits", number={"fanuc-16i": "003", "fanuc-0i-d": "PS0003"}, at="O1 N10",
)
case(
    "L10000 is legal where L has eight digits",
    control="fanuc-30i", source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L10000
        N20 M30
        O2
        #100=#100+1
        M99
    """,
    runs="N10 N20", vars={100: 10000},
)
case(
    "with L all digits of P are the program number",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P20003 L2
        N20 M30
        O3
        N30 M99
        O20003
        N40 M99
    """,
    runs="N10 N40*2 N20", calls="M98:O20003",
)
case(
    "L1 is enough to make all digits of P the program number",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P20003 L1
        N20 M30
        O3
        N30 M99
        O20003
        N40 M99
    """,
    runs="N10 N40 N20",
)
case(
    "with L a count in P is not split off",
    control=LATE, source="K-M general knowledge; ALM PS0076", evidence="inferred",
    program="""
        O1
        N10 M98 P20003 L2
        N20 M30
        O3
        N30 M99
    """,
    alarm="program-not-found", number="PS0076", at="O1 N10",
)
case(
    "an eight-digit program is called with L",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P12345678 L1
        N20 M30
        O12345678
        N30 M99
    """,
    runs="N10 N30 N20",
)

# M98 with Q (6005#0)

case(
    "M98 P Q starts the subprogram at the block of Q",
    control=LATE, source="GED, WEI; K-M parameter", evidence="secondary",
    program="""
        O1
        N10 M98 P2 Q40
        N20 M30
        O2
        N30 M3
        N40 M4
        N50 M99
    """,
    params={"6005#0": 1}, runs="N10 N40 N50 N20", m=[4],
)
case(
    "every repeat starts at the block of Q",
    control=LATE, source="GED, WEI; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q40 L2
        N20 M30
        O2
        N30 M3
        N40 M4
        N50 M99
    """,
    params={"6005#0": 1}, runs="N10 (N40 N50)*2 N20",
)
case(
    "Q may be a variable",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=40
        N15 M98 P2 Q#100
        N20 M30
        O2
        N30 M3
        N40 M99
    """,
    params={"6005#0": 1}, runs="N10 N15 N40 N20",
)
case(
    "M98 Q in a subprogram starts in that subprogram",
    control=LATE, source="GED; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        N60 M99
        O2
        N40 M98 Q60
        N50 M99
        N60 M99
    """,
    params={"6005#0": 1}, runs="O1:N10 O2:N40 O2:N60 O2:N50 O1:N20", calls="M98:O2 M98:O2",
)
case(
    "a local subprogram may return by M99 P to a block of its own program",
    control=LATE, source="GED, S003; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M3
        N30 M30
        N100 M99 P30
    """,
    params={"6005#0": 1}, runs="N10 N100 N30", m=[],
)
case(
    "a local subprogram shares the local variables",
    control=LATE, source="PB304; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=4
        N20 M98 Q100
        N30 M30
        N100 #100=#1
        N110 M99
    """,
    params={"6005#0": 1}, runs="N10 N20 N100 N110 N30", vars={100: 4},
)
case(
    "a Q that the subprogram does not have alarms",
    control=LATE, source="ALM PS0078; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q70
        N20 M30
        N70 M3
        O2
        N30 M99
    """,
    params={"6005#0": 1}, alarm="start-not-found", number="PS0078", at="O1 N10",
)
case(
    "a Q that the present program does not have alarms",
    control=LATE, source="ALM PS0078; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q70
        N20 M30
        O2
        N70 M99
    """,
    params={"6005#0": 1}, alarm="start-not-found", number="PS0078", at="O1 N10",
)
case(
    "M98 P Q of a missing program is a missing program",
    control=LATE, source="ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 M98 P2 Q10
        N20 M30
    """,
    params={"6005#0": 1}, alarm="program-not-found", number="PS0076", at="O1 N10",
)
case(
    "Q without a number has no data",
    control=LATE, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P2 Q
        N20 M30
        O2
        N30 M99
    """,
    params={"6005#0": 1}, runs="", alarm="address-without-value", number="PS0005", at="O1 N10",
)
case(
    "without 6005#0 an M98 with Q alone names no program",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 M99
    """,
    runs="", alarm="program-number-missing", number="PS0076", at="O1 N10",
)
case(
    "the 16i has no M98 Q: the program is missing",
    control="fanuc-16i", source="GED marks it as a later function; K-M general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 M99
    """,
    runs="", alarm="program-number-missing", number="076", at="O1 N10",
)
case(
    "a local subprogram that calls itself runs out of levels",
    control=LATE, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 #100=#100+1
        N110 M98 Q100
        N120 M99
    """,
    params={"6005#0": 1}, alarm="nesting-too-deep", number="PS0077", at="O1 N110", vars={100: 10},
)

# M98: order in the block, what is shared, nothing goes to the machine

case(
    "a T code in the M98 block goes out before the subprogram runs",
    control=ALL, source="PMI39, 17W", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2 T5
        N20 M30
        O2
        N30 T6
        N40 M99
    """,
    runs="N10 N30 N40 N20", t=[5, 6],
)
case(
    "words before M98 run once, not once per repeat",
    control=ALL, source="PMI39, GED", evidence="maker's manual",
    program="""
        O1
        N10 T5 M98 P2 L2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*2 N20", t=[5],
)
case(
    "an axis move in the M98 block is finished when the subprogram starts",
    control=ALL, source="PMI39, 17W", evidence="maker's manual",
    program="""
        O1
        N10 G90 G0 X12. M98 P2
        N20 M30
        O2
        N30 #100=#5001
        N40 M99
    """,
    runs="N10 N30 N40 N20", vars={100: 12},
)
case(
    "the words of an M98 block run even if its program is missing",
    control=ALL, source="PMI39; ALM PS0076", evidence="maker's manual",
    program="""
        O1
        N10 T5 M98 P99
        N20 M30
    """,
    runs="N10", alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N10", t=[5],
)
case(
    "nothing of an M98 block without P runs",
    control=ALL,
    source="K-H general knowledge; policy: nothing changes before a block has been checked",
    evidence="inferred",
    program="""
        O1
        N10 T5 M98
        N20 M30
    """,
    runs="", alarm="program-number-missing", number=numbers("076", "PS0076"), at="O1 N10", t=[],
)
case(
    "nothing of an M98 block with a faulty P runs",
    control=ALL, source="ALM PS0006; policy: nothing changes before a block has been checked",
    evidence="inferred",
    program="""
        O1
        N10 T5 M98 P-2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10", t=[],
)
case(
    "M98 and M99 are not sent to the machine",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M3
        N20 M98 P2
        N30 M5
        N40 M30
        O2
        N50 M8
        N60 M99
    """,
    runs="N10 N20 N50 N60 N30 N40", m=[3, 8, 5],
)
case(
    "M98 takes no new local variables",
    pins="call_passes_words",
    control=ALL, source="PB304", evidence="maker's manual",
    program="""
        O1
        N10 #33=2
        N20 M98 P2
        N30 M30
        O2
        N40 #100=#33
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={100: 2},
)
case(
    "a local set in a subprogram is seen by the caller",
    control=ALL, source="PB304", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2
        N20 #100=#5
        N30 M30
        O2
        N40 #5=6
        N50 M99
    """,
    runs="N10 N40 N50 N20 N30", vars={5: 6, 100: 6},
)
case(
    "repeats of a subprogram see the locals of the pass before",
    control=ALL, source="PB304", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2 L3
        N20 M30
        O2
        N30 #1=#1+2
        N40 M99
    """,
    runs="N10 (N30 N40)*3 N20", vars={1: 6},
)
case(
    "a subprogram called from a macro shares the macro's locals",
    control=ALL, source="PB304", evidence="maker's manual",
    program="""
        O1
        N10 #1=9
        N20 G65 P2 A5.
        N30 M30
        O2
        N40 M98 P3
        N50 M99
        O3
        N60 #100=#1
        N70 M99
    """,
    runs="N10 N20 N40 N60 N70 N50 N30", vars={1: 9, 100: 5},
)
case(
    "common variables are shared by caller and subprogram",
    control=ALL, source="ZAP, JIX", evidence="secondary",
    program="""
        O1
        N10 #100=3
        N20 M98 P2
        N30 M30
        O2
        N40 #100=#100*2
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={100: 6},
)
case(
    "G91 set in a subprogram stays in force in the caller",
    control=ALL, source="source 003, modal G codes in subprograms", evidence="source document",
    program="""
        O1
        N10 G90
        N20 M98 P2
        N30 #100=#4003
        N40 M30
        O2
        N50 G91
        N60 M99
    """,
    runs="N10 N20 N50 N60 N30 N40", vars={100: 91},
)

# M98: nesting

case(
    "a program may call itself while levels are left",
    pins="self_call max_nesting",
    control=ALL, source="MC52, GED; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 IF[#100 GE 4]GOTO60
        N50 M98 P2
        N60 M99
    """,
    runs="N10 (N30 N40 N50)*3 N30 N40 N60*4 N20", vars={100: 4},
)
case(
    "the fifth level of M98 alarms on the 16i at the call",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 M98 P2
        N50 M99
    """,
    alarm="nesting-too-deep", number="077", at="O2 N40", vars={100: 4},
)
case(
    "the eleventh level of M98 alarms at the call",
    pins="max_nesting",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 M98 P2
        N50 M99
    """,
    alarm="nesting-too-deep", number="PS0077", at="O2 N40", vars={100: 10},
)
case(
    "ten levels of M98 are legal",
    control=NEW, source="K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        #100=#100+1
        IF[#100 GE 10]GOTO60
        M98 P2
        N60 M99
    """,
    runs="N10 N60*10 N20", vars={100: 10},
)
case(
    "a main program that calls itself runs out of levels on the 16i",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="maker's manual",
    program="""
        O1
        N10 #100=#100+1
        N20 M98 P1
        N30 M30
    """,
    alarm="nesting-too-deep", number="077", at="O1 N20", vars={100: 5},
)
case(
    "a main program that calls itself runs out of levels",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 M98 P1
        N30 M30
    """,
    alarm="nesting-too-deep", number="PS0077", at="O1 N20", vars={100: 11},
)
case(
    "two programs that call each other run out of levels",
    control=ALL, source="ALM PS0077, MC52", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M98 P2
        N60 M99
    """,
    alarm="nesting-too-deep", number=numbers("077", "PS0077"), at="O3 N50",
)
case(
    "a repeat is no new level",
    control=ALL, source="MC52; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L20
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M99
    """,
    runs="N10 (N30 N50 N40)*20 N20",
)
case(
    "a level is free again after its return",
    control=ALL, source="MC52; K-H depth", evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 M98 P2
        N30 IF[#100 LT 12]GOTO10
        N40 M30
        O2
        N50 M99
    """,
    runs="(N10 N20 N50 N30)*12 N40",
)
case(
    "four M98 levels and four macro levels fit together on the 16i, a fifth M98 level does not",
    pins="nesting_counts_macros",
    control="fanuc-16i", source="PB304, RW; K-H 077", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G65 P3
        N40 M99
        O3
        N50 #100=#100+1
        N60 M98 P3
        N70 M99
    """,
    alarm="nesting-too-deep", number="077", at="O3 N60", vars={100: 5},
)
case(
    "macro calls do not use up M98 levels",
    pins="nesting_counts_macros",
    control=NEW, source="PB304; K-H depth", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G65 P3
        N40 M99
        O3
        N50 #100=#100+1
        N60 M98 P3
        N70 M99
    """,
    alarm="nesting-too-deep", number="PS0077", at="O3 N60", vars={100: 11},
)
case(
    "M98 inside a WHILE loop uses one level",
    control=ALL, source="policy; MC52", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 12]DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 #1=#1+1
        N60 M99
    """,
    runs="(N10 N20 N50 N60 N30)*12 N10 N40", vars={1: 12},
)

# M98: errors

case(
    "a block with M98 alone names no program",
    control=ALL, source="K-H 076; ALM PS0076", evidence="inferred",
    program="""
        O1
        N10 M98 L2
        N20 M30
    """,
    runs="", alarm="program-number-missing", number=numbers("076", "PS0076"), at="O1 N10",
)
case(
    "a missing subprogram of a subprogram alarms in the subprogram",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O2 N30", calls="M98:O2",
)
case(
    "a program that is never called may be missing",
    control=ALL, source="policy: reading never fails", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]GOTO30
        N20 M98 P77
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "M98 and a calling M code in one block are two calls",
    control=NEW, source="ALM PS1091", evidence="secondary",
    program="""
        O1
        N10 M98 P2 M60
        N20 M30
        O2
        N30 M99
        O9001
        N40 M99
    """,
    params={"6071": 60}, runs="", alarm="call-given-twice", number="PS1091", at="O1 N10",
)
case(
    "M98 and a calling T code in one block are two calls",
    control=NEW, source="ALM PS1091", evidence="secondary",
    program="""
        O1
        N10 T5 M98 P2
        N20 M30
        O2
        N30 M99
        O9000
        N40 M99
    """,
    params={"6001#5": 1}, runs="", alarm="call-given-twice", number="PS1091", at="O1 N10",
)
case(
    "a calling T code and a calling M code in one block are two calls",
    control=NEW, source="ALM PS1091", evidence="secondary",
    program="""
        O1
        N10 T5 M60
        N20 M30
        O9000
        N30 M99
        O9001
        N40 M99
    """,
    params={"6001#5": 1, "6071": 60}, runs="", alarm="call-given-twice", number="PS1091",
    at="O1 N10",
)
case(
    "M98 with an axis word in a canned cycle alarms",
    pins="words_with_call_in_cycle",
    control=NEW, source="ALM PS5329", evidence="secondary",
    program="""
        O1
        N10 G83 X1. Z-9. R1. Q2. F100
        N20 Y5. M98 P2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="call-with-words-in-cycle", number="PS5329", at="O1 N20",
)
case(
    "M98 with a T code in a canned cycle alarms",
    control=NEW, source="ALM PS5329", evidence="secondary",
    program="""
        O1
        N10 G81 X1. Z-9. R1. F100
        N20 T5 M98 P2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="call-with-words-in-cycle", number="PS5329", at="O1 N20", t=[],
)
case(
    "a bare M98 in a canned cycle is legal",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G81 X1. Z-9. R1. F100
        N20 M98 P2
        N30 G80
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N50 N30 N40",
)
case(
    "a bare M98 with L in a canned cycle is legal",
    control=ALL, source="K-M general knowledge; ALM PS5329", evidence="inferred",
    program="""
        O1
        N10 G81 X1. Z-9. R1. F100
        N20 M98 P2 L2
        N30 G80
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N50*2 N30 N40",
)
case(
    "M98 with an axis word is legal again behind G80",
    control=NEW, source="ALM PS5329", evidence="secondary",
    program="""
        O1
        N10 G81 X1. Z-9. R1. F100
        N20 G80
        N30 G0 Y5. M98 P2
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N30 N50 N40",
)

# MDI

case(
    "M98 in MDI calls a stored program",
    control=ALL, source="K-M general knowledge (source 003 refuses it on older controls)",
    evidence="inferred",
    program="""
        O2
        N30 T3
        N40 M99
    """,
    mdi="M98 P2", runs="N30 N40", t=[3],
)
case(
    "M98 in MDI may repeat",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 M98 P30002", runs="N10 N30*3",
)
case(
    "blocks behind an M98 in MDI run after the return",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 T3
        N40 M99
    """,
    mdi="N10 M98 P2\nN20 T4", runs="N10 N30 N40 N20", t=[3, 4],
)
case(
    "a program called from MDI may call on",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M99
    """,
    mdi="N10 M98 P2", runs="N10 N30 N50 N40", calls="M98:O2 M98:O3",
)
case(
    "a missing program alarms in MDI as in memory mode",
    control=ALL, source="ALM PS0076; K-H 078", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="M98 P5", alarm="program-not-found", number=numbers("078", "PS0076"),
)
case(
    "G65 in MDI calls a macro with arguments",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 #100=#1
        N40 M99
    """,
    mdi="N10 G65 P2 A4.", runs="N10 N30 N40", vars={100: 4},
)
case(
    "an assignment in MDI is legal",
    control=ALL, source="ALM PS0123; K-H general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 #100=5", runs="N10", vars={100: 5},
)
case(
    "M99 at the end of an MDI program starts it over",
    pins="main_return",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 #100=#100+1\nN20 M99", max_cycles=3, runs="(N10 N20)*3", stop="cycles", vars={100: 3},
)
case(
    "GOTO in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 GOTO20\nN20 M98 P2", runs="", alarm="jump-in-mdi", number=numbers("123", "PS0123"),
)
case(
    "IF GOTO in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 T1\nN15 IF[1 EQ 1]GOTO20\nN20 M98 P2", runs="N10", alarm="jump-in-mdi",
    number=numbers("123", "PS0123"), t=[1],
)
case(
    "WHILE in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 WHILE[#1 LT 2]DO1\nN20 #1=#1+1\nN30 END1", runs="", alarm="jump-in-mdi",
    number=numbers("123", "PS0123"),
)
case(
    "DO without WHILE in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 DO1\nN20 END1", runs="", alarm="jump-in-mdi", number=numbers("123", "PS0123"),
)
case(
    "a program called from MDI may loop",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 WHILE[#1 LT 2]DO1
        N40 #1=#1+1
        N50 END1
        N60 M99
    """,
    mdi="N10 M98 P2", runs="N10 (N30 N40 N50)*2 N30 N60",
)

# M99: return

case(
    "M99 returns to the block behind the call, not to the call",
    control=ALL, source="GED, source 002, ROB", evidence="source document",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 M30
        O2
        N40 M99
        N50 T2
    """,
    runs="N10 N40 N20 N30", t=[1],
)
case(
    "a subprogram may have several M99",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 #1=1
        N20 M98 P2
        N30 #1=0
        N40 M98 P2
        N50 M30
        O2
        N60 IF[#1 EQ 1]GOTO80
        N70 M99
        N80 M99
    """,
    runs="N10 N20 N60 N80 N30 N40 N60 N70 N50",
)
case(
    "words in the M99 block run before the return",
    control=ALL, source="K-H general knowledge; WEI", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 T2
        N30 M30
        O2
        N40 T1 M99
    """,
    runs="N10 N40 N20 N30", t=[1, 2],
)
case(
    "words in the M99 block run in every repeat",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L3
        N20 M30
        O2
        N40 M99 T1
    """,
    runs="N10 N40*3 N20", t=[1, 1, 1],
)
case(
    "repeats start at the first block of the subprogram",
    control=ALL, source="GED, source 002, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L2
        N20 M30
        O2
        N30 T3
        N40 T4
        N50 M99
    """,
    runs="N10 (N30 N40 N50)*2 N20",
)
case(
    "repeats of a called program do not repeat the call inside it once only",
    control=ALL, source="GED, ROB", evidence="secondary",
    program="""
        O1
        N10 M98 P20002
        N20 M30
        O2
        N30 M98 P30003
        N40 M99
        O3
        N50 M99
    """,
    runs="N10 (N30 N50*3 N40)*2 N20", calls="M98:O2 M98:O3 M98:O3",
)
case(
    "a skipped M99 is passed and the next M99 returns",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        /N30 M99
        N40 T4
        N50 M99
    """,
    skip=(1,), runs="N10 N40 N50 N20", t=[4],
)
case(
    "a subprogram whose only M99 is skipped runs into its end",
    control=ALL, source="ALM PS5010; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
        /N40 M99
    """,
    skip=(1,), runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2",
)
case(
    "M30 in a nested subprogram ends the run",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 M30
        O2
        N40 M98 P3
        N50 M99
        O3
        N60 M30
        N70 M99
    """,
    runs="N10 N40 N60", t=[],
)
case(
    "M02 in a subprogram ends the run, repeats or not",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L5
        N20 M30
        O2
        N30 M02
        N40 M99
    """,
    runs="N10 N30",
)
case(
    "M30 in a macro ends the run",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 T1
        N30 M30
        O2
        N40 M30
        N50 M99
    """,
    runs="N10 N40", t=[],
)

# M99 P

case(
    "M99 P may return to a block before the call",
    control=ALL, source="source 003; GED, MC52", evidence="source document",
    program="""
        O1
        N10 #100=#100+1
        N20 M98 P2
        N30 M30
        O2
        N40 IF[#100 GE 2]GOTO60
        N50 M99 P10
        N60 M99
    """,
    runs="N10 N20 N40 N50 N10 N20 N40 N60 N30", vars={100: 2},
)
case(
    "M99 P may return to the calling block itself",
    control=ALL, source="source 003; GED", evidence="source document",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 IF[#100 GE 2]GOTO60
        N50 M99 P10
        N60 M99
    """,
    runs="N10 N30 N40 N50 N10 N30 N40 N60 N20", vars={100: 2},
)
case(
    "the P of M99 may be a variable",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=30
        N15 M98 P2
        N20 T1
        N30 M30
        O2
        N40 M99 P#100
    """,
    runs="N10 N15 N40 N30", t=[],
)
case(
    "the P of M99 may be an expression",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 M30
        O2
        N40 M99 P[10+20]
    """,
    runs="N10 N40 N30", t=[],
)
case(
    "a vacant P of M99 is no P",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N40 M99 P#100
    """,
    runs="N10 N40 N20",
)
case(
    "P may stand before M99",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 M30
        O2
        N40 P30 M99
    """,
    runs="N10 N40 N30", t=[],
)
case(
    "words in the M99 P block run before the return",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 M30
        O2
        N40 T4 M99 P30
    """,
    runs="N10 N40 N30", t=[4],
)
case(
    "M99 P looks in the caller even if the subprogram has the same N",
    control=ALL, source="source 003; GED, MC52", evidence="source document",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 M30
        O2
        N30 T2
        N40 M99 P30
    """,
    runs="O1:N10 O2:N30 O2:N40 O1:N30", t=[2],
)
case(
    "an N that only the subprogram has is no target for M99 P",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N50 T2
        N60 M99 P50
    """,
    alarm="return-target-not-found", number=numbers("078", "PS0078"), at="O2 N60", t=[2],
)
case(
    "an N that only the main program has is no target for M99 P of a nested subprogram",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M99 P20
    """,
    alarm="return-target-not-found", number=numbers("078", "PS0078"), at="O3 N50",
)
case(
    "M99 P leaves at once although repeats are left",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L3
        N20 T1
        N30 M30
        O2
        N40 #100=#100+1
        N50 M99 P30
    """,
    runs="N10 N40 N50 N30", vars={100: 1},
)
case(
    "words in an M99 P block run even if its target is missing",
    control=ALL, source="K-H general knowledge; ALM PS0078", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N40 T4 M99 P70
    """,
    runs="N10 N40", alarm="return-target-not-found", number=numbers("078", "PS0078"), at="O2 N40",
    t=[4],
)
case(
    "M99 P searches the caller from its start",
    control=ALL, source='policy; GED "first"', evidence="inferred",
    program="""
        O1
        N20 #100=#100+1
        N25 IF[#100 GE 2]GOTO40
        N10 M98 P2
        N20 T2
        N40 M30
        O2
        N50 M99 P20
    """,
    runs="N20 N25 N10 N50 N20 N25 N40", t=[],
)
case(
    "M99 P of a macro returns to a block of the macro's caller",
    control=ALL, source="source 003; PB304", evidence="source document",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 M30
        O2
        N40 G65 P3
        N50 T2
        N60 M99
        O3
        N70 M99 P60
    """,
    runs="N10 N40 N70 N60 N20 N30", t=[1],
)
case(
    "behind M99 P the level of the call is free again",
    control=ALL, source="source 003; MC52", evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 IF[#100 GT 12]GOTO40
        N30 M98 P2
        N40 M30
        O2
        N50 M99 P10
    """,
    runs="(N10 N20 N30 N50)*12 N10 N20 N40",
)

# M99 in the main program

case(
    "M99 in the main program starts it over",
    control=ALL, source="GED, source 003, WEI", evidence="source document",
    program="""
        O1
        N10 T1
        N20 M99
    """,
    max_cycles=3, runs="(N10 N20)*3", stop="cycles", t=[1, 1, 1],
)
case(
    "one pass of an endless main program is one cycle",
    control=ALL, source="GED; policy: max_cycles", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M99
        N30 T2
    """,
    runs="N10 N20", stop="cycles", t=[1],
)
case(
    "words in the M99 block of a main program run before it starts over",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 T2 M99
    """,
    max_cycles=2, runs="(N10 N20)*2", stop="cycles", t=[1, 2, 1, 2],
)
case(
    "calls work in every pass of an endless main program",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M99
        O2
        N30 M99
    """,
    max_cycles=2, runs="(N10 N30 N20)*2", stop="cycles",
)
case(
    "local variables keep their values when M99 starts the main program over",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=#1+1
        N20 M99
    """,
    max_cycles=4, runs="(N10 N20)*4", stop="cycles", vars={1: 4},
)
case(
    "M99 P in the main program jumps and never ends",
    control=ALL, source="source 003; GED, WEI", evidence="source document",
    program="""
        O1
        N10 T1
        N20 #100=#100+1
        N30 M99 P20
    """,
    max_cycles=100, max_blocks=5, runs="N10 (N20 N30)*2", stop="limit", vars={100: 2},
)
case(
    "M99 P in the main program may jump forward",
    control=ALL, source="source 003; GED", evidence="source document",
    program="""
        O1
        N10 T1
        N20 M99 P40
        N30 T3
        N40 M30
    """,
    max_cycles=100, runs="N10 N20 N40", t=[1],
)
case(
    "M99 P in the main program to a missing block alarms",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 M99 P70
        N30 M30
    """,
    max_cycles=100, alarm="return-target-not-found", number=numbers("078", "PS0078"), at="O1 N20",
    t=[1],
)
case(
    "/M99 loops the main program while the switch is off",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M99
        N30 M30
    """,
    max_cycles=2, runs="(N10 N20)*2", stop="cycles",
)
case(
    "/2 M99 loops the main program although switch 1 is on",
    control=ALL, source="K-H general knowledge; ISO", evidence="inferred",
    program="""
        O1
        N10 T1
        /2 N20 M99
        N30 M30
    """,
    skip=(1,), runs="N10 N20", stop="cycles",
)
case(
    "/M99 P in the main program jumps while the switch is off",
    control=ALL, source="GED; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        /N20 M99 P40
        N30 T3
        N40 M30
    """,
    max_cycles=100, runs="N10 N20 N40", t=[1],
)
case(
    "/M99 P in the main program is passed while the switch is on",
    control=ALL, source="GED; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        /N20 M99 P10
        N30 T3
        N40 M30
    """,
    skip=(1,), runs="N10 N30 N40", t=[1, 3],
)
case(
    "/M30 and M99 end the main program while the switch is off and loop it while it is on",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M30
        N30 M99
    """,
    skip=(1,), max_cycles=2, runs="(N10 N30)*2", stop="cycles",
)
case(
    "a subprogram started as the main program loops at its M99",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
        N40 M99
    """,
    main="O2", max_cycles=2, runs="(N30 N40)*2", stop="cycles",
)
case(
    "a subprogram started as the main program jumps inside itself by M99 P",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N50 T1
        N20 M30
        O2
        N30 T3
        N40 M99 P50
        N45 T4
        N50 M30
    """,
    main="O2", max_cycles=100, runs="N30 N40 N50", t=[3],
)
case(
    "with 7712#4=1 M99 in the main program alarms",
    control="fanuc-30i", source="ALM PS1018", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 M99
    """,
    params={"7712#4": 1}, alarm="return-in-main-program", number="PS1018", at="O1 N20", t=[1],
)
case(
    "with 7712#4=1 M99 P in the main program alarms",
    control="fanuc-30i", source="ALM PS1018", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 M99 P10
    """,
    params={"7712#4": 1}, alarm="return-in-main-program", number="PS1018", at="O1 N20", t=[1],
)
case(
    "with 7712#4=1 M99 in a subprogram returns as before",
    control="fanuc-30i", source="ALM PS1018", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"7712#4": 1}, runs="N10 N30 N20",
)
case(
    "with 7712#4=1 a skipped M99 in the main program alarms nothing",
    control="fanuc-30i", source="ALM PS1018; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M99
        N30 M30
    """,
    params={"7712#4": 1}, skip=(1,), runs="N10 N30",
)

# M99 L, M99 with words in a modal call

case(
    "M99 L0 drops the repeats that are left on the later FANUC controls",
    pins="return_with_l",
    control=NEW, source="ALM PS1093 names L as legal; K-L general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L5
        N20 M30
        O2
        N30 #100=#100+1
        N40 M99 L0
    """,
    runs="N10 N30 N40 N20", vars={100: 1},
)
case(
    "M99 L is ignored on the 16i",
    control="fanuc-16i", source="K-L general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L3
        N20 M30
        O2
        N30 #100=#100+1
        N40 M99 L0
    """,
    runs="N10 (N30 N40)*3 N20", vars={100: 3},
)
case(
    "M99 with a T code while a modal call is active alarms",
    control=NEW, source="ALM PS1093", evidence="secondary",
    program="""
        O1
        N10 G66 P3
        N20 M98 P2
        N30 G67
        N40 M30
        O2
        N50 T5 M99
        O3
        N60 M99
    """,
    runs="N10 N20", alarm="illegal-word-with-return", number="PS1093", at="O2 N50", t=[],
)
case(
    "M99 with an axis word in a modal macro alarms",
    control=NEW, source="ALM PS1093", evidence="secondary",
    program="""
        O1
        N10 G66 P3
        N20 G0 X1.
        N30 G67
        N40 M30
        O3
        N60 X5. M99
    """,
    runs="N10 N20", alarm="illegal-word-with-return", number="PS1093", at="O3 N60",
)
case(
    "M99 P while a modal call is active is legal",
    control=NEW, source="ALM PS1093", evidence="secondary",
    program="""
        O1
        N10 G66 P3
        N20 M98 P2
        N30 T1
        N40 G67
        N50 M30
        O2
        N60 M99 P40
        O3
        N70 M99
    """,
    runs="N10 N20 N60 N40 N50", t=[],
)
case(
    "M99 with a T code is legal again behind G67",
    control=NEW, source="ALM PS1093", evidence="secondary",
    program="""
        O1
        N10 G66 P3
        N20 G67
        N30 M98 P2
        N40 M30
        O2
        N50 T5 M99
        O3
        N60 M99
    """,
    runs="N10 N20 N30 N50 N40", t=[5],
)

# M198

case(
    "M198 calls a program of the external device",
    pins="external_calls",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30 N20", calls="M198:O2",
)
case(
    "L repeats an external call",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2 L3
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30*3 N20", calls="M198:O2",
)
case(
    "M198 reads the device although memory has a program of that number",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O2
        N40 M99
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30 N20",
)
case(
    "M98 reads memory although the device has a program of that number",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N40 M99
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N40 N20", calls="M98:O2",
)
case(
    "M98 does not find a program of the device",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, alarm="program-not-found", number=numbers("078", "PS0076"),
    at="O1 N10",
)
case(
    "M198 does not find a program of memory",
    control=NEW, source="ALM PS1079", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O2
        N40 M99
    """,
    external={"O3.NC": "O3\nM99\n"}, alarm="external-program-not-found", number="PS1079",
    at="O1 N10",
)
case(
    "a file that the device lacks alarms",
    control=NEW, source="ALM PS1079", evidence="secondary",
    program="""
        O1
        N10 T5 M198 P7
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10", alarm="external-program-not-found",
    number="PS1079", at="O1 N10", t=[5],
)
case(
    "an external program calls no external program, not even another one",
    control=NEW, source="ALM PS1080", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M198 P3\nN40 M99\n", "O3.NC": "O3\nN50 M99\n"},
    alarm="external-call-nested", number="PS1080", at="O2 N30", calls="M198:O2",
)
case(
    "a memory program called from an external one calls no external program",
    control=NEW, source="ALM PS1080, PS0077; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O4
        N60 M198 P3
        N70 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P4\nN40 M99\n", "O3.NC": "O3\nN50 M99\n"},
    alarm="external-call-nested", number="PS1080", at="O4 N60",
)
case(
    "a second external call after the first has returned is legal",
    control=ALL, source="ALM PS1080; CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M198 P2
        N40 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30 N20 N30 N40",
)
case(
    "an external program calls a program of memory",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N50 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN40 M99\n"}, runs="N10 N30 N50 N40 N20",
    calls="M198:O2 M98:O3",
)
case(
    "an external program calls a macro of memory",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N50 #100=#1
        N60 M99
    """,
    external={"O2.NC": "O2\nN30 G65 P3 A2.\nN40 M99\n"}, runs="N10 N30 N50 N60 N40 N20",
    vars={100: 2},
)
case(
    "words in the M198 block run before the call",
    control=ALL, source="CL198, PMI39; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T5 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 T6\nN40 M99\n"}, runs="N10 N30 N40 N20", t=[5, 6],
)
case(
    "an external program shares the local variables",
    control=ALL, source="PB304; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N15 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 #1=#1+1\nN40 M99\n"}, runs="N10 N15 N30 N40 N20", vars={1: 4},
)
case(
    "M99 P of an external program returns to a block of the caller",
    control=ALL, source="source 003; CL198", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 T1
        N25 M30
    """,
    external={"O2.NC": "O2\nN30 M99 P25\n"}, runs="N10 N30 N25", t=[],
)
case(
    "M99 P of an external program to a missing block alarms",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99 P77\n"}, alarm="return-target-not-found",
    number=numbers("078", "PS0078"), at="O2 N30",
)
case(
    "M30 in an external program ends the run",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 T1
        N25 M30
    """,
    external={"O2.NC": "O2\nN30 M30\n"}, runs="N10 N30", t=[],
)
case(
    "an external program without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 T3\n"}, runs="N10 N30", alarm="end-of-record",
    number=numbers("5010", "PS5010"), at="O2",
)
case(
    "M198 without P names no program",
    control=ALL, source="K-H 076; ALM PS0076", evidence="inferred",
    program="""
        O1
        N10 M198
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="program-number-missing",
    number=numbers("076", "PS0076"), at="O1 N10",
)
case(
    "a minus sign at the P of M198 is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M198 P-2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-minus-sign",
    number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "a point at the P of M198 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M198 P2.
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-decimal-point",
    number=numbers("007", "PS0007"), at="O1 N10",
)
case(
    "M198 is not sent to the machine",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M3
        N15 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N15 N30 N20", m=[3],
)
case(
    "parameter 6030 gives the external call another M code",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M150 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, params={"6030": 150}, runs="N10 N30 N20", calls="M198:O2",
    m=[],
)
case(
    "an external call counts as a level of M98 on the 16i",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N40 #100=#100+1
        N50 M98 P3
        N60 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN35 M99\n"}, alarm="nesting-too-deep", number="077",
    at="O3 N50", vars={100: 3},
)
case(
    "an external call counts as a level of M98",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N40 #100=#100+1
        N50 M98 P3
        N60 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN35 M99\n"}, alarm="nesting-too-deep", number="PS0077",
    at="O3 N50", vars={100: 9},
)

# More that alarms

case(
    "with 3403#6=1 two P in an M99 block alarm",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P20 P20
    """,
    params={"3403#6": 1}, runs="N10", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O2 N30",
)
case(
    "with 3403#6=1 two T codes in a block alarm before either goes out",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 T1 T2 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"3403#6": 1}, runs="", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O1 N10", t=[],
)
case(
    "an alarm in the second pass of a repeat leaves the first pass done",
    control=ALL, source="ALM PS0076; GED", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L3
        N20 M30
        O2
        N30 T3
        N40 #100=#100+1
        N50 IF[#100 LT 2]GOTO70
        N60 M98 P99
        N70 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O2 N60", vars={100: 2},
    t=[3, 3],
)
case(
    "a division by zero at the P of M98 alarms",
    control=ALL, source="ALM PS0112; K-H 112", evidence="secondary",
    program="""
        O1
        N10 M98 P[2/0]
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "a variable that does not exist at the P of M98 alarms",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 M98 P#40
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
)
case(
    "a variable that does not exist at the L of M98 alarms",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L#40
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
)
case(
    "a variable that does not exist at the P of M99 alarms",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3 M99 P#40
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O2 N30", t=[],
)
case(
    "the square root of a negative value at the P of M98 alarms",
    control=ALL, source="ALM PS0119; K-H 119", evidence="secondary",
    program="""
        O1
        N10 M98 P[SQRT[-4]]
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="square-root-of-negative", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "six brackets deep at the P of M98 is too deep",
    control=ALL, source="ALM PS0118, X-NUL", evidence="secondary",
    program="""
        O1
        N10 M98 P[[[[[[2]]]]]]
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N10",
)
case(
    "a bracket at the P of M98 that is not closed alarms",
    control=ALL, source="ALM PS1132; K-H 125", evidence="secondary",
    program="""
        O1
        N10 M98 P[1+1
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N10",
)
case(
    "a faulty block of a subprogram alarms in the subprogram",
    control=ALL, source="ALM PS0005; policy: a control reads a block when it reaches it",
    evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
        N40 G0 X
        N50 M99
    """,
    runs="N10 N30", alarm="address-without-value", number=numbers("005", "PS0005"), at="O2 N40",
    t=[3],
)
case(
    "a faulty block behind the executed M99 alarms nothing, before it it does",
    control=ALL, source="ALM PS0007; policy: a control reads a block when it reaches it",
    evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M98 P3
        N30 M30
        O2
        N40 M99
        N50 M3.
        O3
        N60 M3.
        N70 M99
    """,
    runs="N10 N40 N20", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O3 N60",
)
case(
    "an unknown character in a subprogram alarms when its block is reached",
    control=ALL, source="policy; ALM PS0009", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
        N40 T4 $
        N50 M99
    """,
    runs="N10 N30", alarm="illegal-character", number=numbers("009", "PS0009"), at="O2 N40", t=[3],
)
case(
    "a subprogram of a subprogram without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 T5
    """,
    runs="N10 N30 N50", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O3", t=[5],
)
case(
    "M99 P back into a main program without M30 runs into its end",
    control=ALL, source="ALM PS5010; source 003", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 T1
        N30 T2
        O2
        N40 M99 P30
    """,
    runs="N10 N40 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[2],
)
case(
    "a GOTO past the M30 runs into the end of the program",
    control=ALL, source="ALM PS5010; X-GO", evidence="secondary",
    program="""
        O1
        N10 GOTO30
        N20 M30
        N30 T3
    """,
    runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[3],
)
case(
    "a subprogram called from MDI without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 T3
    """,
    mdi="N10 M98 P2", runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"),
    at="O2",
)
case(
    "a minus sign at the P of M98 is illegal in MDI",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 M98 P-2", runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"),
)
case(
    "M98 without P names no program in MDI",
    control=ALL, source="K-H 076; ALM PS0076", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 T1\nN20 M98", runs="N10", alarm="program-number-missing",
    number=numbers("076", "PS0076"), t=[1],
)
case(
    "calls from MDI run out of levels as calls from memory do",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O2
        N30 #100=#100+1
        N40 M98 P2
        N50 M99
    """,
    mdi="M98 P2", alarm="nesting-too-deep", number="PS0077", at="O2 N40", vars={100: 10},
)
case(
    "a minus sign at the L of M198 is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M198 P2 L-3
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-minus-sign",
    number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "the P of M198 without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M198 P
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="address-without-value",
    number=numbers("005", "PS0005"), at="O1 N10",
)
case(
    "with 3403#6=1 two P in an M198 block alarm",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 M198 P2 P3
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, params={"3403#6": 1}, runs="", alarm="address-given-twice",
    number=numbers("5074", "PS5074"), at="O1 N10",
)
case(
    "a program of memory that an external program misses alarms in the external program",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN40 M99\n", "O3.NC": "O3\nN50 M99\n"},
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O2 N30",
)
case(
    "a faulty block of an external program alarms in the external program",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 T3\nN40 X\nN50 M99\n"}, runs="N10 N30",
    alarm="address-without-value", number=numbers("005", "PS0005"), at="O2 N40",
)
case(
    "a Q that only the main program has is not found from a subprogram",
    control=LATE, source="ALM PS0078; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        N70 M99
        O2
        N30 M98 Q70
        N40 M99
    """,
    params={"6005#0": 1}, alarm="start-not-found", number="PS0078", at="O2 N30",
)
case(
    "a local subprogram without M99 runs into the end of its program",
    control=LATE, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 T5
    """,
    params={"6005#0": 1}, runs="N10 N100", alarm="end-of-record", number="PS5010", at="O1", t=[5],
)
case(
    "M99 P of a local subprogram to a missing block alarms",
    control=LATE, source="ALM PS0078; source 003", evidence="secondary",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 M99 P77
    """,
    params={"6005#0": 1}, alarm="return-target-not-found", number="PS0078", at="O1 N100",
)
case(
    "M98 with G91 in a canned cycle alarms",
    control=NEW, source="ALM PS5329", evidence="secondary",
    program="""
        O1
        N10 G81 X1. Z-9. R1. F100
        N20 G91 M98 P2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="call-with-words-in-cycle", number="PS5329", at="O1 N20",
)
case(
    "a canned cycle that a subprogram leaves active forbids words beside the next M98",
    control=NEW, source="ALM PS5329; source 003, modal G codes", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 X5. M98 P2
        N30 M30
        O2
        N40 G81 X1. Z-9. R1. F100
        N50 M99
    """,
    runs="N10 N40 N50", alarm="call-with-words-in-cycle", number="PS5329", at="O1 N20",
)
