"""Mazak: calls and returns of EIA/ISO programs, with the numbers of its maker's list."""

from conformance import case

MAZAK = "mazak-smooth"
CHAPTER = {"control": MAZAK, "source": "OB, M98 P Q L and M99 P L", "evidence": "secondary"}
KIN = {"control": MAZAK, "source": "general knowledge: as on a Mitsubishi", "evidence": "inferred"}


def listed(number):
    return {"control": MAZAK, "source": f"MZL {number}", "evidence": "secondary"}


def chain(levels):
    """Return a main program O1 from which `levels` calls are open at once."""
    text = "O1\nN1 M98 P2\nN101 M30\n"
    for k in range(2, levels + 1):
        text += f"O{k}\nN{k} M98 P{k + 1}\nN{100 + k} M99\n"
    last = levels + 1
    return text + f"O{last}\nN{last} S{last}\nN{100 + last} M99\n"


case(
    "M98 P Q starts the subprogram at its N", **CHAPTER,
    pins="start_word",
    program="O1\nN10 M98 P100 Q20\nN20 M30\nO100\nN10 G0 X1.\nN20 G0 X2.\nN30 M99",
    moves_x=[2],
)
case(
    "with L each pass starts at Q (MAZ-01)", **KIN,
    program="O1\nN5 M98 P100 Q20 L2\nN6 M30\nO100\nN10 G0 X1.\nN20 G0 X2.\nN30 M99",
    runs="N5 (N20 N30)*2 N6",
)
case(
    "H is no word of M98", **CHAPTER,
    pins="start_word",
    program="O1\nN5 M98 P100 H20\nN6 M30\nO100\nN10 G0 X1.\nN20 X2.\nN30 M99",
    runs="N5 N10 N20 N30 N6",
)
case(
    "P is the number of the program, and holds no count", **CHAPTER,
    pins="program_word",
    program="O1\nN10 M98 P30002\nN20 M98 P30002 L2\nN30 M30\nO30002\nN40 M99",
    runs="N10 N40 N20 N40*2 N30",
)
case(
    "M98 Q without P calls a part of its own program", **KIN,
    pins="omitted_program",
    program="O1\nN10 M98 Q30\nN20 M30\nN30 G0 X3.\nN40 M99",
    runs="N10 N30 N40 N20",
)
case(
    "L0 of a Mazak calls nothing", **KIN,
    pins="zero_repeats",
    program="O1\nN10 M98 P9 L0\nN20 M30",
    runs="N10 N20",
)
case(
    "10000 passes are out of range", **listed("809"),
    pins="too_many_repeats max_repeats",
    program="O1\nN10 M98 P2 L10000\nN20 M30\nO2\nN30 M99",
    runs="", alarm="repeat-count-digits", number="809", at="O1 N10", word="L10000",
)
case(
    "9999 passes are not", **KIN,
    pins="max_repeats",
    program="O1\nN10 M98 P2 L9999\nN20 M30\nO2\nN30 M99",
    runs="N10 N30*9999 N20",
)
case(
    "M99 P goes on at a block of the caller", **CHAPTER,
    program="O1\nN10 M98 P2\nN20 S1\nN30 M30\nO2\nN40 M99 P30",
    runs="N10 N40 N30",
)
case(
    "M99 P of a block that the caller has not (MAZ-04)", **listed("843"),
    program="O1\nN10 M98 P100\nN20 M30\nO100\nN30 G0 X5.\nN40 M99 P71",
    runs="N10 N30", alarm="return-target-not-found", number="843", at="O100 N40", word="P71",
)
case(
    "M99 L changes how often the subprogram still runs", **CHAPTER,
    pins="return_with_l",
    program="O1\nN10 M98 P2 L5\nN20 M30\nO2\nN30 M99 L0",
    runs="N10 N30 N20",
)
case(
    "Q of a block that the subprogram has not", **listed("843"),
    program="O1\nN10 M98 P2 Q9\nN20 M30\nO2\nN30 M99",
    runs="", alarm="start-not-found", number="843", at="O1 N10", word="Q9",
)
case(
    "GOTO to a block that is not there", **listed("843"),
    program="O1\nN10 GOTO 50\nN20 M30",
    runs="", alarm="jump-target-not-found", number="843", at="O1 N10",
)
case(
    "a program that is not registered", **listed("844"),
    program="O1\nN10 M98 P2\nN20 M30",
    runs="", alarm="program-not-found", number="844", at="O1 N10", word="P2",
)
case(
    "eight levels are allowed", **listed("842"),
    pins="max_nesting",
    program=chain(8),
    runs=" ".join(f"N{k}" for k in range(1, 10)) + " " + " ".join(f"N{100 + k}" for k in range(9, 0, -1)),
)
case(
    "the ninth level is refused (MAZ-06)", **listed("842"),
    pins="max_nesting",
    program=chain(9),
    runs=" ".join(f"N{k}" for k in range(1, 9)), alarm="nesting-too-deep", number="842", at="O9 N9",
)
case(
    "O0 and N0", **listed("811"),
    pins="refuses:program-number-zero",
    program="O1\nN0 G0 X1.\nN20 M30",
    runs="", alarm="program-number-zero", number="811", at="O1",
)
case(
    "a program without M02, M30 or M99", **listed("810"),
    pins="missing_end",
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.",
    runs="N10 N30", alarm="end-of-record", number="810", at="O2",
)
case(
    "M99 in the main program starts it again", **listed("842: M99 is refused in direct operation alone"),
    pins="main_return",
    program="O1\nN10 S1\nN20 M99",
    runs="(N10 N20)*2", max_cycles=2, stop="cycles",
)
for letter in "IJK":
    case(
        f"M98 with {letter} rotates a figure, which is not computed", **KIN,
        pins="call_words_not_computed",
        program=f"O1\nN10 M98 P2 {letter}5.\nN20 M30\nO2\nN30 M99",
        runs="", alarm="code-not-computed", number=None, at="O1 N10", word=f"{letter}5.",
    )
case(
    ",D is no word of it", **KIN,
    pins="device_word",
    program="O1\nN10 M98 P2 ,D1\nN20 M30\nO2\nN30 M99",
    runs="", alarm="address-not-usable", number="806", at="O1 N10",
)
case(
    "G65 passes its words to the macro", control=MAZAK, source="MZG, G65", evidence="secondary",
    pins="roles:G65=macro-call",
    program="O1\nN10 G65 P2 A1.5 Q3.\nN20 M30\nO2\nN30 M99",
    runs="N10 N30 N20", arguments={1: 1.5, 17: 3},
)
case(
    "G66 calls after each block that moves, until G67", control=MAZAK, source="MZG, G66", evidence="secondary",
    pins="roles:G66=modal-call",
    program="O1\nN10 G66 P2\nN20 G0 X1.\nN30 M8\nN40 X2.\nN50 G67\nN60 X3.\nN70 M30\nO2\nN80 M99",
    runs="N10 N20 N80 N30 N40 N80 N50 N60 N70",
)
case(
    "G66.1 makes each block the arguments of its macro", control=MAZAK, source="MZG, G66.1", evidence="inferred",
    pins="roles:G66.1=modal-call-every-block",
    program="O1\nN10 G66.1 P2\nN20 X1.\nN30 G67\nN40 M30\nO2\nN50 #500=#24\nN60 M99",
    runs="N10 N20 N50 N60 N30 N40", vars={500: 1},
)
for code in ("G65", "G66", "G66.1"):
    case(
        f"{code} without P", **listed("893"),
        program=f"O1\nN10 {code} A1.\nN20 M30",
        runs="", alarm="program-number-missing", number="893", at="O1 N10",
    )
case(
    "G67 without a modal call", **listed("857"),
    pins="cancel_alone",
    program="O1\nN10 G67\nN20 M30",
    runs="", alarm="modal-call-missing", number="857", at="O1 N10",
)
