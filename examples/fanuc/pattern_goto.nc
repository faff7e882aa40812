%
O0004 (GRID OF HOLES WITH GOTO)
(cncsub run examples/fanuc/pattern_goto.nc -c fanuc-0i-f)
(Shop style: jumps instead of loops, and a home-made subroutine: #140 holds)
(the block to return to, N900 drills, GOTO#140 returns. No call is open at)
(any time. Four columns, three rows: #100 is 12 at the end.)
N10 #1=0(COLUMN)
N20 #2=0(ROW)
N30 #100=0
N40 G90G00X0.Y0.Z10.
N50 G0X[#1*15.]Y[#2*10.]
N60 #140=80
N70 GOTO900
N80 #1=#1+1
N90 IF[#1LT4]GOTO50
N100 #1=0
N110 #2=#2+1
N120 IF[#2LT3]GOTO0050
N130 G0Z50.
N140 M30
N900 G1Z-5.F200.
N910 G0Z10.
N920 #100=#100+1
N930 GOTO#140
%
