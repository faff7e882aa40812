"""LinuxCNC: if, elseif, else, endif."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}

case(
    "an if that holds runs to its else", **RUN,
    program="N10 o1 if [1]\nN20 G0 X1\nN30 o1 else\nN40 G0 X2\nN50 o1 endif\nN60 M2",
    runs="N10 N20 N30 N50 N60", moves_x=[1],
)
case(
    "of several elseif the first that holds runs", **RUN,
    program="N10 o1 if [0]\nN20 o1 elseif [#1 EQ 0]\nN30 G0 X3\nN40 o1 elseif [1]\nN50 G0 X5\nN60 o1 endif\nN70 M2",
    runs="N10 N20 N30 N40 N60 N70", moves_x=[3],
)
case(
    "an elseif after the branch that ran is computed all the same", **RUN,
    program="N10 o1 if [1]\nN20 o1 elseif [1/0]\nN30 o1 endif\nN40 M2",
    runs="N10", alarm="division-by-zero", at="MAIN N20",
)
case(
    "a label is used once in a program", **RUN,
    program="N10 o1 if [1]\nN20 o1 endif\nN30 o1 if [1]\nN40 o1 endif\nN50 M2",
    runs="N10 N20", alarm="label-given-twice", at="MAIN N30",
)
case(
    "a label that was passed over is free", **RUN,
    program="N10 o2 if [0]\nN20 o1 if [1]\nN30 o1 endif\nN40 o2 endif\nN50 o1 if [1]\nN60 G0 X6\nN70 o1 endif\nN80 M2",
    runs="N10 N40 N50 N60 N70 N80", moves_x=[6],
)
case(
    "a label of a subprogram is not that of the program", **RUN,
    program="N10 o7 sub\nN20 o1 if [1]\nN30 o1 endif\nN40 o7 endsub\nN50 o1 if [1]\nN60 o7 call\nN70 o1 endif\nN80 M2",
    runs="N10 N40 N50 N60 N10 N20 N30 N40 N70 N80",
)
case(
    "else without if has an undefined label", **RUN,
    program="N10 G0 X1\nN20 o1 else\nN30 M2", runs="N10", alarm="label-not-found", at="MAIN N20",
)
case(
    "endwhile does not end an if", **RUN,
    program="N10 o1 if [1]\nN20 o1 endwhile\nN30 M2", runs="N10", alarm="label-of-another-kind", at="MAIN N20",
)
case(
    "an if that does not hold and has no endif looks to the end of the file", **RUN,
    program="N10 o1 if [0]\nN20 G0 X1\nN30 M2", runs="N10", alarm="end-of-record",
)
case(
    "and in a program that % ends it looks no farther than that", **RUN,
    program="%\nN10 o1 if [0]\nN20 G0 X1\n%\nN30 o1 endif\nN40 M2", runs="", alarm="program-not-found",
)
case(
    "a label is whole where it is passed over, too", **RUN,
    program="N10 o1 if [0]\nN20 o2.5 if [1]\nN30 o1 endif\nN40 M2", runs="N10", alarm="whole-number-expected",
    at="MAIN N20",
)
case(
    "the condition of an if stands in brackets", **RUN,
    program="N10 o1 if 1\nN20 o1 endif\nN30 M2", runs="", alarm="statement-format", at="MAIN N10",
)
case(
    "nothing but a comment stands after a condition", **RUN,
    program="N10 o1 if [1] G0 X1\nN20 o1 endif\nN30 M2", runs="", alarm="statement-format", at="MAIN N10",
)
case(
    "what is passed over is not read", **RUN,
    program="N10 o1 if [0]\nN20 G0 X$ foo\nN30 o2 while [1/0]\nN40 o1 endif (c) ; d\nN50 M2",
    runs="N10 N40 N50",
)
case(
    "but its comments are", **RUN,
    program="N10 o1 if [0]\nN20 G0 (a (b))\nN30 o1 endif\nN40 M2", runs="N10", alarm="comment-in-comment",
)
case(
    "and so are the words after its labels", **RUN,
    program="N10 o1 if [0]\nN20 o2 foo\nN30 o1 endif\nN40 M2", runs="N10", alarm="statement-not-available",
)
