"""A leg's parameters while it moves: `init` what is believed before, then `step` by sample.

belief = online.init(exoid.expected_leg(77.0, 1.80))
for sample in samples:
    belief, outlook = online.step(belief, sample)
"""

from exoid.online.batch import drops_of, refine, segment_of
from exoid.online.belief import Belief, init
from exoid.online.beside_batch import Agreement, agreement, refined
from exoid.online.model.model import Goals, Model, Node
from exoid.online.model.sample import Sample
from exoid.online.model.trust import Phase, Trust
from exoid.online.model.unknowns import Unknowns
from exoid.online.outlook import Outlook
from exoid.online.program import replay, step
from exoid.online.readings import Known, estimates
from exoid.online.samples_of import samples_of

__all__ = [
    "Agreement",
    "Belief",
    "Goals",
    "Known",
    "Model",
    "Node",
    "Outlook",
    "Phase",
    "Sample",
    "Trust",
    "Unknowns",
    "agreement",
    "drops_of",
    "estimates",
    "init",
    "refine",
    "refined",
    "replay",
    "samples_of",
    "segment_of",
    "step",
]
