%@MACRO
// (SYNTEC: A PROGRAM IN THE LANGUAGE OF THE MAKER, WHICH BEGINS WITH %@MACRO)
// (cncsub run examples/syntec/macro_language.nc -c syntec-22ma)
// (ROWS OF HOLES: EVERY SECOND ROW IS SHIFTED BY HALF A PITCH.)
// (Look at 1/2, which is 0: whole numbers divide to a whole number, 1./2 is 0.5.)
G90 G94 G17 G49 G40 G80;
#1 := 10.;                      // PITCH
@1 := 0;                        // HOLES
FOR #2 := 0 TO 2 BY 1 DO
  IF #2 MOD 2 = 1 THEN
    #3 := #1 * (1. / 2);
  ELSEIF #2 = 0 THEN
    #3 := 0.;
  ELSE
    #3 := #1 * (1 / 2);
  END_IF;
  #4 := 0;
  REPEAT
    G0 X(#3 + #4 * #1) Y(#2 * #1);
    @1 := @1 + 1;
    #4 := #4 + 1;
    IF @1 >= 8 THEN
      EXIT;
    END_IF;
  UNTIL #4 >= 3 END_REPEAT;
END_FOR;
CASE @1 OF
  8:
    @2 := 1;
ELSE
  ALARM(20, "WRONG NUMBER OF HOLES");
END_CASE;
M30;
