"""A drop: what one fall of a relaxed leg tells, and what it does not.

The leg is simulated and seen through the sensors of the exoskeleton. For your own recording put
`exoid.load("drop.csv").recording` in place of `record`.
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
drop = Movement(start_angle=np.radians(-20.0), duration=4.0)  # rad, s
model = exoid.LegModel(truth, exoid.NoTorque())
recording = record(model, [drop], jax.random.key(0), subject=person)

result = exoid.fit(recording, multistart=64, seed=0)

print(f"{np.degrees(result.angle_rmse):.3f} deg missed, {np.degrees(result.angle_noise):.3f} noise")
for name, found in [*result.parameters.items(), *result.ratios.items()]:
    value = f"{found.value:.4g} ± {found.standard_error:.2g} {found.unit}"
    print(f"{name} = {value}, set by {found.determined_by}")
print(exoid.identify(result).sentences[-1])
