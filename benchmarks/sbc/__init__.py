"""Simulation-based calibration: is a posterior as wide, and where, as it says?

Talts, Betancourt, Simpson, Vehtari & Gelman, arXiv:1804.06788 (2018): of legs drawn from the prior,
the true value's rank among its posterior's draws is uniform. Any slip in prior, likelihood, density
or sampler bends the histogram of the ranks.
"""
