"""What became of each thing of a model in another tool's file."""

from rich.console import Console

from exoid.interchange.model.joint import Exported
from exoid.report.tables.table import Table, print_table


def print_exported(found: Exported, console: Console) -> None:
    """Each thing, how well the file has it, and where."""
    rows = [each.cells for each in found.kept]
    names = ("of the model", "in the file", "where")
    columns = dict(zip(names, zip(*rows, strict=True), strict=True))
    print_table(Table("What was exported", columns), console)
