"""Which macro statements a control has, does not have, or may have for all that anybody says; and
how tightly logic binds.
"""

from conformance import case

GSK = ["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC, TE = "hnc-21m", "gsk-928te"
KNOWN = {"source": "general knowledge", "evidence": "inferred"}


def block(text):
    return f"O1\nN10 M8\nN20 {text}\nN30 M30\n"


for _text in (
    "#1=5", "#100=#1", "X#1", "X[1+2]", "G1 X-[3]", "G1 Z[#1+2]", "G#1", "M#1", "T[2]",
    "IF[1EQ1]GOTO30", "IF[1EQ1]THEN#1=5", "WHILE[1LT2]DO1", "DO1", "END1", "GOTO30",
    "DPRNT[HOLE]", "BPRNT[HOLE]", "POPEN", "PCLOS", "SETVN 510[A]",
):
    case(
        f"the 928TE, which has no macro statements, refuses {_text}", control=TE,
        pins="statements",
        source="general knowledge: no macro statements", evidence="inferred", program=block(_text),
        runs="N10", alarm="statement-not-available", number=None, at="O1 N20",
    )
for _text in ("G1 X3 F100", "M98 P30", "(DPRNT[A] IF #1)"):
    case(
        f"what only looks like a statement runs on the 928TE: {_text}", control=TE,
        source="source 001; general knowledge", evidence="inferred", program=block(_text), stop="end",
    )
for _text in ("DPRNT[HOLE]", "BPRNT[HOLE]", "POPEN", "PCLOS"):
    case(
        f"nobody says whether these controls have {_text}", control=[*GSK, HNC],
        source="policy: no source names it", evidence="inferred", program=block(_text),
        runs="N10", alarm="statement-not-known", number=None, at="O1 N20",
    )
case(
    "nobody says whether a Mitsubishi has BPRNT", control=MITSUBISHI,
    source="policy: no source names it", evidence="inferred", program=block("BPRNT[HOLE]"),
    runs="N10", alarm="statement-not-known", number=None, at="O1 N20",
)
for _text in ("POPEN", "DPRNT[HOLE]", "PCLOS", "#1=5", "IF[1EQ1]GOTO30", "G1 X[1+2] F100"):
    case(
        f"FANUC and Mitsubishi have {_text}", control=[*FANUC, *MITSUBISHI], **KNOWN,
        program=block(_text), runs="N10 N20 N30",
    )
case(
    "BPRNT is a statement of a FANUC", control=FANUC, source="ALM PS1143", evidence="secondary",
    program=block("BPRNT[HOLE]"), runs="N10 N20 N30",
)
for _text in ("DO1", "END1"):
    case(
        f"the HNC, whose loops end with ENDW, has no {_text}", control=HNC, source="HD",
        evidence="secondary", program=block(_text), runs="N10",
        alarm="statement-not-available", number=None, at="O1 N20", word=_text,
    )

# Logic

def condition(text, true, controls, source, evidence):
    case(
        f"{text} is {'true' if true else 'false'} where logic of numbers binds first",
        pins="logic_of_numbers",
        control=controls, source=source, evidence=evidence,
        program=f"O1\nN10 #100=7\nN15 #101=2\nN20 IF[{text}]GOTO40\nN30 M8\nN40 M30\n",
        runs="N10 N15 N20 " + ("N40" if true else "N30 N40"),
    )


PROGRAMS = ("added.md: IF[#120AND3EQ3] in programs of a machine", "inferred")
for _text, _true in (
    ("#100AND3EQ3", True), ("#101AND3EQ3", False), ("3EQ#100AND3", True), ("#100 AND 3 EQ 3", True),
    ("#[99+1]AND4EQ4", True), ("#[99+2]AND4EQ4", False), ("#101OR1EQ3", True),
    ("#100XOR5EQ2", True), ("#101+1AND2EQ2", True), ("1+#100AND4EQ5", True),
    ("[#100AND3]EQ3", True), ("3EQ[#100AND3]", True), ("3EQ#100AND3OR8", False),
    ("11EQ#100AND3OR8", True), ("ABS[#100]AND3EQ3", True), ("3EQ#100ANDABS[3]", True),
):
    condition(_text, _true, MITSUBISHI, *PROGRAMS)
for _text, _true in (
    ("#100EQ7AND#101EQ2", True), ("#100EQ7AND#101EQ3", False), ("#100EQ1OR#101EQ2", True),
    ("#100EQ1OR#101EQ3", False), ("[#100EQ7]AND[#101EQ2]", True), ("#100EQ7AND[#101EQ2]", True),
    ("#100AND3EQ3AND#101EQ2", True),
):
    case(
        f"{_text}: conditions are joined last, {_true}", control=["mitsubishi-m700", "mitsubishi-m800"],
        source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
        program=f"O1\nN10 #100=7\nN15 #101=2\nN20 IF[{_text}]GOTO40\nN30 M8\nN40 M30\n",
        runs="N10 N15 N20 " + ("N40" if _true else "N30 N40"),
    )
for _text, _value in (
    ("#100+#101AND2", 9), ("#100AND3+1", 4), ("#101OR4*2", 10), ("8+#101OR1", 11), ("6AND3OR8", 10),
):
    case(
        f"#102={_text} is {_value}: AND binds like *, OR like +",
        control=[*MITSUBISHI, *FANUC], **KNOWN,
        program=f"O1\nN10 #100=7\nN15 #101=2\nN20 #102={_text}\nN30 M30\n", vars={102: _value},
    )
for _text in ("#100EQ7AND", "AND#100EQ7", "#100EQ7EQ1", "#100AND[#101EQ2]", "#100AND3", "[#100EQ7]AND3"):
    case(
        f"IF[{_text}] is no condition of a Mitsubishi", control=MITSUBISHI, **KNOWN,
        program=f"O1\nN10 #100=7\nN20 IF[{_text}]GOTO40\nN30 M8\nN40 M30\n",
        runs="N10", alarm="if-format", number="P290", at="O1 N20",
    )
for _text in ("#100EQ7AND#100EQ7", "3EQ#100AND3EQ3"):
    case(
        f"IF[{_text}] without brackets is no condition of a FANUC", control=FANUC, **KNOWN,
        program=f"O1\nN10 #100=7\nN20 IF[{_text}]GOTO40\nN30 M8\nN40 M30\n",
        runs="N10", alarm="if-format", at="O1 N20",
        number={"fanuc-16i": "114", **dict.fromkeys(FANUC[1:], "PS1137")},
    )
for _word in "AX[1]=1", "ABS[1]", "PRM[1]", "G1 X5. SQRT[4]":
    case(
        f"the GSK 928TE has no functions: {_word}", control="gsk-928te",
        source="source 001 names none; general knowledge", evidence="inferred",
        program=f"%1\nN10 M8\nN20 {_word}\nN30 M30\n",
        runs="N10", alarm="statement-not-available", number=None, at="%1 N20",
    )
for _text in ("#100AND3EQ3", "3EQ#100AND3", "[#100AND3]EQ3"):
    case(
        f"AND binds before a comparison on these controls too: {_text}",
        control=[c for c in (*FANUC, *GSK) if c != "gsk-980mdi"], **KNOWN,
        program=f"O1\nN10 #100=7\nN20 IF[{_text}]GOTO40\nN30 M8\nN40 M30\n", runs="N10 N20 N40",
    )
case(
    "AND of numbers binds last on the HNC: a condition is missing before it", control=HNC, **KNOWN,
    pins="logic_of_numbers",
    program="%1\nN10 #50=7\nN20 IF #50 AND 3 EQ 3\nN30 M8\nN40 ENDIF\nN50 M30\n",
    runs="N10", alarm="if-format", at="%1 N20",
)
