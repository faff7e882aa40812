"""Codes that do not go together with another code, or with the state that they meet."""

from conformance import case

MDI, TDI, TE = "gsk-980mdi", "gsk-980tdi", "gsk-928te"
GSK_988 = ["gsk-988ta", "gsk-988t"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC = "hnc-21m"
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
RADIUS = MILL | {"radius_offsets": {1: 3}}


def on_fanuc(number):
    return {F16: number, **dict.fromkeys(FANUC_PS, f"PS0{number}")}


def refused(
    claim, control, first, second, cause, number, source, setup=MILL, evidence=None, word=None,
    pins="max_extra_systems",
):
    """Write a row: the first block runs, the second alarms."""
    evidence = evidence or ("maker's manual" if source.startswith(("MDib", "TA")) else "secondary")
    case(
        claim, control=control, source=source, evidence=evidence, setup=setup,
        pins=pins,
        program=f"O1\nN10 {first}\nN20 {second}\nN30 M30",
        runs="N10", alarm=cause, number=number, at="O1 N20", word=word,
    )


def taken(claim, control, first, second, setup=MILL):
    """Write a row: the second block runs after the first."""
    case(
        claim, control=control, source="no alarm is known", evidence="inferred", setup=setup,
        pins="refuses refuses:coordinate-setting-refused",
        program=f"O1\nN10 {first}\nN20 {second}\nN30 M30",
        runs="N10 N20 N30",
    )


# The mill of GSK; its list of alarms names all of these.
refused(
    "a tool change alarms in polar coordinates on the 980MDi",
    MDI, "G17 G16", "T2", "tool-in-polar", "0188", "MDib 0188", word="T2",
)
refused(
    "a chamfer alarms in polar coordinates on the 980MDi",
    MDI, "G17 G16", "G01 X10 Y10 ,C2 F100", "corner-in-polar", "0185", "MDib 0185", word=",C2",
)
refused(
    "a canned cycle outside G17 alarms in polar coordinates on the 980MDi",
    MDI, "G18 G16", "G81 X10 Z10 Y-5 R2 F100", "cycle-plane-in-polar", "0163", "MDib 0163", word="G81",
)
refused(
    "G20 alarms in polar coordinates on the 980MDi",
    MDI, "G16", "G20", "units-in-rotation", "0161", "MDib 0161", word="G20",
)
refused(
    "G92 alarms in a rotation on the 980MDi",
    MDI, "G68 X0 Y0 R30", "G92 X0", "coordinate-setting-in-rotation", "0151", "MDib 0151", word="G92",
)
refused(
    "G54 alarms in a rotation on the 980MDi",
    MDI, "G68 X0 Y0 R30", "G54", "work-system-in-rotation", "0153", "MDib 0153", word="G54",
)
refused(
    "G52 alarms in a mirror on the 980MDi",
    MDI, "G51.1 X0", "G52 X0", "work-system-in-rotation", "0153", "MDib 0153", word="G52",
)
refused(
    "G53 alarms in scaling on the 980MDi",
    MDI, "G51 X0 Y0 P2", "G53 X0", "work-system-in-rotation", "0153", "MDib 0153", word="G53",
)
refused(
    "G43 alarms in a rotation on the 980MDi",
    MDI, "G68 X0 Y0 R30", "G43 H1", "length-in-rotation", "0149", "MDib 0149", word="G43",
)
refused(
    "H alarms in scaling on the 980MDi",
    MDI, "G51 X0 Y0 P2", "H1", "length-in-rotation", "0149", "MDib 0149", word="H1",
)
refused(
    "G17 alarms in a mirror on the 980MDi",
    MDI, "G51.1 X0", "G17", "plane-change-in-mirror", "0154", "MDib 0154", word="G17",
)
refused(
    "G28 alarms in scaling on the 980MDi",
    MDI, "G51 X0 Y0 P2", "G28 Z0", "reference-return-in-mirror", "0152", "MDib 0152", word="G28",
)
refused(
    "a mirror alarms in scaling on the 980MDi",
    MDI, "G51 X0 Y0 P2", "G51.1 X0", "mirror-in-rotation", "0159", "MDib 0159", word="G51.1",
)
refused(
    "a mirror alarms in a rotation on the 980MDi",
    MDI, "G68 X0 Y0 R30", "G51.1 X0", "mirror-in-rotation", "0159", "MDib 0159", word="G51.1",
)
refused(
    "G10 of a work system alarms in a rotation on the 980MDi",
    MDI, "G68 X0 Y0 R30", "G10 L2 P1 X1", "data-in-rotation", "0243", "MDib 0243", word="G10",
)
refused(
    "a pocket cycle alarms in a rotation on the 980MDi",
    MDI, "G68 X0 Y0 R30", "G110 Z-5 R2 I20 F100", "cycle-in-rotation", "0162", "MDib 0162", word="G110",
    pins="codes_not_turned",
)
refused(
    "a rotation in a block with G01 alarms on the 980MDi",
    MDI, "G0 X0", "G01 G68 X0 Y0 R30", "codes-with-rotation", "0150", "MDib 0150", word="G68",
)
refused(
    "a rotation in a block with G43 alarms on the 980MDi",
    MDI, "G0 X0", "G43 H1 G68 X0 Y0 R30", "codes-with-rotation", "0150", "MDib 0150", word="G68",
)
refused(
    "a rotation and a mirror in one block alarm on the 980MDi",
    MDI, "G0 X0", "G51.1 X0 G68 Y0 R30", "codes-with-rotation", "0150", "MDib 0150", word="G51.1",
)
refused(
    "a rotation in a canned cycle outside G17 alarms on the 980MDi",
    MDI, "G18 G81 X10 Z10 Y-5 R2 F100", "G68 X0 Z0 R30", "rotation-plane-in-cycle", "0160",
    "MDib 0160", word="G68",
)
refused(
    "G52 in a block with G43 alarms on the 980MDi",
    MDI, "G0 X0", "G52 X0 G43 H1", "local-with-length", "0046", "MDib 0046", word="G52",
)
refused(
    "a negative scale alarms on the 980MDi",
    MDI, "G0 X0", "G51 X0 Y0 P-2", "scale-negative", "0140", "MDib 0140", word="P-2",
)
refused(
    "L and K in one canned cycle alarm on the 980MDi",
    MDI, "G0 X0", "G81 X10 Z-5 R2 F100 L2 K3", "cycle-repeats-twice", "0204", "MDib 0204", word="L2",
)
refused(
    "a pattern of holes without a drilling cycle alarms on the 980MDi",
    MDI, "G0 X0", "G140 X10 Y10 I5", "pattern-without-cycle", "0216", "MDib 0216", word="G140",
    pins="pattern_codes",
)
refused(
    "tapping without a lead alarms on the 980MDi",
    MDI, "G0 X0 S100", "G84 X10 Z-5 R2", "tap-without-lead", "0218", "MDib 0218", word="G84",
)
refused(
    "a helix without travel in its plane alarms on the 980MDi",
    MDI, "G0 X0", "G03 Z-5 R10 F100", "helix-without-travel", "0032", "MDib 0032", word="G03",
)
refused(
    "a chamfer in a helix alarms on the 980MDi",
    MDI, "G0 X0", "G02 X10 Y0 R5 Z5 L2 F100", "corner-in-helix", "0278", "MDib 0278", word="L2",
)
refused(
    "L and U in one block alarm on the 980MDi",
    MDI, "G0 X0", "G01 X10 L2 U2 F100", "corner-format", "0093", "MDib 0093", word="U2",
)
refused(
    "there is no P49 of G10 L20 on the 980MDi",
    MDI, "G0 X0", "G10 L20 P49 X1", "g10-system-number", "0239", "MDib 0239", word="P49",
)
refused(
    "there is no P49 of G54.1 on the 980MDi",
    MDI, "G0 X0", "G54.1 P49", "work-system", "0240", "MDib 0240", word="P49",
)
refused(
    "there is no offset P33 of G10 on the 980MDi",
    MDI, "G0 X0", "G10 L10 P33 R1", "g10-offset-number", "0242", "MDib 0242", word="P33",
)
refused(
    "G10 without L alarms on the 980MDi",
    MDI, "G0 X0", "G10 P1 X1", "g10-word-missing", "0246", "MDib 0246", word="G10",
)
refused(
    "G10 without P alarms on the 980MDi",
    MDI, "G0 X0", "G10 L10 R1", "g10-word-missing", "0246", "MDib 0246", word="G10",
)
refused(
    "G10 L2 without an axis alarms on the 980MDi",
    MDI, "G0 X0", "G10 L2 P1", "g10-axis-missing", "0247", "MDib 0247", word="G10",
)
refused(
    "G10 L10 without R alarms on the 980MDi",
    MDI, "G0 X0", "G10 L10 P1", "g10-value-missing", "0248", "MDib 0248", word="G10",
)
refused(
    "a chamfer in the block of G41 alarms on the 980MDi", MDI, "G0 X0", "G41 G01 X10 D1 F100 L1",
    "corner-at-offset-start", "0039", "MDib 0039", RADIUS, word="L1",
)
taken("a tool may be changed in polar coordinates", [*FANUC, *MITSUBISHI], "G17 G16", "T2")
taken("G92 may stand in a rotation", [*FANUC, *MITSUBISHI], "G68 X0 Y0 R30.", "G92 X0")
taken("G54 may stand in a rotation", [*FANUC, *MITSUBISHI], "G68 X0 Y0 R30.", "G54")
taken("G43 may stand in a rotation", [*FANUC, *MITSUBISHI], "G68 X0 Y0 R30.", "G43 H1")
taken("G17 may stand in a mirror", [*FANUC, *MITSUBISHI], "G51.1 X0", "G17")
taken("a rotation may share a block with G01", [*FANUC, *MITSUBISHI], "G0 X0", "G01 G68 X0 Y0 R30.")
taken("G52 may share a block with G43", [*FANUC, *MITSUBISHI], "G0 X0", "G52 X0 G43 H1")
taken("G10 L2 without an axis changes nothing", [*FANUC, *MITSUBISHI], "G0 X0", "G10 L2 P1")
taken("a mirror may begin in scaling", [*FANUC, *MITSUBISHI], "G51 X0 Y0 P2000", "G51.1 X0")
taken("a negative scale is a scale and a mirror", FANUC, "G0 X0", "G51 X0 Y0 Z0 I-2000 J1000 K1000")
case(
    "U is the radius of a corner round on the 980MDi",
    control=MDI, source="MDib 0093: L and U of a corner", evidence="maker's manual", setup=MILL,
    program="O1\nN10 G1 X50. U5. F100\nN20 Y50.\nN30 M30",
    moves="F X45 Y0\nCCW X50 Y5 C X45 Y5\nF Y50",
)

# FANUC
refused(
    "a chamfer in the block of G41 alarms on a FANUC", FANUC, "G0 X0", "G41 G01 X10. D1 F100 ,C1.",
    "corner-at-offset-start", on_fanuc("039"), "ALM 039", RADIUS, word=",C1.",
)
case(
    "a chamfer in the block of G41 is cut on a Mitsubishi",
    control=MITSUBISHI, source="no alarm is known", evidence="inferred", setup=RADIUS,
    program="O1\nN10 G41 G1 X20. D1 F100 ,C2.\nN20 Y20.\nN30 Y30.\nN40 M30",
    runs="N10 N20 N30 N40",
)
case(
    "T in a block with G04 P1 alarms while 5006#1 is 1",
    control=[*FANUC, *GSK_988], source="ALM 245; Talm 028", evidence="secondary",
    params={"5006#1": 1}, setup=LATHE,
    program="O1\nN10 G0 X0\nN20 T0101 G04 P1\nN30 M30",
    runs="N10", alarm="tool-with-setting", number=on_fanuc("245") | dict.fromkeys(GSK_988, "028"),
    at="O1 N20", word="T0101",
)
taken(
    "T may share a block with G04 P1 while 5006#1 is 0",
    [*FANUC, *GSK_988], "G0 X0", "T0101 G04 P1", LATHE,
)
case(
    "T in a block with G10 P1 X1. alarms while 5006#1 is 1",
    control=[*FANUC, *GSK_988], source="ALM 245; Talm 028", evidence="secondary",
    params={"5006#1": 1}, setup=LATHE,
    program="O1\nN10 G0 X0\nN20 T0101 G10 P1 X1.\nN30 M30",
    runs="N10", alarm="tool-with-setting", number=on_fanuc("245") | dict.fromkeys(GSK_988, "028"),
    at="O1 N20", word="T0101",
)
taken(
    "T may share a block with G10 P1 X1. while 5006#1 is 0",
    [*FANUC, *GSK_988], "G0 X0", "T0101 G10 P1 X1.", LATHE,
)
case(
    "T in a block with G50 X1. alarms while 5006#1 is 1",
    control=[*FANUC, *GSK_988], source="ALM 245; Talm 028", evidence="secondary",
    params={"5006#1": 1}, setup=LATHE,
    program="O1\nN10 G0 X0\nN20 T0101 G50 X1.\nN30 M30",
    runs="N10", alarm="tool-with-setting", number=on_fanuc("245") | dict.fromkeys(GSK_988, "028"),
    at="O1 N20", word="T0101",
)
taken(
    "T may share a block with G50 X1. while 5006#1 is 0",
    [*FANUC, *GSK_988], "G0 X0", "T0101 G50 X1.", LATHE,
)
refused(
    "G10 L20 has no P49 on a FANUC",
    FANUC, "G0 X0", "G10 L20 P49 X1.", "g10-system-number", on_fanuc("031"), "ALM 031", word="P49",
)
refused(
    "G10 L10 has no P401 on a FANUC",
    FANUC, "G0 X0", "G10 L10 P401 R1.", "g10-offset-number", on_fanuc("031"), "ALM 031", word="P401",
)
refused(
    "G10 L10 needs R on a FANUC",
    FANUC, "G0 X0", "G10 L10 P1", "g10-value-missing", on_fanuc("031"), "ALM 031", word="G10",
)

# Mitsubishi
refused(
    "G52 alarms while G54.1 is in force on a Mitsubishi", MITSUBISHI, "G54.1 P1", "G52 X10.",
    "local-in-extra-system", "P438", "MZ 949, paired", word="G52",
)
taken("G52 may stand in a work system of G54.1", FANUC, "G54.1 P1", "G52 X10.")
refused(
    "G29 in a block with M05 alarms on a Mitsubishi", MITSUBISHI, "G28 X0", "G29 X10. M05",
    "reference-with-m", "P436", "MZ 921, paired", word="M05",
)
taken("G29 may share a block with M05", [*FANUC, HNC], "G28 X0", "G29 X10. M05")
refused(
    "tapping without S alarms on a Mitsubishi", MITSUBISHI, "G0 X0 F100", "G84 X10. Z-5. R2.",
    "tap-without-speed", "P181", "MZ 906, paired", word="G84",
)
refused(
    "tapping without F alarms on a Mitsubishi", MITSUBISHI, "G0 X0 S500", "G84 X10. Z-5. R2.",
    "tap-without-lead", "P183", "MZ 908, paired", word="G84",
)
refused(
    "tapping without F is a cut without F on a FANUC", FANUC, "G0 X0", "G84 X10. Z-5. R2.",
    "no-feed", on_fanuc("011"), "ALM 011", word="G84",
)

# The 988: a rotation of a lathe.
refused(
    "a rotation in a block with G54 alarms on the 988", GSK_988, "G0 X0", "G54 G68.1 X0 Z0 R30",
    "codes-with-rotation", None, "TA 5 note 2", LATHE, word="G68.1",
)
refused(
    "G28 U0 alarms in a rotation of the 988",
    GSK_988, "G68.1 X0 Z0 R30", "G28 U0", "code-in-rotation", None, "TA 5 note 3", LATHE, word="G28",
)
refused(
    "G50 X0 alarms in a rotation of the 988",
    GSK_988, "G68.1 X0 Z0 R30", "G50 X0", "code-in-rotation", None, "TA 5 note 3", LATHE, word="G50",
)
refused(
    "G54 alarms in a rotation of the 988",
    GSK_988, "G68.1 X0 Z0 R30", "G54", "code-in-rotation", None, "TA 5 note 3", LATHE, word="G54",
)
refused(
    "G04 P1 alarms in a rotation of the 988",
    GSK_988, "G68.1 X0 Z0 R30", "G04 P1", "code-in-rotation", None, "TA 5 note 3", LATHE, word="G04",
)
refused(
    "G32 Z-5 F1 alarms in a rotation of the 988",
    GSK_988, "G68.1 X0 Z0 R30", "G32 Z-5 F1", "code-in-rotation", None, "TA 5 note 3", LATHE, word="G32",
)
refused(
    "G90 X1 Z-5 alarms in a rotation of the 988",
    GSK_988, "G68.1 X0 Z0 R30", "G90 X1 Z-5", "code-in-rotation", None, "TA 5 note 3", LATHE, word="G90",
)
taken(
    "G98 G1 X10 F100 may stand in a rotation of the 988",
    GSK_988, "G68.1 X0 Z0 R30", "G98 G1 X10 F100", LATHE,
)
taken("G69.1 may stand in a rotation of the 988", GSK_988, "G68.1 X0 Z0 R30", "G69.1", LATHE)
taken("G18 may stand in a rotation of the 988", GSK_988, "G68.1 X0 Z0 R30", "G18", LATHE)
taken("G80 may stand in a rotation of the 988", GSK_988, "G68.1 X0 Z0 R30", "G80", LATHE)
case(
    "a chamfer in the block of G41 alarms on the 988",
    pins="chamfer_words",
    control=GSK_988, source="Talm 271", evidence="secondary", setup=LATHE,
    program="O1\nN10 G0 X0\nN20 G41 G01 X10 F100 ,C1\nN30 Z-10\nN40 M30",
    runs="N10", alarm="corner-at-offset-start", number="271", at="O1 N20", word=",C1",
)

# Dwells
case(
    "G04 D1 of the 928 waits a second",
    control=TE, source="928Ti", evidence="secondary",
    program="O1\nN10 G4 D1\nN20 M02",
    moves="W 1",
)
case(
    "G04 P1000 X2 U3 waits 1 s: P counts before X, X before U",
    control=TDI, source="TDi 14", evidence="maker's manual",
    program="O1\nN10 G4 P1000 X2 U3\nN20 M30",
    moves="W 1",
)
case(
    "G04 X2 U3 waits 2 s: P counts before X, X before U",
    control=TDI, source="TDi 14", evidence="maker's manual",
    program="O1\nN10 G4 X2 U3\nN20 M30",
    moves="W 2",
)
case(
    "G04 U1.5 waits 1.5 s: P counts before X, X before U",
    control=TDI, source="TDi 14", evidence="maker's manual",
    program="O1\nN10 G4 U1.5\nN20 M30",
    moves="W 1.5",
)
case(
    "G04 P-100 does not wait",
    control=TDI, source="TDi 14", evidence="maker's manual",
    program="O1\nN10 G4 P-100\nN20 M30",
    runs="N10 N20", moves="none",
)
case(
    "G04 X-1 does not wait",
    control=TDI, source="TDi 14", evidence="maker's manual",
    program="O1\nN10 G4 X-1\nN20 M30",
    runs="N10 N20", moves="none",
)
case(
    "G04 alone does not wait",
    control=TDI, source="TDi 14", evidence="maker's manual",
    program="O1\nN10 G4 \nN20 M30",
    runs="N10 N20", moves="none",
)

# A code that the alarm list proves to exist.
case(
    "G27 alarms where it does not reach the reference point of the 988",
    control=GSK_988, source="Talm 045", evidence="secondary",
    setup=LATHE | {"reference": {1: {"X": 0, "Z": 0}}},
    program="O1\nN10 G27 X0\nN20 G27 X10\nN30 M30",
    runs="N10 N20", alarm="not-at-reference", number="045", at="O1 N20", word="X10", final_work="X10",
)
