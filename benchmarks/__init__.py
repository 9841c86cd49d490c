"""What the engine costs and keeps, beside its peers. Run ``python -m benchmarks``."""
