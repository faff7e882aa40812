%
O0006 (HOW OFTEN IS IT CALLED)
(cncsub run examples/fanuc/repeats.nc -c fanuc-0i-f)
(The last four digits of P are the program, the digits before them the)
(count. #101 counts the passes of O1001, #102 those of O5001, #103 those of)
(O63: 5, 1 and 6 at the end. P5001 has four digits: it is O5001, once, and)
(not O1, five times.)
N10 M98 P51001
N20 M98 P5001
N30 M98 P20062
N40 M30
O1001
N10 #101=#101+1
N20 M99
O5001
N10 #102=#102+1
N20 M99
O0062
N10 M98 P63 L3
N20 M99
O0063
N10 #103=#103+1
N20 M99
%
