"""G code system B of lathes: G90 and G91 are modes, G77, G78 and G79 the turning cycles."""

from conformance import case

TA = ["gsk-988ta", "gsk-988t"]
FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
AT = {"start": {"X": 60, "Z": 2}}
B = AT | {"machine": "lathe-b"}
TAPAR = {"source": "TApar 3401#6", "evidence": "maker's manual"}
KNOWN = {"source": "general knowledge, G code system B", "evidence": "inferred"}

case(
    "with 3401#6 under G91 X and Z are increments",
    control=TA, **TAPAR, setup=AT, params={"3401#6": 1},
    program="O1\nN10 G94 G91 G1 X-10. Z-5. F100.\nN20 G90 X40. Z-10.\nN90 M30",
    moves="F X50 Z-3\nF X40 Z-10",
)
case(
    "in system B under G91 X and Z are increments",
    control=FANUC, **KNOWN, setup=B,
    program="O1\nN10 G94 G91 G1 X-10. Z-5. F100.\nN20 G90 X40. Z-10.\nN90 M30",
    moves="F X50 Z-3\nF X40 Z-10",
)
case(
    "with 3401#6 G77 is the turning cycle",
    control=TA, **TAPAR, setup=AT, params={"3401#6": 1}, pins="power_on:G91",
    program="O1\nN10 G94 G77 X50. Z-20. F100.\nN90 M30",
    moves="R X50\nF Z-20\nF X60\nR Z2",
)
case(
    "in system B G77 is the turning cycle",
    control=FANUC, **KNOWN, setup=B,
    program="O1\nN10 G94 G77 X50. Z-20. F100.\nN90 M30",
    moves="R X50\nF Z-20\nF X60\nR Z2",
)
case(
    "with 3401#6 under G91 G77 takes increments",
    control=TA, **TAPAR, setup=AT, params={"3401#6": 1},
    program="O1\nN10 G94 G91 G77 X-10. Z-22. F100.\nN90 M30",
    moves="R X50\nF Z-20\nF X60\nR Z2",
)
case(
    "in system B under G91 G77 takes increments",
    control=FANUC, **KNOWN, setup=B,
    program="O1\nN10 G94 G91 G77 X-10. Z-22. F100.\nN90 M30",
    moves="R X50\nF Z-20\nF X60\nR Z2",
)
case(
    "with 3401#6 G79 is the facing cycle",
    control=TA, **TAPAR, setup=AT, params={"3401#6": 1}, pins="power_on:G91",
    program="O1\nN10 G94 G79 X20. Z-3. F100.\nN90 M30",
    moves="R Z-3\nF X20\nF Z2\nR X60",
)
case(
    "in system B G79 is the facing cycle",
    control=FANUC, **KNOWN, setup=B,
    program="O1\nN10 G94 G79 X20. Z-3. F100.\nN90 M30",
    moves="R Z-3\nF X20\nF Z2\nR X60",
)
case(
    "with 3401#6 G78 is the thread cycle",
    control=TA, **TAPAR, setup=AT, params={"3401#6": 1}, pins="power_on:G91 thread_chamfer",
    program="O1\nN5 S500 M3\nN10 G78 X50. Z-20. F2.\nN90 M30",
    moves="R X50\nT Z-20\nR X60\nR Z2",
)
case(
    "in system B G78 is the thread cycle",
    control=FANUC, **KNOWN, setup=B,
    program="O1\nN5 S500 M3\nN10 G78 X50. Z-20. F2.\nN90 M30",
    moves="R X50\nT Z-20\nR X60\nR Z2",
)
case(
    "with 3401#6 G92 sets coordinates",
    control=TA, **TAPAR, setup=AT, params={"3401#6": 1},
    program="O1\nN10 G92 X0 Z0\nN20 G0 X10. Z5.\nN90 M30",
    moves="R X10 Z5",
)
case(
    "in system B G92 sets coordinates",
    control=FANUC, **KNOWN, setup=B,
    program="O1\nN10 G92 X0 Z0\nN20 G0 X10. Z5.\nN90 M30",
    moves="R X10 Z5",
)
case(
    "with 3401#6 G94 and G95 are the feeds per minute and per revolution", control=TA, **TAPAR,
    setup=AT, params={"3401#6": 1},
    program="O1\nN5 S100 M3\nN10 G95 G1 Z-18. F0.2\nN20 G94 Z-28. F100.\nN30 M30", time=66.0,
)
case(
    "G90 is no turning cycle with 3401#6", control=TA, **TAPAR, setup=AT, params={"3401#6": 1},
    program="O1\nN10 G94 G1 Z-20. F100.\nN20 G90 X50. Z-10.\nN30 M30", moves="F Z-20\nF X50 Z-10",
)
case(
    "with 3401#6 U and W are no increments of X and Z", control=TA, **TAPAR, setup=AT,
    params={"3401#6": 1}, program="O1\nN10 G94 G1 W-5. F100.\nN20 M30", final_machine="Z2",
)

# H of system A counts C from its present position: there a point is no fault.
A_LATHES = ["fanuc-16i", "fanuc-0i-f", "fanuc-30i", "mitsubishi-m700"]
POINT = {"fanuc-16i": "007", "fanuc-0i-f": "PS0007", "fanuc-30i": "PS0007", "mitsubishi-m700": "P33"}
TURN = {"source": "1.3: U W H V are the increments of system A", "evidence": "inferred"}

case(
    "H60. moves C by 60 degrees on a lathe with system A",
    control=A_LATHES, **TURN, setup={"machine": "lathe-a"},
    program="O1\nN10 #1=12.5\nN20 G0 H60.\nN25 #100=#5004\nN30 M30",
    vars={100: 60},
)
case(
    "H-60.5 moves C by -60.5 degrees on a lathe with system A",
    control=A_LATHES, **TURN, setup={"machine": "lathe-a"},
    program="O1\nN10 #1=12.5\nN20 G0 H-60.5\nN25 #100=#5004\nN30 M30",
    vars={100: -60.5},
)
case(
    "H.5 moves C by 0.5 degrees on a lathe with system A",
    control=A_LATHES, **TURN, setup={"machine": "lathe-a"},
    program="O1\nN10 #1=12.5\nN20 G0 H.5\nN25 #100=#5004\nN30 M30",
    vars={100: 0.5},
)
case(
    "H#1 moves C by 12.5 degrees on a lathe with system A",
    control=A_LATHES, **TURN, setup={"machine": "lathe-a"},
    program="O1\nN10 #1=12.5\nN20 G0 H#1\nN25 #100=#5004\nN30 M30",
    vars={100: 12.5},
)
case(
    "H takes no point on a mill, where it is a number",
    control=A_LATHES, **TURN, setup={"machine": "mill"},
    program="O1\nN10 G0 X1.\nN20 M8 G0 Z0 H60.\nN30 M30",
    runs="N10", alarm="illegal-decimal-point", number=POINT, at="O1 N20", word="H60.",
)
case(
    "H without a point is a number on a mill",
    control=A_LATHES, **TURN, setup={"machine": "mill"},
    program="O1\nN10 G0 X1.\nN20 M8 G0 Z0 H6\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "H takes no point on a lathe-b, where it is a number",
    control=A_LATHES, **TURN, setup={"machine": "lathe-b"},
    program="O1\nN10 G0 X1.\nN20 M8 G0 Z0 H60.\nN30 M30",
    runs="N10", alarm="illegal-decimal-point", number=POINT, at="O1 N20", word="H60.",
)
case(
    "H without a point is a number on a lathe-b",
    control=A_LATHES, **TURN, setup={"machine": "lathe-b"},
    program="O1\nN10 G0 X1.\nN20 M8 G0 Z0 H6\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "H of a call takes no point on a lathe with system A either", control="mitsubishi-m700", **TURN,
    setup={"machine": "lathe-a"}, program="O1\nN10 M98 P2 H30.\nN20 M30\nO2\nN30 M99", runs="",
    alarm="illegal-decimal-point", number="P33", at="O1 N10", word="H30.",
)
case(
    "H without a point counts least increments of C, and digits finer than those are cut off",
    control=["fanuc-16i", "fanuc-0i-f", "fanuc-30i"], **TURN, setup={"machine": "lathe-a"},
    program="O1\nN10 G0 H60\nN20 H1.2349\nN25 #100=#5004\nN30 M30", vars={100: 1.294},
)
