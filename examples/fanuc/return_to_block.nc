%
O0007 (RETURN TO A BLOCK OF THE CALLER)
(cncsub run examples/fanuc/return_to_block.nc -c fanuc-0i-f)
(M99 P returns to a block of the calling program: the subprogram decides)
(whether N20 runs. #101 is 1, #100 is 2 at the end. With block skip on, the)
(slash hides N30, and N10 runs only once.)
N10 M98 P8
N20 #101=#101+1
/N30 IF[#101 LT 1]GOTO10
N40 M30
O0008
N10 #100=#100+1
N20 IF[#100 GE 2]GOTO40
N30 M99 P30
N40 M99
%
