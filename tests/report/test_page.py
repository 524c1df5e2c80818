"""The report: one file with every section, nothing of which a file's text can break."""

import base64
import json
import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from html_tree import parse, rows
from page_cases import made_up, of_friction, of_length, of_nothing
from test_saved_result import check_same

from exoid.files.visible import visible
from exoid.fitting.misfit.uncertainty import Shares
from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.subject import Subject
from exoid.report.document.diagnosis_json import diagnosis_document
from exoid.report.document.fit_json import fit_document
from exoid.report.figures.marks import MOST
from exoid.report.page import SECTIONS, build_page, write_page
from exoid.report.parts.case import Case
from exoid.report.saved.saved_result import load_result, save_result
from exoid.report.sections.quality import described
from exoid.report.sections.summary import LOST
from exoid.report.words.drop import unit_of, value
from exoid.report.words.text import in_degrees, with_error
from exoid.report.words.typeset import tidy, typeset

LARGEST = 6_000_000  # bytes
DIAGNOSED = ("parting", "physics", "proof")
HOSTILE = '</script><script>alert(1)</script><img src=x onerror=alert(2)> & "it\'s" {{ 7 * 7 }}'


@pytest.fixture(scope="module")
def diagnosed():
    """A leg with dry friction, and its page."""
    case = of_friction()
    return case, parse(build_page(case))


@pytest.fixture(scope="module")
def quick():
    """A fit without a diagnosis, and its page."""
    case = made_up()
    return case, parse(build_page(case))


def figure(page, name):
    """The JSON of a figure."""
    return json.loads(page.by_id(name).all("script")[0].text)


def decoded(values):
    """Numbers as plotly packs them."""
    if isinstance(values, list):
        return np.array(values)
    return np.frombuffer(
        base64.b64decode(values["bdata"]), {"f4": "<f4", "f8": "<f8"}[values["dtype"]]
    )


def traces(page, name):
    return {each["name"]: each for each in figure(page, name)["data"]}


def document(case):
    return fit_document(case.fit, version="0", recordings=[], settings={})


def test_every_section_is_there_in_order_with_a_heading_and_content(diagnosed):
    _, page = diagnosed
    sections = page.all("main")[0].all("section")
    assert [each.attributes["id"] for each in sections] == [each.name for each in SECTIONS]
    for each, of in zip(sections, SECTIONS, strict=True):
        assert each.all("h2")[0].text == of.title
        assert len(each.text) > len(of.title) + 40


@pytest.mark.proof
def test_a_page_of_a_leg_that_lacks_nothing_has_every_section_too():
    case = of_nothing()
    assert case.diagnosis is not None
    assert case.diagnosis.verdict == "none"
    page = parse(build_page(case))
    assert [each.attributes["id"] for each in page.all("section")] == [s.name for s in SECTIONS]


def test_a_fit_alone_has_no_section_of_a_diagnosis(quick):
    _, page = quick
    names = [each.attributes["id"] for each in page.all("section")]
    assert names == [each.name for each in SECTIONS if each.name not in DIAGNOSED]
    assert "exoid diagnose" in page.by_id("advice").text


def test_navigation_reaches_every_section(diagnosed):
    _, page = diagnosed
    links = [each.attributes["href"] for each in page.all("nav")[0].all("a")]
    assert links == [f"#{each.name}" for each in SECTIONS]
    skip = page.all("body")[0].all("a")[0]
    assert page.by_id(skip.attributes["href"].removeprefix("#")).tag == "main"


def test_headings_never_skip_a_level(diagnosed):
    _, page = diagnosed
    levels = [int(each.tag[1]) for each in page.all("h1", "h2", "h3", "h4")]
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert max(after - before for before, after in pairwise(levels)) == 1


def test_every_figure_says_what_it_shows_and_has_a_caption(diagnosed):
    _, page = diagnosed
    figures = page.all("figure")
    assert len(figures) >= 12
    for each in figures:
        (plot,) = each.of_class("plot")
        assert len(plot.attributes["aria-label"]) > 40
        assert len(each.all("figcaption")[0].text) > 20
        assert plot.attributes["tabindex"] == "0"


def test_no_two_elements_share_a_name(diagnosed):
    _, page = diagnosed
    names = [each.attributes["id"] for each in page if "id" in each.attributes]
    assert len(names) == len(set(names))


def test_every_table_names_its_columns_and_rows(diagnosed):
    _, page = diagnosed
    for table in page.all("table"):
        assert table.all("caption")[0].text
        assert all(each.text for each in table.all("thead")[0].all("th"))
        for row in table.all("tbody")[0].all("tr"):
            assert row.all("th")[0].attributes["scope"] == "row"


@pytest.mark.parametrize("place", ["notes", "name", "noticed", "segment", "setting", "command"])
def test_text_of_a_file_stays_text(place, quick):
    case = made_up(
        notes=HOSTILE if place == "notes" else None, name=HOSTILE if place == "name" else "leg.csv"
    )
    if place == "noticed":
        case = replace(case, sources=(replace(case.sources[0], notes=(HOSTILE,)),))
    if place == "segment":
        named = [replace(each, name=f"{HOSTILE} {each.name}") for each in case.fit.segments]
        case = replace(case, fit=replace(case.fit, segments=named))
    if place == "setting":
        case = replace(case, origin=replace(case.origin, settings={HOSTILE: HOSTILE}))
    if place == "command":
        case = replace(case, origin=replace(case.origin, command=HOSTILE))
    page = parse(build_page(case))
    for tag in ("script", "img"):
        assert len(page.all(tag)) == len(quick[1].all(tag))
    assert HOSTILE in page.all("body")[0].text


@pytest.mark.parametrize("place", ["notes", "name"])
def test_control_characters_of_a_file_are_shown_on_the_page(place):
    page = build_page(made_up(**{place: "red \x1b[31m, backwards \u202e"}))
    assert visible(page, "\n\t") == page
    assert r"red \u001b[31m, backwards \u202e" in page


def test_nothing_is_loaded_from_anywhere(diagnosed):
    _, page = diagnosed
    for each in page:
        for name in ("src", "href", "action", "data", "poster", "srcset"):
            assert each.attributes.get(name, "#").startswith("#")
    style = page.all("style")[0].text
    assert not re.search(r"@import|url\(", style)
    (policy,) = [each for each in page.all("meta") if "http-equiv" in each.attributes]
    assert policy.attributes["content"].startswith("default-src 'none';")


def test_the_library_of_figures_is_there_once(diagnosed):
    _, page = diagnosed
    packed = [each for each in page.all("script") if len(each.text) > 500_000]
    assert len(packed) == 1


@pytest.mark.proof
def test_the_file_is_small_however_long_the_recording(diagnosed):
    case, _ = diagnosed
    stretched = of_length(replace(case, told=None), samples=4_000, segments=20)
    long = build_page(stretched)
    assert len(long.encode()) < LARGEST
    one = traces(parse(long), "motion-0")["measured"]
    assert decoded(one["x"]).size <= MOST
    assert "One sample in 3 is drawn" in parse(long).by_id("motion-0").text


def test_a_fit_that_does_not_follow_says_so_first_and_calls_nothing_good():
    case = made_up()
    lost = replace(case.fit, astray="the simulated leg does not move as the measured one")
    lost = replace(lost, notes=["the model does not follow this recording", *lost.notes])
    summary = parse(build_page(replace(case, fit=lost))).by_id("summary")
    cards = summary.of_class("card")
    assert "None of its numbers is shown" in cards[0].text
    assert not summary.of_class("good")
    assert "good" not in summary.text
    assert {row["how far to believe it"] for row in rows(summary.all("table")[0])} == {LOST}


@pytest.mark.parametrize("by_hand", [None, "prior", "bound"])
def test_what_one_kind_of_segment_told_is_measured(by_hand):
    case = made_up()
    told = Shares(data=0.99, prior=0.01, bound=0.0, kind="passive")
    ratios = {
        name: replace(each, shares=told, by_hand=by_hand) for name, each in case.fit.ratios.items()
    }
    page = parse(build_page(replace(case, fit=replace(case.fit, ratios=ratios))))
    shown = {row["symbol"]: row for row in rows(page.by_id("summary").all("table")[0])}
    assert "measured" in shown["m l g / J"]["how far to believe it"]
    set_by = {row["symbol"]: row for row in rows(page.by_id("parameters").all("table")[1])}
    assert set_by["m l g / J"]["set by"] == "data (passive) 99%, prior 1%"


def test_title_and_every_table_say_who_it_is_and_which_side():
    case = made_up()
    (source,) = case.sources
    known = replace(source.recording.subject, id="P07", side="right", session="2026-03-02")
    named = replace(source, recording=replace(source.recording, subject=known))
    page, who = (
        parse(build_page(replace(case, sources=(named,)))),
        "P07, right leg, session 2026-03-02",
    )
    assert who in page.all("title")[0].text
    assert who in page.all("h1")[0].text
    captions = [each.text for each in page.all("caption")]
    assert captions
    assert all(each.startswith(f"{who}: ") for each in captions)


def test_parameters_and_ratios_are_those_of_the_json(diagnosed):
    case, page = diagnosed
    found = document(case)
    tables = page.by_id("parameters").all("table")
    shown = {row["symbol"]: row["value"] for table in tables[:2] for row in rows(table)}
    for each in (*found["parameters"].values(), *found["ratios"].values()):
        if each["value"] is not None:
            assert each["standard_error"] is not None
            written = with_error(each["value"], each["standard_error"])
            assert shown[each["symbol"]] == tidy(f"{written} {each['unit']}")


def test_what_nothing_determines_says_so_with_its_reason(quick):
    _, page = quick
    shown = {row["symbol"]: row["value"] for row in rows(page.by_id("parameters").all("table")[0])}
    assert shown["m"] == "not determined"
    assert "motion shows only m l" in page.by_id("parameters").text
    assert "not determined" in page.by_id("summary").text


def test_drawn_parameters_are_those_of_the_json(diagnosed):
    case, page = diagnosed
    found = [each for each in document(case)["parameters"].values() if each["value"] is not None]
    data = figure(page, "parameters-figure")["data"]
    chosen = [each for each in data if each["name"] == "chosen ± standard error"]
    for mark, each in zip(chosen, found, strict=True):
        np.testing.assert_allclose(decoded(mark["x"]), [each["value"]], rtol=1e-6)  # float32
        assert mark["error_x"]["array"] == [each["standard_error"]]


def test_drawn_motion_is_measured_simulated_and_their_difference(quick):
    case, page = quick
    each, found = case.fit.segments[0], traces(page, "motion-0")  # the last of a name: velocity
    for name, samples in (
        ("measured", each.angular_velocity),
        ("simulated", each.simulated_velocity),
        ("simulated - measured", each.simulated_velocity - each.angular_velocity),
    ):
        drawn = decoded(found[name]["y"])
        np.testing.assert_allclose(drawn, np.degrees(samples), rtol=1e-6, atol=1e-6)  # float32
        np.testing.assert_allclose(decoded(found[name]["x"]), each.time, rtol=1e-6)


def test_panels_of_a_segment_share_one_time_axis(quick):
    _, page = quick
    drawn = figure(page, "motion-0")
    assert {each.get("xaxis", "x") for each in drawn["data"]} == {"x"}
    assert len({each["yaxis"] for each in drawn["data"]}) == 4
    groups = {plot.attributes["data-linked"] for plot in page.by_id("motion").of_class("plot")}
    assert groups == {"time"}


def test_curves_are_told_apart_without_colour(quick):
    _, page = quick
    found = traces(page, "motion-0")
    looks = [(each["line"].get("dash"), each["line"]["width"]) for each in found.values()]
    assert len(set(looks)) == len(looks)


def test_diagnosis_is_that_of_the_json(diagnosed):
    case, page = diagnosed
    assert case.diagnosis is not None
    found = diagnosis_document(case.diagnosis, version="0", recordings=[], settings={})
    assert found["verdict"] == "mismatch"
    level = found["parameters"]["coulomb_friction.level"]
    written = f"{with_error(level['value'], level['standard_error'])} {level['unit']}"
    assert written in page.by_id("physics").text
    assert "dry friction" in page.by_id("summary").text
    assert in_degrees(found["heldout_rmse_before"]) in page.by_id("proof").text
    assert in_degrees(found["heldout_rmse_after"]) in page.by_id("proof").text
    for each in found["where"][:2]:
        assert each["region"] in page.by_id("parting").text


def test_prediction_of_held_out_data_is_drawn_without_and_with_the_effect(diagnosed):
    _, page = diagnosed
    found = traces(page, "proof-0")
    assert list(found) == ["without it, held out", "with it, held out"]
    sizes = [np.std(decoded(each["y"])) for each in found.values()]
    assert sizes[1] < sizes[0]


def test_the_page_of_a_saved_result_is_the_page(diagnosed, tmp_path):
    case, _ = diagnosed
    found = {"told": case.told, "diagnosis": case.diagnosis, "plan": case.plan}
    save_result(case.fit, tmp_path / "why.nc", origin=case.origin, **found)
    back = load_result(tmp_path / "why.nc")
    again = Case(case.sources, back.result, back.origin, back.told, back.diagnosis, back.plan)
    assert build_page(again) == build_page(case)
    assert back.diagnosis.after is back.result
    assert case.diagnosis is not None
    told = replace(case.diagnosis, workings=None, before=back.diagnosis.before, after=back.result)
    check_same(told, back.diagnosis)
    check_same(back.diagnosis.before.of_terms, {})
    for name, each in case.diagnosis.before.ratios.items():
        assert back.diagnosis.before.ratios[name].value == each.value


def test_plan_is_given_as_steps_with_the_error_to_expect(diagnosed):
    case, page = diagnosed
    assert case.plan is not None
    advice = page.by_id("advice")
    assert len(advice.all("ol")[0].all("li")) >= 1
    assert with_error(case.plan.value, case.plan.after) in advice.text


def test_drops_are_those_of_the_pendulum_test(diagnosed):
    case, page = diagnosed
    drops = measure_drops(case.sources[0].recording).drops
    shown = {row["measure"]: row for row in rows(page.by_id("drops").all("table")[0])}
    for each in drops[0].measures.values():
        if each.value is not None:
            assert shown[each.title]["segment 0"] == value(each)
            assert shown[each.title]["unit"] == typeset(unit_of(each))
        else:
            assert each.reason is not None
            assert each.reason in page.by_id("drops").text
    amplitude = drops[0].measures["first_flexion_amplitude"].value
    assert amplitude is not None
    degrees = f"{np.degrees(amplitude):.4g}"[:4]
    assert shown["first flexion amplitude"]["unit"] == "deg"
    assert shown["first flexion amplitude"]["segment 0"].startswith(degrees)
    assert re.search(rf"irst flexion amplitude {degrees}[^;]*?\sdeg\b", page.by_id("drops").text)
    release = decoded(traces(page, "drop-0")["release"]["x"])
    np.testing.assert_allclose(release, [drops[0].measures["start_angle"].marks[0].time])


def test_report_of_a_can_log_is_repeated(quick):
    _, page = quick
    text = page.by_id("quality").text
    assert "402 samples from 7 of 9 frames" in text
    assert "2 duplicate frames left out" in text
    assert "no sidecar" in text


def test_provenance_names_files_settings_versions_time_and_command(quick):
    case, page = quick
    section, origin = page.by_id("provenance"), case.origin
    assert origin.command in section.text
    assert origin.made in section.text
    listed = [tuple(row.values()) for table in section.all("table") for row in rows(table)]
    assert listed == [*origin.files.items(), *origin.settings.items(), *origin.versions.items()]


def test_an_existing_page_survives_a_failing_write(tmp_path, monkeypatch):
    path = tmp_path / "report.html"
    path.write_text("precious", encoding="utf-8")

    def full(self, *_, **__):
        self.write_bytes(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(OSError, match="No space left"):
        write_page(made_up(), path)
    assert path.read_bytes() == b"precious"
    assert [each.name for each in tmp_path.iterdir()] == ["report.html"]


def test_what_was_on_the_leg_is_said_with_where_it_sat():
    weighed = Subject(kind="leg", added_mass=1.5, added_mass_distance=0.37)
    assert described(weighed)["added mass"] == "1.5 kg at 0.37 m from the knee"
    some = replace(weighed, added_mass=(0.0, 1.5), added_mass_distance=(np.nan, 0.37))
    assert described(some)["added mass"] == "0, 1.5 kg at ?, 0.37 m from the knee"
    assert described(replace(weighed, added_mass_distance=None))["added mass"] == "1.5 kg"
