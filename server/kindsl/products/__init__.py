"""Knows what is written for people and machines: reports and generated code.

Must not know who asks for them.
"""
