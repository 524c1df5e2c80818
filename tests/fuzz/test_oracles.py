"""The oracles are of another hand, and agree where nothing is damaged."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.fuzz import judge
from tests.fuzz.archives import c3d_samples
from tests.fuzz.judge import NAMES, format_of
from tests.fuzz.mdf import frames_by_mdfreader
from tests.fuzz.opensim import below_header, opensim_samples
from tests.fuzz.others import channels_by_c3d
from tests.fuzz.reading import Sample, Unread, alike
from tests.fuzz.tables import DIALECTS, TIME, by_csv, dialect_table, own_by_csv, read_own

numbers = st.floats(-1e6, 1e6, allow_subnormal=False).map(lambda each: round(each, 4))
motions = st.lists(st.tuples(numbers, numbers), min_size=4, max_size=12)


@given(motions, st.sampled_from([*DIALECTS]))
def test_a_table_in_any_dialect_holds_what_the_csv_module_reads(tmp_path_factory, rows, told):
    path = tmp_path_factory.mktemp("dialect") / "leg.csv"
    time, (angle, gyro) = np.arange(len(rows)) * 0.01, np.array(rows).T
    path.write_bytes(dialect_table(told, time, angle % 90 + 10, gyro % 90 + 10))
    assert alike(read_own(path).rows, by_csv(path, Sample(b"", told)))


@given(motions)
def test_an_own_table_holds_what_the_csv_module_reads(tmp_path_factory, rows):
    path = tmp_path_factory.mktemp("own") / "leg.csv"
    lines = [f"{n / 100},{a % 90},{g % 90}" for n, (a, g) in enumerate(rows)]
    path.write_text("\n".join(["time_s,raw_angle_deg,raw_velocity_rad_s", *lines, ""]))
    assert alike(read_own(path).rows, own_by_csv(path, Sample(b"")))


@pytest.mark.parametrize("name", [name for name in NAMES if format_of(name).oracle is not None])
def test_an_oracle_reads_every_sound_file_as_exoid_does(name, tmp_path):
    made = format_of(name)
    for which, sample in enumerate(made.samples):
        path = tmp_path / f"sound{made.suffix}"
        path.write_bytes(sample.content)
        assert made.oracle is not None
        found = judge.original.__wrapped__(name, which, tmp_path)
        assert alike(found.rows, made.oracle(path, sample))


def test_a_header_within_a_header_is_read_from_below_the_last(tmp_path):
    (sample,) = opensim_samples()
    path = tmp_path / "leg.mot"
    path.write_bytes(sample.content.split(b"0.00000000", 1)[0] + b"0.001\n" + sample.content)
    found = below_header(path, sample)
    assert found["time_s"].tolist() == TIME.tolist()
    assert alike(read_own(path).rows, found)


def test_scaled_analog_channels_are_the_same_to_the_last_bit(tmp_path):
    import ezc3d

    path, (sample,) = tmp_path / "leg.c3d", c3d_samples()
    path.write_bytes(sample.content)
    file = ezc3d.c3d(str(path))
    analog = file["parameters"]["ANALOG"]
    analog["SCALE"]["value"], analog["GEN_SCALE"]["value"] = [0.6328125, 1.0000077], [0.3]
    analog["OFFSET"]["value"] = [7, -300]
    file.write(str(path))
    assert alike(format_of("c3d").read(path).rows, channels_by_c3d(path, sample))


def test_a_group_of_which_mdfreader_loses_the_channels_is_not_taken_for_an_empty_one(tmp_path):
    """The parent of the channels of a frame is said to have more links than the file has bytes."""
    path, content = tmp_path / "log.mf4", bytearray(format_of("can mf4").samples[1].content)
    parent = content.index(b"##CN", content.index(b"##CN") + 1)
    content[parent + 18] = 0x80  # the third byte of the number of its links
    path.write_bytes(content)
    assert format_of("can mf4").read(path).rows["time"].size == 20
    with pytest.raises(Unread, match="time"):
        frames_by_mdfreader(path)
