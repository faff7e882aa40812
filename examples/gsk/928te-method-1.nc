%1
(GSK 928: M98 calls blocks of the same program. First method: the part stands in the main flow.)
(Look at: N0060 to N0120 run five times, then M97 in N0050 leads round them to N0130.)
(Without N0050 the part would run once more and its M99, with no call open, would end the program.)
(Run: cncsub run examples/gsk/928te-method-1.nc -c gsk-928te)
N0010 G00 X100 Z50
N0020 M03 S01
N0030 G0 X50 Z15 F500
N0040 M98 P0060 L5
N0050 M97 P0130
N0060 G0 U-4
N0070 G01 Z-10 F80
N0080 U20 Z-25
N0090 Z-35
N0100 G0 U2 Z1
N0110 U-22
N0120 M99
N0130 G0 X100 Z50
N0140 M05
N0140 M02
