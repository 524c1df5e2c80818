"""Builds the firmware's test programs, each once, and skips what this machine has no tools for.

Commands are called as those of the command line's tests are.
"""

import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from firmware_tools import QEMU, QEMU_M7, make, need

sys.path.append(str(Path(__file__).parents[1] / "cli"))  # `command_line`


@pytest.fixture(scope="session")
def build(tmp_path_factory) -> Callable[[str], Path]:
    """Path of a test program by its name in the Makefile."""
    return partial(make, folder=tmp_path_factory.mktemp("firmware"))


@pytest.fixture(scope="session")
def emulate(build) -> Callable[..., bytes]:
    """Runs an image on the emulated Cortex-M0 or M7: in.bin goes in, out.bin comes back."""

    def run(name: str, given: bytes, folder: Path, *options: str) -> bytes:
        need("qemu-system-arm")
        image = build(name)
        (folder / "in.bin").write_bytes(given)
        emulator = QEMU_M7 if name.startswith("m7_") else QEMU
        command = [*emulator, "-serial", "none", *options, "-kernel", image]
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=60)
        assert done.returncode == 0, f"{name} ended with {done.returncode}: {done.stderr.decode()}"
        return (folder / "out.bin").read_bytes()

    return run
