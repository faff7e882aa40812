O0001
(GSK 988T: a program may not call itself. It refuses what its relative 988TA allows.)
(Look at: this run stops in alarm 084 at N20, the call of the own program from N100.)
(With -c gsk-988ta the same text runs: N100 to N120 twice, then N30.)
(Run: cncsub run examples/gsk/988t-self-call.nc -c gsk-988t)
N10 G0 X60 Z2
N20 M98 P1 Q100 L2
N30 G0 X100 Z100
N40 M30
N100 G1 W-10 F0.2
N110 G0 U4 W10
N120 M99
