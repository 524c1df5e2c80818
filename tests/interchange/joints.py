"""Joints that need no fit: a leg with one term, and its motion as `exoid.simulate` has it."""

from dataclasses import dataclass, replace

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from exoid.interchange.formats.python import python
from exoid.interchange.model.called import called
from exoid.interchange.model.formulas import part_of
from exoid.interchange.model.joint import Joint, Number, Part, Sensing
from exoid.interchange.model.numbers import DRIVE
from exoid.physics.leg import GRAVITY, LegModel
from exoid.physics.library import library
from exoid.physics.moment import SegmentConstants
from exoid.physics.motion.parts_of_a_step import parts_to_follow
from exoid.physics.motion.simulate import Trajectory, cycle_of, simulate
from exoid.physics.motion.with_terms import at_rest
from exoid.physics.parameter import declarations
from exoid.physics.state import LegState
from exoid.physics.term import Term, name_of
from exoid.physics.torque import CycleTorque, NoTorque
from fit_cases import leg

FLOOR = 8.7e-4  # rad, noise of the encoder
TIMES = np.arange(0.0, 2.001, 0.01)
START, THIGH, SEGMENT = -0.35, 0.03, 2  # rad, rad, number of the segment
PUSH = CycleTorque(*map(jnp.asarray, (-9.5, 1.8, 1 / 1.8, 0.0)))
SIMULATED = eqx.filter_jit(simulate)
TERMS = {name_of(term): term for term in library()}


@dataclass(frozen=True)
class Case:
    """A joint and the motion that it is to have."""

    joint: Joint
    model: LegModel

    def motion(self, finer: int = 1) -> Trajectory:
        """At the joint's times, in steps that are so many times finer; dry friction turns over as
        often as in a fit.
        """
        times = self.joint.times
        parts = np.arange(finer) / finer
        fine = (times[:-1, None] + parts * np.diff(times)[:, None]).ravel()
        start = LegState(*map(jnp.asarray, (self.joint.angle, self.joint.rate)))
        found = SIMULATED(
            self.model,
            start,
            jnp.asarray(np.append(fine, times[-1])),
            jnp.asarray(float(self.joint.number)),
            parts=parts_to_follow([*map(type, self.model.terms)], float(np.diff(fine)[0])),
        )
        return jax.tree.map(lambda each: each[::finer], found)


def usual(term: type[Term]) -> Term:
    """The term where a search of it begins, every parameter at something."""
    first = []
    for _, said in declarations(term):
        starts = said.starts_between(-1.6, START)
        first.append(starts[0] or 0.1 * min(said.upper, 1.0))
    return term(*map(jnp.asarray, first))


def numbered(term: Term) -> tuple[Number, ...]:
    name = called(type(term))
    return tuple(
        Number(
            f"{name}_{each}", said.title, said.symbol, said.unit, float(getattr(term, each)), 0.1
        )
        for each, said in declarations(type(term))
    )


def case(*terms: Term, driven: bool = False) -> Case:
    """The usual leg with these terms, let go at rest; or pushed by the voluntary cycle."""
    body, drive = leg(), PUSH if driven else NoTorque()
    model = LegModel(body, drive, jnp.asarray(THIGH), terms)
    place = SegmentConstants(
        model.ratios(), jnp.asarray(body.inertia), cycle_of(drive), jnp.asarray(float(SEGMENT))
    )
    start = LegState(jnp.asarray(START), jnp.asarray(0.0))
    first = jnp.asarray(TIMES[0])
    memories = at_rest(place, terms, start, first, drive(first) / body.inertia).memory
    moment = float(body.mass * body.com_distance) * GRAVITY
    names = ("mass", "inertia", "com_distance", "damping", "stiffness")
    numbers = (Number(name, name, name[0], "SI", float(getattr(body, name))) for name in names)
    pushes = (Number(f"drive_{name}", name, name, "", float(getattr(PUSH, name))) for name in DRIVE)
    joint = Joint(
        title=("A leg of the tests.",),
        numbers=tuple(numbers),
        gravity=Number("gravity", "gravity moment", "m l g", "N m", moment),
        ratios=(),
        thigh_angle=THIGH,
        parts=tuple(
            part_of(term, numbered(term), np.asarray(memory))
            for term, memory in zip(terms, memories, strict=True)
        ),
        angle=START,
        rate=0.0,
        drive=drive,
        drive_numbers=tuple(pushes) if driven else (),
        number=SEGMENT,
        times=TIMES,
        clock=1.0,
        sensing=Sensing(angle_noise=FLOOR, rate_noise=2e-3),
    )
    return Case(joint, model)


def of_term(name: str) -> Case:
    """A leg with this term of the library, pushed where the term changes the push."""
    term = TERMS[name]
    return case(usual(term), driven=term.voluntary or name == "fatigue")


def with_sensing(made: Case, sensing: Sensing) -> Case:
    return replace(made, joint=replace(made.joint, sensing=sensing))


def run(script: str) -> dict:
    """The names of a script of Python."""
    names: dict = {"__name__": "exported"}
    exec(compile(script, "exported.py", "exec"), names)
    return names


def played(joint: Joint) -> np.ndarray:
    """What the exported script makes of a joint: time, angle, rate, shown angle, shown rate."""
    return run(python(joint).text)["simulate"](joint.times)


def part_named(joint: Joint, name: str) -> Part:
    return next(each for each in joint.parts if each.name == name)
