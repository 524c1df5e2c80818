"""A fit, and what else was found, back from its file, number for number."""

import json
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from exoid.fitting.errors.profile import Profile, named
from exoid.fitting.misfit.disturbance import Missed
from exoid.fitting.misfit.information import Disturbance
from exoid.fitting.result.fit_result import FitResult, MountingFit, MultistartReport, SegmentFit
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.planning.plan import Plan
from exoid.report.parts.case import Origin
from exoid.report.saved.estimate_arrays import Groups, Table, from_table, known
from exoid.report.saved.groups import from_groups
from exoid.report.saved.identifiability_groups import from_told
from exoid.report.saved.read_groups import read_groups
from exoid.report.saved.save_result import SAMPLES, SEGMENT
from exoid.report.saved.saved_result import FORMAT, FORMAT_VERSION, SavedResult

WRITERS = "'exoid fit --save' or 'exoid diagnose --save'"
MOUNTED = [each.name for each in fields(MountingFit)][1:]


def load_result(path: str | Path) -> SavedResult:
    """What `save_result`, `exoid fit --save` or `exoid diagnose --save` wrote.

    **Raises** `ValueError` (one line) where the file is another one, or not whole; `OSError` where
    there is none.
    """
    path = Path(path)
    if path.is_dir():
        raise ValueError(f"{path}: this is a directory. Name the file in it.")
    try:
        return restored(read(path))
    except WrongFile as fault:
        raise ValueError(f"{path}: {fault}") from fault
    except OSError:  # a missing or locked file is not a damaged one
        raise
    except Exception as fault:  # whatever a file may raise that is cut off or of another kind
        raise ValueError(
            f"{path}: this is no result of {WRITERS}, or it is not whole. Save it again."
        ) from fault


class WrongFile(ValueError):
    """A netCDF file that holds something else."""


def read(path: Path) -> Groups:
    """The groups of a file that is a result."""
    groups = read_groups(path)
    about = groups["/"].attrs
    if about.get("format") != FORMAT:
        raise WrongFile(f"this netCDF file is no result of {WRITERS}. Name another.")
    if about["format_version"] != FORMAT_VERSION:
        raise WrongFile(
            f"it was saved by exoid {about['exoid']} in another layout. Read it with that version."
        )
    return groups


def restored(groups: Groups) -> SavedResult:
    about = groups["/"].attrs
    amplitude = from_table(groups["torque"])
    result = FitResult(
        parameters=from_table(groups["parameters"]),
        ratios=from_table(groups["ratios"]),
        torque_amplitude=amplitude.get("torque_amplitude"),
        segments=segments(groups),
        mountings=mountings(groups["mountings"]),
        multistart=multistart(groups),
        loss=float(about["loss"]),
        disturbance=disturbance(groups["disturbance"]),
        torque_frequency=about["torque_frequency"] or None,
        other_reading_rmse=known(float(about["other_reading_rmse"])),
        prior=about["prior"],
        notes=json.loads(about["notes"]),
        astray=about.get("astray") or None,
    )
    return SavedResult(
        result,
        from_told(groups) if "told" in groups else None,
        about["exoid"],
        json.loads(about["recordings"]),
        json.loads(about["settings"]),
        profiles(groups, result) if "profiles" in groups else None,
        held(Diagnosis, groups, "diagnosis", fit=result, workings=None),
        held(Plan, groups, "plan"),
        held(Origin, groups, "origin"),
    )


def held(of: Any, groups: Groups, path: str, **given: Any) -> Any:
    """The dataclass of a group, if the file has it."""
    return from_groups(of, groups, path, **given) if path in groups else None


def profiles(groups: Groups, result: FitResult) -> dict[str, Profile]:
    """In the order in which they were saved."""
    known = dict(named(result))
    return {
        name: from_groups(Profile, groups, f"profiles/{name}", estimate=known[name])
        for name in json.loads(groups["profiles"].attrs["names"])
    }


def mountings(table: Table) -> list[MountingFit]:
    rows = from_table(table)
    return [
        MountingFit(name, **{each: rows.get(f"{number}.{each}") for each in MOUNTED})
        for number, name in enumerate(json.loads(table.attrs["recordings"]))
    ]


def segments(groups: Groups) -> list[SegmentFit]:
    """Every segment with its part of the samples."""
    told, torques = groups["segments"], from_table(groups["segment_torques"])
    ends = np.cumsum(told["samples"].values)
    found = []
    for number, end in enumerate(ends.tolist()):
        part = slice(end - int(told["samples"].values[number]), end)
        curves = {name: groups["samples"][name].values[part].copy() for name in SAMPLES}
        numbers = {name: known(float(told[name].values[number])) for name in SEGMENT}
        if numbers["velocity_rmse"] is None:
            curves["angular_velocity"] = None
        names = {name: str(told[name].values[number]) for name in ("name", "kind")}
        torque = torques.get(str(number))
        found.append(SegmentFit(**names, **numbers, **curves, torque_amplitude=torque))
    return found


def multistart(groups: Groups) -> MultistartReport:
    starts, family = groups["starts"], groups["family"]
    counts = {n: int(starts.attrs[n]) for n in ("starts", "succeeded", "at_best", "distinct")}
    limits = zip(family["lower"].values.tolist(), family["upper"].values.tolist(), strict=True)
    return MultistartReport(
        **counts,
        loss=starts["loss"].values,
        failures=json.loads(starts.attrs["failures"]),
        family=dict(zip(family["name"].values.tolist(), limits, strict=True)),
        members={str(name): each.values for name, each in groups["members"].items()},
    )


def disturbance(found: Table) -> Disturbance:
    return Disturbance(
        kinds={kind: Missed(**each) for kind, each in json.loads(found.attrs["kinds"]).items()},
        scales=json.loads(found.attrs["scales"]),
        information=found["information"].values,
        widening=found["widening"].values,
    )
