"""A block that moves under a modal macro call and calls, returns or jumps as well: the macro of its
move comes first, and both are entered from the block's own frame."""

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
    "a subprogram that such a block calls and nobody has is missed behind the modal macro",
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
    "two modal macros of such a block run inside each other, and the call behind both from the block",
    _CHAIN, "N10 N15 N20 N85 N70 N80 N90 N95 N50 N60 N30 N40", "G66:O4(G66:O3) M98:O2",
    vars={100: 1, 101: 1, 102: 1},
)
alarms(
    "a fault of the inner of two modal macros shows both and not the call that waits",
    _CHAIN.replace("#101+1", "1/#101"), "division-by-zero", FAULT, "O3 N70", "O4 N85 G66 < O1 N20 G66",
)
alarms(
    "a fault of the call behind two modal macros shows neither",
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
    "M99 P of such a block goes to the caller of the block's program, behind the modal macro",
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
    "a modal macro whose own last block moves returns behind the outer macro of that move",
    _CHAIN.replace("N85 Z1.\nN90 #102=#102+1\nN95 M99", "N95 Z1. M99"),
    "N10 N15 N20 N95 N70 N80 N50 N60 N30 N40", "G66:O4(G66:O3) M98:O2", control=_MAY_RETURN,
)
alarms(
    "the return of a modal macro behind an outer one leaves the frames as they were",
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
    "a call by an M code behind a move waits for the modal macro", _CODE,
    "N10 N20 N70 N80 N50 N60 N30 N40", "G66:O3 M-code:O9001", control=FANUC, params={"6071": 60},
)
alarms(
    "a fault of a call by an M code behind a move shows the block alone", _CODE.replace("#100+1", "1/#100"),
    "division-by-zero", FAULT, "O9001 N50", "O1 N20 M-code", control=FANUC, params={"6071": 60},
)
_TOOL = MAIN.replace("M98 P2", "T5") + SUB.replace("O2", "O9000").replace("#100+1", "#149") + MACRO
holds(
    "a call by a T code behind a move waits for the modal macro, with the code it was called by", _TOOL,
    "N10 N20 N70 N80 N50 N60 N30 N40", "G66:O3 T-code:O9000", control=FANUC, params={"6001#5": 1},
    vars={100: 5},
)
alarms(
    "a fault of a call by a T code behind a move shows the block alone", _TOOL.replace("#149", "1/[#149-5]"),
    "division-by-zero", FAULT, "O9000 N50", "O1 N20 T-code", control=FANUC, params={"6001#5": 1},
)
_DEVICE = {"files": {"main.nc": MAIN.replace("M98 P2", "M198 P2") + MACRO}, "external": {"O2.nc": SUB}}
case(
    "M198 behind a move waits for the modal macro", control=[FF, F30], **OWN, **_DEVICE,
    runs="N10 N20 N70 N80 N50 N60 N30 N40", tree="G66:O3 M198:O2",
)
case(
    "M198 behind a move misses its program behind the modal macro", control=[FF, F30], **OWN,
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
    "a fault of G65 behind a move shows the block alone", _G65.replace("N50 #100=#1", "N50 #100=1/0"),
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
for _levels, _ends in ((4, None), (5, "macro-nesting-too-deep")):
    _chain = "".join(
        f"O{10 + i}\nN{100 + i} " + (f"G65 P{11 + i}" if i + 1 < _levels else "#100=1") + "\nM99\n"
        for i in range(_levels)
    )
    case(
        f"a chain of {_levels} macros behind the move of a block under G66 "
        f"{'is too deep' if _ends else 'is allowed'}",
        control="fanuc-16i", source="PB p.304: four levels of macro calls", evidence="maker's manual",
        program="O1\nN10 G66 P3\nN20 G91 G1 X1. F100. M98 P9\nN40 M30\nO9\nN30 G65 P10\nM99\n" + _chain + MACRO,
        alarm=_ends, number="077" if _ends else None, vars=None if _ends else {100: 1},
        frames="O12 N102 G65 < O11 N101 G65 < O10 N100 G65 < O9 N30 G65 < O1 N20 M98" if _ends
        else None,
    )

# How many modal calls may be active: each modal macro declares the next, so that a move of the main
# program finds one more each time.
for _controls, _most, _number, _source, _evidence in (
    ("fanuc-16i", 3, "122", "K-H 122: the macro modal call is specified four-fold", "inferred"),
    ([FD, FF, F30], 5, "PS0122", "ALM PS0122", "inferred"),
    (MITSUBISHI, 4, "P273", "SM 6; MZ 855", "secondary"),
    (["gsk-988ta", "gsk-988t"], 4, "207", "TA27, note 2; Talm 207", "maker's manual"),
    (["gsk-980tdi", "gsk-980mdi"], 4, None, "TDi28 3.28.3.2: four levels of G66", "secondary"),
):
    for _count in (_most, _most + 1):
        _macros = "".join(
            f"O{i + 1}\nN{10 * i} G66 P{i + 2}\nN{10 * i + 5} M99\n" if i < _count
            else f"O{i + 1}\nN999 M99\n" for i in range(1, _count + 1)
        )
        _moves = "".join(f"N{500 + i} G0 X{i}.\n" for i in range(1, _count))
        _cancels = "".join(f"N{600 + i} G67\n" for i in range(_count))
        _runs = "N1 " + " ".join(f"N{500 + i} N{10 * i} N{10 * i + 5}" for i in range(1, _count))
        _fails = _count > _most
        case(
            f"{_count} modal calls {'are too many' if _fails else 'may be active'} where {_most} are the most, "
            f"and G67 takes them away one by one on {_controls if isinstance(_controls, str) else _controls[0]}",
            pins="max_modal_calls",
            control=_controls, source=_source, evidence=_evidence,
            program=f"O1\nN1 G66 P2\n{_moves}{_cancels}N700 M30\n{_macros}",
            runs=_runs[: _runs.rindex(" N", 0, _runs.rindex(" N"))] if _fails
            else _runs + "".join(f" N{600 + i}" for i in range(_count)) + " N700",
            alarm="modal-calls-too-many" if _fails else None, number=_number if _fails else None,
            at=f"O{_count} N{10 * (_count - 1)}" if _fails else None,
            frames=f"O1 N{500 + _count - 1} G66" if _fails else None,
        )

for _block, _m in ("M#1 G67", 30), ("M#1 G67", 2), ("G67 M#1", 30):
    case(
        f"a computed M{_m} in {_block} ends the program like one that is written",
        control="fanuc-16i", source="general knowledge", evidence="inferred",
        program=f"O1\nN10 #1={_m}\nN20 {_block}\nN30 M8\nN40 M30\n", runs="N10 N20", m=[_m],
    )
