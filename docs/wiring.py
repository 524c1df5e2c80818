"""Draws `wiring.svg`: which pin goes where, where the sensors' axes point, what is positive.

    python docs/wiring.py

The pins that a node can be built with otherwise are read off the firmware's `config.h`.
"""

import re
from math import cos, radians, sin
from pathlib import Path

DOCS = Path(__file__).parent
PICTURE = DOCS / "wiring.svg"
CONFIG = DOCS.parent / "firmware" / "exoid_node" / "src" / "config.h"

WIDTH, HEIGHT = 860, 760
ROW = 30  # from pin to pin
NANO, ENCODER, CONTROLLER = (330, 150), (40, 150), (640, 150)  # left edge, width
TOP = 70  # of the boards
KNEE = (330, 440)
SHANK = 290  # length
NOW = -52  # deg, the shank that is drawn in full
SUPPLY, GROUND, SENSOR, CAN, LIGHT = "#b3261e", "#1b2a38", "#1f6fb2", "#2c7a3f", "#b26a00"
STYLE = """
text { font-family: system-ui, sans-serif; font-size: 14px; fill: #1b2a38 }
.name { font-size: 16px; font-weight: 600; text-anchor: middle } .end { text-anchor: end }
.middle { text-anchor: middle } .small { font-size: 12.5px; fill: #46596b }
.board { fill: #eef3f7; stroke: #35566f; stroke-width: 1.5 }
.bone { stroke: #9fb4c4; stroke-width: 26; stroke-linecap: round; stroke-linejoin: round;
  fill: none }
.ghost { stroke: #c9d5de; stroke-width: 2; stroke-dasharray: 7 5; fill: none }
.wire { stroke-width: 3; fill: none }
"""


def pin(name: str) -> str:
    """The number of a digital pin, as the firmware has it."""
    found = re.search(rf"{name} = (\d+);", CONFIG.read_text(encoding="utf-8"))
    assert found is not None, f"{CONFIG} has no {name}"
    return f"D{found[1]}"


def wires_to_encoder() -> list[tuple[str, str, str]]:
    """Pin of the encoder, pin of the Nano, colour."""
    both = ("VDD5V, VDD3V3", "3.3 V", SUPPLY), ("GND, DIR", "GND", GROUND)
    return [*both, ("SDA", "A4", SENSOR), ("SCL", "A5", SENSOR)]


def wires_to_controller() -> list[tuple[str, str, str]]:
    """Pin of the Nano, pin of the CAN controller, colour."""
    spi = {pin("CAN_SELECT_PIN"): "CS", "D11": "SI", "D12": "SO", "D13": "SCK"}
    both = ("3.3 V", "VCC", SUPPLY), ("GND", "GND", GROUND)
    return [*both, *((ours, theirs, CAN) for ours, theirs in spi.items())]


def text(at: tuple[float, float], words: str, kind: str = "") -> str:
    return f'<text class="{kind}" x="{at[0]:.0f}" y="{at[1]:.0f}">{words}</text>'


def line(begin, end, colour: str, tip: str = "") -> str:
    (a, b), (c, d) = begin, end
    ends = f' marker-end="url(#{tip})"' if tip else ""
    return f'<path class="wire" stroke="{colour}" d="M{a:.0f} {b:.0f}L{c:.0f} {d:.0f}"{ends}/>'


def board(place: tuple[int, int], rows: int, name: str) -> list[str]:
    (left, width), height = place, rows * ROW + 14
    box = f'<rect class="board" x="{left}" y="{TOP}" width="{width}" height="{height}" rx="8"/>'
    return [box, text((left + width / 2, TOP - 12), name, "name")]


def boards() -> list[str]:
    """The three boards, and every wire between two of their pins."""
    drawn = [
        *board(ENCODER, 4, "AS5600"),
        *board(NANO, 7, "Nano 33 IoT"),
        *board(CONTROLLER, 6, "MCP2515, 3.3 V"),
    ]
    sides = (wires_to_encoder(), ENCODER, NANO), (wires_to_controller(), NANO, CONTROLLER)
    for wires, left, right in sides:
        for row, wire in enumerate(wires):
            drawn += connection(wire, (sum(left), right[0]), TOP + ROW * (row + 0.75))
    return drawn + lamp() + bus()


def connection(wire: tuple[str, str, str], ends: tuple[int, int], y: float) -> list[str]:
    """A wire from the pin of the left board to that of the right one."""
    (begin, end), (left, right, colour) = ends, wire
    return [
        line((begin, y), (end, y), colour),
        text((begin - 10, y + 5), left, "end"),
        text((end + 10, y + 5), right),
    ]


def lamp() -> list[str]:
    """The status LED, which needs a resistor."""
    y, begin = TOP + ROW * 6.75, NANO[0]
    return [
        line((begin, y), (150, y), LIGHT),
        f'<rect x="225" y="{y - 8}" width="44" height="16" fill="#fff" stroke="{LIGHT}"/>',
        text((247, y - 14), "1 k&#937;", "middle"),
        f'<path d="M170 {y - 11}V{y + 11}L150 {y}Z" fill="{LIGHT}"/>',
        line((150, y - 11), (150, y + 11), LIGHT),
        line((150, y), (100, y), GROUND),
        text((92, y + 5), "GND", "end"),
        text((160, y + 32), "status LED", "middle small"),
        text((begin + 10, y + 5), pin("STATUS_LED_PIN")),
    ]


def bus() -> list[str]:
    """Where the CAN bus goes on."""
    x, bottom = CONTROLLER[0] + 75, TOP + 6 * ROW + 14
    return [
        line((x - 25, bottom), (x - 25, bottom + 28), CAN),
        line((x + 25, bottom), (x + 25, bottom + 28), CAN),
        text((x - 25, bottom + 45), "CAN H", "middle"),
        text((x + 25, bottom + 45), "CAN L", "middle"),
        text((x, bottom + 64), "120 &#937; at both ends of the bus", "middle small"),
    ]


def along(angle: float, distance: float, aside: float = 0.0) -> tuple[float, float]:
    """A point at a distance from the knee on a shank of that angle [deg], moved in extension."""
    c, s = cos(radians(angle)), sin(radians(angle))
    return KNEE[0] + distance * c - aside * s, KNEE[1] - distance * s - aside * c


def arc(begin: float, end: float, radius: float, colour: str) -> str:
    (a, b), (c, d) = along(begin, radius), along(end, radius)
    sweep = 0 if end > begin else 1
    return (
        f'<path class="wire" stroke="{colour}" marker-end="url(#tip)" '
        f'd="M{a:.0f} {b:.0f}A{radius} {radius} 0 0 {sweep} {c:.0f} {d:.0f}"/>'
    )


def leg() -> list[str]:
    """Thigh, shank and foot from the side, and what its angles are called."""
    (a, b), (c, d), (e, f) = KNEE, along(NOW, SHANK), along(NOW, SHANK, 52)
    ghosts = [along(0, SHANK), along(-90, SHANK)]
    return [
        *(f'<path class="ghost" d="M{a} {b}L{x:.0f} {y:.0f}"/>' for x, y in ghosts),
        f'<path class="bone" d="M{a - 240} {b}H{a}L{c:.0f} {d:.0f}L{e:.0f} {f:.0f}"/>',
        f'<circle cx="{a}" cy="{b}" r="17" fill="#fff" stroke="{SENSOR}" stroke-width="4"/>',
        f'<circle cx="{a}" cy="{b}" r="5" fill="{SENSOR}"/>',
        text((a - 10, b - 46), "encoder and magnet on the knee&#8217;s axis", "middle"),
        text((a - 160, b + 34), "thigh, level", "middle small"),
        text((a + SHANK + 12, b + 5), "0&#176;: fully extended", "small"),
        text((a - 12, b + SHANK), "&#8722;90&#176;: hanging", "end small"),
        arc(-87, -6, 84, LIGHT),
        text(along(-17, 96), "extension is positive"),
    ]


def axes() -> list[str]:
    """The Nano on the shank with the axes of its inertial sensor."""
    x, y = along(NOW, 150, 20)
    foot, front = along(NOW, 235, 20), along(NOW, 150, 118)
    return [
        f'<rect class="board" x="{x - 34:.0f}" y="{y - 14:.0f}" width="68" height="28" rx="4" '
        f'transform="rotate({-NOW} {x:.0f} {y:.0f})"/>',
        line((x, y), foot, SUPPLY, "tip"),
        line((x, y), front, SENSOR, "tip"),
        f'<circle cx="{x:.0f}" cy="{y:.0f}" r="9" fill="#fff" stroke="{CAN}" stroke-width="3"/>',
        f'<path class="wire" stroke="{CAN}" d="M{x - 6:.0f} {y - 6:.0f}l12 12m0 -12l-12 12"/>',
        text((foot[0] + 14, foot[1] - 6), "x: along the shank, to the foot"),
        text((front[0] + 10, front[1] + 5), "z: where the shank moves in extension"),
        text((front[0] + 10, front[1] + 38), "y: away from you, along the knee&#8217;s axis."),
        text((front[0] + 10, front[1] + 56), "The node sends its negative as GyroY:", "small"),
        text((front[0] + 10, front[1] + 72), "positive in extension, like the angle.", "small"),
    ]


def picture() -> str:
    """The whole picture as SVG."""
    tip = (
        '<marker id="tip" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="4.5" '
        'markerHeight="4.5" orient="auto"><path d="M0 0L8 4L0 8Z" fill="context-stroke"/></marker>'
    )
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}">',
            "<title>The wiring of the node, and the axes of its sensors</title>",
            f"<style>{STYLE}</style><defs>{tip}</defs>",
            '<rect width="100%" height="100%" fill="#ffffff"/>',
            *boards(),
            *leg(),
            *axes(),
            "</svg>\n",
        ]
    )


if __name__ == "__main__":
    PICTURE.write_text(picture(), encoding="utf-8")
