"""Entries of the lists of a control that no other row needs: codes, letters, marks, one by one.

Each entry is one line: `stands` writes its claim, which says no more than the line.
"""

import re

import cncsub
from conformance import case

MILL = {"machine": "mill", "start": {"X": 0, "Y": 0, "Z": 10}, "radius_offsets": {1: 3}}
LATHE = {"machine": "lathe-a", "start": {"X": 40, "Z": 10}}
LISTS = {
    "code-with-macro-call": "codes_not_with_macro_call",
    "m-code-with-macro-call": "m_codes_not_with_macro_call",
    "code-with-modal-call": "codes_not_with_modal_call",
    "illegal-word-with-call": "codes_not_with_call",
    "named-program-not-found": "name_marks",
}


def listed(control, block, alarm):
    """Return the rule of a control whose list has the code or letter of the block."""
    written = re.sub(r"(?s).*\n(N[0-9]+ )?", "", block)
    name = LISTS.get(alarm)
    if name is None and re.match(r"[A-Z]-[0-9]", written):
        name = "minus_addresses"
    elif name is None and re.match(r"[A-FH-Z][0-9]*\.", written):
        name = "point_addresses"
    return next(rule for rule in cncsub.controls[control].rules if rule.name == (name or "g_codes"))


def stands(block, controls, setup=MILL, alarm=None, number=None, **outcome):
    """Write a row of a block that is in the list: it runs, or alarms for a reason of its own."""
    controls = controls.split()
    what = f"alarms as {alarm}" if alarm else "runs"
    blocks = re.findall(r"N[12]0", f"N10 {block}")
    if alarm is None:
        outcome.setdefault("runs", " ".join([*blocks, "N30"]))
    else:
        outcome = {"runs": " ".join(blocks[:-1]), "at": f"O1 {blocks[-1]}"} | outcome
        if alarm == "code-not-computed":
            outcome.setdefault("word", re.findall(r"G[0-9.]+", block)[-1])
    where = f"{'a lathe' if setup is LATHE else 'a mill'} of {controls[0]} and {len(controls) - 1} more"
    case(
        f"{' / '.join(block.split(chr(10)))} {what} on {where}",
        control=controls, source={c: listed(c, block, alarm).source for c in controls},
        evidence={c: str(listed(c, block, alarm).evidence) for c in controls},
        setup=setup, program=f"O1\nN10 {block}\nN30 M30\nO2\nN40 M99\n", alarm=alarm,
        number=number and {name: number.get(name) for name in controls},
        **outcome,
    )


# G codes of the lists
stands("G6.3", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G7", "gsk-988ta gsk-988t", LATHE, alarm="code-not-computed")
stands("G7.1", "gsk-988ta gsk-988t gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G7.2", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G7.3", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G7.9", "gsk-988ta gsk-988t", LATHE, alarm="code-not-computed")
stands("G9", "gsk-988ta gsk-988t", LATHE)
stands("G11", "gsk-980tdi", LATHE)
stands("G10 L2 P1 X1.\nG11", "gsk-988ta gsk-988t", LATHE)
stands("G13.1", "gsk-988t", LATHE)
stands("G18", "gsk-980tdi", LATHE)
stands("G21", "gsk-980tdi", LATHE)
stands("G23", "gsk-988ta gsk-988t", LATHE)
stands("G25", "gsk-988ta gsk-988t", LATHE)
stands("G26", "gsk-988ta gsk-988t", LATHE)
stands("G29", "gsk-988ta gsk-988t", LATHE, alarm="no-intermediate", word="G29")
stands("G32.2", "gsk-988ta gsk-988t gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G32.3", "gsk-988ta gsk-988t gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G33", "gsk-988ta gsk-988t", LATHE, alarm="code-not-computed")
stands("G37", "gsk-980tdi", LATHE, alarm="measuring-axis", word="G37")
stands("G50.2", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G50.3", "gsk-988ta gsk-988t", LATHE)
stands("G51.2", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G56", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G57", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G58", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G59", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G61", "gsk-988ta gsk-988t", LATHE)
stands("G69", "gsk-988ta gsk-988t", LATHE)
stands("G74.1", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G75.1", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G80", "gsk-980tdi", LATHE)
stands("G83.1", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G83.2", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G84", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G84.1", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G84.2", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G87", "gsk-988t gsk-980tdi", LATHE)
stands("G87.1", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G88", "gsk-988ta gsk-988t gsk-980tdi", LATHE)
stands("G88.1", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G89", "gsk-988ta gsk-988t", LATHE)
stands("G92.2", "gsk-988ta gsk-988t", LATHE, alarm="code-not-computed")
stands("G92.3", "gsk-980tdi", LATHE, alarm="code-not-computed")
stands("G1.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G2.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-30i", alarm="code-not-computed")
stands("G2.3", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-30i", alarm="code-not-computed")
stands("G2.4", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands("G3.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-30i", alarm="code-not-computed")
stands("G3.2", "fanuc-16i fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G3.3", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-30i", alarm="code-not-computed")
stands("G3.4", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands("G4.1", "fanuc-30i", alarm="code-not-computed")
stands("G5.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G5.4", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G7", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-30i", alarm="code-not-computed")
stands("G7.1", "gsk-980mdi", alarm="code-not-computed")
stands(
    "G9",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands("G10.3", "fanuc-30i", alarm="code-not-computed")
stands("G10.6", "fanuc-16i fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G10.9", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G10 L2 P1 X1.\nG11", "gsk-980mdi")
stands("G12.4", "fanuc-30i", alarm="code-not-computed")
stands("G13", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G13.4", "fanuc-30i", alarm="code-not-computed")
stands("G14", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G15", "gsk-980mdi mitsubishi-meldas mitsubishi-m800")
stands("G17.1", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G22.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G23.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands(
    "G24",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i",
    alarm="code-not-computed",
)
stands("G25", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G26", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G28.2", "fanuc-30i", alarm="code-not-computed")
stands("G30.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G30.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands("G30.3", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G30.4", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G30.5", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G30.6", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G31.1", "fanuc-16i", alarm="code-not-computed")
stands(
    "G31.1 Z5.", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="no-skip-feed",
    word="G31.1",
    number=dict.fromkeys(("mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"), "P603"),
)
stands("G31.2", "fanuc-16i", alarm="code-not-computed")
stands(
    "G31.2 Z5.", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="no-skip-feed",
    word="G31.2",
    number=dict.fromkeys(("mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"), "P603"),
)
stands("G31.3", "fanuc-16i", alarm="code-not-computed")
stands(
    "G31.3 Z5.", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="no-skip-feed",
    word="G31.3",
    number=dict.fromkeys(("mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"), "P603"),
)
stands("G31.8", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G31.9", "fanuc-30i", alarm="code-not-computed")
stands(
    "G35",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-f fanuc-30i",
    alarm="code-not-computed",
)
stands("G36", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G37", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands(
    "G37.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="measuring-axis", word="G37.1",
    number=dict.fromkeys(("mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"), "P604"),
)
stands("G37.1", "fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G37.2", "fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G37.3", "fanuc-30i", alarm="code-not-computed")
stands("G38", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G39", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G41.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands("G41.3", "fanuc-30i", alarm="code-not-computed")
stands("G41.4", "fanuc-30i", alarm="code-not-computed")
stands("G41.5", "fanuc-30i", alarm="code-not-computed")
stands("G41.6", "fanuc-30i", alarm="code-not-computed")
stands(
    "G42.1",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i",
    alarm="code-not-computed",
)
stands("G42.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands("G42.4", "fanuc-30i", alarm="code-not-computed")
stands("G42.5", "fanuc-30i", alarm="code-not-computed")
stands("G42.6", "fanuc-30i", alarm="code-not-computed")
stands("G43.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands("G43.3", "fanuc-30i", alarm="code-not-computed")
stands("G43.5", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands("G43.7", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G43.8", "fanuc-30i", alarm="code-not-computed")
stands("G43.9", "fanuc-30i", alarm="code-not-computed")
stands("G44", "hnc-21m")
stands("G44.1", "fanuc-30i", alarm="code-not-computed")
stands("G44.7", "fanuc-30i", alarm="code-not-computed")
stands("G49.1", "fanuc-30i", alarm="code-not-computed")
stands("G50", "gsk-980mdi hnc-21m")
stands("G50.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G50.3", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G50.4", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G50.5", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G50.6", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G50.9", "fanuc-30i", alarm="code-not-computed")
stands("G51.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G51.4", "fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G51.5", "fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G51.6", "fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G53.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G53.2", "fanuc-30i", alarm="code-not-computed")
stands("G53.6", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G54.2", "fanuc-16i fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G54.3", "fanuc-30i", alarm="code-not-computed")
stands("G54.4", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-30i", alarm="code-not-computed")
stands(
    "G57",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands(
    "G58",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands(
    "G59",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands("G61", "gsk-980mdi hnc-21m")
stands("G61.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G61.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands(
    "G62",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i",
    
)
stands("G62.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands(
    "G63",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i",
    
)
stands("G63.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G63.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G64", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 hnc-21m")
stands("G68.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G68.3", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G68.4", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G69", "gsk-980mdi")
stands("G69.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-0i-f fanuc-30i")
stands("G70.7", "fanuc-30i", alarm="code-not-computed")
stands("G71.7", "fanuc-30i", alarm="code-not-computed")
stands("G72.1", "fanuc-16i fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G72.2", "fanuc-16i fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G72.7", "fanuc-30i", alarm="code-not-computed")
stands("G73.7", "fanuc-30i", alarm="code-not-computed")
stands("G74", "hnc-21m")
stands("G74.7", "fanuc-30i", alarm="code-not-computed")
stands("G75.7", "fanuc-30i", alarm="code-not-computed")
stands("G76", "gsk-980mdi hnc-21m")
stands("G76.7", "fanuc-30i", alarm="code-not-computed")
stands("G77", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G78", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G79", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G80.4", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G80.5", "fanuc-0i-f fanuc-30i")
stands("G80.8", "fanuc-30i", alarm="code-not-computed")
stands("G81.1", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G81.4", "fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G81.5", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G81.8", "fanuc-30i", alarm="code-not-computed")
stands("G82", "gsk-980mdi mitsubishi-meldas mitsubishi-m800 fanuc-0i-d fanuc-0i-f hnc-21m")
stands("G83.1", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G83.5", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G83.6", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G84", "hnc-21m")
stands("G84.2", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G84.3", "fanuc-16i fanuc-30i", alarm="code-not-computed")
stands("G85", "gsk-980mdi")
stands("G86", "hnc-21m")
stands("G87", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-0i-d hnc-21m")
stands("G87.5", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G87.6", "fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands(
    "G88",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands("G89", "gsk-980mdi mitsubishi-meldas mitsubishi-m800 fanuc-0i-d fanuc-0i-f hnc-21m")
stands("G91.1", "fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G92.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f")
stands("G93", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G96", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G96.1", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G96.2", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G96.3", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G96.4", "fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G107", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands(
    "G112",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i",
    alarm="code-not-computed",
)
stands("G113", "gsk-980mdi")
stands("G114", "gsk-980mdi", alarm="code-not-computed")
stands("G114.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G114.2", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G114.3", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G115", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G116", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G117", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G118", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G119", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G120.1", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands("G121", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G122", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800", alarm="code-not-computed")
stands("G126", "gsk-980mdi", alarm="code-not-computed")
stands("G127", "gsk-980mdi", alarm="code-not-computed")
stands("G132", "gsk-980mdi", alarm="code-not-computed")
stands("G133", "gsk-980mdi", alarm="code-not-computed")
stands("G134", "gsk-980mdi", alarm="code-not-computed")
stands("G135", "gsk-980mdi", alarm="code-not-computed")
stands("G136", "gsk-980mdi", alarm="code-not-computed")
stands("G137", "gsk-980mdi", alarm="code-not-computed")
stands("G138", "gsk-980mdi", alarm="code-not-computed")
stands("G139", "gsk-980mdi", alarm="code-not-computed")
stands("G141", "gsk-980mdi", alarm="pattern-without-cycle", word="G141", number={"gsk-980mdi": "0216"})
stands("G142", "gsk-980mdi", alarm="pattern-without-cycle", word="G142", number={"gsk-980mdi": "0216"})
stands("G143", "gsk-980mdi", alarm="pattern-without-cycle", word="G143", number={"gsk-980mdi": "0216"})
stands("G144", "gsk-980mdi", alarm="pattern-without-cycle", word="G144", number={"gsk-980mdi": "0216"})
stands("G150", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G151", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G152", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G160", "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G161", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i", alarm="code-not-computed")
stands("G250", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")
stands("G251", "fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i")

# Addresses that take a point
stands("B1.", "gsk-928te", LATHE)
stands("E1.", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("H1.", "gsk-928te", LATHE)
stands("Q1.", "gsk-928te", LATHE)
stands("V1.", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("W1.", "gsk-928te", LATHE)
stands("Y1.", "gsk-928te", LATHE)
stands(
    "E1.",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands("H1.", "hnc-21m")
stands("P1.", "hnc-21m")
stands("V1.", "gsk-980mdi fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m")
stands(
    "V1.",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800",
    alarm="no-feed", word="V1.", number={"mitsubishi-meldas": "P62", "mitsubishi-m700": "P62", "mitsubishi-m800": "P62"},
)
stands("W1.", "gsk-980mdi hnc-21m")

# Addresses that take a minus sign
stands("A-1", "gsk-980tdi gsk-928te", LATHE)
stands("B-1", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("C-1", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("D-1", "gsk-928te", LATHE)
stands("E-1", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("F-1", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE, alarm="feed-out-of-range", word="F-1")
stands("H-1", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("I-1", "gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("J-1", "gsk-988t gsk-928te", LATHE)
stands("Q-1", "gsk-928te", LATHE)
stands("S-1", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("V-1", "gsk-988ta gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("W-1", "gsk-928te", LATHE)
stands("X-1", "gsk-928te", LATHE)
stands("Y-1", "gsk-988t gsk-980tdi gsk-928te", LATHE)
stands("A-1", "gsk-980mdi hnc-21m")
stands("B-1", "gsk-980mdi fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m")
stands(
    "B-1",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800",
    alarm="no-feed", word="B-1", number={"mitsubishi-meldas": "P62", "mitsubishi-m700": "P62", "mitsubishi-m800": "P62"},
)
stands("C-1", "gsk-980mdi fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m")
stands(
    "C-1",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800",
    alarm="no-feed", word="C-1", number={"mitsubishi-meldas": "P62", "mitsubishi-m700": "P62", "mitsubishi-m800": "P62"},
)
stands(
    "D-1",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 hnc-21m",
    alarm="radius-offset-number", word="D-1", number={"gsk-980mdi": "0020", "mitsubishi-meldas": "P170", "mitsubishi-m700": "P170", "mitsubishi-m800": "P170"},
)
stands(
    "E-1",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands(
    "F-1",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    alarm="feed-out-of-range", word="F-1", number={"gsk-980mdi": "0023"},
)
stands(
    "H-1",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    alarm="offset-number", word="H-1", number={"gsk-980mdi": "0016", "mitsubishi-meldas": "P170", "mitsubishi-m700": "P170", "mitsubishi-m800": "P170", "fanuc-16i": "030", "fanuc-0i-d": "PS0030", "fanuc-0i-f": "PS0030", "fanuc-30i": "PS0030"},
)
stands("J-1", "gsk-980mdi")
stands("Q-1", "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800")
stands(
    "S-1",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m",
    
)
stands("U-1", "gsk-980mdi fanuc-16i fanuc-0i-f fanuc-30i hnc-21m")
stands(
    "U-1",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800",
    alarm="no-feed", word="U-1", number={"mitsubishi-meldas": "P62", "mitsubishi-m700": "P62", "mitsubishi-m800": "P62"},
)
stands("V-1", "gsk-980mdi fanuc-16i fanuc-0i-d fanuc-0i-f fanuc-30i hnc-21m")
stands(
    "V-1",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800",
    alarm="no-feed", word="V-1", number={"mitsubishi-meldas": "P62", "mitsubishi-m700": "P62", "mitsubishi-m800": "P62"},
)
stands("W-1", "gsk-980mdi hnc-21m")

# `angle_words`
stands("G98 G1 X20. A-20. F100\nN20 Z-20.", "gsk-988ta gsk-988t", LATHE, time=52.028, final_work="X20 Z-20")

# `chamfer_words`
stands(
    "G98 G1 X20. C1. F100\nN20 Z-20.",
    "gsk-988ta gsk-988t fanuc-16i fanuc-0i-f fanuc-30i",
    LATHE, time=23.649, final_work="X20 Z-20",
)

# `codes_not_with_call`
stands("G4 M98 P2", "gsk-980tdi", LATHE, alarm="illegal-word-with-call", number={"gsk-980tdi": "0051"})
stands("G54.1 M98 P2", "gsk-980mdi", alarm="illegal-word-with-call", number={"gsk-980mdi": "0051"})

# `codes_not_with_macro_call`
stands(
    "G65 P2 G0",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G10",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G11",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G12.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G13.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G17",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G18",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G19",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G20",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G21",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G22",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G23",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G25",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G26",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G27",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G28",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G29",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G3",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G30",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G31",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G32",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G32.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G32.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G32.3",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G33",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G34",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G36",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G37",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G4",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G40",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G41",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G42",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G50",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G50.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G50.3",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G51.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G51.3",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G52",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G53",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G54",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G55",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G56",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G57",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G58",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G59",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G61",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G64",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G67",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G68",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G68.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G69",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G69.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G7",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G7.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G7.9",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G70",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G71",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G72",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G73",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G74",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G75",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G76",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G77",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G78",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G79",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G80",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G83",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G84",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G85",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G87",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G88",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G89",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G9",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G90",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G91",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G92",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G92.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G92.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G94",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G95",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G96",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G97",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G98",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G65 P2 G99",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-macro-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)

# `codes_not_with_modal_call`
stands(
    "G66 P2 G0",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G10",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G11",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G12.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G13.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G18",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G19",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G2",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G20",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G21",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G22",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G23",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G25",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G26",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G27",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G28",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G29",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G3",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G30",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G31",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G32",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G32.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G32.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G32.3",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G33",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G34",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G36",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G37", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"},
)
stands(
    "G66 P2 G37",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G4",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G40",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G41",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G42",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands("G66 P2 G5", "gsk-980tdi", LATHE, alarm="code-with-modal-call", number={"gsk-980tdi": "0044"})
stands(
    "G66 P2 G50",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G50.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G50.3",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G51.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G51.3",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G52",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G53",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G54",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G55",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G56",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G57",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G58",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G59",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands("G66 P2 G6.2", "gsk-980tdi", LATHE, alarm="code-with-modal-call", number={"gsk-980tdi": "0044"})
stands("G66 P2 G6.3", "gsk-980tdi", LATHE, alarm="code-with-modal-call", number={"gsk-980tdi": "0044"})
stands(
    "G66 P2 G61",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G64",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G67",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G68",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G68.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G69",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G69.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G7",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G7.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands("G66 P2 G7.2", "gsk-980tdi", LATHE, alarm="code-with-modal-call", number={"gsk-980tdi": "0044"})
stands("G66 P2 G7.3", "gsk-980tdi", LATHE, alarm="code-with-modal-call", number={"gsk-980tdi": "0044"})
stands(
    "G66 P2 G7.9",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G70",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G71",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G72",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G73",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G74",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G75",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G76",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G77",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G78",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G79",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G80",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G83",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G84",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G85",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G87",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G88",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G89",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G9",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G90",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G91",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G92",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G92.1",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G92.2",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G94",
    "gsk-988ta gsk-988t gsk-980tdi",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212", "gsk-980tdi": "0044"},
)
stands(
    "G66 P2 G95",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G96",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G97",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G98",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands(
    "G66 P2 G99",
    "gsk-988ta gsk-988t",
    LATHE, alarm="code-with-modal-call", number={"gsk-988ta": "212", "gsk-988t": "212"},
)
stands("G66 P2 G2", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G3", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G30", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G31", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G50", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G52", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G53", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G73", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G74", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G76", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G84", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G88", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G90", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G92", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})
stands("G66 P2 G94", "gsk-980mdi", alarm="code-with-modal-call", number={"gsk-980mdi": "0044"})

# `dwell_words`
stands("G4 U1.", "gsk-988ta gsk-988t gsk-928te", LATHE, time=1.0, final_work="X40 Z10")
stands(
    "G4 U1.",
    "gsk-980mdi mitsubishi-meldas mitsubishi-m700 mitsubishi-m800 hnc-21m",
    time=1.0, final_work="X0 Y0 Z10",
)

# `g_meanings`
stands("G46", "hnc-21m", alarm="g-code-not-available")
stands("G47", "hnc-21m", alarm="g-code-not-available")
stands("G48", "hnc-21m", alarm="g-code-not-available")

# `m_codes_not_with_macro_call`
stands("G65 P2 M0", "gsk-980tdi", LATHE, alarm="m-code-with-macro-call", number={"gsk-980tdi": "0116"})
stands("G65 P2 M1", "gsk-980tdi", LATHE, alarm="m-code-with-macro-call", number={"gsk-980tdi": "0116"})
stands("G65 P2 M2", "gsk-980tdi", LATHE, alarm="m-code-with-macro-call", number={"gsk-980tdi": "0116"})
stands("G65 P2 M98", "gsk-980tdi", LATHE, alarm="m-code-with-macro-call", number={"gsk-980tdi": "0116"})
stands("G65 P2 M99", "gsk-980tdi", LATHE, alarm="m-code-with-macro-call", number={"gsk-980tdi": "0116"})

# `modal_groups`
stands(
    "#100=#4019\nN20 X#100",
    "mitsubishi-meldas mitsubishi-m700 mitsubishi-m800",
    alarm="no-feed", word="X#100", number={"mitsubishi-meldas": "P62", "mitsubishi-m700": "P62", "mitsubishi-m800": "P62"},
)

# `name_marks`
stands(
    "M98 <A+B>",
    "mitsubishi-m700 mitsubishi-m800",
    alarm="named-program-not-found", number={"mitsubishi-m700": "P232", "mitsubishi-m800": "P232"},
)
stands(
    "M98 <A-B>",
    "mitsubishi-m700 mitsubishi-m800",
    alarm="named-program-not-found", number={"mitsubishi-m700": "P232", "mitsubishi-m800": "P232"},
)
stands(
    "M98 <A_B>",
    "mitsubishi-m700 mitsubishi-m800",
    alarm="named-program-not-found", number={"mitsubishi-m700": "P232", "mitsubishi-m800": "P232"},
)

# `round_words`
stands(
    "G98 G1 X20. R1. F100\nN20 Z-20.",
    "gsk-988ta gsk-988t fanuc-16i fanuc-0i-f fanuc-30i",
    LATHE, time=23.742, final_work="X20 Z-20",
)
