"""The report as a person opens it: in a browser, on a desktop and on a phone, and on paper.

Needs Chromium (Debian's package is `chromium`) and the Python package `playwright`, whose own
browsers are not used. Screenshots are kept, and their paths are printed.
"""

import os
import re
import shutil
import sys
import tempfile
from contextlib import contextmanager
from itertools import combinations
from pathlib import Path

import pytest
from filelock import FileLock
from page_cases import of_example, of_friction

from exoid.report.page import SECTIONS, write_page

pytestmark = pytest.mark.slow

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
DESKTOP, PHONE = {"width": 1280, "height": 900}, {"width": 390, "height": 844}
SMALLEST = {"width": 360, "height": 740}
SHEETS = 5  # of A4
PATIENCE = 60_000  # ms, for a machine that does other things as well
OPENED = 6.0  # times what a hundred million multiplications take: two seconds at a third of one
LOADS = 3  # at most: one that is fast enough tells what the page needs
MULTIPLIED = """() => {
  for (let each = 0, made = 1; each < 1e8; each++) made = Math.imul(made, 1664525) + 1;
}"""
PAPER = 703  # pixels between the margins of A4
RANGE = "document.querySelector('#motion-0 .plot').layout.xaxis.range"
FIRST_FIGURE = """() => new Promise((resolve) => {
  const drawn = () => document.querySelector(".plot .main-svg") && resolve();
  new MutationObserver(drawn).observe(document, { childList: true, subtree: true });
  drawn();
})"""


@pytest.fixture(scope="module")
def browser():
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="playwright is not installed: pip install playwright"
    )
    program = next(filter(None, map(shutil.which, BROWSERS)), None)
    if program is None:
        pytest.skip("no Chromium is installed: on Debian, apt-get install chromium")
    with playwright.sync_playwright() as driver:
        started = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield started
        started.close()


@pytest.fixture(
    scope="module", params=["example", pytest.param("friction", marks=pytest.mark.proof)]
)
def report(request, common):
    """The page of the bundled example, or that of a leg with dry friction: one worker makes it."""
    path = common / f"{request.param}.html"
    with FileLock(path.with_suffix(".lock")):
        if not path.exists():
            write_page({"example": of_example, "friction": of_friction}[request.param](), path)
    return path


@pytest.fixture(scope="session")
def screenshots():
    """A folder that stays: EXOID_SCREENSHOTS, or one of this run."""
    named = os.environ.get("EXOID_SCREENSHOTS")
    folder = Path(named) if named else Path(tempfile.mkdtemp(prefix="exoid-screenshots-"))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@contextmanager
def opened(browser, path, size, **options):
    """The page with all figures drawn, what its console said, and what it asked the network for."""
    context = browser.new_context(viewport=size, **options)
    page, said, asked = context.new_page(), [], []
    page.on("console", lambda message: said.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda fault: said.append(str(fault)))
    page.on("request", lambda request: asked.append(request.url))
    page.goto(path.as_uri())
    page.wait_for_selector("html.drawn", timeout=PATIENCE)
    yield page, said, asked
    context.close()


@pytest.fixture(scope="module")
def desktop(browser, report):
    with opened(browser, report, DESKTOP) as found:
        yield found


def range_of(page, name):
    return page.evaluate(f"document.querySelector('#{name} .plot').layout.xaxis.range")


def middle_of(page, name):
    """The middle of a figure's uppermost panel, in view."""
    panel = page.locator(f"#{name} .plot .nsewdrag").first
    panel.scroll_into_view_if_needed()
    box = panel.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, box["width"]


def test_it_opens_without_a_word_on_the_console_and_without_the_network(desktop, report):
    _, said, asked = desktop
    assert said == []
    assert [url for url in asked if not url.startswith(("data:", "blob:"))] == [report.as_uri()]


def test_every_section_is_there_and_filled(desktop, report):
    page, _, _ = desktop
    names = [each.get_attribute("id") for each in page.locator("main > section").all()]
    diagnosed = report.stem == "friction"
    left_out = () if diagnosed else ("parting", "physics", "proof")
    assert names == [each.name for each in SECTIONS if each.name not in left_out]
    for name in names:
        assert len(page.locator(f"#{name}").inner_text()) > 80
        assert page.locator(f"#{name}").bounding_box()["height"] > 100


def test_every_figure_is_drawn_with_marks_or_lines(desktop):
    page, _, _ = desktop
    figures = page.locator("figure").all()
    assert len(figures) >= 7
    for each in figures:
        assert each.locator(".main-svg").first.bounding_box()["height"] > 150
        assert each.locator(".main-svg .trace, .main-svg .bars .point").count() >= 1


def test_first_figure_is_seen_within_two_seconds(browser, report):
    """Seconds of a common computer, in which the page's thread computes."""
    taken = []
    for _ in range(LOADS):
        context = browser.new_context(viewport=DESKTOP)
        page = context.new_page()
        inside = context.new_cdp_session(page)
        inside.send("Performance.enable", {"timeDomain": "threadTicks"})
        page.goto(report.as_uri(), wait_until="commit")
        page.evaluate(FIRST_FIGURE)
        first = computed(inside)
        page.wait_for_selector("html.drawn", timeout=PATIENCE)
        drawn = computed(inside)
        page.evaluate(MULTIPLIED)
        taken.append(first / (computed(inside) - drawn))
        context.close()
        if taken[-1] < OPENED:
            return
    pytest.fail(f"no load took less than {OPENED} times: {taken}")


def computed(inside) -> float:
    """s of the page's thread so far."""
    counted = inside.send("Performance.getMetrics")["metrics"]
    return next(each["value"] for each in counted if each["name"] == "ThreadTime")


def test_a_zoom_of_one_segment_is_one_of_all(desktop):
    page, _, _ = desktop
    before = range_of(page, "motion-0")
    x, y, width = middle_of(page, "motion-0")
    page.mouse.move(x - width / 4, y)
    page.mouse.down()
    page.mouse.move(x, y, steps=5)
    page.mouse.up()
    page.wait_for_function(
        "document.querySelector('#motion-1 .plot').layout.xaxis.range[1] < "
        f"{before[0] + 0.8 * (before[1] - before[0])}"
    )
    zoomed = range_of(page, "motion-0")
    assert zoomed[1] - zoomed[0] == pytest.approx((before[1] - before[0]) / 4, rel=0.1)  # pixels
    assert range_of(page, "motion-1") == pytest.approx(zoomed)
    page.mouse.dblclick(x, y)
    page.wait_for_function(f"{RANGE}[1] > {zoomed[1]}")
    assert range_of(page, "motion-0") == pytest.approx(before)


def test_pointing_at_a_curve_tells_its_values(desktop):
    page, _, _ = desktop
    x, y, _ = middle_of(page, "motion-0")
    page.mouse.move(x - 40, y)
    page.mouse.move(x, y, steps=3)
    page.wait_for_selector("#motion-0 .hoverlayer text", timeout=PATIENCE)
    said = page.locator("#motion-0 .hoverlayer").text_content()
    for word in ("measured", "simulated", "simulated - measured", "deg"):
        assert word in said
    page.mouse.move(0, 0)


def test_keys_reach_the_content_and_zoom(browser, report):
    with opened(browser, report, DESKTOP) as (page, _, _):
        page.keyboard.press("Tab")
        assert page.evaluate("document.activeElement.className") == "skip"
        page.locator("#motion-0 .plot").focus()
        before = range_of(page, "motion-0")
        page.keyboard.press("+")
        page.wait_for_function(f"{RANGE}[1] < {before[1]}")
        page.keyboard.press("0")
        page.wait_for_function(f"{RANGE}[1] >= {before[1]}")
        page.locator("summary").first.focus()
        page.keyboard.press("Enter")
        assert page.locator("details").first.get_attribute("open") is not None


@pytest.fixture(scope="module")
def paper(browser, report):
    """A page as it is printed, once `beforeprint` is told."""
    with opened(browser, report, DESKTOP) as (page, said, _):
        page.emulate_media(media="print")
        yield page, said


def test_on_paper_no_figure_is_wider_than_the_page(paper):
    page, said = paper
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    widths = page.evaluate(
        "[...document.querySelectorAll('.plot .main-svg')].map("
        "  (each) => each.getBoundingClientRect().width)"
    )
    assert max(widths) <= PAPER + 1  # rounding
    assert page.locator("details:not([open])").count() == 0
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert said == []


def test_on_paper_no_name_of_an_axis_runs_into_another(paper):
    page, _ = paper
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    named = boxes(page, "[id^=motion] text[class$=title]")
    drawn = len(boxes(page, "figure[id^=motion]"))
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert len(named) == 5 * drawn > 0  # two quantities, two residuals, and the time
    assert not any(overlap(*pair) for pair in combinations(named, 2))


def test_it_prints_on_five_pages(paper, tmp_path):
    paper[0].pdf(path=tmp_path / "report.pdf", prefer_css_page_size=True)
    printed = (tmp_path / "report.pdf").read_bytes()
    assert 1 <= len(re.findall(rb"/Type\s*/Page\b", printed)) <= SHEETS


@pytest.fixture(scope="module", params=[True, False], ids=["touch", "mouse"])
def phone(request, browser, report):
    """As wide as a phone; with a mouse it is a narrow window."""
    with opened(browser, report, PHONE, is_mobile=request.param, has_touch=request.param) as found:
        yield found


def boxes(page, selector):
    """Left, top, right and bottom of all that is seen of these elements [pixels of the page]."""
    return page.evaluate(
        "(each) => [...document.querySelectorAll(each)].map((one) => one.getBoundingClientRect())"
        ".filter((box) => box.width && box.height)"
        ".map((box) => [box.left, box.top + scrollY, box.right, box.bottom + scrollY])",
        selector,
    )


def overlap(one, other):
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def test_a_phone_never_scrolls_sideways(phone):
    page, said, _ = phone
    assert page.evaluate("document.scrollingElement.scrollWidth") <= PHONE["width"]
    assert said == []


@pytest.mark.parametrize("selector", [".plot", ".plot .main-svg", ".xtick text", ".legendtext"])
def test_nothing_of_a_figure_is_cut_at_the_edge_of_a_phone(phone, selector):
    page, _, _ = phone
    found = boxes(page, selector)
    assert len(found) >= 7
    assert max(right for _, _, right, _ in found) <= PHONE["width"] + 0.5  # rounding
    assert min(left for left, *_ in found) >= -0.5


def test_buttons_of_a_figure_cover_neither_its_legend_nor_its_panels(phone):
    page, _, _ = phone
    for figure in page.locator("figure").all():
        name = figure.get_attribute("id")
        buttons = boxes(page, f"#{name} .modebar-group")
        shown = boxes(page, f"#{name} .legend .legendtext, #{name} .legend .legendpoints path")
        shown += boxes(page, f"#{name} .nsewdrag")
        assert buttons
        assert not [one for one in shown for button in buttons if overlap(one, button)], name


MORE_DROPS = """(each) => each.querySelectorAll("tr").forEach(
    (row) => row.append(...[...row.children].slice(-2).map((cell) => cell.cloneNode(true))))"""
AS_BEFORE = """(each) => each.querySelectorAll("tr").forEach(
    (row) => [...row.children].slice(-2).forEach((cell) => cell.remove()))"""


def test_a_desktop_shows_the_whole_table_of_two_drops_more(desktop):
    table = desktop[0].locator("#drops .wide").first
    table.evaluate(MORE_DROPS)
    inner, outer = table.evaluate("(each) => [each.scrollWidth, each.clientWidth]")
    table.evaluate(AS_BEFORE)
    assert inner <= outer


def test_a_phone_shows_every_value_of_every_table_without_scrolling(phone):
    page, _, _ = phone
    page.evaluate("document.querySelectorAll('details').forEach((each) => (each.open = true))")
    for table in page.locator(".wide").all():
        inner, outer = table.evaluate("(each) => [each.scrollWidth, each.clientWidth]")
        assert inner <= outer
    values = boxes(page, "#drops td")
    assert len(values) >= 20
    assert max(right for _, _, right, _ in values) <= PHONE["width"]


@pytest.mark.proof
def test_the_smallest_phone_never_scrolls_sideways(browser, report, screenshots, capfd):
    with opened(browser, report, SMALLEST, is_mobile=True, has_touch=True) as (page, said, _):
        assert page.evaluate("document.documentElement.scrollWidth") <= SMALLEST["width"]
        assert said == []
        keep(page, screenshots / f"{report.stem}-phone.png", capfd)


def test_a_picture_of_it_is_kept(desktop, report, screenshots, capfd):
    page, _, _ = desktop
    page.mouse.move(0, 0)
    page.evaluate("scrollTo(0, 0)")
    keep(page, screenshots / f"{report.stem}-desktop.png", capfd)


def keep(page, path, capfd):
    """A screenshot of all of it, its path on the log past pytest's capture."""
    page.screenshot(path=path, full_page=True)
    with capfd.disabled():
        print(f"\nscreenshot: {path}", file=sys.stderr)
    assert path.stat().st_size > 50_000
