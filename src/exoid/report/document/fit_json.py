"""A fit as JSON, for machines: the document's schema."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from exoid.fitting.errors.profile import Profile
from exoid.fitting.misfit.disturbance import Missed
from exoid.fitting.misfit.information import Disturbance
from exoid.fitting.result.fit_result import (
    Estimate,
    FitResult,
    MountingFit,
    MultistartReport,
    SegmentFit,
)
from exoid.report.document.plain_json import plain
from exoid.trust.identifiability import Identifiability

NO_TORQUE = "no segment has a voluntary torque"


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

    `recordings` has path, sha256 and segments of every file; `settings` what the user asked for.
    """
    profiles = profiles or {}
    return plain(
        {
            "exoid": version,
            "recordings": list(recordings),
            "settings": settings,
            "parameters": {
                name: entry(each) | {"profile": profile(profiles.get(name))}
                for name, each in (
                    *result.parameters.items(),
                    ("torque_amplitude", result.torque_amplitude or no_torque()),
                )
            },
            "ratios": {
                name: entry(each) | {"profile": profile(profiles.get(name))}
                for name, each in result.ratios.items()
            },
            "mountings": [mounting(each) for each in result.mountings],
            "identifiability": None if told is None else identifiability(told),
            "fit": quality(result),
            "multistart": multistart(result.multistart),
            "segments": [segment(each) for each in result.segments],
            "notes": result.notes,
        }
    )


def entry(each: Estimate) -> dict[str, Any]:
    """One quantity."""
    return {
        "symbol": each.symbol,
        "title": each.title,
        "unit": each.unit,
        "value": each.value,
        "standard_error": each.standard_error,
        "expected": each.expected,
        "expected_deviation": each.expected_deviation,
        "lower": each.lower,
        "upper": each.upper,
        "determined_by": each.set_by,
        "shares": None if each.shares is None else asdict(each.shares),
        "limited_by": each.limited_by,
        "reason": each.reason,
    }


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
    if found is None:
        return None
    return {
        "shape": found.shape,
        "lower": found.lower,
        "upper": found.upper,
        "value": found.value,
        "rise": found.rise,
    }


def mounting(each: MountingFit) -> dict[str, Any]:
    """What a recording owned."""
    known = {name: entry(one) for name, one in each.known.items()}
    return {"recording": each.recording, **known}


def identifiability(told: Identifiability) -> dict[str, Any]:
    """Directions as relative changes; `error` is null where no motion tells."""
    return {
        "null_directions": [asdict(each) for each in told.null_directions],
        "weak_directions": [asdict(each) for each in told.weak_directions],
        "combinations": {name: entry(each) for name, each in told.combinations.items()},
        "correlation": {"names": told.names, "matrix": told.correlation},
        "segment_shares": told.segment_shares,
        "mirrored": [asdict(each) for each in told.reversals],
        "sentences": told.sentences,
    }


def multistart(report: MultistartReport) -> dict[str, Any]:
    """Where the starts ended; `loss` is null where one failed."""
    return {
        "starts": report.starts,
        "succeeded": report.succeeded,
        "at_best": report.at_best,
        "distinct": report.distinct,
        "failures": report.failures,
        "loss": report.loss,
        "family": {
            name: {"lower": lower, "upper": upper} for name, (lower, upper) in report.family.items()
        },
        "members": report.members,
    }


def segment(each: SegmentFit) -> dict[str, Any]:
    """One segment, without its samples."""
    torque = each.torque_amplitude
    return {
        "name": each.name,
        "kind": each.kind,
        "period_s": each.period,
        "torque_amplitude": None if torque is None else torque.value,
        "torque_amplitude_standard_error": None if torque is None else torque.standard_error,
        "torque_amplitude_determined_by": None if torque is None else torque.determined_by,
        "added_mass_kg": each.added_mass,
        "begins_s": each.begins,
        "angle_rmse_rad": each.angle_rmse,
        "velocity_rmse_rad_s": each.velocity_rmse,
        "angle_noise_rad": each.angle_noise,
        "velocity_noise_rad_s": each.velocity_noise,
        "samples": each.time.size,
    }


def no_torque() -> Estimate:
    """The torque amplitude of a recording without voluntary movement."""
    from exoid.physics.parameter import declarations
    from exoid.physics.torque import CycleTorque

    declared = dict(declarations(CycleTorque))["amplitude"]
    return Estimate(declared.symbol, declared.title, declared.unit, None, None, reason=NO_TORQUE)
