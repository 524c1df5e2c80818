"""What is wrong with single recordings: what names, sidecars and table say of each."""

from collections import defaultdict
from collections.abc import Iterable
from contextlib import suppress

from exoid.files.visible import visible
from exoid.recordings.sidecar import read_keys
from exoid.studies.dataset.check.finding import Findings, error, warning
from exoid.studies.dataset.check.looked import Looked
from exoid.studies.dataset.check.same_content import same_content
from exoid.studies.dataset.entry import Dataset, Entry
from exoid.studies.dataset.layout import said
from exoid.studies.dataset.motion_bids.labels import label

FIELDS = ("participant", "session", "side")
GYRO_UNREAD = (
    "a column may be a gyro's, by its name or unit, and is not read. Name it in the sidecar, or "
    'for all in defaults.toml: raw_velocity_deg_s = "..." under [columns].'
)
CLOSE = {"body_mass": 0.1, "height": 0.02, "age": 0.1}  # relative; over a study people change


def recordings(dataset: Dataset, looked: list[Looked]) -> Findings:
    """Of every recording by itself, then of those that are one."""
    ids = frozenset(dataset.participants)
    for each in looked:
        if each.fault:
            yield error("unreadable", each.entry.name, each.fault)
        yield from twice_in_name(each.named, ids)
        yield from by_sidecar(each, dataset)
        yield from untold(each.entry)
        if each.facts is not None and each.facts.gyro_unread:
            yield warning("gyro not read", each.entry.name, GYRO_UNREAD)
    yield from unknown_keys(dataset)
    yield from doubled(dataset)
    yield from names_alike(each.named.name for each in looked)
    yield from trials_alike(each.entry for each in looked)


def untold(entry: Entry) -> Findings:
    if not entry.participant:
        says = "tells nobody: put an id into its name (P01_left_1.csv) or its sidecar."
        yield error("of nobody", entry.name, says)
    if not entry.side:
        says = "tells no side: put left or right into its name, or side into its sidecar."
        yield warning("no side", entry.name, says)


def twice_in_name(entry: Entry, ids: frozenset[str]) -> Findings:
    """A folder that says one thing, and a file in it that says another."""
    told: dict[str, dict[str, str]] = defaultdict(dict)
    for each in said(entry.name, ids):
        told[each.field].setdefault(same(each.value), each.value)
    for field in FIELDS:
        values = [*told[field].values()]
        if len(values) > 1:
            both = " and ".join(values)
            says = f"its name tells the {field} twice: {both}. Rename the file or its folder."
            yield error("told twice", entry.name, says)


def by_sidecar(each: Looked, dataset: Dataset) -> Findings:
    """What the sidecar says against its name, and against the table."""
    mine = {"participant": each.subject.id, "session": each.subject.session}
    for field, own in {**mine, "side": each.subject.side}.items():
        other = getattr(each.named, field)
        if own and other and same(own.removeprefix("sub-")) != same(other):
            says = f"its sidecar says {field} {own}, its name {other}. The sidecar's is taken."
            yield error("told twice", each.entry.name, says)
    row = dataset.participants.get(each.entry.participant)
    for name, close in CLOSE.items():
        own, other = getattr(each.subject, name), getattr(row, name, None)
        if own is not None and other is not None and abs(own - other) > close * max(own, other):
            says = f"its sidecar says {name.replace('_', ' ')} {own:g}, the table {other:g}."
            yield error("told twice", each.entry.name, f"{says} Mend one of them.")


def unknown_keys(dataset: Dataset) -> Findings:
    """What a `defaults.toml` says that nothing heeds; one that cannot be read is told of anyway."""
    for path in sorted({path for each in dataset.entries for path in each.defaults}):
        with suppress(ValueError, OSError):
            for note in read_keys(path)[2]:
                where = visible(path.relative_to(dataset.folder).as_posix())
                yield warning("unknown key", where, visible(note.removeprefix(f"{path}: ")))


def same(text: str) -> str:
    """What two writings of one thing share: day 1, Day1."""
    return label(text).casefold() or text


def doubled(dataset: Dataset) -> Findings:
    names = {each.path: each.name for each in dataset.entries}
    for group in same_content(names):
        first, *others = sorted(names[path] for path in group)
        for other in others:
            says = f"holds the same as {first}: it would count twice. Delete one."
            yield error("same recording", other, says)


def names_alike(names: Iterable[str]) -> Findings:
    alike: dict[str, list[str]] = defaultdict(list)
    for name in names:
        alike[name.casefold()].append(name)
    for group in alike.values():
        if len(group) > 1:
            says = "differ by capitals alone: on Windows and macOS one takes the other's place."
            yield warning("names alike", " and ".join(group), says)


def trials_alike(entries: Iterable[Entry]) -> Findings:
    """Recordings that are told to be one and the same trial."""
    alike: dict[tuple[str, ...], list[str]] = defaultdict(list)
    for each in entries:
        if each.participant:
            key = (each.participant, each.session, each.side, each.task, each.run)
            alike[key].append(each.name)
    for first, *others in alike.values():
        for name in others:
            says = f"is of the same person, side, session and run as {first}: which is which?"
            yield warning("one trial", name, f"{says} Number them: run-1, run-2.")
