"""SINUMERIK: programs, how they are called and how they end."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
MANUAL = {"control": ONE, "source": "SONE p.45, the words that end a program", "evidence": "maker's manual"}

case(
    "a name alone calls its program, M17 returns", **MANUAL,
    program="%_N_MAIN_MPF\nN10 SUB_A\nN20 M30\n%_N_SUB_A_SPF\nN30 G0 X1\nN40 M17",
    runs="N10 N30 N40 N20", calls="call:SUB_A",
)
case(
    "small letters are capitals", control=ONE, source="SONE p.42, program names", evidence="maker's manual",
    program="%_n_main_mpf\nn10 sub_a\nn20 m30\n%_n_sub_a_spf\nn30 g0 x1\nn40 ret",
    runs="N10 N30 N40 N20",
)
case(
    "a program answers to its name with and without what the control puts around it",
    control=ONE, source="828D p.490, example", evidence="secondary",
    program="%_N_MAIN_MPF\nN10 SUB_PROG\nN20 _N_SUB_PROG\nN30 SUB_PROG_SPF\nN40 _N_SUB_PROG_SPF\nN50 M30\n"
    "%_N_SUB_PROG_SPF\nN60 M17",
    runs="N10 N60 N20 N60 N30 N60 N40 N60 N50",
)
case(
    "a head of punched tape may leave the prefix out", control=ONE, source="SONE p.43, %Flange3_MPF",
    evidence="maker's manual",
    program="%Flange3_MPF\nN10 HOLE\nN20 M30\n%HOLE_SPF\nN30 M17", runs="Flange3:N10 HOLE:N30 Flange3:N20",
)
case(
    "a file without a head is the program of its name", control=ONE, source="SONE p.43, names of programs",
    evidence="maker's manual",
    files={"MAIN.MPF": "N10 L100\nN20 M30\n", "L100.SPF": "N30 M17\n"},
    main="MAIN", runs="N10 N30 N20",
)
case(
    "a comment before the first block belongs to no program", control=ONE, source="SONE p.43, names of programs",
    evidence="maker's manual",
    files={"MAIN.MPF": "; first\n;$PATH=/_N_MPF_DIR\nN10 L100\nN20 M30\n", "L100.SPF": "; second\nN30 M17\n"},
    main="MAIN", runs="N10 N30 N20",
)
case(
    "P is how often", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 P3\nN20 M30\n%_N_L100_SPF\nN30 G0 X1\nN40 M17",
    runs="N10 (N30 N40)*3 N20",
)
case(
    "P is computed too", **KNOWN,
    program="%_N_MAIN_MPF\nN5 R1=2\nN10 L100 P=R1\nN20 M30\n%_N_L100_SPF\nN40 M17", runs="N5 N10 N40*2 N20",
)
case(
    "P is at most 9999", pins="max_repeats too_many_repeats", number="14013", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 P10000\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="repeat-count-digits", at="MAIN N10", word="P10000",
)
case(
    "P0 is no count", pins="zero_repeats", number="14013", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 P0\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="illegal-repeat-count", at="MAIN N10", word="P0",
)
case(
    "L1 and L01 are two programs", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L01\nN20 M30\n%_N_L1_SPF\nN40 M17",
    runs="", alarm="named-program-not-found", number="14011", at="MAIN N10", word="L01",
)
case(
    "a call has a block of its own", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G0 X5 L100\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="illegal-word-with-call", at="MAIN N10", word="L100",
)
case(
    "a block has one call", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 PART\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="call-given-twice", at="MAIN N10", word="PART",
)
case(
    "L without a number calls nothing", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L\nN20 M30", runs="", alarm="address-without-value", number="12080", at="MAIN N10", word="L",
)
case(
    "fifteen programs are called below the main one, the next is 14012", pins="max_nesting max_total_nesting self_call",
    control=ONE, source="828D p.490, 16 program levels; CW-S, 14012", evidence="secondary",
    program="%_N_MAIN_MPF\nN10 REC\nN20 M30\n%_N_REC_SPF\nN30 G0 X1\nN40 REC\nN50 M17",
    runs="N10 (N30 N40)*14 N30", alarm="nesting-too-deep", number="14012", at="REC N40",
)
case(
    "M17 in the main program ends it", pins="main_return roles:M17=return", **MANUAL,
    program="%_N_MAIN_MPF\nN10 G0 X1\nN20 M17\nN30 G0 X2", runs="N10 N20",
)
case(
    "words beside M17 are executed before it returns", pins="power_on:G20", **KNOWN,
    program="%_N_MAIN_MPF\nN10 PART\nN20 M30\n%_N_PART_SPF\nN30 G0 X4 M17", moves_x=[4],
)
case(
    "M2 ends the program after the words of its block", pins="power_on:G91", **MANUAL,
    program="%_N_MAIN_MPF\nN10 G0 X1\nN20 X2 M2\nN30 X3", moves_x=[1, 2],
)
case(
    "M30 ends it too", pins="roles:M30=end", **MANUAL, program="%_N_MAIN_MPF\nN10 G0 X1\nN20 M30\nN30 X3", runs="N10 N20",
)
for words in ("P-1", "P=-1", "P=R1-3"):
    case(
        f"{words} is no count either", number="14013", **KNOWN,
        program=f"%_N_MAIN_MPF\nN10 L100 {words}\nN20 M30\n%_N_L100_SPF\nN40 M17",
        runs="", alarm="illegal-repeat-count", at="MAIN N10", word=words,
    )
case(
    "a program that ends in nothing alarms", pins="missing_end", number="14000", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G0 X1", runs="N10", alarm="end-of-record", at="MAIN",
)
case(
    "R parameters are the same in all programs", **KNOWN,
    program="%_N_MAIN_MPF\nN10 R1=5\nN20 PART\nN30 M30\n%_N_PART_SPF\nN40 R1=R1+1\nN50 RET", vars={1: 6},
)
ENDS = {"control": ONE, "source": "MD840, MD 20800: M17 and M2, M30 are the M functions of a subprogram's end", "evidence": "secondary"}
for code in ("M30", "M2", "M02"):
    case(
        f"{code} in a subprogram returns, as M17 does", pins="end_in_subprogram", **ENDS,
        program=f"%_N_MAIN_MPF\nN10 PART\nN20 M30\n%_N_PART_SPF\nN30 G0 X1\nN40 {code}", runs="N10 N30 N40 N20",
    )
case(
    "M30 in a subprogram lets its passes go on", **ENDS,
    program="%_N_MAIN_MPF\nN10 PART P2\nN20 M30\n%_N_PART_MPF\nN30 R1=R1+1\nN40 M30", runs="N10 (N30 N40)*2 N20",
)
case(
    "a program may call the one that called it", pins="caller_call", **KNOWN,
    program="%_N_MAIN_MPF\nN10 ONE\nN20 M30\n%_N_ONE_SPF\nN30 R1=R1+1\nN40 IF R1>1 GOTOF OUT\nN50 TWO\nN60 OUT: M17\n%_N_TWO_SPF\nN70 ONE\nN80 M17",
    runs="N10 N30 N40 N50 N70 N30 N40 N60 N80 N60 N20",
)

# ---- which program runs, and which is called ----

NAMES = {"control": ONE, "source": "SONE p.43, _MPF of main programs, _SPF of subprograms", "evidence": "maker's manual"}
case(
    "of files the main program is the one that ends in MPF", **NAMES,
    files={"AA1.SPF": "N30 M17\n", "BB1.MPF": "N10 AA1\nN20 M30\n"}, runs="N10 N30 N20",
)
case(
    "of programs in one text it is the one that is named so", **NAMES,
    program="%_N_AA1_SPF\nN30 M17\n%_N_BB1_MPF\nN10 AA1\nN20 M30", runs="N10 N30 N20",
)
case(
    "without one it is the first", **NAMES, files={"AA1.SPF": "N10 BB1\nN20 M17\n", "BB1.SPF": "N30 M17\n"}, runs="N10 N30 N20",
)
for name in ("L1", "L01", "L001"):
    case(
        f"{name} is a program of its own", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
        program=f"%_N_MAIN_MPF\nN10 {name}\nN20 M30\n%_N_L1_SPF\nR1=1\nM17\n%_N_L01_SPF\nR1=2\nM17\n%_N_L001_SPF\nR1=3\nM17",
        vars={1: len(name) - 1},
    )
case(
    "what follows the name of a head is told, and not obeyed", control=ONE, source="policy, nobody says", evidence="inferred",
    program="%_N_MAIN_MPF N5 G0 X9\nN10 G0 X1\nN20 M30", moves_x=[1], dropped=["N5 G0 X9"],
)
case(
    "a comment may follow it", control=ONE, source="policy, nobody says", evidence="inferred",
    program="%_N_MAIN_MPF ; X9\nN10 G0 X1\nN20 M30", runs="N10 N20", dropped=[],
)

# ---- calls that begin with a word ----

for words in (
    'CALL "PART"', 'CALL "/_N_SPF_DIR/_N_PART_SPF"', 'EXTCALL("PART")', 'EXTCALL "PART.SPF"', 'EXTCALL("C:/PROGS/PART.SPF")',
    "PCALL PART", "PCALL /_N_WKS_DIR/_N_SHAFT_WPD/PART", "PCALL /_N_SPF_DIR/PART()",
):
    case(
        f"{words} calls a program", control=ONE, source="828Dj p.198, EXTCALL; general knowledge", evidence="inferred",
        program=f"%_N_MAIN_MPF\nN10 {words}\nN20 M30\n%_N_PART_SPF\nN30 M17", runs="N10 N30 N20", calls="call:PART",
    )
case(
    "PCALL hands values over", **KNOWN,
    program="%_N_MAIN_MPF\nN10 PCALL /_N_SPF_DIR/PART(4,R2)\nN20 M30\n%_N_PART_SPF\nN30 PROC PART(REAL WIDE, VAR REAL HIGH)\nN40 HIGH=WIDE+1\nN50 M17",
    vars={2: 5},
)
for words in ('CALL "NONE"', 'EXTCALL("NONE.SPF")', "PCALL NONE(1)"):
    case(
        f"{words} alarms where there is no such program", number="14011", control=ONE, source="828Dj p.198, the program is cancelled",
        evidence="secondary",
        program=f"N10 {words}\nN20 M30", runs="", alarm="named-program-not-found", at="MAIN N10",
    )
for words in ('EXTCALL("PART"', "PCALL PART(1"):
    case(
        f"{words} lacks its bracket", **KNOWN, program=f"N10 {words}\nN20 M30", runs="", alarm="bracket-not-closed", number="12080", at="MAIN N10",
    )
for words in ('CALL ""', "PCALL /_N_SPF_DIR/"):
    case(
        f"{words} names no program", **KNOWN, program=f"N10 {words}\nN20 M30", runs="", alarm="illegal-program-name", at="MAIN N10",
    )
TYPES = {"control": ONE, "source": "general knowledge of the SINUMERIK alarms", "evidence": "inferred"}
for words, word in (("CALL 5", "5"), ("CALL R1", "R1"), ("EXTCALL(5)", "5"), ("EXTCALL(R1+1)", "R1+1"), ("CALL TRUE", "TRUE")):
    case(
        f"{words} calls nothing: a program is named by a text", number="12150", **TYPES,
        program=f"N10 {words}\nN20 M30", runs="", alarm="type-mismatch", at="MAIN N10", word=word,
    )
for words in ("CALL", "EXTCALL", "EXTCALL()"):
    case(
        f"{words} without a name is a fault of its text", number="12080", **TYPES, program=f"N10 {words}\nN20 M30", runs="", alarm="expression-format", at="MAIN N10",
    )
for words in ("PCALL", 'EXTCALL("")', 'EXTCALL("/NC_DIR/")', 'CALL "" BLOCK AA1 TO AA2'):
    case(
        f"{words} names no program either", **KNOWN, program=f"N10 {words}\nN20 M30", runs="", alarm="illegal-program-name", at="MAIN N10",
    )
case(
    "CALL NAME is not computed", control=ONE, source="policy, nobody says", evidence="inferred",
    program="N10 CALL NAME\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "nothing follows CALL", **KNOWN, program='N10 CALL "PART" X5\nN20 M30', runs="", alarm="statement-format", at="MAIN N10", word="X5",
)

# ---- SETAL ----

SETAL = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
case(
    "SETAL raises an alarm of the user", number="65000", **SETAL,
    program="N10 G0 X1\nN20 SETAL(65000)\nN30 X2\nN40 M30", runs="N10 N20", alarm="user-alarm", at="MAIN N20",
)
case(
    "with a text of its own and a number that is computed", number="65012", **SETAL,
    program='N10 R1=12\nN20 SETAL(65000+R1, "door open")\nN30 M30', runs="N10 N20", alarm="user-alarm", at="MAIN N20",
)
case(
    "its text may be computed", number="65012", **SETAL,
    program='N10 R1=12\nN20 SETAL(65000+R1, "door "<<R1)\nN30 M30', runs="N10 N20", alarm="user-alarm", at="MAIN N20",
)
for number in (60000, 62100, 69999):
    case(
        f"SETAL({number}) is an alarm of cycles", number=str(number), control=ONE,
        source="Autodesk's post writes SETAL(62990), a public cycle SETAL(62100)", evidence="secondary",
        program=f"N10 SETAL({number})\nN20 M30", runs="N10", alarm="user-alarm", at="MAIN N10",
    )
for number in (59999, 70000):
    case(
        f"SETAL({number}) is no alarm of the user", **SETAL,
        program=f"N10 SETAL({number})\nN20 M30", runs="", alarm="illegal-user-alarm", at="MAIN N10", word="SETAL",
    )
case("SETAL needs brackets", **SETAL, program="N10 SETAL 65000\nN20 M30", runs="", alarm="bracket-not-opened", number="12080", at="MAIN N10")
case("that close", **SETAL, program="N10 SETAL(65000\nN20 M30", runs="", alarm="bracket-not-closed", number="12080", at="MAIN N10")

# ---- skip levels ----

LEVELS = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D: / and /0 are the first of ten skip levels", "evidence": "inferred"}
for level in ("", *"0123456789"):
    first = 1 if level == "" else int(level) + 1
    for skip in (first, first % 10 + 1):
        case(
            f"/{level} is skip level {first}: switch {skip} on", **LEVELS,
            program=f"/{level} N10 G0\nN20 M30", skip=[skip], runs="N20" if skip == first else "N10 N20",
        )

# ---- RET with values ----

RET = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}


def _two_levels(back):
    return (
        "%_N_MAIN_MPF\nN10 ONE1\nN20 R1=R1+1\nN30 LAB: R2=R2+1\nN40 R3=R3+1\nN50 M30\n"
        f"%_N_ONE1_SPF\nN60 TWO2\nN65 LAB: R4=1\nN70 M17\n%_N_TWO2_SPF\nN80 {back}"
    )


for back, runs in (
    ("RET()", "N10 N60 N80 N65 N70 N20 N30 N40 N50"),
    ('RET("LAB")', "N10 N60 N80 N65 N70 N20 N30 N40 N50"),
    ('RET("N70")', "N10 N60 N80 N70 N20 N30 N40 N50"),
    ('RET("lab", 1)', "N10 N60 N80 N70 N20 N30 N40 N50"),
    ("RET(,,2)", "N10 N60 N80 N20 N30 N40 N50"),
    ('RET("LAB",,2)', "N10 N60 N80 N30 N40 N50"),
    ('RET("LAB",1,2)', "N10 N60 N80 N40 N50"),
    ('RET("N40",0,1+1)', "N10 N60 N80 N40 N50"),
    ("RET(,,9)", "N10 N60 N80 N20 N30 N40 N50"),
):
    case(f"{back} returns to its block, over its levels", **RET, program=_two_levels(back), runs=runs)
case(
    "the block is searched for after the call, then from the beginning", **RET,
    program="%_N_MAIN_MPF\nN10 R1=R1+1\nN20 IF R1>1 GOTOF N50\nN30 PART\nN50 M30\n%_N_PART_SPF\nN60 RET(\"N10\")",
    runs="N10 N20 N30 N60 N10 N20 N50",
)
case(
    "RET with a block leaves the passes that are left", **RET,
    program="%_N_MAIN_MPF\nN10 PART P3\nN20 M30\nN30 LAB: M30\n%_N_PART_SPF\nN60 RET(\"LAB\")", runs="N10 N60 N30",
)
case(
    "RET with values ends the main program too", **RET, program='N10 RET("N30")\nN20 G0\nN30 M30', runs="N10",
)
case(
    "RET to a block that is not there", number="14080", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program=_two_levels('RET("NONE")'), runs="N10 N60", alarm="return-target-not-found", at="TWO2 N80", word='"NONE"',
)
case(
    "its fourth value is told and has no effect", **RET,
    program=_two_levels("RET(,,1,1)"), runs="N10 N60 N80 N65 N70 N20 N30 N40 N50", dropped=["1"],
)
case("the values of RET stand in brackets that close", **RET, program="N10 RET(,,1\nN20 M30", runs="", alarm="bracket-not-closed", number="12080", at="MAIN N10")
case("nothing follows them", **RET, program="N10 RET() X5\nN20 M30", runs="", alarm="statement-format", at="MAIN N10", word="X5")
for words, word in (("RET(R1)", "R1"), ("RET(10)", "10")):
    case(
        f"{words} names no block: a text does", number="12150", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
        program=f"N10 {words}\nN20 M30", runs="", alarm="type-mismatch", at="MAIN N10", word=word,
    )
for back in ('RET("N"<<R7)', 'RET("N7"<<"0")', 'RET(WAY,,R8)'):
    case(
        f"the text of {back} is computed", **RET,
        program=_two_levels("DEF STRING[9] WAY\nN85 R7=70 R8=1 WAY=\"n70\"\nN90 " + back), runs="N10 N60 N80 N85 N90 N70 N20 N30 N40 N50",
    )
case(
    "and names a block that is not there", number="14080", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program=_two_levels('R1=9\nN90 RET("LAB"<<R1)'), runs="N10 N60 N80", alarm="return-target-not-found", at="TWO2 N90", word='"LAB"<<R1',
)

# ---- an MPF and an SPF of one name ----

TWO = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D: MPF and SPF are two kinds of one name", "evidence": "inferred"}
case(
    "a call means the SPF where an MPF has the same name", **TWO,
    files={"MAIN.MPF": "N10 PART\nN20 M30\n", "PART.MPF": "N30 R1=1\nN40 M30\n", "PART.SPF": "N50 R1=2\nN60 M17\n"}, main="MAIN",
    vars={1: 2}, runs="N10 N50 N60 N20",
)
case(
    "the main program is the MPF", **TWO,
    files={"PART.MPF": "N30 R1=1\nN40 PART\nN45 M30\n", "PART.SPF": "N50 R1=R1+1\nN60 M17\n"}, vars={1: 2}, runs="N30 N40 N50 N60 N45",
)
case(
    "and so in one text with two heads", **TWO,
    program="%_N_PART_MPF\nN30 R1=1\nN40 PART\nN45 M30\n%_N_PART_SPF\nN50 R1=R1+1\nN60 M17", vars={1: 2}, runs="N30 N40 N50 N60 N45",
)
case(
    "an MPF alone is called too", **TWO,
    files={"MAIN.MPF": "N10 PART\nN20 M30\n", "PART.MPF": "N30 R1=1\nN40 M17\n"}, main="MAIN", runs="N10 N30 N40 N20",
)

case(
    "a program whose PROC is refused is entered, and alarms there", control="siemens-one", source="policy, the fault that is to be mended is told", evidence="inferred",
    program="N10 SUB1(5,6)\nN20 M30\n%_N_SUB1_SPF\nN30 PROC SUB1(REAL A1,REAL B1)\nN40 M17",
    runs="N10", alarm="illegal-variable-name", at="SUB1 N30",
)

# ---- assignments and messages beside a return ----

for back in ("M17", "RET"):
    case(
        f"an assignment beside {back} is made before the return", **RET,
        program=f"%_N_MAIN_MPF\nN10 PART\nN20 M30\n%_N_PART_SPF\nN30 R1=7 {back}\nN40 R1=8", runs="N10 N30 N20", vars={1: 7},
    )
    case(
        f"words, an assignment and a message stand beside {back}", **RET,
        program=f'%_N_MAIN_MPF\nN10 PART P2\nN20 M30\n%_N_PART_SPF\nN30 G0 X=IC(5) R1=R1+1 MSG("OUT") {back}\nN40 R1=8',
        runs="N10 N30 N30 N20", vars={1: 2}, moves="R X5\nR X10",
    )
    case(
        f"a fault of an assignment beside {back} leaves the program open", **RET,
        program=f"%_N_MAIN_MPF\nN10 PART\nN20 M30\n%_N_PART_SPF\nN30 R1=1/R2 {back}\nN40 R1=8", runs="N10",
        alarm="division-by-zero", number="14051", at="PART N30",
    )
case(
    "blanks around the name of a called program are no part of it", **KNOWN,
    program='%_N_MAIN_MPF\nN10 CALL " PART "\nN20 CALL " PA"<<"RT "\nN30 M30\n%_N_PART_SPF\nN40 M17', runs="N10 N40 N20 N40 N30",
)
