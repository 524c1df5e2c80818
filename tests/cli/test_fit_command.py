"""`exoid fit` where all is well: what it prints, what it writes, and what its options do."""

import json
import signal
import time

import numpy as np
import pytest
from command_line import apart
from sessions import DROP, EPOCH, LEG, RATIOS, session, write_frames, write_log

QUICK = (".blf", ".csv")
FORMATS = (
    *QUICK,
    *(pytest.param(each, marks=pytest.mark.proof) for each in (".asc", ".log", ".trc", ".mf4")),
)
SAME = 1e-3  # standard errors between two seeds: the solver's tolerance
QUANTISED = 0.5  # standard errors by which rounding in a format may move a ratio
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000
DBC = """VERSION ""
BU_: Knee
BO_ 291 Knee: 8 Knee
 SG_ Angle : 0|32@1- (0.0001,0) [0|0] "deg" Vector__XXX
 SG_ Velocity : 32|32@1- (0.001,0) [0|0] "deg/s" Vector__XXX
"""


@pytest.fixture(scope="module")
def example(command, tmp_path_factory):
    """`exoid fit` without a path, with a document."""
    path = tmp_path_factory.mktemp("example") / "fit.json"
    done = command.alone("fit", "--json", path)
    assert done.returncode == 0, done.stderr
    return done, json.loads(path.read_text(encoding="utf-8"))


def test_without_a_path_it_says_that_it_fits_the_example(example):
    done, _ = example
    first = done.stdout.splitlines()[0]
    assert "No recording given" in first
    assert "example" in first
    assert "8846 samples" in done.stderr


def test_the_example_gives_back_the_leg_that_made_it(example):
    _, document = example
    found = {name: each["value"] for name, each in document["parameters"].items()}
    error = {name: each["standard_error"] for name, each in document["parameters"].items()}
    moment = found["mass"] * found["com_distance"]
    # m l g / J is known to 0.03 %, so that J's own error is that of m l. It is 1 %: the example
    # does not say how well the distance and the extent of its added mass are known.
    scale = LIKELY * error["inertia"] / found["inertia"]
    assert moment == pytest.approx(LEG["mass"] * LEG["com_distance"], rel=scale)
    assert error["inertia"] / found["inertia"] < 0.02
    # Passive drops alone tell J and d; c is told by both kinds of segments.
    told = {"inertia": "passive", "damping": "passive", "stiffness": "data"}
    for name, source in told.items():
        assert document["parameters"][name]["determined_by"] == source
        assert abs(found[name] - LEG[name]) < LIKELY * error[name]


def test_document_names_everything_it_rests_on(example):
    _, document = example
    assert list(document) == [
        "exoid",
        "recordings",
        "settings",
        "parameters",
        "ratios",
        "terms",
        "fit",
        "mountings",
        "identifiability",
        "multistart",
        "segments",
        "notes",
    ]
    (recording,) = document["recordings"]
    assert recording.keys() == {"path", "sha256", "segments", "subject"}
    assert recording["segments"] == len(document["segments"]) == 10
    assert document["settings"] == {
        "lambda": 1.0,
        "multistart": 64,
        "seed": 0,
        "prior": "auto",
        "bounds": "body",
        "method": "lm",
        "smooth": 1,
        "misfit": "weighted",
        "clip": "free",
        "each": False,
    }


def test_the_table_fits_any_pipe_and_nothing_but_notes_goes_to_stderr(command, recordings):
    done = command("fit", recordings / "drop.csv")
    assert (done.returncode, done.stderr) == (0, "")
    assert max(map(len, done.stdout.split("\n"))) <= 80
    assert "\x1b" not in done.stdout
    assert "…" not in done.stdout


def test_the_same_seed_gives_the_same_bytes_and_another_the_same_leg(
    command, recordings, fitted, tmp_path
):
    texts = []
    for number, seed in enumerate((0, 0, 1)):
        path = tmp_path / f"{number}.json"
        command("fit", recordings / "drop.csv", "--seed", seed, "--json", path)
        texts.append(path.read_bytes())
    assert texts[0] == texts[1]
    other = json.loads(texts[2])
    assert other["settings"]["seed"] == 1
    for group in ("parameters", "ratios"):
        assert max(apart(fitted[group], other[group]).values()) < SAME


@pytest.mark.parametrize(
    ("suffix", "begin"),
    [
        (".pdf", b"%PDF"),
        pytest.param(".png", b"\x89PNG", marks=pytest.mark.proof),
        pytest.param(".svg", b"<?xml", marks=pytest.mark.proof),
    ],
)
def test_a_figure_is_drawn_in_the_format_of_its_name(command, recordings, tmp_path, suffix, begin):
    path = tmp_path / f"figure{suffix}"
    done = command("fit", recordings / "drop.csv", "--plot", path)
    assert (done.returncode, done.stderr) == (0, f"wrote {path}\n")
    assert path.read_bytes().startswith(begin)
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


@pytest.mark.proof
def test_without_a_prior_only_the_ratios_are_told(command, recordings, fitted, tmp_path):
    document = command.document(recordings / "drop.csv", "--prior", "none", folder=tmp_path)
    assert document["parameters"]["inertia"]["value"] is None
    assert "ratios" in document["parameters"]["inertia"]["reason"]
    assert max(apart(fitted["ratios"], document["ratios"]).values()) < 0.1  # the prior's pull


def test_body_mass_and_height_replace_the_sidecars(command, recordings, fitted, tmp_path):
    options = ("--body-mass", "90", "--height", "1.9")
    document = command.document(recordings / "drop.csv", *options, folder=tmp_path)
    assert "90 kg and 1.9 m" in document["fit"]["prior"]
    ratio = document["parameters"]["mass"]["expected"] / fitted["parameters"]["mass"]["expected"]
    assert ratio == pytest.approx(90 / 74, rel=1e-6)


def test_each_segment_alone_gives_the_mean_of_the_ratios(command, recordings, tmp_path):
    document = command.document(recordings / "two.csv", "--each", folder=tmp_path)
    assert [each["name"] for each in document["segments"]] == ["0", "1"]
    for name, truth in RATIOS.items():
        assert document["ratios"][name]["value"] == pytest.approx(truth, rel=5e-3)


@pytest.mark.proof
def test_smoothing_data_and_simulation_alike_does_not_move_the_ratios(
    command, recordings, fitted, tmp_path
):
    document = command.document(recordings / "drop.csv", "--smooth", 5, folder=tmp_path)
    assert document["settings"]["smooth"] == 5
    assert max(apart(fitted["ratios"], document["ratios"]).values()) < 2  # it weighs samples anew


@pytest.mark.proof
def test_slsqp_finds_the_same_leg(command, recordings, fitted, tmp_path):
    options = ("--method", "slsqp", "--multistart", 2)
    document = command.document(recordings / "drop.csv", *options, folder=tmp_path)
    assert max(apart(fitted["ratios"], document["ratios"]).values()) < 0.1


@pytest.mark.proof
def test_the_reading_of_the_torque_frequency_can_be_chosen(command, example, tmp_path):
    path = tmp_path / "fit.json"
    done = command.alone("fit", "--torque-frequency", "2/T", "--json", path)
    assert done.returncode == 0  # the drops tell the leg, whatever the cycles do
    assert "This fit follows a part of its recording only" in done.stdout.splitlines()[2]
    document = json.loads(path.read_text(encoding="utf-8"))
    assert "does not follow the active segments" in document["notes"][0]
    torque = document["ratios"]["torque_over_inertia"]
    assert (torque["value"], torque["determined_by"]) == (None, None)
    assert torque["reason"].startswith("the simulation does not follow the active segments")
    assert document["fit"]["torque_frequency"] == "2/T"
    _, chosen = example
    assert chosen["fit"]["torque_frequency"] == "1/T"
    assert document["fit"]["angle_rmse_rad"] > 10 * chosen["fit"]["angle_rmse_rad"]


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_log_gives_the_same_ratios_in_every_format(command, fitted, tmp_path, suffix):
    if suffix == ".mf4":
        pytest.importorskip("asammdf")
    log = write_log(session(DROP), tmp_path / f"session{suffix}")
    document = command.document(log, folder=tmp_path)
    assert max(apart(fitted["ratios"], document["ratios"]).values()) < QUANTISED
    assert document["recordings"][0]["path"] == str(log)


def test_another_devices_log_is_read_by_its_own_dbc(command, fitted, tmp_path):
    recording = session(DROP)
    log = recording.segments[0]
    (tmp_path / "knee.dbc").write_text(DBC)
    counts = np.degrees(np.stack([log.raw_angle, log.raw_angular_velocity], 1)) / [1e-4, 1e-3]
    sent = (
        (EPOCH + time, 291, each.astype("<i4").tobytes())
        for time, each in zip(log.time.tolist(), np.rint(counts), strict=True)
    )
    path = write_frames(sent, recording, tmp_path / "knee.asc")
    signals = ("raw_angle=Knee.Angle", "raw_angular_velocity=Knee.Velocity [deg/s]")
    options = [word for each in signals for word in ("--signal", each)]
    document = command.document(path, "--dbc", tmp_path / "knee.dbc", *options, folder=tmp_path)
    assert max(apart(fitted["ratios"], document["ratios"]).values()) < QUANTISED


def test_a_result_is_still_written_when_nobody_reads_the_table(command, recordings, tmp_path):
    with command.start("fit", recordings / "drop.csv", "--json", tmp_path / "fit.json") as running:
        running.stdout.close()
        assert running.stderr.read() == f"wrote {tmp_path / 'fit.json'}\n"
    assert running.returncode == 0
    assert "ratios" in json.loads((tmp_path / "fit.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_or_a_batch_system_ends_it_at_once_with_one_line(
    command, recordings, tmp_path, number
):
    running = command.start(
        "fit", recordings / "drop.csv", "--multistart", 100_000, "--json", tmp_path / "fit.json"
    )
    time.sleep(4.0)  # past its imports on a busy machine too, far from its end
    running.send_signal(number)
    try:
        _, said = running.communicate(timeout=20)
    finally:
        running.kill()
    assert (running.returncode, said) == (130, "exoid: interrupted\n")
    assert not list(tmp_path.iterdir())


@pytest.mark.proof
def test_a_cache_that_cannot_be_made_or_read_costs_only_time(command, recordings, tmp_path):
    (tmp_path / "file").touch()
    told = {}
    for cache in (tmp_path / "file", command.environment["XDG_CACHE_HOME"]):
        done = command.alone(
            "fit",
            recordings / "drop.csv",
            env={**command.environment, "XDG_CACHE_HOME": str(cache), "PYTHONWARNINGS": "ignore"},
        )
        told[str(cache)] = (done.returncode, done.stderr, done.stdout)
    first, second = told.values()
    assert first == second
    assert first[:2] == (0, "")
