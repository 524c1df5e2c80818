"""`fit`: from recordings of one leg to its parameters."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Literal

import jax
import numpy as np

from exoid.fitting.amount.manageable import TOGETHER, Amount, manageable
from exoid.fitting.asked import (
    PLAIN_SCALE,
    Asked,
    by_name,
    classes_of,
    plainly,
    readings,
    with_aside,
)
from exoid.fitting.data.conditioning import conditioned
from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.fitted_samples import Clip
from exoid.fitting.data.movement import Movement
from exoid.fitting.data.size_of_rig import scale_of
from exoid.fitting.hands.slow_release import is_held, of_slow, without_slow_release
from exoid.fitting.hands.unseen_hands import FEW, without_unseen_hands
from exoid.fitting.model.assumptions import Assumptions, BoundsName, PriorName, by_hand
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.model.user_values import Bounds, Expectations, Fixed
from exoid.fitting.movements import left_out, movements_in
from exoid.fitting.multistart.beginning.begin import begin
from exoid.fitting.multistart.beginning.starts import (
    check_draw,
    term_starts,
)
from exoid.fitting.multistart.search import never, search
from exoid.fitting.multistart.search_result import Plain, SearchResult
from exoid.fitting.one_leg import check_one_leg
from exoid.fitting.result.describing.describe import describe
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.refused.own_swing import hangs_up
from exoid.fitting.result.remarks.pushed.missed_law import lawful
from exoid.fitting.result.remarks.upwards_remarks import UPWARDS, upwards
from exoid.fitting.solve.pose import pose
from exoid.fitting.solve.problem import Problem
from exoid.fitting.unlike_tables import contradicted, strange, without_tables
from exoid.physics.scale import AS_A_LEG, Scale
from exoid.physics.term import SensorTerm, Term
from exoid.recordings.loading.named import RecordingsLike, named_recordings


def fit(
    recordings: RecordingsLike,
    *,
    multistart: int = 64,
    seed: int = 0,
    prior: PriorName = "auto",
    weight: float = 1.0,
    bounds: BoundsName = "body",
    fix: Fixed | None = None,
    bound: Bounds | None = None,
    expect: Expectations | None = None,
    method: Literal["lm", "slsqp"] = "lm",
    smooth: int = 1,
    misfit: Literal["weighted", "paper"] = "weighted",
    clip: Clip = "free",
    at_once: bool = False,
    terms: Asked = (),
    starts: np.ndarray | None = None,
    near: np.ndarray | None = None,
    most: Amount = TOGETHER,
) -> FitResult:
    """Fit one leg to all segments of the recordings (Eq. 9-13).

    `recordings` is one recording (a Recording, what `load` gave, or a path) or a list of them, with
    or without names as (name, recording) pairs; all are of one leg. `weight` is lambda of Eq. 11 in
    standardised units. `bounds` are what a leg of this body can have, or Eq. 13 as the "paper" has
    it. By hand, in printed units: `fix` {"stiffness": 0.0}, `bound` {"damping": (0.0, 20.0)} (None
    leaves an end), `expect` {"damping": (3.0, 1.0)}, a value and its standard deviation in the
    place of the table's. What the sidecar's [fit] says of other parameters holds too. `smooth` is
    the window of Eq. 3 in samples, applied to data and simulation alike. `misfit` "paper" is
    Eq. 11 as printed: the angle alone in rad, and the prior in the parameters' own units. `starts`,
    (start, 6) in the order m, J, l, d, c, tau, replace the draw from the limits by `seed`. `near`
    is such a row that the fit is known to end close to, with `terms` that have values: no start is
    led to the measured motion first. `clip` "paper" keeps what lies between the first and the last
    sample faster than 20 deg/s (Eq. 3-4), in place of what moved freely. `at_once` says that hands
    let go at once: where a recording begins with its release, none is on the leg from the first
    sample on. Else such first instants count where they fit to the rest, and drops that are only
    followed from their greatest speed or their first turn on begin there, unless a term remembers
    what was before. Of recordings with more segments and samples than `most` those are fitted that
    tell most, and `set_aside` of the result says what was not.

    `terms` are what Eq. 9 leaves out and this model has: names or classes of the library
    (`exoid.physics.library`), or classes of your own. An instance says where its search begins.
    Their parameters are fixed, bounded and expected by hand as {"coulomb_friction.level": ...}.

    >>> found = exoid.fit("drops.csv", terms=("coulomb_friction",))
    >>> found.terms["coulomb_friction"]["level"].value < 0.01  # N m
    True

    **Raises** `ValueError` where the recording cannot be fitted or gravity comes out upwards in
    passive segments, `ArithmeticError` where no start succeeded.
    """
    check_draw(multistart, seed)
    named = named_recordings(recordings)
    check_one_leg(named)
    amount = manageable(named, most, average=smooth == 1)
    movements = movements_in(amount.parts, clip=clip)
    plain = misfit == "paper"
    weight *= PLAIN_SCALE**2 if plain else 1.0
    hand = by_hand(named, fix, bound, expect)
    terms = by_name(terms)
    classes = classes_of(terms)
    subject = named[0][1].subject
    scale = scale_of(movements) if subject.kind == "rig" else AS_A_LEG
    belief = believe(subject, Assumptions(prior, weight, plain, bounds, hand), classes, scale)
    if plain:
        movements = [plainly(each) for each in movements]
    chain, movements = conditioned(movements, smooth)

    # What a term remembers is only known of a leg that has not moved yet; a sensor soon forgets it.
    remembering = (each for each in classes if not issubclass(each, SensorTerm))
    at_once = at_once or any(each.memory_size > 0 for each in remembering)
    whole = clip == "free" and not plain
    attempt = Attempt(
        movements=movements,
        chain=chain,
        readings=readings(named, movements),
        terms=terms,
        classes=classes,
        scale=scale,
        multistart=multistart,
        seed=seed,
        starts=starts,
        near=near,
        method=method,
        handled=whole and method == "lm",
        at_once=at_once,
    )
    result, slow = attempt.result(belief)
    if whole and strange(result):
        with suppress(ArithmeticError, ValueError):  # where it finds no leg, the first one stands
            untabled, beside = attempt.result(without_tables(belief))
            if untabled.follows and contradicted(untabled):
                result, slow = untabled, beside
    aside = [*amount.notes, *left_out(amount.parts, movements)]
    return with_aside(result, [*aside, *slow])


@dataclass(frozen=True, eq=False)
class Attempt:
    """What was asked of a fit, but for what is believed of the leg."""

    movements: list[Movement]
    chain: Chain
    readings: tuple[str, ...]  # of Eq. 4, to try
    terms: Sequence[type[Term] | Term]
    classes: tuple[type[Term], ...]  # of these terms
    scale: Scale
    multistart: int
    seed: int
    starts: np.ndarray | None  # (start, 6), in the place of those that are drawn
    near: np.ndarray | None  # (6,), which is close to the end
    method: Literal["lm", "slsqp"]
    handled: bool  # may hands be in it that nobody told of?
    at_once: bool  # do they let go at once?

    def search(
        self,
        belief: Belief,
        movements: list[Movement],
        reading: str,
        plain: Plain | None = None,
    ) -> tuple[Problem, SearchResult]:
        """To these movements; from few starts, where what is missed may make the answer `plain`."""
        count = self.multistart if plain is None else FEW
        if self.starts is None:
            given = begin(movements, belief, reading, count, self.seed)
        else:
            given = self.starts
        if self.near is not None:
            given = np.vstack([self.near, given[1:]])
        problem = pose(movements, belief, reading, self.chain, terms=self.classes)
        own = term_starts(self.terms, movements, len(given), self.scale)
        if self.method == "slsqp":
            return problem, by_slsqp(problem, given, own)
        return search(problem, given, own, near=self.near is not None, plain=plain or never)

    def result(self, belief: Belief) -> tuple[FitResult, list[str]]:
        """The result, and a note of the drops of which the begin was left out.

        **Raises** `ValueError` where gravity comes out upwards.
        """
        each = {reading: self.search(belief, self.movements, reading) for reading in self.readings}
        best = min(each, key=lambda reading: float(each[reading][1].best.misfit[0]))
        found = each[best]
        if self.handled:
            found = without_unseen_hands(
                *found,
                lambda kept: self.search(belief, kept, best),
                lambda kept, plain: self.search(belief, kept, best, plain),
                at_once=self.at_once,
            )
        refuse_upwards(*found)
        others = [describe(*each[other], None, None).angle_rmse for other in each if other != best]
        voluntary = any(one.voluntary for one in self.movements)

        def described(found: tuple[Problem, SearchResult]) -> FitResult:
            return describe(*found, best if voluntary else None, others[0] if others else None)

        result = described(found)
        if not (belief.rig or result.follows) and hangs_up(self.movements):
            raise ValueError(UPWARDS)
        if not self.handled or self.at_once or belief.rig or by_law(result):
            return result, []
        swinging = without_slow_release(
            found,
            lambda kept: self.search(belief, kept, best, is_held),
            lambda found: described(found).follows,
            bent=result.follows,
        )
        if swinging is None:
            return result, []
        found = self.search(belief, swinging, best)
        refuse_upwards(*found)
        return described(found), of_slow(swinging)


def by_law(result: FitResult) -> bool:
    """Does it follow its recording but for a law that damping has, which needs no hand?"""
    basis = result.basis
    if not result.follows or basis is None:
        return False
    return lawful(basis.problem, basis.ended, basis.information.open)


def refuse_upwards(problem: Problem, found: SearchResult) -> None:
    """**Raises** `ValueError` where gravity comes out upwards."""
    if upwards(problem, found):
        raise ValueError(UPWARDS)


def by_slsqp(problem: Problem, starts: np.ndarray, terms: tuple[Term, ...]) -> SearchResult:
    """The search by the reference method."""
    from exoid.fitting.reference.slsqp import search_slsqp

    with jax.enable_x64(True):  # finite differences of a float32 loss lead nowhere
        return search_slsqp(problem, starts, terms)
