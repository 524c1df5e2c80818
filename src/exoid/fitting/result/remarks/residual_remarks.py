"""What besides the declared noise a fit leaves, in sentences."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from exoid.fitting.misfit.disturbance.explain import CORRELATED
from exoid.fitting.misfit.disturbance.torque_noise import TorqueNoise
from exoid.fitting.misfit.missed import DOUBT, NOISY, Disturbance, Missed

SLIGHT = 1e-3  # of m l g, below which an unknown torque changes no number that anybody reads
UNLIKE = 5.0  # times what the best drop is missed by: 3.5 of legs that lack the same in all
MISSED = 3.0  # times the noise
FEWEST = 3  # drops: of two, each pulls the leg as far to itself
EXPLAINED = "as the white noise of the measured torque makes it"
INCOMPLETE = "no error bar of a model that misses something is complete"


def of_residual(
    found: Disturbance,
    gravity: float,
    inertia: float | None,
    unit: float,
    torque: TorqueNoise | None = None,
) -> list[str]:
    """What besides the declared noise is in the residuals, and what that does to the errors.

    `gravity` is m l g / J [1/s^2]; `inertia` None where J is not known; `unit` that of the
    residuals over the noise; `torque` the noise of a torque that was measured.
    """
    noisy = of_noisy_torque(found, gravity)
    measured = found.kinds.get("measured")
    if torque and measured and torque.explains(measured, inertia):
        others = {kind: each for kind, each in found.kinds.items() if each != measured}
        alone = replace(found, kinds=others)
        where = "the residual of measured segments" if others else "the residual"
        rest = of_residual(alone, gravity, inertia, unit) if others else []
        return [*rest, of_torque_noise(torque, where), *noisy]
    if len(set(found.kinds.values())) == 1:
        missed = next(iter(found.kinds.values()))
        return of_missed(missed, "the residual", gravity, inertia, unit) + noisy
    return [
        sentence
        for kind, each in found.kinds.items()
        for sentence in of_missed(each, f"the residual of {kind} segments", gravity, inertia, unit)
    ] + noisy


def of_torque_noise(torque: TorqueNoise, where: str) -> str:
    """That the sensor of a torque makes what is left."""
    return (
        f"{where} is more than the angle's noise, {EXPLAINED}, {torque.level:.2g} N m from sample "
        "to sample: nothing else is seen to be missing. Errors are widened for it."
    )


def of_noisy_torque(found: Disturbance, gravity: float) -> list[str]:
    """What it means where the noise of a measured torque would look alike: a simulation that such
    noise drives strays less the heavier its leg is.
    """
    missed = found.kinds.get("measured")
    if missed is None or missed.cause != "torque" or slight(missed, gravity):
        return []
    if missed.correlation_time > CORRELATED[0]:
        return []
    return [
        "noise of the measured torque leaves such a residual. It makes J too large and the ratios "
        "to it too small, by more than ± says where the leg is led slowly and evenly, as by a "
        "stiff motor: move it quicker and less evenly, or measure the torque with less noise."
    ]


def slight(found: Missed, gravity: float) -> bool:
    """Is what is missed a torque that matters to nobody, beside m l g over J [1/s^2]?"""
    return found.cause == "torque" and found.deviation < SLIGHT * abs(gravity)


def of_missed(
    found: Missed, where: str, gravity: float, inertia: float | None, unit: float
) -> list[str]:
    """The same of one kind of segment, or of all."""
    widened = f"Errors are widened for it; {INCOMPLETE}, and 'exoid diagnose' asks what it misses."
    if found.cause == "torque":
        torque = as_torque(found, gravity, inertia)
        if slight(found, gravity):
            return [
                f"{where} holds a little more than the sensors' noise, as {torque}, would leave "
                "it. Errors are widened for it."
            ]
        return [
            f"{where} is more than the sensors' noise: the model misses something. It is what "
            f"{torque}, would leave. {widened}"
        ]
    if found.cause == "encoder":
        return [
            f"{where} is more than the sensors' noise: it is what {as_encoder(found)}, would "
            f"leave. {widened}"
        ]
    if found.noise > max(NOISY / unit, 1.0):  # 1 where it is not larger, or is less
        return [
            f"{where} is white but {found.noise * unit:.3g} times the noise that is declared, or "
            "that neighbouring samples show, and standard errors are widened by that: check noise "
            "levels and time stamps."
        ]
    return []


def of_angle(found: Disturbance, gravity: float, inertia: float | None) -> list[str]:
    """What the model misses of the angle alone, where the sensors lie apart: an error of the
    encoder, which stands for that, is no torque, and takes what is.
    """
    told = [each for each in found.kinds.values() if each.cause and not slight(each, gravity)]
    if not told:
        return []
    torque = told[0].cause == "torque"
    alike = as_torque(told[0], gravity, inertia) if torque else as_encoder(told[0])
    return [
        "the angle by itself is more than its noise, too: the model misses something beside that. "
        f"It is what {alike}, would leave. The numbers may be off by more than ± says: "
        f"{INCOMPLETE}, and 'exoid diagnose' asks what it misses."
    ]


def as_torque(found: Missed, gravity: float, inertia: float | None) -> str:
    """The torque that is missed."""
    each = [f"{100 * found.deviation / abs(gravity):.2g} % of m l g"] if gravity else []
    each += [] if inertia is None else [f"{found.deviation * inertia:.2g} N m"]
    share = ", ".join(each) or f"{found.deviation:.2g} rad/s^2 times J"
    return f"an unknown torque of about {share}, {lasting(found)}"


def as_encoder(found: Missed) -> str:
    """The error of the angle that is missed."""
    return (
        f"an encoder that errs by about {np.degrees(found.deviation):.2g} deg, {lasting(found)}, "
        "or a thigh or base that turns under it"
    )


def lasting(found: Missed) -> str:
    """How soon what is missed becomes another."""
    if found.correlation_time == CORRELATED[0]:
        return "varying from moment to moment"
    return f"varying within about {found.correlation_time:g} s"


def of_kinds(found: Disturbance) -> list[str]:
    """Which kind of segment is believed, where kinds are weighed differently."""
    if not found.apart:
        return []
    trusted = [kind for kind, scale in found.scales.items() if scale == 1.0]
    others = [
        f"those of the {kind} ones are divided by {scale:.2g}"
        for kind, scale in found.scales.items()
        if kind not in trusted
    ]
    return [
        "what the model misses differs from kind to kind of segment, and each is weighed by its "
        f"own: the residuals of the {' and '.join(trusted)} segments count as they are, "
        f"{', '.join(others)}. That is {DOUBT:g} times by how much more what they miss widens "
        "errors, though little of it may show in residuals. 'set by' names the kind that told a "
        "number."
    ]


def of_unlike_drops(segments: Sequence[Any]) -> list[str]:
    """That drops of fitted `segments` are missed by far more than others, and how to ask whether
    the leg changed.
    """
    drops = sorted(
        (each for each in segments if each.kind == "passive"), key=lambda each: each.angle_rmse
    )
    if len(drops) < FEWEST:
        return []
    best, worst = drops[0], drops[-1]
    if worst.angle_rmse < max(UNLIKE * best.angle_rmse, MISSED * worst.angle_noise):
        return []
    least, most = (f"{np.degrees(each.angle_rmse):.2g} deg" for each in (best, worst))
    return [
        f"one leg does not explain all drops alike: segment {worst.name} is missed by {most}, "
        f"segment {best.name} by {least}. The leg may differ from drop to drop, as one that "
        "relaxes or tires, or carries something; or what is missing acts where it falls far. "
        "'exoid fit --each' takes every drop by itself."
    ]
