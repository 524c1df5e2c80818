"""What the node says it has learned of the leg comes out of its log, and onto the screen."""

import numpy as np
import pytest
from cantools.database import load_file
from cantools.database.can import Database
from exo_node import ADULT, EPOCH, SURE, Node, learned, write_log

from exoid.cli.live.session import live_line
from exoid.recordings.can.dbc import EXOID_DBC
from exoid.recordings.can.logs.log_files import read_log
from exoid.recordings.can.node.config_crc import LEARNED, config_crc
from exoid.recordings.can.node.learned import course_of
from exoid.recordings.can.node.which import read_by
from exoid.recordings.can.node_estimate import NodeEstimate
from exoid.recordings.can.quality import LogQuality
from exoid.recordings.can.sort import sort_frames
from exoid.recordings.live.watch import Watch
from exoid.recordings.loading.can_log import read_can_log

TICKS = 300
LINE = (
    "learned by the node of 3 free movements, good: m l g / J 27.4 ± 0.12 1/s^2, "
    "c / J 6.25 ± 0.25 1/s^2, d / J 0.7998 ± 0.0078 1/s, constant torque / J -0.5 ± 0.25 1/s^2, "
    "dry friction / J 0.125 ± 0.016 1/s^2"
)


def log_of(tmp_path, *told, node=None):
    """A node's log with what it told between its samples."""
    messages = [*(node or Node()).messages(TICKS), *(each for some in told for each in some)]
    return write_log(tmp_path / "leg.blf", sorted(messages, key=lambda each: each.timestamp))


def times(count):
    return EPOCH + 0.506 + 0.1 * np.arange(count)


def quality_of(path) -> LogQuality:
    return read_can_log(path)[1]


def known(estimate: NodeEstimate | None) -> NodeEstimate:
    assert estimate is not None
    return estimate


def test_a_tool_that_reads_the_dbc_shows_trust_and_phase_in_words():
    """By cantools: one for every value of the firmware's Trust and Phase."""
    database = load_file(EXOID_DBC)
    assert isinstance(database, Database)
    learning = database.get_message_by_name("EXO_LEARNING")
    for name, count in {"Trust": 7, "Phase": 5}.items():
        assert [*(learning.get_signal_by_name(name).choices or ())] == list(range(count))
    said = learning.decode(bytes([0, 0x32, 3, 16, 0, 0, 0, 0]))
    assert isinstance(said, dict)
    assert (str(said["Trust"]), str(said["Phase"])) == ("good", "moving freely")


def test_the_last_that_was_learned_is_a_line_of_the_report(tmp_path):
    early, late = times(2)
    told = learned(early, ratios=(30.0, 1.0, 1.0, 1.0, 0.0), Drops=1, Trust=1), learned(late)
    quality = quality_of(log_of(tmp_path, *told))
    assert known(quality.learned).ratios == pytest.approx(
        ADULT, abs=2**-8
    )  # half a count of the coarsest
    assert known(quality.learned).errors == SURE  # whole counts
    assert quality.lines().count(LINE) == 1
    assert quality.frames.foreign == 0


def test_every_time_it_was_told_is_there_in_its_order(tmp_path):
    told = [learned(at, Drops=k, Trust=k % 3, Phase=3) for k, at in enumerate(times(12))]
    frames = read_log(log_of(tmp_path, *told)).frames
    course = course_of(sort_frames(frames, read_by(frames, 0)).messages)
    assert course.drops.tolist() == list(range(12))
    assert course.trust.tolist() == [k % 3 for k in range(12)]
    assert set(course.phase) == {3}
    assert np.all(np.diff(course.order) > 0)


@pytest.mark.parametrize("lost", range(4))
def test_of_four_frames_that_belong_together_none_may_be_missing(tmp_path, lost):
    whole, torn = (learned(at, Drops=k) for k, at in enumerate(times(2), start=1))
    del torn[lost]
    path = log_of(tmp_path, whole, torn)
    assert known(quality_of(path).learned).drops == 1
    assert known(watched([*whole, *torn]).estimate.known).drops == 1
    beginning = learned(times(1)[0], Drops=5)  # the node's next time is whole again
    assert known(watched([*torn, *beginning]).estimate.known).drops == 5


def test_a_node_that_learns_by_other_numbers_is_not_believed(tmp_path):
    (at,) = times(1)
    told = learned(at, LearningCrc=1)
    assert quality_of(log_of(tmp_path, told)).learned is None
    assert watched(told).estimate.known is None


def test_frames_of_those_identifiers_in_the_log_of_an_unknown_node_are_foreign(tmp_path):
    (at,) = times(1)
    quality = quality_of(log_of(tmp_path, learned(at), node=Node(config_crc=0)))
    assert quality.learned is None
    assert quality.frames.foreign == 4


def test_a_node_that_has_seen_no_free_movement_says_no_number(tmp_path):
    (at,) = times(1)
    quality = quality_of(log_of(tmp_path, learned(at, Drops=0, Trust=0)))
    line = "the node has learned nothing of the leg: waiting for a free movement"
    assert line in quality.lines()


def watched(told, said=None) -> Watch:
    watch = Watch((said if said is not None else []).append, config_crc())
    for message in [*Node().messages(TICKS), *told]:
        watch.see(message)
    return watch


def test_the_screen_shows_what_is_known_while_it_is_recorded():
    (at,) = times(1)
    assert live_line(watched(learned(at)).status(0)).endswith("m l g / J 27.4 ± 0.12, good")
    assert "m l g" not in live_line(watched(learned(at, Drops=0)).status(0))


def test_a_leg_that_is_another_or_not_explained_is_said_once():
    said = []
    trusts = (0, 2, 4, 4, 4, 2, 5, 5)
    told = [learned(at, Trust=trust) for trust, at in zip(trusts, times(8), strict=True)]
    watched([each for some in told for each in some], said)
    assert len(said) == 2
    assert "does not explain" in said[0]
    assert "another leg" in said[1]


def test_each_frame_of_what_is_learned_has_its_place_in_the_dbc():
    assert LEARNED == ("EXO_RATIOS", "EXO_RATIO_ERRORS", "EXO_FRICTION", "EXO_LEARNING")
