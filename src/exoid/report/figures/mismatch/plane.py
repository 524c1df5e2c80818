"""The missing torque over the phase plane: with which angle and which speed it goes."""

from typing import Any

import numpy as np
from plotly.graph_objects import Scatter

from exoid.mismatch.evidence.locate import Location
from exoid.report.figures.figure import Figure
from exoid.report.figures.style import GREY, Samples, blank, compact, thinned

HEIGHT = 420  # pixels
CLIPPED = 0.98  # quantile of the torque beyond which colours are the same
COLOURS = [(0.0, "#b35806"), (0.25, "#f1a340"), (0.5, "#dddddd"), (0.75, "#998ec3"), (1, "#542788")]


def draw_plane(location: Location) -> Figure:
    """Angle across [deg], speed up [deg/s], torque as colour and direction of the marks [N m]."""
    every = location.missing
    angle = np.degrees(np.concatenate([one.angle for one in every]))
    speed = np.degrees(np.concatenate([one.angular_velocity for one in every]))
    torque = np.concatenate([one.torque for one in every])
    kept = thinned(torque)
    drawing = blank(HEIGHT, showlegend=False, margin={"t": 12})
    drawing.add_trace(
        Scatter(
            x=compact(angle[kept]),
            y=compact(speed[kept]),
            mode="markers",
            marker=look(torque[kept]),
            hovertemplate="%{x:.1f} deg, %{y:.0f} deg/s: %{marker.color:.3f} N m<extra></extra>",
        )
    )
    drawing.update_xaxes(title_text="angle [deg]")
    drawing.update_yaxes(title_text="angular velocity [deg/s]", zeroline=True, zerolinecolor=GREY)
    return Figure(
        "plane",
        f"The missing torque in N m over angle and angular velocity: {location.pattern}.",
        "Violet, pointing up: torque towards extension is missing; brown, pointing down: towards "
        "flexion. Colours that change with the speed point to friction or drag, colours that "
        "change with the angle to a spring or a stop.",
        drawing,
    )


def look(torque: Samples) -> dict[str, Any]:
    """Colour by size, pointing where the torque does."""
    most = float(np.quantile(np.abs(torque), CLIPPED)) or 1.0
    return {
        "size": 7,
        "symbol": np.where(torque > 0, "triangle-up", "triangle-down"),
        "color": compact(torque),
        "colorscale": COLOURS,
        "cmin": -most,
        "cmax": most,
        "colorbar": {"title": {"text": "N m"}, "thickness": 12, "outlinewidth": 0},
    }
