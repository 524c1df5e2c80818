"""`fit` as it is told outside: no number where the recording refuses its model."""

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec

from exoid.fitting import estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.refused.without_numbers import without_numbers

Asked = ParamSpec("Asked")


def told(fitted: Callable[Asked, FitResult]) -> Callable[Asked, FitResult]:
    """The same, where the result does not follow without its numbers, each with the reason."""

    @wraps(fitted)
    def found(*args: Asked.args, **options: Asked.kwargs) -> FitResult:
        return without_numbers(fitted(*args, **options))

    return found


fit = told(estimate.fit)
