"""SINUMERIK: MEAS, and what is kept of where the probe switched."""

from conformance import case

MEAS = {"control": "siemens-one", "source": "840slj p.5-24: MEAS", "evidence": "secondary"}
KNOWN = {"control": "siemens-one", "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
OFFSETS = {"setup": {"work_offsets": {"G54": {"X": 100.125, "Y": -20.25, "Z": 3.375}}, "start": {"X": 0, "Y": 0, "Z": 0}}}

case(
    "a measuring line ends where the probe switches", **MEAS, **OFFSETS, inputs={"skips": [0.25]},
    program="N10 G54 G1 F100 X10\nN20 MEAS=1 X50\nN30 Y5\nN40 M30", moves="F X10\nF X20\nF Y5", final_work="X20 Y5 Z0",
)
case(
    "$AA_MW is the measured point in the workpiece, $AA_MM in the machine, and both stay", **MEAS, **OFFSETS, inputs={"skips": [{"Z": -4}]},
    program="N10 G54 G1 F100 Z10\nN20 MEAS=-1 Z-10\nN30 G0 Z50\nN40 R1=$AA_MW[Z] R2=$AA_MM[Z] R3=$AC_MEA[1]\nN50 M30",
    vars={1: -4, 2: -0.625, 3: 1},
)
case(
    "axes that the measuring block does not name keep what was measured before", **MEAS, **OFFSETS, inputs={"skips": [{"X": 3}, {"Y": 4}]},
    program="N10 G54 G1 F100 MEAS=1 X50\nN20 MEAS=1 Y50\nN30 R1=$AA_MW[X] R2=$AA_MW[Y] R3=$AA_MM[X]\nN40 MEAS=1 X9\nN50 R4=$AA_MW[X] R5=$AA_MW[Y]\nN60 M30",
    vars={1: 3, 2: 4, 3: 103.125, 4: 9, 5: 4},
)
case(
    "a probe that does not switch: the line goes to its end, and $AC_MEA says so", **KNOWN, **OFFSETS, inputs={"skips": []},
    program="N10 G54 G1 F100 MEAS=1 X50\nN20 IF $AC_MEA[1]\nN30 R1=1\nN40 ELSE\nN50 R1=2\nN60 ENDIF\nN70 M30", vars={1: 2}, final_work="X50 Y0 Z0",
)
case(
    "$AA_MW counts in the frame of the measuring block", **KNOWN, **OFFSETS, inputs={"skips": [0.5]},
    program="N10 G54 ROT Z90\nN20 G1 F100 MEAS=1 X40\nN30 ROT\nN40 R1=$AA_MW[X] R2=$AA_MM[X]\nN50 M30", vars={1: 20, 2: 100.125},
)
case(
    "the code of motion stays in force", **MEAS, **OFFSETS, inputs={"skips": [0.5]},
    program="N10 G54 G1 F100 MEAS=1 X40\nN20 X50\nN30 M30", moves="F X20\nF X50",
)
for words in ("G0 MEAS=1 X5", "G2 MEAS=1 X5 I2.5 F100"):
    case(
        f"measuring on another move than a line is not computed: {words}", **KNOWN,
        program=f"N10 {words}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )
for words in ("MEAS=2", "MEAS=0", "MEAS=R1"):
    case(
        f"nor is {words}", **KNOWN,
        program=f"N10 G1 F100 {words} X5\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )
case(
    "MEAS has a value", **KNOWN,
    program="N10 G1 F100 MEAS X5\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10",
)
case(
    "only the first probe is known", **KNOWN,
    program="N10 R1=$AC_MEA[2]\nN20 M30", runs="", alarm="array-element", number="12400", at="MAIN N10",
)
