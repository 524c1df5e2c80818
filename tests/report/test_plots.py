"""The figure of a fit: labelled panels for every segment, what determined the numbers and how
firmly, and files that are whole.
"""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure

from exoid.fitting.errors.profile import Profile
from exoid.fitting.misfit.information import common
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.misfit.uncertainty import HELD, Shares
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult, MultistartReport
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.report.pictures.axis import readable, view
from exoid.report.pictures.determined import SOURCES
from exoid.report.pictures.motion import SHOWN, chosen_segments
from exoid.report.pictures.profiles import digits
from exoid.report.plots.fit import plot_fit, save_figure
from exoid.report.words.astray import WARNING
from exoid.report.words.typeset import mathtext

SIGNATURES = {"pdf": b"%PDF-", "svg": b"<?xml", "png": b"\x89PNG"}
DATA, PRIOR, BOTH = Shares(1.0, 0.0, 0.0), Shares(0.0, 1.0, 0.0), Shares(0.25, 0.65, 0.1)
LEG = {
    "mass": ("m", "kg", None, None, 4.543, 0.454, 2.0, 6.0, None, "motion shows only m l"),
    "inertia": ("J", "kg m^2", 0.45104, 0.0405, 0.446, 0.067, 0.15, 1.0, PRIOR),
    "com_distance": ("l", "m", 0.2659, 0.0151, 0.2663, 0.016, 0.15, 0.6, PRIOR),
    "damping": ("d", "N m s/rad", 0.3508, 0.0315, 0.36, 0.216, 0.0, 60.0, BOTH),
    "stiffness": ("c", "N m/rad", 3.99999, None, 2.9, 1.74, 0.0, 4.0, HELD, "at a bound"),
}
RATIOS = {
    "gravity_over_inertia": ("m l g / J", "1/s^2", 26.188, 0.0023),
    "stiffness_over_inertia": ("c / J", "1/s^2", 8.868, 0.0059),
    "damping_over_inertia": ("d / J", "1/s", 0.7778, 0.00035),
    "torque_over_inertia": ("tau / J", "1/s^2", -21.118, 0.0053),
}
TORQUE = Estimate("tau", "torque", "N m", -9.5, 0.86, lower=-250.0, upper=250.0, shares=BOTH)


def swing(name, kind, torque=None):
    time = np.linspace(0.0, 2.0, 201)
    angle, velocity = -1.0 + np.cos(5 * time), -5 * np.sin(5 * time)
    noise = 1e-3 * np.cos(40 * time)
    return SegmentFit(
        name=name,
        kind=kind,
        period=None if torque is None else 2.0,
        torque_amplitude=torque,
        added_mass=0.0,
        angle_rmse=0.0010,
        velocity_rmse=0.0030,
        angle_noise=0.0008,
        velocity_noise=0.0028,
        time=time,
        angle=angle + noise,
        angular_velocity=velocity + noise,
        simulated_angle=angle,
        simulated_velocity=velocity,
    )


def multistart(loss):
    inertia = np.linspace(0.2, 0.45, 3)
    return MultistartReport(
        starts=loss.size,
        succeeded=int(np.isfinite(loss).sum()),
        at_best=int((loss == loss.min()).sum()),
        loss=loss,
        failures={"its motion could not be simulated": 1},
        family={"inertia": (0.2, 0.45), "stiffness": (1.8, 4.0), "damping": (0.156, 0.351)},
        members={"inertia": inertia, "stiffness": 8.868 * inertia, "damping": 0.7778 * inertia},
        distinct=2,
    )


def fitted():
    """A drop and a cycle: m is not determined, c at its bound, one start worse and one lost."""
    return FitResult(
        parameters={name: Estimate(each[0], name, *each[1:]) for name, each in LEG.items()},
        ratios={
            name: Estimate(each[0], name, *each[1:], shares=DATA) for name, each in RATIOS.items()
        },
        torque_amplitude=TORQUE,
        segments=[swing("leg 0", "passive"), swing("leg 1", "active", TORQUE)],
        mountings=[],
        multistart=multistart(np.array([150.0, 150.0, 150.0, 9000.0, np.inf])),
        loss=151.0,
        disturbance=common(Missed(None, 0.1, 0.0, 1.0, 0.0), ["passive"]),
        torque_frequency="1/T",
        other_reading_rmse=0.075,
        prior="anatomy, table de_leva, 77 kg and 1.8 m",
    )


def agreeing():
    """The same, all starts at the best cost."""
    return replace(fitted(), multistart=multistart(np.full(5, 150.0)))


def profile(name, lower=-1.96, upper=1.96):
    """Of a quantity of `fitted`: a parabola of its error, level beyond a limit that is None."""
    result = fitted()
    known = {**result.parameters, **result.ratios, "torque_amplitude": TORQUE}
    estimate = known[name]
    middle = estimate.expected if estimate.value is None else estimate.value
    error = estimate.standard_error or 0.1 * abs(middle)
    apart = np.linspace(-3.0, 3.0, 13)
    rise = np.where(apart < 0, lower is not None, upper is not None) * apart**2
    ends = [None if end is None else middle + end * error for end in (lower, upper)]
    return Profile(name, estimate, middle + error * apart, rise, *ends)


def profiled():
    """Of every parameter and ratio; m is flat and c has a lower limit only."""
    result = fitted()
    names = [*result.parameters, "torque_amplitude", *result.ratios]
    flat, above = profile("mass", None, None), profile("stiffness", upper=None)
    return {name: profile(name) for name in names} | {"mass": flat, "stiffness": above}


def shown(figure):
    return [axes for axes in figure.axes if axes.get_visible() and axes.axison]


def panel(figure, beginning):
    """The panel whose title, or else x label, begins so."""
    titled = [axes for axes in figure.axes if axes.get_title(loc="left").startswith(beginning)]
    return (titled or [a for a in figure.axes if a.get_xlabel().startswith(beginning)])[0]


def texts(figure):
    return " ".join(
        text.get_text() for text in figure.findobj(lambda each: hasattr(each, "get_text"))
    )


def without_gyro(segment):
    return replace(segment, angular_velocity=None, velocity_rmse=None, velocity_noise=None)


def test_every_segment_has_four_panels_above_what_determined_the_numbers():
    assert len(shown(plot_fit(agreeing()))) == 2 * 4 + 3  # m and l is left out: no mass


def test_waterfall_is_drawn_only_where_costs_differ():
    assert "cost / best cost [-]" in texts(plot_fit(fitted()))
    assert "cost / best cost [-]" not in texts(plot_fit(agreeing()))
    assert "5 of 5 starts at the best cost,\n0 failed" in texts(plot_fit(agreeing()))


def test_axes_carry_units():
    figure = plot_fit(fitted(), profiled())
    labels = [axes.get_ylabel() for axes in figure.axes] + [
        axes.get_xlabel() for axes in figure.axes
    ]
    labels = [label for label in labels if label]
    assert all("[" in label for label in labels)
    for expected in ("angle\n[deg]", "angular velocity\n[deg/s]", "time [s]"):
        assert expected in labels
    assert "stiffness $c$ [N m/rad]" in labels


def test_panels_show_degrees_and_their_rmse():
    result = fitted()
    angle, residual = plot_fit(result).axes[0], plot_fit(result).axes[2]
    measured, simulated = angle.lines
    np.testing.assert_allclose(measured.get_ydata(), np.degrees(result.segments[0].angle))
    np.testing.assert_allclose(
        simulated.get_ydata(), np.degrees(result.segments[0].simulated_angle)
    )
    assert measured.get_linestyle() != simulated.get_linestyle()
    assert "RMSE 0.0573 deg" in angle.get_title(loc="left")
    band = residual.patches[0].get_extents().transformed(residual.transData.inverted())
    assert band.height == pytest.approx(4 * np.degrees(result.segments[0].angle_noise))


def test_what_was_averaged_over_segments_is_not_called_undetermined():
    result = agreeing()
    ratios = {name: replace(each, shares=None) for name, each in result.ratios.items()}
    bars = panel(plot_fit(replace(result, ratios=ratios)), "share of the precision")
    said = [label.get_text() for label in bars.texts]
    assert said.count("mean of the segments") == len(ratios)
    assert said.count("not determined") == 1


def test_legends_name_each_thing_once():
    figure = plot_fit(fitted(), profiled())
    for part in figure.subfigs:
        labels = [text.get_text() for legend in part.legends for text in legend.texts]
        assert len(labels) == len(set(labels)) >= 4


def test_starts_are_sorted_and_lost_ones_are_counted():
    costs = panel(plot_fit(fitted()), "3 of 5 starts")
    np.testing.assert_allclose(costs.lines[0].get_ydata(), [1, 1, 1, 60])
    assert costs.get_yscale() == "log"
    assert "1 failed" in costs.get_title(loc="left")


def test_shares_of_every_determined_quantity_fill_its_bar():
    result = agreeing()
    bars = panel(plot_fit(result), "share of the precision")
    data, prior, bound = bars.containers
    ends = [one.get_x() + one.get_width() for one in bound]
    known = [row != 0 for row in range(len(ends))]  # of the mass nothing is known
    np.testing.assert_allclose(ends, known)
    row = list(LEG).index("damping")
    widths = [source[row].get_width() for source in (data, prior, bound)]
    np.testing.assert_allclose(widths, [BOTH.data, BOTH.prior, BOTH.bound])
    assert [label.get_text() for label in bars.texts] == ["not determined"]
    symbols = [mathtext(each[0]) for each in (*LEG.values(), ("tau",), *RATIOS.values())]
    assert [label.get_text() for label in bars.get_yticklabels()] == symbols


def test_shares_are_told_apart_without_colour():
    hatches = [role.look.hatch for role in SOURCES.values()]
    assert len(set(hatches)) == len(hatches)


def test_shaded_interval_is_that_of_the_profile():
    each = profile("inertia")
    axes = panel(plot_fit(fitted(), {"inertia": each}), "inertia $J$\n0.451")
    (shaded,) = axes.patches
    ends = shaded.get_x(), shaded.get_x() + shaded.get_width()
    np.testing.assert_allclose(ends, (each.lower, each.upper))


def test_without_a_lower_limit_all_smaller_values_are_shaded():
    each = profile("damping", lower=None)
    axes = panel(plot_fit(fitted(), {"damping": each}), "damping $d$\n")
    (shaded,) = axes.patches
    ends = shaded.get_x(), shaded.get_x() + shaded.get_width()
    np.testing.assert_allclose(ends, (each.value[0], each.upper))
    assert "upper limit only: 0.413" in axes.get_title(loc="left")


def test_profile_of_a_quadratic_loss_lies_on_the_parabola_of_its_error():
    axes = panel(plot_fit(fitted(), profiled()), "com distance $l$\n")
    curves = {line.get_label(): line for line in axes.lines}
    parabola = curves["parabola of the standard error"]
    drawn = curves["profile (all else refitted)"]
    expected = np.interp(drawn.get_xdata(), *parabola.get_data())
    np.testing.assert_allclose(drawn.get_ydata(), expected, atol=0.01)  # of 101 chords


@pytest.mark.parametrize(
    ("end", "width", "words"),
    [
        (0.42004349, 1.7e-4, "0.42004"),
        (-17.128, 9.0, "-17.1"),
        (312.0, 40.0, "312"),
        (-8.7e-6, 5.1e-6, "-8.7e-06"),
        (1.50e-7, 2e-9, "1.5e-07"),
    ],
)
def test_ends_are_written_to_the_second_digit_of_the_interval(end, width, words):
    assert digits(end, width) == words


def test_flat_profile_is_named_flat_and_has_no_parabola():
    axes = panel(plot_fit(fitted(), profiled()), "mass $m$\n")
    assert axes.get_title(loc="left").endswith("not determined\nflat: nothing tells")
    assert "parabola of the standard error" not in [line.get_label() for line in axes.lines]


def test_flat_profile_of_a_quantity_with_an_error_is_not_said_to_be_untold():
    axes = panel(plot_fit(fitted(), {"inertia": profile("inertia", None, None)}), "inertia $J$\n0")
    assert axes.get_title(loc="left").endswith("flat as far as was looked")


def test_narrow_profile_is_drawn_as_deviation_from_its_value():
    axes = panel(plot_fit(fitted(), profiled()), f"{mathtext('m l g / J')}\n")
    assert axes.get_xlabel() == f"{mathtext('m l g / J')} - 26.1880 [1e-3 1/s²]"
    low, high = axes.get_xlim()
    assert -10 < low < -6.9
    assert 6.9 < high < 10


def test_expectation_far_outside_the_profile_is_given_in_words():
    each = profile("stiffness")
    narrow = replace(each, value=4 + (each.value - 4) / 100, lower=3.99, upper=4.01)
    assert "← expected 2.9" in texts(plot_fit(fitted(), {"stiffness": narrow}))


@pytest.mark.parametrize(
    ("low", "high", "label"),
    [
        (0.3, 0.5, "J [kg m^2]"),
        (0.4199, 0.4205, "J - 0.42020 [1e-4 kg m^2]"),
        (1e-5, 3e-5, "J [1e-5 kg m^2]"),
        (-7.003, -6.997, "J + 7.0000 [1e-3 kg m^2]"),
        (0.0, 0.0, "J [kg m^2]"),
    ],
)
def test_label_tells_the_origin_and_the_power_of_ten(low, high, label):
    assert readable((low, high), (low + high) / 2).axis("J", "kg m^2", (low, high)).label == label


def test_scale_is_what_its_label_says():
    scale = readable((0.4199, 0.4205), 0.4202)
    np.testing.assert_allclose(0.42020 + 1e-4 * scale.of([0.4199, 0.4205]), [0.4199, 0.4205])


def test_view_holds_what_is_needed_and_at_most_three_times_that():
    low, high = view([1.0, 2.0], np.array([-50.0, 1.5, 2.2]))
    assert low < 1.0
    assert high > 2.2
    assert high - low < 3 * 1.2  # and margins


def test_a_family_of_legs_eight_times_as_heavy_is_in_the_figure():
    """Motion alone leaves m open by that: a figure of it that leaves most of it out says little."""
    result = agreeing()
    far = {name: np.append(each, 8 * each) for name, each in result.multistart.members.items()}
    figure = plot_fit(replace(result, multistart=replace(result.multistart, members=far)))
    axes = panel(figure, "$J$ and $d$")
    assert axes.get_xlim()[1] > far["inertia"].max()
    assert axes.get_ylim()[1] > far["damping"].max()


def test_members_far_away_are_counted_instead_of_shown():
    result = agreeing()
    far = {name: np.append(each, 100.0) for name, each in result.multistart.members.items()}
    figure = plot_fit(replace(result, multistart=replace(result.multistart, members=far)))
    axes = panel(figure, "$J$ and $d$ (1 set outside)")
    assert axes.get_xlim()[0] < 0.446 - 0.067
    assert 0.45104 + 0.0405 < axes.get_xlim()[1] < 10.0
    assert axes.get_ylim()[0] < 0.36 - 0.216
    assert 0.36 + 0.216 < axes.get_ylim()[1] < 20.0


def test_nothing_determined_is_drawn_all_the_same(tmp_path):
    result = agreeing()
    nothing = {
        name: replace(each, value=None, standard_error=None, expected=None, shares=None)
        for name, each in result.parameters.items()
    }
    lost = replace(result.multistart, members={}, loss=np.full(5, np.inf), succeeded=0, at_best=0)
    empty = replace(result, parameters=nothing, multistart=lost)
    curves = {name: replace(profile(name, None, None), estimate=nothing[name]) for name in nothing}
    figure = plot_fit(empty, curves)
    save_figure(figure, tmp_path / "fit.png")
    assert texts(figure).count("flat: nothing tells") == len(nothing)


def test_parameter_that_nothing_determines_is_explained_instead_of_drawn():
    assert "mass not determined" in texts(plot_fit(fitted()))


def test_value_at_its_bound_is_drawn_on_it():
    figure = plot_fit(fitted())
    pair = next(axes for axes in figure.axes if axes.get_ylabel().startswith("stiffness"))
    assert any(np.array_equal(line.get_ydata(), [4.0]) for line in pair.lines)


def test_recordings_without_gyro_have_no_velocity_residual():
    result = fitted()
    bare = replace(result, segments=[without_gyro(each) for each in result.segments])
    assert "[deg/s]" in texts(plot_fit(bare))
    assert "residual\n[deg/s]" not in texts(plot_fit(bare))


def test_segment_without_gyro_beside_one_with_it_says_so():
    result = fitted()
    mixed = [result.segments[0], without_gyro(result.segments[1])]
    assert "not measured" in texts(plot_fit(replace(result, segments=mixed)))


def test_of_too_many_segments_the_worst_are_shown_in_their_order():
    result = fitted()
    many = [
        replace(result.segments[0], name=f"leg {number}", angle_rmse=1e-3 * (number % 7))
        for number in range(40)
    ]
    crowd = replace(result, segments=many)
    chosen = chosen_segments(crowd)
    assert len(chosen) == SHOWN
    assert min(each.angle_rmse for each in chosen) >= 4e-3
    numbers = [int(each.name.split()[1]) for each in chosen]
    assert numbers == sorted(numbers)
    assert f"The {SHOWN} of 40 segments with the largest RMSE" in texts(plot_fit(crowd))


@pytest.mark.parametrize("kind", SIGNATURES)
def test_figure_is_saved_in_the_format_of_its_name(kind, tmp_path):
    path = tmp_path / f"fit.{kind}"
    save_figure(plot_fit(fitted(), profiled()), path)
    assert path.read_bytes().startswith(SIGNATURES[kind])
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_fonts_are_embedded_as_truetype(tmp_path):
    figure = Figure()
    figure.text(0.5, 0.5, "angle")
    save_figure(figure, tmp_path / "fit.pdf")
    content = (tmp_path / "fit.pdf").read_bytes()
    assert b"/FontFile2" in content
    assert b"/Type3" not in content


@pytest.mark.parametrize("name", ["fit.jpg", "fit", "fit.pdf.exe"])
def test_other_suffix_is_refused(name, tmp_path):
    with pytest.raises(ValueError, match=r"ends in \.pdf, \.svg or \.png"):
        save_figure(Figure(), tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_existing_figure_survives_a_failing_save(tmp_path, monkeypatch):
    path = tmp_path / "fit.png"
    path.write_bytes(b"precious")

    def full(self, target, **_):
        target.write(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Figure, "savefig", full)
    with pytest.raises(OSError, match="No space left"):
        save_figure(Figure(), path)
    assert path.read_bytes() == b"precious"
    assert [each.name for each in tmp_path.iterdir()] == ["fit.png"]


def test_missing_folder_for_a_figure_is_named(tmp_path):
    with pytest.raises(ValueError, match=r"absent does not exist\. Make it first"):
        save_figure(Figure(), tmp_path / "absent" / "fit.pdf")


def test_a_figure_of_a_fit_that_does_not_follow_says_so_and_shows_no_intervals():
    """A figure is pasted into a file without the words of the terminal."""
    lost = replace(fitted(), astray="it misses the angle by 3 deg")
    assert WARNING in texts(plot_fit(lost, profiled()))
    assert WARNING not in texts(plot_fit(fitted(), profiled()))
    assert "95 %" not in texts(plot_fit(lost, profiled()))
