"""FANUC: M98, its P with a count, its L, names, the order in its block, its errors."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]
OLD = ["fanuc-16i", "fanuc-0i-d"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


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

# M98: order in the block, shared variables, no word goes to the machine

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
    pins="refuses:call-with-words-in-cycle",
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
    "M98 with an axis word is legal again after G80",
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

case(
    "M99 returns after the call (F101)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="source 002, return; GED; ROB",
    evidence="source document",
    program="""
        O1
        N10 M98 P1010
        N20 M30
        O1010
        N1020 #100=5
        N1030 M99
    """,
    runs="N10 N1020 N1030 N20",
    vars={100: 5},
)

case(
    "M98 P21010 runs O1010 twice, and M98 P1010 once (F102)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        N10 #100=0
        N20 #101=0
        N30 M98 P21010
        N40 #101=1
        N50 M98 P1010
        N60 M30
        O1010
        N1020 #100=#100+1
        N1060 M99
    """,
    runs="N10 N20 N30 N1020 N1060 N1020 N1060 N40 N50 N1020 N1060 N60",
    vars={100: 3, 101: 1},
)

case(
    "M98 P51002 runs O1002 five times (F103)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        #100=0
        M98 P51002
        M30
        O1002
        #100=#100+1
        M99
    """,
    vars={100: 5},
)

case(
    "M98 P68003 runs O8003 six times (F104)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ROB",
    evidence="secondary",
    program="""
        O1
        M98 P68003
        M30
        O8003
        #100=#100+1
        M99
    """,
    vars={100: 6},
)

case(
    "M98 P5001 runs O5001 once, and P50002 runs O2 five times (F105)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        M98 P5001
        M98 P50002
        M30
        O5001
        #100=#100+1
        M99
        O2
        #101=#101+1
        M99
    """,
    vars={100: 1, 101: 5},
)

case(
    "M98 P100100 runs O100 ten times (F106)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        M98 P100100
        M30
        O100
        #100=#100+1
        M99
    """,
    vars={100: 10},
)

case(
    "with an L, all five digits of P are the program number (F108)",
    control=["fanuc-0i-f", "fanuc-30i"],
    source="CL198; CW-S; general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98 P12345 L2
        M30
        O12345
        #100=#100+1
        M99
        O2345
        #100=#100+100
        M99
    """,
    vars={100: 2},
)

case(
    "the move of an M98 block comes before the call, and that of an M99 block before the return (F109)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="PMI39 (b); 17W",
    evidence="maker's manual",
    program="""
        O1
        G90 G0 X0
        N10 X10. M98 P200
        N20 X20.
        M30
        O200
        N30 #100=#5001
        N40 X99. M99
    """,
    runs="N10 N30 N40 N20",
    vars={100: 10},
    moves="""
        R X0
        R X10
        R X99
        R X20
    """,
)

case(
    "G91 set in a subprogram still holds after the call (F110)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, note on modal G codes",
    evidence="source document",
    program="""
        O1
        G90 G0 X10.
        M98 P200
        X10.
        M30
        O200
        G91
        M99
    """,
    moves="""
        R X10
        R X20
    """,
)

case(
    "M98 shares the local variables with its caller (F111)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304; RW",
    evidence="maker's manual",
    program="""
        O1
        #1=7
        M98 P200
        #100=#1
        M30
        O200
        #101=#1
        #1=8
        M99
    """,
    vars={100: 8, 101: 7, 1: 8},
)

case(
    "M98 to a program that is not in the memory alarms (F115)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="ALM PS0076; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        N10 M98 P4711
        M30
    """,
    alarm="program-not-found",
    number={"fanuc-16i": "078", "fanuc-0i-d": "PS0076", "fanuc-30i": "PS0076"},
    at="O1 N10",
)

case(
    "M98 without a P alarms (F116)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98
        M30
    """,
    alarm="program-number-missing",
    number={"fanuc-16i": "076", "fanuc-30i": "PS0076"},
    at="O1",
)

case(
    "M98 with the name of a program that is not there alarms (F128)",
    control="fanuc-30i",
    source="ALM PS0310",
    evidence="secondary",
    program="""
        O1
        M98 <NOTHERE>
        M30
    """,
    alarm="named-program-not-found",
    number="PS0310",
    at="O1",
)

case(
    "M98 with an X while a canned cycle is active alarms (F131)",
    control="fanuc-30i",
    source="ALM PS5329",
    evidence="secondary",
    program="""
        O1
        G81 X1. Z-1. R1. F100
        X2. M98 P2
        M30
        O2
        M99
    """,
    alarm="call-with-words-in-cycle",
    number="PS5329",
    at="O1",
)

case(
    "M98 and M03 in one block alarm (F132)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS5016; which codes stand alone: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M03 M98 P2
        M30
        O2
        M99
    """,
    alarm="illegal-m-combination",
    number={"fanuc-16i": "5016", "fanuc-30i": "PS5016"},
    at="O1",
)
