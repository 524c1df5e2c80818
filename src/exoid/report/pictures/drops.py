"""A drop with what clinicians read off it, marked on its curves."""

import numpy as np

from exoid.pendulum.drop import Drop
from exoid.recordings.landmarks.measure import Mark as Landmark
from exoid.recordings.landmarks.rest import BAND
from exoid.recordings.landmarks.track import HALF
from exoid.report.pictures.motion import TIME
from exoid.report.pictures.panel import Axis, Band, Line, Mark, Panel, Picture, Points, Rule, Span
from exoid.report.pictures.role import Role
from exoid.report.words.drop import EXPECTED, loaded, unit_of, value

BELOW = 8.0  # deg under the curve, where the period is drawn
SIZES = (4.8, 2.4, 2.4)
TOLD = ("first_flexion_amplitude", "plateau_amplitude", "relaxation_index")
SPANS = (("first_flexion_amplitude", "`A1`"), ("plateau_amplitude", "`A0`"))


def drop_of(drop: Drop) -> tuple[Panel, ...]:
    """Angle, angular velocity and angular acceleration over time, and what was read off them."""
    assert drop.curve is not None  # only what was read is drawn
    curve = drop.curve
    sure = curve.time < curve.time[-1] - HALF  # nearer to the end a second derivative is all noise
    marks = (*rest(drop), *angles(drop), *swings(drop), *spans(drop))
    title = f"segment {drop.name}{loaded(drop)}\n{index(drop)}"
    return (
        Panel(TIME, Axis("angle", "deg"), marks, title, SIZES[0]),
        derivative(drop, "velocity", "deg/s", curve.time, curve.velocity),
        derivative(drop, "acceleration", "deg/s^2", curve.time[sure], curve.acceleration[sure]),
    )


def angles(drop: Drop) -> tuple[Line, ...]:
    """What was measured, and what was read where that is less a drift."""
    track = drop.segment
    raw = track.angle if track.raw_angle is None else track.raw_angle
    assert raw is not None  # a Segment has one or the other
    if not drop.drift:
        return (Line(Role.ANGLE, track.time, np.degrees(raw)),)
    level = raw - drop.drift * (track.time - track.time[0])
    each = ((Role.DRIFTED, raw), (Role.LEVEL_ANGLE, level))
    return tuple(Line(role, track.time, np.degrees(angle)) for role, angle in each)


def derivative(drop: Drop, kind: str, unit: str, time, samples) -> Panel:
    """One of the angle, with its peaks."""
    marks = (
        Rule(Role.ZERO, 0.0),
        Line(Role.DERIVATIVE, time, np.degrees(samples)),
        *dots(Role.FLEXION, landmarks(drop, f"peak_flexion_{kind}")),
        *dots(Role.EXTENSION, landmarks(drop, f"peak_extension_{kind}")),
    )
    return Panel(TIME, Axis(f"angular {kind}", unit), marks, size=SIZES[1])


def index(drop: Drop) -> str:
    """The relaxation index, for the title; of a drop that was cut or caught the expected one."""
    for name in ("relaxation_index", EXPECTED):
        each = drop.measures[name]
        if each.value is not None:
            return f"{each.title} {each.value:.3f}"
    return "no relaxation index"


def rest(drop: Drop) -> tuple[Mark, ...]:
    """The resting angle with its band."""
    found = landmarks(drop, "plateau_angle")[:1]
    levels = [float(np.degrees(each.value)) for each in found]
    half = float(np.degrees(BAND))
    bands = (Band(Role.AT_REST, level - half, level + half) for level in levels)
    return (*bands, *(Rule(Role.RESTING, level) for level in levels))


def swings(drop: Drop) -> tuple[Mark, ...]:
    """Release, turning points and rest, as far as a measure rests on them."""
    flexions = {*landmarks(drop, "number_of_oscillations"), *landmarks(drop, "period")}
    extensions: set[Landmark] = set()
    for name in drop.measures:
        if name.startswith("logarithmic_decrement"):
            flexions |= {*landmarks(drop, name)[1::2]}
            extensions |= {*landmarks(drop, name)[0::2]}
    released = landmarks(drop, "start_angle")
    flexions |= {*landmarks(drop, "first_flexion_amplitude")[1:]}
    return (
        *dots(Role.FLEXION, flexions),
        *dots(Role.EXTENSION, extensions - {*released}),
        *dots(Role.RELEASE, released),
        *dots(Role.CAME, landmarks(drop, "time_to_rest")[1:]),
    )


def spans(drop: Drop) -> tuple[Mark, ...]:
    """A1 and A0 as heights, T and the time to rest as lengths."""
    found = []
    for name, symbol in SPANS:
        for top, bottom in pairs(drop, name):
            low, high = (float(np.degrees(each.value)) for each in (bottom, top))
            found.append(Line(Role.GUIDE, np.array([top.time, bottom.time]), np.full(2, high)))
            found.append(Span((bottom.time, low), (bottom.time, high), symbol))
    for begin, end in pairs(drop, "period"):
        count = round((end.time - begin.time) / (drop.measures["period"].value or 1.0))
        low = float(np.degrees(begin.value)) - BELOW
        name = f"`{count} T`" if count > 1 else "`T`"
        found.append(Span((begin.time, low), (end.time, low), name))
    for begin, end in pairs(drop, "time_to_rest"):
        high = float(np.degrees(begin.value)) + BELOW
        found.append(Span((begin.time, high), (end.time, high), "time to rest"))
    return tuple(found)


def pairs(drop: Drop, name: str) -> list[tuple[Landmark, ...]]:
    """Begin and end of what a measure spans; none where it was not read."""
    found = landmarks(drop, name)
    return [found[:2]] if len(found) > 1 else []


def dots(role: Role, places) -> tuple[Mark, ...]:
    """Landmarks on a curve, in the order of time; nothing where there are none."""
    if not places:
        return ()
    ordered = sorted((each.time, float(np.degrees(each.value))) for each in places)
    return (Points(role, *np.array(ordered).T),)


def landmarks(drop: Drop, name: str) -> tuple[Landmark, ...]:
    """Where a measure was read; none where it was not."""
    return drop.measures[name].marks


def show_drop(drop: Drop, number: int) -> Picture:
    """The angle over time with what was read off it."""
    read = [drop.measures[name] for name in TOLD if drop.measures[name].value is not None]
    words = [f"{each.title} {value(each)} {unit_of(each)}".strip() for each in read]
    said = f"{'; '.join(words).capitalize()}." if words else ""
    dashed = " Dashed: plateau angle; grey: at rest (±2 deg)."
    drifts = (
        f" Everything is read off the angle less a drift of {np.degrees(drop.drift):+.2f} deg/s."
        if drop.drift
        else ""
    )
    return Picture(
        f"drop-{number}",
        f"The angle of segment {drop.name} in deg over time in s, with release, turning points and "
        f"resting angle. {said or 'No amplitude could be read.'}",
        f"Segment {drop.name}. {said}{dashed if landmarks(drop, 'plateau_angle') else ''}{drifts}",
        drop_of(drop)[:1],
    )
