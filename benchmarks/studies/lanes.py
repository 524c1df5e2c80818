"""How many starts and recordings a second the solver itself ends, in runs of ever more lanes.

python -m benchmarks.studies.lanes [--starts 1000000] [--fits 100000] [--lanes 32,65536] [--on gpu]

One simulated drop of 6 s at 100 Hz is asked from that many starts, tied to its first second, as the
first stage of a fit has it; as many recordings are asked for their free motion, from four starts
each. The way of a run's inputs to the device and of its results back is in the time; what a fit
decides between its runs, on the processor, is not. Few lanes are timed on fewer starts. exoid
itself runs all programs on the processor.
"""

import argparse
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import jax
import numpy as np

from exoid.fitting.estimate import fit
from exoid.fitting.solve.answer import answer, laned
from exoid.fitting.solve.meeting import Question, meet
from exoid.fitting.solve.program import solve_many
from exoid.recordings.loading.load import load
from exoid.studies.batch.fit_many import FEW

from .people import drops, write

KNOWN = 64  # recordings of their own: more are the same again
MANY, ROUNDS = 1024, 3  # lanes, and runs of fewer that are timed


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.studies.lanes",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--starts", type=int, default=1_000_000)
    parser.add_argument("--fits", type=int, default=100_000)
    parser.add_argument("--lanes", default="32,4096,65536")
    parser.add_argument("--on", default=jax.default_backend(), help="kind of device, as JAX has it")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    tied, free = questions()
    asked = (("starts, tied", tied[:1], options.starts, 1), ("fits, free", free, options.fits, FEW))
    device = jax.devices(options.on)[0]
    for lanes in map(int, options.lanes.split(",")):
        for what, each, count, share in asked:
            seconds, done, lost = timed(each, count * share, lanes, device)
            print(
                f"{device.device_kind:20} {what:13} {lanes:6} lanes: {done // share:8} in "
                f"{seconds:7.2f} s, {1e3 * share * seconds / done:8.4f} ms each; "
                f"{lost} without an end",
                flush=True,
            )


def questions() -> tuple[list[Question], list[Question]]:
    """What fits from a few starts ask first, and last of the free motion of whole recordings."""
    every: list[Sequence[Question]] = []

    def kept(asked: Sequence[Question]):
        every.append(asked)
        return answer(asked)

    with TemporaryDirectory() as there:
        write(drops(KNOWN), Path(there))
        recordings = [load(path).recording for path in sorted(Path(there).glob("*.csv"))]
    meet([lambda one=one: fit(one, multistart=FEW) for one in recordings], kept)
    flat = [one for asked in every for one in asked]
    first = [one for one in flat if one.steps == flat[0].steps]
    return first[:KNOWN], [one for one in flat if one.steps > flat[0].steps][:KNOWN]


def timed(
    asked: Sequence[Question], count: int, lanes: int, device: jax.Device
) -> tuple[float, int, int]:
    """s that so many starts take, how many those are, and how many of them ended nowhere."""
    runs = -(-count // lanes)
    if lanes < MANY:
        runs = min(runs, ROUNDS)
    run, steps = solver(asked[0], device), np.asarray(max(one.steps for one in asked))
    given = [arguments(asked, lanes, number) for number in range(min(runs, ROUNDS))]
    run(given[0], steps)
    began = time.perf_counter()
    losses = [run(given[number % len(given)], steps) for number in range(runs)]
    seconds = time.perf_counter() - began
    return seconds, runs * lanes, int(np.sum(~np.isfinite(np.concatenate(losses))))


def solver(one: Question, device: jax.Device) -> Callable[..., np.ndarray]:
    """The losses of a run."""

    def run(leaves, steps):
        given = jax.tree.unflatten(one.given, leaves)
        return solve_many(given, steps, one.static).loss

    compiled = jax.jit(run)

    def told(leaves, steps) -> np.ndarray:
        with jax.default_device(device):
            return np.asarray(compiled(leaves, steps))

    return told


def arguments(asked: Sequence[Question], lanes: int, seed: int) -> list[np.ndarray]:
    """Of as many lanes: the recordings in turn, from their starts or, beyond these, near them."""
    starts = np.array([one.starts for one in asked])
    owner = np.resize(np.repeat(np.arange(len(asked)), starts), lanes)
    leaves = laned(asked, np.resize(np.arange(starts.sum()), lanes), owner)
    generator = np.random.default_rng(seed)
    coordinates = len(jax.tree.leaves(jax.tree.unflatten(asked[0].given, leaves)[0]))
    near = [leaf * (1 + 0.02 * generator.normal(size=leaf.shape)) for leaf in leaves[:coordinates]]
    return [*near, *leaves[coordinates:]]


if __name__ == "__main__":
    main()
