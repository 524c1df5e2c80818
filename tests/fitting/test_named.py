"""What a result has by name."""

import pytest

from exoid.files.named import Named


def test_a_misspelt_name_is_answered_with_the_one_it_resembles_and_all_others():
    found = Named(mass=4.0, inertia=0.4)
    assert found["mass"] == 4.0
    assert found | {"damping": 1.0} == {"mass": 4.0, "inertia": 0.4, "damping": 1.0}
    with pytest.raises(KeyError, match=r"'intertia' is none of mass, inertia\. Did you mean in"):
        found["intertia"]
    assert "intertia" not in found
    assert found.get("intertia") is None
