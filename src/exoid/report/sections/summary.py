"""The whole report on half a page, in plain words."""

from collections.abc import Iterator

from markupsafe import Markup

from exoid.files.counted import counted
from exoid.fitting.result.agreement import of_the_rest
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.residual_remarks import EXPLAINED, slight
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.recordings.conventions.left_out.lost_time import TIME_LOST
from exoid.report.parts.case import Case, Source
from exoid.report.sections.blocks import Block, Group, State, card, element
from exoid.report.sections.parameters import parameters_of
from exoid.report.sections.quality import appraisals
from exoid.report.sections.section import section
from exoid.report.tables.leg import in_print, quantities_of, slack_of
from exoid.report.tables.table import Column, Table
from exoid.report.words.astray import astray
from exoid.report.words.diagnosis import cause, certainty
from exoid.report.words.diagnosis.asserted import only_sensors, only_usual
from exoid.report.words.diagnosis.sentences import alike
from exoid.report.words.diagnosis.verdict import verdict
from exoid.report.words.left_out import first_flexions, left_out
from exoid.report.words.text import capital, in_degrees, in_words

BELIEF = {
    "data": "measured: this recording determines it",
    "prior": "rests on what anatomy expects of this body: use the ratios",
    "both": "partly measured, partly what anatomy expects",
    "bound": "held by a limit: do not use it",
    "fixed by you": "fixed by you: no finding",
    "your bound": "held by a limit of yours: do not use it",
    "your prior": "rests on what you expect",
    "both, your prior": "partly measured, partly what you expect",
    None: "not determined",
}
LOST = "do not use it: the model does not follow the recording"
HOW = Markup("""\
<summary>How to read these numbers</summary>
<p>± is one standard error: the true value lies within twice as much on either side in 19 of 20
recordings, if the model is right. Where the recording shows more than the model has, errors are
widened for it, but no error bar of such a model is complete. <i>If slack</i> is an error more, for
a knee's spring that is slack elsewhere than at full extension, where the recording leaves that
open.</p>
<p>The model is a pendulum with a spring and viscous damping (Eq. 9 of the paper), and the terms
that are listed, if any; what else acts on a leg is missing physics.</p>
<p>Motion alone tells ratios to the inertia <i>J</i>. Mass and distance of its centre can never be
told apart by motion; J can, by a drop with a known mass beside a bare one. Compare legs, days and
sides by the ratios.</p>""")
INCOMPLETE = "measured, but with a model that misses something: ± is not complete"


@section("summary", "Summary")
def summary(case: Case) -> Iterator[Block]:
    """Is the recording whole, does the model follow it, what is missing, and the leg's numbers."""
    asked = () if case.diagnosis is None else (missing(case.diagnosis),)
    read = (recording(case),) if case.sources else ()
    told = (*read, agreement(case))
    if not case.fit.follows or of_the_rest(case.fit.segments, case.fit.disturbance):
        told = (agreement(case), *read)
    yield Group("div", [*told, *asked, numbers(case)], "cards")
    yield believed(case)
    yield element("details", HOW)


def recording(case: Case) -> Group:
    """What there is, and whether it is whole."""
    each = appraisals(case)
    lost = [
        *(line for source in case.sources if source.quality for line in source.quality.losses()),
        *(
            counted(count, noun)
            for noun, count in (
                ("gap", sum(one.gaps for one in each)),
                ("missing sample", sum(one.missing for one in each)),
                ("sample at the gyro's limit", sum(one.saturated or 0 for one in each)),
                ("untimed gap", sum(map(untimed, case.sources))),
            )
            if count
        ),
    ]
    amount = (
        f"{counted(len(each), 'segment')}, {sum(one.samples for one in each)} samples in "
        f"{sum(one.duration for one in each):.1f} s"
    )
    answer = "No, parts of it are missing." if lost else "Yes, nothing is missing in it."
    because = f"{amount}: {'; '.join(lost)}." if lost else f"{amount}."
    whole: State = "good" if case.fit.follows else "open"  # whole it may be, but not good
    return card("Is the recording whole?", "care" if lost else whole, answer, because)


def untimed(source: Source) -> int:
    """In how many segments of a file samples are lost of which its clock does not tell."""
    return sum(TIME_LOST in note for note in source.notes)


def agreement(case: Case) -> Group:
    """How far the simulated leg is from the measured one."""
    fit, because = case.fit, difference(case.fit)
    question = "Does the simulated leg move as the measured one?"
    if not fit.follows:
        return card(
            question,
            "open",
            "No. None of its numbers is shown.",
            sentence(astray(fit, diagnosed=case.diagnosis is not None)),
        )
    partly = of_the_rest(fit.segments, fit.disturbance)
    if partly:
        return card(question, "open", "A part of it only.", sentence(partly[0]))
    if fit.disturbance.cause is None and first_flexions(fit.segments):
        return card(question, "open", "Yes, but for what was left out.", because)
    if fit.disturbance.cause is None:
        return card(question, "good", "Yes, within the noise.", because)
    if little(case):
        answer = "Nearly. What is left is little and has no cause that is known; ± allows for it."
        return card(question, "good", answer, because)
    answer = "Not entirely: something is in the recording that the model does not have."
    return card(question, "care", answer, because)


def difference(fit: FitResult) -> str:
    """How far they are apart, and where nobody compared them."""
    rmse, noise, without = fit.angle_rmse, fit.angle_noise, left_out(fit.segments)
    apart = (
        f"They differ by {in_degrees(rmse)} deg (RMSE of the angle), {rmse / noise:.3g} times the "
        f"noise of the sensor, {in_degrees(noise)} deg."
    )
    return f"Left out: {without}. {apart}" if without else apart


def unnamed(case: Case) -> bool:
    """Does a diagnosis find nothing behind what the fit leaves beyond the noise?"""
    return case.diagnosis is not None and case.diagnosis.verdict == "none"


def little(case: Case) -> bool:
    """Is what the fit leaves beyond the noise without a cause that is known, or too little to
    matter?
    """
    return unnamed(case) or barely(case)


def barely(case: Case) -> bool:
    """Is all that the fit leaves beyond the noise a torque that changes no number, or as the noise
    of a torque sensor makes it?
    """
    gravity = case.fit.ratios["gravity_over_inertia"].value or 0.0
    explained = {"measured"} if any(EXPLAINED in each for each in case.fit.notes) else set()
    each = {kind: one for kind, one in case.fit.disturbance.kinds.items() if one.cause is not None}
    return bool(each) and all(
        kind in explained or slight(one, gravity) for kind, one in each.items()
    )


def misses(case: Case) -> bool:
    """Does the model lack something by which all numbers may be moved?"""
    return case.fit.disturbance.cause is not None and not little(case)


def missing(found: Diagnosis) -> Group:
    """What the diagnosis says."""
    question, answer = "What was the model missing?", verdict(found).rstrip(".") + "."
    if found.verdict == "none":
        return card(question, "good", answer, f"{len(found.pinned)} causes were tested.")
    if found.verdict == "cannot_tell":
        return card(question, "open", answer, sentence("; ".join(found.reasons)))
    before, after = found.proof.before.total, found.proof.after.total
    proof = "Encoder and gyro show it of each other, and the fit takes it into account."
    if not only_sensors(found):
        proof = (
            f"With it, held-out data are predicted to {in_degrees(after)} deg instead of "
            f"{in_degrees(before)} deg."
        )
    effects = [*cause.named(found), *alike(found), *certainty.others(found)]
    state: State = "good" if only_usual(found) else "care"
    return card(question, state, answer, f"{sentence('; '.join(effects))} {proof}".strip())


def numbers(case: Case) -> Group:
    """Whose numbers they are."""
    fit = case.fit
    question = "Which numbers come from this recording?"
    if not fit.follows:
        return card(question, "open", "None that can be used.", sentence(LOST))
    groups: dict[str | None, list[str]] = {}
    for each in every_number(fit).values():
        groups.setdefault(each.determined_by, []).append(each.symbol)
    measured = groups.get("data", [])
    others = [each for source, symbols in groups.items() if source != "data" for each in symbols]
    because = f"Not, or not alone: {', '.join(others)}. " if others else ""
    told = all(each.determined_by == "data" for each in fit.ratios.values())
    whole = not misses(case)
    doubt = "" if whole else "The model misses something, so no error bar is complete."
    answer = f"{', '.join(measured) or 'None'}."
    return card(question, "good" if told and whole else "care", answer, f"{because}{doubt}")


def believed(case: Case) -> Table:
    """Every number, and how far to believe it."""
    fit = case.fit
    quantities = every_number(fit)
    each = list(quantities.values())
    printed = [in_print(one) for one in each]
    belief = BELIEF | {"data": INCOMPLETE} if misses(case) else BELIEF
    belief = belief if fit.follows else dict.fromkeys(BELIEF, LOST)
    columns = {
        "quantity": [in_words(name) for name in quantities],
        "symbol": Column([one.symbol for one in each], symbols=True),
        "value": quantities_of(printed),
        "if slack": slack_of(printed),
        "how far to believe it": [belief[decided(one)] for one in each],
    }
    return Table("The leg in numbers; ± is one standard error", columns)


def every_number(fit: FitResult) -> dict[str, Estimate]:
    """Of the leg and of the terms that are fitted with it."""
    return {**parameters_of(fit), **fit.ratios, **fit.of_terms}


def decided(each: Estimate) -> str | None:
    """Who determined it; the kind of segment that told it is told with the parameters."""
    by_data = each.determined_by == "data" and each.by_hand != "fix"
    return "data" if by_data else each.set_by


def sentence(words: str) -> str:
    """With a capital and a full stop."""
    return words and f"{capital(words.rstrip('.'))}."
