O1234
(GSK 988TA: a program calls a part of itself, which stands behind its M30.)
(Look at: N3 to N6 run twice, then N30 follows the call. P1234 could be left out, Q could not.)
(Run: cncsub run examples/gsk/988ta-self-call.nc -c gsk-988ta)
N10 G0 X10 Z10
N20 M98 P1234 Q3 L2
N30 G1 X-10 Z-10 F0.2
N40 G0 X100 Z50
N50 M30
N3 G0 X100 Z100
N4 G1 X90 F0.2
N5 G0 X100
N6 M99
