"""The page of a study as a person opens it: points that open people, a phone, no network.

Needs what `tests/report/test_page_in_browser.py` needs.
"""

import pytest
from benchmarks.studies.tables import Design, Truth, simulate
from test_page_in_browser import DESKTOP, PHONE, browser, opened  # noqa: F401

from exoid.report.parts.origin import Origin
from exoid.studies.page.page import write_page
from exoid.studies.page.parts.part import Told
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Asked

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "report.html"
    answers = ask(simulate(Design(people=16, drops=2), 0), Asked(by="group"))
    write_page(Told(answers, Origin("exoid study report", "today", {}, {}, {}), "results"), path)
    return path


def test_a_point_opens_its_person_and_nothing_asks_the_network(browser, report):  # noqa: F811
    with opened(browser, report, DESKTOP) as (page, said, asked):
        assert said == []
        assert [url for url in asked if not url.startswith(("data:", "blob:"))] == [report.as_uri()]
        point = page.locator("#people-relaxation_index .scatterlayer .trace path.point").first
        point.scroll_into_view_if_needed()
        box = point.bounding_box()
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.wait_for_selector("#people-relaxation_index .hovertext")
        hovered = page.locator("#people-relaxation_index .hovertext").first.text_content()
        page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.wait_for_selector("dialog[open]")
        who = page.locator("#person-title").inner_text()
        assert who in hovered
        assert page.locator("dialog tbody tr").count() == 4  # two days, two sides
        page.keyboard.press("Escape")
        assert not page.evaluate("document.getElementById('person').open")


def test_a_person_is_found_by_typing_and_fits_a_phone(browser, report):  # noqa: F811
    with opened(browser, report, PHONE) as (page, said, _):
        assert said == []
        # Nothing is wider than the phone: no sideways scrolling of the page.
        assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
        page.fill("#find", "sub-003")
        page.press("#find", "Enter")
        page.wait_for_selector("dialog[open]")
        assert page.locator("#person-title").inner_text() == "sub-003"
        box = page.locator("dialog").bounding_box()
        assert box["width"] <= PHONE["width"]
        page.locator("dialog button").click()
        assert not page.evaluate("document.getElementById('person').open")


def test_no_column_of_a_table_is_cut_off_on_a_screen(browser, tmp_path):  # noqa: F811
    long = Truth("peak_flexion_acceleration", "rad/s^2", 31.0, 4.0, 1.0, 0.2, 0.1, 0.4, 0.1)
    answers = ask(simulate(Design(people=16, drops=2, truths=(long,)), 0), Asked(by="group"))
    report = tmp_path / "report.html"
    write_page(Told(answers, Origin("exoid study report", "today", {}, {}, {}), "results"), report)
    with opened(browser, report, {"width": 1280, "height": 800}) as (page, _, _):
        wider = "each => each.scrollWidth > each.clientWidth + 1"
        cut = f"[...document.querySelectorAll('main .wide')].filter({wider}).length"
        assert page.evaluate(cut) == 0
