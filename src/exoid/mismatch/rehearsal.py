"""A diagnosis rehearsed: its programs run once, on the same samples but for no leg in particular.

What it leaves is programs (`fitting.solve.cores.ahead`): they depend on how many numbers they are
given, not on which.
"""

import numpy as np

from exoid.fitting.amount.manageable import DIAGNOSED, manageable
from exoid.fitting.data.conditioning import conditioned
from exoid.fitting.model.assumptions import Assumptions
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.movements import movements_in
from exoid.fitting.solve.pose import pose
from exoid.fitting.solve.program_cache import leave
from exoid.mismatch.prepare import compared, sensors_of, tested, unknown
from exoid.mismatch.screen.along_motion import effects
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.many_pinned import evaluate, room
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.variants import applies
from exoid.physics.scale import AS_A_LEG
from exoid.recordings.recording import Recording


def rehearse(named: list[tuple[str, Recording]]) -> None:
    """Every cause once along the motion, the last one first: a diagnosis comes from the other end,
    and the two meet. Then one for every number of parameters that programs have room for.
    """
    prepared = for_no_leg(named)
    begin = Hypothesis((), (), prepared.point(prepared.like))
    tried = [
        (begin.with_term(term, prepared.starts(term)[0]), prepared.measured_motion)
        for term in prepared.library
        if applies(prepared, term)
    ]
    for one in reversed(tried):
        effects(prepared, [one])
    rooms = {room(sum(map(np.size, one.values))): (one, motion) for one, motion in tried}
    leave(evaluate, prepared, [*rooms.values()])


def for_no_leg(named: list[tuple[str, Recording]]) -> PreparedRecording:
    """The recordings as a diagnosis prepares them, but for what it knows from a fit."""
    parts = manageable(named, DIAGNOSED).parts
    chain, movements = conditioned(movements_in(parts), 1)
    subject = named[0][1].subject
    rig = subject.kind == "rig"
    belief = believe(subject, Assumptions(), (), AS_A_LEG)
    posed = pose(movements, belief, "1/T", chain, owned=unknown(movements, rig=rig))
    problem = compared(posed)
    sensors = sensors_of(problem)
    zero = movements[0].systematics.zero
    return PreparedRecording(problem, sensors, tested(rig=rig), 0.0, rig, zero)
