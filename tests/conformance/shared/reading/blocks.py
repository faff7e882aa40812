"""Reading of NC text: sequence numbers and block skip."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
WITH_O = FANUC + GSK_988 + GSK_980 + MITSUBISHI  # programs are named O1
WITH_PERCENT = ["hnc-21m", "gsk-928te"]  # programs are named %1


def on_fanuc(number):
    """Return the alarm as each FANUC shows it: 005 on the 16i, PS0005 on the others."""
    return {c: f"{number:03d}" if c == "fanuc-16i" else f"PS{number:04d}" for c in FANUC}


def everywhere(claim, text, **expected):
    """Write one row for the controls whose programs have an O, one for those with a %.

    `text` is the only file of the memory, in bytes, with HEAD for the head of the program.
    """
    for head, controls in ((b"O1", WITH_O), (b"%1", WITH_PERCENT)):
        case(
            f"{claim}, programs headed {head.decode()}",
            control=controls, files={"O1.NC": text.replace(b"HEAD", head)}, **expected,
        )


POLICY = "general knowledge"
PLAIN = {"source": POLICY, "evidence": "inferred", "runs": "N10 N20 N30", "m": [8, 9]}

everywhere("blocks need no sequence number", b"HEAD\nM8\nM9\nN30 M30\n",
           source="PB155, N", evidence="inferred", runs="N30", m=[8, 9])
everywhere("sequence numbers may stand in any order", b"HEAD\nN30 M8\nN10 M9\nN20 M30\n",
           source="PB155, N", evidence="inferred", runs="N30 N10 N20", m=[8, 9])
everywhere("a sequence number may come twice", b"HEAD\nN10 M8\nN10 M9\nN30 M30\n",
           source="PB155, N", evidence="inferred", runs="N10 N10 N30", m=[8, 9])
everywhere("leading zeros of a sequence number are no difference",
           b"HEAD\nN0010 M8\nN00020 M9\nN030 M30\n", **PLAIN)
case(
    "a sequence number alone is a block that can be jumped to",
    control=FANUC + MITSUBISHI, source="general knowledge, GOTO", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 M8
        N30
        N40 M30
    """,
    runs="N10 N30 N40", m=[],
)
case(
    "a sequence number after another word is 006 on the GSK 980",
    pins="refuses:sequence-number-not-first",
    control=GSK_980, source="MDia 006", evidence="maker's manual",
    program="""
        O1
        N10 M8
        M9 N20
        N30 M30
    """,
    runs="N10", m=[8], alarm="sequence-number-not-first", number="0006",
)
case(
    "a sequence number above 99999 is 006 on the GSK 980",
    control=GSK_980, source="MDia 006", evidence="maker's manual",
    program="""
        O1
        N10 M8
        N100000 M9
        N30 M30
    """,
    runs="N10", m=[8], alarm="illegal-sequence-number", number="0006",
)

SKIP = "ISO, block delete 1 to 9; general knowledge"

everywhere("a slash block does not run when switch 1 is on",
           b"HEAD\nN10 M8\n/N20 M3\nN25 M9\nN30 M30\n", source=SKIP, evidence="inferred",
           skip=(1,), runs="N10 N25 N30", m=[8, 9])
everywhere("a slash block runs when the switch is off",
           b"HEAD\nN10 M8\n/N20 M9\nN30 M30\n", source=SKIP, evidence="inferred",
           runs="N10 N20 N30", m=[8, 9])

NUMBERED = FANUC + MITSUBISHI

case(
    "/1 belongs to switch 1 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/1 N10 M8\n/2 N20 M9\nN30 M30",
    skip=(1,), runs="N20 N30", m=[9],
)
case(
    "/2 belongs to switch 2 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/2 N10 M8\n/3 N20 M9\nN30 M30",
    skip=(2,), runs="N20 N30", m=[9],
)
case(
    "/3 belongs to switch 3 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/3 N10 M8\n/4 N20 M9\nN30 M30",
    skip=(3,), runs="N20 N30", m=[9],
)
case(
    "/4 belongs to switch 4 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/4 N10 M8\n/5 N20 M9\nN30 M30",
    skip=(4,), runs="N20 N30", m=[9],
)
case(
    "/5 belongs to switch 5 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/5 N10 M8\n/6 N20 M9\nN30 M30",
    skip=(5,), runs="N20 N30", m=[9],
)
case(
    "/6 belongs to switch 6 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/6 N10 M8\n/7 N20 M9\nN30 M30",
    skip=(6,), runs="N20 N30", m=[9],
)
case(
    "/7 belongs to switch 7 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/7 N10 M8\n/8 N20 M9\nN30 M30",
    skip=(7,), runs="N20 N30", m=[9],
)
case(
    "/8 belongs to switch 8 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/8 N10 M8\n/9 N20 M9\nN30 M30",
    skip=(8,), runs="N20 N30", m=[9],
)
case(
    "/9 belongs to switch 9 and to no other",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="O1\n/9 N10 M8\n/1 N20 M9\nN30 M30",
    skip=(9,), runs="N20 N30", m=[9],
)
case(
    "/1 and a bare slash are the same switch",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="""
        O1
        /N10 M8
        /1 N20 M9
        N30 M30
    """,
    skip=(1,), runs="N30", m=[],
)
case(
    "a block with /1/3 is skipped when either switch is on",
    control=FANUC, source=SKIP, evidence="inferred",
    program="""
        O1
        /1/3 N10 M8
        /1/2 N20 M9
        N30 M30
    """,
    skip=(3,), runs="N20 N30", m=[9],
)
case(
    "several switches may be on together",
    control=NUMBERED, source=SKIP, evidence="inferred",
    program="""
        O1
        /2 N10 M8
        /3 N20 M9
        /4 N25 M7
        N30 M30
    """,
    skip=(2, 4), runs="N20 N30", m=[9],
)
case(
    "the slash may stand after the sequence number",
    control=FANUC + MITSUBISHI, source="GED, slash before and after N", evidence="secondary",
    program="""
        O1
        N10 /2 M8
        N20 M9
        N30 M30
    """,
    skip=(2,), m=[9],
)
case(
    "on FANUC a slash inside a block takes only the rest of the block away",
    control=FANUC, source="general knowledge, slash not at the head", evidence="inferred",
    program="""
        O1
        N10 T5 /M8
        N20 M9
        N30 M30
    """,
    skip=(1,), runs="N10 N20 N30", t=[5], m=[9],
)
case(
    "on FANUC a slash inside a block does nothing when the switch is off",
    control=FANUC, source="general knowledge, slash not at the head", evidence="inferred",
    program="""
        O1
        N10 T5 /M8
        N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", t=[5], m=[8, 9],
)
case(
    "a slash in an expression is a division, whatever the switch says",
    control=FANUC + MITSUBISHI + GSK_988, source="general knowledge, slash in an expression",
    evidence="inferred",
    program="""
        O1
        N10 #100=8/2
        N20 #101=[9/3]/2
        N30 M30
    """,
    skip=(1,), runs="N10 N20 N30", vars={100: 4, 101: 1.5},
)
case(
    "a fault in a skipped block raises nothing",
    control=FANUC + MITSUBISHI + GSK_988, source=SKIP, evidence="inferred",
    program="""
        O1
        N10 M8
        /N20 M98 P M-3 X1.2.3
        N30 M30
    """,
    skip=(1,), runs="N10 N30",
)
case(
    "a skipped M30 lets the program run into its end",
    control=FANUC, source="ALM 5010, END OF RECORD", evidence="inferred",
    program="""
        O1
        N10 M8
        /N20 M30
    """,
    skip=(1,), runs="N10", alarm="end-of-record", number=on_fanuc(5010),
)
case(
    "a slash in a comment skips nothing",
    control=WITH_O, source=POLICY, evidence="inferred",
    program="""
        O1
        N10 M8 (/2 A)
        (/) N20 M9
        N30 M30
    """,
    skip=(1, 2), runs="N10 N20 N30", m=[8, 9],
)
