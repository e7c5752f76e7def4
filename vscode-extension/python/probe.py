"""Print, as one line of JSON, what the extension must know about this interpreter.

Runs on any Python, old ones included: their version is what the reader wants to know.
"""

import json
import sys


def is_installed(name):
    """Whether a module can be found, without importing it."""
    try:
        from importlib.util import find_spec
    except ImportError:
        return False
    return find_spec(name) is not None


def main():
    """Print the answer."""
    # The folder of this file, which Python put there, must not hide an installed package.
    del sys.path[0]
    answer = {
        "executable": sys.executable,
        "version": list(sys.version_info[:3]),
        "missing": [name for name in ("numpy",) if not is_installed(name)],
    }
    sys.stdout.write(json.dumps(answer) + "\n")


main()
