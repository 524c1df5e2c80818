"""The tables of a fit: parameters, ratios, what recordings owned, segments."""

from dataclasses import replace
from math import degrees

from exoid.fitting.result.chief import chief
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.fitting.result.summary import quantities
from exoid.report.tables.table import Column, Table, with_unit
from exoid.report.words.estimate import if_slack, written
from exoid.report.words.text import in_degrees, in_words, quantity_words, with_error

BAR = 5  # blocks of a bar of shares
DATA, PRIOR, BOUND = "█", "▒", "░"
MOUNTED = {
    "added_mass_distance": "added mass at r",
    "added_mass": "added mass",
    "added_mass_gyration": "its radius of gyration",
    "zero": "encoder zero",
    "tilt": "tilt of the thigh",
    "gyro_scale": "gyro scale - 1",
    "gyro_bias": "gyro bias",
    "clock": "clock - 1",
    "torque_zero": "torque sensor's zero",
    "torque_gain": "torque sensor's gain - 1",
    "damping_under_load": "damping under its load - 1",
    "stiffness_under_load": "stiffness under its load - 1",
    "distance_apart": "masses apart, log r",
    "extent_apart": "masses apart, k^2",
}
SHORTEST_NAME = 16  # that still tells the segments of two recordings apart


def parameters(known: dict[str, Estimate]) -> Table:
    """(m, J, l, d, c) with what was expected, what was allowed and who decided."""
    each = list(known.values())
    short = [name.removesuffix("_moment") for name in known]  # m l g says what it is
    named = [f"{name} {one.symbol}" for name, one in zip(short, each, strict=True)]
    expected, allowed = [expectation(one) for one in each], [bounds(one) for one in each]
    said = [in_words(name) for name in known]
    columns = {
        "parameter": Column(named, on_page=said, spare=1, brief=short),
        "symbol": Column([one.symbol for one in each], symbols=True, only="page"),
        "value": quantities_of(each),
        "if slack": slack_of(each),
        "expected": Column(expected, on_page=behind(expected, each)),
        "bounds": Column(allowed, on_page=behind(allowed, each), spare=2),
        "set by": set_by(each),
    }
    return Table("Parameters of the leg; ± is one standard error", columns, "Parameters")


def ratios(result: FitResult) -> Table:
    """What the motion alone determines."""
    each = list(result.ratios.values())
    columns = {
        "ratio": Column(list(result.ratios), on_page=[one.title for one in each]),
        "symbol": Column([one.symbol for one in each], symbols=True, head=""),
        "value": quantities_of(each),
        "if slack": slack_of(each),
        "set by": replace(set_by(each), spare=2, brief=[one.set_by or "" for one in each]),
        "limited by": Column([limited_by(one) for one in each], spare=1),  # a note says it, too
    }
    caption = "Ratios to the inertia: what motion alone can tell"
    return Table(caption, columns, "Ratios to the inertia, what motion can tell")


def terms(result: FitResult) -> Table:
    """What the model has beside Eq. 9, and of it what motion alone tells."""
    rows = [
        (in_words(term), in_print(each))
        for term, own in result.terms.items()
        for each in own.values()
    ]
    each = [one for _, one in rows]
    columns = {
        "term": [term for term, _ in rows],
        "parameter": Column([one.title for one in each], head="", spare=1),
        "symbol": Column([one.symbol for one in each], symbols=True, head=" "),
        "value": quantities_of(each),
        "if slack": slack_of(each),
        "set by": replace(set_by(each), spare=2, brief=[one.set_by or "" for one in each]),
    }
    return Table("Terms: what the model has beside Eq. 9", columns, "Terms, beside Eq. 9")


def before_and_after(before: FitResult, after: FitResult) -> Table:
    """Every number of the model with what was found, beside that of an Eq. 9 that follows."""
    old, new = quantities(before), quantities(after)
    each = [in_print(one) for one in new.values()]
    known = old if before.follows else {}
    alone = [written(in_print(known[name])) if name in known else "" for name in new]
    named, symbols = [quantity_words(name) for name in new], [one.symbol for one in each]
    columns = {
        "quantity": Column(named, spare=2, brief=symbols),
        "symbol": Column(symbols, symbols=True, head="", spare=3),
        "with it": quantities_of(each),
        "Eq. 9 alone": Column(alone, on_page=behind(alone, each), spare=1),
        "set by": [one.set_by or "" for one in each],
    }
    return Table("The leg with what was found", columns, "The leg, with what was found")


def mountings(result: FitResult) -> Table:
    """What every recording owned, where there was something to estimate; of segments that were
    fitted alone, what each of them took it for.
    """
    rows = [
        (mounting.recording, MOUNTED[name], in_print(each))
        for mounting in result.mountings
        for name, each in mounting.known.items()
    ]
    owner = "segment" if result.model is None else "recording"
    several = len(result.mountings) > 1
    named = Column([name for name, *_ in rows], shortest=SHORTEST_NAME)
    columns = {
        **({owner: named} if several else {}),
        "quantity": Column([name for _, name, _ in rows], head=""),
        "value": quantities_of([each for *_, each in rows]),
        "if slack": slack_of([each for *_, each in rows]),
    }
    caption = "Sensors, seat and added mass, against what is declared of them"
    return Table(caption, columns, f"Mounting, of each {owner}" if several else "Mounting")


def segments(each: list[SegmentFit]) -> Table:
    """How far simulation and measurement are apart, beside the noise."""
    speed = ["" if one.velocity_rmse is None else in_degrees(one.velocity_rmse) for one in each]
    times = [f"{one.angle_rmse / one.angle_noise:.3g}" for one in each]
    period = ["" if one.period is None else f"{one.period:.4g}" for one in each]
    added = [f"{one.added_mass:.3g}" if one.added_mass else "" for one in each]
    angle = [in_degrees(one.angle_rmse) for one in each]
    noise = [in_degrees(one.angle_noise) for one in each]
    until = ["" if one.caught is None else f"{one.caught:.2f}" for one in each]
    columns = {
        "segment": Column([one.name for one in each], shortest=SHORTEST_NAME),
        "kind": [one.kind for one in each],
        "from [s]": Column([f"{one.begins:.2f}" for one in each], head="from\n[s]"),
        "to [s]": Column(until, head="to\n[s]"),
        "period T [s]": Column(period, head="T [s]"),
        "torque tau [N m]": Column([torque(one) for one in each], head="tau [N m]"),
        "added mass [kg]": Column(added, head="added\n[kg]"),
        "angle RMSE [deg]": Column(angle, head="RMSE\n[deg]"),
        "noise [deg]": Column(noise, head="noise\n[deg]", only="terminal"),
        "times the noise": Column(times, only="page"),
        "velocity RMSE [deg/s]": Column(speed, only="page"),
    }
    return Table("How far measured and simulated are apart", columns, "Segments")


def quantities_of(each: list[Estimate]) -> Column:
    """Values with their errors and units."""
    return Column([written(one) for one in each], units=[one.unit for one in each])


def slack_of(each: list[Estimate]) -> Column:
    """What is open for where the spring is slack, beside values with their units."""
    cells = [if_slack(one) for one in each]
    return Column(cells, on_page=behind(cells, each))


def behind(cells: list[str], each: list[Estimate]) -> list[str]:
    """With the units of these quantities."""
    return [with_unit(cell, one.unit) for cell, one in zip(cells, each, strict=True)]


def in_print(each: Estimate) -> Estimate:
    """Angles and rates in degrees."""
    if each.unit not in ("rad", "rad/s"):
        return each
    value, error, open_ = (
        None if one is None else degrees(1) * one
        for one in (each.value, each.standard_error, each.if_slack)
    )
    unit = each.unit.replace("rad", "deg")
    return replace(each, value=value, standard_error=error, unit=unit, if_slack=open_)


def set_by(each: list[Estimate]) -> Column:
    """Who made the errors as small as they are."""
    return Column([bar(one) for one in each], on_page=[parts(one) for one in each])


def bar(each: Estimate) -> str:
    """A bar of the shares, and the word for them: of data, the kind of segment that told it."""
    if each.shares is None:
        return ""
    data = round(BAR * each.shares.data)
    bound = round(BAR * each.shares.bound)
    return f"{DATA * data + PRIOR * (BAR - data - bound) + BOUND * bound} {each.set_by}"


def parts(each: Estimate) -> str:
    """The parts of the precision in words, the largest first."""
    if each.shares is None:
        return "nothing"
    if each.by_hand == "fix":
        return str(each.set_by)
    shares = {source: getattr(each.shares, source) for source in ("data", "prior", "bound")}
    kind = each.shares.kind
    said = [
        f"{source}{f' ({kind})' if kind and source == 'data' else ''} {part:.0%}"
        for source, part in sorted(shares.items(), key=lambda item: -item[1])
        if round(part, 2) > 0
    ]
    yours = [] if each.determined_by in ("data", each.set_by) else [str(each.set_by)]
    return ": ".join([*yours, ", ".join(said)])


def limited_by(each: Estimate) -> str:
    """What limits a number most, and its part of the variance."""
    most = chief(each) if each.standard_error else None
    return "" if most is None else f"{in_words(most[0])} {most[1]:.0%}"


def expectation(each: Estimate) -> str:
    """expected ± standard deviation."""
    if each.expected is None:
        return ""
    if each.expected_deviation is None:
        return f"{each.expected:.4g}"
    return with_error(each.expected, each.expected_deviation)


def bounds(each: Estimate) -> str:
    """lower..upper; one-sided where only one is known."""
    if each.lower is None:
        return "" if each.upper is None else f"≤ {each.upper:.4g}"
    return f"≥ {each.lower:.4g}" if each.upper is None else f"{each.lower:.4g}..{each.upper:.4g}"


def torque(each: SegmentFit) -> str:
    """The torque amplitude of a segment, empty where no voluntary torque acts."""
    return "" if each.torque_amplitude is None else written(each.torque_amplitude)
