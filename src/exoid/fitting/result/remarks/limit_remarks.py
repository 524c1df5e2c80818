"""Which limits decided a fit, in sentences."""

from exoid.fitting.model.belief import Belief
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.recordings.conventions.angle_convention import ON_ITS_SIDE

REACH = "J <= reach m l"
RULES = {
    "m l^2 <= J": "that J of a rigid leg is at least m l^2",
    REACH: "that J / (m l) of a leg is no longer than the leg from knee to toe",
}


def of_bounds(problem: Problem, at_bound: set[str]) -> list[str]:
    """Which limits decided, and what to do."""
    said, belief = [], problem.belief
    limits = belief.limits
    for name, declared in declarations(LegParameters):
        if name in at_bound and not belief.rig:
            low, high = (float(getattr(each, name)) for each in (limits.lower, limits.upper))
            said.append(
                f"{declared.symbol} ran into its limits of {low:.3g} to {high:.3g} {declared.unit} "
                f"({whose(belief, name)}). Absolute values that go with it follow from that limit, "
                "not from the recording: use the ratios."
            )
    for rule in RULES:
        if rule in at_bound:
            weak = f" Gravity turns no leg that hangs so little. {ON_ITS_SIDE}" * (rule == REACH)
            said.append(f"the fit lies on the limit {RULES[rule]} ({rule}).{weak}")
    return said


def limits_met(problem: Problem, at_bound: set[str]) -> list[str]:
    """The limits of a leg that decided, by their symbols; that damping is not negative is none."""
    if problem.belief.rig:
        return []
    held = [
        declared.symbol
        for name, declared in declarations(LegParameters)
        if name in at_bound and name != "damping"
    ]
    return [*held, *(f"the limit {words}" for rule, words in RULES.items() if rule in at_bound)]


def whose(belief: Belief, name: str) -> str:
    """Where a limit comes from."""
    if name in belief.by_hand.bound:
        return "yours"
    if belief.bounds == "paper":
        return "Eq. 13"
    unknown = belief.expected is None or belief.untabled
    if unknown:
        return "any human's"
    said = {"mass", "com_distance"} & {*belief.by_hand.fix, *belief.by_hand.prior}
    return f"what a leg of {'that m or l' if said else 'this body'} can have"
