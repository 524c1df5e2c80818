"""Measured against simulated."""

from exoid.fitting.result.agreement import (
    root_mean_square,
    simulated,
)
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.find_conditions import find_conditions
from exoid.fitting.result.segment_fit import SegmentFit


def segment_fit(basis: Basis, number: int, torque: Estimate | None) -> SegmentFit:
    """Measured against simulated, at the samples that were fitted."""
    best, each = basis.ended.best, basis.problem.movements[number]
    angle = simulated(basis.problem, best.angle, number)
    velocity = simulated(basis.problem, best.angular_velocity, number)
    gyro = each.angular_velocity
    return SegmentFit(
        name=each.name,
        kind=each.kind,
        period=each.period if each.voluntary else None,
        torque_amplitude=torque,
        added_mass=each.added_mass,
        angle_rmse=root_mean_square(angle - each.angle),
        velocity_rmse=None if gyro is None else root_mean_square(velocity - gyro),
        angle_noise=each.angle_noise,
        velocity_noise=None if gyro is None else each.velocity_noise,
        time=each.segment.time,
        angle=each.angle,
        angular_velocity=gyro,
        simulated_angle=angle,
        simulated_velocity=velocity,
        begins=each.segment.begins,
        conditions=find_conditions(basis.problem, basis.ended, number),
        left_out=each.slow,
        caught=each.caught,
    )
