"""What `live` is to follow, by what model, how fast, and until when, as its options say it."""

from math import inf
from pathlib import Path
from typing import Any

HOST, PORT = "127.0.0.1", 8710  # of the page
ALWAYS = ("angle_offset", "gyro_bias", "gyro_scale")  # terms that an estimator has in any case


def check_source(recording: Path | None, channel: str | None, of_bus: dict, of_file: dict) -> None:
    """Refuse no source and two, and options of the other one, which are given by their names.

    **Raises** `ValueError`.
    """
    if (recording is None) == (channel is None):
        both = "both are given" if channel is not None else "neither is given"
        raise ValueError(f"give a recording to follow, or --channel of a bus: {both}.")
    strange = of_file if recording is None else of_bus
    said = [name for name, value in strange.items() if value]
    if said:
        kind = "a recording" if recording is None else "a bus"
        raise ValueError(f"{said[0]} is of {kind}, which is not followed here. Leave it out.")


def page_asked(host: str | None, port: int | None, *, serve: bool) -> tuple[str, int]:
    """Where the page is to be.

    **Raises** `ValueError` where that is said and no page is asked for.
    """
    for name, value in {"--host": host, "--port": port}.items():
        if value is not None and not serve:
            raise ValueError(f"{name} is of the page, which --serve shows: give that, too.")
    return HOST if host is None else host, PORT if port is None else port


def speed_asked(text: str) -> float:
    """How many times as fast as it was; infinite for max.

    **Raises** `ValueError` for anything else.
    """
    try:
        speed = inf if text == "max" else float(text)
        if "_" in text or not speed > 0 or (speed == inf and text != "max"):
            raise ValueError
    except ValueError:
        raise ValueError(f"--speed {text}: give a number such as 1 or 2.5, or max.") from None
    return speed


def followed_terms(chosen: tuple[Any, ...]) -> tuple[type, ...]:
    """The terms that an estimator can follow.

    **Raises** `ValueError` for one with a memory or with values, and for one that it has anyway.
    """
    from exoid.physics.term import name_of

    for each in chosen:
        name = name_of(each if isinstance(each, type) else type(each))
        if not isinstance(each, type):
            raise ValueError(
                f"--with {name}=...: a live estimate begins with what legs have. Name it alone."
            )
        if each.memory_size:
            raise ValueError(
                f"--with {name}: it has a memory of its own, which no live estimate follows yet. "
                "Fit the recording with it: exoid fit --with."
            )
        if name in ALWAYS:
            raise ValueError(f"--with {name}: it is estimated in any case. Leave it out.")
    if chosen:
        from exoid.online.model.unknowns import Unknowns

        Unknowns(chosen)  # which refuses what motion alone does not tell apart
    return chosen


def goals_asked(until: list[str] | None, terms: tuple[type, ...]) -> tuple[Any, ...]:
    """**Raises** `ValueError` where one is none, names no quantity, or is said twice."""
    if not until:
        return ()
    from exoid import online
    from exoid.online.readings import units
    from exoid.recordings.declared.subject import Subject
    from exoid.watching.beside.goals import goal_of
    from exoid.watching.estimate.expect import expected_of, sizes_of
    from exoid.watching.estimate.known import SENSORS

    names = [name for name in units(online.Model(online.Unknowns(terms))) if name not in SENSORS]
    sizes = sizes_of(expected_of(Subject(kind="leg")))
    goals = tuple(goal_of(text, names, sizes) for text in until)
    if len({goal.name for goal in goals}) < len(goals):
        raise ValueError("--until names a quantity twice. Say it once, as it is wanted.")
    return goals
