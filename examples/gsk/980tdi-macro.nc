O0001
(GSK 980TDi: the three ways to compute: G65 H, WHILE, and a G code that calls a macro.)
(Look at: N30 to N60 are a loop of G65 H codes, N80 to N110 the same with WHILE.)
(N130 calls O2000 like G65 P2000, once G100 is registered and #500 says so:)
(in Python: control.with_parameters with 86=1, 87=100, 88=2000 and variables 500=1.)
(Run: cncsub run examples/gsk/980tdi-macro.nc -c gsk-980tdi)
N10 G0 X62 Z2
N20 G65 H01 P#100 Q60
N30 G65 H03 P#100 Q#100 R2 (#100 = #100 - 2)
N40 G0 X#100
N50 G01 Z-30 F0.2
N55 G0 U2 Z2
N60 G65 H83 P30 Q#100 R54 (back to N30 while #100 is above 54)
N70 #101=0
N80 WHILE[#101 LT 3]DO1
N90 #101=#101+1
N100 G65 P9001 A44 W[-10*#101]
N110 END1
N120 IF[#500<>1]GOTO 140
N130 G100 A40 W-25
N140 G0 X100 Z50
N150 M30

O9001
(A diameter of the groove, W its place in Z)
N200 G0 X58 Z#23
N210 G01 X#1 F0.05
N220 G0 X58
N230 M99

O2000
(called by G100: a groove as wide as two cuts)
N300 G65 P9001 A#1 W#23
N310 G65 P9001 A#1 W[#23-2]
N320 M99
