# The public names and where they are: read by type checkers, and by `__init__.py` when it loads.

import typing

import typing_extensions

from .fitting.apart.fit_each import fit_each
from .fitting.errors.posterior import Posterior, sample
from .fitting.errors.profile import Profile, profiles
from .fitting.result.fit_result import FitResult
from .fitting.solve.program_cache import keep_programs_in
from .interchange.export import export
from .interchange.model.joint import Exported
from .mismatch.answer.diagnosis import Diagnosis
from .mismatch.missing_physics import diagnose
from .pendulum.drop import PendulumTest
from .pendulum.drops import measure_drops
from .physics.anatomy import expected_leg
from .physics.leg import LegModel, LegParameters
from .physics.moment import Moment
from .physics.motion.simulate import Trajectory, simulate
from .physics.parameter import parameter
from .physics.state import LegState
from .physics.term import PhysicsTerm, SensorTerm, reading
from .physics.torque import CycleTorque, MeasuredTorque, NoTorque
from .planning.plan import plan
from .planning.plan_between import plan_between
from .planning.planned import Contrast, Plan
from .recordings.declared.protocol import Protocol
from .recordings.declared.sensors import Sensors
from .recordings.declared.subject import Subject
from .recordings.formats.own_table import write_table
from .recordings.loading.from_memory import recording
from .recordings.loading.load import load
from .recordings.measured.segment import Segment
from .recordings.recording import Recording
from .report.plots.diagnosis import plot_diagnosis
from .report.plots.drops import plot_drops
from .report.plots.fit import plot_fit
from .report.saved.saved_result import SavedResult, load_result, save_result
from .trust.identifiability import Identifiability
from .trust.identify import identify
from .trust.told import fit

__all__ = [
    "Contrast",
    "CycleTorque",
    "Diagnosis",
    "Exported",
    "FitResult",
    "Identifiability",
    "LegModel",
    "LegParameters",
    "LegState",
    "MeasuredTorque",
    "Moment",
    "NoTorque",
    "PendulumTest",
    "PhysicsTerm",
    "Plan",
    "Posterior",
    "Profile",
    "Protocol",
    "Recording",
    "SavedResult",
    "Segment",
    "SensorTerm",
    "Sensors",
    "Subject",
    "Trajectory",
    "diagnose",
    "expected_leg",
    "export",
    "fit",
    "fit_each",
    "identify",
    "keep_programs_in",
    "load",
    "load_result",
    "measure_drops",
    "parameter",
    "plan",
    "plan_between",
    "plot_diagnosis",
    "plot_drops",
    "plot_fit",
    "profiles",
    "reading",
    "recording",
    "sample",
    "save_result",
    "simulate",
    "write_table",
]

__version__: str

@typing_extensions.deprecated("exoid.fit_leg is named exoid.fit")
def fit_leg(*args: typing.Any, **options: typing.Any) -> FitResult: ...
@typing_extensions.deprecated("exoid.diagnose_leg is named exoid.diagnose")
def diagnose_leg(*args: typing.Any, **options: typing.Any) -> Diagnosis: ...
