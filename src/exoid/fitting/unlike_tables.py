"""A leg that swings too fast for its body: then no table of anatomy says anything of it.

A stump or a light prosthesis: what the tables expect, and the limits that they draw, would pull the
ratios that its motion tells. One that swings too slowly has mass beyond its toes, which no leg has.
"""

from dataclasses import replace

from exoid.fitting.model.belief import Belief
from exoid.fitting.model.limits import limits_of
from exoid.fitting.model.prior import no_prior
from exoid.fitting.result.agreement import astray, believed, root_mean_square, simulated
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.anatomy_remarks import SWING, from_anatomy
from exoid.fitting.result.untold import if_times_right
from exoid.fitting.solve.ask import lowest, take
from exoid.physics.anatomy.expected import STRANGE
from exoid.physics.anatomy.limits import anybody

LEFT_OUT = "none, for the motion speaks against it; expected would be"


def strange(result: FitResult) -> bool:
    """Is the leg that a fit has too short for this body? Its tables may have bent it, but for what
    no leg at all follows.
    """
    return too_short(result, 0.0) and (result.follows or followed_freely(result))


def followed_freely(result: FitResult) -> bool:
    """Does the best of the free fits follow, which neither tables nor limits touch?"""
    assert result.basis is not None  # `too_short` asks it
    problem, ended = result.basis.problem, result.basis.ended
    angle = take(ended.free.angle, [lowest(ended.free)])
    missed = [simulated(problem, angle, n) - each.angle for n, each in enumerate(result.segments)]
    segments = [
        replace(each, angle_rmse=root_mean_square(off))
        for each, off in zip(result.segments, missed, strict=True)
    ]
    return astray(believed(segments, ended.disturbance)) is None


def contradicted(result: FitResult) -> bool:
    """Does the motion contradict the tables of this body, by more than its error?"""
    return too_short(result, if_times_right(result).standard_error or 0.0)


def too_short(result: FitResult, error: float) -> bool:
    """Is J / (m l) less than that of all but one in a thousand legs of this body?"""
    gravity = result.ratios[SWING].value
    if result.basis is None or gravity is None:
        return False
    return from_anatomy(result.basis.problem.belief, gravity, error) < -STRANGE


def without_tables(belief: Belief) -> Belief:
    """The same without what the tables say of this body's leg, but to be compared with: its limits
    are those of any human.
    """
    old, limits = belief.prior, belief.limits
    prior = replace(
        no_prior(), weight=old.weight, terms=old.terms, terms_deviation=old.terms_deviation
    )
    if belief.bounds == "body":
        wide = limits_of(anybody(), float(limits.torque), float(limits.reach))
        limits = replace(limits, lower=wide.lower, upper=wide.upper)
    note = f"{LEFT_OUT}: {belief.note}"
    return replace(belief, prior=prior, limits=limits, note=note, untabled=True)
