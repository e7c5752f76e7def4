"""Start kindsl in the interpreter that runs this file.

Usage: launch.py useBundled|fromEnvironment SUBCOMMAND [ARGUMENT ...]

With useBundled the libraries beside the extension win over whatever the environment holds, so that
an old pygls there cannot break the server; with fromEnvironment they only fill gaps.
"""

# Without pathlib, whose import would delay the start.
# ruff: noqa: PTH100, PTH118, PTH120

import os
import runpy
import sys


def main():
    """Rearrange the module path and run the subcommand."""
    strategy = sys.argv[1]
    extension = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    libraries = os.path.join(extension, "bundled", "libs")
    # The folder of this file, which Python put there, must not offer its modules.
    del sys.path[0]
    if strategy == "useBundled":
        sys.path.insert(0, libraries)
    else:
        sys.path.append(libraries)
    sys.argv[:2] = ["kindsl"]
    runpy.run_module("kindsl", run_name="__main__", alter_sys=True)


main()
