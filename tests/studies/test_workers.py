"""The processes that compute a study."""

import socket
import subprocess
import sys
from contextlib import suppress

TWICE = """
from exoid.studies.engine.workers import workers

if __name__ == "__main__":
    for again in range(2):
        with workers(1, None) as client:
            print(client.submit(sum, (1, again)).result())
"""


def test_two_runs_in_one_process_have_workers_and_nothing_is_said_of_a_cluster_beside(tmp_path):
    script = tmp_path / "twice.py"  # what spawns processes is a file
    script.write_text(TWICE)
    with socket.socket() as other:
        other.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        with suppress(OSError):  # another has it already, which is as well
            other.bind(("127.0.0.1", 8787))
            other.listen()
        done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=600)
    assert (done.stdout.split(), done.stderr) == (["1", "2"], "")
