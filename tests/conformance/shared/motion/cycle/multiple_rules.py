"""Motion, rule by rule: the multiple cycles G70 to G76."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
LATHE = {"machine": "lathe-a"}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}


def numbers(controls, fanuc=None, mitsubishi=None, gsk_988=None, mdi=None):
    """Return the alarm number of each control, which is that of its maker; `066/325` where the
    number of the 16i is not that of the later series."""
    old, later = (fanuc.split("/") * 2)[:2] if fanuc else (None, None)
    by_control = {
        **dict.fromkeys(GSK_988, gsk_988), **dict.fromkeys(MITSUBISHI, mitsubishi),
        F16: old, **dict.fromkeys(FANUC_PS, later and f"PS0{later}"), MDI: mdi,
    }
    return {control: by_control.get(control) for control in controls}


case(
    "G71 cuts a millimetre deep and leaves the cut by half a millimetre, at feed",
    pins="rough_depth rough_escape", control=[*GSK_988, TDI],
    source="TDi 23.1 step 4; TA 8; ROB p.48; the amounts: policy", evidence="inferred",
    setup=LATHE | {"start": {"X": 20, "Z": 2}},
    program="O1\nN10 G71 P20 Q30 U0 W0 F10.\nN20 G0 X16.\nN30 G1 Z-10.\nN40 M30",
    moves="R X20 Z2\nR X18\nF Z-10\nF X19 Z-9.5\nR Z2\nR X16\nF Z-10\nR X20 Z2",
)
case(
    "G71 cuts a millimetre deep and leaves the cut by half a millimetre, rapid",
    pins="rough_depth rough_escape", control=[*MITSUBISHI, *FANUC],
    source="TDi 23.1 step 4; TA 8; ROB p.48; the amounts: policy", evidence="inferred",
    setup=LATHE | {"start": {"X": 20, "Z": 2}},
    program="O1\nN10 G71 P20 Q30 U0 W0 F10.\nN20 G0 X16.\nN30 G1 Z-10.\nN40 M30",
    moves="R X20 Z2\nR X18\nF Z-10\nR X19 Z-9.5\nR Z2\nR X16\nF Z-10\nR X20 Z2",
)

_lathe = [*GSK_988, *MITSUBISHI, *FANUC]

case(
    "G73 R1 is one pass",
    pins="single_pattern",
    control=[*GSK_988, *MITSUBISHI, *FANUC], **KNOWN,
    setup=LATHE | {"start": {"X": 20, "Z": 2}},
    program="""
        O1
        N10 G73 U2. W0 R1
        N15 G73 P20 Q30 U0 W0 F10.
        N20 G0 X16.
        N30 G1 Z-10.
        N40 M30
    """,
    moves="R X20 Z2\nR X16\nF Z-10\nR X20 Z2",
)
case(
    "G73 R1 is two passes on the 980TDi",
    pins="single_pattern",
    control=TDI, source="TDi 23.3", evidence="maker's manual",
    setup=LATHE | {"start": {"X": 20, "Z": 2}},
    program="""
        O1
        N10 G73 U2. W0 R1
        N15 G73 P20 Q30 U0 W0 F10.
        N20 G0 X16.
        N30 G1 Z-10.
        N40 M30
    """,
    moves="R X24 Z2\nR X20\nF Z-10\nR X20 Z2\nR X16\nF Z-10\nR X20 Z2",
)
case(
    "Q of G74 counts least increments",
    control=[*MITSUBISHI, *FANUC], **KNOWN, setup=LATHE,
    program="""
        O1
        N10 G74 R1.
        N20 G74 Z-10. Q6000 F10.
        N30 M30
    """,
    moves="F Z-6\nR Z-5\nF Z-10\nR Z0",
)
case(
    "Q of G74 counts millimetres on the 988",
    control=GSK_988, source="TA 12, 3401#1", evidence="maker's manual", setup=LATHE,
    program="""
        O1
        N10 G74 R1.
        N20 G74 Z-10. Q6 F10.
        N30 M30
    """,
    moves="F Z-6\nR Z-5\nF Z-10\nR Z0",
)
case(
    "P of G75 is a radius: P3000 is 6 mm of diameter",
    pins="groove_p_diameter", control=[*MITSUBISHI, *FANUC], source="TA 12, 13; general knowledge",
    evidence="inferred", setup=LATHE | {"start": {"X": 20, "Z": 0}},
    program="O1\nN10 G75 R1.\nN20 G75 X10. P3000 F10.\nN30 M30",
    moves="F X14\nR X16\nF X10\nR X20",
)
case(
    "P of G75 is a radius: P3 is 6 mm of diameter",
    pins="groove_p_diameter", control=GSK_988, source="TA 12, 13; general knowledge",
    evidence="inferred", setup=LATHE | {"start": {"X": 20, "Z": 0}},
    program="O1\nN10 G75 R1.\nN20 G75 X10. P3 F10.\nN30 M30",
    moves="F X14\nR X16\nF X10\nR X20",
)

PROFILE = LATHE | {"start": {"X": 20, "Z": 2}}

case(
    "a call inside the profile of G71 alarms",
    control=_lathe, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N5 G0 X20.
        N10 G71 P20 Q40 U0 W0 F10.
        N20 G0 X10.
        N30 M98 P2
        N40 G1 Z-10.
        N50 M30
        O2
        N60 M99
    """,
    alarm="call-in-profile", number=numbers(_lathe, "066/325", None, "131"), word="M98",
)
case(
    "a profile that begins with an arc alarms",
    control=_lathe, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N5 G0 X20.
        N10 G71 P20 Q40 U0 W0 F10.
        N20 G2 X10. Z0 R20.
        N30 G1 Z-10.
        N40 X20.
        N50 M30
        O2
        N60 M99
    """,
    alarm="profile-first-block", number=numbers(_lathe, "065", None, "144"), word="G2",
)
case(
    "G71 with P and no Q alarms",
    control=_lathe, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N5 G0 X20.
        N10 G71 P20 U0 W0 F10.
        N20 G0 X10.
        N30 G1 Z-10.
        N40 X20.
        N50 M30
        O2
        N60 M99
    """,
    alarm="pq-missing", number=numbers(_lathe, "061", None, "133"), word="G71",
)
case(
    "G28 inside a profile alarms",
    control=_lathe, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N5 G0 X20.
        N10 G71 P20 Q40 U0 W0 F10.
        N20 G0 X10.
        N30 G1 Z-10.
        N40 G28 X20.
        N50 M30
        O2
        N60 M99
    """,
    alarm="profile-code", number=numbers(_lathe, "066/325", None, "128"), word="G28",
)
case(
    "a macro statement inside a profile alarms",
    control=_lathe, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N5 G0 X20.
        N10 G71 P20 Q40 U0 W0 F10.
        N20 G0 X10.
        N30 #100=1
        N40 G1 Z-10.
        N50 M30
        O2
        N60 M99
    """,
    alarm="profile-macro", number=numbers(_lathe, None, None, "130"), word="#100=1",
)
case(
    "a depth of cut of 0 alarms",
    control=_lathe, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N5 G0 X20.
        N10 G71 U0 R1.
        N15 G71 P20 Q40 U0 W0 F10.
        N20 G0 X10.
        N30 G1 Z-10.
        N40 X20.
        N50 M30
    """,
    alarm="cycle-depth", number=numbers(_lathe, "062", None, "148"), word="G71",
)
case(
    "a profile that turns back alarms",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800", "fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N5 G0 X20.
        N10 G71 P20 Q40 U0 W0 F10.
        N20 G0 X10.
        N30 G1 Z-10.
        N40 X12. Z-5.
        N50 M30
    """,
    alarm="profile-not-monotone",
    number={"mitsubishi-meldas": "P203", "mitsubishi-m700": "P203", "mitsubishi-m800": "P203", "fanuc-16i": "064", "fanuc-0i-d": "PS0064", "fanuc-0i-f": "PS0064", "fanuc-30i": "PS0064"},
    word="Z-5.",
)
for _axis, _cycle, _wrong in (
    ("X", "G71 P20 Q50", "N20 G0 X10.\nN30 G1 Z-10.\nN40 X8. Z-12.\nN50 X20. Z-20."),
    ("Z", "G72 P20 Q50", "N20 G0 Z-40.\nN30 G1 X16.\nN40 X14. Z-42.\nN50 X12. Z0"),
):
    case(
        f"a profile that first goes away from the start along {_axis} is told where it does, not where it comes back",
        control=["mitsubishi-m700", "fanuc-16i", "fanuc-0i-f"], source="ALM; MZ 897, paired", evidence="inferred",
        setup=PROFILE, program=f"O1\nN5 G0 X20. Z0\nN10 {_cycle} U0 W0 F10.\n{_wrong}\nN60 M30",
        alarm="profile-not-monotone", number={"mitsubishi-m700": "P203", "fanuc-16i": "064", "fanuc-0i-f": "PS0064"},
        at="O1 N40", word="X8." if _axis == "X" else "Z-42.",
    )
NEW_FANUC = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
ALLOWANCE = "general knowledge: parameters 5145 and 5146 of the 0i-D and the 30i"


def turning_back(x="X20.", z="Z-12.", code="G71 U1. R1."):
    """Return a profile whose block N50 leads to `x` and `z`, and which then goes on out and in."""
    return f"""
        O1
        N5 G0 X40. Z2.
        N10 {code}
        N15 {code[:3]} P20 Q70 U0 W0 F10.
        N20 G0 X10.
        N30 G1 Z-10.
        N40 X20. Z-12.
        N50 {x} {z}
        N60 X30. Z-20.
        N70 X40.
        N80 M30
    """


case(
    "a profile may not turn back along Z at all without 5145",
    pins="first_axis_allowance", control=NEW_FANUC, source="ALM; " + ALLOWANCE,
    evidence="inferred", setup=PROFILE, program=turning_back(z="Z-11.999"),
    alarm="profile-not-monotone", number="PS0064", word="Z-11.999",
)
case(
    "a profile may not turn back along X at all without 5146",
    pins="second_axis_allowance", control=NEW_FANUC, source="ALM; " + ALLOWANCE,
    evidence="inferred", setup=PROFILE, program=turning_back(x="X19.998"),
    alarm="profile-not-monotone", number="PS0064", word="X19.998",
)
case(
    "a profile that turns back along Z by more than 5145 allows alarms",
    control=NEW_FANUC, source="ALM; " + ALLOWANCE, evidence="inferred", setup=PROFILE,
    params={"5145": 0.05, "5146": 1}, program=turning_back(z="Z-11.949"),
    alarm="profile-not-monotone", number="PS0064", word="Z-11.949",
)
case(
    "5145 allows a profile to turn back along Z by so much",
    control=NEW_FANUC, source=ALLOWANCE, evidence="inferred",
    setup=PROFILE, params={"5145": 0.05}, program=turning_back(z="Z-11.95"), runs="N5 N10 N15 N80",
)
case(
    "5146 allows a profile to turn back along X by so much of the radius",
    control=NEW_FANUC, source=ALLOWANCE, evidence="inferred",
    setup=PROFILE, params={"5146": 0.05}, program=turning_back(x="X19.9"), runs="N5 N10 N15 N80",
)
case(
    "beyond 5146 a profile that turns back along X alarms",
    control=NEW_FANUC, source="ALM; " + ALLOWANCE, evidence="inferred", setup=PROFILE,
    params={"5145": 1, "5146": 0.05}, program=turning_back(x="X19.898"),
    alarm="profile-not-monotone", number="PS0064", word="X19.898",
)
case(
    "a profile that turns back alarms where 5102#1 says so",
    control=GSK_988, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
    params={"5102#1": 1},
    program="""
        O1
        N5 G0 X20.
        N10 G71 P20 Q40 U0 W0 F10.
        N20 G0 X10.
        N30 G1 Z-10.
        N40 X12. Z-5.
        N50 M30
    """,
    alarm="profile-not-monotone", number=numbers(GSK_988, "064", "P203", "138"), word="Z-5.",
)
case(
    "a call inside the profile of G71 alarms on the 980TDi", control=TDI, source="TDi 23.1",
    evidence="maker's manual", setup=PROFILE,
    program="O1\nN10 G71 P20 Q40 U0 W0 F10.\nN20 G0 X10.\nN30 M98 P2\nN40 G1 Z-10.\nN50 M30\nO2\nN60 M99",
    alarm="call-in-profile", word="M98",
)
case(
    "a profile that turns back alarms on the 980TDi with K1", control=TDI,
    source="TDi 23.1; general knowledge",
    evidence="inferred", setup=PROFILE,
    program="O1\nN10 G71 P20 Q40 U0 W0 K1 F10.\nN20 G0 X10.\nN30 G1 Z-10.\nN40 X12. Z-5.\nN50 M30",
    alarm="profile-not-monotone", word="Z-5.",
)
case(
    "after G71 the program goes on after the profile",
    control=[TDI, *MITSUBISHI, *FANUC], source="TDi 23.1; TA 8; general knowledge",
    evidence="inferred", setup=PROFILE, pins="after_contour",
    program="O1\nN10 G71 P20 Q30 U0 W0 F10.\nN15 M8\nN20 G0 X10.\nN30 G1 Z-10.\nN50 M30",
    runs="N10 N50",
)
case(
    "after G71 the 988 goes on with the next block where the profile stands elsewhere",
    control=GSK_988, source="TDi 23.1; TA 8; general knowledge", evidence="inferred", setup=PROFILE,
    pins="after_contour",
    program="O1\nN10 G71 P20 Q30 U0 W0 F10.\nN15 M8\nN20 G0 X10.\nN30 G1 Z-10.\nN50 M30",
    runs="N10 N15 N20 N30 N50",
)
case(
    "G75 without X alarms",
    control=T, source="ALM; Talm", evidence="secondary", setup=PROFILE,
    program="O1\nN10 G97 S100 M3\nN20 G75 Z-10. Q1000 F10.\nN30 M30",
    runs="N10", alarm="groove-axis", number=numbers([T], *(None, None, "154")), at="O1 N20", word="G75",
)
case(
    "G76 without P alarms",
    control=_lathe, source="ALM; Talm", evidence="secondary", setup=PROFILE,
    program="O1\nN10 G97 S100 M3\nN20 G76 X18. Z-10. Q100 F1.\nN30 M30",
    runs="N10", alarm="thread-height", number=numbers(_lathe, *("062/317", None, "167")),
    at="O1 N20", word="G76",
)
case(
    "G76 with a finishing allowance above its height of P1 Q1 alarms",
    control=GSK_988, source="Talm 165; ALM 0317", evidence="secondary", setup=PROFILE,
    program="O1\nN10 G97 S100 M3\nN20 G76 P010060 R2.\nN30 G76 X18. Z-10. P1 Q1 F1.\nN40 M30",
    runs="N10 N20", alarm="thread-allowance", number=numbers(GSK_988, "062/317", None, "165"),
    at="O1 N30", word="P1",
)
case(
    "G76 with a finishing allowance above its height of P1000 Q200 alarms",
    control=[*MITSUBISHI, *FANUC], source="Talm 165; ALM 0317", evidence="secondary", setup=PROFILE,
    program="""
        O1
        N10 G97 S100 M3
        N20 G76 P010060 R2.
        N30 G76 X18. Z-10. P1000 Q200 F1.
        N40 M30
    """,
    runs="N10 N20", alarm="thread-allowance",
    number=numbers([*MITSUBISHI, *FANUC], "062/317", None, "165"), at="O1 N30", word="P1000",
)
