"""LinuxCNC: while, do, repeat, break, continue."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}

case(
    "while asks before each pass", **RUN,
    program="N10 o1 while [#1 LT 2]\nN20 #1=[#1+1]\nN30 o1 endwhile\nN40 M2",
    runs="(N10 N20 N30)*2 N10 N30 N40", vars={1: 2},
)
case(
    "do asks after each pass", **RUN,
    program="N10 o1 do\nN20 #1=[#1+1]\nN30 o1 while [#1 LT 2]\nN40 M2",
    runs="(N10 N20 N30)*2 N40", vars={1: 2},
)
case(
    "repeat takes a count to the nearest whole number, of halves the even one", **RUN,
    program="N10 o1 repeat [2.5]\nN20 G0 X#1\nN30 #1=[#1+1]\nN40 o1 endrepeat\nN50 M2",
    runs="(N10 N20 N30 N40)*2 N10 N40 N50", moves_x=[0, 1],
)
case(
    "repeat of a negative count does nothing", **RUN,
    program="N10 o1 repeat [-1]\nN20 G0 X1\nN30 o1 endrepeat\nN40 M2", runs="N10 N30 N40",
)
case(
    "break leaves a while, continue begins its next pass", **RUN,
    program="N10 o1 while [1]\nN20 #1=[#1+1]\nN30 o2 if [#1 EQ 2]\nN40 o1 continue\nN50 o2 elseif [#1 EQ 4]\n"
    "N60 o1 break\nN70 o2 endif\nN80 G0 X#1\nN90 o1 endwhile\nN100 M2",
    moves_x=[1, 3], vars={1: 4},
)
case(
    "break leaves a do at its while", **RUN,
    program="N10 o1 do\nN20 #1=[#1+1]\nN30 o1 break\nN40 o1 while [1]\nN50 M2", runs="N10 N20 N30 N40 N50",
)
case(
    "break does not leave a repeat", **RUN,
    program="N10 o1 repeat [3]\nN20 o1 break\nN30 o1 endrepeat\nN40 M2",
    runs="N10", alarm="label-of-another-kind", at="MAIN N20",
)
case(
    "break of a while is still there at the end of the next do", **RUN,
    program="N10 o1 while [1]\nN20 o1 break\nN30 o1 endwhile\nN40 o2 do\nN50 #1=[#1+1]\nN60 o2 while [#1 LT 3]\nN70 M2",
    runs="N10 N20 N30 N40 N50 N60 N70", vars={1: 1},
)
case(
    "continue of a do runs the next repeat twice", **RUN,
    program="N10 o1 do\nN20 #1=[#1+1]\nN30 o1 continue\nN40 o1 while [#1 LT 3]\nN50 o2 repeat [2]\nN60 G0 X#1\n"
    "N70 #1=[#1+1]\nN80 o2 endrepeat\nN90 M2",
    moves_x=[3, 4, 5, 6],
)
case(
    "a return out of a repeat leaves the passes that were left to the next call", **RUN,
    program="N10 o1 sub\nN20 o2 repeat [3]\nN30 #100=[#100+1]\nN40 G0 X#100\nN50 o3 if [#100 EQ 2]\nN60 o1 return\n"
    "N70 o3 endif\nN80 o2 endrepeat\nN90 o1 endsub\nN100 o1 call\nN110 G0 Y1\nN120 o1 call\nN130 M2",
    moves_x=[1, 2, 2, 3],
)
case(
    "a while without endwhile runs once", **RUN,
    program="N10 o1 while [1]\nN20 G0 X1\nN30 M2", runs="N10 N20 N30",
)
case(
    "endwhile without while has an undefined label", **RUN,
    program="N10 o1 endwhile\nN20 M2", runs="", alarm="label-not-found", at="MAIN N10",
)
case(
    "a pass of a while may call the subprogram it stands in", pins="self_call max_total_nesting", **RUN,
    program="N10 o1 sub\nN20 o2 while [#1 GT 0]\nN30 #1=[#1-1]\nN40 #100=[#100+1]\nN50 G0 X#100\nN60 o1 call [#1]\n"
    "N70 o2 endwhile\nN80 o1 endsub\nN90 o1 call [2]\nN100 M2",
    moves_x=[1, 2, 3],
)
