"""Is what `diagnose` is sure of right as often as it says?

See `__main__`.
"""
