"""Mitsubishi: names of files."""

from conformance import case

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

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]

case(
    "M98 with a file name calls the file",
    control=NEWER, source="IMD, <file name>", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 <POCKET.NC>\nN20 M30\n", "POCKET.NC": "N210 S1\nN220 M99\n"},
    main="O1", runs="N10 N210 N220 N20",
)
case(
    "M98 with a file name takes H and L",
    control=NEWER, source="IMD, <file name>", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 <POCKET.NC> H220 L2\nN20 M30\n",
           "POCKET.NC": "N210 S1\nN220 M99\n"},
    main="O1", runs="N10 N220*2 N20",
)
case(
    "a file name that is not in the memory is P232",
    control=NEWER, source="IMD2; source 004, note 1", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 <SLOT.NC>\nN20 M30\n", "POCKET.NC": "N210 M99\n"},
    main="O1", runs="", alarm="named-program-not-found", number="P232", at="O1 N10",
)
case(
    "an H that the named file does not have is P231",
    control=NEWER, source="IMD, <file name>; source 004, note 2", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 <POCKET.NC> H300\nN20 M30\n", "POCKET.NC": "N210 M99\n"},
    main="O1", runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H300",
)
case(
    "a file name of 32 characters is callable",
    pins="max_name_length",
    control=NEWER, source="IMD, 32 characters with the extension", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 <ABCDEFGHIJKLMNOPQRSTUVWXYZ012.NC>\nN20 M30\n",
           "ABCDEFGHIJKLMNOPQRSTUVWXYZ012.NC": "N210 M99\n"},
    main="O1", runs="N10 N210 N20",
)
case(
    "a file name of 33 characters is P232 although the file is there",
    control=NEWER, source="IMD, 32 characters with the extension; general knowledge",
    evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 <ABCDEFGHIJKLMNOPQRSTUVWXYZ0123.NC>\nN20 M30\n",
           "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123.NC": "N210 M99\n"},
    main="O1", runs="", alarm="illegal-program-name", number="P232", at="O1 N10",
)
case(
    "MELDAS knows no file names in angle brackets",
    control=MELDAS, source="IMD, <file name>; SK P32", evidence="inferred",
    program="""
        O1
        N10 M98 <POCKET.NC>
        N20 M30
    """,
    runs="", alarm="illegal-character", number="P32", at="O1 N10",
)
case(
    "a file without O is called by the number that is its name",
    control=EVERY, source="general knowledge", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "300.NC": "N310 S1\nN320 M99\n"},
    main="O1", runs="N10 N310 N320 N20",
)
case(
    "a file name with O and leading zeros answers to its number",
    control=NEWER, source="general knowledge; IMD2", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "O0300.NC": "N310 M99\n"},
    main="O1", runs="N10 N310 N20",
)
case(
    "from the M700 on the file's name is called and not the O inside",
    pins="program_heads:file",
    control=NEWER, source="IMD2", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 P200\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="N10 N310 N20",
)
case(
    "from the M700 on the O inside a file does not answer a call",
    control=NEWER, source="IMD2; source 004, note 1", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P300",
)
case(
    "from the M700 on files with the same O inside are two programs",
    control=NEWER, source="IMD2", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 P200\nN20 M98 P201\nN30 M30\n", "200.NC": "O7\nN210 M99\n",
           "201.NC": "O7\nN310 M99\n"},
    main="O1", runs="N10 N210 N20 N310 N30",
)
case(
    "MELDAS calls by the O inside the file",
    pins="program_heads:file",
    control=MELDAS, source="general knowledge", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="N10 N310 N20", calls="M98:O300",
)
case(
    "MELDAS does not call by the file's name where the file has an O",
    control=MELDAS, source="general knowledge; source 004, note 1", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P200\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)
