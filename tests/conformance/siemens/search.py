"""SINUMERIK: the folders in which a call looks for a program."""

from conformance import case

ONE = "siemens-one"
PATH = {"control": ONE, "source": "SONE p.559-560: search path for subprogram call", "evidence": "maker's manual"}
PATHS = {"control": ONE, "source": "840Da p.125: workpiece directories", "evidence": "secondary"}
TEXT = {"control": ONE, "source": "NCX chapter 1: ;$PATH=", "evidence": "secondary"}
UNSURE = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}
MAIN = "N10 PART\nN20 M30\n"


def sub(number):
    return f"N{number} R1={number}\nN{number + 1} M17\n"


OWN, SPF, CUS, CMA, CST = (
    f"NC/{folder}/PART.SPF" for folder in ("WKS.DIR/SHAFT.WPD", "SPF.DIR", "CUS.DIR", "CMA.DIR", "CST.DIR")
)
SHAFT = "NC/WKS.DIR/SHAFT.WPD/MAIN.MPF"
for first, others, name in [
    (OWN, [SPF, CUS, CMA, CST], "the folder of the main program is searched first"),
    (SPF, [CUS, CMA, CST], "then that of the subprograms"),
    (CUS, [CMA, CST], "then that of the user's cycles"),
    (CMA, [CST], "then that of the maker's cycles"),
    (CST, [], "then that of the standard cycles"),
]:
    case(
        name, **PATH, pins="search_path",
        files={**{other: sub(900) for other in reversed(others)}, first: sub(100), SHAFT: MAIN},
        main="MAIN", runs="N10 N100 N101 N20", vars={1: 100},
    )
case(
    "the main program may lie in the folder of main programs", **PATH,
    files={"MPF.DIR/MAIN.MPF": MAIN, "MPF.DIR/PART.SPF": sub(100), "SPF.DIR/PART.SPF": sub(900)},
    runs="N10 N100 N101 N20",
)
case(
    "a main program of the own folder is found after a subprogram of it", **PATH,
    files={"MPF.DIR/MAIN.MPF": MAIN, "MPF.DIR/PART.MPF": sub(900), "MPF.DIR/PART.SPF": sub(100)},
    runs="N10 N100 N101 N20",
)
case(
    "a main program of the own folder is found before subprograms elsewhere", **PATH,
    files={"MPF.DIR/MAIN.MPF": MAIN, "MPF.DIR/PART.MPF": sub(100), "SPF.DIR/PART.SPF": sub(900)},
    main="MAIN", runs="N10 N100 N101 N20",
)
case(
    "a main program of the folder of subprograms is not found", **PATH,
    files={"MPF.DIR/MAIN.MPF": MAIN, "SPF.DIR/PART.MPF": sub(100)},
    main="MAIN", runs="", alarm="named-program-not-found", number="14011", at="MAIN N10",
)
case(
    "the folder of the main program is searched, and not that of the program that calls", **PATH,
    files={
        "A.WPD/MAIN.MPF": "N10 STEP\nN20 M30", "SPF.DIR/STEP.SPF": "N30 PART\nN40 M17",
        "SPF.DIR/PART.SPF": sub(900), "A.WPD/PART.SPF": sub(100),
    },
    main="MAIN", runs="N10 N30 N100 N101 N40 N20",
)
case(
    "another workpiece is not searched", **PATHS,
    files={"A.WPD/MAIN.MPF": MAIN, "B.WPD/PART.SPF": sub(100)},
    main="MAIN", runs="", alarm="named-program-not-found", number="14011", at="MAIN N10",
)
case(
    "a folder in a searched folder is not searched", **PATH,
    files={"A.WPD/MAIN.MPF": MAIN, "CUS.DIR/MORE/PART.SPF": sub(100)},
    main="MAIN", runs="", alarm="named-program-not-found", number="14011", at="MAIN N10",
)
case(
    "each workpiece has subprograms of its own", **PATHS,
    files={
        "A.WPD/MAIN.MPF": MAIN, "A.WPD/PART.SPF": sub(900), "B.WPD/OTHER.MPF": MAIN, "B.WPD/PART.SPF": sub(100),
    },
    main="OTHER", runs="N10 N100 N101 N20",
)
case(
    "CALLPATH adds a folder after that of the subprograms, before the cycles", **PATH,
    files={
        "A.WPD/MAIN.MPF": 'N10 CALLPATH("/_N_WKS_DIR/_N_B_WPD")\nN20 PART\nN30 ONLY\nN40 M30',
        "CUS.DIR/PART.SPF": sub(900), "WKS.DIR/B.WPD/PART.SPF": sub(100),
        "SPF.DIR/ONLY.SPF": sub(200), "WKS.DIR/B.WPD/ONLY.SPF": sub(800),
    },
    main="MAIN", runs="N10 N20 N100 N101 N30 N200 N201 N40",
)
case(
    "CALLPATH without a folder takes it away", **PATH,
    files={
        "A.WPD/MAIN.MPF": 'N10 CALLPATH("/_N_WKS_DIR/_N_B_WPD")\nN20 PART\nN30 CALLPATH()\nN40 PART\nN50 M30',
        "CUS.DIR/PART.SPF": sub(200), "WKS.DIR/B.WPD/PART.SPF": sub(100),
    },
    main="MAIN", runs="N10 N20 N100 N101 N30 N40 N200 N201 N50",
)
case(
    "CALLPATH takes a text that is computed", **PATH,
    files={
        "A.WPD/MAIN.MPF": 'N5 DEF STRING[20] WPD="_N_B"\nN10 CALLPATH("/_N_WKS_DIR/"<<WPD<<"_WPD")\nN20 PART\nN40 M30',
        "WKS.DIR/B.WPD/PART.SPF": sub(100),
    },
    main="MAIN", runs="N5 N10 N20 N100 N101 N40",
)
for block, cause, number in [
    ("CALLPATH(5)", "type-mismatch", "12150"),
    ('CALLPATH "/_N_CUS_DIR"', "bracket-not-opened", "12080"),
    ('CALLPATH("/_N_CUS_DIR"', "bracket-not-closed", "12080"),
]:
    case(
        f"{block} names no folder", control=ONE, source="general knowledge of the SINUMERIK 840D",
        evidence="inferred", program=f"N10 G0 X1\nN20 {block}\nN30 M30", runs="N10", alarm=cause, number=number,
        at="MAIN N20",
    )
for block in ["PCALL /_N_CUS_DIR/_N_PART_SPF", 'CALL "/_N_CUS_DIR/_N_PART_SPF"', 'CALL "/_N_CUS"<<"_DIR/PART"']:
    case(
        f"{block} means the program of that folder", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
        files={"A.WPD/MAIN.MPF": f"N10 {block}\nN20 M30", "A.WPD/PART.SPF": sub(900), "CUS.DIR/PART.SPF": sub(100)},
        main="MAIN", runs="N10 N100 N101 N20",
    )
case(
    "a call with a folder means no program of another one", control=ONE, source="general knowledge of the SINUMERIK 840D",
    evidence="inferred", files={"A.WPD/MAIN.MPF": "N10 PCALL /_N_CMA_DIR/PART\nN20 M30", "CUS.DIR/PART.SPF": sub(100)},
    main="MAIN", runs="", alarm="named-program-not-found", number="14011", at="MAIN N10",
)
case(
    "the values of a call go to the program that is found", **PATH,
    files={
        "A.WPD/MAIN.MPF": "N10 PART(1,2)\nN20 M30",
        "CST.DIR/PART.SPF": "N900 PROC PART(REAL AA)\nN901 M17", "CUS.DIR/PART.SPF": "N100 PROC PART(REAL AA,REAL BB)\nN101 R1=BB\nN102 M17",
    },
    main="MAIN", runs="N10 N100 N101 N102 N20", vars={1: 2},
)
case(
    "a program that is found may not take the values", **PATH,
    files={
        "A.WPD/MAIN.MPF": "N10 PART(1,2)\nN20 M30",
        "CUS.DIR/PART.SPF": "N900 PROC PART(REAL AA)\nN901 M17", "CST.DIR/PART.SPF": "N100 PROC PART(REAL AA,REAL BB)\nN102 M17",
    },
    main="MAIN", runs="", alarm="too-many-arguments", number="14020", at="MAIN N10",
)
case(
    "MCALL searches as a call does", **PATH,
    files={
        "A.WPD/MAIN.MPF": "N10 MCALL PART(7)\nN20 G0 X1\nN30 MCALL\nN40 M30",
        "CST.DIR/PART.SPF": sub(900), "CUS.DIR/PART.SPF": "N100 PROC PART(REAL AA)\nN101 R1=AA\nN102 M17",
    },
    main="MAIN", runs="N10 N20 N100 N101 N102 N30 N40", vars={1: 7},
)
ARCHIVE = """\
%_N_MAIN_MPF
;$PATH=/_N_WKS_DIR/_N_SHAFT_WPD
N10 PART
N20 M30
%_N_PART_SPF
;$PATH=/_N_CST_DIR
N900 M17
%_N_PART_SPF
;$PATH=/_N_CUS_DIR
N100 M17
"""
case(
    "the programs of an archive lie where their $PATH says", **TEXT,
    program=ARCHIVE, runs="N10 N100 N20",
)
case(
    "$PATH of a workpiece that is not the main program's is not searched", **TEXT,
    program=ARCHIVE.replace("_N_CUS_DIR", "_N_WKS_DIR/_N_OTHER_WPD"), runs="N10 N900 N20",
)
case(
    "a program whose folder nothing tells is found after the own folder", **UNSURE,
    files={"A.WPD/MAIN.MPF": MAIN, "PART.SPF": sub(100), "CUS.DIR/PART.SPF": sub(900)},
    main="MAIN", runs="N10 N100 N101 N20",
)
case(
    "a main program whose folder nothing tells searches all folders", **UNSURE,
    files={"MAIN.MPF": MAIN, "B.WPD/PART.SPF": sub(900), "CST.DIR/PART.SPF": sub(100)},
    main="MAIN", runs="N10 N100 N101 N20",
)
