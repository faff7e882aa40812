"""SINUMERIK: the entries of its lists of G codes, one by one."""

from conformance import case

GROUPS = {
    "control": "siemens-one",
    "source": "NCI, ggroups.json: the G groups of the manual",
    "evidence": "secondary",
}

# These rows are written by loops: a row each would say nothing but the number of the code.
_NEUTRAL = """9 290 40 41 42 60 62 64 93 110 111 112 140 141 142 143 340 341 450 451 460 601 602 603 621 641 642
    643 644 645"""
_SYSTEMS = "54 55 56 57 500"
_PLANES = "17 18 19"
_NOT_COMPUTED = """5 7 25 26 147 148 247 248 291 335 336 347 348 461 462 931 942
    952 962 972"""
_SURFACE = {"96", "961"}
_CHANGED = {5, 25, 26}  # differ from those of FANUC

for number in (*f"{_NEUTRAL} {_SYSTEMS} {_PLANES} 34 35 94 95 96 97 961 971 973".split(), *range(505, 600)):
    case(
        f"G{number} of a SINUMERIK runs", pins="g_codes", **GROUPS,
        program=f"N10 G{number}{' S100' if number in _SURFACE else ''}\nN20 M30", runs="N10 N20",
    )
for number in (*_NOT_COMPUTED.split(), *range(810, 830)):
    case(
        f"G{number} of a SINUMERIK is not computed", pins="g_meanings" if int(number) in _CHANGED else "g_codes", **GROUPS,
        program=f"N10 G{number}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word=f"G{number}",
    )
