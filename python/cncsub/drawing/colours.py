"""The colours of drawings and plots, which are legible on white and on black."""

from __future__ import annotations

FAMILIES = {  # of moves
    "rapid": "#d9534f",
    "feed": "#3d8fd6",
    "canned cycle": "#2fa36b",
    "radius compensation": "#b565d8",
}
ALARM, HOLE, TOOL_CHANGE = "#e5484d", "#2fa36b", "#c9820a"  # marks
TEXT = "#7a858e"
