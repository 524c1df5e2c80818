"""Bare and loaded together: a known mass on the shank gives absolute values.

A drop of the bare leg tells ratios to the inertia. A second one with a weighed mass at a known
distance from the knee tells the inertia itself, and with it damping and stiffness.
"""

import jax
import jax.numpy as jnp
import numpy as np

import exoid
from exoid.twin.motion import Movement
from exoid.twin.protocols import record

jax.config.update("jax_enable_x64", True)
exoid.keep_programs_in()

truth = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.44, 0.265, 0.35, 2.8)))  # m, J, l, d, c
person = exoid.Subject(kind="leg", body_mass=77.0, height=1.80)  # kg, m
model = exoid.LegModel(truth, exoid.NoTorque())


def recorded(seed, **load):
    """A drop from 20 degrees of flexion, of 4 s."""
    drop = Movement(np.radians(-20.0), 4.0, **load)
    return record(model, [drop], jax.random.key(seed), subject=person)


bare = recorded(0)
loaded = recorded(1, added_mass=1.5, added_mass_distance=0.40)  # kg, m from the knee

alone = exoid.fit([("bare", bare)])
together = exoid.fit([("bare", bare), ("loaded", loaded)])

for name, result in (("bare", alone), ("bare and loaded", together)):
    print(f"{name}:")
    for quantity in ("inertia", "damping", "stiffness"):
        found = result.parameters[quantity]
        value = f"{found.value:.4f} ± {found.standard_error:.2g} {found.unit}"
        print(f"  {quantity} = {value}, set by {found.determined_by}")
