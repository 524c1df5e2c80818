"""The acceleration of free fall, alike in all that is simulated and fitted."""

GRAVITY = 9.81  # m/s^2, as the paper has it
