"""The figure of a fit: labelled panels for every segment, and files that are whole."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure
from test_fit_json import fitted

from exoid.report.plots import SHOWN, chosen_segments, plot_fit, save_figure

SIGNATURES = {"pdf": b"%PDF-", "svg": b"<?xml", "png": b"\x89PNG"}


def shown(figure):
    return [axes for axes in figure.axes if axes.get_visible() and axes.axison]


def texts(figure):
    return " ".join(
        text.get_text() for text in figure.findobj(lambda each: hasattr(each, "get_text"))
    )


def without_gyro(segment):
    return replace(segment, angular_velocity=None, velocity_rmse=None, velocity_noise=None)


def test_every_segment_has_four_panels_above_the_four_of_the_multistart():
    assert len(shown(plot_fit(fitted()))) == 2 * 4 + 3  # m and l is left out: no mass


def test_axes_carry_units():
    figure = plot_fit(fitted())
    labels = [axes.get_ylabel() for axes in figure.axes] + [
        axes.get_xlabel() for axes in figure.axes
    ]
    labels = [label for label in labels if label]
    assert all("[" in label for label in labels)
    for expected in ("angle\n[deg]", "angular velocity\n[deg/s]", "time [s]"):
        assert expected in labels
    assert "stiffness c [N m/rad]" in labels


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


def test_legend_names_each_thing_once():
    figure = plot_fit(fitted())
    labels = [
        text.get_text()
        for part in figure.subfigs
        for legend in part.legends
        for text in legend.texts
    ]
    assert len(labels) == len(set(labels)) == 7


def test_starts_are_sorted_and_lost_ones_are_counted():
    costs = plot_fit(fitted()).axes[8]
    np.testing.assert_allclose(costs.lines[0].get_ydata(), [1, 1, 1, 60])
    assert costs.get_yscale() == "log"
    assert "1 failed" in costs.get_title(loc="left")


def test_parameter_that_nothing_determines_is_explained_instead_of_drawn():
    assert "mass not determined" in texts(plot_fit(fitted()))


def test_value_at_its_bound_is_drawn_on_it():
    figure = plot_fit(fitted())
    panel = next(axes for axes in figure.axes if axes.get_ylabel().startswith("stiffness"))
    assert any(np.array_equal(line.get_ydata(), [4.0]) for line in panel.lines)


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
    save_figure(plot_fit(fitted()), path)
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
        target.write_bytes(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Figure, "savefig", full)
    with pytest.raises(OSError, match="No space left"):
        save_figure(Figure(), path)
    assert path.read_bytes() == b"precious"
    assert [each.name for each in tmp_path.iterdir()] == ["fit.png"]


def test_missing_folder_for_a_figure_is_named(tmp_path):
    with pytest.raises(ValueError, match=r"absent does not exist\. Make it first"):
        save_figure(Figure(), tmp_path / "absent" / "fit.pdf")
