"""grblHAL: numbered and named parameters, and what comments say."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHp, ngc_param_get", "evidence": "source document"}
BLOCK = {"control": "grblhal", "source": "gHg, gc_execute_block", "evidence": "source document"}
NAMED = {"control": "grblhal", "source": "gHp, ngc_named_param_get", "evidence": "source document"}
COMMENT = {"control": "grblhal", "source": "gHx, ngc_process_comment", "evidence": "source document"}

case("a number that was never set is 0", **RUN, program="N10 G0 X#100\nN20 #101=[#1 EQ 0]\nN30 M2", moves_x=[0], vars={101: 1})
case("a number takes its value when its line has run", **BLOCK,
     program="N10 #1=5\nN20 #1=6 #2=#1 G0 X#1\nN30 G0 X#1 Y#2\nN40 M2", moves="R X5\nR X6 Y5")
case("of several assignments of one number the first counts", **BLOCK, program="N10 #1=1 #1=2 #1=3\nN20 M2", vars={1: 1})
case("a number may be computed", **RUN, program="N10 #1=2\nN20 #2=9\nN30 #3=##1\nN40 #[#1+2]=7\nN50 M2", vars={3: 9, 4: 7})
case("its fraction is cut where it is assigned to", **BLOCK, program="N10 #1.9=3\nN20 M2", vars={1: 3})
case("where it is read it is whole", control="grblhal", source="gHx, ngc_read_integer_value", evidence="source document",
     program="N10 #2=#1.5\nN20 M2", runs="", alarm="whole-number-expected", number="error:23")
case("there is no #0", **RUN, program="N10 #1=#0\nN20 M2", runs="", alarm="illegal-variable", number="error:39", at="MAIN N10")
case("nor a #5071", **RUN, program="N10 #1=#5071\nN20 M2", runs="", alarm="illegal-variable", number="error:39", at="MAIN N10")
case("programs write up to #5060", **BLOCK,
     program="N10 #5060=1\nN20 #5061=1\nN30 M2", runs="N10", alarm="variable-write-protected", number="error:39", at="MAIN N20")
case("an assignment has an equals sign, as grblHAL has it", **BLOCK, program="N10 #1 5\nN20 M2", runs="", alarm="missing-equals", number="error:2")
case("a line has at most ten of numbers", control="grblhal", source="gHc, NGC_N_ASSIGN_PARAMETERS_PER_BLOCK", evidence="source document",
     program="N10 " + " ".join(f"#{i}=1" for i in range(1, 12)) + "\nN20 M2", runs="", alarm="too-many-words", number="error:2")
case("#5420 is the position in the work system", **RUN,
     program="N10 G10 L2 P1 X10\nN20 G0 X3 Y4\nN30 #100=#5420\nN40 #101=#<_abs_x>\nN50 M2", vars={100: 3, 101: 13})
case("it is millimetres under G20 too", **RUN, program="N10 G20 G0 X1\nN20 #100=#5420\nN30 M2", vars={100: 25.4})
case("#5220 is the work system in force", **RUN, program="N10 G55\nN20 #100=#5220\nN30 M2", vars={100: 2})
case("#5221 its zero point", **RUN, program="N10 G10 L2 P1 X10\nN20 #100=#5221\nN30 M2", vars={100: 10})
case("#5211 is the shift of G92", **RUN, program="N10 G0 X10\nN20 G92 X2\nN30 #100=#5211\nN40 M2", vars={100: 8})
case("#5161 is the point of G28", **RUN, program="N10 G0 X10\nN20 G28.1\nN30 #100=#5161\nN40 M2", vars={100: 10})
case("a reset leaves them as they are", pins="reset_clears:locals", control="grblhal", source="gHp, ngc_param_set",
     evidence="source document", program="N10 #1=7\nN20 #31=5\nN30 M2", vars_after_reset={1: 7, 31: 5})

case("a name takes its value at once", **BLOCK, program="N10 #<a>=4 G0 X#<a>\nN20 M2", moves_x=[4])
case("letters and blanks of a name do not count, as grblHAL has it", **NAMED, program="N10 #<My Var>=3\nN20 G0 X#<myvar>\nN30 M2", moves_x=[3])
case("a name that was never set is none", **NAMED,
     program="N10 G0 X#<a>\nN20 M2", runs="", alarm="variable-name-unknown", number="error:2", at="MAIN N10")
case("EXISTS asks for it", **NAMED,
     program="N10 #100=EXISTS[#<a>]\nN20 #<a>=1\nN30 #101=EXISTS[#<a>]\nN40 M2", vars={100: 0, 101: 1})
case("EXISTS takes no numbers", **NAMED,
     program="N10 #100=EXISTS[#5]\nN20 M2", runs="", alarm="bracket-not-closed", number="error:75")
case("a name of the control's own keeps its value", control="grblhal", source="gHp, ngc_named_param_set", evidence="source document",
     program="N10 G0 X1\nN20 #<_x>=5\nN30 G0 Y#<_x>\nN40 M2", moves="R X1\nR Y1", dropped=["#<_x>=5"])
case("#<_retract_r_plane> is 1 under G98", **NAMED,
     program="N10 G98\nN20 #100=#<_retract_r_plane>\nN30 G99\nN40 #101=#<_retract_r_plane>\nN50 M2", vars={100: 1, 101: 0})
case("a name has at most 30 characters", control="grblhal", source="gHx, ngc_read_name", evidence="source document",
     program=f"N10 #<{'a' * 31}>=1\nN20 M2", runs="", alarm="illegal-variable-name", number="error:81")
case("what tells of a machine is not computed", **NAMED,
     program="N10 #100=#<_probe_state>\nN20 M2", runs="", alarm="code-not-computed", at="MAIN N10")

case("a comment shows a message", **COMMENT, program="N10 (MSG, hello)\nN20 M2", messages=["hello"])
case("PRINT shows values", **COMMENT, program="N10 #1=2.5\nN20 (PRINT, at #1 %d#1 %.1f#1 %f#2)\nN30 M2",
     messages=["at 2.500 2 2.5 0.000"])
case("ABORT ends the run", control="grblhal", source="gHf, onGcodeComment", evidence="source document",
     program="N10 G0 X1\nN20 (ABORT, no tool)\nN30 M2", runs="N10", alarm="user-alarm", number="error:253", at="MAIN N20")
