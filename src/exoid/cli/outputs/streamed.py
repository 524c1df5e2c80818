"""Files that are written while something goes on: checked before it begins."""

from pathlib import Path

from exoid.cli.outputs.destination import check_absent, check_apart, check_destination


def check_files(
    recording: Path | None, output: Path | None, json_lines: Path | None, *, force: bool
) -> None:
    """Refuse a log and lines that cannot be written, or would replace what is there."""
    lines = None if json_lines == Path("-") else json_lines
    written = [each for each in (output, lines) if each is not None]
    for each in written:
        check_destination(each)
    if output is not None:
        from exoid.recordings.live.log_file import check_kind

        check_kind(output)
        written.append(output.with_suffix(".toml"))
    check_apart(written, [] if recording is None else [recording])
    check_absent(written, force)
