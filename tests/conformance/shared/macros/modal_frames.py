"""A block under a modal macro call that moves and also calls, returns or jumps: the macro of its
move comes first, and both are entered from the frame of the block.
"""

from conformance import case

F16, FD, FF, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
MODAL = [*FANUC, *MITSUBISHI]
OWN = {"source": "general knowledge: words of a block before its call", "evidence": "inferred"}
FAULT = dict.fromkeys(MITSUBISHI, "P283") | {F16: "112"} | dict.fromkeys([FD, FF, F30], "PS0112")
MISSING = dict.fromkeys(MITSUBISHI, "P232") | {F16: "078"} | dict.fromkeys([FD, FF, F30], "PS0076")
NO_BLOCK = dict.fromkeys(MITSUBISHI, "P231") | {F16: "078"} | dict.fromkeys([FD, FF, F30], "PS0078")
MAIN = "O1\nN10 G66 P3\nN20 G91 G1 X1. F100. M98 P2\nN30 G67\nN40 M30\n"
SUB = "O2\nN50 #100=#100+1\nN60 M99\n"
MACRO = "O3\nN70 #101=#101+1\nN80 M99\n"


def holds(claim, program, runs, tree, control=MODAL, **more):
    case(claim, control=control, **OWN, program=program, runs=runs, tree=tree, **more)


def alarms(claim, program, cause, number, where, frames, control=MODAL, **more):
    case(
        claim, control=control, **OWN, program=program, alarm=cause,
        number={c: number[c] for c in control} if isinstance(number, dict) else number, at=where,
        frames=frames, **more,
    )


holds(
    "under G66 a block with a move and M98 runs the modal macro, then the subprogram, both from itself",
    MAIN + SUB + MACRO, "N10 N20 N70 N80 N50 N60 N30 N40", "G66:O3 M98:O2", vars={100: 1, 101: 1},
)
alarms(
    "a fault of the modal macro of such a block was called from the block alone",
    MAIN + SUB + MACRO.replace("#101+1", "1/#101"), "division-by-zero", FAULT, "O3 N70", "O1 N20 G66",
    runs="N10 N20",
)
alarms(
    "a fault of the subprogram of such a block was called from the block alone",
    MAIN + SUB.replace("#100+1", "1/#100") + MACRO, "division-by-zero", FAULT, "O2 N50", "O1 N20 M98",
    runs="N10 N20 N70 N80",
)
alarms(
    "a subprogram that such a block calls and nobody has is missed after the modal macro",
    MAIN + MACRO, "program-not-found", MISSING, "O1 N20", "", runs="N10 N20 N70 N80",
)
holds(
    "M99 P in the modal macro of such a block goes to the block's own program, and its call is not made",
    MAIN + "N90 M30\n" + SUB.replace("N50", "N90") + MACRO.replace("M99", "M99 P30"),
    "N10 N20 N70 N80 N30 N40", "G66:O3", vars={101: 1, 100: None},
)
alarms(
    "M99 P in the modal macro of such a block does not find a block of the subprogram",
    MAIN + SUB + MACRO.replace("M99", "M99 P50"), "return-target-not-found", NO_BLOCK, "O3 N80", "O1 N20 G66",
    runs="N10 N20 N70",
)
holds(
    "M99 P in the subprogram of such a block goes to the block's own program",
    MAIN.replace("N40", "N35 #102=7\nN40") + SUB.replace("M99", "M99 P35") + MACRO,
    "N10 N20 N70 N80 N50 N60 N35 N40", "G66:O3 M98:O2", vars={102: 7},
)
alarms(
    "M99 P in the subprogram of such a block does not find a block of the modal macro",
    MAIN + SUB.replace("M99", "M99 P70") + MACRO, "return-target-not-found", NO_BLOCK, "O2 N60", "O1 N20 M98",
)
holds(
    "the passes of L of such a block are the subprogram's, and the macro runs once",
    MAIN.replace("M98 P2", "M98 P2 L3") + SUB + MACRO, "N10 N20 N70 N80 (N50 N60)*3 N30 N40",
    "G66:O3 M98:O2", vars={100: 3, 101: 1}, control=[F16, FF, F30, *MITSUBISHI],
)
alarms(
    "a fault in a later pass of such a block's call has the frames of the first",
    MAIN.replace("M98 P2", "M98 P2 L3") + SUB.replace("#100+1", "1/[#100-1]") + MACRO, "division-by-zero",
    {F30: "PS0112", MITSUBISHI[1]: "P283"}, "O2 N50", "O1 N20 M98", control=[F30, MITSUBISHI[1]],
    variables={100: 2},
)
holds(
    "the passes of L of the modal macro come before the call of such a block",
    MAIN.replace("G66 P3", "G66 P3 L2") + SUB + MACRO, "N10 N20 (N70 N80)*2 N50 N60 N30 N40",
    "G66:O3 M98:O2",
)
holds(
    "the moves of the subprogram of such a block call the macro one level below it",
    MAIN + SUB.replace("N50 ", "N45 X1.\nN50 ") + MACRO, "N10 N20 N70 N80 N45 N70 N80 N50 N60 N30 N40",
    "G66:O3 M98:O2(G66:O3)", vars={101: 2},
)
alarms(
    "the macro of a move inside that subprogram was called from the subprogram",
    MAIN + SUB.replace("N50 ", "N45 X1.\nN50 ") + MACRO.replace("#101+1", "1/[1-#101]\nN75 #101=1"),
    "division-by-zero", FAULT, "O3 N70", "O2 N45 G66 < O1 N20 M98",
)

_CHAIN = MAIN.replace("N20", "N15 G66 P4\nN20") + SUB + MACRO + "O4\nN85 Z1.\nN90 #102=#102+1\nN95 M99\n"

holds(
    "two modal macros of such a block run inside each other, and the call after both from the block",
    _CHAIN, "N10 N15 N20 N85 N70 N80 N90 N95 N50 N60 N30 N40", "G66:O4(G66:O3) M98:O2",
    vars={100: 1, 101: 1, 102: 1},
)
alarms(
    "a fault of the inner of two modal macros shows both and not the call that waits",
    _CHAIN.replace("#101+1", "1/#101"), "division-by-zero", FAULT, "O3 N70", "O4 N85 G66 < O1 N20 G66",
)
alarms(
    "a fault of the call after two modal macros shows neither",
    _CHAIN.replace("#100+1", "1/#100"), "division-by-zero", FAULT, "O2 N50", "O1 N20 M98",
)

_RETURN = "O1\nN10 M98 P2\nN40 M30\nO2\nN50 G66 P3\nN60 G91 G1 X1. F100. M99\n" + MACRO
_MAY_RETURN = [F16, *MITSUBISHI]

holds(
    "a move in the block of M99 runs the modal macro as one in the block of M98 does",
    _RETURN, "N10 N50 N60 N70 N80 N40", "M98:O2(G66:O3)", control=_MAY_RETURN,
)
alarms(
    "M99 with other words alarms while a modal call is active where the control says so",
    _RETURN, "illegal-word-with-return", "PS1093", "O2 N60", "O1 N10 M98", control=[FD, FF, F30],
)
alarms(
    "a fault of the modal macro of a block with M99 shows the call that the block would end",
    _RETURN.replace("#101+1", "1/#101"), "division-by-zero", FAULT, "O3 N70", "O2 N60 G66 < O1 N10 M98",
    control=_MAY_RETURN, runs="N10 N50 N60",
)
holds(
    "M99 P of such a block goes to the caller of the block's program, after the modal macro",
    _RETURN.replace("N40", "N20 #103=1\nN30 G67\nN40").replace("M99\nO3", "M99 P30\nO3"),
    "N10 N50 N60 N70 N80 N30 N40", "M98:O2(G66:O3)", control=_MAY_RETURN,
)
alarms(
    "M99 P of such a block does not find a block of its own program",
    _RETURN.replace("M99\nO3", "M99 P50\nO3"), "return-target-not-found", NO_BLOCK, "O2 N60", "O1 N10 M98",
    control=_MAY_RETURN, runs="N10 N50 N60 N70 N80",
)
holds(
    "each pass of a subprogram whose last block moves and returns runs the modal macro",
    _RETURN.replace("N50 G66 P3\n", "").replace("N10 M98 P2", "N5 G66 P3\nN10 M98 P2 L3"),
    "N5 N10 (N60 N70 N80)*3 N40", "M98:O2(G66:O3 G66:O3 G66:O3)", control=_MAY_RETURN,
)
holds(
    "a modal macro whose own last block moves returns after the outer macro of that move",
    _CHAIN.replace("N85 Z1.\nN90 #102=#102+1\nN95 M99", "N95 Z1. M99"),
    "N10 N15 N20 N95 N70 N80 N50 N60 N30 N40", "G66:O4(G66:O3) M98:O2", control=_MAY_RETURN,
)
alarms(
    "the return of a modal macro after an outer one leaves the frames as they were",
    _CHAIN.replace("N85 Z1.\nN90 #102=#102+1\nN95 M99", "N95 Z1. M99").replace("#100+1", "1/#100"),
    "division-by-zero", FAULT, "O2 N50", "O1 N20 M98", control=_MAY_RETURN,
)
holds(
    "a main program whose last block moves and starts over runs the modal macro each cycle",
    "O1\nN10 G66 P3\nN20 G91 G1 X1. F100. M99\n" + MACRO, "(N10 N20 N70 N80)*2", "G66:O3 G66:O3",
    control=[MITSUBISHI[1], F16], max_cycles=2, stop="cycles",
)

_CODE = MAIN.replace("M98 P2", "M60") + SUB.replace("O2", "O9001") + MACRO

holds(
    "a call by an M code after a move waits for the modal macro", _CODE,
    "N10 N20 N70 N80 N50 N60 N30 N40", "G66:O3 M-code:O9001", control=FANUC, params={"6071": 60},
)
alarms(
    "a fault of a call by an M code after a move shows the block alone", _CODE.replace("#100+1", "1/#100"),
    "division-by-zero", FAULT, "O9001 N50", "O1 N20 M-code", control=FANUC, params={"6071": 60},
)

_TOOL = MAIN.replace("M98 P2", "T5") + SUB.replace("O2", "O9000").replace("#100+1", "#149") + MACRO

holds(
    "a call by a T code after a move waits for the modal macro, with the code it was called by", _TOOL,
    "N10 N20 N70 N80 N50 N60 N30 N40", "G66:O3 T-code:O9000", control=FANUC, params={"6001#5": 1},
    vars={100: 5},
)
alarms(
    "a fault of a call by a T code after a move shows the block alone", _TOOL.replace("#149", "1/[#149-5]"),
    "division-by-zero", FAULT, "O9000 N50", "O1 N20 T-code", control=FANUC, params={"6001#5": 1},
)

_DEVICE = {"files": {"main.nc": MAIN.replace("M98 P2", "M198 P2") + MACRO}, "external": {"O2.nc": SUB}}

case(
    "M198 after a move waits for the modal macro", control=[FF, F30], **OWN, **_DEVICE,
    runs="N10 N20 N70 N80 N50 N60 N30 N40", tree="G66:O3 M198:O2",
)
case(
    "M198 after a move misses its program after the modal macro", control=[FF, F30], **OWN,
    files=_DEVICE["files"], external={"O5.nc": SUB.replace("O2", "O5")}, runs="N10 N20 N70 N80",
    alarm="external-program-not-found", number="PS1079", at="O1 N20", frames="",
)

_G65 = MAIN.replace("G91 G1 X1. F100. M98 P2", "G91 G1 X1. F100. G65 P2 A#101") + SUB.replace("#100+1", "#1") + MACRO

holds(
    "where words before G65 are executed the modal macro of their move comes first, and the arguments are older",
    _G65, "N10 N20 N70 N80 N50 N60 N30 N40", "G66:O3 G65:O2", control=MITSUBISHI, vars={100: 4, 101: 5},
    variables={101: 4},
)
alarms(
    "a fault of G65 after a move shows the block alone", _G65.replace("N50 #100=#1", "N50 #100=1/0"),
    "division-by-zero", FAULT, "O2 N50", "O1 N20 G65", control=MITSUBISHI,
)

_EACH = MAIN.replace("G66 P3", "G66.1 P3") + SUB + MACRO

holds(
    "under G66.1 a block with a move and a call runs the macro first, and the call from the block's own frame",
    _EACH, "N10 N20 N70 N80 N50 N60 N30 N40", "G66.1:O3 M98:O2", control=["fanuc-30i", "mitsubishi-m700"],
)
alarms(
    "a fault of the call of a block under G66.1 shows the block alone", _EACH.replace("#100+1", "1/#100"),
    "division-by-zero", FAULT, "O2 N50", "O1 N20 M98", control=["fanuc-30i", "mitsubishi-m700"],
)

# The call of such a block is as deep as the same call alone.
case(
    "a chain of 4 macros after the move of a block under G66 is allowed",
    control="fanuc-16i", source="PB p.304: four levels of macro calls", evidence="maker's manual",
    program="""
        O1
        N10 G66 P3
        N20 G91 G1 X1. F100. M98 P9
        N40 M30
        O9
        N30 G65 P10
        M99
        O10
        N100 G65 P11
        M99
        O11
        N101 G65 P12
        M99
        O12
        N102 G65 P13
        M99
        O13
        N103 #100=1
        M99
        O3
        N70 #101=#101+1
        N80 M99
    """,
    number=None, vars={100: 1},
)
case(
    "a chain of 5 macros after the move of a block under G66 is too deep",
    control="fanuc-16i", source="PB p.304: four levels of macro calls", evidence="maker's manual",
    program="""
        O1
        N10 G66 P3
        N20 G91 G1 X1. F100. M98 P9
        N40 M30
        O9
        N30 G65 P10
        M99
        O10
        N100 G65 P11
        M99
        O11
        N101 G65 P12
        M99
        O12
        N102 G65 P13
        M99
        O13
        N103 G65 P14
        M99
        O14
        N104 #100=1
        M99
        O3
        N70 #101=#101+1
        N80 M99
    """,
    alarm="macro-nesting-too-deep", number="077",
    frames="O12 N102 G65 < O11 N101 G65 < O10 N100 G65 < O9 N30 G65 < O1 N20 M98",
)

# How many modal calls may be active: each modal macro declares the next, so a move of the main
# program finds one more each time.
case(
    "3 modal calls may be active where 3 are the most, and G67 takes them away one by one on fanuc-16i",
    pins="max_modal_calls", control="fanuc-16i",
    source="K-H 122: the macro modal call is specified four-fold", evidence="inferred",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N600 G67
        N601 G67
        N602 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N600 N601 N602 N700", number=None,
)
case(
    "4 modal calls are too many where 3 are the most, and G67 takes them away one by one on fanuc-16i",
    pins="max_modal_calls", control="fanuc-16i",
    source="K-H 122: the macro modal call is specified four-fold", evidence="inferred",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503", alarm="modal-calls-too-many", number="122",
    at="O4 N30", frames="O1 N503 G66",
)
case(
    "5 modal calls may be active where 5 are the most, and G67 takes them away one by one on fanuc-0i-d",
    pins="max_modal_calls", control=[FD, FF, F30], source="ALM PS0122", evidence="inferred",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N504 G0 X4.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N604 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N40 G66 P6
        N45 M99
        O6
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N504 N40 N45 N600 N601 N602 N603 N604 N700",
    number=None,
)
case(
    "6 modal calls are too many where 5 are the most, and G67 takes them away one by one on fanuc-0i-d",
    pins="max_modal_calls", control=[FD, FF, F30], source="ALM PS0122", evidence="inferred",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N504 G0 X4.
        N505 G0 X5.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N604 G67
        N605 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N40 G66 P6
        N45 M99
        O6
        N50 G66 P7
        N55 M99
        O7
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N504 N40 N45 N505",
    alarm="modal-calls-too-many", number="PS0122", at="O6 N50", frames="O1 N505 G66",
)
case(
    "4 modal calls may be active where 4 are the most, and G67 takes them away one by one on mitsubishi-meldas",
    pins="max_modal_calls", control=MITSUBISHI, source="SM 6; MZ 855", evidence="secondary",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N600 N601 N602 N603 N700", number=None,
)
case(
    "5 modal calls are too many where 4 are the most, and G67 takes them away one by one on mitsubishi-meldas",
    pins="max_modal_calls", control=MITSUBISHI, source="SM 6; MZ 855", evidence="secondary",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N504 G0 X4.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N604 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N40 G66 P6
        N45 M99
        O6
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N504", alarm="modal-calls-too-many",
    number="P273", at="O5 N40", frames="O1 N504 G66",
)
case(
    "4 modal calls may be active where 4 are the most, and G67 takes them away one by one on gsk-988ta",
    pins="max_modal_calls", control=["gsk-988ta", "gsk-988t"], source="TA27, note 2; Talm 207",
    evidence="maker's manual",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N600 N601 N602 N603 N700", number=None,
)
case(
    "5 modal calls are too many where 4 are the most, and G67 takes them away one by one on gsk-988ta",
    pins="max_modal_calls", control=["gsk-988ta", "gsk-988t"], source="TA27, note 2; Talm 207",
    evidence="maker's manual",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N504 G0 X4.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N604 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N40 G66 P6
        N45 M99
        O6
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N504", alarm="modal-calls-too-many",
    number="207", at="O5 N40", frames="O1 N504 G66",
)
case(
    "4 modal calls may be active where 4 are the most, and G67 takes them away one by one on gsk-980tdi",
    pins="max_modal_calls", control=["gsk-980tdi", "gsk-980mdi"],
    source="TDi28 3.28.3.2: four levels of G66", evidence="secondary",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N600 N601 N602 N603 N700", number=None,
)
case(
    "5 modal calls are too many where 4 are the most, and G67 takes them away one by one on gsk-980tdi",
    pins="max_modal_calls", control=["gsk-980tdi", "gsk-980mdi"],
    source="TDi28 3.28.3.2: four levels of G66", evidence="secondary",
    program="""
        O1
        N1 G66 P2
        N501 G0 X1.
        N502 G0 X2.
        N503 G0 X3.
        N504 G0 X4.
        N600 G67
        N601 G67
        N602 G67
        N603 G67
        N604 G67
        N700 M30
        O2
        N10 G66 P3
        N15 M99
        O3
        N20 G66 P4
        N25 M99
        O4
        N30 G66 P5
        N35 M99
        O5
        N40 G66 P6
        N45 M99
        O6
        N999 M99
    """,
    runs="N1 N501 N10 N15 N502 N20 N25 N503 N30 N35 N504", alarm="modal-calls-too-many",
    number=None, at="O5 N40", frames="O1 N504 G66",
)
case(
    "a computed M30 in M#1 G67 ends the program like one that is written",
    control="fanuc-16i", source="general knowledge", evidence="inferred",
    program="O1\nN10 #1=30\nN20 M#1 G67\nN30 M8\nN40 M30\n",
    runs="N10 N20", m=[30],
)
case(
    "a computed M2 in M#1 G67 ends the program like one that is written",
    control="fanuc-16i", source="general knowledge", evidence="inferred",
    program="O1\nN10 #1=2\nN20 M#1 G67\nN30 M8\nN40 M30\n",
    runs="N10 N20", m=[2],
)
case(
    "a computed M30 in G67 M#1 ends the program like one that is written",
    control="fanuc-16i", source="general knowledge", evidence="inferred",
    program="O1\nN10 #1=30\nN20 G67 M#1\nN30 M8\nN40 M30\n",
    runs="N10 N20", m=[30],
)
