"""Okuma OSP: GOTO and IF."""

from conformance import case

RUN = {"control": "okuma-osp-p300", "source": "OKA 2237, 2238", "evidence": "secondary"}
MACROS = {"control": "okuma-osp-p300", "source": "OKM, OROTA.SSB: IF[PX NE EMPTY] NXT1", "evidence": "secondary"}
KNOWN = {"control": "okuma-osp-p300", "source": "general knowledge of the Okuma OSP", "evidence": "inferred"}

case("GOTO goes on at a name", **RUN, program="O1\nN10 GOTO N30\nN20 G0 X1\nN30 M02", runs="N10 N30")
case("before it too", **RUN,
     program="O1\nN10 V1=V1+1\nN20 IF [V1 EQ 3] N40\nN30 GOTO N10\nN40 M02", runs="(N10 N20 N30)*2 N10 N20 N40")
case("GOTO needs a name", **RUN, program="O1\nN10 GOTO\nN20 M02", runs="", alarm="statement-format", number="2237 1", at="O1 N10", word="GOTO")
case("that a block has", **RUN,
     program="O1\nN10 GOTO N50\nN20 M02", runs="", alarm="jump-target-not-found", number="2237 2", at="O1 N10", word="N50")
case("a name of letters", **RUN,
     program="O1\nN10 GOTO NXT\nN20 M02", runs="", alarm="jump-target-not-found", number="2237 2", at="O1 N10", word="NXT")
case("with the same zeros, or it is told", **KNOWN,
     program="O1\nN10 GOTO N0050\nN20 M02\nN50 M02", runs="", alarm="code-not-computed", at="O1 N10", word="N0050")
case("of one block, or it is told", **KNOWN,
     program="O1\nN10 GOTO N50\nN50 M02\nN50 M02", runs="", alarm="code-not-computed", at="O1 N10", word="N50")
case("of the same program, or it is told", **KNOWN,
     program="O1\nN10 GOTO N50\nN20 M02\nO2\nN50 RTS", runs="", alarm="code-not-computed", at="O1 N10", word="N50")
case("a name with an index is told", **KNOWN,
     program="O1\nN10 GOTO N50[V1]\nN50 M02", runs="", alarm="code-not-computed", at="O1 N10")
case("IF goes to a name where its condition holds", **RUN,
     program="O1\nN10 PX=1\nN20 IF [PX EQ 1] N40\nN30 G0 X9\nN40 G0 X2\nN50 M02", runs="N10 N20 N40 N50", moves_x=[2])
case("and on where it does not", **RUN,
     program="O1\nN10 PX=2\nN20 IF [PX EQ 1] N40\nN30 G0 X9\nN40 G0 X2\nN50 M02", runs="N10 N20 N30 N40 N50")
case("GOTO may stand before the name", **KNOWN,
     program="O1\nN10 IF [1 EQ 1] GOTO N40\nN30 G0 X9\nN40 M02", runs="N10 N40")
case("IF needs a name", **RUN,
     program="O1\nN10 IF [VDIN[34] EQ 1]\nN20 M02", runs="", alarm="statement-format", number="2237 1", at="O1 N10")
case("also where its condition does not hold", **RUN,
     program="O1\nN10 IF [VC1 EQ 1]\nN20 M02", runs="", alarm="statement-format", number="2237 1", at="O1 N10")
case("that is there", **RUN,
     program="O1\nN10 IF [1 EQ 1] N90\nN20 M02", runs="", alarm="jump-target-not-found", number="2237 2", at="O1 N10", word="N90")
case("where the condition does not hold it is not looked for", **KNOWN,
     program="O1\nN10 IF [1 EQ 2] N90\nN20 M02", runs="N10 N20")
case("IF has a bracket", **RUN,
     program="O1\nN10 IF V1 EQ 3 N20\nN20 M02", runs="", alarm="if-format", number="2238 1", at="O1 N10", word="V1")
case("and a comparison in it", **RUN,
     program="O1\nN10 IF [VZOFX[1]] N20\nN20 M02", runs="", alarm="if-format", number="2238 2", at="O1 N10")
for comparison, holds in (("LT", "0 1"), ("LE", "0 1 2"), ("EQ", "2"), ("NE", "0 1 3"), ("GT", "3"), ("GE", "2 3")):
    for value in range(4):
        case(f"{value} {comparison} 2 is {'true' if str(value) in holds else 'false'}", **RUN,
             program=f"O1\nN10 IF [{value} {comparison} 2] N30\nN20 M8\nN30 M02", runs="N10 N30" if str(value) in holds else "N10 N20 N30")
case("both sides may be expressions", **RUN,
     program="O1\nN10 V1=2\nN20 IF [V1+1 EQ 2*V1-1] N40\nN30 M8\nN40 M02", runs="N10 N20 N40")
case("conditions may be joined in brackets", **KNOWN,
     program="O1\nN10 IF [[1 EQ 1] AND [2 GT 3]] N30\nN20 M8\nN30 M02", runs="N10 N20 N30")
case("by OR", **KNOWN, program="O1\nN10 IF [[1 EQ 1] OR [2 GT 3]] N30\nN20 M8\nN30 M02", runs="N10 N30")
case("EMPTY is a local without a value", **MACROS,
     program="O1\nN10 IF [PX EQ EMPTY] N30\nN20 M8\nN30 M02", runs="N10 N30")
case("NE EMPTY is one with a value", **MACROS,
     program="O1\nN5 PX=0\nN10 IF[PX NE EMPTY] N30\nN20 M8\nN30 M02", runs="N5 N10 N30")
case("a call that gives none leaves it empty", **MACROS,
     program="O1\nN10 CALL O2 PY=1\nN20 CALL O2 PX=1\nN30 M02\nO2\nN40 IF [PX NE EMPTY] N60\nN50 PX=0\nN60 G0 X=PX+5\nN70 RTS", moves_x=[5, 6])
case("THEN is told", **KNOWN, program="O1\nN10 IF [1 EQ 1] THEN\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10")
case("words after a jump are told", **KNOWN,
     program="O1\nN10 GOTO N20 X1\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="X1")
case("an input is asked", source="OKA 2237, VDIN[34]", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 IF [VDIN[34] EQ 0] N30\nN20 M8\nN30 M02", runs="N10 N30")
