"""Diagnoses blind cases, and scores the answers.

python -m benchmarks.blind                       # all that lie in ../shared/data, where present
python -m benchmarks.blind --own 50 --seed 0     # our own, simulated
python -m benchmarks.blind --own 50:100          # the next of them, say on another machine
"""

import argparse
import json
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from .answer import Answer, ask
from .crew import diagnosed_cases, set_up
from .deck import CATEGORIES, deal
from .figure import draw
from .report import page, terminal
from .score import score
from .sets import FOLDERS, OWN, TRUTH, Blind, stored

HERE = Path(__file__).parent


def main() -> None:
    options = parse()
    first, last = options.own
    begin = f"{options.category or OWN}-" if last else ""
    begin += f"{first}-" if first else ""
    options.to.mkdir(parents=True, exist_ok=True)
    cases, answers = [], {}
    cards = list(enumerate(deal(last, options.seed, options.category)))[first:]
    made = diagnosed_cases(cards, options.seed, options.workers)
    for case, answer in made if last else stored_ones(options):
        cases.append(case)
        answers[case.name] = answer
        tell(f"[{len(cases)}] {case.name}: {answer.words}  {answer.seconds:.1f} s\n")
        given = {name: answer.as_json() for name, answer in answers.items()}
        write(given, options.to / f"{begin}answers.json")  # an interrupted run is not lost
        if last:
            write([case.truth for case in cases if case.truth], options.to / f"{begin}{TRUTH}")
    if not cases:
        sys.exit("no case to run: name a --folder, or make some with --own N")
    publish(cases, answers, options.to, begin)


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.blind",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--own", type=span, default=(0, 0), metavar="N or A:B", help="run so many own cases instead"
    )
    parser.add_argument("--workers", type=int, help="processes of own cases; one a core")
    parser.add_argument("--category", choices=CATEGORIES, help="own cases of this kind only")
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


def span(text: str) -> tuple[int, int]:
    """N or A:B."""
    begin, colon, end = text.rpartition(":")
    return (int(begin or 0), int(end)) if colon else (0, int(text))


def stored_ones(options: argparse.Namespace) -> Iterator[tuple[Blind, Answer]]:
    """The cases of all folders that are there."""
    set_up()
    for case in found_in(options.folder or FOLDERS):
        if not options.case or case.name in options.case:
            yield case, ask(case.name, case.load, case.truth, options.seed)


def found_in(folders: Iterable[Path]) -> Iterator[Blind]:
    for folder in folders:
        if folder.is_dir():
            yield from stored(folder)
        else:
            tell(f"skipped: {folder} is absent\n")


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
