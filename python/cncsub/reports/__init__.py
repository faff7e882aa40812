"""What is told of programs and of runs, for people and for other programs: as text, JSON, HTML."""
