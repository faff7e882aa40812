"""The page of a run: complete in itself, escaped, bounded, with links that lead somewhere."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.drawing.path import Path as DrawnPath
from cncsub.drawing.path import path_of
from cncsub.drawing.svg import MOST_LINKED, MOST_POINTS

CONTROL = "fanuc-0i-f"
JOB = """O1 (PART <b>)
N10 G0 X0 Y0 Z5.
N20 G65 P2 A3. B0.5
N25 M98 P3 L2
N30 G1 Z-2. F100 M3 M8
N40 G2 X20. Y0 I10.
N50 M98 P9 (<script>alert 1</script>)
O2
N60 IF[#1 LT 0] GOTO 70
N65 G0 X#1
N70 M99
O3
N80 G91 G0 X1.
N90 M98 P2
N95 G90
N99 M99
"""
_VOID = {"meta", "link", "br"}


class Page(HTMLParser):
    """The ids, the links, the addresses and the balance of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.addresses: list[str] = []
        self.open: list[str] = []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if name == "id":
                self.ids.append(value or "")
            elif name == "href":
                self.links.append(value or "")
            elif name in ("src", "action"):
                self.addresses.append(value or "")
        if tag not in _VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        pass

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def page_of(text: str, control: str = CONTROL, **options: Any) -> str:
    library = cncsub.loads(text, control=control, name="job.nc")
    return cncsub.report(library, library.run(**options))


def test_every_link_leads_to_a_place_of_the_page_and_none_elsewhere() -> None:
    page = Page(page_of(JOB))
    assert len(page.ids) == len(set(page.ids))
    assert {link[1:] for link in page.links} - set(page.ids) == set()
    assert page.addresses == []
    assert "f0-l7" in page.ids


def test_the_page_tells_the_stop_the_cure_the_calls_and_their_arguments() -> None:
    page = page_of(JOB)
    shown = re.sub(r"<[^>]*>", "", page)
    assert "stopped: alarm, after 22 blocks" in shown
    assert "PS0076 program-not-found" in shown
    assert cncsub.causes["program-not-found"].cure in shown
    assert "G65 O2 A=3 B=0.5 from O1 N20" in shown
    assert "M98 O3, 2 passes from O1 N25" in shown
    assert "CS201 O9 is not in the memory" in shown
    assert "never taken" in shown


def test_texts_of_programs_are_escaped() -> None:
    page = page_of(JOB)
    assert "<script>alert" not in page
    assert "(&lt;script&gt;alert 1&lt;/script&gt;)" in page


def test_a_run_of_another_library_is_refused() -> None:
    one, other = (cncsub.loads(JOB, control=CONTROL) for _ in range(2))
    with pytest.raises(ValueError, match="another library"):
        cncsub.report(one, other.run())


def test_an_empty_run_is_a_page() -> None:
    assert "The program called nothing." in page_of("O1\nM30\n")


def test_a_program_too_long_is_cut_and_said_so_but_its_findings_are_shown() -> None:
    text = "O1\n" + "G1 X1. F100\nX2.\n" * 4_000 + "M98 P9\n"
    page = page_of(text)
    assert re.search(r"\.\.\. [\d,]+ blocks", page)
    Page(page)
    assert "M98 P9</td>" in page
    assert len(page) < 2_000_000


def test_calls_alike_are_one_line_and_none_is_lost() -> None:
    text = "O1\nM98 P2\nM98 P3\nM30\nO2\nWHILE[#1LT3000]DO1\n#1=#1+1\nG65 P4 A#1\nEND1\nM99\n"
    page = page_of(text + "O3\nM99\nO4\nM99\n")
    tree = page[page.index('<ul class="tree">') : page.index('<section id="path">')]
    shown = re.sub(r"<[^>]*>", "", tree)
    assert "G65 O4 A=1 (the first; they differ) x 3,000 from O2 line 8" in shown
    assert "M98 O3 from O1 line 3" in shown
    assert tree.count("<li>") == 3
    Page(page)


def test_of_many_programs_the_short_ones_are_shown_whole_and_the_long_ones_alike() -> None:
    long = "O1\nM98 P2\nM98 P3\nM98 P4\n" + "G4 X1.\n" * 4_000 + "M30\n"
    long += "".join(f"O{number}\n" + "G4 X1.\n" * 3_000 + "M99\n" for number in (2, 3))
    page = page_of(long + "O4\n#100=1\n#101=2\nM99\n")
    assert "<td>#101=2</td>" in page
    cut = [int(left.replace(",", "")) for left in re.findall(r"\.\.\. ([\d,]+) blocks", page)]
    assert [4_004 - cut[0], 3_001 - cut[1], 3_001 - cut[2]] == [1_666, 1_665, 1_666]


def path_drawn(run: cncsub.Run, coordinates: str = "work") -> DrawnPath:
    return path_of(run.recorded, coordinates, linked=MOST_LINKED, most=MOST_POINTS)


def test_arcs_are_round_and_x_of_a_lathe_is_a_radius() -> None:
    turn = "O1\nG0 X0 Z0\nG1 F100 X20.\nG3 X40. Z-10. R10.\nM30\n"
    path = path_drawn(cncsub.loads(turn, control="gsk-988ta").run())
    assert path.diameters
    arc = path.points[path.moves == 2]
    assert len(arc) >= 9
    assert np.allclose(np.hypot(arc[:, 0] - 10, arc[:, 2] + 10), 10)
    mill = "O1\nG0 X0 Y0\nG2 X0 Y0 I10. Z-4. F100\nM30\n"
    path = path_drawn(cncsub.loads(mill, control=CONTROL).run())
    circle = path.points[path.moves == 1]
    assert not path.diameters
    assert np.allclose(np.hypot(circle[:, 0] - 10, circle[:, 1]), 10)
    assert circle[:, 0].max() == pytest.approx(20, abs=0.01)
    assert circle[:, 1].max() == pytest.approx(10, abs=0.01)  # clockwise from the left: above first
    assert circle[len(circle) // 4, 1] > 0
    assert circle[-1].tolist() == [0, 0, -4]


def points_of(caption: str, page: str) -> list[int]:
    found = re.search(caption, page)
    assert found
    return [int(number.replace(",", "")) for number in found.groups()]


def test_a_long_path_is_thinned_and_says_so() -> None:
    fine = "".join(f"X{i * 0.01:.2f} Y{i % 5 * 0.01:.2f}\n" for i in range(40_000))
    page = page_of(f"O1\nG1 F100\n{fine}M30\n")
    kept, whole = points_of(r"Thinned: ([\d,]+) of ([\d,]+) points; what is left out lies", page)
    assert kept <= MOST_POINTS < whole == 40_001
    assert "nothing after move" not in page


def test_a_path_that_cannot_be_thinned_is_cut_and_says_so() -> None:
    wide = "".join(f"X{i * i * 31 % 9973} Y{i * i * i % 9967}\n" for i in range(40_000))
    page = page_of(f"O1\nG1 F100\n{wide}M30\n")
    behind, whole = points_of(r"nothing after move ([\d,]+) of ([\d,]+)", page)
    assert behind < whole == 40_000


def test_the_command_writes_the_page_and_keeps_the_status(tmp_path: Path) -> None:
    (tmp_path / "job.nc").write_text(JOB)
    file = tmp_path / "report.html"
    done = CliRunner().invoke(
        app, ["report", str(tmp_path / "job.nc"), "-c", CONTROL, "-o", str(file)]
    )
    assert done.exit_code == 1
    assert f"wrote {file}" in done.stdout
    assert "PS0076" in done.stderr
    Page(file.read_text(encoding="utf-8"))
    asked = CliRunner().invoke(app, ["report", str(tmp_path / "job.nc"), "-c", CONTROL])
    assert asked.exit_code == 2


# ---- in a browser ----


def opened(browser: Any, tmp_path: Path, width: int) -> tuple[Any, list[str]]:
    file = tmp_path / "report.html"
    file.write_text(page_of(JOB), encoding="utf-8")
    page = browser.new_page(viewport={"width": width, "height": 800})
    told: list[str] = []
    page.on("console", lambda message: told.append(message.text))
    page.on("pageerror", lambda error: told.append(str(error)))
    page.on("request", lambda request: request.url.startswith("file:") or told.append(request.url))
    page.goto(file.as_uri())
    return page, told


def test_heads_sort_links_lead_and_keys_walk(browser: Any, tmp_path: Path) -> None:
    page, told = opened(browser, tmp_path, 1200)
    heads = page.locator("h3:has-text('variables') + div th button")
    cells = page.locator("h3:has-text('calls') + div tbody td:first-child")
    head = page.locator("h3:has-text('calls') + div th button").first
    head.focus()
    page.keyboard.press("Enter")
    assert cells.first.text_content() == "0"
    page.keyboard.press("Enter")
    assert int(cells.first.text_content()) == cells.count() - 1
    assert heads.count() in (0, 2)
    page.locator("#f0-l7").evaluate("row => row.closest('details').open = false")
    page.get_by_text("to the block").click()
    assert page.locator("#f0-l7").is_visible()
    page.evaluate("location.hash = ''")
    page.keyboard.press("n")
    assert "mark" in page.evaluate("document.activeElement.className")
    page.locator("svg a").first.dispatch_event("click")
    assert page.evaluate("location.hash").startswith("#f0-l")
    assert told == []
    page.close()


def test_the_code_and_the_drawing_have_one_cursor(browser: Any, tmp_path: Path) -> None:
    page, told = opened(browser, tmp_path, 1400)
    code, path = page.locator("#code").bounding_box(), page.locator("#path").bounding_box()
    assert code["x"] >= path["x"] + path["width"]  # the code stands beside the path
    cursor = page.locator("#path > figure circle.cursor")
    assert not cursor.is_visible()
    row = page.locator("#f0-l6")  # N40 G2 X20. Y0
    row.hover()
    assert cursor.is_visible()
    lines = page.locator('#path > figure svg a[href="#f0-l6"]')
    assert "here" in lines.first.get_attribute("class")
    end = page.evaluate(
        "() => document.querySelector('svg a[href=\"#f0-l6\"] polyline').getAttribute('points')"
    ).rpartition(" ")[2]
    assert [cursor.get_attribute(name) for name in ("cx", "cy")] == end.split(",")
    page.locator('svg a[href="#f0-l5"]').first.dispatch_event("pointerenter")
    assert page.locator(".code tr.here").get_attribute("id") == "f0-l5"
    assert told == []
    page.close()


def test_a_block_of_a_long_path_is_found_on_the_drawing() -> None:
    page = page_of("O1\nG1 F100\n" + "".join(f"X{i}.\n" for i in range(1_500)) + "M30\n")
    assert "<polyline" not in page  # too many for a link each
    assert len(re.findall(r'data-at="[\d.]+ [\d.]+"', page)) == 1_500


@pytest.mark.parametrize("width", [360, 1200])
def test_no_width_scrolls_sideways(browser: Any, tmp_path: Path, width: int) -> None:
    page, told = opened(browser, tmp_path, width)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert told == []
    page.close()


def test_the_tool_is_drawn_in_machine_coordinates_where_it_goes_another_way() -> None:
    text = "O1\nG54 G0 X0 Y0\nG1 X10. Y5. F100\nG55 G0 X0 Y0\nG1 X10. Y5.\nM30\n"
    library = cncsub.loads(text, control=CONTROL)
    setup = cncsub.Setup(work_offsets={"G54": {"X": 0}, "G55": {"X": 100}})
    page = cncsub.report(library, library.run(setup=setup))
    Page(page)
    assert "<summary>The tool in machine coordinates" in page
    assert "parts may overlap" in page
    drawn = re.findall(r"<svg.*?</svg>", page)
    assert len(drawn) == 2
    assert [svg.count("<polyline") for svg in drawn] == [4, 4]
    path = path_drawn(library.run(setup=setup), "machine")
    assert path.points[:, 0].tolist() == [0, 0, 10, 100, 110]
    assert "in machine coordinates" not in cncsub.report(library, library.run())
