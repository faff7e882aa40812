O0001
(GSK 988TA: M98 with Q starts a subprogram at a block, not at its head.)
(Look at: N5 of O2121 runs first, and again for the second pass. N1 never runs.)
(Run: cncsub run examples/gsk/988ta-start-block.nc -c gsk-988ta)
N10 G0 X60 Z5
N20 G1 X12.22 F0.2
N30 M98 P2121 Q5 L2
N40 G1 X-10
N50 M30

O2121
N1 G1 X40
N5 G1 X50
N6 G1 W-5
N7 M99
