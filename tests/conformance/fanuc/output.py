"""FANUC: messages (#3000, #3006) and output (DPRNT, BPRNT)."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


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
    pins="prints_leading_blanks", control=ALL, source="K-M general knowledge", evidence="inferred",
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
    "DPRNT puts out a minus sign after the letter",
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
    "#3000=1 after a true condition stops with the alarm 3001 (F534)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; 3000+n: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        N10 IF[#1 EQ #0] THEN #3000=1(MISSING DIAMETER)
        N20 M30
    """,
    runs="N10",
    alarm="user-alarm",
    number={"fanuc-16i": "3001", "fanuc-30i": "MC3001"},
    at="O1 N10",
)

case(
    "with 6008#1 at 1, #3000=1 stops with the alarm 1 (F535)",
    control="fanuc-30i",
    source="6008#1 MCA: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        #3000=1(ALARM MESSAGE)
        M30
    """,
    params={"6008#1": 1},
    alarm="user-alarm",
    number="MC0001",
    at="O1",
)
