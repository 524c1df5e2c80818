"""Blind cases: recordings whose concealed physics `diagnose` must name, and its score."""
