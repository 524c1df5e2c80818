"""Terms that are, or look exactly as, a constant torque."""

CONSTANT_TORQUES = frozenset({"stiffness_rest_angle", "torque_bias"})  # names
