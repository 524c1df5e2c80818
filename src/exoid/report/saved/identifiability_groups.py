"""What a recording told, as groups of tables for a file, and back."""

import json
from dataclasses import asdict

import numpy as np

from exoid.report.saved.estimate_arrays import Groups, from_table, texts, to_table
from exoid.report.saved.groups import text
from exoid.trust.directions import Direction
from exoid.trust.identifiability import Identifiability
from exoid.trust.reversal import Reversal


def to_told(told: Identifiability) -> Groups:
    """What the recording told; the directions and sentences as JSON."""
    import xarray

    words = {
        "null_directions": text([asdict(each) for each in told.null_directions]),
        "weak_directions": text([asdict(each) for each in told.weak_directions]),
        "reversals": text([asdict(each) for each in told.reversals]),
        "sentences": text(told.sentences),
    }
    shares = {n: ("segment", np.asarray(each)) for n, each in told.segment_shares.items()}
    return {
        "told": xarray.Dataset(
            {"correlation": (("name", "other_name"), told.correlation)},
            coords={"name": texts(told.names)},
            attrs=words,
        ),
        "told_combinations": to_table(told.combinations),
        "told_shares": xarray.Dataset(shares),
    }


def from_told(groups: Groups) -> Identifiability:
    """What `to_told` was given."""
    told = groups["told"]
    words = {name: json.loads(each) for name, each in told.attrs.items()}
    return Identifiability(
        [Direction(**each) for each in words["null_directions"]],
        [Direction(**each) for each in words["weak_directions"]],
        from_table(groups["told_combinations"]),
        told["name"].values.tolist(),
        told["correlation"].values,
        {str(name): each.values for name, each in groups["told_shares"].items()},
        [Reversal(**each) for each in words["reversals"]],
        words["sentences"],
    )
