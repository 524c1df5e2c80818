"""The torque that the baseline lacks: over time, and over the phase plane."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.answer.over_inertia import guessed
from exoid.mismatch.evidence.location import OPEN, Location
from exoid.report.pictures.motion import TIME
from exoid.report.pictures.panel import Axis, Band, Cloud, Line, Panel, Picture, Rule
from exoid.report.pictures.role import Role
from exoid.report.words.diagnosis.asserted import parted
from exoid.report.words.diagnosis.located import located

SHOWN = 4  # segments
CLIPPED = 0.98  # quantile of the torque beyond which colours are the same
SIZE, SQUARE = 3.4, 5.4


def worst(found: Diagnosis) -> list[int]:
    """The segments with the largest missing torque, in their order."""
    size = [float(np.std(each.torque)) for each in found.location.missing]
    return sorted(np.argsort(size)[::-1][:SHOWN].tolist())


def shown_of(found: Diagnosis) -> str:
    """Which segments are shown, where that is not all of them."""
    shown, every = len(worst(found)), len(found.location.missing)
    return f"the {shown} of {every} segments in which most is missing" if shown < every else ""


def parting_of(found: Diagnosis) -> Location:
    """Where they part; nothing of it is strongest where no torque is missing."""
    location = located(found)
    return location if parted(found) else replace(location, regions=[])


class Called(NamedTuple):
    """What is shown of a torque."""

    noun: str
    unit: str


TORQUE, OVER_INERTIA = Called("torque", "N m"), Called("torque / J", "rad/s^2")


def called_in(found: Diagnosis) -> Called:
    """Torques over J, where nothing tells that."""
    return OVER_INERTIA if guessed(found.fit) else TORQUE


def torque_of(location: Location, number: int, called: Called = TORQUE) -> Panel:
    """Of one segment, with twice its noise and the stretches where it is strongest."""
    each = location.missing[number]
    regions = [region for region in location.regions if region.segment == each.segment]
    modelled = () if each.modelled is None else (Line(Role.MODELLED, each.time, each.modelled),)
    marks = (
        Band(Role.TORQUE_NOISE, -OPEN * each.band, OPEN * each.band),
        *(Band(Role.STRONGEST, each.begin, each.end, upright=True) for each in regions),
        Line(Role.TORQUE, each.time, each.torque),
        *modelled,
    )
    return Panel(
        TIME, Axis(f"missing {called.noun}", called.unit), marks, f"segment {each.segment}", SIZE
    )


def show_torque(location: Location, number: int, called: Called = TORQUE) -> Picture:
    each = location.missing[number]
    marked = any(region.segment == each.segment for region in location.regions)
    amber = " Amber: where the torque is strongest." if marked else ""
    largest, unit = float(np.max(np.abs(each.torque))), called.unit
    return Picture(
        f"torque-{number}",
        f"The {called.noun} in {unit} that Eq. 9 lacks in segment {each.segment}, over time in s: "
        f"at most {largest:.2g} {unit}, which the sensors tell to {each.band:.2g} {unit} (one "
        "standard deviation).",
        f"Segment {each.segment}, where it swings free: as it is let go, sensors do not tell its "
        f"acceleration. Grey band: how far they leave the torque open, twice a standard deviation "
        f"of {each.band:.2g} {unit}; the curve is smoothed and scatters less.{amber}",
        (torque_of(location, number, called),),
        "whole",
    )


def plane_of(location: Location, called: Called = TORQUE) -> Panel:
    """Angle across [deg], speed up [deg/s], torque as colour."""
    every = location.missing
    angle = np.degrees(np.concatenate([one.angle for one in every]))
    speed = np.degrees(np.concatenate([one.angular_velocity for one in every]))
    torque = np.concatenate([one.torque for one in every])
    most = float(np.quantile(np.abs(torque), CLIPPED)) or 1.0
    colours = f"missing {called.noun} [{called.unit}]"
    marks = (Rule(Role.ZERO, 0.0), Cloud(angle, speed, torque, most, colours))
    axes = Axis("angle", "deg"), Axis("angular velocity", "deg/s")
    return Panel(*axes, marks, "over the phase plane", SQUARE)


def show_plane(location: Location, called: Called = TORQUE) -> Picture:
    return Picture(
        "plane",
        f"The missing {called.noun} in {called.unit} over angle and angular velocity: "
        f"{location.pattern}.",
        "Violet, pointing up: torque towards extension is missing; brown, pointing down: towards "
        "flexion. Colours that change with the speed point to friction or drag, colours that "
        "change with the angle to a spring or a stop.",
        (plane_of(location, called),),
    )
