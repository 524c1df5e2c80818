"""Diagnoses blind cases, and scores the answers.

python -m benchmarks.blind                       # all that lie in ../shared/data, where present
python -m benchmarks.blind --own 50 --seed 0     # our own, simulated
"""

import argparse
import json
import sys
from collections.abc import Iterable
from pathlib import Path

import jax

from exoid.fit.program import keep_programs_in

from .answer import Answer, ask
from .figure import draw
from .report import page, terminal
from .score import score
from .sets import FOLDERS, OWN, TRUTH, Blind, own, stored

HERE = Path(__file__).parent


def main() -> None:
    options = parse()
    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
    cases, total = chosen(options)
    if not total:
        sys.exit("no case to run: name a --folder, or make some with --own N")
    options.to.mkdir(parents=True, exist_ok=True)
    begin = "own-" if options.own else ""
    asked, answers = [], {}
    for case in cases:
        tell(f"[{len(asked) + 1}/{total}] {case.name} ... ")
        answers[case.name] = ask(case.name, case.load, options.seed)
        asked.append(case)
        tell(f"{answers[case.name].words}  {answers[case.name].seconds:.1f} s\n")
        write_answers(answers, options.to / f"{begin}answers.json")
    publish(asked, answers, options.to, begin)


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.blind",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--own", type=int, default=0, metavar="N", help="run N own cases instead")
    parser.add_argument("--seed", type=int, default=0, help="of own cases, and of the diagnosis")
    parser.add_argument(
        "--folder",
        type=Path,
        action="append",
        help=f"recordings, with {TRUTH} where the truth is known, in place of the usual ones",
    )
    parser.add_argument("--case", action="append", help="only this one (may be repeated)")
    parser.add_argument("--to", type=Path, default=HERE, help="folder of what is written")
    return parser.parse_args()


def chosen(options: argparse.Namespace) -> tuple[Iterable[Blind], int]:
    """The cases that were asked for, and how many."""
    if options.own:
        return own(options.own, options.seed), options.own
    found: list[Blind] = []
    for folder in options.folder or FOLDERS:
        if folder.is_dir():
            found += stored(folder)
        else:
            tell(f"skipped: {folder} is absent\n")
    wanted = [case for case in found if not options.case or case.name in options.case]
    return wanted, len(wanted)


def write_answers(answers: dict[str, Answer], path: Path) -> None:
    """After every case, so that an interrupted run is not lost."""
    given = {name: answer.as_json() for name, answer in answers.items()}
    path.write_text(json.dumps(given, indent=1) + "\n")


def publish(cases: list[Blind], answers: dict[str, Answer], folder: Path, begin: str) -> None:
    """The table on stdout, the page, the figure, and the truth of own cases."""
    truths = [case.truth for case in cases if case.truth is not None]
    found = score(truths, answers)
    print(terminal(cases, answers, found))
    image = folder / f"{begin}results.png"
    draw(cases, answers, found, image)
    command = " ".join(["python -m benchmarks.blind", *sys.argv[1:]])
    text = page(cases, answers, found, command=command, image=image.name)
    (folder / f"{begin}results.md").write_text(text, encoding="utf-8")
    if any(case.of == OWN for case in cases):
        (folder / f"{begin}{TRUTH}").write_text(json.dumps(truths, indent=1) + "\n")


def tell(words: str) -> None:
    print(words, end="", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
