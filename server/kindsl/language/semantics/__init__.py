"""Knows names, references, parameters, values: the robot model.

Must not know numpy, files, editors.
"""
