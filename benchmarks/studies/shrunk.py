"""How much nearer to the truth is a leg that all other people help to tell?

python -m benchmarks.studies.shrunk --replications 5

Studies of 40 people, two days, few drops a day, of which some are badly recorded: the root mean
square error of a leg's value against what the leg is, for the mean of its drops and for the
hierarchical model, and how many 95 % intervals hold it.
"""

import argparse

import numpy as np
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.statistics.shrunk import shrunk
from exoid.studies.statistics.tables.values import values_of

QUANTITY = Truth(bad=0.2)


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.studies.shrunk",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--replications", type=int, default=5)
    parser.add_argument("--people", type=int, default=40)
    options = parser.parse_args()
    print("drops a day  mean of drops  shrunk  in the interval")
    for drops in (1, 2, 5):
        design = Design(people=options.people, drops=drops, truths=(QUANTITY,))
        each = np.array([of_study(design, seed) for seed in range(options.replications)])
        plain, nearer, held = each.mean(0)
        print(f"{drops:11}  {plain**0.5:13.4f}  {nearer**0.5:6.4f}  {held:.0%}")


def of_study(design: Design, seed: int) -> tuple[float, float, float]:
    """Mean squares of both errors, and the share of intervals that hold the truth."""
    study = simulate(design, seed)
    found = shrunk(values_of(study, QUANTITY.quantity), "participant_group").legs
    legs = study.quantities.groupby(["participant", "side"])["truth"].first()
    truth = legs.loc[list(zip(found["person"], found["side"], strict=True))].to_numpy()
    off = found["value"].to_numpy() - truth
    held = np.abs(off) < 1.96 * found["error"].to_numpy()
    plain = found["plain"].to_numpy() - truth
    return float(np.mean(plain**2)), float(np.mean(off**2)), float(held.mean())


if __name__ == "__main__":
    main()
