"""GSK: calls in MDI."""

from conformance import case

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

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
FAMILY_980 = [TDI, MDI]
SOURCE = "source document"
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"

case(
    "GSK 988TA: MDI may call one level",
    control=TA, source="source 000, note 4", evidence=INFERRED,
    program="O2\nN20 G0 X1\nN30 M99\n", mdi="N5 M98 P2", runs="N5 N20 N30", calls="M98:O2",
)
case(
    "GSK 988TA: MDI may repeat its call",
    control=TA, source="source 000, note 4", evidence=INFERRED,
    program="O2\nN20 M99\n", mdi="N5 M98 P30002", runs="N5 N20*3",
)
case(
    "GSK 988TA: MDI may call one macro",
    control=TA, source="TA27, note 5", evidence=INFERRED,
    program="O2\nN20 #100=#1\nN30 M99\n", mdi="N5 G65 P2 A4", runs="N5 N20 N30", vars={100: 4},
)
case(
    "GSK 988TA: a program called in MDI may not call another",
    control=TA, source="source 000, note 4; number from Talm 085", evidence=SOURCE,
    program="O2\nN20 M98 P3\nN30 M99\nO3\nN40 M99\n", mdi="N5 M98 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a program called in MDI may not call a macro",
    control=TA, source="source 000, note 4; TA27, note 5; number from Talm 085", evidence=SOURCE,
    program="O2\nN20 G65 P3\nN30 M99\nO3\nN40 M99\n", mdi="N5 M98 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a macro called in MDI may not call another",
    control=TA, source="TA27, note 5; number from Talm 085", evidence=MANUAL,
    program="O2\nN20 G65 P3\nN30 M99\nO3\nN40 M99\n", mdi="N5 G65 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a program called in MDI may not call itself by Q",
    control=TA, source="source 000, note 4; number from Talm 085", evidence=INFERRED,
    program="O2\nN20 M98 Q40\nN30 M99\nN40 M99\n", mdi="N5 M98 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a program missing in MDI is an alarm",
    control=TA, source="source 000, note 3; Talm 083", evidence=SOURCE,
    program="O2\nN20 M99\n", mdi="N5 M98 P3",
    runs="", alarm="program-not-found", number="083",
)
case(
    "GSK 988T: MDI refuses M98",
    control=T, source="Talm 085", evidence=SECONDARY,
    program="O2\nN20 M99\n",
    mdi="N5 M98 P2", runs="", alarm="call-in-mdi", number="085", calls="",
)
case(
    "GSK 988T: MDI refuses G65",
    control=T, source="Talm 085", evidence=SECONDARY,
    program="O2\nN20 M99\n",
    mdi="N5 G65 P2", runs="", alarm="call-in-mdi", number="085", calls="",
)
case(
    "GSK 988T: MDI refuses a call after other blocks, and keeps what they did",
    control=T, source="Talm 085", evidence=SECONDARY,
    program="O2\nN20 M99\n", mdi="N5 M3\nN6 M98 P2",
    runs="N5", m=[3], alarm="call-in-mdi", number="085",
)
case(
    "GSK 980: MDI refuses M98",
    pins="mdi_calls",
    control=FAMILY_980, source="K, M98 is not valid in MDI", evidence=INFERRED,
    program="O2\nN20 M99\n", mdi="N5 M98 P2",
    runs="", alarm="call-in-mdi", calls="",
)
