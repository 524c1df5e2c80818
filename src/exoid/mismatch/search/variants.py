"""What a search tries beside single terms: the same running free, twins, simpler forms."""

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import FLOOR, enough, polished, settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import blurred, lost_at, size
from exoid.mismatch.search.rank import simpler_form
from exoid.physics.parameter import declarations
from exoid.physics.term import SensorTerm, Term, holds, name_of

BESIDE = 2  # of the best single terms are tried beside what the sensors surely say
SEEN = 0.1  # of its period, over which what repeats shows itself


def applies(prepared: PreparedRecording, term: type[Term]) -> bool:
    """Can it act here, and show itself: a voluntary torque, a gyro, what errs once a turn? Over a
    small part of its period that is a bend like any other, and grows without limit.
    """
    if term.living and prepared.rig:
        return False
    if term.voluntary:
        return any(each.voluntary for each in prepared.problem.movements)
    if term.replaces in prepared.zeros or term in prepared.common:
        return False
    if np.ptp(prepared.range) < SEEN * term.period:
        return False
    if term.everyday:
        return prepared.has_gyro
    return True


def reduced(prepared: PreparedRecording, joint: list[Optimum]) -> list[Optimum]:
    """Each term of a pair alone again, from where the pair is: is the other one needed?"""
    first = len(prepared.common)
    return [
        polished(prepared, with_common(prepared, one.candidate).with_term(term, value), one.square)
        for one in joint
        for term, value in list(zip(one.candidate.terms, one.candidate.values, strict=True))[first:]
    ]


def with_common(prepared: PreparedRecording, candidate: Hypothesis) -> Hypothesis:
    """The candidate with none of its terms but the sure errors of sensors."""
    count = len(prepared.common)
    terms, values = candidate.terms[:count], candidate.values[:count]
    return replace(candidate, terms=terms, values=values, linear=None)


def twins(prepared: PreparedRecording, some: list[Optimum], known: list[Optimum]) -> list[Optimum]:
    """What is exactly the same torque under another name: a rest angle, and a constant torque."""
    named = {name_of(term): term for term in prepared.library}
    done = {frozenset(one.candidate.terms) for one in known}
    found = []
    for one in some:
        for mine in (term for term in one.candidate.terms if term.same_torque in named):
            twin = named[mine.same_torque]
            wanted = [twin if term is mine else term for term in one.candidate.terms]
            if frozenset(wanted) not in done:
                start = renamed(prepared, one.candidate, mine, twin)
                found.append(settle_free(prepared, start))
    return found


def renamed(
    prepared: PreparedRecording, candidate: Hypothesis, mine: type[Term], twin: type[Term]
) -> Hypothesis:
    """The candidate with the twin of one of its terms, as large."""
    declared = next(each for _, each in declarations(twin))
    moved = [
        (
            twin,
            np.clip(prepared.as_its_twin(candidate, mine, value), declared.lower, declared.upper),
        )
        if term is mine
        else (term, value)
        for term, value in zip(candidate.terms, candidate.values, strict=True)
    ]
    terms, values = zip(*moved, strict=True)
    return replace(candidate, terms=terms, values=values, linear=None)


def suspected_sensors(
    prepared: PreparedRecording, base: Optimum, singles: list[Optimum]
) -> list[Optimum]:
    """Everything at once that the sensors seem to say of each other, where it is not sure enough to
    be in every candidate: alone, and while noise is not reached with each of the best single terms.
    """
    known = {name_of(term): term for term in prepared.library}
    told = [each for each in prepared.sensors.errors if each.clear and each.name in known]
    told = [each for each in told if known[each.name].replaces not in prepared.zeros]
    if not told or prepared.common:
        return []
    terms = tuple(known[each.name] for each in told)
    values = tuple(np.array([each.value]) for each in told)
    reached = any(enough(prepared, one.square) for one in singles)
    first = [] if reached else singles[:BESIDE]
    best = [one.candidate for one in first if one.candidate.terms[0] not in terms]
    starts = [
        replace(one, terms=(*terms, *one.terms), values=(*values, *one.values), linear=None)
        for one in (base.candidate, *best)
    ]
    return side_by_side(partial(settle_free, prepared), starts)


def unwatched(prepared: PreparedRecording, others: list[Optimum], base: Optimum) -> list[Optimum]:
    """What an encoder may do wrong where no gyro watches it: it bends a motion as springs do, and
    must not be missed for them.
    """
    if prepared.has_gyro or base.square < FLOOR * prepared.samples:
        return []
    sensors = [one for one in others if issubclass(one.candidate.terms[-1], SensorTerm)]
    return [one for one in sensors if one.square < base.square]


def nested(
    prepared: PreparedRecording, some: list[Optimum], simpler: list[type[Term]]
) -> list[Optimum]:
    """A simple term again in the place of a richer one that holds all its parameters."""
    starts = []
    for one in some:
        terms, values = one.candidate.terms, one.candidate.values
        for place, rich in enumerate(terms):
            known = dict(zip(dict(declarations(rich)), values[place], strict=True))
            for simple in simpler:
                wanted = list(dict(declarations(simple)))
                if simpler_form(simple, rich) and simple not in terms:
                    start = replace(
                        one.candidate,
                        terms=put(terms, place, simple),
                        values=put(values, place, np.array([known[name] for name in wanted])),
                        linear=None,
                    )
                    starts.append(start)
    return side_by_side(partial(settle_free, prepared), starts)


def in_simplest_form(
    prepared: PreparedRecording, one: Optimum, usable: list[type[Term]]
) -> Optimum:
    """The same with simple terms in the place of richer ones, where what these have more explains
    no more than noise may: dry friction that falls with speed by nothing is Coulomb's. What may not
    be what it is called has none: drag that may grow as speed does is not quadratic.
    """
    extra = extras(one, usable)
    if not extra:
        return one
    measure = yardstick(prepared, one)
    unsure = blurred(prepared, one, measure.scale)
    untold = [
        simple
        for simple, plain in extra.items()
        if not any(simpler_form(simple, rich) for rich in unsure)
        and not measure.clear(lost_at(prepared, one, plain), 0.0, len(plain))
    ]
    simpler = [
        each
        for each in nested(prepared, [one], untold)
        if each.sound and not measure.clear(each.square, one.square, size(one) - size(each))
    ]
    if not simpler:
        return one
    return in_simplest_form(prepared, min(simpler, key=lambda each: each.square), usable)


def extras(one: Optimum, usable: list[type[Term]]) -> dict[type[Term], dict[int, float]]:
    """Of the simpler forms of its terms, which of its unknowns each has not, and where these make
    it that form, if they may be there: where an excess is none, the speed at which it fades is of
    no matter. What sticks has no form that does not.
    """
    found, first = {}, one.candidate.point.size + one.candidate.zero.size
    for rich, value in zip(one.candidate.terms, one.candidate.values, strict=True):
        for simple in (each for each in usable if each not in one.candidate.terms):
            known = dict(declarations(simple))
            more = {
                first + at: declared.plain
                for at, (name, declared) in enumerate(declarations(rich))
                if name not in known and declared.lower <= declared.plain <= declared.upper
            }
            if more and simpler_form(simple, rich) and holds(simple) is holds(rich):
                found[simple] = more
        first += value.size
    return found


def put(each: tuple, place: int, other: Any) -> tuple:
    """The same with another one in a place."""
    return (*each[:place], other, *each[place + 1 :])
