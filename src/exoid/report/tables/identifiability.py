"""What a recording told of the leg, in sentences."""

from rich.console import Console

from exoid.report.words.text import heading, say
from exoid.trust.told import Identifiability


def print_told(told: Identifiability, console: Console) -> None:
    """What no motion tells, what this recording hardly tells, and what rests on an assumption."""
    heading(console, "What the recording tells")
    alone = ", ".join(each.symbol for each in told.combinations.values())
    say(console, f"- by itself, without prior and bounds: {alone or 'nothing'}.", hanging=2)
    for sentence in told.sentences:
        say(console, f"- {sentence}", hanging=2)
