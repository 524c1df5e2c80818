"""What an answer that cannot tell lists as causes that it may be."""

from unittest.mock import Mock

from found_by_hand import explaining, found_of

from exoid.mismatch.conclude import rivals
from exoid.physics.terms.device.coulomb_friction import CoulombFriction


def test_that_nothing_is_missing_is_no_suspect(monkeypatch):
    """Where Eq. 9 alone explains as much, it was a cause without a name, and a column without a
    head.
    """
    for told in ("moved", "parameters_of"):
        monkeypatch.setattr(rivals, told, Mock(return_value=[]))
    rubbed = explaining(100_000.0, CoulombFriction)
    found = found_of([rubbed])
    told = rivals.suspects(found, [found.base, rubbed], found.base)
    assert [one.terms for one in told] == [["coulomb_friction"]]
