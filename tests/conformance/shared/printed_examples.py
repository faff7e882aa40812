"""The programs that the source documents print, as they print them, on the control they are of.

A text that a source prints in one line is cut into its blocks here. A block of ours (the head of a
program, a start, a feed, an end) has no N of three digits. The claim names misprints.
"""

from conformance import case

MILL = {"machine": "mill"}
MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres
FANUC_MILLS = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC = "hnc-21m"


def printed(claim, *blocks, controls=(HNC, *FANUC_MILLS), head="", setup=None, **expected):
    """Write a row of blocks as source 003 prints them, between a head of ours and M30."""
    case(
        claim, control=controls, source="source 003", replace=MM, setup=MILL | (setup or {}),
        program="\n".join(["O1", *filter(None, [head]), *blocks, "M30"]), **expected,
    )


# The typical example; its text below the print explains N140 to N170.
TYPICAL = "N100 G90G21G17G94G40", "N110 T1M06 M03 S500", "N120 G43H01 Z5.", "N130 X10.Y10."
CUTS = "N140 G01Z-5.F200", "N150 G01X20.Y20.F500", "N160 G01Z-15.F300"

case(
    "the typical example runs as it is printed", control=[HNC, *FANUC_MILLS], source="source 003",
    replace=MM, setup=MILL,
    program="\n".join(["O1", *TYPICAL, "N180 G00 X0. Y0. Z50.", "N190 M30"]),
    runs="N100 N110 N120 N130 N180 N190", moves="R Z5\nR X10 Y10\nR X0 Y0 Z50",
)
case(
    "the typical example runs with the cuts that its text tells", control=[HNC, *FANUC_MILLS],
    source="source 003", replace=MM, setup=MILL,
    program="\n".join(["O1", *TYPICAL, *CUTS, "N180 G00 X0. Y0. Z50.", "N190 M30"]),
    moves="R Z5\nR X10 Y10\nF Z-5\nF X20 Y20\nF Z-15\nR X0 Y0 Z50",
)
printed(
    "the sample program of part 4 runs: its arc ends where it starts, a full circle",
    "G92 X0 Y0 Z0", "G00 X100 Y100 Z10", "G01 X50 Y50 Z5 F100", "G02 X50 Y50 Z5 I25 J0 F100",
    "M05", "M03 S1000", "G01 X0 Y0 Z0 F100",
    moves="R X100 Y100 Z10\nF X50 Y50 Z5\nCW X50 Y50 C X75 Y50\nF X0 Y0 Z0", m=[5, 3],
)
printed("G00G90X120.Y60. goes there", "G00G90X120.Y60.;", moves="R X120 Y60")
printed("G01X10.Y20.Z20.F80. cuts there", "G01X10.Y20.Z20.F80.", moves="F X10 Y20 Z20")
printed(
    "N20G02X120R40 of example 4 keeps its Y", "N10G90G00X40Y60", "N20G02X120R40", head="F100",
    moves="R X40 Y60\nCW X120 Y60 C X80 Y60",
)
printed(
    "N20G02X120I40J0 of example 4 is the same arc", "N10G90G00X40Y60", "N20G02X120I40J0",
    head="F100", moves="R X40 Y60\nCW X120 Y60 C X80 Y60",
)
printed(
    "G02X80Y20R-40 of example 5 turns around X80 Y60",
    "G02X80Y20R-40", head="G00 X40 Y60 F100", moves="R X40 Y60\nCW X80 Y20 C X80 Y60",
)
printed(
    "G02X80Y20R40 of example 5 turns around X40 Y20",
    "G02X80Y20R40", head="G00 X40 Y60 F100", moves="R X40 Y60\nCW X80 Y20 C X40 Y20",
)
printed("G02I40 of example 6 is a full circle", "G02I40", head="F100", moves="CW X0 Y0 C X40 Y0")
printed(
    "G92X50Y50Z10 of example 7 sets the zero 50 50 10 off", "G92X50Y50Z10", "G00X0Y0Z0",
    final_machine="X-50 Y-50 Z-10",
)
printed("G90G53X5.0Y10.0 goes to the machine's X5 Y10", "G90G53X5.0Y10.0;", moves="R X5 Y10")
printed(
    "G54G01X120Y80 of example 8 is G55G01X40Y40", "G54G01X120Y80", "G55G01X40Y40", head="F100",
    setup={"work_offsets": {"G55": {"X": 80, "Y": 40}}}, final_machine="X120 Y80",
)
printed(
    "the blocks of example 9 end at the same point, with Y05 for its Y0 and the number of a heading",
    "N10G54", "N20G52X80Y40", "N30G01X40Y40", "N40G52X0Y0", head="F100",
    final_machine="X120 Y80", final_work="X120 Y80",
)
printed(
    "the increments of Fig. 3 end where its absolute words do", "G92 X0 Y0 Z0", "G91 G00 X15 Y-40",
    "G92 X0 Y0", "G00 X20 Y10", "X40 Y20", final_machine="X75 Y-10",
)
printed(
    "the absolute words of Fig. 3 end where its increments do", "G92 X0 Y0 Z0", "G90 G00 X15 Y-40",
    "G92 X0 Y0", "G00 X20 Y10", "X60 Y30", final_machine="X75 Y-10",
)
printed(
    "example 10 goes to 100 at 60 degrees, and 60 degrees on", "N10G17G90G16",
    "N20G01X100Y60F80", "N30G91Y60", "N30G15", controls=FANUC_MILLS, setup={"start": {"X": 0}},
    moves="F X50 Y86.6025\nF X-50 Y86.6025",
)
printed("the line T02 of the source runs", "N10 T02", "N20 G00 X0", controls=[HNC], runs="N10 N20")
printed(
    "the line M03 S1000 of the source runs",
    "N10 M03 S1000", "N20 G00 X0", controls=[HNC], runs="N10 N20",
)
printed("the line M05 of the source runs", "N10 M05", "N20 G00 X0", controls=[HNC], runs="N10 N20")
printed(
    "the line G92 X0 Y0 Z0 of the source runs",
    "N10 G92 X0 Y0 Z0", "N20 G00 X0", controls=[HNC], runs="N10 N20",
)
printed(
    "the line G04P1 of the source runs",
    "N10 G04P1", "N20 G00 X0", controls=[HNC], runs="N10 N20",
)
printed(
    "the line G04X1 of the source runs",
    "N10 G04X1", "N20 G00 X0", controls=[HNC], runs="N10 N20",
)
printed(
    "the line G94 F100 of the source runs",
    "N10 G94 F100", "N20 G00 X0", controls=[HNC], runs="N10 N20",
)
printed("the line G22 of the source runs", "N10 G22", "N20 G00 X0", controls=[HNC], runs="N10 N20")
printed(
    "G20 in mid-program alarms, as the source says", "N10 G00 X1", "N20 G20", controls=[HNC],
    runs="N10", alarm="unit-change-misplaced", at="O1 N20", word="G20",
)

# Subprogram O10 in main program O20; in the print its first line follows a garbled one.
SUBPROGRAM = """O10
N210 G41G91G01X30Y-5D01F50
N220 Y5
N230 G02X20I10
N240 X-10I-5
N250 G03X-10I-5
N260 G0Y-5
N270 G40X-30Y5
N280 M99
"""
MAIN = """O20
N110 G54G90G17M03S600
N120 G0X0Y0
N130 G43G0Z5H01
N140 G01Z-3F50
N150 M98P10
N160 G90Y50
N170 M98P10
N180 G90G49Z50
N190 M05
M30
"""
_part = " ".join(f"O10:N{n}" for n in range(210, 290, 10))
_main = "O20:N110 O20:N120 O20:N130 O20:N140 O20:N150"

case(
    "O20 calls O10 twice, as they are printed", control=FANUC_MILLS, source="source 003",
    replace=MM, setup=MILL, files={"O20": MAIN, "O10": SUBPROGRAM}, main="O20",
    runs=f"{_main} {_part} O20:N160 O20:N170 {_part} O20:N180 O20:N190",
)
case(
    "example 4.2.2: M98 P_ of a program that is not there alarms", control=FANUC_MILLS,
    source="source 003", files={"O20": MAIN}, main="O20", replace=MM, setup=MILL,
    runs=_main.replace(" O20:N150", ""), alarm="program-not-found", at="O20 N150",
    number={"fanuc-16i": "078", "fanuc-0i-d": "PS0076", "fanuc-0i-f": "PS0076", "fanuc-30i": "PS0076"},
)
