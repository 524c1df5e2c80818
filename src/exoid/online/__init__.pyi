from .batch import drops_of, refine, segment_of
from .belief import Belief, init
from .beside_batch import Agreement, agreement, refined
from .model.model import Goals, Model, Node
from .model.sample import Sample
from .model.trust import Phase, Trust
from .model.unknowns import Unknowns
from .model.weighed import Weighed
from .outlook import Outlook
from .program import replay, step
from .readings import Known, estimates
from .recorded import node_of, samples_of

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
    "Weighed",
    "agreement",
    "drops_of",
    "estimates",
    "init",
    "node_of",
    "refine",
    "refined",
    "replay",
    "samples_of",
    "segment_of",
    "step",
]
