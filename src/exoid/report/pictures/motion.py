"""The motion of a fit: measured against simulated, and what the model leaves over."""

from collections.abc import Iterator, Sequence
from textwrap import fill

import numpy as np

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.report.pictures.panel import Axis, Band, Line, Mark, Panel, Picture
from exoid.report.pictures.role import Role
from exoid.report.words.text import in_degrees

SHOWN = 15  # segments; of more, those that fit worst
SIZES = (3.0, 1.6)  # of a channel and its residual
TIME = Axis("time", "s")
CHANNELS = {  # what is measured, what is simulated, and the noise
    Axis("angle", "deg"): ("angle", "simulated_angle", "angle_noise"),
    Axis("angular velocity", "deg/s"): ("angular_velocity", "simulated_velocity", "velocity_noise"),
}


def chosen_segments(result: FitResult) -> list[SegmentFit]:
    """All segments, or those that fit worst where there are too many to read; in their order."""
    worst = sorted(range(len(result.segments)), key=lambda at: -result.segments[at].angle_rmse)
    return [result.segments[at] for at in sorted(worst[:SHOWN])]


def motion_of(segment: SegmentFit, without: SegmentFit | None = None) -> tuple[Panel, ...]:
    """Angle, its residual, angular velocity, its residual [deg, deg/s] over time [s]; behind them
    those `without` what was found.
    """
    rmse, speed = in_degrees(segment.angle_rmse), segment.velocity_rmse
    titles = (
        f"{fill(f'segment {segment.name}', 26)}\nRMSE {rmse} deg",
        "" if speed is None else f"RMSE {in_degrees(speed)} deg/s",
    )
    models = [(segment, Role.SIMULATED, Role.RESIDUAL)]
    if without is not None:
        models.insert(0, (without, Role.SIMULATED_WITHOUT, Role.RESIDUAL_WITHOUT))
    each = zip(CHANNELS.items(), titles, strict=True)
    return tuple(
        panel for (up, names), title in each for panel in channel(models, up, names, title)
    )


def channel(
    models: list[tuple[SegmentFit, Role, Role]], up: Axis, names: Sequence[str], title: str
) -> Iterator[Panel]:
    """One quantity in degrees and, below it, its residual with the noise band."""
    segment = models[-1][0]
    measured, _, noise = (getattr(segment, name) for name in names)
    above: list[Mark] = []
    below: list[Mark] = []
    if measured is not None:
        above.append(Line(Role.MEASURED, segment.time, np.degrees(measured)))
        twice = None if noise is None else 2 * float(np.degrees(noise))
        below += [] if twice is None else [Band(Role.NOISE, -twice, twice)]
    for model, simulated_role, residual_role in models:
        time = model.time + (model.begins - segment.begins)
        seen, simulated, _ = (getattr(model, name) for name in names)
        above.append(Line(simulated_role, time, np.degrees(simulated)))
        if seen is not None:
            below.append(Line(residual_role, time, np.degrees(simulated - seen)))
    residual, absent = Axis("residual", up.unit), "" if below else "not measured"
    yield Panel(TIME, up, tuple(above), title, SIZES[0])
    yield Panel(TIME, residual, tuple(below), size=SIZES[1], absent=absent)


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
