"""Before and after: held-out segments, predicted without and with what was found."""

from collections.abc import Iterator

from exoid.mismatch.answer.diagnosis import Booked, Diagnosis
from exoid.report.parts.case import Case
from exoid.report.pictures.mismatch.proof import show_proof
from exoid.report.pictures.mismatch.torque import worst
from exoid.report.sections.blocks import Block, some
from exoid.report.sections.section import section
from exoid.report.tables.table import Table
from exoid.report.words.diagnosis.leg import tabled
from exoid.report.words.diagnosis.remainder import remains
from exoid.report.words.text import capital, in_degrees

NOTHING = (
    "Nothing was added to the model. Every segment was predicted from a fit of the others, and "
    "its quarters from each other where there is only one: held-out angle RMSE {0} deg, {1:.1f} "
    "times the noise floor of {2} deg."
)


@section("proof", "Before and after, on held-out data")
def proof(case: Case) -> Iterator[Block]:
    """The proof in a sentence, per segment, and what the baseline had made of the effect."""
    found = case.diagnosis
    if found is None:
        return
    yield sentence(found)
    yield from some([show_proof(found, number) for number in worst(found)])
    yield predicted(found)
    yield booked(tabled(found, found.booked) if found.changed else [])


def sentence(found: Diagnosis) -> str:
    """What the prediction shows."""
    if found.changed:
        return capital(remains(found))
    total, floor = found.proof.before.total, found.proof.noise_floor
    return NOTHING.format(in_degrees(total), total / floor, in_degrees(floor))


def predicted(found: Diagnosis) -> Table:
    """The error of every segment's prediction."""
    before, after = found.proof.before, found.proof.after
    columns = {
        "held-out segment": [each.segment for each in found.location.missing],
        head(found, "without it"): [in_degrees(float(each)) for each in before.rmse],
    }
    if found.changed:
        columns[head(found, "with it")] = [in_degrees(float(each)) for each in after.rmse]
    return Table("How well each segment is predicted by a fit that did not see it", columns)


def head(found: Diagnosis, which: str) -> str:
    return f"RMSE {which} [deg]" if found.changed else "RMSE [deg]"


def booked(each: list[Booked]) -> Table:
    """What the baseline had made of the effect."""
    columns = {
        "quantity": [one.name.replace("_", " ") for one in each],
        "without it": [f"{one.before:.3g}" for one in each],
        "with it": [f"{one.after:.3g}" for one in each],
        "unit": [one.unit for one in each],
    }
    return Table("What the model without it had booked it as", columns)
