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
    "I after a move along Z is a chamfer towards X, K after one along X a chamfer towards Z",
    pins="chamfer_ik",
    control=FANUC, **KNOWN, setup=AT,
    program="O1\nN10 G1 Z-20. I3. F0.2\nN20 X50. K-2.\nN30 Z-40.\nN40 M30",
    moves="F Z-17\nF X26 Z-20\nF X46 Z-20\nF X50 Z-22\nF Z-40",
)
for _zero in ("G54", "EXT"):
    case(
        f"a chamfer does not know where {_zero} lies: the ends of its moves are compared where they are programmed",
        control=FANUC, **KNOWN, setup={"machine": "lathe-a", "work_offsets": {_zero: {"X": 1, "Z": 0.003}}},
        program="O1\nN10 G0 X31.69 Z0\nN20 G98 G1 Z21.95 I-5.5 F300\nN30 X20.\nN40 G0 X31.69 Z0\n"
                "N50 G1 X50. K2.\nN60 Z10.\nN70 M30",
        moves="R X31.69 Z0\nF Z16.45\nF X20.69 Z21.95\nF X20\nR X31.69 Z0\nF X46 Z0\nF X50 Z2\nF Z10",
    )
case(
    "a coordinate that was set by G50, or that increments add up to, is no taper either",
    control=FANUC, **KNOWN, setup={"machine": "lathe-a", "start": {"X": 0, "Z": 0}},
    program="O1\nN10 G50 X100.303\nN20 G0 X0.1\nN30 U0.2\nN40 G98 G1 X0.3 Z-10. I1. F300\nN50 X20.\nN60 M30",
    moves="R X0.1\nR X0.3\nF Z-9\nF X2.3 Z-10\nF X20",
)
case(
    "a move that leads an increment aside is a taper",
    control=FANUC, **KNOWN, setup={"machine": "lathe-a", "start": {"X": 0, "Z": 0}},
    program="O1\nN10 G0 X20. Z0\nN20 G98 G1 X20.001 Z-10. I1. F300\nN30 X30.\nN40 M30",
    alarm="corner-taper", number=on_fanuc("054"), word="I1.",
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
