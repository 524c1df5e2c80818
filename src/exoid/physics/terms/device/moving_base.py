"""The thigh gives way under the swinging leg."""

import jax.numpy as jnp

from exoid.physics.leg import GRAVITY
from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Reading, Scalar, reading


class MovingBase(PhysicsTerm):
    """The thigh pitches by theta about the hip, pushed by what the leg does to the knee.

    With mu = m l L and w = 2 pi f, phi the leg's angle in space,

        J phi'' + mu cos(phi) theta'' = (Eq. 9) + c (theta + theta_0) + d theta',
        (1 / w^2 + C mu^2 / J) theta'' + 2 zeta theta' / w + theta
            = C (c (phi - theta - theta_0) + d (phi' - theta') - tau_h
                 - mu (cos(phi) phi'' - sin(phi) phi'^2)):

    f is the thigh's frequency where the leg swings freely from it,
    spring and damper feel phi - theta, the encoder shows phi - theta - theta_0, a gyro on the leg
    phi'. Before the release a locked knee carried a share h of the leg's weight, the hand the
    rest. Its memory is (theta, theta').
    """

    title = "the thigh moves under the leg"
    reference = "Valle et al., Clinical Biomechanics 21(8), 2006: thigh motion"
    explanation = (
        "Seat, hip and thigh give way as the leg swings, so that the knee is no fixed pivot; the "
        "gyro sees it, the encoder does not."
    )
    isolate = "the same drops with the thigh strapped down, or an IMU on the thigh"
    living = True
    inertial = True
    memory_size = 2
    substeps = 2

    compliance: Parameter = parameter(
        "C", "rad/(N m)", 0.0, 0.05, "compliance of hip and seat", (0.0008,)
    )
    thigh_length: Parameter = parameter("L", "m", 0.2, 0.6, "hip to knee", (0.42,))
    frequency: Parameter = parameter("f", "Hz", 1.0, 15.0, "frequency of the thigh", (4.0, 10.0))
    damping_ratio: Parameter = parameter(
        "zeta", "1", 0.02, 1.5, "damping ratio of the thigh", (0.4,)
    )
    carried: Parameter = parameter(
        "h", "1", 0.0, 1.0, "weight carried by the knee before the release", (1.0,)
    )
    sag: Parameter = parameter("theta_0", "rad", -0.2, 0.2, "how far it gave way", (0.0,))

    def coupling(self, now: Moment) -> Scalar:
        """mu [kg m^2]."""
        return self.thigh_length * now.gravity / GRAVITY

    def held(self, now: Moment, memory: Memory) -> Scalar:
        """What spring and damper add, because they feel phi - theta [N m]."""
        return now.stiffness * (memory[0] + self.sag) + now.damping * memory[1]

    def pitching(self, now: Moment, memory: Memory) -> Scalar:
        """theta'', with phi'' eliminated."""
        rate, level = 2 * jnp.pi * self.frequency, jnp.cos(now.angle)
        mu = self.coupling(now)
        turned = now.angular_acceleration + self.held(now, memory) / now.inertia
        heaved = mu * (level * turned - jnp.sin(now.angle) * now.angular_velocity**2)
        passive = now.stiffness * now.angle + now.damping * now.angular_velocity
        moment = passive - self.held(now, memory) - now.place.cycle.torque(now.time) - heaved
        pulled = self.compliance * moment - memory[0] - 2 * self.damping_ratio / rate * memory[1]
        carried = self.compliance * (mu * jnp.sin(now.angle)) ** 2 / now.inertia
        return pulled / (1 / rate**2 + carried)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        lift = self.coupling(now) * jnp.cos(now.angle) * self.pitching(now, memory)
        return self.held(now, memory) - lift

    def memory_at_rest(self, now: Moment) -> Memory:
        weight = self.carried * now.gravity * jnp.cos(now.tilted)
        spring = (1 - self.carried) * now.stiffness * now.angle
        return jnp.stack([self.compliance * (spring - weight), jnp.zeros(())])

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return jnp.stack([memory[1], self.pitching(now, memory)])

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(-memory[0] - self.sag)
