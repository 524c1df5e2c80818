"""What is known before the first sample."""

import jax
import numpy as np

from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.whiteness import Whiteness
from exoid.online.model.model import Node
from exoid.online.model.trust import Phase
from exoid.online.movement.knowledge import (
    NEVER,
    Course,
    Kept,
    Knowledge,
    Recent,
    Sensing,
    Stream,
    Verdict,
)

ROWS = 128  # samples: a release is seen 0.1 to 0.5 s late
DECLARED = 20.0  # samples that the declared noise is worth


def begin(prior: Gaussian, node: Node) -> Knowledge:
    """Nothing was heard yet of a leg that carries this node."""
    both = jax.tree.map(lambda one: np.stack([one, one]), prior)
    none, never = np.zeros(()), np.asarray(-np.inf)
    still = np.zeros((2, 2))
    return Knowledge(
        filters=both,
        newer=Kept(both, never, none, np.asarray(0), none),
        older=Kept(both, never, none, np.asarray(0), none),
        before=prior,
        prior=prior,
        sensing=sensing_of(node),
        scatter=np.full((2, 2), DECLARED),
        phase=np.asarray(int(Phase.HELD)),
        hold=np.asarray(np.nan),
        recent=Recent(np.full((ROWS, 6), np.nan), np.asarray(0), np.asarray(0)),
        stream=Stream(none, np.asarray(0)),
        course=Course(
            begun=never,
            reached=never,
            ended=never,
            torque=none,
            opened=np.asarray(False),
            whiteness=Whiteness(still, still, still, still, none),
            likelihood=np.zeros(2),
            astray=np.asarray(0),
            direction=none,
            turns=np.asarray(0),
            late=np.asarray(0),
            quick=np.zeros(2),
            top=np.asarray(np.nan),
            scatter=np.full((2, 2), DECLARED),
            rested=np.asarray(0),
        ),
        verdict=Verdict(
            drops=np.asarray(0),
            rests=np.asarray(0),
            changed=np.asarray(False),
            unexplained=np.asarray(False),
            suspected=np.asarray(NEVER),
        ),
    )


def sensing_of(node: Node) -> Sensing:
    declared = (*node.variances, node.delay_wander, node.delay_drift, node.period)
    return Sensing(*map(np.asarray, declared))
