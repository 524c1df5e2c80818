"""Diagnoses blind cases, and scores the answers.

python -m benchmarks.blind                       # all that lie in ../shared/data, where present
python -m benchmarks.blind --own 50 --seed 0     # our own, simulated
"""

import argparse
import json
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

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
    every = made(options.own, options.seed) if options.own else found_in(options.folder or FOLDERS)
    cases = [case for case in every if not options.case or case.name in options.case]
    if not cases:
        sys.exit("no case to run: name a --folder, or make some with --own N")
    options.to.mkdir(parents=True, exist_ok=True)
    begin = f"{OWN}-" if options.own else ""
    if options.own:
        write([case.truth for case in cases if case.truth], options.to / f"{begin}{TRUTH}")
    asked, answers = [], {}
    for case in cases:
        tell(f"[{len(asked) + 1}/{len(cases)}] {case.name} ... ")
        answers[case.name] = ask(case.name, case.load, options.seed)
        asked.append(case)
        tell(f"{answers[case.name].words}  {answers[case.name].seconds:.1f} s\n")
        given = {name: answer.as_json() for name, answer in answers.items()}
        write(given, options.to / f"{begin}answers.json")  # an interrupted run is not lost
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


def made(count: int, seed: int) -> list[Blind]:
    """Own cases, all of them before the first is diagnosed."""
    cases = []
    for case in own(count, seed):
        cases.append(case)
        tell(f"\rdrawing {len(cases)} of {count} cases")
    tell("\n")
    return cases


def found_in(folders: Iterable[Path]) -> list[Blind]:
    """The stored cases of all folders that are there."""
    found: list[Blind] = []
    for folder in folders:
        if folder.is_dir():
            found += stored(folder)
        else:
            tell(f"skipped: {folder} is absent\n")
    return found


def write(content: Any, path: Path) -> None:
    path.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def publish(cases: list[Blind], answers: dict[str, Answer], folder: Path, begin: str) -> None:
    """The table on stdout, the page and the figure."""
    found = score([case.truth for case in cases if case.truth is not None], answers)
    print(terminal(cases, answers, found))
    image = folder / f"{begin}results.png"
    draw(cases, answers, found, image)
    command = " ".join(["python -m benchmarks.blind", *sys.argv[1:]])
    text = page(cases, answers, found, command=command, image=image.name)
    (folder / f"{begin}results.md").write_text(text, encoding="utf-8")


def tell(words: str) -> None:
    print(words, end="", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
