"""`exoid diagnose` as a user runs it: answers, figure, document, page, own terms, refusals."""

import json
import re
from pathlib import Path
from subprocess import CompletedProcess
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import pytest
from command_line import refusal

from exoid.cli.commands.diagnose import telling_apart
from exoid.cli.inputs.again import again
from exoid.mismatch.answer.diagnosis import Suspect
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

TERMS = '''
from typing import Any, ClassVar
import exoid

class Sail(exoid.PhysicsTerm):
    """tau = -b phi'^3."""
    title: ClassVar[str] = "sail"
    reference: ClassVar[str] = "a test"
    explanation: ClassVar[str] = "It flaps."
    isolate: ClassVar[str] = "wind"
    size: Any = exoid.parameter("b", "N m s^3/rad^3", -1.0, 1.0, "size", starts=(0.01,))
    def torque(self, now, memory):
        return -self.size * now.angular_velocity**3
'''


def test_the_command_that_tells_suspects_apart_reads_the_recording_alike():
    each = [Suspect([name], []) for name in ("backlash", "sail", "saturating_damping")]
    options = again(flip="all", column=["time_s=My Time"], terms="mine.py", body_mass=72.0)
    said = telling_apart(SimpleNamespace(suspected=each), [Path("my drops.csv")], LEGS, options)
    assert said[0] == (
        "Which recording tells them apart: exoid plan 'my drops.csv' --between backlash,sail "
        "--flip all --column 'time_s=My Time' --terms mine.py --body-mass 72.0"
    )
    assert telling_apart(SimpleNamespace(suspected=each[:1]), [Path("a.csv")], LEGS, "") == []


def test_no_command_is_printed_that_is_refused_of_a_motor():
    each = SimpleNamespace(suspected=[Suspect(["backlash"], []), Suspect(["sail"], [])])
    motor = recording_of("rig", "measured")
    assert telling_apart(each, [Path("a.csv")], [("a.csv", motor)], "") == []
    left_alone = recording_of("rig", "passive")
    assert telling_apart(each, [Path("a.csv")], [("a.csv", left_alone)], "") != []


def recording_of(subject: str, kind: str) -> Recording:
    """A movement of a second, of a leg or a rig."""
    time = np.linspace(0.0, 1.0, 101)
    torque = np.zeros_like(time) if kind == "measured" else None
    segment = Segment(time, raw_angle=np.sin(time) - 1.0, applied_torque=torque)
    return Recording((segment,), Subject(kind=subject), Protocol(kind=kind), Sensors())


LEGS = [("a.csv", recording_of("leg", "passive"))]


def rubbing(angle: float, seed: int) -> Segment:
    """A drop with dry friction, by Euler's method at 20 kHz: no code of exoid is in it."""
    rng = np.random.default_rng(seed)
    step, steps = 5e-5, 200
    phi, rate, rows = np.radians(angle), 0.0, []
    for _ in range(240):
        rows.append((phi, rate))
        for _ in range(steps):
            pull = -26.0 * np.cos(phi) - 6.0 * phi - 0.8 * rate
            rate += step * pull
            slowed = max(abs(rate) - step * 0.2, 0.0)
            rate = np.sign(rate) * slowed
            phi += step * rate
    motion = np.array(rows) + rng.normal(size=(240, 2)) * [8e-4, 3e-3]
    return Segment(np.arange(240) / 100, raw_angle=motion[:, 0], raw_angular_velocity=motion[:, 1])


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    segments = tuple(rubbing(angle, seed) for seed, angle in enumerate((-10, -30, -45)))
    recording = Recording(
        segments,
        Subject(kind="leg", body_mass=74.0, height=1.78),
        Protocol(kind="passive"),
        Sensors(angle_noise=8e-4, velocity_noise=3e-3),
    )
    path = tmp_path_factory.mktemp("diagnose") / "drops.csv"
    write_table(recording, path)
    return path


class Diagnosed(NamedTuple):
    """What a run said, and what it wrote."""

    done: CompletedProcess[str]
    figure: Path
    document: dict
    page: Path
    kept: Path


@pytest.fixture(scope="module")
def diagnosed(command, table, tmp_path_factory):
    """One run that writes everything: to compile the whole library takes most of its time."""
    folder = tmp_path_factory.mktemp("why")
    kinds = ("png", "json", "html", "nc")
    figure, document, page, kept = (folder / f"why.{suffix}" for suffix in kinds)
    terms = folder / "mine.py"
    terms.write_text(TERMS, encoding="utf-8")
    written = ("--plot", figure, "--json", document, "--report", page, "--save", kept)
    done = command.alone("diagnose", table, *written, "--terms", terms, timeout=600)
    assert done.returncode == 0, done.stderr
    found = json.loads(document.read_text(encoding="utf-8"))
    return Diagnosed(done, figure, found, page, kept)


@pytest.mark.slow
def test_dry_friction_is_found_shown_and_written(diagnosed):
    said = " ".join(diagnosed.done.stdout.split())
    assert "Something is missing" in said
    assert "dry friction" in said
    assert "held-out angle RMSE" in said
    assert diagnosed.figure.stat().st_size > 20_000
    found = diagnosed.document
    assert found["verdict"] == "mismatch"
    assert found["selected"] == ["coulomb_friction"]
    assert found["equivalent"][0] == "coulomb_friction"
    assert found["novel"] is False
    assert found["heldout_rmse_after"] < 1.2 * found["noise_floor"]
    assert found["booked_before"]["damping"]["after"] < found["booked_before"]["damping"]["before"]
    assert {"segment", "from_s", "to_s", "region", "description"} <= found["where"][0].keys()
    assert "sail" in found["ranking"]


@pytest.mark.slow
def test_what_is_saved_gives_the_same_page_and_compares(command, diagnosed, tmp_path):
    page = tmp_path / "again.html"
    again = command("report", diagnosed.kept, "-o", page)
    assert again.returncode == 0, again.stderr
    assert page.read_bytes() == diagnosed.page.read_bytes()
    compared = command("compare", diagnosed.kept, diagnosed.kept)
    assert compared.stdout.count("dry friction") == 2


@pytest.mark.slow
def test_diagnosis_writes_a_page_with_all_of_it(diagnosed):
    found = re.findall(r'<section id="(\w+)"', diagnosed.page.read_text(encoding="utf-8"))
    assert {"summary", "told", "parting", "physics", "proof", "advice"} <= set(found)


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (None, "there is no such file"),
        ("x = 1\n", "no class of exoid.PhysicsTerm"),
        ("import nothing_like_it\n", "ModuleNotFoundError"),
        (TERMS.replace("starts=(0.01,)", "starts=()"), "at least one start"),
        (TERMS.replace("class Sail", "class QuadraticDrag"), "has the name of another"),
    ],
)
def test_terms_that_cannot_be_used_are_refused(command, table, tmp_path, content, why):
    terms = tmp_path / "mine.py"
    if content is not None:
        terms.write_text(content, encoding="utf-8")
    assert why in refusal(command("diagnose", table, "--terms", terms))


def test_an_existing_document_survives_a_failing_run(command, tmp_path):
    kept = tmp_path / "why.json"
    kept.write_text("kept", encoding="utf-8")
    empty = tmp_path / "empty.csv"
    empty.write_text("", encoding="utf-8")
    refusal(command("diagnose", empty, "--json", kept))
    assert kept.read_text(encoding="utf-8") == "kept"


def test_a_figure_of_another_kind_is_refused(command, table, tmp_path):
    assert "must end in" in refusal(command("diagnose", table, "--plot", tmp_path / "why.gif"))
