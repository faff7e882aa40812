%
O0003 (BOLT CIRCLE)
(cncsub run examples/fanuc/bolt_circle.nc -c fanuc-0i-f)
(G65 calls the circle macro once; its G66 calls the drilling macro behind)
(every move to a hole, six times. Look at the tree of calls and at the)
(level: the drilling macro has locals of its own, set by G66 and kept from)
(hole to hole, so its #100 counts the holes.)
(R circle radius, H number of holes, A first angle, Z depth, Q clearance, F feed)
N10 G90 G00 X0. Y0. Z50.
N20 M03 S1200
N30 G65 P9200 X60. Y40. R25. H6. A30. Z-12. Q2. F150.
N40 G00 Z50.
N50 M05
N60 M30
O9200 (CIRCLE: CENTRE X Y, RADIUS R, H HOLES FROM ANGLE A)
N10 IF[#11 LT 1]GOTO90
N20 #30=0
N30 G66 P9201 Z#26 R#17 F#9
N40 WHILE[#30 LT #11]DO1
N50 #31=#1+360*#30/#11
N60 G00 X[#24+#18*COS[#31]] Y[#25+#18*SIN[#31]]
N70 #30=#30+1
N80 END1
N85 G67
N90 M99
O9201 (DRILL: DEPTH Z, CLEARANCE R)
N10 G00 Z#18
N20 G01 Z#26 F#9
N30 G00 Z#18
N40 #100=#100+1
N50 M99
%
