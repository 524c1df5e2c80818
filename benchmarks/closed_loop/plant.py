"""A leg in a motorised frame, in MuJoCo: two bodies on the knee's axis, with cuffs between them.

The thigh is fixed and level. Angles are 0 where the knee is extended and grow in extension. Cuffs
are a spring and a damper, so that what passes between frame and leg can be read. The motor gets a
command late, follows it as a filter of first order, and has a limit.
"""

from dataclasses import dataclass

import mujoco
import numpy as np
from benchmarks.closed_loop.rig import Frame, Leg
from scipy.optimize import root_scalar

STEP = 2.5e-3  # s
# s, of MuJoCo's soft friction, which turns round about half of that before the frame does: with the
# 20 ms that it has by itself, friction would push the frame for 10 ms before each turn.
GRIP = 2e-3


@dataclass(frozen=True)
class Motor:
    """What becomes of a commanded torque."""

    delay: float = 5e-3  # s, from the node's sample to the windings
    lag: float = 4e-3  # s
    limit: float = 20.0  # N m, of the motor itself
    gain: float = 1.0  # of the torque that it gives over that which it is told


@dataclass(frozen=True)
class State:
    """What is at a moment. Torques are positive in extension [N m]."""

    angle: float  # rad, of the leg
    rate: float
    frame_angle: float
    frame_rate: float
    frame_acceleration: float
    interaction: float  # of the frame on the leg, by the cuffs
    motor: float  # of the motor on the frame


MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" gravity="0 0 -9.81">
    <flag refsafe="disable"/>
  </option>
  <worldbody>
    <body name="leg">
      <joint name="leg" axis="0 -1 0" stiffness="{leg.stiffness}" damping="{leg.damping}"/>
      <inertial pos="{leg.distance} 0 0" mass="{leg.mass}" diaginertia="{of_leg}"/>
    </body>
    <body name="frame">
      <joint name="frame" axis="0 -1 0" damping="{frame.damping}" frictionloss="{frame.friction}"
        solimpfriction="0.99 0.999 0.001" solreffriction="{grip} 1"/>
      <inertial pos="{frame.distance} 0 0" mass="{frame.mass}" diaginertia="{of_frame}"/>
    </body>
  </worldbody>
  <tendon>
    <fixed name="cuffs" stiffness="{frame.cuff_stiffness}" damping="{frame.cuff_damping}"
      springlength="0">
      <joint joint="leg" coef="1"/>
      <joint joint="frame" coef="-1"/>
    </fixed>
  </tendon>
  <actuator>
    <general joint="frame" dyntype="filterexact" dynprm="{motor.lag}" gainprm="{motor.gain}"
      delay="{motor.delay}" nsample="{samples}" forcelimited="true"
      forcerange="-{motor.limit} {motor.limit}"/>
  </actuator>
</mujoco>
"""


class Plant:
    """The rig with somebody in it. The leg hangs at first."""

    def __init__(self, leg: Leg, frame: Frame, motor: Motor) -> None:
        self.frame, self.motor = frame, motor
        self._build(leg)
        self.place(self.hanging)

    def place(self, angle: float) -> None:
        """Leg and frame are at that angle [rad]."""
        self._data.qpos[:] = angle

    def seat(self, leg: Leg) -> None:
        """Another leg is in the frame from now on; motion and motor go on."""
        kind = mujoco.mjtState.mjSTATE_INTEGRATION.value
        state = np.empty(mujoco.mj_stateSize(self._model, kind))
        mujoco.mj_getState(self._model, self._data, state, kind)
        self._build(leg)
        mujoco.mj_setState(self._model, self._data, state, kind)

    def step(self, command: float, muscle: float) -> None:
        """STEP with that command to the motor, and a torque of muscle or hand on the leg."""
        self._data.ctrl[0] = command
        self._data.qfrc_applied[0] = muscle
        mujoco.mj_step(self._model, self._data)

    @property
    def hanging(self) -> float:
        """The angle [rad] at which it all hangs, but for friction."""
        weight = self.leg.weight + self.frame.weight

        def pull(angle: float) -> float:
            return weight * np.cos(angle) + self.leg.stiffness * angle

        return float(root_scalar(pull, bracket=(-np.pi / 2, 0.0)).root)

    def state(self) -> State:
        (angle, frame_angle), (rate, frame_rate) = self._data.qpos, self._data.qvel
        cuffs = self.frame.cuff_stiffness * (frame_angle - angle)
        cuffs += self.frame.cuff_damping * (frame_rate - rate)
        return State(
            float(angle),
            float(rate),
            float(frame_angle),
            float(frame_rate),
            float(self._data.qacc[1]),
            float(cuffs),
            float(self._data.actuator_force[0]),
        )

    def _build(self, leg: Leg) -> None:
        self.leg = leg
        text = MODEL.format(
            step=STEP,
            leg=leg,
            frame=self.frame,
            motor=self.motor,
            of_leg=about_centre(leg),
            of_frame=about_centre(self.frame),
            grip=GRIP,
            samples=round(self.motor.delay / STEP) + 2,
        )
        self._model = mujoco.MjModel.from_xml_string(text)
        self._data = mujoco.MjData(self._model)


def about_centre(body: Leg | Frame) -> str:
    """The moments of inertia for MuJoCo, which wants those about the centre of mass."""
    own = body.inertia - body.mass * body.distance**2
    if own <= 0:
        raise ValueError(f"{body} has less inertia than a point of its mass at its place.")
    return f"{own} {own} {own}"
