"""Trials that stand in numbered structs, each with vectors of its own, one below the other."""

import re
from collections import defaultdict
from itertools import chain

import numpy as np

from exoid.recordings.tables.names import called, main_size
from exoid.recordings.tables.sheet import Column

# As trial(3).knee, data.trial3.knee, Trial_03.knee, trials(3).knee.
NUMBERED = re.compile(r"((?:.*\.)?([^.\d]*?))s?[ _]?\(?(\d+)\)?\.([^.]+)")
SEGMENT = "segment"

Trial = dict[str, Column]  # its vectors by the names of its fields


def below_each_other(vectors: list[Column]) -> tuple[list[Column], tuple[str, ...]]:
    """The vectors of trials 1, 2, ... as those of one with segments, and a note of that; as they
    are where there are no two such trials, or more than one kind of them.
    """
    kinds = {stem: each for stem, each in numbered(vectors).items() if len(each) > 1}
    if len(kinds) != 1:
        return vectors, ()
    ((stem, trials),) = kinds.items()
    each = [trials[number] for number in sorted(trials)]
    sizes = [main_size([*one.values()]) for one in each]
    stacked = [
        [one[name] for one in each]
        for name in each[0]
        if [len(one[name].cells) if name in one else 0 for one in each] == sizes
    ]
    columns = [below(stem, parts) for parts in stacked]
    columns.append(Column(SEGMENT, np.repeat(np.arange(len(each), dtype=float), sizes)))
    taken = {id(one) for one in chain(*stacked)}
    rest = [one for one in vectors if id(one) not in taken]
    said = f"{stem} {min(trials)} to {max(trials)}: {len(each)} segments of one recording."
    return [*columns, *rest], (said,)


def below(stem: str, parts: list[Column]) -> Column:
    """The vectors of a field, trial by trial."""
    field = parts[0].name.rpartition(".")[2]
    return Column(f"{stem}.{field}", np.concatenate([one.cells for one in parts]), parts[0].unit)


def numbered(vectors: list[Column]) -> dict[str, dict[int, Trial]]:
    """By what they are called, such as trial or drop, all that are numbered."""
    found: dict[str, dict[int, Trial]] = defaultdict(dict)
    for each in vectors:
        named = NUMBERED.fullmatch(each.name)
        if named is not None and each.numeric and called(named[2], "segment"):
            found[named[1]].setdefault(int(named[3]), {})[named[4]] = each
    return found
