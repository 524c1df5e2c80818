"""Text as it is printed, where a terminal has only what a keyboard has."""

PRINTED = {"^2": "²", "^3": "³", "->": "→"}


def tidy(words: str) -> str:
    """Powers and arrows as signs of their own."""
    for typed, printed in PRINTED.items():
        words = words.replace(typed, printed)
    return words
