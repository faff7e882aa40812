"""Controls that answer otherwise than the Haas NGC."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
GSK = ["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"]
WITH_MACROS = [*GSK, *MITSUBISHI, *FANUC]
OTHERS = [*WITH_MACROS, "hnc-21m", "gsk-928te"]


def on(controls, fanuc, mitsubishi, gsk_988, gsk_980):
    table = {
        **dict.fromkeys(FANUC, f"PS{fanuc}"), "fanuc-16i": fanuc[-3:], **dict.fromkeys(MITSUBISHI, mitsubishi),
        **dict.fromkeys(GSK[:2], gsk_988), **dict.fromkeys(GSK[2:], gsk_980),
    }
    return {name: table.get(name) for name in controls}


case(
    "only on the Haas a condition stands before M99", pins="conditional_return",
    control=[*WITH_MACROS, "hnc-21m"], source="HDIY: it is unique to the Haas", evidence="inferred",
    program="O1\nN10 [1 EQ 1] M99 P30\nN20 M30\nN30 M30", runs="", alarm="value-without-address", at="O1 N10", word="[",
    number=on([*WITH_MACROS, "hnc-21m"], "0004", "P33", "004", None),
)
case(
    "a condition compares two values on other controls than the Haas", pins="conditions:values",
    control=WITH_MACROS, source="X-GO; general knowledge", evidence="inferred",
    program="O1\nN10 #1=1\nN20 IF[#1]GOTO 40\nN30 M30\nN40 M30", runs="N10", alarm="if-format", at="O1 N20",
    number=on(WITH_MACROS, "1137", "P290", "201", "0101") | {"fanuc-16i": "114"},
)
case(
    "M01 calls nothing", pins="roles:M01=local-call",
    control=OTHERS, source="general knowledge", evidence="inferred", program="O1\nN10 M1\nN20 M30", runs="N10 N20",
)
case(
    "G66 and G67 stand beside G65 on other controls than the Haas", pins="roles:G66=modal-call",
    control=WITH_MACROS, source="source 002; M7V; TDi28; TA", evidence="inferred",
    program="O1\nN10 G66 P2\nN20 G0 Z5.\nN30 G67\nN40 M30\nO2\nN50 M99", runs="N10 N20 N50 N30 N40",
)
