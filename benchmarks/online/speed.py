"""What a step costs from Python, and how fast a recording is replayed."""

import time
import tracemalloc

import numpy as np
from benchmarks.online import world

import exoid
from exoid import online

HOUR = 360_000  # samples of 10 ms
ROUNDS = 5


def stream(seed: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A session of three drops."""
    rng = np.random.default_rng(seed)
    motion, _ = world.session(rng, [world.draw_leg(rng)] * 3)
    return world.measured(rng, motion, world.draw_sensors(rng))


def report() -> str:
    belief = online.init(exoid.expected_leg(77.0, 1.80))
    times, angles, rates = stream()
    samples = [online.Sample(*row) for row in np.stack([times, angles, rates], 1).tolist()]
    online.step(belief, samples[0])
    live, processor = [], []
    for _ in range(ROUNDS):
        now = belief
        for one in samples:
            begun, worked = time.perf_counter_ns(), time.process_time_ns()
            now, _ = online.step(now, one)
            processor.append((time.process_time_ns() - worked) / 1e3)
            live.append((time.perf_counter_ns() - begun) / 1e3)
    whole = online.Sample(times, angles, rates)
    lasted = []
    for _ in range(ROUNDS):
        begun = time.process_time()
        online.replay(belief, whole)
        lasted.append(time.process_time() - begun)
    median, last = np.quantile(live, [0.5, 0.999])
    own, late = np.quantile(processor, [0.5, 0.999])
    faster = times[-1] / min(lasted)
    return (
        f"\nstep: median {median:.0f} us, 99.9 % below {last:.0f} us by the clock; {own:.0f} and "
        f"{late:.0f} us of the processor\nreplay: {faster:.0f} times real time at 100 Hz\n"
        f"{grown(belief)}"
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
