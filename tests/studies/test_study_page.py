"""The page of a study: what it says, that it escapes, and that it needs nothing else."""

import json
import re
from dataclasses import replace
from unittest.mock import Mock

import pytest
from benchmarks.studies.tables import Design, Truth, simulate
from html_tree import parse
from pandas import concat

from exoid.report.parts.origin import Origin
from exoid.studies.page.page import PARTS, build_page
from exoid.studies.page.parts.numbers import tells, with_interval
from exoid.studies.page.parts.part import Told
from exoid.studies.page.parts.person import people
from exoid.studies.page.parts.pictured import pictured
from exoid.studies.page.parts.tables import grown
from exoid.studies.page.parts.words import finding, names_of, within
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Answer, Asked
from exoid.studies.statistics.tables.said import Interval
from exoid.studies.statistics.tables.study import study_of

TRUTHS = (
    Truth(effect=-0.6),
    Truth("period", "s", 1.1, 0.05, 0.02, 0.02, 0.01, 0.01, 0.01, effect=0.0),
)
ORIGIN = Origin("exoid study report results", "2026-01-01", {"by": "group"}, {"exoid": "1"}, {})
STRANGE = "</script><img src=x onerror=alert(1)>\x1b[31m"


def told(study, **asked):
    return Told(ask(study, Asked(**asked)), ORIGIN, "results")


@pytest.fixture(scope="module")
def study():
    return simulate(Design(people=16, drops=2, truths=TRUTHS), 0)


@pytest.fixture(scope="module")
def page(study):
    return build_page(told(study, by="group"))


def test_it_holds_every_part_that_was_asked_with_the_finding_first(page, study):
    tree = parse(page)
    named = [each.attributes["id"] for each in tree.all("section")]
    assert named == [each.name for each in PARTS if each.name not in ("change", "failures")]
    said = tree.by_id("summary").of_class("verdict")[0].text
    assert said == finding(ask(study, Asked(by="group")))
    found = (
        r"Relaxation index is lower by [\d.]+ \(95 % [\d.]+ to [\d.]+\) in spastic than in control"
    )
    assert re.match(found, said)


def test_before_and_after_have_a_part_of_their_own(study):
    tree = parse(build_page(told(study, by="group", before="day1", after="day2")))
    text = tree.by_id("change").text
    assert "day2 - day1" in text
    assert "'day2' does not count" in tree.by_id("reliability").text
    assert "Change from day1 to day2, by group" in tree.by_id("groups").text
    # What was to change is not pooled: everybody is drawn as before.
    figure = tree.by_id("people-relaxation_index")
    drawing = json.loads(next(each.text for each in figure.all("script")))
    points = [trace for trace in drawing["data"] if trace.get("customdata")]
    assert all("of 1 session" in words for trace in points for words in trace["text"])


def test_pictures_of_differences_show_two_quantities_that_are_no_variants():
    names = ["relaxation_index", "expected_relaxation_index", "period"]
    each = [Mock(spec=Answer, quantity=name) for name in names]
    assert [one.quantity for one in pictured(each)] == ["relaxation_index", "period"]
    assert [one.quantity for one in pictured(each[1:])] == names[1:]


@pytest.mark.parametrize(("people", "said"), [(4, ""), (10, "falls by 0.66 per deg")])
def test_a_slope_of_a_few_people_is_not_told(people, said):
    """Of two degrees of freedom one in twenty quantities has one by chance."""
    found = Mock(
        spec=Agreement,
        people=people,
        slope_p=0.01,
        slope=Interval(-0.66, -1.0, -0.3),
        pairs=Mock(unit="deg"),
    )
    assert grown(found) == said


def test_what_no_quantity_tells_is_said_without_a_list_of_all():
    assert names_of(["a", "b", "c", "d"], 4) == "all quantities"
    assert names_of(["a", "b", "c", "d"], 5) == "a, b, c, d"
    assert within("No value is of the side 'right'.") == "no value is of the side 'right'."
    assert within("ICC is not told.") == "ICC is not told."


def test_it_asks_nothing_of_a_network(page):
    assert "default-src 'none'" in page
    asked = re.findall(r"""(?:src|href)=["'](?!#|data:)([^"']+)""", page)
    assert asked == []


def strange(study):
    """The study with every name of a file, person, group and reason as bad as can be."""

    def spoil(each):
        return f"{each}{STRANGE}"

    recordings = study.recordings.copy()
    for column in ("name", "participant", "side", "session", "participant_group", "recording"):
        recordings[column] = recordings[column].map(spoil)
    recordings.loc[0, ["status", "reason"]] = ["failed", STRANGE]
    quantities = study.quantities.copy()
    for column in ("participant", "side", "session", "recording", "note", "quantity"):
        kept = quantities["quantity"] == "missing_physics" if column == "quantity" else None
        spoiled = quantities[column].map(spoil)
        quantities[column] = spoiled if kept is None else quantities[column].where(kept, spoiled)
    return study_of(recordings, quantities)


def test_whatever_files_say_is_shown_and_never_obeyed(study):
    spoiled = strange(study)
    page = build_page(replace(told(spoiled, by="group"), title=STRANGE))
    assert "<img" not in page
    assert "\x1b" not in page
    # Three scripts and the figures' numbers, none of which was ended by a name.
    tree = parse(page)
    figures = len(tree.all("figure"))
    assert len(tree.all("script")) == figures + 3
    assert "onerror=alert(1)" in tree.by_id("failures").text


def test_everybody_can_be_opened_with_their_recordings(study):
    document = json.loads(people(ask(study, Asked(by="group"))))
    assert document["heads"] == [
        "recording", "session", "side", "relaxation index", "period [s]", "what became of it",
    ]  # fmt: skip
    assert [*document["people"]] == sorted({*study.recordings["participant"]})
    first = document["people"]["sub-000"]
    assert ["group", "control"] in first["facts"]
    assert first["rows"][0][:3] == ["sub-000/day1/left.csv", "day1", "left"]
    assert len(first["rows"]) == 4


def test_points_say_whose_they_are_and_open_that_person(page, study):
    figure = parse(page).by_id("people-relaxation_index")
    drawing = json.loads(next(each.text for each in figure.all("script")))
    points = [trace for trace in drawing["data"] if trace.get("customdata")]
    opened = {who for trace in points for who in trace["customdata"]}
    assert opened == {*study.recordings["participant"]}
    words = points[0]["text"][0]
    assert words.startswith("sub-000, left<br>")
    assert "of 2 sessions" in words


def test_an_empty_study_has_a_page_that_says_so(study):
    empty = study_of(study.recordings[:0], study.quantities[:0])
    assert "No quantity has values that recordings told." in build_page(told(empty))


@pytest.mark.parametrize(
    ("interval", "unit", "words"),
    [
        (Interval(0.2134, 0.121, 0.299), "1", "0.213 (95 % 0.121 to 0.299)"),
        (Interval(31.27, 28.1, 34.4), "1/s^2", "31.3 1/s^2 (95 % 28.1 to 34.4)"),
        (Interval(0.5, float("nan"), 0.7), "N m", "0.50 N m (the interval could not be found)"),
        (Interval(1234.5, 1100.0, 1400.0), "m", "1234 m (95 % 1100 to 1400)"),
    ],
)
def test_a_number_has_the_digits_that_its_interval_allows(interval, unit, words):
    assert with_interval(interval, unit) == words


def test_a_difference_of_sides_that_is_not_found_is_no_proof_that_there_is_none(page):
    cards = parse(page).of_class("card")
    (sides,) = (each for each in cards if "Are both sides alike?" in each.text)
    assert "open" in sides.attributes["class"].split()
    assert "cannot be told apart from zero" in sides.text
    assert re.search(r"could be as large as [\d.]+", sides.text)


def test_a_card_says_whether_the_groups_differ_and_in_what(page, study):
    cards = parse(page).by_id("summary").of_class("card")
    (said,) = [each.text for each in cards if "Do groups differ?" in each.text]
    assert "Yes, in 1 of 2 quantities." in said
    assert "Relaxation index is lower by" in said
    without = parse(build_page(told(study))).by_id("summary").text
    assert "Do the groups" not in without


def test_the_grade_says_that_it_is_of_the_lower_end(page):
    text = parse(page).by_id("reliability").text
    assert "by its lower end" in text
    assert "(by the lower end of the interval): ICC(A,1)" in text


def test_a_point_says_how_far_its_drops_and_days_lie_apart(page, study):
    figure = parse(page).by_id("people-relaxation_index")
    drawing = json.loads(next(each.text for each in figure.all("script")))
    words = next(trace for trace in drawing["data"] if trace.get("customdata"))["text"][0]
    rows = study.quantities[study.quantities["quantity"] == "relaxation_index"]
    rows = rows[(rows["participant"] == "sub-000") & (rows["side"] == "left")]
    shown = re.search(r"4 values of 2 sessions, with a standard deviation of ([\d.]+)", words)
    assert shown is not None
    assert float(shown[1]) == pytest.approx(rows["value"].std(), rel=0.05)  # two digits
    assert "±" not in words


def test_reasons_that_differ_in_their_numbers_are_one(study):
    from exoid.studies.page.parts.tables import failures

    recordings = study.recordings.assign(status="failed").head(4)
    reasons = [f"fit: it ends {n}.5 s early, by 1e-0{n} rad." for n in (1, 2, 3)]
    table = failures(recordings.assign(reason=[*reasons, "drops: there is none."]))
    names = recordings["name"]
    assert table.rows == [
        ("3", ", ".join(names.iloc[:3]), reasons[0]),
        ("1", names.iloc[3], "drops: there is none."),
    ]


def test_it_says_over_how_many_quantities_p_was_corrected(study):
    alone = build_page(told(study, by="group", primary=("relaxation_index",)))
    said = parse(alone).by_id("origin").text
    assert "over 1 primary quantity, and apart from them over 1 other, by Holm" in said
    assert "corrected for" not in parse(alone).by_id("summary").of_class("verdict")[0].text
    both = parse(build_page(told(study, by="group")))
    assert "over 2 quantities, by Holm" in both.by_id("origin").text
    assert "are named by --primary" in both.by_id("origin").text
    assert "(corrected for 2 quantities: " in both.by_id("summary").of_class("verdict")[0].text


def test_where_not_every_quantity_answers_each_question_has_the_number_that_p_was_corrected_for(
    study,
):
    rows = study.quantities
    lame = rows[(rows["quantity"] != "period") | (rows["side"] == "left")]
    tree = parse(build_page(told(study_of(study.recordings, lame), by="group")))
    number = "over the quantities that have an answer (2 between groups, 1 between sides), by Holm"
    assert number in tree.by_id("origin").text
    summary = tree.by_id("summary").text
    assert "(corrected for 2 quantities: " in summary
    assert "corrected for 1 " not in summary


def test_a_quantity_that_is_another_but_for_a_factor_is_counted_once(study):
    rows = study.quantities
    copy = rows[rows["quantity"] == "relaxation_index"].assign(
        quantity="normalised_relaxation_index"
    )
    both = study_of(study.recordings, concat([rows, copy]))
    tree = parse(build_page(told(both, by="group")))
    assert "over 2 quantities, by Holm" in tree.by_id("origin").text
    assert "Yes, in 1 of 2 quantities." in tree.by_id("summary").text


def test_a_difference_that_may_be_anything_is_not_told():
    told, untold = Interval(0.4, 0.1, 0.7), Interval(0.2, -725.0, 725.0)
    assert tells(told)
    assert not tells(untold)
    assert not tells(Interval(0.2, float("nan"), float("nan")))
