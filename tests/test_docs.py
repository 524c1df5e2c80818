"""Every block of the site runs as it stands, page by page, in a folder of its own.

Python is executed, commands are run, sidecars and DBC files are read, and what is shown of an
answer is looked for in it. A block with a caption is first written to a file of that name. Blocks
of the class `hardware` need a node, a network or a compiler, those of the class `long` minutes: of
both only commands and options are checked.
"""

import re
import shlex
from contextlib import redirect_stdout
from dataclasses import dataclass
from importlib import import_module
from io import StringIO
from pathlib import Path

import numpy as np
import pytest

from exoid.cli import app
from exoid.recordings.declared.entry import known
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.sidecar import read_sidecar

COMMANDS = {name: app.load(name) for name in app.COMMANDS}
DOCS = Path(__file__).parents[1] / "docs"
# Pages that fit often, or diagnose.
SLOW = (
    "tutorial.md",
    "model.md",
    *(
        f"how-to/{each}.md"
        for each in ("extended-model", "own-term", "python", "several-recordings")
    ),
)
PAGES = [
    pytest.param(page, marks=pytest.mark.proof) if page in SLOW else page
    for page in sorted(each.relative_to(DOCS).as_posix() for each in DOCS.rglob("*.md"))
]
FENCE = re.compile(r"^```(?:\{code-block\} )?(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
OPTION = re.compile(r"^:(\w+): (.*)\n", re.MULTILINE)
LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)")  # to a file of the repository
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
SHOWN_WITHIN = 0.1  # relative, of numbers in an answer: errors have two digits


@dataclass(frozen=True)
class Block:
    """A fenced block: its language, options, and text."""

    language: str
    options: dict[str, str]
    text: str


def blocks_of(page: str) -> list[Block]:
    """The blocks of a page, in order."""
    found = FENCE.findall((DOCS / page).read_text(encoding="utf-8"))
    return [
        Block(language, dict(OPTION.findall(body)), OPTION.sub("", body).lstrip("\n"))
        for language, body in found
    ]


class Reader:
    """A person who does what a page says, from top to bottom."""

    def __init__(self, folder: Path):
        self.folder, self.space, self.answer = folder, {"__name__": "page"}, ""

    def follow(self, block: Block) -> None:
        caption = block.options.get("caption")
        if caption is not None:
            (self.folder / caption).write_text(block.text, encoding="utf-8")
        if block.options.get("class") in ("hardware", "long"):
            self.look_up(block.text)
        elif block.language == "sh":
            self.answer = "".join(map(self.run, commands(block.text)))
        elif block.language == "python" and caption is None:
            exec(compile(block.text, "page", "exec"), self.space)
        elif block.language == "toml":
            self.read_sidecar(block.text)
        elif block.language == "text" and caption is None:
            self.check(block.text)

    def run(self, arguments: list[str]) -> str:
        """The command in this process, where programs that are compiled serve again."""
        said = StringIO()
        with redirect_stdout(said):
            COMMANDS[arguments[0]](arguments[1:], standalone_mode=False)
        return said.getvalue()

    def look_up(self, text: str) -> None:
        """Commands of exoid parse, with all their options and values."""
        for arguments in commands(text):
            parse(COMMANDS[arguments[0]], *arguments)

    def read_sidecar(self, text: str) -> None:
        path = self.folder / "block.toml"
        path.write_text(text, encoding="utf-8")
        assert read_sidecar(path)[3] == ()  # nothing is unknown

    def check(self, excerpt: str) -> None:
        """Every line that is shown was said, however it was wrapped, its numbers up to rounding."""
        for line in excerpt.splitlines():
            shown = [float(each) for each in NUMBER.findall(line)]
            said = [
                list(map(float, one.groups())) for one in re.finditer(pattern_of(line), self.answer)
            ]
            assert any(np.allclose(one, shown, rtol=SHOWN_WITHIN) for one in said), (
                f"{line!r} is not in\n{self.answer}"
            )


def parse(command, name: str, *arguments: str) -> None:
    """A command, or one of a group, with its options."""
    below = getattr(command, "commands", {})
    if below:
        parse(below[arguments[0]], *arguments)
    else:
        command.make_context(name, list(arguments))


def commands(text: str) -> list[list[str]]:
    """The arguments of every line that calls exoid."""
    lines = [shlex.split(line, comments=True) for line in text.splitlines()]
    return [words[1:] for words in lines if words[:1] == ["exoid"]]


def pattern_of(line: str) -> str:
    """The line with any numbers and any space; its groups are the numbers."""
    tokens = re.findall(rf"{NUMBER.pattern}|\S", line)
    parts = [
        f"({NUMBER.pattern})" if NUMBER.fullmatch(each) else re.escape(each) for each in tokens
    ]
    return r"\s*".join(parts)


@pytest.mark.parametrize("page", PAGES)
def test_what_a_page_shows_runs(page, programs, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(programs))
    monkeypatch.setenv("COLUMNS", "90")
    reader = Reader(tmp_path)
    for block in blocks_of(page):
        reader.follow(block)


@pytest.mark.parametrize("page", PAGES)
def test_a_page_has_no_block_that_is_passed_over(page):
    for block in blocks_of(page):
        assert block.language in {"python", "sh", "toml", "text"}
        if block.language == "sh" and "class" not in block.options:
            assert all(line.startswith("exoid ") for line in block.text.splitlines())


def test_links_lead_to_files():
    root = DOCS.parent
    pages = [*root.glob("*.md"), *(root / "firmware").glob("*.md"), *DOCS.rglob("*.md")]
    linked = [(page, each) for page in pages for each in LINK.findall(page.read_text("utf-8"))]
    assert len(linked) > 100
    assert [(p.name, each) for p, each in linked if not (p.parent / each).exists()] == []


@pytest.mark.parametrize("module", ["exoid", "exoid.online"])
def test_every_public_name_is_in_the_reference(module):
    parts = (DOCS / "api.md").read_text(encoding="utf-8").split(".. currentmodule:: ")
    own = "".join(part for part in parts if part.partition("\n")[0] == module)
    named = re.findall(r"^\.\. auto\w+:: (\w+)$", own, re.MULTILINE)
    assert sorted(named) == sorted(import_module(module).__all__)


def test_every_column_and_key_is_explained():
    page = (DOCS / "recording-format.md").read_text(encoding="utf-8")
    tables = (Segment, Subject, Protocol, Sensors)
    said = [entry.metadata for table in tables for entry in known(table)]
    for name in (each.get("column") or each["key"] for each in said):
        assert f"`{name}`" in page, name
