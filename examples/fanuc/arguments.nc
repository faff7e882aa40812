%
O0001 (ARGUMENTS OF A MACRO CALL)
(cncsub run examples/fanuc/arguments.nc -c fanuc-0i-f)
(The calls of source 002. Look at the variables #500 to #517 at the end:)
(#500-#506 are 30 45 50 -58 100 -200 -80, the arguments by letter.)
(#510 #511 #514 #517 are 30 45 -3 5: I-3. goes to #4, I4. and D5. both)
(go to #7, and the later word stays. With --param 6008#7=1 there are no)
(sets of I J K: I4. overwrites I-3., and #514 is 4.)
N10 G65 P9100 A30. B45. I50. R-58. X100. Y-200. Z-80.
N20 G65 P9101 A30. B45. I-3. I4. D5.
N30 M30
O9100 (BY LETTER)
N10 #500=#1
N20 #501=#2
N30 #502=#4
N40 #503=#18
N50 #504=#24
N60 #505=#25
N70 #506=#26
N80 M99
O9101 (MIXED)
N10 #510=#1
N20 #511=#2
N30 #514=#4
N40 #517=#7
N50 M99
%
