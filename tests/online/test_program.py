"""How a step is compiled, and kept."""

import jax
import numpy as np
import pytest

from exoid import online
from exoid.fitting.solve import program_cache
from exoid.online import program

SAMPLE = online.Sample(0.0, -0.35, 0.01)


@pytest.fixture
def folder(monkeypatch, tmp_path):
    """Where this test keeps programs; none is in memory."""
    monkeypatch.setattr(program_cache, "_folder", [tmp_path])
    program.program.cache_clear()
    yield tmp_path
    program.program.cache_clear()


def test_a_step_is_one_kernel_and_no_part_of_it_a_call_of_its_own():
    if jax.default_backend() != "cpu":
        return
    text = program.compiled(online.Model()).as_text()
    assert text is not None
    entry = text.split("ENTRY ")[1]
    assert entry.count(" call(") == 1
    assert 'xla_cpu_small_call="true"' in entry
    assert not any(word in entry for word in (" fusion(", " while(", " conditional("))


def test_the_next_process_traces_nothing_and_says_the_same_to_the_last_bit(
    folder, monkeypatch, start
):
    made, said = online.step(start, SAMPLE)
    assert len(list(folder.iterdir())) == 1
    program.program.cache_clear()
    monkeypatch.setattr(program, "compiled", lambda model: pytest.fail("it is traced again"))
    loaded, again = online.step(start, SAMPLE)
    assert np.array_equal(loaded.numbers, made.numbers, equal_nan=True)
    assert np.array_equal(again.ratios, said.ratios)


def test_another_model_has_a_program_of_its_own(folder, monkeypatch):
    made = []
    monkeypatch.setattr(program, "kept", lambda known, results, make: made.append(known))
    for node in (online.Node(), online.Node(tilt=0.01)):
        program.program(online.Model(node=node))
    assert made[0].static != made[1].static
    assert made[0].shapes == made[1].shapes
