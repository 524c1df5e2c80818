"""Does a study find what is true? Studies whose truth is known, told to `exoid.studies` as tables.

python -m benchmarks.studies.truth --replications 50            # 200 people: about five minutes
python -m benchmarks.studies.truth --people 24 --absent 0.2     # a small study, and visits missed
python -m benchmarks.studies.truth --fitted --replications 50 --people 40 --to build/fitted
python -m benchmarks.studies.truth --fitted --with coulomb_friction --to build/with-friction

With --fitted recordings are simulated (`fitted/`) and fitted by the batches of `exoid study run`,
and the tables are those that it leaves. Each study is kept in the folder --to when it is done: a
run that was killed goes on.

Of each study are counted: whether the 95 % interval of the groups' difference, of the correlation
of test and retest and of the minimal detectable change hold the truth; how often a difference is
found that is there, and one that is not; whether dry friction is found in the group that has it.
"""

import argparse
import os
from collections.abc import Sequence
from pathlib import Path

os.environ.update(dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "NPROC"), "1"))

import numpy as np
from benchmarks.studies.fitted.by_fits import by_fits
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Answer, Answers, Asked
from exoid.studies.statistics.reliability import DETECTABLE
from exoid.studies.statistics.tables.said import Interval

DIFFERENT = Truth()
THE_SAME = Truth(quantity="period", unit="s", mean=1.1, effect=0.0)
KEPT = Path("build/fitted")
Row = tuple[str, float, float, str]


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.studies.truth",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--replications", type=int, default=50)
    parser.add_argument("--people", type=int, default=200)
    parser.add_argument("--absent", type=float, default=0.0, help="share of second days missed")
    parser.add_argument("--seed", type=int, default=0, help="of the first study")
    parser.add_argument("--fitted", action="store_true", help="recordings are fitted")
    parser.add_argument("--to", type=Path, default=KEPT, help="where fitted studies are kept")
    parser.add_argument("--with", dest="terms", default="", help="TERM,... of the fitted model")
    parser.add_argument("--multistart", type=int, default=64, help="starts of a fit")
    parser.add_argument("--unlike", type=float, default=0.0, help="relative scatter of drops")
    options = parser.parse_args()
    if options.fitted:
        by_fits(options)
        return
    design = Design(
        people=options.people, absent=options.absent, truths=(DIFFERENT, THE_SAME), friction=0.3
    )
    seeds = range(options.seed, options.seed + options.replications)
    rows = [row for seed in seeds for row in of_study(design, seed)]
    print("\n".join(table(rows, options.replications)))


def of_study(design: Design, seed: int) -> list[Row]:
    """What is to be counted of one study: name, 1 or 0 or a value, and the truth."""
    answers = ask(simulate(design, seed), Asked(by="group"))
    different, same = answers.each
    return [
        *of_truth(different, DIFFERENT, design),
        *of_truth(same, THE_SAME, design),
        (
            "a difference that is there is found",
            float(different.corrected["groups"] < 0.05),
            1.0,
            "",
        ),
        ("one that is not there is found", float(same.corrected["groups"] < 0.05), 0.05, ""),
        ("dry friction is found in its group alone", float(rubs(answers)), 1.0, ""),
    ]


def of_truth(each: Answer, truth: Truth, design: Design) -> list[Row]:
    """Whether the intervals of one quantity hold the truth."""
    found, groups = each.reliability, each.groups
    sem = truth.error_of_occasion(design.drops)
    correlation = truth.correlation(design.drops, design.groups)
    true = {
        "difference of the groups": (groups.differences[0].effect, truth.effect),
        "ICC(C,1)": (found.consistency, correlation),
        "ICC(A,1)": (found.agreement, correlation),  # no day shifts all people
        "minimal detectable change": (found.change, DETECTABLE * sem),
    }
    return [
        (f"{name} of {each.quantity}", held(interval, value), 0.95, off(interval, value))
        for name, (interval, value) in true.items()
    ]


def held(interval: Interval, truth: float) -> float:
    return float(interval.low <= truth <= interval.high)


def off(interval: Interval, truth: float) -> str:
    """How far the value is from the truth."""
    return f"{interval.value - truth:.6g}"


def rubs(answers: Answers) -> bool:
    """Is friction surely found in the second group, and in nobody of the first?"""
    found = {each.group: each for each in answers.physics if each.name == "dry friction"}
    return found["spastic"].share.low > 0.05 and found["control"].people == 0


def table(rows: Sequence[Row], studies: int) -> list[str]:
    """One line per name: how often, of how many, and the mean of what values are off by."""
    names = dict.fromkeys(name for name, *_ in rows)
    width = max(map(len, names))
    lines = [f"{'':{width}}  of {studies}  wanted  mean off the truth"]
    for name in names:
        each = [row for row in rows if row[0] == name]
        apart = [float(row[3]) for row in each if row[3]]
        mean = f"{np.mean(apart):+.4f} ± {np.std(apart) / len(apart) ** 0.5:.4f}" if apart else ""
        count = sum(row[1] for row in each)
        lines.append(f"{name:{width}}  {count:5.0f}  {each[0][2]:6.0%}  {mean}")
    return lines


if __name__ == "__main__":
    main()
