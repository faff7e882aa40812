"""Okuma OSP: files, names of programs and blocks, comments, skipped blocks, ends."""

from conformance import case

RUN = {"control": "okuma-osp-p300", "source": "OKA 2204, 2207, 2236, 2290", "evidence": "secondary"}
KNOWN = {"control": "okuma-osp-p300", "source": "general knowledge of the Okuma OSP", "evidence": "inferred"}

case("a program begins with its name", **RUN, program="O1\nN10 G0 X1\nN20 M02", runs="N10 N20", moves_x=[1])
case("of letters and digits", **RUN, program="OABC\nN10 CALL OE12\nN20 M02\nOE12\nN30 G0 X1\nN40 RTS", runs="N10 N30 N40 N20")
case("M30 ends a program of an OSP too", pins="roles:M30=end", **RUN, program="O1\nN10 G0 X1\nN20 M30\nN30 G0 X2", runs="N10 N20")
case("as M2 does", **RUN, program="O1\nN10 M2\nN20 G0 X2", runs="N10")
case("a file without a name is a program", source="OKM, SET-MASTER-XY.MIN", control="okuma-osp-p300", evidence="secondary",
     files={"SHAFT.MIN": "N10 G0 X1\nN20 M2\n"}, runs="N10 N20")
case("a comment may follow the name", source="OKM, OPULL (BAR PULL)", control="okuma-osp-p300", evidence="secondary",
     program="OPULL (BAR PULL)\nN10 G0 X1\nN20 M2", runs="N10 N20")
case("small letters are as good as capitals", **KNOWN, program="o1\nn10 g0 x1\nn20 call o2\nn30 m2\nO2\nN40 RTS", runs="N10 N20 N40 N30")
case("the name of a file on a tape is passed over", **KNOWN, program="$SHAFT.MIN%\nO1\nN10 G0 X1\nN20 M2\n%", runs="N10 N20")
case("a name without characters is refused", **RUN,
     program="O*123\nN10 M02", runs="", alarm="illegal-program-name", number="2207 1", at="O")
case("and one of five", **RUN,
     program="OABCDE\nN10 M02", runs="", alarm="illegal-program-name", number="2207 2", at="OABCDE", word="OABCDE")
case("a program needs an end", pins="missing_end", **RUN,
     program="O1\nN10 G0 X1", runs="N10", alarm="end-of-record", number="2236 1")
case("a comment needs one too", **RUN,
     program="O1\nN10 G0 X1 (HERE\nN20 M02", runs="", alarm="comment-not-closed", number="2236 2", at="O1 N10")
case("a run does not go into the next program", **RUN,
     program="O1\nN10 G0 X1\nO2\nN20 G0 X2\nN30 M2", runs="N10", alarm="end-of-record", number="2290", at="O1")
case("a call returns before it", **RUN, program="O1\nN10 CALL O2\nN20 M2\nO2\nN30 RTS\nO3\nN40 RTS", runs="N10 N30 N20")
case("comments stand anywhere", **RUN, program="O1\nN10 (A) G0 (B) X1 (C)\n(D)\nN20 M02", runs="N10 N20", moves_x=[1])
case("blanks may be left out", **KNOWN, program="O1\nN10G0X1Y2\nN20M02", runs="N10 N20", moves="R X1 Y2")
case("a block may be named by letters alone", source="OKM, NXT1", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 GOTO NXT1\nN20 G0 X1\nNXT1\nN30 M2", runs="N10 N30")
case("with words behind the name", source="OKM, NTC12 M6", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 GOTO NTC12\nN20 G0 X1\nNTC12 G0 X2\nN30 M2", moves_x=[2])
case("a name needs a character", **RUN,
     program="O1\nN G0 X1\nN20 M2", runs="", alarm="illegal-sequence-number", number="2204 1", at="O1", word="N")
case("at most five of them", **RUN,
     program="O1\nN123456 G0 X1\nN20 M2", runs="", alarm="illegal-sequence-number", number="2204 3", at="O1", word="N123456")
case("a block is skipped by the switch", **KNOWN, program="O1\n/N10 G0 X1\nN20 G0 X2\nN30 M2", skip=[1], moves_x=[2])
case("the slash may follow the name", **KNOWN, program="O1\nN10 /G0 X1\nN20 G0 X2\nN30 M2", skip=[1], moves_x=[2])
case("without the switch it runs", **KNOWN, program="O1\n/N10 G0 X1\nN20 M2", moves_x=[1])
case("an unknown sign is refused", **RUN,
     program="O1\nN10 G0 X1 ?\nN20 M2", runs="", alarm="illegal-character", number="2206", at="O1 N10", word="?")
case("nine digits are enough", **RUN,
     program="O1\nN10 G0 X1000000000\nN20 M2", runs="", alarm="too-many-digits", number="2205 9", at="O1 N10", word="X1000000000")
case("and one point", **RUN,
     program="O1\nN10 G0 X12.351.9\nN20 M2", runs="", alarm="illegal-decimal-point", number="2205", at="O1 N10", word="X12.351.9")
case("an address needs a value", **KNOWN, program="O1\nN10 G0 X\nN20 M2", runs="", alarm="address-without-value", number=None, at="O1 N10")
case("an address twice in a block is told", **KNOWN,
     program="O1\nN10 G0 X1 X2\nN20 M2", runs="", alarm="code-not-computed", at="O1 N10", word="X2")
case("a drawing is passed over", source="OKM, CLEAR and DRAW", control="okuma-osp-p300", evidence="secondary",
     program="O1\nDEF WORK\nPS LC,[0,0],[100,50]\nEND\nN10 CLEAR\nN20 DRAW\nN30 G0 X1\nN40 M2", runs="N10 N20 N30 N40", moves_x=[1],
     dropped=["DEF WORK", "PS LC,[0,0],[100,50]", "END", "CLEAR", "DRAW"])
for word in ("LET", "NOEX", "NCYL", "WHILE", "DO", "READ", "WRITE", "GET", "PUT", "PRNT", "FA", "HP", "SB"):
    case(f"{word} is told", **KNOWN, program=f"O1\nN10 {word} V1=1\nN20 M2", runs="", alarm="code-not-computed", at="O1 N10", word=word)
