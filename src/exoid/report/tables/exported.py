"""What became of each thing of a model in another tool's file."""

from rich.console import Console

from exoid.interchange.model.joint import Exported
from exoid.report.tables.table import Table, print_table


def print_exported(found: Exported, console: Console) -> None:
    """Each thing, how well the file has it, and where."""
    what, how, where = zip(*(each.cells for each in found.kept), strict=True)
    columns = {"of the model": what, "in the file": how, "where": where}
    print_table(Table("What was exported", columns), console)
