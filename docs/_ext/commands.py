"""`{commands}`: every command of exoid with its options, read off the program itself."""

from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from exoid.cli.app import COMMANDS, load


class Commands(SphinxDirective):
    """A section for each command, in the order of `exoid --help`."""

    def run(self):
        text = "\n\n".join(section(name, load(name)) for name in COMMANDS)
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def section(name: str, command) -> str:
    """What the command does, how it is called, its options, examples; then those below it."""
    below = [section(f"{name} {each}", one) for each, one in members(command)]
    return "\n\n".join([alone(name, command), *below])


def members(command) -> list[tuple]:
    """The commands of a group, by name."""
    return list(getattr(command, "commands", {}).items())


def alone(name: str, command) -> str:
    what, _, examples = command.help.partition("\b\nExamples:\n")
    context = command.make_context(f"exoid {name}", [], resilient_parsing=True)
    usage = command.get_usage(context).removeprefix("Usage: ")
    records = [each.get_help_record(context) for each in command.params]
    rows = "\n\n".join(f"`{option}`\n: {meaning}" for option, meaning in filter(None, records))
    return "\n\n".join([f"## exoid {name}", what.strip(), block(usage), rows, block(examples)])


def block(text: str) -> str:
    lines = [line.removeprefix("  ") for line in text.rstrip().splitlines()]
    return "\n".join(["```text", *lines, "```"])


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("commands", Commands)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
