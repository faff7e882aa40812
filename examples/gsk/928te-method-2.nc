%2
(GSK 928: M98 calls blocks of the same program. Second method: the part stands behind M02.)
(Look at: N0080 to N0140 run five times, then N0050 follows. No M97 is needed.)
(The manual prints P0060 in N0040, but its text runs N0080 to N0140: a misprint, mended here.)
(Run: cncsub run examples/gsk/928te-method-2.nc -c gsk-928te)
N0010 G00 X100 Z50
N0020 M03 S01
N0030 G0 X66 Z15 F500
N0040 M98 P0080 L5
N0050 G0 X100 Z50
N0060 M05
N0070 M02
N0080 G0 U-4
N0090 G01 Z-10 F80
N0100 U20 Z-25
N0110 Z-35
N0120 G0 U2 Z1
N0130 U-22
N0140 M99
