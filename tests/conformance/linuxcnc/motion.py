"""LinuxCNC: arcs, units, G53 and canned cycles."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}

case("an arc has R or a centre", pins="no_radius", **RUN,
     program="N10 G2 X1 F100\nN20 M2", runs="", alarm="no-radius", word="G2")
case("R reaches the end of its arc", **RUN,
     program="N10 G2 X9 R1 F100\nN20 M2", runs="", alarm="radius-too-small", word="R1")
case("LinuxCNC takes the long way round for a negative R", pins="negative_radius", **RUN,
     program="N10 G2 X1 R-1 F100\nN20 M2", moves="CW X1 Y0 C X0.5 Y0.866025")
case("an arc of any plane may be a helix", pins="helix", **RUN,
     program="N10 G18 G2 X1 Y2 I0.5 F100\nN20 M2", final_work="X1 Y2")
case("the unit changes anywhere", pins="unit_change", **RUN,
     program="N10 G0 X1\nN20 G20 G0 X1\nN30 M2", moves="R X1\nR X25.4")
case("G53 is a feed in G1", pins="machine_move", **RUN,
     program="N10 G1 X1 F100\nN20 G53 X3\nN30 M2", moves="F X1\nF X3")
case("a canned cycle runs as often as its L says", pins="cycle_repeats", **RUN,
     program="N10 G0 Z1\nN20 G91 G81 X1 Z-1 R0 L2 F100\nN30 G80 M2",
     final_work="X2 Z1")
case("but not zero times", pins="zero_cycle_repeats", **RUN,
     program="N10 G0 Z1\nN20 G91 G81 X1 Z-1 R0 L0 F100\nN30 M2", runs="N10", alarm="cycle-repeats", word="L0")
case("G73 draws back by a hundredth of an inch", pins="peck_retract", **RUN,
     program="N10 G0 Z1\nN20 G73 Z-1 R1 Q1 F100\nN30 G80 M2", moves="R Z1\nR Z1\nF Z0\nR Z0.254\nF Z-1\nR Z1")
case("G83 goes back to a hundredth of an inch above", pins="peck_clearance", **RUN,
     program="N10 G0 Z1\nN20 G83 Z-1 R1 Q1 F100\nN30 G80 M2", moves="R Z1\nR Z1\nF Z0\nR Z1\nR Z0.254\nF Z-1\nR Z1")
case("a cycle that begins below R goes to R before it goes over the hole", pins="cycle_approach", **RUN,
     program="N10 G98 G81 X1 Z-1 R2 F100\nN20 G80 M2", moves="R Z2\nR X1\nR Z2\nF Z-1\nR Z2")
case("and each hole begins there, where G91 counts on", pins="cycle_approach", **RUN,
     program="N10 G0 Z0.25\nN20 G91 G99 G81 X1 Z-1 R0.25 L2 F100\nN30 G80 M2",
     moves="R Z0.25\nR Z0.5\nR X1\nR Z0.5\nF Z-0.5\nR Z0.5\nR X2\nR Z0.5\nF Z-0.5\nR Z0.5")
case("a tap is fed out to the level of G98", pins="tap_return", **RUN,
     program="N10 G0 Z5 S100 M3\nN20 G98 G84 Z-1 R2 F100\nN30 G80 M2", moves="R Z5\nR Z2\nF Z-1\nF Z5")
case("a canned cycle turns no rotary axis", pins="refuses:rotary-axis-in-cycle", **RUN,
     program="N10 G81 A90 Z-1 R1 F100\nN20 M2", runs="", alarm="rotary-axis-in-cycle", word="A90")
case("G33 is a thread whose lead is K", **RUN, program="N10 S100 M3\nN20 G33 Z-2 K0.5\nN30 M2", moves="T Z-2")
case("which it needs for every move", **RUN,
     program="N10 S100 M3\nN20 G33 Z-2\nN30 M2", runs="N10", alarm="thread-lead", word="G33")
case("G33.1 taps and goes back the way it came", **RUN,
     program="N10 S100 M3\nN20 G33.1 Z-2 K0.5\nN30 M2", moves="T Z-2\nT Z0")
case("a tap outside of G17 takes its axes for each other", pins="tap_return", **RUN,
     program="N10 G18 S100 M3 G0 Y2\nN20 G84 X1 Z3 Y-1 R1 F100\nN30 G80 M2",
     moves="R Y2\nR X1 Z3\nR Y1\nF X-1 Y3 Z1\nF X2 Y3 Z1", final_work="X1 Y2 Z3")
case("G10 L1 writes the table of tools", pins="data_forms:tools", **RUN,
     program="N10 G10 L1 P1 Z5 R1\nN20 T1 M6\nN30 (print,#5403)\nN40 M2", messages=["5.000000"])
case("a tool has lengths along other axes too", pins="data_forms:tools", **RUN,
     program="N10 G10 L1 P1 X1 Y2 Z3\nN20 G43 H1\nN30 G0 X0 Y0 Z0\nN40 M2", final_machine="X1 Y2 Z3")
case("in a turned system they stay those of the machine", **RUN,
     program="N10 G10 L1 P1 X1\nN20 G10 L2 P1 R90\nN30 G43 H1 G0 X0 Y0\nN40 M2", final_machine="X1 Y0")
case("L11 puts the tool at the point of G59.3", pins="data_forms:tools", **RUN,
     program="N10 G10 L2 P9 Z-10\nN20 G0 Z20\nN30 G10 L11 P1 Z15\nN40 T1 M6\nN50 (print,#5403)\nN60 M2", messages=["15.000000"])
case("L10 puts the tool at the point", pins="data_forms:tools", **RUN,
     program="N10 G0 Z20\nN20 G10 L10 P1 Z15\nN30 G43 H1\nN40 (print,#5422)\nN50 M2", messages=["15.000000"])
case("G38.2 and G38.3 go to their end where nothing is touched", **RUN,
     program="N10 G38.2 X5 F100\nN20 G38.3 X7\nN30 M2", moves="F X5\nF X7")
