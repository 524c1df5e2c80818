"""Recordings prepared: the baseline fit, the sensors against each other, whole movements."""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.movement import Movement, all_driven
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.pace import LEG, quickest
from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.model.mounting import Mounting, acting
from exoid.fitting.model.systematics import OF_THE_GYRO, OWNED
from exoid.fitting.multistart.beginning.starts import first_state, usual_mounting
from exoid.fitting.multistart.beginning.tethers import tethers
from exoid.fitting.result.agreement import elsewhere
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.segment_fit import pooled
from exoid.fitting.solve.ask import take
from exoid.fitting.solve.pose import pose
from exoid.fitting.solve.problem import Problem
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.filtered import filtered
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import FEWER_ROUNDS, settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.sensors.agreement import Consistency
from exoid.mismatch.sensors.at_ease import compared_at_ease
from exoid.physics.library import library
from exoid.physics.term import Term
from exoid.recordings.recording import Recording
from exoid.recordings.signal.turns import QUICK

FAR = 10.0  # times the noise, by which a baseline misses what drives a rig in a false valley
ABSOLUTE = ("log_distance", "tilt")  # what a recording owns by itself, not compared with the first


def prepare(
    result: FitResult,
    recordings: list[tuple[str, Recording]],
    terms: tuple[type[Term], ...] = (),
) -> tuple[PreparedRecording, Optimum]:
    """The recordings, ready for the library and own `terms`, and the baseline at its best."""
    basis = result.basis
    assert basis is not None  # a joint fit has one
    reading = result.torque_frequency or "1/T"
    chain, movements = basis.problem.chain, basis.problem.movements
    rig = any(recording.subject.kind == "rig" for _, recording in recordings)
    owned = unknown(movements, rig=rig)
    problem = compared(pose(movements, basis.problem.belief, reading, chain, owned=owned))
    sensors = sensors_of(problem)
    best = take(basis.ended.best, 0).coordinates
    observation = without_edges(problem.observation, sensors)
    observation = with_masses(observation, best.mounting, owned)
    if not all_driven(movements):
        observation = with_torques(observation, best.mounting)
    problem = replace(problem, observation=observation)
    fitted = as_expected(released(best, problem), result)
    inertia = float(fitted.shared.log_inertia)
    every = (*tested(rig=rig), *terms)
    zero = movements[0].systematics.zero
    common = common_of(sensors, every, owned)
    noise = pooled(result.segments, lambda each: each.angle_noise)
    drifted = rig and all_driven(movements) and result.angle_rmse > FAR * noise
    lost = not result.follows and elsewhere(result.segments)
    led = tethers(problem) if drifted or lost else ()
    made = PreparedRecording(problem, sensors, every, inertia, rig, zero, tuple(common), led)
    begin = Hypothesis(tuple(common), tuple(common.values()), made.point(fitted))
    return filtered(made, settle_free(made, begin, rounds=FEWER_ROUNDS))


def sensors_of(problem: Problem) -> Consistency:
    """What its sensors say of each other."""
    pace = quickest(problem.movements)
    return compared_at_ease(problem.observation, Yardstick, pace / LEG if pace > QUICK else 1.0)


def tested(*, rig: bool) -> tuple[type[Term], ...]:
    """The terms of the library that a diagnosis tests."""
    return tuple(each for each in library() if not each.named_only and (rig or not each.mechanical))


def common_of(
    sensors: Consistency, every: tuple[type[Term], ...], owned: tuple[str, ...]
) -> dict[type[Term], np.ndarray]:
    """What the sensors surely do wrong, which every candidate has, but for what each recording
    owns.
    """
    return {
        each.fault.term: each.values
        for each in sensors.sure.errors
        if each.fault.term in every and each.fault.term.replaces not in owned
    }


def without_edges(seen: Observation, sensors: Consistency) -> Observation:
    """Leave out the gyro's samples that show what was before or after an encoder's segment."""
    delay = sensors.delay
    if delay == 0.0:
        return seen
    time, weight = np.asarray(seen.time), np.asarray(seen.velocity_weight)
    last = np.where(weight > 0, time, -np.inf).max(axis=1, keepdims=True)
    shown = time - delay
    inside = (shown >= time[:, :1]) & (shown <= last)
    return replace(seen, velocity_weight=np.where(inside, weight, 0.0))


def with_masses(seen: Observation, fitted: Mounting, owned: tuple[str, ...]) -> Observation:
    """Added masses as the fit has them, in weight, place and extent, with the damping and stiffness
    beside them: what is a little off there is no missing physics. What a diagnosis itself leaves
    free stays.
    """
    owner = np.asarray(seen.owner)

    def own(name: str) -> np.ndarray | float:
        entries = np.asarray(getattr(fitted, name))
        return entries[owner] if entries.size and name not in owned else 0.0

    apart = np.asarray(seen.apart)
    off = own("log_distance") + apart * own("distance_apart")
    moved = np.exp(np.asarray(seen.added_mass_moves) * off)
    return replace(
        seen,
        added_mass=seen.added_mass * np.exp(own("log_added")),
        added_mass_distance=seen.added_mass_distance * moved,
        added_mass_extent=seen.added_mass_extent + own("extent") + apart * own("extent_apart"),
        damped=1 + seen.heavier * own("damping_under_load"),
        stiffened=1 + seen.heavier * own("stiffness_under_load"),
    )


def with_torques(seen: Observation, fitted: Mounting) -> Observation:
    """Measured torques less the zero of their sensor, and by its gain, as drops beside them tell
    both: a constant torque of the leg would act in the drops, too.
    """
    zero, gain = np.asarray(fitted.torque_zero), np.asarray(fitted.torque_gain)
    owner = np.asarray(seen.owner)
    offset = np.asarray(seen.torque_reach) * (zero[owner] if zero.size else 0.0)
    offset, own = (each[:, None] for each in (offset, gain[owner] if gain.size else 0.0 * offset))
    return replace(seen, torque=jax.tree.map(lambda one: acting(one, offset, own), seen.torque))


def unknown(movements: list[Movement], *, rig: bool) -> tuple[str, ...]:
    """What of the mountings a diagnosis leaves free: where a mass of unknown distance sat, the tilt
    of a leg's seat, and how the sensors sat compared with the first recording. Its own encoder's
    zero and gyro's bias are free, too (`Hypothesis.zero`); what else differs from what is declared
    is asked for by its candidates.
    """
    several = len({each.recording for each in movements}) > 1
    wanted = {
        "log_distance": any(each.unplaced for each in movements),
        "tilt": not rig,
        **dict.fromkeys(("zero", *OF_THE_GYRO), several),
    }
    return tuple(name for name in OWNED if wanted.get(name, False))


def compared(problem: Problem) -> Problem:
    """The same problem, its first recording's sensors as declared and distances that are known."""
    first = (np.asarray(problem.observation.owner) == 0)[:, None]
    placed = np.array([[float(not each.unplaced)] for each in problem.movements])

    def known(name: str) -> np.ndarray:
        own = getattr(problem.known.mounting, name)
        if name == "log_distance":
            return placed
        return own if name == "tilt" else np.where(first, 1.0, own)

    mounting = replace(problem.known.mounting, **{name: known(name) for name in problem.owned})
    return replace(problem, known=replace(problem.known, mounting=mounting))


def as_expected(fitted: Coordinates, result: FitResult) -> Coordinates:
    """The leg with the inertia of its body, in the place of one that the table tells only beside
    ratios which its recording refuses: of those, torques were off by as much.
    """
    inertia = result.parameters["inertia"]
    told = inertia.by_hand == "fix" or inertia.determined_by not in ("prior", "both")
    if result.follows or told or inertia.expected is None:
        return fitted
    shared = replace(fitted.shared, log_inertia=np.log(inertia.expected))
    return replace(fitted, shared=shared)


def released(at: Coordinates, problem: Problem) -> Coordinates:
    """The fit's leg, every segment from where its whole movement begins."""
    first = np.array([first_state(each) for each in problem.movements])
    mounting = usual_mounting(problem.movements, owned=problem.owned)
    own = replace(at.own, angle=first[:, 0], angular_velocity=first[:, 1])
    entries = {name: getattr(at.mounting, name) for name in problem.owned}
    moved = {name: each - (0.0 if name in ABSOLUTE else each[0]) for name, each in entries.items()}
    at = jax.tree.map(np.asarray, at)
    return Coordinates(at.shared, at.log_mass, replace(mounting, **moved), own)
