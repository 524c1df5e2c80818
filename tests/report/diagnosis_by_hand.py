"""Diagnoses of which nothing was computed: every field that may be there is, or may be missing."""

from dataclasses import replace

import numpy as np
from test_fit_json import fitted

from exoid.mismatch.answer.diagnosis import (
    Booked,
    Diagnosis,
    Finding,
    NovelTorque,
    Parameter,
    Tested,
)
from exoid.mismatch.evidence.location import Location, Missing, Region
from exoid.mismatch.evidence.prediction import Prediction, Proof
from exoid.mismatch.sensors.agreement import SensorError

ODD = 0.1 + 0.2
TIME = np.linspace(0.0, 2.0, 201)
FRICTION = Finding("coulomb_friction", "dry friction", "Straps rub, ä.", "a book, p. 1")


def missing(name: str, modelled: bool) -> Missing:
    torque = 0.1 * np.sign(np.cos(5 * TIME)) + ODD * np.cos(90 * TIME) / 100
    return Missing(
        name,
        TIME,
        np.sin(5 * TIME),
        5 * np.cos(5 * TIME),
        torque,
        0.01,
        0.1 * np.sign(np.cos(5 * TIME)) if modelled else None,
        10,
    )


def prediction(error: float) -> Prediction:
    """Of two segments, the second shorter."""
    counted = np.ones((2, TIME.size), dtype=bool)
    counted[1, 150:] = False
    angle = np.stack([np.sin(5 * TIME), np.sin(5 * TIME)]) + error
    return Prediction(angle, counted, np.array([error, error * ODD]), np.array([error, ODD]) / 1e-6)


def found() -> Diagnosis:
    """Dry friction, clearly, or drag."""
    before, after = prediction(0.02), prediction(0.001)
    data = (np.stack([TIME, TIME]), np.stack([np.sin(5 * TIME)] * 2))
    region = Region("leg 0", 0.1, ODD, "-10 to 5 deg, extending", "0.1 N m are missing", 0.1)
    return Diagnosis(
        verdict="mismatch",
        reasons=[],
        findings=[FRICTION],
        ranking=["coulomb_friction", "quadratic_drag"],
        equivalent=["coulomb_friction", "quadratic_drag + gyro_scale"],
        novel=False,
        formula=None,
        parameters=[
            Parameter("coulomb_friction.level", 0.1, "N m", 0.002),
            Parameter("coulomb_friction.other", ODD, "1", None),
        ],
        inertia=0.45,
        booked=[Booked("damping", 0.5, 0.3, "N m s/rad")],
        location=Location([missing("leg 0", True), missing("leg 1", True)], [region], 0.1, 0.8),
        proof=Proof(before, after, *data, 0.0008, False),
        baseline=Tested([], 40.5, 0.0),
        best=Tested(["coulomb_friction"], ODD + 1, 5e3, True),
        singles=[
            Tested(["coulomb_friction"], ODD + 1, 5e3, True),
            Tested(["quadratic_drag"], 9.0, 1e3),
        ],
        pairs=[Tested(["quadratic_drag", "gyro_scale"], ODD + 1, 4.99e3)],
        pinned=[Tested(["coulomb_friction"], 2.0, None), Tested(["gyro_scale"], 40.0, None)],
        excluded=["broken"],
        false_alarm_rate=5e-324,
        power=1.0,
        inclusion=0.95,
        sensors=[SensorError("gyro_scale", ODD, 0.001, "1")],
        before=fitted(),
        weight=0.992,
        advice=["To tell dry friction apart: move slowly."],
    )


def nothing() -> Diagnosis:
    """Nothing is missing, and hardly anything was there to look at."""
    one = found()
    alone = prediction(0.001)
    return replace(
        one,
        verdict="none",
        findings=[],
        equivalent=[],
        parameters=[],
        booked=[],
        location=Location([missing("leg 0", False)], [], ODD, 0.0),
        proof=replace(one.proof, before=alone, after=alone, in_time=True),
        best=one.baseline,
        singles=[],
        pairs=[],
        excluded=[],
        inclusion=None,
        sensors=[],
        advice=[],
    )


def novel() -> Diagnosis:
    """A torque that has no name."""
    torque = NovelTorque("tau = 0.2 sin(8 x) N m", 0.97, ODD)
    best = Tested(["formula"], 1.1, 6e3, True)
    return replace(found(), findings=[], novel=True, formula=torque, best=best, inclusion=None)


def doubtful() -> Diagnosis:
    """Too little to tell."""
    return replace(found(), verdict="cannot_tell", findings=[], reasons=["1.0 s are too short"])
