"""Huazhong HNC-21M: programs, calls, returns, ends, levels."""

from conformance import case

case(
    "a subprogram reads the global variable of its caller (HNC-001)",
    pins="statements",
    control="hnc-21m",
    source="HD",
    evidence="secondary",
    program="""
        %1000
        #50=20
        M98 P1001
        #50=350
        M98 P1001
        M30
        %1001
        G91 G01 X[#50] F100
        M99
    """,
    moves_x=[20, 370],
)

case(
    "nine levels are legal on the HNC-21 (HNC-007)",
    pins="max_nesting max_total_nesting",
    control="hnc-21m",
    source="HS",
    evidence="secondary",
    program="""
        %1
        M98 P2
        M30
        %2
        G0 X2
        M98 P3
        M99
        %3
        G0 X3
        M98 P4
        M99
        %4
        G0 X4
        M98 P5
        M99
        %5
        G0 X5
        M98 P6
        M99
        %6
        G0 X6
        M98 P7
        M99
        %7
        G0 X7
        M98 P8
        M99
        %8
        G0 X8
        M98 P9
        M99
        %9
        G0 X9
        M98 P10
        M99
        %10
        G0 X10
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9, 10],
)

case(
    "M98 to a program that is not there alarms on the HNC-21 (HNC-009)",
    control="hnc-21m",
    source="general knowledge of the Century Star manuals",
    evidence="inferred",
    program="""
        %1
        G0 X1
        M98 P2
        M30
    """,
    moves_x=[1],
    alarm="program-not-found",
    at="%1",
)

HNC = "hnc-21m"


def chain(levels):
    """Return a main program %1 from which `levels` calls are open at once."""
    text = "%1\nN1 M98 P2\nN101 M30\n"
    for k in range(2, levels + 1):
        text += f"%{k}\nN{k} M98 P{k + 1}\nN{100 + k} M99\n"
    last = levels + 1
    return text + f"%{last}\nN{last} S{last}\nN{100 + last} M99\n"


def way_in(levels):
    return " ".join(f"N{k}" for k in range(1, levels + 1))


# Programs

case(
    "HNC: M98 calls a % program of the same file and M99 comes back",
    control=HNC, source="HD, M98 P1001", evidence="secondary",
    program="""
        %1000
        N10 S1
        N20 M98 P1001
        N30 M30
        %1001
        N40 S2
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", calls="M98:%1001",
)
case(
    "HNC: the first % program of the file is the main one",
    control=HNC, source="HD; general knowledge", evidence="inferred",
    files={"O1234": "%2000\nN10 M98 P1000\nN20 M30\n%1000\nN30 M99\n"},
    runs="N10 N30 N20", calls="M98:%1000",
)
case(
    "HNC: an O line names a program too",
    control=HNC, source="general knowledge, % or O", evidence="inferred",
    program="""
        O1000
        N10 M98 P1001
        N20 M30
        O1001
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "HNC: leading zeros do not hide a program",
    control=HNC, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 M98 P0003
        N30 M30
        %0002
        N40 M99
        %3
        N50 M99
    """,
    runs="N10 N40 N20 N50 N30",
)
case(
    "HNC: a bare % at both ends of the file is a frame",
    control=HNC, source="general knowledge", evidence="inferred",
    program="""
        %
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 M99
        %
    """,
    runs="N10 N30 N20",
)
case(
    "HNC: a program that is not in the file cannot be called",
    control=HNC, source="general knowledge, subprogram not found", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 M98 P7
        N30 M30
    """,
    runs="N10", calls="", alarm="program-not-found", number=None, at="%1 N20", word="P7",
)
case(
    "HNC: a missing program that a subprogram calls is told at the subprogram's block",
    control=HNC, source="general knowledge, subprogram not found", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 M98 P7
        N40 M99
    """,
    runs="N10", alarm="program-not-found", number=None, at="%2 N30", word="P7",
)
case(
    "HNC: M98 without P is refused",
    pins="omitted_program",
    control=HNC, source="general knowledge, M98 without P", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 M98 L2
        N30 M30
    """,
    runs="N10", alarm="program-number-missing", number=None, at="%1 N20",
)
case(
    "HNC: L repeats the subprogram",
    control=HNC, source="general knowledge, M98 P L", evidence="inferred",
    program="""
        %1
        N10 M98 P2 L4
        N20 M30
        %2
        N30 S3
        N40 M99
    """,
    runs="N10 (N30 N40)*4 N20", calls="M98:%2",
)
case(
    "HNC: without L the subprogram runs once",
    control=HNC, source="general knowledge, M98 P L", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "HNC: P has no repeat count in it",
    control=HNC, source="general knowledge, M98 P L", evidence="inferred",
    program="""
        %1
        N10 M98 P30002
        N20 M30
        %2
        N30 M99
    """,
    runs="", alarm="program-not-found", number=None, at="%1 N10", word="P30002",
)
case(
    "HNC: the words beside M98 run before the subprogram",
    control=HNC, source="general knowledge, words before calls", evidence="inferred",
    program="""
        %1
        N10 T1 M98 P2
        N20 M30
        %2
        N30 T2
        N40 M99
    """,
    runs="N10 N30 N40 N20", t=[1, 2],
)
case(
    "HNC: the words beside a call of a missing program have run",
    control=HNC, source="general knowledge, words before calls", evidence="inferred",
    program="""
        %1
        N10 T1 M98 P2
        N20 M30
    """,
    runs="N10", t=[1], alarm="program-not-found", number=None, at="%1 N10",
)
case(
    "HNC: P may be a variable in brackets",
    control=HNC, source="HD, brackets after an address", evidence="inferred",
    program="""
        %1
        N10 M98 P[#50]
        N20 M30
        %2
        N30 M99
    """,
    variables={50: 2}, runs="N10 N30 N20", calls="M98:%2",
)
case(
    "HNC: L may be a variable in brackets",
    control=HNC, source="HD, brackets after an address", evidence="inferred",
    program="""
        %1
        N10 M98 P2 L[#50+1]
        N20 M30
        %2
        N30 M99
    """,
    variables={50: 2}, runs="N10 N30*3 N20",
)

# M99 and ends

case(
    "HNC: M99 in the main program starts it over",
    pins="main_return",
    control=HNC, source="general knowledge; source 003, M99 in the main program",
    evidence="inferred",
    program="""
        %1
        N10 S1
        N20 M99
    """,
    max_cycles=3, runs="(N10 N20)*3", stop="cycles",
)
case(
    "HNC: one cycle of a main program ends with its M99",
    control=HNC, source="general knowledge; source 003, M99 in the main program",
    evidence="inferred",
    program="""
        %1
        N10 T1
        N20 M99
        N30 M30
    """,
    max_cycles=1, runs="N10 N20", t=[1], stop="cycles",
)
case(
    "HNC: M99 P goes on at its block of the caller",
    pins="return_with_p",
    control=HNC, source="source 003, M99 Pn", evidence="source document",
    program="""
        %1
        N10 M98 P2
        N20 S2
        N30 M30
        %2
        N40 M99 P30
    """,
    runs="N10 N40 N30",
)
case(
    "HNC: M99 P ends a call of which passes remain",
    pins="return_with_p",
    control=HNC, source="source 003, M99 Pn; of passes nobody says", evidence="inferred",
    program="""
        %1
        N10 M98 P2 L3
        N20 S2
        N30 M30
        %2
        N40 M99 P30
    """,
    runs="N10 N40 N30",
)
case(
    "HNC: M99 P takes the first block of its number in the caller",
    pins="return_search",
    control=HNC, source="policy, nobody says", evidence="inferred",
    program="""
        %1
        N10 G4 P1
        N30 G4 P2
        N40 #1=#1+1
        N50 IF #1 EQ 1
        N60 M98 P2
        N70 ENDIF
        N30 G4 P3
        N80 M30
        %2
        N90 M99 P30
    """,
    runs="N10 N30 N40 N50 N60 N90 N30 N40 N50 N70 N30 N80",
)
case(
    "HNC: M99 P of a block that the caller does not have alarms",
    control=HNC, source="source 003, M99 Pn", evidence="inferred",
    program="%1\nN10 M98 P2\nN20 M30\n%2\nN30 M99 P99",
    runs="N10", alarm="return-target-not-found", number=None, at="%2 N30",
)
case(
    "HNC: M99 P in the main program goes on at its block",
    control=HNC, source="source 003, M99 Pn", evidence="inferred",
    program="""
        %1
        N10 IF #1 EQ 2
        N20 M30
        N30 ENDIF
        N40 #1=#1+1
        N50 M99 P10
    """,
    runs="(N10 N30 N40 N50)*2 N10 N20",
)
case(
    "HNC: M98 does not run in MDI",
    pins="mdi_calls",
    control=HNC, source="source 003, M98 in MDI", evidence="source document",
    program="%2\nN10 M99", mdi="M98 P2", alarm="call-in-mdi", number=None,
)
case(
    "HNC: the words beside M99 run before the return",
    control=HNC, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 T2
        N30 M30
        %2
        N40 T1 M99
    """,
    runs="N10 N40 N20 N30", t=[1, 2],
)
case(
    "HNC: M30 in a subprogram ends the run",
    pins="end_in_subprogram",
    control=HNC, source="general knowledge, M30", evidence="inferred",
    program="""
        %1
        N10 M98 P2 L3
        N20 M30
        %2
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "HNC: M02 ends the run and the blocks after it do not run",
    control=HNC, source="general knowledge, M02", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 M02
        N30 S3
    """,
    runs="N10 N20",
)
case(
    "HNC: a main program without M30, M02 or M99 is refused at its end",
    pins="missing_end",
    control=HNC, source="general knowledge, file ends without M30, M02 or M99",
    evidence="inferred",
    program="""
        %1
        N10 S1
        N20 S2
    """,
    runs="N10 N20", alarm="end-of-record", number=None,
)
case(
    "HNC: a subprogram without M99 does not run on into the next program",
    control=HNC, source="general knowledge, file ends without M30, M02 or M99",
    evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 S3
        %3
        N40 M99
    """,
    runs="N10 N30", alarm="end-of-record", number=None,
)

# Levels

case(
    "HNC: nine levels of subprograms are legal, all the way in and out",
    control=HNC, source="HS, MAX_PROG_NUM 9", evidence="inferred",
    program=chain(9),
    runs=way_in(10) + " " + " ".join(f"N{k}" for k in range(110, 100, -1)),
)
case(
    "HNC: the tenth level is refused",
    control=HNC, source="HS, MAX_PROG_NUM 9", evidence="inferred",
    program=chain(10), runs=way_in(9), alarm="nesting-too-deep", number=None, at="%10 N10",
)
case(
    "HNC: the words beside the call that is one level too deep have run",
    control=HNC, source="HS, MAX_PROG_NUM 9", evidence="inferred",
    program=chain(10).replace("N10 M98", "N10 T5 M98"),
    runs=way_in(10), t=[5], alarm="nesting-too-deep", number=None, at="%10 N10",
)
case(
    "HNC: repeats are not levels",
    control=HNC, source="HS, MAX_PROG_NUM 9", evidence="inferred",
    program=chain(9).replace("N9 M98 P10", "N9 M98 P10 L20"),
    runs=way_in(9) + " (N10 N110)*20 " + " ".join(f"N{k}" for k in range(109, 100, -1)),
)
case(
    "HNC: a program that calls itself goes nine levels deep",
    pins="self_call",
    control=HNC, source="HS, MAX_PROG_NUM 9", evidence="inferred",
    program="""
        %1
        N10 M98 P1
        N20 M30
    """,
    runs="N10*9", alarm="nesting-too-deep", number=None, at="%1 N10",
)
