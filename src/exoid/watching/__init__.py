"""A leg while somebody watches it: estimates ten times a second, goals, and what to do next."""
