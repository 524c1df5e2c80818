"""Recordings that hold the same as another: whose, and what nobody can know of them."""

from exoid.studies.statistics.tables.frames import Frame

NAMED = 5  # of them; the others are counted


def copies(recordings: Frame) -> list[str]:
    """Which file is as which other, and where two people are named, that one of them is wrong."""
    again = recordings[recordings["status"] == "duplicate"]
    person = recordings.drop_duplicates("name").set_index("name")["participant"]
    first = again[["name", "participant", "duplicate_of"]].head(NAMED).to_numpy(str)
    said = [copy(name, whose, other, person.get(other, "")) for name, whose, other in first]
    more = len(again) - NAMED
    return [*said, *([f"{more} more recordings are the same as another."] if more > 0 else [])]


def copy(name: str, person: str, other: str, of: str) -> str:
    """One of them."""
    said = f"{name} holds the same as {other or 'another'}, and counts once, as that one"
    if not of or not person or person == of:
        return f"{said}."
    return (
        f"{said}: which of two people it truly is, {of} or {person}, nobody knows from the files. "
        f"{person} has no value of it, and {of} may have a wrong one."
    )
