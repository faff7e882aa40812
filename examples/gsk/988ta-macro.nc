O0001
(GSK 988TA: macro calls. O9000 turns a shoulder in passes, O9001 cuts a groove.)
(Look at: the locals of the macro, A in #1 and so on, the IF in N110 and the WHILE in N120.)
(G66 in N40 only declares O9001: the macro follows the moves of N50 and N60, not the M8 of N55.)
(Run: cncsub run examples/gsk/988ta-macro.nc -c gsk-988ta)
N10 G0 X62 Z2
N20 M03 S500
N30 G65 P9000 A60 B50 C2 D-30
N35 G0 X52 Z2
N40 G66 P9001 A44 F0.05
N50 G0 Z-10
N55 M08
N60 G0 Z-20
N70 G67
N80 G0 X100 Z50
N90 M30

O9000
(A start diameter, B end diameter, C depth of a pass, D end in Z)
N100 #10=#1
N110 IF[#1 LE #2]GOTO 190
N120 WHILE[#10 GT #2]DO1
N130 #10=#10-#3
N135 IF[#10 LT #2]THEN #10=#2
N140 G0 X#10
N150 G1 Z#7 F0.2
N160 G0 U2 Z2
N170 END1
N190 M99

O9001
(A diameter of the bottom, F feed)
N200 G1 X#1 F#9
N210 G4 X0.5
N220 G0 X52
N230 M99
