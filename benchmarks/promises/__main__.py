"""Errors reached over errors promised by `exoid plan`.

python -m benchmarks.promises                    # six situations, twelve legs each
python -m benchmarks.promises --situation 2 --legs 40
"""

import argparse

import jax
import numpy as np

from exoid.fitting.solve.program_cache import keep_programs_in

from .situations import SITUATIONS
from .trial import Trial, tried


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.promises",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--legs", type=int, default=12)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--situation", type=int, choices=range(len(SITUATIONS)), action="append")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
    print(f"{'at hand':24} {'wanted':24} {'rms':>5} {'quoted':>7} {'median':>7}  content")
    every: list[Trial] = []
    for number in options.situation or range(len(SITUATIONS)):
        situation = SITUATIONS[number]
        seeds = [(options.seed, number, leg) for leg in range(options.legs)]
        found = [tried(situation, np.random.default_rng(seed)) for seed in seeds]
        print(f"{situation.words:24} {situation.goal:24} {line(found)}", flush=True)
        every += found
    print(f"{'all':49} {line(every)}")


def line(found: list[Trial]) -> str:
    """Of ratios to the promised and to the quoted error; how often a plan wanted nothing more."""
    ratios = np.array([each.ratio for each in found])
    quoted = np.array([each.error / (each.quoted or np.nan) for each in found])
    content = sum(each.content for each in found)
    return (
        f"{rms(ratios):5.2f} {rms(quoted):7.2f} {np.median(np.abs(ratios)):7.2f}  "
        f"{content} of {len(found)}  {' '.join(f'{each:.1f}' for each in ratios)}"
    )


def rms(each: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(each**2)))


if __name__ == "__main__":
    main()
