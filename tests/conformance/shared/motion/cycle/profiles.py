"""The blocks that G70 to G73 follow, and the block at which the run goes on after them."""

from conformance import case

GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI = "gsk-980tdi"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATHES = [*GSK_988, TDI, *MITSUBISHI, *FANUC]
SOURCE = {"source": "general knowledge: the profile next after the cycle", "evidence": "inferred"}
NOT_FOUND = {
    **dict.fromkeys(GSK_988, "134"), TDI: None, **dict.fromkeys(MITSUBISHI, "P201"),
    F16: "063", **dict.fromkeys(FANUC_PS, "PS0063"),
}


def at(x, z):
    return {"machine": "lathe-a", "start": {"X": x, "Z": z}}


def follows(claim, program, runs, moves_x=None, control=LATHES, **more):
    case(
        claim, control=control, **SOURCE, setup=at(50, 2), program="O1\n" + program,
        runs=runs, moves_x=moves_x, max_blocks=100, **more,
    )


def alarms(claim, program, where, control=LATHES, cause="pq-not-found", number=None, **more):
    case(
        claim, control=control, **SOURCE, setup=at(50, 2), program="O1\n" + program,
        alarm=cause, number={c: (number or NOT_FOUND)[c] for c in control}, at=where,
        max_blocks=100, **more,
    )


def profile(x):
    return f"N10 G0 X{x}.\nN20 G1 Z-9.\nN90 X50.\n"


_TWICE = "N1 S500 F0.2\n{0}N2 {1} P10 Q90\n" + profile(30) + "N3 G0 Z2.\nN4 {1} P10 Q90\n" + profile(40)

follows(
    "after the second of two G71 that use the same numbers the run goes on after its own profile",
    _TWICE.format("N5 G71 U50. R1.\n", "G71") + "N6 G0 X60.\nN7 M30", "N1 N5 N2 N3 N4 N6 N7",
)
alarms(
    "where the second G71 names a block that only the first profile has, there is none after",
    _TWICE.format("N5 G71 U50. R1.\n", "G71").replace("Q90", "Q91").replace("N90", "N91", 1) + "N6 M30",
    "O1 N4", word="Q91",
)
follows(
    "after the second of two G72 that use the same numbers the run goes on after its own profile",
    _TWICE.format("N5 G72 W50. R1.\n", "G72").replace("G0 X30.\n", "G0 Z-9.\n").replace("G1 Z-9.\nN90 X50.", "G1 X30.\nN90 Z2.", 1).replace("G0 X40.\n", "G0 Z-9.\n").replace("G1 Z-9.\nN90 X50.", "G1 X40.\nN90 Z2.", 1) + "N6 G0 X60.\nN7 M30",
    "N1 N5 N2 N3 N4 N6 N7",
)
alarms(
    "where the second G72 names a block that only the first profile has, there is none after",
    _TWICE.format("N5 G72 W50. R1.\n", "G72").replace("G0 X30.\n", "G0 Z-9.\n").replace("G1 Z-9.\nN90 X50.", "G1 X30.\nN90 Z2.", 1).replace("G0 X40.\n", "G0 Z-9.\n").replace("G1 Z-9.\nN90 X50.", "G1 X40.\nN90 Z2.", 1).replace("Q90", "Q91").replace("N90", "N91", 1) + "N6 M30",
    "O1 N4", word="Q91",
)
follows(
    "after the second of two G73 that use the same numbers the run goes on after its own profile",
    _TWICE.format("N5 G73 U0 W0 R2\n", "G73") + "N6 G0 X60.\nN7 M30", "N1 N5 N2 N3 N4 N6 N7",
)
alarms(
    "where the second G73 names a block that only the first profile has, there is none after",
    _TWICE.format("N5 G73 U0 W0 R2\n", "G73").replace("Q90", "Q91").replace("N90", "N91", 1) + "N6 M30",
    "O1 N4", word="Q91",
)
follows(
    "a cycle's profile is the next after it, also where a block of that number stands before",
    "N1 S500 F0.2\nN10 G0 X50.\nN5 G71 U50. R1.\nN2 G71 P10 Q90\n" + profile(30) + "N90 G0 X70.\nN7 M30",
    "N1 N10 N5 N2 N90 N7", [50, 50, 30, 30, 50, 50, 70],
)
follows(
    "G70 follows the profile that stands after it before one that stands in front",
    "N1 S500 F0.2\nN2 G0 X50.\nN3 G70 P10 Q90\nN4 M0\n" + profile(30) + "N5 G70 P10 Q90\nN6 M30",
    "N1 N2 N3 N4 N10 N20 N90 N5 N6",
    [50, 30, 30, 50, 50, 30, 30, 50, 30, 30, 50, 50],
)
follows(
    "a profile that ends the program has its end after it",
    "N1 S500 F0.2\nN5 G71 U50. R1.\nN6 M98 P2\nN7 M30\nO2\nN2 G71 P10 Q90\n" + profile(30).replace(
        "N90 X50.\n", "N90 X50.\nM99\n"),
    "N1 N5 N6 N2 N7",
)
alarms(
    "a profile after which nothing stands ends the program without a code that ends it",
    "N1 S500 F0.2\nN5 G71 U50. R1.\nN6 M98 P2\nN7 M30\nO2\nN2 G71 P10 Q90\n" + profile(30),
    "O2", control=["fanuc-30i"], cause="end-of-record", number={"fanuc-30i": "PS5010"},
)
follows(
    "a subprogram called again finds its own profile each time, whatever its caller has",
    "N1 S500 F0.2\nN5 G71 U50. R1.\n" + "N6 M98 P2\nN7 M98 P2\nN8 M30\n" + profile(20)
    + "O2\nN2 G71 P10 Q90\n" + profile(30) + "N3 G0 Z2.\nN4 G71 P10 Q90\n" + profile(40) + "N9 M99",
    "N1 N5 N6 N2 N3 N4 N9 N7 N2 N3 N4 N9 N8",
)
alarms(
    "a profile that stands in another program of the file is none",
    "N1 S500 F0.2\nN5 G71 U50. R1.\nN2 G71 P10 Q90\nN3 M30\nO2\n" + profile(30) + "M99", "O1 N2", word="P10",
)
alarms(
    "a last block that stands only before the first is none",
    "N1 S500 F0.2\nN90 G0 X50.\nN5 G71 U50. R1.\nN2 G71 P10 Q90\nN10 G0 X30.\nN20 G1 Z-9.\nN3 M30",
    "O1 N2", word="Q90",
)
follows(
    "after G71 in a loop the run goes on after the profile outside it, and the loop is left",
    "N1 S500 F0.2\nN5 G71 U50. R1.\nWHILE[1EQ1]DO1\nN2 G71 P10 Q90\nEND1\n" + profile(30)
    + "N3 G0 Z2.\nWHILE[#1NE1]DO1\nN4 #1=1\nEND1\nN7 M30",
    "N1 N5 N2 N3 N4 N7", control=[*MITSUBISHI, *FANUC],
)
case(
    "the one-block form finds its own profile the second time",
    control=FANUC, **SOURCE, params={"1#1": 1}, setup=at(50, 2), max_blocks=100,
    program="O1\nN1 S500 F0.2\nN2 G71 P10 Q90 U0 W0 D20000\n" + profile(30)
            + "N3 G0 Z2.\nN4 G71 P10 Q90 U0 W0 D20000\n" + profile(40) + "N6 G0 X60.\nN7 M30",
    runs="N1 N2 N3 N4 N6 N7",
)
case(
    "after G71 the 988 goes on after a profile that stands right behind, over 'nothing'",
    control=GSK_988, source="TA 8", evidence="maker's manual", setup=at(50, 2), skip=(1,),
    max_blocks=100,
    program="O1\nN1 S500 F0.2\nN5 G71 U50. R1.\nN2 G71 P10 Q90\n" + profile(30) + "N3 G0 Z2.\nN7 M30",
    runs="N1 N5 N2 N3 N7",
)
case(
    "after G71 the 988 goes on after a profile that stands right behind, over '(PROFILE)'",
    control=GSK_988, source="TA 8", evidence="maker's manual", setup=at(50, 2), skip=(1,),
    max_blocks=100,
    program="O1\nN1 S500 F0.2\nN5 G71 U50. R1.\nN2 G71 P10 Q90\n(PROFILE)\n\n" + profile(30) + "N3 G0 Z2.\nN7 M30",
    runs="N1 N5 N2 N3 N7",
)
case(
    "after G71 the 988 goes on after a profile that stands right behind, over '/N4 M8'",
    control=GSK_988, source="TA 8", evidence="maker's manual", setup=at(50, 2), skip=(1,),
    max_blocks=100,
    program="O1\nN1 S500 F0.2\nN5 G71 U50. R1.\nN2 G71 P10 Q90\n/N4 M8\n" + profile(30) + "N3 G0 Z2.\nN7 M30",
    runs="N1 N5 N2 N3 N7",
)
case(
    "after G71 the 988 goes on after a profile that stands right behind, over 'N4 M8'",
    control=GSK_988, source="TA 8", evidence="maker's manual", setup=at(50, 2), skip=(1,),
    max_blocks=100,
    program="O1\nN1 S500 F0.2\nN5 G71 U50. R1.\nN2 G71 P10 Q90\nN4 M8\n" + profile(30) + "N3 G0 Z2.\nN7 M30",
    runs="N1 N5 N2 N4 N10 N20 N90 N3 N7",
)
case(
    "a cycle typed in MDI alarms before its profile is looked for on gsk-988ta",
    control=GSK_988, source="Talm 129; ALM 067", evidence="secondary", setup=at(50, 2),
    mdi="N2 G70 P10 Q90", alarm="profile-in-mdi", number="129", word="G70",
)
case(
    "a cycle typed in MDI alarms before its profile is looked for on fanuc-16i",
    control=FANUC, source="Talm 129; ALM 067", evidence="secondary", setup=at(50, 2),
    mdi="N2 G70 P10 Q90", alarm="profile-in-mdi",
    number={F16: "067", **dict.fromkeys(FANUC_PS, "PS0067")}, word="G70",
)
