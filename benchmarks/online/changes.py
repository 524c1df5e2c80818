"""Another leg, and none: how soon a change is found, and how often one is reported for nothing."""

from dataclasses import replace

import numpy as np
from benchmarks.online import world

import exoid
from exoid import online

TOLD = 2  # drops of a leg before it becomes another
SHARE = 0.4  # by which its mass and inertia grow
DROPS = 40  # of a session for false alarms


def draw(seed: int) -> tuple[np.random.Generator, world.Leg, world.Sensors]:
    rng = np.random.default_rng([7, seed])
    sensors = world.draw_sensors(rng)
    return rng, replace(world.draw_leg(rng), tilt=sensors.tilt), sensors


def found(seed: int) -> float | None:
    """s after its release at which a heavier leg is found; None where it is not in that drop."""
    rng, leg, sensors = draw(seed)
    motion, free = world.session(rng, [leg] * TOLD + [leg.heavier(SHARE)])
    samples = online.Sample(*world.measured(rng, motion, sensors))
    _, said = online.replay(online.init(exoid.expected_leg(77.0, 1.80)), samples)
    changed = np.flatnonzero(said.trust == online.Trust.CHANGED)
    if changed.size == 0 or samples.time[changed[0]] < free[-1][0]:
        return None
    return float(samples.time[changed[0]] - free[-1][0])


def alarms(seed: int) -> tuple[float, dict[online.Trust, int], int]:
    """Hours of one and the same leg, how often something was said to be wrong, and drops missed."""
    rng, leg, sensors = draw(seed)
    motion, free = world.session(rng, [leg] * DROPS)
    time, angle, rate = world.measured(rng, motion, sensors)
    _, said = online.replay(
        online.init(exoid.expected_leg(77.0, 1.80)), online.Sample(time, angle, rate)
    )
    begun = np.diff(said.trust, prepend=0) != 0
    wrong = (online.Trust.CHANGED, online.Trust.UNEXPLAINED, online.Trust.FAULTY)
    count = {each: int(np.sum(begun & (said.trust == each))) for each in wrong}
    return time[-1] / 3600, count, len(free) - int(said.drops[-1])


def report(legs: int, hours: float) -> str:
    delays = [found(seed) for seed in range(legs)]
    known = [each for each in delays if each is not None]
    total, count, missed, seed = 0.0, {}, 0, 0
    while total < hours:
        lasted, one, gone = alarms(seed)
        total, seed, missed = total + lasted, seed + 1, missed + gone
        count = {each: count.get(each, 0) + number for each, number in one.items()}
    alarms_said = ", ".join(f"{each.name.lower()} {number}" for each, number in count.items())
    return (
        f"\na leg whose mass and inertia grow by 40 %: found in {len(known)} of {legs} within its "
        f"first drop, {np.median(known):.1f} s after the release\n"
        f"{total:.1f} h of {seed} legs that stay the same: {alarms_said}; "
        f"{missed} of {seed * DROPS} drops not counted"
    )
