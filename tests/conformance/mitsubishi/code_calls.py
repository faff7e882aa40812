"""Mitsubishi: codes that call."""

from conformance import case

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]

# Codes that call are registered on a screen of the control.
G300_CALLS_O9010 = {"registered_codes": "G300=macro-call:9010"}
M100_CALLS_O9001 = {"registered_codes": "M100=call:9001"}
M100_CALLS_O9020 = {"registered_codes": "M100=macro-call:9020"}


def macro_chain(levels, first=2):
    """Return macros that call one another with G65: Ok calls in Nk, returns in N(100+k)."""
    text = ""
    for k in range(first, first + levels - 1):
        text += f"O{k}\nN{k} G65 P{k + 1}\nN{100 + k} M99\n"
    last = first + levels - 1
    return text + f"O{last}\nN{last} S{last}\nN{100 + last} M99\n"


case(
    "a registered G code calls its macro with arguments",
    control=EVERY, source="general knowledge, G-code call", evidence="inferred",
    program="""
        O1
        N10 G300 A1.5
        N20 M30
        O9010
        N210 #100=#1
        N220 M99
    """,
    replace=G300_CALLS_O9010, runs="N10 N210 N220 N20", calls="G-code:O9010",
    vars={100: 1.5},
)
case(
    "an M code that calls a subprogram shares the caller's locals",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 #1=5
        N20 M100
        N30 M30
        O9001
        N210 #1=#1+1
        N220 M99
    """,
    replace=M100_CALLS_O9001, runs="N10 N20 N210 N220 N30", m=[], vars={1: 6},
)
case(
    "the subprogram of a calling M code must exist: P232",
    control=EVERY, source="source 004, note 1; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M100
        N30 M30
    """,
    replace=M100_CALLS_O9001, runs="N10", m=[8], alarm="program-not-found", number="P232",
    at="O1 N20",
)
case(
    "inside a macro that a G code called, a calling G code is the plain code",
    pins="unlisted_codes code_cascade",
    control=EVERY, source="general knowledge, G-code call", evidence="inferred",
    program="""
        O1
        N10 G300
        N20 M30
        O9010
        N210 G300 X5.
        N220 M99
    """,
    replace=G300_CALLS_O9010, runs="N10", calls="G-code:O9010",
    alarm="g-code-not-available", number="P34", at="O9010 N210",
)
case(
    "the program of a calling G code must exist: P232",
    control=EVERY, source="source 004, note 1; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G300 A1.
        N20 M30
    """,
    replace=G300_CALLS_O9010, runs="", alarm="program-not-found", number="P232", at="O1 N10",
)
case(
    "a G code that is not registered is P34",
    control=EVERY, source="SK P34", evidence="secondary",
    program="""
        O1
        N10 G999
        N20 M30
    """,
    runs="", alarm="g-code-not-available", number="P34", at="O1 N10", word="G999",
)
case(
    "a calling M code is not sent to the machine",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 M100
        N20 M8
        N30 M30
        O9020
        N210 M99
    """,
    replace=M100_CALLS_O9020, runs="N10 N210 N20 N30", m=[8], calls="M-code:O9020",
)
case(
    "an M code that calls a macro passes the words of its block",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 M100 A3.5
        N20 M30
        O9020
        N210 #100=#1
        N220 M99
    """,
    replace=M100_CALLS_O9020, runs="N10 N210 N220 N20", vars={100: 3.5, 1: None},
)
case(
    "inside the macro of an M code the same M code goes to the machine",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 M100
        N20 M30
        O9020
        N210 M100
        N220 M99
    """,
    replace=M100_CALLS_O9020, runs="N10 N210 N220 N20", m=[100], calls="M-code:O9020",
)
case(
    "the program of a calling M code must exist: P232",
    control=EVERY, source="source 004, note 1; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M100
        N30 M30
    """,
    replace=M100_CALLS_O9020, runs="N10", alarm="program-not-found", number="P232",
    at="O1 N20",
)
case(
    "a call by code counts as a macro level",
    control=NEWER, source="SM (6); general knowledge", evidence="inferred",
    program="""
        O1
        N1 M100
        N101 M30
        O9020
        N9 G65 P2
        N109 M99
    """ + "\n".join("        " + line for line in macro_chain(4).splitlines()) + "\n",
    replace=M100_CALLS_O9020, runs="N1 N9 N2 N3", alarm="macro-nesting-too-deep",
    number="P273", at="O4 N4",
)
case(
    "a registered G code calls its macro after every move",
    control=EVERY, source="general knowledge, G-code call", evidence="inferred",
    program="""
        O1
        N10 G300 A2.
        N20 G0 X5.
        N30 G67
        N40 M30
        O9010
        N210 #100=#1
        N220 M99
    """,
    replace={"registered_codes": "G300=modal-call:9010"},
    runs="N10 N20 N210 N220 N30 N40", vars={100: 2},
)
case(
    "every T calls the program that T is registered with",
    control=EVERY, source="general knowledge, T-code call", evidence="inferred",
    program="""
        O1
        N10 T3
        N20 M30
        O9000
        N210 #100=#149
        N220 M99
    """,
    replace={"registered_codes": "T=call:9000"},
    runs="N10 N210 N220 N20", calls="T-code:O9000", vars={100: 3},
)
case(
    "an M code with a meaning of its own may not be registered",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 M98 P9001
        N20 M30
        O9001
        N210 M99
    """,
    replace={"registered_codes": "M98=call:9001"}, runs="", alarm="code-may-not-call", at="O1 N10",
)
