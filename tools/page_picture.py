"""Takes the picture of the page for trying programs that the README shows: docs/pictures/page.png

python tools/page_picture.py    # after `sh tools/playground.sh`, with playwright, Chromium, Pillow
"""

from __future__ import annotations

import io
import shutil
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "build" / "playground" / "page" / "index.html"
PICTURE = ROOT / "docs" / "pictures" / "page.png"
SIZE = {"width": 1180, "height": 640}
COLOURS = 48  # what text and lines need

PROGRAM = """\
O0001 (A ROW OF POCKETS)
N10 G90 G54 G0 X0 Y0
N20 M98 P2 L3
N30 G0 X0 Y60.
N40 M98 P2 L0
N50 G0 X0 Y0
N60 M30
O0002 (ONE OF THEM)
N70 G91 G1 X30. F300.
N80 G3 X0 Y30. I0 J15.
N90 G1 X-30.
N100 G3 X0 Y-30. I0 J-15.
N110 G0 X60.
N120 G90 M99
"""


def picture() -> bytes:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium"), args=["--no-sandbox"]
        )
        page = browser.new_page(viewport=SIZE, color_scheme="light")
        page.goto(PAGE.as_uri())
        page.wait_for_selector("body[data-stop][data-state=idle]")
        page.evaluate(
            "text => { $('second').value = 'mitsubishi-m700';"
            " show([{ name: 'pockets.nc', text }]); run(); }",
            PROGRAM,
        )
        page.wait_for_function("compared !== null")
        page.wait_for_selector("body[data-state=idle]")
        taken = page.screenshot()
        browser.close()
    return taken


def main() -> None:
    image = Image.open(io.BytesIO(picture())).convert("RGB").quantize(COLOURS)
    image.save(PICTURE, optimize=True)
    print(f"{PICTURE}: {PICTURE.stat().st_size >> 10} KiB")


if __name__ == "__main__":
    main()
