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
case("there is no system behind G59.3", pins="max_extra_systems", **RUN,
     program="N10 G10 L2 P10 X5\nN20 M2", runs="", alarm="g10-system-number", word="P10")
case("G10 L20 sets a system so that the tool stands at the point", pins="data_forms:here", **RUN,
     program="N10 G0 X10\nN20 G10 L20 P2 X3\nN30 G55 G0 X4\nN40 M2", final_machine="X11")
case("a turned work system is not computed", **RUN,
     program="N10 G10 L2 P1 R45\nN20 M2", runs="", alarm="code-not-computed", word="R45")
case("#5220 is the number of the work system", **RUN,
     program="N10 G55\nN20 (print,#5220)\nN30 G59.2\nN40 (print,#5220)\nN50 M2", messages=["2.000000", "8.000000"])
case("G43 moves nothing: the work coordinate changes", pins="length_type", **RUN, setup={"length_offsets": {1: 5}},
     program="N10 G0 Z10\nN20 G43 H1\nN30 (print,#5422 #5403)\nN40 G0 Z10\nN50 M2",
     messages=["5.000000 5.000000"], moves="R Z10\nR Z10", final_machine="Z15")
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
