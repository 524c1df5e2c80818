"""A cause whose first step fails is as large as it is before it takes its shape."""

import numpy as np

from exoid.fitting.estimate import fit
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.optimise import given, settle
from exoid.mismatch.search.search import ROUNDS, beginning
from exoid.physics.terms.muscle.stretch_reflex import StretchReflex
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from hands import Knee
from reflexes import stretched

KNEE = Knee(25.2, 5.0, 0.8)
STARTS = np.radians([-9.8, -36.4, -13.2, -19.2])
NOISE = np.radians(0.025)


def test_a_strong_reflex_is_found_along_the_motion_of_its_leg():
    draw, drops = np.random.default_rng(2), []
    for start in STARTS:
        angle = stretched(KNEE, start, 8.0, 2.2, 0.09)[::10]
        seen = angle + draw.normal(0, NOISE, angle.size)
        rate = np.gradient(angle, 0.01) + draw.normal(0, 0.003, angle.size)
        time = 0.01 * np.arange(angle.size)
        drops.append(Segment(time, raw_angle=seen, raw_angular_velocity=rate))
    body = Subject(kind="leg", body_mass=70.0, height=1.75)
    recordings = [("drops", Recording(tuple(drops), body, Protocol(kind="passive")))]
    prepared, base = prepare(fit(recordings, multistart=8, at_once=True), recordings)
    begin = beginning(prepared, base)
    known = given(prepared, begin)
    starts = [begin.with_term(StretchReflex, v, known) for v in prepared.starts(StretchReflex)]
    best = min(settle(prepared, starts, rounds=ROUNDS), key=lambda one: one.square)
    assert best.square < base.square / 20
