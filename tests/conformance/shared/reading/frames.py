"""Reading of NC text: ends of block, frames, leaders and trailers."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
WITH_O = FANUC + GSK_988 + GSK_980 + MITSUBISHI  # programs are named O1
WITH_PERCENT = ["hnc-21m", "gsk-928te"]  # programs are named %1
HNC = "hnc-21m"


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
    "a fault after a semicolon is told at its own block",
    control=FANUC, source="PB155, EOB; ALM PS0006", evidence="inferred",
    program="O1;N10 M8;N20 M-9;N30 M30;",
    runs="N10", m=[8], alarm="illegal-minus-sign", number=on_fanuc(6), at="O1 N20", word="M-9",
)
case(
    "on HNC the text after a semicolon is a comment and no block",
    pins="semicolon",
    control=HNC, source="HD, comments", evidence="secondary",
    files={"O1": b"%1\nN10 M8 ; N15 M3 ; N16 M4\nN20 M9;\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "on HNC even a fault after a semicolon is a comment",
    control=HNC, source="HD, comments", evidence="secondary",
    files={"O1": b"%1\nN10 M8 ; M98 P77 !!\nN20 M9\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)

# Frames, leaders and trailers

everywhere("zeros of a punched-tape leader are skipped",
           b"\0" * 200 + b"HEAD\nN10 M8\nN20 M9\nN30 M30\n", **PLAIN)
everywhere("zeros of a punched-tape trailer are skipped",
           b"HEAD\nN10 M8\nN20 M9\nN30 M30\n" + b"\0" * 200, **PLAIN)
everywhere("zeros before and after the percent signs are skipped",
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
LEADER = "GED, file frame: the tape begins with its %; B-62694EN p.88: a title stands before the first block; general knowledge"
for _kind, _head, _number in (("O", b"O1", NOT_FOUND), ("percent", b"%1", None)):
    _where = {"control": WITH_O if _kind == "O" else WITH_PERCENT, "source": LEADER,
              "evidence": "inferred"}
    for _name, _before in [
        ("words", b"PART 12 FIXTURE 3\r\nTOOLS: 4\r\n"), ("a bad word", b"X1..2\n#1=[\n"),
        ("a letter O", b"ORDER 7\n"), ("a title that reads as words", b"T12\nS355\n"),
        ("a title with a comment", b"(SHAFT)\nREV B (M30)\n"), ("a thread", b"BOLT M30\n"),
    ]:
        case(f"{_name} before the first percent sign is a leader, {_kind} programs", **_where,
             files={"O1.NC": _before + b"%\n" + _head + b"\nN10 M8\nN20 M9\nN30 M30\n%\n"},
             runs="N10 N20 N30", m=[8, 9])
        case(f"after {_name} as a leader the program alarms where it always does, {_kind} programs",
             control=[c for c in _where["control"] if c != "gsk-928te"], source=LEADER,
             evidence="inferred",
             files={"O1.NC": _before + b"%\n" + _head + b"\nN10 M8\nN20 M98 P77\nN30 M30\n"},
             runs="N10", alarm="program-not-found", number=_number, word="P77", m=[8],
             at=f"{_head.decode()} N20")
case(
    "a title that a percent sign ends is a leader before the tape that follows",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"O1.NC": b"SHAFT 100%\n%\nO1\nN10 M8\nN20 M30\n%\n"}, runs="N10 N20", m=[8],
)

# Blocks before the first % that could run are the main program, and no leader
STARTS = "B-63524EN p.649: a file starts with % or LF; general knowledge: a leader holds no program"
for _kind, _tape in (("O", b"%\nO2"), ("percent", b"%2"), ("percent after a percent sign", b"%\n%2")):
    _controls = WITH_O if _kind == "O" else WITH_PERCENT
    for _name, _text, _runs, _m in [
        ("with M30", b"N10 M8\nN20 M30\n", "N10 N20", [8]),
        ("without sequence numbers", b"M8\nG0 X1\nM9\nM30\n", "", [8, 9]),
        ("with M02 after a skip", b"/N10 M8\n(TITLE)\nN20 M9\nN30 M2\n", "N10 N20 N30", [8, 9]),
        ("after a title", b"(SHAFT)\n\nN10 M8\nN20 M30\n", "N10 N20", [8]),
    ]:
        case(
            f"a main program without a head {_name} before the first percent sign runs, {_kind}",
            control=_controls, source=STARTS, evidence="inferred",
            files={"MAIN.NC": _text + _tape + b"\nN60 M3\nN70 M99\n%\n"}, runs=_runs, m=_m,
        )
case(
    "a main program without a head before the first percent sign calls the program after it",
    control=WITH_O, source=STARTS, evidence="inferred",
    files={"MAIN.NC": b"N10 M98 P2\nN20 M30\n%\nO2\nN60 M3\nN70 M99\n%\n"}, runs="N10 N60 N70 N20",
    m=[3],
)
case(
    "a main program without a head and without an end alarms before the first percent sign",
    control=FANUC, source=STARTS, evidence="inferred",
    files={"MAIN.NC": b"N10 M8\nN20 M9\n%\nO2\nN60 M3\nN70 M30\n%\n"}, runs="N10 N20", m=[8, 9],
    alarm="end-of-record", number=on_fanuc(5010),
)
case(
    "a main program without a head alarms at a block that nobody can read, before the first percent sign",
    control=WITH_O, source=STARTS, evidence="inferred",
    files={"MAIN.NC": b"N10 M8\nX1..2\nN20 M30\n%\nO2\nN60 M3\nN70 M30\n%\n"}, runs="N10", m=[8],
    alarm="illegal-decimal-point",
    number={**on_fanuc(7), **dict.fromkeys(GSK_988, "007"), **dict.fromkeys(GSK_980, "0012"),
            **dict.fromkeys(MITSUBISHI, "P33")},
)
case(
    "macro statements before the first percent sign are a program",
    control=FANUC, source=STARTS, evidence="inferred",
    files={"MAIN.NC": b"#500=1\nGOTO 10\nM3\nN10 M30\n%\nO2\nN60 M3\nN70 M30\n%\n"}, runs="N10",
    m=[], vars={500: 1},
)
case(
    "an open loop before the first percent sign is a program that alarms",
    control=FANUC, source=STARTS, evidence="inferred",
    files={"MAIN.NC": b"WHILE[1EQ1]DO1\n%\nO2\nN60 M3\nN70 M30\n%\n"}, runs="", m=[],
    alarm="missing-end", number=on_fanuc(124),
)

# A % after words ends the program file
BEHIND = "general knowledge: % is the end of the record wherever it stands; production programs end in N125M30%"
for _name, _text in [
    ("a trailer", b"O1\nN10 M8\nN20 M9\nN30 M30%\nEND OF TAPE\n"),
    ("another program", b"O1\nN10 M8\nN20 M9\nN30M30%\nO2\nN40 M3\nN50 M99\n%\n"),
    ("more on its line", b"O1\nN10 M8\nN20 M9\nN30 M30 % N40 M3\n"),
]:
    case(f"a percent sign after words ends the program before {_name}", control=WITH_O,
         source=BEHIND, evidence="inferred", files={"O1.NC": _text}, **{
             k: v for k, v in PLAIN.items() if k in ("runs", "m")})
case(
    "a percent sign after words is the end of a program that has no M30",
    control=FANUC, source=BEHIND + "; ALM 5010", evidence="inferred",
    files={"O1.NC": b"O1\nN10 M8%\nN20 M9\nN30 M30\n"}, runs="N10", m=[8],
    alarm="end-of-record", number=on_fanuc(5010),
)
case(
    "a percent sign after a skipped word ends the program too",
    control=FANUC, source=BEHIND, evidence="inferred", skip=(1,),
    files={"O1.NC": b"O1\nN10 M8\nN20 M30 /M3%\nN30 M9\n"}, runs="N10 N20", m=[8],
)
case(
    "a percent sign in a comment ends nothing",
    control=WITH_O, source=BEHIND, evidence="inferred",
    files={"O1.NC": b"O1\nN10 M8 (AT 50%)\nN20 M9 (100%) \nN30 M30\n"}, runs="N10 N20 N30",
    m=[8, 9],
)
case(
    "a leader stands before a head that a second percent sign does not follow",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"O1.NC": b'SHAFT 40\n%\nO1\nN10 M8\nN20 M30\n'}, runs="N10 N20", m=[8],
)
case(
    "a leader stands before blank lines and a comment",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"O1.NC": b'SHAFT 40\n%\n\n(SHAFT)\n  \nO1\nN10 M8\nN20 M30\n'}, runs="N10 N20", m=[8],
)
case(
    "a leader stands before blocks without a head that a second percent sign ends",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"O1.NC": b'SHAFT 40\n%\nN10 M8\nN20 M30\n%\n'}, runs="N10 N20", m=[8],
)
case(
    "a leader stands before several programs",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"O1.NC": b'SHAFT 40\n%\nO1\nN10 M98 P2\nN20 M8\nN30 M30\nO2\nN40 M99\n%\n'},
    runs="N10 N40 N20 N30", m=[8],
)
case(
    "a main program without a head without any percent sign is no leader",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'N10 M98 P2\nN20 M30\nO2\nN30 M8\nN40 M99\n'}, runs="N10 N30 N40 N20", m=[8],
)
case(
    "a main program without a head without any percent sign alarms as any does",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'N10 M98 P2\nN20 M30\nO2\nN30 M98 P77\nN40 M99\n'},
    alarm="program-not-found", number=NOT_FOUND, m=[],
)
case(
    "a main program without a head that a percent sign closes is no leader",
    control=WITH_O, source=LEADER, evidence="inferred", files={"MAIN.NC": b'N10 M8\nN20 M30\n%\n'},
    runs="N10 N20", m=[8],
)
case(
    "a main program without a head that a percent sign closes alarms as any does",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'N10 M98 P77\nN20 M30\n%\n'}, alarm="program-not-found", number=NOT_FOUND,
    m=[],
)
case(
    "a main program without a head that a percent sign closes before a trailer is no leader",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'N10 M8\nN20 M30\n%\nEND OF TAPE\n'}, runs="N10 N20", m=[8],
)
case(
    "a main program without a head that a percent sign closes before a trailer alarms as any does",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'N10 M98 P77\nN20 M30\n%\nEND OF TAPE\n'}, alarm="program-not-found",
    number=NOT_FOUND, m=[],
)
case(
    "a main program without a head after the first percent sign is no leader",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'%\nN10 M98 P2\nN20 M30\nO2\nN30 M8\nN40 M99\n%\n'}, runs="N10 N30 N40 N20",
    m=[8],
)
case(
    "a main program without a head after the first percent sign alarms as any does",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'%\nN10 M98 P2\nN20 M30\nO2\nN30 M98 P77\nN40 M99\n%\n'},
    alarm="program-not-found", number=NOT_FOUND, m=[],
)
case(
    "a main program without a head after the first percent sign and closed by one of its own is no leader",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'%\nN10 M98 P2\nN20 M30\n%\nO2\nN30 M8\nN40 M99\n%\n'},
    runs="N10 N30 N40 N20", m=[8],
)
case(
    "a main program without a head after the first percent sign and closed by one of its own alarms as any does",
    control=WITH_O, source=LEADER, evidence="inferred",
    files={"MAIN.NC": b'%\nN10 M98 P2\nN20 M30\n%\nO2\nN30 M98 P77\nN40 M99\n%\n'},
    alarm="program-not-found", number=NOT_FOUND, m=[],
)
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
    pins="program_heads:percent",
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
    pins="program_heads:percent",
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
    pins="program_heads:percent",
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
