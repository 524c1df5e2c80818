"""Mechanical parameters of the lower leg from exoskeleton recordings.

The names below are the public ones. They load when they are first used: JAX alone takes longer to
import than most commands take to answer.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from exoid.diagnose.diagnosis import Diagnosis
    from exoid.diagnose.identifiability import Identifiability, identify
    from exoid.diagnose.missing_physics import diagnose as diagnose_leg
    from exoid.diagnose.plan import Plan, plan
    from exoid.fit.each import fit_each
    from exoid.fit.estimate import fit as fit_leg
    from exoid.fit.posterior import Posterior, sample
    from exoid.fit.profile import Profile, profiles
    from exoid.fit.program import keep_programs_in
    from exoid.fit.result import FitResult
    from exoid.physics.anatomy import expected_leg
    from exoid.physics.leg import LegModel, LegParameters
    from exoid.physics.moment import Moment
    from exoid.physics.parameter import parameter
    from exoid.physics.simulate import Trajectory, simulate
    from exoid.physics.state import LegState
    from exoid.physics.term import PhysicsTerm, SensorTerm, reading
    from exoid.physics.torque import CycleTorque, MeasuredTorque, NoTorque
    from exoid.recording.frame import recording_of as recording
    from exoid.recording.load import load
    from exoid.recording.pendulum.drops import PendulumTest, measure_drops
    from exoid.recording.recording import Protocol, Recording, Segment, Sensors, Subject
    from exoid.recording.table import write_table
    from exoid.report.load_result import load_result
    from exoid.report.plot_diagnosis import plot_diagnosis
    from exoid.report.plot_drops import plot_drops
    from exoid.report.plots import plot_fit
    from exoid.report.save_result import save_result
    from exoid.report.saved_result import SavedResult

    __version__: str

_HOMES = {
    "Diagnosis": ("exoid.diagnose.diagnosis", "Diagnosis"),
    "diagnose_leg": ("exoid.diagnose.missing_physics", "diagnose"),
    "Moment": ("exoid.physics.moment", "Moment"),
    "parameter": ("exoid.physics.parameter", "parameter"),
    "PhysicsTerm": ("exoid.physics.term", "PhysicsTerm"),
    "SensorTerm": ("exoid.physics.term", "SensorTerm"),
    "reading": ("exoid.physics.term", "reading"),
    "plot_diagnosis": ("exoid.report.plot_diagnosis", "plot_diagnosis"),
    "Identifiability": ("exoid.diagnose.identifiability", "Identifiability"),
    "identify": ("exoid.diagnose.identifiability", "identify"),
    "Plan": ("exoid.diagnose.plan", "Plan"),
    "plan": ("exoid.diagnose.plan", "plan"),
    "fit_each": ("exoid.fit.each", "fit_each"),
    "fit_leg": ("exoid.fit.estimate", "fit"),
    "FitResult": ("exoid.fit.result", "FitResult"),
    "Posterior": ("exoid.fit.posterior", "Posterior"),
    "sample": ("exoid.fit.posterior", "sample"),
    "Profile": ("exoid.fit.profile", "Profile"),
    "profiles": ("exoid.fit.profile", "profiles"),
    "keep_programs_in": ("exoid.fit.program", "keep_programs_in"),
    "expected_leg": ("exoid.physics.anatomy", "expected_leg"),
    "LegModel": ("exoid.physics.leg", "LegModel"),
    "LegParameters": ("exoid.physics.leg", "LegParameters"),
    "Trajectory": ("exoid.physics.simulate", "Trajectory"),
    "simulate": ("exoid.physics.simulate", "simulate"),
    "LegState": ("exoid.physics.state", "LegState"),
    "CycleTorque": ("exoid.physics.torque", "CycleTorque"),
    "MeasuredTorque": ("exoid.physics.torque", "MeasuredTorque"),
    "NoTorque": ("exoid.physics.torque", "NoTorque"),
    "load": ("exoid.recording.load", "load"),
    "Protocol": ("exoid.recording.recording", "Protocol"),
    "Recording": ("exoid.recording.recording", "Recording"),
    "Segment": ("exoid.recording.recording", "Segment"),
    "Sensors": ("exoid.recording.recording", "Sensors"),
    "Subject": ("exoid.recording.recording", "Subject"),
    "write_table": ("exoid.recording.table", "write_table"),
    "plot_fit": ("exoid.report.plots", "plot_fit"),
    "PendulumTest": ("exoid.recording.pendulum.drops", "PendulumTest"),
    "measure_drops": ("exoid.recording.pendulum.drops", "measure_drops"),
    "plot_drops": ("exoid.report.plot_drops", "plot_drops"),
    "SavedResult": ("exoid.report.saved_result", "SavedResult"),
    "save_result": ("exoid.report.save_result", "save_result"),
    "load_result": ("exoid.report.load_result", "load_result"),
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
    if name == "recording":  # a folder that can be called
        return import_module("exoid.recording")
    if name not in _HOMES:
        raise AttributeError(f"module 'exoid' has no attribute {name!r}")
    module, attribute = _HOMES[name]
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted([*__all__, "__doc__", "__name__", "__version__"])
