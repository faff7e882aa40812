"""grblHAL: branches, loops and subprograms by flow words."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHf, ngc_flowctrl", "evidence": "source document"}

case("if runs its blocks where its condition holds", **RUN,
     program="N10 #1=2\no1 if [#1 EQ 2]\nN20 G0 X1\no1 else\nN30 G0 X2\no1 endif\nN40 M2", runs="N10 N20 N40", moves_x=[1])
case("and else its own where it does not", **RUN,
     program="o1 if [0]\nN20 G0 X1\no1 else\nN30 G0 X2\no1 endif\nN40 M2", runs="N30 N40", moves_x=[2])
case("elseif asks another one", **RUN,
     program="N10 #1=2\no1 if [#1 EQ 1]\nN20 G0 X1\no1 elseif [#1 EQ 2]\nN30 G0 X2\no1 elseif [1]\nN40 G0 X3\no1 else\nN50 G0 X4\n"
     "o1 endif\nN60 M2", moves_x=[2])
case("without any that holds, else runs", **RUN,
     program="o1 if [0]\nN20 G0 X1\no1 elseif [0]\nN30 G0 X2\no1 else\nN50 G0 X4\no1 endif\nN60 M2", moves_x=[4])
case("or nothing", **RUN, program="o1 if [0]\nN20 G0 X1\no1 elseif [0]\nN30 G0 X2\no1 endif\nN60 M2", runs="N60", moves="")
case("while repeats as long as its condition holds", **RUN,
     program="N10 #1=0\no1 while [#1 LT 3]\nN20 #1=[#1+1]\nN30 G0 X#1\no1 endwhile\nN40 M2", moves_x=[1, 2, 3])
case("do asks at its end", **RUN,
     program="N10 #1=5\no1 do\nN20 #1=[#1+1]\nN30 G0 X#1\no1 while [#1 LT 3]\nN40 M2", moves_x=[6])
case("repeat counts", **RUN,
     program="N10 #1=0\no1 repeat [3]\nN20 #1=[#1+1]\nN30 G0 X#1\no1 endrepeat\nN40 M2", moves_x=[1, 2, 3])
case("its count is computed once", **RUN,
     program="N10 #1=2\no1 repeat [#1]\nN20 #1=[#1+1]\nN30 G0 X#1\no1 endrepeat\nN40 M2", moves_x=[3, 4])
case("not at all for a count of 0", **RUN, program="o1 repeat [0]\nN20 G0 X1\no1 endrepeat\nN40 M2", runs="N40", moves="")
case("break leaves the loop of its label", **RUN,
     program="N10 #1=0\no1 while [1]\nN20 #1=[#1+1]\no2 if [#1 GE 2]\no1 break\no2 endif\nN30 G0 X#1\no1 endwhile\nN40 M2", moves_x=[1])
case("an outer one too", **RUN,
     program="o1 repeat [2]\no2 repeat [2]\nN20 G91 G0 X1\no1 break\no2 endrepeat\nN30 G0 X5\no1 endrepeat\nN40 M2", moves_x=[1])
case("continue goes on with its next pass", **RUN,
     program="N10 #1=0\no1 repeat [3]\nN20 #1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nN30 G0 X#1\no1 endrepeat\nN40 M2", moves_x=[1, 3])
case("continue in do asks nothing", **RUN,
     program="N10 #1=0\no1 do\nN20 #1=[#1+1]\no2 if [#1 LT 3]\no1 continue\no2 endif\nN30 G0 X#1\no1 while [0]\nN40 M2", moves_x=[3])
case("continue in while asks again", **RUN,
     program="N10 #1=0\no1 while [#1 LT 3]\nN20 #1=[#1+1]\no2 if [#1 LT 2]\no1 continue\no2 endif\nN30 G0 X#1\no1 endwhile\nN40 M2", moves_x=[2, 3])
case("where its condition no longer holds what follows is not computed", **RUN,
     program="N10 #1=0\no1 while [#1 LT 1]\nN20 #1=[#1+1]\no1 continue\no1 endwhile\nN40 M2", runs="N10 N20", alarm="code-not-computed")
case("a line that cannot be read is refused where it is passed over, too", **RUN,
     program="N10 G0 X1\no1 if [0]\nX[1\no1 endif\nN20 M2", runs="N10", alarm="expression-format", number="error:71")
case("one whose first word can be read is not", **RUN,
     program="N10 G0 X1\no1 if [0]\nG0 X[1\no1 endif\nN20 M2", runs="N10 N20", moves_x=[1])
case("twenty branches and loops may be open", **RUN,
     program="N10 G0 X1\n" + "".join(f"o{i} if [1]\n" for i in range(1, 22)) + "".join(f"o{i} endif\n" for i in range(21, 0, -1)) + "N20 M2",
     runs="N10", alarm="nesting-too-deep", number="error:82")
case("an endif without its if is refused", **RUN,
     program="N10 G0 X1\no1 endif\nN20 M2", runs="N10", alarm="label-not-found", number="error:81")
case("one of another label does nothing", **RUN,
     program="o1 if [1]\nN10 G0 X1\no2 endif\nN20 G0 X2\no1 endif\nN30 M2", moves_x=[1, 2])
case("an endwhile in an if is refused", **RUN,
     program="o1 if [1]\nN10 G0 X1\no2 endwhile\nN20 G0 X2\no1 endif\nN30 M2", runs="N10", alarm="label-not-found", number="error:81")
case("a break without its loop is refused", **RUN,
     program="N10 G0 X1\no1 break\nN20 M2", runs="N10", alarm="label-not-found", number="error:81")
case("a condition has brackets", control="grblhal", source="gHx, ngc_eval_expression", evidence="source document",
     program="N10 G0 X1\no1 if 1\nN20 M2", runs="N10", alarm="g-code-not-available", number="error:20")
case("a word that is no flow word is refused", **RUN,
     program="N10 G0 X1\no1 foo\nN20 M2", runs="N10", alarm="statement-format", number="error:81")

case("a subprogram stands before its call", **RUN,
     program="o100 sub\nN10 G0 X#1\no100 endsub\nN20 o100 call [5]\nN30 M2", runs="N20 N10 N30", moves_x=[5])
case("it is passed over where the program comes to it", **RUN,
     program="N10 G0 X1\no100 sub\nN20 G0 X2\no100 endsub\nN30 M2", runs="N10 N30", moves_x=[1])
case("a call of one that stands after it is refused", **RUN,
     program="N10 G0 X1\nN20 o100 call\nN30 M2\no100 sub\nN40 G0 X2\no100 endsub", runs="N10", alarm="label-not-found", number="error:81",
     at="MAIN N20")
case("the first of two of one label counts", **RUN,
     program="o100 sub\nN10 G0 X1\no100 endsub\no100 sub\nN20 G0 X2\no100 endsub\nN30 o100 call\nN40 M2", moves_x=[1])
case("a parameter that is not given is the caller's", **RUN,
     program="o100 sub\nN10 G0 X#1 Y#2\nN20 #2=9\no100 endsub\nN30 #2=7\nN40 o100 call [5]\nN50 G0 X#2\nN60 M2", moves="R X5 Y7\nR X7")
case("#31 and on are everybody's", **RUN,
     program="o100 sub\nN10 #31=[#31+1]\no100 endsub\nN20 #31=1\nN30 o100 call\nN40 G0 X#31\nN50 M2", moves_x=[2])
case("a name is the subprogram's own, one that begins with _ everybody's", **RUN,
     program="o100 sub\nN10 #100=EXISTS[#<a>]\nN20 #<_n>=[#<_n>+1]\no100 endsub\nN30 #<a>=1\nN40 #<_n>=1\nN50 o100 call\n"
     "N60 G0 X#<a> Y#<_n>\nN70 M2", vars={100: 0}, moves="R X1 Y2")
case("of subprograms that share an endsub each begins at its own head", **RUN,
     program="o1 sub\nN10 G0 X1\no2 sub\nN20 G0 X2\no2 endsub\no3 if [#31 EQ 0]\nN30 #31=1\nN40 o2 call\nN50 G0 X3\no3 endif\nN60 M2",
     runs="N30 N40 N20 N50 N60", moves_x=[2, 3])
case("without an endsub nothing more is done", **RUN,
     program="N10 G0 X1\no1 sub\nN20 G0 X2\nN30 o1 call\nN40 M2", runs="N10", moves_x=[1])
case("a repeat in a file that M98 calls has passes of its own", **RUN,
     files={"main.nc": "o1 repeat [2]\nN10 M98 P200\no1 endrepeat\nN20 M30\n", "P200.macro": "o1 repeat [3]\nN30 G91 G0 X1\no1 endrepeat\n"},
     runs="(N10 N30 N30 N30)*2 N20")
case("so has one in a subprogram", **RUN,
     program="o1 sub\no2 repeat [3]\nN10 G91 G0 X1\no2 endrepeat\no1 endsub\no1 repeat [2]\nN20 o1 call\no1 endrepeat\nN30 M2",
     runs="(N20 N10 N10 N10)*2 N30")
case("return goes back at once", **RUN,
     program="o100 sub\nN10 G0 X1\no100 return\nN20 G0 X2\no100 endsub\nN30 o100 call\nN40 M2", moves_x=[1])
case("endsub gives a value back", **RUN,
     program="o100 sub\nN10 #31=[#1*2]\no100 endsub [#31+1]\nN20 o100 call [4]\nN30 G0 X#<_value> Y#<_value_returned>\nN40 M2",
     moves="R X9 Y1")
case("the value is computed with the caller's parameters", **RUN,
     program="o100 sub\nN10 #2=8\no100 endsub [#1*2]\nN20 #1=3\nN30 o100 call [4]\nN40 G0 X#<_value>\nN50 M2", moves_x=[6])
case("where none is given back a call leaves 0", **RUN,
     program="o100 sub\nN10 G0 Y1\no100 endsub\nN20 #<_value>=5\nN30 o100 call\nN40 G0 X#<_value> Y#<_value_returned>\nN50 M2", moves="R Y1\nR X0 Y0")
case("an endsub outside of a call ends nothing", **RUN, program="N10 G0 X1\no100 endsub\nN20 G0 X2\nN30 M2", moves_x=[1, 2])
case("ten calls may be open", pins="max_nesting", control="grblhal", source="gHp, ngc_call_push", evidence="source document",
     program="o100 sub\nN10 #31=[#31+1]\nN20 o100 call\no100 endsub\nN30 o100 call\nN40 M2", vars={31: 10}, alarm="nesting-too-deep",
     number="error:82")
case("a subprogram with a name is a file", **RUN,
     files={"main.nc": "N10 G0 X1\nN20 o<drill> call [5]\nN30 M2\n", "drill.macro": "o<drill> sub\nN40 G0 X#1\no<drill> endsub [3]\n"},
     main="main", runs="N10 N20 N40 N30", moves_x=[1, 5])
case("and is refused in the file that calls", **RUN,
     program="N10 G0 X1\no<drill> sub\nN20 G0 X2\no<drill> endsub\nN30 M2", runs="N10", alarm="label-not-found", number="error:81")
case("one that is not there is not opened", **RUN,
     program="N10 G0 X1\nN20 o<drill> call\nN30 M2", runs="N10", alarm="named-program-not-found", number="error:84", at="MAIN N20")
case("the end of its file returns", control="grblhal", source="gHf, onNamedSubEOF", evidence="source document",
     files={"main.nc": "N10 o<drill> call\nN20 G0 X2\nN30 M2\n", "drill.macro": "o<drill> sub\nN40 G0 X1\n"}, main="main", moves_x=[1, 2])
