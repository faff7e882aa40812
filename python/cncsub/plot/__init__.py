"""Pictures, drawn by plotly (`cncsub[plot]`), which is imported when one is asked for."""
