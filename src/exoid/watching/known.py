"""What is known of a leg besides the ratios of this moment: the leg itself, and its terms."""

from exoid import online
from exoid.watching.moment import Quantity

RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
SENSORS = ("zero", "gyro_bias", "gyro_scale", "gyro_delay")
ABSOLUTE = ("inertia", "gravity", "stiffness", "damping")
SCALED = ("kg", "N")  # units begin so of what is as large as J


def known_of(belief: online.Belief, model: online.Model, doubt: float) -> dict[str, Quantity]:
    """Every quantity; `doubt` is the share of J that a mass leaves open which tells of it."""
    found = {}
    for name, each in online.estimates(belief, model).items():
        error = each.error
        if each.unit.startswith(SCALED):
            error = (error**2 + (doubt * each.value) ** 2) ** 0.5
        found[name] = Quantity(name, each.value, error, each.unit)
    return found


def told_of(belief: online.Belief, model: online.Model, doubt: float) -> tuple[Quantity, ...]:
    """The leg where a known mass or torque tells of it, and what motion tells of the terms."""
    by = {name: each.set_by for name, each in online.estimates(belief, model).items()}
    return tuple(
        each
        for name, each in known_of(belief, model, doubt).items()
        if name not in (*RATIOS, *SENSORS) and by[name] != "prior"
    )
