"""A diagnosis carried to a model: from "dry friction is missing" to a leg that has it.

The hinge of this exoskeleton is worn: 0.25 N m of dry friction, which Eq. 9 lacks.
"""

import jax
import jax.numpy as jnp
import numpy as np

import exoid
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.twin.motion import Movement
from exoid.twin.protocols import record

jax.config.update("jax_enable_x64", True)
exoid.keep_programs_in()

truth = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.44, 0.265, 0.35, 2.8)))  # m, J, l, d, c
worn = exoid.LegModel(truth, exoid.NoTorque(), terms=(CoulombFriction(jnp.asarray(0.25)),))
drops = [Movement(angle, duration=4.0) for angle in (-0.35, -0.87)]  # rad, s
person = exoid.Subject(kind="leg", body_mass=77.0, height=1.80)  # kg, m
recording = record(worn, drops, jax.random.key(0), subject=person)

found = exoid.diagnose(recording)
assert found.selected == ["coulomb_friction"]
level = found.parameters[0]
print(f"missing: {found.findings[0].title}, {level.value:.3f} {level.unit}")
print(f"held out: {found.proof.before.total:.4f} rad before, {found.proof.after.total:.4f} after")

# The same leg with what was found. Motion tells m l, so any l will do.
leg = {each.name: each.after for each in found.booked}
distance = found.fit.parameters["com_distance"].value
mass = leg["gravity_moment"] / (9.81 * distance)
numbers = (mass, found.inertia, distance, leg["damping"], leg["stiffness"])
model = exoid.LegModel(
    exoid.LegParameters(*map(jnp.asarray, numbers)),
    exoid.NoTorque(),
    terms=(CoulombFriction(jnp.asarray(level.value)),),
)

for segment in found.fit.segments:
    highest = exoid.LegState(jnp.asarray(np.nanmax(segment.angle)), jnp.asarray(0.0))  # let go here
    motion = exoid.simulate(model, highest, jnp.asarray(segment.time))
    left = np.degrees(np.sqrt(np.nanmean((motion.angle - segment.angle) ** 2)))
    print(f"drop {segment.name}: {np.degrees(segment.angle_rmse):.2f} deg -> {left:.2f} deg")
