"""Work for all cores of a machine."""
