"""How often the intervals of fitted studies hold the truth, as lines of a table."""

from collections.abc import Iterator, Sequence

import numpy as np
from benchmarks.studies.tables import Truth

from exoid.studies.statistics.reliability import DETECTABLE

from .answered import Answered, Told
from .world import World

SURE = 0.05  # corrected p of a difference that is found
COUNTED = ("recordings", "failed", "missed", "partly")
WIDE = 52  # characters of a name


def summary(world: World, studies: Sequence[Answered]) -> list[str]:
    """Question by question, then kind by kind of recordings."""
    head = f"{len(studies)} studies of {world.design.people} people"
    lines = [f"{head:{WIDE}}   held   truth  found on average  more than exact fits"]
    for at, truth in enumerate(world.design.truths):
        pairs = [(each.told[at], each.exact[at]) for each in studies]
        lines += of_quantity(pairs, truth, world)
    return [*lines, "", *of_kinds(studies)]


def of_quantity(pairs: Sequence[tuple[Told, Told]], truth: Truth, world: World) -> Iterator[str]:
    """Of what studies say, each beside what they would say of exact fits."""
    for question, true in truths(truth, world):
        each, exact = (
            np.array([one.intervals[question] for one in told]) for told in zip(*pairs, strict=True)
        )
        held = int(np.sum((each[:, 1] <= true) & (true <= each[:, 2])))
        more = mean_of(each[:, 0] - exact[:, 0])
        name = f"{question} of {truth.quantity}"
        said = f"{name:{WIDE}} {held:3} of {len(each):3} {true:7.4f}"
        yield f"{said}  {mean_of(each[:, 0]):16}  {more}"
    found = sum(told.p < SURE for told, _ in pairs)
    there = "that is there" if truth.effect else "that is not there"
    yield f"{f'a difference {there} is found':{WIDE}} {found:3} of {len(pairs):3}"


def mean_of(each: np.ndarray) -> str:
    """With its standard error, where there are several."""
    error = f" ± {each.std(ddof=1) / each.size**0.5:.4f}" if each.size > 1 else ""
    return f"{each.mean():.4f}{error}"


def truths(truth: Truth, world: World) -> Iterator[tuple[str, float]]:
    """What fits without errors would tell: those of sound recordings are next to none."""
    design = world.design
    day = truth.error_of_occasion(design.drops) ** 2
    day += (world.unlike * truth.mean) ** 2 / design.drops
    lasting = truth.between**2 + truth.side**2 + truth.effect**2 / 4
    yield "difference of the groups", truth.effect
    yield "ICC(C,1)", lasting / (lasting + day)
    yield "ICC(A,1)", lasting / (lasting + day)  # no day shifts all people
    yield "minimal detectable change", DETECTABLE * day**0.5


def of_kinds(studies: Sequence[Answered]) -> Iterator[str]:
    """What became of recordings."""
    yield f"{'recordings':{WIDE}}  of them  failed  'misses something'  first swing left out"
    every = [each for study in studies for each in study.kinds]
    for name in sorted({each.name for each in every}):
        those = [each for each in every if each.name == name]
        counts = [sum(getattr(each, of) for each in those) for of in COUNTED]
        yield f"{name or 'sound':{WIDE}} " + "".join(
            f"{each:{wide}}" for each, wide in zip(counts, (8, 8, 20, 22), strict=True)
        )
        for fitted in zip(*(each.fitted for each in those), strict=True):
            valued, held = (sum(getattr(one, of) for one in fitted) for of in ("valued", "held"))
            if valued:
                off = sum(one.off for one in fitted) / valued
                rms = (sum(one.square for one in fitted) / valued) ** 0.5
                yield (
                    f"    {fitted[0].quantity}: {held} of {valued} in their intervals, off by "
                    f"{off:+.4f} on average, root mean square {rms:.4f}"
                )
