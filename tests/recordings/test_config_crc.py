"""The node's ConfigCrc stands for what its numbers mean, not for how exoid.dbc is written."""

import re
from binascii import crc_hqx
from dataclasses import fields, replace

import pytest

from exoid.recordings.can.dbc import EXOID_DBC, messages_in
from exoid.recordings.can.node import config_crc as crc_module
from exoid.recordings.can.node.config_crc import (
    COMMANDED,
    EARLIER,
    LEARNED,
    RECORDED,
    SEED,
    config_crc,
    filter_of,
    layout,
    learning_crc,
)
from exoid.recordings.can.node.rows import FINE, SAMPLED, TIME
from exoid.recordings.filter.constants import CURRENT
from exoid.recordings.filter.learning import LEARNING, Learning

MEASURED_EARLIER = 0xAD7F  # CRC of the frames of a tick and of EXO_TIME by all of `EARLIER`


def in_reverse(text: str) -> str:
    """The messages, and the signals of each, from the last to the first."""
    blocks = re.findall(r"^BO_ .*\n(?: SG_ .*\n)+", text, re.MULTILINE)
    begin = text.index(blocks[0])
    end = text.index(blocks[-1]) + len(blocks[-1])
    turned = [
        "\n".join([head, *reversed(signals)])
        for head, *signals in (block.splitlines() for block in reversed(blocks))
    ]
    return text[:begin] + "\n\n".join(turned) + "\n" + text[end:]


COSMETIC = {
    "line ends": lambda text: text.replace("\n", "\r\n"),
    "a space": lambda text: text.replace("BO_ 256 EXO_TIME: 8", "BO_  256 EXO_TIME : 8 "),
    "spaces in a signal": lambda text: text.replace(
        " SG_ Angle : 0|16@1- (", "  SG_  Angle: 0|16@1-("
    ),
    "a blank line": lambda text: text.replace("\nCM_", "\n\nCM_"),
    "no comments": lambda text: re.sub(r"^CM_ .*\n", "", text, flags=re.MULTILINE),
    "other order": in_reverse,
    "a scale written otherwise": lambda text: text.replace("(0.03125,0)", "(3.125E-2,0.0)"),
    "who listens": lambda text: text.replace(" HOST\n", " EXO\n"),
    "ranges": lambda text: text.replace("[-8|7.999755859375]", "[0|0]"),
    "a command": lambda text: text.replace("BO_ 517 EXO_IDENTIFY", "BO_ 518 EXO_BLINK"),
}
MEANT = {
    "identifier": ("BO_ 258 EXO_RAW", "BO_ 263 EXO_RAW"),
    "name": ("SG_ GyroX", "SG_ GyroW"),
    "start": ("SG_ Counter : 12|4", "SG_ Counter : 11|4"),
    "length": ("SG_ Counter : 12|4", "SG_ Counter : 12|3"),
    "sign": ("SG_ GyroX : 16|16@1-", "SG_ GyroX : 16|16@1+"),
    "scale": ("(0.0011964113,0)", "(0.0011964114,0)"),
    "offset": ("(0.0015339807878856412,-3.141592653589793)", "(0.0015339807878856412,0)"),
    "unit": ('"m/s^2"', '"g"'),
    "rate": ('"GenMsgCycleTime" BO_ 257 10;', '"GenMsgCycleTime" BO_ 257 20;'),
    "stride": ('"NodeStride" 16', '"NodeStride" 8'),
    "convention": ('VERSION "1"', 'VERSION "2"'),
}


@pytest.fixture
def crc_of(monkeypatch, tmp_path):
    """The CRC by another text of exoid.dbc."""

    def found(text: str) -> int:
        other = tmp_path / "exoid.dbc"
        other.write_bytes(text.encode())
        monkeypatch.setattr(crc_module, "EXOID_DBC", other)
        return config_crc()

    return found


@pytest.fixture
def text():
    return EXOID_DBC.read_text(encoding="utf-8")


@pytest.mark.parametrize("change", COSMETIC)
def test_the_crc_does_not_depend_on_how_the_file_is_written(crc_of, text, change):
    changed = COSMETIC[change](text)
    assert changed != text
    assert crc_of(changed) == crc_of(text)


@pytest.mark.parametrize("change", MEANT)
def test_the_crc_changes_with_what_a_number_means(crc_of, text, change):
    before, after = MEANT[change]
    assert before in text
    assert crc_of(text.replace(before, after)) != crc_of(text)


@pytest.mark.parametrize("name", ["PROCESS_NOISE", "MEASUREMENT_NOISE", "START_VARIANCE"])
def test_the_crc_changes_with_the_filters_constants(monkeypatch, name):
    before = config_crc()
    first, *others = getattr(crc_module, name)
    monkeypatch.setattr(crc_module, name, (first * 1.01, *others))
    assert config_crc() != before


def test_the_crcs_cover_all_that_comes_by_itself(text):
    sent = {name for name, plan in messages_in(text).items() if plan.period}
    assert sent - {*COMMANDED} == {*RECORDED, FINE, *LEARNED}


def test_what_is_learned_has_a_crc_of_its_own(text, tmp_path, monkeypatch):
    """A log of a node that learns otherwise, or not at all, is measured alike and is read."""
    measured, learned = config_crc(), learning_crc()
    other = tmp_path / "exoid.dbc"
    other.write_text(text.replace("(0.00390625,0)", "(0.0078125,0)"), encoding="utf-8")
    assert other.read_text(encoding="utf-8") != text
    monkeypatch.setattr(crc_module, "EXOID_DBC", other)
    assert config_crc() == measured
    assert learning_crc() != learned


@pytest.mark.parametrize("name", [each.name for each in fields(Learning)])
def test_each_number_by_which_a_leg_is_learned_is_in_its_crc(name, monkeypatch):
    before, value = learning_crc(), getattr(LEARNING, name)
    changed = (*value[:-1], value[-1] + 1) if isinstance(value, tuple) else value + 1
    monkeypatch.setattr(crc_module, "LEARNING", replace(LEARNING, **{name: changed}))
    assert learning_crc() != before


def test_the_crc_is_the_published_one():
    assert crc_hqx(b"123456789", crc_module.SEED) == 0x29B1  # CRC-16/CCITT-FALSE
    assert crc_hqx(b"\x01", 0) == crc_module.POLYNOMIAL  # the remainder of x^16 alone


def test_a_node_whose_crc_was_of_the_text_is_read_with_the_filter_that_it_ran():
    assert EARLIER == {0x99CA: "3 states"}
    assert filter_of(0x99CA) == "3 states"
    assert filter_of(config_crc()) == CURRENT == "4 states"
    assert filter_of(0xBEEF) is filter_of(None) is None


def test_the_measured_frames_mean_what_they_meant_to_earlier_nodes(text):
    """Else logs of `EARLIER` would be misread: whoever changes a frame has to take it out there."""
    assert crc_hqx("\n".join(layout(text, (TIME, *SAMPLED))).encode(), SEED) == MEASURED_EARLIER
