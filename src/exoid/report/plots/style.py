"""How the figure of a fit looks: one colour, dash and hatch for each thing, in every panel."""

from typing import Any, Literal

from matplotlib.axes import Axes
from matplotlib.figure import SubFigure

Place = Literal["outside upper center", "outside lower center"]

# Okabe and Ito's colours, told apart with every kind of colour vision; dashes, hatches for print.
MEASURED = {"color": "#56B4E9", "linewidth": 2.4, "label": "measured"}
SIMULATED = {"color": "black", "linewidth": 0.9, "linestyle": (0, (4, 1.5)), "label": "simulated"}
RESIDUAL = {"color": "#D55E00", "linewidth": 0.7, "label": "residual (simulated - measured)"}
NOISE = {"color": "0.8", "linewidth": 0, "label": "noise of the sensor (±2 sd)"}
MEMBER = {"color": "#0072B2", "marker": "o", "markersize": 3, "linestyle": "", "alpha": 0.5}
CHOSEN = {
    "color": "#D55E00",
    "marker": "D",
    "markersize": 5,
    "linestyle": "",
    "capsize": 2,
    "label": "chosen ± standard error",
}
EXPECTED = {
    "color": "0.35",
    "marker": "s",
    "markersize": 7,
    "markerfacecolor": "none",
    "linestyle": "",
    "capsize": 4,
    "label": "expected ± standard deviation",
}
SHARE: dict[str, dict[str, Any]] = {
    "data": {"facecolor": "#56B4E9"},
    "prior": {"facecolor": "white", "hatch": "/////"},
    "bound": {"facecolor": "#D55E00", "hatch": "xxxx"},
}
PROFILE = {
    "color": "#0072B2",
    "marker": "o",
    "markersize": 3,
    "linewidth": 1.2,
    "label": "profile (all else refitted)",
}
PARABOLA = {
    "color": "0.45",
    "linewidth": 1.2,
    "linestyle": (0, (4, 2)),
    "label": "parabola of the standard error",
}
INTERVAL = {
    "facecolor": "#56B4E9",
    "alpha": 0.3,
    "linewidth": 0,
    "label": "95 % interval",
}
LEVEL = {"color": "black", "linewidth": 0.8, "linestyle": ":"}
TEXT: dict[Any, Any] = {
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.labelsize": 8,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "legend.fontsize": 8,
    "figure.titlesize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.unicode_minus": True,
    "hatch.linewidth": 0.6,
}


def entries(panels: list[Axes]) -> dict[str, Any]:
    """What a legend can name in these panels, each thing once."""
    found: dict[str, Any] = {}
    for axes in panels:
        handles, labels = axes.get_legend_handles_labels()
        found.update(zip(labels, handles, strict=True))
    return found


def name_all(figure: SubFigure, panels: list[Axes], where: Place, across: int = 4) -> None:
    """One legend for all panels; none where there is nothing to name."""
    found = entries(panels)
    if found:
        figure.legend(found.values(), found.keys(), loc=where, ncols=across, frameon=False)


def head(figure: SubFigure, title: str) -> None:
    """What a row of panels is about."""
    figure.suptitle(title, x=0.008, ha="left", fontweight="bold")


def in_words(name: str) -> str:
    """The name of a parameter as an axis has it."""
    return name.replace("_", " ")
