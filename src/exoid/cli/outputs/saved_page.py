"""The page of a saved result, without computing it again."""

from dataclasses import replace
from pathlib import Path, PurePath

from exoid.cli.inputs.reading import take
from exoid.cli.inputs.terms import loaded
from exoid.cli.outputs.origin import origin_of, sha256_of
from exoid.cli.outputs.page import sources_of, write_report
from exoid.cli.outputs.results import sidecar_hash
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently


def retell(paths: list[Path], output: Path, given: list[str], own) -> None:
    """Write what was saved, with its recordings where they are as they were.

    `own` are terms of the user that it may hold.
    """
    check_alone(paths, given)
    (path,) = paths
    saved = patiently(lambda: loaded(path, own), f"reading {path}")
    sources = at_hand(saved, path)
    names = [name_of(each) for each in saved.recordings] or [path.name]
    found = {"told": saved.told, "diagnosis": saved.diagnosis, "plan": saved.plan}
    found["absent"] = () if sources else tuple(names)

    def write(page: Path) -> None:
        origin = saved.origin or origin_of([path], saved.settings)
        write_report(page, sources, saved.result, origin, **found)

    written = Outputs()
    written.put(output, write, "writing the page")
    written.end((saved.diagnosis or saved.result).follows)


def name_of(recording) -> str:
    """Of whom a recording is, where that was told, and the name of its file."""
    from exoid.report.words.person import person

    who = person(recording.get("subject") or {})
    name = PurePath(str(recording["path"])).name
    return f"{who}: {name}" if who else name


def check_alone(paths: list[Path], given: list[str]) -> None:
    """Refuse options that would need computing: a saved result is told as it is."""
    if len(paths) > 1:
        raise ValueError(
            "a saved result (.nc, .json) has a page of its own: name no other file beside it."
        )
    if given:
        raise ValueError(
            f"{paths[0]}: this is shown as it was computed. Leave out {', '.join(given)}, or name "
            "the recordings."
        )


def at_hand(saved, path: Path) -> tuple:
    """The recordings as they were analysed; none where one of their files is not as it was."""
    settings = saved.settings
    dbc = settings.get("dbc")
    each = [(found(Path(str(one["path"])), path), one) for one in saved.recordings]
    changed = [str(place) for place, one in each if not unchanged(place, one)]
    if dbc and not same(Path(dbc), saved.origin and saved.origin.files.get(dbc)):
        changed.append(dbc)
    if changed or not each:
        why = f"{', '.join(changed)} is not there, or has changed" if changed else "it names none"
        say(f"exoid: {path}: without what only the recordings show: {why}.", err=True)
        return ()
    told = {name: settings.get(name) for name in ("flip", "zero", "column", "signal")}
    taken = [take(place, dbc=dbc, **told) for place, _ in each]
    body = {name: settings[name] for name in ("body_mass", "height") if name in settings}
    named = [
        (place.name, replace(one.recording, subject=replace(one.recording.subject, **body)))
        for (place, _), one in zip(each, taken, strict=True)
    ]
    return sources_of(taken, named)


def found(place: Path, beside: Path) -> Path:
    """A recording where it was, or beside the saved result."""
    moved = beside.parent / place.name
    return place if place.is_file() or not moved.is_file() else moved


def unchanged(place: Path, one) -> bool:
    """Are a recording and its sidecar what they were?"""
    return same(place, one["sha256"]) and sidecar_hash(place) == one.get("sidecar_sha256")


def same(place: Path, sha256: str | None) -> bool:
    return place.is_file() and sha256_of(place) == sha256
