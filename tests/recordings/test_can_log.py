"""A log of the node gives its motion back, and a damaged one what is left of it and a report."""

import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import can
import numpy as np
import pytest
from exo_node import EPOCH, GYRO, Node, health, knee_angle, knee_velocity, message, write_log

from exoid.recordings.can.frames import CanLogError
from exoid.recordings.can.logs.blf import read_blf
from exoid.recordings.can.logs.log_files import frames_of, row_of
from exoid.recordings.can.node.config_crc import config_crc
from exoid.recordings.declared.subject import Subject
from exoid.recordings.loading.can_log import read_can_log

TICKS = 700
FORMATS = (".blf", ".asc", ".log", ".trc", ".csv", ".mf4")
TEXT = (".asc", ".log", ".trc", ".csv")
REAL_LOGS = Path(__file__).parents[2].parent / "shared" / "data" / "can-logs"

STATE_STEP = 2.0**-13  # rad; half of the last bit of EXO_STATE's angle
COUNT_STEP = np.pi / 4096  # rad; half a count of the encoder
CLOCK = 1e-9  # s; the device clock counts microseconds, and a tick is a whole number of them


def motion_is_right(segment, tick=None):
    """Every value is that of its own time: nothing was shifted by as much as one tick.

    One tick moves the angle by up to 0.027 rad, 200 times the tolerance.
    """
    tick = np.rint(segment.time / 0.01) if tick is None else tick
    time = tick * 0.01
    assert np.nanmax(np.abs(segment.angle - knee_angle(time))) <= STATE_STEP
    assert np.nanmax(np.abs(segment.raw_angle - knee_angle(time))) <= COUNT_STEP
    gyro = segment.raw_angular_velocity - knee_velocity(time)
    assert np.nanmax(np.abs(gyro)) <= GYRO / 2 + 1e-12


def read(tmp_path, messages, suffix=".blf", **options):
    recording, quality = read_can_log(write_log(tmp_path / f"leg{suffix}", messages), **options)
    return recording.segments[0], quality


@pytest.fixture(scope="module")
def messages():
    return Node().messages(TICKS)


@pytest.mark.parametrize("suffix", FORMATS)
def test_every_format_gives_the_motion_back_without_the_hosts_jitter(tmp_path, messages, suffix):
    segment, quality = read(tmp_path, messages, suffix, strict=True)
    np.testing.assert_allclose(segment.time, np.arange(TICKS) * 0.01, rtol=0, atol=CLOCK)
    motion_is_right(segment)
    assert quality.clock == "device"
    assert quality.frames.used == quality.frames.read == len(messages)
    assert quality.config_crc == config_crc()


def test_blf_is_read_as_python_can_reads_it(tmp_path, messages):
    odd = [
        can.Message(timestamp=EPOCH + 8, is_error_frame=True, arbitration_id=5),
        can.Message(timestamp=EPOCH + 8, arbitration_id=0x12345, data=b"LOBJLOBJ"),
        can.Message(timestamp=EPOCH + 8, arbitration_id=7, is_remote_frame=True),
        can.Message(timestamp=EPOCH + 8, arbitration_id=7, is_fd=True, data=bytes(12)),
        can.Message(timestamp=EPOCH + 8, arbitration_id=0x101, is_extended_id=False, data=b"abc"),
    ]
    # Twice: the frame that holds the signature of an object is inside, not at the end.
    path = write_log(tmp_path / "leg.blf", [*messages, *odd, *messages, *odd])
    ours = read_blf(path)
    with can.BLFReader(path) as reader:
        theirs = frames_of([row_of(each) for each in reader])
    assert ours.found == ours.announced == len(ours.frames)
    for name in ("time", "identifier", "flags", "data"):
        np.testing.assert_array_equal(getattr(ours.frames, name), getattr(theirs, name))


def test_the_device_clock_may_wrap_in_the_middle(tmp_path):
    segment, quality = read(tmp_path, Node(device_start=2**32 / 1e6 - 3.0).messages(TICKS))
    np.testing.assert_allclose(segment.time, np.arange(TICKS) * 0.01, rtol=0, atol=CLOCK)
    assert quality.resets == ()


@pytest.mark.parametrize("silence", [1, 3, 400, 3000])
def test_a_silence_is_a_gap_of_its_true_length(tmp_path, silence):
    all_messages = Node().messages(300 + silence + 300)
    begin, end = EPOCH + 3.0, EPOCH + 3.0 + silence * 0.01
    heard = [m for m in all_messages if not begin <= m.timestamp < end]
    segment, quality = read(tmp_path, heard)
    motion_is_right(segment)
    # Jitter lets a frame or two on either side of the silence through, or not.
    assert sum(gap.samples for gap in quality.gaps) == pytest.approx(silence, abs=1)
    assert segment.time[-1] == pytest.approx((599 + silence) * 0.01, abs=CLOCK)


def test_lost_frames_are_counted_and_their_channels_alone_are_missing(tmp_path):
    node = Node(jitter=0.0).messages(TICKS)
    raw = [m for m in node if m.arbitration_id == 0x102]
    dropped = {id(m) for m in raw[100:130]}
    segment, quality = read(tmp_path, [m for m in node if id(m) not in dropped])
    motion_is_right(segment)
    assert np.flatnonzero(np.isnan(segment.raw_angle)).tolist() == list(range(100, 130))
    assert not np.isnan(segment.angle).any()
    by_name = {count.name: count for count in quality.messages}
    assert by_name["EXO_RAW"].expected - by_name["EXO_RAW"].used == 30
    assert by_name["EXO_RAW"].jumps == 1
    assert quality.gaps == ()


def test_a_log_may_begin_and_end_in_the_middle_of_a_tick(tmp_path, messages):
    segment, quality = read(tmp_path, messages[1:-2], strict=True)
    assert segment.time.size == TICKS
    assert quality.losses() == []


def test_a_restart_of_the_node_is_found_and_both_runs_are_kept(tmp_path):
    first = Node(first_counter=7).messages(TICKS)
    second = Node(device_start=0.5, first_counter=0).messages(TICKS, begin=9.0, seed=1)
    segment, quality = read(tmp_path, first + second)
    assert len(quality.resets) == 1
    # Only host time, with 1.5 ms of jitter, tells how long the restart took.
    assert quality.resets[0] == pytest.approx(9.0, abs=0.002)
    again = np.rint((segment.time[TICKS:] - segment.time[TICKS]) / 0.01)
    motion_is_right(segment, np.concatenate([np.arange(TICKS), again]))


def test_without_the_time_frame_the_counter_keeps_the_time(tmp_path, messages):
    segment, quality = read(tmp_path, [m for m in messages if m.arbitration_id != 0x100])
    np.testing.assert_allclose(segment.time, np.arange(TICKS) * 0.01, rtol=0, atol=CLOCK)
    motion_is_right(segment)
    assert quality.clock == "counter"
    assert any("no EXO_TIME frame" in line for line in quality.lines())


def test_counters_are_unwrapped_over_a_silence_without_any_time_frame(tmp_path):
    heard = [
        m
        for m in Node().messages(2000)
        if m.arbitration_id != 0x100 and not EPOCH + 5 <= m.timestamp < EPOCH + 15
    ]
    segment, _ = read(tmp_path, heard)
    motion_is_right(segment)
    assert segment.time[-1] == pytest.approx(19.99, abs=CLOCK)


def test_host_times_that_repeat_or_go_back_do_not_move_a_sample(tmp_path):
    node = Node().messages(TICKS)
    for place in range(50, len(node) - 50, 40):
        node[place].timestamp = node[place - 1].timestamp
        node[place + 20].timestamp -= 2.0
    segment, quality = read(tmp_path, node, ".csv")
    np.testing.assert_allclose(segment.time, np.arange(TICKS) * 0.01, rtol=0, atol=CLOCK)
    motion_is_right(segment)
    assert quality.resets == ()


def test_a_step_of_the_hosts_clock_does_not_move_a_sample(tmp_path, messages):
    moved = [
        can.Message(
            timestamp=m.timestamp + (3600 if m.timestamp > EPOCH + 4 else 0),
            arbitration_id=m.arbitration_id,
            is_extended_id=False,
            data=m.data,
        )
        for m in messages
    ]
    segment, quality = read(tmp_path, moved)
    np.testing.assert_allclose(segment.time, np.arange(TICKS) * 0.01, rtol=0, atol=CLOCK)
    assert quality.resets == ()


def test_a_log_without_host_times_still_has_the_devices(tmp_path):
    node = Node().messages(TICKS)
    for each in node:
        each.timestamp = 0.0
    segment, quality = read(tmp_path, node)
    np.testing.assert_allclose(segment.time, np.arange(TICKS) * 0.01, rtol=0, atol=CLOCK)
    motion_is_right(segment)
    assert quality.skew_ppm is None


def test_one_damaged_count_moves_no_other(tmp_path):
    node = Node().messages(TICKS)
    raw = [each for each in node if each.arbitration_id == 0x102]
    raw[200].data[1] ^= 0x08  # half a turn
    segment, _ = read(tmp_path, node, subject=Subject(kind="rig"))
    wrong = np.abs(segment.raw_angle - knee_angle(segment.time)) > COUNT_STEP
    assert np.flatnonzero(wrong).tolist() == [200]


def test_duplicate_frames_are_left_out_and_counted(tmp_path, messages):
    doubled = [m for m in messages[:2000] for _ in range(2)]
    segment, quality = read(tmp_path, doubled)
    motion_is_right(segment)
    sampled = sum(m.arbitration_id != 0x100 for m in messages[:2000])
    assert quality.frames.duplicate == sampled
    assert quality.losses() == []


@pytest.mark.parametrize(
    ("bit", "missing"),
    [
        ("EncoderFault", {"angle", "raw_angle"}),
        ("MagnetMissing", {"angle", "raw_angle"}),
        (
            "ImuFault",
            {
                "angular_velocity",
                "angular_acceleration",
                "raw_angular_velocity",
                "raw_acceleration_x",
                "raw_acceleration_z",
            },
        ),
        ("GyroSaturated", {"angular_velocity", "angular_acceleration", "raw_angular_velocity"}),
        ("MagnetStrength", set()),
    ],
)
def test_a_fault_takes_its_own_channels_out_and_is_counted(tmp_path, bit, missing):
    status = {tick: {bit: 1} for tick in range(40, 45)}
    segment, quality = read(tmp_path, Node(status=status).messages(100))
    motion_is_right(segment)
    for name, samples in segment.channels().items():
        gone = [40, 41, 42, 43, 44] if name in missing else []
        assert np.flatnonzero(np.isnan(samples)).tolist() == gone, name
    assert dict(quality.faults)[bit] == 5
    assert f"{bit}: 5 samples" in quality.lines()


@pytest.mark.parametrize(
    ("told", "line"),
    [
        ({}, None),
        ({"WatchdogReset": 1}, "watchdog"),
        ({"BrownOutReset": 1}, "supply has dipped"),
        ({"TransmitErrors": 128}, "counts many errors of sending"),
        ({"ReceiveErrors": 128}, "counts many errors of hearing"),
        ({"CanOff": 1}, "left the bus"),
        ({"BusReleases": 3}, "released its sensors' bus 3 time"),
        ({"CanStarts": 2}, "set its CAN controller up 2 times"),
    ],
)
def test_what_the_node_says_of_its_health_is_reported_and_moves_no_sample(
    tmp_path, messages, told, line
):
    _, before = read(tmp_path, messages)
    middle = [*messages[:900], health(messages[899].timestamp, **told), *messages[900:]]
    segment, quality = read(tmp_path, middle, strict=True)
    motion_is_right(segment)
    said = set(quality.lines()) - set(before.lines())
    said = {each for each in said if "frames" not in each}  # there is one frame more
    assert len(said) == (line is not None)
    assert all(line in each for each in said)


def test_the_raw_angle_is_unwrapped_onto_the_turn_of_the_filtered_one(tmp_path):
    frames = []
    for tick in range(200):
        angle = -2.0 - 0.02 * tick  # passes -pi, where the encoder's count goes from 0 to 4095
        counter = tick % 256
        state = dict.fromkeys(("EncoderFault", "MagnetMissing", "MagnetStrength", "ImuFault"), 0)
        state |= dict.fromkeys(("GyroSaturated", "StateSaturated", "FilterReset", "Overrun"), 0)
        state |= dict(Angle=angle, AngularVelocity=0, AngularAcceleration=0, Counter=counter)
        count = round(angle / (2 * np.pi) * 4096 + 2048) % 4096
        raw = dict(Angle=count * 2 * np.pi / 4096 - np.pi, GyroX=0, GyroY=0, GyroZ=0)
        host = EPOCH + tick * 0.01
        frames.append(message("EXO_STATE", state, host))
        frames.append(message("EXO_RAW", raw | {"Counter": counter % 16}, host + 0.0003))
    segment, _ = read(tmp_path, frames, subject=Subject(kind="rig"))
    assert np.abs(segment.raw_angle - segment.angle).max() <= COUNT_STEP + STATE_STEP


def like(messages, every, **changed):
    """The messages, with every n-th of EXO_STATE changed."""
    seen = 0
    for each in messages:
        if each.arbitration_id != 0x101:
            yield each
            continue
        seen += 1
        known = dict(
            timestamp=each.timestamp, arbitration_id=0x101, is_extended_id=False, data=each.data
        )
        yield can.Message(**known | changed) if seen % every == 0 else each


@pytest.mark.parametrize(
    ("heading", "changed"),
    [
        ("foreign", {"arbitration_id": 0x3A1}),
        ("extended", {"is_extended_id": True}),
        ("fd", {"is_fd": True}),
        ("remote", {"is_remote_frame": True, "data": None, "dlc": 8}),
        ("wrong_length", {"data": b"abc"}),
        ("error", {"is_error_frame": True, "arbitration_id": 0, "data": None}),
    ],
)
def test_frames_of_the_wrong_kind_are_left_out_and_counted(tmp_path, messages, heading, changed):
    segment, quality = read(tmp_path, list(like(messages, 10, **changed)))
    motion_is_right(segment)
    assert getattr(quality.frames, heading) == TICKS // 10
    assert np.isnan(segment.angle).sum() == TICKS // 10
    counts = [getattr(quality.frames, each.name) for each in fields(quality.frames)]
    assert quality.frames.read == sum(counts) - quality.frames.read
    with pytest.raises(CanLogError, match="EXO_STATE: 69 of 699 frame"):
        read(tmp_path, list(like(messages, 10, **changed)), strict=True)


@pytest.mark.parametrize("suffix", TEXT)
def test_a_text_log_cut_inside_a_line_keeps_every_whole_frame(tmp_path, messages, suffix):
    path = write_log(tmp_path / f"leg{suffix}", messages)
    content = path.read_bytes()
    path.write_bytes(content[: content.index(b"\n", len(content) // 2) + 9])
    recording, quality = read_can_log(path)
    motion_is_right(recording.segments[0])
    assert recording.segments[0].time.size > TICKS * 0.45
    assert "is cut short and left out" in str(quality.stopped)
    with pytest.raises(CanLogError, match="cut short"):
        read_can_log(path, strict=True)


@pytest.mark.parametrize("suffix", TEXT)
def test_one_damaged_line_costs_one_frame(tmp_path, messages, suffix):
    path = write_log(tmp_path / f"leg{suffix}", messages)
    lines = path.read_text().splitlines(keepends=True)
    lines[1000] = lines[1000].replace("0", "?")
    path.write_text("".join(lines))
    recording, quality = read_can_log(path)
    motion_is_right(recording.segments[0])
    assert quality.frames.used == len(messages) - 1
    assert any(line.endswith("the counter jumps 1 time") for line in quality.losses())


def test_a_blf_cut_in_half_keeps_what_is_there_and_says_how_much_was_announced(tmp_path, messages):
    path = write_log(tmp_path / "leg.blf", messages)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    recording, quality = read_can_log(path)
    motion_is_right(recording.segments[0])
    assert quality.announced == len(messages) > quality.found > len(messages) * 0.4
    report = "\n".join(quality.lines())
    assert "the file ends inside the block" in report
    assert f"the header announces {len(messages)} objects" in report


def test_a_blf_whose_logger_was_killed_is_read_and_named(tmp_path, messages):
    path = write_log(tmp_path / "leg.blf", messages)
    content = bytearray(path.read_bytes())
    content[32:36] = bytes(4)  # the count of objects, which a logger writes when it is stopped
    path.write_bytes(content)
    recording, quality = read_can_log(path)
    assert recording.segments[0].time.size == TICKS
    assert "the header was never completed" in "\n".join(quality.losses())


def test_a_damaged_block_of_a_blf_costs_that_block_alone(tmp_path):
    path = write_log(tmp_path / "leg.blf", Node().messages(3000))
    content = bytearray(path.read_bytes())
    blocks = [at for at in range(len(content)) if content[at : at + 4] == b"LOBJ"]
    content[(blocks[1] + blocks[2]) // 2] ^= 0xFF
    path.write_bytes(content)
    recording, quality = read_can_log(path)
    motion_is_right(recording.segments[0])
    # A block holds 128 KiB, an object 48 bytes; 3.1 frames make a sample.
    (gap,) = quality.gaps
    assert gap.samples == pytest.approx(128 * 1024 / 48 / 3.1, abs=2)
    assert f"the block at byte {blocks[1]} is damaged" in str(quality.stopped)


@pytest.mark.parametrize("suffix", FORMATS)
@pytest.mark.parametrize("flips", [1, 20, 200])
def test_flipped_bits_give_good_samples_or_one_line(tmp_path, messages, suffix, flips):
    path = write_log(tmp_path / f"leg{suffix}", messages)
    whole = path.read_bytes()
    for seed in range(1 if suffix == ".mf4" else 3):  # tests/fuzz damages more of what takes long
        rng = np.random.default_rng(seed)
        damaged = bytearray(whole)
        for at in rng.integers(0, len(whole), flips):
            damaged[at] ^= 1 << int(rng.integers(8))
        path.write_bytes(damaged)
        one_line_or_a_recording(path)


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_file_of_noise_is_one_line(tmp_path, suffix):
    path = tmp_path / f"leg{suffix}"
    path.write_bytes(np.random.default_rng(5).bytes(3000))
    with pytest.raises(CanLogError, match=f"leg{suffix}") as caught:
        read_can_log(path)
    assert str(caught.value).isprintable()


@pytest.mark.parametrize("suffix", FORMATS)
@pytest.mark.parametrize("share", [0.5, 0.99, 0.01])
def test_a_cut_file_gives_good_samples_or_one_line(tmp_path, messages, suffix, share):
    path = write_log(tmp_path / f"leg{suffix}", messages)
    path.write_bytes(path.read_bytes()[: int(path.stat().st_size * share)])
    recording = one_line_or_a_recording(path)
    if recording is not None:
        motion_is_right(recording.segments[0])


def one_line_or_a_recording(path):
    told = ""
    recording, lines = None, []
    try:
        recording, quality = read_can_log(path)
        lines = quality.lines()
    except CanLogError as fault:
        told = str(fault)
    assert recording is not None or str(path) in told
    assert all(line.isprintable() for line in [told, *lines])
    return recording


@pytest.mark.parametrize("suffix", FORMATS)
def test_an_empty_file_is_called_empty(tmp_path, suffix):
    path = tmp_path / f"leg{suffix}"
    path.touch()
    with pytest.raises(CanLogError, match="is empty"):
        read_can_log(path)


def test_an_unknown_format_names_the_known_ones(tmp_path):
    path = tmp_path / "leg.db"
    path.touch()
    with pytest.raises(CanLogError, match=r"\.blf, \.mf4, \.asc"):
        read_can_log(path)


def test_mf4_without_asammdf_says_what_to_install(tmp_path, monkeypatch):
    path = tmp_path / "leg.mf4"
    path.write_bytes(b"MDF")
    monkeypatch.setattr("exoid.recordings.can.logs.log_files.find_spec", lambda name: None)
    with pytest.raises(CanLogError, match=r"install '\.\[mf4\]'"):
        read_can_log(path)


def test_a_log_of_faults_only_says_so(tmp_path):
    status = {tick: {"EncoderFault": 1} for tick in range(100)}
    with pytest.raises(CanLogError, match="EncoderFault: 100 sample"):
        read(tmp_path, Node(status=status).messages(100))


def test_the_nodes_own_frames_need_neither_python_can_nor_cantools(tmp_path, messages):
    path = write_log(tmp_path / "leg.blf", messages)
    program = (
        "import sys; from exoid.recordings.loading.can_log import read_can_log; "
        f"read_can_log({str(path)!r}); "
        "print([name for name in ('can', 'cantools', 'jax') if name in sys.modules])"
    )
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert told.stdout.strip() == "[]", told.stderr


DBC = """VERSION ""
NS_ :
BS_:
BU_: KNEE
BO_ 291 Knee: 8 KNEE
 SG_ Angle : 7|16@0- (0.01,0) [0|0] "deg" KNEE
 SG_ Rate : 16|16@1- (1,0) [0|0] "" KNEE
BO_ 2147484065 Force: 4 KNEE
 SG_ Torque : 0|16@1- (0.01,0) [0|0] "Nm" KNEE
 SG_ Angle : 16|16@1- (1,0) [0|0] "deg" KNEE
"""


@pytest.fixture
def dbc(tmp_path):
    path = tmp_path / "other.dbc"
    path.write_text(DBC)
    return path


def other_device(ticks, lost=()):
    rng = np.random.default_rng(3)
    for tick in range(ticks):
        time = tick * 0.02
        host = EPOCH + time + rng.exponential(0.001)
        degrees = round(np.degrees(knee_angle(time)) * 100)
        rate = round(np.degrees(knee_velocity(time)))
        data = degrees.to_bytes(2, "big", signed=True) + rate.to_bytes(2, "little", signed=True)
        if tick not in lost:
            yield can.Message(
                timestamp=host, arbitration_id=291, is_extended_id=False, data=data + bytes(4)
            )
        torque = round(500 * np.sin(time + 0.005)).to_bytes(2, "little", signed=True)
        yield can.Message(
            timestamp=host + 0.005, arbitration_id=417, is_extended_id=True, data=torque + bytes(2)
        )


NAMES = "Knee: ", "Force: "  # of its messages
SIGNALS = {
    "angle": "Knee.Angle",
    "angular_velocity": "Rate [deg/s]",
    "applied_torque": "Torque",
}


def test_another_device_is_read_through_its_dbc_and_a_map(tmp_path, dbc):
    segment, quality = read(tmp_path, other_device(500), dbc=dbc, signals=SIGNALS, strict=True)
    # 500 host times with 1 ms of scatter give a line to 0.1 ms; five of these, at 2.7 rad/s.
    assert np.abs(np.diff(segment.time) - 0.02).max() < 1e-4
    assert np.abs(segment.angle - knee_angle(segment.time)).max() < 0.0015
    # Half a degree per second of rounding, and 0.5 ms at 8 rad/s^2.
    error = segment.angular_velocity - knee_velocity(segment.time)
    assert np.abs(error).max() < np.radians(0.5) + 0.004
    # Between its own frames, 5 ms away: a fortieth of a period's bend, and the line's 0.5 ms.
    inside = slice(1, -1)
    torque = 5 * np.sin(segment.time[inside])
    assert np.abs(segment.applied_torque[inside] - torque).max() < 0.01
    assert quality.clock == "host"
    angle, other = (next(line for line in quality.notes if name in line) for name in NAMES)
    assert "interpolated" not in angle
    assert other.endswith("interpolated to those of Knee")


def test_a_map_may_call_a_rate_as_tables_do(tmp_path, dbc):
    told = {
        "velocity" if name == "angular_velocity" else name: each for name, each in SIGNALS.items()
    }
    assert told != SIGNALS
    segment, _ = read(tmp_path, other_device(50), dbc=dbc, signals=told)
    assert segment.angular_velocity is not None


def test_lost_frames_of_another_device_are_gaps(tmp_path, dbc):
    lost = {100, 250, 251, 252}
    log = other_device(500, lost)
    segment, quality = read(tmp_path, log, dbc=dbc, signals=SIGNALS)
    assert [gap.samples for gap in quality.gaps] == [1, 3]
    assert np.abs(segment.angle - knee_angle(segment.time)).max() < 0.0015
    assert any(line.endswith("by their times in 2 places") for line in quality.losses())
    assert not any("counter jumps" in line for line in quality.lines())  # there is none
    with pytest.raises(CanLogError, match="Knee: 4 of 500 frame"):
        read(tmp_path, other_device(500, lost), dbc=dbc, signals=SIGNALS, strict=True)


@pytest.mark.parametrize(
    ("signals", "told"),
    [
        ({"angle": "Angle"}, r"can be Knee\.Angle, Force\.Angle"),
        ({"angle": "Knee.Angel"}, r"no such signal\. Did you mean Knee\.Angle"),
        ({"angle": "Knee.Rate"}, r"Knee\.Rate has no unit, but rad is wanted"),
        ({"angle": "Torque"}, r"has the unit 'Nm', but rad is wanted"),
        ({"angle": "Knee Angle"}, r"write MESSAGE\.SIGNAL"),
        ({"applied_torque": "Torque"}, "names no angle"),
        ({"angle": "Knee.Angle", "speed": "Rate"}, "knows no channel speed"),
    ],
)
def test_a_map_that_does_not_fit_says_how(tmp_path, dbc, signals, told):
    with pytest.raises(CanLogError, match=told):
        read(tmp_path, other_device(10), dbc=dbc, signals=signals)


def test_a_dbc_of_another_log_is_noticed(tmp_path, messages, dbc):
    with pytest.raises(CanLogError, match=r"holds 0 frames of Knee"):
        read(tmp_path, messages, dbc=dbc, signals=SIGNALS)


def test_a_dbc_without_a_map_is_refused(tmp_path, messages, dbc):
    with pytest.raises(CanLogError, match="belong together"):
        read(tmp_path, messages, dbc=dbc)


def real(name):
    path = REAL_LOGS / name
    if not path.exists():
        pytest.skip(f"{path} is not there")
    return path


@pytest.mark.parametrize(
    "name",
    [
        "pythoncan_issue_1256.asc",
        "pythoncan_logfile.asc",
        "pythoncan_test_CanFdMessage64.blf",
        "pythoncan_test_CanMessage.blf",
        "pythoncan_test_CanMessage_V2_1.trc",
        "css_LOG_2F6913DB_00000004_00000001.MF4",
    ],
)
def test_a_real_log_without_the_node_is_told_apart(name):
    with pytest.raises(CanLogError, match="no exoid frames"):
        read_can_log(real(name))


def test_a_csv_of_another_tool_is_named_by_its_header():
    with pytest.raises(CanLogError, match="line 1 is Time Stamp,ID"):
        read_can_log(real("projectgus_kona_221210-2.csv"))


@pytest.mark.parametrize("name", ["issue_1256.asc", "test_CanFdMessage64.blf"])
def test_real_files_hold_as_many_frames_as_python_can_finds(name):
    path = real(f"pythoncan_{name}")
    with can.LogReader(path) as reader, pytest.raises(CanLogError, match=f"{len(list(reader))} "):
        read_can_log(path)


def test_a_real_log_is_read_through_its_own_dbc():
    log = real("css_LOG_2F6913DB_00000004_00000001.MF4")
    gnss = real("css_dbc_files_gnss.dbc")
    signals = {"angle": "gnss_attitude.Roll", "raw_acceleration_z": "gnss_imu.AccelerationZ"}
    recording, quality = read_can_log(log, dbc=gnss, signals=signals)
    segment = recording.segments[0]
    assert quality.frames.read == 5588  # as python-can counts them
    assert segment.time.size == 44
    # A car: it stands upright in the Earth's field.
    assert np.nanmedian(segment.raw_acceleration_z) == pytest.approx(9.81, abs=0.5)
    assert np.nanmax(np.abs(segment.angle)) < 0.5


def test_a_node_of_another_firmware_is_refused(tmp_path):
    with pytest.raises(CanLogError, match=r"ConfigCrc 0xBEEF, here 0x.*Flash this version"):
        read(tmp_path, Node(config_crc=0xBEEF).messages(50))


@pytest.mark.parametrize(
    ("told", "filter"), [(config_crc(), "4 states"), (0x99CA, "3 states"), (0, None)]
)
def test_a_log_tells_by_its_config_crc_which_filter_the_node_ran(tmp_path, told, filter):
    node = Node(config_crc=told).messages(300)
    recording, quality = read_can_log(write_log(tmp_path / "leg.blf", node))
    assert recording.sensors.filter == quality.design == filter
    filtered = [each for each in node if each.arbitration_id != 0x102]
    _, quality = read_can_log(write_log(tmp_path / "filtered.blf", filtered))
    said = [line for line in quality.lines() if "which filter made the channels" in line]
    assert len(said) == (filter is None)
