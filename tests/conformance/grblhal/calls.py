"""grblHAL: M98, M99 and G65 with the macros of files."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHm, macro_execute; gHg, gc_execute_block", "evidence": "source document"}

case("M98 calls the file of its number, whose end returns", **RUN,
     files={"main.nc": "N10 M98 P200\nN20 G0 X2\nN30 M30\n", "P200.macro": "N40 G0 X1\n"}, runs="N10 N40 N20 N30", moves_x=[1, 2])
case("M99 returns before", **RUN,
     files={"main.nc": "N10 M98 P200\nN20 M30\n", "P200.macro": "N40 G0 X1\nN50 M99\nN60 G0 X9\n"}, runs="N10 N40 N50 N20", moves_x=[1])
case("L counts the passes", **RUN,
     files={"main.nc": "N10 M98 P200 L2\nN20 M30\n", "P200.macro": "N40 G91 G0 X1\nN50 M99\n"}, runs="N10 (N40 N50)*2 N20", moves_x=[1, 2])
case("eight bits of it", **RUN,
     files={"main.nc": "N10 M98 P200 L258\nN20 M30\n", "P200.macro": "N40 G0 X1\nN50 M99\n"}, runs="N10 (N40 N50)*2 N20")
case("L0 is L1", pins="zero_repeats", **RUN,
     files={"main.nc": "N10 M98 P200 L0\nN20 M30\n", "P200.macro": "N40 G0 X1\nN50 M99\n"}, runs="N10 N40 N50 N20")
case("the other words of its line come first", **RUN,
     files={"main.nc": "N10 G0 X5 M98 P200\nN20 M30\n", "P200.macro": "N40 G0 X1\nN50 M99\n"}, moves_x=[5, 1])
case("P is cut where it is computed", pins="call_values", **RUN,
     files={"main.nc": "N10 #1=200.7\nN20 M98 P#1\nN30 M30\n", "P200.macro": "N40 G0 X1\nN50 M99\n"}, moves_x=[1])
case("P is the number of the file, and no count", pins="program_word max_program_digits", **RUN,
     files={"main.nc": "N10 M98 P20100\nN20 M30\n", "P20100.macro": "N40 G0 X1\n", "P100.macro": "N50 G0 X2\n"}, moves_x=[1])
case("#1 to #30 are the caller's", **RUN,
     files={"main.nc": "N10 #1=5\nN20 M98 P200\nN30 G0 X#1\nN40 M30\n", "P200.macro": "N50 #1=[#1+1]\n"}, moves_x=[6])
case("M98 needs P, as grblHAL has it", **RUN,
     program="N10 M98 L2\nN20 M30", runs="", alarm="program-number-missing", number="error:28", at="MAIN N10")
case("of at most 65535", **RUN,
     program="N10 M98 P70000\nN20 M30", runs="", alarm="illegal-program-number", number="error:39", at="MAIN N10", word="P70000")
case("and at least 100", **RUN,
     program="N10 M98 P50\nN20 M30", runs="", alarm="illegal-program-number", number="error:39", at="MAIN N10", word="P50")
case("the macros of the control's own are not computed", **RUN,
     program="N10 G65 P3 I100\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word="P3")
case("a file that is not there is not opened", **RUN,
     program="N10 M98 P300\nN20 M30", runs="", alarm="program-not-found", number="error:84", at="MAIN N10", word="P300")
case("P beside M99 is used by nothing", **RUN,
     files={"main.nc": "N10 M98 P200\nN5 M30\n", "P200.macro": "N40 G0 X1\nN50 M99 P5\n"},
     runs="N10 N40", alarm="address-not-usable", number="error:36", at="P200 N50", word="P5")
case("M99 starts the main program over", pins="main_return", control="grblhal", source="gHs, onProgramCompleted", evidence="source document",
     program="N10 G0 X1\nN20 M99\nN30 G0 X2", runs="N10 N20", stop="cycles")
case("M30 in a file that is called ends the run", pins="end_in_subprogram", **RUN,
     files={"main.nc": "N10 M98 P200\nN20 G0 X2\nN30 M30\n", "P200.macro": "N40 G0 X1\nN50 M30\n"}, runs="N10 N40 N50", moves_x=[1])
case("a call loses what its line assigns to numbers", **RUN,
     files={"main.nc": "N10 #1=1\nN20 #1=5 M98 P200\nN30 G0 X#1\nN40 M30\n", "P200.macro": "N50 G0 Y#1\n"}, moves="R Y1\nR X1",
     dropped=["#1=5"])

case("G65 gives its words to the macro", pins="roles:G65=macro-call", **RUN,
     files={"main.nc": "N10 G65 P200 A1 D7 X24\nN20 M30\n", "P200.macro": "N40 G0 X#1\nN50 G0 X#7\nN60 G0 X#24\n"}, moves_x=[1, 7, 24])
case("P of G65 too", pins="max_macro_digits", **RUN,
     files={"main.nc": "N10 G65 P20100\nN20 M30\n", "P20100.macro": "N40 G0 X1\n"}, moves_x=[1])
case("a computed count keeps eight bits too", **RUN,
     files={"main.nc": "N10 #1=258\nN20 M98 P200 L#1\nN30 M30\n", "P200.macro": "N40 G0 X1\nN50 M99\n"}, runs="N10 N20 (N40 N50)*2 N30")
case("a macro may call its caller", pins="caller_call", **RUN,
     files={"main.nc": "N10 G65 P200\nN20 M30\n", "P200.macro": "N30 #100=[#100+1]\no1 if [#100 LT 3]\nN40 G65 P201\no1 endif\n",
            "P201.macro": "N50 G65 P200\n"}, vars={100: 3})
case("calls of subprograms and macros count together", pins="nesting_counts_macros", control="grblhal", source="gHp, ngc_call_push",
     evidence="source document",
     files={"main.nc": "o100 sub\nN10 #31=[#31+1]\no2 if [#31 LT 9]\nN20 o100 call\no2 else\nN30 G65 P200\no2 endif\no100 endsub\n"
            "N40 o100 call\nN50 M30\n", "P200.macro": "N60 #100=[#100+1]\nN70 G65 P200\n"},
     main="main", vars={31: 9, 100: 1}, alarm="nesting-too-deep", number="error:82")
case("every letter has a number", **RUN,
     files={"main.nc": "N10 G65 P200 A1 B2 C3 D4 E5 F6 H7 I8 J9 K10 M11 Q12 R13 S14 T15 U16 V17 W18 X19 Y20 Z21\nN20 M30\n",
            "P200.macro": "".join(f"N{i} #{100 + i}=#{i}\n" for i in (*range(1, 10), 11, 13, *range(17, 27)))},
     vars={101: 1, 102: 2, 103: 3, 107: 4, 108: 5, 109: 6, 111: 7, 104: 8, 105: 9, 106: 10, 113: 11, 117: 12, 118: 13, 119: 14, 120: 15,
           121: 16, 122: 17, 123: 18, 124: 19, 125: 20, 126: 21})
case("the macro has locals of its own", **RUN,
     files={"main.nc": "N10 #1=5\nN20 #2=6\nN30 G65 P200 A1\nN40 G0 X#1\nN50 M30\n", "P200.macro": "N60 G0 Y#1 Z#2\n"}, moves="R Y1 Z0\nR X5")
case("which stay from pass to pass", **RUN,
     files={"main.nc": "N10 G65 P200 L3 A1\nN20 M30\n", "P200.macro": "N40 G0 X#1\nN50 #1=[#1+1]\n"}, moves_x=[1, 2, 3])
case("other G codes of its line do not count", **RUN,
     files={"main.nc": "N10 G0 X1\nN20 G91 G65 P200\nN30 X5\nN40 M30\n", "P200.macro": "N50 G0 Y1\n"}, moves="R X1\nR Y1\nR X5")
case("five macros may be open", pins="max_macro_nesting self_call", **RUN,
     files={"main.nc": "N10 G65 P200\nN20 M30\n", "P200.macro": "N40 #100=[#100+1]\nN50 G65 P200\n"}, vars={100: 5},
     alarm="macro-nesting-too-deep", number="error:82")
for code in ("G66", "G66.1"):
    case(f"the calls of {code} are not computed", **RUN,
         files={"main.nc": f"N10 {code} P200 A1\nN20 G0 X1\nN30 M30\n", "P200.macro": "N40 G0 Y1\n"}, runs="", alarm="code-not-computed", at="main N10")
case("G67 ends none of them", **RUN,
     program="N10 G67\nN20 G0 X1\nN30 M2", moves_x=[1])
