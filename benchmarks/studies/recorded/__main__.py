"""Does a study of recordings find what is true? From files to the report, by the commands.

python -m benchmarks.studies.recorded --people 40                  # some minutes on two cores
python -m benchmarks.studies.recorded --people 200 --seed 1        # an hour
python -m benchmarks.studies.recorded --people 40 --steps drops --replications 10
python -m benchmarks.studies.recorded --people 0 --diagnosed 20    # missing physics alone

People of two groups, both legs, two days, five drops, some with dry friction, some recordings bad,
are simulated without exoid (`world.py`, `visit.py`) and written to disk; `exoid study check`, `run`
and `report` are asked as one asks them. Told are the difference of the groups, ICC and detectable
change beside the truth of all people (`truths.py`), and of every kind of recording how many values
are wrong and nothing says so.
"""

import argparse
from pathlib import Path
from tempfile import TemporaryDirectory

from .asked import report, run
from .diagnosed import diagnosed
from .held import Held, held, table
from .silence import silence
from .truths import QUANTITIES, truth_of
from .world import World
from .write import put_study

STEPS = {"relaxation_index": "drops", "damping_over_inertia": "fit"}  # that tell a quantity
EVERYBODY = {"damping_over_inertia": 4000, "relaxation_index": 1500}  # people of whom truth is


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.studies.recorded",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--people", type=int, default=40)
    parser.add_argument("--seed", type=int, default=0, help="of the first study")
    parser.add_argument("--replications", type=int, default=1)
    parser.add_argument("--steps", default="drops,fit")
    parser.add_argument("--diagnosed", type=int, default=0, help="recordings, half with friction")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--folder", type=Path, help="where studies are kept")
    options = parser.parse_args()
    world = World(people=options.people)
    with TemporaryDirectory() as there:
        folder = options.folder or Path(there)
        if world.people:
            studies(world, options, folder)
        if options.diagnosed:
            print("\n".join(diagnosed(world, options, folder / "diagnosed")), flush=True)


def studies(world: World, options: argparse.Namespace, folder: Path) -> None:
    asked = [name for name, step in STEPS.items() if step in options.steps]
    truths = {name: truth_of(world, QUANTITIES[name], EVERYBODY[name]) for name in asked}
    found: list[Held] = []
    for seed in range(options.seed, options.seed + options.replications):
        place = folder / f"study-{seed}"
        visits = put_study(world, seed, place / "study")
        seconds = run(place / "study", place / "results", options.workers, options.steps)
        print(f"study {seed}: {len(visits)} visits, run in {seconds:.0f} s", flush=True)
        for name in asked:
            print("\n".join(silence(visits, place / "results", name)), flush=True)
        one = held(report(place / "results", asked), truths)
        print("\n".join(table(one)), flush=True)
        found += one
    if options.replications > 1:
        print("\n".join(["all studies:", *table(found)]))


if __name__ == "__main__":
    main()
