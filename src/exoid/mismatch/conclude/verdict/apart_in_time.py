"""That encoder and gyro lie apart by another time in each segment: no model here has that."""

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found
from exoid.mismatch.sensors.agreement import OwnValue

ONE_CLOCK = (
    "Record encoder and gyro by one clock, or move the gyro of each segment by the delay that "
    "stands under Sensors."
)


def apart_in_time(found: Found, best: Optimum) -> list[str]:
    """Why nothing can be claimed where delays differ and more than noise remains, in sentences."""
    delays = [one for each in found.prepared.sensors.errors for one in each.own]
    if not delays or found.yardstick.explains(best.square):
        return []
    return [of_delays(delays)]


def of_delays(delays: list[OwnValue]) -> str:
    least, most = (1e3 * one(each.value for each in delays) for one in (min, max))
    return (
        "encoder and gyro lie apart by another time in each segment, the gyro late by "
        f"{least:.2g} to {most:.2g} ms, and every model here has one delay: what else is missing "
        "cannot be told beside that"
    )
