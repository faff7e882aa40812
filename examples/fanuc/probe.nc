%
O0005 (PROBING MACRO THAT CHECKS ITS ARGUMENTS)
(cncsub run examples/fanuc/probe.nc -c fanuc-0i-f)
(This example ends in alarm MC3092: the bore of the second call is out of)
(tolerance. A call without D would end in MC3091. Look at the frames of the)
(alarm: O9810 N920, called from O5 N40.)
(D nominal diameter, S measured diameter, H tolerance; #135 is the deviation.)
N10 G90 G00 X0. Y0. Z20.
N20 #500=30.004(STANDS FOR WHAT A PROBE WOULD HAVE MEASURED)
N30 G65 P9810 D30. S#500 H0.02
N40 G65 P9810 D30. S[#500+0.05] H0.02
N50 M30
O9810 (DEVIATION OF A BORE)
N10 IF[#7 EQ #0]GOTO910
N20 IF[#11 NE #0]GOTO40
N30 #11=0.05(DEFAULT TOLERANCE)
N40 #135=#19-#7
N50 IF[ABS[#135] GT #11]GOTO920
N60 M99
N910 #3000=91(DIAMETER MISSING)
N920 #3000=92(OUT OF TOLERANCE)
%
