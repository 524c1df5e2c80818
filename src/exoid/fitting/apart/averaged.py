"""The mean of what segments tell by themselves, with the errors that they have in common."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from exoid.fitting.result.estimates.estimate import Estimate


def averaged(each: Sequence[Estimate], owner: Sequence[int]) -> Estimate:
    """The mean of the values, with the standard error that their scatter gives it, and that of what
    is the same in all segments of a session: an encoder's zero, a seat's tilt, a clock, which no
    scatter shows. `owner` is the number of the session of each.
    """
    values = np.array([one.value for one in each], dtype=float)
    if values.size < 2:
        return replace(each[0], standard_error=None, shares=None, limited_by=None)
    scatter = float(values.std(ddof=1) / np.sqrt(values.size))
    common = {name: size for name, size in of_sessions(each, owner).items() if size}
    error = float(np.hypot.reduce([scatter, *common.values()]))
    part = {name: (size / error) ** 2 for name, size in common.items()}
    mean = replace(each[0], value=float(values.mean()), standard_error=error, shares=None)
    return replace(mean, limited_by=part, if_slack=mean_slack(each))


def mean_slack(each: Sequence[Estimate]) -> float | None:
    """What a spring slack elsewhere leaves open of the mean: it is one spring, and all segments are
    off to the same side.
    """
    return float(np.mean([one.if_slack or 0.0 for one in each])) or None


def of_sessions(each: Sequence[Estimate], owner: Sequence[int]) -> dict[str, float]:
    """What every systematic makes of the mean's error: in one session it pulls all segments
    alike, in another one its own way.
    """
    names = {name for one in each for name in one.limited_by or {}}
    made = {}
    for name in sorted(names):
        of_segment = np.array([error_by(one, name) for one in each])
        made[name] = float(np.sqrt(np.sum(np.bincount(owner, of_segment) ** 2)) / len(each))
    return made


def error_by(one: Estimate, name: str) -> float:
    """What a systematic makes of an error. Two that go together are each a part: all are no more
    than the whole.
    """
    shares = one.limited_by or {}
    share = shares.get(name, 0.0) / max(sum(shares.values()), 1.0)
    return (one.standard_error or 0.0) * float(np.sqrt(share))
