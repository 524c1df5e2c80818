"""What is known of a leg besides the ratios of this moment: the leg itself, its terms, and the
ratios of before it changed.
"""

import numpy as np

from exoid.online.model.model import Model
from exoid.online.model.trust import Phase, Trust
from exoid.online.outlook import Outlook
from exoid.watching.estimate.moment import Change, Quantity
from exoid.watching.estimate.online import Belief, estimates

RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
UNITS = ("1/s^2", "1/s^2", "1/s")  # of those
SENSORS = ("zero", "gyro_bias", "gyro_scale", "gyro_delay")
ABSOLUTE = ("inertia", "gravity", "stiffness", "damping")
SCALED = ("kg", "N")  # units of what is as large as J begin so


def ratios_of(said: Outlook, at: int) -> tuple[Quantity, ...]:
    """The ratios that were said after a sample."""
    numbers = said.ratios, said.errors, said.if_slack
    values, errors, slack = (each[at].tolist() for each in numbers)
    felt = [more if more >= error else None for more, error in zip(slack, errors, strict=True)]
    return tuple(map(Quantity, RATIOS, values, errors, UNITS, felt))


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


class Changes:
    """Follows what an estimator says: where do its ratios begin to rest on other drops?"""

    def __init__(self):
        self.known: Change | None = None  # what is known, as if another leg were to come
        self.open: Change | None = None  # until a drop of the other leg has ended
        self.due: Change | None = None  # of a drop that ended as nobody could believe its numbers

    def look(self, said: Outlook, until: int) -> None:
        """Remember what is known while nothing moves; a drop that was taken back told nothing."""
        still = np.flatnonzero(said.phase[:until] != Phase.MOVING)
        if still.size and self.open is None:
            at = int(still[-1])
            drops, known = int(said.rests[at]), ratios_of(said, at)
            self.known = Change(float(said.ended[at]), drops, known) if drops else None

    def begun(self, said: Outlook, at: int) -> None:
        """Amid a movement it is sure that this is another leg."""
        self.open = self.since(said, at, another=True)

    def counted(self, said: Outlook, at: int) -> Change | None:
        """A drop has ended: is it the first one of other numbers that can be believed?"""
        found, self.open = self.open or self.due, None
        if found is None and said.rests[at] == 1:
            found = self.since(said, at, another=False)
        believed = said.trust[at] != Trust.UNEXPLAINED  # a pause that was foreseen is no fault
        self.due = None if believed else found
        return found if believed else None

    def taken_back(self) -> None:
        """The last drop told nothing."""
        self.due = None

    def since(self, said: Outlook, at: int, *, another: bool) -> Change | None:
        if self.known is None:
            return None
        return Change(float(said.begun[at]), self.known.drops, self.known.before, another)
