"""SINUMERIK: texts, their operators and functions, and messages."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
TYPES = {"control": ONE, "source": "840Da p.45, conversions of types", "evidence": "secondary"}
JOBS = {"control": ONE, "source": "828Dj p.74, string operations", "evidence": "secondary"}
FORMAT = {"control": ONE, "source": "840Dg p.94, formats of SPRINT", "evidence": "secondary"}
RANGE = {"control": ONE, "source": "840Df p.63, types", "evidence": "secondary"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}


def said(value: str, before: str = "") -> str:
    return f"{before}N20 MSG({value})\nN30 M30"


NOTE = 'N10 DEF STRING[20] NOTE="axis . stationary"\n'
case(
    "a text is kept and given on", control=ONE, source="NCI, def_string.mpf", evidence="secondary",
    program='N10 DEF STRING[8] TAG="A-7", NOTE=""\nN20 NOTE=TAG TAG="B-2"\nN30 MSG(TAG)\nN40 MSG(NOTE)\nN50 M30',
    messages=["B-2", "A-7"],
)
case(
    "a text that was given nothing is empty", **KNOWN,
    program=said('"<"<<NOTE<<">"', "N10 DEF STRING[8] NOTE\n"), messages=["<>"],
)
case(
    "a text is cut at the length of its variable", **KNOWN,
    program='N10 DEF STRING[3] TAG="ABCDE"\nN20 MSG(TAG)\nN30 TAG="X"<<TAG\nN40 MSG(TAG)\nN50 M30', messages=["ABC", "XAB"],
)
case(
    "a STRING has at most 200 characters", **RANGE,
    program="N10 DEF STRING[201] NOTE\nN20 M30", runs="", alarm="value-out-of-range", at="MAIN N10",
)
case(
    "<< joins texts and numbers", **KNOWN,
    program=said('"Index:"<<IDX<<"/value:"<<VALUE', "N10 DEF INT IDX=2\nN15 DEF REAL VALUE=9.654\n"),
    messages=["Index:2/value:9.654"],
)
for number, written in (("5", "5"), ("2.50", "2.5"), ("-0.125", "-0.125"), ("1/4", "0.25"), ("0.1+0.2", "0.3"), ("100000", "100000"), ("12345678901", "12345678901"), ("-0", "0")):
    case(f"{number} is written as {written}", **KNOWN, program=said(f"<<{number}"), messages=[written])
case(
    "a truth is written as 1 or 0, a character as it is, an axis by its letter", **KNOWN,
    program=said('TRUE<<FALSE<<MARK<<WAY', 'N10 DEF CHAR MARK="C"\nN15 DEF AXIS WAY=Y\n'), messages=["10CY"],
)
case(
    "<< is done after calculations and before comparisons", control=ONE, source="SONE p.444, priority of the operations",
    evidence="maker's manual", program='N10 R1=2\nN20 MSG("S"<<R1+1<<R1*2)\nN30 R2="S3"=="S"<<R1+1\nN40 M30',
    messages=["S34"], vars={2: 1},
)
case(
    "texts are alike or not, with their small letters", **KNOWN,
    program='N10 DEF STRING[9] TAG="Part"\nN20 R1=TAG=="Part" R2=TAG=="PART" R3=TAG<>"Part" R4=TAG<>"X"\nN30 M30', vars={1: 1, 2: 0, 3: 0, 4: 1},
)
case(
    "a text that was joined is like one that was written", **KNOWN,
    program='N10 DEF STRING[9] TAG="A", NEXT\nN20 NEXT=TAG<<7\nN30 R1=NEXT=="A7" R2=NEXT<<"B"=="A7B"\nN40 IF NEXT=="A7"\nN50 R3=1\nN60 ENDIF\nN70 M30',
    vars={1: 1, 2: 1, 3: 1},
)
case(
    "STRLEN counts the characters", **JOBS,
    program=NOTE + "N20 R1=STRLEN(NOTE) R2=STRLEN(\"\") R3=STRLEN(\"AB\"<<12)\nN30 M30", vars={1: 17, 2: 0, 3: 4},
)
case(
    "TOUPPER and TOLOWER change the letters", **JOBS,
    program=said('TOUPPER(NOTE)<<TOLOWER("Ab9")', NOTE), messages=["AXIS . STATIONARYab9"],
)
case(
    "INDEX and RINDEX find the first and the last place of a character, counted from 0", **KNOWN,
    program=NOTE + 'N20 R1=INDEX(NOTE,"a") R2=RINDEX(NOTE,"a") R3=INDEX(NOTE,"Z") R4=RINDEX(NOTE,"Z") R5=INDEX(NOTE,46)\nN30 M30',
    vars={1: 0, 2: 14, 3: -1, 4: -1, 5: 5},
)
case(
    "MINDEX finds the first of several characters, MATCH a text", **KNOWN,
    program=NOTE + 'N20 R1=MINDEX(NOTE,"tx.") R2=MATCH(NOTE,"sta") R3=MATCH(NOTE,"run") R4=MINDEX(NOTE,"QZ")\nN30 M30',
    vars={1: 1, 2: 7, 3: -1, 4: -1},
)
case(
    "SUBSTR is the text from a place on, or so many characters of it", **KNOWN,
    program=said('SUBSTR(NOTE,7)<<"|"<<SUBSTR(NOTE,0,4)<<"|"<<SUBSTR(NOTE,15,9)<<"|"<<SUBSTR(NOTE,40)', NOTE),
    messages=["stationary|axis|ry|"],
)
case(
    "NUMBER is the number in a text, and ISNUMBER whether there is one", **KNOWN,
    program='N10 R1=NUMBER("1.5") R2=NUMBER("-2EX2") R3=ISNUMBER("12") R4=ISNUMBER("1A") R5=ISNUMBER("")\nN20 M30',
    vars={1: 1.5, 2: -200, 3: 1, 4: 0, 5: 0},
)
case(
    "a text that is none has no NUMBER", **KNOWN,
    program='N10 R1=NUMBER("1A")\nN20 M30', runs="", alarm="value-out-of-range", at="MAIN N10",
)
case(
    "TEXT[n] is a character", **KNOWN,
    program='N10 DEF STRING[9] TAG="ABC"\nN20 R1=TAG[0] R2=TAG[2] R3=TAG[1]=="B" R4=TAG[7]\nN30 MSG(TAG[1]<<TAG[0])\nN40 M30',
    vars={1: 65, 2: 67, 3: 1, 4: 0}, messages=["BA"],
)
case(
    "a character of a text is replaced", **KNOWN,
    program='N10 DEF STRING[20] STRG="axis . stationary"\nN20 STRG[5]="X"\nN30 MSG(STRG)\nN40 STRG[5]=0\nN50 MSG(STRG)\nN60 M30',
    messages=["axis X stationary", "axis "],
)
case(
    "outside of the text's variable there is none", **KNOWN,
    program='N10 DEF STRING[3] TAG="ABC"\nN20 TAG[3]="X"\nN30 M30', runs="N10", alarm="array-element", number="12400", at="MAIN N20",
)
case(
    "the place may be computed: an idiom of posts that fills blanks of a date", control=ONE, source="NCI, tests of texts: characters by INDEX", evidence="secondary",
    program='N10 DEF STRING[13] DT\nN20 DT=SPRINT("20%2d%2d%2dT%2d%2d",24,5,29,13,31)\nN30 WHILE(INDEX(DT," ")>0)\n'
    'N40 DT[INDEX(DT," ")]="0"\nN50 ENDWHILE\nN60 MSG(DT)\nN70 R1=1\nN80 DT[R1*2]=0\nN90 MSG(DT)\nN95 M30',
    messages=["20240529T1331", "20"],
)
for _place in ("R1", "-R1-1"):
    case(
        f"a computed place of {_place} is outside of the text", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
        program=f'N10 DEF STRING[3] TAG="ABC"\nN20 R1=3\nN30 TAG[{_place}]="X"\nN40 M30', runs="N10 N20",
        alarm="array-element", number="12400", at="MAIN N30",
    )
case(
    "a text is TRUE where it has a character", **TYPES,
    program='N10 DEF BOOL FLAG="A", OTHER=""\nN20 R1=FLAG R2=OTHER\nN30 M30', vars={1: 1, 2: 0},
)
case(
    "a CHAR takes a text of one character", **TYPES,
    program='N10 DEF STRING[3] TAG="Q"\nN20 DEF CHAR MARK\nN30 MARK=TAG\nN40 R1=MARK\nN50 MARK=TAG<<TAG\nN60 M30',
    vars={1: 81}, runs="N10 N20 N30 N40", alarm="value-out-of-range", at="MAIN N50",
)
case(
    "a text takes a truth and a character", **TYPES,
    program='N10 DEF STRING[3] TAG=TRUE\nN20 DEF CHAR MARK="C"\nN30 MSG(TAG)\nN40 TAG=MARK\nN50 MSG(TAG)\nN60 M30', messages=["1", "C"],
)
for wrong in ('TAG=5', 'TAG=R1', 'R1="A"', 'R1=TAG+1', 'G0 X=TAG', 'R1=-TAG', 'R1=SIN(TAG)', 'R1=STRLEN(5)', 'R1=1==TAG', 'R1=GRID[TAG]'):
    case(
        f"a text is no number: {wrong}", **TYPES,
        program=f'N10 DEF STRING[3] TAG="A"\nN15 DEF REAL GRID[3]\nN20 {wrong}\nN30 M30',
        runs="N10 N15", alarm="type-mismatch", number="12150", at="MAIN N20",
    )
case(
    "arrays hold texts", **KNOWN,
    program='N10 DEF STRING[8] TAGS[3]=SET("A","B"<<2)\nN20 MSG(TAGS[0]<<TAGS[1]<<TAGS[2])\nN30 TAGS[2]=TAGS[1]\nN40 MSG(TAGS[2])\nN50 M30',
    messages=["AB2", "B2"],
)
case(
    "a program takes a text, and gives one back", **KNOWN,
    program='%_N_MAIN_MPF\nN10 DEF STRING[9] TAG="A"\nN20 PART("X"<<1,TAG)\nN30 MSG(TAG)\nN40 M30\n'
    '%_N_PART_SPF\nN50 PROC PART(STRING[9] FIRST, VAR STRING[9] LAST)\nN60 MSG(FIRST<<LAST)\nN70 LAST=FIRST<<"Z"\nN80 M17',
    messages=["X1A", "X1Z"],
)
case(
    "a message has several parts", **KNOWN,
    program='N10 R1=3 R2=0.5\nN20 MSG("LAYER "<<R1<<" OF "<<R1*2<<", "<<R2)\nN30 MSG()\nN40 M30', messages=["LAYER 3 OF 6, 0.5", ""],
)
case(
    "a message may say when it shows", **KNOWN, program='N10 MSG("WAIT",1)\nN20 M30', messages=["WAIT"],
)
for form, value, written in (
    ("%D", "R1", "13"), ("%5D", "R1", "   13"), ("%.2F", "R2", "2.35"), ("%7.1F", "R2", "    2.3"), ("%F", "R2", "2.345000"),
    ("%S", '"AB"', "AB"), ("%.3S", '"ABCDEFG"', "ABC"), ("%10.5S", '"ABCDEFG"', "     ABCDE"), ("%X", "'HA5B8'", "A5B8"),
    ("%B", "R1>5", "TRUE"), ("%C", "65", "A"), ("100%%", "", "100%"),
):
    case(
        f"SPRINT writes {value or form} by {form} as {written!r}", **FORMAT,
        program=f'N10 R1=13 R2=2.345\nN20 MSG(SPRINT("<{form}>"{"," + value if value else ""}))\nN30 M30', messages=[f"<{written}>"],
    )
case(
    "SPRINT has a value for each format", **FORMAT,
    program='N10 MSG(SPRINT("%D %D",1))\nN20 M30', runs="", alarm="missing-comma", number="12080", at="MAIN N10",
)
case(
    "of two texts nobody says which is the smaller", **POLICY,
    program='N10 R1="A"<"B"\nN20 M30', runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "AXSTRING names an axis", **JOBS,
    program=said("AXSTRING(WAY)<<AXSTRING(Z)", "N10 DEF AXIS WAY=X\n"), messages=["XZ"],
)
case(
    "an AXIS takes axes and nothing else", **TYPES,
    program="N10 DEF AXIS WAY=X, NONE=NO_AXIS\nN15 WAY=Y\nN20 R1=WAY==Y R2=WAY==X R3=NONE==NO_AXIS\nN30 WAY=5\nN40 M30",
    vars={1: 1, 2: 0, 3: 1}, runs="N10 N15 N20", alarm="type-mismatch", number="12150", at="MAIN N30",
)
case(
    "a joined text of more than 1,000 characters is not computed", **POLICY,
    program='N10 DEF STRING[200] TAG="' + "A" * 200 + '"\nN20 R1=STRLEN(TAG<<TAG<<TAG<<TAG<<TAG)\nN30 R2=STRLEN(TAG<<TAG<<TAG<<TAG<<TAG<<1)\nN40 M30',
    vars={1: 1000}, runs="N10 N20", alarm="code-not-computed", at="MAIN N30",
)
case(
    "AXNAME is the axis of a name", **KNOWN,
    program='N10 DEF AXIS WAY=AXNAME("Y"), NEXT\nN20 NEXT=AXNAME("z")\nN30 MSG(WAY<<NEXT)\nN40 R1=AXNAME("Q9")==NO_AXIS\nN50 M30',
    messages=["YZ"], vars={1: 1},
)
case(
    "a tool may have the name in a variable, and the word is told as dropped", **KNOWN,
    program='N10 DEF STRING[20] TOOL="MILL"\nN20 T=TOOL\nN30 M6\nN40 M30', runs="N10 N20 N30 N40", dropped=["T=TOOL"],
)
case(
    "characters are counted, and not their bytes", **KNOWN,
    program='N10 DEF STRING[4] NOTE="häß"\nN20 R1=STRLEN(NOTE) R2=INDEX(NOTE,"ß") R3=NOTE[1] R4=MINDEX(NOTE,"xßä") R5=MATCH(NOTE,"ß")\n'
    'N30 MSG(SUBSTR(NOTE,1,1)<<NOTE[2])\nN40 NOTE="äöüßä"\nN50 MSG(NOTE)\nN60 NOTE[1]="O"\nN70 MSG(NOTE)\nN80 R6=INDEX(NOTE,196)\nN90 M30',
    vars={1: 3, 2: 2, 3: 228, 4: 1, 5: 2, 6: -1}, messages=["äß", "äöüß", "äOüß"],
)
case(
    "a CHAR may be one of the upper half", **RANGE,
    program='N10 DEF CHAR MARK="ß"\nN20 R1=MARK\nN30 MSG(MARK<<MARK)\nN40 M30', vars={1: 223}, messages=["ßß"],
)
