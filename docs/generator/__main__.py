"""Writes the pages of the site, and what its builder needs, into a folder."""

import sys
from pathlib import Path

from generator.assembling import assemble

assemble(Path(sys.argv[1]))
