"""What a piece of missing physics, or an error of a sensor, is: one class, in a file of its own."""

from abc import abstractmethod
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, ClassVar, Literal

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment

Moved = Literal["leg", "rig", "motor"]  # what moves: a leg, a rig by itself, an axis by its motor
BUSY = 6  # steps within a step, from which on running takes longer than compiling
Memory = Float[Array, " memory"]
Scalar = Float[Array, ""]


class Reading(eqx.Module):
    """By how much the sensors show another motion than the leg's, and how late the gyro does."""

    angle: Float[Any, "*batch"]  # rad
    angular_velocity: Float[Any, "*batch"]  # rad/s
    delay: Float[Any, "*batch"]  # s, of the gyro

    def __add__(self, other: "Reading") -> "Reading":
        return jax.tree.map(jnp.add, self, other)


def reading(angle: Any = 0.0, angular_velocity: Any = 0.0, delay: Any = 0.0) -> Reading:
    """A `Reading`; what is not said is right.

    >>> float(exoid.reading(angle=0.01).delay)  # s
    0.0
    """
    return Reading(jnp.asarray(angle), jnp.asarray(angular_velocity), jnp.asarray(delay))


class Term(eqx.Module):
    """Something that Eq. 9 leaves out. Its first parameter is its size.

    Parameters are fields declared by `parameter`, with the places where a search begins. What a
    term does not say for itself is nothing.
    """

    title: eqx.AbstractClassVar[str]
    reference: eqx.AbstractClassVar[str]
    explanation: eqx.AbstractClassVar[str]  # one sentence for the user
    isolate: eqx.AbstractClassVar[str]  # the recording that would show it apart from others

    isolate_driven: ClassVar[str] = ""  # the recording of an axis whose torque is known, if another
    isolate_rig: ClassVar[str] = ""  # the recording of a rig that swings by itself, if another
    remark: ClassVar[str] = ""  # what to know of its numbers
    twin: ClassVar[str] = ""  # what looks the same in every recording
    named_only: ClassVar[bool] = False  # need no search try it by itself: a twin, or a finer form
    steady: ClassVar[bool] = False  # is its torque the same at all times
    same_torque: ClassVar[str] = ""  # the term that pushes just like this one, whatever is recorded
    opposite: ClassVar[str] = ""  # the term that this one takes in where the two are opposite
    memory_size: ClassVar[int] = 0  # of a state of its own
    lasting: ClassVar[bool] = False  # may the state outlast that the leg is held before a drop
    begun: ClassVar[str] = ""  # the parameter that says how the state begins
    moves_zero: ClassVar[bool] = False  # does it move the encoder's zero between segments
    jumps: ClassVar[bool] = False  # does the gyro's reading jump
    substeps: ClassVar[int] = 1  # of 10 ms or more, where the term is faster than the leg
    voluntary: ClassVar[bool] = False  # does it change the torque of Eq. 10, and nothing else
    living: ClassVar[bool] = False  # does it take a person's leg, so that no rig has it
    mechanical: ClassVar[bool] = False  # does only a rig have it, and no person's leg
    inertial: ClassVar[bool] = False  # does its torque hang on the acceleration
    by_whole_drops: ClassVar[bool] = False  # can no sample by itself tell its numbers, but a drop
    period: ClassVar[float] = 0.0  # rad, after which what it shows repeats
    everyday: ClassVar[bool] = False  # does every gyro have some of it
    # What legs really do may follow another law: by how much a number of another term is off then.
    law_of: ClassVar[Mapping[str, float]] = MappingProxyType({})
    replaces: ClassVar[str] = ""  # what a fit estimates of every recording and the term is itself

    @classmethod
    def isolated_by(cls, moved: Moved) -> str:
        """The recording that would show it apart from others."""
        own = {"leg": "", "rig": cls.isolate_rig, "motor": cls.isolate_driven}
        return own[moved] or cls.isolate

    @staticmethod
    def as_twin(size: Any) -> Any:
        """The size of its `twin` that looks the same."""
        return size

    @staticmethod
    def as_same_torque(size: Any, stiffness: Any) -> Any:
        """The size of the term named `same_torque` on a leg of this stiffness [N m/rad]."""
        return size

    def includes(self) -> str:
        """The name of another term that is a part of this one at these values."""
        return ""

    def itself(self) -> bool:
        """Is it at these values still what it is called?"""
        return True

    def possible(self) -> bool:
        """Can a person's leg have it at these values?"""
        return True

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        """The missing torque [N m], extension positive."""
        return jnp.zeros(())

    def dry_friction(self, now: Moment) -> Scalar:
        """The torque [N m] that holds a leg at rest, and opposes one that moves."""
        return jnp.zeros(())

    def memory_at_rest(self, now: Moment) -> Memory:
        """The term's own state while the leg was held still at `now`."""
        return jnp.zeros(self.memory_size)

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        """Its time derivative."""
        return jnp.zeros(self.memory_size)

    def memory_within(self, now: Moment, memory: Memory) -> Memory:
        """The term's own state brought back to where it can be, after every step."""
        return memory

    def gaps(self, now: Moment, memory: Memory) -> tuple[tuple[Scalar, Scalar], ...]:
        """How far [rad] each contact is at which the torque jumps, and how fast that grows. Such a
        torque takes `now.place.slack` for touching.
        """
        return ()

    def shown(self, now: Moment, memory: Memory) -> Reading:
        """What the sensors show minus how the leg moves."""
        return reading(0.0 * now.angle)


class PhysicsTerm(Term):
    """A torque on the leg that Eq. 9 does not have: `torque`, or `dry_friction` that sticks.

    >>> class Mud(exoid.PhysicsTerm):
    ...     title = reference = explanation = isolate = "mud"
    ...     level: jax.Array = exoid.parameter("D", "N m s/rad", 0.0, 5.0, "drag", (0.1,))
    ...     def torque(self, now, memory):
    ...         return -self.level * now.angular_velocity
    >>> leg = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
    >>> model = exoid.LegModel(leg, exoid.NoTorque(), terms=(Mud(jnp.asarray(0.1)),))
    """


class SensorTerm(Term):
    """An error of a sensor: the leg moves as Eq. 9 says, but is shown otherwise.

    >>> class Stretched(exoid.SensorTerm):
    ...     title = reference = explanation = isolate = "stretched"
    ...     gain: jax.Array = exoid.parameter("g", "1", -0.1, 0.1, "gain", (0.01,))
    ...     def shown(self, now, memory):
    ...         return exoid.reading(self.gain * now.angle)
    >>> float(Stretched(jnp.asarray(0.01)).gain)
    0.01
    """

    @abstractmethod
    def shown(self, now: Moment, memory: Memory) -> Reading:
        """What the sensors show minus how the leg moves."""


def holds(term: type[Term]) -> bool:
    """Does it hold a leg at rest?"""
    return term.dry_friction is not Term.dry_friction


def strikes(term: type[Term]) -> bool:
    """Does its torque jump where something meets?"""
    return term.gaps is not Term.gaps


def busy(term: type[Term]) -> bool:
    """Is it so much faster than the leg that it costs far more than other terms?"""
    return term.substeps > BUSY


def brief(term: type[Term]) -> bool:
    """Is it sooner worked out along a motion than a program for it is optimised?"""
    return term.memory_size < 2


def name_of(term: type[Term]) -> str:
    """coulomb_friction for CoulombFriction."""
    letters = (f"_{each.lower()}" if each.isupper() else each for each in term.__name__)
    return "".join(letters).lstrip("_")


def pushing_alike(terms: Sequence[type[Term]]) -> list[type[Term]]:
    """Those of which another one pushes just alike, at every angle and under every load."""
    known = set(map(name_of, terms))
    return [term for term in dict.fromkeys(terms) if term.same_torque in known]


def of_alike(terms: Sequence[type[Term]]) -> str:
    """That nothing has to be recorded for their sake."""
    return (
        f"{' and '.join(term.title for term in terms)} push alike at every angle and with every "
        "mass: no recording of the motion tells them apart, and nothing of the leg but the name "
        "hangs on which it is."
    )
