"""Knows the messages that draw a robot.

Must not know servers, event loops, the viewer.
"""
