%
O0020 (TWO EQUAL PROFILES, ONE SUBPROGRAM)
(cncsub run examples/fanuc/milling.nc -c fanuc-0i-f)
(The milling example of source 003, restored, with decimal points.)
(O10 is incremental and comes back to where it began, so the second call)
(cuts the same profile 50 mm further up. O10 leaves G91 in force: that is)
(why N60 and N80 begin with G90. Take the G90 of N60 away and look where)
(the second profile goes.)
(The tool: D01 = 3 mm radius, H01 = 50 mm length, as in milling.toml.)
(With a radius above 5 the tool does not fit the arcs N40 and N50 of O10.)
N10 G54 G90 G17 M03 S600
N20 G00 X0. Y0.
N30 G43 G00 Z5. H01
N40 G01 Z-3. F50.
N50 M98 P10
N60 G90 Y50.
N70 M98 P10
N80 G90 G49 Z50.
N90 M05
N100 M30
O0010 (ONE PROFILE)
N10 G41 G91 G01 X30. Y-5. D01 F50.
N20 Y5.
N30 G02 X20. I10.
N40 X-10. I-5.
N50 G03 X-10. I-5.
N60 G00 Y-5.
N70 G40 X-30. Y5.
N80 M99
%
