"""Among how many tests every p was corrected."""

from exoid.report.words.text import counted
from exoid.studies.statistics.asked import Answers
from exoid.studies.statistics.multiple import WORDS, tested_as

QUANTITIES = "quantity", "quantities"


def correction(answers: Answers) -> str:
    """Which quantities were corrected with which, and how."""
    asked, names = answers.asked, [each.quantity for each in answers.each]
    first = tests([each for each in names if each in asked.primary])
    whole = first + tests([each for each in names if each not in asked.primary])
    how = f"by {WORDS[asked.correction]}"
    if first:
        said = f"p is corrected over {counted(first, *primary())}"
        rest = counted(whole - first, "other", "others")
        return f"{said}, and apart from them over {rest}, {how}."
    said = f"p is corrected over {counted(whole, *QUANTITIES)}, {how}."
    if whole < 2:
        return said
    return f"{said} Those that were the question from the start are named by --primary."


def tests(quantities: list[str]) -> int:
    """How many there are of so many quantities."""
    return len(set(tested_as(quantities)))


def primary() -> tuple[str, ...]:
    return tuple(f"primary {each}" for each in QUANTITIES)
