"""Words of G10 and G04 besides the plain forms, and axes that an arc cannot move."""

from conformance import case

GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE, HNC = "gsk-980tdi", "gsk-980mdi", "gsk-928te", "hnc-21m"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
POSTS = "forum posts on G10 and G04 of a Mitsubishi, excerpts"


def on_fanuc(number):
    return {F16: number, **dict.fromkeys(FANUC_PS, f"PS0{number}")}


def one(claim, control, block, *, before="G90 G0 X0", source="general knowledge", setup=MILL,
        evidence="inferred", **expected):
    alarms = "alarm" in expected
    case(
        claim, control=control, source=source, evidence=evidence, setup=setup,
        pins="helix dwell_point other_system data_forms:L52 data_forms:without-L",
        program=f"O1\nN10 {before}\nN20 {block}\nN30 M30",
        runs="N10" if alarms else "N10 N20 N30", **({"at": "O1 N20"} if alarms else {}), **expected,
    )


# G10 L2
one(
    "G10 L2 P7 sets G54 of a Mitsubishi",
    MITSUBISHI, "G10 L2 P7 X5.", source=POSTS, evidence="secondary", vars={5221: 5},
)
one(
    "G10 L2 P9 sets G54 of a Mitsubishi",
    MITSUBISHI, "G10 L2 P9 X5.", source=POSTS, evidence="secondary", vars={5221: 5},
)
one(
    "G10 L2 P99 sets G54 of a Mitsubishi",
    MITSUBISHI, "G10 L2 P99 X5.", source=POSTS, evidence="secondary", vars={5221: 5},
)
one(
    "G10 L2 P1 sets G54 of a Mitsubishi",
    MITSUBISHI, "G10 L2 P1 X5.", source=POSTS, evidence="secondary", vars={5221: 5},
)
one(
    "G10 L2 without P sets G54 of a Mitsubishi",
    MITSUBISHI, "G10 L2  X5.", source=POSTS, evidence="secondary", vars={5221: 5},
)
one("G10 L2 without P sets the system in force of a Mitsubishi", MITSUBISHI, "G10 L2 X5.",
    before="G90 G55 G0 X0", source=POSTS, evidence="secondary", vars={5221: 0, 5241: 5})
one("G10 L2 P6 sets G59 of a Mitsubishi", MITSUBISHI, "G10 L2 P6 X5.", vars={5221: 0, 5321: 5})
one(
    "there is no P7 of G10 L2",
    [*FANUC, *GSK_988, TDI, MDI], "G10 L2 P7 X5.", source="ALM 031; Talm 062; MDib 0238",
    alarm="g10-p",
    number=on_fanuc("031") | dict.fromkeys(GSK_988, "062") | {TDI: None, MDI: "0238"}, word="P7",
)
one(
    "there is no P9 of G10 L2",
    [*FANUC, *GSK_988, TDI, MDI], "G10 L2 P9 X5.", source="ALM 031; Talm 062; MDib 0238",
    alarm="g10-p",
    number=on_fanuc("031") | dict.fromkeys(GSK_988, "062") | {TDI: None, MDI: "0238"}, word="P9",
)
one(
    "there is no P99 of G10 L2",
    [*FANUC, *GSK_988, TDI, MDI], "G10 L2 P99 X5.", source="ALM 031; Talm 062; MDib 0238",
    alarm="g10-p",
    number=on_fanuc("031") | dict.fromkeys(GSK_988, "062") | {TDI: None, MDI: "0238"}, word="P99",
)

# G10 L52 and G10 P R
one("G10 L52 writes parameters, as L50 does, and moves nothing", FANUC_PS, "G10 L52",
    source="general knowledge, G10 of the 0i-D and 30i", final_machine="X0")
one("G10 L50 writes parameters", FANUC, "G10 L50", final_machine="X0")
one(
    "G10 does not take L52 everywhere", [F16, *GSK_988, TDI, MDI, *MITSUBISHI], "G10 L52 P1 R1.",
    source="ALM 031; Talm 061; MDib 0244", alarm="g10-l",
    number={F16: "031", **dict.fromkeys(GSK_988, "061"), TDI: None, MDI: "0244",
            **dict.fromkeys(MITSUBISHI)}, word="L52",
)
one(
    "G10 with L51 is no code for parameters", FANUC, "G10 L51", source="ALM 031",
    evidence="secondary", alarm="g10-l", number=on_fanuc("031"), word="L51",
)
case(
    "G10 P1 R5. of a mill sets the length of H1",
    control=FANUC, pins="data_forms:without-L", source="a repost of the 0i manual, memory A",
    evidence="secondary", setup=MILL,
    program="O1\nN10 G90 G10 P1 R5.\nN20 G43 H1 G0 Z10.\nN30 M30",
    runs="N10 N20 N30", final_machine="Z15",
)
case(
    "G10 P1 R-2.5 of a mill sets the length of H1",
    control=FANUC, pins="data_forms:without-L", source="a repost of the 0i manual, memory A",
    evidence="secondary", setup=MILL,
    program="O1\nN10 G90 G10 P1 R-2.5\nN20 G43 H1 G0 Z10.\nN30 M30",
    runs="N10 N20 N30", final_machine="Z7.5",
)
case(
    "G10 P R of a mill sets the radius of D1", control=FANUC,
    source="a repost of the 0i manual, memory A", evidence="secondary", setup=MILL,
    program="""
        O1
        N10 G90 G10 P1 R5.
        N20 G41 D1 G1 X0 Y10. F600
        N30 Y20.
        N40 G40 X10.
        N50 M30
    """,
    centre="X-5 Y10 | X-5 Y20 | X10 Y20",
)
one(
    "G10 P R needs L", [MDI, *MITSUBISHI], "G10 P1 R5.", source="MDib 0246",
    alarm="g10-word-missing", number={MDI: "0246", **dict.fromkeys(MITSUBISHI)}, word="G10",
)
one(
    "G10 R of a mill needs P", FANUC, "G10 R5.", source="ALM 031", evidence="secondary",
    alarm="g10-word-missing", number=on_fanuc("031"), word="G10",
)

# G04
one(
    "G4 P1.5 takes 0.001 s on a Mitsubishi while #8112 is 0",
    MITSUBISHI, "G4 P1.5",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 0}, time=0.001,
)
one(
    "G4 P1. takes 0.001 s on a Mitsubishi while #8112 is 0",
    MITSUBISHI, "G4 P1.",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 0}, time=0.001,
)
one(
    "G4 P1.5 takes 1.5 s on a Mitsubishi while #8112 is 1",
    MITSUBISHI, "G4 P1.5",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 1}, time=1.5,
)
one(
    "G4 P1. takes 1 s on a Mitsubishi while #8112 is 1",
    MITSUBISHI, "G4 P1.",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 1}, time=1,
)
one(
    "G4 P1500 takes 1.5 s on a Mitsubishi while #8112 is 0",
    MITSUBISHI, "G4 P1500",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 0}, time=1.5,
)
one(
    "G4 P1500 takes 1.5 s on a Mitsubishi while #8112 is 1",
    MITSUBISHI, "G4 P1500",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 1}, time=1.5,
)
one(
    "P2.5 G4 takes 2.5 s on a Mitsubishi while #8112 is 1",
    MITSUBISHI, "P2.5 G4",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 1}, time=2.5,
)
one(
    "P2.5 G4 takes 0.002 s on a Mitsubishi while #8112 is 0",
    MITSUBISHI, "P2.5 G4",
    source="forum posts on G10 and G04 of a Mitsubishi, excerpts; general knowledge, #8112",
    params={"8112": 0}, time=0.002,
)
one("what is after the point of a dwell is cut on a Mitsubishi as delivered", MITSUBISHI,
    "G4 P2.5", source=f"{POSTS}; M700V manual, 5.3 (7)", time=0.002)
one("P of a dwell has a point on the HNC-21M: it counts seconds", HNC, "G4 P1.5",
    source="source 003, G04", time=1.5)
one(
    "G4 P1.5 has a point where P takes none",
    [*FANUC, *GSK_988, TDI, MDI, TE], "G4 P1.5", before="G0 X0", source="ALM 007",
    alarm="illegal-decimal-point",
    number=on_fanuc("007") | dict.fromkeys(GSK_988, "007") | {TDI: "0012", MDI: "0012", TE: None},
)
one(
    "G04 P1. has a point where P takes none",
    [*FANUC, *GSK_988, TDI, MDI, TE], "G04 P1.", before="G0 X0", source="ALM 007",
    alarm="illegal-decimal-point",
    number=on_fanuc("007") | dict.fromkeys(GSK_988, "007") | {TDI: "0012", MDI: "0012", TE: None},
)
one("a point is refused at P of other blocks of a Mitsubishi", MITSUBISHI, "G10 L2 P1. X5.",
    alarm="illegal-decimal-point", number="P33")

# L of a canned cycle
case(
    "L0 in G81 is no repeat count of a FANUC, which counts with K",
    control=FANUC, source="general knowledge", evidence="inferred", setup=MILL,
    program="O1\nN10 G90 G0 Z5.\nN20 G81 X1. Y1. Z-5. R1. F100 L0\nN30 M30",
    moves="R Z5\nR X1 Y1\nR Z1\nF Z-5\nR Z5",
)
case(
    "G81 with L0 drills nothing",
    control=[*MITSUBISHI, HNC], source="general knowledge", evidence="inferred", setup=MILL,
    program="O1\nN10 G90 G0 Z5.\nN20 G81 X1. Y1. Z-5. R1. F100 L0\nN30 M30",
    moves="R Z5",
)
case(
    "L0 in G82 is no repeat count of a FANUC, which counts with K",
    control=FANUC, source="general knowledge", evidence="inferred", setup=MILL,
    program="O1\nN10 G90 G0 Z5.\nN20 G82 X1. Y1. Z-5. R1. F100 L0\nN30 M30",
    moves="R Z5\nR X1 Y1\nR Z1\nF Z-5\nR Z5",
)
case(
    "G82 with L0 drills nothing",
    control=[*MITSUBISHI, HNC], source="general knowledge", evidence="inferred", setup=MILL,
    program="O1\nN10 G90 G0 Z5.\nN20 G82 X1. Y1. Z-5. R1. F100 L0\nN30 M30",
    moves="R Z5",
)

# Arcs
ARC_SOURCE = "ALM 021; Talm 033; MDib 0022"

one(
    "G2 X10. Y10. R20. A5. F100 in G17 names an axis that no helix moves",
    [*FANUC, *MITSUBISHI, HNC], "G2 X10. Y10. R20. A5. F100", before="G90 G17 G0 X0 Y0 Z0",
    source=ARC_SOURCE, alarm="arc-axis-not-in-plane", word="A5.",
    number=on_fanuc("021") | dict.fromkeys(MITSUBISHI, "P113") | {HNC: None},
)
one(
    "G2 X10. Y10. R20. A5. F100 in G17 names an axis beyond X, Y and Z on the 980MDi",
    MDI, "G2 X10. Y10. R20. A5. F100", before="G90 G17 G0 X0 Y0 Z0", source="MDib 0022",
    evidence="maker's manual", alarm="helix-axis", word="A5.", number="0022",
)
one(
    "G3 X10. Z10. R20. A5. F100 in G18 names an axis that no helix moves",
    [*FANUC, *MITSUBISHI, HNC], "G3 X10. Z10. R20. A5. F100", before="G90 G18 G0 X0 Y0 Z0",
    source=ARC_SOURCE, alarm="arc-axis-not-in-plane", word="A5.",
    number=on_fanuc("021") | dict.fromkeys(MITSUBISHI, "P113") | {HNC: None},
)
one(
    "G3 X10. Z10. R20. A5. F100 in G18 names an axis beyond X, Y and Z on the 980MDi",
    MDI, "G3 X10. Z10. R20. A5. F100", before="G90 G18 G0 X0 Y0 Z0", source="MDib 0022",
    evidence="maker's manual", alarm="helix-axis", word="A5.", number="0022",
)
one(
    "G2 Y10. Z10. R20. B5. F100 in G19 names an axis that no helix moves",
    [*FANUC, *MITSUBISHI, HNC], "G2 Y10. Z10. R20. B5. F100", before="G90 G19 G0 X0 Y0 Z0",
    source=ARC_SOURCE, alarm="arc-axis-not-in-plane", word="B5.",
    number=on_fanuc("021") | dict.fromkeys(MITSUBISHI, "P113") | {HNC: None},
)
one(
    "G2 Y10. Z10. R20. B5. F100 in G19 names an axis beyond X, Y and Z on the 980MDi",
    MDI, "G2 Y10. Z10. R20. B5. F100", before="G90 G19 G0 X0 Y0 Z0", source="MDib 0022",
    evidence="maker's manual", alarm="helix-axis", word="B5.", number="0022",
)
one(
    "G3 X10. Y0 I5. J0 A5. F100 in G17 names an axis that no helix moves",
    [*FANUC, *MITSUBISHI, HNC], "G3 X10. Y0 I5. J0 A5. F100", before="G90 G17 G0 X0 Y0 Z0",
    source=ARC_SOURCE, alarm="arc-axis-not-in-plane", word="A5.",
    number=on_fanuc("021") | dict.fromkeys(MITSUBISHI, "P113") | {HNC: None},
)
one(
    "G3 X10. Y0 I5. J0 A5. F100 in G17 names an axis beyond X, Y and Z on the 980MDi",
    MDI, "G3 X10. Y0 I5. J0 A5. F100", before="G90 G17 G0 X0 Y0 Z0", source="MDib 0022",
    evidence="maker's manual", alarm="helix-axis", word="A5.", number="0022",
)
one(
    "G2 X10. Z10. R20. B5. F100 of a lathe names an axis outside its plane",
    [*FANUC, *GSK_988, TDI], "G2 X10. Z10. R20. B5. F100", before="G18 G0 X0 Z0", setup=LATHE,
    source=ARC_SOURCE, alarm="arc-axis-not-in-plane", word="B5.",
    number=on_fanuc("021") | dict.fromkeys(GSK_988, "033") | {TDI: None},
)
one(
    "G3 X10. Z10. I0 K10. B5. F100 of a lathe names an axis outside its plane",
    [*FANUC, *GSK_988, TDI], "G3 X10. Z10. I0 K10. B5. F100", before="G18 G0 X0 Z0", setup=LATHE,
    source=ARC_SOURCE, alarm="arc-axis-not-in-plane", word="B5.",
    number=on_fanuc("021") | dict.fromkeys(GSK_988, "033") | {TDI: None},
)
one(
    "G2 X10. Z10. R20. Y5. F100 moves Y across the plane of a lathe",
    FANUC, "G2 X10. Z10. R20. Y5. F100", before="G18 G0 X0 Z0", setup=LATHE, source="ALM 021",
    evidence="secondary", alarm="arc-axis-not-in-plane", word="Y5.", number=on_fanuc("021"),
)
one(
    "G3 X10. Z10. I0 K10. Y5. F100 moves Y across the plane of a lathe",
    FANUC, "G3 X10. Z10. I0 K10. Y5. F100", before="G18 G0 X0 Z0", setup=LATHE, source="ALM 021",
    evidence="secondary", alarm="arc-axis-not-in-plane", word="Y5.", number=on_fanuc("021"),
)
one("a lathe with helices moves Y across G18", [*MITSUBISHI, MDI, HNC],
    "G2 X10. Z10. R20. Y5. F100", before="G18 G0 X0 Z0", setup=LATHE, final_machine="X10 Y5 Z10")
one("the third axis of a mill's arc is a helix", [*FANUC, *MITSUBISHI, MDI, HNC],
    "G2 X10. Y10. R20. Z5. F100", before="G90 G17 G0 X0 Y0", final_machine="X10 Y10 Z5")
one("an arc of a lathe in its plane runs", [*FANUC, *GSK_988, TDI], "G2 X10. Z10. R20. F100",
    before="G18 G0 X0 Z0", setup=LATHE, final_machine="X10 Z10")
case(
    "P0 of G10 L2 is the external offset, which counts in all systems",
    control=[*FANUC, *MITSUBISHI, MDI], pins="data_forms:in-force", source="general knowledge", evidence="inferred",
    setup=MILL, program="O1\nN10 G10 L2 P0 X5.\nN20 G55 G0 X0\nN30 M30", final_machine="X5",
)
case(
    "P0 of G10 L2 is the external offset of a lathe too",
    control=[*GSK_988, TDI], pins="data_forms:in-force", source="general knowledge", evidence="inferred",
    setup=LATHE, program="O1\nN10 G10 L2 P0 X5.\nN20 G55 G0 X0\nN30 M30", final_machine="X5",
)
case(
    "G10 L20 sets an extra system, not one by the place of the tool",
    control=[*FANUC, *MITSUBISHI, MDI], pins="data_forms:here", source="general knowledge", evidence="inferred",
    setup=MILL, program="O1\nN10 G10 L20 P2 X5.\nN20 G54.1 P2 G0 X0\nN30 M30", final_machine="X5",
)
case(
    "R of G10 L10 is the length of an H",
    control=[*FANUC, *MITSUBISHI, MDI], pins="data_forms:tools", source="general knowledge", evidence="inferred",
    setup=MILL, program="O1\nN10 G10 L10 P1 R5.\nN20 G43 H1 G0 Z0\nN30 M30", final_machine="Z5",
)
