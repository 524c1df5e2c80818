"""Do 95 % intervals hold m, l, J, d and c of people whom no table was made of?

python -m benchmarks.calibration [--people 300] [--seed 0]

Adults, children, obese and spastic people, a quarter each, with one to four drops; legs by
`people.py`. Body mass and height are given, nothing else.
"""

import argparse

import numpy as np
from benchmarks.people import ANGLE_NOISE, KINDS, VELOCITY_NOISE, Person, drop, person

from exoid.fitting.estimate import fit
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

NAMES = ("mass", "com_distance", "inertia", "damping", "stiffness")
INTERVAL = 1.96  # standard errors
STARTS = 2
SWING = np.radians(15.0)  # a release from near the rest is no drop


def recording(rng: np.random.Generator, one: Person, drops: int) -> Recording:
    """So many drops of a person, from various angles."""
    segments = []
    while len(segments) < drops:
        time, angle, velocity = drop(rng, one, np.radians(rng.uniform(-45, 0)))
        if np.ptp(angle) > SWING:
            segments.append(Segment(time, raw_angle=angle, raw_angular_velocity=velocity))
    return Recording(
        tuple(segments),
        Subject(kind="leg", body_mass=one.body_mass, height=one.height),
        Protocol(kind="passive"),
        Sensors(angle_noise=ANGLE_NOISE, velocity_noise=VELOCITY_NOISE),
    )


def scores(people: int, seed: int, drops: tuple[int, ...] = (1, 2, 3, 4)) -> dict[str, np.ndarray]:
    """(estimate - truth) / standard error of every parameter: (kind, person, parameter)."""
    rng = np.random.default_rng(seed)
    found: dict[str, list[list[float]]] = {kind: [] for kind in KINDS}
    for number in range(people):
        kind = KINDS[number % len(KINDS)]
        one = person(rng, kind)
        count = drops[number // len(KINDS) % len(drops)]
        parameters = fit(recording(rng, one, count), multistart=STARTS).parameters
        found[kind].append([distance(parameters[name], getattr(one, name)) for name in NAMES])
    return {kind: np.array(each) for kind, each in found.items()}


def distance(estimate, truth: float) -> float:
    """In standard errors; infinite where a bound was met instead."""
    if estimate.value is None or not estimate.standard_error:
        return np.inf
    return (estimate.value - truth) / estimate.standard_error


def covered(z: np.ndarray) -> np.ndarray:
    return np.mean(np.abs(z) < INTERVAL, axis=0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=int, default=300)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    found = scores(asked.people, asked.seed)
    print(f"{'':10}" + "".join(f"{name:>14}" for name in NAMES))
    for kind, z in {**found, "all": np.concatenate(list(found.values()))}.items():
        print(f"{kind:10}" + "".join(f"{100 * part:12.1f} %" for part in covered(z)))
        means = "".join(
            f"{m:6.2f} ±{s:5.2f} " for m, s in zip(np.mean(z, 0), np.std(z, 0), strict=True)
        )
        print(f"{'  z':10}{means}")


if __name__ == "__main__":
    import jax

    from exoid.fitting.solve.program_cache import keep_programs_in

    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
    main()
