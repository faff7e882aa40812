"""How NC text is read: frames, heads, ends of block, skips, comments, words, numbers, encodings."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_NAMES = ["fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
WITH_O = FANUC + GSK_988 + GSK_980 + MITSUBISHI  # programs are named O1
WITH_PERCENT = ["hnc-21m", "gsk-928te"]  # programs are named %1
HNC = "hnc-21m"


def on_fanuc(number):
    """The alarm as each FANUC shows it: 005 on the 16i, PS0005 on the others."""
    return {c: f"{number:03d}" if c == "fanuc-16i" else f"PS{number:04d}" for c in FANUC}


def everywhere(claim, text, **expected):
    """One row for the controls whose programs have an O, one for those with a %.

    `text` is the memory's only file, in bytes, with HEAD for the program's head.
    """
    for head, controls in ((b"O1", WITH_O), (b"%1", WITH_PERCENT)):
        case(
            f"{claim}, programs headed {head.decode()}",
            control=controls, files={"O1.NC": text.replace(b"HEAD", head)}, **expected,
        )


POLICY = "general knowledge"
PLAIN = {"source": POLICY, "evidence": "inferred", "runs": "N10 N20 N30", "m": [8, 9]}

# Ends of block

everywhere("line feeds end blocks", b"HEAD\nN10 M8\nN20 M9\nN30 M30\n", **PLAIN)
everywhere("carriage return and line feed end blocks", b"HEAD\r\nN10 M8\r\nN20 M9\r\nN30 M30\r\n",
           **PLAIN)
everywhere("carriage returns alone end blocks", b"HEAD\rN10 M8\rN20 M9\rN30 M30\r", **PLAIN)
everywhere("line feed with two carriage returns ends one block",
           b"HEAD\n\r\rN10 M8\n\r\rN20 M9\n\r\rN30 M30\n\r\r", **PLAIN)
everywhere("ends of line may change within a file", b"HEAD\r\nN10 M8\rN20 M9\nN30 M30", **PLAIN)
everywhere("the last block needs no end of line", b"HEAD\nN10 M8\nN20 M9\nN30 M30", **PLAIN)
everywhere("empty lines are no blocks", b"\n\nHEAD\n\nN10 M8\n   \n\t\nN20 M9\n\nN30 M30\n\n",
           **PLAIN)
case(
    "a semicolon ends a block like the end of the line",
    control=WITH_O, source="PB155, EOB", evidence="inferred",
    program="""
        O1;
        N10 M8;
        N20 M9;
        N30 M30;
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "two blocks may stand on one line with a semicolon between",
    pins="semicolon",
    control=[*WITH_O, "haas-ngc"], source="PB155, EOB", evidence="inferred",
    program="O1;N10 M8;N20 M9;N30 M30;",
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a whole memory of programs may stand on one line",
    control=FANUC, source="PB155, EOB", evidence="inferred",
    program="%;O1;N10 M98 P2;N20 M30;O2;N30 M99;%",
    runs="N10 N30 N20",
)
case(
    "a fault behind a semicolon is told at its own block",
    control=FANUC, source="PB155, EOB; ALM PS0006", evidence="inferred",
    program="O1;N10 M8;N20 M-9;N30 M30;",
    runs="N10", m=[8], alarm="illegal-minus-sign", number=on_fanuc(6), at="O1 N20", word="M-9",
)
case(
    "on HNC the text behind a semicolon is a comment and no block",
    pins="semicolon",
    control=HNC, source="HD, comments", evidence="secondary",
    files={"O1": b"%1\nN10 M8 ; N15 M3 ; N16 M4\nN20 M9;\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "on HNC even a fault behind a semicolon is a comment",
    control=HNC, source="HD, comments", evidence="secondary",
    files={"O1": b"%1\nN10 M8 ; M98 P77 !!\nN20 M9\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)

# Frames, leaders and trailers

everywhere("zeros of a punched-tape leader are skipped",
           b"\0" * 200 + b"HEAD\nN10 M8\nN20 M9\nN30 M30\n", **PLAIN)
everywhere("zeros of a punched-tape trailer are skipped",
           b"HEAD\nN10 M8\nN20 M9\nN30 M30\n" + b"\0" * 200, **PLAIN)
everywhere("zeros before and behind the percent signs are skipped",
           b"\0" * 50 + b"%\nHEAD\nN10 M8\nN20 M9\nN30 M30\n%\n" + b"\0" * 50, **PLAIN)
everywhere("a byte order mark is no text",
           b"\xef\xbb\xbfHEAD\nN10 M8\nN20 M9\nN30 M30\n", **PLAIN)
everywhere("a byte order mark before the percent sign is no text",
           b"\xef\xbb\xbf%\nHEAD\nN10 M8\nN20 M9\nN30 M30\n%\n", **PLAIN)
everywhere("percent signs alone on a line open and close the file",
           b"%\nHEAD\nN10 M8\nN20 M9\nN30 M30\n%\n", **PLAIN)
everywhere("the closing percent sign may be missing",
           b"%\nHEAD\nN10 M8\nN20 M9\nN30 M30\n", **PLAIN)
everywhere("the opening percent sign may be missing",
           b"HEAD\nN10 M8\nN20 M9\nN30 M30\n%\n", **PLAIN)
for name, content in [("an empty file", b""), ("a file of zeros", b"\0" * 4096),
                      ("a file of line ends", b"\r\n" * 50), ("a lone percent sign", b"%\n")]:
    case(
        f"{name} beside the program does no harm",
        control=WITH_O, source=POLICY, evidence="inferred",
        files={"O1.NC": b"O1\nN10 M8\nN20 M30\n", "X.NC": content},
        main="O1", runs="N10 N20", m=[8],
    )
NOT_FOUND = {**on_fanuc(76), "fanuc-16i": "078", **dict.fromkeys(GSK_988, "083"), **dict.fromkeys(GSK_980, "0001"),
             **dict.fromkeys(MITSUBISHI, "P232")}
LEADER = "GED, file frame: the tape begins with its %; general knowledge"
for _kind, _head, _number in (("O", b"O1", NOT_FOUND), ("percent", b"%1", None)):
    _where = {"control": WITH_O if _kind == "O" else WITH_PERCENT, "source": LEADER,
              "evidence": "inferred"}
    for _name, _before in [
        ("words", b"PART 12 FIXTURE 3\r\nTOOLS: 4\r\n"), ("a bad word", b"X1..2\n#1=[\n"),
        ("an end of program", b"G0 X1.\nM30\n"), ("a letter O", b"ORDER 7\n"),
        ("an open loop", b"WHILE[1EQ1]DO1\n"),
    ]:
        case(f"{_name} before the first percent sign is a leader, {_kind} programs", **_where,
             files={"O1.NC": _before + b"%\n" + _head + b"\nN10 M8\nN20 M9\nN30 M30\n%\n"},
             runs="N10 N20 N30", m=[8, 9])
        case(f"behind {_name} as a leader the program alarms where it always does, {_kind} programs",
             control=[c for c in _where["control"] if c != "gsk-928te"], source=LEADER,
             evidence="inferred",
             files={"O1.NC": _before + b"%\n" + _head + b"\nN10 M8\nN20 M98 P77\nN30 M30\n"},
             runs="N10", alarm="program-not-found", number=_number, word="P77", m=[8],
             at=f"{_head.decode()} N20")
for _name, _tape, _runs in [
    ("a head that a second percent sign does not follow", b"%\nO1\nN10 M8\nN20 M30\n", "N10 N20"),
    ("blank lines and a comment", b"%\n\n(SHAFT)\n  \nO1\nN10 M8\nN20 M30\n", "N10 N20"),
    ("blocks without a head that a second percent sign ends", b"%\nN10 M8\nN20 M30\n%\n", "N10 N20"),
    ("several programs", b"%\nO1\nN10 M98 P2\nN20 M8\nN30 M30\nO2\nN40 M99\n%\n", "N10 N40 N20 N30"),
]:
    case(f"a leader stands before {_name}", control=WITH_O, source=LEADER, evidence="inferred",
         files={"O1.NC": b"SHAFT 40\n" + _tape}, runs=_runs, m=[8])
for _name, _text, _runs in [
    ("without any percent sign", b"N10 M98 P2\nN20 M30\nO2\nN30 M8\nN40 M99\n", "N10 N30 N40 N20"),
    ("that a percent sign closes", b"N10 M8\nN20 M30\n%\n", "N10 N20"),
    ("that a percent sign closes before a trailer", b"N10 M8\nN20 M30\n%\nEND OF TAPE\n", "N10 N20"),
    ("behind the first percent sign",
     b"%\nN10 M98 P2\nN20 M30\nO2\nN30 M8\nN40 M99\n%\n", "N10 N30 N40 N20"),
    ("behind the first percent sign and closed by one of its own",
     b"%\nN10 M98 P2\nN20 M30\n%\nO2\nN30 M8\nN40 M99\n%\n", "N10 N30 N40 N20"),
]:
    case(f"a main program without a head {_name} is no leader", control=WITH_O, source=LEADER,
         evidence="inferred", files={"MAIN.NC": _text}, runs=_runs, m=[8])
    case(f"a main program without a head {_name} alarms as any does", control=WITH_O,
         source=LEADER, evidence="inferred",
         files={"MAIN.NC": _text.replace(b"M8\n", b"M98 P77\n")},
         alarm="program-not-found", number=NOT_FOUND, m=[])
case("a program with a head before the first percent sign is no leader", control=WITH_O,
     source=LEADER, evidence="inferred",
     files={"O1.NC": b"O1\nN10 M98 P2\nN20 M30\n%\nO2\nN30 M8\nN40 M99\n%\n"},
     runs="N10 N30 N40 N20", m=[8])
case(
    "a closing percent sign is the end and the program in front of it has no M30",
    control=FANUC, source="ALM 5010, END OF RECORD", evidence="secondary",
    program="""
        %
        O1
        N10 M8
        %
    """,
    runs="N10", alarm="end-of-record", number=on_fanuc(5010),
)
case(
    "a program that only has its O is at its end at once on FANUC",
    pins="percent_programs",
    control=[*FANUC, "haas-ngc"], source="ALM 5010, END OF RECORD", evidence="inferred",
    program="""
        O1
        O2
        N10 M30
    """,
    main="O1", runs="", alarm="end-of-record", number={**on_fanuc(5010), "haas-ngc": "312"},
)
case(
    "a program that only has its O is at its end at once on a Mitsubishi",
    pins="percent_programs",
    control=MITSUBISHI, source="SK P36", evidence="inferred",
    program="""
        O1
        O2
        N10 M30
    """,
    main="O1", runs="", alarm="end-of-record", number="P36",
)
case(
    "a program that only has its O is at its end at once on the GSK 988",
    pins="percent_programs",
    control=GSK_988, source="Talm 19", evidence="inferred",
    program="""
        O1
        O2
        N10 M30
    """,
    main="O1", runs="", alarm="end-of-record", number="019",
)
case(
    "comment lines are no blocks and end no program",
    control=FANUC, source="ALM 5010, END OF RECORD; GED, comments", evidence="inferred",
    program="""
        O1
        (M30)
        N10 M8
        (N20 M30)
    """,
    runs="N10", alarm="end-of-record", number=on_fanuc(5010),
)

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
    "a program does not run on into the program behind it",
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
    "a title behind the O is a comment",
    control=WITH_O, source="GED, comment behind the O", evidence="secondary",
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
    "words behind the O on its line are a block of the program",
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
    pins="file_name_wins",
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

# Sequence numbers

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
    "a sequence number behind another word is 006 on the GSK 980",
    pins="sequence_number_first",
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

# Block skip

SKIP = "ISO, block delete 1 to 9; general knowledge"
everywhere("a slash block does not run when switch 1 is on",
           b"HEAD\nN10 M8\n/N20 M3\nN25 M9\nN30 M30\n", source=SKIP, evidence="inferred",
           skip=(1,), runs="N10 N25 N30", m=[8, 9])
everywhere("a slash block runs when the switch is off",
           b"HEAD\nN10 M8\n/N20 M9\nN30 M30\n", source=SKIP, evidence="inferred",
           runs="N10 N20 N30", m=[8, 9])
NUMBERED = FANUC + MITSUBISHI
for digit in range(1, 10):
    case(
        f"/{digit} belongs to switch {digit} and to no other",
        control=NUMBERED, source=SKIP, evidence="inferred",
        program=f"""
            O1
            /{digit} N10 M8
            /{digit % 9 + 1} N20 M9
            N30 M30
        """,
        skip=(digit,), runs="N20 N30", m=[9],
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
    "the slash may stand behind the sequence number",
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

# Comments

case(
    "a comment may stand anywhere in a block, even between an address and its value",
    control=FANUC + MITSUBISHI, source="GED, comments", evidence="inferred",
    program="""
        O1
        (A)N10(B) M(C)8(D)
        N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "percent signs, slashes and brackets in a comment are text",
    control=WITH_O, source=POLICY, evidence="inferred",
    program="""
        O1
        (FEED 100%)
        N10 M8 (#1=[2 O5 N99 M30 <X>)
        N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment ends at the first closing parenthesis",
    control=FANUC, source="GED, comments", evidence="secondary",
    program="""
        O1
        N10 T5 (A (B) M8
        N30 M30
    """,
    runs="N10 N30", t=[5], m=[8],
)
OWN = "real programs: `($Message(\"... [..] ...\") )`; general knowledge"
TAKES_LONE = FANUC + GSK_988 + MITSUBISHI + WITH_PERCENT
for _name, _line in [
    ("in a block", 'N20 M9 ($Message("[1] of [2]") )'), ("on a line of its own", '($Message("A") )\nN20 M9'),
    ("at the head of a block", "(A (B) ) N20 M9"), ("between words", "N20 (A(B)) M9"),
    ("twice", "N20 M9 (A (B (C) ) )"), ("before another comment", "N20 M9 (A (B)) (C (D))"),
]:
    for _head, _controls in ((b"O1", [c for c in TAKES_LONE if c not in WITH_PERCENT]),
                             (b"%1", WITH_PERCENT)):
        case(f"a comment with brackets of its own {_name} ends with the last, {_head.decode()} programs",
             control=_controls, source=OWN, evidence="inferred",
             files={"O1.NC": _head + f"\nN10 M8\n{_line}\nN30 M30\n".encode()},
             runs="N10 N20 N30", m=[8, 9])
case("a comment with brackets of its own ends a macro statement", control=FANUC + GSK_988 + MITSUBISHI,
     source=OWN, evidence="inferred",
     program="O1\nN10 #100=2 (A (B) )\nN20 IF[#100EQ2]GOTO40 (A (B) )\nN30 M8\nN40 M30\n",
     runs="N10 N20 N40", vars={100: 2})
for _name, _line, _word in [("behind a word", "N20 M9)", ")"), ("behind a word behind a comment", "N20 (A) M9 )", ")"),
                            ("at the head of a block", ") N20 M9", ")"),
                            ("and a sign behind a comment", "N20 M9 (A (B) ) !", "!")]:
    case(f"a parenthesis {_name} alarms", control=FANUC + GSK_988 + MITSUBISHI, source=OWN,
         evidence="inferred", program=f"O1\nN10 M8\n{_line}\nN30 M30\n",
         runs="N10", m=[8], alarm="illegal-character", word=_word,
         number={**dict.fromkeys(GSK_988), **dict.fromkeys(MITSUBISHI, "P32"), **on_fanuc(9), "fanuc-16i": "009"})
for _name, _line in [("behind a word", "N20 M9)"), ("behind a comment", "N20 M9 (A (B) )"),
                     ("between words", "N20 (A)) M9")]:
    case(f"a parenthesis too many {_name} is 041 on the GSK 980", control=GSK_980,
         source="MDia 041: brackets not paired", evidence="maker's manual",
         program=f"O1\nN10 M8\n{_line}\nN30 M30\n",
         runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20", word=")")
case(
    "a comment that is not closed ends with its block on FANUC",
    control=FANUC, source="GED, comments; policy for unclosed", evidence="inferred",
    program="""
        O1
        N10 T5 (A M8
        N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", t=[5], m=[9],
)
case(
    "a comment that is not closed is 041 on the GSK 980",
    pins="open_comment",
    control=GSK_980, source="MDia 041", evidence="maker's manual",
    program="""
        O1
        N10 M8
        N20 M9 (A
        N30 M30
    """,
    runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20",
)
case(
    "a comment in full-width parentheses is 041 on the GSK 980",
    control=GSK_980, source="MDia 041", evidence="maker's manual",
    program="""
        O1
        N10 M8
        N20 M9 \uff08A\uff09
        N30 M30
    """,
    runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20",
)
for name, encoding, text in [
    ("UTF-8 Chinese", "utf-8", "\u7c97\u52a0\u5de5"), ("GBK Chinese", "gbk", "\u7c97\u52a0\u5de5"),
    ("Shift-JIS Japanese", "shift_jis", "\u30bd\u30d5\u30c8\u8868\u793a"),
    ("Latin-1 German", "latin-1", "Fr\u00e4ser \u00d810"),
    ("UTF-8 Cyrillic", "utf-8", "\u0424\u0440\u0435\u0437\u0430"),
    ("Windows Cyrillic", "cp1251", "\u0424\u0440\u0435\u0437\u0430"),
]:
    case(
        f"a comment in {name} is read over",
        control=[*WITH_O, HNC], source=POLICY, evidence="inferred",
        files={"O1.NC": f"O1 ({text})\nN10 M8 ({text})\n({text})\nN20 M9\nN30 M30\n"
               .encode(encoding)},
        runs="N10 N20 N30", m=[8, 9],
    )
case(
    "an encoding may be named",
    control=WITH_O, source=POLICY, evidence="inferred",
    files={"O1.NC": "O1\nN10 M8 (\u30bd)\nN20 M9\nN30 M30\n".encode("shift_jis")},
    encoding="shift_jis", runs="N10 N20 N30", m=[8, 9],
)
case(
    "bytes of no encoding in a comment are read over",
    control=WITH_O, source=POLICY, evidence="inferred",
    files={"O1.NC": b"O1\nN10 M8 (\xff\xfe\x80\x01)\nN20 M9\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment of #3000 is the alarm's text and no comment",
    control=FANUC, source="general knowledge, #3000", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 #3000= 91 (TEXT)
        N30 M30
    """,
    runs="N10 N20", alarm="user-alarm",
    number={c: "3091" if c == "fanuc-16i" else "MC3091" for c in FANUC}, at="O1 N20",
)

# Joins, spaces, zeros, case

everywhere("words need no spaces between them", b"HEAD\nN10M8\nN20M9\nN30M30\n", **PLAIN)
everywhere("spaces and tabs between words are no difference",
           b"HEAD\n  N10\t M8\t\n N20   M9\nN30 M30\n", **PLAIN)
everywhere("spaces inside words are no difference", b"HEAD\nN 1 0 M 8\nN2 0M 0 9\nN30 M3 0\n",
           **PLAIN)
everywhere("leading zeros of an M code are no difference",
           b"HEAD\nN10 M08\nN20 M009\nN30 M0030\n", **PLAIN)
everywhere("small letters are read as capitals", b"HEAD\nn10 m8\nn20 M9\nN30 m30\n", **PLAIN)
case(
    "a call joined to a move is a call",
    control=WITH_O, source=POLICY, evidence="inferred",
    program="""
        O1
        N10G0X1.M98P22
        N20M30
        O22
        N30M99
    """,
    runs="N10 N30 N20", calls="M98:O22",
)
case(
    "a joined call of a missing program is told at its P on FANUC",
    control=FANUC, source="ALM PS0076; general knowledge 078", evidence="inferred",
    program="""
        O1
        N10G0X1.M98P22
        N20M30
    """,
    runs="N10", alarm="program-not-found",
    number={c: "078" if c == "fanuc-16i" else "PS0076" for c in FANUC}, at="O1 N10", word="P22",
)
case(
    "a joined call of a missing program is told at its P on a Mitsubishi",
    control=MITSUBISHI, source="source 004, note 1", evidence="source document",
    program="""
        O1
        N10G0X1.M98P22
        N20M30
    """,
    runs="N10", alarm="program-not-found", number="P232", at="O1 N10", word="P22",
)
case(
    "a joined call of a missing program is told at its P on the GSK 988",
    control=GSK_988, source="source 000, note 3; Talm 83", evidence="inferred",
    program="""
        O1
        N10G0X1.M98P0022
        N20M30
    """,
    runs="N10", alarm="program-not-found", number="083", at="O1 N10", word="P0022",
)
case(
    "macro statements need no spaces",
    control=FANUC + MITSUBISHI, source="programs seen in shops", evidence="inferred",
    program="""
        O1
        N10#100=5
        N20IF[#100EQ5]GOTO40
        N30M8
        N40WHILE[#100LT7]DO1
        N50#100=#100+1
        N60END1
        N70M30
    """,
    runs="N10 N20 N40 N50 N60 N40 N50 N60 N40 N70", vars={100: 7}, m=[],
)
case(
    "macro statements may have spaces inside",
    control=FANUC + MITSUBISHI, source="programs seen in shops", evidence="inferred",
    program="""
        O1
        N10 # 100 = 1 0 1
        N20 # [ #100 ] = 2 . 5
        N30 GO TO 50
        N40 M 8
        N50 M 3 0
    """,
    runs="N10 N20 N30 N50", vars={100: 101, 101: 2.5}, m=[],
)
case(
    "leading zeros in a jump and in a variable are no difference",
    control=FANUC + MITSUBISHI, source="programs seen in shops", evidence="inferred",
    program="""
        O1
        N10 #0100=#06+1
        N20 GOTO0040
        N30 M8
        N40 M30
    """,
    runs="N10 N20 N40", vars={100: 1}, m=[],
)
case(
    "macro statements in small letters are read",
    control=FANUC + MITSUBISHI, source="policy for small letters", evidence="inferred",
    program="""
        o1
        n10 #100=sin[30]
        n20 if[#100 lt 1]goto40
        n30 m8
        n40 m30
    """,
    runs="N10 N20 N40", vars={100: 0.5}, m=[],
)
case(
    "a joined jump to a block that does not exist is P231",
    control=MITSUBISHI, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10IF[#100EQ#0]GOTO0099
        N20M30
    """,
    runs="", alarm="jump-target-not-found", number="P231", at="O1 N10",
)
case(
    "on the 16i two letters of a function suffice",
    control="fanuc-16i", source="general knowledge, first two letters", evidence="inferred",
    program="""
        O1
        N10 #100=RO[1.6]+FI[2.9]+SI[30]
        N20 M30
    """,
    runs="N10 N20", vars={100: 4.5},
)

# Numbers

for text, meaning, value in [
    ("1", "thousandths of a millimetre", 0.001), ("1.", "millimetres", 1),
    (".5", "half a millimetre", 0.5), ("-.5", "minus half a millimetre", -0.5),
    ("+1.", "one millimetre with a plus sign", 1), ("01.50", "one and a half millimetres", 1.5),
    ("1.23456", "millimetres cut to the least increment", 1.234),
]:
    case(
        f"X{text} is read as {meaning} on FANUC",
        pins="cuts_fine_digits",
        control=FANUC, source="general knowledge, decimal point and least increment",
        evidence="inferred",
        program=f"""
            O1
            N10 G90 G0 X{text}
            N20 #100=#5001
            N30 M30
        """,
        runs="N10 N20 N30", vars={100: value},
    )
case(
    "with pocket calculator notation X1 is one millimetre",
    control=FANUC, source="general knowledge, 3401#0 DPI", evidence="inferred",
    program="""
        O1
        N10 G90 G0 X1
        N20 #100=#5001
        N30 M30
    """,
    params={"3401#0": 1}, runs="N10 N20 N30", vars={100: 1},
)
case(
    "a value from a variable is rounded to the least increment and not cut",
    control=FANUC, source="JIX, XIA", evidence="secondary",
    program="""
        O1
        N10 #1=1.23456
        N20 G90 G0 X#1
        N30 #100=#5001
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 1.235},
)
case(
    "an M code from a variable is rounded half up",
    control=FANUC, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #1=7.5
        N20 M#1
        N30 M[#1+0.7]
        N40 M30
    """,
    runs="N10 N20 N30 N40", m=[8, 8],
)

FORM = "general knowledge, faults of form"
for claim, text, word, cause, fanuc, gsk, mitsubishi in [
    ("an address without a value", "N20 M8 T", "T", "address-without-value", 5, "005", "P33"),
    ("an address whose value is only a sign", "N20 M8 X-", "X-", "address-without-value", 5,
     "005", "P33"),
    ("an address right before another one", "N20 G0 X Y1.", "X", "address-without-value", 5,
     "005", "P33"),
    ("a number with two points", "N20 G0 Y1.2.3", "Y1.2.3", "illegal-decimal-point", 7, "007",
     "P33"),
    ("a point in an M code", "N20 M8.", "M8.", "illegal-decimal-point", 7, "007", "P33"),
    ("a point in a tool number", "N20 T1.", "T1.", "illegal-decimal-point", 7, "007", "P33"),
]:
    program = f"""
        O1
        N10 M9
        {text}
        N30 M30
    """
    expected = {"program": program, "evidence": "inferred", "runs": "N10", "m": [9], "alarm": cause,
                    "at": "O1 N20", "word": word}
    case(f"{claim} is alarm {fanuc:03d} on FANUC: {text}", control=FANUC,
         source=f"ALM PS{fanuc:04d}", number=on_fanuc(fanuc), **expected)
    case(f"{claim} is {gsk} on the GSK 988: {text}", control=GSK_988, source=f"Talm {gsk}",
         number=gsk, **expected)
    case(f"{claim} is {mitsubishi} on a Mitsubishi: {text}", control=MITSUBISHI,
         source="SK P33", number=mitsubishi, **expected)
for text in ("5 M8", "12.5"):
    for controls, number, source in [
        (FANUC, on_fanuc(4), "ALM PS0004"), (GSK_988, "004", "Talm 004"),
        (MITSUBISHI, "P33", "SK P33"),
    ]:
        case(
            f"a block that begins with a value alarms, {source}: {text}",
            control=controls, source=source, evidence="inferred",
            program=f"O1\nN10 M9\n{text}\nN30 M30\n",
            runs="N10", m=[9], alarm="value-without-address", number=number, at="O1",
        )
case(
    "a blank inside a sequence number is passed over on FANUC: N20 5 is N205",
    control=FANUC, source="GED, blanks", evidence="secondary",
    program="""
        O1
        N10 GOTO 205
        N20 5 M8
        N30 M30
    """,
    runs="N10 N205 N30", m=[8],
)
for controls, number, source in [(FANUC, on_fanuc(6), "ALM PS0006"), (GSK_988, "006", "Talm 006")]:
    for word in ("M-8", "T-1"):
        case(
            f"a minus sign in {word} is refused, {source}",
            control=controls, source=source, evidence="inferred",
            program=f"""
                O1
                N10 M9
                N20 {word}
                N30 M30
            """,
            runs="N10", m=[9], alarm="illegal-minus-sign", number=number, at="O1 N20", word=word,
        )
case(
    "HNC refuses an address without a value",
    control=HNC, source=FORM, evidence="inferred",
    program="""
        %1
        N10 M9
        N20 M8 T
        N30 M30
    """,
    runs="N10", m=[9], alarm="address-without-value", number=None, at="%1 N20",
)
case(
    "HNC refuses a number with two points",
    control=HNC, source=FORM, evidence="inferred",
    program="""
        %1
        N10 M9
        N20 G0 X1.2.3
        N30 M30
    """,
    runs="N10", m=[9], alarm="illegal-decimal-point", number=None, at="%1 N20", word="X1.2.3",
)
case(
    "nine digits are too many for the 16i",
    control="fanuc-16i", source="ALM PS0003; general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G0 X123456789
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number="003", at="O1 N20", word="X123456789",
)
case(
    "the digits of a value with a point count in least increments",
    control=FANUC, source="ALM PS0003; general knowledge, digits after conversion",
    evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G0 Y1234567.
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=on_fanuc(3), at="O1 N20", word="Y1234567.",
)
case(
    "a value of more than eight digits is 003 on the GSK 988",
    control=GSK_988, source="Talm 003", evidence="maker's manual",
    program="""
        O1
        N10 M9
        N20 G0 X123456789
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number="003", at="O1 N20", word="X123456789",
)

# Characters, words and codes that the control does not know

for claim, byte in [("an exclamation mark", b"!"), ("a dollar sign", b"$"),
                    ("a control character", b"\x07")]:
    text = b"O1\nN10 M9\nN20 M8 " + byte + b"\nN30 M30\n"
    case(
        f"{claim} is a character that FANUC does not know",
        control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
        files={"O1.NC": text}, runs="N10", m=[9], alarm="illegal-character",
        number=on_fanuc(9), at="O1 N20",
    )
case(
    "Chinese text outside a comment stops FANUC at its block",
    control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
    files={"O1.NC": "O1\nN10 M9\nN20 M8 \u52a0\u5de5\nN30 M30\n".encode()},
    runs="N10", m=[9], alarm="illegal-character", number=on_fanuc(9), at="O1 N20",
)
case(
    "a byte of no encoding outside a comment stops FANUC at its block",
    control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
    files={"O1.NC": b"O1\nN10 M9\nN20 M8 \xff\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number=on_fanuc(9), at="O1 N20",
)
case(
    "zeros in the middle of a program are skipped",
    control=WITH_O, source=POLICY, evidence="inferred",
    files={"O1.NC": b"O1\nN10 M8\n\0\0\0N20 M9\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a character that the GSK 988 does not know alarms without a number",
    control=GSK_988, source="general knowledge; no list names a character", evidence="inferred",
    files={"O1.CNC": b"O1\nN10 M9\nN20 M8 !\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number=None, at="O1 N20",
)
case(
    "a character that a Mitsubishi does not know is P32",
    control=MITSUBISHI, source="SK P32", evidence="inferred",
    files={"O1.NC": b"O1\nN10 M9\nN20 M8 !\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number="P32", at="O1 N20",
)
case(
    "a character that HNC does not know stops at its block",
    pins="file_name_wins",
    control=HNC, source=FORM, evidence="inferred",
    files={"O1": b"%1\nN10 M9\nN20 M8 !\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number=None, at="%1 N20",
)
case(
    "an unknown character behind M30 is never reached",
    control=WITH_O, source="reading never fails", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 M30
        N30 M8 !!
    """,
    runs="N10 N20", m=[9],
)
case(
    "a faulty block that a jump passes raises nothing",
    control=FANUC + MITSUBISHI, source="reading never fails", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 M-8 X1.2.3 T !
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "a faulty program that nobody calls raises nothing",
    control=WITH_O, source="reading never fails", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 M30
        O22
        N30 M8 ! X1.2.3 (
    """,
    runs="N10 N20", m=[9],
)
case(
    "the words in front of a fault in the same block are not executed",
    control=FANUC, source="ALM PS0006; nothing changes before a block has been checked",
    evidence="inferred",
    program="""
        O1
        N10 T5 M-8
        N20 M30
    """,
    runs="", t=[], alarm="illegal-minus-sign", number=on_fanuc(6), at="O1 N10", word="M-8",
)
case(
    "a G code that FANUC does not have is alarm 010",
    control=FANUC, source="ALM PS0010", evidence="secondary",
    program="""
        O1
        N10 M9
        N20 G999 X1.
        N30 M30
    """,
    runs="N10", m=[9], alarm="g-code-not-available", number=on_fanuc(10), at="O1 N20",
    word="G999",
)
case(
    "a G code that the GSK 988 does not have is 009",
    control=GSK_988, source="Talm 009", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G999 X1.
        N30 M30
    """,
    runs="N10", m=[9], alarm="g-code-not-available", number="009", at="O1 N20", word="G999",
)
case(
    "a G code that the GSK 980 does not have is 0002",
    control=GSK_980, source="MDib 0002", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G999
        N30 M30
    """,
    runs="N10", m=[9], alarm="g-code-not-available", number="0002", at="O1 N20", word="G999",
)
case(
    "27 words in a block are too many for FANUC",
    control=FANUC, source="ALM PS5006", evidence="secondary",
    program="O1\nN10 M9\nN20 " + "T1 " * 27 + "\nN30 M30\n",
    runs="N10", t=[], alarm="too-many-words",
    number={c: "5006" if c == "fanuc-16i" else "PS5006" for c in FANUC}, at="O1 N20",
)
case(
    "a block of more than 256 characters is 002 on the GSK 988",
    control=GSK_988, source="Talm 002", evidence="inferred",
    program="O1\nN10 M9\nN20 " + "T00000001" * 40 + "\nN30 M30\n",
    runs="N10", t=[], alarm="block-too-long", number="002", at="O1 N20",
)
case(
    "an address written twice is 010 on the GSK 980",
    pins="repeated_address",
    control=GSK_980, source="MDia 010", evidence="maker's manual",
    program="""
        O1
        N10 M9
        N20 T1 T2
        N30 M30
    """,
    runs="N10", t=[], alarm="address-given-twice", number="0010", at="O1 N20",
)
case(
    "an address written twice is 010 on the GSK 988 when AD2 is set",
    control=GSK_988, source="Talm 010; TApar 3403#6", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 T1 T2
        N30 M30
    """,
    params={"3403#6": 1}, runs="N10", t=[], alarm="address-given-twice", number="010",
    at="O1 N20",
)
case(
    "of an address written twice the last one counts on the others",
    control=FANUC + GSK_988 + MITSUBISHI, source="TApar 3403#6; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 T1 T2
        N30 M30
    """,
    runs="N10 N30", t=[2],
)
case(
    "two G codes of one group are PS5074 on FANUC when AD2 is set",
    control=FANUC, source="ALM PS5074; general knowledge, 3403#6", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G90 G91
        N30 M30
    """,
    params={"3403#6": 1}, runs="N10", alarm="address-given-twice",
    number={c: "5074" if c == "fanuc-16i" else "PS5074" for c in FANUC}, at="O1 N20",
)
