"""The JSON of a fit: its schema, what is null, and that no file is ever half written."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.errors.profile import Profile
from exoid.fitting.misfit.information import common
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.misfit.uncertainty import HELD, Shares
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult, MultistartReport
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.report.document.fit_json import fit_document
from exoid.report.document.plain_json import write_json

BY_DATA, BY_PRIOR = Shares(1.0, 0.0, 0.0), Shares(0.0, 1.0, 0.0)
BY_BOTH = Shares(0.4, 0.6, 0.0)
WHITE = common(Missed(None, 0.025, 0.0, 1.0, 0.0), ["passive"])
RECORDINGS = [{"path": "leg.csv", "sha256": "00ff", "segments": 2}]


def torque(value, error):
    return Estimate(
        "tau", "torque amplitude", "N m", value, error, None, None, -250.0, 250.0, BY_BOTH
    )


def swing(name, kind, period=None, amplitude=None):
    time = np.linspace(0.0, 2.0, 201)
    angle, velocity = -1.0 + np.cos(5 * time), -5 * np.sin(5 * time)
    noise = 1e-3 * np.cos(40 * time)
    return SegmentFit(
        name=name,
        kind=kind,
        period=period,
        torque_amplitude=amplitude,
        added_mass=0.0,
        angle_rmse=np.float64(0.0010),  # as NumPy gives it
        velocity_rmse=0.0030,
        angle_noise=0.0008,
        velocity_noise=0.0028,
        time=time,
        angle=angle + noise,
        angular_velocity=velocity + noise,
        simulated_angle=angle,
        simulated_velocity=velocity,
    )


def fitted():
    """A fit of a drop and a cycle: mass not determined, stiffness at its bound, one start lost."""
    leg = [
        ("mass", "m", "kg", None, None, 4.543, 0.454, 2.0, 6.0, None, "motion shows only m l"),
        ("inertia", "J", "kg m^2", 0.45104, 0.0405, 0.446, 0.067, 0.15, 1.0, BY_PRIOR, None),
        ("com_distance", "l", "m", 0.2659, 0.0151, 0.2663, 0.016, 0.15, 0.6, BY_PRIOR, None),
        ("damping", "d", "N m s/rad", 0.3508, 0.0315, 0.36, 0.216, 0.0, 60.0, BY_BOTH, None),
        ("stiffness", "c", "N m/rad", 3.99999, None, 2.9, 1.74, 0.0, 4.0, HELD, "at a bound"),
    ]
    ratios = [
        ("gravity_over_inertia", "m l g / J", "1/s^2", 26.188, 0.0023),
        ("stiffness_over_inertia", "c / J", "1/s^2", 8.868, 0.0059),
        ("damping_over_inertia", "d / J", "1/s", 0.7778, 0.00035),
        ("torque_over_inertia", "tau / J", "1/s^2", -21.118, 0.0053),
    ]
    inertia = np.linspace(0.2, 0.45, 3)
    return FitResult(
        parameters={name: Estimate(symbol, name, *rest) for name, symbol, *rest in leg},
        ratios={name: Estimate(symbol, name, *rest) for name, symbol, *rest in ratios},
        torque_amplitude=torque(-9.5, 0.86),
        mountings=[],
        segments=[
            swing("leg 0", "passive"),
            swing("leg 1", "active", 2.0, torque(-9.5, 0.86)),
        ],
        multistart=MultistartReport(
            starts=5,
            succeeded=4,
            at_best=3,
            loss=np.array([150.0, 150.0, 150.0, 9000.0, np.inf]),
            failures={"its motion could not be simulated": 1},
            family={"inertia": (0.2, 0.45), "stiffness": (1.8, 4.0), "damping": (0.156, 0.351)},
            members={"inertia": inertia, "stiffness": 8.868 * inertia, "damping": 0.7778 * inertia},
            distinct=2,
        ),
        loss=151.0,
        disturbance=WHITE,
        torque_frequency="1/T",
        other_reading_rmse=0.075,
        prior="anatomy, table de_leva, 77 kg and 1.8 m",
        notes=["the fit lies on the limit m l^2 <= J of a rigid leg."],
    )


def document(result):
    return fit_document(result, version="0.1.0", recordings=RECORDINGS, settings={"seed": 0})


def leaves(value):
    if isinstance(value, dict):
        return [leaf for each in value.values() for leaf in leaves(each)]
    return [leaf for each in value for leaf in leaves(each)] if isinstance(value, list) else [value]


def test_document_has_every_key_that_readers_rely_on():
    found = document(fitted())
    assert found["exoid"] == "0.1.0"
    assert found["recordings"] == RECORDINGS
    assert found["settings"] == {"seed": 0}
    names = ["mass", "inertia", "com_distance", "damping", "stiffness", "torque_amplitude"]
    assert list(found["parameters"]) == names
    keys = {"symbol", "unit", "value", "standard_error", "expected", "lower", "upper"}
    for each in found["parameters"].values():
        assert each.keys() >= keys | {"determined_by", "reason"}
    ratios = {"gravity", "stiffness", "damping", "torque"}
    assert found["ratios"].keys() == {f"{name}_over_inertia" for name in ratios}
    for each in found["ratios"].values():
        assert each.keys() >= {"unit", "value", "standard_error"}
    fit = {"angle_rmse_rad", "velocity_rmse_rad_s", "angle_noise_rad", "samples"}
    assert found["fit"].keys() >= fit
    assert found["multistart"].keys() >= {"starts", "succeeded", "at_best"}
    assert [each["torque_amplitude"] for each in found["segments"]] == [None, -9.5]
    assert [each["period_s"] for each in found["segments"]] == [None, 2.0]


def test_document_is_json_without_nan_although_a_start_failed():
    result = fitted()
    assert np.isinf(result.multistart.loss).any()
    found = document(result)
    assert json.loads(json.dumps(found, allow_nan=False)) == found
    assert all(type(leaf) in (str, int, float, bool, type(None)) for leaf in leaves(found))
    assert found["multistart"]["loss"][-1] is None


@pytest.mark.parametrize("odd", [np.nan, np.inf, np.float64(np.nan), -math.inf])
def test_what_is_not_finite_becomes_null(odd):
    result = fitted()
    segment = replace(result.segments[0], angle_rmse=odd)
    found = document(replace(result, segments=[segment]))
    assert found["segments"][0]["angle_rmse_rad"] is None


def test_settings_with_paths_and_numpy_numbers_are_plain(tmp_path):
    settings = {"plot": tmp_path, "seed": np.int64(3), "limits": (1.0, np.inf)}
    found = fit_document(fitted(), version="0", recordings=[], settings=settings)["settings"]
    assert found == {"plot": str(tmp_path), "seed": 3, "limits": [1.0, None]}


def test_without_voluntary_torque_the_amplitude_is_null_with_a_reason():
    result = fitted()
    found = document(replace(result, torque_amplitude=None))
    amplitude = found["parameters"]["torque_amplitude"]
    assert amplitude["value"] is None
    assert (amplitude["symbol"], amplitude["unit"]) == ("tau", "N m")
    assert "no segment has a voluntary torque" in amplitude["reason"]


def test_shares_profile_and_what_is_in_the_residual_are_written():
    result = fitted()
    profile = Profile(
        "inertia",
        result.parameters["inertia"],
        np.array([0.37, 0.45, 0.53]),
        np.array([4.1, 0.0, 3.9]),
        0.372,
        None,
    )
    missed = common(Missed("torque", 0.1, 0.0004, 1.0, 0.0), ["passive"])
    result = replace(result, disturbance=replace(missed, widening=np.array([2.0, 5.0])))
    found = fit_document(
        result, version="0", recordings=[], settings={}, profiles={"inertia": profile}
    )
    inertia = found["parameters"]["inertia"]
    assert inertia["shares"] == {"data": 0.0, "prior": 1.0, "bound": 0.0, "kind": None}
    assert inertia["profile"]["shape"] == "lower limit only"
    assert (inertia["profile"]["lower"], inertia["profile"]["upper"]) == (0.372, None)
    assert found["parameters"]["mass"]["shares"] is None
    assert found["parameters"]["damping"]["profile"] is None
    assert found["fit"]["disturbance"] == {
        "kinds": {
            "passive": {
                "cause": "torque",
                "correlation_time_s": 0.1,
                "deviation": 0.02,
                "noise_over_declared": 1.0,
                "residual_divided_by": 1.0,
            }
        },
        "widening_least": 2.0,
        "widening_most": 5.0,
    }


def test_written_file_reads_back_as_the_document(tmp_path):
    found = document(fitted())
    write_json(found, tmp_path / "fit.json")
    assert json.loads((tmp_path / "fit.json").read_text(encoding="utf-8")) == found
    assert [each.name for each in tmp_path.iterdir()] == ["fit.json"]


def test_existing_file_survives_a_failing_write(tmp_path, monkeypatch):
    path = tmp_path / "fit.json"
    path.write_text("precious")

    def full(self, text, **_):
        with self.open("w") as file:
            file.write(text[:5])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("pathlib.Path.write_text", full)
    with pytest.raises(OSError, match="No space left"):
        write_json({"exoid": "0.1.0"}, path)
    assert path.read_text() == "precious"
    assert [each.name for each in tmp_path.iterdir()] == ["fit.json"]


def test_document_with_nan_is_refused_before_the_file_is_touched(tmp_path):
    path = tmp_path / "fit.json"
    path.write_text("precious")
    with pytest.raises(ValueError, match="not JSON compliant"):
        write_json({"value": math.nan}, path)
    assert path.read_text() == "precious"


def test_missing_folder_is_named(tmp_path):
    with pytest.raises(ValueError, match=r"absent does not exist\. Make it first"):
        write_json({}, tmp_path / "absent" / "fit.json")


def test_directory_is_no_file_to_write(tmp_path):
    with pytest.raises(ValueError, match="this is a directory"):
        write_json({}, tmp_path)


def test_link_stays_a_link_and_its_target_is_replaced(tmp_path):
    target, link = tmp_path / "target.json", tmp_path / "link.json"
    target.write_text("old")
    link.symlink_to(target)
    write_json({"exoid": "0.1.0"}, link)
    assert link.is_symlink()
    assert json.loads(target.read_text()) == {"exoid": "0.1.0"}


def test_device_is_written_to_not_replaced(tmp_path):
    device = tmp_path / "null"
    device.symlink_to("/dev/null")
    write_json({"exoid": "0.1.0"}, device)
    assert device.is_symlink()
    assert device.is_char_device()
