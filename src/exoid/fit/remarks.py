"""What the user should know of a fit, in sentences."""

import numpy as np

from exoid.fit.disturbance import Disturbance
from exoid.fit.multistart import FEASIBLE, Ended
from exoid.fit.problem import Problem

NOISY = 1.1  # over the declared noise, from where on it is worth a word
INCOMPLETE = "no error bar of a model that misses something is complete"


def remarks(problem: Problem, ended: Ended, at_bound: set[str]) -> list[str]:
    """How segments were taken, what the residual holds, and which limits decided."""
    said = []
    guessed = [each for each in problem.movements if not each.kind_said]
    rig = not np.isfinite(problem.belief.limits.reach)
    if guessed:
        each = ", ".join(f"{one.name} {one.kind}" for one in guessed)
        said.append(f"the sidecar does not say how the leg was moved; by its motion: {each}.")
    said += of_residual(ended.disturbance)
    if ended.disturbance.cause is not None and not rig:
        said.append(
            "m l g / J and c / J hold for a spring that is slack at full extension (Eq. 9). "
            "With another rest angle they trade off against each other by more than their "
            "errors say: drops from several angles, or with a known mass, tell them apart."
        )
    if rig:
        said.append(
            "on a rig the spring term c phi also takes up a constant torque and an encoder zero "
            "that is off: read c / J as a spring only where a spring is known to be."
        )
    if float(ended.best.violation[0]) > FEASIBLE:
        said.append("the limits could not all be met: see the bounds in the table.")
    for rule in ("m l^2 <= J", "J <= reach m l"):
        if rule in at_bound:
            said.append(f"the fit lies on the limit {rule} of a rigid leg.")
    return said


def of_residual(found: Disturbance) -> list[str]:
    """What besides the declared noise is in the residual, and what that does to the errors."""
    said = []
    least, most = found.widening.min(), found.widening.max()
    if found.cause == "torque":
        said.append(
            "the residual is more than the sensors' noise: the model misses something. It is what "
            f"a random torque of J times {found.deviation:.2g} rad/s^2 (one sd), correlated over "
            f"about {found.correlation_time:g} s, would leave. Standard errors are widened for it, "
            f"{least:.2g} to {most:.2g} times; {INCOMPLETE}, and --plot shows where it misses."
        )
    if found.cause == "encoder":
        said.append(
            "the residual is more than the sensors' noise: it is what an encoder that errs by "
            f"{np.degrees(found.deviation):.2g} deg (one sd), varying over about "
            f"{found.correlation_time:g} s, would leave. Standard errors are widened for it, "
            f"{least:.2g} to {most:.2g} times; {INCOMPLETE}, and --plot shows where."
        )
    if found.cause is None and found.noise > NOISY:
        said.append(
            f"the residual is white but {found.noise:.3g} times the declared noise, and standard "
            "errors are widened by that: check the noise levels in the sidecar."
        )
    return said
