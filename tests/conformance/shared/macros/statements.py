"""The macro statements that a control has, does not have, or may have because no source says; and
the precedence of logic.
"""

from conformance import case

GSK = ["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC, TE = "hnc-21m", "gsk-928te"
KNOWN = {"source": "general knowledge", "evidence": "inferred"}


def block(text):
    return f"O1\nN10 M8\nN20 {text}\nN30 M30\n"


# A loop writes one claim over twenty statements that are refused alike.
for _text in (
    "#1=5", "#100=#1", "X#1", "X[1+2]", "G1 X-[3]", "G1 Z[#1+2]", "G#1", "M#1", "T[2]",
    "IF[1EQ1]GOTO30", "IF[1EQ1]THEN#1=5", "WHILE[1LT2]DO1", "DO1", "END1", "GOTO30",
    "DPRNT[HOLE]", "BPRNT[HOLE]", "POPEN", "PCLOS", "SETVN 510[A]",
):
    case(
        f"the 928TE, which has no macro statements, refuses {_text}", control=TE,
        source="general knowledge: no macro statements", evidence="inferred", program=block(_text),
        runs="N10", alarm="statement-not-available", number=None, at="O1 N20",
    )
case(
    "what only looks like a statement runs on the 928TE: G1 X3 F100",
    control=TE, source="source 001; general knowledge", evidence="inferred",
    program=block("G1 X3 F100"),
    runs="N10 N20 N30",
)
case(
    "what only looks like a statement runs on the 928TE: M98 P30",
    control=TE, source="source 001; general knowledge", evidence="inferred",
    program=block("M98 P30"),
    runs="N10 N20 N30",
)
case(
    "what only looks like a statement runs on the 928TE: (DPRNT[A] IF #1)",
    control=TE, source="source 001; general knowledge", evidence="inferred",
    program=block("(DPRNT[A] IF #1)"),
    runs="N10 N20 N30",
)
case(
    "nobody says whether these controls have DPRNT[HOLE]",
    control=[*GSK, HNC], source="policy: no source names it", evidence="inferred",
    program=block("DPRNT[HOLE]"),
    runs="N10", alarm="statement-not-known", number=None, at="O1 N20",
)
case(
    "nobody says whether these controls have BPRNT[HOLE]",
    control=[*GSK, HNC], source="policy: no source names it", evidence="inferred",
    program=block("BPRNT[HOLE]"),
    runs="N10", alarm="statement-not-known", number=None, at="O1 N20",
)
case(
    "nobody says whether these controls have POPEN",
    control=[*GSK, HNC], source="policy: no source names it", evidence="inferred",
    program=block("POPEN"),
    runs="N10", alarm="statement-not-known", number=None, at="O1 N20",
)
case(
    "nobody says whether these controls have PCLOS",
    control=[*GSK, HNC], source="policy: no source names it", evidence="inferred",
    program=block("PCLOS"),
    runs="N10", alarm="statement-not-known", number=None, at="O1 N20",
)
case(
    "nobody says whether a Mitsubishi has BPRNT", control=MITSUBISHI,
    source="policy: no source names it", evidence="inferred", program=block("BPRNT[HOLE]"),
    runs="N10", alarm="statement-not-known", number=None, at="O1 N20",
)
case(
    "FANUC and Mitsubishi have POPEN",
    control=[*FANUC, *MITSUBISHI], **KNOWN,
    program=block("POPEN"),
    runs="N10 N20 N30",
)
case(
    "FANUC and Mitsubishi have DPRNT[HOLE]",
    control=[*FANUC, *MITSUBISHI], **KNOWN,
    program=block("DPRNT[HOLE]"),
    runs="N10 N20 N30",
)
case(
    "DPRNT fills the places of leading zeros with blanks",
    pins="prints_leading_blanks", control=[*MITSUBISHI, "haas-ngc"],
    source="policy: as FANUC's 6001#1 = 0", evidence="inferred",
    program="O1\nN10 #100=128.5\nN20 POPEN\nN30 DPRNT[X#100[53]]\nN40 PCLOS\nN50 M30",
    runs="N10 N20 N30 N40 N50", messages=["X   128.500"],
)
case(
    "FANUC and Mitsubishi have PCLOS",
    control=[*FANUC, *MITSUBISHI], **KNOWN,
    program=block("PCLOS"),
    runs="N10 N20 N30",
)
case(
    "FANUC and Mitsubishi have #1=5",
    control=[*FANUC, *MITSUBISHI], **KNOWN,
    program=block("#1=5"),
    runs="N10 N20 N30",
)
case(
    "FANUC and Mitsubishi have IF[1EQ1]GOTO30",
    control=[*FANUC, *MITSUBISHI], **KNOWN,
    program=block("IF[1EQ1]GOTO30"),
    runs="N10 N20 N30",
)
case(
    "FANUC and Mitsubishi have G1 X[1+2] F100",
    control=[*FANUC, *MITSUBISHI], **KNOWN,
    program=block("G1 X[1+2] F100"),
    runs="N10 N20 N30",
)
case(
    "BPRNT is a statement of a FANUC", control=FANUC, source="ALM PS1143", evidence="secondary",
    program=block("BPRNT[HOLE]"), runs="N10 N20 N30",
)
case(
    "the HNC, whose loops end with ENDW, has no DO1",
    control=HNC, source="HD", evidence="secondary",
    program=block("DO1"),
    runs="N10", alarm="statement-not-available", number=None, at="O1 N20", word="DO1",
)
case(
    "the HNC, whose loops end with ENDW, has no END1",
    control=HNC, source="HD", evidence="secondary",
    program=block("END1"),
    runs="N10", alarm="statement-not-available", number=None, at="O1 N20", word="END1",
)


# Logic
def condition(text, true, controls, source, evidence):
    case(
        f"{text} is {'true' if true else 'false'} where logic of numbers binds first",
        pins="logic_order",
        control=controls, source=source, evidence=evidence,
        program=f"O1\nN10 #100=7\nN15 #101=2\nN20 IF[{text}]GOTO40\nN30 M8\nN40 M30\n",
        runs="N10 N15 N20 " + ("N40" if true else "N30 N40"),
    )


PROGRAMS = ("added.md: IF[#120AND3EQ3] in programs of a machine", "inferred")

condition("#100AND3EQ3", True, MITSUBISHI, *PROGRAMS)
condition("#101AND3EQ3", False, MITSUBISHI, *PROGRAMS)
condition("3EQ#100AND3", True, MITSUBISHI, *PROGRAMS)
condition("#100 AND 3 EQ 3", True, MITSUBISHI, *PROGRAMS)
condition("#[99+1]AND4EQ4", True, MITSUBISHI, *PROGRAMS)
condition("#[99+2]AND4EQ4", False, MITSUBISHI, *PROGRAMS)
condition("#101OR1EQ3", True, MITSUBISHI, *PROGRAMS)
condition("#100XOR5EQ2", True, MITSUBISHI, *PROGRAMS)
condition("#101+1AND2EQ2", True, MITSUBISHI, *PROGRAMS)
condition("1+#100AND4EQ5", True, MITSUBISHI, *PROGRAMS)
condition("[#100AND3]EQ3", True, MITSUBISHI, *PROGRAMS)
condition("3EQ[#100AND3]", True, MITSUBISHI, *PROGRAMS)
condition("3EQ#100AND3OR8", False, MITSUBISHI, *PROGRAMS)
condition("11EQ#100AND3OR8", True, MITSUBISHI, *PROGRAMS)
condition("ABS[#100]AND3EQ3", True, MITSUBISHI, *PROGRAMS)
condition("3EQ#100ANDABS[3]", True, MITSUBISHI, *PROGRAMS)
case(
    "#100EQ7AND#101EQ2: conditions are joined last, True",
    control=["mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
    program="O1\nN10 #100=7\nN15 #101=2\nN20 IF[#100EQ7AND#101EQ2]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N15 N20 N40",
)
case(
    "#100EQ7AND#101EQ3: conditions are joined last, False",
    control=["mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
    program="O1\nN10 #100=7\nN15 #101=2\nN20 IF[#100EQ7AND#101EQ3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N15 N20 N30 N40",
)
case(
    "#100EQ1OR#101EQ2: conditions are joined last, True",
    control=["mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
    program="O1\nN10 #100=7\nN15 #101=2\nN20 IF[#100EQ1OR#101EQ2]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N15 N20 N40",
)
case(
    "#100EQ1OR#101EQ3: conditions are joined last, False",
    control=["mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
    program="O1\nN10 #100=7\nN15 #101=2\nN20 IF[#100EQ1OR#101EQ3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N15 N20 N30 N40",
)
case(
    "[#100EQ7]AND[#101EQ2]: conditions are joined last, True",
    control=["mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
    program="""
        O1
        N10 #100=7
        N15 #101=2
        N20 IF[[#100EQ7]AND[#101EQ2]]GOTO40
        N30 M8
        N40 M30
    """,
    runs="N10 N15 N20 N40",
)
case(
    "#100EQ7AND[#101EQ2]: conditions are joined last, True",
    control=["mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
    program="O1\nN10 #100=7\nN15 #101=2\nN20 IF[#100EQ7AND[#101EQ2]]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N15 N20 N40",
)
case(
    "#100AND3EQ3AND#101EQ2: conditions are joined last, True",
    control=["mitsubishi-m700", "mitsubishi-m800"],
    source="general knowledge: comparisons, then AND, then OR", evidence="inferred",
    program="""
        O1
        N10 #100=7
        N15 #101=2
        N20 IF[#100AND3EQ3AND#101EQ2]GOTO40
        N30 M8
        N40 M30
    """,
    runs="N10 N15 N20 N40",
)
case(
    "#102=#100+#101AND2 is 9: AND binds like *, OR like +",
    control=[*MITSUBISHI, *FANUC], **KNOWN,
    program="O1\nN10 #100=7\nN15 #101=2\nN20 #102=#100+#101AND2\nN30 M30\n",
    vars={102: 9},
)
case(
    "#102=#100AND3+1 is 4: AND binds like *, OR like +",
    control=[*MITSUBISHI, *FANUC], **KNOWN,
    program="O1\nN10 #100=7\nN15 #101=2\nN20 #102=#100AND3+1\nN30 M30\n",
    vars={102: 4},
)
case(
    "#102=#101OR4*2 is 10: AND binds like *, OR like +",
    control=[*MITSUBISHI, *FANUC], **KNOWN,
    program="O1\nN10 #100=7\nN15 #101=2\nN20 #102=#101OR4*2\nN30 M30\n",
    vars={102: 10},
)
case(
    "#102=8+#101OR1 is 11: AND binds like *, OR like +",
    control=[*MITSUBISHI, *FANUC], **KNOWN,
    program="O1\nN10 #100=7\nN15 #101=2\nN20 #102=8+#101OR1\nN30 M30\n",
    vars={102: 11},
)
case(
    "#102=6AND3OR8 is 10: AND binds like *, OR like +",
    control=[*MITSUBISHI, *FANUC], **KNOWN,
    program="O1\nN10 #100=7\nN15 #101=2\nN20 #102=6AND3OR8\nN30 M30\n",
    vars={102: 10},
)
case(
    "IF[#100EQ7AND] is no condition of a Mitsubishi",
    control=MITSUBISHI, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[#100EQ7AND]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", number="P290", at="O1 N20",
)
case(
    "IF[AND#100EQ7] is no condition of a Mitsubishi",
    control=MITSUBISHI, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[AND#100EQ7]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", number="P290", at="O1 N20",
)
case(
    "IF[#100EQ7EQ1] is no condition of a Mitsubishi",
    control=MITSUBISHI, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[#100EQ7EQ1]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", number="P290", at="O1 N20",
)
case(
    "IF[#100AND[#101EQ2]] is no condition of a Mitsubishi",
    control=MITSUBISHI, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[#100AND[#101EQ2]]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", number="P290", at="O1 N20",
)
case(
    "IF[#100AND3] is no condition of a Mitsubishi",
    control=MITSUBISHI, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[#100AND3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", number="P290", at="O1 N20",
)
case(
    "IF[[#100EQ7]AND3] is no condition of a Mitsubishi",
    control=MITSUBISHI, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[[#100EQ7]AND3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", number="P290", at="O1 N20",
)
case(
    "IF[#100EQ7AND#100EQ7] without brackets is no condition of a FANUC",
    control=FANUC, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[#100EQ7AND#100EQ7]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", at="O1 N20",
    number={"fanuc-16i": "114", **dict.fromkeys(FANUC[1:], "PS1137")},
)
case(
    "IF[3EQ#100AND3EQ3] without brackets is no condition of a FANUC",
    control=FANUC, **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[3EQ#100AND3EQ3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10", alarm="if-format", at="O1 N20",
    number={"fanuc-16i": "114", **dict.fromkeys(FANUC[1:], "PS1137")},
)
case(
    "the GSK 928TE has no functions: AX[1]=1",
    control="gsk-928te", source="source 001 names none; general knowledge", evidence="inferred",
    program="%1\nN10 M8\nN20 AX[1]=1\nN30 M30\n",
    runs="N10", alarm="statement-not-available", number=None, at="%1 N20",
)
case(
    "the GSK 928TE has no functions: ABS[1]",
    control="gsk-928te", source="source 001 names none; general knowledge", evidence="inferred",
    program="%1\nN10 M8\nN20 ABS[1]\nN30 M30\n",
    runs="N10", alarm="statement-not-available", number=None, at="%1 N20",
)
case(
    "the GSK 928TE has no functions: PRM[1]",
    control="gsk-928te", source="source 001 names none; general knowledge", evidence="inferred",
    program="%1\nN10 M8\nN20 PRM[1]\nN30 M30\n",
    runs="N10", alarm="statement-not-available", number=None, at="%1 N20",
)
case(
    "the GSK 928TE has no functions: G1 X5. SQRT[4]",
    control="gsk-928te", source="source 001 names none; general knowledge", evidence="inferred",
    program="%1\nN10 M8\nN20 G1 X5. SQRT[4]\nN30 M30\n",
    runs="N10", alarm="statement-not-available", number=None, at="%1 N20",
)
case(
    "AND binds before a comparison on these controls too: #100AND3EQ3",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "gsk-980tdi"],
    **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[#100AND3EQ3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N20 N40",
)
case(
    "AND binds before a comparison on these controls too: 3EQ#100AND3",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "gsk-980tdi"],
    **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[3EQ#100AND3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N20 N40",
)
case(
    "AND binds before a comparison on these controls too: [#100AND3]EQ3",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "gsk-980tdi"],
    **KNOWN,
    program="O1\nN10 #100=7\nN20 IF[[#100AND3]EQ3]GOTO40\nN30 M8\nN40 M30\n",
    runs="N10 N20 N40",
)
case(
    "AND of numbers binds last on the HNC: a condition is missing before it", control=HNC, **KNOWN,
    pins="logic_order",
    program="%1\nN10 #50=7\nN20 IF #50 AND 3 EQ 3\nN30 M8\nN40 ENDIF\nN50 M30\n",
    runs="N10", alarm="if-format", at="%1 N20",
)
