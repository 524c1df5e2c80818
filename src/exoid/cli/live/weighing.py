"""The weight on the shank of a node's stream, as a key or the page says that it comes and goes."""

from dataclasses import replace
from math import inf

from exoid.cli.live.session import Session
from exoid.cli.live.watched import Watched
from exoid.recordings.declared.subject import Subject
from exoid.watching.board import Weight
from exoid.watching.estimate.switch import Switch

KEY = "w"
UNMARKED = "  Without --segment the sidecar does not say when: fill in added_mass_kg."


class Weighing:
    """Switches it for the estimator by the node's clock, and for the sidecar by that of the log."""

    def __init__(self, switch: Switch, session: Session, watched: Watched):
        self.switch, self.session, self.watched = switch, session, watched
        self.logged = Switch(switch.weight)
        session.keys[KEY] = self.turn
        session.added = self.subject
        watched.board.weight = Weight(self.words, lambda: switch.on, self.turn)

    @property
    def words(self) -> str:
        mass = self.switch.weight
        return f"{mass.weight:g} kg{f' at {mass.distance:g} m' if mass.placed else ''}"

    def turn(self) -> None:
        """It was put on, or taken off."""
        self.switch.turn(self.watched.heard)
        self.logged.turn(self.session.watch.seconds)
        unmarked = "" if self.session.marking else UNMARKED
        self.watched.tell(f"weight: {self.words} {'on' if self.switch.on else 'off'}.{unmarked}")

    def subject(self, begin: float) -> Subject:
        """With what was on the shank when a segment began; without marks nobody knows which."""
        subject = self.session.subject
        unsaid = begin == inf and len(self.logged.masses) > 1
        if not unsaid and self.logged.at(begin).weight:
            return subject
        none = None if unsaid else 0.0
        return replace(subject, added_mass=none, added_mass_distance=none)
