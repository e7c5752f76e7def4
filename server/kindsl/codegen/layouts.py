"""Whose folders RobCoGen's classes are laid out for."""

LAYOUTS = ("control-toolbox", "robcogen")
