"""LinuxCNC: numbered and named parameters."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}

case(
    "a parameter that was never set is 0", **RUN,
    program="N10 G0 X#100\nN20 #101=[#1 EQ 0]\nN30 M2", moves_x=[0], vars={101: 1},
)
case(
    "words and assignments of a line have the values from before it", **RUN,
    program="N10 #1=5\nN20 #1=6 #2=#1 G0 X#1\nN30 G0 X#1\nN40 G0 X0 Y#2\nN50 M2", moves="R X5\nR X6\nR X0 Y5",
)
case(
    "of several assignments of one parameter the last counts", **RUN,
    program="N10 #1=1 #1=2 #1=3\nN20 M2", vars={1: 3},
)
case(
    "a reset leaves the parameters as they are", pins="reset_clears:locals", control="linuxcnc",
    source="LC overview", evidence="maker's manual",
    program="N10 #1=7\nN20 #<_g>=2\nN30 #31=5\nN40 M2", vars_after_reset={1: 7, 31: 5},
)
case(
    "a parameter may say the number of another", **RUN,
    program="N10 #1=2\nN20 #2=9\nN30 #3=##1\nN40 #[#1+2]=7\nN50 M2", vars={3: 9, 4: 7},
)
case(
    "a number of a parameter is whole but for a ten-thousandth", **RUN,
    program="N10 #2=8\nN20 #3=#1.99999\nN30 #4=#1.5\nN40 M2",
    runs="N10 N20", alarm="whole-number-expected", vars={3: 8},
)
case("parameters begin at 1", **RUN, program="N10 #0=1\nN20 M2", runs="", alarm="illegal-variable", at="MAIN N10")
case(
    "parameters end at 5601", **RUN,
    program="N10 #5601=1\nN20 #5602=1\nN30 M2", runs="N10", alarm="illegal-variable", at="MAIN N20",
)
case(
    "so do computed ones", **RUN,
    program="N10 #1=5602\nN20 G0 X##1\nN30 M2", runs="N10", alarm="illegal-variable", at="MAIN N20",
)
case(
    "the position is read and not written", **RUN,
    program="N10 G0 X3 Y4\nN20 #1=#5420\nN30 #2=#5421\nN40 #5420=1\nN50 M2",
    runs="N10 N20 N30", alarm="variable-write-protected", vars={1: 3, 2: 4},
)
case("an assignment has an equals sign", **RUN, program="N10 #1 5\nN20 M2", runs="", alarm="missing-equals")
case(
    "a named parameter is the program's or the subprogram's own", **RUN,
    program="N10 #<a>=1\nN20 o1 sub\nN30 #31=[EXISTS[#<a>]]\nN40 #<a>=2\nN50 o1 endsub\nN60 o1 call\nN70 G0 X#<a>\nN80 M2",
    vars={31: 0}, moves_x=[1],
)
case(
    "one that begins with _ is everybody's", **RUN,
    program="N10 #<_g>=4\nN20 o1 sub\nN30 #<_g>=[#<_g>+2]\nN40 o1 endsub\nN50 o1 call\nN60 G0 X#<_g>\nN70 M2", moves_x=[6],
)
case(
    "letters and blanks of a name do not count", **RUN,
    program="N10 #<My Var>=3\nN20 G0 X#<myvar>\nN30 M2", moves_x=[3],
)
case(
    "a named parameter that was not set is not there", **RUN,
    program="N10 G0 X#<nope>\nN20 M2", runs="", alarm="variable-name-unknown", at="MAIN N10",
)
case(
    "but in its own first assignment it is 0", **RUN,
    program="N10 #<x>=[#<x>+1]\nN20 G0 X#<x>\nN30 M2", moves_x=[1],
)
case(
    "EXISTS tells whether a parameter is there", **RUN,
    program="N10 #<a>=1\nN20 #31=EXISTS[#<a>]\nN30 #32=EXISTS[#<b>]\nN40 #33=EXISTS[#5601]\nN50 #34=EXISTS[#5602]\nN60 M2",
    vars={31: 1, 32: 0, 33: 1, 34: 0},
)
case(
    "a name ends with >", **RUN, program="N10 #<a=5\nN20 M2", runs="", alarm="illegal-variable-name", at="MAIN N10",
)
case(
    "what the interpreter tells is not assigned to", **RUN,
    program="N10 #<_x>=5\nN20 M2", runs="", alarm="variable-write-protected",
)
case(
    "the interpreter tells its modes and its place", **RUN,
    program="N10 G0 X3 F100 G91\nN20 #31=#<_x>\nN30 #32=#<_absolute>\nN40 #33=#<_incremental>\nN50 #34=#<_metric>\n"
    "N60 #35=#<_plane>\nN70 #36=#<_feed>\nN80 #37=#<_line>\nN90 #38=#<_call_level>\nN100 M2",
    vars={31: 3, 32: 0, 33: 1, 34: 1, 35: 170, 36: 100, 37: 8, 38: 0},
)
case(
    "what tells of a machine is not computed here", **RUN,
    program="N10 G0 X#<_spindle_on>\nN20 M2", runs="", alarm="code-not-computed",
)
case("#<_abs_x> is the machine position, #<_x> the one in the work system", **RUN,
     program="N10 G10 L2 P1 X5\nN20 G0 X1\nN30 (print,#<_abs_x> #<_x>)\nN40 M2", messages=["6.000000 1.000000"])
case("named variables tell the modes", **RUN,
     program="N10 G55 G99\nN15 G41.1 D1\nN20 (print,#<_coord_system> #<_retract_r_plane> #<_ccomp> #<_units_per_rev>)\nN30 M2",
     messages=["550.000000 1.000000 410.000000 0.000000"])
for _code, _told in (("G40", 400), ("G41 D0", 410), ("G41.1 D2", 410), ("G42 D0", 420), ("G42.1 D2", 420)):
    case(f"#<_ccomp> tells the side of {_code}, not its form", **RUN,
         program=f"N10 {_code}\nN20 (print,#<_ccomp>)\nN30 M2", messages=[f"{_told}.000000"])
case("#5599 at 0 or below silences (debug,), and not (print,) and (msg,)", **RUN,
     program="N10 (debug,a #5599)\nN20 #5599=0\nN30 (debug,b)\nN40 (print,c #5599)\nN50 (msg,d)\nN60 #5599=-1\nN70 (debug,e)\n"
     "N80 #5599=0.5\nN90 (debug,f)\nN100 M2",
     messages=["a 1.000000", "c 0.000000", "d", "f"])
for _name in ("_x", "_abs_z", "_metric", "_task", "_value", "_value_returned", "_line", "_vmajor", "_current_tool", "_u"):
    case(f"#<{_name}> is not assigned to", **RUN,
         program=f"N10 #<{_name}>=5\nN20 M2", runs="", alarm="variable-write-protected")
