"""GSK: M198, programs of the external device."""

from conformance import case

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
SOURCE = "source document"
INFERRED = "inferred"


def one_call(call, sub="N30 M99", name="O2"):
    """Return a main program O1 of one call, and the program that it calls."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


def device_call(claim, call, **row):
    """Write a row in which O1 calls O2 of the device; `row` says what happens."""
    memory = f"O1\nN10 {call}\nN20 M30\n"
    device = {"O2.CNC": "O2\nN40 G0 X4\nN50 G0 X5\nN60 M99\n", "T2.CNC": "N70 M99\n"}
    row = {"source": "source 000, M198", "evidence": SOURCE, **row}
    case(claim, pins="roles:M198=external-call", control=TA, program=memory, external=device, **row)


device_call(
    "GSK 988TA: M198 calls a program of the external device",
    "M198 P2", runs="N10 N40 N50 N60 N20", calls="M198:O2",
)
device_call(
    "GSK 988TA: M198 reads a count in P as M98 does",
    "M198 P20002", runs="N10 (N40 N50 N60)*2 N20", calls="M198:O2",
)
device_call(
    "GSK 988TA: M198 repeats L times",
    "M198 P2 L3", runs="N10 (N40 N50 N60)*3 N20",
)
device_call(
    "GSK 988TA: M198 starts at Q, every time",
    "M198 P2 Q60 L2", runs="N10 N60*2 N20",
)
device_call(
    "GSK 988TA: M198 calls a program by its name",
    "M198 P[T2] L2", runs="N10 N70*2 N20", calls="M198:T2",
)
device_call(
    "GSK 988TA: an L of M198 above 9999 is held at 9999",
    "M198 P[T2] L20000", runs="N10 N70*9999 N20",
)
device_call(
    "GSK 988TA: an L of M198 below zero is refused",
    "M198 P2 L-2", runs="", alarm="illegal-repeat-count", number="003", at="O1 N10",
    source="source 000, M198 (3); number from Talm 003",
)
device_call(
    "GSK 988TA: a count in the P of M198 excludes L",
    "M198 P20002 L2", runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
device_call(
    "GSK 988TA: a character that no name has is refused in M198",
    "M198 P[T=2]", runs="", alarm="illegal-program-name", at="O1 N10",
)
device_call(
    "GSK 988TA: M198 without P and Q is refused",
    "M198", runs="", alarm="program-number-missing", number="081", at="O1 N10", evidence=INFERRED,
    source="source 000, note 5; Talm 081",
)
device_call(
    "GSK 988TA: M198 does not find what the device does not have",
    "M198 P3", runs="", alarm="external-program-not-found", number="083", at="O1 N10",
    source="source 000, note 3; Talm 083",
)
device_call(
    "GSK 988TA: the words of an M198 block are executed before the device is read",
    "G0 X1 M198 P3", runs="N10", alarm="external-program-not-found", number="083", at="O1 N10",
    source="source 000, M198, function",
)
device_call(
    "GSK 988TA: M98 does not read the device",
    "M98 P2", runs="", alarm="program-not-found", number="083", at="O1 N10",
    source="source 000, M98 and M198",
)
device_call(
    "GSK 988TA: the Q of M198 must be a block of the device's program",
    "M198 P2 Q20", runs="", alarm="start-not-found", number="083", at="O1 N10", evidence=INFERRED,
)
case(
    "GSK 988TA: M198 takes the number from a variable",
    control=TA, source="source 000, M198 (2)", evidence=SOURCE,
    program="O1\nN10 #100=2.7\nN20 M198 P[#100] L2\nN30 M30\n", external={"O2.CNC": "N40 M99\n"},
    runs="N10 N20 N40*2 N30",
)
case(
    "GSK 988TA: M198 P[#100] of five digits is refused like M98's",
    control=TA, source="source 000, M198 as M98; word P, format 2", evidence=SOURCE,
    program="O1\nN10 #100=10002\nN20 M198 P[#100]\nN30 M30\n", external={"O2.CNC": "N40 M99\n"},
    runs="N10", alarm="illegal-program-number", number="291", at="O1 N20",
)
case(
    "GSK 988TA: M198 does not read the memory",
    control=TA, source="source 000, M198", evidence=SOURCE,
    program=one_call("M198 P2"), external={"O3.CNC": "N40 M99\n"},
    runs="", alarm="external-program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: of two programs of one name M98 takes the memory's and M198 the device's",
    control=TA, source="source 000, M98 and M198", evidence=SOURCE,
    program="O1\nN10 M198 P2\nN20 M98 P2\nN30 M30\nO2\nN40 M99\n", external={"O2.CNC": "N50 M99\n"},
    runs="N10 N50 N20 N40 N30", calls="M198:O2 M98:O2",
)
case(
    "GSK 988TA: M99 P of a program of the device names a block of the caller",
    control=TA, source="source 000, M99", evidence=SOURCE,
    program="O1\nN10 M198 P2\nN20 G0 X2\nN30 M30\n", external={"O2.CNC": "N40 M99 P30\n"},
    runs="N10 N40 N30",
)
case(
    "GSK 988TA: a program of the device may call one of the memory",
    control=TA, source="source 000, M98 and M198", evidence=INFERRED,
    program="O1\nN10 M198 P2\nN20 M30\nO3\nN30 M99\n",
    external={"O2.CNC": "N40 M98 P3\nN50 M99\n"},
    runs="N10 N40 N30 N50 N20", calls="M198:O2 M98:O3",
)
