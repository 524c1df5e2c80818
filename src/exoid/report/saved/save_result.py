"""A fit, and what else was found, in one netCDF file: tables that any reader shows, with units."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from exoid.fitting.errors.profile import Profile
from exoid.fitting.misfit.information import Disturbance
from exoid.fitting.result.fit_result import FitResult, MountingFit, MultistartReport, SegmentFit
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.planning.plan import Plan
from exoid.report.document.fit_json import replacing
from exoid.report.parts.case import Origin
from exoid.report.saved.estimate_arrays import Groups, Table, numbers, texts, to_table
from exoid.report.saved.groups import text, to_groups
from exoid.report.saved.identifiability_groups import to_told
from exoid.report.saved.saved_result import APART, FORMAT, FORMAT_VERSION
from exoid.trust.identifiability import Identifiability

SAMPLES = {  # of all segments, one after the other
    "time": "s",
    "angle": "rad",
    "angular_velocity": "rad/s",
    "simulated_angle": "rad",
    "simulated_velocity": "rad/s",
}
SEGMENT = {
    "period": "s",
    "added_mass": "kg",
    "begins": "s",
    "angle_rmse": "rad",
    "velocity_rmse": "rad/s",
    "angle_noise": "rad",
    "velocity_noise": "rad/s",
}


def save_result(
    result: FitResult,
    path: str | Path,
    *,
    told: Identifiability | None = None,
    profiles: Mapping[str, Profile] | None = None,
    diagnosis: Diagnosis | None = None,
    plan: Plan | None = None,
    recordings: Sequence[Mapping[str, Any]] = (),
    settings: Mapping[str, Any] | None = None,
    origin: Origin | None = None,
) -> None:
    """Write a fit to a netCDF file, in full or not at all; `load_result` gives it back.

    A `diagnosis` is that of this fit. `recordings` has path, sha256 and segments of every file;
    `settings` what was asked for.
    """
    import xarray

    about = {
        "format": FORMAT,
        "format_version": FORMAT_VERSION,
        "exoid": version("exoid"),
        "recordings": text(list(recordings)),
        "settings": text(dict(settings or {})),
        "prior": result.prior,
        "torque_frequency": result.torque_frequency or "",
        "notes": text(result.notes),
        "astray": result.astray or "",
        "loss": result.loss,
        "other_reading_rmse": numbers([result.other_reading_rmse])[0],
    }
    amplitude = result.torque_amplitude
    groups = {
        "/": xarray.Dataset(attrs=about),
        "parameters": to_table(result.parameters),
        "ratios": to_table(result.ratios),
        "torque": to_table({} if amplitude is None else {"torque_amplitude": amplitude}),
        "mountings": mountings(result.mountings),
        **segments(result.segments),
        **multistart(result.multistart),
        "disturbance": disturbance(result.disturbance),
        **({} if told is None else to_told(told)),
        **({} if profiles is None else profiled(profiles)),
        **({} if diagnosis is None else to_groups(diagnosis, "diagnosis", without=APART)),
        **({} if plan is None else to_groups(plan, "plan")),
        **({} if origin is None else to_groups(origin, "origin")),
    }
    tree = xarray.DataTree.from_dict(groups)
    with replacing(path) as part:
        tree.to_netcdf(part, engine="h5netcdf")


def mountings(each: list[MountingFit]) -> Table:
    """One row for each quantity of each recording, named NUMBER.QUANTITY."""
    rows = {
        f"{number}.{name}": one
        for number, mounting in enumerate(each)
        for name, one in mounting.known.items()
    }
    return to_table(rows).assign_attrs(recordings=text([one.recording for one in each]))


def segments(each: list[SegmentFit]) -> Groups:
    """What is told of every segment, its torque where there is one, and the samples of all."""
    import xarray

    told: dict[str, tuple] = {
        name: ("segment", texts([getattr(one, name) for one in each])) for name in ("name", "kind")
    }
    for name, unit in SEGMENT.items():
        told[name] = ("segment", numbers([getattr(s, name) for s in each]), {"units": unit})
    told["samples"] = ("segment", np.array([s.time.size for s in each]))
    curves = {
        name: ("sample", np.concatenate([samples(s, name) for s in each]), {"units": unit})
        for name, unit in SAMPLES.items()
    }
    torques = {str(n): s.torque_amplitude for n, s in enumerate(each) if s.torque_amplitude}
    return {
        "segments": xarray.Dataset(told),
        "segment_torques": to_table(torques),
        "samples": xarray.Dataset(curves),
    }


def samples(segment: SegmentFit, name: str) -> np.ndarray:
    """A curve; NaN throughout where there is none."""
    found = getattr(segment, name)
    return np.full(segment.time.size, np.nan) if found is None else np.asarray(found, dtype=float)


def multistart(report: MultistartReport) -> Groups:
    """Where the starts ended, the family's ranges, and its members."""
    import xarray

    counts = {
        name: getattr(report, name) for name in ("starts", "succeeded", "at_best", "distinct")
    }
    ranges = np.array(list(report.family.values()), dtype=float).reshape(-1, 2)
    return {
        "starts": xarray.Dataset(
            {"loss": ("start", report.loss)}, attrs=counts | {"failures": text(report.failures)}
        ),
        "family": xarray.Dataset(
            {"lower": ("name", ranges[:, 0]), "upper": ("name", ranges[:, 1])},
            coords={"name": texts(list(report.family))},
        ),
        "members": xarray.Dataset({n: ("member", each) for n, each in report.members.items()}),
    }


def disturbance(found: Disturbance) -> Table:
    import xarray

    return xarray.Dataset(
        {
            "information": (("coordinate", "other_coordinate"), found.information),
            "widening": ("direction", found.widening),
        },
        attrs={
            "kinds": text({kind: asdict(each) for kind, each in found.kinds.items()}),
            "scales": text(found.scales),
        },
    )


def profiled(profiles: Mapping[str, Profile]) -> Groups:
    """A group for each quantity, whose values are in its unit."""
    import xarray

    groups: dict[str, Table] = {"profiles": xarray.Dataset(attrs={"names": text(list(profiles))})}
    for name, each in profiles.items():
        path = f"profiles/{name}"
        groups |= to_groups(each, path, without=("estimate",))
        for curve in ("value", "lower", "upper"):
            if curve in groups[path]:
                groups[path][curve].attrs["units"] = each.estimate.unit
    return groups
