"""What stands in the comments of every format: what was measured, and what anatomy said."""

import re
from collections.abc import Iterable

from exoid.interchange.model.joint import Joint

HYPHENS = re.compile("-(?=-)")
CONVENTION = (
    "phi is 0 with the knee extended and the shank horizontal, -pi/2 hanging; extension is",
    "positive. Behind a number stand its error, its unit and who told it: data, prior (which is",
    "anatomy), or both. SI units and radians.",
)


def described(joint: Joint) -> Iterable[str]:
    """In lines: what it is, and every number with its error and origin."""
    yield from joint.title
    yield from CONVENTION
    yield ""
    for each in (*joint.numbers, joint.gravity, *joint.drive_numbers):
        yield each.words
    if joint.ratios:
        yield "J, and all that is in N m, go with J and share its error; these do not:"
    for each in joint.ratios:
        yield each.words
    yield f"angle of the thigh, the knee above the hip = {joint.thigh_angle:.6g} rad"
    for part in joint.parts:
        yield ""
        yield f"{part.name}: {part.title}"
        yield from part.formula.splitlines()
        for each in part.numbers:
            yield each.words
    yield ""
    yield from sensors(joint)


def sensors(joint: Joint) -> Iterable[str]:
    """How encoder and gyro of the recording differ from the leg's angle and rate."""
    own = joint.sensing
    yield f"encoder of the recording: angle + {own.zero:.6g} rad, noise {own.angle_noise:.2g} rad"
    if own.rate_noise is not None:
        yield (
            f"gyro of the recording: {1 + own.gyro_scale:.6g} rate + {own.gyro_bias:.6g} rad/s, "
            f"noise {own.rate_noise:.2g} rad/s"
        )


def xml_comment(lines: Iterable[str], inset: str = "  ") -> str:
    """An XML comment of these lines; two hyphens in a row would end it."""
    inside = (f"{inset}  {HYPHENS.sub('- ', each)}".rstrip() for each in lines)
    return "\n".join([f"{inset}<!--", *inside, f"{inset}-->"])


def in_docstring(text: str) -> str:
    """As it stands between triple quotes of Python."""
    return text.replace("\\", "\\\\").replace('"', "'")


def in_c_comment(text: str) -> str:
    """As it stands in a comment of C, which it may not end."""
    return text.replace("*/", "* /").replace("/*", "/ *")
