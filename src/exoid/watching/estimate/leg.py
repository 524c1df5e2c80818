"""A leg whose load may change: every weight on it is followed as a leg of its own."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from exoid.online.model.model import Model
from exoid.online.model.trust import Phase, Trust
from exoid.physics.anatomy.expected import STRANGE, ExpectedLeg
from exoid.recordings.declared.subject import Subject
from exoid.recordings.live.decoding.reading import Reading
from exoid.recordings.measured.segment import Segment
from exoid.watching.estimate.estimator import Drop, Estimator
from exoid.watching.estimate.expect import unloading
from exoid.watching.estimate.known import ABSOLUTE, RATIOS, SCALED
from exoid.watching.estimate.left_out import CUT, TORN, LeftOut
from exoid.watching.estimate.load import Load, Mass, expected_with
from exoid.watching.estimate.moment import Moment, Quantity
from exoid.watching.estimate.online import Belief
from exoid.watching.estimate.switch import Switch
from exoid.watching.estimate.unload import Bare, Told, misplaced_by, unloaded

TOLD = 0.5**0.5  # of the prior's error of log J, half of its variance: what leaves more tells no J
SOUND = (Trust.WAITING, Trust.LEARNING, Trust.GOOD, Trust.ENOUGH)
FAR = 8.0  # standard deviations: three weights told nine numbers, which are 6 apart once in 10 000
SETTLING = 1.0  # s after a pause, or another weight, in which the gap counts as no fault


@dataclass(frozen=True)
class Person:
    """Whose leg it is, what is expected of it, by which model it is followed."""

    subject: Subject
    expected: ExpectedLeg
    model: Model


@dataclass(frozen=True, eq=False)
class LegDrop:
    """A drop that has ended: with what on the leg, and what is believed of it by every weight."""

    number: int  # of all weights
    segment: Segment
    mass: Mass
    moment: Moment
    beliefs: Mapping[Mass, Belief]

    @property
    def until(self) -> float:
        """When it ended to count [s]."""
        return float(self.segment.begins + self.segment.time[-1])


class Leg:
    """Takes samples, and says of the bare leg what all weights told."""

    def __init__(self, person: Person, load: Load | Switch):
        self.person, self.load = person, load
        self.estimators: dict[Mass, Estimator] = {}
        self.now = load.at(0.0)
        self.said = Trust.WAITING  # before the last pause
        self.before = unloading(person.expected, person.subject, load.masses)
        self.latest: dict[Mass, Moment] = {}  # of each weight, its last one
        self.changed: float | None = None  # s, since when it is another leg
        self.solved: tuple[dict[Mass, Told], Bare] | None = None  # what they told, and the bare leg
        self.estimator_of(self.now)

    @property
    def beliefs(self) -> dict[Mass, Belief]:
        return {mass: each.belief for mass, each in self.estimators.items()}

    def warm(self) -> None:
        """Have the program compiled or loaded."""
        self.estimators[self.now].warm()

    def estimator_of(self, mass: Mass) -> Estimator:
        if mass not in self.estimators:
            expected = expected_with(self.person.expected, mass)
            self.estimators[mass] = Estimator(expected, self.person.model, loaded=self.load.known)
        return self.estimators[mass]

    def take(self, readings: Sequence[Reading]) -> Iterator[Moment | LegDrop | LeftOut]:
        """What is to be told after these samples."""
        begin = 0
        for at, each in enumerate(readings if self.load.known else ()):
            mass = self.load.at(each.time)
            if mass != self.now:
                yield from self.taken(readings[begin:at])
                yield from self.cut_by(each)
                begin, self.now = at, mass
        yield from self.taken(readings[begin:])

    def cut_by(self, after: Reading) -> Iterator[LegDrop | LeftOut]:
        """The drop that a pause ends, behind which another weight is on."""
        for news in self.taken([after]):
            if not isinstance(news, Moment):
                yield news

    def taken(self, readings: Sequence[Reading]) -> Iterator[Moment | LegDrop | LeftOut]:
        estimator = self.estimator_of(self.now)
        for news in estimator.take(readings):
            if isinstance(news, LeftOut):
                yield self.foreseen(news)
                continue
            moment = self.settled(news if isinstance(news, Moment) else news.moment)
            moment = self.of_all(moment)
            if isinstance(news, Drop):
                yield LegDrop(moment.drops, news.segment, self.now, moment, self.beliefs)
            else:
                yield moment

    def foreseen(self, left: LeftOut) -> LeftOut:
        """A pause that was foreseen lost no samples."""
        cut = left.why == TORN and self.is_paused(left.time)
        return replace(left, why=CUT) if cut else left

    def is_paused(self, time: float) -> bool:
        """Was there a pause, or another weight, just before?"""
        return time < self.load.paused(time) + SETTLING

    def settled(self, moment: Moment) -> Moment:
        """A pause that was foreseen is no fault of the stream: what was said before still holds."""
        if moment.trust is Trust.FAULTY and self.is_paused(moment.time):
            return replace(moment, trust=self.said)
        self.said = moment.trust
        return moment

    def of_all(self, moment: Moment) -> Moment:
        """What this weight tells at the moment, together with what the others have told."""
        change = moment.change
        if change is not None and change.another and change.since != self.changed:
            self.changed = change.since
            self.forget_others()
        self.latest[self.now] = moment
        if not self.load.known:
            return moment
        bare = self.bare()
        others = [each for each in moment.others if not each.unit.startswith(SCALED)]
        return replace(
            moment,
            trust=self.trust(moment, bare),
            drops=sum(each.drops for each in self.latest.values()),
            ratios=bare.ratios,
            others=(*absolute_of(bare), *others),
            misplaced=misplaced_by(self.before, bare),
        )

    def forget_others(self) -> None:
        """The leg is another one: what other weights have told was of the one before."""
        self.estimators = {self.now: self.estimators[self.now]}
        self.latest, self.solved = {}, None

    def trust(self, moment: Moment, bare: Bare) -> Trust:
        """What one weight has made sure of stays so while another one is learned; where they
        contradict each other, no leg is like that.
        """
        trust = moment.trust
        if trust not in SOUND:
            return trust
        if bare.apart > FAR:
            return Trust.UNEXPLAINED
        others = [each.trust for each in self.latest.values() if each.drops and each.trust in SOUND]
        return max([trust, *others])

    def bare(self) -> Bare:
        """By what all weights have told until now; most moments tell nothing new."""
        told = {mass: told_of(each) for mass, each in self.latest.items() if is_told(each)}
        if self.solved is None or self.solved[0] != told:
            near = None if self.solved is None else self.solved[1].row
            self.solved = told, unloaded(self.before, told, near)
        return self.solved[1]


def is_told(moment: Moment) -> bool:
    """Has the leg moved with this weight?"""
    moves = moment.phase is Phase.MOVING and moment.believed
    return moment.drops > 0 or moves


def told_of(moment: Moment) -> Told:
    """The ratios of the leg as it was loaded, and its J where a torque told that."""
    known = {each.name: each for each in (*moment.ratios, *moment.others)}
    values, errors = (
        tuple(getattr(known[name], what) for name in RATIOS) for what in ("value", "error")
    )
    inertia = known.get(ABSOLUTE[0])
    return Told(values, errors, None if inertia is None else (inertia.value, inertia.error))


def absolute_of(bare: Bare) -> tuple[Quantity, ...]:
    """The leg in kg m^2 and N m, where it was not the prior that told it, nor a mass that does not
    move as it is declared.
    """
    return bare.absolute if bare.narrowed < TOLD and bare.misplaced <= STRANGE else ()
