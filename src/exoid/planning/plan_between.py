"""What to record next to tell rival causes apart: where no rival can follow what another makes."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.ask import sensed
from exoid.mismatch.evidence.yardstick import UNEXPLAINED
from exoid.physics.term import Moved, Term, name_of, of_alike, pushing_alike
from exoid.planning.candidate_recordings import candidates, drops_of_rig, moving
from exoid.planning.expected_information import posed
from exoid.planning.expected_odds import RivalFit, probability, rival_fit
from exoid.planning.odds_at_hand import odds_at_hand, told_already
from exoid.planning.planned import Candidate, Contrast, Telling
from exoid.planning.prior_knowledge import PriorKnowledge, from_result
from exoid.recordings.declared.subject import Subject

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

    **Raises** `ValueError` where there are no two rivals, or not of the same recordings, or of a
    rig that a motor drove all the time.

    >>> from exoid.physics.terms.device.coulomb_friction import CoulombFriction
    >>> from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
    >>> recording = exoid.load("drops.csv").recording
    >>> fits = [exoid.fit(recording, terms=(each,)) for each in (CoulombFriction, CubicStiffness)]
    >>> contrast = exoid.plan_between(fits, recording.subject)
    >>> 0 < contrast.probability <= 1
    True
    """
    check_rivals(fits)
    check_let_go(subject, [seg.kind for seg in fits[0].segments], terms_of(fits))
    known = [from_result(each) for each in fits]
    names = [rival_name(each.terms) for each in known]
    noise = min(each.noise_scale for each in fits)
    at_hand = odds_at_hand(fits)
    comparison = compared(known, options_of(fits, subject), noise)
    single = [
        Telling(each, odds := comparison.log_odds([each]), probability(odds))
        for each in comparison.options
    ]
    told = told_already(fits) and any(map(explains, fits))
    best = comparison.greedy()
    chosen = best if not told and probability(comparison.log_odds(best)) > LIKELY else []
    expected = comparison.log_odds(chosen or best)
    return Contrast(
        rivals=names,
        at_hand=at_hand,
        proposed=chosen,
        log_odds=expected,
        probability=probability(expected),
        if_right=comparison.if_right(chosen or best),
        options=sorted(single, key=lambda each: -each.log_odds),
        sentences=advice(fits, names, known, at_hand, told=told, helpless=not (told or chosen)),
    )


def check_rivals(fits: Sequence[FitResult]) -> None:
    """Refuse what cannot be compared."""
    models = {tuple(sorted(each.terms)) for each in fits}
    if len(models) < 2 or len(models) < len(fits):
        raise ValueError("rivals are two or more models, each of them given once.")
    if len({each.samples for each in fits}) > 1:
        raise ValueError("the rivals were fitted to different samples: fit the same recordings.")


def terms_of(fits: Sequence[FitResult]) -> list[type[Term]]:
    """Of all rivals, each once."""
    return list(dict.fromkeys(type(term) for each in fits for term in each.fitted_terms))


def check_let_go(
    subject: Subject, kinds: Iterable[str | None], terms: Iterable[type[Term]]
) -> None:
    """Refuse a rig all of whose movements a motor made, of which no drop can be planned.

    **Raises** `ValueError` with what tells each of the `terms`.
    """
    if subject.kind != "rig" or {*kinds} != {"measured"}:
        return
    shown = (f"{name_of(each)} shows in {each.isolated_by('motor')}" for each in terms)
    raise ValueError(
        "what is planned are drops, and a motor drives this rig in every segment. "
        f"Of its movements: {'; '.join(shown)}."
    )


def options_of(fits: Sequence[FitResult], subject: Subject) -> list[Candidate]:
    """What can be recorded of a person's leg; of a rig drops from where it has been."""
    if subject.kind != "rig":
        return candidates(subject.height, None)
    ends = [(np.nanmin(each.angle), np.nanmax(each.angle)) for each in fits[0].segments]
    lowest, highest = np.array(ends).T
    return drops_of_rig(float(lowest.min()), float(highest.max()))


def rival_name(terms: Sequence[Term]) -> str:
    return " + ".join(name_of(type(each)) for each in terms) or "Eq. 9 alone"


def explains(each: FitResult) -> bool:
    """Is what it leaves of the angle hardly more than noise?"""
    return each.angle_rmse**2 < UNEXPLAINED * each.angle_noise**2


def compared(known: list[PriorKnowledge], every: list[Candidate], noise: float) -> "Comparison":
    """Every rival after every other, along the candidates from which all of them move."""
    moved = [moving(every, each) for each in known]
    common = [each for each in every if all(each in motions for motions in moved)]
    followed = []
    for right, motions in zip(known, moved, strict=True):
        made = {each: motions[each] for each in common}
        own = sensed(*posed(right, made))
        rivals = [each for each in known if each is not right]
        followed.append([rival_fit(rival, made, own, noise) for rival in rivals])
    return Comparison(common, followed)


@dataclass(frozen=True, eq=False)
class Comparison:
    """Every model as the right one, and how its rivals follow what it would make."""

    options: list[Candidate]
    followed: list[list[RivalFit]]  # of every model, by its rivals

    def if_right(self, chosen: Sequence[Candidate]) -> list[float]:
        """Log odds to expect of these candidates where a model is right: against the rival that
        follows it best.
        """
        return [min(rival.log_odds(chosen) for rival in rivals) for rivals in self.followed]

    def log_odds(self, chosen: Sequence[Candidate]) -> float:
        """The same of the pair that is hardest to tell apart."""
        return min(self.if_right(chosen))

    def greedy(self) -> list[Candidate]:
        """Segment after segment, the simplest of the nearly best, until they are sure to tell."""
        chosen: list[Candidate] = []
        while self.options and len(chosen) < MOST:
            before = self.log_odds(chosen) if chosen else 0.0
            if probability(before) > SURE:
                break
            after = {each: self.log_odds([*chosen, each]) for each in self.options}
            if max(after.values()) <= WORTH * before:
                break
            near = [each for each in after if after[each] >= NEAR * max(after.values())]
            chosen.append(min(near, key=lambda each: (each.effort, -after[each])))
        return chosen


def advice(
    fits: Sequence[FitResult],
    names: list[str],
    known: list[PriorKnowledge],
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
        terms = [type(term) for each in known for term in each.terms]
        said.extend(of_helpless(terms, "rig" if known[0].belief.rig else "leg"))
    said.extend(
        of_strays([name for name, each in zip(names, fits, strict=True) if not each.follows])
    )
    if not any(map(explains, fits)):
        said.append(
            "none of them follows the recordings down to the noise: another cause may be at work, "
            "alone or beside them. exoid diagnose searches for it."
        )
    return said


def of_helpless(terms: list[type[Term]], moved: Moved = "leg") -> list[str]:
    """That no candidate tells them apart, and what might."""
    alike = pushing_alike(terms)
    others = [term for term in dict.fromkeys(terms) if term not in alike]
    said = [of_alike(alike)] if alike else []
    if others or not alike:
        said.append("no recording of this kind tells them apart; what might is said below.")
    return [*said, *(f"{name_of(term)} shows in {term.isolated_by(moved)}." for term in others)]


def of_strays(names: list[str]) -> list[str]:
    """That these do not follow what was recorded."""
    return [
        f"with {name} the simulation does not follow the recordings at hand: what is planned "
        "against it is not to be believed."
        for name in names
    ]
