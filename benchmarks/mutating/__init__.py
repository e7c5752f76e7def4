"""Mutants of the server's code, for `benchmarks/mutation.py`."""
