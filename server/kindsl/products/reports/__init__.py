"""Knows reports on a robot, for people and programs.

Must not know terminals, editors.
"""
