"""What to record next: the recording that narrows a quantity most, with the error to expect."""

import math

from exoid.fitting.model.assumptions import Assumptions
from exoid.fitting.model.systematics import PLACED, WEIGHED
from exoid.fitting.model.term_parameters import parameters_of, ratio_name, ratio_unit
from exoid.fitting.result.estimates.ratios import RATIOS
from exoid.fitting.result.estimates.scale import MASS_AND_DISTANCE
from exoid.fitting.result.fit_result import FitResult
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.planning.at_hand import at_hand, remarks_on
from exoid.planning.candidate_recordings import candidates, moving
from exoid.planning.expected_information import ENOUGH, Design, informations
from exoid.planning.planned import AtHand, Candidate, Option, Plan
from exoid.planning.prior_knowledge import PriorKnowledge, from_anatomy, from_result
from exoid.recordings.declared.subject import Subject
from exoid.trust.legs import strangers


def plan(
    result: FitResult | None,
    subject: Subject,
    goal: str = "inertia",
    *,
    assumed: Assumptions | None = None,
) -> Plan:
    """The segments to record next for `goal`, after `result`, or with nothing yet.

    The goal is a parameter of the leg, or the ratio to the inertia of its gravity, stiffness or
    damping, such as "damping_over_inertia"; or a parameter of one of the fit's terms, such as
    "coulomb_friction.level".

    Before any fit the prior is `assumed`, by default that of the body. The error `before` is that
    of the fit; what of it no further recording narrows, `stays`. After a fit that does not follow
    its recording nothing is planned.

    **Raises** `ValueError` where the goal is no quantity of a leg, is fixed, or the subject is a
    rig.

    >>> result = exoid.fit("drops.csv")
    >>> wanted = exoid.plan(result, exoid.load("drops.csv").recording.subject, "inertia")
    >>> wanted.after < wanted.before  # kg m^2
    True
    """
    check_subject(subject)
    known = from_anatomy(subject, assumed) if result is None else from_result(result)
    if goal not in known.quantities:
        raise ValueError(f"the goal is {goal!r}; it can be {', '.join(known.quantities)}.")
    if goal in known.belief.by_hand.fix:
        raise ValueError(f"{goal} is fixed by you: there is nothing to narrow.")
    symbol, unit = named(goal, known)
    if result is not None and not result.follows:
        return nothing(goal, symbol, unit, [*result.notes[:1], *strangers(result)])
    every = candidates(subject.height, known.torque)
    now = at_hand(known, goal, result)
    design = Design(known, goal, informations(known, moving(every, known)), now)
    proposed = design.greedy()
    single = [Option(each, design.error([each])) for each in design.told]
    return Plan(
        goal=goal,
        symbol=symbol,
        unit=unit,
        value=design.value,
        before=design.error([]),
        after=design.error(proposed),
        proposed=proposed,
        options=sorted(single, key=lambda option: option.error),
        sentences=[
            *([] if result is None else strangers(result)),
            *([] if result is None else remarks_on(goal, result, now, unit)),
            *advice(goal, known, proposed, now, enough=design.enough([])),
        ],
        stays=now.stays,
        if_slack=now.if_slack,
    )


def check_subject(subject: Subject) -> None:
    """**Raises** `ValueError` of a rig, for which no quantity is planned."""
    if subject.kind == "rig":
        raise ValueError("plans are made for legs; a rig can be taken apart and weighed.")


def nothing(goal: str, symbol: str, unit: str, sentences: list[str]) -> Plan:
    """Of a fit that has no numbers from which to plan."""
    return Plan(goal, symbol, unit, math.nan, math.inf, math.inf, [], [], sentences)


def named(goal: str, known: PriorKnowledge) -> tuple[str, str]:
    """Symbol and unit."""
    for name, declared in parameters_of(known.classes):
        if goal == name:
            return declared.symbol, declared.unit
        if goal == ratio_name(name, declared):
            return f"{declared.symbol} over J", ratio_unit(declared)
    if goal in RATIOS:
        symbol, _, unit = RATIOS[goal]
        return symbol, unit
    declared = dict(declarations(LegParameters))[goal]
    return declared.symbol, declared.unit


def advice(
    goal: str, known: PriorKnowledge, proposed: list[Candidate], now: AtHand, *, enough: bool
) -> list[str]:
    """Why, and what to mind."""
    said = []
    missed = known.disturbance is not None and known.disturbance.cause is not None
    if known.belief.expected is None:
        said.append(
            "body mass and height are unknown, so the plan is made for a typical adult and "
            "absolute values have no prior: tell them (--body-mass KG, --height M)."
        )
    if enough and not known.checked:
        said.append(
            f"its error is below {ENOUGH:.1%} already, but it rests on one movement that nothing "
            "checks: a second one shows whether the first can be believed."
        )
    elif enough and (missed or now.if_slack):
        said.append(
            f"its ± is below {ENOUGH:.1%} already: what is said here beside it counts more, and no "
            "further recording like these tells it."
        )
    elif enough:
        said.append(f"it is known to better than {ENOUGH:.1%} already: nothing more is needed.")
    elif goal in ("mass", "com_distance"):
        said.append(f"{MASS_AND_DISTANCE}: a drop narrows {goal} only as far as the prior goes.")
    if not proposed and not enough:
        said.append("no recording of this kind would narrow it noticeably.")
    if any(each.motion.added_mass for each in proposed):
        said.append(
            "J, c and d are as wrong as the added mass, and no fit shows it: the errors allow for "
            f"{WEIGHED:.1%} of its weight and {1e3 * PLACED:.0f} mm of its distance, unless the "
            "sidecar says how well it was weighed and placed."
        )
    if missed:
        said.append(
            "the model misses something in the recordings at hand, and no error bar of such a "
            "model is complete: 'exoid diagnose' asks what. The new one is expected to be missed "
            "as much, and its errors to be as wide."
        )
    return said
