%
O0009 (Q STARTS A SUBPROGRAM AT A BLOCK)
(cncsub run examples/fanuc/start_block_0i_d.nc -c fanuc-0i-d --param 6005#0=1)
(With parameter 6005#0 = 1 M98 P2000 Q30 calls O2000 from its N30. Look at)
(the tree: the second call starts at N30, three times, and leaves out the)
(tool and the approach. #100 is 1 and #101 is 4 at the end.)
(Without the parameter Q is no start block: every pass begins at the head of)
(O2000, and #100 is 4.)
N10 G90 G00 X0. Y0. Z50.
N20 M98 P2000
N30 M98 P2000 Q30 L3
N40 G90 G00 Z50.
N50 M30
O2000 (A ROW OF SLOTS)
N10 #100=#100+1(APPROACHES)
N20 G90 G00 X10. Y10. Z2.
N30 #101=#101+1(SLOTS)
N40 G91 G01 Z-4. F80.
N50 X20. F200.
N60 G00 Z4.
N70 X-20. Y12.
N80 M99
%
