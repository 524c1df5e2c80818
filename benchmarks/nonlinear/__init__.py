"""Is the hidden physics of a recorded system named, and does its model simulate what it never saw?

Three systems that others measured or simulated (nonlinearbenchmark.org): the first part of each
file is diagnosed, and the model that comes out simulates the rest freely. Published errors of
models that were made for each system by hand stand beside.
"""
