"""Tables in memory. pandas' own types do not tell a table from a column of it, so for a type
checker they are what they are used for.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import pandas as pd

if TYPE_CHECKING:
    Frame = Any
    Column = Any
else:
    Frame = pd.DataFrame
    Column = pd.Series


def frame_of(columns: Mapping[str, Any]) -> Frame:
    """A table of columns by name."""
    return pd.DataFrame(columns)
