O1009
(GSK 988TA: M99 P says where the caller goes on.)
(Look at: N70 follows the subprogram, N50 and N60 are skipped.)
(Run: cncsub run examples/gsk/988ta-return-block.nc -c gsk-988ta)
N10 G0 X100 Z50
N20 M03 S500
N30 G0 X52 Z2
N40 M98 P1010
N50 G0 X1
N60 G0 X2
N70 G0 X100 Z50
N80 M05
N90 M30

O1010
N1000 G1 X50 F0.2
N1010 G1 Z-30
N1020 G0 U4
N1100 M99 P0070
