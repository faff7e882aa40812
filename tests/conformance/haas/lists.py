"""Haas NGC: the entries of its lists, one by one."""

from conformance import case

HAAS = "haas-ngc"
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}
_RUNS = "9 17 18 21 31 42 44 50 56 57 58 59 61 64 69 74 76 82 84 85 86 89 93 94 95 99 187"

# These rows are written by loops: a row each would say nothing but the number of the code.
for number in _RUNS.split():
    case(
        f"G{number} is a code of the Haas that runs", **KNOWN,
        program=f"O1\nN10 G{number}\nN20 M30", runs="N10 N20",
    )
case(
    "G29 without G28 before alarms on the Haas", **KNOWN,
    program="O1\nN10 G29 X5.\nN20 M30", runs="", alarm="no-intermediate", at="O1 N10", word="G29",
)

_WORDS = "A1. B1. D1. E1. H1. J1. K1. U1. V1. W1. A-1 B-1 C-1 E-1 J-1 K-1 Q-1 S-1 U-1 V-1 W-1"

for word in _WORDS.split():
    case(f"{word} is a word of the Haas", **KNOWN, program=f"O1\nN10 {word}\nN20 M30", runs="N10 N20")
case(
    "D-1 is read on the Haas, and out of range",
    **KNOWN,
    program="O1\nN10 D-1\nN20 M30",
    runs="", alarm="radius-offset-number", at="O1 N10", word="D-1",
)
case(
    "F-1 is read on the Haas, and out of range",
    **KNOWN,
    program="O1\nN10 F-1\nN20 M30",
    runs="", alarm="feed-out-of-range", at="O1 N10", word="F-1",
)
case(
    "H-1 is read on the Haas, and out of range",
    **KNOWN,
    program="O1\nN10 H-1\nN20 M30",
    runs="", alarm="offset-number", at="O1 N10", word="H-1",
)
# This list is written by a loop: twenty names of twenty systems, counted on.
for system in range(2, 20):
    case(
        f"G{109 + system} is G154 P{system}",
        control=HAAS, source="H96 p.113; general knowledge of the Haas mill", evidence="inferred",
        program=f"O1\nN10 #{6981 + 20 * system}=5.\nN20 G0 G{109 + system} X1.\nN30 #1=#5021\nN40 M30", vars={1: 6},
    )
case(
    "no source says whether the Haas has BP",
    **KNOWN,
    program="O1\nN10 BPRNT[#1[53]]\nN20 M30",
    runs="", alarm="statement-not-known", at="O1 N10",
)
case(
    "the Haas prints with DPRNT between POPEN and PCLOS", **KNOWN,
    program="O1\nN10 #1=5\nN20 POPEN\nN30 DPRNT[X#1[53]]\nN40 PCLOS\nN50 M30", messages=["X     5.000"],
)
case(
    "the functions of the Haas", **KNOWN,
    program="O1\nN10 #1=TAN[0]\nN20 #2=ACOS[1]\nN30 #3=SQRT[9]\nN40 #4=ABS[-2]\nN50 #5=ROUND[1.6]\nN60 #6=FIX[1.6]\nN70 M30",
    vars={1: 0, 2: 0, 3: 3, 4: 2, 5: 2, 6: 1},
)
case(
    "FUP is no function of the Haas", **KNOWN,
    program="O1\nN10 #1=FUP[1.2]\nN20 M30", runs="", alarm="expression-format", at="O1 N10",
)
case(
    ",R rounds a corner on the Haas", **KNOWN, setup={"machine": "mill"},
    program="O1\nN10 G1 X5. ,R1. F100.\nN20 Y5.\nN30 M30", moves="F X4\nCCW X5 Y1 C X4 Y1\nF Y5",
)
