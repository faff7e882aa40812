%
O0001 (SYNTEC: A PROGRAM THAT CALLS A PART OF ITSELF, AS THE POST OF THE SYIL WRITES IT)
(cncsub run examples/syntec/own_part.nc -c syntec-22ma)
(N9000 to M99 runs three times: once for N20, twice for N40 with its L2.)
(On a FANUC the same M98 has no program number and alarms: -c fanuc-0i-f)
N10 G90 G94 G17 G49 G40 G80
N20 M98 H9000
N30 G0 X100. Y50.
N40 M98 H9000 L2
N50 M30
N9000 G91 G1 X10. F500
N9010 Y10.
N9020 G90
N9030 M99
%
