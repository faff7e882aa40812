"""Blocks, interpolation and coordinates, claim by claim: claims that no other row would notice."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE, HNC = "gsk-980tdi", "gsk-980mdi", "gsk-928te", "hnc-21m"
GSK_LATHES = [*GSK_988, TDI, TE]
MILLS = [*FANUC, MDI, *MITSUBISHI, HNC]
LATHES = [*FANUC, *GSK_LATHES]
TURNING = [*FANUC, *GSK_988, TDI]  # the codes of the 928 are known in part only
POLAR = [*FANUC, MDI, *MITSUBISHI]
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
HOME = {"reference": {1: {"X": 0, "Y": 0, "Z": 0}, 2: {"X": -5}, 3: {"X": -7}, 4: {"X": -9}}}


def numbers(controls, fanuc, **others):
    """Return the number of each control: of a FANUC `fanuc`, which the later ones show as PS0 and
    it.
    """
    table = {c: fanuc if c == "fanuc-16i" else f"PS0{fanuc}" for c in FANUC}
    table |= dict.fromkeys(MITSUBISHI, others.get("mitsubishi"))
    table |= dict.fromkeys(GSK_988, others.get("gsk_988"))
    table |= {MDI: others.get("mdi"), TDI: None, TE: None, HNC: None}
    return {control: table[control] for control in controls}


def program(*blocks):
    lines = [f"N{n}0 {block}" for n, block in enumerate((*blocks, "M30"), 1)]
    return "\n".join(("O1", *lines, ""))


def moves(claim, controls, *blocks, source="general knowledge", evidence="inferred", **keywords):
    case(
        claim, control=controls, source=source, evidence=evidence, program=program(*blocks),
        pins="max_words repeated_address no_radius refuses:no-arc-travel max_rotation rotation_words",
        **keywords,
    )


# Blocks that another language refuses
_OTHERS = [*MILLS, *GSK_988, TDI, "haas-ngc", "syntec-22ma"]
for _claim, _pin, _controls, _blocks in (
    ("G01 without an axis moves nothing, and needs no feed", "no-feed", [*_OTHERS, TE], ("G0 X5.", "G1")),
    ("a centre of 0 across the plane counts for nothing", "arc-axis-not-in-plane", _OTHERS,
     ("G1 F100.", "G17 G2 X20. I10. J0 K0")),
    ("R may stand beside a centre", "radius-and-centre", _OTHERS,
     ("G1 F100.", "G17 G2 X20. I10. R10.")),
    ("the plane of Y and Z has a radius compensation", "offset-in-wrong-plane", _OTHERS,
     ("G19 G1 F100.", "G41 D1 Y50.", "Y90.", "G40 Y120.")),
):
    case(
        _claim, control=_controls, source="general knowledge", evidence="inferred",
        program=program(*_blocks), pins=f"refuses:{_pin}",
        runs=" ".join(f"N{n}0" for n in range(1, len(_blocks) + 2)),
    )

# Blocks, groups, power-on
moves(
    "G91 at the end of a block counts for the words before it", MILLS,
    "G90 G1 X5. Y5. F100.", "X5. Y7. G91", setup=MILL, moves="F X5 Y5\nF X10 Y12",
)
moves(
    "a work system at the end of a block counts for the words before it", MILLS,
    "G90 G0 X5. G55", setup=MILL | {"work_offsets": {"G55": {"X": 100}}}, centre="X105",
)
moves(
    "of two motion codes in a block the later counts",
    [*FANUC, *GSK_988, TE, *MITSUBISHI, HNC], "G1 G0 X5. F100.", "G0 G1 X9.",
    moves="R X5\nF X9",
)
moves(
    "two motion codes in a block are 010 on the GSK 988 when AD2 is set", GSK_988,
    "G0 X1", "G1 G0 X5 F100", source="Talm 010; TApar 3403#6", evidence="secondary",
    params={"3403#6": 1}, runs="N10", alarm="address-given-twice", number="010", at="O1 N20", word="G0",
)
moves(
    "more than a hundred words in a block are 011 on the 980MDi", MDI,
    "G0 X1", "S1" * 100 + "M5M6", source="MDib 0011", evidence="maker's manual",
    runs="N10", alarm="too-many-words", number="0011", at="O1 N20", word="M5",
)
moves(
    "a G without a number is G00 on a Mitsubishi", MITSUBISHI,
    "G90 G1 X1. F100.", "G X20.", source="M7 p.45", evidence="maker's manual", setup=MILL,
    moves="F X1\nR X20",
)
moves(
    "G00 without an axis only changes the mode", [*MILLS, *GSK_LATHES],
    "G1 F100.", "G0", "X5.", source="TDi 2", evidence="maker's manual", moves="R X5",
)

# Arcs
moves(
    "in G18 of a mill G03 turns from Z to X, G02 back", MILLS,
    "G90 G18 G3 X10. Z10. I10. K0 F100.", "G2 X0 Z0 I0 K-10.", source="source 003, G17 G18 G19",
    evidence="source document", setup=MILL,
    moves="CCW X10 Z10 C X10 Z0\nCW X0 Z0 C X10 Z0",
)
moves(
    "in G19 G03 turns from Y to Z, G02 back", MILLS,
    "G90 G19 G3 Y10. Z10. J0 K10. F100.", "G2 Y0 Z0 R10.", source="source 003, G17 G18 G19",
    evidence="source document", setup=MILL,
    moves="CCW Y10 Z10 C Y0 Z10\nCW Y0 Z0 C Y0 Z10",
)
moves(
    "a helix in G18 climbs along Y", MILLS,
    "G90 G18 G2 X10. Z10. Y5. R10. F100.", setup=MILL, moves="CW X10 Y5 Z10 C X0 Z10",
)
moves(
    "the feed of a helix is that in its plane", MILLS,
    "G90 G2 I10. Z30. F100.", setup=MILL, source="source 003, helix; general knowledge",
    moves="CW X0 Z30 C X10 Y0", time=37.699,
)
moves(
    "exactly half a circle is the same with either sign of R", MILLS,
    "G90 G2 X20. R10. F100.", "G2 X0 R-10.", source="source 003, R", evidence="source document",
    setup=MILL, moves="CW X20 C X10 Y0\nCW X0 C X10 Y0",
)
moves(
    "an end that is the start makes a full circle too", MILLS,
    "G90 G3 X0 Y0 I-10. F100.", source="source 003, full circle", evidence="source document",
    setup=MILL, moves="CCW X0 Y0 C X-10 Y0", time=37.699,
)
moves(
    "I and K without an end are a full circle of a lathe", LATHES,
    "G98 G2 I10. F100.", source="TDi 4 note 4", evidence="inferred", setup=LATHE,
    moves="CW X0 Z0 C X20 Z0", time=37.699,
)
moves(
    "an arc with R that ends where it starts is no move", [*FANUC, MDI, HNC],
    "G90 G2 X0 Y0 R10. F100.", "G1 X5.", source="16TC p.67", evidence="inferred", setup=MILL,
    moves="F X5",
)
moves(
    "an arc with R that ends where it starts is no move of a lathe", LATHES,
    "G98 G2 X0 Z0 R10. F100.", "G1 X5.", source="16TC p.67; TDi 4 note 4",
    evidence="maker's manual", setup=LATHE, moves="F X5",
)
moves(
    "R counts where I and K stand beside it on a lathe", LATHES,
    "G98 G3 X20. Z-10. R10. I3. K3. F100.", source="16TC p.67; TDi 4 note 2",
    evidence="maker's manual", setup=LATHE, moves="CCW X20 Z-10 C X0 Z-10",
)
moves(
    "K in an arc of G17 alarms", MILLS,
    "G90 G0 X0", "G2 X10. Y10. I10. K3. F100.", source="ALM 021; MDib 0008", evidence="secondary",
    setup=MILL, runs="N10", alarm="arc-axis-not-in-plane",
    number=numbers(MILLS, "021", mitsubishi="P113", mdi="0008"), at="O1 N20", word="K3.",
)
moves(
    "J in an arc of a lathe alarms", LATHES,
    "G98 G0 X0", "G3 X20. Z-10. K-10. J3. F100.", source="ALM 021; Talm 033", evidence="secondary",
    setup=LATHE, runs="N10", alarm="arc-axis-not-in-plane",
    number=numbers(LATHES, "021", gsk_988="033"), at="O1 N20", word="J3.",
)
moves(
    "an arc without R, I and K is 034 on the GSK 988 while 3403#5 is 1", GSK_988,
    "G98 G0 X0", "G2 X10 Z-10 F100", source="Talm 034; TApar 3403#5", evidence="secondary",
    params={"3403#5": 1}, setup=LATHE, runs="N10", alarm="no-radius", number="034", at="O1 N20", word="G2",
)
moves(
    "an arc without R, I and K is a line of the GSK 988 while 3403#5 is 0", GSK_988,
    "G98 G2 X10 Z-10 F100", source="TApar 3403#5", evidence="maker's manual", setup=LATHE,
    moves="F X10 Z-10",
)
moves(
    "while 3403#4 is 1 a radius too small alarms on the GSK 988 inside the tolerance too", GSK_988,
    "G98 G0 X0", "G2 Z-20.1 R10 F100", source="Talm 035; TApar 3403#4", evidence="secondary",
    params={"3403#4": 1, "3410": 0.2}, setup=LATHE, runs="N10", alarm="radius-too-small",
    number="035", at="O1 N20", word="R10",
)
moves(
    "while 3403#4 is 1 a radius too small alarms on a FANUC inside the tolerance too", FANUC,
    "G90 G0 X0", "G2 X20.1 R10. F100.", source="TApar 3403#4", params={"3403#4": 1, "3410": 0.2},
    setup=MILL, runs="N10", alarm="radius-too-small", number=numbers(FANUC, "020"), at="O1 N20", word="R10.",
)
moves(
    "radii that differ by more than 3410 are 0018 on the 980MDi", MDI,
    "G90 G0 X0", "G2 X20.3 I10 F100", source="MDib 0018", evidence="maker's manual",
    params={"3410": 0.1}, runs="N10", alarm="radius-tolerance", number="0018", at="O1 N20", word="X20.3",
)
moves(
    "radii that differ by more than 154 alarm on the 980TDi", TDI,
    "G98 G0 X0", "G3 X20.6 Z-10 K-10 F100", source="TDi 4 note 5; TDipar 154",
    evidence="maker's manual", params={"154": 0.1}, runs="N10", alarm="radius-tolerance",
    at="O1 N20", word="X20.6",
)
moves(
    "1084 of a Mitsubishi is the tolerance of an arc", MITSUBISHI,
    "G90 G2 X20.3 I10. F100.", source="M7 p.194", evidence="maker's manual", params={"1084": 0.5},
    setup=MILL, moves="CW X20.3 C X10 Y0",
)

# Coordinates
moves(
    "V and H are the increments of Y and C on a lathe", [*FANUC, *GSK_988],
    "G0 Y10 C30", "V5 H10", source="TDi 2; general knowledge", replace={"whole_numbers": "millimetres"}, setup=LATHE,
    moves="R Y10 C30\nR Y15 C40",
)
moves(
    "EXT is added to every work system", MILLS,
    "G90 G54 G0 X0 Y0", "G55 X0 Y0", source="source 003, G54 to G59", evidence="source document",
    setup=MILL | {"work_offsets": {"G54": {"X": 160}, "G55": {"Y": 50}, "EXT": {"X": 1, "Y": 2}}},
    centre="X161 Y2 | X1 Y52",
)
moves(
    "selecting a work system moves nothing, and an axis without a word stays", MILLS,
    "G90 G0 X1. Y1.", "G55", "G56 X0", source="source 003, G54 to G59", evidence="source document",
    setup=MILL | {"work_offsets": {"G55": {"Y": 10}, "G56": {"X": 30, "Y": 9}}},
    centre="X1 Y1 | X30 Y1",
)
moves(
    "S beside G50 sets no coordinates", LATHES,
    "G0 X10. Z10.", "G50 S2000", "G0 X1. Z1.", source="TDi 18", evidence="maker's manual",
    setup=LATHE, centre="X10 Z10 | X1 Z1",
)
moves(
    "G50 without words changes nothing", [*FANUC, *GSK_988, TE],
    "G0 X10. Z10.", "G50", "G0 X1. Z1.", source="TDi 18", evidence="inferred", setup=LATHE,
    centre="X10 Z10 | X1 Z1",
)
moves(
    "the point that G92 sets includes the length offset in force", MILLS,
    "G90 G43 H1 G0 Z100.", "G92 Z50.", "G0 Z0", "G49 Z0", source="M7 p.531", evidence="inferred",
    setup=MILL | {"length_offsets": {1: 30}}, centre="Z130 | Z80 | Z50",
)
moves(
    "G52 under G91 gives the zero itself, no increment", MILLS,
    "G90 G52 X10.", "G91 G52 X5.", "G90 G0 X0", source="TDi 19", evidence="inferred", setup=MILL,
    centre="X5",
)
moves(
    "G53 of a lathe takes no U", TURNING,
    "G0 X10.", "G53 X5.", "G53 U5.", "G0 X6.", source="TDi 20", evidence="inferred",
    setup=LATHE | HOME | {"work_offsets": {"G54": {"X": 100}}}, moves="R X10\nR X-95\nR X6",
)
moves(
    "G53 takes the length offset away on the axis that moves", FANUC,
    "G90 G43 H1 G0 Z100.", "G53 Z50.", "G0 Z10.", source="0iMB p.228", evidence="maker's manual",
    setup=MILL | HOME | {"length_offsets": {1: 30}}, centre="Z130 | Z50 | Z10",
)
moves(
    "G53 leaves the length offset where Z does not move", FANUC,
    "G90 G43 H1 G0 Z100.", "G53 X50.", "G0 Z10.", source="0iMB p.228", evidence="maker's manual",
    setup=MILL | HOME | {"length_offsets": {1: 30}}, centre="Z130 | X50 Z130 | Z40",
)
moves(
    "G53 of a Mitsubishi keeps the radius offset", MITSUBISHI,
    "G90 G41 D1 G1 X10. F100.", "X20.", "G53 X30.", "X40.", "G40 X50.", source="M7 p.520",
    evidence="maker's manual", setup=MILL | HOME | {"radius_offsets": {1: 3}},
    centre="X10 Y3 | X20 Y3 | X30 Y3 | X40 Y3 | X50 Y0",
)
moves(
    "of G53 and G28 in a block the later counts on a Mitsubishi", MITSUBISHI,
    "G90 G0 X50.", "G28 G53 X5.", "G53 G28 X9.", source="M7 p.520", evidence="maker's manual",
    setup=MILL | HOME, moves="R X50\nR X5\nR X9\nR X0",
)
moves(
    "G10 L2 changes nothing before the next block", POLAR,
    "G90 G0 X1.", "G10 L2 P1 X5.", "X1.", setup=MILL, centre="X1 | X6",
)

# Polar coordinates
POLE = {"source": "16MC p.147; M7 p.96", "evidence": "maker's manual", "setup": MILL}

moves(
    "in G18 the radius of polar coordinates is Z and the angle X", POLAR,
    "G18 G90 G16 G0 Z10. X30.", **POLE, moves="R X5 Z8.6603",
)
moves(
    "in G19 the radius of polar coordinates is Y and the angle Z", POLAR,
    "G19 G90 G16 G0 Y10. Z30.", **POLE, moves="R Y8.6603 Z5",
)
moves(
    "the pole is the zero of G52", POLAR,
    "G90 G52 X5. Y5.", "G16 G0 X10. Y90.", **POLE, centre="X5 Y15",
)
moves(
    "a polar angle without a radius keeps the distance from zero", POLAR,
    "G90 G0 X10. Y0", "G16 Y90.", **POLE | {"source": "M7 p.98"}, moves="R X10\nR X0 Y10",
)
moves(
    "a polar radius without an angle keeps the angle", POLAR,
    "G90 G0 X10. Y10.", "G16 X20.", **POLE | {"source": "M7 p.98"},
    moves="R X10 Y10\nR X14.1421 Y14.1421",
)
moves(
    "with radius and angle in increments the pole is the tool, the angle that before plus more",
    POLAR, "G90 G16 G0 X10. Y30.", "G91 X10. Y30.",
    source="policy", evidence="inferred", setup=MILL, moves="R X8.6603 Y5\nR X13.6603 Y13.6603",
)
moves(
    "the words of G04 are not polar",
    POLAR, "G90 G16 G0 X10. Y30.", "G4 X1.", "X10. Y90.", setup=MILL | HOME,
    moves="R X8.6603 Y5\nW 1\nR X0 Y10",
)
moves(
    "the words of G28 are not polar",
    POLAR, "G90 G16 G0 X10. Y30.", "G28 X3. Y4.", "X10. Y90.", setup=MILL | HOME,
    moves="R X8.6603 Y5\nR X3 Y4\nR X0 Y0\nR X0 Y10",
)
moves(
    "the words of G53 are not polar",
    POLAR, "G90 G16 G0 X10. Y30.", "G53 X3. Y4.", "X10. Y90.", setup=MILL | HOME,
    moves="R X8.6603 Y5\nR X3 Y4\nR X0 Y10",
)
moves(
    "the words of G52 are not polar",
    POLAR, "G90 G16 G0 X10. Y30.", "G52 X5. Y5.", "X10. Y90.", setup=MILL,
    centre="X8.6603 Y5 | X5 Y15",
)
moves(
    "the words of G10 are not polar",
    POLAR, "G90 G16 G0 X10. Y30.", "G10 L2 P1 X5. Y5.", "X10. Y90.", setup=MILL,
    centre="X8.6603 Y5 | X5 Y15",
)
moves(
    "the centre of G68 is not polar", FANUC,
    "G90 G16 G0 X10. Y30.", "G68 X3. Y4. R90.", "X10. Y0", setup=MILL,
    moves="R X8.6603 Y5\nR X7 Y11",
)

# Reference points
moves(
    "each axis keeps its own intermediate point", MILLS,
    "G90 G0 X50. Y30.", "G28 X60.", "G28 Y40.", "G29 X5. Y6.", setup=MILL | HOME,
    moves="R X50 Y30\nR X60\nR X0\nR Y40\nR Y0\nR X60 Y40\nR X5 Y6",
)
moves(
    "the intermediate point is a place of the machine", MILLS,
    "G90 G0 X50.", "G28 X60.", "G55", "G29 X5.",
    setup=MILL | HOME | {"work_offsets": {"G55": {"X": 10}}}, centre="X50 | X60 | X0 | X60 | X15",
)
moves(
    "G29 goes through the intermediate point of a G30 too", [c for c in MILLS if c != HNC],
    "G90 G0 X50.", "G30 X60.", "G29 X5.", setup=MILL | HOME,
    source="M7 p.523", evidence="inferred", moves="R X50\nR X60\nR X-5\nR X60\nR X5",
)
moves(
    "P of G30 names the reference point of a mill",
    ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-980mdi", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    "G0 X50.", "G30 P4 X1.", "G30 P3 X1.", "G30 P2 X1.", source="TDi 15", evidence="inferred",
    setup=HOME | {"machine": "mill"}, moves="R X50\nR X1\nR X-9\nR X1\nR X-7\nR X1\nR X-5",
)
moves(
    "P of G30 names the reference point of a lathe-a",
    TURNING, "G0 X50.", "G30 P4 X1.", "G30 P3 X1.", "G30 P2 X1.", source="TDi 15",
    evidence="inferred", setup=HOME | {"machine": "lathe-a"},
    moves="R X50\nR X1\nR X-9\nR X1\nR X-7\nR X1\nR X-5",
)
moves(
    "G28 of a lathe takes X as a place and W as an increment", TURNING,
    "G0 X50. Z30.", "G28 X60. W5.", source="TDi 15", evidence="maker's manual",
    setup=LATHE | HOME, moves="R X50 Z30\nR X60 Z35\nR X0 Z0",
)
moves(
    "the length offset goes on the way from the intermediate point to the reference point", MILLS,
    "G90 G43 H1 G0 Z100.", "G28 Z120.", source="0iMB p.228", evidence="inferred",
    setup=MILL | HOME | {"length_offsets": {1: 30}}, centre="Z130 | Z150 | Z0",
)
moves(
    "the radius offset is gone at the intermediate point", MILLS,
    "G90 G41 D1 G1 X10. F100.", "X20.", "G28 X30.", "G40 X60.",
    setup=MILL | HOME | {"radius_offsets": {1: 3}}, source="general knowledge",
    centre="X10 Y3 | X20 Y3 | X30 Y0 | X0 Y0 | X60 Y0",
)

# Units, rotation, scaling, mirror
moves(
    "in inches a rotary axis stays in degrees", [*FANUC, MDI, *MITSUBISHI],
    "G20", "G90 G0 X1. A90.", source="30i p.226", evidence="inferred", setup=MILL,
    moves="R X25.4 A90",
)
moves(
    "in inches G10 and G92 take inches", [*FANUC, *MITSUBISHI],
    "G20", "G90 G10 L2 P1 X1.", "G0 X0", "G92 Y2.", "G0 Y0", source="30i p.226",
    evidence="inferred", setup=MILL, centre="X25.4 Y0 | X25.4 Y-50.8",
)
moves(
    "a rotation without a centre turns about the present point", POLAR,
    "G90 G0 X5. Y5.", "G68 R90.", "G1 X10. Y5. F100.", setup=MILL, moves="R X5 Y5\nF X5 Y10",
)
moves(
    "increments are turned as well", [*FANUC, *MITSUBISHI],
    "G90 G68 X0 Y0 R90.", "G91 G1 X10. F100.", "X5.", "G69", "X5.", setup=MILL,
    moves="F X0 Y10\nF X0 Y15\nF X5 Y15",
)
moves(
    "a scaling grows away from its centre", FANUC,
    "G90 G51 X10. Y0 P2000", "G1 X20. Y5. F100.", "G50", "X20.", setup=MILL,
    moves="F X30 Y10\nF X20 Y10",
)
for _x, _y in ((0, 0), (140.756, 0.125), (500.5, -77.003)):
    moves(
        f"a round between an arc and the line back along its tangent is cut wherever it lies, X{_x} Y{_y} too",
        [*FANUC, *MITSUBISHI], f"G90 G17 G0 X{_x:.3f} Y{_y:.3f}", f"G3 X{_x - 5.393:.3f} Y{_y + 5.393:.3f} I-5.393 J0. ,R0.881 F200",
        f"G1 X{_x + 5.62:.3f}", setup=MILL,
        moves=f"R X{_x} Y{_y}\nCCW X{_x - 1.645695:.6f} Y{_y + 3.878421:.6f} C X{_x - 5.393:.3f} Y{_y}"
        f"\nCW X{_x - 1.033535:.6f} Y{_y + 5.393:.3f} C X{_x - 1.033535:.6f} Y{_y + 4.512:.3f}\nF X{_x + 5.62:.3f} Y{_y + 5.393:.3f}",
    )
moves(
    "a round between a line and the arc back along it is cut where the arc turns away", [*FANUC, *MITSUBISHI],
    "G90 G17 G0 X0 Y0", "G1 X10. ,R.557 F200", "G3 X5.299 Y-4.701 I0 J-4.701", setup=MILL,
    moves="R X0 Y0\nF X6.763671 Y0\nCW X7.106507 Y-.995990 C X6.763671 Y-.557\nCCW X5.299 Y-4.701 C X10 Y-4.701",
)
moves(
    "a point is mirrored first, then scaled, then turned, the other way where one axis is mirrored", FANUC,
    "G90 G51.1 X0", "G51 X0 Y0 P2000", "G68 X0 Y0 R90.", "G1 X10. Y0 F100.", setup=MILL,
    moves="F X0 Y20",
)
moves(
    "a mirror in both axes of the plane leaves the direction of rotation", FANUC,
    "G90 G51.1 X0 Y0", "G68 X0 Y0 R90.", "G1 X10. Y0 F100.", setup=MILL,
    moves="F X0 Y-10",
)
moves(
    "G50.1 ends the mirror of the axis it names", [*FANUC, *MITSUBISHI, MDI],
    "G90 G51.1 X0 Y0", "G1 X10. Y5. F100.", "G50.1 X0", "X10. Y5.", setup=MILL,
    moves="F X-10 Y-5\nF X10 Y-5",
)
moves(
    "G24 of the HNC-21 mirrors at the value of its axis, G25 ends it", HNC,
    "G90 G24 X5", "G1 X10 Y5 F100", "G25 X5", "X10 Y5", setup=MILL, moves="F X0 Y5\nF X10 Y5",
)
moves(
    "the table of the manual: G68.1 turns the point with its X halved", GSK_988,
    "G68.1 X40 Z20 R45", "G0 X10 Z10", "X28.284", "X20 Z10", source="TA 5",
    evidence="maker's manual", setup=LATHE,
    moves="R X54.142 Z20\nR X67.071 Z7.071\nR X61.213 Z12.929",
)

# ---- states that an earlier block or the power-on leaves ----
case(
    "with 3402#3 the first block after power-on is incremental",
    control="fanuc-30i", source="TApar 3402#3; FANUC: general knowledge",
    evidence="inferred", setup=MILL, params={"3402#3": 1},
    program="O1\nN10 G0 X5.\nN20 X5.\nN30 M30\n", moves="R X5\nR X10",
)
case(
    "a Mitsubishi that wakes up in G91 counts the first block from where it stands",
    control="mitsubishi-m700", source="general knowledge", evidence="inferred", setup=MILL,
    replace={"power_on": "G91"},
    program="O1\nN10 G0 X5.\nN20 X5.\nN30 M30\n", moves="R X5\nR X10",
)
case(
    "G01 beside G52 holds for the blocks after", control=[*FANUC, *MITSUBISHI],
    source="general knowledge: a code of group 01 is modal", evidence="inferred", setup=MILL,
    program="O1\nN10 G0 X1.\nN20 G1 G52 X0 F100.\nN30 X10.\nN40 M30\n", moves="R X1\nF X10",
)
