"""Ranks of true values among the draws of their posteriors.

python -m benchmarks.sbc                     # 300 recordings, ten minutes on one core
python -m benchmarks.sbc --recordings 60
"""

import argparse

import jax

from exoid.fitting.solve.program_cache import keep_programs_in

from .ranks import Ranks, ranked

FALSE_ALARM = 1e-3  # of a chi-square, before it is divided by the number of quantities


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.sbc", description=__doc__)
    parser.add_argument("--recordings", type=int, default=300)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
    print(table(ranked(options.recordings, options.seed)))


def table(found: Ranks) -> str:
    """A line a quantity: the histogram, how surprising it is, and whether ranks lean to a side."""
    count = len(next(iter(found.ranks.values())))
    rows = [f"{count} recordings in which something moves"]
    rows += [f"{'quantity':24} {'ranks in ten parts':40} {'p':>7} {'lean':>6}"]
    for name in found.ranks:
        counts = " ".join(f"{count:3d}" for count in found.histogram(name))
        rows.append(f"{name:24} {counts:40} {found.surprise(name):7.3f} {found.mean(name):+6.1f}")
    least = min(map(found.surprise, found.ranks))
    uniform = least > FALSE_ALARM / len(found.ranks)
    return "\n".join([*rows, "uniform" if uniform else "NOT uniform"])


if __name__ == "__main__":
    main()
