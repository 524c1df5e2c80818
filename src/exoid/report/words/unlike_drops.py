"""What to say of drops of one leg that began, ended or hung otherwise than each other."""

from math import degrees
from statistics import median

from exoid.pendulum.drop import Drop, PendulumTest
from exoid.recordings.landmarks.expected_rest import expected_rest
from exoid.recordings.landmarks.measure import NotAllowed

ALIKE = 5.0  # deg, by which drops that were meant to begin, or to rest, alike differ
SURE = 3.0  # standard errors
FEWEST = 3  # drops, most of which hang alike
EXPECTED, INDEX = "expected_relaxation_index", "relaxation_index"
START, SWING = "start_angle", "first_flexion_amplitude"


def of_mixed_starts(test: PendulumTest) -> str | None:
    """Which means hang on where the drops began; None where they began alike."""
    if "start_angle" not in test.average:
        return None
    alike = test.average["start_angle"].drops
    read = (drop.measures["start_angle"].value for drop in test.drops if drop.name in alike)
    starts = [degrees(each) for each in read if each is not None]
    lowest, highest = min(starts), max(starts)
    if highest - lowest < ALIKE:
        return None
    return (
        f"These drops began between {lowest:.0f} and {highest:.0f} deg: amplitudes, oscillations, "
        "time to rest, peak velocities and accelerations grow with the height of the release, and "
        "scatter with it. Indices, period and decrements hardly do, but where friction or a reflex "
        "acts."
    )


def of_mixed_ends(test: PendulumTest) -> str | None:
    """That first swings end at a halt in some drops and not in others, which no mean of them is of;
    None where they end alike.
    """
    if INDEX not in test.average:
        return None
    alike = [drop for drop in test.drops if drop.name in test.average[INDEX].drops]
    ends = [[drop for drop in alike if drop.ends_above == above] for above in (True, False)]
    if not all(ends):
        return None
    halted, lowest = map(over, ends)
    return (
        "Amplitude and indices of the first swing, and what follows it, mix two kinds of ends: "
        f"where the leg first turns back, as by a stretch reflex or a stop, in {halted}; at its "
        f"lowest angle in {lowest} (mean relaxation index). Compare drops that end alike."
    )


def of_unlike_rests(test: PendulumTest) -> str | None:
    """Whose swings shrink to another angle than those of most that the thigh lay in alike; None
    where none do.
    """
    alike = test.average[EXPECTED].drops if EXPECTED in test.average else ()
    read = [drop for drop in test.drops if drop.name in alike]
    thighs = sorted({drop.thigh_angle for drop in read})
    groups = ([drop for drop in read if drop.thigh_angle == thigh] for thigh in thighs)
    where = [said for group in groups if (said := of_unlike(group))]
    if not where:
        return None
    return (
        f"Swings shrink to {'; '.join(where)}. A relaxed leg hangs alike in all: a muscle or a "
        "hand held it while it swung, or the thigh lay otherwise, and its indices are of that; or "
        "the angle's zero moved, as where a strap slips, and its indices hold."
    )


def of_unlike(drops: list[Drop]) -> str | None:
    """To where the swings of those shrink that are unlike the most, and of these."""
    if len(drops) < FEWEST:
        return None
    rests = {drop.name: rest_of(drop) for drop in drops}
    usual = float(median(rest for rest, _ in rests.values()))
    unlike = {
        name: rest
        for name, (rest, error) in rests.items()
        if abs(rest - usual) > max(ALIKE, SURE * error)
    }
    if not unlike:
        return None
    where = ", ".join(f"{rest:.0f} deg in segment {name}" for name, rest in unlike.items())
    others = ", ".join(name for name in rests if name not in unlike)
    return f"{where}, and to about {usual:.0f} deg in {others}" if others else where


def rest_of(drop: Drop) -> tuple[float, float]:
    """The angle that its swings shrink to, beside where friction may hold it, and its error [deg];
    of one that swings too few times, where it came to rest.
    """
    try:
        assert drop.landmarks is not None  # of a drop that has an index
        rest = expected_rest(drop.landmarks.turns)
        return degrees(rest.value), degrees(rest.error)
    except NotAllowed:
        index = drop.measures[EXPECTED]
    start, swing, found = (drop.measures[name].value or 0.0 for name in (START, SWING, EXPECTED))
    amplitude = degrees(swing) / found
    return degrees(start) - amplitude, amplitude * (index.standard_error or 0.0) / found


def over(drops: list[Drop]) -> str:
    """Some segments, and their mean relaxation index."""
    read = [each for drop in drops if (each := drop.measures[INDEX].value) is not None]
    return f"segment {', '.join(each.name for each in drops)} ({sum(read) / len(read):.3g})"
