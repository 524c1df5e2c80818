"""Hand a fitted model on to other tools."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Literal

import jax

from exoid.fitting.result.fit_result import FitResult
from exoid.interchange.formats.c import c
from exoid.interchange.formats.mjcf import mjcf
from exoid.interchange.formats.osim import osim
from exoid.interchange.formats.python import python
from exoid.interchange.formats.urdf import urdf
from exoid.interchange.model.gather import gather
from exoid.interchange.model.joint import Exported, Joint
from exoid.mismatch.answer.diagnosis import Diagnosis

Form = Literal["mjcf", "urdf", "osim", "c", "python"]
FORMATS: dict[str, Callable[[Joint], Exported]] = {
    "mjcf": mjcf,
    "urdf": urdf,
    "osim": osim,
    "c": c,
    "python": python,
}


UNTOLD = (
    "nothing told {names}: the file holds a leg that moves alike, right but for one factor of all "
    "masses and torques. Give body mass and height, or record a drop with a known mass."
)
UNSETTLED = (
    "the diagnosis cannot tell what is missing: this is the fit of Eq. 9 alone, which does not "
    "explain all of the recording."
)


def export(found: FitResult | Diagnosis, form: Form, *, segment: int | None = None) -> Exported:
    """The fitted leg with its terms in the words of MuJoCo, URDF, OpenSim, C or Python.

    Of a diagnosis it is the model with what was found. The leg is bare and free, and begins as the
    first segment did; of a `segment`, counted from 0, it has the added mass and the torque, too.

    **Raises** `ValueError` where the form has nothing that acts like a term, by its name and with
    advice; where every segment was fitted alone; for a fit that an older exoid saved.

    >>> found = exoid.export(exoid.fit("drops.csv"), "mjcf")
    >>> found.text.splitlines()[0], found.warnings
    ('<mujoco model="leg">', ())
    """
    result = found.fit if isinstance(found, Diagnosis) else found
    with jax.enable_x64(True):  # else formulas and memories would lose half of their digits
        made = FORMATS[form](gather(result, segment))
    return replace(made, warnings=(*cautions(found, result), *made.warnings))


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
