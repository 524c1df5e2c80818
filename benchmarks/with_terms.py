"""Do 95 % intervals hold the leg where the model has the right term beside Eq. 9?

python -m benchmarks.with_terms [--legs 200] [--seed 0] [--found]

Legs as the prior has them, three drops each on the virtual exoskeleton, with dry friction, drag, a
rest angle, compliant cuffs, or a gyro of wrong scale, a fifth each. The term is told to the fit;
with --found it is what a diagnosis names, and a leg of which it cannot tell counts as not held.
"""

import argparse

import jax
import numpy as np
from benchmarks.sbc.people import SUBJECT, person

import exoid
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.library import library
from exoid.physics.term import Term, name_of
from exoid.physics.torque import NoTorque
from exoid.recordings.recording import Recording
from exoid.twin.motion import Movement
from exoid.twin.protocols import record

INTERVAL = 1.96  # standard errors
STARTS = 4
DROPS = tuple(Movement(angle, 5.0) for angle in (-0.2, -0.5, -0.9))  # rad, s
SIZES: dict[str, tuple[tuple[float, float], ...]] = {
    "coulomb_friction": ((0.05, 0.5),),
    "quadratic_drag": ((0.02, 0.2),),
    "stiffness_rest_angle": ((-1.2, -0.3),),
    "cuff_compliance": ((0.01, 0.05), (0.02, 0.05), (0.5, 1.2), (0.05, 0.2), (0.2, 0.4)),
    "gyro_scale": ((-0.05, 0.05),),
}  # each parameter's range, in its unit
RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


def drawn(rng: np.random.Generator, name: str) -> Term:
    """The term, its parameters anywhere in their ranges."""
    (term,) = [each for each in library() if name_of(each) == name]
    return term(*(np.asarray(rng.uniform(*ends)) for ends in SIZES[name]))


def recorded(rng: np.random.Generator, leg: LegParameters, term: Term) -> Recording:
    """Drops of a leg with it."""
    key = jax.random.key(int(rng.integers(2**31)))
    return record(LegModel(leg, NoTorque(), terms=(term,)), DROPS, key, subject=SUBJECT)


def distances(result: exoid.FitResult, leg: LegParameters) -> dict[str, float]:
    """(estimate - truth) / standard error of J and of the ratios."""
    ratios = LegModel(leg, NoTorque()).ratios()
    truth = dict(zip(RATIOS, (ratios.gravity, ratios.stiffness, ratios.damping), strict=True))
    truth["inertia"] = leg.inertia
    each = result.parameters | result.ratios
    return {name: away(each[name], float(value)) for name, value in truth.items()}


def away(estimate, truth: float) -> float:
    """In standard errors; infinite where none is quoted."""
    if estimate.value is None or not estimate.standard_error:
        return np.inf
    return (estimate.value - truth) / estimate.standard_error


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--legs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--found", action="store_true")
    asked = parser.parse_args()
    rng = np.random.default_rng(asked.seed)
    found: dict[str, list[dict[str, float]]] = {name: [] for name in SIZES}
    for number in range(asked.legs):
        name = list(SIZES)[number % len(SIZES)]
        leg, term = person(rng), drawn(rng, name)
        recording = recorded(rng, leg, term)
        if asked.found:
            result = exoid.diagnose(recording, multistart=STARTS).fit
        else:
            result = exoid.fit(recording, multistart=STARTS, terms=(type(term),))
        found[name].append(distances(result, leg))
        print(number, name, {key: round(z, 2) for key, z in found[name][-1].items()}, flush=True)
    for name, each in {**found, "all": [one for own in found.values() for one in own]}.items():
        held = {key: np.mean([abs(one[key]) < INTERVAL for one in each]) for key in each[0]}
        print(f"{name:22}" + "".join(f"{key} {100 * part:5.1f} %  " for key, part in held.items()))


if __name__ == "__main__":
    from exoid.fitting.solve.program_cache import keep_programs_in

    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
    main()
