"""Hand a fitted model on to other tools."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import degrees
from typing import Protocol, runtime_checkable

import jax

from exoid.fitting.result.fit_result import FitResult
from exoid.interchange.formats.c import c
from exoid.interchange.formats.mjcf import mjcf
from exoid.interchange.formats.osim import osim
from exoid.interchange.formats.python import python
from exoid.interchange.formats.urdf import urdf
from exoid.interchange.model.gather import gather
from exoid.interchange.model.joint import Exported, Joint, Kept
from exoid.interchange.model.numbers import effects_not_found
from exoid.mismatch.answer.diagnosis import Diagnosis

FORMATS: dict[str, Callable[[Joint], Exported]] = {
    "mjcf": mjcf,
    "urdf": urdf,
    "osim": osim,
    "c": c,
    "python": python,
}
FORMS = ", ".join(FORMATS)

LOST = "the fit does not follow its recording ({why}): none of its numbers is to be used."
UNTOLD = (
    "nothing told {names}: the file holds a leg that moves alike, right but for one factor of all "
    "masses and torques. Give body mass and height, or record a drop with a known mass."
)
SIZELESS = (
    "nothing told m, J and l: every torque of a C header would be off by one unknown factor, "
    "before a motor and a person. Give body mass and height, or record a drop with a known mass."
)
UNSETTLED = (
    "the diagnosis cannot tell what is missing: this is the fit of Eq. 9 alone, which does not "
    "explain all of the recording."
)
SEATED = (
    "it sits as in the recording, the knee {angle:.1f} deg above the hip: for another seat change "
    "the angle of the thigh in the file."
)
SEEN = 1.0  # deg that a seat is visibly off the level


@runtime_checkable
class Saved(Protocol):
    """What `load_result` gave: a fit, and the diagnosis where it is of one."""

    @property
    def result(self) -> FitResult: ...

    @property
    def diagnosis(self) -> Diagnosis | None: ...


def export(
    found: FitResult | Diagnosis | Saved, form: str, *, segment: int | None = None
) -> Exported:
    """The fitted leg with its terms in the words of MuJoCo, URDF, OpenSim, C or Python, as the
    `form` mjcf, urdf, osim, c or python.

    Of a diagnosis it is the model with what was found. The leg is bare and free, and sits and
    begins as the first segment did; of a `segment`, counted from 0, it has the added mass and the
    torque, too.

    **Raises** `ValueError` where the form has nothing that acts like a term, by its name and with
    advice; where every segment was fitted alone; for a fit that does not follow its recording, or
    that an older exoid saved; for C where nothing told how large torques are.

    >>> found = exoid.export(exoid.fit("drops.csv"), "mjcf")
    >>> found.text.splitlines()[0], found.warnings
    ('<mujoco model="leg">', ())
    """
    if form not in FORMATS:
        raise ValueError(f"{form!r} is no format that a leg is exported to: give one of {FORMS}.")
    if isinstance(found, Saved):
        found = found.diagnosis or found.result
    result = found.fit if isinstance(found, Diagnosis) else found
    if result.astray is not None:
        raise ValueError(LOST.format(why=result.astray))
    if form == "c" and result.leg is not None and result.parameters["inertia"].value is None:
        raise ValueError(SIZELESS)
    with jax.enable_x64(True):  # else formulas and memories would lose half of their digits
        joint = gather(result, segment)
        made = FORMATS[form](joint)
    said = *cautions(found, result), *seat(joint)
    return replace(made, kept=with_limits(made.kept, result), warnings=(*said, *made.warnings))


def with_limits(kept: tuple[Kept, ...], result: FitResult) -> tuple[Kept, ...]:
    """What became of each thing; how large an effect may be that the recording does not show."""
    none = {name: each.of_leg for name, each in effects_not_found(result).items()}
    return tuple(
        replace(each, how="none found", where=f"{each.where}: {none[each.what]}")
        if each.what in none
        else each
        for each in kept
    )


def doubts(found: FitResult | Diagnosis, result: FitResult) -> Iterator[str]:
    """Why its numbers may be wrong."""
    if result.astray is not None:
        yield f"the fit does not follow its recording ({result.astray}): trust no number of it."
    if isinstance(found, Diagnosis) and found.verdict == "cannot_tell" and found.after is None:
        yield UNSETTLED


def cautions(found: FitResult | Diagnosis, result: FitResult) -> Iterator[str]:
    """What to know before the file is used."""
    yield from doubts(found, result)
    if result.parameters["inertia"].value is None:
        yield UNTOLD.format(names="m, J and l")


def seat(joint: Joint) -> Iterator[str]:
    """What a leg on another seat is not moved by."""
    angle = degrees(joint.thigh_angle)
    if abs(angle) > SEEN:
        yield SEATED.format(angle=angle)
