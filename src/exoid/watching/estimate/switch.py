"""A weight that somebody puts on the shank and takes off while the leg is followed."""

from dataclasses import dataclass, field

from exoid.watching.estimate.load import BARE, Load, Mass


@dataclass
class Switch:
    """Stands for a `Load` that nobody knows beforehand. One thread switches, another one asks:
    `load` is replaced as a whole.

    >>> switch = Switch(Mass(1.0, 0.4))
    >>> switch.turn(30.0)
    >>> switch.at(29.0).weight, switch.at(31.0).weight  # kg
    (1.0, 0.0)
    """

    weight: Mass
    load: Load = field(init=False)

    def __post_init__(self):
        self.load = Load((float("-inf"),), (self.weight,))

    @property
    def on(self) -> bool:
        """Is it on the leg now?"""
        return self.load.masses[-1] == self.weight

    def turn(self, time: float) -> None:
        """From now on, the time [s] of the stream, it is off where it was on, or on again."""
        mass = BARE if self.on else self.weight
        self.load = Load((*self.load.begins, time), (*self.load.masses, mass))

    def at(self, time: float) -> Mass:
        return self.load.at(time)

    def paused(self, time: float) -> float:
        return self.load.paused(time)

    @property
    def masses(self) -> tuple[Mass, ...]:
        return self.load.masses

    @property
    def known(self) -> bool:
        return self.load.known
