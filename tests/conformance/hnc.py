"""Huazhong HNC-21M: programs, calls with arguments, locals by level, IF and WHILE, units.

No alarm numbers of this control were found, so every number here is None.
"""

from conformance import case

HNC = "hnc-21m"


def chain(levels):
    """A main program %1 from which `levels` calls are open at once."""
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
    control=HNC, source="HD, brackets behind an address", evidence="inferred",
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
    control=HNC, source="HD, brackets behind an address", evidence="inferred",
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
    "HNC: M99 P in a subprogram is refused",
    pins="return_with_p",
    control=HNC, source="general knowledge, M99 P not supported (weak)", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 S2
        N30 M30
        %2
        N40 M99 P30
    """,
    runs="N10", alarm="illegal-word-with-return", number=None, at="%2 N40",
)
case(
    "HNC: M99 P in the main program is refused",
    control=HNC, source="general knowledge, M99 P not supported (weak)", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 M99 P10
    """,
    runs="N10", alarm="illegal-word-with-return", number=None, at="%1 N20",
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
    "HNC: M02 ends the run and the blocks behind it do not run",
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

# Arguments

for letters, values in [
    ("A B C D", {0: 11, 1: 12, 2: 13, 3: 14}),
    ("I J K", {8: 11, 9: 12, 10: 13}),
    ("Q R U V W", {16: 11, 17: 12, 20: 13, 21: 14, 22: 15}),
    ("X Y Z", {23: 11, 24: 12, 25: 13}),
]:
    words = " ".join(f"{a}{11 + i}" for i, a in enumerate(letters.split()))
    body = "".join(f"N{200 + n} #{100 + n}=#{n}\n" for n in values)
    case(
        f"HNC: {letters} of the M98 block are #{min(values)} to #{max(values)} of the subprogram",
        control=HNC, source="general knowledge, A to Z become #0 to #25", evidence="inferred",
        program=f"%1\nN10 G0 M98 P2 {words}\nN20 M30\n%2\n{body}N299 M99\n",
        runs="N10 " + " ".join(f"N{200 + n}" for n in values) + " N299 N20",
        vars={100 + n: value for n, value in values.items()},
    )
case(
    "HNC: an argument may be an expression of the caller's variables",
    control=HNC, source="general knowledge, A to Z become #0 to #25; HD", evidence="inferred",
    program="""
        %1
        N10 #5=4
        N20 M98 P2 D[#5*2]
        N30 M30
        %2
        N40 #50=#3
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 8, 5: 4},
)
case(
    "HNC: a word that was not written counts as zero in the subprogram",
    control=HNC, source="general knowledge, absent words", evidence="inferred",
    program="""
        %1
        N10 #2=9
        N20 M98 P2 D1
        N30 M30
        %2
        N40 #50=#2+1
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 1},
)
case(
    "HNC: AR of a word that was not written is 0",
    control=HNC, source="general knowledge, AR[#n]", evidence="inferred",
    program="""
        %1
        N10 G0 G90
        N20 M98 P2 X5
        N30 M30
        %2
        N40 #50=AR[#24]
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 0},
)
case(
    "HNC: AR of a word written under G90 is 90",
    control=HNC, source="general knowledge, AR[#n]", evidence="inferred",
    program="""
        %1
        N10 G0 G90
        N20 M98 P2 X5
        N30 M30
        %2
        N40 #50=AR[#23]
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 90},
)
case(
    "HNC: AR of a word written under G91 is 91",
    control=HNC, source="general knowledge, AR[#n]", evidence="inferred",
    program="""
        %1
        N10 G0 G91
        N20 M98 P2 X5
        N30 M30
        %2
        N40 #50=AR[#23]
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 91},
)

# Locals by level

case(
    "HNC: each level has its own locals and the caller's come back",
    control=HNC, source="H9, nested locals", evidence="secondary",
    program="""
        %1
        N10 #30=5
        N20 #49=6
        N30 M98 P2
        N40 M30
        %2
        N50 #49=99
        N60 M99
    """,
    runs="N10 N20 N30 N50 N60 N40", vars={49: 6},
)
case(
    "HNC: #50 is the first variable that all levels share",
    control=HNC, source="H9, #50 to #199 global", evidence="secondary",
    program="""
        %1
        N10 #49=1
        N20 #50=1
        N30 M98 P2
        N40 M30
        %2
        N50 #49=7
        N60 #50=7
        N70 #199=8
        N80 M99
    """,
    runs="N10 N20 N30 N50 N60 N70 N80 N40", vars={49: 1, 50: 7, 199: 8},
)
case(
    "HNC: #2nn is the image of #nn of the main program",
    control=HNC, source="H9, level 0 is #200 to #249", evidence="secondary",
    program="""
        %1
        N10 #45=7
        N20 M98 P2
        N30 M30
        %2
        N40 #45=1
        N50 #50=#245
        N60 M99
    """,
    runs="N10 N20 N40 N50 N60 N30", vars={50: 7},
)
case(
    "HNC: the image of level 1 starts at #250",
    control=HNC, source="H9, level 1 is #250 to #299", evidence="secondary",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 #40=8
        N40 M98 P3
        N50 M99
        %3
        N60 #50=#290
        N70 M99
    """,
    runs="N10 N30 N40 N60 N70 N50 N20", vars={50: 8},
)
case(
    "HNC: a level reads itself through its own image",
    control=HNC, source="H9, the images of the levels", evidence="inferred",
    program="""
        %1
        N10 #40=6
        N20 #50=#240
        N30 M30
    """,
    runs="N10 N20 N30", vars={50: 6},
)
case(
    "HNC: two levels down the main program is still #200 to #249",
    control=HNC, source="H9, level 0 is #200 to #249", evidence="secondary",
    program="""
        %1
        N10 #40=6
        N20 M98 P2
        N30 M30
        %2
        N40 M98 P3
        N50 M99
        %3
        N60 #50=#240
        N70 M99
    """,
    runs="N10 N20 N40 N60 N70 N50 N30", vars={50: 6},
)
case(
    "HNC: there is no variable #900",
    control=HNC, source="H9, user range #0 to #899", evidence="inferred",
    program="""
        %1
        N10 #899=1
        N20 #900=1
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=None, at="%1 N20",
)

# IF

case(
    "HNC: a true IF runs its part and jumps over ELSE",
    control=HNC, source="HD, IF ELSE ENDIF", evidence="secondary",
    program="""
        %1
        N10 #1=10
        N20 IF #1 GE 10
        N30 S3
        ELSE
        N40 S4
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N30 N50",
)
case(
    "HNC: a false IF without ELSE goes on behind ENDIF",
    control=HNC, source="HD, IF ENDIF", evidence="secondary",
    program="""
        %1
        N10 #1=10
        N20 IF #1 GT 10
        N30 S3
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N50",
)
case(
    "HNC: ELSE belongs to the innermost open IF",
    control=HNC, source="HD, IF ELSE ENDIF", evidence="inferred",
    program="""
        %1
        N10 #1=10
        N20 IF #1 EQ 10
        N30 IF #1 EQ 11
        N35 S3
        ELSE
        N40 S4
        ENDIF
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50",
)
case(
    "HNC: AND joins two conditions in brackets",
    control=HNC, source="general knowledge, AND OR NOT", evidence="inferred",
    program="""
        %1
        N10 IF [#50 GT 1] AND [#51 GT 1]
        N20 S2
        ENDIF
        N30 IF [#50 GT 1] OR [#51 GT 1]
        N40 S4
        ENDIF
        N50 M30
    """,
    variables={50: 2, 51: 0}, runs="N10 N30 N40 N50",
)
case(
    "HNC: TRUE and FALSE are conditions",
    control=HNC, source="H9, constants", evidence="secondary",
    program="""
        %1
        N10 IF TRUE
        N20 S2
        ENDIF
        N30 IF FALSE
        N40 S4
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N30 N50",
)
case(
    "HNC: an IF without ENDIF is refused",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 IF #50 GE 10
        N30 S3
        N40 M30
    """,
    variables={50: 0}, runs="N10", alarm="if-without-end", number=None, at="%1 N20",
)
case(
    "HNC: the ENDIF of another program does not end an IF",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 IF #50 GE 10
        N20 M30
        %2
        N30 ENDIF
        N40 M99
    """,
    variables={50: 0}, runs="", alarm="if-without-end", number=None, at="%1 N10",
)
case(
    "HNC: an ENDIF without IF is refused",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 ENDIF
        N30 M30
    """,
    runs="N10", alarm="if-without-end", number=None, at="%1 N20",
)
case(
    "HNC: nine IF inside each other are legal",
    pins="max_ifs",
    control=HNC, source="HS, MAX_NEST_NUM 9", evidence="inferred",
    program="%1\n" + "".join(f"N{k} IF #50 EQ 1\n" for k in range(1, 10)) + "N20 S1\n"
    + "ENDIF\n" * 9 + "N30 M30\n",
    variables={50: 1}, runs=" ".join(f"N{k}" for k in range(1, 10)) + " N20 N30",
)
case(
    "HNC: a tenth IF inside is refused",
    control=HNC, source="HS, MAX_NEST_NUM 9", evidence="inferred",
    program="%1\n" + "".join(f"N{k} IF #50 EQ 1\n" for k in range(1, 11)) + "N20 S1\n"
    + "ENDIF\n" * 10 + "N30 M30\n",
    variables={50: 1}, runs=" ".join(f"N{k}" for k in range(1, 10)), alarm="if-too-deep",
    number=None, at="%1 N10",
)
case(
    "HNC: a condition of more than 128 characters is refused",
    control=HNC, source="HS, MAX_CONDITION_LEN 128", evidence="inferred",
    program="%1\nN10 IF #50 EQ " + "+".join(["1"] * 70) + "\nN20 S2\nENDIF\nN30 M30\n",
    variables={50: 70}, runs="", alarm="if-format", number=None, at="%1 N10",
)

# WHILE

case(
    "HNC: a WHILE loop runs until its condition is false",
    control=HNC, source="HD, WHILE ENDW", evidence="secondary",
    program="""
        %1
        N10 #1=3
        N20 WHILE #1 GT 0
        N30 #1=#1-1
        N40 ENDW
        N50 M30
    """,
    runs="N10 (N20 N30 N40)*3 N20 N50",
)
case(
    "HNC: a WHILE that is false from the start goes on behind ENDW",
    control=HNC, source="HD, WHILE ENDW", evidence="secondary",
    program="""
        %1
        N10 #1=3
        N20 WHILE #1 LT 3
        N30 S3
        N40 ENDW
        N50 M30
    """,
    runs="N10 N20 N50",
)
case(
    "HNC: WHILE TRUE never ends by itself",
    control=HNC, source="H9, constants; HD, WHILE ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE TRUE
        N20 S2
        N30 ENDW
        N40 M30
    """,
    max_blocks=6, runs="(N10 N20 N30)*2", stop="limit",
)
case(
    "HNC: ENDW belongs to the innermost open WHILE",
    control=HNC, source="HD, WHILE ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 LT 2
        N20 #51=0
        N30 WHILE #51 LT 1
        N40 #51=#51+1
        N50 ENDW
        N60 #50=#50+1
        N70 ENDW
        N80 M30
    """,
    variables={50: 0}, runs="(N10 N20 N30 N40 N50 N30 N60 N70)*2 N10 N80",
)
case(
    "HNC: a subprogram called in a loop comes back into it",
    control=HNC, source="HD, WHILE ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 LT 2
        N20 M98 P2
        N30 ENDW
        N40 M30
        %2
        N50 #50=#50+1
        N60 M99
    """,
    variables={50: 0}, runs="(N10 N20 N50 N60 N30)*2 N10 N40",
)
case(
    "HNC: a WHILE without ENDW is refused even when it would not run",
    control=HNC, source="general knowledge, WHILE without ENDW", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 WHILE #50 GT 5
        N30 S3
        N40 M30
    """,
    variables={50: 0}, runs="N10", alarm="missing-end", number=None, at="%1 N20",
)
case(
    "HNC: an ENDW without WHILE is refused",
    control=HNC, source="general knowledge, ENDW without WHILE", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 ENDW
        N30 M30
    """,
    runs="N10", alarm="missing-do", number=None, at="%1 N20",
)
case(
    "HNC: a tenth WHILE inside is refused",
    pins="max_loops",
    control=HNC, source="HS, MAX_NEST_NUM 9", evidence="inferred",
    program="%1\n" + "".join(f"N{k} WHILE #50 EQ 1\n" for k in range(1, 11)) + "N20 #50=2\n"
    + "ENDW\n" * 10 + "N30 M30\n",
    variables={50: 1}, runs=" ".join(f"N{k}" for k in range(1, 10)), alarm="loops-too-deep",
    number=None, at="%1 N10",
)
case(
    "HNC: an ELSE without IF is refused",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 ELSE
        N30 M30
    """,
    runs="N10", alarm="if-without-end", number=None, at="%1 N20",
)
case(
    "HNC: an IF without ENDIF in a subprogram is told there",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 IF #0 GT 5
        N40 M99
    """,
    runs="N10", alarm="if-without-end", number=None, at="%2 N30",
)
case(
    "HNC: an ENDW does not end an IF",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 IF #50 GT 5
        N20 S2
        N30 ENDW
        N40 M30
    """,
    variables={50: 0}, runs="", alarm="if-without-end", number=None, at="%1 N10",
)
case(
    "HNC: an ENDIF does not end a WHILE",
    control=HNC, source="general knowledge, WHILE without ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 GT 5
        N20 S2
        N30 ENDIF
        N40 M30
    """,
    variables={50: 0}, runs="", alarm="missing-end", number=None, at="%1 N10",
)
case(
    "HNC: the ENDW of another program does not end a WHILE",
    control=HNC, source="general knowledge, WHILE without ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 GT 5
        N20 M30
        %2
        N30 ENDW
        N40 M99
    """,
    variables={50: 0}, runs="", alarm="missing-end", number=None, at="%1 N10",
)
case(
    "HNC: a missing program is found on the pass that calls it",
    control=HNC, source="HD, IF ENDIF; general knowledge", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 LT 5
        N20 #50=#50+1
        N30 M98 P[#50+1]
        N40 ENDW
        N50 M30
        %2
        N60 M99
    """,
    variables={50: 0}, runs="N10 N20 N30 N60 N40 N10 N20", alarm="program-not-found",
    number=None, at="%1 N30",
)
case(
    "HNC: a fault in an argument stops the call",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 M98 P2 A[5/#50]
        N30 M30
        %2
        N40 M99
    """,
    variables={50: 0}, runs="N10", calls="", alarm="division-by-zero", number=None, at="%1 N20",
)
case(
    "HNC: a bracket that was not opened stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=1+2]
        N30 M30
    """,
    runs="N10", alarm="bracket-not-opened", number=None, at="%1 N20",
)
case(
    "HNC: there is no GOTO",
    pins="jumps",
    control=HNC, source="general knowledge, no GOTO in HNC-21", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 GOTO 10
        N30 M30
    """,
    runs="N10", alarm="statement-not-available", number=None, at="%1 N20",
)

# Expressions

for claim, text, value in [
    ("PI is a constant", "PI", 3.14159265),
    ("SIN takes radians", "SIN[PI/2]", 1),
    ("degrees are turned into radians by the program", "SIN[30*PI/180]", 0.5),
    ("COS takes radians", "COS[PI]", -1),
    ("TAN takes radians", "TAN[PI/4]", 1),
    ("ATAN gives radians", "ATAN[1]", 0.78539816),
    ("SQRT is the square root", "SQRT[16]", 4),
    ("ABS takes the sign away", "ABS[-3.5]", 3.5),
    ("INT cuts the fraction off", "INT[3.7]", 3),
    ("SIGN tells the sign", "SIGN[-5]", -1),
    ("EXP is the power of e", "EXP[0]", 1),
    ("multiplication comes before addition", "2+3*4", 14),
    ("brackets come first", "[2+3]*4", 20),
]:
    case(
        f"HNC expressions: {claim}, {text} is {value}",
        pins="angle_unit",
        control=HNC, source="H9, constants; general knowledge, functions", evidence="inferred",
        program=f"""
            %1
            N10 #50={text}
            N20 M30
        """,
        runs="N10 N20", vars={50: value},
    )
case(
    "HNC: a division by zero stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 #50=0
        N20 #51=5/#50
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=None, at="%1 N20",
)
case(
    "HNC: the square root of a negative value stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=SQRT[1-5]
        N30 M30
    """,
    runs="N10", alarm="square-root-of-negative", number=None, at="%1 N20",
)
case(
    "HNC: a bracket that is not closed stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=[1+2
        N30 M30
    """,
    runs="N10", alarm="bracket-not-closed", number=None, at="%1 N20",
)
case(
    "HNC: an expression that breaks off stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=1+
        N30 M30
    """,
    runs="N10", alarm="expression-format", number=None, at="%1 N20",
)
case(
    "HNC: an undefined variable counts as zero in an expression",
    control=HNC, source="general knowledge, undefined is 0", evidence="inferred",
    program="""
        %1
        N10 #50=#7+3
        N20 M30
    """,
    runs="N10 N20", vars={50: 3},
)
case(
    "HNC: a tool number may be an expression in brackets",
    control=HNC, source="HD, variables behind M, D, H and others", evidence="secondary",
    program="""
        %1
        N10 T[#50+2]
        N20 M[#51]
        N30 M30
    """,
    variables={50: 3, 51: 8}, runs="N10 N20 N30", t=[5], m=[8],
)

# Units and comments

for code, unit in [("G20", "inch"), ("G21", "metric"), ("G22", "pulse")]:
    case(
        f"HNC: {code} is the word for {unit} units and stops nothing",
        control=HNC, source="source 003, G20, G21, G22", evidence="source document",
        program=f"""
            %1
            N10 {code}
            N20 M98 P2
            N30 M30
            %2
            N40 M99
        """,
        runs="N10 N20 N40 N30",
    )
case(
    "HNC: G94 and G95 choose the feed and stop nothing",
    control=HNC, source="source 003, G94, G95", evidence="source document",
    program="""
        %1
        N10 G94 F100
        N20 G95 F0.2
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "HNC: what stands behind a semicolon is a comment",
    control=HNC, source="HD, comments", evidence="secondary",
    program="""
        %1 ; the main program
        N10 T1 ; T9 M98 P7
        ; N15 T2
        N20 M98 P2 ; L3
        N30 M30
        %2
        N40 M99
    """,
    runs="N10 N20 N40 N30", t=[1],
)
case(
    "HNC: what stands in parentheses is a comment",
    control=HNC, source="general knowledge, comments", evidence="inferred",
    program="""
        %1
        N10 T1 (T9) M8
        N20 M30
    """,
    runs="N10 N20", t=[1], m=[8],
)
case(
    "HNC: a block skip that is on leaves the call out",
    control=HNC, source="general knowledge, block skip", evidence="inferred",
    program="""
        %1
        N10 S1
        /N20 M98 P7
        N30 M30
    """,
    skip=(1,), runs="N10 N30", calls="",
)
case(
    "HNC: a block skip that is off leaves the call in",
    control=HNC, source="general knowledge, block skip", evidence="inferred",
    program="""
        %1
        N10 S1
        /N20 M98 P7
        N30 M30
    """,
    runs="N10", alarm="program-not-found", number=None, at="%1 N20", word="P7",
)
