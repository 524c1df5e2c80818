"""What the motor is to carry: the parameters for the node, and what the leg should feel of it."""

from dataclasses import dataclass

import numpy as np
from benchmarks.closed_loop.learners import Known
from benchmarks.closed_loop.rig import Frame, Leg

from exoid.recordings.commissioning.torque_parameters import TorqueParameters


@dataclass(frozen=True)
class Shares:
    """How much of the leg's own torques the motor is to carry, beside the frame's."""

    gravity: float = 0.0
    stiffness: float = 0.0
    damping: float = 0.0


NOTHING = Shares()
SHARES = Shares(
    1.0, 1.0, 0.8
)  # carried: a damping taken off in full would leave no room for errors
FRICTION_SHARE = 0.8
LIMIT = 15.75  # N m
RATE_LIMIT = 60.0  # N m/s


def carrying(known: Known, frame: Frame, shares: Shares) -> TorqueParameters:
    """What takes the frame off, and of the leg those shares. Both together are learned."""
    inertia = known.inertia
    weight, damping = inertia * known.gravity, inertia * known.damping
    own = frame.weight / weight
    return TorqueParameters(
        gravity=weight,
        thigh_angle=-known.zero,
        stiffness=max(inertia * known.stiffness, 0.0),
        damping=damping,
        friction=max(inertia * known.friction, 0.0),
        inertia=inertia,
        gravity_share=own + (1 - own) * shares.gravity,
        stiffness_share=shares.stiffness,
        damping_share=shares.damping,
        friction_share=FRICTION_SHARE,
        limit=LIMIT,
        rate_limit=RATE_LIMIT,
    )


def support(shares: Shares, leg: Leg, angle: float, rate: float) -> float:
    """What the frame is to give the leg [N m]: its share of what the leg's muscles else would."""
    torque = shares.gravity * leg.weight * np.cos(angle)
    torque += shares.stiffness * leg.stiffness * angle
    return torque + shares.damping * leg.damping * rate
