"""LinuxCNC: M98 and M99 as its interpreter runs them."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}

case(
    "M98 calls the program after it, M99 returns", **RUN,
    program="N10 M98 P1\nN20 M30\nO1\nN30 G0 X1\nN40 M99", moves_x=[1], calls="M98:O1",
)
case(
    "L is the count of passes, and each is a step of the call", **RUN,
    program="N10 M98 P1 L2\nN20 M30\nO1\nN30 G0 X1\nN40 G0 X0\nN50 M99", moves_x=[1, 0, 1, 0],
)
case(
    "P is looked at for each pass", **RUN,
    program="N10 #10=1\nN20 M98 P[#10] L3\nN30 M30\nO1\nN40 G0 X1\nN50 #10=2\nN60 M99\nO2\nN70 G0 X2\nN80 #10=1\nN90 M99",
    moves_x=[1, 2, 1],
)
case(
    "L0 calls nothing", **RUN,
    program="N10 M98 P1 L0\nN20 G0 X2\nN30 M30\nO1\nN40 G0 X9\nN50 M99", moves_x=[2],
)
case(
    "but L0 leaves a level open: M99 returns after it", **RUN,
    program="N10 M98 P1 L0\nN20 #1=[#1+1]\nN30 M99\nO1\nN40 M99", runs="N10 (N20 N30)*2", vars={1: 2},
)
case(
    "#1 to #30 are the caller's, names are not", **RUN,
    program="N10 #<a>=1\nN20 #2=4\nN30 M98 P5\nN40 G0 X#2 Y#<a>\nN50 M2\nO5\nN60 #2=[#2+1]\n"
    "N70 #3=[EXISTS[#<a>]]\nN80 #<a>=9\nN90 M99",
    vars={2: 5, 3: 0}, moves="R X5 Y1",
)
case(
    "the first of two programs of one number counts", **RUN,
    program="N10 M98 P1\nN20 M98 P1\nN30 M30\nO1\nN40 G0 X1\nN50 G0 X0\nN60 M99\nO1\nN70 G0 X2\nN80 M99",
    moves_x=[1, 0, 1, 0],
)
case(
    "a file comes before the program of the number after the call", control="linuxcnc", source="rs274 2.9",
    evidence="source document",
    files={"a.ngc": "N10 M98 P100\nN20 M30\nO100\nN30 G0 X1\nN40 M99\n",
           "100.ngc": "O100\nN50 G0 X2\nN60 M99\n"},
    moves_x=[2],
)
case(
    "an M98 that is passed over is read", **RUN,
    program="N10 o1 if [0]\nN20 M98 P1.5\nN30 o1 endif\nN40 M2", runs="N10", alarm="whole-number-expected",
    at="MAIN N20",
)
case(
    "a number below zero in it is refused where it is passed over", **{**RUN, "source": "rs274 2.9"},
    program="N10 M98 P100\nN20 M98 P101 F-1\nN30 M2\nO100\nN40 G0 X1\nN50 M99",
    runs="N10", alarm="value-out-of-range", at="MAIN N20", moves="",
)
case(
    "a word that nothing uses is not, until its line runs", **{**RUN, "source": "rs274 2.9"},
    program="N10 M98 P100\nN20 M98 P101 D-1\nN30 M2\nO100\nN40 G0 X1\nN50 M99",
    runs="N10 N40 N50", alarm="address-not-usable", at="MAIN N20", word="D-1", moves="R X1",
)
case(
    "and so are its values", **RUN,
    program="N10 #1=-1\nN20 o1 if [0]\nN30 M98 P1 L#1\nN40 o1 endif\nN50 M2",
    runs="N10", alarm="illegal-repeat-count", at="MAIN N30",
)
case(
    "a search reads them with the variables of the level it calls", **RUN,
    program="N10 #1=1.5\nN20 o1 call\nN30 M2\nN40 M98 P#1\nN50 o1 sub\nN60 o1 endsub", runs="N10 N20 N50 N60 N30",
)
case(
    "P and L may be expressions", **RUN,
    program="N10 #10=4\nN20 M98 P[#10*25] L[#10/2]\nN30 M30\nO100\nN40 #11=[#11+1]\nN50 G0 X#11\nN60 M99", moves_x=[1, 2],
)
case(
    "nine programs of M98 may be open", pins="max_nesting", **RUN,
    program="N10 M98 P1\nN20 M30\nO1\nN30 #1=[#1+1]\nN40 G0 X#1\nN50 M98 P1\nN60 M99",
    moves_x=[1, 2, 3, 4, 5, 6, 7, 8, 9], alarm="nesting-too-deep",
)
case(
    "M98 needs P", **RUN, program="N10 M98 L2\nN20 M30", runs="", alarm="program-number-missing", at="MAIN N10",
)
case(
    "P is a whole number", **RUN,
    program="N10 M98 P1.5\nN20 M30", runs="", alarm="whole-number-expected", at="MAIN N10",
)
case(
    "L is not negative", **RUN,
    program="N10 M98 P1 L-1\nN20 M30\nO1\nN30 M99", runs="", alarm="illegal-repeat-count", at="MAIN N10",
)
case(
    "M98 stands first in its line", **RUN,
    program="N10 G0 X5 M98 P1\nN20 M30\nO1\nN30 M99", runs="", alarm="m-code-not-available", at="MAIN N10",
)
case(
    "words after M98 do nothing", **RUN,
    program="N10 M98 P1 G0 X3\nN20 M30\nO1\nN30 G0 X1\nN40 M99", moves_x=[1],
)
case(
    "M98 of a program that is not there", **RUN,
    program="N10 G0 X1\nN20 M98 P7\nN30 M30", runs="N10", alarm="program-not-found", at="MAIN N20",
)
case(
    "M98 does not call a sub", **RUN,
    program="N10 M98 P1\nN20 M2\nN30 o1 sub\nN40 o1 endsub", runs="N10", alarm="call-of-another-kind",
)
case(
    "O call does not call a program", **RUN,
    program="N10 o1 call\nN20 M2\nO1\nN40 M99", runs="N10", alarm="call-of-another-kind",
)
case(
    "endsub does not end what M98 has called", **RUN,
    program="N10 M98 P1\nN20 M2\nO1\nN40 G0 X1\nN50 o1 endsub", alarm="call-of-another-kind", moves_x=[1],
)
case(
    "M99 does not end a sub", **RUN,
    program="N10 o1 call\nN20 M2\nN30 o1 sub\nN40 M99", runs="N10 N30", alarm="call-of-another-kind",
)
case(
    "M99 has no words in a subprogram", **RUN,
    program="N10 M98 P1\nN20 M30\nO1\nN30 M99 P3", alarm="statement-format",
)
case(
    "M99 ends the main program", pins="main_return", **RUN,
    program="N10 G0 X1\nN20 M99\nN30 G0 X2\nN40 M2", runs="N10 N20",
)
case(
    "the main program runs on over an O line", **RUN,
    program="O1\nN10 G0 X1\nO2\nN20 G0 X2\nN30 M30", moves_x=[1, 2],
)
