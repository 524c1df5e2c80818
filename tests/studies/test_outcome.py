"""What the summary of a run says of recordings that failed."""

import pyarrow as pa

from exoid.studies.engine.outcome import Outcome, outcome

MISSES = "fit: it does not follow the recording: it misses the angle by {} deg"
EMPTY = "line {} is empty"


def of(*reasons: tuple[str, int | None]) -> Outcome:
    """Of failed recordings by their reasons and segments, and one that is ok."""
    rows = [
        {"name": f"{at}.csv", "status": "failed", "reason": said, "segments": n}
        for at, (said, n) in enumerate(reasons)
    ]
    rows.append({"name": "good.csv", "status": "ok", "reason": "", "segments": 1})
    return outcome(pa.Table.from_pylist(rows), ("drops", "fit"), 0, 1.0)


def test_one_cause_is_one_line_whatever_its_numbers_and_details():
    held = MISSES.format(3) + ": held by k_p at its upper limit"
    astray = [*(MISSES.format(n / 7) for n in range(23)), held]
    made = of(*((each, 2) for each in astray), (EMPTY.format(1), None), (EMPTY.format(4), None))
    assert made.reasons == {
        f"0.csv, 1.csv, 2.csv and 21 more, the first of them: {astray[0]}. "
        "Measured nevertheless: drops.": 24,
        "24.csv, 25.csv, the first of them: line 1 is empty.": 2,
    }


def test_it_is_said_of_how_many_other_steps_were_measured():
    both = "drops: no drop is in it. " + MISSES.format(2)
    made = of((MISSES.format(1), 2), (both, 1), ("drops: no drop is in it.", 1), ("empty", None))
    assert (made.ok, made.failed, made.partly) == (1, 4, 2)
    assert [*made.reasons] == [
        f"0.csv: {MISSES.format(1)}. Measured nevertheless: drops.",
        f"1.csv: {both}.",
        "2.csv: drops: no drop is in it. Measured nevertheless: fit.",
        "3.csv: empty.",
    ]
