"""Among how many tests every p was corrected."""

from collections.abc import Sequence

from exoid.files.counted import counted
from exoid.studies.statistics.asked import Answer, Answers
from exoid.studies.statistics.multiple import WORDS, tested_as

QUANTITIES = "quantity", "quantities"
BETWEEN = {
    "groups": "between groups",
    "change": "before and after",
    "change_by_group": "in how groups change",
    "sides": "between sides",
}


def correction(answers: Answers) -> str:
    """Which quantities were corrected with which, and how."""
    asked = answers.asked
    first = [each for each in answers.each if each.quantity in asked.primary]
    others = [each for each in answers.each if each.quantity not in asked.primary]
    how = f"by {WORDS[asked.correction]}"
    if first:
        said = f"p is corrected over {over(first, *(f'primary {each}' for each in QUANTITIES))}"
        return f"{said}, and apart from them over {over(others, 'other', 'others')}, {how}."
    said = f"p is corrected over {over(others, *QUANTITIES)}, {how}."
    if len(tested(others)) < 2:
        return said
    return f"{said} Those that were the question from the start are named by --primary."


def over(each: Sequence[Answer], one: str, many: str) -> str:
    """How many tests there are; of each question by itself where not all quantities answer it."""
    counts = {kind: count for answer in each for kind, count in answer.among.items()}
    if len({*counts.values()}) < 2:
        return counted(next(iter(counts.values()), len(tested(each))), one, many)
    apart = (f"{counts[kind]} {words}" for kind, words in BETWEEN.items() if kind in counts)
    return f"the {many} that have an answer ({', '.join(apart)})"


def tested(each: Sequence[Answer]) -> list[Answer]:
    """Without those that are a copy of another, and have its test."""
    own = tested_as([one.quantity for one in each])
    return [one for at, one in enumerate(each) if own[at] == at]
