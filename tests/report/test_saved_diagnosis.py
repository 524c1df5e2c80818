"""A saved diagnosis comes back as it was, is shown as it was, and is compared with another."""

import json
from dataclasses import replace
from io import BytesIO, StringIO

import numpy as np
import pytest
from diagnosis_by_hand import doubtful, found, nothing, novel
from page_cases import ORIGIN, made_up
from rich.console import Console
from test_fit_json import fitted
from test_saved_result import SETTINGS, SOURCES, check_same, plainly

from exoid.fitting.errors.profile import Profile
from exoid.planning.candidate_recordings import candidates
from exoid.planning.planned import Option, Plan
from exoid.report.document.diagnosis_json import diagnosis_document
from exoid.report.page import build_page
from exoid.report.parts.case import Case
from exoid.report.plots.diagnosis import plot_diagnosis
from exoid.report.saved.saved_result import load_result, save_result
from exoid.report.tables.compare import compare
from exoid.report.tables.comparison import comparison_document, print_comparison
from exoid.report.tables.mismatch.diagnosis import print_diagnosis

CASES = {"found": found, "nothing": nothing, "novel": novel, "doubtful": doubtful}


def saved(path, one, **options):
    """The diagnosis `one`, as it comes back."""
    save_result(one.fit, path, diagnosis=one, **options)
    back = load_result(path)
    assert back.diagnosis is not None
    return back


def printed(show) -> str:
    console = Console(width=80, file=StringIO())
    show(console)
    return console.file.getvalue()


def picture(one) -> bytes:
    file = BytesIO()
    plot_diagnosis(one).savefig(file, format="png", metadata={"Software": None})
    return file.getvalue()


@pytest.mark.parametrize("make", CASES.values(), ids=CASES)
def test_a_saved_diagnosis_comes_back_bit_for_bit(tmp_path, make):
    one = replace(make(), before=plainly(fitted()))
    back = saved(tmp_path / "why.nc", one)
    check_same(one, back.diagnosis)
    assert back.diagnosis.fit is back.result
    assert back.diagnosis.workings is None


@pytest.mark.parametrize("make", CASES.values(), ids=CASES)
def test_table_document_and_figure_are_those_of_the_original(tmp_path, make):
    one = make()
    both = one, saved(tmp_path / "why.nc", one).diagnosis
    texts = [printed(lambda console, each=each: print_diagnosis(each, console)) for each in both]
    assert texts[0] == texts[1]
    options = {"version": "0", "recordings": [], "settings": {}}
    assert diagnosis_document(both[0], **options) == diagnosis_document(both[1], **options)
    assert picture(both[0]) == picture(both[1])


def test_a_page_without_its_recordings_tells_the_rest(tmp_path):
    case = replace(made_up(), diagnosis=found())
    back = saved(tmp_path / "why.nc", case.diagnosis, origin=ORIGIN)
    bare = Case((), back.result, ORIGIN, diagnosis=back.diagnosis, absent=("a.csv",))
    page = build_page(bare)
    assert "Report on a.csv" in page
    assert "Made from a saved result without its recordings" in page
    for name in ("quality", "drops"):
        assert f'<section id="{name}"' not in page
    whole = build_page(case)
    for name in ("parameters", "motion", "parting", "physics", "proof", "provenance"):
        assert section(page, name) == section(whole, name)


def section(page: str, name: str) -> str:
    return page.partition(f'<section id="{name}"')[2].partition("</section>")[0]


def test_profiles_plan_and_origin_come_back(tmp_path):
    result = plainly(fitted())
    value, rise = np.array([0.37, 0.45, 0.53]), np.array([4.1, 0.0, 3.9])
    profiles = {
        name: Profile(name, result.parameters[name], value, rise, 0.372, None)
        for name in ("inertia", "damping")
    }
    each = candidates(1.78, 9.5)
    options = [Option(one, np.inf) for one in each]
    planned = Plan("inertia", "J", "kg m^2", 0.45, np.inf, 0.01, each[:3], options, ["weigh it."])
    path = tmp_path / "fit.nc"
    save_result(result, path, profiles=profiles, plan=planned, origin=ORIGIN)
    back = load_result(path)
    check_same(profiles, back.profiles)
    check_same(planned, back.plan)
    check_same(ORIGIN, back.origin)
    assert back.diagnosis is None


def test_any_reader_of_netcdf_finds_causes_errors_and_curves(tmp_path):
    import xarray

    path = tmp_path / "why.nc"
    saved(path, found())

    def group(name):
        with xarray.open_dataset(path, group=f"diagnosis/{name}") as table:
            return table.load()

    assert group("singles")["terms"].values.tolist()[1] == '["quadratic_drag"]'
    assert group("parameters")["unit"].values.tolist() == ["N m", "1"]
    assert group("proof/before")["rmse"].attrs["units"] == "rad"
    assert group("location/missing/1")["torque"].attrs["units"] == "N m"
    assert group("location/regions")["begin"].attrs["units"] == "s"


def test_what_was_saved_before_survives_a_failing_write(tmp_path, monkeypatch):
    path = tmp_path / "why.nc"
    path.write_text("precious")
    monkeypatch.setattr("exoid.report.saved.document.sealed", lambda _: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        save_result(fitted(), path, diagnosis=found())
    assert path.read_text() == "precious"
    assert [each.name for each in tmp_path.iterdir()] == ["why.nc"]


@pytest.mark.parametrize("share", [0.3, 0.6, 0.95])
def test_a_file_that_is_cut_off_is_refused_in_one_line(tmp_path, share):
    path = tmp_path / "why.nc"
    saved(path, found())
    content = path.read_bytes()
    path.write_bytes(content[: int(share * len(content))])
    with pytest.raises(ValueError, match=r"why\.nc: this is no result of exoid, or it is not"):
        load_result(path)


def test_a_diagnosis_and_a_fit_are_compared_by_what_both_have(tmp_path):
    one = saved(tmp_path / "a.nc", found(), recordings=SOURCES, settings={"seed": 7, "terms": None})
    save_result(fitted(), tmp_path / "b.nc", recordings=SOURCES, settings=SETTINGS)
    sides = [load_result(tmp_path / "b.nc"), one]
    text = printed(lambda console: print_comparison(compare(*sides), sides, console))
    assert max(map(len, text.split("\n"))) <= 80
    (verdict,) = [line for line in text.split("\n") if line.startswith("verdict")]
    assert verdict.split() == ["verdict", "not", "diagnosed", "something", "is", "missing"]
    assert "Nothing: the settings are the same." in text
    document = comparison_document(compare(*sides), sides)
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["first"]["diagnosis"] is None
    assert document["second"]["diagnosis"]["selected"] == ["coulomb_friction"]


def test_two_diagnoses_are_shown_side_by_side(tmp_path):
    sides = [saved(tmp_path / "a.nc", found()), saved(tmp_path / "b.nc", novel())]
    text = printed(lambda console: print_comparison(compare(*sides), sides, console))
    lines = {line.partition("  ")[0]: line for line in text.split("\n")}
    assert "dry friction" in lines["missing"]
    assert "tau = 0.2 sin(8 x) N m" in lines["missing"]
    held_out = comparison_document(compare(*sides), sides)["first"]["diagnosis"]
    assert held_out["heldout_rmse_before"] == found().proof.before.total
    assert held_out["heldout_rmse_after"] == found().proof.after.total


def body(sha256: str, mass: float) -> list[dict]:
    return [{**SOURCES[0], "sha256": sha256, "body_mass_kg": mass, "height_m": 1.8}]


def test_results_of_different_bodies_and_legs_are_named(tmp_path):
    one = fitted()
    ratio = replace(one.ratios["gravity_over_inertia"], value=30.0)
    other = replace(one, ratios={**one.ratios, "gravity_over_inertia": ratio})
    save_result(one, tmp_path / "a.nc", recordings=body("aa", 77.0))
    save_result(other, tmp_path / "b.nc", recordings=body("bb", 60.0))
    sides = [load_result(tmp_path / name) for name in ("a.nc", "b.nc")]
    bodies, legs = comparison_document(compare(*sides), sides)["strangers"]
    assert bodies == "The recordings are of different bodies: 77 kg, 1.8 m, against 60 kg, 1.8 m."
    assert "m l g / J = 26.2 and 30 1/s^2" in legs
    same = [sides[0], sides[0]]
    assert comparison_document(compare(*same), same)["strangers"] == []


def test_one_leg_on_two_days_is_not_called_another(tmp_path):
    save_result(fitted(), tmp_path / "a.nc", recordings=body("aa", 77.0))
    save_result(fitted(), tmp_path / "b.nc", recordings=body("bb", 77.0))
    sides = [load_result(tmp_path / name) for name in ("a.nc", "b.nc")]
    assert comparison_document(compare(*sides), sides)["strangers"] == []
