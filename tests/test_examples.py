"""Every example runs as it stands, and prints what its page of the site shows."""

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[1]
PAGES = ROOT / "docs" / "examples"
NAMES = sorted(set(path.stem for path in (ROOT / "examples").glob("*.py")) - {"make_example"})
SLOW = ("diagnosis_to_model", "own_term")  # they diagnose
SHOWN = re.compile(r"^```\{code-block\} text\n:caption: prints\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.(\d+))?(?:e[-+]?\d+)?")
SHOWN_WITHIN = 0.1  # relative, and one in the last digit: errors have two digits
LONGEST = 60  # lines


def page_of(name: str) -> str:
    return (PAGES / f"{name.replace('_', '-')}.md").read_text(encoding="utf-8")


def close(shown: re.Match, printed: re.Match) -> bool:
    last = 10.0 ** -len(shown[1] or "") if "e" not in shown[0] else 0.0
    return bool(np.isclose(float(printed[0]), float(shown[0]), rtol=SHOWN_WITHIN, atol=last))


def check(shown: str, printed: str) -> None:
    """The same words, and numbers that are the same up to rounding."""
    assert NUMBER.sub("#", printed) == NUMBER.sub("#", shown)
    for pair in zip(NUMBER.finditer(shown), NUMBER.finditer(printed), strict=True):
        assert close(*pair), f"{pair[1][0]} is shown as {pair[0][0]}"


@pytest.mark.parametrize(
    "name",
    [pytest.param(each, marks=pytest.mark.proof) if each in SLOW else each for each in NAMES],
)
def test_an_example_prints_what_its_page_shows(name, tmp_path):
    script = ROOT / "examples" / f"{name}.py"
    done = subprocess.run(
        [sys.executable, script], cwd=tmp_path, capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    (shown,) = SHOWN.findall(page_of(name))
    check(shown, done.stdout)


@pytest.mark.parametrize("name", NAMES)
def test_an_example_is_short_and_has_a_page(name):
    script = (ROOT / "examples" / f"{name}.py").read_text(encoding="utf-8")
    assert len(script.splitlines()) <= LONGEST
    assert f"{{literalinclude}} ../../examples/{name}.py" in page_of(name)
    assert f"({name.replace('_', '-')}.md)" in (PAGES / "index.md").read_text(encoding="utf-8")


def test_another_word_or_number_is_noticed():
    check("J = 0.4397 ± 0.0023 kg m^2\n", "J = 0.4398 ± 0.0022 kg m^2\n")
    for printed in ("J = 0.52 ± 0.0023 kg m^2\n", "d = 0.4397 ± 0.0023 kg m^2\n"):
        with pytest.raises(AssertionError):
            check("J = 0.4397 ± 0.0023 kg m^2\n", printed)
