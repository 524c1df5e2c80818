"""Every test runs in float64, with the shapes and types annotated in `exoid` checked as it runs."""

import ctypes
import gc
import os
from contextlib import suppress
from pathlib import Path

from machine_code import QUICK

# Tests compile far more than they run: most of their time would go into optimising machine code.
os.environ["XLA_FLAGS"] = f"{os.environ.get('XLA_FLAGS', '')} {QUICK}"
# Several processes keep programs in one folder: with a limit of size [bytes] JAX locks it.
os.environ.setdefault("JAX_COMPILATION_CACHE_MAX_SIZE", str(8 << 30))
# Set for the workers of xdist, which inherit it: in this process NumPy is loaded already. Two
# threads of the linear algebra library take forty times as long over a small matrix as one.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import hypothesis
import jax
import pytest

from checked_types import install

jax.config.update("jax_enable_x64", True)
# Works only before the first import of exoid. Typer gives commands what it does not declare.
ROOMS = (
    *("files", "recordings", "physics", "pendulum", "fitting", "twin"),
    *("trust", "mismatch", "planning", "interchange", "online", "watching", "report", "studies"),
)
install([f"exoid.{room}" for room in ROOMS])

# Tracing makes millions of objects that stay: looking for garbage among them takes a tenth of it.
gc.set_threshold(100_000, 20, 100)

# The same examples in every run; the first one compiles, so no deadline.
hypothesis.settings.register_profile("exoid", derandomize=True, deadline=None, database=None)
hypothesis.settings.load_profile("exoid")

LEAST = 256  # samples
FEW = 4  # starts at once
LITTLE = 1.2e9  # bytes of memory; one test adds up to 0.4e9

SHARED = Path(__file__).parents[2] / "shared" / "data"


@pytest.fixture(scope="session")
def shared():
    """The folder of recordings and logs beside the repository, which a clone does not hold."""
    if not SHARED.is_dir():
        pytest.skip(f"{SHARED} is absent: it holds recordings that are not in the repository")
    return SHARED


@pytest.fixture(scope="session")
def common(tmp_path_factory):
    """A folder of this run that all workers share."""
    base = tmp_path_factory.getbasetemp()
    return base.parent if "PYTEST_XDIST_WORKER" in os.environ else base


@pytest.fixture(scope="session")
def programs(common):
    """Where all workers, and the commands that they run, keep what they compile: most of it serves
    many tests.
    """
    folder = common / "programs"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture(scope="session", autouse=True)
def _keeping(programs):
    """What the tests of this process compile is kept as the commands keep it, and nowhere else."""
    from exoid.fitting.solve.program_cache import keep_programs_in

    os.environ["XDG_CACHE_HOME"] = str(programs)
    keep_programs_in(programs / "exoid" / "programs")


@pytest.fixture(scope="session", autouse=True)
def _alike():
    """Most recordings have one of two shapes, and share their programs: what is beyond the last
    sample weighs nothing, and no fit simulates it. Most fits begin from few starts, and those that
    only fill a batch up would take as long as they do.
    """
    from exoid.fitting.data import observe
    from exoid.fitting.solve import ask

    observe.bucket = roomy
    ask.BATCH = FEW


def roomy(size: int) -> int:
    """A shape for this many samples: one of fewer than users have, and the least is theirs."""
    whole = LEAST
    while whole < size:
        whole *= 4
    return whole


@pytest.fixture(autouse=True)
def _forgetting():
    """What was compiled for past tests goes, once there is much of it."""
    yield
    if resident() > full():
        jax.clear_caches()
        gc.collect()
        with suppress(AttributeError, OSError):  # glibc alone keeps what was freed, and can give it
            ctypes.CDLL(None).malloc_trim(0)


def full() -> float:
    """The memory [bytes] from which on a worker forgets: half of the machine's is theirs. What it
    forgets is traced and loaded anew, which takes longer than most tests.
    """
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    try:
        whole = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGESIZE")
    except (AttributeError, ValueError, OSError):
        return LITTLE
    return max(LITTLE, whole / (2 * workers))


def resident() -> float:
    """The memory of this process [bytes], as far as the system tells."""
    try:
        pages = Path("/proc/self/statm").read_text().split()[1]
    except OSError:
        return float("inf")
    return int(pages) * os.sysconf("SC_PAGESIZE")
