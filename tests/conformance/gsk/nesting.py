"""GSK: how deep subprograms may call."""

from conformance import case

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

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
FAMILIES = [TA, T, TDI, MDI]
SOURCE = "source document"
MANUAL = "maker's manual"
INFERRED = "inferred"


def one_call(call, sub="N30 M99", name="O2"):
    """Return a main program O1 of one call, and the program that it calls."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


def chain(calls):
    """Return programs: O1 calls O2, O2 calls O3 and so on; calls[k] is the call in O<k+1>."""
    programs = [
        f"O{level}\nN{level}0 {call.format(level + 1)}\nN{level}1 {'M30' if level == 1 else 'M99'}\n"
        for level, call in enumerate(calls, 1)
    ]
    last = len(calls) + 1
    return "".join(programs) + f"O{last}\nN{last}0 M99\n"


def chain_down(levels):
    """Return the blocks of a chain on the way down: the calls of O1 to O<levels>."""
    return " ".join(f"N{level}0" for level in range(1, levels + 1))


def chain_through(levels):
    """Return all the blocks of a chain of `levels` calls."""
    up = " ".join(f"N{level}1" for level in range(levels, 0, -1))
    return f"{chain_down(levels + 1)} {up}"


M98, G65 = "M98 P{}", "G65 P{}"

case(
    "GSK 988: twelve levels of subprograms are legal",
    pins="max_nesting",
    control=FAMILY_988, source="source 000, nesting; Talm 082", evidence=SOURCE,
    program=chain([M98] * 12), runs=chain_through(12), calls=" ".join(f"M98:O{k}" for k in range(2, 14)),
)
case(
    "GSK 988: the thirteenth level of subprograms is an alarm",
    control=FAMILY_988, source="source 000, nesting; Talm 082", evidence=SOURCE,
    program=chain([M98] * 13), runs=chain_down(12), alarm="nesting-too-deep", number="082",
    at="O13 N130",
)
case(
    "GSK 988: eight subprograms and four macros are twelve levels",
    pins="max_macro_nesting roles:G65=macro-call",
    control=FAMILY_988, source="source 000, nesting, macros included", evidence=SOURCE,
    program=chain([M98] * 8 + [G65] * 4), runs=chain_through(12),
)
case(
    "GSK 988: a subprogram as thirteenth level above macros is an alarm",
    pins="nesting_counts_macros",
    control=FAMILY_988, source="source 000, nesting, macros included; Talm 082", evidence=SOURCE,
    program=chain([G65] * 4 + [M98] * 9), runs=chain_down(12), alarm="nesting-too-deep",
    number="082", at="O13 N130",
)
case(
    "GSK 988: a macro as thirteenth level above subprograms is an alarm",
    control=FAMILY_988, source="source 000, nesting, macros included; Talm 082", evidence=SOURCE,
    program=chain([M98] * 12 + [G65]), runs=chain_down(12), alarm="nesting-too-deep",
    number="082", at="O13 N130",
)
case(
    "GSK 988TA: a program of the device counts as a level",
    control=TA, source="source 000, nesting and M198", evidence=INFERRED,
    program=chain([M98] * 12 + ["M198 P{}"]), external={"O14.CNC": "N140 M99\n"},
    runs=chain_down(12), alarm="nesting-too-deep", number="082", at="O13 N130",
)
case(
    "GSK 988: the words of a call one level too deep are executed before its alarm",
    control=FAMILY_988, source="source 000, nesting; Talm 082", evidence=SOURCE,
    program=chain([M98] * 12 + ["G0 X1 M98 P{}"]),
    runs=chain_down(13), alarm="nesting-too-deep", number="082", at="O13 N130",
)
case(
    "GSK 980: four levels of subprograms are legal",
    pins="max_nesting",
    control=FAMILY_980, source="MDia 096", evidence=MANUAL,
    program=chain([M98] * 4), runs=chain_through(4), calls="M98:O2 M98:O3 M98:O4 M98:O5",
)
case(
    "GSK 980: the fifth level of subprograms is an alarm",
    control=FAMILY_980, source="MDia 096", evidence=MANUAL,
    program=chain([M98] * 5), runs=chain_down(4), alarm="nesting-too-deep", number="0096",
    at="O5 N50",
)
case(
    "GSK: calls one after the other do not add up",
    control=FAMILIES, source="source 000, nesting; MDia 096", evidence=SOURCE,
    program="O1\n" + "N10 M98 P2\n" * 14 + "N20 M30\nO2\nN30 M99\n",
    runs="(N10 N30)*14 N20",
)
case(
    "GSK: repetitions do not add up",
    control=FAMILIES, source="source 000, nesting; MDia 096", evidence=SOURCE,
    program=one_call("M98 P200002"),
    runs="N10 N30*20 N20",
)
case(
    "GSK: a return frees its level",
    control=FAMILIES, source="source 000, nesting; MDia 096", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N11 M30
        O2
        N20 M98 P3
        N21 M98 P3
        N22 M99
        O3
        N30 M98 P4
        N31 M98 P4
        N32 M99
        O4
        N40 M98 P5
        N41 M99
        O5
        N50 M99
    """,
    runs="N10 N20 N30 N40 N50 N41 N31 N40 N50 N41 N32 N21 N30 N40 N50 N41 N31 N40 N50 N41 N32 N22 N11",
)
case(
    "GSK: each pass of a repeated program makes its own calls",
    control=FAMILIES, source="source 000, M98", evidence=SOURCE,
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
