"""The examples in the docstrings of `exoid.online` give what they show."""

import doctest
import inspect

import numpy as np
import pytest

import exoid
from exoid import online

WITH_EXAMPLE = [
    name for name in online.__all__ if ">>>" in (inspect.getdoc(getattr(online, name)) or "")
]


def test_what_a_stream_needs_has_an_example():
    assert {"init", "step", "replay", "estimates", "Sample", "Model"} <= set(WITH_EXAMPLE)


@pytest.mark.parametrize("name", WITH_EXAMPLE)
def test_an_example_gives_what_it_shows(name):
    space = {"exoid": exoid, "online": online, "np": np}
    text = inspect.getdoc(getattr(online, name)) or ""
    example = doctest.DocTestParser().get_doctest(text, space, name, None, 0)
    said: list[str] = []
    result = doctest.DocTestRunner(verbose=False).run(example, out=said.append)
    assert result.failed == 0, "".join(said)
