"""What a result of a fit rests on."""

from dataclasses import dataclass

from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem


@dataclass(frozen=True, eq=False)
class Basis:
    """What a result rests on, for those who ask further: profiles, posterior, plans."""

    problem: Problem
    ended: SearchResult
    information: Information
