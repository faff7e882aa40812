"""Worked examples of Mitsubishi, GSK and Huazhong controls.

The X values of the motion blocks tell in which order the blocks ran.
"""

from conformance import case

case(
    "H200 starts the subprogram at N200 (MIT-003)",
    pins="whole_numbers",
    control="mitsubishi-m700",
    source="source 004, H",
    evidence="source document",
    program="""
        O1
        M98 P2 H200
        G0 X2
        M30
        O2
        G0 X10
        N100 G0 X11
        N200 G0 X12
        M99
    """,
    moves_x=[12, 2],
)

case(
    "with H and L every repetition starts at N200 (MIT-004)",
    control="mitsubishi-m700",
    source="source 004, H and L; restart at H: general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2 H200 L2
        G0 X2
        M30
        O2
        G0 X10
        N200 G0 X12
        M99
    """,
    moves_x=[12, 12, 2],
)

case(
    "with L0 the call is left out and the run goes on (MIT-007)",
    control="mitsubishi-m700",
    source="source 004, L0",
    evidence="source document",
    program="""
        O1
        G0 X1
        M98 P2 L0
        G0 X2
        M30
        O2
        G0 X10
        M99
    """,
    moves_x=[1, 2],
)

case(
    "M98 H100 without a P calls its own program on the M700, and M99 returns behind it (MIT-009)",
    pins="omitted_program",
    control="mitsubishi-m700",
    source="IMD, P omitted; general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G0 X1
        M98 H100
        G0 X2
        M30
        N100 G0 X20
        M99
    """,
    moves_x=[1, 20, 2],
)

case(
    "M98 H100 L3 calls the part of its own program three times (MIT-010)",
    control="mitsubishi-m700",
    source="IMD, P omitted; general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G0 X1
        M98 H100 L3
        G0 X2
        M30
        N100 G0 X20
        M99
    """,
    moves_x=[1, 20, 20, 20, 2],
)

case(
    "a bare M98 jumps to the head of its program on the MELDAS of source 004 (MIT-012)",
    pins="whole_numbers omitted_program",
    control="mitsubishi-meldas",
    source="source 004, P, H and L omitted",
    evidence="source document",
    program="""
        O1
        G0 X1
        M98
        M30
    """,
    max_cycles=6,
    moves_x=[1, 1, 1, 1, 1, 1],
    stop="cycles",
)

case(
    "M99 P300 goes on at N300 of the caller (MIT-013)",
    control="mitsubishi-m700",
    source="source 004, M99 P",
    evidence="source document",
    program="""
        O1
        M98 P2
        G0 X2
        N300 G0 X3
        M30
        O2
        G0 X10
        M99 P300
    """,
    moves_x=[10, 3],
)

case(
    "M99 P300 alarms where the caller has no N300 (MIT-014)",
    control="mitsubishi-m700",
    source="source 004, P231",
    evidence="source document",
    program="""
        O1
        M98 P2
        G0 X2
        M30
        O2
        G0 X10
        M99 P300
    """,
    moves_x=[10],
    alarm="return-target-not-found",
    number="P231",
    at="O2",
)

case(
    "eight nested levels are legal on the M700 (MIT-017)",
    pins="max_nesting max_total_nesting",
    control="mitsubishi-m700",
    source="SM 13.9 (6); MZ 842",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M98 P7
        M99
        O7
        G0 X7
        M98 P8
        M99
        O8
        G0 X8
        M98 P9
        M99
        O9
        G0 X9
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9],
)

case(
    "the ninth level alarms on the M700 (MIT-018)",
    control="mitsubishi-m700",
    source="SM 13.9 (6); MZ 842; P230: source 004",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M98 P7
        M99
        O7
        G0 X7
        M98 P8
        M99
        O8
        G0 X8
        M98 P9
        M99
        O9
        G0 X9
        M98 P10
        M99
        O10
        G0 X10
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9],
    alarm="nesting-too-deep",
    number="P230",
    at="O9",
)

case(
    "four levels are legal and the fifth alarms on the MELDAS of source 004 (MIT-019)",
    pins="program_word max_nesting max_total_nesting",
    control="mitsubishi-meldas",
    source="source 004, P230",
    evidence="source document",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M99
    """,
    moves_x=[2, 3, 4, 5],
    alarm="nesting-too-deep",
    number="P230",
    at="O5",
)

case(
    "the move of an M98 block comes before the call (MIT-020)",
    control="mitsubishi-m700",
    source="SM 13.9 (3)",
    evidence="maker's manual",
    program="""
        O1
        G0 X1 M98 P2
        G0 X2
        M30
        O2
        G0 X10
        M99
    """,
    moves_x=[1, 10, 2],
)

case(
    "M30 in a subprogram ends the run on the M700 (MIT-022)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2
        G0 X2
        M30
        O2
        G0 X10
        M30
    """,
    moves_x=[10],
)

case(
    "a file name of 39 characters alarms (MIT-024)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        M98 <ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.NC>
        M30
    """,
    moves_x=[],
    alarm="illegal-program-name",
    number="P232",
    at="O1",
)

case(
    "M98 P0002 calls O2 (MIT-025)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        M98 P0002
        M30
        O2
        G0 X10
        M99
    """,
    moves_x=[10],
)

case(
    "a program number of eight digits can be called (MIT-026)",
    control="mitsubishi-m700",
    source="IMD, P",
    evidence="secondary",
    program="""
        O1
        M98 P12345678
        M30
        O12345678
        G0 X10
        M99
    """,
    moves_x=[10],
)

case(
    "Q in M98 is no start word and is passed over (MIT-029)",
    control="mitsubishi-m700",
    source="IMD, Q",
    evidence="secondary",
    program="""
        O1
        M98 P2 Q200
        M30
        O2
        G0 X10
        N200 G0 X12
        M99
    """,
    moves_x=[10, 12],
)

case(
    "a subprogram that comes to its end without M99 alarms (MIT-030)",
    control="mitsubishi-m700",
    source="SK P36; MZ 810",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        M98 P2
        M30
        O2
        G0 X10
    """,
    moves_x=[1, 10],
    alarm="end-of-record",
    number="P36",
)

case(
    "a repeated subprogram repeats its own call in each pass (MIT-031)",
    control="mitsubishi-m700",
    source="SM 13.9; source 004, L",
    evidence="maker's manual",
    program="""
        O1
        M98 P2 L2
        G0 X2
        M30
        O2
        G0 X10
        M98 P3 L2
        G0 X11
        M99
        O3
        G0 X30
        M99
    """,
    moves_x=[10, 30, 30, 11, 10, 30, 30, 11, 2],
)

case(
    "a /M98 that is skipped calls nothing (MIT-032)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G0 X1
        /M98 P2
        G0 X2
        M30
        O2
        G0 X10
        M99
    """,
    skip=(1,),
    moves_x=[1, 2],
)

case(
    "G65 puts A, B, X and Z into #1, #2, #24 and #26 (MIT-101)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 A1.5 B2 X7 Z8
        M30
        O2
        G0 X#1
        G0 X#2
        G0 X#24
        G0 X#26
        M99
    """,
    arguments={1: 1.5, 2: 2, 24: 7, 26: 8},
    moves_x=[1.5, 2, 7, 8],
)

case(
    "M99 of a macro gives the caller's locals back (MIT-102)",
    control="mitsubishi-m700",
    source="SM 13.9 (5)",
    evidence="maker's manual",
    program="""
        O1
        #1=5
        G65 P2 A1
        G0 X#1
        M30
        O2
        G0 X#1
        #1=9
        M99
    """,
    moves_x=[1, 5],
)

case(
    "four macro levels are legal (MIT-104)",
    control="mitsubishi-m700",
    source="SM 13.9 (6)",
    evidence="maker's manual",
    program="""
        O1
        G65 P2
        M30
        O2
        G0 X2
        G65 P3
        M99
        O3
        G0 X3
        G65 P4
        M99
        O4
        G0 X4
        G65 P5
        M99
        O5
        G0 X5
        M99
    """,
    moves_x=[2, 3, 4, 5],
)

case(
    "the fifth macro level alarms (MIT-105)",
    control="mitsubishi-m700",
    source="SM 13.9 (6); MZ 855, paired with P273",
    evidence="secondary",
    program="""
        O1
        G65 P2
        M30
        O2
        G0 X2
        G65 P3
        M99
        O3
        G0 X3
        G65 P4
        M99
        O4
        G0 X4
        G65 P5
        M99
        O5
        G0 X5
        G65 P6
        M99
        O6
        G0 X6
        M99
    """,
    moves_x=[2, 3, 4, 5],
    alarm="macro-nesting-too-deep",
    number="P273",
    at="O5",
)

case(
    "four macro levels on five of M98 are one level too many (MIT-106)",
    pins="nesting_counts_macros",
    control="mitsubishi-m700",
    source="SM 13.9 (6); MZ 842",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        G65 P7
        M99
        O7
        G0 X7
        G65 P8
        M99
        O8
        G0 X8
        G65 P9
        M99
        O9
        G0 X9
        G65 P10
        M99
        O10
        G0 X10
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9],
    alarm="nesting-too-deep",
    number="P230",
    at="O9",
)

case(
    "G65 without a P alarms on the M700 (MIT-107)",
    control="mitsubishi-m700",
    source="MZ 893, paired with P296",
    evidence="secondary",
    program="""
        O1
        G0 X1
        G65 A1
        M30
    """,
    moves_x=[1],
    alarm="program-number-missing",
    number="P296",
    at="O1",
)

case(
    "G66 calls behind each move, and neither in its own block nor behind an M code (MIT-108)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G66 P2 A5
        G0 X1
        M8
        G0 X2
        G67
        G0 X3
        M30
        O2
        G0 X#1
        M99
    """,
    moves_x=[1, 5, 2, 5, 3],
)

case(
    "an eleventh set of I alarms on the M700 (MIT-111)",
    control="mitsubishi-m700",
    source="MZ 856, paired with P275",
    evidence="secondary",
    program="""
        O1
        G65 P2 I1 I2 I3 I4 I5 I6 I7 I8 I9 I10 I11
        M30
        O2
        M99
    """,
    moves_x=[],
    alarm="too-many-argument-sets",
    number="P275",
    at="O1",
)

case(
    "the second pass of G65 L2 finds the locals as the first left them (MIT-112)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 L2 A1
        M30
        O2
        G0 X#1
        #1=#1+1
        M99
    """,
    moves_x=[1, 2],
)

case(
    "IF GOTO jumps where the condition is true and only there (MIT-113)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=3
        IF[#1 EQ 3]GOTO 20
        G0 X9
        N20 G0 X1
        IF[#1 EQ 4]GOTO 30
        G0 X2
        N30 M30
    """,
    moves_x=[1, 2],
)

case(
    "of two blocks with one number GOTO takes the next one behind it (MIT-115)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        N10 G0 X1
        GOTO 10
        G0 X9
        N10 G0 X2
        M30
    """,
    moves_x=[1, 2],
)

case(
    "GOTO finds a block before it (MIT-116)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=0
        N10 G0 X1
        #1=#1+1
        IF[#1 LT 3]GOTO 10
        G0 X2
        M30
    """,
    moves_x=[1, 1, 1, 2],
)

case(
    "WHILE runs its loop as long as the condition is true (MIT-117)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=1
        WHILE[#1 LE 3]DO1
        G0 X#1
        #1=#1+1
        END1
        G0 X9
        M30
    """,
    moves_x=[1, 2, 3, 9],
)

case(
    "a DO without its END alarms on the M700 (MIT-118)",
    control="mitsubishi-m700",
    source="MZ 868, paired with P294",
    evidence="secondary",
    program="""
        O1
        #1=1
        WHILE[#1 LE 3]DO1
        G0 X#1
        M30
    """,
    moves_x=[],
    alarm="missing-end",
    number="P294",
    at="O1",
)

case(
    "M98 works inside a WHILE (MIT-119)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=1
        WHILE[#1 LE 2]DO1
        M98 P2
        #1=#1+1
        END1
        M30
        O2
        G0 X#1
        M99
    """,
    moves_x=[1, 2],
)

case(
    "a bracket that is not closed alarms (MIT-121)",
    control="mitsubishi-m700",
    source="MZ 859, paired with P281",
    evidence="secondary",
    program="""
        O1
        G0 X1
        #1=[2+3
        M30
    """,
    moves_x=[1],
    alarm="bracket-not-closed",
    number="P281",
    at="O1",
)

case(
    "#3000=5 stops with P277 (MIT-123)",
    control="mitsubishi-m700",
    source="MZ 979, paired with P277",
    evidence="secondary",
    program="""
        O1
        G0 X1
        #3000=5(TEST)
        M30
    """,
    moves_x=[1],
    alarm="user-alarm",
    number="P277",
    at="O1",
)

case(
    "a vacant variable takes its word out of the block on the M700 (MIT-124)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G0 X#1
        G0 X2
        M30
    """,
    moves_x=[2],
)

case(
    "ten levels are legal on the M800 (MIT-126)",
    pins="whole_numbers program_word max_nesting max_total_nesting",
    control="mitsubishi-m800",
    source="CW; general knowledge of the M800 manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M98 P7
        M99
        O7
        G0 X7
        M98 P8
        M99
        O8
        G0 X8
        M98 P9
        M99
        O9
        G0 X9
        M98 P10
        M99
        O10
        G0 X10
        M98 P11
        M99
        O11
        G0 X11
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9, 10, 11],
)

case(
    "P21006 runs O1006 twice on the 988TA (TA-001)",
    pins="whole_numbers refuses",
    control="gsk-988ta",
    source="TA28 p.7; source 000, P",
    evidence="maker's manual",
    program="""
        O1
        M98 P21006
        G0 X2
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 50, 2],
)

case(
    "P1006 runs O1006 once on the 988TA (TA-002)",
    control="gsk-988ta",
    source="source 000, P (1)",
    evidence="source document",
    program="""
        O1
        M98 P1006
        G0 X2
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 2],
)

case(
    "a count in P and an L in one block alarm (TA-004)",
    control="gsk-988ta",
    source="source 000, words L and Q (3)",
    evidence="source document",
    program="""
        O1
        G0 X1
        M98 P21006 L2
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[1],
    alarm="repeat-given-twice",
    number="293",
    at="O1",
)

case(
    "P1006 L3 runs O1006 three times (TA-005)",
    control="gsk-988ta",
    source="source 000, words L and Q (2)",
    evidence="source document",
    program="""
        O1
        M98 P1006 L3
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 50, 50],
)

case(
    "Q5 starts the subprogram at N5 (TA-006)",
    pins="point_addresses minus_addresses",
    control="gsk-988ta",
    source="TA28 p.3, figure; source 000, words L and Q (1)",
    evidence="maker's manual",
    program="""
        O1
        G1 X12.22
        M98 P2121 Q5
        G1 X-10
        M30
        O2121
        G1 X40
        N5 G1 X50
        M99
    """,
    moves_x=[12.22, 50, -10],
)

case(
    "every repetition starts at Q (TA-007)",
    control="gsk-988ta",
    source="TA28 p.3, figure",
    evidence="maker's manual",
    program="""
        O1
        M98 P2121 Q5 L3
        M30
        O2121
        G1 X40
        N5 G1 X50
        M99
    """,
    moves_x=[50, 50, 50],
)

case(
    "Q without a P is looked for in the program that runs, not in the main program (TA-010)",
    pins="omitted_program self_call max_total_nesting",
    control="gsk-988ta",
    source="TA28 p.4, figure",
    evidence="maker's manual",
    program="""
        O1
        G1 X12.22
        M98 P2121 Q2 L2
        G1 X-10
        M30
        O2121
        G1 X77
        N2 G1 X50
        M98 Q5 L2
        G1 X31
        M99
        N5 G1 X51
        M99
    """,
    moves_x=[12.22, 50, 51, 51, 31, 50, 51, 51, 31, -10],
)

case(
    "P[O0023] L3 runs the standard program O0023 three times (TA-011)",
    pins="bracket_names",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="source document",
    program="""
        O1
        M98 P[O0023] L3
        M30
        O0023
        G1 X5
        M99
    """,
    moves_x=[5, 5, 5],
)

case(
    "P[T0023] runs the program named T0023 (TA-012)",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="source document",
    files={
        "O1.CNC": """
            O1
            M98 P[T0023] L2
            M30
        """,
        "T0023.CNC": """
            G1 X6
            M99
        """,
    },
    main="O1",
    moves_x=[6, 6],
)

case(
    "P[#100] with 23.34 runs O0023 (TA-013)",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="source document",
    program="""
        O1
        #100=23.34
        M98 P[#100] L3
        M30
        O0023
        G1 X5
        M99
    """,
    moves_x=[5, 5, 5],
)

case(
    "P#100 with 21006.7 runs O1006 twice (TA-015)",
    pins="call_values",
    control="gsk-988ta",
    source="source 000, P (2)",
    evidence="source document",
    program="""
        O1
        #100=21006.7
        M98 P#100
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 50],
)

case(
    "P#100 with a value of nine digits alarms (TA-016)",
    pins="max_program_digits",
    control="gsk-988ta",
    source="source 000, P (2); the number 003: Talm 003 of the 988T",
    evidence="inferred",
    program="""
        O1
        #100=123456789
        G0 X1
        M98 P#100
        M30
    """,
    moves_x=[1],
    alarm="too-many-digits",
    number="003",
    at="O1",
)

case(
    "M98 to a program that is not there alarms on the 988TA (TA-017)",
    control="gsk-988ta",
    source="source 000, note 3; Talm 083 of the 988T",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98 P1006
        M30
    """,
    moves_x=[1],
    alarm="program-not-found",
    number="083",
    at="O1",
)

case(
    "M98 with neither P nor Q alarms (TA-018)",
    control="gsk-988ta",
    source="source 000, note 5; Talm 081 of the 988T",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98
        M30
    """,
    moves_x=[1],
    alarm="program-number-missing",
    number="081",
    at="O1",
)

case(
    "twelve levels are legal on the 988TA (TA-019)",
    pins="max_nesting",
    control="gsk-988ta",
    source="source 000, M98",
    evidence="source document",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M98 P7
        M99
        O7
        G0 X7
        M98 P8
        M99
        O8
        G0 X8
        M98 P9
        M99
        O9
        G0 X9
        M98 P10
        M99
        O10
        G0 X10
        M98 P11
        M99
        O11
        G0 X11
        M98 P12
        M99
        O12
        G0 X12
        M98 P13
        M99
        O13
        G0 X13
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13],
)

case(
    "the thirteenth level alarms on the 988TA (TA-020)",
    control="gsk-988ta",
    source="source 000, M98; Talm 082 of the 988T",
    evidence="secondary",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M98 P7
        M99
        O7
        G0 X7
        M98 P8
        M99
        O8
        G0 X8
        M98 P9
        M99
        O9
        G0 X9
        M98 P10
        M99
        O10
        G0 X10
        M98 P11
        M99
        O11
        G0 X11
        M98 P12
        M99
        O12
        G0 X12
        M98 P13
        M99
        O13
        G0 X13
        M98 P14
        M99
        O14
        G0 X14
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13],
    alarm="nesting-too-deep",
    number="082",
    at="O13",
)

case(
    "M99 P99 alarms where the caller has no N99 (TA-022)",
    pins="return_with_p",
    control="gsk-988ta",
    source="source 000, note 1; Talm 083 of the 988T",
    evidence="secondary",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X1
        M99 P99
    """,
    moves_x=[1],
    alarm="return-target-not-found",
    number="083",
    at="O2",
)

case(
    "of two N7 behind the call M99 P7 takes the earlier one (TA-024)",
    control="gsk-988ta",
    source="source 000, note 2 (2)",
    evidence="source document",
    program="""
        O1
        N50 M98 P2
        G0 X3
        N7 G0 X1
        M30
        N7 G0 X2
        M30
        O2
        G0 X9
        M99 P7
    """,
    moves_x=[9, 1],
)

case(
    "of two N7 around the call M99 P7 takes the one behind it (TA-025)",
    pins="return_search jumps",
    control="gsk-988ta",
    source="source 000, note 2 (3)",
    evidence="source document",
    program="""
        O1
        GOTO 50
        N7 G0 X1
        M30
        N50 M98 P2
        G0 X3
        N7 G0 X2
        M30
        O2
        G0 X9
        M99 P7
    """,
    moves_x=[9, 2],
)

case(
    "a star in the name of a program alarms (TA-027)",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="inferred",
    program="""
        O1
        G0 X1
        M98 P[A*B]
        M30
    """,
    moves_x=[1],
    alarm="illegal-program-name",
    at="O1",
)

case(
    "a call in MDI alarms on the 988T (TA-028)",
    pins="whole_numbers mdi_calls",
    control="gsk-988t",
    source="Talm 085",
    evidence="maker's manual",
    program="""
        O2
        M99
    """,
    mdi="""
        G0 X1
        M98 P2
        M30
    """,
    moves_x=[1],
    alarm="call-in-mdi",
    number="085",
)

case(
    "a call from a subprogram called in MDI alarms on the 988TA (TA-029)",
    pins="mdi_calls",
    control="gsk-988ta",
    source="source 000, note 4; Talm 085 of the 988T",
    evidence="secondary",
    program="""
        O2
        G0 X2
        M98 P3
        M99
        O3
        M99
    """,
    mdi="""
        M98 P2
        M30
    """,
    moves_x=[2],
    alarm="call-in-mdi",
    number="085",
    at="O2",
)

case(
    "a program that calls itself without Q alarms on the 988T (TA-030)",
    pins="self_call",
    control="gsk-988t",
    source="Talm 084",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        M98 P1
        M30
    """,
    moves_x=[1],
    alarm="program-calls-itself",
    number="084",
    at="O1",
)

case(
    "G65 P[T123] L2 runs the program named T123 twice with its argument (TA-032)",
    pins="macro_calls",
    control="gsk-988ta",
    source="TA27",
    evidence="maker's manual",
    files={
        "O1.CNC": """
            O1
            G65 P[T123] L2 A4
            M30
        """,
        "T123.CNC": """
            G0 X#1
            M99
        """,
    },
    main="O1",
    arguments={1: 4},
    moves_x=[4, 4],
)

case(
    "G65 P[#100] with a value of five digits alarms (TA-033)",
    control="gsk-988ta",
    source="TA27",
    evidence="maker's manual",
    program="""
        O1
        #100=21234
        G65 P[#100] L2
        M30
    """,
    moves_x=[],
    alarm="illegal-macro-number",
    number="291",
    at="O1",
)

case(
    "G67 without G66 alarms on the 988TA (TA-036)",
    pins="cancel_alone",
    control="gsk-988ta",
    source="Talm 218 of the 988T",
    evidence="secondary",
    program="""
        O1
        G0 X1
        G67
        M30
    """,
    moves_x=[1],
    alarm="modal-call-missing",
    number="218",
    at="O1",
)

case(
    "G500, T2 and M31 call O9039, O9012 and O9020 (TA-037)",
    control="gsk-988ta",
    source="TA27",
    evidence="maker's manual",
    program="""
        O1
        G500
        T2
        M31
        M30
        O9039
        G0 X39
        M99
        O9012
        G0 X12
        M99
        O9020
        G0 X20
        M99
    """,
    params={"6062": 2, "6080": 31, "6099": 500, "6008#5": 1, "6008#6": 1, "6008#7": 1},
    moves_x=[39, 12, 20],
)

case(
    "macro calls count among the twelve levels of the 988TA (TA-042)",
    pins="nesting_counts_macros max_macro_nesting",
    control="gsk-988ta",
    source="source 000, M98",
    evidence="source document",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M98 P7
        M99
        O7
        G0 X7
        M98 P8
        M99
        O8
        G0 X8
        M98 P9
        M99
        O9
        G0 X9
        M98 P10
        M99
        O10
        G0 X10
        G65 P11
        M99
        O11
        G0 X11
        G65 P12
        M99
        O12
        G0 X12
        G65 P13
        M99
        O13
        G0 X13
        G65 P14
        M99
        O14
        G0 X14
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13],
    alarm="nesting-too-deep",
    number="082",
    at="O13",
)

case(
    "P12002 runs O2002 once (TD-001)",
    pins="whole_numbers program_word",
    control="gsk-980tdi",
    source="TDi15",
    evidence="maker's manual",
    program="""
        O1
        M98 P12002
        G0 X2
        M30
        O2002
        G0 X20
        M99
    """,
    moves_x=[20, 2],
)

case(
    "P20 runs O0020 (TD-003)",
    control="gsk-980tdi",
    source="TDi15",
    evidence="maker's manual",
    program="""
        O1
        M98 P20
        M30
        O0020
        G0 X20
        M99
    """,
    moves_x=[20],
)

case(
    "a program may have a Chinese name (TD-005)",
    pins="bracket_names",
    control="gsk-980tdi",
    source="TDi15",
    evidence="maker's manual",
    files={
        "O1.CNC": """
            O1
            M98 P[螺纹切削]
            M30
        """,
        "螺纹切削.CNC": """
            G0 X8
            M99
        """,
    },
    main="O1",
    moves_x=[8],
)

case(
    "H01, H02 and H84 make a loop (TD-006)",
    pins="macro_calls",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G65 H01 P#100 Q0
        N10 G65 H02 P#100 Q#100 R1
        G0 X#100
        G65 H84 P10 Q#100 R3
        M30
    """,
    moves_x=[1, 2, 3],
)

case(
    "H80 jumps (TD-007)",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        G65 H80 P120
        G0 X9
        N120 G0 X2
        M30
    """,
    moves_x=[1, 2],
)

case(
    "H99 P15 stops with the alarm 5915 (TD-008)",
    pins="h99_offset",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        G65 H99 P15(/TEXT)
        M30
    """,
    moves_x=[1],
    alarm="user-alarm",
    number="5915",
    at="O1",
)

case(
    "a vacant variable counts as 0 in a word of the 980TDi (TD-009)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G0 X#1
        M30
    """,
    moves_x=[0],
)

case(
    "G65 P9010 fills #1 to #12 as the manual's example says (TD-010)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G65 P9010 A1 B2 C3 I14 J15 I6 J7 K9 K11 K12 J30
        M30
        O9010
        G0 X#1
        G0 X#4
        G0 X#5
        G0 X#6
        G0 X#7
        G0 X#8
        G0 X#9
        G0 X#11
        G0 X#12
        M99
    """,
    arguments={1: 1, 2: 2, 3: 3, 4: 14, 5: 15, 6: 9, 7: 6, 8: 7, 9: 11, 11: 30, 12: 12},
    moves_x=[1, 14, 15, 9, 6, 7, 11, 30, 12],
)

case(
    "G66 with L2 calls twice behind a move on the 980TDi (TD-011)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G66 P100 L2 A2
        G98 G01 X80 F100
        G67
        G01 X20
        M30
        O100
        G0 X#1
        M99
    """,
    moves_x=[80, 2, 2, 20],
)

case(
    "M17 calls O5 by the parameters 89 to 91 (TD-012)",
    control="gsk-980tdi",
    source="TDi17",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        M17
        M30
        O5
        G0 X5
        M99
    """,
    params={"89": 17, "90": 5, "91": 1},
    moves_x=[1, 5],
)

case(
    "G100 calls O2000 with arguments by the parameters 86 to 88 (TD-013)",
    control="gsk-980tdi",
    source="TDi32",
    evidence="maker's manual",
    program="""
        O1
        G100 A1 B2
        M30
        O2000
        G0 X#1
        G0 X#2
        M99
    """,
    params={"86": 1, "87": 100, "88": 2000},
    arguments={1: 1, 2: 2},
    moves_x=[1, 2],
)

case(
    "the manual's sum of 1 to 10 is 55 (TD-014)",
    control="gsk-980tdi",
    source="TDi29, example",
    evidence="maker's manual",
    program="""
        O9500
        #1=0
        #2=1
        N1 IF[#2 GT 10]GOTO2
        #1=#1+#2
        #2=#2+1
        GOTO1
        N2 G0 X#1
        M30
    """,
    moves_x=[55],
)

case(
    "M98 to a program that is not there alarms on the 980TDi (TD-015)",
    control="gsk-980tdi",
    source="MDia 001 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98 P2002
        M30
    """,
    moves_x=[1],
    alarm="program-not-found",
    number="0001",
    at="O1",
)

case(
    "a program that calls itself alarms on the 980TDi (TD-016)",
    pins="self_call",
    control="gsk-980tdi",
    source="MDia 097 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98 P1
        M30
    """,
    moves_x=[1],
    alarm="program-calls-itself",
    number="0097",
    at="O1",
)

case(
    "a subprogram that calls the main program alarms (TD-017)",
    control="gsk-980tdi",
    source="MDia 094 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P1
        M99
    """,
    moves_x=[2],
    alarm="program-calls-caller",
    number="0094",
    at="O2",
)

case(
    "the fifth level alarms on the 980TDi (TD-019)",
    control="gsk-980tdi",
    source="MDia 096 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M99
    """,
    moves_x=[2, 3, 4, 5],
    alarm="nesting-too-deep",
    number="0096",
    at="O5",
)

case(
    "M98 under G66 alarms (TD-021)",
    control="gsk-980tdi",
    source="MDia 113 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G66 P2
        M98 P2
        M30
        O2
        M99
    """,
    moves_x=[],
    alarm="call-in-modal-call",
    number="0113",
    at="O1",
)

case(
    "H05 by zero alarms (TD-022)",
    control="gsk-980tdi",
    source="MDia 105 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G65 H05 P#100 Q5 R0
        M30
    """,
    moves_x=[],
    alarm="division-by-zero",
    number="0105",
    at="O1",
)

case(
    "H99 P100 is no user alarm (TD-023)",
    control="gsk-980tdi",
    source="MDia 126 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G65 H99 P100
        M30
    """,
    moves_x=[],
    alarm="illegal-user-alarm",
    number="0126",
    at="O1",
)

case(
    "a value assigned to #0 alarms on the 980TDi (TD-024)",
    control="gsk-980tdi",
    source="MDia 117 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        #0=1
        M30
    """,
    moves_x=[],
    alarm="vacant-assigned",
    number="0117",
    at="O1",
)

case(
    "#9100 is the variable whose number stands in #100 (TD-026)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        #100=205
        #205=500
        G0 X#9100
        M30
    """,
    moves_x=[500],
)

case(
    "H27 is the root of two squares, and H26 multiplies and divides (TD-027)",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        #101=3
        #102=4
        G65 H27 P#103 Q#101 R#102
        G0 X#103
        #104=10
        G65 H26 P#104 Q#101 R#102
        G0 X#104
        M30
    """,
    moves_x=[5, 7.5],
)

case(
    "H31 takes its angle in degrees (TD-028)",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G65 H31 P#101 Q100 R30
        G0 X#101
        M30
    """,
    moves_x=[50],
)

case(
    "G65 ends the modal call on the 980TDi (TD-029)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G66 P100
        G0 X1
        G65 P200
        G0 X2
        M30
        O100
        G0 X10
        M99
        O200
        G0 X20
        M99
    """,
    moves_x=[1, 10, 20, 2],
)

case(
    "the part between M98 and M97 runs five times and is then jumped over (928-001)",
    pins="whole_numbers",
    control="gsk-928te",
    source="source 001, method 1",
    evidence="source document",
    program="""
        %1
        N0010 G00 X100 Z50
        N0020 M03
        N0030 G0 X50 F500
        N0040 M98 P0060 L5
        N0050 M97 P0130
        N0060 G0 X60
        N0070 G01 X70
        N0120 M99
        N0130 G0 X130
        N0140 M05
        N0140 M02
    """,
    runs="N10 N20 N30 N40 (N60 N70 N120)*5 N50 N130 N140 N140",
    moves_x=[100, 50, 60, 70, 60, 70, 60, 70, 60, 70, 60, 70, 130],
)

case(
    "the part behind M02 runs five times (928-002)",
    control="gsk-928te",
    source="source 001, method 2",
    evidence="source document",
    program="""
        %1
        N0010 G00 X100
        N0030 G0 X66 F500
        N0040 M98 P0080 L5
        N0050 G0 X101
        N0060 M05
        N0070 M02
        N0080 G0 X80
        N0090 G01 X90
        N0140 M99
    """,
    runs="N10 N30 N40 (N80 N90 N140)*5 N50 N60 N70",
    moves_x=[100, 66, 80, 90, 80, 90, 80, 90, 80, 90, 80, 90, 101],
)

case(
    "M99 without M98 ends the program (928-003)",
    control="gsk-928te",
    source="source 001, M99",
    evidence="source document",
    program="""
        %1
        N0010 G0 X1
        N0020 M99
        N0030 G0 X2
        N0040 M02
    """,
    runs="N10 N20",
    moves_x=[1],
)

case(
    "a part without M99 runs once, whatever L says, and runs on (928-004)",
    control="gsk-928te",
    source="source 001, M98 alone",
    evidence="source document",
    program="""
        %1
        N0010 M98 P0030 L5
        N0020 M02
        N0030 G0 X3
        N0040 G0 X4
        N0050 M02
    """,
    runs="N10 N30 N40 N50",
    moves_x=[3, 4],
)

case(
    "M97 jumps to its sequence number (928-005)",
    control="gsk-928te",
    source="source 001, M97",
    evidence="source document",
    program="""
        %1
        N0010 G0 X1
        N0020 M97 P0040
        N0030 G0 X9
        N0040 G0 X2
        N0050 M02
    """,
    runs="N10 N20 N40 N50",
    moves_x=[1, 2],
)

case(
    "eighteen levels are legal on the 928 (928-007)",
    control="gsk-928te",
    source="source 001, nesting",
    evidence="source document",
    program="""
        %1
        N0001 M98 P1001
        N0002 M02
        N1001 G0 X1
        N2001 M98 P1002
        N3001 M99
        N1002 G0 X2
        N2002 M98 P1003
        N3002 M99
        N1003 G0 X3
        N2003 M98 P1004
        N3003 M99
        N1004 G0 X4
        N2004 M98 P1005
        N3004 M99
        N1005 G0 X5
        N2005 M98 P1006
        N3005 M99
        N1006 G0 X6
        N2006 M98 P1007
        N3006 M99
        N1007 G0 X7
        N2007 M98 P1008
        N3007 M99
        N1008 G0 X8
        N2008 M98 P1009
        N3008 M99
        N1009 G0 X9
        N2009 M98 P1010
        N3009 M99
        N1010 G0 X10
        N2010 M98 P1011
        N3010 M99
        N1011 G0 X11
        N2011 M98 P1012
        N3011 M99
        N1012 G0 X12
        N2012 M98 P1013
        N3012 M99
        N1013 G0 X13
        N2013 M98 P1014
        N3013 M99
        N1014 G0 X14
        N2014 M98 P1015
        N3014 M99
        N1015 G0 X15
        N2015 M98 P1016
        N3015 M99
        N1016 G0 X16
        N2016 M98 P1017
        N3016 M99
        N1017 G0 X17
        N2017 M98 P1018
        N3017 M99
        N1018 G0 X18
        N3018 M99
    """,
    moves_x=[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18],
)

case(
    "a call inside a repeated part repeats in each pass (928-010)",
    control="gsk-928te",
    source="source 001, nesting",
    evidence="source document",
    program="""
        %1
        N0010 M98 P0100 L2
        N0020 M02
        N0100 G0 X1
        N0110 M98 P0200 L2
        N0120 M99
        N0200 G0 X2
        N0210 M99
    """,
    runs="N10 (N100 N110 (N200 N210)*2 N120)*2 N20",
    moves_x=[1, 2, 2, 1, 2, 2],
)

case(
    "M98 to a sequence number that is not there alarms on the 928 (928-011)",
    control="gsk-928te",
    source="general knowledge of GSK controls",
    evidence="inferred",
    program="""
        %1
        N0010 G0 X1
        N0020 M98 P0999
        N0030 M02
    """,
    runs="N10",
    moves_x=[1],
    alarm="start-not-found",
    at="%1 N20",
)

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
    "M98 puts A, B and X of its block into #0, #1 and #23 (HNC-002)",
    pins="whole_numbers call_passes_words",
    control="hnc-21m",
    source="general knowledge of the Century Star manuals",
    evidence="inferred",
    program="""
        %1
        G00
        M98 P2 A11 B12 X50
        M30
        %2
        G01 X[#0] F100
        G01 X[#1]
        G01 X[#23]
        M99
    """,
    arguments={0: 11, 1: 12, 23: 50},
    moves_x=[50, 11, 12, 50],
)

case(
    "IF runs its blocks where the condition is true and only there (HNC-004)",
    control="hnc-21m",
    source="HD",
    evidence="secondary",
    program="""
        %1
        #3=9
        IF #3 GE 9
        G0 X1
        ENDIF
        IF #3 LT 5
        G0 X2
        ENDIF
        M30
    """,
    moves_x=[1],
)

case(
    "ELSE runs where the condition is false (HNC-005)",
    control="hnc-21m",
    source="general knowledge of the Century Star manuals",
    evidence="inferred",
    program="""
        %1
        #3=2
        IF #3 GE 9
        G0 X1
        ELSE
        G0 X2
        ENDIF
        M30
    """,
    moves_x=[2],
)

case(
    "WHILE takes an expression without brackets (HNC-006)",
    pins="loop_form",
    control="hnc-21m",
    source="HD",
    evidence="secondary",
    program="""
        %1
        #1=0
        WHILE #1 LT 2*2
        G0 X[#1]
        #1=#1+1
        ENDW
        M30
    """,
    moves_x=[0, 1, 2, 3],
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

case(
    "a subprogram of the HNC-21 has locals of its own (HNC-010)",
    control="hnc-21m",
    source="H9",
    evidence="secondary",
    program="""
        %1
        #10=5
        M98 P2
        G0 X[#10]
        M30
        %2
        #10=9
        M99
    """,
    moves_x=[5],
)

case(
    "#210 is #10 of the main program (HNC-011)",
    control="hnc-21m",
    source="H9",
    evidence="secondary",
    program="""
        %1
        #10=98
        M98 P2
        M30
        %2
        G0 X[#210]
        M99
    """,
    moves_x=[98],
)

case(
    "G22 counts X in pulses of a thousandth of a millimetre (HNC-012)",
    pins="g_meanings",
    control="hnc-21m",
    source="source 003, G20 G21 G22; the size of the pulse: general knowledge of the Century Star manuals",
    evidence="source document",
    program="""
        %1
        G22
        G01 X100 F100
        M30
    """,
    moves_x=[0.1],
)
