"""SINUMERIK 828D and 840D sl: the language is that of the SINUMERIK ONE."""

from conformance import case

BOTH = ["siemens-828d", "siemens-840d-sl"]

case(
    "the sixteenth level of calls of a relative is 14012", pins="max_nesting",
    control=BOTH, source="828D p.490, 16 program levels", evidence={"siemens-828d": "maker's manual", "siemens-840d-sl": "secondary"},
    program="%_N_MAIN_MPF\nN10 REC\nN20 M30\n%_N_REC_SPF\nN30 G0 X1\nN40 REC\nN50 M17",
    runs="N10 (N30 N40)*14 N30", alarm="nesting-too-deep", number="14012", at="REC N40",
)
case(
    "a name answers with and without what the control puts around it", control=BOTH, source="828D p.490, example",
    evidence={"siemens-828d": "maker's manual", "siemens-840d-sl": "secondary"},
    program="%_N_MAIN_MPF\nN10 SUB_PROG\nN20 _N_SUB_PROG_SPF\nN50 M30\n%_N_SUB_PROG_SPF\nN60 M17",
    runs="N10 N60 N20 N60 N50",
)
case(
    "a block of a control structure has no label", control=BOTH, source="840Dsl p.107; PRM, 12630",
    evidence="secondary",
    program="%_N_MAIN_MPF\nN10 LAB1: IF R1==1\nN20 G0 X1\nN30 ENDIF\nN40 M30", runs="", alarm="structure-marked", number="12630", at="MAIN N10",
)
case(
    "the standard cycles are there", control=BOTH, source="HC81, format and depth", evidence="secondary",
    program="N10 G0 X5 Z60 F100\nN20 MCALL CYCLE81(50,30,2,-10)\nN30 X6\nN40 MCALL\nN50 M30",
    moves="R X5 Y0 Z60\nR X6\nR Z32\nF Z-10\nR Z50",
)
case(
    "arcs go both ways", control=BOTH, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program="N10 G0 X0 Y0\nN20 G2 X10 CR=5 F100\nN30 G3 X0 CR=5\nN40 M30", moves="R X0 Y0\nCW X10 Y0 C X5 Y0\nCCW X0 Y0 C X5 Y0",
)
for claim, program, runs, alarm, number, word, source in (
    ("F0 is no feed of theirs", "N10 G0 X1\nN20 G1 X5 F0\nN30 M30", "N10", "feed-out-of-range", "14800", "F0", "840Dv p.2-9: 14800"),
    ("their first G96 needs S", "N10 G0 X1\nN20 G96\nN30 M30", "N10", "no-surface-speed", "10900", "G96", "840Dv p.2-9: 10900"),
    ("an arc by its radius ends elsewhere on them", "N10 G0 X1\nN20 G2 X1 CR=5 F100\nN30 M30", "N10", "no-arc-travel", "14040", "CR=5", "HSA 14040"),
    ("a rounding of theirs is not below zero", "N10 G1 X5 F100 RND=-1\nN20 Y5\nN30 M30", "", "value-out-of-range", None, "RND=-1", "general knowledge of the SINUMERIK 840D"),
):
    case(
        claim, control=BOTH, source=source, evidence="inferred" if number is None else "secondary",
        program=program, runs=runs, alarm=alarm, number=number, at="MAIN N10" if runs == "" else "MAIN N20", word=word,
    )
