"""Variables by option: those that a control has as it stands, those that an option brings, and
those that are given by `control.replace(commons=..., variable_options=...)`.
"""

from collections.abc import Sequence

from conformance import case

MITSUBISHI = ("mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800")
FANUC = ("fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i")
GSK_988, GSK_980 = ("gsk-988ta", "gsk-988t"), ("gsk-980tdi", "gsk-980mdi")
HNC = "hnc-21m"
P241 = dict.fromkeys(MITSUBISHI, "P241")
PS = {"fanuc-16i": "115", **dict.fromkeys(FANUC[1:], "PS0115")}
NUMBERS = {**P241, **PS, **dict.fromkeys(GSK_988, "203"), **dict.fromkeys(GSK_980, "0111"), HNC: None}
SETS = "general knowledge of the maker's sets; real programs use #400 and #900000"
ADDED = "JIX; XIA; general knowledge"


def numbers(controls: Sequence[str]) -> dict[str, str | None]:
    return {name: NUMBERS[name] for name in controls}


# ---- variables of a control as it stands ----
_STANDARD = "O1\nN10 #100=1\nN20 #199=2\nN30 #500=3\nN40 #999=4\nN50 M30"

case(
    "#100 to #199 and #500 to #999 are commons without a word about options",
    pins="commons",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source=f"TApar 6001#6 and 6031; JIX; {SETS}",
    evidence="inferred", program=_STANDARD, vars={100: 1, 199: 2, 500: 3, 999: 4},
)
case(
    "GSK 980: #100 to #999 are commons in one piece",
    pins="commons",
    control=GSK_980, source="TDi28, variables", evidence="maker's manual",
    program="O1\nN10 #100=1\nN20 #200=2\nN30 #499=3\nN40 #999=4\nN50 M30",
    vars={100: 1, 200: 2, 499: 3, 999: 4},
)
case(
    "HNC-21M: #50 to #199 are its global variables",
    pins="commons",
    control=HNC, source="H9", evidence="secondary",
    program="%1\nN10 #50=1\nN20 #199=2\nN30 M30", vars={50: 1, 199: 2},
)
case(
    "FANUC 30i: #98000 to #98499 are there without a word about options",
    control="fanuc-30i", source="general knowledge", evidence="inferred",
    program="O1\nN10 #98000=1\nN20 #98499=2\nN30 M30", vars={98000: 1, 98499: 2},
)
case(
    "#99 is no common of a standard control",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC],
    source="TApar; TDi28; JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred",
    program="O1\nN10 #100=1\nN20 #99=1\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *GSK_980, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#99", vars={100: 1},
)
case(
    "#200 is no common of a standard control",
    control=[*GSK_988, *MITSUBISHI, *FANUC],
    source="TApar; TDi28; JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred",
    program="O1\nN10 #100=1\nN20 #200=1\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#200", vars={100: 1},
)
case(
    "#499 is no common of a standard control",
    control=[*GSK_988, *MITSUBISHI, *FANUC],
    source="TApar; TDi28; JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred",
    program="O1\nN10 #100=1\nN20 #499=1\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#499", vars={100: 1},
)
case(
    "#97999 is no common of a standard control",
    control=FANUC,
    source="TApar; TDi28; JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred",
    program="O1\nN10 #100=1\nN20 #97999=1\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers(FANUC), at="O1 N20", word="#97999",
    vars={100: 1},
)
case(
    "#98500 is no common of a standard control",
    control=FANUC,
    source="TApar; TDi28; JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred",
    program="O1\nN10 #100=1\nN20 #98500=1\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers(FANUC), at="O1 N20", word="#98500",
    vars={100: 1},
)
case(
    "#98000 is no common of a standard control",
    control=FANUC[:3],
    source="TApar; TDi28; JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred",
    program="O1\nN10 #100=1\nN20 #98000=1\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers(FANUC[:3]), at="O1 N20", word="#98000",
    vars={100: 1},
)
case(
    "#900000 is no common of a standard control",
    control=MITSUBISHI,
    source="TApar; TDi28; JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred",
    program="O1\nN10 #100=1\nN20 #900000=1\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers(MITSUBISHI), at="O1 N20", word="#900000",
    vars={100: 1},
)

# ---- blocks that read and write ----

# The block that uses #n, its result if the variable is there, and the word of the alarm.
_USES = {
    "written": ("N20 #{n}=7", {}, "#{n}"),
    "read": ("N20 #101=#{n}", {101: 2}, "#{n}"),
    "read by a computed number": ("N20 #101=#[{n}-1+1]", {101: 2}, None),
    "written by a computed number": ("N20 #[#100]=7", {}, None),
    "read in a condition": ("N20 IF[#{n}NE2]GOTO40", {}, "#{n}"),
    "read in a loop": ("N20 WHILE[#{n}GT5]DO1\nEND1", {}, "#{n}"),
    "read by an argument": ("N20 G65 P2 A#{n}", {101: 2}, None),
    "read by a word": ("N20 G0 X#{n}", {}, None),
    "printed": ("POPEN\nN20 DPRNT[X#{n}[53]]\nPCLOS", {}, None),
}
_TAIL = "\nN30 M30\nN40 #3000=1\nO2\nN50 #101=#1\nN60 M99"


def used(n: int, use: str, controls: Sequence[str], option: dict[str, str], source: str) -> None:
    """Write two rows: without its option the variable alarms, with the option it does not."""
    block, gives, word = _USES[use]
    text = block.format(n=n) + _TAIL
    case(
        f"#{n} is not there without its option when it is {use}",
        control=controls, source=source, evidence="inferred",
        program=f"O1\nN10 #100={n}\n{text}",
        runs="N10", alarm="illegal-variable", number=numbers(controls), at="O1 N20",
        word=word and word.format(n=n), vars={100: n},
    )
    writes = 7 if use.startswith("written") else 2
    case(
        f"#{n} is {use} where its option is fitted",
        control=controls, source=source, evidence="inferred", replace=option,
        program=f"O1\nN10 #100={n}\nN15 #{n}=2\n{text}",
        vars={100: n, n: writes, **gives},
    )


# Loops write these rows: every use of a variable, and the ends of every range.
for _use in _USES:
    used(400, _use, MITSUBISHI, {"commons": "700-sets"}, SETS)
    used(907399, _use, MITSUBISHI, {"commons": "8000-sets"}, SETS)
    used(499, _use, FANUC, {"commons": "commons-from-100"}, ADDED)
    used(98499, _use, FANUC[2:3], {"commons": "embedded-macro"}, ADDED)
for _n, _on, _how in (
    (399, MITSUBISHI, "700-sets"), (1999, MITSUBISHI, "700-sets"),
    (900000, MITSUBISHI, "700-sets"), (899999, MITSUBISHI, "8000-sets"),
    (907400, MITSUBISHI, "8000-sets"), (600, MITSUBISHI, "200-sets"),
    (700, MITSUBISHI, "300-sets"), (400, MITSUBISHI, "600-sets"),
    (150, FANUC, "basic-commons"), (199, FANUC, "basic-commons"), (499, FANUC, "basic-commons"),
    (532, FANUC, "basic-commons"), (98000, FANUC[:3], "commons-from-100"),
    (200, FANUC, "added-commons"), (98500, FANUC[2:], "embedded-macro"),
    (97999, FANUC[2:], "embedded-macro"), (98000, ["fanuc-30i"], "added-commons"),
):
    case(
        f"#{_n} is beyond the option {_how}",
        control=_on, source=f"{ADDED}; {SETS}", evidence="inferred", replace={"commons": _how},
        program=f"O1\nN10 #100=1\nN20 #101=#{_n}\nN30 M30",
        runs="N10", alarm="illegal-variable", number=numbers(_on), at="O1 N20", word=f"#{_n}",
        vars={100: 1},
    )
case(
    "the option 200-sets reaches from end to end",
    control=MITSUBISHI,
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "200-sets"},
    program="O1\nN10 #100=1\nN20 #199=2\nN30 #500=3\nN40 #599=4\nM30",
    vars={100: 1, 199: 2, 500: 3, 599: 4},
)
case(
    "the option 300-sets reaches from end to end",
    control=MITSUBISHI,
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "300-sets"},
    program="O1\nN10 #500=1\nN20 #699=2\nM30",
    vars={500: 1, 699: 2},
)
case(
    "the option 700-sets reaches from end to end",
    control=MITSUBISHI,
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "700-sets"},
    program="O1\nN10 #100=1\nN20 #199=2\nN30 #400=3\nN40 #999=4\nM30",
    vars={100: 1, 199: 2, 400: 3, 999: 4},
)
case(
    "the option 8000-sets reaches from end to end",
    control=MITSUBISHI,
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "8000-sets"},
    program="O1\nN10 #400=1\nN20 #900000=2\nN30 #907399=3\nM30",
    vars={400: 1, 900000: 2, 907399: 3},
)
case(
    "the option basic-commons reaches from end to end",
    control=FANUC,
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "basic-commons"},
    program="O1\nN10 #100=1\nN20 #149=2\nN30 #500=3\nN40 #531=4\nM30",
    vars={100: 1, 149: 2, 500: 3, 531: 4},
)
case(
    "the option added-commons reaches from end to end",
    control=FANUC,
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "added-commons"},
    program="O1\nN10 #150=1\nN20 #199=2\nN30 #532=3\nN40 #999=4\nM30",
    vars={150: 1, 199: 2, 532: 3, 999: 4},
)
case(
    "the option commons-from-100 reaches from end to end",
    control=FANUC,
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "commons-from-100"},
    program="O1\nN10 #199=1\nN20 #200=2\nN30 #499=3\nN40 #500=4\nM30",
    vars={199: 1, 200: 2, 499: 3, 500: 4},
)
case(
    "the option embedded-macro reaches from end to end",
    control=FANUC[2:],
    source="JIX; XIA; general knowledge; general knowledge of the maker's sets; real programs use #400 and #900000",
    evidence="inferred", replace={"commons": "embedded-macro"},
    program="O1\nN10 #199=1\nN20 #500=2\nN30 #98000=3\nN40 #98499=4\nM30",
    vars={199: 1, 500: 2, 98000: 3, 98499: 4},
)

# ---- ranges that a user gives ----
_GIVEN = "100-199 500-999 900000-907399"

case(
    "#99 is none of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #99=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *GSK_980, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#99", vars={101: 1},
)
case(
    "#100 is one of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #100=2\nN30 M30",
    vars={101: 1, 100: 2},
)
case(
    "#199 is one of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #199=2\nN30 M30",
    vars={101: 1, 199: 2},
)
case(
    "#200 is none of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #200=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *GSK_980, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#200", vars={101: 1},
)
case(
    "#499 is none of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #499=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *GSK_980, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#499", vars={101: 1},
)
case(
    "#500 is one of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #500=2\nN30 M30",
    vars={101: 1, 500: 2},
)
case(
    "#999 is one of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #999=2\nN30 M30",
    vars={101: 1, 999: 2},
)
case(
    "#899999 is none of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #899999=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *GSK_980, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#899999", vars={101: 1},
)
case(
    "#900000 is one of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #900000=2\nN30 M30",
    vars={101: 1, 900000: 2},
)
case(
    "#907399 is one of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #907399=2\nN30 M30",
    vars={101: 1, 907399: 2},
)
case(
    "#907400 is none of the commons that were given",
    control=[*GSK_988, *GSK_980, *MITSUBISHI, *FANUC], source="inferred: the caller's list",
    evidence="inferred", replace={"commons": _GIVEN},
    program="O1\nN10 #101=1\nN20 #907400=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=numbers([*GSK_988, *GSK_980, *MITSUBISHI, *FANUC]),
    at="O1 N20", word="#907400", vars={101: 1},
)
case(
    "HNC-21M: #49 is there beside commons to 150 and from 910",
    control=HNC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "50-150 910-950"},
    program="%1\nN10 #50=1\nN20 #49=2\nN30 M30",
    runs="N10 N20 N30", vars={50: 1, 49: 2},
)
case(
    "HNC-21M: #150 is there beside commons to 150 and from 910",
    control=HNC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "50-150 910-950"},
    program="%1\nN10 #50=1\nN20 #150=2\nN30 M30",
    runs="N10 N20 N30", vars={50: 1, 150: 2},
)
case(
    "HNC-21M: #151 is not there beside commons to 150 and from 910",
    control=HNC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "50-150 910-950"},
    program="%1\nN10 #50=1\nN20 #151=2\nN30 M30",
    runs="N10", alarm="illegal-variable", at="%1 N20", vars={50: 1, },
)
case(
    "HNC-21M: #899 is there beside commons to 150 and from 910",
    control=HNC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "50-150 910-950"},
    program="%1\nN10 #50=1\nN20 #899=2\nN30 M30",
    runs="N10 N20 N30", vars={50: 1, 899: 2},
)
case(
    "HNC-21M: #900 is not there beside commons to 150 and from 910",
    control=HNC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "50-150 910-950"},
    program="%1\nN10 #50=1\nN20 #900=2\nN30 M30",
    runs="N10", alarm="illegal-variable", at="%1 N20", vars={50: 1, },
)
case(
    "HNC-21M: #950 is there beside commons to 150 and from 910",
    control=HNC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "50-150 910-950"},
    program="%1\nN10 #50=1\nN20 #950=2\nN30 M30",
    runs="N10 N20 N30", vars={50: 1, 950: 2},
)
case(
    "HNC-21M: #951 is not there beside commons to 150 and from 910",
    control=HNC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "50-150 910-950"},
    program="%1\nN10 #50=1\nN20 #951=2\nN30 M30",
    runs="N10", alarm="illegal-variable", at="%1 N20", vars={50: 1, },
)
case(
    "a loop over commons that were given ends in the alarm of the first that is none",
    control=FANUC, source="inferred: the caller's list", evidence="inferred",
    replace={"commons": "100-110 600-603"},
    program="""
        O1
        N10 #1=600
        N20 WHILE[#1LE610]DO1
        N30 #[#1]=#1
        N40 #1=#1+1
        N50 END1
        N60 M30
    """,
    runs="N10 N20 (N30 N40 N50 N20)*4", alarm="illegal-variable", number=PS, at="O1 N30",
    vars={600: 600, 601: 601, 602: 602, 603: 603},
)
case(
    "of commons that were given those below #500 are vacant after a reset",
    control=FANUC, source="JIX; CW-G, parameter 6001#6 CCV", evidence="inferred",
    replace={"commons": "100-110 499-501"},
    program="O1\nN10 #499=1\nN20 #500=2\nN30 M30",
    vars={499: 1, 500: 2}, vars_after_reset={499: None, 500: 2},
)
case(
    "a code that calls a macro has no common for its value",
    control=FANUC, source="source 002, T codes", evidence="inferred", params={"6001#5": 1},
    replace={"commons": "500-999"},
    program="O1\nN10 #500=1\nN20 T5\nN30 M30\nO9000\nN40 M99",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", vars={500: 1},
)
case(
    "a code that calls a macro leaves its value in #149 of the basic commons",
    control=FANUC, source="source 002, T codes", evidence="inferred", params={"6001#5": 1},
    replace={"commons": "basic-commons"},
    program="O1\nN10 #500=1\nN20 T5\nN30 M30\nO9000\nN40 M99", vars={149: 5, 500: 1},
)

# ---- system variables by option ----
BY_AXIS = {"variable_options": "work-offsets-by-axis"}
_AXES = "FANUC's variables of work offsets by axis: general knowledge, real programs"

case(
    "#2501 to #2806 are the work offsets that #5221 to #5324 are",
    control=FANUC, source=_AXES, evidence="inferred", replace=BY_AXIS,
    program="""
        O1
        N10 #2500=1
        N20 #2601=2
        N30 #5243=3
        N40 #2806=4
        N50 #100=#5201
        N60 #101=#5222
        N70 #102=#2702
        N80 #103=#5324
        N90 M30
    """,
    vars={100: 1, 101: 2, 102: 3, 103: 4},
)
case(
    "a move goes by the offset that #2501 holds",
    control=FANUC, source=_AXES, evidence="inferred", replace=BY_AXIS,
    program="O1\nN10 #2501=10\nN20 G54 G90 G0 X1.\nN30 M30", final_machine="X11 Y0 Z0",
)
case(
    "#2499 is not there beside work offsets by axis",
    control=FANUC, source=_AXES, evidence="inferred", replace=BY_AXIS,
    program="O1\nN10 #100=1\nN20 #2499=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", word="#2499", vars={100: 1},
)
case(
    "#2507 is not there beside work offsets by axis",
    control=FANUC, source=_AXES, evidence="inferred", replace=BY_AXIS,
    program="O1\nN10 #100=1\nN20 #2507=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", word="#2507", vars={100: 1},
)
case(
    "#2600 is not there without work offsets by axis",
    pins="variable_options", control=FANUC, source=_AXES, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #2600=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", word="#2600", vars={100: 1},
)
case(
    "#2607 is not there beside work offsets by axis",
    control=FANUC, source=_AXES, evidence="inferred", replace=BY_AXIS,
    program="O1\nN10 #100=1\nN20 #2607=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", word="#2607", vars={100: 1},
)
case(
    "#2701 is not there without work offsets by axis",
    pins="variable_options", control=FANUC, source=_AXES, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #2701=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", word="#2701", vars={100: 1},
)
case(
    "#2806 is not there without work offsets by axis",
    pins="variable_options", control=FANUC, source=_AXES, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #2806=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", word="#2806", vars={100: 1},
)
case(
    "#2807 is not there beside work offsets by axis",
    control=FANUC, source=_AXES, evidence="inferred", replace=BY_AXIS,
    program="O1\nN10 #100=1\nN20 #2807=2\nN30 M30",
    runs="N10", alarm="illegal-variable", number=PS, at="O1 N20", word="#2807", vars={100: 1},
)

FROM_2201 = {"variable_options": "offsets-from-2201"}
_WEAR = "Mitsubishi's tool offsets: general knowledge, real programs"

case(
    "#2201, #2401 and #2601 are the offsets that #11001, #16001 and #17001 are",
    control=MITSUBISHI, source=_WEAR, evidence="inferred", replace=FROM_2201,
    program="""
        O1
        N10 #2201=1
        N20 #16002=2
        N30 #2601=3
        N40 #2400=4
        N50 #100=#11001
        N60 #101=#2402
        N70 #102=#17001
        N80 #103=#11200
        N90 M30
    """,
    vars={100: 1, 101: 2, 102: 3, 103: 4},
)
case(
    "#2201 is not there without offsets from #2201",
    pins="variable_options", control=MITSUBISHI, source=_WEAR, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #101=#2201\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#2401 is not there without offsets from #2201",
    pins="variable_options", control=MITSUBISHI, source=_WEAR, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #101=#2401\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#2601 is not there without offsets from #2201",
    pins="variable_options", control=MITSUBISHI, source=_WEAR, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #101=#2601\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#2800 is not there without offsets from #2201",
    pins="variable_options", control=MITSUBISHI, source=_WEAR, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #101=#2800\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#2801 is not there beside offsets from #2201",
    control=MITSUBISHI, source=_WEAR, evidence="inferred",
    replace=FROM_2201,
    program="O1\nN10 #100=1\nN20 #101=#2801\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)

READING = {"variable_options": "parameter-reading"}
_READ = "Mitsubishi's reading of parameters: general knowledge, real programs"

case(
    "#100010 reads the parameter whose number #100000 holds",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace=READING,
    params={"1174": 120, "1176": 60},
    program="""
        O1
        N10 #100000=1174
        N20 #100001=1
        N30 #100002=1
        N40 #100=#100010
        N50 #100000=1176
        N60 #101=#100010
        N70 M30
    """,
    vars={100: 120, 101: 60},
)
case(
    "#100010 cannot be written",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace=READING,
    program="O1\nN10 #100000=1174\nN20 #100010=5\nN30 M30",
    runs="N10", alarm="variable-write-protected",
    number=dict.fromkeys(MITSUBISHI, "P243"), at="O1 N20", word="#100010",
)
case(
    "#99999 is not there beside the reading of parameters",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace=READING,
    program="O1\nN10 #100=1\nN20 #101=#99999\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#100000 is not there without the reading of parameters",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #101=#100000\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#100003 is not there beside the reading of parameters",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace=READING,
    program="O1\nN10 #100=1\nN20 #101=#100003\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#100009 is not there beside the reading of parameters",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace=READING,
    program="O1\nN10 #100=1\nN20 #101=#100009\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#100010 is not there without the reading of parameters",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace={},
    program="O1\nN10 #100=1\nN20 #101=#100010\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
case(
    "#100011 is not there beside the reading of parameters",
    control=MITSUBISHI, source=_READ, evidence="inferred", replace=READING,
    program="O1\nN10 #100=1\nN20 #101=#100011\nN30 M30",
    runs="N10", alarm="illegal-variable", number=P241, at="O1 N20", vars={100: 1},
)
