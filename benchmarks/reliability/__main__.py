"""Answers of the benchmarks `blind` and `others` against how sure `diagnose` was of them.

python -m benchmarks.blind --own 500 --to build/own
python -m benchmarks.others --cases 500 --only diagnose
python -m benchmarks.reliability build/own build/others      # table, figure, reliability.md
python -m benchmarks.reliability                             # of all that were asked before

Every recording counts as it was first answered (`kept.py`), by the code of that day. An answer
names causes, or has a best explanation where it says "cannot tell"; `weight` is the share of the
weight of all explanations that those with these causes hold. It is right where all act.
"""

import argparse
from pathlib import Path

from benchmarks.blind.report import aligned, markdown

from .curve import BINS, HEAD, asserted_rows, binned, draw
from .kept import keep
from .outcomes import Outcome, of_blind, of_others

HERE = Path(__file__).parent


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.reliability",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("folders", type=Path, nargs="*", help="of answers with their truths")
    parser.add_argument("--to", type=Path, default=HERE, help="folder of what is kept and written")
    options = parser.parse_args()
    options.to.mkdir(parents=True, exist_ok=True)
    new = [one for folder in options.folders for one in outcomes(folder)]
    found = keep(options.to / "asked.csv", new)
    sure = [HEAD, *asserted_rows(found)]
    curve = [("weight", "answers", "mean weight", "right"), *binned(found, BINS)]
    print("\n\n".join(map(aligned, (sure, curve))))
    draw(found, options.to / "reliability.png")
    (options.to / "reliability.md").write_text(page(sure, curve), encoding="utf-8")


def outcomes(folder: Path) -> list[Outcome]:
    return [*of_blind(folder), *of_others(folder)]


def page(sure: list[tuple[str, ...]], curve: list[tuple[str, ...]]) -> str:
    return f"""\
# Reliability

What `diagnose` asserts, and whether it is true. `own` are recordings that exoid's own models made,
`others` those of people, hands and sensors that share no code with exoid. *Wrong* is an answer with
a cause that does not act, or a torque called novel that is not. Each was asked once, by the code of
its day, before anything was mended after it: `asked.csv` has them all.

{markdown(sure[0], sure[1:])}

All answers with a best explanation, asserted or not, by the weight of what it names:

{markdown(curve[0], curve[1:])}

![Share of right answers over the weight that they had](reliability.png)
"""


if __name__ == "__main__":
    main()
