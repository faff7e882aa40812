"""GSK 928TE: calls of a part of the same program."""

from conformance import case

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
    "the part after M02 runs five times (928-002)",
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

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
SOURCE = "source document"
INFERRED = "inferred"


def part_chain(levels):
    """Return a 928 program in which N1001 is called, calls N1002 and so on, so many levels deep."""
    blocks = ["%1", "N0001 M98 P1001", "N0002 M02"]
    for level in range(1, levels):
        blocks += [f"N{1000 + level} M98 P{1001 + level}", f"N{2000 + level} M99"]
    return "\n".join([*blocks, f"N{1000 + levels} M99", ""])


case(
    "GSK 928: the first method of the manual: M97 leads round the part inside the main program",
    pins="self_call",
    control=TE, source="source 001, example, first listing", evidence=SOURCE,
    program="""
        %1
        N0010 G00 X100 Z50
        N0020 M03 S01
        N0030 G0 X50 Z15 F500
        N0040 M98 P0060 L5
        N0050 M97 P0130
        N0060 G0 U-4
        N0070 G01 Z-10 F80
        N0080 U20 Z-25
        N0090 Z-35
        N0100 G0 U2 Z1
        N0110 U-22
        N0120 M99
        N0130 G0 X100 Z50
        N0140 M05
        N0140 M02
    """,
    runs="N10 N20 N30 N40 (N60 N70 N80 N90 N100 N110 N120)*5 N50 N130 N140 N140", calls="M98:%1",
)

SECOND_METHOD = """
        %2
        N0010 G00 X100 Z50
        N0020 M03 S01
        N0030 G0 X66 Z15 F500
        N0040 M98 P{} L5
        N0050 G0 X100 Z50
        N0060 M05
        N0070 M02
        N0080 G0 U-4
        N0090 G01 Z-10 F80
        N0100 U20 Z-25
        N0110 Z-35
        N0120 G0 U2 Z1
        N0130 U-22
        N0140 M99
    """

case(
    "GSK 928: the second method of the manual: the part stands after M02",
    control=TE, source="source 001, example, second listing; its text calls N0080", evidence=SOURCE,
    program=SECOND_METHOD.format("0080"),
    runs="N10 N20 N30 N40 (N80 N90 N100 N110 N120 N130 N140)*5 N50 N60 N70", calls="M98:%2",
)
case(
    "GSK 928: the second listing as it is printed calls P0060 and ends at M02 without a cut",
    control=TE, source="source 001, example, second listing, literally", evidence=SOURCE,
    program=SECOND_METHOD.format("0060"),
    runs="N10 N20 N30 N40 N60 N70", calls="M98:%2",
)
case(
    "GSK 928: the first method without its M97 runs the part once more and ends at its M99",
    pins="main_return",
    control=TE, source="source 001, example, note on M97", evidence=SOURCE,
    program="""
        %1
        N0040 M98 P0060 L2
        N0060 G0 U-4
        N0120 M99
        N0130 G0 X100
        N0140 M02
    """,
    runs="N40 (N60 N120)*2 N60 N120", stop="end",
)
case(
    "GSK 928: M98 calls from a block of the same program",
    control=TE, source="source 001, example", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0040
        N0020 G0 X2
        N0030 M02
        N0040 G0 X4
        N0050 M99
    """,
    runs="N10 N40 N50 N20 N30", calls="M98:%1",
)
case(
    "GSK 928: L is one where it is not written",
    control=TE, source="K, L of M98", evidence=INFERRED,
    program="%1\nN0010 M98 P0030\nN0020 M02\nN0030 M99\n",
    runs="N10 N30 N20",
)
case(
    "GSK 928: leading zeros of P and N do not matter",
    control=TE, source="source 001, example", evidence=INFERRED,
    program="%1\nN10 M98 P0030 L2\nN20 M02\nN0030 M99\n",
    runs="N10 N30*2 N20",
)
case(
    "GSK 928: P is a block of the program itself, never another program",
    control=TE, source="source 001, example", evidence=SOURCE,
    files={"%1.CNC": "%1\nN0010 M98 P0002\nN0020 M02\nN0002 M99\n", "%2.CNC": "%2\nN0090 M99\n"},
    main="%1", runs="N10 N2 N20", calls="M98:%1",
)
case(
    "GSK 928: the part may stand in front of its call",
    control=TE, source="source 001, M97 and M98", evidence=INFERRED,
    program="""
        %1
        N0010 M97 P0040
        N0020 G0 X2
        N0030 M99
        N0040 M98 P0020 L2
        N0050 M02
    """,
    runs="N10 N40 (N20 N30)*2 N50",
)
case(
    "GSK 928: one part may be called from two places",
    control=TE, source="source 001, M98", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0050 L2
        N0020 G0 X2
        N0030 M98 P0050
        N0040 M02
        N0050 M99
    """,
    runs="N10 N50*2 N20 N30 N50 N40", calls="M98:%1 M98:%1",
)
case(
    "GSK 928: a part may be entered in its middle",
    control=TE, source="source 001, M98", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0040
        N0020 M98 P0050
        N0030 M02
        N0040 G0 X4
        N0050 G0 X5
        N0060 M99
    """,
    runs="N10 N40 N50 N60 N20 N50 N60 N30",
)
case(
    "GSK 928: calls may be nested",
    pins="max_total_nesting",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0100 L3
        N0020 M02
        N0100 M98 P0200 L2
        N0110 M99
        N0200 G0 U1
        N0210 M99
    """,
    runs="N10 (N100 (N200 N210)*2 N110)*3 N20",
)
case(
    "GSK 928: a call without M99 runs the part once, whatever L says",
    control=TE, source="source 001, first rule", evidence=SOURCE,
    program="%1\nN0010 M98 P0030 L3\nN0020 M02\nN0030 G0 X3\nN0040 M02\n",
    runs="N10 N30 N40",
)
case(
    "GSK 928: a call without M99 does not come back",
    control=TE, source="source 001, first rule", evidence=SOURCE,
    program="%1\nN0010 M98 P0030\nN0020 G0 X2\nN0030 G0 X3\nN0040 M30\n",
    runs="N10 N30 N40",
)
case(
    "GSK 928: M99 without M98 ends the program and does not start it anew",
    control=TE, source="source 001, second rule", evidence=SOURCE,
    program="%1\nN0010 G0 X1\nN0020 M99\n",
    max_cycles=3, runs="N10 N20", stop="end",
)
case(
    "GSK 928: an M99 that is jumped to without a call ends the program",
    control=TE, source="source 001, second rule", evidence=SOURCE,
    program="%1\nN0010 M97 P0030\nN0020 M02\nN0030 M99\nN0040 G0 X4\n",
    runs="N10 N30", stop="end",
)
case(
    "GSK 928: M99 after a finished call ends the program",
    control=TE, source="source 001, second rule", evidence=SOURCE,
    program="%1\nN0010 M98 P0030 L2\nN0020 G0 X2\nN0030 G0 X3\nN0040 M99\nN0050 M02\n",
    runs="N10 (N30 N40)*2 N20 N30 N40", stop="end",
)
case(
    "GSK 928: M97 goes forward",
    control=TE, source="source 001, example", evidence=SOURCE,
    program="%1\nN0010 M97 P0030\nN0020 G0 X2\nN0030 M02\n",
    runs="N10 N30", calls="",
)
case(
    "GSK 928: M97 goes backward",
    control=TE, source="source 001, example", evidence=INFERRED,
    program="%1\nN0010 G0 U1\nN0020 M97 P0010\nN0030 M02\n",
    max_blocks=5, runs="N10 N20 N10 N20 N10", stop="limit",
)
case(
    "GSK 928: M97 does not end a call",
    control=TE, source="source 001, M97 has no return", evidence=INFERRED,
    program="""
        %1
        N0010 M98 P0040 L2
        N0020 M02
        N0040 M97 P0060
        N0050 M02
        N0060 M99
    """,
    runs="N10 (N40 N60)*2 N20",
)
case(
    "GSK 928: M02 ends the program in a called part",
    pins="end_in_subprogram",
    control=TE, source="K, M02", evidence=INFERRED,
    program="%1\nN0010 M98 P0030 L5\nN0020 M30\nN0030 M02\nN0040 M99\n",
    runs="N10 N30",
)
case(
    "GSK 928: M30 ends the program",
    control=TE, source="K, M30", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M30\nN0030 G0 X3\n",
    runs="N10 N20",
)
case(
    "GSK 928: M20 starts the program anew",
    pins="m_codes_per_block roles:M20=start-over",
    control=TE, source="K, M20", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M20\nN0030 G0 X3\n",
    max_cycles=2, runs="(N10 N20)*2", stop="cycles",
)
case(
    "GSK 928: of two blocks of one number M97 takes the first of the program",
    control=TE, source="source 001, its N0140 stands twice; choice of the engine", evidence=INFERRED,
    program="""
        %1
        N0010 M97 P0140
        N0140 M05
        N0150 M02
        N0140 M30
    """,
    runs="N10 N140 N150",
)
case(
    "GSK 928: of two blocks of one number M98 takes the first of the program",
    control=TE, source="source 001, its N0140 stands twice; choice of the engine", evidence=INFERRED,
    program="""
        %1
        N0010 M97 P0040
        N0020 G0 X2
        N0030 M99
        N0040 M98 P0020
        N0050 M02
        N0020 G0 X3
        N0060 M99
    """,
    runs="N10 N40 N20 N30 N50",
)
case(
    "GSK 928: two blocks of one number may follow each other",
    control=TE, source="source 001, example, N0140", evidence=SOURCE,
    program="%1\nN0130 G0 X100\nN0140 M05\nN0140 M02\n",
    runs="N130 N140 N140",
)
case(
    "GSK 928: eighteen levels are legal",
    pins="max_nesting",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program=part_chain(18),
    runs=" ".join(
        ["N1"]
        + [f"N{1000 + k}" for k in range(1, 19)]
        + [f"N{2000 + k}" for k in range(17, 0, -1)]
        + ["N2"]
    ),
)
case(
    "GSK 928: the nineteenth level is an alarm",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program=part_chain(19),
    runs=" ".join(["N1"] + [f"N{1000 + k}" for k in range(1, 18)]),
    alarm="nesting-too-deep", at="%1 N1018",
)
case(
    "GSK 928: a part that calls itself is stopped at the nineteenth level",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program="%1\nN0010 M98 P0010\nN0020 M02\n",
    runs="N10*18", alarm="nesting-too-deep", at="%1 N10",
)
case(
    "GSK 928: calls without M99 stay open and use up the levels",
    control=TE, source="source 001, first rule and nesting", evidence=INFERRED,
    program="%1\nN0010 G0 U1\nN0020 M98 P0010 L2\nN0030 M02\n",
    runs="N10 (N20 N10)*18", alarm="nesting-too-deep", at="%1 N20",
)
case(
    "GSK 928: repetitions are no levels",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program="%1\nN0010 M98 P0030 L25\nN0020 M02\nN0030 M99\n",
    runs="N10 N30*25 N20",
)
case(
    "GSK 928: M98 to a block that is missing is an alarm",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M98 P0090 L2\nN0030 M02\n",
    runs="N10", alarm="start-not-found", at="%1 N20",
)
case(
    "GSK 928: M97 to a block that is missing is an alarm",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M97 P0090\nN0030 M02\n",
    runs="N10", alarm="jump-target-not-found", at="%1 N20",
)
case(
    "GSK 928: M98 without P is an alarm",
    pins="omitted_program",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M98 L2\nN0030 M02\n",
    runs="N10", alarm="program-number-missing", at="%1 N20",
)
case(
    "GSK 928: a missing block is missed inside a called part",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 M98 P0030\nN0020 M02\nN0030 M98 P0090\nN0040 M99\n",
    runs="N10", alarm="start-not-found", at="%1 N30",
)
case(
    "GSK 928: a call to a missing block that is never reached raises nothing",
    control=TE, source="policy: a control reads a block when it reaches it", evidence=INFERRED,
    program="%1\nN0010 M97 P0030\nN0020 M98 P0090\nN0030 M02\n",
    runs="N10 N30",
)
