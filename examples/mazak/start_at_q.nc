O0001 (MAZAK: A SUBPROGRAM THAT STARTS IN THE MIDDLE)
(cncsub run examples/mazak/start_at_q.nc -c mazak-smooth)
(M98 P Q L: O200 runs from its head, and twice from N230. The tap reads F as its pitch, in G94 too.)
(Look at the order of N210 to N260, and at the feed of the tap: 600 turns of 1.25 mm are 750 mm/min.)
N10 G90 G54 G0 X0. Y0. Z50.
N20 S600 M3
N30 M98 P200
N40 M98 P200 Q230 L2
N50 M5
N60 M30
O0200
N210 G0 Z20.
N220 G0 Y10.
N230 G91 G0 X15.
N240 G90 G84 Z-10. R5. F1.25
N250 G80
N260 M99
%
