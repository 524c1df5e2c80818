"""`exoid effects`: every term by the name that options take, and each in full."""

from command_line import refusal

from exoid.mismatch.novel.nameless import NAMELESS
from exoid.physics.library import library
from exoid.physics.term import name_of

OWN = """
import jax
import exoid

class Mud(exoid.PhysicsTerm):
    title = reference = explanation = isolate = "mud"
    level: jax.Array = exoid.parameter("D", "N m s/rad", 0.0, 5.0, "drag", (0.1,))
"""


def test_every_effect_has_a_row_with_the_units_of_its_values(command):
    done = command("effects")
    assert (done.returncode, done.stderr) == (0, "")
    assert max(map(len, done.stdout.split("\n"))) <= 80
    first = {line.split(" ")[0] for line in done.stdout.splitlines()}
    assert first >= {name_of(term) for term in library()}
    assert "level [N m]" in done.stdout


def test_one_is_explained_with_its_equation_and_ranges(command):
    said = " ".join(command("effects", "coulomb_friction").stdout.split())
    assert "tau = -F_c sgn(phi')" in said
    assert "level F_c: Friction level, 0 to 50 N m" in said
    assert "Isolated by: drops from a large and from a small angle" in said


def test_whatever_a_diagnosis_may_name_is_listed_and_explained(command):
    first = {line.split(" ")[0] for line in command("effects").stdout.splitlines()}
    assert first >= {name_of(term) for term in NAMELESS}
    said = " ".join(command("effects", "damping_by_angle").stdout.split())
    assert "damped more at one end of its range" in said
    assert "tau = -k phi phi'" in said


def test_ones_own_are_listed_and_others_refused(command, tmp_path):
    mine = tmp_path / "mine.py"
    mine.write_text(OWN, encoding="utf-8")
    assert "mud" in command("effects", "--terms", mine).stdout
    assert "level D: Drag" in command("effects", "mud", "--terms", mine).stdout.replace("  ", " ")
    assert "did you mean coulomb_friction" in refusal(command("effects", "coulom_friction"))
