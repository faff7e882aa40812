"""How many examples the property tests take: HYPOTHESIS_PROFILE=ci takes few, for slow builds."""

import os

from hypothesis import settings

settings.register_profile("full", deadline=None, max_examples=200)
settings.register_profile("ci", deadline=None, max_examples=25)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "full"))
