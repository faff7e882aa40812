"""grblHAL: modes, feeds, offsets and reference points."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHg, gc_execute_block", "evidence": "source document"}

case("a cut needs a feed", pins="power_on_feed", **RUN,
     program="N10 G1 X1\nN20 M2", runs="", alarm="no-feed", number="error:22", word="G1", at="MAIN N10")
case("and so does G1 alone", pins="refuses:no-feed", **RUN,
     program="N10 G1\nN20 M2", runs="", alarm="no-feed", number="error:22", at="MAIN N10", word="G1")
case("G93 leaves no feed in force", pins="feed_mode_change", **RUN,
     program="N10 G1 X1 F100\nN20 G93\nN30 G1 X2\nN40 M2", runs="N10 N20", alarm="no-feed", number="error:22", word="G1", at="MAIN N30")
case("nor does G94", pins="feed_mode_change", **RUN,
     program="N10 G93 G1 X1 F2\nN20 G94 X2\nN30 M2", runs="N10", alarm="no-feed", number="error:22", word="X2", at="MAIN N20")
case("F counts in the unit of its line", pins="feed_unit", **RUN,
     program="N10 G20 G1 F10 X1\nN20 #100=[#<_feed>]\nN30 M2", moves="F X25.4", vars={100: 10})
case("the unit changes anywhere, as grblHAL has it", pins="power_on:G20", **RUN, program="N10 G0 X1\nN20 G20 X1\nN30 G21 X1\nN40 M2", moves_x=[1, 25.4, 1])
case("G91 counts from the point before", pins="power_on:G91", **RUN, program="N10 G0 X1\nN20 X2\nN30 G91 X1\nN40 G90 X1\nN50 M2", moves="R X1\nR X2\nR X3\nR X1")
case("a computed length is not rounded", pins="computed_lengths", **RUN,
     program="N10 G91\no1 repeat [30]\nN20 G0 X[1/3]\no1 endrepeat\nN30 M2", final_work="X10")

case("G4 waits so many seconds", pins="dwell_words dwell_unit", **RUN,
     program="N10 G4 P1.5\nN20 M2", runs="N10 N20", time=1.5)
case("G4 needs P", **RUN, program="N10 G4\nN20 M2", runs="", alarm="motion-word-missing", number="error:28", at="MAIN N10", word="G4")
case("not below zero", **RUN, program="N10 G4 P-1\nN20 M2", runs="", alarm="illegal-minus-sign", number="error:4", word="P-1")
case("axes beside G4 move in the mode in force", pins="codes_that_move", **RUN,
     program="N10 G0 X1\nN20 G4 P1 X2\nN30 M2", moves="R X1\nW 1\nR X2")

case("a work system is chosen", **RUN,
     program="N10 G10 L2 P2 X10\nN20 G55 G0 X1\nN30 G54 X1\nN40 M2", moves_x=[1, 1], final_machine="X1")
for number, code in enumerate(("54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"), 1):
    case(f"G{code} is work system {number}", **RUN,
         program=f"N10 G54 G10 L2 P{number} X{number}0\nN20 G{code} G0 X1\nN30 M2", final_machine=f"X{number}1")
case("G10 L2 sets one", pins="data_forms:in-force", **RUN,
     program="N10 G55\nN20 G10 L2 P0 X10\nN30 G0 X1\nN40 G54 X2\nN50 M2", moves_x=[1, 2], final_machine="X2")
case("without P the one in force", **RUN,
     program="N10 G55\nN20 G10 L2 X10\nN30 G0 X1\nN40 G54 X2\nN50 M2", moves_x=[1, 2], final_machine="X2")
case("G10 L20 sets it so that the tool is at the point", pins="data_forms:here", **RUN,
     program="N10 G0 X10\nN20 G10 L20 P1 X2\nN30 G0 X0\nN40 M2", final_machine="X8")
case("there are nine", pins="max_extra_systems", **RUN,
     program="N10 G10 L2 P9 X10\nN20 G59.3 G0 X1\nN30 M2", final_machine="X11")
case("and no tenth", **RUN,
     program="N10 G10 L2 P10 X1\nN20 M2", runs="", alarm="g10-p", number="error:29", at="MAIN N10", word="P10")
case("G10 needs an axis", **RUN,
     program="N10 G10 L2 P1\nN20 M2", runs="", alarm="g10-axis-missing", number="error:26", word="G10", at="MAIN N10")
case("it has no table of tools to write", **RUN,
     program="N10 G10 L1 P1 Z1\nN20 M2", runs="", alarm="g10-l", number="error:20", at="MAIN N10", word="L1")
case("nor turned work systems", **RUN,
     program="N10 G10 L2 P1 X1 R45\nN20 M2", runs="", alarm="g10-l", number="error:20", at="MAIN N10", word="R45")
case("G92 shifts so that the tool is at the point", **RUN,
     program="N10 G0 X10\nN20 G92 X2\nN30 G0 X0\nN40 M2", final_machine="X8")
case("G92.1 takes the shift back", **RUN,
     program="N10 G0 X10\nN20 G92 X2\nN30 G92.1\nN40 G0 X0\nN50 M2", final_machine="X0")
case("G92.3 brings it back after G92.2", **RUN,
     program="N10 G0 X10\nN20 G92 X2\nN30 G92.2\nN40 G92.3\nN50 G0 X0\nN60 M2", final_machine="X8")
case("G92 needs an axis", **RUN,
     program="N10 G92\nN20 M2", runs="", alarm="motion-word-missing", number="error:26", at="MAIN N10", word="G92")
case("G43.1 gives lengths along any axis", **RUN,
     program="N10 G43.1 X1 Z5\nN20 G0 X0 Z0\nN30 M2", final_machine="X1 Z5")
case("they stay in force after G53", pins="length_type", **RUN,
     program="N10 G43.1 Z5\nN20 G53 G0 Z1\nN30 G0 Z0\nN40 M2", final_machine="Z5")
case("G49 ends them", **RUN, program="N10 G43.1 Z5\nN20 G49\nN30 G0 Z0\nN40 M2", final_machine="Z0")
case("G43.1 needs an axis", **RUN,
     program="N10 G43.1\nN20 M2", runs="", alarm="length-axis", number="error:37", word="G43.1", at="MAIN N10")
case("G43 needs a table of tools", **RUN,
     program="N10 G43 H1\nN20 M2", runs="", alarm="g-code-not-available", number="error:20", at="MAIN N10", word="G43")

case("G53 is a feed in G1, as grblHAL has it", **RUN,
     program="N10 G10 L2 P1 X10\nN20 G1 X1 F100\nN30 G53 X3\nN40 M2", final_machine="X3")
case("G53 takes machine coordinates under G91 too", pins="machine_move", **RUN,
     program="N10 G0 X5\nN20 G91 G53 X3\nN30 M2", final_machine="X3")
case("G53 needs G0 or G1", **RUN,
     program="N10 G2 X1 I0.5 F100\nN20 G53 X3\nN30 M2", runs="N10", alarm="machine-move-without-line", number="error:30", word="G53", at="MAIN N20")
case("G28 goes by way of its point, along its axes alone", **RUN,
     program="N10 G0 X1 Y1\nN20 G28.1\nN30 G0 X5 Y5\nN40 G28 X7\nN50 M2", moves="R X1 Y1\nR X5 Y5\nR X7\nR X1", final_machine="X1 Y5")
case("without axes all go, and no point lies between", **RUN,
     program="N10 G0 X1 Y1 Z1\nN20 G28.1\nN30 G0 X5 Y5\nN40 G28\nN50 M2", final_machine="X1 Y1 Z1")
case("G30 has a point of its own", **RUN,
     program="N10 G0 X2\nN20 G30.1\nN30 G0 X5\nN40 G30\nN50 M2", final_machine="X2")
for number in (28, 30):
    case(f"axes beside G{number}.1 move after it", pins="codes_that_move", **RUN,
         program=f"N10 G0 X1\nN20 G{number}.1 X4\nN30 G{number} X4\nN40 M2", moves_x=[1, 4, 4, 1])
for number, end in ((1, 4), (2, 4), (3, 9)):
    case(f"axes beside G92.{number} move after it", pins="codes_that_move", **RUN,
         program=f"N10 G0 X5\nN20 G92 X0\nN30 G92.2\nN40 G92.{number} X4\nN50 M2", final_machine=f"X{end}")
case("G80 takes no axes", **RUN,
     program="N10 G80 X1\nN20 M2", runs="", alarm="no-motion-code", number="error:31", word="G80", at="MAIN N10")
case("and leaves no code of motion in force", pins="refuses:no-motion-code", **RUN,
     program="N10 G80\nN20 X1\nN30 M2", runs="N10", alarm="no-motion-code", number="error:31", word="X1", at="MAIN N20")
for number in (2, 3, 4, 5):
    case(f"G38.{number} goes to its end where the probe tells nothing, and stays in force", pins="g_meanings", **RUN,
         program=f"N10 G38.{number} X5 F100\nN20 X7\nN30 M2", moves="F X5\nF X7")
case("G38 has an end", **RUN,
     program="N10 G38.3 F100\nN20 M2", runs="", alarm="motion-word-missing", number="error:26", word="G38.3", at="MAIN N10")
for code, what in (("G40", "no radius is compensated"), ("G61", "the path is exact"), ("G50", "nothing is scaled"), ("G91.1", "a centre counts from the start")):
    case(f"{code}: {what}, as from power-on", **RUN,
         program=f"N10 {code}\nN20 G2 X10 I5 F100\nN30 M2", moves="CW X10 C X5 Y0")
case("G19 is the plane of Y and Z", **RUN,
     program="N10 G19 G2 Y10 J5 F100\nN20 M2", final_work="Y10")
case("M70 keeps the modes, M72 brings them back", pins="roles:M70=save-modes roles:M72=restore-modes", **RUN,
     program="N10 G0 X1\nN20 M70\nN30 G91 X1\nN40 M72\nN50 X5\nN60 M2", moves_x=[1, 2, 5])
case("M71 forgets them", pins="roles:M71=forget-modes", **RUN,
     program="N10 M70\nN20 M71\nN30 G91\nN40 M72\nN50 G0 X1\nN60 X1\nN70 M2", moves_x=[1, 2])
