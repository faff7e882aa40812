"""How many examples the property tests take: HYPOTHESIS_PROFILE=ci takes few, for slow builds."""

import os

from hypothesis import settings

# What fails where everything is checked fails again: programs are made at random elsewhere only.
AGAIN = "CI" in os.environ
settings.register_profile("full", deadline=None, max_examples=200, derandomize=AGAIN)
settings.register_profile("ci", deadline=None, max_examples=25, derandomize=AGAIN)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "full"))
