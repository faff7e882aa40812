"""Motion, rule by rule: turning cycles."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
GSK_LATHES = [*GSK_988, TDI, TE]
LATHE = {"machine": "lathe-a"}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
TOOL = LATHE | {"tools": {1: {"X": 1, "Z": 0}}}

case(
    "a tool offset is a shift of the coordinates and moves nothing",
    pins="tool_offset tool_offset_digits",
    control=[*GSK_LATHES, *MITSUBISHI, *FANUC],
    source="TApar 5002#4; TDipar 003#4; general knowledge", evidence="inferred", setup=TOOL,
    program="""
        O1
        N10 T0201
        N20 M30
    """,
    moves="none", final_work="X-1",
)
case(
    "G50 sets the coordinates of the point with the tool offset in it",
    pins="set_coordinate_without_tool",
    control=[*GSK_988, TE, *MITSUBISHI, *FANUC], **KNOWN, setup=TOOL,
    program="""
        O1
        N10 T0201
        N20 G50 X10.
        N30 M30
    """,
    final_work="X10",
)
case(
    "of X and U in one block X counts",
    control=[*GSK_LATHES, *MITSUBISHI, *FANUC], source="TDi 2; for others: policy", evidence="inferred",
    setup=LATHE | {"start": {"X": 20, "Z": 0}},
    program="""
        O1
        N10 G0 X10. U5.
        N20 M30
    """,
    moves="R X10",
)
