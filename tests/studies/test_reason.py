"""What a study's table says of a recording that failed."""

import pytest

from exoid.recordings.loading.load import load
from exoid.studies.engine.reason import reason_of


def test_a_column_of_another_name_is_named_where_a_study_can_name_it(tmp_path):
    path = tmp_path / "drop.csv"
    path.write_text("time_s,Sensor 1\n" + "".join(f"{0.01 * k},{-k % 90}\n" for k in range(300)))
    with pytest.raises(ValueError, match="columns=") as fault:
        load(path)
    assert 'raw_angle_deg = "Sensor 1" below [columns] in its sidecar' in reason_of(fault.value)
