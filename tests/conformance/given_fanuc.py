"""Worked examples of FANUC controls: calls, macros and the macro language."""

from conformance import case

case(
    "a colon stands for O, comments are not read and spaces do not count (F001)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="GED; PB155; the colon: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        %
        :1 (MAIN)
        N10 #100 = 1 (#100=9 IN A COMMENT)
        N20 G0 X 1 0. Y2.0
        N30 M30
        %
    """,
    runs="N10 N20 N30",
    vars={100: 1},
    moves="R X10 Y2",
)

case(
    "nothing behind M30 runs (F002)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 M30
        N30 #100=2
    """,
    runs="N10 N20",
    vars={100: 1},
)

case(
    "a block behind a slash is left out while the switch is on (F004)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ISO",
    evidence="secondary",
    program="""
        O1
        #100=1
        /#100=2
        N20 M30
    """,
    skip=(1,),
    vars={100: 1},
)

case(
    "with the switch on, a slash inside a block takes the rest of the block away (F007)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G91 G0
        N10 X1. /Y2.
        M30
    """,
    skip=(1,),
    moves="R X1",
)

case(
    "with the switch off, a slash inside a block does nothing (F008)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G91 G0
        N10 X1. /Y2.
        M30
    """,
    moves="R X1 Y2",
)

case(
    "leading zeros of G, M and P mean nothing (F012)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED",
    evidence="secondary",
    program="""
        O1
        G00 X1.
        G0 X2.
        M003
        M3
        M98 P0010
        M30
        O10
        N5 M99
    """,
    runs="N5",
    m=[3, 3],
)

case(
    "two decimal points in one number alarm (F014)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0007; SIN; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G0 X1.2.3
        M30
    """,
    alarm="illegal-decimal-point",
    number={"fanuc-16i": "007", "fanuc-30i": "PS0007"},
    at="O1",
    word="X1.2.3",
)

case(
    "an address without a value alarms (F015)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0005; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G0 X Y1.
        M30
    """,
    alarm="address-without-value",
    number={"fanuc-16i": "005", "fanuc-30i": "PS0005"},
    at="O1",
)

case(
    "a number of ten digits alarms (F016)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0003; 16i and the number of digits: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G0 X1234567890
        M30
    """,
    alarm="too-many-digits",
    number={"fanuc-16i": "003", "fanuc-30i": "PS0003"},
    at="O1",
)

case(
    "a minus sign at the P of M98 alarms (F017)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0006; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M98 P-10
        M30
        O10
        M99
    """,
    alarm="illegal-minus-sign",
    number={"fanuc-16i": "006", "fanuc-30i": "PS0006"},
    at="O1",
)

case(
    "a G code that the control does not have alarms (F018)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0010; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G777
        M30
    """,
    alarm="g-code-not-available",
    number={"fanuc-16i": "010", "fanuc-30i": "PS0010"},
    at="O1",
)

case(
    "the percent sign reached without M30 ends the run while 3404#6 is 1 (F020)",
    control=["fanuc-16i", "fanuc-30i"],
    source="3404#6 EOR: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        N10 #100=1
        %
    """,
    params={"3404#6": 1},
    runs="N10",
    vars={100: 1},
)

case(
    "the same address twice alarms while 3403#6 is 1 (F021)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS5074; 3403#6 AD2: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G0 X1. X2.
        M30
    """,
    params={"3403#6": 1},
    alarm="address-given-twice",
    number={"fanuc-16i": "5074", "fanuc-30i": "PS5074"},
    at="O1",
)

case(
    "of the same address twice the later word counts while 3403#6 is 0 (F022)",
    control=["fanuc-16i", "fanuc-30i"],
    source="3403#6 AD2: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G0 X1. X2.
        M30
    """,
    moves="R X2",
)

case(
    "M99 returns behind the call (F101)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="source 002, return; GED; ROB",
    evidence="source document",
    program="""
        O1
        N10 M98 P1010
        N20 M30
        O1010
        N1020 #100=5
        N1030 M99
    """,
    runs="N10 N1020 N1030 N20",
    vars={100: 5},
)

case(
    "M98 P21010 runs O1010 twice, and M98 P1010 once (F102)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        N10 #100=0
        N20 #101=0
        N30 M98 P21010
        N40 #101=1
        N50 M98 P1010
        N60 M30
        O1010
        N1020 #100=#100+1
        N1060 M99
    """,
    runs="N10 N20 N30 N1020 N1060 N1020 N1060 N40 N50 N1020 N1060 N60",
    vars={100: 3, 101: 1},
)

case(
    "M98 P51002 runs O1002 five times (F103)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        #100=0
        M98 P51002
        M30
        O1002
        #100=#100+1
        M99
    """,
    vars={100: 5},
)

case(
    "M98 P68003 runs O8003 six times (F104)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ROB",
    evidence="secondary",
    program="""
        O1
        M98 P68003
        M30
        O8003
        #100=#100+1
        M99
    """,
    vars={100: 6},
)

case(
    "M98 P5001 runs O5001 once, and P50002 runs O2 five times (F105)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        M98 P5001
        M98 P50002
        M30
        O5001
        #100=#100+1
        M99
        O2
        #101=#101+1
        M99
    """,
    vars={100: 1, 101: 5},
)

case(
    "M98 P100100 runs O100 ten times (F106)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ROB",
    evidence="secondary",
    program="""
        O1
        M98 P100100
        M30
        O100
        #100=#100+1
        M99
    """,
    vars={100: 10},
)

case(
    "with an L, all five digits of P are the program number (F108)",
    control=["fanuc-0i-f", "fanuc-30i"],
    source="CL198; CW-S; general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98 P12345 L2
        M30
        O12345
        #100=#100+1
        M99
        O2345
        #100=#100+100
        M99
    """,
    vars={100: 2},
)

case(
    "the move of an M98 block comes before the call, and that of an M99 block before the return (F109)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="PMI39 (b); 17W",
    evidence="maker's manual",
    program="""
        O1
        G90 G0 X0
        N10 X10. M98 P200
        N20 X20.
        M30
        O200
        N30 #100=#5001
        N40 X99. M99
    """,
    runs="N10 N30 N40 N20",
    vars={100: 10},
    moves="""
        R X0
        R X10
        R X99
        R X20
    """,
)

case(
    "G91 set in a subprogram still holds behind the call (F110)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, note on modal G codes",
    evidence="source document",
    program="""
        O1
        G90 G0 X10.
        M98 P200
        X10.
        M30
        O200
        G91
        M99
    """,
    moves="""
        R X10
        R X20
    """,
)

case(
    "M98 shares the local variables with its caller (F111)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304; RW",
    evidence="maker's manual",
    program="""
        O1
        #1=7
        M98 P200
        #100=#1
        M30
        O200
        #101=#1
        #1=8
        M99
    """,
    vars={100: 8, 101: 7, 1: 8},
)

case(
    "four levels of M98 are legal (F112)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="MC52; GED; CW-S",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        N9 M30
        O2
        M98 P3
        M99
        O3
        M98 P4
        M99
        O4
        M98 P5
        M99
        O5
        #100=4
        M99
    """,
    runs="N9",
    vars={100: 4},
)

case(
    "the fifth level of M98 alarms on the 16i (F113)",
    control="fanuc-16i",
    source="MC52; GED; 077: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        N9 M30
        O2
        M98 P3
        M99
        O3
        M98 P4
        M99
        O4
        M98 P5
        M99
        O5
        M98 P6
        M99
        O6
        #100=5
        M99
    """,
    vars={100: None},
    alarm="nesting-too-deep",
    number="077",
    at="O5",
)

case(
    "the fifth level of M98 is legal on the 0i-D and the 30i (F113)",
    control=["fanuc-0i-d", "fanuc-30i"],
    source="ten levels: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2
        N9 M30
        O2
        M98 P3
        M99
        O3
        M98 P4
        M99
        O4
        M98 P5
        M99
        O5
        M98 P6
        M99
        O6
        #100=5
        M99
    """,
    vars={100: 5},
)

case(
    "a subprogram that calls itself runs four times on the 16i (F114)",
    control="fanuc-16i",
    source="MC52; 077: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        M30
        O2
        #100=#100+1
        M98 P2
        M99
    """,
    vars={100: 4},
    alarm="nesting-too-deep",
    number="077",
    at="O2",
)

case(
    "a subprogram that calls itself runs ten times on the 0i-D and the 30i (F114)",
    control=["fanuc-0i-d", "fanuc-30i"],
    source="ALM PS0077; ten levels: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2
        M30
        O2
        #100=#100+1
        M98 P2
        M99
    """,
    vars={100: 10},
    alarm="nesting-too-deep",
    number="PS0077",
    at="O2",
)

case(
    "M98 to a program that is not in the memory alarms (F115)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="ALM PS0076; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        N10 M98 P4711
        M30
    """,
    alarm="program-not-found",
    number={"fanuc-16i": "078", "fanuc-0i-d": "PS0076", "fanuc-30i": "PS0076"},
    at="O1 N10",
)

case(
    "M98 without a P alarms (F116)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98
        M30
    """,
    alarm="program-number-missing",
    number={"fanuc-16i": "076", "fanuc-30i": "PS0076"},
    at="O1",
)

case(
    "M99 P30 returns to N30 of the calling program (F117)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="source 003, M99 Pn; GED; MC52",
    evidence="source document",
    program="""
        O1
        N10 M98 P1010
        N20 #100=20
        N30 #101=30
        N40 M30
        O1010
        N1020 M99 P30
    """,
    runs="N10 N1020 N30 N40",
    vars={100: None, 101: 30},
)

case(
    "M99 P returns to the caller's N50, not to the main program's (F119)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99 Pn; GED; MC52",
    evidence="source document",
    program="""
        O1
        N10 M98 P2
        N50 #100=50
        N60 M30
        O2
        N20 M98 P3
        N50 #101=50
        N51 M99
        O3
        N30 M99 P50
    """,
    runs="O1:N10 O2:N20 O3:N30 O2:N50 O2:N51 O1:N50 O1:N60",
    vars={100: 50, 101: 50},
)

case(
    "M99 in a main program starts it over (F120)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99; GED; WEI",
    evidence="source document",
    program="""
        O1
        N10 #100=#100+1
        N20 M99
    """,
    max_cycles=100,
    max_blocks=6,
    runs="N10 N20 N10 N20 N10 N20",
    vars={100: 3},
    stop="limit",
)

case(
    "a /M99 that is skipped lets the main program come to its M30 (F121)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99; GED shows /M99 P",
    evidence="secondary",
    program="""
        O1
        N10 #100=#100+1
        /M99
        N30 M30
    """,
    skip=(1,),
    runs="N10 N30",
    vars={100: 1},
)

case(
    "M99 P20 in a main program jumps to N20 (F122)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99; GED; WEI",
    evidence="source document",
    program="""
        O1
        N10 #100=#100+1
        N20 #101=#101+1
        N30 IF[#101 GE 3] GOTO 50
        N40 M99 P20
        N50 M30
    """,
    runs="N10 N20 N30 N40 N20 N30 N40 N20 N30 N50",
    vars={100: 1, 101: 3},
)

case(
    "M30 in a subprogram ends the whole run (F124)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M30
        N40 M99
    """,
    runs="N10 N30",
)

case(
    "a GOTO does not find a sequence number of the caller (F125)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT p.188; the number for a GOTO is policy",
    evidence="inferred",
    program="""
        O1
        M98 P2
        N50 M30
        O2
        GOTO 50
        M99
    """,
    alarm="jump-target-not-found",
    number={"fanuc-16i": "128", "fanuc-30i": "PS0128"},
    at="O2",
)

case(
    "M98 with the name of a program that is not there alarms (F128)",
    control="fanuc-30i",
    source="ALM PS0310",
    evidence="secondary",
    program="""
        O1
        M98 <NOTHERE>
        M30
    """,
    alarm="named-program-not-found",
    number="PS0310",
    at="O1",
)

case(
    "M98 Q100 L2 runs the part from N100 of its own program twice (F129)",
    control=["fanuc-30i", "fanuc-0i-f"],
    source="GED; WEI; 6005#0 SQC: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        N10 M98 Q100 L2
        N20 M30
        N100 #100=#100+1
        N110 M99
    """,
    params={"6005#0": 1},
    runs="N10 N100 N110 N100 N110 N20",
    vars={100: 2},
)

case(
    "M98 P2 Q20 starts O2 at N20 (F130)",
    control=["fanuc-30i", "fanuc-0i-f"],
    source="GED; WEI; 6005#0 SQC: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M98 P2 Q20
        N90 M30
        O2
        N10 #100=1
        N20 #101=2
        N30 M99
    """,
    params={"6005#0": 1},
    runs="N20 N30 N90",
    vars={100: None, 101: 2},
)

case(
    "M98 with an X while a canned cycle is active alarms (F131)",
    control="fanuc-30i",
    source="ALM PS5329",
    evidence="secondary",
    program="""
        O1
        G81 X1. Z-1. R1. F100
        X2. M98 P2
        M30
        O2
        M99
    """,
    alarm="call-with-words-in-cycle",
    number="PS5329",
    at="O1",
)

case(
    "M98 and M03 in one block alarm (F132)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS5016; which codes stand alone: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M03 M98 P2
        M30
        O2
        M99
    """,
    alarm="illegal-m-combination",
    number={"fanuc-16i": "5016", "fanuc-30i": "PS5016"},
    at="O1",
)

case(
    "an external subprogram that calls another external one alarms (F133)",
    control="fanuc-30i",
    source="ALM PS1080; CW-S",
    evidence="secondary",
    program="""
        O1
        M198 P2
        M30
    """,
    external={
        "O2.CNC": """
            O2
            M198 P3
            M99
        """,
        "O3.CNC": """
            O3
            M99
        """,
    },
    alarm="external-call-nested",
    number="PS1080",
    at="O2",
)

case(
    "an external subprogram may call one of the memory (F134)",
    control="fanuc-30i",
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M198 P2
        N9 M30
        O3
        #100=1
        M99
    """,
    external={
        "O2.CNC": """
            O2
            M98 P3
            M99
        """,
    },
    runs="N9",
    vars={100: 1},
)

case(
    "a GOTO in MDI alarms (F135)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0123; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    mdi="""
        GOTO 10
        N10 M30
    """,
    alarm="jump-in-mdi",
    number={"fanuc-16i": "123", "fanuc-30i": "PS0123"},
)

case(
    "a program called from MDI may use GOTO (F136)",
    control=["fanuc-16i", "fanuc-30i"],
    source="calls from MDI: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O2
        GOTO 10
        #100=1
        N10 M99
    """,
    mdi="""
        M98 P2
        N9 M30
    """,
    runs="N10 N9",
    vars={100: None},
)

case(
    "G65 puts each letter into the variable of argument specification I (F201)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="source 002, argument specification I; ZAP; INT",
    evidence="source document",
    program="""
        O1
        G65 P2 A1. B2. C3. D7. E8. F9. H11. I4. J5. K6. M13. Q17. R18. S19. T20. U21. V22. W23. X24. Y25. Z26.
        M30
        O2
        #500=#1*1000000+#2*10000+#3*100+#4
        #501=#5*1000000+#6*10000+#7*100+#8
        #502=#9*1000000+#11*10000+#13*100+#17
        #503=#18*1000000+#19*10000+#20*100+#21
        #504=#22*1000000+#23*10000+#24*100+#25
        #505=#26
        #506=#10
        #507=#27
        M99
    """,
    vars={
        500: 1020304,
        501: 5060708,
        502: 9111317,
        503: 18192021,
        504: 22232425,
        505: 26,
        506: None,
        507: None,
    },
    arguments={
        1: 1,
        2: 2,
        3: 3,
        7: 7,
        8: 8,
        9: 9,
        11: 11,
        4: 4,
        5: 5,
        6: 6,
        13: 13,
        17: 17,
        18: 18,
        19: 19,
        20: 20,
        21: 21,
        22: 22,
        23: 23,
        24: 24,
        25: 25,
        26: 26,
        10: None,
        27: None,
    },
)

case(
    "ten sets of I, J and K fill #4 to #33 (F203)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, argument specification II; ZAP",
    evidence="source document",
    program="""
        O1
        G65 P2 A1. B2. C3. I4. J5. K6. I7. J8. K9. I10. J11. K12. I13. J14. K15. I16. J17. K18. I19. J20. K21. I22. J23. K24. I25. J26. K27. I28. J29. K30. I31. J32. K33.
        M30
        O2
        #100=0
        #101=1
        WHILE[#101 LE 33]DO1
        IF[#[#101] NE #101] THEN #100=#100+1
        #101=#101+1
        END1
        M99
    """,
    vars={100: 0, 101: 34},
    arguments={1: 1, 4: 4, 9: 9, 31: 31, 33: 33},
)

case(
    "D behind a second I wins #7, and an I before it keeps #4 (F204)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304",
    evidence="maker's manual",
    program="""
        O1
        G65 A1.0 B2.0 I-3.0 I4.0 D5.0 P1000
        M30
        O1000
        #101=#1
        #102=#2
        #103=#3
        #104=#4
        #105=#5
        #106=#6
        #107=#7
        M99
    """,
    vars={101: 1, 102: 2, 103: None, 104: -3, 105: None, 106: None, 107: 5},
)

case(
    "A30. B45. I-3. I4. D5. gives #1, #2, #4 and #7 as the book says (F205)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, mixed arguments",
    evidence="source document",
    program="""
        O1
        G65 P9100 A30. B45. I-3. I4. D5.
        M30
        O9100
        #101=#1
        #102=#2
        #104=#4
        #107=#7
        M99
    """,
    vars={101: 30, 102: 45, 104: -3, 107: 5},
    arguments={1: 30, 2: 45, 4: -3, 7: 5},
)

case(
    "a second I behind D wins #7 (F206)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, mixed arguments; PB304",
    evidence="source document",
    program="""
        O1
        G65 P2 D5. I-3. I4.
        M30
        O2
        #107=#7
        M99
    """,
    vars={107: 4},
)

case(
    "a letter not later in the alphabet than the one before begins a new set (F207)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304 fits; the rule: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 I1. K2. J3. I4.
        M30
        O2
        #104=#4
        #105=#5
        #106=#6
        #107=#7
        #108=#8
        #110=#10
        M99
    """,
    vars={104: 1, 105: None, 106: 2, 107: None, 108: 3, 110: 4},
)

case(
    "with 6008#7 at 1, K J I are #6 #5 #4 in any order (F209)",
    control=["fanuc-30i", "fanuc-0i-d"],
    source="source 002, parameter 6008.7; CW-A; the order: general knowledge of the FANUC manuals",
    evidence="source document",
    program="""
        O1
        G65 P2 K1. J2. I3.
        M30
        O2
        #101=#6
        #102=#5
        #103=#4
        M99
    """,
    params={"6008#7": 1},
    vars={101: 1, 102: 2, 103: 3},
)

case(
    "an eleventh set of I alarms (F210)",
    control="fanuc-30i",
    source="ALM PS1095",
    evidence="maker's manual",
    program="""
        O1
        G65 P2 I1. I2. I3. I4. I5. I6. I7. I8. I9. I10. I11.
        M30
        O2
        M99
    """,
    alarm="too-many-argument-sets",
    number="PS1095",
    at="O1",
)

case(
    "a G code as an argument of G65 alarms (F211)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0129; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G65 P2 A1. G28.
        M30
        O2
        M99
    """,
    alarm="illegal-argument",
    number={"fanuc-16i": "129", "fanuc-30i": "PS0129"},
    at="O1",
)

case(
    "an argument that is left out is vacant in the macro, and the caller keeps its own (F212)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304; VAC",
    evidence="maker's manual",
    program="""
        O1
        #1=99
        G65 P2 B5.
        #102=#1
        M30
        O2
        #100=#1
        #101=#2
        #1=7
        M99
    """,
    vars={100: None, 101: 5, 102: 99, 1: 99},
)

case(
    "a second G65 does not inherit the locals of the first (F213)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304; VAC",
    evidence="maker's manual",
    program="""
        O1
        G65 P2 A1.
        G65 P2 B2.
        M30
        O2
        #100=#1
        #101=#2
        #10=5
        #102=#10
        M99
    """,
    vars={100: None, 101: 2, 102: 5},
)

case(
    "arguments are computed with the caller's variables (F215)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        #1=10
        #2=3
        G65 P2 A#2 B[#1+#2]
        M30
        O2
        #100=#1
        #101=#2
        M99
    """,
    vars={100: 3, 101: 13},
)

case(
    "with 3401#0 at 1 an argument without a point counts as it stands (F218)",
    control=["fanuc-30i", "fanuc-0i-d"],
    source="3401#0 DPI: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 X10
        M30
        O2
        #100=#24
        M99
    """,
    params={"3401#0": 1},
    vars={100: 10},
)

case(
    "every macro level gives its caller's locals back (F219)",
    control=["fanuc-16i", "fanuc-30i"],
    source="PB304",
    evidence="maker's manual",
    program="""
        O1
        #1=1
        G65 P2 A2.
        #100=#1
        M30
        O2
        G65 P3 A3.
        #101=#1
        M99
        O3
        G65 P4 A4.
        #102=#1
        M99
        O4
        #103=#1
        #1=44
        M99
    """,
    vars={100: 1, 101: 2, 102: 3, 103: 4},
)

case(
    "four levels of G65 are legal (F221)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="PB304",
    evidence="maker's manual",
    program="""
        O1
        G65 P2
        N9 M30
        O2
        G65 P3
        M99
        O3
        G65 P4
        M99
        O4
        G65 P5
        M99
        O5
        #100=4
        M99
    """,
    runs="N9",
    vars={100: 4},
)

case(
    "a macro that calls itself runs four times on the 16i (F222)",
    control="fanuc-16i",
    source="PB304; 077: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2
        M30
        O2
        #100=#100+1
        G65 P2
        M99
    """,
    vars={100: 4},
    alarm="macro-nesting-too-deep",
    number="077",
    at="O2",
)

case(
    "a macro that calls itself runs five times on the 0i-D and the 30i (F222)",
    control=["fanuc-0i-d", "fanuc-30i"],
    source="ALM PS0122; five levels: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2
        M30
        O2
        #100=#100+1
        G65 P2
        M99
    """,
    vars={100: 5},
    alarm="macro-nesting-too-deep",
    number="PS0122",
    at="O2",
)

case(
    "four levels of M98 and four of G65 are eight legal levels on the 16i (F223)",
    pins="max_total_nesting",
    control="fanuc-16i",
    source="RW; PB304; MC52",
    evidence="secondary",
    program="""
        O1
        M98 P11
        N9 M30
        O11
        M98 P12
        M99
        O12
        M98 P13
        M99
        O13
        M98 P14
        M99
        O14
        G65 P15
        M99
        O15
        G65 P16
        M99
        O16
        G65 P17
        M99
        O17
        G65 P18
        M99
        O18
        #100=8
        M99
    """,
    runs="N9",
    vars={100: 8},
)

case(
    "M99 P30 leaves a macro to N30 of the caller and gives the caller's locals back (F224)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99 Pn; MC52; PB304",
    evidence="source document",
    program="""
        O1
        #1=1
        N10 G65 P2 A9.
        N20 #100=20
        N30 #101=#1
        N40 M30
        O2
        N50 M99 P30
    """,
    runs="N10 N50 N30 N40",
    vars={100: None, 101: 1},
)

case(
    "G65 without a P alarms (F225)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0076; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G65 A1.
        M30
    """,
    alarm="program-number-missing",
    number={"fanuc-16i": "076", "fanuc-30i": "PS0076"},
    at="O1",
)

case(
    "an argument before G65 alarms (F226)",
    control=["fanuc-16i", "fanuc-30i"],
    source="policy; X-65 wants G65 first",
    evidence="inferred",
    program="""
        O1
        A1. G65 P2 B2.
        M30
        O2
        M99
    """,
    alarm="macro-call-not-first",
    number={"fanuc-16i": "129", "fanuc-30i": "PS0129"},
    at="O1",
)

case(
    "G66 calls behind each move, and not in its own block (F301)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="ENG; M7V; NCT; CW-A",
    evidence="secondary",
    program="""
        O1
        G90 G0
        N10 G66 P2 A5.
        N20 X1.
        N30 X2. Y1.
        N40 G67
        N50 X3.
        N60 M30
        O2
        N100 #100=#100+#1
        N110 M99
    """,
    runs="N10 N20 N100 N110 N30 N100 N110 N40 N50 N60",
    vars={100: 10},
    moves="""
        R X1
        R X2 Y1
        R X3
    """,
)

case(
    "G66 does not call behind a block that moves no axis (F302)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G66 P2
        M8
        #101=1
        G4 P100
        X1.
        G67
        M30
        O2
        #100=#100+1
        M99
    """,
    vars={100: 1},
    m=[8],
)

case(
    "the locals of a G66 macro keep their values from call to call (F303)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G66 P2 A10.
        X1.
        X2.
        X3.
        G67
        M30
        O2
        #100=#1
        #1=#1+1
        M99
    """,
    vars={100: 12},
)

case(
    "G66 with L3 calls three times behind a move (F305)",
    control=["fanuc-16i", "fanuc-30i"],
    source="M7V; NCT; CW-A",
    evidence="secondary",
    program="""
        O1
        G66 P2 L3
        X1.
        G67
        M30
        O2
        #100=#100+1
        M99
    """,
    vars={100: 3},
)

case(
    "a move inside the last G66's macro calls the macro of the G66 before (F307)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT p.171; M7V note 2",
    evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N11 G1 G91 Z10. F100
        N12 G66 P3
        N13 Z20.
        N14 G67
        N15 G67
        N16 Z-5.
        N17 M30
        O2
        N20 X4.
        N21 M99
        O3
        N30 Z2.
        N31 Z3.
        N32 M99
    """,
    runs="N10 N11 N20 N21 N12 N13 N30 N20 N21 N31 N20 N21 N32 N14 N15 N16 N17",
)

case(
    "the first G67 cancels the last G66 only (F308)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT p.171",
    evidence="secondary",
    program="""
        O1
        G66 P2
        G66 P3
        G67
        N10 X1.
        G67
        N20 X2.
        M30
        O2
        #100=#100+1
        M99
        O3
        #101=#101+1
        M99
    """,
    vars={100: 1, 101: None},
)

case(
    "G67 without a modal call alarms (F309)",
    control="fanuc-30i",
    source="ALM PS1100",
    evidence="maker's manual",
    program="""
        O1
        G67
        M30
    """,
    alarm="modal-call-missing",
    number="PS1100",
    at="O1",
)

case(
    "a G66 drilling macro reads the position and gives the modal codes back (F311)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT; M7V; REG; ZAP",
    evidence="secondary",
    program="""
        O1
        G90 G0 X0 Y0 Z50.
        G66 P9110 Z-20. R5. F500
        G90 X20. Y20.
        X50.
        G67
        M30
        O9110
        #1=#4001
        #3=#4003
        #5=#5003
        G00 G90 Z#18
        G01 Z#26 F#9
        G00 Z#5
        G#1 G#3
        M99
    """,
    moves="""
        R X0 Y0 Z50
        R X20 Y20
        R Z5
        F Z-20
        R Z50
        R X50
        R Z5
        F Z-20
        R Z50
    """,
)

case(
    "M50 set in 6080 calls O9020 with arguments, and is not sent to the machine (F402)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, PRM6080=50",
    evidence="source document",
    program="""
        O1
        #1=9
        M50 A1. B2.
        #103=#1
        M30
        O9020
        #100=#1
        #101=#2
        M99
    """,
    params={"6080": 50},
    vars={100: 1, 101: 2, 103: 9},
    m=[],
    arguments={1: 1, 2: 2},
)

case(
    "M60 set in 6071 calls O9001 behind the move, with the caller's locals (F403)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, PRM6071=60; PMI39",
    evidence="source document",
    program="""
        O1
        #1=9
        N10 G0 X5. M60
        M30
        O9001
        #100=#1
        #101=#5001
        M99
    """,
    params={"6071": 60},
    vars={100: 9, 101: 5},
    m=[],
)

case(
    "T23 calls O9000 with 23 in #149, and T inside it is a tool (F404)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 002, PRM6001.5=1; PMI39",
    evidence="source document",
    program="""
        O1
        T23
        M30
        O9000
        #100=#149
        T#149
        M6
        M99
    """,
    params={"6001#5": 1},
    vars={100: 23, 149: 23},
    m=[6],
    t=[23],
)

case(
    "the calling G code inside its own macro is the ordinary code (F405)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G81 X1.
        M30
        O9010
        #100=#24
        N10 G81 X2. Z-1. R1. F100
        N20 G80
        M99
    """,
    params={"6050": 81},
    runs="N10 N20",
    vars={100: 1},
)

case(
    "M60 inside the program it calls goes to the machine (F406)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M60
        M30
        O9001
        #100=#100+1
        M60
        M99
    """,
    params={"6071": 60},
    vars={100: 1},
    m=[60],
)

case(
    "an M code that calls is ordinary inside a macro called by a G code (F407)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G70
        M30
        O9010
        M60
        #100=1
        M99
        O9001
        #100=99
        M99
    """,
    params={"6050": 70, "6071": 60},
    vars={100: 1},
    m=[60],
)

case(
    "G65 and M98 call inside a macro called by a G code (F408)",
    control=["fanuc-16i", "fanuc-30i"],
    source="RW table 20-K; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G70 A1.
        M30
        O9010
        G65 P2 A5.
        M98 P3
        #102=#1
        M99
        O2
        #100=#1
        M99
        O3
        #101=#1
        M99
    """,
    params={"6050": 70},
    vars={100: 5, 101: 1, 102: 1},
)

case(
    "6038 to 6040 let G905 call O1005 (F409)",
    control="fanuc-30i",
    source="6038 to 6040: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G905 A7.
        M30
        O1005
        #100=#1
        M99
    """,
    params={"6038": 900, "6039": 1000, "6040": 100},
    vars={100: 7},
)

case(
    "a calling M code whose program is missing alarms (F410)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0076; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M60
        M30
    """,
    params={"6071": 60},
    alarm="program-not-found",
    number={"fanuc-16i": "078", "fanuc-30i": "PS0076"},
    at="O1",
)

case(
    "brackets come first, then times and divide, then plus and minus (F501)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT; a public interpreter's examples; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #101=100*[5/25]
        #102=10/2+3
        #103=10/[2+3]
        #104=1+2+3+4+5
        #105=[20-5]*2
        #106=20-[5*2]
        #107=2*3+5*2
        #108=2*[3+5]*2
        #109=[1+[2*[3]]]+[[6*2]+2]
        #110=5+2*3+5*[2+2]*2+4
        M30
    """,
    vars={101: 20, 102: 8, 103: 2, 104: 15, 105: 30, 106: 10, 107: 16, 108: 32, 109: 21, 110: 55},
)

case(
    "vacant stays vacant in a copy and counts as 0 in a sum (F502)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-NUL",
    evidence="secondary",
    program="""
        O1
        #101=#1
        #102=#1*5
        #103=#1+#1
        #104=15.7+#1
        #105=15.7-#1
        #2=0
        #106=#2
        M30
    """,
    vars={101: None, 102: 0, 103: 0, 104: 15.7, 105: 15.7, 106: 0},
)

case(
    "a vacant variable takes its word out of the block, and counts as 0 in an expression (F504)",
    control=["fanuc-16i", "fanuc-30i"],
    source="XIA; JIX; M7V",
    evidence="secondary",
    program="""
        O1
        G90 G0 X5. Y5.
        #1=0
        X#1 Y#2
        X[#2+7.]
        M30
    """,
    moves="""
        R X5 Y5
        R X0
        R X7
    """,
)

case(
    "ROUND in a word rounds to the increment, so that the tool comes home (F507)",
    control=["fanuc-16i", "fanuc-30i"],
    source="CSD; the numbers: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #1=1.2345
        #2=2.3456
        G91 G0 X-#1
        G1 X-#2 F300
        G0 X[#1+#2]
        G90 X0
        G91 X-#1
        X-#2
        X[ROUND[#1]+ROUND[#2]]
        M30
    """,
    moves="""
        R X-1.235
        F X-3.581
        R X-0.001
        R X0
        R X-1.235
        R X-3.581
        R X0
    """,
)

case(
    "with 6004#0 at 1 ATAN and ASIN give angles from -180 and from -90 (F509)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALI",
    evidence="secondary",
    program="""
        O1
        #104=ATAN[-1]/[-1]
        #106=ASIN[-1]
        M30
    """,
    params={"6004#0": 1},
    vars={104: -135, 106: -90},
)

case(
    "functions come before times and AND, and these before plus, OR and XOR (F510)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT; ALI; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #4=90
        #101=1+2*SIN[#4]
        #102=6 AND 3
        #103=4 OR 3
        #104=6 XOR 3
        #105=1+2 OR 4
        #106=1+6 AND 3
        M30
    """,
    vars={101: 3, 102: 2, 103: 7, 104: 5, 105: 7, 106: 3},
)

case(
    "five brackets inside each other are legal (F511)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0118; X-NUL",
    evidence="maker's manual",
    program="""
        O1
        #101=[[[[[1]]]]]
        #102=SIN[[[[90]]]]
        M30
    """,
    vars={101: 1, 102: 1},
)

case(
    "six brackets inside each other alarm (F512)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0118; X-NUL",
    evidence="maker's manual",
    program="""
        O1
        #101=SIN[[[[[[90]]]]]]
        M30
    """,
    alarm="brackets-too-deep",
    number={"fanuc-16i": "118", "fanuc-30i": "PS0118"},
    at="O1",
)

case(
    "a division by zero alarms (F513)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0112; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        #1=0
        #101=5/#1
        M30
    """,
    alarm="division-by-zero",
    number={"fanuc-16i": "112", "fanuc-30i": "PS0112"},
    at="O1",
)

case(
    "BCD[12] is 18, and BIN[18] is 12 (F515)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALI; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #101=BCD[12]
        #102=BIN[18]
        M30
    """,
    vars={101: 18, 102: 12},
)

case(
    "GOTO finds blocks before and behind it (F516)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO",
    evidence="secondary",
    program="""
        O1
        N10 #100=#100+1
        N20 IF[#100 GE 3] GOTO 40
        N30 GOTO 10
        N40 M30
    """,
    runs="N10 N20 N30 N10 N20 N30 N10 N20 N40",
    vars={100: 3},
)

case(
    "a GOTO to a sequence number that is not there alarms (F518)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0128; PS0128 or PS0078 is policy",
    evidence="inferred",
    program="""
        O1
        GOTO 500
        M30
    """,
    alarm="jump-target-not-found",
    number={"fanuc-16i": "128", "fanuc-30i": "PS0128"},
    at="O1",
)

case(
    "GOTO 123456 is out of the range of the 16i (F520)",
    control="fanuc-16i",
    source="X-GO; PB155",
    evidence="secondary",
    program="""
        O1
        GOTO 123456
        M30
        N123456 #100=1
        M30
    """,
    alarm="illegal-jump-number",
    number="128",
    at="O1",
)

case(
    "GOTO 123456 is inside the range of the 30i (F520)",
    control="fanuc-30i",
    source="ALM PS1128",
    evidence="secondary",
    program="""
        O1
        GOTO 123456
        M30
        N123456 #100=1
        M30
    """,
    runs="N123456",
    vars={100: 1},
)

case(
    "IF THEN runs its statement where the condition is true and only there (F521)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO; FIN",
    evidence="secondary",
    program="""
        O1
        #1=2
        IF[#1 EQ 2] THEN #100=1
        IF[#1 LT 2] THEN #101=1
        M30
    """,
    vars={100: 1, 101: None},
)

case(
    "both sides of a condition may be expressions (F522)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO; NCT",
    evidence="secondary",
    program="""
        O1
        #1=4
        #7=1
        #100=2
        #101=60
        IF[[#1/[#7+3]] LT [#100*SIN[#101+30]]] GOTO 75
        #102=9
        N75 M30
    """,
    runs="N75",
    vars={102: None},
)

case(
    "a WHILE that is false at once runs nothing of its loop (F524)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO",
    evidence="secondary",
    program="""
        O1
        WHILE[1 GT 2]DO1
        N10 #100=1
        END1
        N20 M30
    """,
    runs="N20",
    vars={100: None},
)

case(
    "a DO without an END alarms (F528)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0124; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        WHILE[1 EQ 1]DO1
        #100=1
        M30
    """,
    alarm="missing-end",
    number={"fanuc-16i": "124", "fanuc-30i": "PS0124"},
    at="O1",
)

case(
    "an END without a DO alarms (F529)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS1124; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #100=1
        END1
        M30
    """,
    alarm="missing-do",
    number={"fanuc-16i": "124", "fanuc-30i": "PS1124"},
    at="O1",
)

case(
    "a GOTO may leave a loop (F530)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        DO1
        #100=#100+1
        IF[#100 EQ 5] GOTO 90
        END1
        N90 M30
    """,
    runs="N90",
    vars={100: 5},
)

case(
    "loops that cross alarm (F532)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ISO; general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        DO1
        DO2
        END1
        END2
        M30
    """,
    alarm="missing-end",
    number={"fanuc-16i": "124", "fanuc-30i": "PS0124"},
    at="O1",
)

case(
    "#3000=1 behind a true condition stops with the alarm 3001 (F534)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; 3000+n: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        N10 IF[#1 EQ #0] THEN #3000=1(MISSING DIAMETER)
        N20 M30
    """,
    runs="N10",
    alarm="user-alarm",
    number={"fanuc-16i": "3001", "fanuc-30i": "MC3001"},
    at="O1 N10",
)

case(
    "with 6008#1 at 1, #3000=1 stops with the alarm 1 (F535)",
    control="fanuc-30i",
    source="6008#1 MCA: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        #3000=1(ALARM MESSAGE)
        M30
    """,
    params={"6008#1": 1},
    alarm="user-alarm",
    number="MC0001",
    at="O1",
)

case(
    "a value assigned to #0 alarms (F536)",
    control=["fanuc-16i", "fanuc-30i"],
    source="JIX; the number: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #0=1
        M30
    """,
    alarm="vacant-assigned",
    number={"fanuc-16i": "116", "fanuc-30i": "PS0116"},
    at="O1",
)

case(
    "a value assigned to a position variable alarms (F537)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0116; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        #5001=1
        M30
    """,
    alarm="variable-write-protected",
    number={"fanuc-16i": "116", "fanuc-30i": "PS0116"},
    at="O1",
)

case(
    "#34 does not exist (F538)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0115; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        #34=1
        M30
    """,
    alarm="illegal-variable",
    number={"fanuc-16i": "115", "fanuc-30i": "PS0115"},
    at="O1",
)

case(
    "a sign stands before the variable of a word, and an expression in brackets (F541)",
    control=["fanuc-16i", "fanuc-30i"],
    source="JIX; SIN; 52S",
    evidence="secondary",
    program="""
        O1
        #1=2.5
        #2=4
        G90 G0 X-#1 Y[#1+#2]
        #3=-#1
        X#3
        M30
    """,
    moves="""
        R X-2.5 Y6.5
        R X-2.5
    """,
)

case(
    "the result of a comparison cannot be stored (F543)",
    control="fanuc-30i",
    source="MEX; ALM PS1125",
    evidence="secondary",
    program="""
        O1
        #2=[1 LT 2]
        M30
    """,
    alarm="expression-format",
    number="PS1125",
    at="O1",
)

case(
    "THEN takes no NC words (F546)",
    control="fanuc-30i",
    source="ALM PS1137; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        IF[1 EQ 1] THEN G0 X5.
        M30
    """,
    alarm="if-format",
    number="PS1137",
    at="O1",
)

case(
    "a loop of the caller goes on behind a macro with a loop of the same number (F548)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        #1=0
        WHILE[#1 LT 3]DO1
        G65 P2 A#1
        #1=#1+1
        END1
        M30
        O2
        #1=#1*2
        WHILE[#2 LT 2]DO1
        #100=#100+#1
        #2=#2+1
        END1
        M99
    """,
    vars={100: 12, 1: 3},
)

case(
    "of two blocks with one sequence number GOTO takes the one behind it first (F549)",
    control=["fanuc-16i", "fanuc-30i"],
    source="policy; FIN",
    evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 GOTO 10
        N10 #101=1
        N30 M30
    """,
    runs="N10 N20 N10 N30",
    vars={100: 1, 101: 1},
)
