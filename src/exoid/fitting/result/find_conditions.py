"""How the best simulation of a segment began."""

import numpy as np

from exoid.fitting.model.mounting import acting
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.conditions import Conditions
from exoid.fitting.solve.problem import Problem
from exoid.recordings.signal.local_line import interpolated


def find_conditions(problem: Problem, ended: SearchResult, number: int) -> Conditions:
    """Those of one segment at the best fit."""
    point, seen, each = ended.point, problem.observation, problem.movements[number]
    entry = int(np.asarray(seen.owner)[number])

    def owned(name: str) -> float:
        leaf = np.asarray(getattr(point.mounting, name))
        return float(leaf[entry]) if leaf.size else 0.0

    def seen_of(name: str) -> float:
        return float(np.asarray(getattr(seen, name))[number])

    def clock_of(name: str) -> float:
        return float(np.asarray(getattr(seen.clock, name))[number])

    moved = np.exp(seen_of("added_mass_moves") * owned("log_distance"))
    distance = seen_of("added_mass_distance") * moved
    mass = seen_of("added_mass") * np.exp(owned("log_added"))
    torque = float(np.asarray(point.own.torque)[number]) * np.exp(float(point.shared.log_inertia))
    measured = each.segment.applied_torque if each.kind == "measured" else None
    if measured is not None:
        shown = interpolated(each.segment.time, measured)
        zero = seen_of("torque_reach") * owned("torque_zero")
        measured = acting(shown, zero, owned("torque_gain"))
    return Conditions(
        angle=float(np.asarray(point.own.angle)[number]),
        angular_velocity=float(np.asarray(point.own.angular_velocity)[number]),
        thigh_angle=seen_of("thigh_angle") + owned("tilt"),
        clock=owned("clock"),
        number=number,
        added_mass=float(mass),
        added_distance=float(distance) if mass > 0 else 0.0,
        added_inertia=float(mass * (distance**2 + seen_of("added_mass_extent") + owned("extent"))),
        zero=owned("zero"),
        gyro_scale=owned("gyro_scale"),
        gyro_bias=owned("gyro_bias"),
        amplitude=float(torque) if each.voluntary else 0.0,
        period=clock_of("period"),
        frequency=clock_of("frequency"),
        onset=clock_of("onset"),
        torque=measured,
        finer=seen.parts,
    )
