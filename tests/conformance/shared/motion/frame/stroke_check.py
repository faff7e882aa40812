"""G22 and G23: the stored stroke check 2, an area that no move may enter, or none may leave."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
MILLS = FANUC + MITSUBISHI
GSK = ["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-928te"]
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
TDI = {"source": "TDi 31", "evidence": "maker's manual"}
MILL = {"machine": "mill", "start": {"X": 0, "Y": 0, "Z": 10}}
LATHE = {"machine": "lathe-a", "start": {"X": 100, "Z": 50}}
BOX = "G22 X30. Y20. Z5. I10. J-20. K-5."  # X 10 to 30, Y -20 to 20, Z -5 to 5


def program(*blocks, area=BOX):
    lines = [f"N{10 * i} {block}" for i, block in enumerate(blocks, 2)]
    return "\n".join(["O1", f"N10 {area}", *lines, f"N{10 * len(blocks) + 20} M30"])


def stops(
    claim, *blocks, at, controls=MILLS, setup=MILL, area=BOX, params=None, tags=KNOWN, word=None,
):
    controls = [controls] if isinstance(controls, str) else controls
    case(
        claim, control=controls, **tags, setup=setup, params=params,
        pins="rapid_way power_on:G22 stroke_area",
        program=program(*blocks, area=area), alarm="over-travel", at=at, word=word,
        number={name: "M01 0007" if name in MITSUBISHI else None for name in controls},
    )


def passes(claim, *blocks, moves, controls=MILLS, setup=MILL, area=BOX, params=None, tags=KNOWN):
    case(
        claim, control=controls, **tags, setup=setup, params=params,
        pins="power_on:G22 stroke_area",
        program=program(*blocks, area=area), moves=moves,
    )


stops("a move that ends in the area of G22 alarms", "G90 G1 X20. F100.", "Z0", at="O1 N30", word="Z0")
stops(
    "a move that only crosses the area of G22 alarms", "G90 G0 Z0", "G1 X40. F100.", at="O1 N30", word="X40.",
)
passes(
    "moves beside, above and along the area of G22 are made", "G90 G1 X40. F100.", "Y20.",
    "Z0", "X0", "X5. Y25.", moves="F X40\nF Y20\nF Z0\nF X0\nF X5 Y25",
)
stops(
    "a move that begins in the area of G22 alarms", "G0 Z40.", at="O1 N20", word="Z40.",
    setup=MILL | {"start": {"X": 20, "Y": 0, "Z": 0}},
)
stops(
    "an arc that reaches into the area of G22 between its ends alarms",
    "G90 G0 Z0", "G3 X0 Y10. I0 J5. F100.", "G2 X0 Y-10. I0 J-10.", "G3 X0 Y10. I0 J10.1",
    at="O1 N50", word="X0", controls=FANUC, params={"3410": 1},
)
stops(
    "an arc that reaches into the area of G22 between its ends alarms on a Mitsubishi",
    "G90 G0 Z0", "G3 X0 Y10. I0 J5. F100.", "G2 X0 Y-10. I0 J-10.", "G3 X0 Y10. I0 J10.1",
    at="O1 N50", word="X0", controls=MITSUBISHI,
    params={"1084": 1},
)
passes(
    "an arc that goes around the area of G22 is made", "G90 G0 Z0", "G2 X0 Y10. I0 J5. F100.",
    "G3 X0 Y-10. I0 J-10.",
    moves="R Z0\nCW X0 Y10 C X0 Y5\nCCW X0 Y-10 C X0 Y0",
)
stops(
    "a helix that comes down into the area of G22 alarms", "G90 G0 X20.",
    "G3 X20. Y0 Z0 I-3. F100.", at="O1 N30", word="X20.",
)
passes(
    "a helix that stays above the area of G22 is made", "G90 G0 X20.",
    "G3 X20. Y0 Z6. I-3. F100.", moves="R X20\nCCW X20 Y0 Z6 C X17 Y0",
)
passes(
    "G23 ends the check, G22 without words takes it up again with the same area",
    "G90 G1 Z0 F100.", "G23", "X20.", "X40.", "G22", "X50.", moves="F Z0\nF X20\nF X40\nF X50",
)
stops(
    "G22 without words checks the area of the G22 before", "G90 G1 Z0 F100.", "G23", "X40.", "G22",
    "X0", at="O1 N60", word="X0",
)
stops(
    "the area of G22 lies in machine coordinates, offsets count", "G90 G55 G43 H1 G0 Z100.",
    "G1 X-80. F100.", "Z30.", at="O1 N40", word="Z30.",
    setup=MILL | {"work_offsets": {"G55": {"X": 100}}, "length_offsets": {1: -30}},
)
stops(
    "a rapid in which every axis goes at its own rate cuts a corner that a line would miss",
    "G90 G0 X0 Y0", "X25. Y70.", at="O1 N30", word="X25.", area="G22 X30. Y50. Z20. I20. J10. K-20.",
)
passes(
    "a rapid on a straight line does not come where single axes would",
    "G90 G0 X0 Y0", "X25. Y70.", moves="R X0 Y0\nR X25 Y70", controls=FANUC,
    area="G22 X30. Y50. Z20. I20. J10. K-20.", params={"1401#1": 1},
)
stops(
    "with 1300#0 a move may not leave the area of G22", "G90 G1 X20. F100.", "Z-4.", "X31.",
    at="O1 N40", word="X31.", controls=FANUC, params={"1300#0": 1},
    setup=MILL | {"start": {"X": 11, "Y": 0, "Z": 5}},
)
passes(
    "with 1300#0 moves inside the area of G22 are made", "G90 G1 X20. F100.", "Z-5.", "X30.",
    moves="F X20\nF Z-5\nF X30", controls=FANUC, params={"1300#0": 1},
    setup=MILL | {"start": {"X": 11, "Y": 0, "Z": 5}},
)
stops(
    "an area that the setup names is checked from power-on", "G90 G1 X20. Z0 F100.", at="O1 N20", word="X20.",
    controls=FANUC, area="G90",
    setup=MILL | {"stroke_area": {"X": (10, 30), "Y": (-20, 20), "Z": (-5, 5)}},
)
passes(
    "with 3402#7 an area that the setup names is checked from G22 on", "G90 G1 X20. Z0 F100.",
    moves="F X20 Z0", controls=FANUC, area="G90", params={"3402#7": 1},
    setup=MILL | {"stroke_area": {"X": (10, 30), "Y": (-20, 20), "Z": (-5, 5)}},
)
passes(
    "at power-on the area of the setup is not checked", "G90 G1 X20. Z0 F100.", moves="F X20 Z0",
    controls=MITSUBISHI, area="G90",
    setup=MILL | {"stroke_area": {"X": (10, 30), "Y": (-20, 20), "Z": (-5, 5)}},
)
passes(
    "an area whose upper corner is not above the lower one forbids nothing",
    "G90 G1 X20. Z0 F100.", moves="F X20 Z0", controls=FANUC,
    area="G22 X10. Y20. Z5. I30. J-20. K-5.",
)

# Lathes
stops(
    "a rapid of a lathe goes to its X first, by itself",
    "G0 X50 Z-50", controls=GSK[:3], setup=LATHE, area="G22 X60 Z20 I40 K-20", at="O1 N20", word="X50",
)
passes(
    "a rapid of a lathe goes to its X first, or not",
    "G0 X50 Z-50", controls=["gsk-988ta", "gsk-988t"], setup=LATHE, params={"1401#1": 1},
    area="G22 X60 Z20 I40 K-20", moves="R X50 Z-50",
)
passes(
    "with 001#7 a rapid of a lathe goes on a straight line", "G0 X50 Z-50", controls="gsk-980tdi",
    setup=LATHE, params={"001#7": 1}, area="G22 X60 Z20 I40 K-20", moves="R X50 Z-50", tags=TDI,
)
stops(
    "on a lathe X and I of G22 are diameters", "G1 X62. F100.", "Z9.", "X59.", at="O1 N40", word="X59.",
    controls=["gsk-988ta", "gsk-988t", "gsk-980tdi"], setup=LATHE,
    area="G22 X60 Z10 I0 K-50",
    tags=TDI,
)
stops(
    "a FANUC lathe checks the area of G22", "G1 X62. F100.", "Z9.", "X59.", at="O1 N40", word="X59.",
    controls=FANUC, setup=LATHE, area="G22 X60. Z10. I0 K-50.",
)
passes(
    "at power-on G23 is in force", "G98 G1 X50 Z0 F100", moves="F X50 Z0", controls=GSK,
    setup=LATHE | {"stroke_area": {"X": (0, 60), "Z": (-50, 10)}}, area="G97 S100", tags=TDI,
)
stops(
    "with 172#2 a move may not leave the area of G22", "G98 G1 X50 F100", "Z0", "X61", at="O1 N40",
    word="X61",
    controls="gsk-980tdi", setup=LATHE | {"start": {"X": 40, "Z": 5}}, params={"172#2": 1},
    area="G22 X60 Z10 I0 K-50", tags=TDI,
)
stops(
    "with 172#2 an empty area forbids everything", "G98 G1 X50 F100", at="O1 N20", word="X50",
    controls="gsk-980tdi", setup=LATHE, params={"172#2": 1}, area="G22 X0 Z10 I60 K-50", tags=TDI,
)
case(
    "G22 G98 X60 Z10 I0 K-50 puts G22 or G23 with other codes",
    control="gsk-980tdi", source="TDi 31 note 6", evidence="maker's manual", setup=LATHE,
    program="O1\nN10 G22 G98 X60 Z10 I0 K-50\nN20 M30",
    alarm="stroke-check-with-codes", at="O1 N10", word="G22",
)
case(
    "G23 M5 puts G22 or G23 with other codes",
    control="gsk-980tdi", source="TDi 31 note 6", evidence="maker's manual", setup=LATHE,
    program="O1\nN10 G23 M5\nN20 M30",
    alarm="stroke-check-with-codes", at="O1 N10", word="G23",
)
case(
    "G23 S100 puts G22 or G23 with other codes",
    control="gsk-980tdi", source="TDi 31 note 6", evidence="maker's manual", setup=LATHE,
    program="O1\nN10 G23 S100\nN20 M30",
    alarm="stroke-check-with-codes", at="O1 N10", word="G23",
)
case(
    "U and W of G52 say the same as X and Z", control=["gsk-980tdi", "gsk-988ta", *FANUC],
    source="TDi 19", evidence="maker's manual", setup=LATHE,
    program="O1\nN10 G52 U10. W20.\nN20 G0 X0 Z0\nN30 G52 U0 W0\nN40 X0 Z0\nN50 M30",
    centre="X10 Z20 | X0 Z0",
)
case(
    "G22 X60 Z10 I60 K-50: a corner is not above the other by two millimetres",
    control=["gsk-988ta", "gsk-988t"], source="Talm 068", evidence="secondary", setup=LATHE,
    program="O1\nN10 G22 X60 Z10 I60 K-50\nN20 M30",
    alarm="stroke-area", number="068", at="O1 N10", word="X60",
)
case(
    "G22 X60 Z10 I0 K8.001: a corner is not above the other by two millimetres",
    control=["gsk-988ta", "gsk-988t"], source="Talm 068", evidence="secondary", setup=LATHE,
    program="O1\nN10 G22 X60 Z10 I0 K8.001\nN20 M30",
    alarm="stroke-area", number="068", at="O1 N10", word="X60",
)
