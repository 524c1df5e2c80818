"""What was asked of a fit, as it is understood, and what it says beside its numbers."""

from collections.abc import Sequence
from dataclasses import replace

from exoid.fitting.data.movement import Movement
from exoid.fitting.result.fit_result import FitResult
from exoid.physics.library import check_terms, library, term_named
from exoid.physics.term import Term, name_of
from exoid.recordings.recording import Recording

PLAIN_SCALE = 1e3  # 1/rad: the solver's tolerances are in units of noise, here 1 mrad
READINGS = ("1/T", "2/T")  # of Eq. 4

Asked = Sequence[type[Term] | Term | str]


def by_name(terms: Asked) -> tuple[type[Term] | Term, ...]:
    """The same, those of the library that are named as their classes.

    **Raises** `ValueError` where one is no term.
    """
    if not isinstance(terms, tuple | list):
        raise ValueError('terms are several: terms=("coulomb_friction",), with the comma.')
    found = tuple(term_named(each) if isinstance(each, str) else each for each in terms)
    for each in found:
        if not issubclass(each if isinstance(each, type) else type(each), Term):
            raise ValueError(
                f"terms has {each!r}, which is no term: give names such as 'coulomb_friction', "
                "classes such as CoulombFriction, or such with values; "
                "exoid.physics.library.library() has them all."
            )
    return found


def classes_of(terms: Asked) -> tuple[type[Term], ...]:
    """The classes of terms.

    **Raises** `ValueError` where one is there twice, or is no term that a search could begin with.
    """
    classes = tuple(each if isinstance(each, type) else type(each) for each in by_name(terms))
    twice = [name_of(each) for each in classes if classes.count(each) > 1]
    if twice:
        raise ValueError(f"the term {twice[0]} is given twice: once is enough.")
    check_terms(tuple(each for each in classes if each not in library()))
    return classes


def with_aside(result: FitResult, aside: list[str]) -> FitResult:
    """With what was left out of the recordings, behind why a fit that is astray is."""
    first = [] if result.follows else result.notes[:1]
    return replace(result, set_aside=aside, notes=[*first, *aside, *result.notes[len(first) :]])


def plainly(each: Movement) -> Movement:
    """Weigh every angle alike and leave the velocity out, as Eq. 11 does."""
    return replace(each, divisor=1 / PLAIN_SCALE, angular_velocity=None, gyro_noise=None)


def readings(named: list[tuple[str, Recording]], movements: list[Movement]) -> tuple[str, ...]:
    """The readings of Eq. 4 to try: as the sidecar says, else both; one where no cycle is."""
    said = {recording.protocol.torque_frequency for _, recording in named} - {None}
    if not any(each.voluntary for each in movements):
        return READINGS[:1]
    return tuple(sorted(said)) if said else READINGS  # type: ignore[arg-type]
