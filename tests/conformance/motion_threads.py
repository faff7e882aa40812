"""Threads of lathes: the lead, the run-out at the end, the cycles G92 and G76."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, TE = "gsk-980tdi", "gsk-928te"
GSK = [*GSK_988, TDI]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
OTHERS = [*MITSUBISHI, *FANUC]
FANUC_317 = {F16: "062", **dict.fromkeys(FANUC_PS, "PS0317")}


def at(x, z):
    return {"machine": "lathe-a", "start": {"X": x, "Z": z}}


def thread(claim, control, block, moves, *, start=(65, 5), source="TDi 24.9", **more):
    """One block behind a block that starts the spindle."""
    evidence = more.pop("evidence", "maker's manual")
    case(
        claim, control=control, source=source, evidence=evidence, setup=at(*start),
        pins="run_out_words lead_growth",
        program=f"O1\nN10 G97 S60 M3\nN20 {block}\nN30 M30", moves=moves, **more,
    )


# The run-out of G92

thread(
    "J and K of G92 run the thread out by a straight line", [*GSK_988, TDI],
    "G92 X58.7 Z-28 F3 J3 K1",
    "R X58.7\nT X58.7 Z-27\nT X64.7 Z-28\nR X65\nR Z5", source="TDi 24.9, O0012; TA 18",
)
thread(
    "the run-out of G92 without J and K comes from parameter 019", TDI, "G92 X58.7 Z-28 F3",
    "R X58.7\nT X58.7 Z-26.5\nT X61.7 Z-28\nR X65\nR Z5", params={"019": 5},
    source="TDi 24.9 note 2",
)
thread(
    "the run-out of G92 without J and K comes from parameter 5130", GSK_988, "G92 X58.7 Z-28 F3",
    "R X58.7\nT X58.7 Z-26.5\nT X61.7 Z-28\nR X65\nR Z5", params={"5130": 5}, source="TA 18",
)
thread(
    "the run-out of G92 comes from parameter 5130 of a FANUC", FANUC, "G92 X58.7 Z-28. F3.",
    "R X58.7\nT X58.7 Z-26.5\nT X61.7 Z-28\nR X65\nR Z5", params={"5130": 5},
    source="motion: FANUC chamfer 5130, general knowledge", evidence="inferred",
)
thread(
    "without J, K and parameter G92 runs to the end", [*GSK, *OTHERS], "G92 X58.7 Z-28. F3.",
    "R X58.7\nT X58.7 Z-28\nR X65\nR Z5", source="TDi 24.9; TA 18", evidence="inferred",
)
thread(
    "J of G92 without K runs out as far along as across", TDI, "G92 X58.7 Z-28 F3 J3",
    "R X58.7\nT X58.7 Z-25\nT X64.7 Z-28\nR X65\nR Z5", source="TDi 24.9 note 4",
)
thread(
    "J of G92 without K draws back at the end on the 988", GSK_988, "G92 X58.7 Z-28 F3 J3",
    "R X58.7\nT X58.7 Z-28\nR X64.7\nR X65\nR Z5", source="TA 18",
)
thread(
    "K of G92 without J takes the way across from 019", TDI, "G92 X58.7 Z-28 F3 K1",
    "R X58.7\nT X58.7 Z-27\nT X61.7 Z-28\nR X65\nR Z5", params={"019": 5},
    source="TDi 24.9 note 3",
)
for _words in "K1", "J0", "J0 K1", "J3 K0":
    thread(
        f"{_words} of G92 runs nothing out on the 988", GSK_988, f"G92 X58.7 Z-28 F3 {_words}",
        "R X58.7\nT X58.7 Z-28\nR X65\nR Z5", source="TA 18", params={"5130": 5},
    )
for _words in "J0", "J0 K1":
    thread(
        f"{_words} of G92 runs nothing out on the 980TDi", TDI, f"G92 X58.7 Z-28 F3 {_words}",
        "R X58.7\nT X58.7 Z-28\nR X65\nR Z5", source="TDi 24.9 notes 5 and 7", params={"019": 5},
    )
thread(
    "K0 of G92 is J", TDI, "G92 X58.7 Z-28 F3 J3 K0",
    "R X58.7\nT X58.7 Z-25\nT X64.7 Z-28\nR X65\nR Z5", source="TDi 24.9 note 6",
)
thread(
    "a negative J counts as a positive one in G92", TDI, "G92 X58.7 Z-28 F3 J-3 K-1",
    "R X58.7\nT X58.7 Z-27\nT X64.7 Z-28\nR X65\nR Z5", source="TDi 24.9 note 10",
)
thread(
    "a run-out of G92 goes no further than the start", [*GSK_988, TDI], "G92 X58.7 Z-28 F3 J9 K1",
    "R X58.7\nT X58.7 Z-27\nT X65 Z-28\nR X65\nR Z5", source="TA 18 note 5",
)
case(
    "J and K of G92 stay until another motion code",
    control=GSK, source="TDi 24.9; TA 18", evidence="maker's manual", setup=at(65, 5),
    program="O1\nN10 G97 S60 M3\nN20 G92 X58 Z-28 F3 J1 K1\nN30 X57\nN40 G0 X65\nN50 M30",
    moves="""
        R X58
        T X58 Z-27
        T X60 Z-28
        R X65
        R Z5
        R X57
        T X57 Z-27
        T X59 Z-28
        R X65
        R Z5
        R X65
    """,
)
thread(
    "a taper thread runs out from its own line", TDI, "G92 X40 Z-20 R-5 F2 J1 K5",
    "R X30\nT X37.5 Z-15\nT X39.5 Z-20\nR X50\nR Z0", start=(50, 0),
)

# G32

for _control, _source in ((TDI, "TDi 24.1"), (TA, "TA 14")):
    thread(
        f"J and K of G32 run the thread out on {_control}", _control, "G32 Z-20 F2 J3 K1",
        "T X20 Z-19\nT X26 Z-20", start=(20, 3), source=_source,
    )
    thread(
        f"a negative J of G32 runs out to the other side on {_control}", _control,
        "G32 Z-20 F2 J-3 K1", "T X20 Z-19\nT X14 Z-20", start=(20, 3), source=_source,
    )
    thread(
        f"K of G32 alone runs nothing out on {_control}", _control, "G32 Z-20 F2 K1",
        "T X20 Z-20", start=(20, 3), source=_source,
    )
thread(
    "J of G32 without K is K too", TDI, "G32 Z-20 F2 J3", "T X20 Z-17\nT X26 Z-20",
    start=(20, 3), source="TDi 24.1 note 2",
)
thread(
    "J of G32 without K draws back at the end on the 988", GSK_988, "G32 Z-20 F2 J3",
    "T X20 Z-20\nR X26", start=(20, 3), source="TA 14 (2)",
)
thread(
    "J and K are no run-out of G32", OTHERS, "G32 Z-20. F2. J3. K1.", "T X20 Z-20",
    start=(20, 3), source="general knowledge", evidence="inferred",
)
thread(
    "a face thread runs out along Z", TDI, "G32 X20 F2 J2 K1", "T X22 Z0\nT X20 Z2",
    start=(50, 0), source="TDi 24.1: J on the short axis",
)
case(
    "J and K of G32 stay for the thread behind it, and end with another motion code",
    control=TDI, source="TDi 24.1 note 1", evidence="maker's manual", setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G32 Z-10 F2 J1 K1\nN30 Z-20\nN40 G0 Z0\nN50 G32 Z-5 F2\nN60 M30",
    moves="T X20 Z-9\nT X22 Z-10\nT X22 Z-19\nT X24 Z-20\nR Z0\nT X24 Z-5",
)
for _control, _number in (([TA, T], "039"), ([TDI], None)):
    case(
        f"a run-out longer than its thread alarms on {' and '.join(_control)}",
        control=_control, source="Talm 039; TA 14 note 4", evidence="secondary", setup=at(20, 0),
        program="O1\nN10 G97 S60 M3\nN20 G32 Z-2 F1 J1 K5\nN30 M30",
        runs="N10", alarm="thread-run-out", number=_number, at="O1 N20",
    )

# The lead

for _control, _number in ((GSK_988, "038"), ([TDI], None)):
    case(
        f"a thread before any lead alarms on {' and '.join(_control)}, whatever the feed is",
        pins="lead_apart",
        control=_control, source="Talm 038; TDi 24.1", evidence="secondary", setup=at(20, 0),
        program="O1\nN10 G97 S60 M3\nN20 G98 G1 Z-1 F100\nN30 G32 Z-20\nN40 M30",
        runs="N10 N20", alarm="thread-lead", number=_number, at="O1 N30",
    )
case(
    "a thread takes the feed in force as its lead",
    pins="lead_apart",
    control=OTHERS, source="general knowledge", evidence="inferred", setup=at(20, 0),
    program="O1\nN10 G97 S60 M3 G99\nN20 G1 Z-1. F0.5\nN30 G32 Z-3.\nN40 M30",
    moves="F Z-1\nT Z-3", time=6,
)
case(
    "a lead stays until the next one, and the feed is another number",
    control=GSK, source="TDi 24.1: F of a thread", evidence="maker's manual",
    setup=at(20, 0),
    program="""
        O1
        N10 G97 S60 M3
        N20 G32 Z-2 F2
        N30 G98 G1 Z0 F120
        N40 G32 Z-2
        N50 G1 Z0
        N60 M30
    """,
    time=4,
)
thread(
    "I is the number of threads an inch", GSK, "G32 Z-25.4 I10", "T Z-25.4", start=(20, 0),
    source="TDi 24.1; TA 14", time=10,
)
thread(
    "the lead of G34 grows by R", GSK, "G34 W-40 F2 R1", "T Z-40", start=(20, 0),
    source="TDi 24.4; TA 17", time=7.165,
)
thread(
    "the lead of G34 grows by K", OTHERS, "G34 W-40. F2. K1.", "T Z-40", start=(20, 0),
    source="general knowledge", evidence="inferred", time=7.165,
)
thread(
    "J and K of G34 are its run-out, and the lead grows there too", GSK,
    "G34 W-40 F2 R1 J5 K2", "T Z-38\nT X30 Z-40", start=(20, 0), source="TDi 24.4; TA 17",
    time=7.165 - 0.222 + 5 / 9.060,
)
for _word, _controls, _numbers in (
    ("R-1", GSK, {TA: "038", T: "038", TDI: None}),
    ("K-1.", OTHERS, {
        **dict.fromkeys(MITSUBISHI, "P93"), F16: None, **dict.fromkeys(FANUC_PS, "PS0313"),
    }),
):
    case(
        f"G34 {_word} alarms where its lead would come to nothing",
        control=_controls, source="TDi 24.4; ALM 313; Talm 038", evidence="secondary",
        setup=at(20, 0),
        program=f"O1\nN10 G97 S60 M3\nN20 G34 W-40. F2. {_word}\nN30 M30",
        runs="N10", alarm="thread-lead", number=_numbers, at="O1 N20",
    )

# G76

_PASS = "R X18 Z5\nT X18 Z-19\nT X20 Z-20\nR X30\nR Z5\n"
_PLAIN = "R X18 Z5\nT X18 Z-20\nR X30\nR Z5\n"


def multiple(claim, control, first, second, moves, **more):
    case(
        claim, control=control, setup=at(30, 5),
        pins="one_block_cycles thread_digits_apart",
        source=more.pop("source", "TDi 24.12; TA 21"),
        evidence=more.pop("evidence", "maker's manual"),
        program=f"O1\nN10 G97 S60 M3\nN20 {first}\nN30 {second}\nN40 M30", moves=moves, **more,
    )


for _controls, _depth in (([TDI, *FANUC], "P1000 Q1000"), (GSK_988, "P1 Q1")):
    multiple(
        f"r of P in G76 runs the thread out by tenths of its lead with {_depth}", _controls,
        "G76 P010500 Q0 R0", f"G76 X18. Z-20. {_depth} F2.", _PASS * 2,
    )
    multiple(
        f"r of 00 in G76 runs nothing out with {_depth}", _controls,
        "G76 P010000 Q0 R0", f"G76 X18. Z-20. {_depth} F2.", _PLAIN * 2,
    )
    multiple(
        f"a first cut of G76 deeper than the thread is cut at once with {_depth}", _controls,
        "G76 P010000 Q0 R0", f"G76 X18. Z-20. {_depth}5 F2.", _PLAIN * 2,
        source="TA 21 note 5",
    )
multiple(
    "J and K of G76 are its run-out", GSK_988, "G76 P010500 Q0 R0",
    "G76 X18 Z-20 P1 Q1 F2 J2 K1", "R X18 Z5\nT X18 Z-19\nT X22 Z-20\nR X30\nR Z5\n" * 2,
    source="TA 21 note 9",
)
multiple(
    "P of two digits in G76 is the angle alone", TDI, "G76 P0 Q0 R0",
    "G76 X18 Z-20 P1000 Q1000 F2", _PASS * 3, params={"019": 5, "057": 2},
    source="TDi 24.12 note 4",
)
multiple(
    "P of three digits in G76 is run-out and angle", TDI, "G76 P500 Q0 R0",
    "G76 X18 Z-20 P1000 Q1000 F2", _PASS * 3, params={"057": 2}, source="TDi 24.12 note 4",
)
for _controls, _params in ((GSK_988, "5142 5143 5140 5141"), (FANUC, "5142 5143 5140 5141"),
                           (TDI, "057 058 059 060")):
    _passes, _angle, _least, _allowance = _params.split()
    _depth = "P1 Q0.4" if _controls == GSK_988 else "P1000 Q400"
    multiple(
        f"G76 without its first block takes the parameters {_passes} and behind"
        f" with {_depth} of a control with {len(_controls)}",
        _controls, "G4 P1000", f"G76 X18. Z-20. {_depth} F2.",
        "W 1\n" + "".join(
            f"R X{18 + 2 * (1 - depth):.4f} Z{5 - depth * 0.5773503:.4f}\n"
            f"T X{18 + 2 * (1 - depth):.4f} Z-20\nR X30\nR Z5\n"
            for depth in (0.4, 0.7, 0.865685, 0.9, 1, 1)
        ),
        params={_passes: 2, _angle: 60, _least: 0.3, _allowance: 0.1},
        source="TDi 24.12; TA 21", evidence="inferred" if _controls == FANUC else "maker's manual",
    )

_DATA = {
    "the least cut above the height": ("P010060 Q2 R0", "X18 Z-20 P1 Q1", "thread-least-cut", "164"),
    "an allowance of the whole height": ("P010060 Q0 R1", "X18 Z-20 P1 Q1", "thread-allowance",
                                         "165"),
    "no depth of the first cut": ("P010060 Q0 R0", "X18 Z-20 P1", "thread-cut", "169"),
    "a height of nothing": ("P010060 Q0 R0", "X18 Z-20 P0 Q1", "thread-height-value", "168"),
    "no travel in X": ("P010060 Q0 R0", "Z-20 P1 Q1", "thread-travel", "160"),
    "no travel in Z": ("P010060 Q0 R0", "X18 P1 Q1", "thread-travel", "160"),
    "a taper against the cut": ("P010060 Q0 R0", "X18 Z-20 R9 P1 Q1", "thread-taper", "166"),
    "a taper over 45 degrees": ("P010060 Q0 R0", "X18 Z-20 R-26 P1 Q1", "thread-steep", "170"),
}
for _what, (_first, _second, _cause, _number) in _DATA.items():
    case(
        f"G76 with {_what} alarms on the 988",
        control=GSK_988, source=f"Talm {_number}", evidence="secondary", setup=at(30, 5),
        program=f"O1\nN10 G97 S60 M3\nN20 G76 {_first}\nN30 G76 {_second} F2\nN40 M30",
        runs="N10 N20", alarm=_cause, number=_number, at="O1 N30",
    )
case(
    "G76 with no finishing passes alarms on the 988",
    pins="thread_digits_apart",
    control=GSK_988, source="Talm 161", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P560 Q0 R0\nN30 M30",
    runs="N10", alarm="thread-passes", number="161", at="O1 N20",
)
for _what, _second, _cause in (
    ("the height of nothing", "X18. Z-20. P0 Q1000", "thread-height-value"),
    ("no depth of the first cut", "X18. Z-20. P1000", "thread-cut"),
):
    case(
        f"G76 with {_what} alarms on a FANUC",
        control=FANUC, source="ALM 0317", evidence="secondary", setup=at(30, 5),
        program=f"O1\nN10 G97 S60 M3\nN20 G76 {_second} F2.\nN30 M30",
        runs="N10", alarm=_cause, number=FANUC_317, at="O1 N20",
    )
case(
    "a thread of a mill takes the feed in force as its lead",
    control=FANUC, source="general knowledge", evidence="inferred",
    setup={"machine": "mill"},
    program="O1\nN10 S60 M3\nN20 G95 G1 Z-1. F0.5\nN30 G33 Z-3.\nN40 M30",
    moves="F Z-1\nT Z-3", time=6,
)
case(
    "J and K are no run-out of a mill's thread",
    control=FANUC, source="general knowledge", evidence="inferred",
    setup={"machine": "mill"},
    program="O1\nN10 S60 M3\nN20 G33 Z-20. F2. J3. K1.\nN30 M30", moves="T Z-20",
)
GSK_STARTS = ["gsk-988ta", "gsk-988t", "gsk-980tdi"]
STARTS = {"source": "TDi 24.9, TA 18: L", "evidence": "maker's manual"}
case(
    "a thread of two starts is cut twice, also in the blocks behind", control=GSK_STARTS, **STARTS,
    pins="thread_starts",
    setup={"start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G92 X20 Z-20 F2 L2\nN20 X19\nN30 M30",
    moves="R X20\nT Z-20\nR X30\nR Z5\n" * 2 + "R X19\nT Z-20\nR X30\nR Z5\n" * 2,
)
case(
    "a thread has one start where L does not count them",
    pins="thread_starts",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "mitsubishi-meldas",
             "mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge", evidence="inferred",
    setup={"machine": "lathe-a", "start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G92 X20. Z-20. F2. L2\nN30 M30",
    moves="R X20\nT Z-20\nR X30\nR Z5",
)
for _words in ("L0", "L1000"):
    case(
        f"a thread of {_words} starts alarms", control=GSK_STARTS, **STARTS,
        setup={"start": {"X": 30, "Z": 5}},
        program=f"O1\nN5 S500 M3\nN10 G92 X20 Z-20 F2 {_words}\nN30 M30",
        alarm="value-out-of-range",
        number={"gsk-988ta": "003", "gsk-988t": "003", "gsk-980tdi": "0012"}, at="O1 N10",
    )
for _words in ("L2", "D1", "E1"):
    case(
        f"G76 with {_words}: where its passes lie is not computed", control=GSK_STARTS[:2],
        pins="thread_words_not_computed",
        source="TA 21", evidence="maker's manual", setup={"start": {"X": 30, "Z": 5}},
        program=f"O1\nN5 S500 M3\nN10 G76 P020060 Q0.1 R0.1 {_words}\nN20 M30",
        alarm="code-not-computed", at="O1 N10",
    )
case(
    "L, D and E are no words of G76",
    pins="thread_words_not_computed",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "mitsubishi-meldas",
             "mitsubishi-m700", "mitsubishi-m800", "gsk-980tdi"],
    source="general knowledge", evidence="inferred",
    setup={"machine": "lathe-a", "start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G76 P020060 Q100 R0.1 L2 D1 E1\nN20 M30", moves="none",
)
case(
    "J of G32 draws back where the thread has no length too", control=GSK_988,
    source="TA 18", evidence="inferred", setup={"machine": "lathe-a", "start": {"X": 30, "Z": 0}},
    program="O1\nN10 G97 S60 M3\nN20 G32 Z-20. F2. J3.\nN30 G32 Z-20.\nN40 M30\n",
    moves="T Z-20\nR X36\nT X36\nR X42",
)
