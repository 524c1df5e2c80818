"""Do intervals hold the truth, and how wide are they? The estimator beside others, drop by drop."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from benchmarks.online import rivals, world

import exoid
from exoid import online
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.recordings.declared.subject import Subject

SUBJECT = Subject(kind="leg", body_mass=77.0, height=1.80)
RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
FRICTION = 0.24  # 1/s^2, of 0.1 N m
SKIPPED = 0.08  # s after a release that others leave out, too
OTHERS = {
    "filterpy's EKF": rivals.extended,
    "filterpy's UKF": rivals.unscented,
    "least squares": rivals.least_squares,
}


class Answer(NamedTuple):
    """What a method says of one leg after so many drops."""

    method: str
    drops: int
    off: np.ndarray  # from the truth
    errors: np.ndarray  # standard


def model_of(friction: float) -> online.Model:
    """Of the world's sensors, whose clock is exact, and said to be."""
    terms = (CoulombFriction,) if friction else ()
    return online.Model(online.Unknowns(terms), online.Node(clock_declared=True))


def answers(
    number: int, friction: float = 0.0, *, batch: bool = False, others: bool = True
) -> list[Answer]:
    """What every method says of a leg; with `batch` also the batch fit, which takes a while."""
    rng = np.random.default_rng([number, int(1e3 * friction)])
    sensors = world.draw_sensors(rng)
    leg = replace(world.draw_leg(rng, friction), tilt=sensors.tilt + world.draw_slant(rng))
    motion, free = world.session(rng, [leg] * 3)
    time, angle, rate = world.measured(rng, motion, sensors)
    truth = np.array([leg.gravity, leg.stiffness, leg.damping])
    samples, model = online.Sample(time, angle, rate), model_of(friction)
    belief = online.init(exoid.expected_leg(SUBJECT.body_mass, SUBJECT.height), model)
    after, said = online.replay(belief, samples, model)
    found = []
    for drops in (1, 3):
        at = np.flatnonzero(said.drops >= drops)
        if at.size:
            found.append(Answer("exoid", drops, said.ratios[at[0]] - truth, said.errors[at[0]]))
        stretches = [stretch(time, angle, rate, one) for one in free[:drops]]
        for name, method in OTHERS.items() if others and not friction else ():
            other = method(stretches)
            found.append(Answer(name, drops, other.values - truth, other.errors))
    if friction:
        level = online.estimates(after, model)["coulomb_friction.level_over_inertia"]
        off = np.array([level.value - leg.friction])
        found.append(Answer("exoid, friction", 3, off, np.array([level.error])))
    if batch:
        found += batch_answers(online.drops_of(samples, said), model, truth)
    return found


def stretch(time, angle, rate, free: tuple[float, float]) -> rivals.Stretch:
    inside = (time > free[0] + SKIPPED + 0.06) & (time < free[1])
    return rivals.Stretch(angle[inside], rate[inside], float(time[1] - time[0]))


def batch_answers(drops, model: online.Model, truth: np.ndarray) -> list[Answer]:
    """The batch fit as it is, and with the gyro's delay, which the live model always has."""
    found = []
    prompt = replace(model, node=replace(model.node, delay_error=0.0))
    for name, one in {"batch": prompt, "batch, gyro's delay": model}.items():
        for count in (1, 3):
            if len(drops) < count:
                continue
            each = online.refine(drops[:count], SUBJECT, one).ratios
            values, errors = (
                np.array([getattr(each[key], what) or np.nan for key in RATIOS])
                for what in ("value", "standard_error")
            )
            found.append(Answer(name, count, values - truth, errors))
    return found


def table(every: list[Answer]) -> str:
    """Of each method and number of drops: coverage, and root mean square and median error."""
    lines = [f"{'method':22} drops legs | 95 % holds (G, c, d) | rms off | median error"]
    for key in dict.fromkeys((one.method, one.drops) for one in every):
        mine = [one for one in every if (one.method, one.drops) == key]
        off, errors = (np.stack([getattr(one, what) for one in mine]) for what in ("off", "errors"))
        holds = np.mean(np.abs(off) < 1.96 * errors, axis=0)
        rms, median = np.sqrt(np.nanmean(off**2, axis=0)), np.nanmedian(errors, axis=0)
        lines.append(
            f"{key[0]:22} {key[1]:5} {len(mine):4} | {words(100 * holds, '.0f')} | "
            f"{words(rms, '.2g')} | {words(median, '.2g')}"
        )
    return "\n".join(lines)


def words(values: np.ndarray, how: str) -> str:
    return " ".join(format(value, how) for value in values)


def narrower(every: list[Answer], method: str, drops: int) -> np.ndarray:
    """The live standard errors over another method's on the same data, median over legs."""
    mine = [one.errors for one in every if (one.method, one.drops) == ("exoid", drops)]
    other = [one.errors for one in every if (one.method, one.drops) == (method, drops)]
    return np.nanmedian(np.stack(mine)[: len(other)] / np.stack(other), axis=0)
