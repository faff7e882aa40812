"""SINUMERIK: addresses by an index, tools by their names, data of tools, calls and jumps by texts."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
GROUPS = {"control": ONE, "source": "NCI, ggroups.json: the numbers of the codes of a group", "evidence": "secondary"}
NUMBERS = {"control": ONE, "source": "general knowledge of the SINUMERIK alarms", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}

# ---- codes by their groups ----

OFFSETS = {"work_offsets": {"G54": {"X": 1.125}, "G55": {"X": 2.25}, "G57": {"X": 4.5}, "G505": {"X": 8.625}, "G599": {"X": 9.125}}}
for number, centre in ((1, "X5"), (2, "X6.125"), (3, "X7.25"), (5, "X9.5"), (6, "X13.625"), (100, "X14.125")):
    for way, before in ((str(number), ""), ("R1", f"N5 R1={number}\n"), ("KORD", f"N5 DEF INT KORD={number}\n")):
        case(
            f"G[8]={way} is code {number} of the work offsets", **GROUPS, setup=OFFSETS,
            program=f"{before}N10 G0 G[8]={way}\nN20 X5\nN30 M30", centre=centre,
        )
for group, number, text, moves in (
    (1, 1, "X5", "R X5"), (1, 2, "X5 F100", "F X5"), (14, 2, "X5", "F X8"), (14, 1, "X5", "F X5"), (13, 1, "X1", "F X25.4"), (29, 2, "X5", "F X2.5"),
):
    for way in (str(number), "R1"):
        case(
            f"G[{group}]={way}, its code {number}", **GROUPS,
            program=f"N5 R1={number}\nN10 G1 X3 F500\nN20 G[{group}]={way} {text}\nN30 M30", moves=f"F X3\n{moves}",
        )
case(
    "a number that no code of the group has", **NUMBERS,
    program="N10 G[6]=4\nN20 M30", runs="", alarm="group-code-not-available", number="12475", at="MAIN N10", word="G[6]=4",
)
case(
    "nor one that is computed", **NUMBERS,
    program="N5 R1=7\nN10 G[14]=R1\nN20 M30", runs="N5", alarm="group-code-not-available", number="12475", at="MAIN N10",
)
for block in ("G[5]=1", "G[1]=6", "G[R2]=1"):
    case(
        f"{block} is not computed", **POLICY,
        program=f"N10 {block}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )
case(
    "G takes the number of a code after its equals sign", **KNOWN,
    program="N5 R1=1\nN10 G=0 X1\nN20 G=R1 X2 F100\nN30 M30", moves="R X1\nF X2",
)
case(
    "and no number that is none", **KNOWN,
    program="N10 G=999\nN30 M30", runs="", alarm="g-code-not-available", number="12470", at="MAIN N10", word="G=999",
)
# ---- spindles by their numbers ----

case(
    "M[1] is that of the first spindle, others are told", **KNOWN,
    program="N10 M[1]=3 S[1]=500\nN20 M[2]=4 S[2]=700\nN30 M30", m=[3, 30], dropped=["M[2]=4", "S[2]=700"],
)
case(
    "and so where the number is computed", **KNOWN,
    program="N5 DEF INT SPINU=1\nN10 M[SPINU]=3 S[SPINU]=500\nN15 SPINU=2\nN20 M[SPINU]=4 S[SPINU]=700\nN30 M30", m=[3, 30],
    dropped=["M[SPINU]=4", "S[SPINU]=700"],
)
case(
    "QU sends an M code without a wait", **KNOWN,
    program="N5 R1=9\nN10 M=QU(8)\nN20 M=QU( R1 )\nN30 M30", m=[8, 9, 30],
)

# ---- tools ----

TOOLS = {"tools": {5: {"name": "MILL_10", "Z": 120.5, "R": 5, "edges": {2: {"Z": 118.25, "R": 4}}}, 7: {"name": "drill", "Z": 80.125}}}
for text in ('"MILL_10"', "NAME", '"MILL_"<<10', '"mill_10"'):
    case(
        f"T={text} is the tool of this name, and takes its offsets", **KNOWN, setup=TOOLS,
        program=f'N5 DEF STRING[20] NAME="MILL_10"\nN10 T={text}\nN20 M6\nN30 G0 Z1\nN40 M30', t=[5], dropped=[], centre="Z121.5",
    )
case(
    "a name that no tool has is told, and the tool stays", **KNOWN, setup=TOOLS,
    program='N10 T="MILL_10" M6\nN20 T="OTHER" M6\nN30 G0 Z1\nN40 M30', t=[5], dropped=['T="OTHER"'], centre="Z121.5",
)
case(
    "D2 is the second edge of the tool", **KNOWN, setup=TOOLS,
    program='N10 T="MILL_10" M6\nN20 G0 D2 Z1\nN30 D1 Z1\nN40 D0 Z1\nN50 M30', centre="Z119.25 | Z121.5 | Z1",
)
case(
    "an edge that the setup does not give is told", **POLICY, setup=TOOLS,
    program="N10 T7 M6\nN20 D3\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word="D3",
)
case(
    "a program writes the length of an edge, which D takes", **KNOWN,
    program="N10 $TC_DP3[1,1]=120.5\nN15 $TC_DP12[1,1]=-0.25\nN20 T1 M6\nN30 G0 Z1\nN40 M30", centre="Z121.25",
)
case(
    "not before D or the tool change", **KNOWN,
    program="N10 T1 M6 D1\nN20 $TC_DP3[1,1]=120.5\nN30 G0 Z1\nN35 D1\nN37 Z1\nN40 M30", centre="Z1 | Z121.5",
)
case(
    "the lengths lie across the plane, along its second axis and its first", **KNOWN,
    program="N10 $TC_DP3[1,2]=3.125 $TC_DP4[1,2]=4.25 $TC_DP5[1,2]=5.5\nN20 T1 M6\nN30 G0 D2 X0 Y0 Z0\nN40 G18 X0 Y0 Z0\nN50 G19 X0 Y0 Z0\nN60 M30",
    centre="X5.5 Y4.25 Z3.125 | X4.25 Y3.125 Z5.5 | X3.125 Y5.5 Z4.25",
)
case(
    "the tables of the setup stay where a program writes nothing", **KNOWN, setup=TOOLS,
    program="N10 R1=$TC_DP3[5,1] R2=$TC_DP6[5,2] R3=$TC_DP3[5,2]\nN20 $TC_DP3[5,2]=R3+1\nN30 R4=$TC_DP3[5,2] R5=$TC_DP25[5,2]\nN40 M30",
    vars={1: 120.5, 2: 4, 3: 118.25, 4: 119.25, 5: 0},
)
case(
    "$P_TOOLNO and $P_TOOL are the tool and its edge", **KNOWN, setup=TOOLS,
    program="N10 T5 M6\nN20 D2\nN30 R1=$TC_DP6[$P_TOOLNO,$P_TOOL] R2=$P_TOOL\nN40 M30", vars={1: 4, 2: 2},
)
case(
    "a program names a tool", **KNOWN,
    program='N10 $TC_TP2[3]="CUTTER"\nN20 $TC_DP3[3,1]=50.125\nN30 T="CUTTER" M6\nN40 G0 Z1\nN50 M30', t=[3], centre="Z51.125",
)
case(
    "an alarm leaves the data of the tool as they were", **KNOWN,
    program="N10 $TC_DP3[1,1]=5\nN20 $TC_DP3[1,1]=6 R1=1/R2\nN30 M30", runs="N10", alarm="division-by-zero", number="14051", at="MAIN N20",
)
case(
    "other data of tools are told", **KNOWN,
    program="N10 $TC_TP7[1]=2\nN20 $TC_MPP6[1,R1]=R1+5\nN30 M30", runs="N10 N20 N30", dropped=["$TC_TP7[1]=2", "$TC_MPP6[1,R1]=R1+5"],
)
case(
    "and what a run does not know of them is not read", **POLICY,
    program="N10 R1=$TC_TP7[1]\nN30 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "a tool for turning that a program writes is not computed", **POLICY,
    program="N10 $TC_DP1[1,1]=500\nN20 T1 M6\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
for index in ("-1,1", "1,20", "40000,1"):
    case(
        f"$TC_DP3[{index}] is no edge", **POLICY,
        program=f"N10 $TC_DP3[{index}]=5\nN30 M30", runs="", alarm="array-element", number="12400", at="MAIN N10",
    )

# ---- jumps to what a text names ----

for text in ('"LBL"<<R1', "NAME", 'NAME<<""', "NAMES[1]"):
    case(
        f"GOTOF {text} goes where the text says", **KNOWN,
        program=f'N5 DEF STRING[10] NAME="lbl2", NAMES[2]=SET("A","LBL2")\nN7 R1=2\nN10 GOTOF {text}\nN20 LBL1: X9\nN30 LBL2: G0 X2\nN40 M30',
        runs="N5 N7 N10 N30 N40", moves_x=[2],
    )
case(
    "the text may be a block number", **KNOWN,
    program='N5 R1=40\nN10 GOTO "N"<<R1\nN20 G0 X9\nN40 M30', runs="N5 N10 N40",
)
case(
    "it counts when the jump is made: the nearest before it", **KNOWN,
    program='N5 DEF STRING[10] NAME="AA"\nN10 AA: R1=R1+1\nN20 AA: R2=R2+1\nN25 BB: R3=R3+1\nN30 IF R2<2 GOTOB NAME\nN40 NAME="BB"\nN50 IF R3<4 GOTOB NAME\nN60 M30',
    runs="N5 N10 N20 N25 N30 N20 N25 N30 N40 N50 N25 N30 N40 N50 N25 N30 N40 N50 N60",
)
for word, alarms in (("GOTOF", True), ("GOTOB", False), ("GOTO", False)):
    case(
        f"{word} searches in its direction", **KNOWN,
        program=f'N5 DEF STRING[10] NAME="AA"\nN10 AA: R1=R1+1\nN20 IF R1>1 GOTOF EE\nN30 {word} NAME\nN40 EE: M30',
        **({"runs": "N5 N10 N20", "alarm": "jump-target-not-found", "number": "14080", "at": "MAIN N30", "word": "NAME"} if alarms
           else {"runs": "N5 N10 N20 N30 N10 N20 N40"}),
    )
case(
    "GOTOC goes on where no block has the text", **KNOWN,
    program='N5 DEF STRING[10] NAME="AA"\nN30 GOTOC NAME\nN40 M30', runs="N5 N30 N40",
)
case(
    "a text that is computed leads into no structure", **NUMBERS,
    program='N5 DEF STRING[10] NAME="AA"\nN10 GOTOF NAME\nN20 IF R1==0\nN30 AA: G0 X1\nN40 ENDIF\nN50 M30',
    runs="N5", alarm="jump-target-not-found", number="14080", at="MAIN N10", word="NAME",
)
case(
    "but out of one", **KNOWN,
    program='N5 DEF STRING[10] NAME="AA"\nN10 LOOP\nN20 GOTOF NAME\nN30 ENDLOOP\nN40 AA: M30', runs="N5 N10 N20 N40",
)
case(
    "and within it", **KNOWN,
    program='N5 DEF STRING[10] NAME="AA"\nN10 IF R1==0\nN20 GOTOF NAME\nN25 G0 X9\nN30 AA: G0 X1\nN40 ENDIF\nN50 M30', runs="N5 N10 N20 N30 N40 N50",
)
case(
    "a label of another program is not meant", **NUMBERS,
    program='N5 DEF STRING[10] NAME="AA"\nN10 GOTOF NAME\nN50 M30\n%_N_PART_SPF\nN60 AA: M17',
    runs="N5", alarm="jump-target-not-found", number="14080", at="MAIN N10", word="NAME",
)
case(
    "CASE and several conditions jump by texts too", **KNOWN,
    program='N5 DEF STRING[10] NAME="AA"\nN10 CASE(R1) OF 0 GOTOF NAME 1 GOTOF BB\nN20 AA: IF R1==1 GOTOF BB IF R1==0 GOTOF NAME<<"2"\nN30 BB: G0 X9\nN40 AA2: M30',
    runs="N5 N10 N20 N40",
)
case(
    "a variable that is no text names no block: its own name is a label", **POLICY,
    program="N5 DEF INT NAME=5\nN10 GOTOF NAME\nN20 G0 X9\nN30 NAME: M30", runs="N5 N10 N30",
)

# ---- calls of what a text names ----

for text in ("NAME", '"PA"<<"RT"', "NAMES[1]", '"/_N_SPF_DIR/_N_PART_SPF"', "LONG"):
    case(
        f"CALL {text} calls the program of this name", **KNOWN,
        program=f'N5 DEF STRING[40] NAME="part", NAMES[2]=SET("A","PART"), LONG="/_N_CUS_DIR/_N_PART_SPF"\nN10 CALL {text}\nN20 M30\n%_N_PART_SPF\nN30 G0 X1\nN40 M17',
        runs="N5 N10 N30 N40 N20",
    )
case(
    "a program that is not there alarms", **KNOWN,
    program='N5 DEF STRING[40] NAME="OTHER"\nN10 CALL NAME\nN20 M30', runs="N5", alarm="named-program-not-found", number="14011", at="MAIN N10", word="NAME",
)
case(
    "its parameters have their own values", **KNOWN,
    program='N5 DEF STRING[40] NAME="PART"\nN10 CALL NAME\nN20 M30\n%_N_PART_SPF\nN30 PROC PART(REAL WIDE=4, INT COUNT)\nN40 R1=WIDE R2=COUNT+1\nN50 M17',
    vars={1: 4, 2: 1}, runs="N5 N10 N30 N40 N50 N20",
)
case(
    "but for those by reference", **NUMBERS,
    program='N5 DEF STRING[40] NAME="PART"\nN10 CALL NAME\nN20 M30\n%_N_PART_SPF\nN30 PROC PART(VAR REAL WIDE)\nN50 M17',
    runs="N5", alarm="parameter-missing", number="12300", at="MAIN N10",
)
case(
    "EXTCALL takes a text too", **KNOWN,
    program='N5 DEF STRING[40] NAME="PART.SPF"\nN10 EXTCALL(NAME)\nN20 M30\n%_N_PART_SPF\nN30 G0 X1\nN40 M17', runs="N5 N10 N30 N40 N20",
)

# ---- the lengths of a setup follow the plane ----

for plane, machine in (("G17", "X0 Y0 Z12.5"), ("G18", "X0 Y12.5 Z0"), ("G19", "X12.5 Y0 Z0")):
    case(
        f"the Z of a tool of the setup is its first length: across {plane}", control="siemens-one", source="general knowledge of the SINUMERIK 840D: tools for milling", evidence="inferred",
        setup={"tools": {1: {"Z": 12.5, "R": 1}}}, program=f"N10 T1 M6\nN20 {plane} G0 X0 Y0 Z0\nN30 M30", final_machine=machine,
    )
case(
    "a wear that a program writes is added to it in every plane", control="siemens-one", source="general knowledge of the SINUMERIK 840D: tools for milling", evidence="inferred",
    setup={"tools": {1: {"Z": 12.5}}},
    program="N10 $TC_DP12[1,1]=0.25\nN20 T1 M6\nN30 G17 G0 X0 Y0 Z0\nN40 R1=$AA_IM[Z] R2=$TC_DP3[1,1]\nN50 G18 G0 X0 Y0 Z0\nN60 R3=$AA_IM[Y] R4=$TC_DP3[1,1]\nN70 M30",
    vars={1: 12.75, 2: 12.5, 3: 12.75, 4: 12.5},
)
