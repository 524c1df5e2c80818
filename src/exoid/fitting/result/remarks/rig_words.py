"""A rig is called a rig: what is said of legs is said of it in its own words."""

import re

OWN = tuple(
    (re.compile(of_a_leg), own)
    for of_a_leg, own in (
        (r", or a foot before the leg's line,", ""),
        (r"\bwith the knee extended\b", "with the rig level"),
        (r"\bthe axis of the knee\b", "the axis"),
        (r"\bthe knee\b", "the axis"),
        (r"\b([Tt]he|[Aa]|level|tilted) (seat|thigh)\b", r"\1 base"),
        (r"\b([Tt]he|[Aa]|this|no|any)( bare| hanging)? leg\b", r"\1\2 rig"),
    )
)


def of_rig(sentence: str) -> str:
    """The same sentence of a rig.

    >>> of_rig("the recording begins as the leg is let go")
    'the recording begins as the rig is let go'
    """
    for of_a_leg, own in OWN:
        sentence = of_a_leg.sub(own, sentence)
    return sentence
