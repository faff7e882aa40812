"""SINUMERIK: variables that a program defines with DEF."""

from conformance import case

ONE = "siemens-one"
NAMES = {"control": ONE, "source": "SONE p.383, naming rules", "evidence": "maker's manual"}
LOCAL = {"control": ONE, "source": "808D p.126: local user data", "evidence": "secondary"}
JOBS = {"control": ONE, "source": "828Dj p.23, definition of user variables", "evidence": "secondary"}
TYPES = {"control": ONE, "source": "840Da p.45, conversions of types", "evidence": "secondary"}
RANGE = {"control": ONE, "source": "840Df p.63, types", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}

case(
    "a variable has the value of its definition until another is given", **LOCAL,
    program="N10 DEF REAL DEPTH=2.5\nN20 G0 Z=DEPTH\nN30 DEPTH=DEPTH*2\nN40 Z=-DEPTH\nN50 M30", moves="R Z2.5\nR Z-5",
)
case(
    "a variable without a value is 0", **LOCAL,
    program="N10 DEF REAL DEPTH\nN20 R1=DEPTH+1\nN30 M30", vars={1: 1},
)
case(
    "one block defines several variables of a type", **JOBS,
    program="N10 DEF INT ONE=1, TWO, THREE=3\nN20 R1=ONE R2=TWO R3=THREE\nN30 M30", vars={1: 1, 2: 0, 3: 3},
)
case(
    "small letters name the same variable", control=ONE, source="NCI, case_insensitive_variables.mpf", evidence="secondary",
    program="N10 def real Depth=4\nN20 R1=DEPTH\nN30 depth=5\nN40 R2=Depth\nN50 M30", vars={1: 4, 2: 5},
)
case(
    "conditions and indices of R read variables", **KNOWN,
    program="N10 DEF INT COUNT=0\nN20 WHILE COUNT<3\nN30 COUNT=COUNT+1\nN40 R[COUNT]=COUNT*10\nN50 ENDWHILE\nN60 M30",
    vars={1: 10, 2: 20, 3: 30}, runs="N10 (N20 N30 N40 N50)*3 N20 N60",
)
case(
    "an INT rounds what it is given, and a half goes up", **TYPES,
    program="N10 DEF INT COUNT=2.4\nN20 R1=COUNT\nN30 COUNT=7/2\nN40 R2=COUNT\nN50 R3=3.7\nN60 COUNT=R3\nN70 R4=COUNT\nN80 M30",
    vars={1: 2, 2: 4, 4: 4},
)
case(
    "a BOOL is TRUE where it is given anything but 0", **TYPES,
    program="N10 DEF BOOL FLAG=5, OTHER\nN20 R1=FLAG R2=OTHER\nN30 R3=-2\nN40 FLAG=R3\nN50 R4=FLAG\nN60 FLAG=FALSE\nN70 R5=FLAG\nN80 M30",
    vars={1: 1, 2: 0, 4: 1, 5: 0},
)
case(
    "a CHAR is the code of its character", **RANGE,
    program='N10 DEF CHAR MARK="A"\nN20 R1=MARK\nN30 MARK=66\nN40 R2=MARK\nN50 MARK="C"\nN60 R3=MARK\nN70 M30',
    vars={1: 65, 2: 66, 3: 67},
)
case(
    "a CHAR is not above 255", **RANGE,
    program="N10 DEF CHAR MARK=256\nN20 M30", runs="", alarm="value-out-of-range", at="MAIN N10",
)
case(
    "a variable is known in the program that defines it, and nowhere else", **LOCAL,
    program="%_N_MAIN_MPF\nN10 DEF REAL DEPTH=5\nN20 PART\nN30 M30\n%_N_PART_SPF\nN40 R1=DEPTH\nN50 M17",
    runs="N10 N20", alarm="code-not-computed", at="PART N40", word="R1=DEPTH",
)
case(
    "two programs have two variables of one name", **LOCAL,
    program="%_N_MAIN_MPF\nN10 DEF REAL DEPTH=5\nN20 PART\nN30 R1=DEPTH\nN40 M30\n"
    "%_N_PART_SPF\nN50 DEF REAL DEPTH\nN60 R2=DEPTH\nN70 DEPTH=9\nN80 M17",
    vars={1: 5, 2: 0}, runs="N10 N20 N50 N60 N70 N80 N30 N40",
)
case(
    "each call of a program has variables of its own", **LOCAL,
    program="%_N_MAIN_MPF\nN10 PART\nN20 M30\n%_N_PART_SPF\nN30 DEF INT OWN\nN40 R1=R1+1\nN50 OWN=R1\n"
    "N60 IF R1<3\nN70 PART\nN80 ENDIF\nN90 R[10+OWN]=OWN\nN99 M17",
    vars={11: 1, 12: 2, 13: 3},
)
case(
    "a variable stands in several assignments of a block", **KNOWN,
    program="N10 DEF REAL WIDE=3, HIGH\nN20 R1=WIDE HIGH=2 G0 X=WIDE\nN30 Y=HIGH\nN40 M30", vars={1: 3}, moves="R X3\nR Y2",
)
case(
    "what a variable is in the block that assigns to it is not computed", **POLICY,
    program="N10 DEF REAL WIDE\nN20 WIDE=3 R1=WIDE\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
case(
    "a name begins with two letters", **NAMES,
    program="N10 DEF REAL D1=5\nN20 M30", runs="", alarm="illegal-variable-name", at="MAIN N10", word="D1",
)
case(
    "one letter is too short", **NAMES,
    program="N10 DEF INT I\nN20 M30", runs="", alarm="illegal-variable-name", at="MAIN N10", word="I",
)
case(
    "31 characters are a name", **NAMES,
    program=f"N10 DEF REAL {'A' * 31}=5\nN20 R1={'A' * 31}\nN30 M30", vars={1: 5},
)
case(
    "32 are none", **NAMES,
    program=f"N10 DEF REAL {'A' * 32}=5\nN20 M30", runs="", alarm="illegal-variable-name", at="MAIN N10",
)
case(
    "a name is defined once", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program="N10 DEF REAL DEPTH\nN20 DEF INT DEPTH\nN30 M30",
    runs="N10", alarm="variable-given-twice", number="12170", at="MAIN N20", word="DEPTH",
)
case(
    "a definition has a type", **JOBS,
    program="N10 DEF DEPTH=5\nN20 M30", runs="", alarm="statement-format", at="MAIN N10", word="DEPTH",
)
case(
    "and a block of its own", **JOBS,
    program="N10 DEF REAL DEPTH=5 G0 X1\nN20 M30", runs="", alarm="statement-format", at="MAIN N10", word="G0",
)
case(
    "a variable alone is no block", **KNOWN,
    program="N10 DEF REAL DEPTH\nN20 DEPTH\nN30 M30", runs="N10", alarm="missing-equals", number="12080", at="MAIN N20", word="DEPTH",
)
case(
    "the definition of a text runs", **POLICY,
    program='N10 DEF STRING[20] NOTE="A ; B", OTHER\nN20 G0 X1\nN30 M30', runs="N10 N20 N30",
)
for area in ("NCK", "CHAN"):
    case(
        f"global user data, DEF {area}, stand in files of definitions", **POLICY,
        program=f"N10 DEF {area} REAL DEPTH\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word=area,
    )
    case(
        f"a variable of DEF {area} is that of all programs", control=ONE, source="840Da p.133, defining user data", evidence="secondary",
        files={"MAIN.MPF": "N10 R1=DEPTH\nN20 DEPTH=7\nN30 PART\nN40 R3=DEPTH\nN50 M30\n", "PART.SPF": "N60 R2=DEPTH DEPTH=9\nN70 M17\n",
               "UGUD.DEF": f"DEF {area} REAL DEPTH=2.5 ; of the machine\nM30\n"},
        vars={1: 2.5, 2: 7, 3: 9},
    )
for words in ("CHAN REAL PHU 1", "NCK INT LLI 0 ULI 10", "CHAN INT", "CHAN APRP 7 APWP 3 DCM INT", "NCK REAL SYNRW PHU 42 LLI -5.5"):
    case(
        f"who may use a variable stands before its type or after it: {words}", control=ONE, source="828Dj p.23, DEF", evidence="maker's manual",
        files={"MAIN.MPF": "N10 R1=DEPTH\nN20 M30\n", "UGUD.DEF": f"DEF {words} DEPTH=3\nM17\n"}, vars={1: 3},
    )
for use in ("MYMAC", "R1=MYMAC", "G0 X1 MYMAC"):
    case(
        f"a macro of a file that is no number is not computed: {use}", **POLICY,
        files={"MAIN.MPF": f"N10 G0 X2\nN20 {use}\nN30 M30\n", "UMAC.DEF": "DEFINE MYMAC AS G0 X5\nM17\n"},
        runs="N10", alarm="code-not-computed", at="MAIN N20", word="MYMAC",
    )
case(
    "a name that nothing defines is not computed", **POLICY,
    program="N10 DEPTH=5\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "EXTERN runs, for it says what a PROC says", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program="%_N_MAIN_MPF\nN10 EXTERN PART(REAL, INT)\nN20 PART(2,3)\nN30 M30\n%_N_PART_SPF\nN40 PROC PART(REAL WIDE, INT HIGH)\nN50 R1=WIDE R2=HIGH\nN60 M17",
    vars={1: 2, 2: 3},
)
for word in ("LLI", "ULI"):
    case(
        f"{word}, a limit of a variable, is told as dropped", control=ONE, source="SONE p.409, limit values of variables", evidence="maker's manual",
        program=f"N10 DEF REAL {word} 5.0 DEPTH=2\nN20 R1=DEPTH\nN30 M30", vars={1: 2}, dropped=[f"{word} 5.0"],
    )
for value in ("2147483648", "-2147483649", "1EX10"):
    case(
        f"an INT has 32 bits and does not hold {value}", **RANGE,
        program=f"N10 DEF INT COUNT\nN20 COUNT={value}\nN30 M30", runs="N10", alarm="value-out-of-range", at="MAIN N20",
    )
    case(
        f"nor does one that is computed, {value}", **RANGE,
        program=f"N10 DEF INT COUNT\nN15 R1={value}\nN20 COUNT=R1\nN30 M30", runs="N10 N15", alarm="value-out-of-range", at="MAIN N20",
    )
case(
    "an INT holds what 32 bits hold", **RANGE,
    program="N10 DEF INT COUNT=2147483647, LOW=-2147483648\nN20 R1=COUNT R2=LOW\nN30 M30", vars={1: 2147483647, 2: -2147483648},
)
case(
    "a CHAR that is computed is not above 255", **RANGE,
    program="N10 DEF CHAR MARK\nN20 R1=255\nN30 MARK=R1\nN40 MARK=R1+1\nN50 M30", runs="N10 N20 N30", alarm="value-out-of-range", at="MAIN N40",
)
DATA = {"control": ONE, "source": "840Da p.133, defining user data", "evidence": "secondary"}
case(
    "arrays and texts of all programs have their first values", **DATA,
    files={"MAIN.MPF": 'N10 R1=KEEP[1] R2=KEEP[2] KEEP[0]=5\nN20 MSG(NAME<<KEEP[0]<<OTHER)\nN30 NAME="Z"\nN40 MSG(NAME)\nN50 M30\n',
           "GUD4.DEF": '%_N_GUD4_DEF\n;$PATH=/_N_DEF_DIR\nDEF CHAN SYNR REAL KEEP[3]=SET(1,2,3)\nDEF NCK STRING[8] NAME="AB", OTHER\nM17\n'},
    vars={1: 2, 2: 3}, messages=["AB5", "Z"],
)
case(
    "a variable of the program comes before one of all programs", **POLICY,
    files={"MAIN.MPF": "N10 DEF REAL DEPTH=1\nN20 R1=DEPTH\nN30 DEPTH=4\nN40 PART\nN50 M30\n", "UGUD.DEF": "DEF NCK REAL DEPTH=9\nM30\n", "PART.SPF": "N60 R2=DEPTH\nN70 M17\n"},
    vars={1: 1, 2: 9},
)
case(
    "a name of all programs is defined once", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    files={"UGUD.DEF": "N10 DEF NCK REAL DEPTH=9\nN20 DEF CHAN INT DEPTH\nM30\n"}, main="UGUD",
    runs="N10", alarm="variable-given-twice", number="12170", at="UGUD N20", word="DEPTH",
)
case(
    "DEFINE gives a number a name", **KNOWN,
    files={"MAIN.MPF": "N10 DEF REAL GRID[SIDES]=REP(2)\nN20 R1=SIDES*2 R2=GRID[SIDES-1] R3=LOW\nN30 M30\n",
           "UMAC.DEF": "DEFINE SIDES AS 6 ; of a nut\nDEFINE LOW AS -2.5\nM17\n"},
    vars={1: 12, 2: 2, 3: -2.5},
)
case(
    "which takes no value", **KNOWN,
    program="N10 DEFINE SIDES AS 6\nN20 SIDES=7\nN30 M30", runs="N10", alarm="statement-format", at="MAIN N20", word="SIDES",
)
case(
    "other macros are not computed", **POLICY,
    program="N10 DEFINE MILLING AS M3\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "REDEF is read, and told as dropped", **KNOWN,
    program="N10 DEF INT COUNT=2\nN20 REDEF COUNT INIRE\nN30 R1=COUNT\nN40 M30", vars={1: 2}, dropped=["REDEF COUNT INIRE"],
)
