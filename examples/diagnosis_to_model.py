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
assert found.after is not None
print(f"missing: {found.findings[0].title}")
print(f"held out: {found.proof.before.total:.4f} rad before, {found.proof.after.total:.4f} after")

damping = "damping_over_inertia"
for name, fit in {"Eq. 9 alone": found.before, "with friction": found.after}.items():
    ratio = fit.ratios[damping]
    print(f"{name}: {damping} = {ratio.value:.4f} ± {ratio.standard_error:.2g} {ratio.unit}")
for name, each in found.after.terms["coulomb_friction"].items():
    print(f"{name} = {each.value:.4f} ± {each.standard_error:.2g} {each.unit}")

# Both models predict a drop from 80 degrees of flexion, which was not recorded.
start = exoid.LegState(jnp.radians(-80.0), jnp.asarray(0.0))
time = jnp.arange(0.0, 4.0, 0.01)
true = exoid.simulate(worn, start, time).angle
for name, fit in {"Eq. 9 alone": found.before, "with friction": found.after}.items():
    angle = exoid.simulate(fit.model, start, time).angle
    print(f"{name}: off by {np.degrees(np.abs(angle - true).max()):.2f} deg at most")
