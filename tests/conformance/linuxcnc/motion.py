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
case("a canned cycle runs as often as its L says", pins="cycle_repeats max_cycle_repeats", **RUN,
     program="N10 G0 Z1\nN20 G91 G81 X1 Z-1 R0 L2 F100\nN30 G80 M2",
     final_work="X2 Z1")
case("but not zero times", pins="zero_cycle_repeats", **RUN,
     program="N10 G0 Z1\nN20 G91 G81 X1 Z-1 R0 L0 F100\nN30 M2", runs="N10", alarm="cycle-repeats", word="L0")
case("G73 draws back by a hundredth of an inch", pins="peck_retract", **RUN,
     program="N10 G0 Z1\nN20 G73 Z-1 R1 Q1 F100\nN30 G80 M2", moves="R Z1\nF Z0\nR Z0.254\nF Z-1\nR Z1")
case("G83 goes back to a hundredth of an inch above", pins="peck_clearance", **RUN,
     program="N10 G0 Z1\nN20 G83 Z-1 R1 Q1 F100\nN30 G80 M2", moves="R Z1\nF Z0\nR Z1\nR Z0.254\nF Z-1\nR Z1")
case("a cycle that begins below R goes to R before it goes over the hole", pins="cycle_approach", **RUN,
     program="N10 G98 G81 X1 Z-1 R2 F100\nN20 G80 M2", moves="R Z2\nR X1\nF Z-1\nR Z2")
case("and each hole begins there, where G91 counts on", pins="cycle_approach", **RUN,
     program="N10 G0 Z0.25\nN20 G91 G99 G81 X1 Z-1 R0.25 L2 F100\nN30 G80 M2",
     moves="R Z0.25\nR Z0.5\nR X1\nF Z-0.5\nR Z0.5\nR X2\nF Z-0.5\nR Z0.5")
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
     program="N10 G18 S100 M3 G0 Y2\nN20 G98 G84 X1 Z3 Y-1 R1 F100\nN30 G80 M2",
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
case("without G98 and G99 a cycle goes back to R", pins="power_on:G99", **RUN,
     program="N10 G0 Z5\nN20 G81 X1 Z-1 R2 F100\nN30 X2\nN40 G80\nN50 (print,#<_retract_r_plane> #<_retract_old_z>)\nN60 M2",
     moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z2\nR X2\nF Z-1\nR Z2", messages=["1.000000 0.000000"])
case("a radius or an angle alone is a hole", **{**RUN, "source": "LC g-code; rs274 2.9"},
     program="N10 G0 X3 Y4 Z5\nN20 G99 G81 Z-1 R2 F100\nN30 ^90\nN40 @10\nN50 @5 ^0\nN60 G80\nN70 M2",
     moves="""
         R X3 Y4 Z5
         R Z2
         F Z-1
         R Z2
         R X0 Y5
         F Z-1
         R Z2
         R X0 Y10
         F Z-1
         R Z2
         R X5 Y0
         F Z-1
         R Z2
     """)
case("by a radius alone at the zero point too, where no other move goes", **RUN,
     program="N10 G0 Z2\nN20 G81 @5 Z-1 R2 F100\nN30 G0 X0\nN40 @5\nN50 M2", runs="N10 N20 N30", alarm="polar-word", at="MAIN N40", word="@5",
     moves="R Z2\nR X5\nF Z-1\nR Z2\nR X0")
case("a tool above R goes over the hole at its own height, though the cycle returns higher", **{**RUN, "source": "rs274 2.9"},
     program="N10 G0 Z5\nN20 G99 G81 X1 Z-1 R2 F100\nN30 G98 X2 R1\nN40 X3\nN50 G80\nN60 M2",
     moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z2\nR X2\nR Z1\nF Z-1\nR Z5\nR X3\nR Z1\nF Z-1\nR Z5")
case("a series that began below R returns to R, also from a hole of no depth", **{**RUN, "source": "rs274 2.9"},
     program="N10 G98 G85 X1 R2 Z-4 F100\nN20 X3 Z2\nN30 G80\nN40 M2",
     moves="R Z2\nR X1\nF Z-4\nF Z2\nR Z2\nR X3\nF Z2\nF Z2", final_work="X3 Y0 Z2")
case("G80 gives way to another motion code of its line, in either order", **RUN,
     program="N10 G0 Z5\nN20 G81 X1 Z-1 R2 F100\nN30 G80 G0 X2\nN40 G1 G80 X3\nN50 X4\nN60 G80 G80\nN70 M2",
     moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z2\nR X2\nF X3\nF X4")
case("also to a cycle", **RUN,
     program="N10 G0 Z2\nN20 G80 G81 X1 Z-1 R2 F100\nN30 M2", moves="R Z2\nR X1\nF Z-1\nR Z2")
case("two other motion codes are two of a group", **RUN,
     program="N10 G80 G0 G1 X1 F100\nN20 M2", runs="", alarm="address-given-twice", word="G1")
case("beside G80 alone no axis word stands", **RUN,
     program="N10 G80 X1\nN20 M2", runs="", alarm="address-not-usable", word="X1")

# Values
case("a computed word is not rounded", pins="computed_lengths", **RUN,
     program="N10 G91 G0 X[1/3]\nN20 X[1/3]\nN30 X[1/3]\nN40 (print,#5420)\nN50 M2", messages=["1.000000"])
case("nor in inches", pins="computed_lengths", **RUN,
     program="N10 G20 G91\nN20 o1 repeat [1000]\nN30 G0 X[0.001/8]\nN40 o1 endrepeat\nN50 (print,#5420)\nN60 M2", messages=["0.125000"])
case("nor a centre, a radius, or an angle", pins="computed_lengths", **RUN,
     program="N10 G2 X[2/3] I[1/3] F100\nN20 G0 A[1/3]\nN30 G91 A[2/3]\nN40 G90 G3 X[4/3] R[1/3]\nN50 (print,#5420 #5423)\nN60 M2",
     messages=["1.333333 1.000000"])
case("nor the words of a cycle", pins="computed_lengths", **RUN,
     program="N10 G0 Z[2/3]\nN20 G73 R[1/3] Z-[1/3] Q[1/3] F100\nN30 (print,#5422)\nN40 G80 M2", messages=["0.333333"])
case("nor a zero point and a length", pins="computed_lengths", **RUN,
     program="N10 G10 L2 P1 X[1/3]\nN20 G43.1 Z[2/3]\nN30 (print,#5221 #5403 #5420 #5422)\nN40 M2",
     messages=["0.333333 0.000000 -0.333333 -0.666667"])

# Codes of group 00 that take no axis words
case("G4 waits, then the words of its block move", pins="codes_that_move", **RUN,
     program="N10 G0 X0\nN20 G4 P0.5 X5\nN30 G1 G4 P0.25 Y3 F100\nN40 G4 P1\nN50 M2",
     moves="R X0\nW 0.5\nR X5\nW 0.25\nF Y3\nW 1")
case("in a series they are a hole", pins="codes_that_move", **RUN,
     program="N10 G0 Z5\nN20 G81 X1 Z-1 R2 F100\nN30 G4 P1 X2\nN40 G80 M2",
     moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z2\nW 1\nR X2\nF Z-1\nR Z2")
case("G28.1 stores the point before the move of its block, G30.1 too", pins="codes_that_move", **RUN,
     program="N10 G0 X1\nN20 G28.1 X5\nN30 G1 G30.1 Y7 F100\nN40 G28\nN50 G30\nN60 M2",
     moves="R X1\nR X5\nF Y7\nR X1 Y0\nR X5 Y0")
case("G28.1 in a thread moves nothing by itself", **RUN,
     program="N10 M3 S100 G33 Z-1 K1\nN20 G28.1\nN30 G4 P1\nN40 M2", moves="T Z-1\nW 1")
case("a radius and an angle beside them move too", **RUN,
     program="N10 G0 X5\nN20 G4 P1 ^90\nN30 G28.1 @7\nN40 G92.1 @8 ^0\nN50 M2", moves="R X5\nW 1\nR X0 Y5\nR X0 Y7\nR X8 Y0")

# The tool
case("a tool change stops the spindle", pins="spindle_at_change", **{**RUN, "source": "LC m-code, M6", "evidence": "maker's manual"},
     program="N10 M3 S100\nN20 T1 M6\nN30 G33 Z-2 K0.5\nN40 M2", runs="N10 N20", alarm="spindle-stopped", word="G33")
case("an M3 of its line starts it after that", **RUN,
     program="N10 M3 S100 T1 M6\nN20 G33 Z-2 K0.5\nN30 M2", moves="T Z-2")
case("axis words beside G43.1 are those of a motion code too", **RUN,
     program="N10 G43.1 Z1 G0 X1\nN20 X4\nN30 M2", final_machine="X5 Z2")
UNDEFINED = {**RUN, "source": "LC g-code, G87 and G88: the behaviour is undefined", "evidence": "maker's manual"}
case("what G87 does is not told", pins="g_meanings", **UNDEFINED,
     program="N10 M3 S100 G0 Z5\nN20 G87 X1 Z-1 R2 I1 J0 K-1 F100\nN30 M2", runs="N10", alarm="code-not-computed", word="G87")
case("nor is what G88 does", pins="g_meanings", **UNDEFINED,
     program="N10 M3 S100 G0 Z5\nN20 G88 X1 Z-1 R2 P1 F100\nN30 M2", runs="N10", alarm="code-not-computed", word="G88")

# The way to a hole
case("with G98 after G99 the tool goes up on its way to the hole", pins="cycle_approach", **RUN,
     program="N10 G0 Z5\nN20 G99 G81 R2 Z-1 X1 F100\nN30 G98 X2\nN40 G80 M2",
     moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z2\nR X2 Z5\nR Z2\nF Z-1\nR Z5")
case("so it does where R is another one", pins="cycle_approach", **RUN,
     program="N10 G0 Z5\nN20 G99 G81 R2 Z-1 X1 F100\nN30 X2 R3\nN40 X3 R6\nN50 X4 R1\nN60 G80 M2",
     moves="""
         R Z5
         R X1
         R Z2
         F Z-1
         R Z2
         R X2 Z3
         F Z-1
         R Z3
         R Z6
         R X3
         F Z-1
         R Z6
         R X4
         R Z1
         F Z-1
         R Z1
     """)
case("R and the depth count as the mode of the block says, whichever block gave them", pins="cycle_approach", **RUN,
     program="N10 G0 Z5\nN20 G98 G81 R2 Z-1 X1 F100\nN30 G91 X1\nN40 G80 M2",
     moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z5\nR Z7\nR X2\nF Z6\nR Z7")
case("P of another code in a series is no dwell of its cycle", **RUN,
     program="N10 M3 S100 G0 Z2 F6000\nN20 G81 R2 Z-1\nN30 G4 P1 X1\nN40 G84 X2 Z-1 R2\nN50 G80 M2",
     moves="R Z2\nF Z-1\nR Z2\nW 1\nR X1\nF Z-1\nR Z2\nR X2\nF Z-1\nF Z2")
case("P of G4 is seconds, computed or not", pins="dwell_unit", **{**RUN, "source": "LC g-code", "evidence": "maker's manual"},
     program="N10 G4 P[1/2]\nN20 #1=2\nN30 G4 P#1\nN40 G4 P1\nN50 M2", moves="W 0.5\nW 2\nW 1")
case(
    "rapid traverse is 10 m a minute where the setup names no other", pins="rapid_rate", **RUN,
    program="N10 G0 X90000 Y50\nN20 M2", time=540,
)
