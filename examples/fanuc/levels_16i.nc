%
O0008 (FOUR LEVELS OF SUBPROGRAMS, FOUR OF MACROS)
(cncsub run examples/fanuc/levels_16i.nc -c fanuc-16i)
(The 16i counts the two kinds of calls apart: four M98 and four G65 may be)
(open at one time. Here all eight are: look at the tree, the level of the)
(locals grows with the G65 only, and #100 is 8 at the end.)
(One call more, an M98 or a G65 in O18, would be 077 SUB PROGRAM NESTING)
(ERROR. The 0i-D and later allow ten and five, fifteen in all.)
N10 M98 P11
N20 M30
O0011
N11 #100=#100+1
N12 M98 P12
N13 M99
O0012
N11 #100=#100+1
N12 M98 P13
N13 M99
O0013
N11 #100=#100+1
N12 M98 P14
N13 M99
O0014
N11 #100=#100+1
N12 G65 P15 A1.
N13 M99
O0015
N11 #100=#100+1
N12 G65 P16 A[#1+1]
N13 M99
O0016
N11 #100=#100+1
N12 G65 P17 A[#1+1]
N13 M99
O0017
N11 #100=#100+1
N12 G65 P18 A[#1+1]
N13 M99
O0018
N11 #100=#100+1
N12 #101=#1(THE MACRO LEVEL: 4)
N13 M99
%
