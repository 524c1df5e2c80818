"""A study as its two tables tell it: one row per recording, one row per quantity."""

from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from exoid.studies.statistics.tables.frames import Column, Frame

RECORDINGS = ("recording", "name", "participant", "session", "side", "status")
QUANTITIES = ("recording", "participant", "session", "side", "quantity", "value")
WORDS = {  # columns that may be absent, and what is taken instead
    "recordings": ("task", "run", "reason", "duplicate_of", "device"),
    "quantities": ("name", "task", "run", "step", "unit", "determined_by", "note"),
}
# What is asked first where nobody says what: the measure of the pendulum test, and the ratios that
# motion alone tells.
LEADING = (
    "relaxation_index",
    "expected_relaxation_index",
    "damping_over_inertia",
    "stiffness_over_inertia",
    "gravity_over_inertia",
)
# What goes with the height from which an operator lets the leg go: told last.
OF_RELEASE = (
    "first_flexion_amplitude",
    "plateau_amplitude",
    "number_of_oscillations",
    "time_to_rest",
    "peak_flexion_velocity",
    "peak_extension_velocity",
    "peak_flexion_acceleration",
    "peak_extension_acceleration",
    "start_angle",
)
KEYS = ("recording", "name", "participant", "session", "side", "status", "quantity")


@dataclass(frozen=True, eq=False)
class Study:
    """The tables; words that are missing in them are empty."""

    recordings: Frame
    quantities: Frame

    @property
    def once(self) -> Frame:
        """The recordings, without those that are another again."""
        return self.recordings[self.recordings["status"] != "duplicate"]

    @property
    def read(self) -> Frame:
        """Of these, what was read: a step may have failed, then others have told something."""
        once = self.once
        told = self.measured
        samples = once["samples"].notna() if "samples" in once else False
        return once[(once["status"] == "ok") | once["recording"].isin(told) | samples]

    @property
    def measured(self) -> Column:
        """The recordings of which something has a value."""
        return self.quantities.loc[self.quantities["value"].notna(), "recording"]

    @property
    def told(self) -> tuple[str, ...]:
        """The quantities that have values, those that lead first, those of the release last, others
        in the table's order.
        """
        found = self.quantities.loc[self.quantities["value"].notna(), "quantity"].unique()
        return tuple(sorted(found, key=place))

    @property
    def of_legs(self) -> tuple[str, ...]:
        """Of these, what was read off a leg or fitted to it: neither how well a fit follows, nor
        the size of what a diagnosis found here and there.
        """
        rows = self.quantities
        of_leg = (
            (rows["determined_by"] != "") & (rows["step"] != "diagnose") & rows["value"].notna()
        )
        kept = {*rows.loc[of_leg, "quantity"]}
        return tuple(each for each in self.told if each in kept)


def place(quantity: str) -> int:
    """Among those that lead, between, or among those that come last."""
    order = (*LEADING, "", *OF_RELEASE)
    return order.index(quantity if quantity in order else "")


def open_study(folder: str | Path) -> Study:
    """Reads what `exoid study run` wrote.

    **Raises** `ValueError` (what, where, what to do) where that is not what lies there.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise ValueError(f"{folder}: there is no such folder. Name what 'exoid study run' wrote.")
    return study_of(
        read(folder / "recordings.parquet"), read(folder / "quantities.parquet"), str(folder)
    )


def study_of(recordings: Frame, quantities: Frame, where: str = "tables") -> Study:
    """A study of tables that are at hand.

    **Raises** `ValueError` (what, where, what to do) where they lack a column, or hold words where
    numbers belong.
    """
    tables = {"recordings": recordings, "quantities": quantities}
    for (name, table), needed in zip(tables.items(), (RECORDINGS, QUANTITIES), strict=True):
        lacking = [each for each in needed if each not in table]
        if lacking:
            raise ValueError(
                f"{where}: the table of {name} has no column {', '.join(lacking)}. Run 'exoid "
                "study run' again."
            )
        tables[name] = filled(table, WORDS[name])
    tables["quantities"] = with_numbers(tables["quantities"], where)
    return Study(**tables)


def read(path: Path) -> Frame:
    """A table of Parquet."""
    if not path.is_file():
        raise ValueError(
            f"{path.parent}: there is no {path.name} in it. Name the folder that 'exoid study run' "
            "wrote, and let the run end."
        )
    try:
        return pd.read_parquet(path)
    except Exception as fault:  # pyarrow has many
        raise ValueError(
            f"{path}: this is no sound Parquet file. Run 'exoid study run' again."
        ) from fault


def filled(table: Frame, words: tuple[str, ...]) -> Frame:
    """With all columns of words, none of them missing."""
    texts = {
        each: "" if each not in table else as_words(table[each])
        for each in (*words, *KEYS)
        if each in words or each in table
    }
    return table.assign(**texts)


def as_words(column: Column) -> Column:
    """What cells say; nothing where they are empty."""
    return column.astype(object).where(column.notna(), "").map(str)


def with_numbers(quantities: Frame, where: str) -> Frame:
    """Values and errors as numbers; infinite ones are missing."""
    errors = quantities.get("standard_error", pd.Series(float("nan"), quantities.index))
    try:
        each = {
            "value": quantities["value"].astype("float64"),
            "standard_error": errors.astype("float64"),
            "segment": quantities.get("segment", pd.Series(-1, quantities.index)),
        }
    except (ValueError, TypeError) as fault:
        raise ValueError(
            f"{where}: the table of quantities has words where values belong. Run 'exoid study "
            "run' again."
        ) from fault
    infinite = [float("inf"), float("-inf")]
    return quantities.assign(**each).replace({"value": infinite, "standard_error": infinite}, None)
