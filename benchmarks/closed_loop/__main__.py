"""Node, motor and leg in a closed loop, in MuJoCo: emulated and simulated only.

python -m benchmarks.closed_loop [--people 100] [--seed 0] [--friction 0.1] [--learner host]
"""

import argparse
from pathlib import Path

from benchmarks.closed_loop.figure import draw
from benchmarks.closed_loop.learners import ByHost, ByNode
from benchmarks.closed_loop.people import outcomes, session
from benchmarks.closed_loop.report import report
from benchmarks.closed_loop.rubbing import rubbing

LEARNERS = {"node": ByNode, "host": ByHost}


def main() -> None:
    said = argparse.ArgumentParser(description=__doc__)
    said.add_argument("--people", type=int, default=100)
    said.add_argument("--seed", type=int, default=0)
    said.add_argument("--friction", type=float, default=0.1, help="N m, the most of a frame's")
    said.add_argument("--learner", choices=LEARNERS, default="host")
    said.add_argument("--rubbing", action="store_true", help="learn alone, by levels of friction")
    said.add_argument("--figure", type=Path, help="where to draw it, a PNG")
    given = said.parse_args()
    learner = LEARNERS[given.learner]
    if given.rubbing:
        print(rubbing(given.people, given.seed, learner))
        return
    drawn = (given.seed, given.friction, learner)
    every = list(outcomes(given.people, *drawn))
    print(f"{given.people} people, the leg learned by the {given.learner}, ", end="")
    print(f"dry friction of up to {given.friction:g} N m")
    print(report(every))
    if given.figure is not None:
        draw(session(0, *drawn)[0], every, given.figure)


if __name__ == "__main__":
    main()
