"""FANUC: calls by G, M, T, S, B and ASCII codes."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


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
    pins="unlisted_codes",
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
    "parameters 6041 to 6043 make a range of G codes with one decimal call a range of programs",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G90.2 A1.
        N20 G0 X1.
        N30 M30
        O4002
        N40 M99
    """,
    params={"6041": 900, "6042": 4000, "6043": 100}, runs="N10 N40 N20 N30", calls="G-code:O4002",
    arguments={1: 1},
)
case(
    "G90 is a code of the range of 6041 to 6043 that begins at 900",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G90
        N20 M30
        O4000
        N30 M99
    """,
    params={"6041": 900, "6042": 4000, "6043": 1}, runs="N10 N30 N20", calls="G-code:O4000",
)
case(
    "the range of 6038 to 6040 holds whole G codes: G200.1 calls nothing",
    control=NEW, source="K-M general knowledge; ALM PS0010", evidence="inferred",
    program="""
        O1
        N10 G200.1
        N20 M30
        O3000
        N30 M99
    """,
    params={"6038": 200, "6039": 3000, "6040": 3}, runs="", alarm="g-code-not-available",
    number="PS0010", word="G200.1",
)
case(
    "with 6007#3=1 a negative number of 6050 calls for every block, as G66.1",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G70 A1.
        N20 M8
        N30 G67
        N40 M30
        O9010
        N50 #100=#100+1
        N60 M99
    """,
    params={"6050": -70, "6007#3": 1}, runs="N10 N20 N50 N60 N30 N40", vars={100: 1},
)
case(
    "with 6007#3=0 a negative number of 6050 calls after moves, as G66",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G70 A1.
        N20 M8
        N30 G0 X1.
        N40 G67
        N50 M30
        O9010
        N60 #100=#100+1
        N70 M99
    """,
    params={"6050": -70}, runs="N10 N20 N30 N60 N70 N40 N50", vars={100: 1},
)
case(
    "a G code after the range of 6038 to 6040 calls nothing",
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
    "an M code after the range of 6044 to 6046 goes to the machine",
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
    "a second G code after a calling G code is refused as an argument",
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
    "M50 set in 6080 calls O9020 with arguments, and is not sent to the machine (F402)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, PRM6080=50",
    evidence="source document",
    program="""
        O1
        #1=9
        M50 A1. B2.
        #103=#1
        M30
        O9020
        #100=#1
        #101=#2
        M99
    """,
    params={"6080": 50},
    vars={100: 1, 101: 2, 103: 9},
    m=[],
    arguments={1: 1, 2: 2},
)

case(
    "M60 set in 6071 calls O9001 after the move, with the caller's locals (F403)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, PRM6071=60; PMI39",
    evidence="source document",
    program="""
        O1
        #1=9
        N10 G0 X5. M60
        M30
        O9001
        #100=#1
        #101=#5001
        M99
    """,
    params={"6071": 60},
    vars={100: 9, 101: 5},
    m=[],
)

case(
    "T23 calls O9000 with 23 in #149, and T inside it is a tool (F404)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, PRM6001.5=1; PMI39",
    evidence="source document",
    program="""
        O1
        T23
        M30
        O9000
        #100=#149
        T#149
        M6
        M99
    """,
    params={"6001#5": 1},
    vars={100: 23, 149: 23},
    m=[6],
    t=[23],
)

case(
    "the calling G code inside its own macro is the ordinary code (F405)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G81 X1.
        M30
        O9010
        #100=#24
        N10 G81 X2. Z-1. R1. F100
        N20 G80
        M99
    """,
    params={"6050": 81},
    runs="N10 N20",
    vars={100: 1},
)

case(
    "M60 inside the program it calls goes to the machine (F406)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M60
        M30
        O9001
        #100=#100+1
        M60
        M99
    """,
    params={"6071": 60},
    vars={100: 1},
    m=[60],
)

case(
    "an M code that calls is ordinary inside a macro called by a G code (F407)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G70
        M30
        O9010
        M60
        #100=1
        M99
        O9001
        #100=99
        M99
    """,
    params={"6050": 70, "6071": 60},
    vars={100: 1},
    m=[60],
)

case(
    "G65 and M98 call inside a macro called by a G code (F408)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G70 A1.
        M30
        O9010
        G65 P2 A5.
        M98 P3
        #102=#1
        M99
        O2
        #100=#1
        M99
        O3
        #101=#1
        M99
    """,
    params={"6050": 70},
    vars={100: 5, 101: 1, 102: 1},
)

case(
    "6038 to 6040 let G905 call O1005 (F409)",
    control="fanuc-30i",
    source="6038 to 6040: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G905 A7.
        M30
        O1005
        #100=#1
        M99
    """,
    params={"6038": 900, "6039": 1000, "6040": 100},
    vars={100: 7},
)

case(
    "a calling M code whose program is missing alarms (F410)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0076; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M60
        M30
    """,
    params={"6071": 60},
    alarm="program-not-found",
    number={"fanuc-16i": "078", "fanuc-30i": "PS0076"},
    at="O1",
)
