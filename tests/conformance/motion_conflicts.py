"""What does not go together: a code with another, or with the state that it meets."""

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


def refused(claim, control, first, second, cause, number, source, setup=MILL, evidence=None):
    """The second block alarms behind the first, which does not."""
    evidence = evidence or ("maker's manual" if source.startswith(("MDib", "TA")) else "secondary")
    case(
        claim, control=control, source=source, evidence=evidence, setup=setup,
        pins="max_extra_systems",
        program=f"O1\nN10 {first}\nN20 {second}\nN30 M30",
        runs="N10", alarm=cause, number=number, at="O1 N20",
    )


def taken(claim, control, first, second, setup=MILL):
    """The second block runs behind the first."""
    case(
        claim, control=control, source="no alarm is known", evidence="inferred", setup=setup,
        pins="refuses set_coordinate_alarms",
        program=f"O1\nN10 {first}\nN20 {second}\nN30 M30",
        runs="N10 N20 N30",
    )


# The mill of GSK, whose list of alarms names them all.

for _claim, _first, _second, _cause, _number in (
    ("a tool change alarms in polar coordinates", "G17 G16", "T2", "tool-in-polar", "0188"),
    ("a chamfer alarms in polar coordinates", "G17 G16",
     "G01 X10 Y10 ,C2 F100", "corner-in-polar", "0185"),
    ("a canned cycle outside G17 alarms in polar coordinates", "G18 G16",
     "G81 X10 Z10 Y-5 R2 F100", "cycle-plane-in-polar", "0163"),
    ("G20 alarms in polar coordinates", "G16", "G20", "units-in-rotation", "0161"),
    ("G92 alarms in a rotation", "G68 X0 Y0 R30", "G92 X0",
     "coordinate-setting-in-rotation", "0151"),
    ("G54 alarms in a rotation", "G68 X0 Y0 R30", "G54", "work-system-in-rotation", "0153"),
    ("G52 alarms in a mirror", "G51.1 X0", "G52 X0", "work-system-in-rotation", "0153"),
    ("G53 alarms in scaling", "G51 X0 Y0 P2", "G53 X0", "work-system-in-rotation", "0153"),
    ("G43 alarms in a rotation", "G68 X0 Y0 R30", "G43 H1", "length-in-rotation", "0149"),
    ("H alarms in scaling", "G51 X0 Y0 P2", "H1", "length-in-rotation", "0149"),
    ("G17 alarms in a mirror", "G51.1 X0", "G17", "plane-change-in-mirror", "0154"),
    ("G28 alarms in scaling", "G51 X0 Y0 P2", "G28 Z0", "reference-return-in-mirror", "0152"),
    ("a mirror alarms in scaling", "G51 X0 Y0 P2", "G51.1 X0", "mirror-in-rotation", "0159"),
    ("a mirror alarms in a rotation", "G68 X0 Y0 R30", "G51.1 X0", "mirror-in-rotation", "0159"),
    ("G10 of a work system alarms in a rotation", "G68 X0 Y0 R30", "G10 L2 P1 X1",
     "data-in-rotation", "0243"),
    ("a pocket cycle alarms in a rotation", "G68 X0 Y0 R30", "G110 Z-5 R2 I20 F100",
     "cycle-in-rotation", "0162"),
    ("a rotation in a block with G01 alarms", "G0 X0", "G01 G68 X0 Y0 R30",
     "codes-with-rotation", "0150"),
    ("a rotation in a block with G43 alarms", "G0 X0", "G43 H1 G68 X0 Y0 R30",
     "codes-with-rotation", "0150"),
    ("a rotation and a mirror in one block alarm", "G0 X0", "G51.1 X0 G68 Y0 R30",
     "codes-with-rotation", "0150"),
    ("a rotation in a canned cycle outside G17 alarms", "G18 G81 X10 Z10 Y-5 R2 F100",
     "G68 X0 Z0 R30", "rotation-plane-in-cycle", "0160"),
    ("G52 in a block with G43 alarms", "G0 X0", "G52 X0 G43 H1", "local-with-length", "0046"),
    ("a negative scale alarms", "G0 X0", "G51 X0 Y0 P-2", "scale-negative", "0140"),
    ("L and K in one canned cycle alarm", "G0 X0", "G81 X10 Z-5 R2 F100 L2 K3",
     "cycle-repeats-twice", "0204"),
    ("a pattern of holes without a drilling cycle alarms", "G0 X0", "G140 X10 Y10 I5",
     "pattern-without-cycle", "0216"),
    ("tapping without a lead alarms", "G0 X0 S100", "G84 X10 Z-5 R2", "tap-without-lead", "0218"),
    ("a helix without travel in its plane alarms", "G0 X0", "G03 Z-5 R10 F100",
     "helix-without-travel", "0032"),
    ("a chamfer in a helix alarms", "G0 X0", "G02 X10 Y0 R5 Z5 L2 F100",
     "corner-in-helix", "0278"),
    ("L and U in one block alarm", "G0 X0", "G01 X10 L2 U2 F100", "corner-format", "0093"),
    ("there is no P49 of G10 L20", "G0 X0", "G10 L20 P49 X1", "g10-system-number", "0239"),
    ("there is no P49 of G54.1", "G0 X0", "G54.1 P49", "work-system", "0240"),
    ("there is no offset P33 of G10", "G0 X0", "G10 L10 P33 R1", "g10-offset-number", "0242"),
    ("G10 without L alarms", "G0 X0", "G10 P1 X1", "g10-word-missing", "0246"),
    ("G10 without P alarms", "G0 X0", "G10 L10 R1", "g10-word-missing", "0246"),
    ("G10 L2 without an axis alarms", "G0 X0", "G10 L2 P1", "g10-axis-missing", "0247"),
    ("G10 L10 without R alarms", "G0 X0", "G10 L10 P1", "g10-value-missing", "0248"),
):
    refused(f"{_claim} on the 980MDi", MDI, _first, _second, _cause, _number, f"MDib {_number}")

refused(
    "a chamfer in the block of G41 alarms on the 980MDi", MDI, "G0 X0", "G41 G01 X10 D1 F100 L1",
    "corner-at-offset-start", "0039", "MDib 0039", RADIUS,
)
for _claim, _first, _second in (
    ("a tool may be changed in polar coordinates", "G17 G16", "T2"),
    ("G92 may stand in a rotation", "G68 X0 Y0 R30.", "G92 X0"),
    ("G54 may stand in a rotation", "G68 X0 Y0 R30.", "G54"),
    ("G43 may stand in a rotation", "G68 X0 Y0 R30.", "G43 H1"),
    ("G17 may stand in a mirror", "G51.1 X0", "G17"),
    ("a rotation may share a block with G01", "G0 X0", "G01 G68 X0 Y0 R30."),
    ("G52 may share a block with G43", "G0 X0", "G52 X0 G43 H1"),
    ("G10 L2 without an axis changes nothing", "G0 X0", "G10 L2 P1"),
):
    taken(_claim, [*FANUC, *MITSUBISHI], _first, _second)
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
    "corner-at-offset-start", on_fanuc("039"), "ALM 039", RADIUS,
)
case(
    "a chamfer in the block of G41 is cut on a Mitsubishi",
    control=MITSUBISHI, source="no alarm is known", evidence="inferred", setup=RADIUS,
    program="O1\nN10 G41 G1 X20. D1 F100 ,C2.\nN20 Y20.\nN30 Y30.\nN40 M30",
    runs="N10 N20 N30 N40",
)
for _code in "G04 P1", "G10 P1 X1.", "G50 X1.":
    case(
        f"T in a block with {_code} alarms while 5006#1 is 1",
        control=[*FANUC, *GSK_988], source="ALM 245; Talm 028", evidence="secondary",
        params={"5006#1": 1}, setup=LATHE,
        program=f"O1\nN10 G0 X0\nN20 T0101 {_code}\nN30 M30",
        runs="N10", alarm="tool-with-setting",
        number=on_fanuc("245") | dict.fromkeys(GSK_988, "028"), at="O1 N20",
    )
    taken(
        f"T may share a block with {_code} while 5006#1 is 0", [*FANUC, *GSK_988],
        "G0 X0", f"T0101 {_code}", LATHE,
    )
for _claim, _block, _cause in (
    ("G10 L20 has no P49", "G10 L20 P49 X1.", "g10-system-number"),
    ("G10 L10 has no P401", "G10 L10 P401 R1.", "g10-offset-number"),
    ("G10 L10 needs R", "G10 L10 P1", "g10-value-missing"),
):
    refused(
        f"{_claim} on a FANUC", FANUC, "G0 X0", _block, _cause, on_fanuc("031"), "ALM 031",
    )

# Mitsubishi

refused(
    "G52 alarms while G54.1 is in force on a Mitsubishi", MITSUBISHI, "G54.1 P1", "G52 X10.",
    "local-in-extra-system", "P438", "MZ 949, paired",
)
taken("G52 may stand in a work system of G54.1", FANUC, "G54.1 P1", "G52 X10.")
refused(
    "G29 in a block with M05 alarms on a Mitsubishi", MITSUBISHI, "G28 X0", "G29 X10. M05",
    "reference-with-m", "P436", "MZ 921, paired",
)
taken("G29 may share a block with M05", [*FANUC, HNC], "G28 X0", "G29 X10. M05")
refused(
    "tapping without S alarms on a Mitsubishi", MITSUBISHI, "G0 X0 F100", "G84 X10. Z-5. R2.",
    "tap-without-speed", "P181", "MZ 906, paired",
)
refused(
    "tapping without F alarms on a Mitsubishi", MITSUBISHI, "G0 X0 S500", "G84 X10. Z-5. R2.",
    "tap-without-lead", "P183", "MZ 908, paired",
)
refused(
    "tapping without F is a cut without F on a FANUC", FANUC, "G0 X0", "G84 X10. Z-5. R2.",
    "no-feed", on_fanuc("011"), "ALM 011",
)

# The 988: a rotation of a lathe.

refused(
    "a rotation in a block with G54 alarms on the 988", GSK_988, "G0 X0", "G54 G68.1 X0 Z0 R30",
    "codes-with-rotation", None, "TA 5 note 2", LATHE,
)
for _code in "G28 U0", "G50 X0", "G54", "G04 P1", "G32 Z-5 F1", "G90 X1 Z-5":
    refused(
        f"{_code} alarms in a rotation of the 988", GSK_988, "G68.1 X0 Z0 R30", _code,
        "code-in-rotation", None, "TA 5 note 3", LATHE,
    )
for _code in "G98 G1 X10 F100", "G69.1", "G18", "G80":
    taken(f"{_code} may stand in a rotation of the 988", GSK_988, "G68.1 X0 Z0 R30", _code, LATHE)
case(
    "a chamfer in the block of G41 alarms on the 988",
    pins="chamfer_words",
    control=GSK_988, source="Talm 271", evidence="secondary", setup=LATHE,
    program="O1\nN10 G0 X0\nN20 G41 G01 X10 F100 ,C1\nN30 Z-10\nN40 M30",
    runs="N10", alarm="corner-at-offset-start", number="271", at="O1 N20",
)

# Dwells

case(
    "G04 D1 of the 928 waits a second",
    control=TE, source="928Ti", evidence="secondary",
    program="O1\nN10 G4 D1\nN20 M02",
    moves="W 1",
)
for _words, _seconds in {"P1000 X2 U3": 1, "X2 U3": 2, "U1.5": 1.5}.items():
    case(
        f"G04 {_words} waits {_seconds} s: P counts before X, X before U",
        control=TDI, source="TDi 14", evidence="maker's manual",
        program=f"O1\nN10 G4 {_words}\nN20 M30",
        moves=f"W {_seconds}",
    )
for _words in "P-100", "X-1", "":
    case(
        f"G04 {_words or 'alone'} does not wait",
        control=TDI, source="TDi 14", evidence="maker's manual",
        program=f"O1\nN10 G4 {_words}\nN20 M30",
        runs="N10 N20", moves="none",
    )

# A code that the alarm list proves.

case(
    "G27 alarms where it does not reach the reference point of the 988",
    control=GSK_988, source="Talm 045", evidence="secondary",
    setup=LATHE | {"reference": {1: {"X": 0, "Z": 0}}},
    program="O1\nN10 G27 X0\nN20 G27 X10\nN30 M30",
    runs="N10", alarm="not-at-reference", number="045", at="O1 N20",
)
