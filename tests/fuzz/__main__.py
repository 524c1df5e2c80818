"""python -m tests.fuzz --minutes 60 --seed 0: a table of what damaged files came to."""

import argparse
import sys
from pathlib import Path

from .judge import FAILED, NAMES, mutant
from .run import Plan, Tally, fuzz, table
from .worker import alone


def main() -> int:
    """The exit code: 1 where a mutant failed."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--mutants", type=int, default=10**12, help="of each format, at most")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--format", action="append", choices=NAMES, help="only this one; repeat")
    parser.add_argument("--failures", type=Path, default=Path("fuzz-failures.txt"))
    parser.add_argument("--replay", help="FORMAT:SEED:NUMBER, as in the file of failures")
    parser.add_argument("--apart", action="store_true", help="replay as a command reads it")
    parser.add_argument("--write", type=Path, help="write the mutant that is replayed to this file")
    given = parser.parse_args()
    if given.replay:
        return replay(given.replay, given.apart, given.write)
    names = tuple(given.format or NAMES)

    def keep(tallies: dict[str, Tally]) -> None:
        recipes = [
            f"{name}:{given.seed}:{number} {kind}"
            for name, each in tallies.items()
            for number, kind in each.failures
        ]
        given.failures.write_text("\n".join([table(tallies), "", *recipes, ""]))

    tallies = fuzz(Plan(names, given.seed, 60 * given.minutes, given.mutants), keep)
    print(table(tallies))
    failed = sum(len(each.failures) for each in tallies.values())
    if failed:
        print(f"{failed} failed: see {given.failures}, and --replay each of its lines")
    return int(bool(failed))


def replay(recipe: str, apart: bool, write: Path | None) -> int:
    name, seed, told = recipe.split(":")
    number = told.split()[0]
    if write is not None:
        write.write_bytes(mutant(name, int(seed), int(number))[0])
    verdict = alone(name, int(seed), int(number), apart=apart)
    print(verdict.kind)
    print(verdict.why)
    return int(verdict.kind in FAILED)


if __name__ == "__main__":
    sys.exit(main())
