"""LinuxCNC: work systems, shifts, lengths and reference points."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}

case("G92.2 puts the shift of G92 aside, G92.3 takes it back in", pins="g_meanings", **RUN, program="""
         N10 G0 X1
         N20 G92 X5
         N30 G92.2 G0 X2
         N40 G92.3 G0 X7
         N50 M2
     """, moves="R X1\nR X2\nR X7", final_machine="X3")
case("G92.1 forgets it", **RUN, program="N10 G0 X1\nN20 G92 X5\nN30 G92.1\nN40 G92.3 G0 X7\nN50 M2", final_machine="X7")
case("G52 gives the shift of G92 itself", **RUN, program="N10 G92 X5\nN20 G52 X1\nN30 G0 X3\nN40 M2", final_machine="X4")
case("#5210 tells whether the shift counts, #5211 what it is", **RUN,
     program="N10 G92 X5\nN20 G92.2\nN30 (print,#5210 #5211)\nN40 G92.3\nN50 (print,#5210 #5211)\nN60 M2",
     messages=["0.000000 -5.000000", "1.000000 -5.000000"])
case("the shift does not change while a radius is compensated", **RUN, setup={"radius_offsets": {1: 1}},
     program="N10 G41 D1 G1 X5 F100\nN20 G52 X1\nN30 M2", runs="N10", alarm="shift-in-offset", word="G52")
case("G10 L2 P0 sets the work system in force, and does not add in G91", pins="data_forms:in-force", **RUN,
     program="N10 G55 G91\nN20 G10 L2 P0 X5\nN30 G10 L2 P0 X5\nN40 G90 G0 X1\nN50 M2", final_machine="X6")
case("its P7 is G59.1", pins="max_extra_systems data_forms:in-force", **RUN,
     program="N10 G10 L2 P7 X5\nN20 G10 L2 P9 X8\nN30 G59.1 G0 X1\nN40 G59.3 G0 X1\nN50 M2", moves_x=[1, 1], final_machine="X9")
case("there is no system after G59.3", pins="max_extra_systems", **RUN,
     program="N10 G10 L2 P10 X5\nN20 M2", runs="", alarm="g10-system-number", word="P10")
case("G10 L20 sets a system so that the tool stands at the point", pins="data_forms:here", **RUN,
     program="N10 G0 X10\nN20 G10 L20 P2 X3\nN30 G55 G0 X4\nN40 M2", final_machine="X11")
case("G10 L20 takes off the shift that is written in #5211, not the one in force", **RUN,
     program="N10 G92 X0\nN20 #5211=-0.1\nN30 G10 L20 P1 X0\nN40 G0 X1\nN50 (print,#<_abs_x> #5221)\nN60 M2",
     messages=["1.100000 0.100000"])
case("a shift that is put aside is not taken off by G10 L20", **RUN,
     program="N10 G92 X0\nN20 G92.2\nN30 #5211=-0.1\nN40 G10 L20 P1 X0\nN50 G0 X1\nN60 (print,#<_abs_x> #5221)\nN70 M2",
     messages=["1.000000 0.000000"])
case("R of G10 L2 turns a work system about its zero point", pins="data_forms:in-force", **RUN,
     program="N10 G10 L2 P1 X10 R90\nN20 G0 X5 Y1\nN30 M2", moves="R X5 Y1", final_machine="X9 Y5")
case("it turns the tool's place in the work system in force at once", **RUN,
     program="N10 G0 X5\nN20 G10 L2 P1 R90\nN30 (print,#5420 #5421)\nN40 M2", messages=["0.000000 -5.000000"])
case("a system of its own turn is one code away", **RUN,
     program="N10 G10 L2 P2 R90\nN20 G55 G0 X5\nN30 G54\nN40 (print,#5420 #5421)\nN50 M2", messages=["0.000000 5.000000"])
case("G91 counts along the turned axes", **RUN,
     program="N10 G10 L2 P1 R90\nN20 G91 G0 X5\nN30 Y2\nN40 M2", final_machine="X-2 Y5")
case("an arc turns with its system", **RUN,
     program="N10 G10 L2 P1 R90\nN20 G3 X10 Y10 J10 F100\nN30 M2", moves="CCW X10 Y10 C X0 Y10", final_machine="X-10 Y10")
case("G92 shifts along the turned axes", **RUN,
     program="N10 G10 L2 P1 R90\nN20 G92 X-5\nN30 G0 X0\nN40 M2", final_machine="X0 Y5")
case("G53 goes to the machine coordinate from a turned system", **RUN,
     program="N10 G10 L2 P1 R90\nN20 G0 X5 Y1\nN30 G53 G0 X0\nN40 M2", moves="R X5 Y1\nR X5 Y0", final_machine="X0 Y5")
case("G28 goes to its machine point from a turned system", **RUN,
     program="N10 G0 X3 Y4\nN20 G28.1\nN30 G10 L2 P1 R90\nN40 G0 X0 Y0\nN50 G28\nN60 M2", final_machine="X3 Y4")
case("G10 L20 sets a turned system by where the tool stands in it", pins="data_forms:here", **RUN,
     program="N10 G10 L2 P1 R90\nN20 G0 X5\nN30 G10 L20 P1 X0\nN40 (print,#5420 #5421)\nN50 M2", messages=["0.000000 0.000000"])
case("a compensated path turns with its system", **RUN,
     program="N10 G10 L2 P1 R90\nN20 G41.1 D2 G1 X5 F100\nN30 X9\nN40 M2", centre="X-1 Y5 | X-1 Y9")
case("#5230 is the turn of G54", **RUN, program="N10 G10 L2 P1 R30\nN20 (print,#5230)\nN30 M2", messages=["30.000000"])
case("the system in force does not change while a radius is compensated", **RUN, setup={"radius_offsets": {1: 1}},
     program="N10 G41 D1 G1 X5 F100\nN20 G10 L2 P1 X5\nN30 M2", runs="N10", alarm="shift-in-offset", word="G10")
case("nor does a tool length", **RUN, setup={"radius_offsets": {1: 1}, "length_offsets": {1: 1}},
     program="N10 G41 D1 G1 X5 F100\nN20 G43 H1\nN30 M2", runs="N10", alarm="shift-in-offset", word="G43")
case("#5220 is the number of the work system", **RUN,
     program="N10 G55\nN20 (print,#5220)\nN30 G59.2\nN40 (print,#5220)\nN50 M2", messages=["2.000000", "8.000000"])
case("G43 moves nothing: the work coordinate changes", pins="length_type", **RUN, setup={"length_offsets": {1: 5}},
     program="N10 G0 Z10\nN20 G43 H1\nN30 (print,#5422)\nN40 G0 Z10\nN50 M2",
     messages=["5.000000"], moves="R Z10\nR Z10", final_machine="Z15")
case("#5403 is the length of the tool in the spindle, in force or not", **RUN, setup={"length_offsets": {1: 5}},
     program="N10 (print,#5403)\nN20 T1 M6\nN30 (print,#5403)\nN40 M2", messages=["0.000000", "5.000000"])
case("#5403, #5221, #5161 and #5211 are those of a machine in millimetres under G20 too", **RUN, setup={"length_offsets": {1: 5}},
     program="""
         N10 T1 M6
         N20 G20 #5221=25.4
         N30 #5161=50.8
         N40 G92 X1
         N50 (print,#5403 #5221 #5161 #5211)
         N60 M2
     """, messages=["5.000000 25.400000 50.800000 -25.400000"])
case("G53 goes to the machine coordinate with the length in it", pins="length_type", **RUN, setup={"length_offsets": {1: 5}},
     program="N10 G43 H1\nN20 G53 G0 Z20\nN30 M2", moves="R Z15", final_machine="Z20")
case("G43 without H takes the length of the tool", pins="missing_radius_offset", **RUN, setup={"length_offsets": {2: 5}},
     program="N10 T2 M6\nN20 G43 G0 Z1\nN30 M2", final_machine="Z6")
case("G43.1 gives the length, G43.2 adds to it", **RUN, setup={"length_offsets": {1: 5}},
     program="N10 G43.1 Z2\nN20 G43.2 H1\nN30 G43.2 Z1\nN40 G0 Z0\nN50 M2", moves="R Z0", final_machine="Z8")
case("G28.1 stores where the tool stands, a bare G28 goes there", **RUN,
     program="N10 G0 X1 Y2\nN20 G28.1\nN30 G0 X5 Y5\nN40 G28\nN50 M2", final_work="X1 Y2")
case("G30.1 stores the second point, #5181 tells it", **RUN,
     program="N10 G0 X1\nN20 G30.1\nN30 (print,#5181)\nN40 G0 X5\nN50 G30 X4\nN60 M2",
     messages=["1.000000"], moves_x=[1, 5, 4, 1])
case("#5161 is the reference point, and may be written", **RUN,
     program="N10 #5161=3\nN20 G28\nN30 M2", final_work="X3")
case("a bare G30 goes to the second reference point", **RUN,
     program="N10 #5181=3\nN20 G30\nN30 M2", final_work="X3")
case("G43 without H takes the tool in the spindle, not the one that T chose", **RUN,
     setup={"length_offsets": {1: 5, 2: 7}},
     program="N10 T1 M6\nN20 T2\nN30 G43\nN40 G0 Z0\nN50 (print,#5400 #<_selected_tool>)\nN60 M6 G43\nN70 G0 Z1\nN80 M2",
     messages=["1.000000 2.000000"], final_machine="Z8")
case("G92.2 beside G92 puts the shift aside that it sets", **RUN,
     program="N10 G0 X10\nN20 G92.2 G92 X4\nN30 G91 G0 X1\nN40 (print,#5210 #5211)\nN50 M2", messages=["0.000000 6.000000"], final_work="X11")
case("so it does after it, and beside G52", **RUN,
     program="N10 G0 X10\nN20 G52 X4 G92.1\nN30 G91 G0 X1\nN40 (print,#5210 #5211)\nN50 M2", messages=["0.000000 0.000000"], final_work="X11")
case("and beside G53, before its move, and beside G4 and G28.1", **RUN,
     program="N10 G92 X5\nN20 G53 G0 X3 G92.2\nN30 G92.3 G4 P1\nN40 G0 X1\nN50 G28.1 G92.1 X2\nN60 M2", moves="R X3\nW 1\nR X1\nR X2",
     final_machine="X2")
case("a shift that is written counts for nothing but the point where a system is chosen", pins="written_offset", **RUN,
     program="N10 G92 X5\nN20 #5211=3\nN30 G55\nN40 (print,#5420)\nN50 M2", messages=["-3.000000"])
case("one that #5210 says is in force too", **RUN,
     program="N10 #5210=7\nN20 #5211=3\nN30 G55\nN40 (print,#5420)\nN50 M2", messages=["-3.000000"])
case("and where G10 L20 sets one", **RUN,
     program="N10 G92 X5\nN20 #5211=3\nN30 G10 L20 P2 X0\nN40 (print,#5241)\nN50 M2", messages=["-3.000000"])
case("H0 is the tool in the spindle too", **RUN, setup={"length_offsets": {1: 5}},
     program="N10 T1 M6\nN20 G43 H0\nN30 G0 Z0\nN40 M2", final_machine="Z5")
