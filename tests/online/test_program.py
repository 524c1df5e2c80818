"""How a step is compiled."""

import jax

from exoid.online.model.model import Model
from exoid.online.program import program


def test_a_step_is_one_kernel_and_no_part_of_it_a_call_of_its_own():
    if jax.default_backend() != "cpu":
        return
    text = program(Model()).as_text()
    assert text is not None
    entry = text.split("ENTRY ")[1]
    assert entry.count(" call(") == 1
    assert 'xla_cpu_small_call="true"' in entry
    assert not any(word in entry for word in (" fusion(", " while(", " conditional("))
