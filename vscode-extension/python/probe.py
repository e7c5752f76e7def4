"""Print, as one line of JSON, what the extension must know about this interpreter.

Usage: probe.py FOLDER, where FOLDER holds what the extension has installed, by kind of Python.

Runs on any Python, old ones included: their version is what the reader wants to know.
"""

# ruff: noqa: PTH118

import json
import os
import sys


def is_installed(name):
    """Whether a module can be found, without importing it."""
    try:
        from importlib.util import find_spec
    except ImportError:
        return False
    return find_spec(name) is not None


def kind_of_python():
    """What compiled packages are bound to: version and platform."""
    from sysconfig import get_platform

    return "-".join((getattr(sys.implementation, "cache_tag", "python"), get_platform()))


def main():
    """Print the answer."""
    # The folder of this file, which Python put there, must not hide an installed package.
    del sys.path[0]
    packages = os.path.join(sys.argv[1], kind_of_python())
    sys.path.append(packages)
    answer = {
        "executable": sys.executable,
        "version": list(sys.version_info[:3]),
        "packages": packages,
        "missing": [name for name in ("numpy",) if not is_installed(name)],
    }
    sys.stdout.write(json.dumps(answer) + "\n")


main()
