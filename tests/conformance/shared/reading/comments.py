"""Reading of NC text: comments and encodings."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
WITH_O = FANUC + GSK_988 + GSK_980 + MITSUBISHI  # programs are named O1
WITH_PERCENT = ["hnc-21m", "gsk-928te"]  # programs are named %1
HNC = "hnc-21m"


def on_fanuc(number):
    """Return the alarm as each FANUC shows it: 005 on the 16i, PS0005 on the others."""
    return {c: f"{number:03d}" if c == "fanuc-16i" else f"PS{number:04d}" for c in FANUC}


POLICY = "general knowledge"

case(
    "a comment may stand anywhere in a block, even between an address and its value",
    control=FANUC + MITSUBISHI, source="GED, comments", evidence="inferred",
    program="""
        O1
        (A)N10(B) M(C)8(D)
        N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "percent signs, slashes and brackets in a comment are text",
    control=WITH_O, source=POLICY, evidence="inferred",
    program="""
        O1
        (FEED 100%)
        N10 M8 (#1=[2 O5 N99 M30 <X>)
        N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment ends at the first closing parenthesis",
    control=FANUC, source="GED, comments", evidence="secondary",
    program="""
        O1
        N10 T5 (A (B) M8
        N30 M30
    """,
    runs="N10 N30", t=[5], m=[8],
)

OWN = "real programs: `($Message(\"... [..] ...\") )`; general knowledge"

case(
    "a comment with brackets of its own in a block ends with the last, O1 programs",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=OWN, evidence="inferred",
    files={"O1.NC": b'O1\nN10 M8\nN20 M9 ($Message("[1] of [2]") )\nN30 M30\n'}, runs="N10 N20 N30",
    m=[8, 9],
)
case(
    "a comment with brackets of its own in a block ends with the last, %1 programs",
    control=WITH_PERCENT, source=OWN, evidence="inferred",
    files={"O1.NC": b'%1\nN10 M8\nN20 M9 ($Message("[1] of [2]") )\nN30 M30\n'}, runs="N10 N20 N30",
    m=[8, 9],
)
case(
    "a comment with brackets of its own on a line of its own ends with the last, O1 programs",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=OWN, evidence="inferred",
    files={"O1.NC": b'O1\nN10 M8\n($Message("A") )\nN20 M9\nN30 M30\n'}, runs="N10 N20 N30",
    m=[8, 9],
)
case(
    "a comment with brackets of its own on a line of its own ends with the last, %1 programs",
    control=WITH_PERCENT, source=OWN, evidence="inferred",
    files={"O1.NC": b'%1\nN10 M8\n($Message("A") )\nN20 M9\nN30 M30\n'}, runs="N10 N20 N30",
    m=[8, 9],
)
case(
    "a comment with brackets of its own at the head of a block ends with the last, O1 programs",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=OWN, evidence="inferred", files={"O1.NC": b'O1\nN10 M8\n(A (B) ) N20 M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment with brackets of its own at the head of a block ends with the last, %1 programs",
    control=WITH_PERCENT, source=OWN, evidence="inferred",
    files={"O1.NC": b'%1\nN10 M8\n(A (B) ) N20 M9\nN30 M30\n'}, runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment with brackets of its own between words ends with the last, O1 programs",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=OWN, evidence="inferred", files={"O1.NC": b'O1\nN10 M8\nN20 (A(B)) M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment with brackets of its own between words ends with the last, %1 programs",
    control=WITH_PERCENT, source=OWN, evidence="inferred",
    files={"O1.NC": b'%1\nN10 M8\nN20 (A(B)) M9\nN30 M30\n'}, runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment with brackets of its own twice ends with the last, O1 programs",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=OWN, evidence="inferred",
    files={"O1.NC": b'O1\nN10 M8\nN20 M9 (A (B (C) ) )\nN30 M30\n'}, runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment with brackets of its own twice ends with the last, %1 programs",
    control=WITH_PERCENT, source=OWN, evidence="inferred",
    files={"O1.NC": b'%1\nN10 M8\nN20 M9 (A (B (C) ) )\nN30 M30\n'}, runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment with brackets of its own before another comment ends with the last, O1 programs",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=OWN, evidence="inferred",
    files={"O1.NC": b'O1\nN10 M8\nN20 M9 (A (B)) (C (D))\nN30 M30\n'}, runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment with brackets of its own before another comment ends with the last, %1 programs",
    control=WITH_PERCENT, source=OWN, evidence="inferred",
    files={"O1.NC": b'%1\nN10 M8\nN20 M9 (A (B)) (C (D))\nN30 M30\n'}, runs="N10 N20 N30", m=[8, 9],
)
case("a comment with brackets of its own ends a macro statement", control=FANUC + GSK_988 + MITSUBISHI,
     source=OWN, evidence="inferred",
     program="O1\nN10 #100=2 (A (B) )\nN20 IF[#100EQ2]GOTO40 (A (B) )\nN30 M8\nN40 M30\n",
     runs="N10 N20 N40", vars={100: 2})
case(
    "a parenthesis after a word alarms",
    control=FANUC + GSK_988 + MITSUBISHI, source=OWN, evidence="inferred",
    program="O1\nN10 M8\nN20 M9)\nN30 M30\n",
    runs="N10", m=[8], alarm="illegal-character", word=")",
    number={**dict.fromkeys(GSK_988), **dict.fromkeys(MITSUBISHI, "P32"), **on_fanuc(9), "fanuc-16i": "009"},
)
case(
    "a parenthesis after a word after a comment alarms",
    control=FANUC + GSK_988 + MITSUBISHI, source=OWN, evidence="inferred",
    program="O1\nN10 M8\nN20 (A) M9 )\nN30 M30\n",
    runs="N10", m=[8], alarm="illegal-character", word=")",
    number={**dict.fromkeys(GSK_988), **dict.fromkeys(MITSUBISHI, "P32"), **on_fanuc(9), "fanuc-16i": "009"},
)
case(
    "a parenthesis at the head of a block alarms",
    control=FANUC + GSK_988 + MITSUBISHI, source=OWN, evidence="inferred",
    program="O1\nN10 M8\n) N20 M9\nN30 M30\n",
    runs="N10", m=[8], alarm="illegal-character", word=")",
    number={**dict.fromkeys(GSK_988), **dict.fromkeys(MITSUBISHI, "P32"), **on_fanuc(9), "fanuc-16i": "009"},
)
case(
    "a parenthesis and a sign after a comment alarms",
    control=FANUC + GSK_988 + MITSUBISHI, source=OWN, evidence="inferred",
    program="O1\nN10 M8\nN20 M9 (A (B) ) !\nN30 M30\n",
    runs="N10", m=[8], alarm="illegal-character", word="!",
    number={**dict.fromkeys(GSK_988), **dict.fromkeys(MITSUBISHI, "P32"), **on_fanuc(9), "fanuc-16i": "009"},
)
case(
    "a parenthesis too many after a word is 041 on the GSK 980",
    control=GSK_980, source="MDia 041: brackets not paired", evidence="maker's manual",
    program="O1\nN10 M8\nN20 M9)\nN30 M30\n",
    runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20", word=")",
)
case(
    "a parenthesis too many after a comment is 041 on the GSK 980",
    control=GSK_980, source="MDia 041: brackets not paired", evidence="maker's manual",
    program="O1\nN10 M8\nN20 M9 (A (B) )\nN30 M30\n",
    runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20", word=")",
)
case(
    "a parenthesis too many between words is 041 on the GSK 980",
    control=GSK_980, source="MDia 041: brackets not paired", evidence="maker's manual",
    program="O1\nN10 M8\nN20 (A)) M9\nN30 M30\n",
    runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20", word=")",
)
case(
    "a comment that is not closed ends with its block on FANUC",
    control=FANUC, source="GED, comments; policy for unclosed", evidence="inferred",
    program="""
        O1
        N10 T5 (A M8
        N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", t=[5], m=[9],
)
case(
    "a comment that is not closed is 041 on the GSK 980",
    pins="open_comment",
    control=GSK_980, source="MDia 041", evidence="maker's manual",
    program="""
        O1
        N10 M8
        N20 M9 (A
        N30 M30
    """,
    runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20",
)
case(
    "a comment in full-width parentheses is 041 on the GSK 980",
    control=GSK_980, source="MDia 041", evidence="maker's manual",
    program="""
        O1
        N10 M8
        N20 M9 \uff08A\uff09
        N30 M30
    """,
    runs="N10", m=[8], alarm="comment-not-closed", number="0041", at="O1 N20",
)
case(
    "a comment in UTF-8 Chinese is read over",
    control=[*WITH_O, HNC], source=POLICY, evidence="inferred",
    files={"O1.NC": b'O1 (\xe7\xb2\x97\xe5\x8a\xa0\xe5\xb7\xa5)\nN10 M8 (\xe7\xb2\x97\xe5\x8a\xa0\xe5\xb7\xa5)\n(\xe7\xb2\x97\xe5\x8a\xa0\xe5\xb7\xa5)\nN20 M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment in GBK Chinese is read over",
    control=[*WITH_O, HNC], source=POLICY, evidence="inferred",
    files={"O1.NC": b'O1 (\xb4\xd6\xbc\xd3\xb9\xa4)\nN10 M8 (\xb4\xd6\xbc\xd3\xb9\xa4)\n(\xb4\xd6\xbc\xd3\xb9\xa4)\nN20 M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment in Shift-JIS Japanese is read over",
    control=[*WITH_O, HNC], source=POLICY, evidence="inferred",
    files={"O1.NC": b'O1 (\x83\\\x83t\x83g\x95\\\x8e\xa6)\nN10 M8 (\x83\\\x83t\x83g\x95\\\x8e\xa6)\n(\x83\\\x83t\x83g\x95\\\x8e\xa6)\nN20 M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment in Latin-1 German is read over",
    control=[*WITH_O, HNC], source=POLICY, evidence="inferred",
    files={"O1.NC": b'O1 (Fr\xe4ser \xd810)\nN10 M8 (Fr\xe4ser \xd810)\n(Fr\xe4ser \xd810)\nN20 M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment in UTF-8 Cyrillic is read over",
    control=[*WITH_O, HNC], source=POLICY, evidence="inferred",
    files={"O1.NC": b'O1 (\xd0\xa4\xd1\x80\xd0\xb5\xd0\xb7\xd0\xb0)\nN10 M8 (\xd0\xa4\xd1\x80\xd0\xb5\xd0\xb7\xd0\xb0)\n(\xd0\xa4\xd1\x80\xd0\xb5\xd0\xb7\xd0\xb0)\nN20 M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment in Windows Cyrillic is read over",
    control=[*WITH_O, HNC], source=POLICY, evidence="inferred",
    files={"O1.NC": b'O1 (\xd4\xf0\xe5\xe7\xe0)\nN10 M8 (\xd4\xf0\xe5\xe7\xe0)\n(\xd4\xf0\xe5\xe7\xe0)\nN20 M9\nN30 M30\n'},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "an encoding may be named",
    control=WITH_O, source=POLICY, evidence="inferred",
    files={"O1.NC": "O1\nN10 M8 (\u30bd)\nN20 M9\nN30 M30\n".encode("shift_jis")},
    encoding="shift_jis", runs="N10 N20 N30", m=[8, 9],
)
case(
    "bytes of no encoding in a comment are read over",
    control=WITH_O, source=POLICY, evidence="inferred",
    files={"O1.NC": b"O1\nN10 M8 (\xff\xfe\x80\x01)\nN20 M9\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a comment of #3000 is the alarm's text and no comment",
    control=FANUC, source="general knowledge, #3000", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 #3000= 91 (TEXT)
        N30 M30
    """,
    runs="N10 N20", alarm="user-alarm",
    number={c: "3091" if c == "fanuc-16i" else "MC3091" for c in FANUC}, at="O1 N20",
)
