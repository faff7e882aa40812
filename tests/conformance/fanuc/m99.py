"""FANUC: M99, the return, and M99 P and L."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


# M99: return

case(
    "M99 returns to the block after the call, not to the call",
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
    "after M99 P the level of the call is free again",
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
    "M99 with a T code is legal again after G67",
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
    "a faulty block after the executed M99 alarms nothing, before it it does",
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
    "M99 P30 returns to N30 of the calling program (F117)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="source 003, M99 Pn; GED; MC52",
    evidence="source document",
    program="""
        O1
        N10 M98 P1010
        N20 #100=20
        N30 #101=30
        N40 M30
        O1010
        N1020 M99 P30
    """,
    runs="N10 N1020 N30 N40",
    vars={100: None, 101: 30},
)

case(
    "M99 P returns to the caller's N50, not to the main program's (F119)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99 Pn; GED; MC52",
    evidence="source document",
    program="""
        O1
        N10 M98 P2
        N50 #100=50
        N60 M30
        O2
        N20 M98 P3
        N50 #101=50
        N51 M99
        O3
        N30 M99 P50
    """,
    runs="O1:N10 O2:N20 O3:N30 O2:N50 O2:N51 O1:N50 O1:N60",
    vars={100: 50, 101: 50},
)
