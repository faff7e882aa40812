"""Okuma OSP: locals by name, commons, expressions, system variables, alarms of the program's own."""

from conformance import case

RUN = {"control": "okuma-osp-p300", "source": "OKA 2202 to 2235", "evidence": "secondary"}
FUNCTIONS = {"control": "okuma-osp-p300", "source": "OKA 2327; what they give is general knowledge", "evidence": "inferred"}
KNOWN = {"control": "okuma-osp-p300", "source": "general knowledge of the Okuma OSP", "evidence": "inferred"}
MACROS = {"control": "okuma-osp-p300", "source": "OKM, OROTA.SSB and G116-NEW.LIB", "evidence": "secondary"}

case("a local has a name", **RUN, program="O1\nN10 ABC=2\nN20 G0 X=ABC\nN30 M02", moves_x=[2])
case("several are given values in a block", **RUN, program="O1\nN10 ABC=1 BCE=2\nN20 G0 X=ABC Y=BCE\nN30 M02", moves="R X1 Y2")
case("beside words too", **KNOWN, program="O1\nN10 G0 X1 ABC=1\nN20 G0 X=ABC+1\nN30 M02", moves_x=[1, 2])
case("a local has at most four characters", **RUN,
     program="O1\nN10 ABCDE=1\nN20 M02", runs="", alarm="variable-name-too-long", number="2227", at="O1 N10", word="ABCDE")
case("so has a word that is misspelled", **RUN,
     program="O1\nN10 MODNN\nN20 M02", runs="", alarm="variable-name-too-long", number="2227", at="O1 N10", word="MODNN")
case("a local is read once it has a value", **RUN,
     program="O1\nN10 G0 X=BDIK\nN20 M02", runs="", alarm="variable-name-unknown", number="2234", at="O1 N10", word="X=BDIK")
case("an assignment has its =", **RUN,
     program="O1\nN10 ABC 36\nN20 M02", runs="", alarm="missing-equals", number="2235", at="O1 N10", word="3")
case("a common too", **RUN, program="O1\nN10 V13V5\nN20 M02", runs="", alarm="missing-equals", number="2235", at="O1 N10")
case("commons are shared", **RUN,
     program="O1\nN10 V5=3\nN20 CALL O2\nN30 G0 X=V5\nN40 M02\nO2\nN50 V5=V5+1\nN60 RTS", moves_x=[4], vars={5: 4})
case("VC are others", **KNOWN, program="O1\nN10 V5=3\nN20 VC5=7\nN30 G0 X=V5 Y=VC5\nN40 M02", moves="R X3 Y7", vars={5: 3, 1005: 7})
case("they are kept at reset", **KNOWN, program="O1\nN10 V5=3\nN20 M02", vars_after_reset={5: 3})
case("one without a value counts as 0", **KNOWN, program="O1\nN10 G0 X=V7+1\nN20 M02", moves_x=[1])
case("there is no V0", **RUN, program="O1\nN10 V0=13\nN20 M02", runs="", alarm="illegal-variable", number="2202", at="O1 N10", word="V0")
case("nor V450", **RUN, program="O1\nN10 V450=20\nN20 M02", runs="", alarm="illegal-variable", number="2202", at="O1 N10", word="V450")
case("nor is it read", **RUN, program="O1\nN10 V1=V450\nN20 M02", runs="", alarm="illegal-variable", number="2202", at="O1 N10", word="V450")
case("a block does not read what it assigns", **KNOWN,
     program="O1\nN10 ABC=1 BCE=ABC\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="ABC")
case("nor a common", **KNOWN, program="O1\nN10 V1=1 V2=V1\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="V1")

for expression, value in (
    ("1+2*3", 7), ("[1+2]*3", 9), ("10-4-3", 3), ("12/4/3", 1), ("-2+5", 3), ("2*-3", -6), ("+4", 4), ("[1+[2*[3+4]]]", 15), (".5*4", 2),
    ("1/4", 0.25), ("3-1*2+4/2", 3),
):
    case(f"{expression} of an OSP is {value}", **KNOWN, program=f"O1\nN10 V1={expression}\nN20 M02", vars={1: value})
for expression, value in (
    ("SIN[30]", 0.5), ("COS[60]", 0.5), ("TAN[45]", 1), ("ATAN[1]", 45), ("ATAN2[1,-1]", 135), ("SQRT[16]", 4), ("ABS[-5]", 5), ("BIN[18]", 12),
    ("BCD[12]", 18), ("ROUND[2.6]", 3), ("FIX[2.6]", 2), ("FUP[2.1]", 3), ("DROUND[1.2346]", 1.235), ("DFIX[1.2346]", 1.234),
    ("DFUP[1.2341]", 1.235), ("MOD[17,5]", 2), ("6 AND 3", 2), ("6 OR 3", 7), ("6 EOR 3", 5), ("2*SIN[30]+1", 2),
):
    case(f"{expression} of an OSP is {value}", pins="angle_unit" if "SIN" in expression else "", **FUNCTIONS,
         program=f"O1\nN10 V1={expression}\nN20 M02", vars={1: value})
case("a function of an OSP needs its bracket", **KNOWN,
     program="O1\nN10 V1=SIN 30\nN20 M02", runs="", alarm="expression-format", number=None, at="O1 N10", word="3")
case("a second value stands after a comma", **KNOWN,
     program="O1\nN10 V1=MOD[5]\nN20 M02", runs="", alarm="missing-comma", number=None, at="O1 N10")
case("a bracket is closed", **RUN, program="O1\nN10 V1=[1+2\nN20 M02", runs="", alarm="bracket-not-closed", number="2231 4", at="O1 N10")
case("an expression does not end at an operator", **KNOWN,
     program="O1\nN10 V1=1+\nN20 M02", runs="", alarm="expression-format", number=None, at="O1 N10")
case("an OSP divides nothing by zero", **RUN, program="O1\nN10 V1=1/V2\nN20 M02", runs="", alarm="division-by-zero", number="2230", at="O1 N10")
case("no root is taken of a negative value", **RUN,
     program="O1\nN10 V1=SQRT[-1]\nN20 M02", runs="", alarm="square-root-of-negative", number="2230", at="O1 N10")
case("values are compared in conditions alone", **KNOWN,
     program="O1\nN10 V1=[V2 EQ 3]\nN20 M02", runs="", alarm="bracket-not-closed", number="2231 4", at="O1 N10")
case("hexadecimal numbers are told", **KNOWN, program="O1\nN10 V1=#81H\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10")
case("EMPTY in an expression is told", **KNOWN, program="O1\nN10 PX=EMPTY\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="EMPTY")

for letter in "XYZ":
    case(f"VZOF{letter} is the zero point of a work system", **MACROS,
         program=f"O1\nN10 VZOF{letter}[2]=10.5\nN20 G15 H2\nN30 G0 {letter}1\nN40 V1=VZOF{letter}[2]\nN50 M02",
         final_machine=f"{letter}11.5", vars={1: 10.5})
case("the index may be an expression", **MACROS,
     program="O1\nN10 PH=1 PP=2\nN15 VZOFX[PH]=3\nN20 VZOFX[PP+1]=VZOFX[PH]+1\nN30 G15 H=PP+1\nN40 G0 X1\nN50 M02", final_machine="X5")
case("VZOFV is none", **RUN, program="O1\nN10 VZOFV=40\nN20 M02", runs="", alarm="illegal-variable", number="2203", at="O1 N10", word="VZOFV")
case("there is no work system 201", **KNOWN,
     program="O1\nN10 VZOFX[201]=1\nN20 M02", runs="", alarm="illegal-variable", number="2202", at="O1 N10")
case("VTOFH is the length of a tool", **KNOWN,
     program="O1\nN10 VTOFH[3]=20\nN20 G56 H3\nN30 G0 Z1\nN40 V1=VTOFH[3]\nN50 M02", final_machine="Z21", vars={1: 20})
case("VTLCN is the tool in the spindle", **MACROS, program="O1\nN10 T5 M6\nN20 V1=VTLCN\nN30 M02", vars={1: 5})
case("VDOUT cannot be read", **RUN,
     program="O1\nN10 V1=VDOUT[31]+1\nN20 M02", runs="", alarm="variable-read-protected", number="2229", at="O1 N10", word="VDOUT")
case("VDIN cannot be set", **KNOWN,
     program="O1\nN10 VDIN[31]=1\nN20 M02", runs="", alarm="variable-write-protected", number=None, at="O1 N10", word="VDIN")
for name in ("VPVDX", "VWKCC[1]", "VTLNN", "VORD[24]", "VSLNO"):
    case(f"what {name} holds is not known", **MACROS,
         program=f"O1\nN10 V1={name}\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word=name.split("[", maxsplit=1)[0])

case("VDOUT[992] raises an alarm with the text of VUACM[1]", **MACROS,
     program="O1\nN10 VUACM[1]='NO DATA PX'\nN20 VDOUT[992]=1001\nN30 M02", runs="N10 N20", alarm="user-alarm", number="1001", at="O1 N20")
case("without a text too", **MACROS,
     program="O1\nN20 VDOUT[992]=V1+5\nN30 M02", runs="N20", alarm="user-alarm", number="5", at="O1 N20")
case("the text is one of a block", source="OKA 2208", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 VUACM[1]='NO END\nN20 M02", runs="", alarm="statement-format", number="2208 3", at="O1 N10")
case("with a character", source="OKA 2208", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 VUACM[1]=''\nN20 M02", runs="", alarm="statement-format", number="2208 1", at="O1 N10")
case("and at most sixteen", source="OKA 2208", control="okuma-osp-p300", evidence="secondary",
     program="O1\nN10 VUACM[1]='ABCDEFGHIJKLMNOPQ'\nN20 M02", runs="", alarm="statement-format", number="2208 2", at="O1 N10")
