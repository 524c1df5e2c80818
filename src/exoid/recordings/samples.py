"""Numbers of a channel, sample by sample."""

import numpy as np
from numpy.typing import NDArray

Samples = NDArray[np.float64]  # one value per sample; jaxtyping here would cost 0.1 s at start
