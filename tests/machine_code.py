"""How far XLA optimises what the tests compile, for the variable XLA_FLAGS."""

QUICK = "--xla_backend_optimization_level=0 --xla_cpu_use_fusion_emitters=false"
# Half as long again to compile, and a third of the time to run.
OPTIMISED = "--xla_backend_optimization_level=1 --xla_cpu_use_fusion_emitters=false"
