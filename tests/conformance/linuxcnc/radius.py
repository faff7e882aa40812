"""LinuxCNC: radius compensation."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}
D1 = {"radius_offsets": {1: 1}}

case("the start of G41 ends beside its own line", pins="start_up radius_offset_diameter", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 Y5\nN30 G40 X0\nN40 M2", centre="X4 Y1 | X4 Y5 | X0 Y5")
case("around an outside corner of any angle the tool goes in an arc", pins="start_up", **RUN, setup=D1,
     program="N10 G42 D1 G1 X5 F100\nN20 Y5\nN30 G40 X0\nN40 M2", centre="X5 Y-1 | X6 Y0 | X6 Y5 | X0 Y5")
case("the first compensated move is longer than the radius", **RUN, setup=D1,
     program="N10 G41 D1 G1 X1 F100\nN20 M2", runs="", alarm="offset-start-too-short", word="G41")
case("it may be an arc, whose radius changes", **RUN, setup=D1,
     program="N10 G42 D1 G3 X4 Y0 I2 F100\nN20 G1 Y5\nN30 M2", centre="X5 Y0 | X5 Y5")
case("a side is begun once", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 G41 X9\nN30 M2", runs="N10", alarm="offset-begun-twice", word="G41")
case("G40 lets the last move go, and no arc may follow", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 X9\nN30 G40\nN40 G2 I1\nN50 M2", runs="N10 N20 N30", alarm="arc-at-offset-end", word="G2",
     centre="X5 Y1 | X9 Y1")
case("an inside corner moves the end of the move before it back", **RUN, setup=D1,
     program="N10 G41 D1 G1 X9 F100\nN20 Y9\nN30 M2", centre="X8 Y1 | X8 Y9")
case("but not after its start", **RUN, setup=D1,
     program="N10 G41 D1 G1 X9 F100\nN20 X9.5\nN30 Y9\nN40 M2", runs="N10 N20", alarm="offset-interference", word="Y9")
case("an arc is beside its own centre, whatever its start says", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 G3 X7.01 Y2 I0 J2\nN30 M2", centre="X5 Y1 | X6.01 Y2")
case("a corner of less than a twentieth of a radian is none", pins="start_up", **RUN, setup=D1,
     program="N10 G42 D1 G1 X100 F100\nN20 X200 Y3\nN30 G40 X300\nN40 M2", centre="X100 Y-1 | X200.03 Y2 | X300 Y3")
case("G41 without D takes the radius of the tool", pins="missing_radius_offset", **RUN, setup={"radius_offsets": {2: 1}},
     program="N10 T2 M6\nN20 G41 G1 X5 F100\nN30 X9\nN40 M2", centre="X5 Y1 | X9 Y1")
case("D of G41.1 is the diameter itself", **RUN,
     program="N10 G41.1 D2 G1 X5 F100\nN20 X9\nN30 M2", centre="X5 Y1 | X9 Y1")
case("which it needs", **RUN,
     program="N10 G41.1 G1 X5 F100\nN20 M2", runs="", alarm="radius-offset-number", word="G41.1")
case("an arc that ends off its circle is told in numbers", **RUN,
     program="N10 G2 X2 Y1 I1 F100\nN20 M2", runs="", alarm="radius-tolerance", word="X2")
case("D of G42.1 is the diameter too", **RUN,
     program="N10 G42.1 D2 G1 X5 F100\nN20 X9\nN30 M2", centre="X5 Y-1 | X9 Y-1")
case("after G40 the tool counts as standing on the path", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 Y5\nN30 G40\nN40 (print,#5420 #5421 #<_abs_x>)\nN50 G91 G0 X2\nN60 M2",
     messages=["5.000000 5.000000 5.000000"], centre="X4 Y1 | X4 Y5 | X7 Y5")
case("a tool change after G40 goes on from where the tool stands", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 Y5\nN30 G40\nN40 T1 M6\nN50 (print,#5420 #5421)\nN60 G91 G0 X2\nN70 M2",
     messages=["4.000000 5.000000"], centre="X4 Y1 | X4 Y5 | X6 Y5")
case("no arc may follow that either", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 Y5\nN30 G40\nN40 T1 M6\nN50 G2 I1\nN60 M2", runs="N10 N20 N30 N40", alarm="arc-at-offset-end", word="G2")
case("a dwell after G40 leaves the tool where it is", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 Y5\nN30 G40\nN40 G4 P1\nN50 T1 M6\nN60 G91 G0 X2\nN70 M2",
     final_machine="X6 Y5")
case("where the first compensated move waits, the tool counts as standing at its end", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 (print,#<_x> #<_y> #<_abs_y>)\nN30 Y5\nN40 (print,#<_x> #<_y>)\nN50 M2",
     messages=["5.000000 1.000000 1.000000", "4.000000 5.000000"])
case("G41 without D takes the tool in the spindle, not the one that T chose", pins="missing_radius_offset", **RUN,
     setup={"radius_offsets": {1: 1, 2: 3}},
     program="N10 T1 M6\nN20 T2\nN30 G41 G1 X5 F100\nN40 X9\nN50 M2", centre="X5 Y1 | X9 Y1")
case("while none is there it compensates none", **RUN, setup={"radius_offsets": {1: 1}},
     program="N10 T1\nN20 G41 G1 X5 F100\nN30 X9\nN40 M2", centre="X5 | X9")
case("D0 is the tool in the spindle too", pins="missing_radius_offset", **RUN, setup={"radius_offsets": {1: 1}},
     program="N10 T1 M6\nN20 G41 D0 G1 X5 F100\nN30 X9\nN40 M2", centre="X5 Y1 | X9 Y1")
