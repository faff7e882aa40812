"""LinuxCNC: words that no code of their line uses, and numbers below zero."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}


def unused(line, word):
    case(f"no code of its line uses {word}: {line}", **RUN, program=f"N10 {line}\nN20 M2",
         runs="", alarm="address-not-usable", word=word)


# A loop writes these rows, which are all alike: the interpreter has a list of the words.
for _line, _word in (
    ("G0 X1 P1", "P1"), ("G0 X1 Q1", "Q1"), ("G0 X1 R1", "R1"), ("G0 X1 I1", "I1"), ("G0 X1 J1", "J1"), ("G0 X1 K1", "K1"),
    ("G0 X1 L1", "L1"), ("G0 X1 H1", "H1"), ("G0 X1 D1", "D1"), ("G0 X1 E1", "E1"), ("G40 D1", "D1"), ("M5 P1", "P1"),
    ("G81 X1 Z-1 R1 Q1 F1", "Q1"), ("G1 X1 F1 R1", "R1"), ("G80 X1", "X1"),
):
    unused(_line, _word)

case("in a mode that uses it a word needs no code", **RUN,
     program="N10 G2 X1 I0.5 F100\nN20 X0 I-0.5\nN30 G81 X1 Z-1 R1\nN40 X2 R1\nN50 G80 M2", runs="N10 N20 N30 N40 N50")
case("a code that is computed may use any word", **RUN, program="N10 G[4] P0\nN20 M2", runs="N10 N20")
case("two codes do not both take the axes", **RUN,
     program="N10 G0 G28 X1\nN20 M2", runs="", alarm="one-shot-with-motion", word="G28")
for _line, _word in (("F-1", "F-1"), ("S-1", "S-1"), ("T-1", "T-1"), ("G91 G81 X1 Z-1 R1 L-1 F1", "L-1")):
    case(f"{_word} is below zero", **RUN, program=f"N10 {_line}\nN20 M2", runs="", alarm="value-out-of-range", word=_word)
