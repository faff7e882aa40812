"""A fault names the block, the file and the whole word that is wrong, wherever the run is."""

from conformance import case

F16, F30 = MILLS = ["fanuc-16i", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
RULE = {"source": "policy: a fault carries its block", "evidence": "inferred"}
M7 = "mitsubishi-m700"
CORNER = {F16: "055", F30: "PS0055"}
TOO_SMALL = {F16: "041", F30: "PS0041"}
DIVISION = {"fanuc-16i": "112", "fanuc-30i": "PS0112", "mitsubishi-m700": "P283"}


def lathe(**more):
    return {"machine": "lathe-a", "start": {"X": 50, "Z": 2}, **more}


for _sub, _file in (("O2\n", "b.nc"), ("", "")):
    _files = {"a.nc": "O1\nN10 G90 G0 X0 Y0\nN20 M98 P2\nN30 Y50.\nN40 M30\n"}
    if _file:
        _files[_file] = "O2\nN50 G1 X3. ,C5. F100.\nN60 M99\n"
    else:
        _files["a.nc"] = "O1\nN10 G90 G0 X0 Y0\nN50 G1 X3. ,C5. F100.\nN30 Y50.\nN40 M30\n"
    case(
        "a corner that is too long belongs to its own block, "
        f"{'also where a program in another file finds it' if _file else 'and not to the block that finds it'}",
        control=MILLS, **RULE, files=_files, alarm="corner-too-short", number=CORNER,
        at="O2 N50" if _file else "O1 N50", word=",C5.",
    )
case(
    "an inner arc smaller than the tool belongs to its own block, also where another file finds it",
    control=MILLS, **RULE, setup={"radius_offsets": {1: 6}},
    files={
        "a.nc": "O1\nN10 G90 G0 X0 Y0\nN20 G41 G91 G1 X30. Y-5. D1 F50.\nN30 M98 P2\nN40 G0 Y-5.\n"
                "N50 G40 X-30. Y5.\nN60 M30\n",
        "b.nc": "O2\nN70 Y5.\nN80 G2 X20. I10.\nN85 X-10. I-5.\nN90 G3 X-10. I-5.\nN95 M99\n",
    },
    alarm="offset-arc-too-small", number=TOO_SMALL, at="O2 N90", word="I-5.",
)
case(
    "the same contour with a tool that fits is cut",
    control=MILLS, **RULE, setup={"radius_offsets": {1: 4}},
    files={
        "a.nc": "O1\nN10 G90 G0 X0 Y0\nN20 G41 G91 G1 X30. Y-5. D1 F50.\nN30 M98 P2\nN40 G0 Y-5.\n"
                "N50 G40 X-30. Y5.\nN60 M30\n",
        "b.nc": "O2\nN70 Y5.\nN80 G2 X20. I10.\nN85 X-10. I-5.\nN90 G3 X-10. I-5.\nN95 M99\n",
    },
    runs="N10 N20 N30 N70 N80 N85 N90 N95 N40 N50 N60",
)

_G71 = "O1\nN10 G71 U5. R1.\nN20 G71 P30 Q50 U0 W0 F100.\nN30 G0 X20.\nN40 {0}\nN50 X50. Z-40.\nN60 M30\n"

case(
    "a fault of G28 X30. in a profile names its own block and word",
    control=GSK_988, **RULE, setup=lathe(),
    program=_G71.format("G28 X30."),
    runs="N10", alarm="profile-code", number="128", at="O1 N40", word="G28",
)
case(
    "a fault of M98 P2 in a profile names its own block and word",
    control=GSK_988, **RULE, setup=lathe(),
    program=_G71.format("M98 P2"),
    runs="N10", alarm="call-in-profile", number="131", at="O1 N40", word="M98",
)
case(
    "a fault of G2 X30. Z-20. R1. in a profile names its own block and word",
    control=GSK_988, **RULE, setup=lathe(),
    program=_G71.format("G2 X30. Z-20. R1."),
    runs="N10", alarm="radius-too-small", number="035", at="O1 N40", word="R1.",
)
case(
    "a value that cannot be computed in a profile names its own block",
    control=[F16, F30, M7], **RULE, setup=lathe(), program=_G71.format("G1 Z[-9/#100]"), runs="N10",
    alarm="division-by-zero", number=DIVISION, at="O1 N40", word="/",
)
case(
    "a value that can be computed in a profile is cut",
    control=[F16, F30, M7], **RULE, setup=lathe(), program=_G71.format("G1 Z[-9/#100]"), runs="N10 N20 N60",
    variables={100: 1},
)
case(
    "a block whose codes are computed keeps them while the blocks of its profile compute theirs",
    control=[F16, F30], source="policy: a block does what its words say", evidence="inferred",
    setup=lathe(),
    program="O1\nN10 G#1 U5. R1.\nN20 G#1 P30 Q50 U0 W0 F100.\nN30 G#2 X20.\nN40 G#3 Z-9.\nN50 X50.\nN60 M30\n",
    variables={1: 71, 2: 0, 3: 1}, runs="N10 N20 N60", final_work="X50 Z2",
)
case(
    "a move beyond the travel names the word of that axis, with increments too",
    control=[F30, "gsk-988t"], **RULE, setup=lathe(limits={"X": (-60, 60), "Z": (-60, 60)}),
    program="O1\nN10 G0 X40. Z0\nN20 U5. W-70.\nN30 M30", runs="N10", alarm="over-travel",
    number={F30: "OT0501", "gsk-988t": None},
    at="O1 N20", word="W-70.",
)
case(
    "a G31 without a feed is named where G98 stands before it",
    control=[M7], source="M7 p.550", evidence="maker's manual",
    program="O1\nN10 G0 X0\nN20 G98 G31 X10.\nN30 M30",
    runs="N10", alarm="no-skip-feed", number="P603", at="O1 N20", word="G31",
)
case(
    "a G31 without a feed is named where G17 G40 G80 stands before it",
    control=[M7], source="M7 p.550", evidence="maker's manual",
    program="O1\nN10 G0 X0\nN20 G17 G40 G80 G31 X10.\nN30 M30",
    runs="N10", alarm="no-skip-feed", number="P603", at="O1 N20", word="G31",
)
case(
    "a G31 without a feed is named where M8 G94 stands before it",
    control=[M7], source="M7 p.550", evidence="maker's manual",
    program="O1\nN10 G0 X0\nN20 M8 G94 G31 X10.\nN30 M30",
    runs="N10", alarm="no-skip-feed", number="P603", at="O1 N20", word="G31",
)
case(
    "a G31 with the feed in its block runs after other G codes", control=[M7],
    source="M7 p.550", evidence="maker's manual",
    program="O1\nN10 G0 X0\nN20 G98 G31 X10. F100\nN30 M30", runs="N10 N20 N30",
)

# A statement's fault names a whole word: a variable, a function, a keyword with its number.
case(
    "the fault of #2=#[9000000] is its #[9000000]",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 #2=#[9000000]\nN30 M30",
    runs="N10", alarm="illegal-variable", at="O1 N20",
    number=dict(zip(MILLS, ("115", "PS0115"), strict=True)), word="#[9000000]",
)
case(
    "the fault of #2=5+#[#1+[3*9000000]] is its #[#1+[3*9000000]]",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 #2=5+#[#1+[3*9000000]]\nN30 M30",
    runs="N10", alarm="illegal-variable", at="O1 N20",
    number=dict(zip(MILLS, ("115", "PS0115"), strict=True)), word="#[#1+[3*9000000]]",
)
case(
    "the fault of IF[#9000000EQ1]GOTO30 is its #9000000",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[#9000000EQ1]GOTO30\nN30 M30",
    runs="N10", alarm="illegal-variable", at="O1 N20",
    number=dict(zip(MILLS, ("115", "PS0115"), strict=True)), word="#9000000",
)
case(
    "the fault of #2=ABCD[2] is its ABCD",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 #2=ABCD[2]\nN30 M30",
    runs="N10", alarm="expression-format", at="O1 N20",
    number=dict(zip(MILLS, ("125", "PS1125"), strict=True)), word="ABCD",
)
case(
    "the fault of #2=1+ABCD is its ABCD",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 #2=1+ABCD\nN30 M30",
    runs="N10", alarm="expression-format", at="O1 N20",
    number=dict(zip(MILLS, ("125", "PS1125"), strict=True)), word="ABCD",
)
case(
    "the fault of IF[1EQ1]THEN G1 is its G1",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[1EQ1]THEN G1\nN30 M30",
    runs="N10", alarm="if-format", at="O1 N20",
    number=dict(zip(MILLS, ("114", "PS1137"), strict=True)), word="G1",
)
case(
    "the fault of IF[1EQ1]M30 is its M30",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[1EQ1]M30\nN30 M30",
    runs="N10", alarm="if-format", at="O1 N20",
    number=dict(zip(MILLS, ("114", "PS1137"), strict=True)), word="M30",
)
case(
    "the fault of M8 #2=SQRT[4] is its #2",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 M8 #2=SQRT[4]\nN30 M30",
    runs="N10", alarm="nc-and-macro-in-block", at="O1 N20",
    number=dict(zip(MILLS, ("127", "PS0127"), strict=True)), word="#2",
)
case(
    "the fault of #2=1 DPRNT[A] is its DPRNT",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 #2=1 DPRNT[A]\nN30 M30",
    runs="N10", alarm="nc-and-macro-in-block", at="O1 N20",
    number=dict(zip(MILLS, ("127", "PS0127"), strict=True)), word="DPRNT",
)
case(
    "the fault of DO4 is its DO4",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 DO4\nN30 M30",
    runs="N10", alarm="illegal-loop-number", at="O1 N20",
    number=dict(zip(MILLS, ("126", "PS0126"), strict=True)), word="DO4",
)
case(
    "the fault of GOTO1.5 is its GOTO1.5",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 GOTO1.5\nN30 M30",
    runs="N10", alarm="illegal-decimal-point", at="O1 N20",
    number=dict(zip(MILLS, ("007", "PS0007"), strict=True)), word="GOTO1.5",
)
case(
    "the fault of IF[1EQ1]GOTO77 is its GOTO77",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[1EQ1]GOTO77\nN30 M30",
    runs="N10", alarm="jump-target-not-found", at="O1 N20",
    number=dict(zip(MILLS, ("128", "PS0128"), strict=True)), word="GOTO77",
)
case(
    "the fault of IF[1EQ1]GOTO 77 is its 77",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[1EQ1]GOTO 77\nN30 M30",
    runs="N10", alarm="jump-target-not-found", at="O1 N20",
    number=dict(zip(MILLS, ("128", "PS0128"), strict=True)), word="77",
)
case(
    "the fault of END3 is its END3",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 END3\nN30 M30",
    runs="N10", alarm="missing-do", at="O1 N20",
    number=dict(zip(MILLS, ("124", "PS1124"), strict=True)), word="END3",
)
case(
    "no fault is in #2=#[500]",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 #2=#[500]\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "no fault is in IF[#500EQ1]GOTO30",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[#500EQ1]GOTO30\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "no fault is in IF[1EQ1]THEN#2=1",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[1EQ1]THEN#2=1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "no fault is in #2=ABS[2]",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 #2=ABS[2]\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "no fault is in GOTO30",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 GOTO30\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "no fault is in IF[1EQ1]GOTO30",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[1EQ1]GOTO30\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "no fault is in IF[1EQ0]GOTO 77",
    control=MILLS, **RULE,
    program="O1\nN10 G0 X0\nN20 IF[1EQ0]GOTO 77\nN30 M30",
    runs="N10 N20 N30",
)
