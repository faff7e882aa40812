"""Corners of lathes in the older form: I and K between moves at right angles."""

from conformance import case

F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
OTHERS = ["gsk-988ta", "gsk-988t", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800",
          "gsk-980tdi", "gsk-928te"]
AT = {"machine": "lathe-a", "start": {"X": 20, "Z": 0}}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}


def on_fanuc(number):
    return {F16: number, **dict.fromkeys(FANUC_PS, f"PS0{number}")}


case(
    "I behind a move along Z is a chamfer towards X, K behind one along X a chamfer towards Z",
    pins="chamfer_ik",
    control=FANUC, **KNOWN, setup=AT,
    program="O1\nN10 G1 Z-20. I3. F0.2\nN20 X50. K-2.\nN30 Z-40.\nN40 M30",
    moves="F Z-17\nF X26 Z-20\nF X46 Z-20\nF X50 Z-22\nF Z-40",
)
case(
    "I and K are no chamfer", control=OTHERS, **KNOWN, setup=AT,
    pins="chamfer_ik",
    program="O1\nN10 G97 S100 G1 Z-20. I3. F0.2\nN20 X50. K-2.\nN30 Z-40.\nN40 M30",
    moves="F Z-20\nF X50\nF Z-40",
)
case(
    "a chamfer by K in a taper alarms",
    control=FANUC, source="ALM 054", evidence="secondary", setup=AT,
    program="O1\nN10 G1 X30. Z-20. K3. F0.2\nN20 Z-40.\nN30 M30",
    alarm="corner-taper", number=on_fanuc("054"), word="K3.",
)
case(
    "a chamfer by both I and K alarms",
    control=FANUC, source="ALM 053", evidence="secondary", setup=AT,
    program="O1\nN10 G1 Z-20. I3. K3. F0.2\nN20 X40.\nN30 M30",
    alarm="corner-format", number=on_fanuc("053"), word="K3.",
)
case(
    "a chamfer by I longer than its move alarms",
    control=FANUC, source="ALM 055", evidence="secondary", setup=AT,
    program="O1\nN10 G1 Z-2. I3. F0.2\nN20 X40.\nN30 M30",
    alarm="corner-too-short", number=on_fanuc("055"), word="I3.",
)
