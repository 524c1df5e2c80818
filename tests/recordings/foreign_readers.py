"""Readers that do what foreign libraries do over a damaged file."""

import os
import sys
import time

import numpy as np


def good(path):
    print("a library's own words")
    os.write(1, b"and those of its C code")
    sys.stderr.write("a warning")
    return {"bytes": np.frombuffer(path.read_bytes(), np.uint8), "name": np.array("é")}


def looping(path):
    while True:
        pass


def deaf(path):
    """A loop in C, which holds Python's lock."""
    return {"never": np.array(sum(range(10**15)))}


def greedy(path):
    return {"zeros": np.ones(10**12, np.uint8)}


def broken(path):
    raise KeyError("no such block\nat 0x40")


def dying(path):
    os.abort()


def pickling(path):
    return {"object": np.array([object()])}


def marking(path):
    """Says where it is before it sleeps."""
    path.with_suffix(".pid").write_text(str(os.getpid()))
    time.sleep(600)
