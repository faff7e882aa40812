"""grblHAL: canned cycles."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHmc, mc_canned_drill; gHg, gc_execute_block", "evidence": "source document"}

case("G81 drills a hole and goes back to where it began", pins="g_codes power_on:G99", **RUN,
     program="N10 G0 Z5\nN20 G81 X1 Y2 Z-1 R2 F100\nN30 G80\nN40 M2", moves="R Z5\nR X1 Y2\nR Z2\nF Z-1\nR Z5")
case("under G99 to R", **RUN,
     program="N10 G0 Z5\nN20 G99 G81 X1 Z-1 R2 F100\nN30 X2\nN40 G80\nN50 M2", moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z2\nR X2\nF Z-1\nR Z2")
case("one that begins below R goes to R first", pins="cycle_approach", **RUN,
     program="N10 G98 G81 X1 Z-1 R2 F100\nN20 G80\nN30 M2", moves="R Z2\nR X1\nF Z-1\nR Z2")
case("G82 waits at the bottom", **RUN,
     program="N10 G0 Z5\nN20 G82 X1 Z-1 R2 P1.5 F100\nN30 G80\nN40 M2", moves="R Z5\nR X1\nR Z2\nF Z-1\nW 1.5\nR Z5")
case("L repeats the hole", pins="cycle_repeats", **RUN,
     program="N10 G0 Z5\nN20 G91 G99 G81 X1 Z-3 R-3 L2 F100\nN30 G80\nN40 M2", moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z2\nR X2\nF Z-1\nR Z2")
case("not zero times", pins="zero_cycle_repeats", **RUN,
     program="N10 G81 X1 Z-1 R2 L0 F100\nN20 M2", runs="", alarm="cycle-repeats", number="error:19", word="L0")
case("the first line of a cycle has R", **RUN,
     program="N10 G81 X1 Z-1 F100\nN20 M2", runs="", alarm="motion-word-missing", number="error:28", word="G81", at="MAIN N10")
case("and its depth", **RUN,
     program="N10 G81 X1 R2 F100\nN20 M2", runs="", alarm="motion-word-missing", number="error:28", word="G81", at="MAIN N10")
case("G82 has P", **RUN,
     program="N10 G82 X1 Z-1 R2 F100\nN20 M2", runs="", alarm="motion-word-missing", number="error:28", word="G82", at="MAIN N10")
case("R is not below the bottom", **RUN,
     program="N10 G81 X1 Z-1 R-2 F100\nN20 M2", runs="", alarm="r-below-bottom", number="error:54", word="R-2", at="MAIN N10")
case("no cycle under G93", **RUN,
     program="N10 G93\nN20 G81 X1 Z-1 R2 F100\nN30 M2", runs="N10", alarm="cycle-in-inverse-time", number="error:3", word="G81", at="MAIN N20")
case("P beside G81 is used by nothing", **RUN,
     program="N10 G81 X1 Z-1 R2 P1 F100\nN20 M2", runs="", alarm="address-not-usable", number="error:36", word="P1")
# The control reads G85, G86 and G89, and makes no moves for them.
for number in (73, 83, 85, 86, 89):
    words = "Q1" if number in (73, 83) else "P1" if number in (86, 89) else ""
    case(f"the moves of G{number} are not computed", pins="g_meanings", **RUN,
         program=f"N10 G{number} X1 Z-1 R2 {words} F100\nN20 M2", runs="", alarm="code-not-computed", at="MAIN N10", word=f"G{number}")
case("G84 needs a spindle that is synchronous", **RUN,
     program="N10 G84 X1 Z-1 R2 P1 F100\nN20 M2", runs="", alarm="g-code-not-available", number="error:20", at="MAIN N10", word="G84")
for number in ("5", "5.1", "51"):
    words = {"5": "X1 I1 J1 P1 Q1 F100", "5.1": "X1 I1 J1 F100", "51": "P2"}[number]
    case(f"what G{number} does is not computed", pins="g_meanings", **RUN,
         program=f"N10 G{number} {words}\nN20 M2", runs="", alarm="code-not-computed", at="MAIN N10", word=f"G{number}")
