"""The layout of help."""

import argparse
import os

_WIDTH = 98


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """As argparse has it, but does not import what measures the terminal at every start."""

    def __init__(self, prog: str) -> None:
        columns = os.environ.get("COLUMNS", "")
        super().__init__(prog, width=int(columns) - 2 if columns.isdigit() else _WIDTH)
