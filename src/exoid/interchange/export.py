"""Hand a fitted model on to other tools."""

from collections.abc import Callable
from typing import Literal

from exoid.fitting.result.fit_result import FitResult
from exoid.interchange.formats.c import c
from exoid.interchange.formats.mjcf import mjcf
from exoid.interchange.formats.osim import osim
from exoid.interchange.formats.python import python
from exoid.interchange.formats.urdf import urdf
from exoid.interchange.gather import gather
from exoid.interchange.joint import Exported, Joint
from exoid.mismatch.answer.diagnosis import Diagnosis

Form = Literal["mjcf", "urdf", "osim", "c", "python"]
FORMATS: dict[str, Callable[[Joint], Exported]] = {
    "mjcf": mjcf,
    "urdf": urdf,
    "osim": osim,
    "c": c,
    "python": python,
}


def export(found: FitResult | Diagnosis, form: Form, *, segment: int | None = None) -> Exported:
    """The fitted leg with its terms as MuJoCo, URDF, OpenSim, C or Python has it."""
    result = found.fit if isinstance(found, Diagnosis) else found
    return FORMATS[form](gather(result, segment))
