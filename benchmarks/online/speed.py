"""What a step costs, alone and beside a refinement, and how fast a recording is replayed.

python -m benchmarks.online.speed    on cores that have nothing else to do
"""

import time
import tracemalloc
from collections.abc import Callable, Iterator

import numpy as np
from benchmarks.online import world
from benchmarks.online.coverage import SUBJECT
from jaxtyping import Float

from exoid import online
from exoid.recordings.live.decoding.reading import Reading
from exoid.watching.beside.refinement import Refinement
from exoid.watching.estimate.expect import expected_of
from exoid.watching.estimate.leg import Leg, LegDrop, Person
from exoid.watching.estimate.load import Load

HOUR = 360_000  # samples of 10 ms
ROUNDS = 5
QUANTILES = (0.5, 0.999)
FITS = 3  # refinements beside which steps are timed


def stream(seed: int = 0) -> online.Sample:
    """A session of three drops."""
    rng = np.random.default_rng(seed)
    motion, _ = world.session(rng, [world.draw_leg(rng)] * 3)
    return online.Sample(*world.measured(rng, motion, world.draw_sensors(rng)))


def start() -> online.Belief:
    return online.init(expected_of(SUBJECT))


def rows_of(samples: online.Sample) -> list[online.Sample]:
    table = np.stack([samples.time, samples.angle, samples.angular_velocity], axis=1)
    return [online.Sample(*row) for row in table.tolist()]


def timed(samples: online.Sample, goes_on: Callable[[int], bool]) -> Float[np.ndarray, "step 2"]:
    """us of every step, by the clock and of the processor, session after session."""
    belief, each, found = start(), rows_of(samples), []
    online.step(belief, each[0])
    while goes_on(len(found)):
        now = belief
        for one in each:
            begun, worked = time.perf_counter_ns(), time.process_time_ns()
            now, _ = online.step(now, one)
            processor = time.process_time_ns() - worked
            found.append((time.perf_counter_ns() - begun, processor))
    return np.array(found) / 1e3


def beside_refinements(samples: online.Sample) -> Float[np.ndarray, "step 2"]:
    """The same, in this process, while the batch fits that `exoid live` asks for run in theirs."""
    refinement = Refinement(SUBJECT, online.Model())
    try:
        (last,) = [*drops_of(samples)][-1:]
        fit(refinement, last)  # compiled, or loaded
        while refinement.busy:
            time.sleep(0.1)
            refinement.look()
        done = iter(range(FITS))

        def goes_on(_: int) -> bool:
            refinement.look()
            if refinement.failed is not None:
                raise RuntimeError(refinement.failed)
            if refinement.busy:
                return True
            if next(done, None) is None:
                return False
            fit(refinement, last)
            return True

        return timed(samples, goes_on)
    finally:
        refinement.close()


def fit(refinement: Refinement, drop: LegDrop) -> None:
    """Ask for one more fit, as after another drop."""
    refinement.add(drop)
    refinement.latest = None
    refinement.look()


def drops_of(samples: online.Sample) -> Iterator[LegDrop]:
    """As `exoid live` finds them."""
    person = Person(SUBJECT, expected_of(SUBJECT), online.Model())
    readings = [Reading(one.time, one.angle, one.angular_velocity) for one in rows_of(samples)]
    told = Leg(person, Load()).take(readings)
    return (each for each in told if isinstance(each, LegDrop))


def report() -> str:
    samples = stream()
    alone = timed(samples, lambda steps: steps < ROUNDS * len(np.asarray(samples.time)))
    lasted = []
    for _ in range(ROUNDS):
        begun = time.process_time()
        online.replay(start(), samples)
        lasted.append(time.process_time() - begun)
    faster = np.asarray(samples.time)[-1] / min(lasted)
    return (
        f"\nstep: {words(alone)}\nstep beside refinements: {words(beside_refinements(samples))}\n"
        f"replay: {faster:.0f} times real time at 100 Hz\n{grown(start())}"
    )


def words(each: Float[np.ndarray, "step 2"]) -> str:
    (median, last), (own, late) = np.quantile(each, QUANTILES, axis=0).T
    return (
        f"median {median:.0f} us, 99.9 % below {last:.0f} us by the clock; {own:.0f} and "
        f"{late:.0f} us of the processor ({len(each)} steps)"
    )


def grown(belief: online.Belief, samples: int = HOUR // 10) -> str:
    """How much memory a stream takes for good."""
    online.step(belief, online.Sample(0.0, 0.0, 0.0))
    kept = []
    tracemalloc.start()
    for number in range(samples):
        shaken = 1e-3 * np.sin(number)
        belief, _ = online.step(belief, online.Sample(0.01 * number, -0.35 + shaken, shaken))
        if number % (samples // 4) == samples // 4 - 1:
            kept.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    return f"memory after each quarter of {samples} samples: {kept} bytes"


if __name__ == "__main__":
    from exoid.fitting.solve.program_cache import keep_programs_in

    keep_programs_in()
    print(report())
