%
O0002 (CALLS BY G, M AND T CODES)
(cncsub run examples/fanuc/code_calls.nc -c fanuc-0i-f --param 6050=70 --param 6051=71 --param 6071=60 --param 6080=50 --param 6001#5=1)
(Source 002: the parameters make G70, G71, M60, M50 and every T code call)
(O9010, O9011, O9001, O9020 and O9000. None of these codes reaches the)
(machine, but for T5 inside O9000 and M60 inside O9020: a program that was)
(called by a code takes the codes as they are. M60 shares #1 with this)
(program, G70, G71 and M50 have locals of their own: #1 is 7 at the end.)
(Without the parameters N20 stops with alarm PS0010.)
N10 #1=6
N20 G70 A1. B2.
N30 G71 X10. L2
N40 M60
N50 M50 A3.
N60 T5
N70 M30
O9000 (T: THE CODE IS IN #149)
N10 T#149
N20 M06
N30 M99
O9001 (M60: A SUBPROGRAM)
N10 #1=#1+1
N20 M99
O9010 (G70: A MACRO)
N10 #500=#1+#2
N20 M99
O9011 (G71: A MACRO, TWICE)
N10 #501=#501+#24
N20 M99
O9020 (M50: A MACRO)
N10 #502=#1
N20 M60
N30 M99
%
