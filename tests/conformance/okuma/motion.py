"""Okuma OSP of machining centers: work systems, lengths, modes, lines, arcs, dwell."""

from conformance import case

TABLE = {"control": "okuma-osp-p300", "source": "OKG, the table of G codes", "evidence": "secondary"}
POST = {"control": "okuma-osp-p300", "source": "OKP, the codes that it writes", "evidence": "secondary"}
KNOWN = {"control": "okuma-osp-p300", "source": "general knowledge of the Okuma OSP", "evidence": "inferred"}

SYSTEMS = "VZOFX[1]=10.125 VZOFY[1]=-3.5 VZOFZ[1]=7.25 VZOFX[2]=-20.375 VZOFZ[2]=1.5\n"

case("G15 H selects a work system", pins="g_codes g_meanings", **TABLE,
     program=f"O1\n{SYSTEMS}N10 G15 H1\nN20 G0 X1 Y1\nN30 M02", final_machine="X11.125 Y-2.5 Z0")
case("each has a zero point of its own", **TABLE,
     program=f"O1\n{SYSTEMS}N10 G15 H1\nN20 G0 X1 Z1\nN30 G15 H2\nN40 X1 Z1\nN50 M02", moves_x=[1, 1], final_machine="X-19.375 Z2.5")
case("H may be an expression", source="OKM, G15 H=PP", control="okuma-osp-p300", evidence="secondary",
     program=f"O1\n{SYSTEMS}N5 PP=2\nN10 G15 H=PP\nN20 G0 X1\nN30 M02", final_machine="X-19.375 Z0")
case("G15 needs H", **KNOWN, program="O1\nN10 G15\nN20 M02", runs="", alarm="motion-word-missing", number=None, at="O1 N10", word="G15")
case("machine coordinates by G15 H0 are told", **KNOWN,
     program="O1\nN10 G15 H0\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="H0")
case("there are 200 of them", pins="max_extra_systems", **KNOWN,
     program="O1\nN10 G15 H200\nN20 G15 H201\nN30 M02", runs="N10", alarm="work-system", number=None, at="O1 N20", word="H201")
case("G56 H adds the length of a tool along Z", pins="g_codes g_meanings", **POST,
     program=f"O1\n{SYSTEMS}N5 VTOFH[3]=25.5\nN10 G15 H1\nN20 G0 G56 Z10 H3\nN30 M02", final_work="X-10.125 Y3.5 Z10", final_machine="X0 Y0 Z42.75")
case("the length counts along Z in every plane", pins="length_type", **KNOWN,
     program="O1\nN5 VTOFH[3]=25.5\nN10 G18 G56 H3\nN20 G0 Z1 Y1\nN30 M02", final_machine="Y1 Z26.5")
case("G53 takes it back", pins="g_codes g_meanings", **KNOWN,
     program="O1\nN5 VTOFH[3]=25.5\nN10 G56 H3\nN20 G0 Z10\nN30 G53\nN40 G0 Z10\nN50 M02", final_machine="Z10")
case("there are 300 lengths", pins="max_offset_number", **POST,
     program="O1\nN10 G56 H300\nN20 G56 H301\nN30 M02", runs="N10", alarm="offset-number", number=None, at="O1 N20", word="H301")
case("G90 and G91 are modes", pins="g_codes", **POST,
     program=f"O1\n{SYSTEMS}N10 G15 H1\nN20 G90 G0 X5\nN30 G91 X2\nN40 G90 X2\nN50 M02", moves_x=[5, 7, 2],
     final_machine="X12.125 Y0 Z0")
case("G1 goes at the feed", pins="g_codes", **TABLE, program=f"O1\n{SYSTEMS}N10 G15 H2\nN20 G1 X5 Y2 F100\nN30 M02", moves="F X5 Y2 Z-1.5", final_machine="X-15.375 Y2 Z0")
case("a whole number is millimetres", **KNOWN, program="O1\nN10 G0 X10\nN20 X10.\nN30 M02", moves_x=[10, 10])
case("lengths count thousandths of a millimetre", pins="computed_lengths", **KNOWN,
     program="O1\nN10 G91\nN20 G0 X=1/3\nN30 X=1/3\nN40 X=1/3\nN50 M02", final_work="X0.999")
case("an arc has a centre from its start", pins="g_codes", **TABLE,
     program=f"O1\n{SYSTEMS}N10 G15 H1\nN20 G0 X1 Y2\nN30 G2 X3 Y4 I2 J0 F100\nN40 M02", moves="R X1 Y2 Z-7.25\nCW X3 Y4 C X3 Y2", final_machine="X13.125 Y0.5 Z0")
case("counter-clockwise too", pins="g_codes", **TABLE,
     program=f"O1\n{SYSTEMS}N10 G15 H1\nN20 G0 X1 Y2\nN30 G3 X3 Y4 I0 J2 F100\nN40 M02", moves="R X1 Y2 Z-7.25\nCCW X3 Y4 C X1 Y4", final_machine="X13.125 Y0.5 Z0")
case("or a radius", pins="negative_radius", **KNOWN,
     program="O1\nN20 G0 X1 Y2\nN30 G2 X3 Y4 R-2 F100\nN40 M02", moves="R X1 Y2\nCW X3 Y4 C X1 Y4")
case("its end may miss by 20 micrometres", pins="arc_tolerance", source="OKA 2252", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 G2 X10 I5.009 F100\nN20 X20.0205 I5\nN30 M02", runs="N10", alarm="radius-tolerance", number=None, at="O1 N20", word="X20.0205")
case("an arc needs a centre or a radius", pins="no_radius", source="OKA 2252", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 G2 X10 F100\nN20 M02", runs="", alarm="no-radius", number="2252 4", at="O1 N10", word="G2")
case("a centre that is its start is none", pins="refuses:no-radius", source="OKA 2252", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 G2 X10 I0 J0 F100\nN20 M02", runs="", alarm="no-radius", number="2252 4", at="O1 N10", word="I0")
case("a radius too small for its arc is refused", pins="small_radius", **KNOWN,
     program="O1\nN10 G2 X10 R4.995 F100\nN20 M02", runs="", alarm="radius-too-small", number=None, at="O1 N10", word="R4.995")
case("an arc may go along Z", pins="helix", **TABLE, program="O1\nN10 G2 X10 I5 Z3 F100\nN20 M02", final_work="X10 Z3")
for code, plane in ((17, "X1 Y2"), (18, "Z1 X2"), (19, "Y1 Z2")):
    letters = plane.replace("1", "").replace("2", "").split()
    centre = {"X": "I", "Y": "J", "Z": "K"}[letters[0]]
    case(f"G{code} selects the plane of {letters[0]} and {letters[1]}", pins="g_codes", **TABLE,
         program=f"O1\nN10 G{code} G2 {letters[0]}10 {centre}5 F100\nN20 M02", final_work=f"{letters[0]}10")
case("G4 F waits so many seconds", pins="dwell_words", source="OKM, G4 F4. (PAUSE FOR 4 SECONDS)", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 G4 F4.\nN20 M02", runs="N10 N20", time=4)
case("G4 P too", pins="dwell_words dwell_unit", source="OKM, G4 P2.", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 G4 P2.\nN20 M02", runs="N10 N20", time=2)
case("G94 is a feed a minute", pins="g_codes", **POST, program="O1\nN10 G94 G1 X10 F600\nN20 M02", time=1)
case("G95 a feed a turn", pins="g_codes", **POST, program="O1\nN10 S600 M3\nN20 G95 G1 X10 F1\nN30 M02", time=1)
case("the feed stays a number after it", pins="feed_mode_change", **KNOWN,
     program="O1\nN10 G94 G1 X10 F600\nN20 S600 M3\nN30 G95 X20\nN40 M02", runs="N10 N20 N30 N40")
for code in ("0", "4", "9", "10", "21", "23", "40", "50", "61", "64", "80"):
    case(f"G{code} runs", pins="g_codes", **(TABLE if int(code) < 30 else KNOWN),
         program=f"O1\nN10 G{code}{' F1' if code == '4' else ''}\nN20 M02", runs="N10 N20")
NOT_COMPUTED = (
    11, 14, 16, 20, 22, 30, 31, 43, 44, 51, 54, 55, 57, 58, 59, 60, 62, 92, 101, 102, 103, 104, 105, 106, 107,
    108, 109, 110, 111, 116, 130, 131, 132, 169, 170, 273, 274, 283, 284,
)
for number in NOT_COMPUTED:
    code = str(number)
    case(f"G{code} of an OSP is not computed", pins="g_codes",
         **(TABLE if int(code) < 31 else POST if code == "111" else KNOWN),
         program=f"O1\nN10 G{code}\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word=f"G{code}")
for code in ("5", "28", "65", "98", "99", "200", "999"):
    case(f"no source tells of G{code}", pins="unlisted_codes", **KNOWN, program=f"O1\nN10 G{code}\nN20 M02", runs="", alarm="code-not-known", at="O1 N10", word=f"G{code}")
case("nor of a fraction", **KNOWN, program="O1\nN10 G54.1\nN20 M02", runs="", alarm="code-not-known", number=None, at="O1 N10", word="G54.1")
case("a G code that is computed is told", **KNOWN,
     program="O1\nN10 G=V1\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="G=V1")
case("an M code too", **KNOWN, program="O1\nN10 M=V1\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="M=V1")
case("M codes of the machine run", source="OKM, M329 and M331", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 M329\nN20 M331\nN30 M02", runs="N10 N20 N30", m=[329, 331, 2])
case("T may be an expression", source="OKM, T=PT", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN5 PT=4\nN10 T=PT\nN20 M6\nN30 M02", t=[4])
for code, what in (("98", "call"), ("99", "return"), ("198", "external call")):
    case(f"M{code} is no {what}", source="OKA 2280: programs are called by CALL", control="okuma-osp-p300",
         evidence="secondary", program=f"O1\nN10 M{code}\nN20 M02", runs="N10 N20")
case("G90 is in force at power-on", pins="power_on:G91", **KNOWN, program="O1\nN10 G0 X1\nN20 X1\nN30 M02", moves_x=[1, 1])
case("G17 too", pins="power_on:G19", **KNOWN, program="O1\nN10 G2 X2 I1 F100\nN20 M02", final_work="X2")
case("and millimetres", **KNOWN, program="O1\nN10 G0 X1\nN20 M02", final_machine="X1")
for code, side in ((41, 2), (42, -2)):
    case(f"G{code} D of an OSP compensates the radius of a tool", pins="g_codes", **KNOWN,
         program=f"O1\nN5 VTOFD[1]=2\nN10 G1 G{code} D1 X10 F100\nN20 X20\nN30 G40 X30\nN40 M02", centre=f"X10 Y{side} | X20 Y{side} | X30")
case("and not G18", pins="power_on:G18", **KNOWN, program="O1\nN10 G2 Y2 J1 F100\nN20 M02", final_work="Y2")
