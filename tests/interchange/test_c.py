"""The exported header computes what NumPy does in single precision, to the last bit."""

import re
import shutil
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest
from joints import SEGMENT, TERMS, case, of_term, part_named, usual

from exoid.interchange.formats.c import c, memory_of, torques
from exoid.interchange.formula.expression import evaluate
from exoid.interchange.formula.single import single
from exoid.interchange.model.formulas import undriven
from exoid.interchange.model.joint import Joint

STILL = 0.02  # rad/s, EXOID_LEG_STILL
ULP = float(np.finfo(np.float32).eps)
FLAGS = ("-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffp-contract=off", "-O2")
COMPILERS = [("gcc", "-std=c99"), ("g++", "-std=c++11")]
REFUSED = {
    "backlash": "it is a body that moves by itself",
    "cuff_compliance": "it is a body that moves by itself",
    "moving_base": "it hangs on the acceleration",
    "polycentric_axis": "it hangs on the acceleration",
    "power_drag": "it computes log, which takes a mathematics library",
    "wobbling_mass": "it hangs on the acceleration",
}
HELD = [name for name in TERMS if name not in (*REFUSED, "clock_rate")]
REMEMBERING = ("hysteresis", "maxwell_element", "shaped_hysteresis", "stretch_reflex")
SAMPLES = 60
BEGUN = "        const exoid_leg_memory memory = exoid_leg_begun;\n"
READER = """
#include <stdio.h>
#include <string.h>
#include "exoid_leg.h"
int main(void)
{{
    float in[4], out[{count}];
    while (fread(in, sizeof in, 1, stdin) == 1) {{
        const float angle = in[0], rate = in[1], acceleration = in[2], seconds = in[3];
{memory}        (void)angle, (void)rate, (void)acceleration, (void)seconds;
{outputs}
        fwrite(out, sizeof out, 1, stdout);
    }}
    return 0;
}}
"""


def compiled(joint: Joint, folder: Path, calls: list[str], compiler=COMPILERS[0]) -> Path:
    """A program that answers angle, rate, acceleration and seconds with these calls."""
    name, standard = compiler
    if shutil.which(name) is None:
        pytest.skip(f"{name} is absent: no compiler tries the header")
    text = c(joint).text
    (folder / "exoid_leg.h").write_text(text, encoding="utf-8")
    begun = BEGUN if any("memory" in call for call in calls) else ""
    lines = "\n".join(f"        out[{at}] = {call};" for at, call in enumerate(calls))
    source = folder / ("main.c" if name == "gcc" else "main.cpp")
    source.write_text(READER.format(count=len(calls), memory=begun, outputs=lines))
    program = folder / "main"
    subprocess.run([name, standard, *FLAGS, source, "-o", program], check=True, cwd=folder)
    return program


def asked(program: Path, rows: np.ndarray) -> np.ndarray:
    """The answers to rows of four."""
    done = subprocess.run(
        [program], input=rows.astype("<f4").tobytes(), capture_output=True, check=True
    )
    return np.frombuffer(done.stdout, "<f4").reshape(len(rows), -1)


def some_rows(seed: int = 3) -> np.ndarray:
    """Angles, rates, accelerations and times of a leg, and where formulas change."""
    random = np.random.default_rng(seed)
    rows = random.uniform([-2.4, -8, -40, 1e-4], [0.4, 8, 40, 2e-3], (SAMPLES, 4))
    special = [
        [-np.pi / 2, 0, 0, 1e-3],
        [0, STILL, 0, 1e-3],
        [np.pi / 2, -0.0, 1, 0],
        [7, -9, 1, 0],
    ]
    return np.vstack([rows, special]).astype(np.float32)


def values(joint: Joint, row: np.ndarray) -> dict:
    begun = {
        f"{part.name}_memory_{at}": value
        for part in joint.parts
        for at, value in enumerate(part.begun)
    }
    state = {"angle": row[0], "rate": row[1], "seconds": row[3], "still": STILL}
    return joint.constants | begun | state


def twin(joint: Joint, row: np.ndarray) -> np.float32:
    """The feed-forward torque by NumPy, every operation in single precision."""
    own = undriven(joint.parts)
    acting = [part for part in own if part.pushes and not part.term.voluntary]
    resting = [part for part in acting if part.torque.value != 0.0]
    at, passive = values(joint, row), None
    for formula in torques(joint, resting).values():
        one = single(formula, at)
        passive = one if passive is None else np.float32(passive + one)
    assert passive is not None  # gravity is always there
    wanted = np.float32(np.float32(joint.value["inertia"]) * np.float32(row[2]))
    return np.float32(wanted - passive)


def memory_argument(joint: Joint) -> str:
    return ", memory" if any(part.name in REMEMBERING for part in joint.parts) else ""


@pytest.mark.parametrize("name", HELD)
def test_the_feed_forward_is_numpys_to_the_last_bit(name, tmp_path):
    made = of_term(name).joint
    call = f"exoid_leg_feed_forward(angle, rate, acceleration{memory_argument(made)})"
    rows = some_rows()
    found = asked(compiled(made, tmp_path, [call]), rows)[:, 0]
    wanted = np.array([twin(made, row) for row in rows])
    assert (found.view(np.uint32) == wanted.view(np.uint32)).all()


@pytest.mark.parametrize("compiler", COMPILERS)
def test_every_torque_alone_is_numpys_to_the_last_bit_in_c_and_in_cpp(compiler, tmp_path):
    names = ("coulomb_friction", "end_range_stiffening", "quadratic_drag", "hard_stop")
    made = case(*(usual(TERMS[name]) for name in names)).joint
    calls = {
        "gravity": "exoid_leg_gravity(angle)",
        "stiffness": "exoid_leg_stiffness(angle)",
        "damping": "exoid_leg_damping(rate)",
        "friction": "exoid_leg_friction(angle, rate)",
        **{name: f"exoid_leg_{name}(angle, rate)" for name in names[1:]},
    }
    rows = some_rows()
    found = asked(compiled(made, tmp_path, [*calls.values()], compiler), rows)
    formulas = torques(made, [part_named(made, name) for name in names[1:]])
    for column, name in enumerate(calls):
        wanted = np.array([single(formulas[name], values(made, row)) for row in rows])
        assert (found[:, column].view(np.uint32) == wanted.view(np.uint32)).all(), name


@pytest.mark.parametrize("name", HELD)
def test_single_precision_is_close_to_double(name):
    """Some sixty operations, each off by half a unit of what is largest on the way."""
    made = of_term(name).joint
    own = [part for part in undriven(made.parts) if not part.term.voluntary]
    parts = [part for part in own if part.torque.value != 0.0]
    for row in some_rows()[:SAMPLES]:
        at = values(made, row) | {"inertia": made.value["inertia"]}
        each = [float(evaluate(one, at)) for one in torques(made, parts).values()]
        exact = made.value["inertia"] * float(row[2]) - sum(each)
        size = max(*map(abs, each), abs(made.value["inertia"] * float(row[2])))
        assert abs(twin(made, row) - exact) < 60 * ULP * size


@pytest.mark.parametrize("name", REMEMBERING)
def test_what_is_remembered_goes_on_as_numpy_has_it(name, tmp_path):
    made = of_term(name).joint
    (part,) = made.parts
    step = "exoid_leg_remembered(memory, angle, rate, seconds)"
    calls = [f"{step}.{name}[{at}]" for at in range(part.begun.size)]
    rows = some_rows()
    found = asked(compiled(made, tmp_path, calls), rows)
    formulas = memory_of([part])
    for row, entries in zip(rows, found, strict=True):
        at = values(made, row)
        moved = {
            f"{name}_memory_{k}": single(formulas[f"{name}[{k}]"], at) for k in range(len(entries))
        }
        wanted = [single(formulas[f"{name}[{k}] within"], at | moved) for k in range(len(entries))]
        assert entries.tolist() == [float(each) for each in wanted]


@pytest.mark.parametrize("name", REFUSED)
def test_what_no_feed_forward_can_have_is_refused_by_name(name):
    with pytest.raises(ValueError, match=f"no feed-forward for {name} .*: {REFUSED[name]}. Exp"):
        c(of_term(name).joint)


def test_the_limits_hold_whatever_is_wanted(tmp_path):
    """before is the rate, wanted the angle: 5 N m and 20 N m/s are what nobody set otherwise."""
    program = compiled(case().joint, tmp_path, ["exoid_leg_limited(angle, rate, seconds)"])
    nan, inf = np.nan, np.inf
    sound = [[9, 4.9, 0, 1], [9, 0, 0, 0.01], [-9, 0, 0, 0.01], [0.1, 0, 0, 0.01], [-9, -5, 0, 1]]
    broken = [[nan, 1, 0, 1], [1, nan, 0, 1], [1, 0, 0, nan], [1, 0, 0, -1], [inf, 0, 0, 0.01]]
    rows = np.array([*sound, *broken])
    found = asked(program, rows)[:, 0]
    wanted = np.float32([5, 0.2, -0.2, 0.1, -5, 0, 0, 0, 0, 0.2])
    assert np.abs(found - wanted).max() < ULP


def test_no_number_breaks_it(tmp_path):
    """What a broken sensor says gives no number, and no undefined behaviour."""
    program = compiled(case().joint, tmp_path, ["exoid_leg_gravity(angle)"])
    found = asked(program, np.array([[np.nan] * 4, [np.inf] * 4, [1e30] * 4]))[:, 0]
    assert np.isnan(found[:2]).all()
    assert struct.calcsize("f") == 4


def test_the_header_says_what_it_is_not_and_what_every_number_rests_on():
    text = c(case(usual(TERMS["coulomb_friction"])).joint).text
    assert "THIS IS NO SAFETY FUNCTION" in text
    assert re.search(r"#define EXOID_LEG_COULOMB_FRICTION_LEVEL 0.05f /\* F_c: ± 0.1 N m, ", text)
    assert not re.search(r"#include|malloc|double", text)
    assert of_term("fatigue").joint.number == SEGMENT
