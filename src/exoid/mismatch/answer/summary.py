"""What a diagnosis says, in few lines for the prompt and a small table for a notebook."""

from typing import Any

from exoid.mismatch.answer.over_inertia import parameters_shown
from exoid.recordings.summary import html_table

VERDICTS = {
    "none": "nothing is missing",
    "mismatch": "something is missing",
    "cannot_tell": "cannot tell from this recording",
}


def lines(found: Any) -> str:
    """The verdict, what is missing with its numbers, and why no more could be said."""
    effects = [f"  {each.title}" for each in found.findings]
    numbers = [f"    {written(each)}" for each in parameters_shown(found, found.parameters)]
    reasons = [f"  because {each}" for each in found.reasons]
    return "\n".join([heading(found), *effects, *numbers, *reasons])


def page(found: Any) -> str:
    """The verdict above what was found, as HTML."""
    shown = parameters_shown(found, found.parameters)
    rows = [(each.name, f"{each.value:.4g}", error(each), each.unit) for each in shown]
    titles = "; ".join([each.title for each in found.findings] or found.reasons)
    title = f"{heading(found)}{f': {titles}' if titles else ''}"
    return html_table(title, ("parameter", "value", "±", "unit"), rows)


def heading(found: Any) -> str:
    return f"Diagnosis: {VERDICTS[found.verdict]}"


def written(each: Any) -> str:
    return f"{each.name} = {each.value:.4g} ± {error(each)} {each.unit}".replace(" ±  ", " ")


def error(each: Any) -> str:
    return "" if each.standard_error is None else f"{each.standard_error:.2g}"
