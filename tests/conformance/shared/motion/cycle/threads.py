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
    """Write a row of one block after a block that starts the spindle."""
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
thread(
    "K1 of G92 runs nothing out on the 988",
    GSK_988, "G92 X58.7 Z-28 F3 K1", "R X58.7\nT X58.7 Z-28\nR X65\nR Z5", source="TA 18",
    params={"5130": 5},
)
thread(
    "J0 of G92 runs nothing out on the 988",
    GSK_988, "G92 X58.7 Z-28 F3 J0", "R X58.7\nT X58.7 Z-28\nR X65\nR Z5", source="TA 18",
    params={"5130": 5},
)
thread(
    "J0 K1 of G92 runs nothing out on the 988",
    GSK_988, "G92 X58.7 Z-28 F3 J0 K1", "R X58.7\nT X58.7 Z-28\nR X65\nR Z5", source="TA 18",
    params={"5130": 5},
)
thread(
    "J3 K0 of G92 runs nothing out on the 988",
    GSK_988, "G92 X58.7 Z-28 F3 J3 K0", "R X58.7\nT X58.7 Z-28\nR X65\nR Z5", source="TA 18",
    params={"5130": 5},
)
thread(
    "J0 of G92 runs nothing out on the 980TDi",
    TDI, "G92 X58.7 Z-28 F3 J0", "R X58.7\nT X58.7 Z-28\nR X65\nR Z5",
    source="TDi 24.9 notes 5 and 7", params={"019": 5},
)
thread(
    "J0 K1 of G92 runs nothing out on the 980TDi",
    TDI, "G92 X58.7 Z-28 F3 J0 K1", "R X58.7\nT X58.7 Z-28\nR X65\nR Z5",
    source="TDi 24.9 notes 5 and 7", params={"019": 5},
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
    "a run-out of G92 goes no further than the start", [TA, TDI], "G92 X58.7 Z-28 F3 J9 K1",
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
thread(
    "J and K of G32 run the thread out on gsk-980tdi",
    TDI, "G32 Z-20 F2 J3 K1", "T X20 Z-19\nT X26 Z-20", start=(20, 3), source="TDi 24.1",
)
thread(
    "a negative J of G32 runs out to the other side on gsk-980tdi",
    TDI, "G32 Z-20 F2 J-3 K1", "T X20 Z-19\nT X14 Z-20", start=(20, 3), source="TDi 24.1",
)
thread(
    "K of G32 alone runs nothing out on gsk-980tdi",
    TDI, "G32 Z-20 F2 K1", "T X20 Z-20", start=(20, 3), source="TDi 24.1",
)
thread(
    "J and K of G32 run the thread out on gsk-988ta",
    TA, "G32 Z-20 F2 J3 K1", "T X20 Z-19\nT X26 Z-20", start=(20, 3), source="TA 14",
)
thread(
    "a negative J of G32 runs out to the other side on gsk-988ta",
    TA, "G32 Z-20 F2 J-3 K1", "T X20 Z-19\nT X14 Z-20", start=(20, 3), source="TA 14",
)
thread(
    "K of G32 alone runs nothing out on gsk-988ta",
    TA, "G32 Z-20 F2 K1", "T X20 Z-20", start=(20, 3), source="TA 14",
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
    "J and K of G32 stay for the thread after it, and end with another motion code",
    control=TDI, source="TDi 24.1 note 1", evidence="maker's manual", setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G32 Z-10 F2 J1 K1\nN30 Z-20\nN40 G0 Z0\nN50 G32 Z-5 F2\nN60 M30",
    moves="T X20 Z-9\nT X22 Z-10\nT X22 Z-19\nT X24 Z-20\nR Z0\nT X24 Z-5",
)
case(
    "a run-out longer than its thread alarms on gsk-988ta and gsk-988t",
    control=[TA, T], source="Talm 039; TA 14 note 4", evidence="secondary", setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G32 Z-2 F1 J1 K5\nN30 M30",
    runs="N10", alarm="thread-run-out", number="039", at="O1 N20", word="K5",
)
case(
    "a run-out longer than its thread alarms on gsk-980tdi",
    control=[TDI], source="Talm 039; TA 14 note 4", evidence="secondary", setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G32 Z-2 F1 J1 K5\nN30 M30",
    runs="N10", alarm="thread-run-out", number=None, at="O1 N20", word="K5",
)

# The lead
case(
    "a thread before any lead alarms on gsk-988ta and gsk-988t, whatever the feed is",
    pins="lead_apart", control=GSK_988, source="Talm 038; TDi 24.1", evidence="secondary",
    setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G98 G1 Z-1 F100\nN30 G32 Z-20\nN40 M30",
    runs="N10 N20", alarm="thread-lead", number="038", at="O1 N30", word="G32",
)
case(
    "a thread before any lead alarms on gsk-980tdi, whatever the feed is",
    pins="lead_apart", control=[TDI], source="Talm 038; TDi 24.1", evidence="secondary",
    setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G98 G1 Z-1 F100\nN30 G32 Z-20\nN40 M30",
    runs="N10 N20", alarm="thread-lead", number=None, at="O1 N30", word="G32",
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
case(
    "G34 R-1 alarms where its lead would come to nothing",
    control=GSK, source="TDi 24.4; ALM 313; Talm 038", evidence="secondary", setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G34 W-40. F2. R-1\nN30 M30",
    runs="N10", alarm="thread-lead", number={TA: "038", T: "038", TDI: None}, at="O1 N20", word="R-1",
)
case(
    "G34 K-1. alarms where its lead would come to nothing",
    control=OTHERS, source="TDi 24.4; ALM 313; Talm 038", evidence="secondary", setup=at(20, 0),
    program="O1\nN10 G97 S60 M3\nN20 G34 W-40. F2. K-1.\nN30 M30",
    runs="N10", alarm="thread-lead",
    number={**dict.fromkeys(MITSUBISHI, "P93"), F16: None, **dict.fromkeys(FANUC_PS, "PS0313")},
    at="O1 N20", word="K-1.",
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


multiple(
    "r of P in G76 runs the thread out by tenths of its lead with P1000 Q1000",
    [TDI, *FANUC], "G76 P010500 Q0 R0", "G76 X18. Z-20. P1000 Q1000 F2.", _PASS * 2,
)
multiple(
    "r of 00 in G76 runs nothing out with P1000 Q1000",
    [TDI, *FANUC], "G76 P010000 Q0 R0", "G76 X18. Z-20. P1000 Q1000 F2.", _PLAIN * 2,
)
multiple(
    "a first cut of G76 deeper than the thread is cut at once with P1000 Q1000",
    [TDI, *FANUC], "G76 P010000 Q0 R0", "G76 X18. Z-20. P1000 Q10005 F2.", _PLAIN * 2,
    source="TA 21 note 5",
)
multiple(
    "r of P in G76 runs the thread out by tenths of its lead with P1 Q1",
    GSK_988, "G76 P010500 Q0 R0", "G76 X18. Z-20. P1 Q1 F2.", _PASS * 2,
)
multiple(
    "r of 00 in G76 runs nothing out with P1 Q1",
    GSK_988, "G76 P010000 Q0 R0", "G76 X18. Z-20. P1 Q1 F2.", _PLAIN * 2,
)
multiple(
    "a first cut of G76 deeper than the thread is cut at once with P1 Q1",
    GSK_988, "G76 P010000 Q0 R0", "G76 X18. Z-20. P1 Q15 F2.", _PLAIN * 2, source="TA 21 note 5",
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
multiple(
    "G76 without its first block takes the parameters 5142 and after with P1 Q0.4 of a control with 2",
    GSK_988, "G4 P1000", "G76 X18. Z-20. P1 Q0.4 F2.",
    "W 1\nR X19.2000 Z4.7691\nT X19.2000 Z-20\nR X30\nR Z5\nR X18.6000 Z4.5959\nT X18.6000 Z-20\nR X30\nR Z5\nR X18.2686 Z4.5002\nT X18.2686 Z-20\nR X30\nR Z5\nR X18.2000 Z4.4804\nT X18.2000 Z-20\nR X30\nR Z5\nR X18.0000 Z4.4226\nT X18.0000 Z-20\nR X30\nR Z5\nR X18.0000 Z4.4226\nT X18.0000 Z-20\nR X30\nR Z5\n",
    params={"5142": 2, "5143": 60, "5140": 0.3, "5141": 0.1}, source="TDi 24.12; TA 21",
    evidence="maker's manual",
)
multiple(
    "G76 without its first block takes the parameters 5142 and after with P1000 Q400 of a control with 4",
    FANUC, "G4 P1000", "G76 X18. Z-20. P1000 Q400 F2.",
    "W 1\nR X19.2000 Z4.7691\nT X19.2000 Z-20\nR X30\nR Z5\nR X18.6000 Z4.5959\nT X18.6000 Z-20\nR X30\nR Z5\nR X18.2686 Z4.5002\nT X18.2686 Z-20\nR X30\nR Z5\nR X18.2000 Z4.4804\nT X18.2000 Z-20\nR X30\nR Z5\nR X18.0000 Z4.4226\nT X18.0000 Z-20\nR X30\nR Z5\nR X18.0000 Z4.4226\nT X18.0000 Z-20\nR X30\nR Z5\n",
    params={"5142": 2, "5143": 60, "5140": 0.3, "5141": 0.1}, source="TDi 24.12; TA 21",
    evidence="inferred",
)
multiple(
    "G76 without its first block takes the parameters 057 and after with P1000 Q400 of a control with 10",
    TDI, "G4 P1000", "G76 X18. Z-20. P1000 Q400 F2.",
    "W 1\nR X19.2000 Z4.7691\nT X19.2000 Z-20\nR X30\nR Z5\nR X18.6000 Z4.5959\nT X18.6000 Z-20\nR X30\nR Z5\nR X18.2686 Z4.5002\nT X18.2686 Z-20\nR X30\nR Z5\nR X18.2000 Z4.4804\nT X18.2000 Z-20\nR X30\nR Z5\nR X18.0000 Z4.4226\nT X18.0000 Z-20\nR X30\nR Z5\nR X18.0000 Z4.4226\nT X18.0000 Z-20\nR X30\nR Z5\n",
    params={"057": 2, "058": 60, "059": 0.3, "060": 0.1}, source="TDi 24.12; TA 21",
    evidence="maker's manual",
)
case(
    "G76 with the least cut above the height alarms on the 988",
    control=GSK_988, source="Talm 164", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P010060 Q2 R0\nN30 G76 X18 Z-20 P1 Q1 F2\nN40 M30",
    runs="N10 N20", alarm="thread-least-cut", number="164", at="O1 N30", word="P1",
)
case(
    "G76 with an allowance of the whole height alarms on the 988",
    control=GSK_988, source="Talm 165", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P010060 Q0 R1\nN30 G76 X18 Z-20 P1 Q1 F2\nN40 M30",
    runs="N10 N20", alarm="thread-allowance", number="165", at="O1 N30", word="P1",
)
case(
    "G76 with no depth of the first cut alarms on the 988",
    control=GSK_988, source="Talm 169", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P010060 Q0 R0\nN30 G76 X18 Z-20 P1 F2\nN40 M30",
    runs="N10 N20", alarm="thread-cut", number="169", at="O1 N30", word="G76",
)
case(
    "G76 with a height of nothing alarms on the 988",
    control=GSK_988, source="Talm 168", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P010060 Q0 R0\nN30 G76 X18 Z-20 P0 Q1 F2\nN40 M30",
    runs="N10 N20", alarm="thread-height-value", number="168", at="O1 N30", word="P0",
)
case(
    "G76 with no travel in X alarms on the 988",
    control=GSK_988, source="Talm 160", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P010060 Q0 R0\nN30 G76 Z-20 P1 Q1 F2\nN40 M30",
    runs="N10 N20", alarm="thread-travel", number="160", at="O1 N30", word="Z-20",
)
case(
    "G76 with no travel in Z alarms on the 988",
    control=GSK_988, source="Talm 160", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P010060 Q0 R0\nN30 G76 X18 P1 Q1 F2\nN40 M30",
    runs="N10 N20", alarm="thread-travel", number="160", at="O1 N30", word="X18",
)
case(
    "G76 with a taper against the cut alarms on the 988",
    control=GSK_988, source="Talm 166", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P010060 Q0 R0\nN30 G76 X18 Z-20 R9 P1 Q1 F2\nN40 M30",
    runs="N10 N20", alarm="thread-taper", number="166", at="O1 N30", word="R9",
)
case(
    "G76 with a taper over 45 degrees alarms on the 988",
    control=GSK_988, source="Talm 170", evidence="secondary", setup=at(30, 5),
    program="""
        O1
        N10 G97 S60 M3
        N20 G76 P010060 Q0 R0
        N30 G76 X18 Z-20 R-26 P1 Q1 F2
        N40 M30
    """,
    runs="N10 N20", alarm="thread-steep", number="170", at="O1 N30", word="R-26",
)
case(
    "G76 with no finishing passes alarms on the 988",
    pins="thread_digits_apart",
    control=GSK_988, source="Talm 161", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 P560 Q0 R0\nN30 M30",
    runs="N10", alarm="thread-passes", number="161", at="O1 N20", word="P560",
)
case(
    "G76 with the height of nothing alarms on a FANUC",
    control=FANUC, source="ALM 0317", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. P0 Q1000 F2.\nN30 M30",
    runs="N10", alarm="thread-height-value", number=FANUC_317, at="O1 N20", word="P0",
)
case(
    "G76 with no depth of the first cut alarms on a FANUC",
    control=FANUC, source="ALM 0317", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. P1000 F2.\nN30 M30",
    runs="N10", alarm="thread-cut", number=FANUC_317, at="O1 N20", word="G76",
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
    "a thread of two starts is cut twice, also in the blocks after", control=GSK_STARTS, **STARTS,
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
case(
    "a thread of L0 starts alarms",
    control=GSK_STARTS, **STARTS, setup={"start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G92 X20 Z-20 F2 L0\nN30 M30",
    alarm="value-out-of-range",
    number={"gsk-988ta": "003", "gsk-988t": "003", "gsk-980tdi": "0012"}, at="O1 N10", word="L0",
)
case(
    "a thread of L1000 starts alarms",
    control=GSK_STARTS, **STARTS, setup={"start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G92 X20 Z-20 F2 L1000\nN30 M30",
    alarm="value-out-of-range",
    number={"gsk-988ta": "003", "gsk-988t": "003", "gsk-980tdi": "0012"}, at="O1 N10", word="L1000",
)
case(
    "G76 with L2: where its passes lie is not computed",
    control=GSK_STARTS[:2], pins="thread_words_not_computed", source="TA 21",
    evidence="maker's manual", setup={"start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G76 P020060 Q0.1 R0.1 L2\nN20 M30",
    alarm="code-not-computed", at="O1 N10", word="G76",
)
case(
    "G76 with D1: where its passes lie is not computed",
    control=GSK_STARTS[:2], pins="thread_words_not_computed", source="TA 21",
    evidence="maker's manual", setup={"start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G76 P020060 Q0.1 R0.1 D1\nN20 M30",
    alarm="code-not-computed", at="O1 N10", word="G76",
)
case(
    "G76 with E1: where its passes lie is not computed",
    control=GSK_STARTS[:2], pins="thread_words_not_computed", source="TA 21",
    evidence="maker's manual", setup={"start": {"X": 30, "Z": 5}},
    program="O1\nN5 S500 M3\nN10 G76 P020060 Q0.1 R0.1 E1\nN20 M30",
    alarm="code-not-computed", at="O1 N10", word="G76",
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
