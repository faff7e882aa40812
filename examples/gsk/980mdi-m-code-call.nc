O0001
(GSK 980MDi: the count stands in P, and M codes may call subprograms.)
(Look at: P00032000 runs O2000 three times. There is no L: N30 says L3 and O2000 runs once.)
(6044 = 60, 6045 = 2100, 6046 = 2 make M60 call O2100 and M61 call O2101. Neither reaches the)
(machine: it gets M3, M8, M9 and M5. Without the parameters it would get M60 and M61 as well.)
(Run: cncsub run examples/gsk/980mdi-m-code-call.nc -c gsk-980mdi --param 6044=60 --param 6045=2100 --param 6046=2)
N10 G90 G0 X0 Y0 Z5
N15 M03 S1000
N20 M98 P00032000
N30 M98 P2000 L3
N40 M60
N50 G90 G0 X0 Y0
N60 M61
N70 M05
N80 M30

O2000
(one hole, then on to the next place)
N100 G91 G1 Z-8 F100
N110 G0 Z8
N120 X15
N130 M99

O2100
(M60: coolant on, down to the work)
N200 M08
N210 G90 G0 Z2
N220 M99

O2101
(M61: coolant off, up)
N300 M09
N310 G90 G0 Z50
N320 M99
