"""Calls and variables after a reset."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MELDAS, M700, M800 = MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC, TE = "hnc-21m", "gsk-928te"

case(
    "reset makes locals and commons vacant",
    pins="reset_clears:locals reset_clears:commons",
    control=[*GSK_988, *FANUC], source="TA27, parameters 6001#6 and 6001#7; CW-G",
    evidence="secondary",
    program="""
        O1
        N10 #1=5
        N20 #100=6
        N30 M30
    """,
    vars={1: 5, 100: 6}, vars_after_reset={1: None, 100: None},
)
case(
    "reset makes locals vacant and leaves commons",
    pins="reset_clears:locals reset_clears:commons",
    control=[*GSK_980, *MITSUBISHI, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N10 #1=5
        N20 #100=6
        N30 M30
    """,
    vars={1: 5, 100: 6}, vars_after_reset={1: None, 100: 6},
)
case(
    "reset makes locals vacant and leaves commons on the HNC",
    pins="reset_clears:locals reset_clears:commons",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N10 #1=5
        N20 #50=6
        N30 M30
    """,
    vars={1: 5, 50: 6}, vars_after_reset={1: None, 50: 6},
)
