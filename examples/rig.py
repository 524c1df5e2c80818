"""A rig: a pendulum on a bench, driven by a motor whose torque is measured.

A rig has no anatomy, so no prior and no bounds of a leg. The measured torque tells the inertia.
"""

import jax
import jax.numpy as jnp
import numpy as np

import exoid

jax.config.update("jax_enable_x64", True)
exoid.keep_programs_in()

time = np.arange(0.0, 5.0, 0.01)  # s
torque = 1.5 * np.sin(2 * np.pi * 0.7 * time)  # N m
truth = exoid.LegParameters(*map(jnp.asarray, (2.0, 0.2, 0.3, 0.1, 0.0)))  # m, J, l, d, c
drive = exoid.MeasuredTorque(jnp.asarray(time), jnp.asarray(torque))
hanging = exoid.LegState(jnp.asarray(-np.pi / 2), jnp.asarray(0.0))
motion = exoid.simulate(exoid.LegModel(truth, drive), hanging, jnp.asarray(time))

noise = np.random.default_rng(0).normal(0.0, 1e-3, time.size)  # rad
recording = exoid.recording(
    time_s=time,
    raw_angle_rad=np.asarray(motion.angle) + noise,
    torque_nm=torque,
    subject={"kind": "rig"},
    protocol={"kind": "measured"},
)

result = exoid.fit(recording)

for name in ("inertia", "damping"):
    found = result.parameters[name]
    print(f"{name} = {found.value:.4f} ± {found.standard_error:.2g} {found.unit}")
gravity = result.ratios["gravity_over_inertia"].value * result.parameters["inertia"].value
print(f"m l g = {gravity:.3f} N m, {2.0 * 0.3 * 9.81:.3f} N m as built")
print(f"mass: {result.parameters['mass'].reason}")
