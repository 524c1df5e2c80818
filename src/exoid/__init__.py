"""Mechanical parameters of the lower leg from exoskeleton recordings.

The names below are the public ones. They load when they are first used: JAX alone takes longer to
import than most commands take to answer.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from exoid.fitting.each_segment import fit_each
    from exoid.fitting.errors.posterior import Posterior, sample
    from exoid.fitting.errors.profile import Profile, profiles
    from exoid.fitting.estimate import fit as fit_leg
    from exoid.fitting.result.fit_result import FitResult
    from exoid.fitting.solve.program_cache import keep_programs_in
    from exoid.mismatch.answer.diagnosis import Diagnosis
    from exoid.mismatch.missing_physics import diagnose as diagnose_leg
    from exoid.pendulum.drops import PendulumTest, measure_drops
    from exoid.physics.anatomy import expected_leg
    from exoid.physics.leg import LegModel, LegParameters
    from exoid.physics.moment import Moment
    from exoid.physics.motion.simulate import Trajectory, simulate
    from exoid.physics.parameter import parameter
    from exoid.physics.state import LegState
    from exoid.physics.term import PhysicsTerm, SensorTerm, reading
    from exoid.physics.torque import CycleTorque, MeasuredTorque, NoTorque
    from exoid.planning.plan import Plan, plan
    from exoid.recordings.formats.own_table import write_table
    from exoid.recordings.loading.from_memory import recording_of as recording
    from exoid.recordings.loading.load import load
    from exoid.recordings.recording import Protocol, Recording, Segment, Sensors, Subject
    from exoid.report.plots.diagnosis import plot_diagnosis
    from exoid.report.plots.drops import plot_drops
    from exoid.report.plots.fit import plot_fit
    from exoid.report.saved.saved_result import SavedResult, load_result, save_result
    from exoid.trust.identifiability import Identifiability, identify

    __version__: str

_HOMES = {
    "Diagnosis": ("exoid.mismatch.answer.diagnosis", "Diagnosis"),
    "diagnose_leg": ("exoid.mismatch.missing_physics", "diagnose"),
    "Moment": ("exoid.physics.moment", "Moment"),
    "parameter": ("exoid.physics.parameter", "parameter"),
    "PhysicsTerm": ("exoid.physics.term", "PhysicsTerm"),
    "SensorTerm": ("exoid.physics.term", "SensorTerm"),
    "reading": ("exoid.physics.term", "reading"),
    "plot_diagnosis": ("exoid.report.plots.diagnosis", "plot_diagnosis"),
    "Identifiability": ("exoid.trust.identifiability", "Identifiability"),
    "identify": ("exoid.trust.identifiability", "identify"),
    "Plan": ("exoid.planning.plan", "Plan"),
    "plan": ("exoid.planning.plan", "plan"),
    "fit_each": ("exoid.fitting.each_segment", "fit_each"),
    "fit_leg": ("exoid.fitting.estimate", "fit"),
    "FitResult": ("exoid.fitting.result.fit_result", "FitResult"),
    "Posterior": ("exoid.fitting.errors.posterior", "Posterior"),
    "sample": ("exoid.fitting.errors.posterior", "sample"),
    "Profile": ("exoid.fitting.errors.profile", "Profile"),
    "profiles": ("exoid.fitting.errors.profile", "profiles"),
    "keep_programs_in": ("exoid.fitting.solve.program_cache", "keep_programs_in"),
    "expected_leg": ("exoid.physics.anatomy", "expected_leg"),
    "LegModel": ("exoid.physics.leg", "LegModel"),
    "LegParameters": ("exoid.physics.leg", "LegParameters"),
    "Trajectory": ("exoid.physics.motion.simulate", "Trajectory"),
    "simulate": ("exoid.physics.motion.simulate", "simulate"),
    "LegState": ("exoid.physics.state", "LegState"),
    "CycleTorque": ("exoid.physics.torque", "CycleTorque"),
    "MeasuredTorque": ("exoid.physics.torque", "MeasuredTorque"),
    "NoTorque": ("exoid.physics.torque", "NoTorque"),
    "recording": ("exoid.recordings.loading.from_memory", "recording_of"),
    "load": ("exoid.recordings.loading.load", "load"),
    "Protocol": ("exoid.recordings.recording", "Protocol"),
    "Recording": ("exoid.recordings.recording", "Recording"),
    "Segment": ("exoid.recordings.recording", "Segment"),
    "Sensors": ("exoid.recordings.recording", "Sensors"),
    "Subject": ("exoid.recordings.recording", "Subject"),
    "write_table": ("exoid.recordings.formats.own_table", "write_table"),
    "plot_fit": ("exoid.report.plots.fit", "plot_fit"),
    "PendulumTest": ("exoid.pendulum.drops", "PendulumTest"),
    "measure_drops": ("exoid.pendulum.drops", "measure_drops"),
    "plot_drops": ("exoid.report.plots.drops", "plot_drops"),
    "SavedResult": ("exoid.report.saved.saved_result", "SavedResult"),
    "save_result": ("exoid.report.saved.saved_result", "save_result"),
    "load_result": ("exoid.report.saved.saved_result", "load_result"),
}

__all__ = [
    "CycleTorque",
    "Diagnosis",
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
    "diagnose_leg",
    "expected_leg",
    "fit_each",
    "fit_leg",
    "identify",
    "keep_programs_in",
    "load",
    "load_result",
    "measure_drops",
    "parameter",
    "plan",
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


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return import_module("importlib.metadata").version("exoid")
    if name not in _HOMES:
        raise AttributeError(f"module 'exoid' has no attribute {name!r}")
    module, attribute = _HOMES[name]
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted([*__all__, "__doc__", "__name__", "__version__"])
