"""Blind cases: recordings whose concealed physics `diagnose` must name, and its score."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command line has it: small matrices
