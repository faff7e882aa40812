"""LinuxCNC: modes that are saved and restored, diameters, probing and threads."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}
BOOK = {"control": "linuxcnc", "source": "LC m-code", "evidence": "maker's manual"}

case("F and S beside M72 are read first, and taken back", **{**RUN, "source": "rs274 2.9"},
     program="N10 G94 F300 S500\nN20 M70\nN30 F100 S10\nN40 M72 F55 S77\nN50 (print,#<_feed> #<_rpm>)\nN60 M2",
     messages=["300.000000 500.000000"])
case("F0 too", **{**RUN, "source": "rs274 2.9"},
     program="N10 F300\nN20 M70\nN30 F100\nN40 M72 F0\nN50 G1 X1\nN60 M2", moves="F X1")
case("M72 takes the modes back in that M70 saved", pins="roles:M70=save-modes roles:M72=restore-modes", **RUN,
     program="N10 G1 X1 F100\nN20 M70\nN30 G20 G91\nN40 M72\nN50 X3\nN60 M2", moves="F X1\nF X3")
case("the feed comes back in its own unit", **RUN,
     program="N10 F100\nN20 M70\nN30 G20 F7\nN40 M72\nN50 (print,#<_feed> #<_metric>)\nN60 M2", messages=["100.000000 1.000000"])
case("what nobody saved does not come back", **RUN,
     program="N10 G0 X1\nN20 M72\nN30 M2", runs="N10", alarm="modes-not-saved", word="M72")
case("M71 forgets what was saved", pins="roles:M71=forget-modes", **BOOK,
     program="N10 M70\nN20 M71\nN30 M72\nN40 M2", runs="N10 N20", alarm="modes-not-saved", word="M72")
case("a subprogram saves for itself", **RUN,
     program="""
         N10 o1 sub
         N20 M72
         N30 o1 endsub
         N40 M70
         N50 o1 call
         N60 M2
     """, alarm="modes-not-saved", at="O1 N20", word="M72")
case("M73 takes the modes back in at the return", pins="roles:M73=keep-modes", **RUN,
     program="""
         N10 o1 sub
         N20 M73
         N30 G91 G20
         N40 o1 endsub
         N50 G0 X5
         N60 o1 call
         N70 G0 X1
         N80 M2
     """, moves="R X5\nR X1")
case("but not after M71", **BOOK,
     program="""
         N10 o1 sub
         N20 M73
         N30 G91
         N40 M71
         N50 o1 endsub
         N60 o1 call
         N70 G0 X1
         N80 X1
         N90 M2
     """, moves="R X1\nR X2")
case("G7 takes X for a diameter, in its own line too", pins="g_meanings", **RUN,
     program="N10 G7 G0 X10\nN20 X10\nN30 (print,#5420 #<_lathe_diameter_mode>)\nN40 G8\nN50 X4\nN60 M2",
     moves="R X5\nR X5\nR X4", messages=["5.000000 1.000000"])
case("G38.2 is a mode: the next line probes too", pins="g_meanings skip_own_feed", **RUN,
     program="N10 G38.3 X5 F100\nN20 X7\nN30 M2", moves="F X5\nF X7")
case("a probing move that is to meet something leads somewhere", **RUN,
     program="N10 G38.2 X0 F100\nN20 M2", runs="", alarm="probe-without-way", word="G38.2")
case("G38.3 may stay", **RUN, program="N10 G38.3 X0 F100\nN20 M2", runs="N10 N20")
case("it names an axis", **RUN,
     program="N10 G38.2 F100\nN20 M2", runs="", alarm="motion-word-missing", word="G38.2")
case("#5070 tells whether the probe met something, #5061 where", pins="skip_signals", **{**BOOK, "source": "LC g-code"},
     inputs={"skips": [{"X": 3}]}, program="""
         N10 G38.2 X5 F100
         N20 (print,#5070 #5061)
         N30 G38.3 X9
         N40 (print,#5070 #5061)
         N50 M2
     """, messages=["1.000000 3.000000", "0.000000 9.000000"])
case("G76 cuts beside its drive line, each pass deeper", pins="g_meanings", **RUN,
     program="N10 M3 S100\nN20 G76 Z-10 P1 I-2 J0.5 K1\nN30 M2",
     moves="""
         R X0.5
         R X-2.5
         T X-2.5 Z-10
         R X0.5 Z-10
         R X0 Z0
         R X-3
         T X-3 Z-10
         R X0 Z-10
         R Z-10
     """)
case("it wants the spindle to turn", pins="refuses:spindle-stopped", **RUN,
     program="N10 G76 Z-10 P1 I-2 J0.5 K1\nN20 M2", runs="", alarm="spindle-stopped", word="G76")
case("so does G33", pins="refuses:spindle-stopped", **RUN,
     program="N10 G33 Z-2 K0.5\nN20 M2", runs="", alarm="spindle-stopped", word="G33")
case("a tap to the right wants it to turn to the right", **RUN,
     program="N10 M4 S100 G0 Z5\nN20 G84 Z-1 R2 F100\nN30 M2", runs="N10", alarm="spindle-direction", word="G84")
case("G86 dwells for the seconds of its P", pins="g_meanings", **RUN,
     program="N10 M3 S100 G0 Z5\nN20 G98 G86 Z-1 R2 P0.5 F6000\nN30 G80 M2", moves="R Z5\nR Z2\nF Z-1\nW 0.5\nR Z5")
case("a spline needs its control point", **{**BOOK, "source": "LC g-code"},
     program="N10 F100\nN20 G5.1 X4 I2\nN30 M2", runs="N10", alarm="spline-word", word="G5.1")
case("a spline is not compensated", **{**BOOK, "source": "LC g-code"}, setup={"radius_offsets": {1: 1}},
     program="N10 G41 D1 G1 X5 F100\nN20 G5.1 X9 I2 J2\nN30 M2", runs="N10", alarm="spline-in-offset", word="G5.1")
case("after G80 an axis wants a motion code", pins="refuses:no-motion-code", **RUN,
     program="N10 G0 X1\nN20 G80\nN30 X2\nN40 M2", runs="N10 N20", alarm="no-motion-code", word="X2")
case("and so does the first axis of a program", pins="refuses:no-motion-code", **RUN,
     program="N10 X2\nN20 M2", runs="", alarm="no-motion-code", word="X2")
case("#<_motion_mode> tells a canned cycle and its end", **RUN,
     program="""
         N10 G0 Z5
         N20 (print,#<_motion_mode>)
         N30 G81 Z1 R2 F100
         N40 (print,#<_motion_mode>)
         N50 G80
         N60 (print,#<_motion_mode>)
         N70 M2
     """, messages=["0.000000", "810.000000", "800.000000"])
case("G53 does not stand under G91", pins="machine_move", **RUN,
     program="N10 G91 G0 X1\nN20 G53 X3\nN30 M2", runs="N10", alarm="machine-move-in-increments", word="G53")
case("the first block of a cycle has R, a depth, and what its code wants", **RUN,
     program="N10 G0 Z5\nN20 G82 Z-1 R1 F100\nN30 M2", runs="N10", alarm="motion-word-missing", word="G82")
case("R lies above the bottom of the hole", **RUN,
     program="N10 G0 Z5\nN20 G81 Z3 R1 F100\nN30 M2", runs="N10", alarm="r-below-bottom", word="R1")
case("G85 feeds out to R, G89 to the level of G98", pins="tap_return", **RUN,
     program="N10 G0 Z5 F6000\nN20 G98 G85 Z-1 R2\nN30 G89 X1 Z-1 R2 P0.5\nN40 G80 M2",
     moves="R Z5\nR Z2\nF Z-1\nF Z2\nR Z5\nR X1\nR Z2\nF Z-1\nW 0.5\nF Z5")
case("G38.4 and G38.5 go to their end where the probe never leaves", pins="g_meanings", **RUN,
     program="N10 G38.4 X5 F100\nN20 G38.5 X7\nN30 M2", moves="F X5\nF X7")

# ---- words that belong to one code ----

case("S beside G92 is the speed", pins="speed_limit", **RUN,
     program="N10 G21 S500 M3\nN20 G92 X0 S1000\nN30 G95 G1 X10 F1\nN40 M2", time=0.6)
case("D of G96 is the highest speed, not an offset", pins="speed_limit", **RUN,
     program="N10 G21 G96 D600 S100 M3\nN20 G95 G1 Z-10 F1\nN30 M2", time=1)
case("G96 without D has no highest speed", **RUN,
     program="N10 G21 G96 D600 S100 M3\nN20 G96 S31.415926535898\nN30 G0 X10\nN40 G95 G1 Z-10 F1\nN50 M2", moves="R X10\nF Z-10", time=1.26)
for _begun, _before in (("G41.1 D4", "G40"), ("G41.1 D4", "G40\nN31 G41 D2\nN32 G40"), ("G41 D2", "G40")):
    case(f"M72 begins the side of {_begun} by G41, with the tool in the spindle, after {len(_before.split())} words", **RUN,
         setup={"radius_offsets": {1: 1, 2: 3}},
         program=f"N10 T1 M6\nN20 {_begun}\nN25 M70\nN30 {_before}\nN40 M72\nN50 G1 X5 F100\nN60 X9\nN70 M2",
         centre="X5 Y1 | X9 Y1")
case("where a side is compensated, M72 leaves its radius", **RUN,
     program="N10 G41.1 D4\nN20 M70\nN30 G40\nN40 G41.1 D2\nN50 M72\nN60 G1 X5 F100\nN70 X9\nN80 M2", centre="X5 Y1 | X9 Y1")
