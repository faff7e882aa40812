"""The number of examples of the property tests (HYPOTHESIS_PROFILE=ci takes few, for slow builds),
and the browser that looks at pages.
"""

import os
import shutil
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import settings

# Where everything is checked, a failure must repeat: random programs are made elsewhere only.
AGAIN = "CI" in os.environ
settings.register_profile("full", deadline=None, max_examples=200, derandomize=AGAIN)
settings.register_profile("ci", deadline=None, max_examples=25, derandomize=AGAIN)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "full"))


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """Yield Chromium as it is installed. The libraries of the sanitizers, which are loaded first in
    each of their processes, are not for it.
    """
    found = shutil.which("chromium") or shutil.which("google-chrome")
    if found is None:
        pytest.skip("no Chromium is installed (Debian: apt-get install chromium)")
    api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    args = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    own = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
    with api.sync_playwright() as playwright:
        made = playwright.chromium.launch(executable_path=found, args=args, env=own)
        yield made
        made.close()
