"""G71 and G72 of type II: profiles that go in and out, cut pocket by pocket."""

from conformance import case

F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
TA = ["gsk-988ta", "gsk-988t"]
LATHE = {"machine": "lathe-a", "start": {"X": 60, "Z": 5}}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
TDI = {"source": "TDi 23.1, figure 3-69", "evidence": "maker's manual"}
TA8 = {"source": "TA 8", "evidence": "maker's manual"}


def program(cycle="", first="N20 G0 X50. W0"):
    return f"""
        O1
        N5 G98 S500 M3
        N10 G71 U5. R1.
        N15 G71 P20 Q50 F100. {cycle}
        {first}
        N25 G1 X40. Z-5.
        N30 Z-10.
        N35 X56. Z-18.
        N40 Z-22.
        N45 X44. Z-28.
        N50 X60. Z-36.
        N55 M30
    """


# The path: down to X50, the first pocket to its bottom, over the shoulder, the second pocket.
POCKETS = """
    R X60 Z5
    R X50
    F X50 Z-15
    F X56 Z-18
    F Z-22
    {out} X58
    R Z5
    R X50
    F X40 Z-5
    F Z-10
    F X50 Z-15
    R X58
    R Z-22
    F X56
    F X50 Z-25
    F Z-31
    F X60 Z-36
    R Z-25
    R X50
    F X44 Z-28
    F X50 Z-31
    R X60
"""
PASS = """
    R Z5
    R X50
    F X40 Z-5
    F Z-10
    F X56 Z-18
    F Z-22
    F X44 Z-28
    F X60 Z-36
    R X60 Z5
"""
HOME = "    R Z5\n"
FEED, RAPID = POCKETS.replace("{out}", "F"), POCKETS.replace("{out}", "R")

case(
    "a profile with pockets is cut pocket by pocket", control="gsk-980tdi", **TDI, setup=LATHE,
    pins="pocket_pass",
    program=program(), moves=FEED + HOME,
)
case(
    "J1 cuts the whole profile once more after the pockets", control="gsk-980tdi", **TDI,
    setup=LATHE, program=program("J1"), moves=FEED + PASS,
)
case(
    "J2 cuts the profile no second time", control="gsk-980tdi", **TDI, setup=LATHE,
    program=program("J2"), moves=FEED + HOME,
)
case(
    "after the pockets the whole profile is cut once more", control=FANUC + MITSUBISHI, **KNOWN,
    pins="escape pocket_pass",
    setup=LATHE, program=program(), moves=RAPID + PASS,
)
case(
    "with 5105#2 the profile is not cut once more", control=FANUC, **KNOWN, setup=LATHE,
    params={"5105#2": 1}, program=program(), moves=RAPID + HOME,
)
case(
    "a profile with pockets is cut pocket by pocket, and once more as a whole", control=TA, **TA8,
    pins="escape pocket_pass",
    setup=LATHE, program=program(), moves=FEED + PASS,
)
case(
    "with 5105#2 = 1 the profile is cut no second time", control=TA, **TA8, setup=LATHE,
    params={"5105#2": 1}, program=program(), moves=FEED + HOME,
)
case(
    "the shape decides that there are pockets, though the first block names X alone", control=TA,
    pins="rough_type",
    **TA8, setup=LATHE, program=program(first="N20 G0 X50."), moves=FEED + PASS,
)
case(
    "with 5102#2 the first block decides: X alone allows no pockets", control=TA, **TA8,
    setup=LATHE, params={"5102#1": 1, "5102#2": 1},
    program=program(first="N20 G0 X50."),
    alarm="profile-not-monotone", number="138", word="X40.",
)
case(
    "X alone in the first block allows no pockets", control=FANUC, source="ALM 064",
    pins="profile_monotone rough_type",
    evidence="secondary", setup=LATHE, program=program(first="N20 G0 X50."),
    alarm="profile-not-monotone",
    number={F16: "064", **dict.fromkeys(FANUC_PS, "PS0064")}, word="X40.",
)
case(
    "a first block with X alone makes no pockets, whatever the shape",
    pins="profile_monotone rough_type",
    control=["gsk-980tdi", *MITSUBISHI], **KNOWN, setup=LATHE,
    program=program("K1", first="N20 G0 X50."), alarm="profile-not-monotone",
    number={"gsk-980tdi": None, **dict.fromkeys(MITSUBISHI, "P203")}, word="X40.",
)
case(
    "an arc of a profile with pockets that turns back along Z alarms", control="gsk-980tdi",
    source="TDi 23.1: K", evidence="maker's manual", setup=LATHE,
    program="""
        O1
        N10 G98 G71 U5 R1
        N15 G71 P20 Q40 F100
        N20 G0 X50 W0
        N25 G1 X40 Z-5
        N30 G3 X40 Z-15 R-8
        N35 G1 X30 Z-20
        N40 X60 Z-36
        N55 M30
    """,
    alarm="profile-not-monotone", word="Z-36",
)
