"""The values of one quantity: whose, of which side and day, and how sure each is."""

from dataclasses import dataclass

import numpy as np

from exoid.studies.statistics.tables.frames import Column, Frame, frame_of
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.study import Study

# Who told a value that no recording told: such values compare bodies and settings, not legs.
ELSEWHERE = ("prior", "anatomy", "bound", "fixed", "your")
PARTLY = "both"
PERSONAL = ("age_years", "body_mass_kg", "height_m")
WHOLE = -1  # the segment that is the whole recording
SAME = 1e-9  # relative, of a mean and that of the same drops
FITTED, DIAGNOSED = "fit", "diagnose"
STEPS = (FITTED, "drops", DIAGNOSED)
LEG = ["person", "side"]
OCCASION = [*LEG, "session"]


@dataclass(frozen=True, eq=False)
class Values:
    """`frame` has a row per value: `person`, `side`, `session`, `value`, its standard `error`
    (NaN where unknown), `recording`, and what is known of the person.
    """

    quantity: str
    unit: str
    frame: Frame
    notes: tuple[str, ...] = ()

    @property
    def people(self) -> int:
        return self.frame["person"].nunique()

    def where(self, **chosen: str) -> "Values":
        """Those of a side or a session."""
        kept = self.frame
        for column, name in chosen.items():
            kept = kept[kept[column] == name]
        return Values(self.quantity, self.unit, kept, self.notes)


def values_of(study: Study, quantity: str, task: str = "") -> Values:
    """The values that recordings told, of people who are named, angles in degrees.

    **Raises** `NotTold` (why) where there is none.
    """
    rows = asked_rows(study, quantity, task)
    check_told(rows[rows["value"].notna()])
    named, notes = told_by_recordings(rows[rows["value"].notna()])
    if named.empty:
        raise NotTold(" ".join(notes) or "No recording that was read has a value.")
    units = named["unit"].unique()
    if len(units) > 1:
        raise NotTold(f"{quantity} has several units: {', '.join(units)}. Compare within one.")
    unit, frame = in_degrees(str(units[0]), with_people(once(named), study.recordings))
    return Values(quantity, unit, frame, notes)


def check_told(rows: Frame) -> None:
    """Refuses what most recordings leave to anatomy: those few of which they tell a part are no
    sample of the others, and lie where anatomy has them.
    """
    left = int((~of_recordings(rows)).sum())
    if left > len(rows) / 2:
        raise NotTold(
            f"{left} of {len(rows)} values: no recording told them, or only in part, but anatomy, "
            "a limit or a setting. Nothing is compared: what few recordings tell is no sample of "
            "all. Where it is anatomy, drops with a known mass on the leg tell it."
        )


def of_recordings(rows: Frame) -> Column:
    """Which values recordings told alone."""
    return ~rows["determined_by"].str.startswith((*ELSEWHERE, PARTLY))


def in_degrees(unit: str, frame: Frame) -> tuple[str, Frame]:
    """Angles as they are read; the tables of a run have radians."""
    if not unit.startswith("rad"):
        return unit, frame
    each = {name: np.degrees(frame[name].astype(float)) for name in ("value", "error")}
    return unit.replace("rad", "deg", 1), frame.assign(**each)


def asked_rows(study: Study, quantity: str, task: str = "") -> Frame:
    """The rows of a quantity, those without a value, too. A recording of which one step failed
    has the values of the others; one that is there twice counts once.
    """
    rows = study.quantities
    rows = rows[rows["quantity"] == quantity]
    rows = rows[rows["task"] == task] if task else rows
    return of_one_step(rows[rows["recording"].isin(study.once["recording"])])


def told_by_recordings(rows: Frame) -> tuple[Frame, tuple[str, ...]]:
    """Without those that anatomy or a limit set, and those of nobody; what is left out is said."""
    elsewhere = rows["determined_by"].str.startswith(ELSEWHERE)
    nobody = (rows["participant"] == "") & ~elsewhere
    partly = rows["determined_by"].str.startswith(PARTLY) & ~nobody
    used = ~elsewhere & ~nobody & ~partly
    mended = (rows["step"] == DIAGNOSED) & used
    said = (
        (elsewhere, "left out: no recording told them, but anatomy, a limit or a setting"),
        (nobody, "left out: their recordings name no participant"),
        (partly, "left out: they rest partly on anatomy, which draws people together"),
        (mended, "are of a model with what a diagnosis found missing"),
    )
    notes = (f"{which.sum()} of {len(rows)} values {why}." for which, why in said if which.any())
    return rows[used], tuple(notes)


def once(rows: Frame) -> Frame:
    """Each drop where the value of the recording is the mean of its drops, so that their scatter is
    told; else the value of the recording: of a fit to all of it, or of the drops that count.
    """
    whole = rows["segment"] == WHOLE
    of_recording = rows[whole].groupby("recording")["value"].mean()
    of_drops = rows[~whole].groupby("recording")["value"].mean()
    both = of_recording.reindex(rows["recording"]).to_numpy(float)
    mean = of_drops.reindex(rows["recording"]).to_numpy(float)
    drops = np.isnan(both) | np.isclose(mean, both, rtol=SAME, atol=0.0)
    return rows[np.where(whole, ~drops, drops)]


def of_one_step(rows: Frame) -> Frame:
    """The first of the steps that told it. Of a recording in which a diagnosis found what a fit
    misses, its value, which is of a leg with that, takes the place of the fit's.
    """
    told = rows[rows["value"].notna()]
    steps = [each for each in STEPS if (told["step"] == each).any()]
    if not steps:
        return rows
    found = told.loc[told["step"] == DIAGNOSED, "recording"] if steps[0] == FITTED else ()
    wanted = np.where(rows["recording"].isin(found), DIAGNOSED, steps[0])
    return rows[rows["step"] == wanted]


def with_people(rows: Frame, recordings: Frame) -> Frame:
    """Values beside what is known of their people. An error of 0, as of a count that noise does not
    change, is none: such a value would weigh more than all others.
    """
    known = [each for each in recordings if each.startswith("participant_") or each in PERSONAL]
    people = recordings.drop_duplicates("recording").set_index("recording")[known]
    error = rows["standard_error"].where(rows["standard_error"] > 0)
    told = rows[["recording", "session", "side", "value"]]
    found = told.assign(person=rows["participant"], error=error)
    return found.join(people, on="recording").reset_index(drop=True)


def means(values: Values, over: list[str]) -> Frame:
    """The mean of the drops of each of `over`, its standard `error` by those of the drops, and how
    many `drops` there were.
    """
    grouped = values.frame.groupby(over, sort=True)
    squares = values.frame.assign(square=values.frame["error"] ** 2).groupby(over, sort=True)
    drops = grouped["value"].size()
    error = np.sqrt(squares["square"].sum(skipna=False)) / drops
    return frame_of({"value": grouped["value"].mean(), "error": error, "drops": drops})


def per_person(values: Values) -> Frame:
    """One value for each person: the mean of their sides, each the mean of its days, each the mean
    of its drops; so no leg or day counts more because it has more drops.
    """
    found = means(values, ["person", "side", "session"])
    for level in (["person", "side"], ["person"]):
        grouped = found.groupby(level=level)
        size = grouped["value"].size()
        square = (found["error"] ** 2).groupby(level=level).sum(skipna=False)
        found = frame_of(
            {
                "value": grouped["value"].mean(),
                "error": np.sqrt(square) / size,
                "drops": grouped["drops"].sum(),
            }
        )
    return found
