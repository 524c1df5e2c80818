"""A torque as a sum of what hangs on the angle, on the rate, and on time alone."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from exoid.interchange.formula.expression import Expression, evaluate

Curve = Callable[[np.ndarray], np.ndarray]
LOWEST, HIGHEST = -2.7, 0.3  # rad, where a knee comes
FASTEST = 15.0  # rad/s, of a leg
LONGEST = 10.0  # s
SAMPLES = 201
EXACT = 1e-10  # relative, to which a sum is one


@dataclass(frozen=True)
class Sum:
    """constant + by_angle(angle) + by_rate(rate) + by_time(time) [N m]; each is 0 where it is 0."""

    constant: float
    by_angle: Curve | None
    by_rate: Curve | None
    by_time: Curve | None


def by_variable(torque: Expression, constants: Mapping[str, float]) -> Sum | None:
    """The torque as such a sum; None where it is none, is no number somewhere, or hangs on more."""
    names = torque.symbols
    if not names <= {*constants, "angle", "rate", "time"}:
        return None

    def at(angle: object = 0.0, rate: object = 0.0, time: object = 0.0) -> np.ndarray:
        with np.errstate(all="ignore"):  # where a formula is no number, it is refused
            found = evaluate(torque, {**constants, "angle": angle, "rate": rate, "time": time})
        return np.asarray(found)

    constant = float(at())
    random = np.random.default_rng(0)
    angle = random.uniform(LOWEST, HIGHEST, SAMPLES)
    rate = random.uniform(-FASTEST, FASTEST, SAMPLES)
    time = random.uniform(0.0, LONGEST, SAMPLES)
    alone = at(angle) + at(rate=rate) + at(time=time) - 2 * constant
    whole = at(angle, rate, time)
    if not np.abs(whole - alone).max() <= EXACT * np.abs(whole).max() < np.inf:
        return None
    return Sum(
        constant,
        (lambda angle: at(angle) - constant) if "angle" in names else None,
        (lambda rate: at(rate=rate) - constant) if "rate" in names else None,
        (lambda time: at(time=time) - constant) if "time" in names else None,
    )


def odd_powers(curve: Curve, furthest: float) -> tuple[float, float, float] | None:
    """a, b, c of a x + b x |x| + c x^3, which is what MuJoCo's springs and dampers are; None where
    the curve is no such sum.
    """
    x = np.linspace(-furthest, furthest, SAMPLES)
    powers = np.stack([x, x * np.abs(x), x**3], axis=1)
    wanted = curve(x)
    found = np.linalg.lstsq(powers, wanted)[0]
    size = np.abs(wanted).max()
    if np.abs(powers @ found - wanted).max() > EXACT * max(size, 1e-300):
        return None
    small = EXACT * size / np.abs(powers).max(axis=0)
    a, b, c = np.where(np.abs(found) < small, 0.0, found).tolist()
    return a, b, c
