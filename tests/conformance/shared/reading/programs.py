"""Reading of NC text: heads and names of programs, duplicates."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_NAMES = ["fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
WITH_O = FANUC + GSK_988 + GSK_980 + MITSUBISHI  # programs are named O1
HNC = "hnc-21m"


def on_fanuc(number):
    """Return the alarm as each FANUC shows it: 005 on the 16i, PS0005 on the others."""
    return {c: f"{number:03d}" if c == "fanuc-16i" else f"PS{number:04d}" for c in FANUC}


POLICY = "general knowledge"

# Heads and names

case(
    "several O programs in one text are several programs",
    control=WITH_O, source="GED, file frame", evidence="inferred",
    program="""
        O1
        N10 M98 P22
        N20 M30
        O22
        N30 M8
        N40 M99
    """,
    runs="N10 N30 N40 N20", calls="M98:O22",
)
case(
    "percent signs between programs part them like their heads do",
    control=WITH_O, source="GED, file frame", evidence="inferred",
    program="""
        %
        O1
        N10 M98 P22
        N20 M30
        %
        O22
        N30 M8
        N40 M99
        %
    """,
    runs="N10 N30 N40 N20",
)
case(
    "a program does not run on into the program after it",
    control=FANUC, source="ALM 5010, END OF RECORD", evidence="inferred",
    program="""
        O1
        N10 M8
        O22
        N30 M9
        N40 M30
    """,
    runs="N10", m=[8], alarm="end-of-record", number=on_fanuc(5010),
)
case(
    "a colon is an O on FANUC",
    control=FANUC, source="general knowledge, :nnnn", evidence="inferred",
    program="""
        :1
        N10 M98 P22
        N20 M30
        :0022
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a colon is an O on Mitsubishi and GSK too",
    control=GSK_988 + GSK_980 + MITSUBISHI, source=POLICY, evidence="inferred",
    program="""
        :1
        N10 M98 P22
        N20 M30
        :22
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "leading zeros of an O are no difference",
    control=WITH_O, source="GED, leading zeros", evidence="inferred",
    program="""
        O0001
        N10 M98 P22
        N20 M30
        O0022
        N30 M99
    """,
    main="O1", runs="N10 N30 N20", calls="M98:O0022",
)
case(
    "a title after the O is a comment",
    control=WITH_O, source="GED, comment after the O", evidence="secondary",
    program="""
        O1 (MAIN M98 P99)
        N10 M98 P22
        N20 M30
        O22(SUB)
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "words after the O on its line are a block of the program",
    control=FANUC, source=POLICY, evidence="inferred",
    program="""
        O1 M8
        N10 M9
        N20 M30
    """,
    runs="N10 N20", m=[8, 9],
)
case(
    "a space between O and its number is no difference",
    control=WITH_O, source="GED, spaces", evidence="inferred",
    program="""
        O 1
        N10 M98 P22
        N20 M30
        O 22
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a name in angle brackets heads a program and is called",
    control=FANUC_NAMES, source="general knowledge, <name>", evidence="inferred",
    program="""
        <MAIN>
        N10 M98 <POCKET_2>
        N20 M30
        <POCKET_2>
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a name in angle brackets takes L",
    control=FANUC_NAMES, source="general knowledge, M98 <name> L", evidence="inferred",
    program="""
        O1
        N10 M98 <POCKET> L3
        N20 M30
        <POCKET>
        N30 M99
    """,
    runs="N10 N30*3 N20",
)
case(
    "the name <O22> is program number 22",
    control=FANUC_NAMES, source="general knowledge, <O123>", evidence="inferred",
    program="""
        O1
        N10 M98 P22
        N20 M30
        <O22>
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a name that nobody has is PS0310",
    control=FANUC_NAMES, source="ALM PS0310", evidence="secondary",
    program="""
        O1
        N10 M98 <POCKET>
        N20 M30
        <POCKETS>
        N30 M99
    """,
    runs="", alarm="named-program-not-found", number="PS0310", at="O1 N10",
)
case(
    "a name whose bracket is not closed is PS0311",
    control=FANUC_NAMES, source="ALM PS0311", evidence="secondary",
    program="""
        O1
        N10 M98 <POCKET L2
        N20 M30
        <POCKET>
        N30 M99
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a file without a head has its file's name: P[T0023] finds T0023.CNC",
    control="gsk-988ta", source="source 000, P[T0023]", evidence="source document",
    files={"O0001.CNC": "O0001\nN10 M98 P[T0023] L2\nN20 M30\n", "T0023.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30*2 N20",
)
case(
    "a name with all its legal characters is found",
    control="gsk-988ta", source="source 000, names", evidence="source document",
    files={"O0001.CNC": "O0001\nN10 M98 P[A+b-1_2.3]\nN20 M30\n", "A+b-1_2.3.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30 N20",
)
case(
    "a name whose file is not there is 083",
    control="gsk-988ta", source="source 000, note 3; Talm 83", evidence="inferred",
    files={"O0001.CNC": "O0001\nN10 M98 P[T0024] L2\nN20 M30\n", "T0023.CNC": "N30 M99\n"},
    main="O1", runs="", alarm="named-program-not-found", number="083", at="O0001 N10",
)
case(
    "the 988TA takes no Chinese letters in a name",
    pins="wide_names",
    control="gsk-988ta", source="source 000, other characters alarm", evidence="source document",
    files={"O0001.CNC": "O0001\nN10 M98 P[\u87ba\u7eb9]\nN20 M30\n",
           "\u87ba\u7eb9.CNC": "N30 M99\n"},
    main="O1", runs="", alarm="illegal-program-name", number=None, at="O0001 N10",
)
case(
    "the 980TDi calls a file with a Chinese name",
    pins="wide_names",
    control="gsk-980tdi", source="TDi15", evidence="maker's manual",
    files={"O0001.CNC": "O0001\nN10 M98 P[\u5916\u5706] L2\nN20 M30\n",
           "\u5916\u5706.CNC": "N30 M99\n"},
    params={"878": 1}, main="O1", runs="N10 N30*2 N20",
)
case(
    "the 980TDi finds a Chinese name written in GBK",
    control="gsk-980tdi", source="TDi15", evidence="inferred",
    files={"O0001.CNC": "O0001\nN10 M98 P[\u5916\u5706]\nN20 M30\n".encode("gbk"),
           "\u5916\u5706.CNC": "N30 M99\n"},
    params={"878": 1}, encoding="gbk", main="O1", runs="N10 N30 N20",
)
case(
    "a Chinese name whose file is not there is 001",
    control="gsk-980tdi", source="TDi15; MDia 001", evidence="inferred",
    files={"O0001.CNC": "O0001\nN10 M98 P[\u5916\u5706]\nN20 M30\n",
           "\u87ba\u7eb9.CNC": "N30 M99\n"},
    params={"878": 1}, main="O1", runs="", alarm="named-program-not-found", number="0001",
    at="O0001 N10",
)
case(
    "a file without a head is called by the number of its name",
    control=FANUC + GSK_988 + GSK_980, source=POLICY, evidence="inferred",
    files={"O0001.NC": "O0001\nN10 M98 P22\nN20 M30\n", "O0022.NC": "N30 M99\n"},
    main="O1", runs="N10 N30 N20",
)
case(
    "the O in a file counts and not the file's name on FANUC and GSK",
    pins="program_heads:file",
    control=[*FANUC + GSK_988 + GSK_980, "haas-ngc"], source=POLICY, evidence="inferred",
    files={"O0001.NC": "O0001\nN10 M98 P22\nN20 M30\n", "PART7.NC": "O0022\nN30 M99\n"},
    main="O1", runs="N10 N30 N20",
)
case(
    "a file's name does not answer on FANUC where the file has an O",
    control=FANUC, source="ALM PS0076; general knowledge 078", evidence="inferred",
    files={"O0001.NC": "O0001\nN10 M98 P22\nN20 M30\n", "O0022.NC": "O0023\nN30 M99\n"},
    main="O1", runs="", alarm="program-not-found",
    number={c: "078" if c == "fanuc-16i" else "PS0076" for c in FANUC}, at="O0001 N10",
)
case(
    "a % line with a number heads a program of the 928",
    control="gsk-928te", source="928T1; source 001", evidence="inferred",
    program="""
        %12
        N0010 M97 P0030
        N0020 M09
        N0030 M02
    """,
    main="%12", runs="N10 N30", m=[],
)
case(
    "a program of the 928 has blocks of its own program only",
    control="gsk-928te", source="source 001, M97", evidence="inferred",
    program="""
        %12
        N0010 M97 P0030
        N0020 M02
        %13
        N0030 M02
    """,
    main="%12", runs="", alarm="jump-target-not-found", number=None, at="%12 N10", word="P0030",
)

# Duplicates

case(
    "of two programs with one number the first counts",
    control=WITH_O, source=POLICY, evidence="inferred",
    program="""
        O1
        N10 M98 P22
        N20 M30
        O22
        N30 M99
        O22
        N40 M99
    """,
    runs="N10 N30 N20",
)
case(
    "of two main programs with one number the first runs",
    control=WITH_O, source=POLICY, evidence="inferred",
    program="""
        O1
        N10 M30
        O0001
        N20 M30
    """,
    main="O1", runs="N10",
)
case(
    "of two files with one number the first in the order of names counts",
    control=FANUC + GSK_988 + GSK_980, source=POLICY, evidence="inferred",
    files={"A.NC": "O0022\nN30 M99\n", "B.NC": "O0022\nN40 M99\n",
           "M.NC": "O0001\nN10 M98 P22\nN20 M30\n"},
    main="O1", runs="N10 N30 N20",
)
case(
    "a fault in the first of two programs with one number is not hidden by the second",
    control=FANUC, source="ALM PS0006", evidence="inferred",
    program="""
        O1
        N10 M98 P22
        N20 M30
        O22
        N30 M-8
        N40 M99
        O22
        N50 M99
    """,
    runs="N10", alarm="illegal-minus-sign", number=on_fanuc(6), at="O22 N30",
)
case(
    "of two % programs with one number the first counts",
    control=HNC, source=POLICY, evidence="inferred",
    program="""
        %1
        N10 M98 P22
        N20 M30
        %22
        N30 M99
        %0022
        N40 M99
    """,
    runs="N10 N30 N20",
)
