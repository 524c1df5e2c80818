"""What the parts of a figure are, what a legend calls them, and how they look in every figure.

Okabe and Ito's colours, told apart with every kind of colour vision; dashes, hatches for print.
"""

from dataclasses import dataclass
from enum import Enum
from typing import Literal

Marker = Literal["", "circle", "diamond", "square", "down", "up", "limit"]
Hatch = Literal["", "/", "x"]
BLACK, INK, GREY, PALE = "#000000", "#404040", "#595959", "#B3B3B3"
SKY, BLUE, GREEN, RED, AMBER = "#56B4E9", "#0072B2", "#009E73", "#D55E00", "#E69F00"
WHITE = "#FFFFFF"
DIVERGING = (  # from the least to the most, pale at zero
    "#B35806",
    "#F1A340",
    "#DDDDDD",
    "#998EC3",
    "#542788",
)


@dataclass(frozen=True)
class Look:
    """Sizes in points on paper."""

    colour: str
    width: float = 0.8
    dash: tuple[float, float] | None = None  # drawn and left out, in widths
    marker: Marker = ""
    size: float = 5.0
    hollow: bool = False
    opacity: float = 1.0
    hatch: Hatch = ""


class Role(Enum):
    """Each thing by its name in a legend, and its look; none of a name that begins with a space."""

    MEASURED = "measured", Look(SKY, 2.4)
    SIMULATED = "simulated", Look(BLACK, 0.9, (4.0, 1.5))
    RESIDUAL = "simulated - measured", Look(RED, 0.7)
    SIMULATED_WITHOUT = "simulated by Eq. 9 alone", Look(AMBER, 1.1, (1.0, 1.5))
    RESIDUAL_WITHOUT = "Eq. 9 alone - measured", Look(AMBER, 0.7)
    NOISE = "noise of the sensor (±2 sd)", Look(BLACK, opacity=0.18)
    START = " start", Look(BLUE, marker="circle", size=3.0, opacity=0.5)
    MEMBER = "fits equally well", Look(BLUE, marker="circle", size=3.0, opacity=0.5)
    CHOSEN = "chosen ± standard error", Look(RED, marker="diamond")
    EXPECTED = (
        "expected ± standard deviation",
        Look(GREY, 1.0, marker="square", size=6.0, hollow=True),
    )
    LIMIT = "limit", Look(GREY, marker="limit", size=11.0)
    DATA = "data", Look(SKY)
    PRIOR = "prior", Look(WHITE, hatch="/")
    BOUND = "bound", Look(RED, hatch="x")
    PROFILE = "profile (all else refitted)", Look(BLUE, 1.2, marker="circle", size=3.0)
    PARABOLA = "parabola of the standard error", Look(GREY, 1.2, (4.0, 2.0))
    INTERVAL = "95 % interval", Look(SKY, opacity=0.3)
    LEVEL = " level", Look(BLACK, 0.8, (1.0, 1.5))
    ZERO = " zero", Look(PALE, 0.6)
    GUIDE = " guide", Look(PALE, 0.6)
    FLOOR = " noise itself", Look(BLACK, 0.9, (4.0, 2.0))
    TORQUE = "missing torque, measured", Look(INK)
    MODELLED = "by what explains it best", Look(BLUE, 1.2, (4.0, 2.0))
    TORQUE_NOISE = "what the sensors leave open (±2 sd)", Look(BLACK, opacity=0.18)
    STRONGEST = "strongest", Look(AMBER, opacity=0.35)
    BEFORE = "without it, held out", Look(RED)
    AFTER = "with it, held out", Look(BLUE, 1.1, (4.0, 1.5))
    HELD_OUT = "held out", Look(RED)
    CAUSE = " cause", Look("#DDDDDD", hatch="/")
    CHOSEN_CAUSE = " chosen cause", Look(BLUE)
    ANGLE = "measured angle", Look(SKY, 2.0)
    DRIFTED = "angle, as measured", Look(AMBER, 1.0)
    LEVEL_ANGLE = "less its drift", Look(SKY, 2.0)
    DERIVATIVE = "its derivatives", Look(BLACK, 0.9)
    RESTING = "plateau angle", Look(GREEN, 1.0, (4.0, 2.0))
    AT_REST = "at rest (±2 deg)", Look(BLACK, opacity=0.12)
    FLEXION = "peak of flexion", Look(RED, marker="down")
    EXTENSION = "peak of extension", Look(BLUE, marker="up")
    RELEASE = "release", Look(BLACK, marker="circle")
    CAME = "at rest from here", Look(GREEN, marker="square")
    LEFT = "left", Look(BLUE, marker="circle", size=4.0, opacity=0.75)
    RIGHT = "right", Look(RED, marker="square", size=3.6, opacity=0.75)
    EITHER = " side not told", Look(BLUE, marker="circle", size=4.0, opacity=0.75)
    MEAN = "mean with 95 % interval", Look(BLACK, marker="diamond", size=6.0)
    AGREED = " limits of agreement", Look(RED, 0.9, (4.0, 2.0))
    BIAS = " mean difference", Look(BLUE, 1.1)
    CENTRE = " value with its interval", Look(BLACK, marker="diamond", size=6.0)
    SURE = " 95 % interval", Look("#BFE1F6")

    @property
    def title(self) -> str:
        """In a legend; empty where it is not named there."""
        return "" if self.value[0].startswith(" ") else self.value[0]

    @property
    def look(self) -> Look:
        return self.value[1]
