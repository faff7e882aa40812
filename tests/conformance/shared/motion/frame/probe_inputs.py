"""The answers of the probe."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-30i"]
PROBE = """
    O1
    N10 G90 G31 X100. F500
    N20 #100=#5061
    N30 #101=#5001
    N40 M30
"""

case(
    "G31 ends where its skip signal comes, and #5061 keeps the place",
    control=FANUC, source="ZAP, #5061; general knowledge, G31", evidence="inferred",
    program=PROBE, setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": [0.25]},
    vars={100: 25, 101: 25},
)
case(
    "G31 without its signal goes to its end point",
    control=FANUC, source="ZAP, #5061; general knowledge, G31", evidence="inferred",
    program=PROBE, setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": []},
    vars={100: 100, 101: 100},
)
case(
    "each G31 takes the next skip",
    control=FANUC, source="ZAP, #5061; general knowledge, G31", evidence="inferred",
    program="""
        O1
        N10 G90 G31 X100. F500
        N20 #100=#5061
        N30 G31 X0
        N40 #101=#5061
        N50 M30
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": [0.5, 0.2]},
    vars={100: 50, 101: 40},
)
case(
    "a program alarms where its probe met nothing",
    control=FANUC, source="GED, #3000; ZAP, #5061; general knowledge, G31", evidence="inferred",
    program="""
        O1
        N10 G90 G31 X100. F500
        N20 IF[#5061 LT 99.]GOTO 40
        N30 #3000=3(NO CONTACT)
        N40 M30
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": []}, runs="N10 N20 N30",
    alarm="user-alarm", number={"fanuc-16i": "3003", "fanuc-30i": "MC3003"}, at="O1 N30",
)
