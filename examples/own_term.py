"""An own term: a torque that exoid does not know, simulated and fitted with the leg.

The motor of this exoskeleton is not powered, but its magnets pull to the nearest of twelve poles.
"""

from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import numpy as np

import exoid
from exoid.twin.motion import Movement
from exoid.twin.protocols import record

jax.config.update("jax_enable_x64", True)
exoid.keep_programs_in()


class MagneticDetent(exoid.PhysicsTerm):
    """tau = a sin(12 phi)."""

    title: ClassVar[str] = "magnetic detent"
    reference: ClassVar[str] = "the motor's data sheet: twelve poles"
    explanation: ClassVar[str] = "The unpowered motor pulls to the nearest of its poles."
    isolate: ClassVar[str] = "slow movements by hand, motor unpowered"

    size: Any = exoid.parameter("a", "N m", -1.0, 1.0, "size", starts=(0.05,))

    def torque(self, now, memory):
        return self.size * jnp.sin(12 * now.angle)


if __name__ == "__main__":
    truth = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.44, 0.265, 0.35, 2.8)))  # m, J, l, d, c
    motor = exoid.LegModel(truth, exoid.NoTorque(), terms=(MagneticDetent(jnp.asarray(0.2)),))
    drops = [Movement(angle, duration=4.0) for angle in (-0.35, -0.87)]  # rad, s
    person = exoid.Subject(kind="leg", body_mass=77.0, height=1.80)  # kg, m
    recording = record(motor, drops, jax.random.key(1), subject=person)

    plain = exoid.fit(recording, multistart=8)
    result = exoid.fit(recording, terms=(MagneticDetent,), multistart=8)

    for name, each in result.terms["magnetic_detent"].items():
        print(f"{name} = {each.value:.4f} ± {each.standard_error:.2g} {each.unit}, {each.set_by}")
    for name, fit in {"Eq. 9 alone": plain, "with the term": result}.items():
        print(f"{name}: {np.degrees(fit.angle_rmse):.2f} deg missed")
