"""#4001 to #4022 and #4101 to #4130: the modal codes and words of the block before, by number."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = "gsk-980tdi", "gsk-980mdi"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
M7 = {"source": "M700V manual, printed p.331", "evidence": "maker's manual"}
REG = {"source": "REG; general knowledge", "evidence": "secondary"}
_WORDS = """
    O7
    N10 G0 X1. F250 S800 T3 M8
    N20 G43 H2 Z1.
    N30 G41 D4 X2.
    N40 G40 X3.
    N50 #100=#4107
    #101=#4109
    #102=#4111
    #103=#4113
    #104=#4114
    #105=#4115
    #106=#4119
    #107=#4120
    N60 M30
"""
_VALUES = {100: 4, 101: 250, 102: 2, 103: 8, 105: 7, 106: 800, 107: 3}

case(
    "Mitsubishi: D is #4107, F #4109, H #4111, M #4113, O #4115, S #4119, T #4120",
    control=MITSUBISHI, **M7, program=_WORDS, vars=_VALUES,
)
case(
    "a mill's D is #4107, F #4109, H #4111, M #4113, O #4115, S #4119, T #4120",
    control=[*FANUC, MDI], **REG, program=_WORDS, vars=_VALUES,
)
case(
    "Mitsubishi: #4307 to #4320 are the same words of the running block",
    control=MITSUBISHI, **M7,
    program=_WORDS.replace("#41", "#43"), vars=_VALUES,
)
case(
    "N is #4114",
    control=[*MITSUBISHI, TDI, MDI, *GSK_988, *FANUC], source="M700V manual, printed p.331; TDi28; REG",
    evidence="secondary",
    program="O1\nN10 G0 X1.\nN20 #100=#4114\nN30 M30",
    vars={100: 10},
)
case(
    "F is #4109 on a GSK lathe, S #4119, T #4120",
    control=[TDI, *GSK_988], source="TDi28, modal information", evidence="maker's manual",
    program="O1\nN10 G0 X1. F250 S800 T0100\nN20 #100=#4109\n#101=#4119\n#102=#4120\nN30 M30",
    vars={100: 250, 101: 800, 102: 100},
)
case(
    "there is no #4104, which the letter alone would give",
    control=[*MITSUBISHI, TDI, MDI, *GSK_988, *FANUC],
    source="M700V manual, printed p.331; TDi28; REG", evidence="secondary",
    program="O1\nN10 #100=1\nN20 #100=#4104\nN30 M30",
    runs="N10", alarm="illegal-variable", vars={100: 1}, at="O1 N20",
    number={**dict.fromkeys(MITSUBISHI, "P241"), TDI: "0111", MDI: "0111", **dict.fromkeys(GSK_988, "203"), "fanuc-16i": "115", **dict.fromkeys(FANUC[1:], "PS0115")},
)
case(
    "there is no #4105, which the letter alone would give",
    control=[*MITSUBISHI, TDI, MDI, *GSK_988, *FANUC],
    source="M700V manual, printed p.331; TDi28; REG", evidence="secondary",
    program="O1\nN10 #100=1\nN20 #100=#4105\nN30 M30",
    runs="N10", alarm="illegal-variable", vars={100: 1}, at="O1 N20",
    number={**dict.fromkeys(MITSUBISHI, "P241"), TDI: "0111", MDI: "0111", **dict.fromkeys(GSK_988, "203"), "fanuc-16i": "115", **dict.fromkeys(FANUC[1:], "PS0115")},
)
case(
    "there is no #4106, which the letter alone would give",
    control=[*MITSUBISHI, TDI, MDI, *GSK_988, *FANUC],
    source="M700V manual, printed p.331; TDi28; REG", evidence="secondary",
    program="O1\nN10 #100=1\nN20 #100=#4106\nN30 M30",
    runs="N10", alarm="illegal-variable", vars={100: 1}, at="O1 N20",
    number={**dict.fromkeys(MITSUBISHI, "P241"), TDI: "0111", MDI: "0111", **dict.fromkeys(GSK_988, "203"), "fanuc-16i": "115", **dict.fromkeys(FANUC[1:], "PS0115")},
)
case(
    "the 980TDi has no #4003",
    control=TDI, source="TDi28, modal information", evidence="maker's manual",
    program="O1\nN10 #100=1\nN20 #100=#4003\nN30 M30",
    runs="N10", alarm="illegal-variable", number="0111", vars={100: 1}, at="O1 N20",
)
case(
    "the 980TDi has no #4008",
    control=TDI, source="TDi28, modal information", evidence="maker's manual",
    program="O1\nN10 #100=1\nN20 #100=#4008\nN30 M30",
    runs="N10", alarm="illegal-variable", number="0111", vars={100: 1}, at="O1 N20",
)
case(
    "the 980TDi has no #4010",
    control=TDI, source="TDi28, modal information", evidence="maker's manual",
    program="O1\nN10 #100=1\nN20 #100=#4010\nN30 M30",
    runs="N10", alarm="illegal-variable", number="0111", vars={100: 1}, at="O1 N20",
)
case(
    "the 980TDi has no #4013",
    control=TDI, source="TDi28, modal information", evidence="maker's manual",
    program="O1\nN10 #100=1\nN20 #100=#4013\nN30 M30",
    runs="N10", alarm="illegal-variable", number="0111", vars={100: 1}, at="O1 N20",
)

_READ = "\n".join(f"#{100 + g}=#{4000 + g}" for g in (1, 2, 3, 5, 6, 7, 8, 9, 10))

case(
    "the first ten groups are motion, plane, G90, feed, unit, radius, length, cycle, return",
    control=[*MITSUBISHI, *FANUC, MDI], source="REG; general knowledge of the makers' tables",
    evidence="inferred",
    program=f"O1\nG20\nN10 G1 G18 G91 G95\nN20 G99\n{_READ}\nN30 M30",
    vars={101: 1, 102: 18, 103: 91, 105: 95, 106: 20, 107: 40, 108: 49, 109: 80, 110: 99},
)
case(
    "Mitsubishi: #4012 work system, #4013 path, #4014 modal call, #4017 surface speed, #4018 polar",
    control=MITSUBISHI, source="general knowledge, modal information", evidence="inferred",
    program="O1\nN10 G56 G61\nN20 G97\n#100=#4012\n#101=#4013\n#102=#4014\n#103=#4017\n#104=#4018\nN30 M30",
    vars={100: 56, 101: 61, 102: 67, 103: 97, 104: 15},
)
case(
    "a mill of FANUC's groups: #4012 modal call, #4013 surface speed, #4014 work system, #4015 path, #4017 polar",
    control=FANUC, **REG,
    program="O1\nN10 G56 G61\nN20 G97\n#100=#4014\n#101=#4015\n#102=#4012\n#103=#4013\n#104=#4017\nN30 M30",
    vars={100: 56, 101: 61, 102: 67, 103: 97, 104: 15},
)
case(
    "the 980TDi: #4002 surface speed, #4005 feed, #4006 unit, #4007 radius, #4014 work system, #4016 plane",
    control=TDI, source="TDi28, modal information", evidence="maker's manual",
    program="O1\nN10 G0 G98 G97\nN20 G55\n#100=#4001\n#101=#4002\n#102=#4005\n#103=#4006\n#104=#4007\n#105=#4014\n#106=#4016\nN30 M30",
    vars={100: 0, 101: 97, 102: 98, 103: 21, 104: 40, 105: 55, 106: 18},
)
case(
    "#4130 is the number of the extra work system in force",
    control=FANUC, source="general knowledge, #4130", evidence="inferred",
    program="O1\nN10 G54.1 P3\nN20 #100=#4130\nN30 G54\nN40 #101=#4130\nN50 M30",
    vars={100: 3, 101: 0},
)
