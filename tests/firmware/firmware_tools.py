"""Where the firmware is, and the tools that build and emulate it."""

import shutil
import subprocess
from pathlib import Path

import pytest

FIRMWARE = Path(__file__).parents[2] / "firmware"
QEMU = (
    *("qemu-system-arm", "-M", "microbit", "-display", "none", "-monitor", "none"),
    *("-semihosting-config", "enable=on,target=native"),
)

QEMU_M7 = tuple("mps2-an500" if each == "microbit" else each for each in QEMU)


def need(tool: str) -> None:
    """Skips the test where a tool is absent."""
    if shutil.which(tool) is None:
        pytest.skip(f"{tool} is not installed")


def make(name: str, folder: Path) -> Path:
    """The path of a test program by its name in the Makefile, made where it is not there yet."""
    need("make")
    need("arm-none-eabi-g++" if name.endswith((".elf", ".o")) else "g++")
    program = folder / name
    command = ["make", "-s", "-C", FIRMWARE, f"BUILD={folder}", program]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return program
