"""That gravity comes out upwards, as no leg falls, in sentences."""

from exoid.fitting.data.movement import all_driven
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem

UPWARDS = (
    "gravity comes out upwards (m l g / J is negative): no leg falls like this. The angle must be "
    "0 with the knee extended and the shank level, -90 deg hanging, extension positive. Is flexion "
    'positive in this file? Then say flip="angle" (flip="all" with a gyro of the same sign). Is 0 '
    'the hanging leg? Then say zero="hanging".'
)
NO_RIG = (
    "gravity would pull upwards: of this rig a spring and gravity are not told apart. Where no "
    'spring is, say [subject] spring = "none"'
)


def upwards(problem: Problem, ended: SearchResult) -> bool:
    """Does gravity come out upwards, of a leg that nothing but gravity moved?"""
    return (
        float(ended.best.coordinates.shared.gravity[0]) < 0
        and not problem.belief.rig
        and all(each.kind == "passive" for each in problem.movements)
    )


def upside_down(problem: Problem, ended: SearchResult) -> bool:
    """Does gravity come out upwards, of a rig that was not driven all the time?"""
    gravity = float(ended.best.coordinates.shared.gravity[0])
    return problem.belief.rig and not all_driven(problem.movements) and gravity < 0


def of_impossible(problem: Problem, ended: SearchResult) -> list[str]:
    """That no rig falls like this."""
    return [f"m l g / J and c / J: {NO_RIG}."] if upside_down(problem, ended) else []
