"""What the fit of the recordings at hand says of a goal, and what of it no further one narrows."""

from math import hypot, inf, sqrt

from exoid.fitting.result.chief import WORTH
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.ratios import RATIOS
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.added_mass_remarks import of_misplaced
from exoid.fitting.result.remarks.anatomy_remarks import RARE
from exoid.fitting.result.systematics.limiting import limiting
from exoid.planning.next_mountings import information_error, with_recordings
from exoid.planning.planned import AtHand
from exoid.planning.prior_knowledge import PriorKnowledge


def at_hand(known: PriorKnowledge, goal: str, result: FitResult | None) -> AtHand:
    """By the information of a fit, and by what its error holds beside that: what the search cannot
    see, as of a seat that may be tilted, a mass that may hang elsewhere, or times that are off.
    """
    told = information_error(with_recordings(known.prior, known, {}, []), known, goal)
    each = None if result is None else estimate_of(goal, result)
    if each is None:
        return AtHand(told)
    if each.value is None:
        return AtHand(inf)
    if not each.standard_error:  # on a bound
        return AtHand(told, if_slack=each.if_slack)
    stays = sqrt(max(each.standard_error**2 - told**2, 0.0))
    return AtHand(hypot(told, stays), stays, each.if_slack)


def estimate_of(goal: str, result: FitResult) -> Estimate | None:
    """The number that a fit gives of it; None where it gives none of this name."""
    return {**result.parameters, **result.ratios, **result.of_terms}.get(goal)


def remarks_on(goal: str, result: FitResult, now: AtHand, unit: str) -> list[str]:
    """What the fit says that touches the goal, and how much of its error stays."""
    each, basis = estimate_of(goal, result), result.basis
    if each is None or basis is None:
        return []
    said = [note for note in result.notes if RARE in note]
    if goal not in RATIOS:
        said += of_misplaced(basis.problem, basis.ended)
    if each.value is None and each.reason:
        said.append(f"nothing tells {each.symbol} yet: {each.reason}.")
    if now.stays**2 > WORTH * now.error**2 and each.standard_error:
        said.append(
            f"± {now.stays:.2g} {unit} of its error is what no motion of this leg tells: a further "
            "recording like these leaves it."
        )
    if now.if_slack:
        said.append(
            f"± {now.if_slack:.2g} {unit} more where the knee's spring is slack elsewhere than at "
            "full extension (Eq. 9), in the errors expected here, too: the hanging angle without "
            "and with a known mass tells that, and 'exoid diagnose' asks it."
        )
    return [*said, *limiting(result, each)]
