"""Syntec: a program that calls a part of itself, M98 P H L, M99 P."""

from conformance import case, inert

SYNTEC = "syntec-22ma"

case(
    "M98 H calls what its N heads in its own program, as the post of the Syil writes it",
    pins="start_word omitted_program",
    control=SYNTEC, source="SYP, M98 H9000", evidence="secondary",
    program="""
        O1
        N10 G91 M98 H9000
        N20 M98 H9000
        N30 M30
        N9000 G1 X10. F500
        N9010 M99
    """,
    runs="N10 N9000 N9010 N20 N9000 N9010 N30", moves="F X10\nF X20",
)
case(
    "M98 H L repeats the part (SYN-01)",
    control=SYNTEC, source="PWR p.149, M98 P H L", evidence="secondary",
    program="O1\nN10 G0 X1.\nN20 M98 H50 L2\nN30 G0 X2.\nN40 M30\nN50 G0 X8.\nN60 M99",
    runs="N10 N20 (N50 N60)*2 N30 N40",
)
case(
    "M98 P H starts the other program at its N",
    control=SYNTEC, source="PWR p.149, M98 P H L", evidence="secondary",
    program="O1\nN10 M98 P2 H70\nN20 M30\nO2\nN60 G0 X1.\nN70 G0 X2.\nN80 M99",
    runs="N10 N70 N80 N20",
)
case(
    "M99 P goes on at a block of the caller (SYN-02)",
    control=SYNTEC, source="PWR p.150, M99 P", evidence="secondary",
    program="O1\nN10 M98 P2\nN20 G0 X1.\nN90 G0 X2.\nN95 M30\nO2\nN200 M99 P90",
    runs="N10 N200 N90 N95",
)
case(
    "M98 H is called from MDI as well",
    pins="mdi_calls",
    control=SYNTEC, source="PWR p.149: in memory and MDI", evidence="secondary",
    program="O2\nN60 G0 X1.\nN70 G0 X2.\nN80 M99", mdi="M98 P2 H70",
    runs="N70 N80",
)
case(
    "G65 P Z passes Z to the macro",
    pins="roles:G65=macro-call",
    control=SYNTEC, source="SYP, G65 P9810 Z", evidence="secondary",
    program="O1\nN10 G65 P9810 Z5.\nN20 M30\nO9810\nN30 #100=#26\nN40 M99",
    runs="N10 N30 N40 N20", vars={100: 5},
)
case(
    "M and T are arguments, as the tool breakage macro of the Syil takes them",
    control=SYNTEC, source="SYP, G65 P9921 M23. C0. T1.", evidence="secondary",
    program="O1\nN10 G65 P9921 M23. C0. T3.\nN20 M30\nO9921\nN30 M99",
    runs="N10 N30 N20", arguments={13: 23, 3: 0, 20: 3}, t=[],
)
case(
    "a part that its program does not have alarms, without a number that anybody knows",
    control=SYNTEC, source="SYP, M98 H9000", evidence="secondary",
    program="O1\nN10 M98 H9000\nN20 M30",
    runs="", alarm="start-not-found", number=None, at="O1 N10", word="H9000",
)
case(
    "P of M98 is a number, and holds no count",
    pins="program_word",
    control=SYNTEC, source="general knowledge", evidence="inferred",
    program="O1\nN10 M98 P20002\nN20 M30\nO20002\nN30 M99",
    runs="N10 N30 N20",
)
case(
    "G66.1 calls its macro in every block",
    pins="roles:G66.1=modal-call-every-block",
    control=SYNTEC, source="general knowledge", evidence="inferred",
    program="O1\nN10 G66.1 P2\nN20 X5.\nN30 G67\nN40 M30\nO2\nN50 M99",
    runs="N10 N20 N50 N30 N40",
)
inert("code_cascade", control=SYNTEC, reason="nothing is known of codes that call a program there")
inert(
    "skip_own_feed max_skip_signals skip_signals measuring measured",
    control=SYNTEC, reason="nothing is known of its skip signals and of its measuring",
)
