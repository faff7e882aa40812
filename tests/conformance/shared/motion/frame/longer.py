"""G45 to G48, which make moves longer or shorter by a tool offset, and G60, which always arrives
from the same side.
"""

from conformance import case

F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
MILLS = FANUC + MITSUBISHI
M7 = {"source": "M7 p.242", "evidence": "maker's manual"}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
D1 = {"machine": "mill", "radius_offsets": {1: 10, 2: 15, 3: -10}, "length_offsets": {1: 3}}


def program(*blocks, feed="F100."):
    lines = [f"N{10 * i} {block}" for i, block in enumerate(blocks, 1)]
    return "\n".join(["O1", f"N5 G91 G1 {feed}", *lines, f"N{10 * len(blocks) + 10} M30"])


case(
    "G45 changes the length of a move by the offset of D, whatever its direction",
    pins="longer_words", control=MILLS, **M7, setup=D1,
    program=program("G45 X1000. D1", "G45 X-1000.", "G45 X1000. D3", "G45 X-1000."),
    moves="F X1010\nF X0\nF X990\nF X0",
)
case(
    "G46 changes the length of a move by the offset of D, whatever its direction",
    pins="longer_words", control=MILLS, **M7, setup=D1,
    program=program("G46 X1000. D1", "G46 X-1000.", "G46 X1000. D3", "G46 X-1000."),
    moves="F X990\nF X0\nF X1010\nF X0",
)
case(
    "G47 changes the length of a move by the offset of D, whatever its direction",
    pins="longer_words", control=MILLS, **M7, setup=D1,
    program=program("G47 X1000. D1", "G47 X-1000.", "G47 X1000. D3", "G47 X-1000."),
    moves="F X1020\nF X0\nF X980\nF X0",
)
case(
    "G48 changes the length of a move by the offset of D, whatever its direction",
    pins="longer_words", control=MILLS, **M7, setup=D1,
    program=program("G48 X1000. D1", "G48 X-1000.", "G48 X1000. D3", "G48 X-1000."),
    moves="F X980\nF X0\nF X1020\nF X0",
)
case(
    "a move shortened by more than its length goes the other way", control=MILLS, **M7, setup=D1,
    program=program("G48 X20. D2"), moves="F X-10",
)
case(
    "under G91 G45 X0 moves by the offset alone, its direction is the sign of the zero",
    control=MILLS, **M7, setup=D1,
    program=program("G45 X0 D1"),
    moves="F X10",
)
case(
    "under G91 G45 X-0 moves by the offset alone, its direction is the sign of the zero",
    control=MILLS, **M7, setup=D1,
    program=program("G45 X-0 D1"),
    moves="F X-10",
)
case(
    "under G91 G46 X0 moves by the offset alone, its direction is the sign of the zero",
    control=MILLS, **M7, setup=D1,
    program=program("G46 X0 D1"),
    moves="F X-10",
)
case(
    "under G91 G46 X-0 moves by the offset alone, its direction is the sign of the zero",
    control=MILLS, **M7, setup=D1,
    program=program("G46 X-0 D1"),
    moves="F X10",
)
case(
    "under G90 a word that moves nothing is not made longer", control=MILLS, **M7, setup=D1,
    program=program("G90 G45 X0 D1", "G45 X0 Y20."), moves="F X0\nF X0 Y30",
)
case(
    "under G90 the way from where the tool is gets longer, and the tool stays there",
    control=MILLS, **KNOWN, setup=D1,
    program=program("G90 G46 X80. Y50. D1", "G1 Y60.", "G47 X0"), moves="F X70 Y40\nF Y60\nF X-20",
)
case(
    "every named axis gets longer, also in a rapid, for one block only",
    control=MILLS, **KNOWN, setup=D1,
    program=program("G45 G0 X10. Y-10. Z5. D1", "X10."), moves="R X20 Y-20 Z15\nR X30",
)

# A contour with a convex and a concave quarter; its tool keeps a distance of 10.
case(
    "G45 to G48 lead a tool around a contour and back to its start", control=MILLS, **KNOWN,
    setup=D1,
    program=program(
        "G46 G0 X80. Y50. D1", "G47 G1 X50. F120.", "Y40.", "G48 X40.", "Y-40.", "G45 X30.",
        "G45 G3 X30. Y30. J30.", "G45 G1 Y20.", "G46 X0", "G46 G2 X-30. Y30. J30.", "G45 G1 Y0",
        "G47 X-120.", "G47 Y-80.", "G46 G0 X-80. Y-50.",
    ),
    moves="""
        R X70 Y40
        F X140
        F Y80
        F X160
        F Y40
        F X200
        CCW X240 Y80 C X200 Y80
        F Y110
        F X230
        CW X210 Y130 C X230 Y130
        F Y140
        F X70
        F Y40
        R X0 Y0
    """,
)
case(
    "three quarters of a circle get larger around the same centre", control=MILLS, **KNOWN,
    setup=D1, program=program("G45 Y-20. D1", "G45 G3 X-20. Y20. J20. D1"),
    moves="F Y-30\nCCW X-30 Y0 C X0 Y0",
)
case(
    "a half circle cannot be made longer",
    control=MILLS, **KNOWN, setup=D1,
    program=program("G45 G3 X0 Y40. J20. D1"),
    alarm="longer-arc", at="O1 N10", word="G45",
)
case(
    "an eighth of a circle cannot be made longer",
    control=MILLS, **KNOWN, setup=D1,
    program=program("G45 G3 X14.142 Y5.858 J20. D1"),
    alarm="longer-arc", at="O1 N10", word="G45",
)
case(
    "a quarter that begins between the axes cannot be made longer",
    control=MILLS, **KNOWN, setup=D1,
    program=program("G45 G3 X0 Y28.284 I-14.142 J14.142 D1"),
    alarm="longer-arc", at="O1 N10", word="G45",
)
case(
    "a quarter written with R cannot be made longer",
    control=MILLS, **KNOWN, setup=D1,
    program=program("G45 G3 X20. Y20. R20. D1"),
    alarm="longer-arc", at="O1 N10", word="G45",
)
case(
    "a quarter cannot be made shorter than nothing", control=MILLS, **KNOWN, setup=D1,
    program=program("G46 G3 X10. Y10. J10. D1"), alarm="longer-arc", at="O1 N10", word="G46",
)
case(
    "G45 to G48 may not stand in radius compensation", control=FANUC, source="ALM 042",
    evidence="secondary", setup=D1, program=program("G41 D1 X20.", "G48 X20.", "G40 X20."),
    alarm="longer-in-offset", number={F16: "042", **dict.fromkeys(FANUC_PS, "PS0042")}, at="O1 N20",
    word="G48",
)
case(
    "a canned cycle takes no notice of G45", control=MILLS, **M7, setup=D1,
    program=program("S100 M3", "G90 G81 X10. Z-5. R2.", "G45 X30. D1"),
    moves="R X10\nR Z2\nF Z-5\nR Z0\nR X30\nR Z2\nF Z-5\nR Z0",
)
case(
    "the offset of G45 is that of the last D", control=MILLS, **KNOWN, setup=D1,
    program=program("D1 X1.", "G45 X9."), moves="F X1\nF X20",
)
case(
    "H names the offset of G45 too", control=MITSUBISHI, source="M7 p.241",
    evidence="maker's manual", setup=D1, program=program("G45 X10. H1", "G45 X10. D1"),
    moves="F X13\nF X33",
)
case(
    "H names no offset of G45", control=FANUC, **KNOWN, setup=D1,
    pins="longer_words",
    program=program("D1 X1.", "G45 X9. H1"), moves="F X1\nF X20",
)
case(
    "with 5001#5 H names the offset of G45, not D", control=FANUC, **KNOWN, setup=D1,
    params={"5001#5": 1}, program=program("H1 D1 X1.", "G45 X9. D1"), moves="F X1\nF X13",
)
case(
    "G45 to G48 are no codes of this control", control="hnc-21m", **KNOWN, setup=D1,
    program="O1\nN10 G91 G1 F100\nN20 G45 X10 D1\nN30 M30", alarm="g-code-not-available",
    at="O1 N20", word="G45",
)
case(
    "G60 goes to its point in rapid", control=[*MILLS, "hnc-21m", "haas-ngc"], **KNOWN,
    pins="one_way_overrun",
    setup={"machine": "mill"}, program=program("G60 X10. Y5.", "X5."), moves="R X10 Y5\nF X15",
)
case(
    "5440 = 2 is how far G60 goes past its point, and from which side it comes back",
    control=FANUC, **KNOWN, setup={"machine": "mill"}, params={"5440": 2},
    program=program("G90 G60 X10.", "G60 X10."),
    moves="R X8\nR X10\nR X8\nR X10",
)
case(
    "5440 = -2 is how far G60 goes past its point, and from which side it comes back",
    control=FANUC, **KNOWN, setup={"machine": "mill"}, params={"5440": -2},
    program=program("G90 G60 X10.", "G60 X10."),
    moves="R X12\nR X10\nR X12\nR X10",
)
case(
    "8209 = 2 is how far G60 goes past its point, and from which side it comes back",
    control=MITSUBISHI, **KNOWN, setup={"machine": "mill"}, params={"8209": 2},
    program=program("G90 G60 X10.", "G60 X10."),
    moves="R X8\nR X10\nR X8\nR X10",
)
case(
    "8209 = -2 is how far G60 goes past its point, and from which side it comes back",
    control=MITSUBISHI, **KNOWN, setup={"machine": "mill"}, params={"8209": -2},
    program=program("G90 G60 X10.", "G60 X10."),
    moves="R X12\nR X10\nR X12\nR X10",
)
case(
    "in a canned cycle G60 leads to the hole like G00", control=MILLS, **KNOWN,
    setup={"machine": "mill"}, program=program("S100 M3", "G90 G81 X10. Z-5. R2.", "G60 X30."),
    moves="R X10\nR Z2\nF Z-5\nR Z0\nR X30\nR Z2\nF Z-5\nR Z0",
)
