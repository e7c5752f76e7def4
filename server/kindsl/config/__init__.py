"""Knows kindsl.toml and [tool.kindsl]: where it is, what it may say, what is wrong in it.

Must not know editors, the command line.
"""
