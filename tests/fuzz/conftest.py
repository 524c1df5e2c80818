"""The fuzzer is a package of the repository: its processes are started from there."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[2]))
