"""Makes recordings as other people do, has exoid fit and diagnose them, and scores the answers.

python -m benchmarks.others --cases 500 --seed 0             # all of it; continues where it was
python -m benchmarks.others --cases 200 --together 3         # three effects at once
python -m benchmarks.others --cases 0:60 --only fit          # these cases, fits alone
python -m benchmarks.others --cases 200 --only make          # recordings and truths alone
python -m benchmarks.others --cases 200 --release MODULE:FUNCTION   # a detector's begins and ends
"""

import argparse
import json
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict
from itertools import repeat
from multiprocessing import get_context
from pathlib import Path

from . import release
from .ask import answer_of, ask_all
from .score import mark_diagnosis, mark_fit
from .summary import HEAD, Marked, aligned, line, page, rows
from .write import make

COMMANDS = ["fit", "diagnose"]


def main() -> None:
    options = parse()
    numbers = range(*options.cases)
    with ProcessPoolExecutor(options.workers, mp_context=get_context("spawn")) as pool:
        given = (repeat(options.seed), numbers, repeat(options.to), repeat(options.together))
        made = pool.map(make, *given, chunksize=4)
        tables = list(made)
    if options.only == "make":
        print(f"{len(tables)} recordings in {options.to}")
    elif options.release:
        print(release.report(tables, release.detector(options.release)))
    else:
        publish(list(judged(tables, options)), options)


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.others",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--cases", type=span, default=(0, 500), metavar="N or A:B")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--together", type=int, default=1, choices=[1, 2, 3], help="effects of one recording"
    )
    parser.add_argument("--only", choices=["make", *COMMANDS], help="without it: fit and diagnose")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument(
        "--to", type=Path, default=Path("build/others"), help="folder of recordings"
    )
    parser.add_argument("--answers", type=Path, help="folder of the answers; TO/answers")
    parser.add_argument("--release", metavar="MODULE:FUNCTION", help="score a detector instead")
    options = parser.parse_args()
    options.answers = options.answers or options.to / "answers"
    return options


def span(text: str) -> tuple[int, int]:
    """N or A:B."""
    begin, colon, end = text.rpartition(":")
    return (int(begin or 0), int(end)) if colon else (0, int(text))


def judged(tables: list[Path], options: argparse.Namespace) -> Iterator[Marked]:
    """Each case when it is answered; a fit of a leg that lacks something is not asked for."""
    asked = [options.only] if options.only else COMMANDS
    questions = {table: wanted(table, asked) for table in tables}
    for table in ask_all(questions, options.answers, options.workers):
        case = marked(table, questions[table], options.answers)
        print(line(case), flush=True)
        yield case


def wanted(table: Path, commands: list[str]) -> list[str]:
    """The commands whose answers can be judged."""
    plain = truth_of(table)["effect"] == "none"
    return [each for each in commands if plain or each != "fit"]


def truth_of(table: Path) -> dict:
    return json.loads(table.with_suffix(".truth.json").read_text(encoding="utf-8"))


def marked(table: Path, commands: list[str], folder: Path) -> Marked:
    truth = truth_of(table)
    answers = {each: answer_of(folder, table.stem, each) for each in commands}
    fit, diagnosis = answers.get("fit"), answers.get("diagnose")
    return Marked(
        truth,
        mark_fit(truth, fit) if fit is not None else None,
        mark_diagnosis(truth, diagnosis) if diagnosis is not None else None,
    )


def publish(cases: list[Marked], options: argparse.Namespace) -> None:
    """The table on stdout and in Markdown, all marks as JSON."""
    cases = sorted(cases, key=lambda case: case.truth["id"])
    body = list(rows(cases))
    print("\n" + aligned(HEAD, body))
    marks = [
        {
            "id": case.truth["id"],
            "fit": case.fit and asdict(case.fit),
            "diagnosis": case.diagnosis and asdict(case.diagnosis),
        }
        for case in cases
    ]
    (options.answers / "marks.json").write_text(json.dumps(marks, indent=1) + "\n")
    (options.answers / "results.md").write_text(page(cases), encoding="utf-8")


if __name__ == "__main__":
    main()
