"""Haas NGC: the variables of its manual, one by one."""

from conformance import case

HAAS = "haas-ngc"


def manual(page: str, **said: str) -> dict[str, str]:
    return {"control": HAAS, "source": f"HNGC p.{page}", "evidence": "maker's manual", **said}


case(
    "#5207 is no variable", **manual("214", evidence="inferred"),
    program="O1\nN10 #1=#5207\nN20 M30", runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "#11000 to #11255 are inputs", **manual("208, #11000- #11255"), inputs={"signals": {11018: 1, 11255: 1}},
    program="O1\nN10 #10000=#11018+#11255+#11100\nN20 M30", vars={10000: 2},
)
case(
    "#11256 is after the last input", **manual("208", evidence="inferred"),
    program="O1\nN10 #1=#11256\nN20 M30", runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "#12000 to #12255 are outputs that a program writes and reads", **manual("218, #12000-#12255"),
    program="O1\nN10 #12012=1\nN20 #12255=1\nN30 #1=#12012+#12255+#12018\nN40 M30", vars={1: 2},
)
case(
    "the coolant level is #13013", **manual("205, #13013"), inputs={"signals": {13013: 70}},
    program="O1\nN10 #1=#13013\nN20 M30", vars={1: 70},
)
for number in (1064, 1080, 1090, 1264, 3020, 3023, 3027, 3028, 3030, 3032, 3033, 3196, 3201, 3401, 5401, 5501, 5801, 7501, 7601, 7701, 7801,
               8501, 8515, 8551, 9000, 9016, 13000, 30000, 50001, 51801, 52801 - 1):
    case(
        f"#{number} is what the machine says", **manual("200 to 208, macro variables"), inputs={"signals": {number: 7}},
        program=f"O1\nN10 #1=#{number}\nN20 M30", vars={1: 7},
    )
for number in (3901, 3902, 5601, 5701, 5901, 8500, 8550):
    case(
        f"#{number} keeps what a program writes", **manual("200 to 208, macro variables", evidence="inferred"),
        program=f"O1\nN10 #{number}=7\nN20 #1=#{number}\nN30 M30", vars={1: 7},
    )
for number in (10000, 10149, 10200, 10400, 10700, 10999):
    case(
        f"#{number} is a global variable", pins="commons", **manual("199, #10000-#10999"),
        program=f"O1\nN10 #{number}=7\nN20 #1=#{number}\nN30 M30", vars={1: 7, number: 7},
    )
case(
    "#3000 takes 1 to 999 and adds 1000", pins="user_alarm_offset", **manual("210, #3000= 15"),
    program="O1\nN10 #3000= 15 (MESSAGE PLACED INTO ALARM LIST)\nN20 M30", runs="N10", alarm="user-alarm", number="1015", at="O1 N10",
)
case(
    "#3000=999 is 1999", **manual("210: between 1000 and 1999"),
    program="O1\nN10 #3000=999\nN20 M30", runs="N10", alarm="user-alarm", number="1999", at="O1 N10",
)
case(
    "#3001 is set and counts milliseconds from there", **manual("211, #3001"),
    program="O1\nN10 #3001=0\nN20 G4 P1.5\nN30 #1=FIX[#3001/100]\nN40 M30", vars={1: 15},
)
case(
    "#4003 is 91 under G91", **manual("213: if #4003 contains 91"),
    program="O1\nN10 G91\nN20 #1=#4003\nN30 G90\nN40 #2=#4003\nN50 M30", vars={1: 91, 2: 90},
)
case(
    "#4109 is the F before, #4119 the S, #4120 the T", **manual("213, #4101-#4126"),
    program="O1\nN10 F100. S500 T3\nN20 #1=#4109\nN30 #2=#4119\nN40 #3=#4120\nN50 M30", vars={1: 100, 2: 500, 3: 3},
)
case(
    "#5001 is the end of the block before, #5021 the machine's place, #5041 that in the work system",
    **manual("213, #5001, #5021, #5041"), setup={"machine": "mill", "work_offsets": {"G54": {"X": 3, "Z": 1}}, "length_offsets": {1: 50}},
    program="O1\nN10 G43 H1 G0 X1. Z2.\nN20 #1=#5001\nN30 #2=#5021\nN40 #3=#5041\nN50 #4=#5083\nN60 M30", vars={1: 1, 2: 4, 3: 1, 4: 50},
)
case(
    "#5069 is the W of the skip signal", **manual("214, #5061-#5069", evidence="inferred"),
    program="O1\nN10 #1=#5069\nN20 M30", vars={1: 0},
)
case(
    "#14001 is the X of G154 P1, #15961 that of P99", pins="max_extra_systems", **manual("203 to 207"),
    program="O1\nN10 #14001=5.\nN20 #15961=6.\nN30 G0 G154 P1 X1.\nN40 #1=#5021\nN50 G154 P99 X1.\nN60 #2=#5021\nN70 M30",
    vars={1: 6, 2: 7},
)
