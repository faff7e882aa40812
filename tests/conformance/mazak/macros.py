"""Mazak: macro statements, variables and the alarms of programs."""

from conformance import case

MAZAK = "mazak-smooth"
KIN = {"control": MAZAK, "source": "general knowledge: as on a Mitsubishi", "evidence": "inferred"}


def listed(number, evidence="secondary"):
    return {"control": MAZAK, "source": f"MZL {number}", "evidence": evidence}


def stops(name, statement, alarm, number, evidence="secondary", **more):
    """Add a row for a block that alarms by a number of the list."""
    case(
        name, **listed(number, evidence), program=f"O1\nN10 S1\nN20 {statement}\nN30 M30",
        runs="N10", alarm=alarm, number=number, at="O1 N20", **more,
    )


for n, number in ((1, "980"), (10, "989"), (11, "990"), (20, "999"), (21, "979"), (30, "979"), (9999, "979")):
    case(
        f"#3000={n} raises {number} (MAZ-11)", **listed(number),
        pins={20: "user_alarm_offset user_alarm_numbers", 21: "user_alarm_numbers", 9999: "user_alarm_last"}.get(n, ""),
        program=f"O1\nN10 #3000={n}(TOOL WORN)\nN20 M30",
        runs="N10", alarm="user-alarm", number=number, at="O1 N10",
    )
case(
    "#3000 takes no number above 9999", **KIN,
    pins="user_alarm_last",
    program="O1\nN10 #3000=10000\nN20 M30",
    runs="", alarm="illegal-user-alarm", number=None, at="O1 N10",
)
stops("a word and a statement in one block", "G0 #1=1", "nc-and-macro-in-block", "854")
stops("six brackets inside each other", "#1=[[[[[[1]]]]]]", "brackets-too-deep", "858", pins="max_brackets")
stops("brackets that do not pair", "#1=[[1]", "bracket-not-closed", "859")
stops("an expression that is wrong", "#1=1+*2", "expression-format", "860")
stops("a division by zero (MAZ-12)", "#1=1/0", "division-by-zero", "861")
stops("the root of a negative value", "#1=SQRT[-1]", "square-root-of-negative", "860", "inferred")
stops("IF without a condition", "IF GOTO 30", "if-format", "864")
stops("a condition that compares nothing", "IF[#1]GOTO 30", "if-format", "864", pins="conditions:bare")
stops("a WHILE without DO on a Mazak", "WHILE[#1 EQ 0]", "while-format", "865", pins="loop_form")
stops("END1 of no DO", "END1", "missing-do", "868")
stops("an assignment without =", "#1 5", "missing-equals", "847")
stops("a wrong address", "@5", "illegal-character", "806", "inferred")
stops("a G code that it has not", "G5.5", "g-code-not-available", "808")
stops("an address without a value", "X", "address-without-value", "807")
case(
    "27 loops inside each other", **listed("867"),
    pins="max_loops",
    program="O1\n" + "".join(f"DO{k}\n" for k in range(1, 28)) + "#1=5\nN10 M30\n" + "".join(f"END{k}\n" for k in range(27, 0, -1)),
    vars={1: 5},
)
case(
    "28 loops inside each other", **listed("867"),
    pins="max_loops",
    program="O1\n" + "".join(f"DO{k}\n" for k in range(1, 29)) + "N10 M30\n" + "".join(f"END{k}\n" for k in range(28, 0, -1)),
    runs="", alarm="loops-too-deep", number="867",
)
case(
    "more than ten sets of I, J and K", **listed("856"),
    pins="argument_sets",
    program="O1\nN10 G65 P2 " + "I1. J1. K1. " * 11 + "\nN20 M30\nO2\nN30 M99",
    runs="", alarm="too-many-argument-sets", number="856", at="O1 N10",
)
case(
    "five macros open at once", **listed("855", "inferred"),
    pins="max_macro_nesting",
    program="O1\nN1 G65 P2\nM30\n" + "".join(f"O{k}\nN{k} G65 P{k + 1}\nM99\n" for k in range(2, 7)) + "O7\nM99",
    runs="N1 N2 N3 N4", alarm="macro-nesting-too-deep", number="855", at="O5 N5",
)
case(
    "what a variable of the maker's own holds is not known", **KIN,
    pins="unlisted_variables",
    program="O1\nN10 #1=#50001\nN20 M30",
    runs="", alarm="variable-not-known", number=None, at="O1 N10", word="#50001",
)
case(
    "#100 to #199 and #500 to #999 are common", **KIN,
    pins="commons",
    program="O1\nN10 #100=1\nN20 #199=2\nN30 #500=3\nN40 #999=4\nN50 M30",
    vars={100: 1, 199: 2, 500: 3, 999: 4},
)
