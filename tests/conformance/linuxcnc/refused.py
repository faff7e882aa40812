"""LinuxCNC: refusals that depend on the mode in force, and those under radius compensation."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}
D1 = {"radius_offsets": {1: 1}}

# ---- words that the mode does not use ----

for _mode, _word in (
    ("G1 X1 F1", "I1"), ("G1 X1 F1", "J1"), ("G1 X1 F1", "K1"), ("G1 X1 F1", "R1"), ("G1 X1 F1", "Q1"), ("G1 X1 F1", "L1"),
    ("G2 X2 I1 F1", "Q1"), ("G81 X1 Z-1 R1 F1", "Q1"), ("G81 X1 Z-1 R1 F1", "I1"), ("G83 X1 Z-1 R1 Q1 F1", "P1"),
    ("G85 X1 Z-1 R1 F1", "E1"), ("G0 X1", "H1"),
):  # one row for each mode and letter: the interpreter has a list of them
    case(f"{_word} after {_mode} is used by nothing", **RUN,
         program=f"N10 {_mode}\nN20 X3 {_word}\nN30 M2", runs="N10", alarm="address-not-usable", word=_word)
case("I J K move in an arc alone", **RUN,
     program="N10 G1 X1 F1\nN20 M8 J1\nN30 M2", runs="N10", alarm="address-not-usable", word="J1")
case("in an arc they go on without an axis", **RUN,
     program="N10 G2 X0 I1 F1\nN20 I2\nN30 M2", moves="CW X0 C X1 Y0\nCW X0 C X2 Y0")
case("no mode goes on in a block of G10", **RUN,
     program="N10 G82 X1 Z-1 R1 P1 F1\nN20 G80\nN30 G10 L2 P1 X1 H1\nN40 M2", runs="N10 N20", alarm="address-not-usable", word="H1")
case("Q-1 is no Q", **RUN, program="N10 G0 X1 Q-1\nN20 M2", moves="R X1")
case("a code that is computed uses its words", **RUN,
     program="N10 G[4] P1\nN20 G[0] X1 P1\nN30 M2", runs="N10", alarm="address-not-usable", word="P1")
for _line, _word in (("G96", "G96"), ("M61", "M61"), ("M62", "M62"), ("M65", "M65"), ("M67 Q1", "M67"), ("M68 E-1 Q1", "M68")):
    case(f"{_line} lacks a word", **RUN, program=f"N10 {_line}\nN20 M2", runs="", alarm="motion-word-missing", word=_word)
for _line, _word in (("M19 P3", "P3"), ("M19 P0.5", "P0.5"), ("M19 R361", "R361"), ("M19 Q0", "Q0")):
    case(f"{_line} is beyond its range", **RUN, program=f"N10 {_line}\nN20 M2", runs="", alarm="value-out-of-range", word=_word)
for _word in ("H1.5", "L1.5", "T1.5"):
    case(f"{_word} is no whole number", **RUN, program=f"N10 {_word}\nN20 M2", runs="", alarm="whole-number-expected", word=_word)
for _line in ("S[0-3]", "T[0-3]", "S-#1"):
    case(f"{_line} is below zero", **RUN, program=f"N5 #1=2\nN10 {_line}\nN20 M2", runs="N5", alarm="value-out-of-range")
for _word in ("Q-2", "Q[0-2]"):
    case(f"a pecking cycle refuses {_word}", pins="refuses:peck-negative", **RUN,
         program=f"N10 G0 Z10 F100\nN20 G83 X1 Z-5 R2 {_word}\nN30 M2", runs="N10", alarm="peck-negative", word=_word)
case("G43.2 without axes and H lacks them", **RUN,
     program="N10 G43.2\nN20 M2", runs="", alarm="motion-word-missing", word="G43.2")
case("P of G10 that misses its system by rounding alone is that system", **RUN,
     program="N10 G10 L2 P[0.3/0.1] X1\nN20 G56 G0 X5\nN30 M2", final_machine="X6")
case("a thread has no feed of its own", **RUN,
     program="N10 M3 S1\nN20 G33 Z-1 K1 F1\nN30 M2", runs="N10", alarm="address-not-usable", word="F1")
case("a dwell does not share its P with an arc", **RUN,
     program="N10 G2 G4 X2 I1 P1 F1\nN20 M2", runs="", alarm="one-shot-with-motion", word="G4")
for _word in ("H1", "D1", "E1", "I1", "J1", "K1", "Q1", "R1", "D1 I1 J1"):
    case(f"M98 takes no {_word}", **RUN, program=f"N10 M98 P1 {_word}\nN20 M2\nO1\nN30 M99",
         runs="", alarm="address-not-usable", word=_word.split()[0])

case("a G code that is computed is refused at its own word", **RUN,
     program="N10 X3 G[2*100]\nN20 M2", runs="", alarm="g-code-not-available", at="MAIN N10", word="G[2*100]")

for _line in ("G[0+1] G[1+1] X1 I1", "G0 G[1+1] X1 I1", "G[1] G0 X1", "G17 G[9+9]"):
    case(f"{_line} are codes of one group, computed or not", pins="repeated_address", **RUN,
         program=f"N10 F100\nN20 {_line}\nN30 M2", runs="N10", alarm="address-given-twice")

for _word in ("X1", "A1"):
    case(f"{_word} beside M98 stands where a motion is in force alone", **RUN,
         program=f"N10 G80\nN20 M98 P1 {_word}\nN30 M2\nO1\nN40 M99", runs="N10", alarm="no-motion-code", word=_word)
case("no rotary axis stands beside M98 in a canned cycle", **RUN,
     program="N10 G81 X1 Z-1 R1 F100\nN20 M98 P1 A3\nN30 M2\nO1\nN40 M99", runs="N10", alarm="rotary-axis-in-cycle", word="A3")
case("lengths of G43.1 stand beside M98 at any time", **RUN,
     program="N10 G80\nN20 M98 P1 G43.1 Z1\nN30 M2\nO1\nN40 M99", runs="N10 N20 N40 N30")

# ---- G53 ----

case("G53 goes with a straight move of the block or of the mode", **RUN,
     program="N10 G0 X1\nN20 G53 X2\nN30 G1 F1 G53 X3\nN40 G2 X4 I0.5\nN50 G53 X5\nN60 M2", runs="N10 N20 N30 N40",
     alarm="machine-move-without-line", word="G53")
case("it needs an axis", **RUN, program="N10 G0 X1\nN20 G53\nN30 M2", runs="N10", alarm="machine-move-without-line", word="G53")
case("in a cycle it goes nowhere", **RUN,
     program="N10 G81 X1 Z-1 R1 F1\nN20 G53 X2\nN30 M2", runs="N10", alarm="machine-move-without-line", word="G53")

# ---- feeds ----

case("G94 leaves no feed in force", pins="feed_mode_change", **RUN,
     program="N10 G1 X1 F10\nN20 G94 X2\nN30 M2", runs="N10", alarm="no-feed", word="X2")
case("G95 neither", pins="feed_mode_change", **RUN,
     program="N10 S100 M3 G1 X1 F10\nN20 G95\nN30 X2\nN40 M2", runs="N10 N20", alarm="no-feed", word="X2")
case("an F beside it is a feed", **RUN, program="N10 G1 X1 F10\nN20 G94 X2 F20\nN30 X3\nN40 M2", moves="F X1\nF X2\nF X3")
case("under G93 every cut has its own F", pins="feed_mode_change", **RUN,
     program="N10 G93 G1 X1 F10\nN20 G0 X3\nN30 G1 X4\nN40 M2", runs="N10 N20", alarm="no-feed", word="G1")
case("an arc too", **RUN, program="N10 G93 G2 X2 I1 F10\nN20 X4 I1\nN30 M2", runs="N10", alarm="no-feed", word="X4")
case("G94 after G93 begins anew", **RUN,
     program="N10 F10\nN20 G93\nN30 G94\nN40 G1 X1\nN50 M2", runs="N10 N20 N30", alarm="no-feed", word="G1")
case("M72 takes back the kind of feed, and the feed where that differs", **RUN,
     program="N10 F10\nN20 M70\nN30 G95 F2\nN40 M72\nN50 G1 X1\nN60 M2", moves="F X1")
case("where the number is the same nothing is in force", **RUN,
     program="N10 F10\nN20 M70\nN30 G95 F10\nN40 M72\nN50 G1 X1\nN60 M2", runs="N10 N20 N30 N40", alarm="no-feed", word="G1")
case("a cycle does not go under G93", **RUN,
     program="N10 G93 G81 X1 Z-1 R1 F1\nN20 M2", runs="", alarm="cycle-in-inverse-time", word="G93")
case("F beside G20 counts in the unit before", pins="feed_unit", **RUN,
     program="N10 G20 F100 G1 X1\nN20 M2", moves="F X25.4", time=15.24)
case("F after it in inches", **RUN, program="N10 G20\nN20 F10 G1 X1\nN30 M2", moves="F X25.4", time=6)
case("a feed per turn needs a speed", **RUN,
     program="N10 G95 G1 X1 F1\nN20 M2", runs="", alarm="no-spindle-speed", word="G1")
case("a probe does not go by a feed per turn", **RUN,
     program="N10 S100 M3 G95 F1\nN20 G38.3 X1\nN30 M2", runs="N10", alarm="skip-per-revolution", word="G38.3")

for _line in ("G93 G1", "G94 G1", "G1 G99 G95"):
    case(f"G1 without an axis needs a feed too: {_line}", pins="refuses:no-feed", **RUN,
         program=f"N10 G1 X1 F10\nN20 {_line}\nN30 M2", runs="N10", alarm="no-feed", word="G1")
case("where there was none at all as well", pins="refuses:no-feed", **RUN,
     program="N10 G0 X1\nN20 G1\nN30 M2", runs="N10", alarm="no-feed", word="G1")
case("where one is in force it is a block like others", **RUN, program="N10 G0 X1 F10\nN20 G1\nN30 X2\nN40 M2", moves="R X1\nF X2")
for _line in ("G10 L2 X1", "G10 L2", "G10 L2 R5"):
    case(f"{_line} names no system", **RUN, program=f"N10 {_line}\nN20 M2", runs="", alarm="g10-p", word="G10")

# ---- under radius compensation ----

for _code in ("G28", "G28 X1", "G30", "G53 G0 X9", "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3",
              "G61", "G61.1", "G64", "G64 P0.1", "G98", "G99", "G92 X1"):  # a row for each code of the list
    case(f"{_code} does not stand under radius compensation",
         pins="codes_not_compensated", **RUN, setup=D1,
         program=f"N10 G41 D1 G1 X5 F100\nN20 {_code}\nN30 M2", runs="N10", alarm="code-in-offset", word=_code.split()[0])
for _code in ("M6", "M48", "M49", "M50 P1", "M51 P1", "M52 P1", "M53 P1", "M62 P1", "M63 P1", "M64 P1", "M65 P1",
              "M66 P1", "M67 E1 Q1", "M68 E1 Q1"):
    case(f"{_code} does not stand under radius compensation",
         pins="m_codes_not_compensated", **RUN, setup=D1,
         program=f"N10 T1 M6\nN20 G41 D1 G1 X5 F100\nN30 {_code}\nN40 M2", runs="N10 N20", alarm="code-in-offset", word=_code.split()[0])
for _code in ("G90", "G91.1", "M3", "M8", "S5", "T2", "F5", "G4 P1", "G17", "G94 F5", "G80"):
    case(f"{_code} stands there", **RUN, setup=D1,
         program=f"N10 G41 D1 G1 X5 F100\nN20 {_code}\nN30 G1 X9\nN40 M2", runs="N10 N20 N30 N40")
case("G92.1 does nothing there", **RUN, setup=D1,
     program="N10 G92 X0\nN20 G52 X3\nN30 G41 D1 G1 X5 F100\nN40 G92.1\nN50 G1 X9\nN60 M2", final_work="X9")

for _line in ("#1=#5420", "X#5421", "G40 X[#5428+9]", "#1=##2"):
    case(f"a program does not read a position there: {_line}", **RUN, setup=D1,
         program=f"N10 #2=5422\nN20 G41 D1 G1 X5 F100\nN30 {_line}\nN40 M2", runs="N10 N20", alarm="position-in-offset")
case("whether there is one it may ask, and a message tells it", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 Y5\nN30 #1=EXISTS[#5420]\nN40 (print,#5420 #1)\nN50 M2", messages=["4.000000 1.000000"])
case("beside G41 it reads the one before", **RUN, setup=D1,
     program="N10 G0 X3\nN20 G41 D1 G1 X[#5420+5] F100\nN30 Y5\nN40 M2", centre="X3 | X7 Y1 | X7 Y5")

# ---- with G40 to G42, which come before the other codes of the block ----

for _code in ("G55", "G28", "G61", "G64", "G99", "G92 X1"):
    case(f"{_code} does not stand beside G41", pins="codes_not_compensated", **RUN, setup=D1,
         program=f"N10 G1 X1 F100\nN20 G41 D1 {_code}\nN30 M2", runs="N10", alarm="code-in-offset", word=_code.split()[0])
for _code in ("G28.1", "G30.1"):
    case(f"{_code} stores no point beside G41", **RUN, setup=D1,
         program=f"N10 G1 X1 F100\nN20 G41 D1 {_code}\nN30 M2", runs="N10", alarm="shift-in-offset", word=_code)
    case(f"{_code} stores one beside G40", **RUN, setup=D1,
         program=f"N10 G41 D1 G1 X5 F100\nN20 G40 {_code}\nN30 M2", runs="N10 N20 N30")
for _code in ("G43", "G49"):
    case(f"{_code} neither", **RUN, setup=D1,
         program=f"N10 G1 X1 F100\nN20 G41 D1 {_code}\nN30 M2", runs="N10", alarm="shift-in-offset", word=_code)
for _code in ("G55", "G61", "G99", "G49", "G92 X1", "G81 X9 Z-1 R1"):
    case(f"{_code} stands beside G40", **RUN, setup=D1,
         program=f"N10 G41 D1 G1 X5 F100\nN20 G40 {_code}\nN30 M2", runs="N10 N20 N30")
case("M codes come before G40", pins="m_codes_not_compensated", **RUN, setup=D1,
     program="N10 G41 D1 G1 X5 F100\nN20 G40 M48\nN30 M2", runs="N10", alarm="code-in-offset", word="M48")
case("and before G41", **RUN, setup=D1, program="N10 G41 D1 M48\nN20 M2", runs="N10 N20")
case("L of G41.1 is how a turning tool lies, in its plane", **RUN,
     program="N10 G41.1 D2 L1\nN20 M2", runs="", alarm="address-not-usable", word="L1")
case("there it is not computed", **RUN, program="N10 G18\nN20 G41.1 D2 L1\nN30 M2", runs="N10", alarm="code-not-computed", word="L1")
case("L0 lies no way", **RUN, program="N10 G18\nN20 G41.1 D2 L0\nN30 M2", runs="N10 N20 N30")
for _line, _word in (("G19 G2 I1", "I1"), ("G18 G3 J1", "J1"), ("G17 G2 K1", "K1"), ("G19 G93 G2 I1 F5", "I1")):
    case(f"{_line} has a centre outside of its plane", **RUN,
         program=f"N10 F100\nN20 {_line}\nN30 M2", runs="N10", alarm="arc-axis-not-in-plane", word=_word)
for _line, _word in (("G2 X2 I1 K0", "K0"), ("G18 G3 X2 I1 J0", "J0"), ("G19 G2 Y2 J1 I0", "I0")):
    case(f"at 0 too: {_line}", pins="refuses:arc-axis-not-in-plane", **RUN,
         program=f"N10 F100\nN20 {_line}\nN30 M2", runs="N10", alarm="arc-axis-not-in-plane", word=_word)
case("where the arc goes on by its centre as well", **RUN,
     program="N10 G2 X2 I1 F100\nN20 K0 I1\nN30 M2", runs="N10", alarm="arc-axis-not-in-plane", word="K0")
for _line in ("G19 G41", "G42 G19 M51", "G19 G41.1 D1", "G42.1 D2 G19 X5"):
    case(f"the plane of Y and Z has no radius compensation: {_line}", pins="refuses:offset-in-wrong-plane", **RUN,
         program=f"N10 G0 X1\nN20 {_line}\nN30 M2", runs="N10", alarm="offset-in-wrong-plane", word=next(w for w in _line.split() if w.startswith("G4")))
case("there it may end", **RUN, program="N10 G19\nN20 G40\nN30 M2", runs="N10 N20 N30")
for _code in ("G4 P1", "G28.1", "G92.1", "G92.3"):
    case(f"beside {_code} the axes of G43.1 are its own too", **RUN,
         program=f"N10 G0 X1 Z5\nN20 {_code} G43.1 Z4\nN30 G90\nN40 (print,#<_z>)\nN50 M2", messages=["1.000000"], final_machine="X1 Z5")
case("a motion code moves by them as well", **RUN,
     program="N10 G0 X1 Z5\nN20 G0 G43.1 Z4\nN30 M2", final_work="X1 Z4", final_machine="X1 Z8")
case("a drilling code too", **RUN,
     program="N10 G0 X1 Z5 F100\nN20 G81 G43.1 Z4 R6\nN30 M2", final_machine="X1 Z10", moves="R X1 Z5\nR Z6\nF Z4\nR Z6")
case("a word that nothing uses is seen before M72 takes modes back", **RUN, setup=D1,
     program="N10 M70\nN20 G41 D1 G1 X5 F100\nN30 M72 Y5 D3\nN40 M2", runs="N10 N20", alarm="address-not-usable", word="D3")
case("no straight move is made by them for G53", **RUN,
     program="N10 G0 X1 Z5\nN20 G53 G43.1 Z4\nN30 M2", runs="N10", alarm="machine-move-without-line", word="G53")
case("nor has an arc words by them", **RUN,
     program="N10 G2 X2 I1 F100\nN20 G43.1 Z4 I1\nN30 M2", runs="N10", alarm="address-not-usable", word="I1")
for _code in ("G2", "G3", "G99 G3"):
    case(f"{_code} alone is no arc", **RUN, program=f"N10 F100\nN20 {_code}\nN30 M2", runs="N10", alarm="no-radius", word=_code.split()[-1])
case("under G96 a feed per minute needs no speed", **RUN,
     program="N10 G96 S0\nN20 G1 X1 F10\nN30 M2", moves="F X1")
case("no thread is cut there", **RUN, setup=D1,
     program="N10 M3 S100\nN20 G41 D1 G1 X5 F100\nN30 G33 Z-2 K1\nN40 M2", runs="N10 N20", alarm="code-in-offset", word="G33")
case("where the radius is 0 one is", **RUN,
     program="N10 M3 S100\nN20 G41 D1 G1 X5 F100\nN30 G33 Z-2 K1\nN40 M2", moves="F X5\nT Z-2")

# ---- parameters ----

case("a work offset that is written moves nothing at once", pins="written_offset", **RUN,
     program="N10 #5221=7\nN20 G0 X1\nN30 M2", final_machine="X1")
case("it counts when its system is selected after another", **RUN,
     program="N10 #5221=7\nN20 G0 X1\nN30 (print,#5221)\nN40 G55\nN50 G54\nN60 G0 X1\nN70 M2",
     messages=["7.000000"], moves="R X1\nR X1", final_machine="X8")
case("G10 of the system takes it over", **RUN,
     program="N10 #5221=7\nN20 G10 L2 P1 Y0\nN30 G0 X1\nN40 M2", final_machine="X8")
case("so is its turn", pins="written_offset", **RUN,
     program="N10 #5230=90\nN20 G0 X1\nN30 G55\nN40 G54\nN50 G0 X5 Y0\nN60 (print,#5230)\nN70 M2",
     messages=["90.000000"], final_machine="X0 Y5")
case("that of another system counts with it", **RUN,
     program="N10 #5241=7\nN20 G55\nN30 G0 X1\nN40 M2", final_machine="X8")
for _number in (5061, 5069, 5070, 5210, 5220, 5230, 5399):
    case(f"#{_number} may be written and is read back", **RUN,
         program=f"N10 #{_number}=3\nN20 #1=#{_number}\nN30 M2", vars={1: 3})
case("a probe tells its point anew", **RUN,
     program="N10 #5061=3 #5070=9\nN20 G38.3 X5 F100\nN30 #1=#5061 #2=#5070\nN40 M2", vars={1: 5, 2: 0})
case("what was written before a probe does not come back with another of its parameters", **RUN,
     program="N10 #5061=3\nN20 G38.3 X5 F100\nN30 #5062=4\nN40 #1=#5061 #2=#5062\nN50 M2", vars={1: 5, 2: 4})
case("a work system its number", **RUN,
     program="N10 #5220=7\nN20 G54\nN30 #1=#5220\nN40 G55\nN50 #2=#5220\nN60 M2", vars={1: 7, 2: 2})

# ---- % ----

case("where the main program stands between %, a file that begins with one is not read", **RUN,
     files={"main.ngc": "%\nN10 o<sub> call\nN20 M2\n%", "sub.ngc": "%\no<sub> sub\nN30 G0 X1\no<sub> endsub\n%"},
     runs="", alarm="program-not-found")
case("a % that stands before a sub in its file hides it from a program that begins with one", **RUN,
     files={"main.ngc": "%\nN10 o<sub> call\nN20 M2\n%", "sub.ngc": "(SUB)\n%\no<sub> sub\nN30 G0 X1\no<sub> endsub\n%"},
     main="main", runs="N10", alarm="program-not-found")
case("where no % begins the main program, one before the sub hides nothing", **RUN,
     files={"main.ngc": "N10 o<sub> call\nN20 M2", "sub.ngc": "(SUB)\n%\no<sub> sub\nN30 G0 X1\no<sub> endsub\n%"},
     main="main", moves_x=[1])
case("a % inside a sub is refused", **RUN,
     files={"main.ngc": "N10 o<sub> call\nN20 M2", "sub.ngc": "o<sub> sub\nN30 G0 X1\n%\no<sub> endsub\n"},
     main="main", alarm="illegal-character", moves_x=[1])
case("otherwise it is", **RUN,
     files={"main.ngc": "N10 o<sub> call\nN20 M2", "sub.ngc": "%\no<sub> sub\nN30 G0 X1\no<sub> endsub\n%"},
     moves="R X1")
