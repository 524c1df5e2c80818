"""Plant, sensors, node and host, tick after tick: what happened."""

from dataclasses import dataclass, field

import numpy as np
from benchmarks.closed_loop.acts import Act
from benchmarks.closed_loop.carrying import NOTHING, support
from benchmarks.closed_loop.host import Host
from benchmarks.closed_loop.learners import DOUBTED, Learner
from benchmarks.closed_loop.node import TICK, Node
from benchmarks.closed_loop.plant import STEP, Plant
from benchmarks.closed_loop.sensors import Faults, read, seen

STEPS = round(TICK / STEP)  # of the plant in a tick


@dataclass
class Log:
    """What happened, by STEP."""

    rows: list[tuple[float, ...]] = field(default_factory=list)

    @property
    def table(self) -> np.ndarray:
        return np.array(self.rows, dtype=np.dtype([(name, float) for name in COLUMNS]))


COLUMNS = (
    "time",  # s
    "angle",  # rad, of the leg
    "command",  # N m, of the node
    "motor",  # N m
    "interaction",  # N m, of the frame on the leg
    "residual",  # N m, the part of it that the motor is not meant to give
    "muscle",  # N m
    "permit",
    "trust",
)


class Session:
    """One rig with its node, from its start on."""

    def __init__(self, rng: np.random.Generator, plant: Plant, faults: Faults, learner: Learner):
        self.plant, self.learner, self.host, self.node = plant, learner, Host(), Node()
        self.shares = NOTHING
        self.follows = True  # the learner what the leg does: where a hand lifts it and lets it go
        self.log = Log()
        self.time = 0.0  # s
        self._rng, self._faults = rng, faults

    def act(self, act: Act) -> slice:
        """Lets it happen; returns which rows of the log it is."""
        first = len(self.log.rows)
        act.begin(self.plant.state(), self.plant.leg)
        for tick in range(round(act.seconds / TICK)):
            self._tick(act, tick * TICK)
        return slice(first, len(self.log.rows))

    def doubted_since(self, time: float) -> float | None:
        """When the learner first doubted the leg after that time [s]."""
        every = (row[0] for row in self.log.rows if row[0] > time and row[-1] in DOUBTED)
        return next(every, None)

    def _tick(self, act: Act, elapsed: float) -> None:
        host = self.host
        for message in host.say():
            self.node.hear(message)
        state = self.plant.state()
        readings = read(self._rng, self._faults, state, self.time)
        host.see(self.node.tick(readings))
        told = host.told
        if self.follows:
            self.learner.see(seen(readings, self.time), told)
        if self.learner.trust in DOUBTED:
            host.forget()
        for step in range(STEPS):
            muscle = act.torque(elapsed + step * STEP, state)
            self.plant.step(told.torque, muscle)
            state = self.plant.state()
            self.time += STEP
            residual = state.interaction
            if told.torque:
                residual -= support(self.shares, self.plant.leg, state.angle, state.rate)
            row = (self.time, state.angle, told.torque, state.motor, state.interaction)
            self.log.rows.append((*row, residual, muscle, told.permit, self.learner.trust))
