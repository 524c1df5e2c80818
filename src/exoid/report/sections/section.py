"""What a part of the report is: one class, in a file of its own, and one template of its name."""

from abc import ABC, abstractmethod
from typing import ClassVar

from exoid.report.parts.case import Case


class Section(ABC):
    """What the template `name`.html shows of a case, under its title."""

    name: ClassVar[str]
    title: ClassVar[str]

    @classmethod
    @abstractmethod
    def of(cls, case: Case) -> "Section | None":
        """What there is to show of this case; None where there is nothing."""
