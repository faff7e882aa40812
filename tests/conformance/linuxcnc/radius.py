"""LinuxCNC: radius compensation."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}
D1 = {"radius_offsets": {1: 1}}

case("the start of G41 ends beside its own line", pins="start_up", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 Y5\nN30 G40 X0\nN40 M2", centre="X4 Y1 | X4 Y5 | X0 Y5")
case("around an outside corner of any angle the tool goes in an arc", pins="acute_corner", **RUN, setup=D1,
     program="N10 G42 D1 G1 X5 F100\nN20 Y5\nN30 G40 X0\nN40 M2", centre="X5 Y-1 | X6 Y0 | X6 Y5 | X0 Y5")
case("a corner of less than a twentieth of a radian is none", pins="acute_corner", **RUN, setup=D1,
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
