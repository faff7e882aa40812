"""Reports on programs and runs, for people and for other programs: as text, JSON, HTML."""
