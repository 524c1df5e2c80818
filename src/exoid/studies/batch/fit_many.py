"""Many recordings fitted side by side, each as `fit` has it."""

from collections.abc import Sequence
from functools import partial
from typing import Any

from exoid.fitting.estimate import fit
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.answer import LANES, answer
from exoid.fitting.solve.cores.side_by_side import MOST, side_by_side
from exoid.fitting.solve.meeting import meet
from exoid.recordings.loading.named import RecordingsLike

FEW = 4  # starts: from anatomy, from inverse dynamics, and two drawn ones
STARTS = 64  # of `fit`


def fit_many(each: Sequence[RecordingsLike], **options: Any) -> list[FitResult | Exception]:
    """`fit` of each of them with these options, or the exception that it raises.

    They share the runs of compiled programs: those of alike shapes, which have as many segments of
    about as many samples, in lanes of one. A few starts decide where all of these end in the same
    minimum; where they do not, all starts go. Where there are several cores, some compute while a
    program runs for others. Memory grows with what is given at once: hundreds of recordings of
    seconds, tens of minutes.
    """
    tasks = [partial(frugal_fit, one, options) for one in each]
    count = max(1, min(MOST, len(tasks) // LANES))  # of meetings, none of which leaves lanes empty
    found = side_by_side(partial(meet, answer=answer), [tasks[at::count] for at in range(count)])
    return [found[at % count][at // count] for at in range(len(tasks))]


def frugal_fit(recordings: RecordingsLike, options: dict[str, Any]) -> FitResult:
    """`fit`, from few starts where these agree."""
    wanted = options.get("multistart", STARTS)
    if wanted <= FEW or options.get("starts") is not None or options.get("method") == "slsqp":
        return fit(recordings, **options)
    few: dict[str, Any] = {**options, "multistart": FEW}
    try:
        found = fit(recordings, **few)
    except (ValueError, ArithmeticError):  # as all starts have it, whose words it then is
        return fit(recordings, **options)
    agree = found.multistart.at_best == FEW and found.follows
    return found if agree else fit(recordings, **options)
