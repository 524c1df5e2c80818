"""Programs kept between processes: found again, bitwise the same, and never a reason to fail."""

import hashlib
import importlib.util
import re
import sys
import warnings
import zlib
from pathlib import Path

import grimp
import jax
import numpy as np
import pytest
from jax.experimental import serialize_executable

import exoid
from exoid.fitting.data.conditioning_chain import MovingAverage, Raw
from exoid.fitting.estimate import fit
from exoid.fitting.solve import program_cache as program
from exoid.fitting.solve.compiled import kept_program, machine_code
from exoid.mismatch.novel.dictionary import dictionary
from exoid.mismatch.novel.formula import Formula, term_of
from fit_cases import DROP, recorded

KEPT = f"*{kept_program.KEPT}"
PROGRAM = re.compile(r'"(exoid\.[\w.]+):\w+"')  # how a compiled function is named
SETTINGS = (
    "jax_compilation_cache_dir",
    "jax_persistent_cache_min_compile_time_secs",
    "jax_persistent_cache_min_entry_size_bytes",
)


@pytest.fixture(autouse=True)
def _as_before():
    """JAX and the program as they were, whatever a test has set."""
    before = {name: getattr(jax.config, name) for name in SETTINGS}
    folder = list(program._folder)
    program._folder.clear()
    yield
    for name, value in before.items():
        jax.config.update(name, value)
    begin_anew()
    program._folder[:] = folder


def fingerprint(name, structure, shapes, static, options=machine_code.LEAN) -> str:
    return kept_program.fingerprint(kept_program.Known(name, structure, shapes, static, options))


def begin_anew():
    """Forget what this process has compiled, as a new one would not know it."""
    from jax.experimental.compilation_cache import compilation_cache

    program.program.cache_clear()
    compilation_cache.reset_cache()


@pytest.fixture(scope="module")
def drop():
    return recorded(DROP)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("programs")


def numbers(drop, folder: Path) -> np.ndarray:
    """All of a fit's values and errors, by a process that keeps its programs in `folder`."""
    begin_anew()
    program.keep_programs_in(folder)
    found = program.with_sound_programs(lambda: fit([("leg", drop)], multistart=2))
    each = [*found.parameters.values(), *found.ratios.values()]
    return np.array([(one.value, one.standard_error) for one in each], dtype=float)


def test_programs_of_two_formulas_are_not_taken_for_each_other():
    """Both are classes of the same name, with as many parameters."""
    plain = [feature for feature in dictionary() if not feature.shape]
    first, second = ((term_of(Formula((feature,), np.ones(1), 1.0, 0.0)),) for feature in plain[:2])
    structure = jax.tree.structure((1.0,))
    kept = [fingerprint("program", structure, (), each) for each in (first, second)]
    assert kept[0] != kept[1]
    again = (term_of(Formula((plain[0],), np.zeros(1), 1.0, 0.0)),)
    assert fingerprint("program", structure, (), again) == kept[0]  # of another size


def test_a_kept_program_is_found_again_and_gives_bitwise_the_same(drop, folder, monkeypatch):
    traced = numbers(drop, folder)
    kept = sorted(folder.glob(KEPT))
    assert len(kept) == 2  # the solver, and the sensitivities behind the errors
    written = [each.stat().st_mtime_ns for each in kept]
    monkeypatch.setattr(program, "compiled", None)  # to compile again would fail
    np.testing.assert_array_equal(numbers(drop, folder), traced)
    assert [each.stat().st_mtime_ns for each in kept] == written


@pytest.mark.parametrize("damage", [lambda c: c[:1000], lambda c: b"", lambda c: b"foreign" * 99])
def test_a_damaged_program_is_traced_anew_and_replaced(drop, folder, damage):
    before = numbers(drop, folder)
    kept = max(folder.glob(KEPT), key=lambda each: each.stat().st_size)
    kept.write_bytes(damage(kept.read_bytes()))
    np.testing.assert_array_equal(numbers(drop, folder), before)
    digest, content = np.split(np.frombuffer(kept.read_bytes(), np.uint8), [kept_program.DIGEST])
    assert hashlib.sha256(content.tobytes()).digest() == digest.tobytes()
    assert [path.suffix for path in folder.glob("*.part")] == []


def test_what_xla_kept_and_cannot_read_is_replaced(tmp_path):
    """Of what is compiled beside the programs that are kept here."""

    def tripled() -> float:
        begin_anew()
        program.keep_programs_in(tmp_path)
        return program.with_sound_programs(lambda: float(jax.jit(lambda x: 3.0 * x)(2.0)))

    assert tripled() == 6.0
    (compiled,) = tmp_path.glob("*lambda*-cache")
    compiled.write_bytes(compiled.read_bytes()[:100])
    assert tripled() == 6.0
    assert compiled.stat().st_size > 100


def test_another_warning_is_not_mistaken_for_an_unreadable_program(tmp_path):
    program.keep_programs_in(tmp_path)
    (tmp_path / "kept-cache").touch()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match="something else"):
            program.with_sound_programs(lambda: warnings.warn("something else", stacklevel=1))
    assert (tmp_path / "kept-cache").exists()


def test_a_folder_that_cannot_be_made_keeps_nothing(tmp_path):
    (tmp_path / "file").touch()
    program.keep_programs_in(tmp_path / "file" / "programs")
    assert program._folder == []


def doubled() -> jax.stages.Compiled:
    """A program, fresh from the compiler."""
    leaf = jax.tree.structure((0.0,))
    return machine_code.compiled("operator:mul", leaf, [((), "float32")], 2.0, brief=True)


def test_a_program_that_cannot_be_written_is_not_kept(tmp_path):
    kept_program.store(tmp_path / "nowhere" / "a.program", doubled())
    assert list(tmp_path.iterdir()) == []


def test_only_what_is_whole_is_loaded(tmp_path):
    path = tmp_path / "a.program"
    kept_program.store(path, doubled())
    loaded = kept_program.load(path, 1, 1)
    assert loaded is not None
    assert [float(each) for each in loaded(np.float32(3.0))] == [6.0]
    flipped = bytearray(path.read_bytes())
    flipped[-7] ^= 1
    path.write_bytes(flipped)
    assert kept_program.load(path, 1, 1) is None
    assert kept_program.load(tmp_path / "missing.program", 1, 1) is None


def test_what_is_whole_but_no_program_is_not_loaded(tmp_path):
    """As XLA itself refuses what another build of it has written."""
    path = tmp_path / "a.program"
    kept_program.store(path, doubled())
    code = serialize_executable.serialize(doubled())[0]
    foreign = zlib.compress(code.replace(b"ELF", b"FLE"))
    path.write_bytes(hashlib.sha256(foreign).digest() + foreign)
    assert kept_program.load(path, 1, 1) is None


def test_the_same_program_is_kept_anew_beside_xlas_own_cache(tmp_path):
    """What XLA loads from its cache it cannot write once more: it would fail where it runs."""
    program.keep_programs_in(tmp_path)
    jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.0)
    for name in ("a.program", "b.program"):
        kept_program.store(tmp_path / name, doubled())
        loaded = kept_program.load(tmp_path / name, 1, 1)
        assert loaded is not None
        assert [float(each) for each in loaded(np.float32(3.0))] == [6.0]


def test_the_fingerprint_tells_everything_apart_that_changes_a_program(tmp_path, monkeypatch):
    shape = ((3,), "float64")
    structures = [jax.tree.structure(each) for each in ((0, 1), [0, 1])]
    prints = [
        fingerprint("solve", structures[0], (shape,), Raw()),
        fingerprint("solve", structures[1], (shape,), Raw()),
        fingerprint("solve", structures[0], (shape, shape), Raw()),
        fingerprint("solve", structures[0], (shape,), MovingAverage(3)),
        fingerprint("solve", structures[0], (shape,), MovingAverage(4)),
    ]
    prints.append(fingerprint("sense_all", structures[0], (shape,), Raw()))
    for text in ("a = 1", "a = 2"):
        source = tmp_path / text / "recordings" / "constants.py"
        source.parent.mkdir(parents=True)
        source.write_text(text)
        monkeypatch.setattr(
            kept_program,
            "__file__",
            str(tmp_path / text / "fitting" / "solve" / "compiled" / "kept.py"),
        )
        prints.append(fingerprint("solve", structures[0], (shape,), Raw()))
    prints.append(fingerprint("solve", structures[0], (shape,), Raw(), machine_code.BRIEF))
    for name in ("libraries", "machine"):
        monkeypatch.setattr(kept_program, name, lambda: ("another",))
        prints.append(fingerprint("solve", structures[0], (shape,), Raw()))
    assert len(set(prints)) == len(prints)


def test_all_that_a_program_imports_is_in_its_fingerprint():
    graph = grimp.build_graph("exoid")
    home = Path(exoid.__file__).parent
    seen = set(kept_program.sources(home))
    names = {each for path in home.rglob("*.py") for each in PROGRAM.findall(path.read_text())}
    assert "exoid.mismatch.screen.pinned" in names
    for name in names:
        for module in {name, *graph.find_upstream_modules(name)}:
            place = home.parent / module.replace(".", "/")
            assert {place.with_suffix(".py"), place / "__init__.py"} & seen, f"{name}: {module}"


def test_a_kept_program_depends_on_the_code_of_a_users_own_class(tmp_path):
    def prints(value):
        path = tmp_path / "mine.py"
        path.write_text(f"class Own:\n    value = {value}\n", encoding="utf-8")
        spec = importlib.util.spec_from_file_location("mine", path)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules["mine"] = module
        spec.loader.exec_module(module)
        return fingerprint("release", jax.tree.structure(()), (), ((module.Own,), Raw()))

    assert prints(1) != prints(2)
    sys.modules.pop("mine")


def test_a_program_with_a_class_typed_into_a_notebook_is_not_kept(tmp_path, monkeypatch):
    monkeypatch.setattr(program, "_folder", [tmp_path])
    space: dict = {"__name__": "no_module"}
    exec("class Typed:\n    pass", space)
    number, leaf = ((), "float64"), jax.tree.structure((0.0,))
    kept = program.program("operator:is_", leaf, (number,), (space["Typed"],), 1)
    assert callable(kept)
    assert not list(tmp_path.iterdir())


def test_what_xla_flags_ask_for_holds_here_too(monkeypatch):
    level, fusion, split = machine_code.LEAN
    monkeypatch.setenv("XLA_FLAGS", f"--{level}=3 --other=1 --{split}=2")
    assert machine_code.options(brief=False) == {fusion: machine_code.LEAN[fusion]}
    assert machine_code.options(brief=True) == {fusion: machine_code.BRIEF[fusion]}


def test_options_that_xla_does_not_know_cost_nothing_but_time(monkeypatch):
    monkeypatch.delenv("XLA_FLAGS", raising=False)
    machine_code.understood.cache_clear()
    assert machine_code.understood(brief=False) == machine_code.LEAN
    assert machine_code.understood(brief=True) == machine_code.BRIEF
    machine_code.understood.cache_clear()
    monkeypatch.setattr(machine_code, "LEAN", {"no_such_option": 1})
    assert machine_code.understood(brief=False) == {}
    machine_code.understood.cache_clear()
