"""LinuxCNC: sub, endsub, call, return, and the files of subprograms."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}
_ARGUMENTS = "".join(f"[{n}]" for n in range(1, 31))

case(
    "a sub is passed over where it stands and run where it is called", **RUN,
    program="N10 o<f> sub\nN20 G0 X#1\nN30 o<f> endsub\nN40 o<f> call [5]\nN50 M2",
    runs="N10 N30 N40 N10 N20 N30 N50", moves_x=[5], calls="O:f",
)
case(
    "a sub may stand after its call, and after the end of the program", **RUN,
    program="N10 o1 call\nN20 M2\nN30 o1 sub\nN40 G0 X4\nN50 o1 endsub", runs="N10 N30 N40 N50 N20", moves_x=[4],
)
case(
    "the program may not run into a sub that was called before it was met", **RUN,
    program="N10 o1 call\nN20 o1 sub\nN30 o1 endsub\nN40 M2",
    runs="N10 N20 N30", alarm="subprogram-given-twice", at="O1 N20",
)
case(
    "a sub is given once", **RUN,
    program="N10 o1 sub\nN20 o1 endsub\nN30 o1 sub\nN40 o1 endsub\nN50 M2",
    runs="N10 N20", alarm="subprogram-given-twice",
)
case(
    "no sub stands inside another", **RUN,
    program="N10 o1 sub\nN20 o2 sub\nN30 o2 endsub\nN40 o1 endsub\nN50 M2",
    runs="N10", alarm="subprogram-in-subprogram",
)
case(
    "thirty arguments fill #1 to #30, which the caller has back afterwards", **RUN,
    program=f"N10 #30=7\nN20 o1 sub\nN30 G0 X#30\nN40 o1 endsub\nN50 o1 call {_ARGUMENTS}\nN60 G0 X#30\nN70 M2",
    moves_x=[30, 7],
)
case(
    "thirty-one are too many", **RUN,
    program=f"N10 o1 sub\nN20 o1 endsub\nN30 o1 call {_ARGUMENTS}[31]\nN40 M2",
    runs="N10 N20", alarm="too-many-arguments", at="MAIN N30",
)
case(
    "an argument that is not given is 0, not the caller's value", **RUN,
    program="N10 o1 sub\nN20 G0 X#1\nN30 G0 X#2\nN40 o1 endsub\nN50 #2=77\nN60 o1 call [5]\nN70 M2", moves_x=[5, 0],
)
case(
    "variables from #31 on are everybody's", **RUN,
    program="N10 #31=8\nN20 o1 sub\nN30 #31=3\nN40 o1 endsub\nN50 o1 call\nN60 M2", vars={31: 3},
)
case(
    "return gives a value to #<_value>", **RUN,
    program="N10 o<f> sub\nN20 o<f> return [#1*2]\nN30 o<f> endsub\nN40 o<f> call [21]\n"
    "N50 G0 X#<_value>\nN60 G0 X#<_value_returned>\nN70 M2",
    moves_x=[42, 1],
)
case(
    "so does endsub", **RUN,
    program="N10 o1 sub\nN20 o1 endsub [7]\nN30 o1 call\nN40 G0 X#<_value>\nN50 M2", moves_x=[7],
)
case(
    "a subprogram without a value leaves 0 and says so", **RUN,
    program="N10 o1 sub\nN20 o1 endsub\nN30 o1 call\nN40 G0 X[5+#<_value>] Y#<_value_returned>\nN50 M2",
    moves="R X5 Y0",
)
case(
    "the values of a sub are computed where it is met, too", **RUN,
    program="N10 o1 sub\nN20 o1 return [1/#1]\nN30 o1 endsub\nN40 M2", runs="N10", alarm="division-by-zero",
)
case(
    "there a named variable counts 0", **RUN,
    program="N10 o1 sub\nN20 o1 return [#<x>]\nN30 o1 endsub\nN40 M2", runs="N10 N20 N30 N40",
)
case(
    "a return of another label returns all the same", **RUN,
    program="N10 o1 call\nN20 G0 X#<_value>\nN30 M2\nN40 o1 sub\nN50 o2 return [5]\nN60 o1 endsub",
    runs="N10 N40 N50 N20 N30", moves_x=[5],
)
case(
    "once a call has come back, a return of the main program gives a value and goes on", **RUN,
    program="N10 o1 sub\nN20 o1 endsub\nN30 o1 call\nN40 o2 return [4]\nN50 G0 X#<_value>\nN60 M2", moves_x=[4],
)
case(
    "and an endsub is refused", **RUN,
    program="N10 o1 sub\nN20 o1 endsub\nN30 o1 call\nN40 o2 endsub\nN50 M2",
    runs="N10 N20 N30 N10 N20", alarm="return-in-main-program", at="MAIN N40",
)
case(
    "a search for a sub stops at an O-word that cannot be read", **RUN,
    program="N10 o1 call\nN20 M2\nN30 o2 foo\nN40 o1 sub\nN50 o1 endsub",
    runs="N10", alarm="statement-not-available", at="MAIN N30",
)
case(
    "the definition of a sub passes over it", **RUN,
    program="N10 o1 sub\nN20 o2 foo\nN30 o1 endsub\nN40 M2", runs="N10 N30 N40",
)
case(
    "no call leads after the % that ends a program", **RUN,
    program="%\nN10 o1 call\nN20 M2\n%\nN30 o1 sub\nN40 o1 endsub", alarm="program-not-found", runs="N10",
)
case(
    "endsub outside a sub is refused", **RUN,
    program="N10 o1 endsub\nN20 M2", runs="", alarm="return-in-main-program", at="MAIN N10",
)
case(
    "nine calls may be open", pins="max_nesting", **RUN,
    program="N10 o1 sub\nN20 G0 X#1\nN30 o2 if [#1 LT 9]\nN40 o1 call [#1+1]\nN50 o2 endif\nN60 o1 endsub\n"
    "N70 o1 call [1]\nN80 M2",
    moves_x=[1, 2, 3, 4, 5, 6, 7, 8, 9],
)
case(
    "ten are too many", pins="max_nesting", **RUN,
    program="N10 o1 sub\nN20 #100=[#100+1]\nN30 o1 call\nN40 o1 endsub\nN50 o1 call\nN60 M2",
    alarm="nesting-too-deep", at="O1 N30", vars={100: 9},
)
case(
    "a subprogram that calls itself has its own variables on each level", **RUN,
    program="N10 o1 sub\nN20 o2 if [#1 LE 1]\nN30 o1 return [1]\nN40 o2 endif\nN50 o1 call [#1-1]\n"
    "N60 o1 return [#1*#<_value>]\nN70 o1 endsub\nN80 o1 call [5]\nN90 G0 X#<_value>\nN100 M2",
    moves_x=[120],
)
case(
    "a call that leads nowhere", **RUN,
    program="N10 G0 X1\nN20 o<zz> call\nN30 M2", runs="N10", alarm="program-not-found", at="MAIN N20",
)
case(
    "a file is a subprogram of its name", control="linuxcnc", source="rs274 2.9", evidence="source document",
    files={"a.ngc": "N10 o<fs> call [3]\nN20 G0 X#<_value>\nN30 M2\n",
           "fs.ngc": "N40 o<fs> sub\nN50 G0 X#1\nN60 o<fs> endsub [9]\nN70 M2\n"},
    runs="N10 N40 N50 N60 N20 N30", moves_x=[3, 9],
)
case(
    "a file without its sub holds no subprogram", control="linuxcnc", source="rs274 2.9", evidence="source document",
    files={"a.ngc": "N10 o<fs> call\nN20 M2\n", "fs.ngc": "N40 G0 X1\nN50 M2\n"},
    runs="", alarm="program-not-found", at="a N10",
)
case(
    "a file calls the subs of the program that were met", pins="caller_call", control="linuxcnc", source="rs274 2.9",
    evidence="source document",
    files={"a.ngc": "N10 o<a> sub\nN20 G0 X1\nN30 o<a> endsub\nN40 o<fs> call\nN50 M2\n",
           "fs.ngc": "N60 o<fs> sub\nN70 o<a> call\nN80 o<fs> endsub\n"},
    runs="N10 N30 N40 N60 N70 N10 N20 N30 N80 N50", moves_x=[1],
)
case(
    "the label of a call may be a value", **RUN,
    program="N10 #5=7\nN20 o[#5] call [2]\nN30 M2\nN40 o7 sub\nN50 G0 X#1\nN60 o7 endsub", moves_x=[2],
)
case(
    "letters and blanks of a name do not count, nor how a number is written", **RUN,
    program="N10 o<My Sub> sub\nN20 G0 X1\nN30 O<MYSUB> EndSub\nN40 o<mysub> CALL\nN50 o007 call\nN60 M2\n"
    "N70 o<7> sub\nN80 G0 X2\nN90 o7.0 endsub",
    moves_x=[1, 2],
)
