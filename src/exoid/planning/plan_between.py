"""What to record next to tell rival causes apart: where no rival can follow what another makes."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, permutations

from exoid.fitting.result.fit_result import FitResult
from exoid.physics.term import Term, name_of
from exoid.planning.candidate_recordings import candidates, moving
from exoid.planning.expected_odds import DECISIVE, Pursuit, probability, pursuit, simulated
from exoid.planning.planned import Candidate, Contrast, Telling
from exoid.planning.prior_knowledge import Known, from_result
from exoid.recordings.recording import Subject

MOST = 3  # segments of a proposed recording
SURE = 0.95  # a probability that needs no further segment
LIKELY = 0.5  # a probability below which a recording is no proposal
NEAR = 0.6  # of the greatest log odds: within it the simplest recording is proposed
WORTH = 1.15  # of the log odds before: a further segment that brings less is not worth its time


def plan_between(fits: Sequence[FitResult], subject: Subject) -> Contrast:
    """The segments to record next that tell rival models apart.

    `fits` are those of the rivals to the same recordings, as `exoid.fit(recordings,
    terms=(CoulombFriction,))` gives them. Whichever of them is right, the others are expected to
    be refuted; of several pairs the one that is hardest to tell apart decides.

    **Raises** `ValueError` where there are no two rivals, or not of the same recordings, or the
    subject is a rig.

    >>> from exoid.physics.terms.device.coulomb_friction import CoulombFriction
    >>> from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
    >>> recording = exoid.load("drops.csv").recording
    >>> fits = [exoid.fit(recording, terms=(each,)) for each in (CoulombFriction, CubicStiffness)]
    >>> contrast = exoid.plan_between(fits, recording.subject)
    >>> 0 < contrast.probability <= 1
    True
    """
    check_rivals(fits, subject)
    known = [from_result(each) for each in fits]
    names = [rival_name(each.terms) for each in known]
    noise = min(each.noise_scale for each in fits)
    at_hand = odds_at_hand(fits, noise)
    contest = Contest(len(known), tuple(pursuits(known, candidates(subject.height, None), noise)))
    single = [
        Telling(each, contest.log_odds([n]), probability(contest.log_odds([n])))
        for n, each in enumerate(contest.options)
    ]
    told = min(abs(one - other) for one, other in combinations(at_hand, 2)) > DECISIVE
    best = contest.greedy()
    chosen = best if not told and probability(contest.log_odds(best)) > LIKELY else []
    expected = contest.log_odds(chosen or best)
    return Contrast(
        rivals=names,
        at_hand=at_hand,
        proposed=[contest.options[number] for number in chosen],
        log_odds=expected,
        probability=probability(expected),
        if_right=contest.if_right(chosen or best),
        options=sorted(single, key=lambda each: -each.log_odds),
        sentences=advice(fits, names, known, at_hand, told=told, helpless=not (told or chosen)),
    )


def check_rivals(fits: Sequence[FitResult], subject: Subject) -> None:
    """Refuse what cannot be compared."""
    if subject.kind == "rig":
        raise ValueError("plans are made for legs; a rig can be taken apart and looked at.")
    models = {tuple(sorted(each.terms)) for each in fits}
    if len(models) < 2 or len(models) < len(fits):
        raise ValueError("rivals are two or more models, each of them given once.")
    if len({each.samples for each in fits}) > 1:
        raise ValueError("the rivals were fitted to different samples: fit the same recordings.")


def rival_name(terms: Sequence[Term]) -> str:
    return " + ".join(name_of(type(each)) for each in terms) or "Eq. 9 alone"


def odds_at_hand(fits: Sequence[FitResult], noise: float) -> list[float]:
    """The log odds of each of them against the best, by the recordings at hand."""
    least = min(each.loss for each in fits)
    return [(least - each.loss) / noise**2 for each in fits]


def pursuits(known: list[Known], every: list[Candidate], noise: float) -> list[Pursuit]:
    """Every rival after every other, along the candidates from which all of them move."""
    moved = [moving(every, each.leg, each.sensors, each.gyro, each.model_terms) for each in known]
    common = [each for each in every if all(each in motions for motions in moved)]
    made = [{each: motions[each] for each in common} for motions in moved]
    own = [simulated(one, list(each.values())) for one, each in zip(known, made, strict=True)]
    return [
        pursuit(known[rival], made[right], own[right], noise)
        for right, rival in permutations(range(len(known)), 2)
    ]


@dataclass(frozen=True, eq=False)
class Contest:
    """Every rival after every other."""

    rivals: int
    pursuits: tuple[Pursuit, ...]  # those after the same one in a row

    @property
    def options(self) -> list[Candidate]:
        return self.pursuits[0].options

    def log_odds(self, chosen: Sequence[int]) -> float:
        """To expect of these candidates, of the pair that is hardest to tell apart."""
        return min(each.log_odds(chosen) for each in self.pursuits)

    def if_right(self, chosen: Sequence[int]) -> list[float]:
        """The same of each model by itself: against the rival that follows it best."""
        each = [one.log_odds(chosen) for one in self.pursuits]
        others = self.rivals - 1
        return [min(each[n : n + others]) for n in range(0, len(each), others)]

    def greedy(self) -> list[int]:
        """Segment after segment, the simplest of the nearly best, until they are sure to tell."""
        chosen: list[int] = []
        while self.options and len(chosen) < MOST:
            before = self.log_odds(chosen) if chosen else 0.0
            if probability(before) > SURE:
                break
            after = {n: self.log_odds([*chosen, n]) for n in range(len(self.options))}
            if max(after.values()) <= WORTH * before:
                break
            near = [n for n in after if after[n] >= NEAR * max(after.values())]
            chosen.append(min(near, key=lambda n: (self.options[n].effort, -after[n])))
        return chosen


def advice(
    fits: Sequence[FitResult],
    names: list[str],
    known: list[Known],
    at_hand: list[float],
    *,
    told: bool,
    helpless: bool,
) -> list[str]:
    """What is told already, and what to do where no candidate tells."""
    best = names[at_hand.index(max(at_hand))]
    second = max(each for name, each in zip(names, at_hand, strict=True) if name != best)
    said = []
    if told:
        said.append(
            f"the recordings at hand tell them apart already: {best} fits better than any other, "
            f"by log odds of {-second:.1f}."
        )
    if helpless:
        said.append("no recording of this kind tells them apart; what might is said below.")
        terms = dict.fromkeys(type(term) for each in known for term in each.terms)
        said.extend(f"{name_of(term)} shows in {term.isolate}." for term in terms)
    said.extend(
        of_strays([name for name, each in zip(names, fits, strict=True) if not each.follows])
    )
    if all(each.disturbance.cause is not None for each in fits):
        said.append(
            "none of them follows the recordings down to the noise: another cause may be at work, "
            "alone or beside them. exoid diagnose searches for it."
        )
    return said


def of_strays(names: list[str]) -> list[str]:
    """That these do not follow what was recorded."""
    return [
        f"with {name} the simulation does not follow the recordings at hand: what is planned "
        "against it is not to be believed."
        for name in names
    ]
