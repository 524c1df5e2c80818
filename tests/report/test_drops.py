"""The pendulum test shown: a table that fits a terminal, a document, a figure with its marks."""

import json
from dataclasses import replace
from io import StringIO

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from rich.console import Console

from exoid.pendulum.drop import PendulumTest
from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.report.document.drops_json import drops_document
from exoid.report.pictures.drops import index
from exoid.report.plots.drops import plot_drops
from exoid.report.plots.fit import save_figure
from exoid.report.tables.drops import MOST, print_drops
from exoid.report.words.drop import written
from exoid.report.words.typeset import mathtext
from reflexes import CHILD, thrown
from swings import NOISE, Oscillator, drop, recorded


@pytest.fixture(scope="module")
def four():
    """Two drops, one that is cut before rest and carries 1 kg, one voluntary movement."""
    parts = [
        *drop(noise=NOISE).segments,
        *drop(Oscillator(amplitude=0.8), noise=NOISE, seed=1).segments,
        *drop(noise=NOISE, lasting=5.0, seed=2).segments,
        *drop(noise=NOISE, lasting=5.0, seed=3).segments,
    ]
    kinds = ("passive", "passive", "passive", "active")
    subject = Subject(added_mass=(0.0, 0.0, 1.0, 0.0), added_mass_distance=0.4)
    return measure_drops(Recording(tuple(parts), subject, Protocol(kind=kinds)))


def printed(test, width=80):
    stream = StringIO()
    print_drops(test, Console(file=stream, width=width))
    return stream.getvalue()


def test_the_table_has_every_drop_the_average_and_the_reasons(four):
    text = printed(four)
    joined = " ".join(text.split())
    assert max(map(len, text.split("\n"))) <= 80
    assert "…" not in text
    for title in ("Drop of segment 0", "Drop of segment 2, 1 kg added", "Average over drops"):
        assert title in text
    assert "not read: plateau (resting) angle, plateau amplitude, relaxation index" in joined
    assert "cut before rest" in joined
    assert "- 3: a voluntary movement" in joined
    assert "Not in it, with another added mass: segment 2." in joined
    assert "Nothing here is a diagnosis" in joined


def test_of_many_drops_the_average_is_printed_and_not_a_table_of_each(four):
    many = PendulumTest([four.drops[0]] * (MOST + 1), four.average, [])
    text = printed(many)
    assert "Drop of segment" not in text
    assert "Average over drops" in text
    assert f"{MOST + 1} drops were read" in text
    document = drops_document(many, version="0", recordings=[])
    assert len(document["drops"]) == MOST + 1
    assert "Drop of segment" in printed(PendulumTest([four.drops[0]] * MOST, four.average, []))


def test_every_number_in_the_table_has_its_error_and_unit(four):
    rows = [line.split() for line in printed(four).splitlines() if " ± " in line]
    amplitude = next(row for row in rows if row[:3] == ["first", "flexion", "amplitude"])
    half = np.exp(-Oscillator().decrement / 2)
    assert float(amplitude[4]) == pytest.approx(np.degrees(1 + half), abs=0.2)
    assert amplitude[5] == "±"
    assert amplitude[7] == "deg"


def test_drops_from_different_angles_are_averaged_with_a_word():
    high, low = Oscillator(), Oscillator(amplitude=0.8)  # rad above the rest of -1.2

    def averaged(*legs):
        each = [drop(leg, noise=NOISE, seed=n).segments[0] for n, leg in enumerate(legs)]
        return " ".join(printed(measure_drops(Recording(tuple(each)))).split())

    assert "These drops began between -23 and -11 deg" in averaged(high, low)
    assert "grow with the height of the release" in averaged(high, low)
    assert "began between" not in averaged(high, high)


def test_where_no_drop_is_read_there_is_no_error_to_explain():
    held = drop(noise=NOISE).segments[0]
    text = printed(measure_drops(Recording((held,), protocol=Protocol(kind="active"))))
    assert "a voluntary movement" in text
    assert "±" not in text


def test_one_drop_has_no_average():
    assert "Average" not in printed(measure_drops(drop(lasting=5.0)))


def test_the_document_is_json_in_radians_with_reasons_for_what_is_null(four):
    found = drops_document(four, version="0.1.0", recordings=[])
    assert json.loads(json.dumps(found, allow_nan=False)) == found
    first, _, cut, active = found["drops"]
    assert first["measures"]["plateau_angle"]["value"] == pytest.approx(-1.2, abs=0.01)
    assert first["measures"]["plateau_angle"]["unit"] == "rad"
    assert first["measures"]["period"]["marks"][0].keys() == {"sample", "time", "value"}
    assert cut["measures"]["relaxation_index"]["value"] is None
    assert "cut before rest" in cut["measures"]["relaxation_index"]["reason"]
    assert (active["measures"], active["reason"][:11]) == ({}, "a voluntary")
    assert found["average"]["period"]["drops"] == ["0", "1"]
    assert found["left_out_of_average"] == ["2"]


def test_the_figure_marks_the_measures_on_labelled_axes(four):
    figure = plot_drops(four)
    panels = [axes for axes in figure.axes if axes.get_visible()]
    assert len(panels) == 9  # three drops; the voluntary movement is left out
    labels = {axes.get_ylabel() for axes in panels}
    assert {"angle\n[deg]", "angular velocity\n[deg/s]"} < labels
    assert {axes.get_xlabel() for axes in panels[-3:]} <= {"time [s]", ""}
    texts = {text.get_text() for axes in panels for text in axes.texts}
    assert {*map(mathtext, ("A1", "A0", "3 T")), "time to rest"} <= texts
    first = panels[0]
    assert first.get_title(loc="left").startswith("segment 0\nrelaxation index 1.7")
    flexion = next(line for line in first.lines if line.get_label() == "peak of flexion")
    leg = Oscillator()
    peaks = leg.rest - np.exp(-leg.decrement * (np.arange(len(flexion.get_xdata())) + 0.5))
    assert np.sort(flexion.get_ydata()) == pytest.approx(np.degrees(np.sort(peaks)), abs=0.3)


def test_the_title_of_a_drop_that_was_cut_has_the_expected_index_that_the_table_has(four):
    (cut,) = (each for each in four.drops if each.added_mass)
    expected = cut.measures["expected_relaxation_index"].value
    assert cut.measures["relaxation_index"].value is None
    assert index(cut) == f"expected relaxation index {expected:.3f}"
    assert index(four.drops[0]).startswith("relaxation index 1.7")


def test_flexion_and_extension_differ_in_shape_and_in_lightness(four):
    axes = plot_drops(four).axes[0]
    styles = {line.get_label(): line for line in axes.lines}
    flexion, extension = styles["peak of flexion"], styles["peak of extension"]
    assert flexion.get_marker() != extension.get_marker()
    assert to_rgb(flexion.get_color()) != to_rgb(extension.get_color())


def test_the_figure_is_vectors_with_its_fonts(four, tmp_path):
    save_figure(plot_drops(four), tmp_path / "drops.pdf")
    content = (tmp_path / "drops.pdf").read_bytes()
    assert content.startswith(b"%PDF-")
    assert b"/FontFile2" in content
    assert b"/Subtype /Image" not in content


def test_nothing_to_draw_is_said():
    time = np.arange(0, 3, 0.01)
    still = recorded(np.cos(time) - 2.0, time, kind="active")
    with pytest.raises(ValueError, match="no segment could be read as a drop"):
        plot_drops(measure_drops(still))


def test_every_reason_ends_with_one_stop():
    still = drop(Oscillator(amplitude=1e-9))
    text = printed(measure_drops(still))
    assert "nothing moves" in text
    assert ".." not in text


@pytest.mark.parametrize(
    ("number", "error", "said"), [(5.0, 1.0, "5 ± 1"), (5.0, 0.0, "5"), (5.2, 1.0, "5.2 ± 1.0")]
)
def test_a_count_that_noise_may_change_by_one_has_no_decimals(number, error, said):
    assert written("1", number, error) == said


def test_what_an_expected_index_divides_by_is_explained_where_there_is_one(four):
    assert "A_e is the amplitude" in printed(four)
    held = drop(noise=NOISE).segments[0]
    refused = measure_drops(Recording((held,), protocol=Protocol(kind="active")))
    assert "A_e" not in printed(refused)


def test_a_mean_over_first_swings_that_end_otherwise_says_so():
    """Of one leg, two falls that its reflex turns back far enough to end A1, and another."""
    angles = [thrown(CHILD, strength, 100.0) for strength in (1.5, 1.6, 0.8)]
    test = measure_drops(Recording(tuple(angles), protocol=Protocol(kind="passive")))
    joined = " ".join(printed(test).split())
    assert "first turns back, as by a stretch reflex or a stop, in segment 0, 1 (0." in joined
    assert "at its lowest angle in segment 2 (1." in joined
    alike = measure_drops(Recording(tuple(angles[:2]), protocol=Protocol(kind="passive")))
    assert "two kinds of ends" not in printed(alike)


def test_a_drop_whose_swings_shrink_to_another_angle_than_those_of_the_others_is_named():
    """A muscle that lets go later holds it there."""
    angles = (-1.2, -1.2, -1.05, -1.22)
    parts = [drop(Oscillator(rest=each), lasting=3.0, noise=NOISE).segments[0] for each in angles]
    unlike = printed(measure_drops(Recording(tuple(parts), protocol=Protocol(kind="passive"))), 400)
    assert "Swings shrink to -60 deg in segment 2, and to about -69 deg in 0, 1, 3." in unlike
    assert "a muscle or a hand held it" in unlike
    assert "the angle's zero moved" in unlike
    alike = Recording((parts[0], parts[1], parts[3]), protocol=Protocol(kind="passive"))
    assert "Swings shrink to" not in printed(measure_drops(alike), 400)


def test_drops_whose_declared_thigh_lay_otherwise_may_hang_otherwise():
    angles = (-1.2, -1.2, -1.2, -1.45, -1.45, -1.45)
    parts = tuple(
        drop(Oscillator(rest=each), lasting=3.0, noise=NOISE).segments[0] for each in angles
    )
    untold = printed(measure_drops(Recording(parts, protocol=Protocol(kind="passive"))), 400)
    assert "Swings shrink to -69 deg in segment 0" in untold
    assert "in the others" not in untold  # nobody hangs at the middle of both
    tilted = Protocol(kind="passive", thigh_angle=(0.0, 0.0, 0.0, 0.25, 0.25, 0.25))
    assert "Swings shrink to" not in printed(measure_drops(Recording(parts, protocol=tilted)), 400)


def test_a_rig_that_friction_stops_off_its_middle_hangs_as_the_others():
    """Its swings shrink by 8 deg each, to -69 deg, within 4 deg of which it sticks."""

    def stuck(start):
        turns = [start]
        while abs(turns[-1]) > 4.0:
            turns.append(-np.sign(turns[-1]) * (abs(turns[-1]) - 8.0))
        time = np.arange(0.0, 9.0, 0.01)
        number = np.clip((time - 1.0) / 0.5, 0.0, len(turns) - 1 - 1e-9)
        at = number.astype(int)
        ends = np.array(turns)
        middle, half = (ends[at] + ends[at + 1]) / 2, (ends[at] - ends[at + 1]) / 2
        angle = np.radians(-69.0 + middle + half * np.cos(np.pi * (number - at)))
        noisy = angle + NOISE * np.random.default_rng(2).normal(size=time.size)
        return recorded(noisy, time).segments[0]

    parts = tuple(stuck(each) for each in (51.9, 51.7, 51.8, 60.0))
    rests = Recording(parts, Subject(kind="rig"), Protocol(kind="passive"))
    found = measure_drops(rests)
    ends = [each.measures["plateau_angle"].value for each in found.drops]
    assert np.ptp(np.degrees(ends)) > 5.0
    assert "Swings shrink to" not in printed(found, 400)


def test_a_number_stays_on_the_line_of_its_error(four):
    long = replace(four.average["period"], mean=0.5913174, standard_deviation=7.9e-6)
    test = replace(four, average=four.average | {"period": long})
    assert "(5.913174 ± 0.000079)e-1" in printed(test)
