"""Reports, coverage pages and plots have one look."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.pages import html_page

JOB = "O1\nN10 G0 X10. Y5.\nN20 M98 P2\nN30 M30\nO2\nN10 G1 X20. F100\nN20 M99\n"
KINDS = ("report", "coverage", "plot")


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    pytest.importorskip("plotly", reason="plotly is not installed")
    folder = tmp_path_factory.mktemp("pages")
    (folder / "job.nc").write_text(JOB)
    files = {kind: folder / f"{kind}.html" for kind in KINDS}
    for kind, file in files.items():
        option = "--html" if kind == "coverage" else "-o"
        asked = [kind, str(folder / "job.nc"), "-c", "fanuc-0i-f", option, str(file)]
        done = CliRunner().invoke(app, asked)
        assert done.exit_code == 0, done.output
    return files


def style_of(page: Any, scheme: str) -> list[str]:
    page.emulate_media(color_scheme=scheme)
    names = "['backgroundColor', 'color', 'fontFamily', 'fontSize']"
    told: list[str] = page.evaluate(
        f"['body', 'h1', 'nav b'].flatMap(of => {names}.map("
        "name => getComputedStyle(document.querySelector(of))[name]))"
    )
    return told


def test_the_pages_have_one_look_dark_and_light(browser: Any, pages: dict[str, Path]) -> None:
    looks = []
    for kind, file in pages.items():
        page = browser.new_page(viewport={"width": 1200, "height": 800})
        page.goto(file.as_uri())
        assert page.locator("nav b").inner_text() == f"cncsub {kind}"
        looks.append((style_of(page, "light"), style_of(page, "dark")))
        assert looks[-1][0] != looks[-1][1]
        page.close()
    assert looks == [looks[0]] * len(KINDS)


def test_the_pages_allow_nothing_from_elsewhere(pages: dict[str, Path]) -> None:
    for file in pages.values():
        text = file.read_text(encoding="utf-8")
        assert "default-src 'none'" in text
        assert re.search(r"(src|href)=\"(?!#)", text) is None


def test_texts_of_a_page_are_escaped() -> None:
    text = html_page("<b>", "<i>", ["<p>body</p>"], parts=[("a", "<u>")])
    assert "<title>&lt;b&gt;</title>" in text
    assert "<i>" not in text
    assert "<u>" not in text
    assert text.count("<b>") == 1  # of the header
    assert '<a href="#a">&lt;u&gt;</a>' in text
    assert "<p>body</p>" in text


def test_a_plot_without_a_script_shows_a_drawing_and_a_text(
    browser: Any, pages: dict[str, Path]
) -> None:
    page = browser.new_page(java_script_enabled=False)
    page.goto(pages["plot"].as_uri())
    assert page.locator("noscript svg").count() == 1
    assert "shown: rapid, feed" in page.locator("noscript").inner_text()
    page.close()
    run = cncsub.loads(JOB, control="fanuc-0i-f").run()
    assert run.svg() in pages["plot"].read_text(encoding="utf-8")
