"""LinuxCNC: centres of arcs, several turns, polar words and splines."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}
BOOK = {"control": "linuxcnc", "source": "LC g-code", "evidence": "maker's manual"}

case("G90.1 gives the centre of an arc itself, G91.1 from its start", pins="g_meanings g_codes machine max_feed power_on:G91 power_on:G18 power_on:G19 power_on:G20", **RUN,
     program="""
         N10 G90.1 G2 X2 Y0 I1 J0 F100
         N20 X4 I3 J0
         N30 G91.1 X6 I1
         N40 M2
     """, moves="CW X2 Y0 C X1 Y0\nCW X4 Y0 C X3 Y0\nCW X6 Y0 C X5 Y0")
case("both words of such a centre are written", **RUN,
     program="N10 G90.1 G2 X2 Y0 I1 F100\nN20 M2", runs="", alarm="no-radius", word="I1")
case("#<_ijk_absolute_mode> tells it", pins="modal_groups", **RUN,
     program="N10 (print,#<_ijk_absolute_mode>)\nN20 G90.1\nN30 (print,#<_ijk_absolute_mode>)\nN40 M2",
     messages=["0.000000", "1.000000"])
case("P of an arc tells how often it goes around", pins="helix", **RUN,
     program="N10 G3 X0 I1 Z-3 P3 F60\nN20 M2", moves="CCW Z-3 C X1 Y0", time=18.849556)
case("not once is too few", pins="helix", **RUN,
     program="N10 G3 X0 I1 P0 F100\nN20 M2", runs="", alarm="value-out-of-range", word="P0")
case("an arc takes a rotary axis along", pins="helix", **RUN,
     program="N10 G2 X2 I1 A90 F100\nN20 M2", final_work="X2 A90")
case("an arc whose centre is its start has no radius", **RUN,
     program="N10 G2 X0 I0.001 F100\nN20 M2", runs="", alarm="no-radius", word="I0.001")
for _line in ("G3 X4 I1 R0", "G3 X4 K1 R5", "I0.5 R5", "M5 J0.5 R0"):
    case(f"{_line} has a radius and a centre", pins="refuses:radius-and-centre", **RUN,
         program=f"N10 G3 X2 I1 F100\nN20 {_line}\nN30 M2", runs="N10", alarm="radius-and-centre", word=_line.split()[-1])
case("R to where the tool stands is no arc", **RUN,
     program="N10 G2 X0 R5 F100\nN20 M2", runs="", alarm="no-arc-travel", word="R5")
case("@ and ^ are the radius and the angle of a point", **RUN,
     program="N10 G0 @10 ^30\nN20 @20\nN30 ^0\nN40 M2",
     moves="R X8.660254 Y5\nR X17.320508 Y10\nR X20 Y0")
case("under G91 they count on", **RUN,
     program="N10 G0 @10 ^0\nN20 G91 @5\nN30 ^90\nN40 M2", moves="R X10\nR X15\nR X0 Y15")
case("X does not go with them", **RUN,
     program="N10 G0 X1\nN20 G0 @10 X1\nN30 M2", runs="N10", alarm="polar-word", word="G0")
case("nor does another plane than G17", **RUN,
     program="N10 G18\nN20 G0 @10 ^5\nN30 M2", runs="N10", alarm="polar-word", word="G0")
case("a radius alone has no direction at the zero point", **RUN,
     program="N10 G0 @10\nN20 M2", runs="", alarm="polar-word", word="G0")
case("G5 is a curve to its end by the directions at both ends", **BOOK,
     program="N10 F60\nN20 G5 I0 J3 P0 Q3 X4 Y0\nN30 M2", final_work="X4 Y0", time=6.7436)
case("after it one without I and J goes on in its direction", **BOOK,
     program="N10 F60\nN20 G5 I0 J3 P0 Q3 X4 Y0\nN30 G5 P0 Q-3 X8 Y0\nN40 M2", final_work="X8 Y0", time=13.4872)
for _code in ("G5 X9 Y1 I1 J1 P0 Q-1", "G5.1 X9 Y1 I1 J1"):
    case(f"{_code} holds for its block, and the mode before goes on", **{**BOOK, "source": "rs274 2.9"},
         program=f"N10 G1 X5 F100\nN20 {_code}\nN30 (print,#<_motion_mode>)\nN40 X3\nN50 M2",
         messages=["10.000000"], final_work="X3 Y1")
    case(f"where none was in force, none is after {_code}", **{**BOOK, "source": "rs274 2.9"},
         program=f"N10 F100\nN20 {_code}\nN30 X3\nN40 M2", runs="N10 N20", alarm="no-motion-code", word="X3")
