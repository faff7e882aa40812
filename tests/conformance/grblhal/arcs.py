"""grblHAL: arcs."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHg, gc_execute_block", "evidence": "source document"}

case("an arc has a centre", pins="max_feed", **RUN, program="N10 G2 X10 Y0 I5 F100\nN20 M2", moves="CW X10 C X5 Y0")
case("without axes it is a full circle", **RUN, program="N10 G3 I5 F100\nN20 M2", moves="CCW X0 Y0 C X5 Y0")
case("or a radius, in the plane of X and Y", pins="power_on:G18 power_on:G19", **RUN, program="N10 G2 X10 R10 F100\nN20 M2", moves="CW X10 C X5 Y-8.660254")
case("a negative radius takes the long way", pins="negative_radius", **RUN,
     program="N10 G2 X1 R-1 F100\nN20 M2", moves="CW X1 C X0.5 Y0.866025")
case("it may be a helix, in any plane", pins="helix", **RUN, program="N10 G18 G2 X1 Y2 I0.5 F100\nN20 M2", final_work="X1 Y2")
case("P counts its turns", pins="helix", **RUN, program="N10 G2 X0 Y0 Z-3 I1 P3 F100\nN20 M2", final_work="Z-3")
case("from 1 on", **RUN, program="N10 G2 X1 I0.5 P0 F100\nN20 M2", runs="", alarm="value-out-of-range", number="error:39", word="P0")
case("as a whole number", **RUN,
     program="N10 G2 X1 I0.5 P1.5 F100\nN20 M2", runs="", alarm="whole-number-expected", number="error:23", word="P1.5")
case("a centre across the plane does not count", pins="drops_centre_across", **RUN,
     program="N10 G2 X10 I5 K1 F100\nN20 M2", moves="CW X10 C X5 Y0", dropped=["K1"])
case("its end may miss the circle by 0.005", pins="arc_tolerance", **RUN,
     program="N10 G2 X2.005 I1 F100\nN20 M2", final_work="X2.005")
case("and by a thousandth of its radius", pins="arc_tolerance_share", **RUN,
     program="N10 G2 X200.09 I100 F100\nN20 M2", final_work="X200.09")
case("but no more", pins="arc_tolerance", **RUN,
     program="N10 G2 X10.0055 I5 F100\nN20 M2", runs="", alarm="radius-tolerance", number="error:33", word="X10.0055", at="MAIN N10")
case("a radius reaches its end", **RUN,
     program="N10 G2 X9 R1 F100\nN20 M2", runs="", alarm="radius-too-small", number="error:34", word="R1")
case("however little is missing", pins="small_radius", **RUN,
     program="N10 G2 X10 R4.997 F100\nN20 M2", runs="", alarm="radius-too-small", number="error:34", word="R4.997")
case("which is not where it starts", pins="refuses:no-arc-travel", **RUN,
     program="N10 G0 X1\nN20 G2 X1 R1 F100\nN30 M2", runs="N10", alarm="no-arc-travel", number="error:33", word="R1")
case("and is written", **RUN,
     program="N10 G2 R1 F100\nN20 M2", runs="", alarm="no-arc-travel", number="error:26", word="G2", at="MAIN N10")
case("without radius and centre there is no arc", pins="no_radius", **RUN,
     program="N10 G2 X1 F100\nN20 M2", runs="", alarm="no-radius", number="error:35", at="MAIN N10", word="G2")
case("not even without an end", **RUN,
     program="N10 G2 F100\nN20 M2", runs="", alarm="no-radius", number="error:35", at="MAIN N10", word="G2")
case("a centre where it starts is off its circle", **RUN,
     program="N10 G2 X10 I0 F100\nN20 M2", runs="", alarm="radius-tolerance", number="error:33", word="X10", at="MAIN N10")
case("a centre beside a radius is used by nothing", pins="refuses:radius-and-centre", **RUN,
     program="N10 G2 X1 R1 I1 F100\nN20 M2", runs="", alarm="radius-and-centre", number="error:36", word="R1", at="MAIN N10")
