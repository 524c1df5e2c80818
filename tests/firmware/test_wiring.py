"""The picture of the wiring is what its script draws, with the pins of the firmware."""

import importlib.util
import re

import pytest
from firmware_tools import FIRMWARE

DOCS = FIRMWARE.parent / "docs"
README = (FIRMWARE / "README.md").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def wiring():
    found = importlib.util.spec_from_file_location("wiring", DOCS / "wiring.py")
    assert found is not None
    assert found.loader is not None
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


def test_the_picture_is_what_its_script_draws(wiring):
    told = "run: python docs/wiring.py"
    assert wiring.PICTURE.read_text(encoding="utf-8") == wiring.picture(), told


def test_picture_and_table_agree_on_every_pin(wiring):
    rows = re.findall(r"^\| ([\w. ]+?)(?: \(\w+\))? \| (.*?) ?\| (.*?) ?\|$", README, re.MULTILINE)
    table = {ours: (encoder, controller) for ours, encoder, controller in rows}
    for theirs, ours, _ in wiring.wires_to_encoder():
        assert set(re.findall(r"\w+", theirs)) <= set(re.findall(r"\w+", table[ours][0]))
    for ours, theirs, _ in wiring.wires_to_controller():
        assert table[ours][1] == theirs
    assert f"{wiring.pin('STATUS_LED_PIN')} goes over 1 kilohm to a status LED" in README


def test_the_axes_are_a_right_handed_set_and_z_is_where_extension_goes(wiring):
    (x0, y0), (x1, y1) = wiring.along(wiring.NOW, 0), wiring.along(wiring.NOW, 1)
    along = (x1 - x0, y0 - y1)  # the picture's second axis points down
    ahead = wiring.along(wiring.NOW, 0, 1)
    across = (ahead[0] - x0, y0 - ahead[1])
    # z times x is y: negative is away from who looks at the picture.
    assert across[0] * along[1] - across[1] * along[0] == pytest.approx(-1.0)
    later = wiring.along(wiring.NOW + 1, 1)  # a degree of extension
    moved = (later[0] - x1, y1 - later[1])
    assert moved[0] * across[0] + moved[1] * across[1] > 0
