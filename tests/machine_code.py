"""How far XLA optimises what the tests compile, in commands that they start, too (XLA_FLAGS)."""

QUICK = "--xla_backend_optimization_level=0 --xla_cpu_use_fusion_emitters=false"
