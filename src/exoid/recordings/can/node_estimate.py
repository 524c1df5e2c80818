"""What a node says it has learned of the leg, and in words how far that can be believed."""

from dataclasses import dataclass

from exoid.files.counted import counted

NAMES = ("m l g / J", "c / J", "d / J", "constant torque / J", "dry friction / J")
UNITS = ("1/s^2", "1/s^2", "1/s", "1/s^2", "1/s^2")
UNEXPLAINED, CHANGED = "the model does not explain the movement", "the leg has changed"
TRUST = (  # by its number in EXO_LEARNING
    "waiting for a free movement",
    "learning",
    "good",
    "enough",
    UNEXPLAINED,
    CHANGED,
    "its samples are faulty",
)
UNKNOWN = "unknown"


@dataclass(frozen=True)
class NodeEstimate:
    """The leg by the node; ratios in the order of NAMES."""

    trust: str
    drops: int  # free movements that count
    ratios: tuple[float, ...]
    errors: tuple[float, ...]  # standard

    @property
    def short(self) -> str:
        """The first ratio and its trust, for a line that has little room."""
        return f"{NAMES[0]} {self.ratios[0]:.4g} ± {self.errors[0]:.2g}, {self.trust}"

    @property
    def line(self) -> str:
        """In one line; nothing but its trust while it knows no more than anatomy."""
        if not self.drops:
            return f"the node has learned nothing of the leg: {self.trust}"
        told = zip(NAMES, self.ratios, self.errors, UNITS, strict=True)
        values = ", ".join(
            f"{name} {value:.4g} ± {error:.2g} {unit}" for name, value, error, unit in told
        )
        return (
            f"learned by the node of {counted(self.drops, 'free movement')}, {self.trust}: {values}"
        )


def word(trust: int) -> str:
    """What a number of EXO_LEARNING.Trust means."""
    return TRUST[trust] if trust < len(TRUST) else UNKNOWN
