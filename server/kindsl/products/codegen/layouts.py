"""Whose folders and names RobCoGen's classes have."""

LAYOUTS = ("control-toolbox", "robcogen", "robcogen-0.5")
