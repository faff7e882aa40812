O0001
(GSK 988TA: a subprogram that calls a part of itself.)
(Look at: M98 Q5 without P means the program that is running, O0121, not the main program.)
(Order of each of the two passes: N2 N3, twice N5 N6, then N4 and its M99.)
(Run: cncsub run examples/gsk/988ta-nested-self-call.nc -c gsk-988ta)
N10 G0 X60 Z50
N20 M98 P121 Q2 L2
N30 G0 X100 Z100
N40 M30

O0121
N1 G1 X77 F0.2
N2 G1 X50 F0.2
N3 M98 Q5 L2
N4 G1 X31 Z45
N45 M99
N5 G1 X51 W-1
N6 M99
