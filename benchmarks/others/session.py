"""The session as it happened: one motion from begin to end, and when hands were on the leg."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from . import hand
from .leg import Physics
from .motion import TICK, Motion, march
from .protocol import Drop, Protocol, resting_angle

SLOW = 0.01  # rad/s, below which a leg has come to rest
LONGEST = 20.0  # s of one swing
SETTLE = 0.3  # s of holding after a lift that nobody records


@dataclass(frozen=True)
class Happened:
    """One drop, in seconds of the session."""

    held: float  # the hold that is kept begins
    released: float  # the hand begins to let go
    free: float  # its torque is zero
    end: float  # a hand comes back, or the recording stops
    over: float  # what is kept of this drop ends
    kind: str


@dataclass(frozen=True)
class Session:
    """The whole motion, its drops, and the windows that become segments."""

    motion: Motion
    drops: tuple[Happened, ...]
    windows: tuple[tuple[float, float], ...]  # s


class Stage:
    """The leg while a session goes on."""

    def __init__(self, physics: Physics, angle: float):
        self.physics, self.grip = physics, hand.grip_of(physics)
        self.state = (angle, 0.0, 0.0, 0.0)
        self.past = np.zeros(int(physics.reflex_delay / TICK) + 3)
        self.pieces: list[np.ndarray] = [np.array([[angle], [0.0], [0.0], [0.0]])]
        self.ticks = 0

    @property
    def clock(self) -> float:
        return self.ticks * TICK

    def play(self, rows: np.ndarray) -> None:
        """What the hand does for a while."""
        out, self.state, self.past = self.foresee(rows)
        self.pieces[-1] = self.pieces[-1][:, :-1]
        self.pieces.append(out)
        self.ticks += out.shape[1] - 1

    def foresee(self, rows: np.ndarray):
        return march(self.physics, self.state, self.grip, rows, self.past, TICK)

    def motion(self) -> Motion:
        whole = np.concatenate(self.pieces, axis=1)
        return Motion(TICK * np.arange(whole.shape[1]), *whole, self.state[2:])


def hold_session(physics: Physics, protocol: Protocol) -> Session:
    rest = resting_angle(physics)
    first = rest if protocol.hanging else protocol.drops[0].angle
    stage, happened = Stage(physics, first), []
    if protocol.hanging:
        stage.play(hand.leave(protocol.hanging))
        raise_leg(stage, protocol.drops[0].angle)
    for number, drop in enumerate(protocol.drops):
        happened.append(perform(stage, drop))
        if number + 1 < len(protocol.drops):
            raise_leg(stage, protocol.drops[number + 1].angle)
    return Session(stage.motion(), tuple(happened), tuple(windows(protocol, happened)))


def raise_leg(stage: Stage, angle: float) -> None:
    """Take the leg where it is, and bring it to the next angle."""
    stage.play(hand.catch(stage.physics, stage.state[0], stage.state[1], 0.15))
    far = abs(angle - stage.state[0])
    stage.play(hand.lift(stage.physics, stage.state[0], angle, 0.6 + far))
    stage.play(hand.lift(stage.physics, angle, angle, SETTLE))


def perform(stage: Stage, drop: Drop) -> Happened:
    """Hold, release, swing, and what ends it."""
    physics, held = stage.physics, stage.clock
    stage.play(hand.hold(physics, drop.angle, drop.hold, drop.tremor, stage.clock))
    released = stage.clock
    stage.play(hand.let_go(physics, drop.angle, drop.ramp, drop.tremor, stage.clock))
    free = stage.clock
    if drop.end == "rest":
        stage.play(hand.leave(time_to_rest(stage) + drop.after))
        end = over = stage.clock
    else:
        stage.play(hand.leave(drop.swing))
        end = over = stage.clock
    if drop.end == "caught":
        stage.play(hand.catch(physics, stage.state[0], stage.state[1], 0.05 + drop.ramp))
        there = stage.state[0]
        stage.play(hand.lift(physics, there, there, drop.after))
        over = stage.clock
    kept = free + drop.skipped if drop.skipped else held
    return Happened(kept, released, free, end, over, drop.end)


def time_to_rest(stage: Stage) -> float:
    """s until the leg swings no more."""
    out, _, _ = stage.foresee(hand.leave(LONGEST))
    moving = np.flatnonzero(np.abs(out[1]) > SLOW)
    return float(TICK * moving[-1]) if moving.size else TICK


def windows(protocol: Protocol, happened: list[Happened]) -> Iterator[tuple[float, float]]:
    """From when to when each segment was recorded."""
    if protocol.table:
        yield 0.0, happened[-1].over
        return
    if protocol.hanging:
        yield 0.0, protocol.hanging
    for each in happened:
        yield each.held, each.over
