"""Okuma OSP: CALL, RTS, MODIN and MODOUT."""

from conformance import case

RUN = {"control": "okuma-osp-p300", "source": "OKA 2278, 2279, 2280", "evidence": "secondary"}
MACROS = {"control": "okuma-osp-p300", "source": "OKM, CALL OO30 PAXI=4 PLI=5.9039", "evidence": "secondary"}
KNOWN = {"control": "okuma-osp-p300", "source": "general knowledge of the Okuma OSP", "evidence": "inferred"}

case("CALL runs a program as often as Q says", **RUN,
     program="O1\nN10 CALL O100 Q2\nN20 G0 X9\nN30 M02\nO100\nN40 G0 X1\nN50 RTS", runs="N10 (N40 N50)*2 N20 N30", moves_x=[1, 1, 9])
case("once without Q", **RUN, program="O1\nN10 CALL O100\nN20 M02\nO100\nN40 G0 X1\nN50 RTS", runs="N10 N40 N50 N20")
case("Q may be computed", **KNOWN, program="O1\nN5 V1=2\nN10 CALL O100 Q=V1+1\nN20 M02\nO100\nN50 RTS", runs="N5 N10 N50*3 N20")
case("Q0 is refused, as an OSP has it", pins="zero_repeats", **RUN,
     program="O1\nN10 CALL O100 Q0\nN20 M02\nO100\nN50 RTS", runs="", alarm="illegal-repeat-count", number="2278", at="O1 N10", word="Q0")
case("and Q10000", pins="max_repeats too_many_repeats", **RUN,
     program="O1\nN10 CALL OAAA Q10000\nN20 M02\nOAAA\nN50 RTS", runs="", alarm="repeat-count-digits", number="2278", at="O1 N10", word="Q10000")
case("Q9999 is not", pins="max_repeats", **RUN,
     program="O1\nN10 CALL OAAA Q9999\nN20 M02\nOAAA\nN30 V1=V1+1\nN50 RTS", vars={1: 9999})
case("a call needs a name", **RUN, program="O1\nN10 CALL\nN20 M02", runs="", alarm="program-number-missing", number="2280 1", at="O1 N10", word="CALL")
case("MODIN too", **RUN, program="O1\nN10 MODIN\nN20 M02", runs="", alarm="program-number-missing", number="2280 1", at="O1 N10", word="MODIN")
case("of a program that there is", **RUN,
     program="O1\nN10 CALL O5\nN20 M02", runs="", alarm="named-program-not-found", number="2280 2", at="O1 N10", word="O5")
case("O100 is not O0100", **KNOWN,
     program="O1\nN10 CALL O0100\nN20 M02\nO100\nN30 RTS", runs="", alarm="named-program-not-found", number="2280 2", at="O1 N10", word="O0100")
case("with O and a character", **RUN,
     program="O1\nN10 CALL O\nN20 M02", runs="", alarm="illegal-program-name", number="2207 1", at="O1 N10", word="O")
case("no more than four", **RUN,
     program="O1\nN10 CALL OABCDE\nN20 M02", runs="", alarm="illegal-program-name", number="2207 2", at="O1 N10", word="OABCDE")
case("a call finds a program of another file", source="OKM, .SSB and .LIB", control="okuma-osp-p300", evidence="secondary",
     files={"MAIN.MIN": "O1\nN10 CALL OSUB\nN20 M2\n", "TOOLS.SSB": "OONE\nN30 RTS\nOSUB\nN40 RTS\n"}, runs="N10 N40 N20")
for ending in ("SUB", "LIB"):
    case(f"a .{ending} too", source="OKM, .SSB and .LIB", control="okuma-osp-p300", evidence="secondary",
         files={"MAIN.MIN": "O1\nN10 CALL OSUB\nN20 M2\n", f"OTHER.{ending}": "OSUB\nN40 RTS\n"}, runs="N10 N40 N20")
case("RTS in the main program is one too many", pins="main_return", **RUN,
     program="O1\nN10 G0 X1\nN20 RTS", runs="N10", alarm="return-in-main-program", number="2279 1", at="O1 N20", word="RTS")
case("eight levels are enough", pins="max_nesting max_total_nesting self_call", **RUN,
     program="O1\nN10 CALL O2\nN20 M02\nO2\nN30 G0 X1\nN40 CALL O2\nN50 RTS", runs="N10 (N30 N40)*7 N30",
     alarm="nesting-too-deep", number="2279 2", at="O2 N40", moves_x=[1] * 8)
case("a program may call itself and its caller", pins="caller_call", **KNOWN,
     program="O1\nN10 V1=V1+1\nN20 IF [V1 GT 2] N50\nN30 CALL O2\nN40 M02\nN50 RTS\nO2\nN60 CALL O1\nN70 M02", runs="N10 N20 N30 N60 (N10 N20 N30 N60)*1 N10 N20 N50 N70")
case("M02 in a subprogram ends the run", pins="end_in_subprogram", **KNOWN,
     program="O1\nN10 CALL O2\nN20 M02\nO2\nN30 M02", runs="N10 N30")
case("a call gives the locals of the program their values", **MACROS,
     program="O1\nN10 CALL OO30 PAXI=4 PLI=5.9\nN20 M02\nOO30\nN30 G0 X=PAXI Y=PLI\nN40 RTS", moves="R X4 Y5.9")
case("which may be expressions", **MACROS,
     program="O1\nN5 PA=2\nN10 CALL O2 PX=PA*3 PY=-PA\nN20 M02\nO2\nN30 G0 X=PX Y=PY\nN40 RTS", moves="R X6 Y-2")
case("with Q between them", **MACROS,
     program="O1\nN10 CALL O100 Q2 PX=4\nN20 M02\nO100\nN30 G0 X=PX\nN40 RTS", moves_x=[4, 4])
case("other programs have locals of their own", **KNOWN,
     program="O1\nN5 PX=1\nN10 CALL O2\nN15 G0 X=PX\nN20 M02\nO2\nN30 PX=7\nN40 RTS", moves_x=[1])
case("a local of the caller has no value in it", **KNOWN,
     program="O1\nN5 PX=1\nN10 CALL O2\nN20 M02\nO2\nN30 G0 X=PX\nN40 RTS", runs="N5 N10", alarm="variable-name-unknown", number="2234", at="O2 N30", word="X=PX")
case("a word of one letter beside a call is told", **KNOWN,
     program="O1\nN10 CALL O2 X5\nN20 M02\nO2\nN30 RTS", runs="", alarm="code-not-computed", at="O1 N10", word="X5")
case("as a common is", **KNOWN,
     program="O1\nN10 CALL O2 V1=5\nN20 M02\nO2\nN30 RTS", runs="", alarm="code-not-computed", at="O1 N10", word="V1")
case("a value needs its =", **RUN,
     program="O1\nN10 CALL O2 PX 5\nN20 M02\nO2\nN30 RTS", runs="", alarm="missing-equals", number="2235", at="O1 N10", word="5")
case("words after RTS are told", **KNOWN,
     program="O1\nN10 CALL O2\nN20 M02\nO2\nN30 RTS G0", runs="N10", alarm="code-not-computed", at="O2 N30", word="G0")
case("a call after other words is told", **KNOWN,
     program="O1\nN10 G0 X1 CALL O2\nN20 M02\nO2\nN30 RTS", runs="", alarm="code-not-computed", at="O1 N10", word="CALL")

case("MODIN calls after each block that moves an axis, until MODOUT", source="OKA 2279", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 MODIN O100\nN20 G0 X1\nN30 G0 X2\nN40 MODOUT\nN50 G0 X3\nN60 M02\nO100\nN70 M08\nN80 RTS",
     runs="N10 N20 N70 N80 N30 N70 N80 N40 N50 N60", moves_x=[1, 2, 3])
case("not after one that moves none", pins="modal_trigger", **KNOWN,
     program="O1\nN10 MODIN O100\nN20 G0 X0\nN30 M8\nN40 MODOUT\nN60 M02\nO100\nN80 RTS", runs="N10 N20 N30 N40 N60")
case("with its values each time", pins="modal_locals", **KNOWN,
     program="O1\nN10 MODIN O100 PX=1\nN20 G0 X1\nN30 G0 X2\nN40 MODOUT\nN60 M02\nO100\nN70 V1=PX\nN75 PX=5\nN80 RTS", vars={1: 1})
case("a second MODIN is added to the first", pins="second_modal_call", **RUN,
     program="O1\nN10 MODIN O2\nN20 MODIN O3\nN30 G0 X1\nN40 MODOUT\nN50 G0 X2\nN60 MODOUT\nN70 M02\nO2\nN80 RTS\nO3\nN90 RTS",
     runs="N10 N20 N30 N90 N40 N50 N80 N60 N70")
case("MODOUT alone is one too many", pins="cancel_alone", **RUN,
     program="O1\nN10 MODOUT\nN20 M02", runs="", alarm="modal-call-missing", number="2279 3", at="O1 N10")
case("eight of them are enough", pins="max_modal_calls", **RUN,
     program="O1\n" + "N10 MODIN O2\n" * 9 + "N20 M02\nO2\nN30 RTS", runs="N10*8", alarm="modal-calls-too-many", number="2279 4", at="O1 N10")
case("a call may stand between MODIN and MODOUT", pins="calls_in_modal", **KNOWN,
     program="O1\nN10 MODIN O2\nN20 CALL O3\nN30 MODOUT\nN40 M02\nO2\nN50 RTS\nO3\nN60 RTS", runs="N10 N20 N60 N30 N40")
