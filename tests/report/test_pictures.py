"""A picture is drawn twice, for print and for a page: both hold its numbers, and no others."""

from dataclasses import replace
from itertools import chain, pairwise

import numpy as np
import pytest
from diagnosis_by_hand import found, nothing
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PathCollection
from matplotlib.colors import to_rgba
from matplotlib.container import BarContainer, ErrorbarContainer
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from test_plots import fitted, profiled, without_gyro

from exoid.pendulum.drops import measure_drops
from exoid.report.figures.draw import APART_FROM_UNIT
from exoid.report.figures.draw import draw as draw_page
from exoid.report.pictures.determined import shares_of, show_parameters
from exoid.report.pictures.drops import drop_of
from exoid.report.pictures.mismatch.causes import Cause, causes, causes_of, lowest, show_causes
from exoid.report.pictures.mismatch.proof import proof_of
from exoid.report.pictures.mismatch.torque import (
    called_in,
    parting_of,
    plane_of,
    show_plane,
    show_torque,
    torque_of,
)
from exoid.report.pictures.motion import motion_of
from exoid.report.pictures.panel import (
    Band,
    Bars,
    Cloud,
    Line,
    Note,
    Panel,
    Picture,
    Points,
    Rule,
    Span,
)
from exoid.report.pictures.profiles import profile_of
from exoid.report.pictures.role import Role
from exoid.report.pictures.search import costs_of, family_of, pairs_of
from exoid.report.plots.diagnosis import parting, plot_diagnosis
from exoid.report.plots.draw import draw as draw_print
from exoid.report.tables.mismatch.diagnosis import candidates, legend
from exoid.report.words.typeset import with_formulas, with_mathtext
from swings import drop


def panels_of(name: str) -> list[Panel]:
    """Everything of one kind that a report shows."""
    fit, diagnosis = fitted(), found()
    parameters = show_parameters(fit.parameters)
    assert parameters is not None
    return {
        "motion": lambda: [
            *motion_of(fit.segments[0], replace(fit.segments[0], begins=1.0)),
            *motion_of(without_gyro(fit.segments[1]), without_gyro(fit.segments[1])),
            *motion_of(without_gyro(fit.segments[1])),
        ],
        "costs": lambda: [costs_of(fit.multistart)],
        "shares": lambda: [shares_of(fit)],
        "families": lambda: [family_of(fit, pair) for pair in pairs_of(fit)],
        "parameters": lambda: list(parameters.panels),
        "profiles": lambda: [profile_of(each) for each in profiled().values()],
        "drops": lambda: list(drop_of(measure_drops(drop()).drops[0])),
        "torque": lambda: [torque_of(diagnosis.location, 0), plane_of(diagnosis.location)],
        "causes": lambda: [causes_of(diagnosis)],
        "proof": lambda: [proof_of(diagnosis, 0)],
    }[name]()


NAMES = [
    "motion",
    "costs",
    "shares",
    "families",
    "parameters",
    "profiles",
    "drops",
    "torque",
    "causes",
    "proof",
]


def printed(panel: Panel) -> list[tuple]:
    """What matplotlib drew, as the numbers that it holds now."""
    axes = Figure().subplots()
    draw_print(axes, panel)
    clouds = [each for each in axes.collections if isinstance(each, PathCollection)]
    bars = [each for each in axes.containers if isinstance(each, BarContainer)]
    lying = {id(patch) for each in bars for patch in each}
    spans = [p for p in axes.patches if isinstance(p, Rectangle) and id(p) not in lying]
    errors = [each for each in axes.collections if isinstance(each, LineCollection)]
    ended = [each for each in axes.containers if isinstance(each, ErrorbarContainer)]
    caps = {id(cap) for each in ended for cap in each[1]}
    return [
        *(("curve", *each.get_xydata().T) for each in axes.lines if id(each) not in caps),
        *(("cloud", *each.get_offsets().T, each.get_array()) for each in clouds),
        *(("bars", *np.array([bar_of(patch) for patch in each]).T) for each in bars),
        *(("area", *each.get_bbox().intervalx, *each.get_bbox().intervaly) for each in spans),
        *(("error", *np.ptp(segment, axis=0)) for e in errors for segment in e.get_segments()),
        *(("arrow", *each.xyann, *each.xy) for each in axes.texts if is_arrow(each)),
        *(("words", each.get_text()) for each in axes.texts if each.get_text()),
    ]


def bar_of(patch) -> tuple[float, float, float]:
    """Where it begins, its row, its length."""
    return patch.get_x(), patch.get_y() + patch.get_height() / 2, patch.get_width()


def is_arrow(text) -> bool:
    return getattr(text, "arrow_patch", None) is not None


def on_page(panel: Panel) -> list[tuple]:
    """What plotly drew."""
    drawn = draw_page(Picture("one", "", "", (panel,))).drawing
    found: list[tuple] = []
    for each in drawn.data:
        if each.type == "bar":
            begin = np.zeros(len(each.x)) if each.base is None else each.base
            found.append(("bars", begin, each.y, each.x))
            found += [("words", text) for text in each.text or ()]
        elif isinstance(each.marker.color, np.ndarray):
            found.append(("cloud", each.x, each.y, each.marker.color))
        else:
            found.append(("curve", each.x, each.y))
        if each.type != "bar":
            found += [("error", 2 * one, 0.0) for one in each.error_x.array or ()]
            found += [("error", 0.0, 2 * one) for one in each.error_y.array or ()]
    for each in drawn.layout.shapes:
        kind = {"rect": "area", "line": "curve"}[each.type]
        ends = [each.x0, each.x1], [each.y0, each.y1]
        found.append((kind, *ends) if kind == "curve" else (kind, *chain(*ends)))
    for each in drawn.layout.annotations:
        arrow = each.ax is not None
        found.append(("arrow", each.ax, each.ay, each.x, each.y) if arrow else ("words", each.text))
    return found


def expected(panel: Panel, typeset) -> list[tuple]:
    """What the description says."""
    said: list[tuple] = []
    for each in panel.marks:
        if isinstance(each, Line | Points):
            said.append(("curve", each.x, each.y))
        if isinstance(each, Points):
            errors = [(2 * (each.x_error or 0), 0.0), (0.0, 2 * (each.y_error or 0))]
            said += [("error", *pair) for pair in errors if any(pair)] * each.x.size
        if isinstance(each, Cloud):
            said.append(("cloud", each.x, each.y, each.value))
        if isinstance(each, Band):
            across, up = (0.0, 1.0), (each.low, each.high)
            said.append(("area", *((*up, *across) if each.upright else (*across, *up))))
        if isinstance(each, Rule):
            level, whole = [each.at, each.at], [0.0, 1.0]
            said.append(("curve", *((level, whole) if each.upright else (whole, level))))
        if isinstance(each, Bars):
            begin = np.zeros(each.rows.size) if each.begin is None else each.begin
            said.append(("bars", begin, each.rows, each.lengths))
            said += [("words", word) for word in each.words]
        if isinstance(each, Span):
            said += [("arrow", *each.begin, *each.end), ("words", typeset(each.name))]
        if isinstance(each, Note):
            said.append(("words", typeset(each.words)))
    return said + [("words", panel.absent)] * bool(panel.absent)


def same(one: tuple, other: tuple) -> bool:
    """To the digits of float32, which a page keeps."""
    if one[0] != other[0] or len(one) != len(other):
        return False
    if one[0] == "words":
        return one == other
    each = [
        (np.asarray(a, float), np.asarray(b, float))
        for a, b in zip(one[1:], other[1:], strict=True)
    ]
    return all(a.shape == b.shape and np.allclose(a, b, 1e-5, 1e-6) for a, b in each)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    ("drawn", "typeset"),
    [(printed, with_mathtext), (on_page, with_formulas)],
    ids=["print", "page"],
)
def test_a_drawing_holds_what_its_panel_says_and_nothing_else(name, drawn, typeset):
    panels = panels_of(name)
    assert panels
    for panel in panels:
        shown, said = drawn(panel), expected(panel, typeset)
        assert said
        for each in said:
            assert any(same(each, other) for other in shown), each[0]
        assert len(shown) == len(said)


@pytest.mark.parametrize("name", NAMES)
def test_axes_bear_the_same_words_and_limits_in_both(name):
    for panel in panels_of(name):
        axes = Figure().subplots()
        draw_print(axes, panel)
        layout = draw_page(Picture("one", "", "", (panel,))).drawing.layout
        for axis, label, page, seen in (
            (panel.across, axes.get_xlabel(), layout.xaxis, axes.get_xlim()),
            (panel.up, axes.get_ylabel(), layout.yaxis, axes.get_ylim()),
        ):
            assert label == with_mathtext(axis.label)
            title = page.title.text and page.title.text.replace(APART_FROM_UNIT, " ")
            assert page.visible is False or title == with_formulas(axis.label)
            if axis.limits is not None:
                np.testing.assert_allclose(seen, axis.limits)
                limits = np.power(10, page.range) if axis.logarithmic else page.range
                np.testing.assert_allclose(limits, axis.limits)


def test_every_role_that_a_legend_names_has_a_name_of_its_own():
    for name in NAMES:
        for panel in panels_of(name):
            drawn = draw_page(Picture("one", "", "", (panel,))).drawing
            shown = [each.name for each in drawn.data if each.showlegend]
            assert len(shown) == len(set(shown))


def test_what_a_model_left_out_is_drawn_behind_what_it_has():
    segment = fitted().segments[0]
    bare = replace(
        segment,
        simulated_angle=segment.simulated_angle + 0.1,
        simulated_velocity=segment.simulated_velocity + 0.2,
        begins=segment.begins + 0.5,
    )
    angle, residual, velocity, slip = motion_of(segment, bare)
    for panel, role, moved in (
        (angle, Role.SIMULATED_WITHOUT, 0.1),
        (residual, Role.RESIDUAL_WITHOUT, 0.1),
        (velocity, Role.SIMULATED_WITHOUT, 0.2),
        (slip, Role.RESIDUAL_WITHOUT, 0.2),
    ):
        *_, behind, front = panel.of(Line)
        assert behind.role is role
        assert behind.y - front.y == pytest.approx(np.degrees(moved))
        assert behind.x - front.x == pytest.approx(0.5)


@pytest.mark.parametrize(("verdict", "strongest"), [("none", 0), ("cannot_tell", 1)])
def test_nothing_is_strongest_where_nothing_is_missing(verdict, strongest):
    """Noise has a largest value, too, which is no place where anything is missing."""
    one = replace(found(), verdict=verdict, findings=[], reasons=["too short"])
    assert len(one.location.regions) == 1
    figure = plot_diagnosis(one)
    spots = [each for each in figure.findobj(Rectangle) if each.get_label() == "strongest"]
    drawn = torque_of(parting_of(one), 0).marks
    roles = [mark.role for mark in drawn if isinstance(mark, Band)]
    assert roles.count(Role.STRONGEST) == strongest
    assert bool(spots) == bool(strongest)
    assert ("Amber" in show_torque(parting_of(one), 0).caption) == bool(strongest)


def test_torques_are_over_an_inertia_that_nobody_knows():
    one = found()
    inertia = replace(one.before.parameters["inertia"], value=None)
    before = replace(one.before, parameters={**one.before.parameters, "inertia": inertia})
    guess = replace(one, before=before)
    panel = torque_of(parting_of(guess), 0, called_in(guess))
    told = torque_of(parting_of(one), 0, called_in(one))
    assert (panel.up.title, panel.up.unit) == ("missing torque / J", "rad/s^2")
    assert (told.up.title, told.up.unit) == ("missing torque", "N m")
    for over, each in zip(panel.marks, told.marks, strict=True):
        if isinstance(each, Line):
            assert isinstance(over, Line)
            assert over.y == pytest.approx(each.y / one.inertia)
    shown = parting_of(guess), called_in(guess)
    words = [show_torque(shown[0], 0, shown[1]), show_plane(*shown)]
    assert not any("N m" in each.alt + each.caption for each in words)


def test_names_of_three_causes_do_not_run_into_each_other():
    three = ["stretch_reflex", "wobbling_mass", "end_range_stiffening"]
    one = found()
    (pair,) = one.pairs
    both = [replace(pair, terms=[*three[:2], last]) for last in ("polycentric_axis", three[-1])]
    figure = plot_diagnosis(replace(one, pairs=both))
    FigureCanvasAgg(figure).draw()
    (bars,) = (
        one for one in figure.findobj(Axes) if one.get_title(loc="left") == "what explains it"
    )
    boxes = [each.get_window_extent() for each in bars.get_yticklabels()]
    assert sum(each.get_text().count("\n") == 2 for each in bars.get_yticklabels()) == 2
    lower = sorted(boxes, key=lambda box: box.y0)
    assert all(below.y1 <= above.y0 for below, above in pairwise(lower))


def test_a_figure_has_the_causes_of_the_table_with_what_the_table_says_of_them():
    """What was only looked at leaves another amount, and no word of the answer is of it."""
    one = found()
    tried = replace(one.best, terms=["cuff_compliance"], mean_square=0.9, chosen=False)
    drawn = causes(replace(one, pinned=[tried, *one.pinned]))
    table = candidates(one).rows
    assert [each.name.replace(" +\n", " + ") for each in drawn[1:]] == [row[0] for row in table[1:]]
    assert [f"{each.left:.2f}" for each in drawn] == [row[1] for row in table]
    assert [each.chosen for each in drawn] == ["chosen" in row for row in table]


def test_a_figure_without_causes_that_ran_free_has_those_that_were_looked_at():
    drawn = causes(nothing())
    assert [each.left for each in drawn[1:]] == [2.0, 40.0]


def test_where_every_cause_leaves_as_much_as_the_baseline_none_is_said_to_explain_it():
    one = found()
    left = one.baseline.mean_square
    flat = [replace(each, mean_square=0.995 * left) for each in (*one.pairs, *one.singles)]
    as_much = replace(one, pairs=[], singles=flat, best=replace(one.best, mean_square=left))
    assert causes_of(one).title == "what explains it"
    assert causes_of(as_much).title == "no cause leaves less than Eq. 9"


def test_a_cause_that_was_chosen_is_drawn_however_many_seem_better():
    one = found()
    better = [replace(one.best, terms=[f"a{n}"], evidence=6e3 + n, chosen=False) for n in range(9)]
    drawn = causes(replace(one, singles=[*better, *one.singles]))
    assert [each.name for each in drawn if each.chosen] == ["coulomb friction"]


def test_segments_that_are_not_drawn_are_told():
    one = found()
    first = one.location.missing[0]
    many = [replace(first, segment=f"leg {number}") for number in range(5)]
    some = replace(one, location=replace(one.location, missing=many))
    assert "the 4 of 5 segments in which most is missing" in parting(some)
    assert "segments" not in parting(one)


@pytest.mark.parametrize(("verdict", "chosen"), [("mismatch", 1), ("cannot_tell", 0), ("none", 0)])
def test_no_cause_looks_chosen_where_none_is(verdict, chosen):
    one = replace(found(), verdict=verdict)
    assert one.best.chosen
    bars = [each for each in causes_of(one).of(Bars) if each.role is Role.CHOSEN_CAUSE]
    assert sum(len(each.rows) for each in bars) == chosen
    blue = to_rgba(Role.CHOSEN_CAUSE.look.colour)
    drawn = [each.get_facecolor() for each in plot_diagnosis(one).findobj(Rectangle)]
    assert drawn.count(blue) == chosen
    assert sum(row.count("chosen") for row in candidates(one).rows) == chosen
    assert ("chosen" in legend(one)) == bool(chosen)
    assert ("Blue without stripes" in show_causes(one).caption) == bool(chosen)


def test_a_cause_that_leaves_far_less_than_the_noise_has_a_bar():
    """As where noise was taken for larger than it is: the axis began at half of it."""
    rows = [Cause(name, left, False) for name, left in (("", 11.0), ("some", 0.98))]
    assert lowest(rows) == 0.5
    assert 0 < lowest([*rows, Cause("much", 0.002, True)]) < 0.002
    assert lowest([*rows, Cause("all", 0.0, True)]) == 0.5


def test_a_profile_says_what_its_interval_does_not_hold_for_where_the_spring_is_slack():
    known = next(iter(profiled().values()))
    leaning = replace(known, estimate=replace(known.estimate, if_slack=0.097))
    whole = profile_of(known).title
    assert profile_of(leaning).title == f"{whole}\nif slack: ± 0.097 more"
