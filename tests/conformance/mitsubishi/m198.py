"""Mitsubishi: M198 and ,D, programs of a device."""

from conformance import case

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]


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


case(
    "M198 runs the program of the external device",
    pins="roles:M198=external-call",
    control=NEWER, source="CW, M198", evidence="secondary",
    program="""
        O1
        N10 M198 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\nN220 M99\n"},
    runs="N10 N210 N220 N20", calls="M198:O200",
)
case(
    "M198 repeats with L like M98",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200 L3
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="N10 N210*3 N20", calls="M198:O200",
)
case(
    "M198 starts at H like M98",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200 H220
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\nN220 M99\n"},
    runs="N10 N220 N20",
)
case(
    "an H that the external program does not have is P231",
    control=NEWER, source="CW, M198; source 004, note 2", evidence="inferred",
    program="""
        O1
        N10 M198 P200 H300
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\nN220 M99\n"},
    runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H300",
)
case(
    "M198 takes the program of the device and M98 the one of the memory",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M98 P200
        N30 M30
        O200
        N210 M99
    """,
    external={"O200.NC": "O200\nN310 M99\n"},
    runs="N10 N310 N20 N210 N30", calls="M198:O200 M98:O200",
)
case(
    "a program that is not on the device is P232 even when the memory holds it",
    control=NEWER, source="source 004, note 1; CW", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
        O200
        N210 M99
    """,
    external={"O300.NC": "O300\nN310 M99\n"},
    runs="", alarm="external-program-not-found", number="P232", at="O1 N10", word="P200",
)
case(
    "M98 does not look on the external device",
    control=NEWER, source="source 004, note 1; CW", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)
case(
    "an external program cannot call an external program",
    control=NEWER, source="CW, nested M198; MZ 842", evidence="secondary",
    program="""
        O1
        N10 M198 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M198 P300\nN220 M99\n", "O300.NC": "O300\nN310 M99\n"},
    runs="N10", alarm="external-call-nested", number="P230", at="O200 N210",
)
case(
    "an external program may call a program of the memory",
    control=NEWER, source="CW, nested M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
        O300
        N310 M99
    """,
    external={"O200.NC": "O200\nN210 M98 P300\nN220 M99\n"},
    runs="N10 N210 N310 N220 N20", calls="M198:O200 M98:O300",
)
case(
    "a program of the memory cannot call the device while an external program is open",
    control=NEWER, source="CW, nested M198; MZ 842", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
        O300
        N310 M198 P400
        N320 M99
    """,
    external={"O200.NC": "O200\nN210 M98 P300\nN220 M99\n", "O400.NC": "O400\nN410 M99\n"},
    runs="N10 N210", alarm="external-call-nested", number="P230", at="O300 N310",
)
case(
    "one external program after the other is no nesting",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M198 P300
        N30 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n", "O300.NC": "O300\nN310 M99\n"},
    runs="N10 N210 N20 N310 N30", calls="M198:O200 M198:O300",
)
case(
    "M99 P of an external program returns to a block of the caller in memory",
    control=NEWER, source="source 004, M99 P; CW", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 S2
        N30 M30
    """,
    external={"O200.NC": "O200\nN210 M99 P30\n"},
    runs="N10 N210 N30",
)
case(
    "an external program without M99 is P36",
    control=NEWER, source="SK P36", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\n"},
    runs="N10 N210", alarm="end-of-record", number="P36",
)
case(
    "M700: an external program is one of the eight levels",
    control=M700, source="MZ 842; SM (6)", evidence="inferred",
    program=chain(9).replace("N1 M98 P2", "N1 M198 P2").replace("O2\nN2", "O20\nN20"),
    external={"O2.NC": "O2\nN2 M98 P3\nN102 M99\n"},
    runs=way_in(8), alarm="nesting-too-deep", number="P230", at="O9 N9",
)
case(
    "M198 of a file name looks for the file on the device",
    pins="name_marks",
    control=NEWER, source="CW, M198; IMD", evidence="inferred",
    program="""
        O1
        N10 M198 <POCKET.NC> L2
        N20 M30
    """,
    external={"POCKET.NC": "N210 M99\n"},
    runs="N10 N210*2 N20",
)
case(
    "a file name that the device does not hold is P232",
    control=NEWER, source="CW, M198; IMD", evidence="inferred",
    program="""
        O1
        N10 M198 <POCKET.NC>
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="", alarm="external-program-not-found", number="P232", at="O1 N10",
)
case(
    "M198 calls nothing on MELDAS, it is an M code for the machine",
    control=MELDAS, source="general knowledge, no M198", evidence="inferred",
    program="""
        O1
        N10 M198
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="N10 N20", m=[198], calls="",
)
case(
    "M98 with ,D1 takes the program from the device",
    pins="device_word",
    control=NEWER, source="IMD, ,D", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D1
        N20 M30
        O200
        N210 M99
    """,
    external={"O200.NC": "O200\nN310 M99\n"},
    runs="N10 N310 N20",
)
case(
    "M98 with ,D1 and a program that is not on the device is P232",
    control=NEWER, source="IMD, ,D; source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D1
        N20 M30
        O200
        N210 M99
    """,
    external={"O300.NC": "O300\nN310 M99\n"},
    runs="", alarm="external-program-not-found", number="P232", at="O1 N10",
)
case(
    "a device number above 4 is over the range",
    control=NEWER, source="IMD, ,D 0 to 4; SK P35", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D5
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="value-out-of-range", number="P35", at="O1 N10",
)
case(
    "MELDAS has no ,D",
    control=MELDAS, source="IMD, ,D; SK P32", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D1
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="address-not-usable", number="P32", at="O1 N10", word=",D1",
)
