"""The motion of a fit: measured against simulated, and what the model leaves over."""

from textwrap import fill

import numpy as np

from exoid.fitting.result.fit_result import FitResult, SegmentFit
from exoid.report.pictures.panel import Axis, Band, Line, Mark, Panel, Picture, Values
from exoid.report.pictures.role import Role
from exoid.report.words.text import in_degrees

SHOWN = 15  # segments; of more, those that fit worst
SIZES = (3.0, 1.6)  # of a channel and its residual
TIME = Axis("time", "s")


def chosen_segments(result: FitResult) -> list[SegmentFit]:
    """All segments, or those that fit worst where there are too many to read; in their order."""
    worst = sorted(range(len(result.segments)), key=lambda at: -result.segments[at].angle_rmse)
    return [result.segments[at] for at in sorted(worst[:SHOWN])]


def motion_of(segment: SegmentFit, without: SegmentFit | None = None) -> tuple[Panel, ...]:
    """Angle, its residual, angular velocity, its residual [deg, deg/s] over time [s]; behind them
    those `without` what was found.
    """
    each = segment
    rmse = f"{fill(f'segment {each.name}', 26)}\nRMSE {in_degrees(each.angle_rmse)} deg"
    speed = "" if each.velocity_rmse is None else f"RMSE {in_degrees(each.velocity_rmse)} deg/s"
    angle = channel(each.time, each.angle, each.simulated_angle, each.angle_noise)
    velocity = channel(
        each.time, each.angular_velocity, each.simulated_velocity, each.velocity_noise
    )
    if without is not None:
        angle, velocity = behind(segment, without, angle, velocity)
    axes = Axis("angle", "deg"), Axis("angular velocity", "deg/s")
    return (
        *panels(axes[0], rmse, *angle),
        *panels(axes[1], speed, *velocity),
    )


def panels(up: Axis, title: str, above: tuple[Mark, ...], below: tuple[Mark, ...]):
    """A quantity and its residual."""
    absent = "" if below else "not measured"
    yield Panel(TIME, up, above, title, SIZES[0])
    yield Panel(TIME, Axis("residual", up.unit), below, size=SIZES[1], absent=absent)


def channel(
    time: Values, measured: Values | None, simulated: Values, noise: float | None
) -> tuple[tuple[Mark, ...], tuple[Mark, ...]]:
    """One quantity in degrees and, below it, its residual with the noise band."""
    model = Line(Role.SIMULATED, time, np.degrees(simulated))
    if measured is None:
        return (model,), ()
    twice = None if noise is None else 2 * float(np.degrees(noise))
    band = () if twice is None else (Band(Role.NOISE, -twice, twice),)
    residual = Line(Role.RESIDUAL, time, np.degrees(simulated - measured))
    return (Line(Role.MEASURED, time, np.degrees(measured)), model), (*band, residual)


def behind(segment: SegmentFit, without: SegmentFit, *channels: tuple) -> list[tuple]:
    """The channels with the simulation and the residual of another model behind them."""
    time = without.time + without.begins - segment.begins
    each = (
        (without.simulated_angle, without.angle),
        (without.simulated_velocity, without.angular_velocity),
    )
    found = []
    for (above, below), (simulated, measured) in zip(channels, each, strict=True):
        curve = Line(Role.SIMULATED_WITHOUT, time, np.degrees(simulated))
        if measured is None:
            found.append(((curve, *above), below))
            continue
        residual = Line(Role.RESIDUAL_WITHOUT, time, np.degrees(simulated - measured))
        found.append(((*above[:-1], curve, above[-1]), (*below[:-1], residual, below[-1])))
    return found


def show_motion(segment: SegmentFit, number: int, without: SegmentFit | None = None) -> Picture:
    """One segment: what a sensor measured, and below it what the model leaves over; behind it what
    the model leaves over `without` what was found.
    """
    gyro = segment.angular_velocity is not None
    units = [("angle", "deg", segment.angle_rmse)]
    if segment.velocity_rmse is not None:
        units.append(("velocity", "deg/s", segment.velocity_rmse))
    misfits = ", ".join(f"{in_degrees(rmse)} {unit}" for _, unit, rmse in units)
    shown = " and ".join(f"{title} in {unit}" for title, unit, _ in units)
    bare = ""
    if without is not None:
        bare = f" Eq. 9 alone leaves {in_degrees(without.angle_rmse)} deg."
    return Picture(
        f"motion-{number}",
        f"Segment {segment.name}: {shown} over time in s, measured and simulated, each with its "
        f"residual below. The root mean square of the residual is {misfits}.{bare}",
        f"Residual (simulated minus measured): {misfits} RMSE. Grey: twice the noise of the "
        f"sensor, {in_degrees(segment.angle_noise)} deg for the angle.{bare}",
        motion_of(segment, without)[: 4 if gyro else 2],
        "time",
    )
