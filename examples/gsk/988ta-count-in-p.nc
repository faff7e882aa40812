O0001
(GSK 988TA: the last four digits of P are the program, those in front of them the count.)
(Look at: P21006 runs O1006 twice, P1006 L3 three times. P21006 L3 would be alarm 293.)
(Run: cncsub run examples/gsk/988ta-count-in-p.nc -c gsk-988ta)
N10 G0 X60 Z2
N20 M98 P21006
N30 G0 X60 Z-20
N40 M98 P1006 L3
N50 #100=21006.7 (a variable drops its decimals and may hold the count)
N60 M98 P#100
N70 G0 X100 Z50
N80 M30

O1006
N100 G1 U-4 F0.2
N110 G0 U4
N120 G0 W-3
N130 M99
