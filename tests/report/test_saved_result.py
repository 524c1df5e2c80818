"""A saved fit comes back number for number, and another file is refused in one line."""

import json
from dataclasses import fields, is_dataclass, replace
from importlib.metadata import version
from io import StringIO

import numpy as np
import pytest
from rich.console import Console
from test_fit_json import BY_DATA, fitted

from exoid.fitting.misfit.missed import Disturbance, Missed
from exoid.fitting.result.estimates.estimate import RIVALS, Estimate
from exoid.fitting.result.fit_result import MountingFit
from exoid.fitting.result.remarks.anatomy_remarks import RARE
from exoid.report.document.fit_json import fit_document
from exoid.report.saved.saved_result import SavedResult, load_result, save_result
from exoid.report.tables.compare import ComparedQuantity, compare
from exoid.report.tables.comparison import comparison_document, print_comparison
from exoid.report.tables.fit import print_fit
from exoid.report.tables.same_leg import strangers
from exoid.trust.identifiability import Direction, Identifiability, Reversal

SOURCES = [{"path": "é leg.csv", "sha256": "00ff" * 16, "segments": 2, "sidecar_sha256": None}]
SETTINGS = {"lambda": 1.0, "seed": 7, "each": False, "torque_frequency": None, "signal": ["a=B.c"]}
ODD = (0.1 + 0.2, 1e-308, np.pi, float(np.nextafter(1.0, 2.0)), -0.0, 5e-324)


def zero():
    return Estimate("z", "zero", "rad", ODD[0], ODD[3], reason=None)


def rich():
    """A fit in which everything that may be there is, and everything that may be missing is not."""
    plain = fitted()
    segments = [
        replace(plain.segments[0], name="ä 0", angular_velocity=None, velocity_rmse=None),
        replace(plain.segments[1], angle=np.resize(ODD, 201)),
    ]
    return replace(
        plain,
        segments=segments,
        mountings=[
            MountingFit("b.csv", zero=zero(), gyro_scale=zero()),
            MountingFit("c.csv", *[zero()] * (len(fields(MountingFit)) - 1)),
        ],
        disturbance=Disturbance(
            {"active": Missed("encoder", 0.1, ODD[0], 1.0, ODD[1]), "passive": missed()},
            {"active": ODD[2], "passive": 1.0},
            np.outer(ODD, ODD),
            np.array(ODD),
        ),
        torque_frequency=None,
        other_reading_rmse=None,
    )


def missed():
    return Missed(None, 0.025, 0.0, 1.0, -7.5)


def told():
    return Identifiability(
        null_directions=[Direction({"mass": 1.0, "com_distance": -ODD[0]}, np.inf, "m up, l down")],
        weak_directions=[],
        combinations={"gravity_over_inertia": zero()},
        names=["inertia", "damping"],
        correlation=np.array([[1.0, ODD[0]], [ODD[0], 1.0]]),
        segment_shares={"gravity_over_inertia": np.array([0.25, 0.75])},
        reversals=[Reversal("ä 0", True, ODD[3])],
        sentences=["nothing tells m."],
    )


def check_same(one, other, where="saved"):
    """Bit for bit, down to the type of every number."""
    assert type(one) is type(other), where
    if is_dataclass(one):
        for each in fields(one):
            if each.name != "basis":
                check_same(
                    getattr(one, each.name), getattr(other, each.name), f"{where}.{each.name}"
                )
    elif isinstance(one, np.ndarray):
        assert (one.dtype, one.shape) == (other.dtype, other.shape), where
        assert one.tobytes() == other.tobytes(), where
    elif isinstance(one, dict):
        assert list(one) == list(other), where
        for name, each in one.items():
            check_same(each, other[name], f"{where}.{name}")
    elif isinstance(one, list | tuple):
        assert len(one) == len(other), where
        for number, pair in enumerate(zip(one, other, strict=True)):
            check_same(*pair, f"{where}[{number}]")
    else:
        assert one == other, where


def plainly(result):
    """Without NumPy's own scalar types, which a file does not keep."""
    return replace(
        result,
        segments=[replace(each, angle_rmse=float(each.angle_rmse)) for each in result.segments],
    )


@pytest.mark.parametrize("name", ["fit.nc", "fit.json"])
@pytest.mark.parametrize(("make", "asked"), [(fitted, None), (rich, told())])
def test_a_saved_fit_comes_back_bit_for_bit(tmp_path, make, asked, name):
    path = tmp_path / name
    result = plainly(make())
    save_result(result, path, told=asked, recordings=SOURCES, settings=SETTINGS)
    back = load_result(path)
    check_same(result, back.result)
    check_same(asked, back.told)
    assert (back.version, back.recordings, back.settings) == (version("exoid"), SOURCES, SETTINGS)
    assert [each.name for each in tmp_path.iterdir()] == [name]


def test_a_fit_without_voluntary_segments_comes_back(tmp_path):
    result = replace(plainly(fitted()), torque_amplitude=None, segments=fitted().segments[:1])
    result = plainly(replace(result, multistart=replace(result.multistart, family={}, members={})))
    save_result(result, tmp_path / "drop.nc")
    back = load_result(tmp_path / "drop.nc")
    check_same(result, back.result)
    assert (back.recordings, back.settings, back.told) == ([], {}, None)


@pytest.mark.parametrize("limits", [None, {}, {"clock": 0.3}])
def test_what_limits_a_number_comes_back(tmp_path, limits):
    """Nothing known, nothing that limits it, and one that does, beside a number that has one."""
    each = {"a": replace(zero(), limited_by=limits), "b": replace(zero(), limited_by={"zero": 1.0})}
    result = replace(fitted(), ratios=each)
    save_result(result, tmp_path / "fit.nc")
    check_same(result.ratios, load_result(tmp_path / "fit.nc").result.ratios)


def test_tables_and_document_of_a_saved_fit_are_those_of_the_fit(tmp_path):
    result, asked = plainly(rich()), told()
    save_result(result, tmp_path / "fit.nc", told=asked)
    back = load_result(tmp_path / "fit.nc")
    printed = []
    for pair in ((result, asked), (back.result, back.told)):
        console = Console(width=80, file=StringIO())
        print_fit(pair[0], console, pair[1])
        printed.append(console.file.getvalue())
    assert printed[0] == printed[1]
    documents = [
        fit_document(one, version="0", recordings=[], settings={}, told=other)
        for one, other in ((result, asked), (back.result, back.told))
    ]
    assert json.dumps(documents[0]) == json.dumps(documents[1])


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """A saved fit."""
    path = tmp_path_factory.mktemp("saved") / "fit.nc"
    save_result(fitted(), path)
    return path


def test_any_reader_of_netcdf_finds_values_with_their_units(whole):
    import xarray

    with xarray.open_dataset(whole, group="result/parameters") as table:
        row = table.sel(name="inertia")
        assert (float(row["value"]), str(row["unit"].values)) == (0.45104, "kg m^2")
    with xarray.open_dataset(whole, group="result/segments/0") as samples:
        assert samples["angle"].attrs["units"] == "rad"
        assert samples["time"].dtype == float  # s, and not taken for a date
    with xarray.open_datatree(whole) as tree:
        assert {"parameters", "segments", "multistart"} <= set(tree["result"].children)


def test_what_was_saved_before_survives_a_failing_write(tmp_path, monkeypatch):
    path = tmp_path / "fit.nc"
    path.write_text("precious")
    monkeypatch.setattr("exoid.report.saved.document.sealed", lambda _: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        save_result(fitted(), path)
    assert path.read_text() == "precious"
    assert [each.name for each in tmp_path.iterdir()] == ["fit.nc"]


DAMAGE = {
    "cut": lambda content: content[: len(content) // 2],
    "empty": lambda _: b"",
    "text": lambda _: b"time_s,angle_rad\n",
    "holed": lambda content: content[:2000] + bytes(3000) + content[5000:],
}


@pytest.mark.parametrize("damaged", DAMAGE.values(), ids=DAMAGE)
def test_a_file_that_is_not_whole_is_refused_in_one_line(tmp_path, whole, damaged):
    path = tmp_path / "fit.nc"
    path.write_bytes(damaged(whole.read_bytes()))
    with pytest.raises(ValueError, match=r"fit\.nc: (this is no result of exoid|it is damaged)"):
        load_result(path)


def test_a_recording_in_place_of_a_result_is_to_be_fitted_first(tmp_path):
    path = tmp_path / "drop.csv"
    path.write_text("time_s,knee_angle_deg\n0,-10\n0.01,-11\n")
    with pytest.raises(ValueError, match=r"drop\.csv: .*exoid fit RECORDING --save"):
        load_result(path)


def test_a_file_that_sends_its_library_round_for_ever_is_refused(shared):
    with pytest.raises(ValueError, match=r"hang_hdf5\.nc: this was saved by an earlier exoid"):
        load_result(shared / "faults" / "hang_hdf5.nc")


def test_a_byte_that_is_another_anywhere_is_refused_in_one_line(tmp_path, whole):
    """No library sees the file: one of its links may lead round for ever."""
    content, generator = whole.read_bytes(), np.random.default_rng(5)
    path = tmp_path / "fit.nc"
    for place in generator.integers(0, len(content), 200):
        damaged = bytearray(content)
        damaged[place] ^= 1 << int(generator.integers(0, 8))
        path.write_bytes(damaged)
        with pytest.raises(ValueError, match=r"fit\.nc: (it is damaged|this is no result)") as told:
            load_result(path)
        assert "\n" not in str(told.value)


def test_another_netcdf_file_and_other_layouts_are_named(tmp_path, monkeypatch):
    import xarray

    other, old = tmp_path / "other.nc", tmp_path / "old.nc"
    data = xarray.Dataset({"x": ("t", np.arange(3.0))})
    data.to_netcdf(other, engine="h5netcdf")
    with pytest.raises(ValueError, match=r"other\.nc: this is no result of exoid"):
        load_result(other)
    data.assign_attrs(format="exoid fit", format_version=2).to_netcdf(old, engine="h5netcdf")
    with pytest.raises(ValueError, match=r"old\.nc: this was saved by an earlier exoid"):
        load_result(old)
    with monkeypatch.context() as patched:
        patched.setattr("exoid.report.saved.seal.LAYOUT", 99)
        save_result(fitted(), tmp_path / "new.nc")
    with pytest.raises(ValueError, match=r"new\.nc: it was saved by exoid \S+ in another layout"):
        load_result(tmp_path / "new.nc")


def test_a_missing_file_and_a_directory_are_named(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"none\.nc"):
        load_result(tmp_path / "none.nc")
    with pytest.raises(ValueError, match="this is a directory"):
        load_result(tmp_path)


@pytest.fixture(scope="module")
def sides(tmp_path_factory):
    """Two fits: the second with another inertia, no torque, of another file, by another seed."""
    folder, plain = tmp_path_factory.mktemp("sides"), plainly(fitted())
    weighed = replace(plain.parameters["inertia"], shares=BY_DATA)
    first = replace(plain, parameters={**plain.parameters, "inertia": weighed})
    inertia = replace(weighed, value=0.55104)
    other = replace(
        first, parameters={**first.parameters, "inertia": inertia}, torque_amplitude=None
    )
    save_result(first, folder / "a.nc", recordings=SOURCES, settings=SETTINGS)
    moved = [{**SOURCES[0], "sha256": "aa" * 32}]
    save_result(other, folder / "b.nc", recordings=moved, settings={**SETTINGS, "seed": 8})
    return [load_result(folder / name) for name in ("a.nc", "b.nc")]


def test_a_comparison_counts_differences_in_standard_errors(sides):
    found = {each.name: each for each in compare(*sides).quantities}
    assert found["inertia"].difference == pytest.approx(0.1)
    assert found["inertia"].standard_errors == pytest.approx(0.1 / (0.0405 * 2**0.5))
    assert found["damping"].standard_errors == 0.0
    assert found["mass"].difference is None  # neither tells it
    assert found["stiffness"].standard_errors is None  # at a bound: no error is quoted
    assert found["torque_amplitude"].second is None
    assert found["torque_over_inertia"].symbol == "tau / J"


def test_what_goes_with_an_inertia_that_no_recording_tells_is_not_compared():
    """Their prior is one and the same: they are no independent values."""
    side = SavedResult(fitted(), told=None, version="1", recordings=[], settings={})
    found = {each.name: each for each in compare(side, side).quantities}
    goes = [name for name, each in found.items() if each.assumed]
    assert goes == ["mass", "inertia", "com_distance", "damping", "stiffness", "torque_amplitude"]
    assert all(found[name].error is None for name in goes)
    ratio = found["damping_over_inertia"]
    assert ratio.error == pytest.approx(2**0.5 * ratio.first.standard_error)


def test_where_a_spring_is_slack_counts_once_in_a_difference():
    first = Estimate("c / J", "stiffness over inertia", "1/s^2", 5.0, 0.3, if_slack=0.4)
    second = replace(first, value=6.0, limited_by={RIVALS: 0.5})  # of a diagnosis: it has it
    both = ComparedQuantity("stiffness_over_inertia", "c / J", "1/s^2", first, second)
    assert both.error == pytest.approx((0.5**2 + 0.3**2) ** 0.5)


def test_a_spring_slack_elsewhere_leads_both_sides_of_one_leg_astray_alike():
    """It leaves c / J open in proportion; what one leg has anew is a sixth of it: 5 of 30 deg."""
    first = Estimate("c / J", "stiffness over inertia", "1/s^2", 10.0, 0.1, if_slack=1.5)
    second = replace(first, value=6.0, if_slack=0.9)
    each = ("stiffness_over_inertia", "c / J", "1/s^2", first, second)
    own = 0.1 * 2**0.5
    two = ComparedQuantity(*each)
    assert two.error == pytest.approx(np.hypot(own, np.hypot(1.5, 0.9)))
    one = ComparedQuantity(*each, one_leg=True)
    assert one.error == pytest.approx(np.hypot(own, np.hypot(0.6, np.hypot(1.5, 0.9) / 6)))


@pytest.mark.parametrize(
    ("first", "second", "same"),
    [
        ({"id": "P1", "side": "left"}, {"id": "P1", "side": "left"}, True),
        ({"id": "P1", "side": "left"}, {"id": "P1", "side": "right"}, False),
        ({"id": None, "side": "left"}, {"id": None, "side": "left"}, False),
        (None, None, False),
    ],
)
def test_one_leg_is_what_both_sidecars_call_so(first, second, same, sides):
    each = [
        replace(side, recordings=[{**SOURCES[0], "subject": subject}])
        for side, subject in zip(sides, (first, second), strict=True)
    ]
    assert compare(*each).quantities[0].one_leg == same


@pytest.mark.parametrize(
    ("second", "said"),
    [
        ({"id": "P1", "side": "right"}, "of different legs: left, against right."),
        ({"id": "P2", "side": "left"}, "of different people: P1, against P2."),
        ({"id": "P1", "side": "left"}, "They do not look like one leg, or it changed"),
        ({"id": "P1", "side": None}, "They do not look like one leg, or it changed"),
    ],
)
def test_legs_that_are_told_to_be_two_are_not_found_to_be(second, said, sides):
    ratio = sides[1].result.ratios["damping_over_inertia"]
    ratios = {**sides[1].result.ratios, "damping_over_inertia": replace(ratio, value=9.0)}
    changed = [sides[0], replace(sides[1], result=replace(sides[1].result, ratios=ratios))]
    subjects = {"id": "P1", "side": "left"}, second
    each = [
        replace(one, recordings=[{**one.recordings[0], "subject": subject}])
        for one, subject in zip(changed, subjects, strict=True)
    ]
    (sentence,) = strangers(compare(*each), each)
    assert said in sentence


def test_a_comparison_names_the_settings_that_differ_and_no_other(sides):
    found = compare(*sides)
    assert found.settings == {"seed": ("7", "8")}
    assert not found.same_recordings
    assert compare(sides[0], sides[0]).settings == {}
    assert compare(sides[0], sides[0]).same_recordings


def test_a_comparison_fits_eighty_columns_and_json(sides):
    console = Console(width=80, file=StringIO())
    print_comparison(compare(*sides), sides, console)
    text = console.file.getvalue()
    assert max(map(len, text.split("\n"))) <= 80
    assert "…" not in text
    assert "0.451 ± 0.041" in text
    assert "not determined" in text
    assert "7 -> 8" in text
    assert "+22 ± 13 %" in text  # 0.1 of 0.451, each with an error of 0.0405
    assert "neither recording tells" not in text
    document = comparison_document(compare(*sides), sides)
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["quantities"]["inertia"]["difference"] == pytest.approx(0.1)


def test_a_comparison_says_of_which_fit_the_leg_is_none_of_its_body(sides):
    strange = f"by its motion this leg has J / (m l) = 0.49 m: {RARE}."
    noted = replace(sides[1], result=replace(sides[1].result, notes=[strange]))
    console = Console(width=80, file=StringIO())
    print_comparison(compare(sides[0], noted), [sides[0], noted], console)
    _, second = console.file.getvalue().split("The second fit")
    assert "By its motion this leg has J / (m l) = 0.49 m" in second


def test_fits_that_name_no_recording_are_not_called_of_the_same(tmp_path):
    save_result(fitted(), tmp_path / "a.nc")
    back = load_result(tmp_path / "a.nc")
    assert not compare(back, back).same_recordings
