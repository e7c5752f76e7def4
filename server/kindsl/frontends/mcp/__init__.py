"""Knows what an assistant may ask: tools of the Model Context Protocol, one file each in `tools`.

Reads and writes below one folder, starts nothing, opens no network.
"""
