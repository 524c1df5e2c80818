"""The joint as a robot description (URDF): inertia, damping, dry friction and limits."""

from collections.abc import Iterable

from exoid.interchange.formula.expression import evaluate
from exoid.interchange.model.body import body
from exoid.interchange.model.described import described, xml_comment
from exoid.interchange.model.joint import Exported, Joint, Kept, Part
from exoid.physics.terms.device.hard_stop import HardStop

NO_SPRING = "URDF has no spring: add -c phi [N m] yourself"
EFFORT, VELOCITY = 250.0, 40.0  # N m and rad/s: beyond what a knee has


def urdf(joint: Joint) -> Exported:
    """The description. What it has no place for stands in its comment, and is told."""
    leg, kept = joint.value, [*keeping(joint)]
    shank, odd = body(leg["mass"], leg["mass"] * leg["com_distance"], leg["inertia"])
    missing = [each.what for each in kept if each.how == "in words"]
    alone = f"Not in this file, but in its comment: {', '.join(missing)}."
    text = "\n".join(
        [
            '<?xml version="1.0"?>',
            '<robot name="leg">',
            xml_comment([*described(joint), "", alone, *([odd] if odd else [])]),
            '  <link name="thigh"/>',
            '  <link name="shank">',
            "    <inertial>",
            f'      <origin xyz="{shank.distance:.12g} 0 0" rpy="0 0 0"/>',
            f'      <mass value="{shank.mass:.12g}"/>',
            f'      <inertia ixx="{shank.along:.12g}" ixy="0" ixz="0" iyy="{shank.central:.12g}" '
            f'iyz="0" izz="{shank.central:.12g}"/>',
            "    </inertial>",
            "  </link>",
            *knee(joint),
            "</robot>",
            "",
        ]
    )
    warnings = tuple(each for each in (alone, odd) if each)
    return Exported(text, tuple(kept), warnings)


def knee(joint: Joint) -> Iterable[str]:
    """The joint, limited where the leg hits a stop."""
    stops = [part for part in joint.parts if isinstance(part.term, HardStop)]
    yield f'  <joint name="knee" type="{"revolute" if stops else "continuous"}">'
    yield '    <parent link="thigh"/>'
    yield '    <child link="shank"/>'
    yield f'    <origin xyz="0 0 0" rpy="0 {-joint.thigh_angle:.12g} 0"/>'
    yield '    <axis xyz="0 -1 0"/>'
    level = sum(level_of(part, joint) or 0.0 for part in joint.parts)
    damping = joint.value["damping"]
    yield f'    <dynamics damping="{damping:.12g}" friction="{level:.12g}"/>'
    limits = f'effort="{EFFORT:g}" velocity="{VELOCITY:g}"'
    for part in stops:
        own = part.values
        lower, upper = (own[f"{part.name}_{side}_angle"] for side in ("flexion", "extension"))
        limits = f'lower="{lower:.12g}" upper="{upper:.12g}" {limits}'
    yield f"    <limit {limits}/>"
    yield "  </joint>"


def level_of(part: Part, joint: Joint) -> float | None:
    """Its dry friction [N m], where it is one level and all that the term does."""
    if part.friction.symbols - {*joint.constants} or part.torque.value != 0.0:
        return None
    return float(evaluate(part.friction, joint.constants)) or None


def keeping(joint: Joint) -> Iterable[Kept]:
    """What becomes of each thing."""
    yield Kept("leg", "exact", "inertial, damping")
    if joint.value["stiffness"]:
        yield Kept("stiffness", "in words", f"comment: {NO_SPRING}")
    for part in joint.parts:
        if isinstance(part.term, HardStop):
            yield Kept(part.name, "approximate", "limit: its angles, not how it gives way")
        elif level_of(part, joint) is not None:
            yield Kept(part.name, "exact", "dynamics friction")
        else:
            yield Kept(part.name, "in words", "comment: its formula and numbers")
    if joint.driven:
        yield Kept("drive", "in words", "comment: its numbers")
    yield Kept("encoder and gyro", "in words", "comment")
