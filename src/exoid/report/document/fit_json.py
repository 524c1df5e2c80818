"""A fit as JSON, for machines: the document's schema."""

from collections.abc import Mapping, Sequence
from typing import Any

from exoid.fitting.errors.profile import Profile
from exoid.fitting.misfit.missed import Disturbance, Missed
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult, MountingFit, MultistartReport
from exoid.fitting.result.refused.without_numbers import without_numbers
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.report.document.plain_json import plain, shown
from exoid.trust.identifiability import Identifiability

NO_TORQUE = "no segment has a voluntary torque"
CURVES = ("time", "angle", "angular_velocity", "simulated_angle", "simulated_velocity")
UNITS = {
    "period": "period_s",
    "added_mass": "added_mass_kg",
    "begins": "begins_s",
    "left_out": "left_out_s",
    "caught": "caught_s",
    "angle_rmse": "angle_rmse_rad",
    "velocity_rmse": "velocity_rmse_rad_s",
    "angle_noise": "angle_noise_rad",
    "velocity_noise": "velocity_noise_rad_s",
}


def fit_document(
    result: FitResult,
    *,
    version: str,
    recordings: Sequence[Mapping[str, Any]],
    settings: Mapping[str, Any],
    told: Identifiability | None = None,
    profiles: Mapping[str, Profile] | None = None,
) -> dict[str, Any]:
    """The fit in SI units and radians; null, with a reason beside it, where nothing is known.

    `recordings` has path, sha256 and segments of every file; `settings` what the user asked for. Of
    a fit that does not follow its recording no number of its model is there.
    """
    result = without_numbers(result)
    told = told if result.follows else None
    return plain(
        {
            "exoid": version,
            "recordings": list(recordings),
            "settings": settings,
            **model(result, profiles or {}),
            "mountings": [mounting(each) for each in result.mountings],
            "identifiability": None if told is None else identifiability(told),
            "multistart": multistart(result.multistart),
            "segments": [segment(each) for each in result.segments],
            "notes": result.notes,
        }
    )


def model(result: FitResult, profiles: Mapping[str, Profile]) -> dict[str, Any]:
    """The numbers of a fitted model, and how well it fits; where that is not how the recording
    moves, null for numbers, with that as the reason.
    """
    result = without_numbers(result)
    torque = {"torque_amplitude": result.torque_amplitude or no_torque()}
    return {
        "parameters": entries({**result.of_leg, **torque}, profiles),
        "ratios": entries(result.ratios, profiles),
        "terms": {
            term: entries(parameters, profiles, f"{term}.")
            for term, parameters in result.terms.items()
        },
        "fit": quality(result),
    }


def entries(
    quantities: Mapping[str, Estimate], profiles: Mapping[str, Profile], term: str = ""
) -> dict[str, Any]:
    """Quantities with their profiles, which have the name of the `term` before theirs."""
    return {
        name: {**entry(each), "profile": profile(profiles.get(f"{term}{name}"))}
        for name, each in quantities.items()
    }


def entry(each: Estimate) -> dict[str, Any]:
    """One quantity."""
    return {**shown(each, ["by_hand"]), "determined_by": each.set_by}


def quality(result: FitResult) -> dict[str, Any]:
    """How well the simulation follows the samples."""
    return {
        "follows_recording": result.follows,
        "astray": result.astray,
        "angle_rmse_rad": result.angle_rmse,
        "velocity_rmse_rad_s": result.velocity_rmse,
        "angle_noise_rad": result.angle_noise,
        "samples": result.samples,
        "loss": result.loss,
        "noise_scale": result.noise_scale,
        "disturbance": disturbance(result.disturbance),
        "torque_frequency": result.torque_frequency,
        "other_torque_frequency_angle_rmse_rad": result.other_reading_rmse,
        "prior": result.prior,
    }


def disturbance(found: Disturbance) -> dict[str, Any]:
    """What besides white noise is in the residual, by kind of segment."""
    kinds = {kind: missed(each, found.scales[kind]) for kind, each in found.kinds.items()}
    return {
        "kinds": kinds,
        "widening_least": found.widening.min(),
        "widening_most": found.widening.max(),
    }


def missed(found: Missed, scale: float) -> dict[str, Any]:
    """Of one kind; the deviation in rad/s^2 (times J) or rad."""
    none = found.cause is None
    return {
        "cause": found.cause,
        "correlation_time_s": None if none else found.correlation_time,
        "deviation": None if none else found.deviation,
        "noise_over_declared": found.noise,
        "residual_divided_by": scale,
    }


def profile(found: Profile | None) -> dict[str, Any] | None:
    """The least twice-loss over the best, and where it passes the 95 % point; null at no end."""
    return None if found is None else {"shape": found.shape, **shown(found, ["name", "estimate"])}


def mounting(each: MountingFit) -> dict[str, Any]:
    """What a recording owned."""
    known = {name: entry(one) for name, one in each.known.items()}
    return {"recording": each.recording, **known}


def identifiability(told: Identifiability) -> dict[str, Any]:
    """Directions as relative changes; `error` is null where no motion tells."""
    return {
        **shown(told, ["names"], reversals="mirrored"),
        "combinations": {name: entry(each) for name, each in told.combinations.items()},
        "correlation": {"names": told.names, "matrix": told.correlation},
    }


def multistart(report: MultistartReport) -> dict[str, Any]:
    """Where the starts ended; `loss` is null where one failed."""
    ranges = {
        name: {"lower": lower, "upper": upper} for name, (lower, upper) in report.family.items()
    }
    return {**shown(report), "family": ranges}


def segment(each: SegmentFit) -> dict[str, Any]:
    """One segment, without its samples."""
    torque = each.torque_amplitude
    return {
        **shown(each, CURVES, **UNITS),
        "torque_amplitude": None if torque is None else torque.value,
        "torque_amplitude_standard_error": None if torque is None else torque.standard_error,
        "torque_amplitude_determined_by": None if torque is None else torque.determined_by,
        "samples": each.time.size,
    }


def no_torque() -> Estimate:
    """The torque amplitude of a recording without voluntary movement."""
    from exoid.physics.parameter import declarations
    from exoid.physics.torque import CycleTorque

    declared = dict(declarations(CycleTorque))["amplitude"]
    return Estimate(declared.symbol, declared.title, declared.unit, None, None, reason=NO_TORQUE)
