"""The live estimator, loaded where it is first used: behind it stands most of exoid."""

from collections.abc import Mapping
from typing import Any

from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.outlook import Outlook
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.recordings.measured.segment import Segment

Belief = Any  # of exoid.online.belief


def init(expected: ExpectedLeg, model: Model) -> Belief:
    from exoid.online import belief

    return belief.init(expected, model)


def at_begin(belief: Belief, model: Model) -> Belief:
    from exoid.online import belief as beliefs

    return beliefs.at_begin(belief, model)


def replay(belief: Belief, samples: Sample, model: Model) -> tuple[Belief, Outlook]:
    from exoid.online import program

    return program.replay(belief, samples, model)


def estimates(belief: Belief, model: Model) -> Mapping[str, Any]:
    from exoid.online import readings

    return readings.estimates(belief, model)


def segment_of(samples: Sample, begun: float, ended: float) -> Segment:
    from exoid.online import batch

    return batch.segment_of(samples, begun, ended)
