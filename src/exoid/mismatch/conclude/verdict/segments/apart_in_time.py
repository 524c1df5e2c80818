"""That encoder and gyro lie apart by another time in each segment, or in swings of another size: no
model here has that.
"""

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found
from exoid.mismatch.sensors.agreement import OwnValue
from exoid.physics.sensing.butterworth_filter import ButterworthFilter
from exoid.physics.sensing.first_order_filter import FirstOrderFilter
from exoid.physics.sensing.sensor_skew import SensorSkew

LATE = (SensorSkew, FirstOrderFilter, ButterworthFilter)  # causes by which a sensor is late
ONE_CLOCK = (
    "Record encoder and gyro by one clock, or move the gyro of each segment by the delay that "
    "stands under Sensors."
)
THIGH_HELD = "The same drops with the thigh strapped down, or with a gyro on the thigh, too."


def apart_in_time(found: Found, best: Optimum) -> tuple[list[str], list[str]]:
    """Why nothing can be claimed where delays differ and more than noise remains, in sentences, and
    what to record. Swings of another size are asked where a delay is the answer.
    """
    errors = found.prepared.sensors.errors
    delays = [one for each in errors for one in each.own]
    by_size = [one for each in errors for one in each.by_size]
    if found.yardstick.explains(best.square):
        return [], []
    if by_size and not delays and any(term in LATE for term in best.candidate.terms):
        return [of_sizes(*by_size)], [THIGH_HELD]
    return ([of_delays(delays)], [ONE_CLOCK]) if delays else ([], [])


def of_sizes(larger: float, smaller: float) -> str:
    """How late the gyro seems by the size of the swing [s], and what that may be."""
    return (
        f"the gyro seems {1e3 * larger:.2g} ms late in the larger swings, {1e3 * smaller:.2g} ms "
        "in the smaller ones (below 0: early), as no delay is: as where the thigh rocks or sinks "
        "under an encoder that shows the knee, or where play or soft tissue is between a sensor "
        "and the leg. What else is missing cannot be told beside that"
    )


def of_delays(delays: list[OwnValue]) -> str:
    least, most = (1e3 * one(each.value for each in delays) for one in (min, max))
    return (
        "encoder and gyro lie apart by another time in each segment, the gyro late by "
        f"{least:.2g} to {most:.2g} ms, and every model here has one delay: what else is missing "
        "cannot be told beside that"
    )
