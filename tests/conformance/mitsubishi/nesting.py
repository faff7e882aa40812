"""Mitsubishi: how deep programs may call."""

from conformance import case

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

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"


def chain(levels, call="M98 P{}"):
    """Return a main program O1 from which `levels` calls are open at once.

    Program Ok calls in block Nk and returns in block N(100+k).
    """
    text = f"O1\nN1 {call.format(2)}\nN101 M30\n"
    for k in range(2, levels + 1):
        text += f"O{k}\nN{k} {call.format(k + 1)}\nN{100 + k} M99\n"
    last = levels + 1
    return text + f"O{last}\nN{last} S{last}\nN{100 + last} M99\n"


def way_in(levels):
    return " ".join(f"N{k}" for k in range(1, levels + 1))


def way_in_and_out(levels):
    out = " ".join(f"N{100 + k}" for k in range(levels + 1, 0, -1))
    return f"{way_in(levels + 1)} {out}"


case(
    "MELDAS: four levels of subprograms are legal",
    control=MELDAS, source="source 004, note on levels", evidence="source document",
    program=chain(4), runs=way_in_and_out(4), calls="M98:O2 M98:O3 M98:O4 M98:O5",
)
case(
    "MELDAS: the fifth level is P230 and nothing of it runs",
    control=MELDAS, source="source 004, note on levels", evidence="source document",
    program=chain(5), runs=way_in(4), alarm="nesting-too-deep", number="P230", at="O5 N5",
)
case(
    "MELDAS: a level that was left may be used again",
    control=MELDAS, source="source 004, note on levels", evidence="source document",
    program=chain(4).replace("N101 M30", "N101 M98 P2\nN201 M30"),
    runs=f"{way_in_and_out(4)} N2 N3 N4 N5 N105 N104 N103 N102 N201",
)
case(
    "MELDAS: repeats are not levels",
    control=MELDAS, source="source 004, note on levels", evidence="inferred",
    program=chain(4, "M98 P{} L2").replace("N1 M98 P2 L2", "N1 M98 P2"),
    runs="N1 N2 N3 N4 N5 N105 N5 N105 N104 N4 N5 N105 N5 N105 N104 N103"
    " N3 N4 N5 N105 N5 N105 N104 N4 N5 N105 N5 N105 N104 N103 N102 N101",
)
case(
    "MELDAS: the words beside the call that is one level too deep have run",
    control=MELDAS, source="source 004, note on levels; SM (3)", evidence="inferred",
    program=chain(5).replace("N5 M98", "N5 T5 M98"),
    runs=way_in(5), t=[5], alarm="nesting-too-deep", number="P230", at="O5 N5",
)
case(
    "MELDAS: three subprograms and a macro are four levels",
    control=MELDAS, source="SM (6); source 004, note on levels", evidence="inferred",
    program=chain(4).replace("N4 M98 P5", "N4 G65 P5"), runs=way_in_and_out(4),
)
case(
    "MELDAS: a macro over four subprograms is P230",
    pins="nesting_counts_macros",
    control=MELDAS, source="SM (6); source 004, note on levels", evidence="inferred",
    program=chain(5).replace("N5 M98 P6", "N5 G65 P6"),
    runs=way_in(4), alarm="nesting-too-deep", number="P230", at="O5 N5",
)
case(
    "M700: eight levels of M98 are legal, all the way in and out",
    control=M700, source="SM (6); MZ 842", evidence="maker's manual",
    program=chain(8), runs=way_in_and_out(8),
)
case(
    "M700: the ninth M98 is P230",
    control=M700, source="SM (6); MZ 842", evidence="maker's manual",
    program=chain(9), runs=way_in(8), alarm="nesting-too-deep", number="P230", at="O9 N9",
)
case(
    "M800: ten levels of M98 are legal, all the way in and out",
    control=M800, source="CW", evidence="secondary",
    program=chain(10), runs=way_in_and_out(10),
)
case(
    "M800: the eleventh M98 is P230",
    control=M800, source="CW", evidence="secondary",
    program=chain(11), runs=way_in(10), alarm="nesting-too-deep", number="P230", at="O11 N11",
)
case(
    "M700: a self-call with H counts a level each time",
    control=M700, source="SM (6); IMD", evidence="inferred",
    program="""
        O1
        N10 M98 H30
        N20 M30
        N30 S3
        N40 M98 H30
        N50 M99
    """,
    runs="N10 (N30 N40)*7 N30", alarm="nesting-too-deep", number="P230", at="O1 N40",
)
