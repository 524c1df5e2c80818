"""Where the starts of a search begin."""

import numpy as np

from exoid.fitting.data.movement import Movement, all_driven
from exoid.fitting.model.belief import NAMES, Belief
from exoid.fitting.multistart.beginning.starts import draw, driven, informed

MIDDLING = {"mass": 4.0, "inertia": 0.4}  # kg, kg m^2: where nothing is expected


def begin(
    movements: list[Movement], belief: Belief, reading: str, count: int, seed: int
) -> np.ndarray:
    """The starts: two informed ones, from anatomy and from inverse dynamics, the rest drawn."""
    starts, typical = draw(count, seed, belief.limits), belief.typical
    if typical.keys() >= {*NAMES}:
        starts[0] = [*(typical[name] for name in NAMES), 0.0]
    mass, inertia = (typical.get(*each) for each in MIDDLING.items())
    if belief.rig and all_driven(movements):
        guess = driven(movements, mass)
    else:
        guess = informed(movements, reading, mass, inertia)
    if count > 1 and guess is not None:
        starts[1] = guess
    return starts
