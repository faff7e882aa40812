"""Radius compensation: moves after a corner, joints that rounding tears, arcs on their centre."""

from conformance import case

F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
TA, T, TDI, MDI, TE, HNC = (
    "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te", "hnc-21m")
MILLS = [*FANUC, *MITSUBISHI, MDI, HNC]
GSK_LATHES = [TA, T, TDI]
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
MILL = {"machine": "mill", "radius_offsets": {1: 1, 2: 2, 5: 5}, "length_offsets": {1: 30}}
NOSE = {"machine": "lathe-a", "tools": {1: {"R": 1}, 2: {"R": 2}, 5: {"R": 5}}}


def lines(*blocks):
    """Return a program of these blocks, numbered from N10 on."""
    numbered = [f"N{10 * (i + 1)} {block}" for i, block in enumerate(blocks)]
    return "\n".join(["O1", *numbered, "N900 M30"])


def path(claim, controls, *blocks, **keywords):
    case(
        claim, control=controls, params={"3401#0": 1} if {*controls} <= {*FANUC} else None,
        **KNOWN | {"setup": MILL} | keywords, program=lines(*blocks),
    )


def numbers(controls, fanuc, mitsubishi, gsk_988, mdi):
    table = {F16: fanuc, **dict.fromkeys(FANUC_PS, f"PS0{fanuc}")}
    table |= dict.fromkeys(MITSUBISHI, mitsubishi) | dict.fromkeys((TA, T), gsk_988) | {MDI: mdi}
    return {control: table.get(control) for control in controls}


# A block after an acute corner is executed when the tool is around the corner.
path(
    "after an acute corner a move across G17 comes when the tool is around it",
    MILLS, *("G90 G17 G0 X0. Y-10.", "G41 D1 G1 X10. Y0. F100", "X10. Y50."), "Z20.",
    *("X15. Y0.", "G40 X50."),
    centre="X0 Y-10 Z0 | X9 Y0 Z0 | X9 Y51 Z0 | X10.8955 Y51.0945 Z0 | X10.8955 Y51.0945 Z20 | X15.995 Y0.0995 Z20 | X50 Y0 Z20",
)
path(
    "two moves across G17 after an acute corner come in their order",
    ["fanuc-30i", *MITSUBISHI, MDI],
    *("G90 G17 G0 X0. Y-10.", "G41 D1 G1 X10. Y0. F100", "X10. Y50."), "Z20.", "Z30.",
    *("X15. Y0.", "G40 X50."),
    centre="X0 Y-10 Z0 | X9 Y0 Z0 | X9 Y51 Z0 | X10.8955 Y51.0945 Z0 | X10.8955 Y51.0945 Z20 | X10.8955 Y51.0945 Z30 | X15.995 Y0.0995 Z30 | X50 Y0 Z30",
)
path(
    "after an acute corner a move across G18 comes when the tool is around it",
    MILLS, *("G90 G18 G0 Z0. X-10.", "G41 D1 G1 Z10. X0. F100", "Z10. X50."), "Y20.",
    *("Z15. X0.", "G40 Z50."),
    centre="Z0 X-10 Y0 | Z9 X0 Y0 | Z9 X51 Y0 | Z10.8955 X51.0945 Y0 | Z10.8955 X51.0945 Y20 | Z15.995 X0.0995 Y20 | Z50 X0 Y20",
)
path(
    "two moves across G18 after an acute corner come in their order",
    ["fanuc-30i", *MITSUBISHI, MDI],
    *("G90 G18 G0 Z0. X-10.", "G41 D1 G1 Z10. X0. F100", "Z10. X50."), "Y20.", "Y30.",
    *("Z15. X0.", "G40 Z50."),
    centre="Z0 X-10 Y0 | Z9 X0 Y0 | Z9 X51 Y0 | Z10.8955 X51.0945 Y0 | Z10.8955 X51.0945 Y20 | Z10.8955 X51.0945 Y30 | Z15.995 X0.0995 Y30 | Z50 X0 Y30",
)
path(
    "after an acute corner a move across G19 comes when the tool is around it",
    MILLS, *("G90 G19 G0 Y0. Z-10.", "G41 D1 G1 Y10. Z0. F100", "Y10. Z50."), "X20.",
    *("Y15. Z0.", "G40 Y50."),
    centre="Y0 Z-10 X0 | Y9 Z0 X0 | Y9 Z51 X0 | Y10.8955 Z51.0945 X0 | Y10.8955 Z51.0945 X20 | Y15.995 Z0.0995 X20 | Y50 Z0 X20",
)
path(
    "two moves across G19 after an acute corner come in their order",
    ["fanuc-30i", *MITSUBISHI, MDI],
    *("G90 G19 G0 Y0. Z-10.", "G41 D1 G1 Y10. Z0. F100", "Y10. Z50."), "X20.", "X30.",
    *("Y15. Z0.", "G40 Y50."),
    centre="Y0 Z-10 X0 | Y9 Z0 X0 | Y9 Z51 X0 | Y10.8955 Z51.0945 X0 | Y10.8955 Z51.0945 X20 | Y10.8955 Z51.0945 X30 | Y15.995 Z0.0995 X30 | Y50 Z0 X30",
)

_TO_CORNER = "G90 G17 G0 X0 Y-10.", "G41 D1 G1 X10. Y0 F100", "X10. Y50."
_AWAY = "X15. Y0", "G40 X50."

path(
    "after an acute corner the length offset comes when the tool is around it", [*FANUC, *MITSUBISHI],
    *_TO_CORNER, "G43 H1", *_AWAY,
    centre="X0 Y-10 | X9 Y0 | X9 Y51 | X10.8955 Y51.0945 | X10.8955 Y51.0945 Z30"
    " | X15.995 Y0.0995 Z30 | X50 Y0 Z30",
)
path(
    "after an acute corner G4 P2000 waits when the tool is around it",
    [*FANUC, *MITSUBISHI, MDI], *_TO_CORNER, "G4 P2000", *_AWAY,
    moves="R X0 Y-10\nF X10 Y0\nF Y50\nF Y50\nW 2\nF X15 Y0\nF X50",
)
path(
    "after an acute corner G4 P2 waits when the tool is around it",
    HNC, *_TO_CORNER, "G4 P2", *_AWAY,
    moves="R X0 Y-10\nF X10 Y0\nF Y50\nF Y50\nW 2\nF X15 Y0\nF X50",
)
path(
    "after an acute corner of a lathe a dwell waits when the nose is around it", GSK_LATHES,
    "T0101 G0 Z0. X-20.", "G98 G41 G1 Z10. X0. F100", "Z10. X100.", "G4 X2.", "Z15. X0.", "G40 Z50.",
    setup=NOSE, moves="R Z0 X-20\nF Z10 X0\nF X100\nF X100\nW 2\nF Z15 X0\nF Z50",
)

# An arc that starts or ends on its own centre has no direction there.
_STARTS = {"source": "ALM 038; Talm 254; MDib 0254; general knowledge", "evidence": "inferred"}

path(
    "a compensated arc that starts on its own centre alarms",
    ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800", "gsk-980mdi", "hnc-21m"],
    "G90 G17 G0 X0 Y-10.", "G41 D1 G1 X10. Y0 F100", "X20. Y0", "G2 X40. Y0. I0. J0.",
    "G40 X50. Y9.", **_STARTS, runs="N10 N20 N30", alarm="arc-start-on-centre-in-offset",
    number={"fanuc-16i": "038", "fanuc-0i-d": "PS0038", "fanuc-0i-f": "PS0038", "fanuc-30i": "PS0038", "mitsubishi-meldas": "P153", "mitsubishi-m700": "P153", "mitsubishi-m800": "P153", "gsk-980mdi": "0254", "hnc-21m": None},
    at="O1 N40", word="I0.",
)
path(
    "an arc of a lathe that starts on its own centre alarms under a nose radius",
    [*FANUC, *GSK_LATHES], "T0101 G0 X0. Z0.", "G98 G41 G1 Z10. X10. F100", "Z20.",
    "G2 Z40. X10. K0. I0.", "G40 X50. Z9.", setup=NOSE, **_STARTS, runs="N10 N20 N30",
    alarm="arc-start-on-centre-in-offset",
    number=numbers([*FANUC, *GSK_LATHES], "038", None, "254", None), at="O1 N40", word="I0.",
)
path(
    "a compensated arc that ends on its own centre alarms",
    ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-980mdi", "hnc-21m"],
    "G90 G17 G0 X0 Y-10.", "G41 D1 G1 X10. Y0 F100", "X20. Y0", "G2 X40. Y0. I20. J0.",
    "G40 X50. Y9.", **_STARTS, runs="N10 N20 N30", alarm="arc-end-on-centre-in-offset",
    number={"fanuc-16i": "038", "fanuc-0i-d": "PS0038", "fanuc-0i-f": "PS0038", "fanuc-30i": "PS0038", "gsk-980mdi": "0255", "hnc-21m": None},
    at="O1 N40", word="I20.",
)
path(
    "an arc of a lathe that ends on its own centre alarms under a nose radius",
    [*FANUC, *GSK_LATHES], "T0101 G0 X0. Z0.", "G98 G41 G1 Z10. X10. F100", "Z20.",
    "G2 Z40. X10. K20. I0.", "G40 X50. Z9.", setup=NOSE, **_STARTS, runs="N10 N20 N30",
    alarm="arc-end-on-centre-in-offset",
    number=numbers([*FANUC, *GSK_LATHES], "038", None, "254", None), at="O1 N40", word="I0.",
)
path(
    "an arc that starts on its own centre is a line with D0",
    [*FANUC], "G90 G17 G0 X0 Y-10.", "G41 D0 G1 X10. Y0 F100", "G2 X40. Y0. I0. J0.",
    moves="R X0 Y-10\nF X10 Y0\nF X40",
)

# The end of the compensation
case(
    "the end of type B at an outside corner goes around it, inside it ends on the normal: right",
    control=FANUC, source="16MC p.293; the way: general knowledge", evidence="inferred",
    params={"3401#0": 1, "5003#0": 1}, setup=MILL,
    program=lines(*_TO_CORNER, "G40 X30. Y50."),
    centre="X0 Y-10 | X9 Y0 | X9 Y51 | X30 Y50",
)
path(
    "the end of type A is on the normal of the last move: right",
    [*FANUC, *MITSUBISHI], *_TO_CORNER, "G40 X30. Y50.", source="M7 p.188", evidence="secondary",
    centre="X0 Y-10 | X9 Y0 | X9 Y50 | X30 Y50",
)
case(
    "the end of type B at an outside corner goes around it, inside it ends on the normal: acute",
    control=FANUC, source="16MC p.293; the way: general knowledge", evidence="inferred",
    params={"3401#0": 1, "5003#0": 1}, setup=MILL,
    program=lines(*_TO_CORNER, "G40 X15. Y0"),
    centre="X0 Y-10 | X9 Y0 | X9 Y51 | X10.8955 Y51.0945 | X15 Y0",
)
path(
    "the end of type A is on the normal of the last move: acute",
    [*FANUC, *MITSUBISHI], *_TO_CORNER, "G40 X15. Y0", source="M7 p.188", evidence="secondary",
    centre="X0 Y-10 | X9 Y0 | X9 Y50 | X15 Y0",
)
case(
    "the end of type B at an outside corner goes around it, inside it ends on the normal: inside",
    control=FANUC, source="16MC p.293; the way: general knowledge", evidence="inferred",
    params={"3401#0": 1, "5003#0": 1}, setup=MILL,
    program=lines(*_TO_CORNER, "G40 X-30. Y50."),
    centre="X0 Y-10 | X9 Y0 | X9 Y50 | X-30 Y50",
)
path(
    "the end of type A is on the normal of the last move: inside",
    [*FANUC, *MITSUBISHI], *_TO_CORNER, "G40 X-30. Y50.", source="M7 p.188", evidence="secondary",
    centre="X0 Y-10 | X9 Y0 | X9 Y50 | X-30 Y50",
)

# A program rounds its points and centres. So what is tangent, or fits, in the drawing is so only
# within some increments.
_WITNESS = (
    "G90 G0 X49.379 Y76.423", "G42 D1 G1 X61.101 Y60.218 F500", "G1 X36.795 Y42.635",
    "G2 X8.031 Y38.733 I-18.026 J24.919", "G1 X-10.711 Y45.716", "G40 X-20. Y30.")

path(
    "an arc whose centre is rounded joins the tangent lines beside it", MILLS, *_WITNESS,
    centre="X49.379 Y76.423 | X60.515 Y61.028 | X36.209 Y43.445 | X8.380 Y39.670 | X-10.362 Y46.653"
    " | X-20 Y30",
)
path(
    "an arc whose centre is rounded joins the tangent lines beside it on a lathe", GSK_LATHES,
    "T0101", "G98 G0 Z49.379 X152.846", "G42 G1 Z61.101 X120.436 F500", "G1 Z36.795 X85.270",
    "G2 Z8.031 X77.466 K-18.026 I24.919", "G1 Z-10.711 X91.432", "G40 Z-20. X60.", setup=NOSE,
    centre="Z49.379 X152.846 | Z60.515 X122.056 | Z36.209 X86.890 | Z8.380 X79.340 | Z-10.362 X93.306"
    " | Z-20 X60",
)

# A groove of 2 mm with a round ground: a tool of that radius just fits, one of 1.01 mm does not.
path(
    "into a round groove whose words miss 2 mm by an increment a tool of D1 fits",
    [*FANUC, *MITSUBISHI, MDI], "G90 G17 G0 X-10. Y20.", "G41 D1 G1 X0 Y20. F100", "Y0.001",
    "G3 X1.999 Y0 I1. J0.", "G1 Y20.", "G40 X-10.",
    setup=MILL | {"radius_offsets": {1: 1, 3: 1.01}},
    centre="X-10 Y20 | X1 Y20 | X1 Y0.001 | X0.999 Y0 | X0.999 Y20 | X-10 Y20",
)
path(
    "the groove is as wide wherever G54 and EXT lie",
    [*FANUC, *MITSUBISHI, MDI], "G90 G17 G0 X-10. Y20.", "G41 D1 G1 X0 Y20. F100", "Y0.001",
    "G3 X1.999 Y0 I1. J0.", "G1 Y20.", "G40 X-10.",
    setup=MILL | {"radius_offsets": {1: 1}, "start": {"X": 0, "Y": 0, "Z": 0},
                  "work_offsets": {"G54": {"X": -731.117, "Y": 402.389}, "EXT": {"X": 13.021, "Y": -7.707}}},
    centre="X-728.096 Y414.682 | X-717.096 Y414.682 | X-717.096 Y394.683 | X-717.097 Y394.682 | X-717.097 Y414.682 | "
           "X-728.096 Y414.682",
)
path(
    "into a round groove whose words miss 2 mm by an increment a tool of D3 does not fit",
    [*FANUC, *MITSUBISHI, MDI], "G90 G17 G0 X-10. Y20.", "G41 D3 G1 X0 Y20. F100", "Y0.001",
    "G3 X1.999 Y0 I1. J0.", "G1 Y20.", "G40 X-10.",
    setup=MILL | {"radius_offsets": {1: 1, 3: 1.01}},
    source="16iLB p.208; MDib 0256; general knowledge", alarm="offset-arc-too-small",
    number=numbers([*FANUC, *MITSUBISHI, MDI], "041", "P153", None, "0256"), word="I1.",
)

# A step of some increments between two long moves has a direction that says nothing, so the tool
# goes over it from one to the other. A higher step, a corner or a groove is smaller than the tool.
_LOW, _HIGH, _NARROW = "X50.003 Y0.002", "X50.03 Y0.02", "X50.002 Y0.002"
_UP, _DOWN = ("G90 G17 G0 X-10. Y20.", "G41 D5 G1 X0 Y0 F100", "X50. Y0"), "G90 G17 G0 X110. Y20."
_SMALL = {"source": "16iLB p.208; 30iM p.238; general knowledge", "alarm": "offset-interference"}

path(
    "the tool goes over a step of 4 increments up to a slope: line",
    MILLS, *_UP, "G1 X50.003 Y0.002", "G1 X100. Y0.5", "G40 Y30.",
    centre="X-10 Y20 | X0 Y5 | X49.862 Y5 | X49.907 Y5.001 | X99.950 Y5.500 | X100 Y30",
)
path(
    "the tool goes over a step of 4 increments up to a slope: an arc to the left",
    MILLS, *_UP, "G3 X50.003 Y0.002 R0.01", "G1 X100. Y0.5", "G40 Y30.",
    centre="X-10 Y20 | X0 Y5 | X49.862 Y5 | X49.907 Y5.001 | X99.950 Y5.500 | X100 Y30",
)
path(
    "the tool goes over a step of 4 increments up to a slope: an arc to the right",
    MILLS, *_UP, "G2 X50.003 Y0.002 R0.01", "G1 X100. Y0.5", "G40 Y30.",
    centre="X-10 Y20 | X0 Y5 | X49.862 Y5 | X49.907 Y5.001 | X99.950 Y5.500 | X100 Y30",
)
path(
    "the tool goes over a step of 4 increments up to a slope: an arc with a centre",
    MILLS, *_UP, "G2 X50.003 Y0.002 I0.004 J-0.002", "G1 X100. Y0.5", "G40 Y30.",
    centre="X-10 Y20 | X0 Y5 | X49.862 Y5 | X49.907 Y5.001 | X99.950 Y5.500 | X100 Y30",
)
path(
    "the tool goes over a step of 4 increments down from a slope: line",
    MILLS, _DOWN, "G42 D5 G1 X100. Y0.5 F100", _LOW, "G1 X50. Y0", "G1 X0", "G40 Y30.",
    centre="X110 Y20 | X99.950 Y5.500 | X49.907 Y5.001 | X49.862 Y5 | X0 Y5 | X0 Y30",
)
path(
    "the tool goes over a step of 4 increments down from a slope: an arc to the right",
    MILLS, _DOWN, "G42 D5 G1 X100. Y0.5 F100", _LOW, "G2 X50. Y0 R0.01", "G1 X0", "G40 Y30.",
    centre="X110 Y20 | X99.950 Y5.500 | X49.907 Y5.001 | X49.862 Y5 | X0 Y5 | X0 Y30",
)
path(
    "the tool goes over a step of 4 increments down from a slope: an arc to the left",
    MILLS, _DOWN, "G42 D5 G1 X100. Y0.5 F100", _LOW, "G3 X50. Y0 R0.01", "G1 X0", "G40 Y30.",
    centre="X110 Y20 | X99.950 Y5.500 | X49.907 Y5.001 | X49.862 Y5 | X0 Y5 | X0 Y30",
)
path(
    "the tool goes around a step of 4 increments down no further than the slope after it asks", MILLS,
    *_UP, "X50.003 Y-0.002", "X100. Y0.5", "G40 Y30.",
    centre="X-10 Y20 | X0 Y5 | X50.046 Y5 | X50.092 Y4.999 | X99.950 Y5.500 | X100 Y30",
)
path(
    "the nose goes over a step of 4 increments of a lathe", GSK_LATHES,
    "T0505", "G98 G0 Z-10. X40.", "G41 G1 Z0. X0. F100", "Z50.", "Z50.003 X0.004", "Z100. X1.",
    "G40 X60.", setup=NOSE,
    centre="Z-10 X40 | Z0 X10 | Z49.862 X10 | Z49.907 X10.003 | Z99.950 X11 | Z100 X60",
)
path(
    "an inner arc begins where the tool comes over a step of 4 increments in an acute corner", MILLS,
    "G90 G17 G0 X-20. Y0", "G42 D5 G1 X-10.846 Y15.088 F100", "X0 Y0", "X0.003 Y0.003",
    "G2 X11.992 Y-4.188 I3.912 J-8.077", "G1 X30. Y-40.", "G40 X50.",
    centre="X-20 Y0 | X-14.906 Y12.170 | X-1.565 Y-6.389 | X2.252 Y-4.464 | X7.486 Y-6.356"
    " | X7.505 Y-6.395 | X25.533 Y-42.246 | X50 Y-40",
)
path(
    "an outer arc of 10 increments whose end the tool touches within an increment is gone over", MILLS,
    "G90 G17 G0 X-54.648 Y-30.941", "G41 D1 G1 X-55.606 Y-32.014 F100", "X-51.561 Y-50.8",
    "G2 X-51.553 Y-50.807 I-0.006 J-0.014", "G1 X-35.696 Y-84.943", "X-20.375 Y-67.89",
    "G40 X-20.629 Y-66.584", setup=MILL | {"radius_offsets": {1: 0.2}},
    centre="X-54.648 Y-30.941 | X-55.411 Y-31.972 | X-51.374 Y-50.717 | X-51.373 Y-50.720"
    " | X-35.642 Y-84.584 | X-20.524 Y-67.756 | X-20.629 Y-66.584",
)
path(
    "an inner arc of 45 increments between two outside corners begins on its own circle", MILLS,
    "G90 G17 G0 X25. Y10.", "G41 D1 G1 X27. Y3.9 F100", "X24.841 Y-28.821",
    "G3 X24.798 Y-28.806 I-0.089 J-0.185", "G1 X12.332 Y-25.867", "G40 X0",
    setup=MILL | {"radius_offsets": {1: 0.2}},
    centre="X25 Y10 | X27.200 Y3.887 | X25.027 Y-29.034 | X24.935 Y-29.088 | X24.754 Y-29.001"
    " | X24.753 Y-29.001 | X24.753 Y-29.001 | X12.286 Y-26.062 | X0 Y-25.867",
)
path(
    "a step of 4 increments is the last compensated move where the compensation ends after it", MILLS,
    *_UP, _LOW, "G40 Y30.", centre="X-10 Y20 | X0 Y5 | X49.862 Y5 | X49.862 Y5 | X50.003 Y30",
)
path(
    "what stands beside a step of 4 increments keeps its order", MILLS,
    *_UP, "Z5.", _LOW, "Z9.", "X100. Y0.5", "G40 Y30.",
    centre="X-10 Y20 | X0 Y5 | X49.862 Y5 | X49.862 Y5 Z5 | X49.907 Y5.001 Z5 | X49.907 Y5.001 Z9"
    " | X99.950 Y5.500 Z9 | X100 Y30 Z9",
)
path(
    "a step of 36 increments up to a steep slope is one the tool does not fit into",
    MILLS, *(*_UP, _HIGH, "X100. Y2.52", "G40 Y30."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X50.03",
)
path(
    "a step of 4 increments up to a steep slope is one the tool does not fit into",
    MILLS, *(*_UP, _LOW, "X100. Y2.502", "G40 Y30."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X50.003",
)
path(
    "a step of 4 increments to a steep wall is one the tool does not fit into",
    MILLS, *(*_UP, _LOW, "X60. Y40.", "G40 Y60."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X50.003",
)
path(
    "a step of 10 increments between leaning walls is one the tool does not fit into",
    MILLS, *(*_UP, "X50.001 Y0.01", "X0 Y0.02", "G40 Y30."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X50.001",
)
path(
    "a step of 10 increments between two walls is one the tool does not fit into",
    MILLS, *(*_UP, "X49.999 Y0.01", "X0 Y0.02", "G40 Y30."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X49.999",
)
path(
    "a step of 3 increments in a corner is one the tool does not fit into",
    MILLS, *(*_UP, _NARROW, "X50.002 Y50.", "G40 X0."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X50.002",
)
path(
    "a step of 4 increments down from a steep slope is one the tool does not fit into",
    MILLS, *(_DOWN, "G42 D5 G1 X100. Y2.5 F100", _LOW, "X50. Y0", "X0 Y0", "G40 Y30."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X50.",
)
path(
    "a step of 36 increments down from a steep slope is one the tool does not fit into",
    MILLS, *(_DOWN, "G42 D5 G1 X100. Y2.5 F100", _HIGH, "X50. Y0", "X0 Y0", "G40 Y30."), **_SMALL,
    number=numbers(MILLS, "041", "P153", None, "0260"), at="O1 N40", word="X50.",
)
path(
    "an inner arc of 4 increments that turns upwards is smaller than the tool", MILLS,
    *_UP, f"G3 {_LOW} I0.001 J0.004", "G1 X100. Y0.5", "G40 Y30.",
    **_SMALL | {"alarm": "offset-arc-too-small"}, number=numbers(MILLS, "041", "P153", None, "0256"),
    at="O1 N40", word="I0.001",
)
path(
    "a groove of 3 increments of a lathe alarms between two walls", GSK_LATHES,
    "T0505", "G98 G0 Z-10. X40.", "G41 G1 Z0. X0. F100", "Z50.", "Z50.002 X0.004", "X100.", "G40 Z0.",
    setup=NOSE, **_SMALL, number=numbers(GSK_LATHES, None, None, "256", None), at="O1 N50", word="Z50.002",
)

# A move of one increment has no direction, but it is not a block without a move either.
path(
    "the corner after X50.001 and M8 is looked for while one block stands still",
    ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], *_UP, *("X50.001", "M8"), "X100. Y10.", "G40 Y30.",
    source="source 003, note a", evidence="inferred",
    centre="X-10 Y20 | X0 Y5 | X49.505 Y5 | X49.506 Y5 | X99.019 Y14.903 | X100 Y30",
)
path(
    "the corner after M8 and X50.001 is looked for while one block stands still",
    ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], *_UP, *("M8", "X50.001"), "X100. Y10.", "G40 Y30.",
    source="source 003, note a", evidence="inferred",
    centre="X-10 Y20 | X0 Y5 | X49.505 Y5 | X49.506 Y5 | X99.019 Y14.903 | X100 Y30",
)
path(
    "the corner after M8 is looked for while one block stands still",
    ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], *_UP, *("M8",), "X100. Y10.", "G40 Y30.",
    source="source 003, note a", evidence="inferred",
    centre="X-10 Y20 | X0 Y5 | X49.505 Y5 | X99.019 Y14.903 | X100 Y30",
)
path(
    "the corner after M8 and M9 is looked for while one block stands still",
    ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], *_UP, *("M8", "M9"), "X100. Y10.", "G40 Y30.",
    source="source 003, note a", evidence="inferred",
    centre="X-10 Y20 | X0 Y5 | X50 Y5 | X49.019 Y4.903 | X99.019 Y14.903 | X100 Y30",
)
