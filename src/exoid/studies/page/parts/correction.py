"""Among how many tests every p was corrected."""

from exoid.report.words.text import counted
from exoid.studies.statistics.asked import Answers
from exoid.studies.statistics.multiple import WORDS

QUANTITIES = "quantity", "quantities"


def correction(answers: Answers) -> str:
    """Which quantities were corrected with which, and how."""
    asked, whole = answers.asked, len(answers.each)
    first = sum(each.quantity in asked.primary for each in answers.each)
    how = f"by {WORDS[asked.correction]}"
    if first:
        said = f"p is corrected over {counted(first, *primary())}"
        rest = counted(whole - first, "other", "others")
        return f"{said}, and apart from them over {rest}, {how}."
    said = f"p is corrected over {counted(whole, *QUANTITIES)}, {how}."
    if whole < 2:
        return said
    return f"{said} Those that were the question from the start are named by --primary."


def primary() -> tuple[str, ...]:
    return tuple(f"primary {each}" for each in QUANTITIES)
