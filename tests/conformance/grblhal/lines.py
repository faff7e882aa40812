"""grblHAL: lines, words, and what its parser refuses."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHg, gc_execute_block", "evidence": "source document"}
VALUE = {"control": "grblhal", "source": "gHx, ngc_read_real_value", "evidence": "source document"}

case("a line moves, and the mode stays", **RUN,
     program="N10 G0 X1\nN20 Y2\nN30 G1 Z3 F100\nN40 X0\nN50 M2", runs="N10 N20 N30 N40 N50", moves="R X1\nR Y2\nF Z3\nF X0")
case("blanks and small letters do not count", **RUN,
     program="N10 g 0 x 1 0 y-2\nN20 m 3 0", runs="N10 N20", moves="R X10 Y-2")
case("a comment is left out, one that is not closed ends with its line", **RUN,
     program="N10 G0 (go) X1 ; there\nN20 X2 (and\nN30 M2", runs="N10 N20 N30", moves_x=[1, 2])
case("a closing bracket alone is left out", control="grblhal", source="gHg, gc_normalize_block", evidence="source document",
     program="N10 G0 X1)Y2\nN20 M2", moves="R X1 Y2")
case("a slash leaves its line out where the switch is on", control="grblhal", source="gHg, gc_normalize_block", evidence="source document",
     program="N10 G0 X1\n/N20 X2\nN30 M2", skip=(1,), runs="N10 N30", moves_x=[1])
case("a program may stand between %", **RUN,
     program="%\nN10 G0 X1\n%\nN20 G0 X2", runs="N10", moves_x=[1])
case("a % that no other one begins says nothing", **RUN,
     program="N10 G0 X1\n%\nN20 G0 X2\nN30 M2", runs="N10 N20 N30", moves_x=[1, 2])
case("the end of the main program ends the run", pins="missing_end", control="grblhal", source="gHs, stream_read", evidence="source document",
     program="N10 G0 X1", runs="N10", moves_x=[1])
case("M30 ends it before", pins="roles:M30=end", **RUN, program="N10 G0 X1\nN20 M30\nN30 G0 X2", runs="N10 N20", moves_x=[1])
case("M2 does too", **RUN, program="N10 G0 X1\nN20 M2\nN30 G0 X2", runs="N10 N20", moves_x=[1])

case("a word begins with a letter", **RUN,
     program="N10 G0 X1\nN20 [1]\nN30 M2", runs="N10", alarm="illegal-character", number="error:1", at="MAIN N20")
case("a line that begins with $ is a command of the system", control="grblhal", source="gHpr, protocol_main_loop", evidence="source document",
     program="N10 G0 X1\n $H\nN30 M2", runs="N10", alarm="code-not-computed", word="$H")
case("also where lines are passed over", control="grblhal", source="gHpr, protocol_main_loop", evidence="source document",
     program="N10 G0 X1\no1 if [0]\n$H\no1 endif\nN30 M2", runs="N10", alarm="code-not-computed", word="$H")
case("after a slash it is a word without a letter", **RUN,
     program="N10 G0 X1\n/$H\nN30 M2", runs="N10", alarm="illegal-character", number="error:1")
case("an address without a value is an expression that is none", **VALUE,
     program="N10 G0 X\nN20 M2", runs="", alarm="address-without-value", number="error:75", at="MAIN N10")
case("a sign alone is no number", **VALUE,
     program="N10 G0 X-\nN20 M2", runs="", alarm="address-without-value", number="error:2", at="MAIN N10")
case("a second point begins a word that has no letter", **VALUE,
     program="N10 G0 X1.5.5\nN20 M2", runs="", alarm="illegal-character", number="error:1", at="MAIN N10")
case("a number has nine digits, and what stands after them does not count", control="grblhal", source="gHn, read_float", evidence="source document",
     program="N10 G0 X1.2500000009\nN20 M2", moves_x=[1.25])
case("a word stands once", **RUN,
     program="N10 G0 X1 X2\nN20 M2", runs="", alarm="address-given-twice", number="error:25", at="MAIN N10", word="X2")
case("two codes that move share no line", **RUN,
     program="N10 G0 G1 X1\nN20 M2", runs="", alarm="one-shot-with-motion", number="error:24", at="MAIN N10", word="G1")
case("nor do G28 and a code that moves", **RUN,
     program="N10 G0 G28 X1\nN20 M2", runs="", alarm="one-shot-with-motion", number="error:24", at="MAIN N10", word="G28")
case("two codes of another group neither", **RUN,
     program="N10 G17 G18\nN20 M2", runs="", alarm="group-given-twice", number="error:21", at="MAIN N10", word="G18")
case("nor G80 and a code that moves", **RUN,
     program="N10 G1 G80 F100\nN20 M2", runs="", alarm="group-given-twice", number="error:21", at="MAIN N10", word="G80")
case("nor do two M codes of a group", **RUN,
     program="N10 M3 M4 S1\nN20 M2", runs="", alarm="group-given-twice", number="error:21", at="MAIN N10", word="M4")
case("M3 and M8 do", **RUN, program="N10 M3 M8 S100\nN20 M2", runs="N10 N20", m=[3, 8, 2])
case("a G code that it has not is unsupported", **RUN,
     program="N10 G6\nN20 M2", runs="", alarm="g-code-not-available", number="error:20", at="MAIN N10", word="G6")
case("a fraction of one that has none is not whole", **RUN,
     program="N10 G1.5 X1 F1\nN20 M2", runs="", alarm="g-code-not-available", number="error:23", at="MAIN N10")
case("a fraction that it has not is unsupported", **RUN,
     program="N10 G59.4\nN20 M2", runs="", alarm="g-code-not-available", number="error:20", at="MAIN N10")
case("an M code that it has not is unsupported", **RUN,
     program="N10 M20\nN20 M2", runs="", alarm="m-code-not-available", number="error:20", at="MAIN N10", word="M20")
case("M19 and M66 need what this machine has not", **RUN,
     program="N10 M66 P1 L0\nN20 M2", runs="", alarm="m-code-not-available", number="error:20", at="MAIN N10", word="M66")
case("M198 is none", **RUN,
     program="N10 M198 P100\nN20 M2", runs="", alarm="m-code-not-available", number="error:20", at="MAIN N10", word="M198")
for word in ("A1", "B1", "C1", "D1", "E1", "H1", "L1", "P1", "Q1", "R1", "U1", "V1", "W1"):
    case(f"{word[0]} beside G0 is used by nothing", **RUN,
         program=f"N10 G0 X1\nN20 G0 Y1 {word}\nN30 M2", runs="N10", alarm="address-not-usable", number="error:36", at="MAIN N20", word=word)
case("a centre without an axis in the mode of an arc is used by nothing", **RUN,
     program="N10 G2 X1 I0.5 F100\nN20 I1\nN30 M2", runs="N10", alarm="address-not-usable", number="error:36", at="MAIN N20", word="I1")
case("an O alone is used by nothing", **RUN,
     program="N10 G0 X1\nO100\nN20 M2", runs="N10", alarm="address-not-usable", number="error:36")
for word in ("F-1", "S-1", "T-1", "H-1"):
    case(f"{word[0]} is not below zero", **RUN,
         program=f"N10 {word}\nN20 M2", runs="", alarm="illegal-minus-sign", number="error:4", at="MAIN N10", word=word)
case("T is whole", **RUN,
     program="N10 T1.5\nN20 M2", runs="", alarm="whole-number-expected", number="error:23", at="MAIN N10", word="T1.5")
case("a line has at most 256 characters", control="grblhal", source="gHpr, protocol_main_loop", evidence="source document",
     program=f"N10 G0 X1 ({'long ' * 60})\nN20 M2", runs="", alarm="block-too-long", number="error:11")
