"""How large an effect may be that a recording does not show."""

from dataclasses import dataclass

SURE = 0.95  # of a limit


@dataclass(frozen=True)
class Limit:
    """How large an effect may be."""

    names: tuple[str, str]  # of its size and of that over J, as `of_terms` has them
    title: str
    symbol: str  # over J
    unit: str
    most: float  # over J
    most_of_leg: float  # of this leg, in the unit of the size
    unit_of_leg: str

    @property
    def words(self) -> str:
        """As a sentence."""
        return f"no {self.title} found: {self.symbol} is {self.over_inertia}."

    @property
    def over_inertia(self) -> str:
        """The limit of the size over J."""
        return f"below {self.most:.2g} {self.unit} ({100 * SURE:.0f} %)"

    @property
    def of_leg(self) -> str:
        """The limit of the size of the leg as it was fitted."""
        return f"below {self.most_of_leg:.2g} {self.unit_of_leg} ({100 * SURE:.0f} %)"
