"""What BIDS wants beside the recordings: what the data set is."""

import json
from importlib.metadata import version

VERSION = "1.11.1"  # of BIDS, whose rules are kept
README = """# {name}

Recordings of the movement of lower legs about the knee. Each `_motion.tsv` holds one leg in one
trial: the knee's angle, 0 with the knee extended and the shank level, extension positive, and
the angular velocity where it was measured. `_channels.tsv` names its columns and their units,
`_events.tsv` says where each drop or cycle begins, `_motion.json` how it was recorded;
`acq-left` and `acq-right` tell the side. `participants.tsv` says who the people are, and
`participants.json` the units of its columns.

Whom to ask, how the people were chosen, what they consented to, and under which licence the data
may be used: write it here, and the licence and the authors into `dataset_description.json`.
"""
EVENTS = {
    "trial_type": {
        "Description": "how the leg was moved in this segment",
        "Levels": {
            "passive": "let go, and left to itself",
            "active": "moved by its own muscles",
            "measured": "moved by a torque that was measured",
        },
    },
    "sample": {"Description": "the number of its first row in _motion.tsv, from 0"},
}


def description(name: str) -> str:
    """`dataset_description.json`; licence and authors are for its owner to fill in."""
    document = {
        "Name": name,
        "BIDSVersion": VERSION,
        "DatasetType": "raw",
        "GeneratedBy": [{"Name": "exoid", "Version": version("exoid")}],
    }
    return json.dumps(document, indent=2, ensure_ascii=False) + "\n"


def readme(name: str) -> str:
    return README.format(name=name)


def events() -> str:
    """`task-TASK_events.json`: what the columns of `_events.tsv` mean."""
    return json.dumps(EVENTS, indent=2) + "\n"
