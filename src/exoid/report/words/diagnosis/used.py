"""What of the recordings a diagnosis used."""

from collections.abc import Iterable

from exoid.fitting.hands.kept_back import AS, NEXT


def used(aside: Iterable[str], said: str) -> list[str]:
    """What was not used, without what is `said` already of why, and of what to do."""
    again = {f", {words}" for words in AS.values() if words in said}
    again |= {f" {words}" for words in NEXT.values() if words in said}
    return [without(each, again) for each in aside]


def without(sentence: str, words: Iterable[str]) -> str:
    """The sentence without any of these words."""
    for each in words:
        sentence = sentence.replace(each, "")
    return sentence
