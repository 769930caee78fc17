"""SAT and manifolds."""
