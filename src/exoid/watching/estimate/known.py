"""What is known of a leg besides the ratios of this moment: the leg itself, and its terms."""

from exoid.online.model.model import Model
from exoid.watching.estimate.moment import Quantity
from exoid.watching.estimate.online import Belief, estimates

RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
SENSORS = ("zero", "gyro_bias", "gyro_scale", "gyro_delay")
ABSOLUTE = ("inertia", "gravity", "stiffness", "damping")
SCALED = ("kg", "N")  # units of what is as large as J begin so


def known_of(belief: Belief, model: Model) -> dict[str, Quantity]:
    """Every quantity of the leg and of the terms, whoever told it."""
    return {
        name: Quantity(name, each.value, each.error, each.unit)
        for name, each in estimates(belief, model).items()
        if name not in SENSORS
    }


def told_of(belief: Belief, model: Model, *, torque: bool) -> tuple[Quantity, ...]:
    """Besides the ratios: what motion tells of the terms, and with a torque the leg itself."""
    return tuple(
        Quantity(name, each.value, each.error, each.unit)
        for name, each in estimates(belief, model).items()
        if name not in (*RATIOS, *SENSORS)
        and each.set_by != "prior"
        and (torque or not each.unit.startswith(SCALED))
    )
