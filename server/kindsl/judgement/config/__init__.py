"""Knows kindsl.toml and [tool.kindsl]: its place, its keys, its errors.

Must not know editors, the command line.
"""
