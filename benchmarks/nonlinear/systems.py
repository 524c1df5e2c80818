"""The systems: where their files are, what is hidden in them, and what others reached."""

from dataclasses import dataclass, field
from pathlib import Path

SHARED = Path(__file__).parents[3] / "shared" / "data"


@dataclass(frozen=True)
class System:
    """One recording of a system whose physics is known to others."""

    name: str
    file: str  # below the shared data
    unit: str  # of what it shows
    hidden: tuple[str, ...]  # terms that name what is hidden
    published: str  # error of others on their test file, and who
    parameters: str  # what is published of it
    subject: dict[str, str] = field(default_factory=dict)  # what its makers know beside the sidecar

    @property
    def path(self) -> Path:
        return SHARED / self.file


SYSTEMS = (
    System(
        "EMPS",
        "real/emps.csv",
        "m",
        ("coulomb_friction", "stribeck_friction"),
        "2.64e-3 on the pulses, by inverse dynamics (Janot et al. 2019)",
        "M 95.11 kg, Fv 203.5 N s/m, Fc 20.39 N, offset -3.16 N",
        {"spring": "none"},
    ),
    System(
        "Silverbox",
        "benchmarks/silverbox-multisine.csv",
        "V",
        ("cubic_stiffness",),
        "baselines of ten methods: Champneys et al. 2024, arXiv 2405.10779",
        "68 Hz, cubic spring",
        {"gravity": "none"},
    ),
    System(
        "Bouc-Wen",
        "benchmarks/bouc-wen-multisine.csv",
        "m",
        ("shaped_hysteresis", "hysteresis"),
        "1.87e-5 on the multisine (Esfahani et al. 2018)",
        "m 2 kg, c 10 N s/m, k 5e4 N/m",
        {"gravity": "none"},
    ),
)
