"""What is believed of this leg before it moves: the prior and the limits of a fit."""

from dataclasses import replace
from typing import TypeAlias

import numpy as np

from exoid.fitting.model.assumptions import Assumptions, BoundsName, PriorName
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.limits import (
    Limits,
    Prior,
    limits_by_hand,
    limits_of,
    paper_limits,
    rig_limits,
)
from exoid.fitting.model.prior import joint_prior, no_prior, own_units, with_own
from exoid.fitting.model.term_parameters import parameters_of, term_of
from exoid.fitting.model.user_values import ByHand
from exoid.physics.anatomy import (
    Body,
    ExpectedLeg,
    expected_leg,
    known_leg,
    measured_leg,
    paper_prior,
    reach,
)
from exoid.physics.anatomy.limits import allowed, anybody, strongest
from exoid.physics.parameter import Declaration
from exoid.physics.scale import AS_A_LEG, Scale, ranged
from exoid.physics.term import Term
from exoid.recordings.declared.subject import Subject

TALL = 2.0  # m; the reach of a leg whose height is unknown
DECADES = "d and c: a twentieth to twenty times a relaxed knee's"


def believe(
    subject: Subject,
    assumed: Assumptions | None = None,
    terms: tuple[type[Term], ...] = (),
    scale: Scale = AS_A_LEG,
) -> Belief:
    """Expected parameters from body mass and height, else from a measured mass and COM distance.

    A rig has neither prior nor limits but that it does not make energy, and what is said by hand.
    `terms` keep the limits that they declare, a rig's by its `scale`.

    **Raises** `ValueError` where something is said by hand of a term that is not in the model, or
    that it cannot have.
    """
    assumed = Assumptions() if assumed is None else assumed
    hand = assumed.by_hand
    if subject.kind == "rig":
        found = Belief("none", None, no_prior(), rig_limits(), "a rig: no anatomy is assumed")
    else:
        expected, note = expectation(subject, assumed.prior)
        own = told_of(subject, hand)
        expected = None if expected is None else known_leg(expected, *own)
        limits = leg_limits(subject, assumed.bounds, own)
        name = "none" if expected is None else assumed.prior
        prior = prior_of(expected, assumed)
        found = Belief(name, expected, prior, limits, note, assumed.raw and expected is not None)
    declared = {name: ranged(each, scale) for name, each in parameters_of(terms)}
    check_known(hand.terms, declared)
    prior = replace(
        found.prior,
        terms=tuple(term_of(term, lambda *_: 0.0) for term in terms),
        terms_deviation=tuple(term_of(term, lambda *_: np.inf) for term in terms),
    )
    return replace(
        found,
        prior=with_own(prior, hand.prior, assumed.weight),
        limits=term_limits(limits_by_hand(found.limits, hand.leg), terms, hand, scale),
        note="; ".join([found.note, *(f"yours: {words}" for words in hand.words(declared))]),
        bounds=assumed.bounds,
        by_hand=hand,
    )


def check_known(hand: ByHand, declared: dict[str, Declaration]) -> None:
    """Refuse what is said of a parameter that no term of the model has, or of a value beyond it."""
    for name in hand.names:
        if name not in declared:
            known = f"it has {', '.join(declared)}" if declared else "it has no terms"
            raise ValueError(
                f"{name} is no parameter of this model: {known}. Add its term, "
                f"{name.partition('.')[0]}, or check the name."
            )
    for name, value in hand.fix.items():
        one = declared[name]
        if not one.lower <= value <= one.upper:
            raise ValueError(
                f"fix of {name}: {value:g} {one.unit} cannot be; it is {one.lower:g} to "
                f"{one.upper:g} {one.unit}."
            )


def term_limits(
    limits: Limits, terms: tuple[type[Term], ...], hand: ByHand, scale: Scale
) -> Limits:
    """The limits with what the terms declare, narrowed or fixed by hand."""

    def model(end: int) -> tuple[Term, ...]:
        return tuple(
            term_of(term, lambda name, declared: ends_of(name, ranged(declared, scale), hand)[end])
            for term in terms
        )

    return replace(limits, lower_terms=model(0), upper_terms=model(1))


def ends_of(name: str, declared: Declaration, hand: ByHand) -> tuple[float, float]:
    """The lower and the upper end of what a term's parameter can be."""
    if name in hand.fix:
        return hand.fix[name], hand.fix[name]
    low, high = hand.bound.get(name, (None, None))
    lower = declared.lower if low is None else max(low, declared.lower)
    upper = declared.upper if high is None else min(high, declared.upper)
    if not lower < upper:
        raise ValueError(
            f"bound of {name}: nothing is left of {declared.lower:g} to {declared.upper:g} "
            f"{declared.unit}, which it can have."
        )
    return lower, upper


def prior_of(expected: ExpectedLeg | None, assumed: Assumptions) -> Prior:
    """The prior around what is expected: joint in logarithms, or one by one in own units."""
    if expected is None:
        return no_prior()
    if assumed.raw or expected.covariance is None:
        return own_units(expected, assumed.weight, unit=assumed.raw)
    return joint_prior(expected, assumed.weight)


def expectation(subject: Subject, name: PriorName) -> tuple[ExpectedLeg | None, str]:
    """What anatomy expects, and where that comes from in words."""
    if name == "none":
        return None, "no prior, as asked"
    body_mass, height = subject.body_mass, subject.height
    if body_mass is not None and height is not None:
        if name == "paper":
            return paper_prior(body_mass, height), "Eq. 14 of the original paper, scaled"
        length, age = subject.shank_length, subject.age
        leg = expected_leg(body_mass, height, table=name, age=age, shank_length=length)
        return leg, f"{leg.source}, {body_mass:g} kg and {height:g} m; {DECADES}"
    mass, distance = subject.shank_foot_mass, subject.com_distance
    if mass is not None and distance is not None:
        return measured_leg(mass, distance), f"shank_foot_mass_kg and com_distance_m; {DECADES}"
    known = {"body mass": body_mass, "height": height}
    missing = " and ".join(name for name, value in known.items() if value is None)
    return None, (
        f"{missing} unknown, so absolute values stay open: tell them (--body-mass KG, --height M)"
    )


Own: TypeAlias = tuple[float | None, float | None]


def told_of(subject: Subject, hand: ByHand) -> Own:
    """m [kg] and l [m] of this leg where they are known otherwise than by its body: what is fixed
    or expected by hand before what the sidecar says.
    """

    def of(name: str, declared: float | None) -> float | None:
        expected = hand.prior[name][0] if name in hand.prior else declared
        return hand.fix.get(name, expected)

    return of("mass", subject.shank_foot_mass), of("com_distance", subject.com_distance)


def leg_limits(subject: Subject, bounds: BoundsName = "body", own: Own | None = None) -> Limits:
    """What this body's leg can be, any human's where the body is unknown; or Eq. 13 as printed.
    Where m or l are its `own`, the others follow from those.

    The reach is that of the height; Eq. 13 has none.
    """
    if bounds == "paper":
        return paper_limits()
    body = body_of(subject)
    mass, distance = told_of(subject, ByHand()) if own is None else own
    if body is not None:
        leg = expected_leg(body.mass, body.height, age=body.age, shank_length=subject.shank_length)
        each = allowed(known_leg(leg, mass, distance))
    elif mass is not None and distance is not None:
        each = allowed(measured_leg(mass, distance))
    else:
        each = anybody()
    tall = TALL if subject.height is None else subject.height
    return limits_of(each, strongest(body), reach(tall))


def body_of(subject: Subject) -> Body | None:
    """None where mass or height is unknown."""
    if subject.body_mass is None or subject.height is None:
        return None
    return Body(subject.body_mass, subject.height, age=subject.age)
