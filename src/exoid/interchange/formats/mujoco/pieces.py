"""What each term becomes in MuJoCo: a shape of its own, or springs, dampers and motors by what its
torque hangs on.
"""

from collections.abc import Iterable

import numpy as np

from exoid.interchange.formats.mujoco.by_variable import (
    FASTEST,
    HIGHEST,
    LOWEST,
    Curve,
    Sum,
    by_variable,
    odd_powers,
)
from exoid.interchange.formats.mujoco.piece import Piece, together
from exoid.interchange.formats.mujoco.shapes import SHAPES
from exoid.interchange.formats.mujoco.spline import BETWEEN, springs
from exoid.interchange.formula.expression import evaluate, make, number
from exoid.interchange.model.joint import Joint, Kept, Part

KNEE = '<joint joint="knee" coef="1"/>'
FAR = -20.0  # rad, where no leg comes
ROOM = 0.3  # rad, beyond the fitted motion
STRONG = 100.0  # times what the leg weighs and met: no swing climbs a torque that is larger
POOR = 0.01  # of the torque, by which springs may be off
FURTHEST = 4.0  # rad, over which a torque must be powers of the angle to be written as such
RUBBED = 1e-4  # s, the longest step beside dry friction


def piece_of(part: Part, joint: Joint) -> Piece:
    """A term in MuJoCo.

    **Raises** `ValueError` (one line, with advice) where MuJoCo has nothing that acts like it.
    """
    shape = SHAPES.get(type(part.term))
    if shape is not None:
        return shape(part, joint)
    if not part.pushes:
        rest = "what the sensors show" if part.shows else "nothing pushes the leg here"
        return Piece((Kept(part.name, "in words", f"comment: {rest}"),))
    if part.hangs_on & {"memory", "acceleration"} or part.friction.symbols - {*joint.constants}:
        raise refused(part)
    found = by_variable(part.torque, joint.constants)
    if found is None:
        raise refused(part)
    return together([rubbing(part, joint), *summed(part, found, joint)])


def refused(part: Part, why: str | None = None) -> ValueError:
    """Why a term cannot be handed over, and what to do."""
    feels = {
        "memory": "it remembers",
        "acceleration": "it hangs on the acceleration",
        "angle": "it changes with the angle",
        "rate": "it changes with the speed",
    }
    why = why or next((said for name, said in feels.items() if name in part.hangs_on), "its form")
    return ValueError(
        f"MuJoCo's XML has nothing for {part.name} ({part.title}): {why}. Export it for Python "
        "and apply its torque by a passive callback (mjcb_passive), or fit without "
        "it."
    )


def rubbing(part: Part, joint: Joint) -> Piece:
    """Dry friction of one level."""
    level = float(evaluate(part.friction, joint.constants))
    if level == 0.0:
        return Piece()
    return Piece((Kept(part.name, "exact", "frictionloss"),), friction=level, step=RUBBED)


def summed(part: Part, found: Sum, joint: Joint) -> Iterable[Piece]:
    """A torque that is a sum of what angle, rate and time make."""
    powers = odd_powers(found.by_angle, FURTHEST) if found.by_angle else None
    if found.by_angle is not None and powers is None:
        yield splined(part, found, joint)
    else:
        if found.constant != 0.0:
            kept = Kept(part.name, "exact", f'general "{part.name}": a bias')
            yield Piece((kept,), actuators=(bias(part.name, found.constant),))
        if powers is not None:
            spring = tendon(part.name, 0.0, 0.0, *(-each for each in powers))
            yield Piece((Kept(part.name, "exact", f'tendon "{part.name}"'),), tendons=(spring,))
    if found.by_rate is not None:
        powers = odd_powers(found.by_rate, FASTEST)
        if powers is None:
            raise refused(part)
        a, b, c = (-each for each in powers)
        yield Piece((Kept(part.name, "exact", "damping of the knee"),), damping=(a, b, c))
    if found.by_time is not None:
        moving = make("sub", part.torque, number(found.constant))  # which is told above
        yield Piece((Kept(part.name, "exact", "in the torque of the drive"),), drives=(moving,))


def bias(name: str, torque: float) -> str:
    """A motor of constant torque."""
    said = f'gainprm="0" biastype="affine" biasprm="{torque:.12g} 0 0"'
    return f'<general name="{name}" joint="knee" {said}/>'


def splined(part: Part, torque: Sum, joint: Joint) -> Piece:
    """Springs that each begin at an angle, and the constant torque that is left.

    **Raises** `ValueError` where they would be another torque.
    """
    assert torque.by_angle is not None  # asked before
    low, high = joint.reach
    met = np.abs(torque.by_angle(np.linspace(low, high, BETWEEN))).max()
    size = max(float(met), joint.value["gravity"])
    lowest, highest = climbed(torque.by_angle, joint.reach, STRONG * size)
    found = springs(torque.by_angle, lowest, highest, size)
    if found.share > POOR:
        raise refused(part, "it jumps, or waves, with the angle")
    tendons = tuple(
        tendon(f"{part.name}_{at}", FAR, each.begins, each.first, each.second, each.third)
        for at, each in enumerate(found.each)
    )
    told = (
        f"{len(tendons)} tendons: within {found.error:.1g} N m, {lowest:.2g} to {highest:.2g} rad"
    )
    motor = bias(part.name, torque.constant + found.constant)
    return Piece((Kept(part.name, "approximate", told),), tendons=tendons, actuators=(motor,))


def climbed(curve: Curve, reach: tuple[float, float], most: float) -> tuple[float, float]:
    """From which angle to which a knee comes [rad], where no torque is beyond `most` [N m]."""
    lowest, highest = min(LOWEST, reach[0] - ROOM), max(HIGHEST, reach[1] + ROOM)
    below = np.linspace(reach[0], lowest, BETWEEN)
    above = np.linspace(reach[1], highest, BETWEEN)
    lowest, highest = (each[np.abs(curve(each)) <= most][-1] for each in (below, above))
    return float(lowest), float(highest)


def tendon(name: str, begins: float, ends: float, *powers: float) -> str:
    """A spring of these powers beyond `ends`, slack down to `begins` [rad]."""
    stiffness = " ".join(repr(each + 0.0) for each in powers)  # far on, large ones cancel
    return (
        f'<fixed name="{name}" springlength="{begins!r} {ends!r}" stiffness="{stiffness}"> '
        f"{KNEE} </fixed>"
    )
