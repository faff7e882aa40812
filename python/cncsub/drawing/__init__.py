"""What pictures show of a path, and the drawings that need no library: SVG."""
