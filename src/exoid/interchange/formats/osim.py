"""The joint as a model of OpenSim 4: every torque with a formula is an expression force."""

from collections.abc import Iterable, Mapping

import numpy as np

from exoid.interchange.formats.lepton import NAMES, expression, unable
from exoid.interchange.formula.expression import Expression, known, make, number, symbol, total
from exoid.interchange.model.body import body
from exoid.interchange.model.described import described, xml_comment
from exoid.interchange.model.drive_over_time import drive_over_time
from exoid.interchange.model.formulas import eq9
from exoid.interchange.model.joint import Exported, Joint, Kept, Part
from exoid.physics.leg import GRAVITY

SMOOTH = 0.01  # rad/s, within which a smoothed friction turns round
OFF = 2e-3  # rad, at most, while a leg swings: 1.6e-3 of levels from 0.05 to 1.5 N m
CREEP = 0.0055  # rad/s, of a leg at rest where half of the level pulls: SMOOTH artanh(1/2)
CREEPING = (
    f"smooth below {SMOOTH:g} rad/s: within {1e3 * OFF:g} mrad while it swings; at rest it creeps, "
    f"by {1e3 * CREEP:g} mrad/s where half of its level pulls"
)
COORDINATE = "<coordinate>knee_angle</coordinate>"


def osim(joint: Joint) -> Exported:
    """The model.

    **Raises** `ValueError` where a term remembers: OpenSim's expressions know angle and rate alone.
    """
    leg = joint.value
    shank, odd = body(leg["mass"], leg["mass"] * leg["com_distance"], leg["inertia"])
    forces, moving = dict(expressions(joint)), driven(joint)
    inertia = f"{shank.along!r} {shank.central!r} {shank.central!r} 0 0 0"
    text = "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            '<OpenSimDocument Version="40000">',
            xml_comment([*described(joint), *([odd] if odd else [])]),
            '<Model name="leg">',
            f"  <gravity>0 {-GRAVITY} 0</gravity>",
            '  <Ground name="ground"/>',
            '  <BodySet name="bodyset"><objects>',
            f'    <Body name="shank"> <mass>{shank.mass!r}</mass> '
            f"<mass_center>{shank.distance!r} 0 0</mass_center> <inertia>{inertia}</inertia> "
            "</Body>",
            "  </objects></BodySet>",
            *knee(joint),
            *(controller(joint) if moving else ()),
            '  <ForceSet name="forceset"><objects>',
            '    <SpringGeneralizedForce name="passive">',
            f"      {COORDINATE} <stiffness>{leg['stiffness']!r}</stiffness>",
            f"      <rest_length>0</rest_length> <viscosity>{leg['damping']!r}</viscosity>",
            "    </SpringGeneralizedForce>",
            *(force(name, root) for name, root in forces.items()),
            *(actuator() if moving else ()),
            "  </objects></ForceSet>",
            "</Model>",
            "</OpenSimDocument>",
            "",
        ]
    )
    return Exported(text, tuple(keeping(joint, forces)), (odd,) if odd else ())


def driven(joint: Joint) -> bool:
    """Does anything drive it over time?"""
    return joint.driven


def expressions(joint: Joint) -> Iterable[tuple[str, Expression]]:
    """Every torque of the terms, by angle and rate [N m]."""
    quiet = {**joint.constants, "drive_amplitude": 0.0}
    plain = [part for part in joint.parts if not part.term.inertial]
    pushed = make("add", eq9(), make("div", total([each.torque for each in plain]), INERTIA))
    for part in joint.parts:
        torque = part.torque
        if part.term.inertial:
            torque = known(torque, {"acceleration": pushed})
        torque = known(torque, quiet)
        rubbed = rubbing(part, quiet)
        if unknown := (torque.symbols | rubbed.symbols) - {*NAMES}:
            remembers = any("memory" in each for each in unknown)
            raise refused(part, "it remembers" if remembers else "it hangs on more")
        if part.term.inertial and joint.driven:
            raise refused(part, "it hangs on more")
        if why := unable(torque) or unable(rubbed):
            raise refused(part, why)
        if torque.value != 0.0:
            yield part.name, torque
        if rubbed.value != 0.0:
            yield f"{part.name}_smoothed", rubbed


INERTIA = symbol("inertia")


def rubbing(part: Part, constants: Mapping[str, float]) -> Expression:
    """Its dry friction, smoothed, since an expression cannot hold a leg at rest."""
    way = make("tanh", make("div", symbol("rate"), number(SMOOTH)))
    return known(make("neg", make("mul", part.friction, way)), constants)


def refused(part: Part, why: str) -> ValueError:
    return ValueError(
        f"OpenSim's expressions know angle and rate alone, and nothing of {part.name} "
        f"({part.title}): {why}. Export it for Python, or fit without it."
    )


def force(name: str, root: Expression) -> str:
    """A force with a formula."""
    return (
        f'    <ExpressionBasedCoordinateForce name="{name}"> {COORDINATE} '
        f"<expression>{expression(root)}</expression> </ExpressionBasedCoordinateForce>"
    )


def knee(joint: Joint) -> Iterable[str]:
    """A pin about z: x points along the extended shank, y up."""
    yield '  <JointSet name="jointset"><objects>'
    yield '    <PinJoint name="knee">'
    yield "      <socket_parent_frame>thigh</socket_parent_frame>"
    yield "      <socket_child_frame>/bodyset/shank</socket_child_frame>"
    yield '      <coordinates> <Coordinate name="knee_angle">'
    yield f"        <default_value>{joint.angle!r}</default_value>"
    yield f"        <default_speed_value>{joint.rate!r}</default_speed_value>"
    yield f"        <range>{-np.pi!r} {np.pi!r}</range> <clamped>false</clamped>"
    yield "      </Coordinate> </coordinates>"
    yield '      <frames> <PhysicalOffsetFrame name="thigh">'
    yield "        <socket_parent>/ground</socket_parent> <translation>0 1 0</translation>"
    yield f"        <orientation>0 0 {joint.thigh_angle!r}</orientation>"
    yield "      </PhysicalOffsetFrame> </frames>"
    yield "    </PinJoint>"
    yield "  </objects></JointSet>"


def actuator() -> Iterable[str]:
    yield f'    <CoordinateActuator name="drive"> {COORDINATE} <optimal_force>1</optimal_force>'
    yield "    </CoordinateActuator>"


def controller(joint: Joint) -> Iterable[str]:
    """The torque over time [N m], straight between its numbers."""
    time, torque = drive_over_time(joint, [part.torque for part in joint.parts])
    rows = (" ".join(f"{value:.12g}" for value in each) for each in (time, torque))
    x, y = rows
    yield '  <ControllerSet name="controllerset"><objects>'
    yield '    <PrescribedController name="driving"> <actuator_list>drive</actuator_list>'
    yield '      <FunctionSet name="ControlFunctions"><objects>'
    yield f'        <PiecewiseLinearFunction name="drive"> <x>{x}</x> <y>{y}</y>'
    yield "        </PiecewiseLinearFunction>"
    yield "      </objects></FunctionSet>"
    yield "    </PrescribedController>"
    yield "  </objects></ControllerSet>"


def keeping(joint: Joint, forces: Mapping[str, Expression]) -> Iterable[Kept]:
    """What became of each thing."""
    yield Kept("leg", "exact", 'body "shank", force "passive"')
    for part in joint.parts:
        if part.name in forces:
            yield Kept(part.name, "exact", f'expression force "{part.name}"')
        if f"{part.name}_smoothed" in forces:
            yield Kept(part.name, "approximate", f'force "{part.name}_smoothed": {CREEPING}')
        if part.pushes and joint.driven and "time" in part.torque.symbols:
            yield Kept(part.name, "exact", 'in the torque of "drive"')
        if not part.pushes:
            yield Kept(part.name, "in words", "comment: what the sensors show")
    if joint.driven:
        yield Kept("drive", "exact", 'actuator "drive", controller "driving"')
    yield Kept("encoder and gyro", "in words", "comment")
