"""Motion, rule by rule: reset."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC = "hnc-21m"
HAAS = "haas-ngc"
TURNING = [*GSK_988, TDI, *MITSUBISHI, *FANUC]  # the codes of the 928 are known in part only

case(
    "the reset of a mill leaves the modal codes as they are",
    pins="reset_clears:codes", control=[MDI, HNC, HAAS], source="TApar 3402#6; general knowledge",
    evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 G19\nN20 M30",
    modal_after_reset={"plane": "G19"},
)
case(
    "the reset of a lathe-a leaves the modal codes as they are",
    pins="reset_clears:codes", control=TURNING, source="TApar 3402#6; general knowledge",
    evidence="inferred", setup={"machine": "lathe-a"},
    program="O1\nN10 G19\nN20 M30",
    modal_after_reset={"plane": "G19"},
)
case(
    "reset ends G52",
    pins="reset_clears:local-system",
    control=[TDI, MDI, *MITSUBISHI, HNC], source="TDipar 181; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G52 X10.
        N20 M30
    """,
    work_after_reset="X0",
)
case(
    "reset leaves G52 as it is while 1202#3 is 0",
    pins="reset_clears:local-system",
    control=[*GSK_988, *FANUC], source="TApar 1202#3; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G52 X10.
        N20 M30
    """,
    work_after_reset="X-10",
)
