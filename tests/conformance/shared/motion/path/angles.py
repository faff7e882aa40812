"""Lines by their angle: direct drawing dimension programming."""

from conformance import case

F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
TA, TDI = ["gsk-988ta", "gsk-988t"], "gsk-980tdi"
LATHE = {"machine": "lathe-a", "start": {"X": 20, "Z": 0}}
KNOWN = {"source": "general knowledge, direct drawing dimension programming",
         "evidence": "inferred"}
TDI13 = {"source": "TDi 13", "evidence": "maker's manual"}

# Two lines: 150 degrees from (0, 10), 180 degrees to (-40, 20), Z and radius.
MEET = "F X40 Z-17.3205\nF Z-40"


def numbers(number):
    return {F16: number, **dict.fromkeys(FANUC_PS, f"PS0{number}")}


def both(claim, *blocks, moves, setup=LATHE):
    """Write rows for FANUC with ,A and A, for the 988 with ,A, for the 980TDi with Q in degrees."""
    for name, controls, params, tags in (
        (",A", [*FANUC, *TA, *MITSUBISHI], None, KNOWN), ("A", FANUC, None, KNOWN),
        ("Q", TDI, {"182#7": 1}, TDI13),
    ):
        lines = "\n".join(f"N{10 * i} {block}" for i, block in enumerate(blocks, 1))
        text = lines.replace("ANGLE", name)
        if name == "Q":
            text = text.replace(",C", "L").replace(",R", "D")
        case(
            f"{claim}, by {name}", control=controls, **tags, setup=setup, params=params,
            pins="point_addresses round_words angle_words",
            program=f"O1\nN5 G98 S100 M3 F100.\n{text}\nN90 M30", moves=moves,
        )


both("X and an angle say where Z ends", "G1 X40. ANGLE150.", moves="F X40 Z-17.3205")
both("Z and an angle say where X ends", "G1 Z-17.3205 ANGLE150.", moves="F X40 Z-17.3205")
both("an increment and an angle say the rest", "G1 U20. ANGLE150.", moves="F X40 Z-17.3205")
case(
    "a rapid goes by an angle too, by ,A",
    control=[*FANUC, *TA, *MITSUBISHI], **KNOWN, setup=LATHE,
    program="O1\nN10 G0 X40. ,A150.\nN20 M30",
    moves="R X40 Z-17.3205",
)
case(
    "a rapid goes by an angle too, by Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN10 G0 X40. Q150.\nN20 M30",
    moves="R X40 Z-17.3205",
)
both("an angle and its opposite are the same line", "G1 X40. ANGLE-30.", moves="F X40 Z-17.3205")
both("beside both coordinates an angle does not count", "G1 X40. Z-30. ANGLE150.",
     moves="F X40 Z-30")
both("two lines by their angles meet", "G1 ANGLE150.", "X40. Z-40. ANGLE180.", moves=MEET)
both("one block without a move may stand between two angles", "G1 ANGLE150.", "M8",
     "X40. Z-40. ANGLE180.", moves=MEET)
both("after two angles a third line goes on", "G1 ANGLE150.", "X40. Z-40. ANGLE180.", "X50.",
     moves=MEET + "\nF X50")
both("a round lies where two lines by their angles meet", "G1 ANGLE90. ,R2.",
     "X40. Z-40. ANGLE180. ,R3.", "X60.",
     moves="F X36 Z0\nCCW X40 Z-2 C X36 Z-2\nF Z-37\nCW X46 Z-40 C X46 Z-37\nF X60")
both("a corner before two lines by their angles is kept", "G1 Z-10. ,R2.", "ANGLE90.",
     "X40. Z-40. ANGLE180.",
     moves="F Z-8\nCW X24 Z-10 C X24 Z-8\nF X40\nF Z-40")
case(
    "Q of an angle counts thousandths of a degree", control=TDI, **TDI13, setup=LATHE,
    program="O1\nN10 G98 G1 X40 Q150000 F100\nN20 M30", moves="F X40 Z-17.3205",
)
case(
    "a profile of G71 may have lines by their angles, not one that is left open",
    control=FANUC, **KNOWN, setup=LATHE,
    program="""
        O1
        N10 G98 G0 X60. Z2.
        N20 G71 U5. R1.
        N30 G71 P40 Q60 F100.
        N40 G0 X20.
        N50 G1 ,A180.
        N60 X60. Z-40. ,A90.
        N70 G71 P80 Q90
        N80 G0 X20.
        N90 G1 ,A180.
        N99 M30
    """,
    alarm="angle-no-end", number=numbers("058"), word=",A180.",
)
case(
    "an angle of a mill counts from the first axis of its plane", control=MITSUBISHI,
    pins="angles_on_mills",
    source="general knowledge, linear angle command", evidence="inferred",
    setup={"machine": "mill"},
    program="O1\nN10 G90 G1 X10. ,A45. F100.\nN20 G1 ,A90.\nN30 X0 Y30. ,A180.\nN40 M30",
    moves="F X10 Y10\nF Y30\nF X0",
)
case(
    "the second of two lines needs an angle, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 ,A150.\nN20 X40. Z-40.\nN90 M30",
    alarm="angle-end", number=numbers("056"), at="O1 N20", word="X40.",
)
case(
    "the second of two lines needs both coordinates, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 ,A150.\nN20 Z-40. ,A180.\nN90 M30",
    alarm="angle-end", number=numbers("056"), at="O1 N20", word="Z-40.",
)
case(
    "the second of two lines takes no increments, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 ,A150.\nN20 X40. W-40. ,A180.\nN90 M30",
    alarm="angle-end", number=numbers("056"), at="O1 N20", word="X40.",
)
case(
    "no second line with an angle alone, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 ,A150.\nN20 ,A180.\nN90 M30",
    alarm="angle-end", number=numbers("056"), at="O1 N20", word=",A180.",
)
case(
    "no arc after an angle, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 ,A150.\nN20 G2 X40. Z-40. R60.\nN90 M30",
    alarm="angle-end", number=numbers("056"), at="O1 N20", word="X40.",
)
case(
    "two lines of one direction do not meet, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 ,A150.\nN20 X40. Z-40. ,A150.5\nN90 M30",
    alarm="angle-parallel", number=numbers("057"), at="O1 N20", word=",A150.5",
)
case(
    "a line along Z never comes to another X, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 X40. ,A179.5\nN90 M30",
    alarm="angle-parallel", number=numbers("057"), at="O1 N10", word=",A179.5",
)
case(
    "a line along X never comes to another Z, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Z-40. ,A90.5\nN90 M30",
    alarm="angle-parallel", number=numbers("057"), at="O1 N10", word=",A90.5",
)
case(
    "two blocks without a move after an angle, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="""
        O1
        N5 G98 S100 M3 F100.
        N10 G1 ,A150.
        N20 M8
        N30 M9
        N40 X40. Z-40. ,A180.
        N90 M30
    """,
    alarm="angle-no-end", number=numbers("058"), at="O1 N30", word="M9",
)
case(
    "the program ends after an angle, written with ,A",
    control=FANUC, source="ALM 056 to 058", evidence="secondary", setup=LATHE,
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 ,A150.\nN90 M30",
    alarm="angle-no-end", number=numbers("058"), word=",A150.",
)
case(
    "the second of two lines needs an angle, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Q150.\nN20 X40. Z-40.\nN90 M30",
    alarm="angle-end", number=None, at="O1 N20", word="X40.",
)
case(
    "the second of two lines needs both coordinates, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Q150.\nN20 Z-40. Q180.\nN90 M30",
    alarm="angle-end", number=None, at="O1 N20", word="Z-40.",
)
case(
    "the second of two lines takes no increments, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Q150.\nN20 X40. W-40. Q180.\nN90 M30",
    alarm="angle-end", number=None, at="O1 N20", word="X40.",
)
case(
    "no second line with an angle alone, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Q150.\nN20 Q180.\nN90 M30",
    alarm="angle-end", number=None, at="O1 N20", word="Q180.",
)
case(
    "no arc after an angle, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Q150.\nN20 G2 X40. Z-40. R60.\nN90 M30",
    alarm="angle-end", number=None, at="O1 N20", word="X40.",
)
case(
    "two lines of one direction do not meet, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Q150.\nN20 X40. Z-40. Q150.5\nN90 M30",
    alarm="angle-parallel", number=None, at="O1 N20", word="Q150.5",
)
case(
    "a line along Z never comes to another X, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 X40. Q179.5\nN90 M30",
    alarm="angle-parallel", number=None, at="O1 N10", word="Q179.5",
)
case(
    "a line along X never comes to another Z, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Z-40. Q90.5\nN90 M30",
    alarm="angle-parallel", number=None, at="O1 N10", word="Q90.5",
)
case(
    "two blocks without a move after an angle, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="""
        O1
        N5 G98 S100 M3 F100.
        N10 G1 Q150.
        N20 M8
        N30 M9
        N40 X40. Z-40. Q180.
        N90 M30
    """,
    alarm="angle-no-end", number=None, at="O1 N30", word="M9",
)
case(
    "the program ends after an angle, written with Q",
    control=TDI, **TDI13, setup=LATHE, params={"182#7": 1},
    program="O1\nN5 G98 S100 M3 F100.\nN10 G1 Q150.\nN90 M30",
    alarm="angle-no-end", number=None, word="Q150.",
)
case(
    "fanuc-16i, fanuc-0i-d, fanuc-0i-f, fanuc-30i: ,A is no word here",
    control=FANUC, pins="point_addresses angles_on_mills",
    source="policy: no wrong move without a word", evidence="inferred", setup={"machine": "mill"},
    program="O1\nN5 S100 M3\nN10 G1 X40. ,A150. F100.\nN20 M30",
    alarm="address-not-usable", number={F16: "009", **dict.fromkeys(FANUC_PS, "PS0009")},
    at="O1 N10", word=",A150.",
)
case(
    "gsk-980mdi, hnc-21m: ,A is no word here",
    control=["gsk-980mdi", "hnc-21m"], pins="point_addresses",
    source="policy: no wrong move without a word", evidence="inferred",
    program="O1\nN5 S100 M3\nN10 G1 X40. ,A150. F100.\nN20 M30",
    alarm="address-not-usable", number=None, at="O1 N10", word=",A150.",
)
case(
    "gsk-980tdi, gsk-928te: ,A is no word here",
    control=[TDI, "gsk-928te"], pins="point_addresses angle_words",
    source="policy: no wrong move without a word", evidence="inferred", setup=LATHE,
    program="O1\nN5 S100 M3\nN10 G1 X40. ,A150. F100.\nN20 M30",
    alarm="address-not-usable", number=None, at="O1 N10", word=",A150.",
)
case(
    "in a rapid C is an axis of a lathe, no chamfer",
    control=FANUC, source="general knowledge", evidence="inferred", setup=LATHE,
    program="O1\nN5 G98 S100 M3\nN10 G0 C90. A5.\nN90 M30",
    moves="R C90 A5",
)
case(
    "in a return to the reference point C is an axis of a lathe, no chamfer",
    control=FANUC, source="general knowledge", evidence="inferred", setup=LATHE,
    program="O1\nN5 G98 S100 M3\nN10 G1 F100. G28 C0\nN90 M30",
    moves="R C0\nR C0",
)
case(
    "in a drilling cycle C is an axis of a lathe, no chamfer",
    control=FANUC, source="general knowledge", evidence="inferred", setup=LATHE,
    program="O1\nN5 G98 S100 M3\nN10 G83 C90. Z-10. R-5. F100.\nN90 M30",
    moves="R C90\nR Z-5\nF Z-10\nR Z0",
)
