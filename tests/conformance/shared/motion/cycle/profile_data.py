"""The lathe's cycles G70 to G75 and its drilling: data, one-block form, alarms."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI = "gsk-980tdi"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
KNOWN = {"source": "general knowledge", "evidence": "inferred"}


def at(x, z):
    return {"machine": "lathe-a", "start": {"X": x, "Z": z}}


def on_fanuc(number):
    old, later = (number.split("/") * 2)[:2]  # that of the 16i and that of the later series
    return {F16: old, **dict.fromkeys(FANUC_PS, f"PS0{later}")}


def alarms(claim, control, blocks, cause, number, where, source, **more):
    case(
        claim, control=control, source=source,
        evidence="maker's manual" if source.startswith("T") and "alm" not in source else "secondary",
        setup=more.pop("setup", at(50, 2)), program="O1\n" + blocks + "\nN90 M30",
        alarm=cause, number=number, at=f"O1 {where}", **more,
    )


# G74 and G75
case(
    "G74 of the 980TDi: P and R are diameters, the last column and the last peck take the rest",
    pins="cycle_unit groove_p_diameter",
    control=TDI, source="TDi 23.5", evidence="maker's manual", setup=at(36, 5),
    program="O1\nN10 G74 R0.5\nN20 G74 X32 Z-2 P3000 Q5000 R1 F50\nN30 M30",
    moves="""
        F Z0
        R Z0.5
        F Z-2
        R X37
        R Z5
        R X33
        F Z0
        R Z0.5
        F Z-2
        R X34
        R Z5
        R X32
        F Z0
        R Z0.5
        F Z-2
        R X33
        R Z5
        R X36
    """,
)
case(
    "G74 of the 988: P and R are radii",
    pins="cycle_unit cycle_point groove_p_diameter",
    control=GSK_988, source="TA 12", evidence="maker's manual", setup=at(36, 5),
    program="O1\nN10 G74 R0.5\nN20 G74 X33 Z-2 P1.5 Q7 R0.5 F50\nN30 M30",
    moves="F Z-2\nR X37\nR Z5\nR X33\nF Z-2\nR X34\nR Z5\nR X36",
)
case(
    "Q with a point is no count of increments, whatever its digits", control=FANUC,
    source="FANUC lathe manuals: Q of G74 in the least increment", evidence="inferred", setup=at(36, 5),
    program="O1\nN10 G74 R0.5\nN20 G74 Z-2. Q4. F50.\nN30 M30",
    moves="F Z1\nR Z1.5\nF Z-2\nR Z5",
)
case(
    "G74 without the axis it pecks along is not done",
    control=[TDI, TA, T, *FANUC], source="TDi 23.5, 23.6; TA 12, 13",
    evidence="maker's manual", setup=at(36, 5),
    program="O1\nN10 G74 X30 P3000 Q5000 F50\nN20 M30",
    runs="N10 N20", moves="none",
)
case(
    "G75 without the axis it pecks along is not done",
    pins="refuses", control=[TDI, TA, *FANUC], source="TDi 23.5, 23.6; TA 12, 13",
    evidence="maker's manual", setup=at(36, 5),
    program="O1\nN10 G75 Z-20 P3000 Q5000 F50\nN20 M30",
    runs="N10 N20", moves="none",
)
case(
    "the retract of G74 with Q6000 comes from parameter 056 on gsk-980tdi",
    control=[TDI], source="TDi 23.5; TA 12; general knowledge", evidence="inferred",
    setup=at(36, 5), params={"056": 1},
    program="O1\nN10 G74 Z-7. Q6000 F50.\nN20 M30",
    moves="F Z-1\nR Z0\nF Z-7\nR Z5",
)
case(
    "the retract of G74 with Q6 comes from parameter 5139 on gsk-988ta",
    control=GSK_988, source="TDi 23.5; TA 12; general knowledge", evidence="inferred",
    setup=at(36, 5), params={"5139": 1},
    program="O1\nN10 G74 Z-7. Q6 F50.\nN20 M30",
    moves="F Z-1\nR Z0\nF Z-7\nR Z5",
)
case(
    "the retract of G74 with Q6000 comes from parameter 5139 on fanuc-16i",
    control=FANUC, source="TDi 23.5; TA 12; general knowledge", evidence="inferred",
    setup=at(36, 5), params={"5139": 1},
    program="O1\nN10 G74 Z-7. Q6000 F50.\nN20 M30",
    moves="F Z-1\nR Z0\nF Z-7\nR Z5",
)
alarms(
    "G74 with Q0 alarms on the 988",
    GSK_988, "N10 G74 X40 Z-5 P1 Q0 F50", "groove-q", "153", "N10", "Talm 153", word="Q0",
)
alarms(
    "G74 with a negative Q alarms on the 988",
    GSK_988, "N10 G74 X40 Z-5 P1 Q-1 F50", "groove-q", "153", "N10", "Talm 153", word="Q-1",
)
alarms(
    "G75 with P0 alarms on the 988",
    GSK_988, "N10 G75 X40 Z-5 P0 Q1 F50", "groove-p", "155", "N10", "Talm 155", word="P0",
)
alarms(
    "G74 with P0 alarms on the 988",
    GSK_988, "N10 G74 X40 Z-5 P0 Q1 F50", "groove-step", "158", "N10", "Talm 158", word="P0",
)
alarms(
    "G75 with Q0 alarms on the 988",
    GSK_988, "N10 G75 X40 Z-5 P1 Q0 F50", "groove-step", "158", "N10", "Talm 158", word="Q0",
)
alarms(
    "G74 with a retract below zero alarms on the 988",
    GSK_988, "N10 G74 R-1", "groove-retract", "156", "N10", "Talm 156", word="R-1",
)
alarms(
    "G74 with an escape below zero alarms on the 988T", T, "N10 G74 X40 Z-5 P1 Q1 R-1 F50",
    "groove-escape", "157", "N10", "Talm 157", word="R-1",
)
case(
    "the sign of an escape does not count on the 988TA while X moves",
    control=TA, source="TA 12", evidence="maker's manual", setup=at(50, 2),
    program="O1\nN10 G74 X40 Z-5 P5 Q9 R-1 F50\nN20 M30",
    moves="F Z-5\nR X52\nR Z2\nR X40\nF Z-5\nR X42\nR Z2\nR X50",
)
alarms(
    "G74 with a negative Q alarms on a FANUC", FANUC, "N10 G74 X40. Z-5. P1000 Q-1000 F50.",
    "groove-q", on_fanuc("062/320"), "N10", "ALM 0320", word="Q-1000",
)
alarms(
    "G74 with an escape below zero alarms on a FANUC", FANUC,
    "N10 G74 X40. Z-5. P1000 Q1000 R-1. F50.", "groove-escape", on_fanuc("062/318"), "N10", "ALM 0318", word="R-1.",
)

# Profiles
_BODY = "\nN20 G0 X20\nN30 G1 Z-20\nN40 X50"

alarms(
    "a cycle with an escape below zero alarms on the 988",
    GSK_988, "N10 G71 U2 R-1", "cycle-escape", "149", "N10", "Talm 149", word="R-1",
)
alarms(
    "a cycle with no passes of G73 alarms on the 988",
    GSK_988, "N10 G73 U2 W1 R0", "pattern-passes", "151", "N10", "Talm 151", word="R0",
)
alarms(
    "a cycle with P and Q alike alarms on the 988",
    GSK_988, "N10 G71 P20 Q20 U0 W0 F1" + _BODY, "pq-same", "135", "N10", "Talm 135", word="Q20",
)
alarms(
    "a cycle with no X in the first block of G71 alarms on the 988",
    GSK_988, "N10 G71 P20 Q40 U0 W0 F1\nN20 G0 Z0\nN30 G1 X20\nN40 Z-10", "profile-first-x", "146",
    "N20", "Talm 146", word="G0",
)
alarms(
    "a cycle with no Z in the first block of G72 alarms on the 988",
    GSK_988, "N10 G72 P20 Q40 U0 W0 F1\nN20 G0 X20\nN30 G1 Z-10\nN40 X50", "profile-first-z", "147",
    "N20", "Talm 147", word="G0",
)
alarms(
    "a cycle with a first block of G73 that moves nothing alarms on the 988",
    GSK_988, "N10 G73 P20 Q40 U0 W0 F1\nN20 G0\nN30 G1 Z-10\nN40 X50", "pattern-first-block", "145",
    "N20", "Talm 145", word="G0",
)
alarms(
    "a cycle with a start inside the profile alarms on the 988",
    GSK_988, "N10 G71 P20 Q40 U0 W0 F1\nN20 G0 X20\nN30 G1 Z-20\nN40 X60", "profile-start", "139",
    "N10", "Talm 139", word="G71",
)
alarms(
    "a cycle with an escape in X against the allowance of G73 alarms on the 988",
    GSK_988, "N5 G73 U2 W1 R2\nN10 G73 P20 Q40 U-1 W1 F1" + _BODY, "pattern-x", "141", "N10",
    "Talm 141", word="U-1",
)
alarms(
    "a cycle with an escape in Z against the allowance of G73 alarms on the 988",
    GSK_988, "N5 G73 U2 W1 R2\nN10 G73 P20 Q40 U1 W-1 F1" + _BODY, "pattern-z", "142", "N10",
    "Talm 142", word="W-1",
)
alarms(
    "a cycle with another plane than G18 alarms on the 988",
    GSK_988, "N5 G17\nN10 G71 P20 Q40 U0 W0 F1" + _BODY, "cycle-plane", "126", "N10", "Talm 126", word="G71",
)
alarms(
    "a cycle with a Y in its line alarms on the 988",
    GSK_988, "N10 G74 X40 Z-5 Y1 P1 Q1 F50", "cycle-axis", "127", "N10", "Talm 127", word="Y1",
)
alarms(
    "a cycle with G90 outside G18 alarms on the 988",
    GSK_988, "N5 G17\nN10 G90 X40 Z-5 F50", "turning-plane", "121", "N10", "Talm 121", word="G90",
)
alarms(
    "a cycle with a Y in G90 alarms on the 988",
    GSK_988, "N10 G90 X40 Z-5 Y1 F50", "turning-axis", "122", "N10", "Talm 122", word="Y1",
)
alarms(
    "G71 outside G18 alarms on the 980TDi",
    TDI, "N5 G17\nN10 G71 P20 Q40 U0 W0 F1\nN20 G0 X20\nN30 G1 Z-20\nN40 X50", "cycle-plane", None,
    "N10", "TDi 8 note 3", word="G71",
)
alarms(
    "G90 outside G18 alarms on the 980TDi",
    TDI, "N5 G17\nN10 G90 X40 Z-5 F50", "turning-plane", None, "N10", "TDi 8 note 3", word="G90",
)
# Loops write these programs, because each has a hundred blocks and more.
for _controls, _number, _most in (
    (GSK_988, "137", 100), (MITSUBISHI, "P202", 100), ([TDI], None, 200),
):
    for _more, _ends in ((0, None), (1, "profile-too-long")):
        _lines = "\n".join(f"N{i} G1 Z{-i}" for i in range(21, 20 + _most + _more - 1))
        _program = (
            f"O1\nN10 G71 P20 Q999 U0 W0 F1.\nN20 G0 X20.\n{_lines}\nN999 X50.\nN1000 M30"
        )
        case(
            f"a profile of {_most + _more} blocks "
            f"{'alarms' if _ends else 'is cut'} on {_controls[0]}",
            pins="max_profile_blocks",
            control=_controls, source="Talm 137; MZ 898, paired with P202; TDi 23.1 note 9",
            evidence="secondary", setup=at(50, 2), program=_program, alarm=_ends,
            runs="" if _ends else "N10 N1000",
            number=_number if _ends else None, word="Q999" if _ends else None,
        )
case(
    "G71 alarms in MDI on gsk-988ta",
    control=GSK_988, source="Talm 129; TA 8 note 4; ALM 067", evidence="secondary", setup=at(50, 2),
    mdi="G71 P20 Q40 U0 W0 F1.\nN20 G0 X20.\nN30 G1 Z-20.\nN40 X50.\nM30", alarm="profile-in-mdi",
    number="129", word="G71",
)
case(
    "G71 alarms in MDI on fanuc-16i",
    control=FANUC, source="Talm 129; TA 8 note 4; ALM 067", evidence="secondary", setup=at(50, 2),
    mdi="G71 P20 Q40 U0 W0 F1.\nN20 G0 X20.\nN30 G1 Z-20.\nN40 X50.\nM30", alarm="profile-in-mdi",
    number=on_fanuc("067"), word="G71",
)
case(
    "a profile that turns back is cut where nothing checks it",
    pins="profile_monotone",
    control=[TDI, *GSK_988], source="TDi 23.1: K; TA 8: 5102#1", evidence="maker's manual",
    setup=at(50, 2),
    program="O1\nN10 G71 U15 R1\nN15 G71 P20 Q50 U0 W0 F1\nN20 G0 X20\nN30 G1 Z-20\n"
            "N40 X30 Z-15\nN50 X50 Z-40\nN60 M30",
    moves="R X50 Z2\nR X20\nF Z-20\nF X30 Z-15\nF X50 Z-40\nR X50 Z2",
)
case(
    "a cycle with no X in the first block of G71 alarms on a FANUC",
    control=FANUC, source="ALM 065", evidence="secondary", setup=at(50, 2),
    program="O1\nN10 G71 P20 Q40 U0 W0 F1.\nN20 G0 Z0\nN30 G1 X20.\nN40 Z-10.\nN90 M30",
    alarm="profile-first-x", number=on_fanuc("065"), word="G0",
)
case(
    "a cycle with no passes alarms on a FANUC",
    control=FANUC, source="ALM 062/321", evidence="secondary", setup=at(50, 2),
    program="O1\nN10 G73 U2. W1. R0\nN90 M30",
    alarm="pattern-passes", number=on_fanuc("062/321"), word="R0",
)
# Loops write these programs, because each has twenty blocks and more.
for _control, _most, _number in ((TA, 30, "140"), (T, 10, "140"), (TDI, 20, None)):
    for _pockets in (_most, _most + 1):
        _walls = "\n".join(
            f"N{21 + 2 * i} G1 X30 Z{-2 * i - 1}\nN{22 + 2 * i} X20 Z{-2 * i - 2}"
            for i in range(_pockets)
        )
        case(
            f"{_pockets} pockets are {'cut' if _pockets == _most else 'too many'} on {_control}",
            pins="max_pockets",
            control=_control, source="Talm 140; TA 8; TDi 23.1", evidence="secondary",
            setup=at(50, 2),
            program=f"O1\nN10 G71 P20 Q999 U0 W0 F1\nN20 G0 X20 Z0\n{_walls}\nN999 X50\nN1000 M30",
            alarm=None if _pockets == _most else "profile-pockets",
            runs="N10 N1000" if _pockets == _most else "",
            number=None if _pockets == _most else _number,
            word=None if _pockets == _most else "G71",
        )

# The one-block form of the series 10 and 11
_OLD = {"params": {"0001#1": 1}, "control": FANUC, **KNOWN}
_CUT = "\nN20 G0 X20.\nN30 G1 Z-20.\nN40 X50.\nN50 M30"

case(
    "G71 in one block: D is the depth of cut in least increments", **_OLD, setup=at(50, 2),
    program="O1\nN5 G71 U9. R1.\nN10 G71 P20 Q40 U0 W0 D10000 F1." + _CUT,
    moves="R X50 Z2\nR X30\nF Z-20\nR X32 Z-19\nR Z2\nR X20\nF Z-20\nF X50\nR Z2",
)
case(
    "G73 in one block: I and K are the escape, D the passes", **_OLD, setup=at(50, 2),
    program="O1\nN10 G73 P20 Q40 U0 W0 I4. K2. D2 F1." + _CUT,
    moves="""
        R X58 Z4
        R X28
        F Z-18
        F X58
        R X50 Z2
        R X20
        F Z-20
        F X50
        R Z2
    """,
)
case(
    "G74 in one block: I steps along X, K pecks along Z, D escapes", **_OLD, setup=at(36, 5),
    program="O1\nN5 G74 R0.5\nN10 G74 X34. Z-2. I1. K5. D500 F50.\nN20 M30",
    moves="""
        F Z0
        R Z0.5
        F Z-2
        R X37
        R Z5
        R X34
        F Z0
        R Z0.5
        F Z-2
        R X35
        R Z5
        R X36
    """,
)
case(
    "G75 in one block: I pecks along X", **_OLD, setup=at(20, 0),
    program="O1\nN5 G75 R1.\nN10 G75 X10. I3. F10.\nN20 M30",
    moves="F X14\nR X16\nF X10\nR X20",
)
case(
    "G76 in one block: K is the height, D the first cut, I the taper, A the angle", **_OLD,
    setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. I-1. K1. D1000 F2. A60\nN30 M30",
    moves="R X16 Z4.4226\nT X18 Z-20\nR X30\nR Z5\n" * 2,
)
case(
    "G76 with K and no P has no height of the thread while 0001#1 is 0",
    pins="one_block_cycles",
    control=FANUC, source="ALM 062", evidence="secondary", setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. K1. D1000 F2. A60\nN30 M30",
    runs="N10", alarm="thread-height", number=on_fanuc("062/317"), at="O1 N20", word="G76",
)

# Drilling
_DEEP = at(50, 0)

case(
    "G83 of the 980TDi: R is the retract of a peck", control=TDI, source="TDi 23.9",
    pins="drill_full_retract drill_retract",
    evidence="maker's manual", setup=_DEEP,
    program="O1\nN10 G98 G83 X50 Z-12 Q5000 R2 F100\nN20 M30",
    moves="R X50\nF Z-5\nR Z-3\nF Z-10\nR Z-8\nF Z-12\nR Z0",
)
case(
    "J1 of G83 of the 980TDi draws back to the start of the hole",
    pins="cycle_words_not_computed", control=TDI, source="TDi 23.9",
    evidence="maker's manual", setup=_DEEP,
    program="O1\nN10 G98 G83 X50 Z-12 Q5000 R2 J1 F100\nN20 M30",
    moves="R X50\nF Z-5\nR Z0\nR Z-3\nF Z-10\nR Z0\nR Z-8\nF Z-12\nR Z0",
)
case(
    "G83 Q0 R2 of the 980TDi drills in one go",
    control=TDI, source="TDi 23.9 notes 6, 7", evidence="maker's manual", setup=_DEEP,
    program="O1\nN10 G98 G83 X50 Z-12 Q0 R2 F100\nN20 M30",
    moves="R X50\nF Z-12\nR Z0",
)
case(
    "G83 Q5000 R0 of the 980TDi drills in one go",
    control=TDI, source="TDi 23.9 notes 6, 7", evidence="maker's manual", setup=_DEEP,
    program="O1\nN10 G98 G83 X50 Z-12 Q5000 R0 F100\nN20 M30",
    moves="R X50\nF Z-12\nR Z0",
)
case(
    "5101#2 = 0 says how far G83 of the 988 draws back, D the clearance",
    control=GSK_988, source="TA 24", evidence="maker's manual", setup=_DEEP, params={"5101#2": 0},
    program="O1\nN10 G98 G83 X50 Z-12 R-2 Q5 D1 F100\nN20 M30",
    moves="R X50\nR Z-2\nF Z-7\nR Z-6\nF Z-12\nR Z0",
)
case(
    "5101#2 = 1 says how far G83 of the 988 draws back, D the clearance",
    control=GSK_988, source="TA 24", evidence="maker's manual", setup=_DEEP, params={"5101#2": 1},
    program="O1\nN10 G98 G83 X50 Z-12 R-2 Q5 D1 F100\nN20 M30",
    moves="R X50\nR Z-2\nF Z-7\nR Z-2\nR Z-6\nF Z-12\nR Z0",
)
case(
    "G85 of the 988 draws back at twice the feed, or as 5149 = 0 says",
    control=GSK_988, source="TA 26", evidence="maker's manual",
    setup=_DEEP | {"rapid": {"X": 900000, "Z": 900000}}, params={"5149": 0},
    program="O1\nN10 G98 G85 Z-10 F100\nN20 M30",
    moves="F Z-10\nF Z0", time=9,
)
case(
    "G85 of the 988 draws back at twice the feed, or as 5149 = 300 says",
    control=GSK_988, source="TA 26", evidence="maker's manual",
    setup=_DEEP | {"rapid": {"X": 900000, "Z": 900000}}, params={"5149": 300},
    program="O1\nN10 G98 G85 Z-10 F100\nN20 M30",
    moves="F Z-10\nF Z0", time=8,
)
case(
    "P of G76 takes a point on the 988", control=GSK_988, source="TA 21, O0013",
    evidence="maker's manual", setup=at(80, 10),
    program="O1\nN10 G97 S300 M3\nN20 G76 P010000 Q0.150 R0\nN30 G76 X60.64 Z-62 P3.680 Q3.68 F6\nN40 M30",
    moves="R X60.64 Z10\nT Z-62\nR X80\nR Z10\n" * 2,
)
case(
    "P of G74 takes no point on a FANUC", control=FANUC, source="general knowledge",
    pins="cycle_point",
    evidence="inferred", setup=at(36, 5),
    program="O1\nN10 G74 X33. Z-2. P1.5 Q7000 F50.\nN20 M30",
    runs="", alarm="illegal-decimal-point", number=on_fanuc("007"), at="O1 N10", word="P1.5",
)

SLOW = at(36, 5) | {"rapid": {"X": 1, "Z": 1}}

# A loop writes this row, because the thread takes 401 cuts.
for _controls, _thread, _groove in (
    (GSK_988, "P0.04 Q0.002", "Q6"), ([TDI, *MITSUBISHI, *FANUC], "P40 Q2", "Q6000"),
):
    case(
        f"G76 alone has one finishing pass, no angle, no least cut, no allowance: {_thread}",
        pins="cycle_unit thread_chamfer thread_passes thread_least_cut thread_allowance",
        control=_controls, **KNOWN, setup=at(30, 5),
        program=f"O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. {_thread} F2.\nN30 M30",
        moves="".join(
            f"R X{18 + 2 * (0.04 - 0.002 * n**0.5):.5f} Z5\n"
            f"T X{18 + 2 * (0.04 - 0.002 * n**0.5):.5f} Z-20\nR X30\nR Z5\n"
            for n in (*range(1, 401), 400)
        ),
    )
    case(
        f"G74 {_groove} alone retracts by nothing", control=_controls, **KNOWN, setup=SLOW,
        pins="groove_retract",
        program=f"O1\nN10 G98 G74 Z-7. {_groove} F60.\nN20 M30",
        moves="F Z-1\nR Z-1\nF Z-7\nR Z5", time=732,
    )
case(
    "a boring cycle takes 9 s of feed",
    control=GSK_988, pins="g_codes bore_return", source="TA 26; general knowledge",
    evidence="inferred", setup=at(50, 0) | {"rapid": {"X": 900000, "Z": 900000}},
    program="O1\nN10 G98 G85 Z-10. F100.\nN20 M30",
    moves="F Z-10\nF Z0", time=9,
)
case(
    "a boring cycle takes 12 s of feed",
    control=[*MITSUBISHI, *FANUC], pins="g_codes bore_return", source="TA 26; general knowledge",
    evidence="inferred", setup=at(50, 0) | {"rapid": {"X": 900000, "Z": 900000}},
    program="O1\nN10 G98 G85 Z-10. F100.\nN20 M30",
    moves="F Z-10\nF Z0", time=12,
)
case(
    "two pockets are cut", control=[*MITSUBISHI, *FANUC], **KNOWN, setup=at(50, 2),
    pins="max_profile_blocks max_pockets",
    program="O1\nN10 G71 U15. R1.\nN15 G71 P20 Q70 U0 W0 F1.\nN20 G0 X20. Z0\nN30 G1 X30. Z-1.\n"
            "N40 X20. Z-2.\nN50 X30. Z-3.\nN60 X20. Z-4.\nN70 X50.\nN80 M30",
    runs="N10 N15 N80",
)
case(
    "P of two digits in G76 names no passes and no run-out: there is one pass, and none",
    pins="refuses thread_digits_apart",
    control=[*MITSUBISHI, *FANUC], **KNOWN, setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN15 G76 P020500 Q0 R0\nN20 G76 P00\n"
            "N30 G76 X18. Z-20. P1000 Q1000 F2.\nN40 M30",
    moves="R X18 Z5\nT X18 Z-20\nR X30\nR Z5\n" * 2,
)
case(
    "G76 in one block is no thread of other controls", control=[TDI, *MITSUBISHI], **KNOWN,
    pins="one_block_cycles",
    setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. K1. D1000 F2. A60\nN30 M30",
    runs="N10", alarm="thread-height", number=None, at="O1 N20", word="G76",
)
case(
    "P of G74 takes no point on other controls", control=[TDI, *MITSUBISHI], **KNOWN,
    pins="cycle_point",
    setup=at(36, 5), program="O1\nN10 G74 X33. Z-2. P1.5 Q7000 F50.\nN20 M30",
    runs="", alarm="illegal-decimal-point",
    number={TDI: "0012", **dict.fromkeys(MITSUBISHI, "P33")}, at="O1 N10", word="P1.5",
)
case(
    "G76 alone goes straight in: P1 Q1",
    pins="thread_angle", control=GSK_988, **KNOWN, setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. P1 Q1 F2.\nN30 M30",
    moves="R X18 Z5\nT X18 Z-20\nR X30\nR Z5\nR X18 Z5\nT X18 Z-20\nR X30\nR Z5",
)
case(
    "G76 alone goes straight in: P1000 Q1000",
    pins="thread_angle", control=[TDI, *MITSUBISHI, *FANUC], **KNOWN, setup=at(30, 5),
    program="O1\nN10 G97 S60 M3\nN20 G76 X18. Z-20. P1000 Q1000 F2.\nN30 M30",
    moves="R X18 Z5\nT X18 Z-20\nR X30\nR Z5\nR X18 Z5\nT X18 Z-20\nR X30\nR Z5",
)
