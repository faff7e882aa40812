"""Okuma OSP of machining centers: fixed cycles, which are not computed."""

from conformance import case

POST = {"control": "okuma-osp-p300", "source": "OKP, the codes that it writes", "evidence": "secondary"}

case("the level of G71 is not computed", **POST,
     program="O1\nN10 G71 Z20\nN20 M02", runs="", alarm="code-not-computed", at="O1 N10", word="G71")
for code in ("71", "73", "74", "76", "81", "82", "83", "84", "85", "86", "87", "89"):
    case(f"G{code} is a cycle that is not computed", pins="g_codes", **POST,
         program=f"O1\nN10 G0 Z50\nN20 G{code} X1 Y2 Z-5 R2 F100 M53\nN30 M02", runs="N10", alarm="code-not-computed", at="O1 N20", word=f"G{code}")
