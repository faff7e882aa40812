"""Codes of a control that change its path in a way that is not computed. They alarm rather than
move wrongly. Codes that no path depends on let the block go on.
"""

from conformance import case

F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
POLICY = {"source": "policy: no wrong move without a word", "evidence": "inferred"}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
MILL, LATHE = {"machine": "mill"}, {"machine": "lathe-a"}


def block(words, mode="G91 ", axis="X"):
    return f"O1\nN10 {mode}G1 F100.\nN20 {words} {axis}10.\nN30 M30"


case(
    "involutes: G2.2 is a code whose moves are not computed",
    control=[F16, F0F, F30], **POLICY, setup=MILL,
    program=block("G2.2"),
    alarm="code-not-computed", at="O1 N20", word="G2.2",
)
case(
    "NURBS: G6.2 is a code whose moves are not computed",
    control=[F16, F30, *MITSUBISHI], **POLICY, setup=MILL,
    program=block("G6.2"),
    alarm="code-not-computed", at="O1 N20", word="G6.2",
)
case(
    "cylindrical interpolation: G7.1 is a code whose moves are not computed",
    control=[*FANUC, *MITSUBISHI], **POLICY, setup=MILL,
    program=block("G7.1"),
    alarm="code-not-computed", at="O1 N20", word="G7.1",
)
case(
    "cylindrical interpolation by its older code: G107 is a code whose moves are not computed",
    control=FANUC, **POLICY, setup=MILL,
    program=block("G107"),
    alarm="code-not-computed", at="O1 N20", word="G107",
)
case(
    "the corner arc of compensation: G39 is a code whose moves are not computed",
    control=FANUC, **POLICY, setup=MILL,
    program=block("G39"),
    alarm="code-not-computed", at="O1 N20", word="G39",
)
case(
    "normal direction control: G41.1 is a code whose moves are not computed",
    control=[*FANUC, *MITSUBISHI], **POLICY, setup=MILL,
    program=block("G41.1"),
    alarm="code-not-computed", at="O1 N20", word="G41.1",
)
case(
    "a tilted plane: G68.2 is a code whose moves are not computed",
    control=[F0F, F30, *MITSUBISHI], **POLICY, setup=MILL,
    program=block("G68.2"),
    alarm="code-not-computed", at="O1 N20", word="G68.2",
)
case(
    "tool centre point control: G43.4 is a code whose moves are not computed",
    control=[F30, *MITSUBISHI], **POLICY, setup=MILL,
    program=block("G43.4"),
    alarm="code-not-computed", at="O1 N20", word="G43.4",
)
case(
    "the floating reference point: G30.1 is a code whose moves are not computed",
    control=FANUC, **POLICY, setup=MILL,
    program=block("G30.1"),
    alarm="code-not-computed", at="O1 N20", word="G30.1",
)
case(
    "the cutting of circles: G12 is a code whose moves are not computed",
    control=MITSUBISHI, **POLICY, setup=MILL,
    program=block("G12"),
    alarm="code-not-computed", at="O1 N20", word="G12",
)
case(
    "polar interpolation: G12.1 is a code whose moves are not computed",
    control=[*FANUC, "gsk-988ta", "gsk-988t", "gsk-980tdi"], **POLICY, setup=LATHE,
    program=block("G12.1", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G12.1",
)
case(
    "mirroring of double turrets: G68 is a code whose moves are not computed",
    control=[*FANUC, "gsk-988ta", "gsk-988t"], **POLICY, setup=LATHE,
    program=block("G68", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G68",
)
case(
    "rigid threads: G32.1 is a code whose moves are not computed",
    control=["gsk-988ta", "gsk-988t", "gsk-980tdi"], **POLICY, setup=LATHE,
    program=block("G32.1", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G32.1",
)
case(
    "ellipses and parabolas: G6.2 is a code whose moves are not computed",
    control=["gsk-980tdi"], **POLICY, setup=LATHE,
    program=block("G6.2", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G6.2",
)
case(
    "hobbing: G51.3 is a code whose moves are not computed",
    control=["gsk-988ta", "gsk-988t"], **POLICY, setup=LATHE,
    program=block("G51.3", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G51.3",
)
case(
    "the thread cycle G92.1 is not computed, in both G code systems",
    control=["gsk-988ta", "gsk-988t"], source="TA 19", evidence="maker's manual",
    setup={"machine": "lathe-b"}, program=block("G92.1"), alarm="code-not-computed", at="O1 N20",
    word="G92.1",
)
case(
    "milling of pockets, G110 to G117, is not computed", control="gsk-980mdi", **POLICY,
    program=block("G110"), alarm="code-not-computed", at="O1 N20", word="G110",
)
case(
    "a cycle of G code system B is not computed in system A", control=FANUC, **POLICY, setup=LATHE,
    program=block("G77", "", "U"), alarm="code-not-computed", at="O1 N20", word="G77",
)
case(
    "look-ahead: G8 P1 lets the move of its block be made",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=block("G8 P1", "G91 ", "X"),
    moves="F X10",
)
case(
    "high-speed machining: G5 P10000 lets the move of its block be made",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=block("G5 P10000", "G91 ", "X"),
    moves="F X10",
)
case(
    "the end of data setting: G11 lets the move of its block be made",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=block("G11", "G91 ", "X"),
    moves="F X10",
)
case(
    "the end of normal direction control: G40.1 lets the move of its block be made",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=block("G40.1", "G91 ", "X"),
    moves="F X10",
)
case(
    "the end of polar interpolation: G113 lets the move of its block be made",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=block("G113", "G91 ", "X"),
    moves="F X10",
)
case(
    "the end of polar interpolation on lathes: G13.1 lets the move of its block be made",
    control=[*FANUC, "gsk-988ta", "gsk-980tdi"], **KNOWN, setup=LATHE,
    program=block("G13.1", "", "U"),
    moves="F X10",
)
case(
    "the axis words of G5.1 Q1 name axes, they move none", control=FANUC, **KNOWN, setup=MILL,
    program=block("G5.1 Q1"), moves="none",
)

TDI5 = {"source": "TDi 5", "evidence": "maker's manual"}
AT = {"machine": "lathe-a", "start": {"X": 10, "Z": 20}}

case(
    "G05 is an arc through a third point",
    control="gsk-980tdi", **TDI5, setup=AT,
    program="O1\nN10 G05 X10 Z10 I5 K-5 F150\nN30 M30",
    moves="CCW X10 Z10 C X10 Z15",
)
case(
    "G05.1 is an arc through a third point",
    control="gsk-980tdi", **TDI5, setup=AT,
    program="O1\nN10 G05.1 X10 Z10 I20 K15 F150\nN20 X10 Z20 I20 K15\nN30 M30",
    moves="CCW X10 Z10 C X10 Z15\nCW X10 Z20 C X10 Z15",
)
case(
    "three points on one line: no arc of G05",
    control="gsk-980tdi", **TDI5, setup=AT,
    program="O1\nN10 G05 X10 Z10 I0 K-5 F150\nN20 M30",
    alarm="three-points", at="O1 N10", word="I0",
)
case(
    "no point in between: no arc of G05",
    control="gsk-980tdi", **TDI5, setup=AT,
    program="O1\nN10 G05 X10 Z10 F150\nN20 M30",
    alarm="three-points", at="O1 N10", word="G05",
)
case(
    "a full circle: no arc of G05",
    control="gsk-980tdi", **TDI5, setup=AT,
    program="O1\nN10 G05 X10 Z20 I5 K-5 F150\nN20 M30",
    alarm="three-points", at="O1 N10", word="I5",
)

# A code of the list of a control is never refused with its number: it runs, or is not computed
# here.
case(
    "the end of length offsets: G49 of the other kind of machine goes on",
    control=FANUC, source="added.md: the modal groups of a 0i-TF Plus; general knowledge",
    evidence="inferred", setup=LATHE,
    program=block("G49", "", "U"),
    moves="F X10",
)
case(
    "the exact stop mode: G61 of the other kind of machine goes on",
    control=FANUC, source="added.md: the modal groups of a 0i-TF Plus; general knowledge",
    evidence="inferred", setup=LATHE,
    program=block("G61", "", "U"),
    moves="F X10",
)
case(
    "the cutting mode: G64 of the other kind of machine goes on",
    control=[*FANUC, "gsk-988ta", "gsk-988t"],
    source="added.md: the modal groups of a 0i-TF Plus; general knowledge", evidence="inferred",
    setup=LATHE,
    program=block("G64", "", "U"),
    moves="F X10",
)
case(
    "the end of polar coordinates: G15 of the other kind of machine goes on",
    control=FANUC, source="added.md: the modal groups of a 0i-TF Plus; general knowledge",
    evidence="inferred", setup=LATHE,
    program=block("G15", "", "U"),
    moves="F X10",
)
case(
    "the check of the spindle's speed: G26 of the other kind of machine goes on",
    control=FANUC, source="added.md: the modal groups of a 0i-TF Plus; general knowledge",
    evidence="inferred", setup=MILL,
    program=block("G26", "G91 ", "X"),
    moves="F X10",
)
case(
    "the end of that check: G25 of the other kind of machine goes on",
    control=FANUC, source="added.md: the modal groups of a 0i-TF Plus; general knowledge",
    evidence="inferred", setup=MILL,
    program=block("G25", "G91 ", "X"),
    moves="F X10",
)
case(
    "the end of polar interpolation: G13.1 of the other kind of machine goes on",
    control=MITSUBISHI, source="added.md: the modal groups of a 0i-TF Plus; general knowledge",
    evidence="inferred", setup=MILL,
    program=block("G13.1", "G91 ", "X"),
    moves="F X10",
)
case(
    "G50.1 of a lathe ends no mirror, and moves nothing", control=FANUC,
    source="added.md: the modal groups of a 0i-TF Plus", evidence="inferred", setup=LATHE,
    program="O1\nN10 G98 G1 F100.\nN20 G50.1 X0\nN30 Z5.\nN40 M30", moves="F Z5",
)
case(
    "polar coordinates of a lathe: G16 is not computed, and alarms with no number",
    control=FANUC, source="the control's list; policy: no wrong move without a word",
    evidence="inferred", setup=LATHE,
    program=block("G16", "", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G16",
)
case(
    "the mirror of a lathe: G51.1 X0 is not computed, and alarms with no number",
    control=FANUC, source="the control's list; policy: no wrong move without a word",
    evidence="inferred", setup=LATHE,
    program=block("G51.1 X0", "", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G51.1",
)
case(
    "polar interpolation of a mill: G12.1 is not computed, and alarms with no number",
    control=MITSUBISHI, source="the control's list; policy: no wrong move without a word",
    evidence="inferred", setup=MILL,
    program=block("G12.1", "G91 ", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G12.1",
)
case(
    "the drilling cycle of the 980TDi: G86 is not computed, and alarms with no number",
    control="gsk-980tdi", source="the control's list; policy: no wrong move without a word",
    evidence="inferred", setup=LATHE,
    program=block("G86", "", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G86",
)
case(
    "the threads of the 980TDi: G92.1 is not computed, and alarms with no number",
    control="gsk-980tdi", source="the control's list; policy: no wrong move without a word",
    evidence="inferred", setup=LATHE,
    program=block("G92.1", "", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G92.1",
)
case(
    "G78 of a GSK lathe: G78 is not computed, and alarms with no number",
    control=["gsk-980tdi", "gsk-988ta", "gsk-988t"],
    source="the control's list; policy: no wrong move without a word", evidence="inferred",
    setup=LATHE,
    program=block("G78", "", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G78",
)
case(
    "the cycles of lathes on a mill: G71 is not computed, and alarms with no number",
    control=FANUC, source="the control's list; policy: no wrong move without a word",
    evidence="inferred", setup=MILL,
    program=block("G71", "G91 ", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G71",
)
case(
    "polar coordinates of the 980MDi on a lathe: G16 is not computed, and alarms with no number",
    control="gsk-980mdi", source="the control's list; policy: no wrong move without a word",
    evidence="inferred", setup=LATHE,
    program=block("G16", "", "Z"),
    alarm="code-not-computed", at="O1 N20", word="G16",
)
case(
    "G16, which the control's list has not, is refused with its number",
    control=["gsk-988ta", "gsk-980tdi"], source="the control's list; Talm 009; ALM 010; SK P34",
    evidence="inferred", setup=LATHE,
    program=block("G16", "", "Z"),
    alarm="g-code-not-available", number={"gsk-988ta": "009", "gsk-980tdi": "0002"}, at="O1 N20", word="G16",
)
case(
    "G86, which the control's list has not, is refused with its number",
    control=["gsk-988ta"], source="the control's list; Talm 009; ALM 010; SK P34",
    evidence="inferred", setup=LATHE,
    program=block("G86", "", "Z"),
    alarm="g-code-not-available", number={"gsk-988ta": "009"}, at="O1 N20", word="G86",
)
case(
    "G78.1, which the control's list has not, is refused with its number",
    control=["fanuc-16i", "fanuc-30i"], source="the control's list; Talm 009; ALM 010; SK P34",
    evidence="inferred", setup=LATHE,
    program=block("G78.1", "", "Z"),
    alarm="g-code-not-available", number={"fanuc-16i": "010", "fanuc-30i": "PS0010"}, at="O1 N20",
    word="G78.1",
)
case(
    "G77.3, which the control's list has not, is refused with its number",
    control=MITSUBISHI, source="the control's list; Talm 009; ALM 010; SK P34", evidence="inferred",
    setup=LATHE,
    program=block("G77.3", "", "Z"),
    alarm="g-code-not-available", number=dict.fromkeys(MITSUBISHI, "P34"), at="O1 N20", word="G77.3",
)

# The 928TE and the HNC-21M: only a part of their codes is known.
case(
    "G22 of the 928TE is its own, and not computed",
    control="gsk-928te", pins="g_meanings",
    source="general knowledge: a loop, returns to points, a thread", evidence="inferred",
    setup=LATHE,
    program=block("G22", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G22",
)
case(
    "G26 of the 928TE is its own, and not computed",
    control="gsk-928te", pins="g_meanings",
    source="general knowledge: a loop, returns to points, a thread", evidence="inferred",
    setup=LATHE,
    program=block("G26", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G26",
)
case(
    "G27 of the 928TE is its own, and not computed",
    control="gsk-928te", pins="g_meanings",
    source="general knowledge: a loop, returns to points, a thread", evidence="inferred",
    setup=LATHE,
    program=block("G27", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G27",
)
case(
    "G29 of the 928TE is its own, and not computed",
    control="gsk-928te", pins="g_meanings",
    source="general knowledge: a loop, returns to points, a thread", evidence="inferred",
    setup=LATHE,
    program=block("G29", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G29",
)
case(
    "G33 of the 928TE is its own, and not computed",
    control="gsk-928te", pins="g_meanings",
    source="general knowledge: a loop, returns to points, a thread", evidence="inferred",
    setup=LATHE,
    program=block("G33", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G33",
)
case(
    "G80 of the 928TE is its own, and not computed",
    control="gsk-928te", pins="g_meanings",
    source="general knowledge: a loop, returns to points, a thread", evidence="inferred",
    setup=LATHE,
    program=block("G80", "", "U"),
    alarm="code-not-computed", at="O1 N20", word="G80",
)
case(
    "nobody says whether the 928TE has G10",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G10", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G10",
)
case(
    "nobody says whether the 928TE has G20",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G20", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G20",
)
case(
    "nobody says whether the 928TE has G28",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G28", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G28",
)
case(
    "nobody says whether the 928TE has G31",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G31", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G31",
)
case(
    "nobody says whether the 928TE has G53",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G53", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G53",
)
case(
    "nobody says whether the 928TE has G54",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G54", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G54",
)
case(
    "nobody says whether the 928TE has G60",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G60", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G60",
)
case(
    "nobody says whether the 928TE has G71",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G71", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G71",
)
case(
    "nobody says whether the 928TE has G92",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G92", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G92",
)
case(
    "nobody says whether the 928TE has G5.1",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G5.1", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G5.1",
)
case(
    "nobody says whether the 928TE has G123",
    control="gsk-928te", **POLICY, setup=LATHE, pins="unlisted_codes",
    program=block("G123", "", "U"),
    alarm="code-not-known", at="O1 N20", word="G123",
)
case(
    "the 928TE has no macro calls: G65 P2 A1.",
    control="gsk-928te", source="general knowledge: no macro statements", evidence="inferred",
    setup=LATHE,
    program="N10 G0 X1\nN20 G65 P2 A1.\nN30 M30",
    runs="N10", alarm="g-code-not-available", word="G65",
)
case(
    "the 928TE has no macro calls: G66 P2",
    control="gsk-928te", source="general knowledge: no macro statements", evidence="inferred",
    setup=LATHE,
    program="N10 G0 X1\nN20 G66 P2\nN30 M30",
    runs="N10", alarm="g-code-not-available", word="G66",
)
case(
    "the 928TE has no macro calls: G67",
    control="gsk-928te", source="general knowledge: no macro statements", evidence="inferred",
    setup=LATHE,
    program="N10 G0 X1\nN20 G67\nN30 M30",
    runs="N10", alarm="g-code-not-available", word="G67",
)
case(
    "the 928TE runs G0",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G0 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G1",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G1 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G2 R10",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G2 R10 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G3 R10",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G3 R10 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G4 D1",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G4 D1 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G96 S100",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G96 S100 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G97 S100",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G97 S100 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G98",
    control="gsk-928te", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G98 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "the 928TE runs G99",
    control="gsk-928te", pins="refuses", source="source 001; 928Ti; general knowledge",
    evidence="inferred", setup=LATHE,
    program="N10 G98 G1 F100\nN20 G99 X2 Z1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "G7 is a code of the HNC-21M that is not computed",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G7"),
    alarm="code-not-computed", at="O1 N20", word="G7",
)
case(
    "G11 is a code of the HNC-21M that is not computed",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G11"),
    alarm="code-not-computed", at="O1 N20", word="G11",
)
case(
    "G12 is a code of the HNC-21M that is not computed",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G12"),
    alarm="code-not-computed", at="O1 N20", word="G12",
)
case(
    "G34 is a code of the HNC-21M that is not computed",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G34"),
    alarm="code-not-computed", at="O1 N20", word="G34",
)
case(
    "G65 P2 is a code of the HNC-21M that is not computed",
    control="hnc-21m", **KNOWN, pins="roles:G65=macro-call", setup=MILL,
    program=block("G65 P2"),
    alarm="code-not-computed", at="O1 N20", word="G65",
)
case(
    "the HNC-21M has no G10",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G10"),
    alarm="g-code-not-available", at="O1 N20", word="G10",
)
case(
    "the HNC-21M has no G31",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G31"),
    alarm="g-code-not-available", at="O1 N20", word="G31",
)
case(
    "the HNC-21M has no G66",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G66"),
    alarm="g-code-not-available", at="O1 N20", word="G66",
)
case(
    "the HNC-21M has no G67",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G67"),
    alarm="g-code-not-available", at="O1 N20", word="G67",
)
case(
    "the HNC-21M has no G96",
    control="hnc-21m", **KNOWN, setup=MILL,
    program=block("G96"),
    alarm="g-code-not-available", at="O1 N20", word="G96",
)
case(
    "nobody says whether the HNC-21M has G8",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G8"),
    alarm="code-not-known", at="O1 N20", word="G8",
)
case(
    "nobody says whether the HNC-21M has G30",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G30"),
    alarm="code-not-known", at="O1 N20", word="G30",
)
case(
    "nobody says whether the HNC-21M has G33",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G33"),
    alarm="code-not-known", at="O1 N20", word="G33",
)
case(
    "nobody says whether the HNC-21M has G36",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G36"),
    alarm="code-not-known", at="O1 N20", word="G36",
)
case(
    "nobody says whether the HNC-21M has G51.1",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G51.1"),
    alarm="code-not-known", at="O1 N20", word="G51.1",
)
case(
    "nobody says whether the HNC-21M has G54.1 P1",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G54.1 P1"),
    alarm="code-not-known", at="O1 N20", word="G54.1",
)
case(
    "nobody says whether the HNC-21M has G93",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G93"),
    alarm="code-not-known", at="O1 N20", word="G93",
)
case(
    "nobody says whether the HNC-21M has G97",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G97"),
    alarm="code-not-known", at="O1 N20", word="G97",
)
case(
    "nobody says whether the HNC-21M has G345",
    control="hnc-21m", **POLICY, setup=MILL, pins="unlisted_codes",
    program=block("G345"),
    alarm="code-not-known", at="O1 N20", word="G345",
)
