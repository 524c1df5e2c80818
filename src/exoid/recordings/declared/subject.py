"""Whose leg was measured, or which rig."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from exoid.recordings.declared.entry import check_words, extra, ranged, text

SIDES = ("left", "right")
ABSENT = ("none",)  # what a rig can be said to have of gravity or of a spring


@dataclass(frozen=True)
class Subject:
    """Whose leg, or which rig. None means unknown, never a default.

    **Raises** `ValueError` for a word that a field cannot be, as do `Protocol` and `Sensors`.

    >>> exoid.Subject(kind="leg", body_mass=77.0, height=1.8).age is None  # unknown
    True
    """

    kind: Literal["leg", "rig"] | None = text("kind", ("leg", "rig"))
    id: str | None = text("id")
    side: str | None = text("side", SIDES)
    session: str | None = text("session")
    body_mass: float | None = ranged("body_mass_kg", "kg", 2.0, 400.0)
    height: float | None = ranged("height_m", "m", 0.4, 2.6)
    age: float | None = ranged("age_years", "years", 0.0, 130.0)
    shank_length: float | None = ranged("shank_length_m", "m", 0.05, 0.8)
    shank_foot_mass: float | None = ranged("shank_foot_mass_kg", "kg", 0.05, 40.0)
    com_distance: float | None = ranged("com_distance_m", "m", 0.01, 0.8)
    added_mass: float | tuple[float, ...] | None = ranged("added_mass_kg", "kg", 0.0, 50.0)
    added_mass_distance: float | tuple[float, ...] | None = ranged(
        "added_mass_distance_m", "m", 0.0, 1.0
    )
    added_mass_uncertainty: float | None = ranged("added_mass_uncertainty_kg", "kg", 0.0, 10.0)
    added_mass_distance_uncertainty: float | None = ranged(
        "added_mass_distance_uncertainty_m", "m", 0.0, 0.5
    )
    added_mass_gyration: float | None = ranged("added_mass_gyration_m", "m", 0.0, 0.5)
    damping_under_load_uncertainty: float | None = ranged(
        "damping_under_load_uncertainty", "of 1", 0.0, 1.0
    )
    stiffness_under_load_uncertainty: float | None = ranged(
        "stiffness_under_load_uncertainty", "of 1", 0.0, 1.0
    )
    gravity: str | None = text("gravity", ABSENT)
    spring: str | None = text("spring", ABSENT)
    notes: str | None = text("notes")
    extra_keys: Mapping[str, Any] = extra()

    def __post_init__(self):
        check_words(self)
