"""What reading drops costs: as much for each sample of a long recording as of a short one."""

import gc
import subprocess
import sys
import time
import weakref
from dataclasses import dataclass

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.conventions import balance
from exoid.recordings.conventions.apply import understand
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.landmarks import local_polynomial
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion import find_free
from exoid.recordings.recording import Recording
from exoid.recordings.remembered import remembered
from exoid.recordings.splitting.split import cut_table
from swings import NOISE, Oscillator, drop

RATE = 100.0  # Hz


def lying(samples, seed=0):
    """One drop, and rest until so many samples are full."""
    return drop(lasting=samples / RATE - 1.0, noise=NOISE, seed=seed)


def session(samples, seed=0):
    """Drop after drop: 2 s held, 10 s free, 2 s on the way up, all at 100 Hz."""
    generator = np.random.default_rng(seed)
    since = np.arange(0, 10, 1 / RATE)
    parts = []
    for _ in range(samples // 1400):
        leg = Oscillator(frequency=generator.uniform(5.5, 6.5), amplitude=generator.uniform(0.9, 1))
        fall = leg.angle(since)
        lift = fall[-1] + (fall[0] - fall[-1]) * np.sin(np.linspace(0, np.pi / 2, 200)) ** 2
        parts += [np.full(200, fall[0]), fall, lift]
    angle = np.concatenate(parts)
    angle = angle + NOISE * generator.normal(size=angle.size)
    segment = Segment(np.arange(angle.size) / RATE, raw_angle=angle)
    return Recording((segment,), Subject(kind="leg"), Protocol(kind="passive"))


def counted(monkeypatch, module, name, size=lambda *_: 1):
    """How often a function is called from now on, or of what size altogether."""
    calls, real = [], getattr(module, name)
    monkeypatch.setattr(module, name, lambda *told: (calls.append(size(*told)), real(*told))[1])
    return calls


def test_a_leg_that_lies_at_rest_for_longer_is_followed_by_no_more_polynomials(monkeypatch):
    fitted = []
    for samples in (10_000, 100_000):
        centres = counted(
            monkeypatch, local_polynomial, "through", lambda _, centre, *__: len(centre)
        )
        measure_drops(lying(samples))
        fitted.append(sum(centres))
        monkeypatch.undo()
    assert fitted[0] == pytest.approx(fitted[1], rel=0.05)  # the noise is another, and its peaks


def test_the_release_of_a_drop_is_looked_for_once(monkeypatch):
    looked = counted(monkeypatch, find_free, "let_go")
    measured = measure_drops(lying(1_500))
    (one,) = measured.drops
    assert one.reason is None
    assert len(looked) == 1


def test_where_a_leg_swings_is_worked_out_once_for_each_of_a_hundred_drops(monkeypatch):
    asked = counted(monkeypatch, balance, "weak_form")
    found, _ = understand(session(140_000), cut_table)
    assert len(found.segments) == 100
    assert len(asked) == 100


@pytest.mark.slow
@pytest.mark.parametrize("recorded", [lying, session])
def test_ten_times_the_samples_cost_ten_times_the_processor(recorded):
    """A quadratic part that is a tenth of the cost of 10^4 samples would make it 19 times as much;
    a machine that is busy with others makes it half as much again.
    """
    spent = []
    found, _ = understand(recorded(14_000), cut_table)
    measure_drops(found)  # what is only done once
    for samples in (14_000, 140_000):
        each = []
        for seed in (1, 2):
            recording = recorded(samples, seed=seed)
            began = time.process_time()
            found, _ = understand(recording, cut_table)
            measure_drops(found)
            each.append(time.process_time() - began)
        spent.append(min(each))
    assert spent[1] < 1.7 * 10 * spent[0]


def test_an_answer_is_worked_out_once_and_goes_with_what_it_is_about():
    @dataclass(frozen=True, eq=False)
    class Thing:
        size: int

    asked = []

    @remembered
    def double(thing, by=2):
        asked.append(by)
        return np.full(1, by * thing.size)

    thing = Thing(3)
    assert [double(thing)[0], double(thing)[0], double(thing, 4)[0]] == [6, 6, 12]
    assert asked == [2, 4]
    answer = weakref.ref(double(thing))
    del thing
    gc.collect()
    assert answer() is None


def test_answers_about_each_other_go_with_what_they_are_about():
    @dataclass(frozen=True, eq=False)
    class Thing:
        pass

    @remembered
    def other(thing):
        return Thing()

    @remembered
    def between(thing, first):
        return (thing, first)

    thing = Thing()
    between(other(thing), thing)
    gone = weakref.ref(other(thing))
    del thing
    gc.collect()
    assert gone() is None


def test_drops_are_read_without_what_only_a_fit_needs():
    code = (
        "import sys, exoid.cli.commands.drops, exoid.pendulum.drops, exoid.report.tables.drops\n"
        "import exoid.report.document.drops_json\n"
        "sys.exit(len({'jax', 'equinox', 'scipy'} & sys.modules.keys()))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
