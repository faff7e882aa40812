"""FANUC: G65, its P and L, local variables, levels."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


# G65: the call

case(
    "G65 calls a macro and goes on after the call",
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
    "P and L may stand after the arguments of G65",
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
    "a calling M code after G65 is an argument, not a call",
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
    "the loop of a caller goes on after a macro call",
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
    "an argument that is left out is vacant in the macro, and the caller keeps its own (F212)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304; VAC",
    evidence="maker's manual",
    program="""
        O1
        #1=99
        G65 P2 B5.
        #102=#1
        M30
        O2
        #100=#1
        #101=#2
        #1=7
        M99
    """,
    vars={100: None, 101: 5, 102: 99, 1: 99},
)

case(
    "a second G65 does not inherit the locals of the first (F213)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304; VAC",
    evidence="maker's manual",
    program="""
        O1
        G65 P2 A1.
        G65 P2 B2.
        M30
        O2
        #100=#1
        #101=#2
        #10=5
        #102=#10
        M99
    """,
    vars={100: None, 101: 2, 102: 5},
)

case(
    "every macro level gives its caller's locals back (F219)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304",
    evidence="maker's manual",
    program="""
        O1
        #1=1
        G65 P2 A2.
        #100=#1
        M30
        O2
        G65 P3 A3.
        #101=#1
        M99
        O3
        G65 P4 A4.
        #102=#1
        M99
        O4
        #103=#1
        #1=44
        M99
    """,
    vars={100: 1, 101: 2, 102: 3, 103: 4},
)

case(
    "four levels of G65 are legal (F221)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="PB304",
    evidence="maker's manual",
    program="""
        O1
        G65 P2
        N9 M30
        O2
        G65 P3
        M99
        O3
        G65 P4
        M99
        O4
        G65 P5
        M99
        O5
        #100=4
        M99
    """,
    runs="N9",
    vars={100: 4},
)

case(
    "a macro that calls itself runs four times on the 16i (F222)",
    control="fanuc-16i",
    source="PB304; 077: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2
        M30
        O2
        #100=#100+1
        G65 P2
        M99
    """,
    vars={100: 4},
    alarm="macro-nesting-too-deep",
    number="077",
    at="O2",
)

case(
    "a macro that calls itself runs five times on the 0i-D and the 30i (F222)",
    control=["fanuc-0i-d", "fanuc-30i"],
    source="ALM PS0122; five levels: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2
        M30
        O2
        #100=#100+1
        G65 P2
        M99
    """,
    vars={100: 5},
    alarm="macro-nesting-too-deep",
    number="PS0122",
    at="O2",
)

case(
    "four levels of M98 and four of G65 are eight legal levels on the 16i (F223)",
    pins="max_total_nesting",
    control="fanuc-16i",
    source="RW; PB304; MC52",
    evidence="secondary",
    program="""
        O1
        M98 P11
        N9 M30
        O11
        M98 P12
        M99
        O12
        M98 P13
        M99
        O13
        M98 P14
        M99
        O14
        G65 P15
        M99
        O15
        G65 P16
        M99
        O16
        G65 P17
        M99
        O17
        G65 P18
        M99
        O18
        #100=8
        M99
    """,
    runs="N9",
    vars={100: 8},
)

case(
    "M99 P30 leaves a macro to N30 of the caller and gives the caller's locals back (F224)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99 Pn; MC52; PB304",
    evidence="source document",
    program="""
        O1
        #1=1
        N10 G65 P2 A9.
        N20 #100=20
        N30 #101=#1
        N40 M30
        O2
        N50 M99 P30
    """,
    runs="N10 N50 N30 N40",
    vars={100: None, 101: 1},
)

case(
    "G65 without a P alarms (F225)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0076; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G65 A1.
        M30
    """,
    alarm="program-number-missing",
    number={"fanuc-16i": "076", "fanuc-30i": "PS0076"},
    at="O1",
)
