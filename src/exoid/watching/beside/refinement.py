"""The batch fit of the drops so far, beside the stream: in a process of its own, newest first."""

import os
import signal
from concurrent.futures import Future
from dataclasses import dataclass, field, replace
from math import hypot
from typing import Any

import numpy as np

from exoid.fitting.solve.cores.second_process import SecondProcess
from exoid.online.model.model import Model
from exoid.recordings.declared.subject import Subject
from exoid.watching.estimate.known import RATIOS
from exoid.watching.estimate.left_out import LeftOut
from exoid.watching.estimate.leg import LegDrop

LEAST = np.radians(10.0)  # that a leg swings in a drop which a fit can use
FAR = 3.0  # standard errors of their difference, from which on two estimates disagree
MASS = ("added_mass", "added_mass_distance")
BACKGROUND = 10  # niceness: the stream comes first


@dataclass(frozen=True)
class Refined:
    """The ratios of the batch fit of so many drops, and whether the live ones agree."""

    drops: int
    ratios: dict[str, tuple[float, float]]  # value and standard error, by name
    apart: dict[str, float]  # standard errors between the two, by ratio
    agrees: bool
    if_slack: dict[str, float] = field(default_factory=dict)  # errors more, by name, of that fit


class Refinement:
    """Takes drops as they end; `latest` is what the last fit that is done has found.

    One thread adds, another one looks: what they share is replaced as a whole.
    """

    def __init__(self, subject: Subject, model: Model):
        self.subject, self.model = subject, model
        self.drops: list[LegDrop] = []
        self.process: SecondProcess | None = None
        self.running: tuple[Future, LegDrop, int] | None = None
        self.begun_with: list[LegDrop] = []  # of the last fit
        self.latest: Refined | None = None
        self.failed: str | None = None

    def add(self, drop: LegDrop) -> None:
        """One more drop of the same leg; the first one of another leg begins anew."""
        if (change := drop.moment.change) is not None:
            since = change.since
            others = (each for each in self.drops if each.mass != drop.mass or each.until > since)
            self.drops = list(others)
        if drop.number <= len(self.drops):
            self.drops = []
        if np.ptp(drop.segment.best_angle[np.isfinite(drop.segment.best_angle)]) >= LEAST:
            self.drops = [*self.drops, drop]

    def leave_out(self, left: LeftOut) -> None:
        """A drop that was added may not count after all."""
        self.drops = [each for each in self.drops if each.moment.begun != left.begun]

    def look(self) -> None:
        """Take what is done, and begin what waits."""
        if self.running is not None and self.running[0].done():
            self.finish(*self.running)
            self.running = None
        waits = self.drops and self.begun_with != self.drops
        if self.running is None and waits and self.failed is None:
            self.begin()

    def begin(self) -> None:
        from exoid.online.batch import refine

        if self.process is None:
            self.process = SecondProcess(prepare)
        self.begun_with = self.drops
        masses = [each.mass for each in self.drops]
        carried = {}
        if any(each.weight for each in masses):
            placed = all(each.placed for each in masses)
            carried["added_mass"] = tuple(each.weight for each in masses)
            carried["added_mass_distance"] = (
                tuple(each.distance for each in masses) if placed else None
            )
        subject = replace(self.subject, **dict.fromkeys(MASS) | carried)
        segments = [each.segment for each in self.drops]
        future = self.process.submit(refine, segments, subject, self.model)
        self.running = future, self.drops[-1], len(self.drops)

    def finish(self, future: Future, drop: LegDrop, count: int) -> None:
        """What the fit says beside what was known after its last drop."""
        try:
            found = future.result()
            if not found.follows:
                raise ValueError(f"it does not follow the drops: {found.astray}")
            self.latest = beside(drop, found, count)
        except Exception as fault:  # whatever a fit may raise, the stream goes on
            self.failed = " ".join(str(fault).split()) or type(fault).__name__

    @property
    def busy(self) -> bool:
        """Does a fit run that `look` has begun?"""
        return self.running is not None

    def close(self) -> None:
        """Whatever still runs ends with it."""
        if self.process is not None:
            self.process.close(at_once=self.busy)
            self.process = self.running = None


def beside(drop: LegDrop, found: Any, count: int) -> Refined:
    """Both saw the same samples: where both are right, they are closer than these errors say."""
    live = {each.name: each for each in drop.moment.ratios}
    ratios, apart = {}, {}
    for name in RATIOS:
        value, error = found.ratios[name].value, found.ratios[name].standard_error
        if value is None or error is None:
            raise ValueError(f"it tells no error of {name}")
        ratios[name] = value, error
        apart[name] = (live[name].value - value) / hypot(live[name].error, error)
    each = {**found.ratios, **found.parameters}
    slack = {name: one.if_slack for name, one in each.items() if one.if_slack is not None}
    return Refined(count, ratios, apart, max(map(abs, apart.values())) < FAR, slack)


def prepare() -> None:
    """In the other process: programs are kept, Ctrl-C is left to the one that started it, and the
    stream has a core of its own.
    """
    from exoid.fitting.solve.program_cache import keep_programs_in

    os.nice(BACKGROUND)
    leave_a_core()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    keep_programs_in()


def leave_a_core() -> None:
    """Where a process may choose its cores, all but one: a nice one on every core still makes the
    stream wait for milliseconds. XLA has no more threads than that.
    """
    if not hasattr(os, "sched_setaffinity"):
        return
    cores = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, cores[1:] or cores)
