"""The torque that the baseline lacks: over time, and over the phase plane."""

from dataclasses import replace

import numpy as np

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.evidence.location import Location
from exoid.report.pictures.motion import TIME
from exoid.report.pictures.panel import Axis, Band, Cloud, Line, Panel, Picture, Rule
from exoid.report.pictures.role import Role
from exoid.report.words.diagnosis.asserted import parted

SHOWN = 4  # segments
CLIPPED = 0.98  # quantile of the torque beyond which colours are the same
SIZE, SQUARE = 3.4, 5.4


def worst(found: Diagnosis) -> list[int]:
    """The segments with the largest missing torque, in their order."""
    size = [float(np.std(each.torque)) for each in found.location.missing]
    return sorted(np.argsort(size)[::-1][:SHOWN].tolist())


def parting_of(found: Diagnosis) -> Location:
    """Where they part; nothing of it is strongest where no torque is missing."""
    return found.location if parted(found) else replace(found.location, regions=[])


def torque_of(location: Location, number: int) -> Panel:
    """Of one segment [N m], with twice its noise and the stretches where it is strongest."""
    each = location.missing[number]
    regions = [region for region in location.regions if region.segment == each.segment]
    modelled = () if each.modelled is None else (Line(Role.MODELLED, each.time, each.modelled),)
    marks = (
        Band(Role.TORQUE_NOISE, -2 * each.band, 2 * each.band),
        *(Band(Role.STRONGEST, each.begin, each.end, upright=True) for each in regions),
        Line(Role.TORQUE, each.time, each.torque),
        *modelled,
    )
    return Panel(TIME, Axis("missing torque", "N m"), marks, f"segment {each.segment}", SIZE)


def show_torque(location: Location, number: int) -> Picture:
    each = location.missing[number]
    marked = any(region.segment == each.segment for region in location.regions)
    amber = " Amber: where the torque is strongest." if marked else ""
    largest = float(np.max(np.abs(each.torque)))
    return Picture(
        f"torque-{number}",
        f"The torque in N m that Eq. 9 lacks in segment {each.segment}, over time in s: at most "
        f"{largest:.2g} N m, with a noise of {each.band:.2g} N m (one standard deviation).",
        f"Segment {each.segment}. Grey band: noise, twice its standard deviation of "
        f"{each.band:.2g} N m.{amber}",
        (torque_of(location, number),),
        "whole",
    )


def plane_of(location: Location) -> Panel:
    """Angle across [deg], speed up [deg/s], torque as colour [N m]."""
    every = location.missing
    angle = np.degrees(np.concatenate([one.angle for one in every]))
    speed = np.degrees(np.concatenate([one.angular_velocity for one in every]))
    torque = np.concatenate([one.torque for one in every])
    most = float(np.quantile(np.abs(torque), CLIPPED)) or 1.0
    marks = (Rule(Role.ZERO, 0.0), Cloud(angle, speed, torque, most, "missing torque [N m]"))
    axes = Axis("angle", "deg"), Axis("angular velocity", "deg/s")
    return Panel(*axes, marks, "over the phase plane", SQUARE)


def show_plane(location: Location) -> Picture:
    return Picture(
        "plane",
        f"The missing torque in N m over angle and angular velocity: {location.pattern}.",
        "Violet, pointing up: torque towards extension is missing; brown, pointing down: towards "
        "flexion. Colours that change with the speed point to friction or drag, colours that "
        "change with the angle to a spring or a stop.",
        (plane_of(location),),
    )
