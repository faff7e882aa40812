"""LinuxCNC: lines, words, comments and messages."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}
_LONG = "x" * 251

case(
    "small letters, capitals and blanks are alike", **RUN,
    program="n 1 0 g 0 0 x 1 2 . 5\nN20 G1F1 00X-.5\nN30 M2", moves="R X12.5\nF X-0.5",
)
case("a semicolon begins a comment", **RUN, program="N10 G0 X1 ; X2\nN20 M2 (end)", moves_x=[1])
case("a comment is closed in its line", **RUN, program="N10 G0 X1 (a\nN20 M2", runs="", alarm="comment-not-closed")
case(
    "no comment stands in a comment", **RUN,
    program="N10 G0 X1 (a (b))\nN20 M2", runs="", alarm="comment-in-comment",
)
case(
    "a line has at most 253 characters", **RUN,
    program=f"({_LONG})\nN10 G0 X1\n({_LONG}x)\nN20 M2", runs="N10", alarm="block-too-long",
)
case("an address stands once", **RUN, program="N10 G0 X1 X2\nN20 M2", runs="", alarm="address-given-twice")
case("a group of G codes has one code", **RUN, program="N10 G0 G1 X1\nN20 M2", runs="", alarm="address-given-twice")
case("a group of M codes has one code", **RUN, program="N10 M3 M4\nN20 M2", runs="", alarm="address-given-twice")
case("N stands first", **RUN, program="N10 G0 X3 N7\nN20 M2", runs="", alarm="illegal-character")
case("an O-word stands first", **RUN, program="N10 G0 X1 o1 if [1]\nN20 M2", runs="", alarm="illegal-character")
for _code in ("G6", "G6.1", "G6.2"):
    case(f"{_code}, a spline of later versions, is none of its codes", **RUN, program=f"N10 {_code} X1\nN20 M2", runs="",
         alarm="g-code-not-available", word=_code)
case("a G code that is none", **RUN, program="N10 G37 X1\nN20 M2", runs="", alarm="g-code-not-available")
case("an M code that is none", **RUN, program="N10 M55\nN20 M2", runs="", alarm="m-code-not-available")
case("G1 needs a feed", pins="power_on_feed", **RUN, program="N10 G1 X1\nN20 M2", runs="", alarm="no-feed", word="G1")
case("a comment is no part of the word before it", **RUN,
     program="N10 G1 (cut) X1\nN20 M2", runs="", alarm="no-feed", word="G1")
case("a slash drops its line where the switch is on", **RUN, program="/N10 G0 X1\nN20 M2", skip=(1,), runs="N20")
case("and is nothing where it is off", **RUN, program="/N10 G0 X1\nN20 M2", runs="N10 N20")
case("a program that ends without M2, M30 or %", pins="missing_end", **RUN, program="N10 G0 X1", runs="N10", alarm="end-of-record")
case("% ends a program that begins with one", **RUN, program="%\nN10 G0 X1\n%\nN20 G0 X2\nN30 M2", moves_x=[1])
case("a % that begins no program is no line of one", **RUN,
     program="N10 G0 X1\n%\nN20 M2", runs="N10", alarm="illegal-character")
case("M30 ends the program from a subprogram too", pins="end_in_subprogram", **RUN,
     program="N10 o1 call\nN20 M2\nN30 o1 sub\nN40 M30\nN50 o1 endsub", runs="N10 N30 N40")
case("MSG says its text as it is", **RUN, program="N10 G0 X1 (MSG, raw #1)\nN20 M2", messages=[" raw #1"], moves_x=[1])
case(
    "DEBUG and PRINT put values in", **RUN,
    program="N10 #<a>=2.5\nN20 (DEBUG, a #1 b #<a> c #<zz> d)\nN30 (print,p #<a> q)\nN40 M2",
    messages=[" a 0.000000 b 2.500000 c ###### d", "p 2.500000 q"],
)
case(
    "%d, %f and %.1f say how many decimals the values after them have", **RUN,
    program="N10 #<a>=2.56789\nN20 (DEBUG,%d#<a> %f#<a> %.1f#<a> #<a> %g %.x #x)\nN30 (DEBUG,#<a>)\nN40 M2",
    messages=["3 2.5679 2.6 2.6 %g .x #x", "2.567890"],
)
case(
    "a value of more than 29 characters is crossed out, and so is what is no parameter", **RUN,
    program="N10 #1=12345678901234567890123456789.\nN20 (DEBUG,#1 %d#1 #5602 #0)\nN30 M2",
    messages=["###### 12345678901234568227576610816 ###### 0"],
)
case("of several comments of a line the last counts", **RUN,
     program="N10 (MSG, one)(MSG, two)\nN20 M2", messages=[" two"])
case("a message that is passed over is not said", **RUN,
     program="N10 o1 if [0]\nN20 (MSG, no)\nN30 o1 else\nN40 (MSG, yes)\nN50 o1 endif\nN60 M2", messages=[" yes"])
case("ABORT stops the program with its text", **RUN,
     program="N10 G0 X1\nN20 (ABORT, stop #1)\nN30 M2", runs="N10", alarm="user-alarm", at="MAIN N20")
case("G4 waits for seconds", pins="dwell_words", **RUN, program="N10 G4 P1.5\nN20 M2", time=1.5)
case(
    "P of G4 counts seconds where it is computed or has no point, too", pins="dwell_unit", **RUN,
    program="N10 #1=1.5\nN20 G4 P#1\nN30 G4 P[1+0.5]\nN40 G4 P2\nN50 M2", time=5,
)
case(
    "an arc that ends off its circle by more than a hair is refused", pins="arc_rounding", **RUN,
    program="N10 G2 X2.0284 Y0 I1 F100\nN20 M2", runs="", alarm="radius-tolerance", word="X2.0284",
)
case("what a large arc misses by less than a thousandth of its radius counts for nothing", pins="arc_tolerance_share", **RUN,
     program="N10 G2 X80.029 Y0 I40 F100\nN20 M2", moves_x=[80.029])
case("but for a hundred times the hair", **RUN,
     program="N10 G2 X20002.9 Y0 I10000 F100\nN20 M2", runs="", alarm="radius-tolerance", word="X20002.9")
case("in inches the hair is 28 ten-thousandths of one", pins="arc_rounding", **RUN,
     program="N10 G20\nN20 G2 X2.0028 Y0 I1 F100\nN30 M2", moves_x=[2.0028 * 25.4])
case("an arc in inches that ends farther off is refused", pins="arc_rounding", **RUN,
     program="N10 G20\nN20 G2 X2.00285 Y0 I1 F100\nN30 M2", runs="N10", alarm="radius-tolerance", word="X2.00285")
case("a character of several bytes is shown whole", **RUN,
     program="N10 G0 X1 é\nN20 M2", runs="", alarm="illegal-character", at="MAIN N10")

# A loop writes a row for each code: each would say nothing but the number.
for code in ("5.2", "18.1", "19.1", "71.1", "71.2"):
    case(
        f"the moves of G{code} are not computed on LinuxCNC", pins="g_codes", control="linuxcnc", source="LC overview", evidence="inferred",
        program=f"N10 G{code}\nN20 M2", runs="", alarm="code-not-computed", at="MAIN N10", word=f"G{code}",
    )
case(
    "G74 wants a spindle that turns", pins="g_codes", control="linuxcnc", source="rs274 2.9", evidence="inferred",
    program="N10 G0 Z5\nN20 G74 X1 Z-1 R1 F100\nN30 M2", runs="N10", alarm="spindle-stopped", at="MAIN N20", word="G74",
)
for words in ("G87 X1 Y0 Z-1 R1 I1 J0 K1 F100", "G88 X1 Z-1 R1 P1 F100"):
    case(
        f"the moves of {words.split()[0]} are not told, with its words", pins="g_codes", control="linuxcnc", source="LC g-code, G87 and G88",
        evidence="maker's manual",
        program=f"N10 M3 S100 G0 Z5\nN20 {words}\nN30 M2", runs="N10", alarm="code-not-computed", at="MAIN N20", word=words.split()[0],
    )
case(
    "G5.3 ends what is not computed", pins="g_codes", control="linuxcnc", source="LC overview", evidence="inferred",
    program="N10 G5.3 X1\nN20 M2", runs="", alarm="code-not-computed", at="MAIN N10", word="G5.3",
)
case("G49 and G97 S run alone", pins="g_codes", **RUN, program="N10 G49\nN20 G97 S100\nN30 M2", runs="N10 N20 N30")
