"""The templates of reports, of a fit and of a study: what they share stands in one of them."""

from collections import Counter
from pathlib import Path

import exoid

TELLING = 30  # letters from which on a line is more than a tag that any page has


def test_no_line_stands_in_two_of_them():
    found = Counter(
        line
        for room in ("report", "studies")
        for path in (Path(exoid.__file__).parent / room).rglob("templates/*.html")
        for line in {each.strip() for each in path.read_text(encoding="utf-8").splitlines()}
        if len(line) >= TELLING
    )
    assert len(found) > 10
    assert [line for line, count in found.items() if count > 1] == []
