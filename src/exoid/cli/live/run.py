"""`exoid live` from its beginning to its end: of a bus, or of a file."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from pathlib import Path

from exoid.cli.live.ending import conclude
from exoid.cli.live.follow import Bus, follow_file
from exoid.cli.live.opened import Opened
from exoid.cli.live.result import give
from exoid.cli.live.viewing import Views, viewing
from exoid.cli.terminal.keys import keyboard
from exoid.cli.terminal.stopping import stoppable
from exoid.recordings.recording import Subject
from exoid.watching.beside.goals import Goal
from exoid.watching.board import Board
from exoid.watching.estimate.load import constant_load
from exoid.watching.origin import Origin


@dataclass(frozen=True)
class Wanted:
    """What is to be estimated, when that is enough, and where it is shown."""

    terms: tuple[type, ...]
    goals: Sequence[Goal]
    views: Views
    refine: bool | None

    def origin(self, subject: Subject, **placed) -> Origin:
        return Origin(subject, terms=self.terms, goals=self.goals, **placed)


def run_bus(bus: Bus, wanted: Wanted, *, marked: bool, duration: float | None) -> None:
    """Follow a node until somebody stops it, it has lasted, or the goals are reached."""
    board = Board(wanted.goals)
    origin = wanted.origin(bus.subject, load=constant_load(bus.subject))
    with (
        stoppable() as stopped,
        viewing(board, str(bus.address), wanted.views) as viewer,
        keyboard(marked) as pressed,
    ):
        session = bus.follow(
            origin,
            viewer,
            stopped,
            pressed=pressed if marked else None,
            duration=duration,
            refined=wanted.refine is not False,
        )
    conclude(session, err=wanted.views.err)
    give(board, err=wanted.views.err)


def run_file(name: Path, opened: Opened, wanted: Wanted, speed: float) -> None:
    """Follow a recording until its end, or until the goals are reached."""
    board = Board(wanted.goals)
    placed = {"load": opened.load, "thigh_angle": opened.thigh_angle}
    refined = speed != inf if wanted.refine is None else wanted.refine
    with stoppable() as stopped, viewing(board, name.name, wanted.views) as viewer:
        origin = wanted.origin(opened.subject, **placed)
        follow_file(opened, origin, viewer, stopped, speed=speed, refined=refined)
    give(board, err=wanted.views.err)
