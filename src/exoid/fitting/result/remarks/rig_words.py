"""A rig is called a rig: what is said of legs is said of it in its own word."""

import re

LEG = re.compile(r"\b(the|The|a|A|this|no|any)( bare| hanging)? leg\b")


def of_rig(sentence: str) -> str:
    """The same sentence of a rig.

    >>> of_rig("the recording begins as the leg is let go")
    'the recording begins as the rig is let go'
    """
    return LEG.sub(r"\1\2 rig", sentence)
