"""A rehearsal asks for the programs that a diagnosis asks for while it tests all causes."""

import pytest
from diagnosis_cases import session

from exoid.fitting.solve import program_cache
from exoid.mismatch.missing_physics import diagnose
from exoid.mismatch.rehearsal import rehearse

TESTING = ("along", "act")


@pytest.mark.slow
def test_what_tests_all_causes_was_rehearsed(monkeypatch):
    asked, program = set(), program_cache.program

    def heard(*wanted):
        asked.add(wanted)
        return program(*wanted)

    heard.cache_clear = program.cache_clear
    monkeypatch.setattr(program_cache, "program", heard)
    drops = session()  # whose programs other tests ask for, too
    rehearse([("drops", drops)])
    rehearsed, asked = asked, set()
    diagnose(drops, multistart=4)
    wanted = {each for each in asked if each[0].partition(":")[2] in TESTING}
    assert len(wanted) > 20
    assert wanted <= rehearsed
    assert {each for each in asked if each[0].endswith(":deviate")} & rehearsed
