(GRBLHAL: A SUBPROGRAM WITH ARGUMENTS AND A VALUE, A LOOP AND A BRANCH)
(LOOK AT: THE TREE OF CALLS, AND THE MESSAGES AFTER EACH ROW OF HOLES)
(RUN: cncsub run examples/grblhal/holes.nc -c grblhal)
G21 G90 G17 G94
G0 X0 Y0 Z5
o100 sub (count, pitch, depth)
  #<i> = 0
  o10 while [#<i> LT #1]
    G0 X[#<i> * #2]
    o11 if [#<i> EQ 0]
      G1 Z[-#3 / 2] F50 (the first hole is half as deep)
    o11 else
      G1 Z-#3 F100
    o11 endif
    G0 Z5
    #<i> = [#<i> + 1]
  o10 endwhile
o100 endsub [#31] (what it gives back is computed with the caller's parameters)

#<_holes> = 0
#31 = 4
o20 repeat [3]
  o100 call [#31] [12.5] [3]
  #<_holes> = [#<_holes> + #<_value>]
  (MSG, a row is done)
  (PRINT, holes so far: %d#<_holes>)
  G0 Y[#5421 + 10]
o20 endrepeat
M2
