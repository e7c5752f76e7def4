"""Install packages into a folder of the extension's own: install.py FOLDER PACKAGE [PACKAGE ...].

pip refuses to touch a system's Python, but not a folder beside it. Where pip is missing, the copy
is used that Python carries for making environments.
"""

import runpy
import sys
from importlib.util import find_spec
from pathlib import Path

NO_PIP = 3


def main():
    """Run pip; its exit status, or NO_PIP where there is none."""
    # The folder of this file, which Python put there, must not hide an installed package.
    del sys.path[0]
    folder, *packages = sys.argv[1:]
    if find_spec("pip") is None:
        wheel = pip_of_this_python()
        if wheel is None:
            sys.exit(NO_PIP)
        sys.path.insert(0, str(wheel))
    how = ["--only-binary", ":all:", "--no-input", "--disable-pip-version-check"]
    patience = ["--retries", "1", "--timeout", "15", "--progress-bar", "off"]
    sys.argv[:] = ["pip", "install", "--target", folder, *how, *patience, *packages]
    runpy.run_module("pip", run_name="__main__", alter_sys=True)


def pip_of_this_python():
    """Return the wheel of pip in the standard library, None where it was left out."""
    spec = find_spec("ensurepip")
    places = spec.submodule_search_locations if spec is not None else None
    wheels = [wheel for place in places or () for wheel in Path(place).rglob("pip-*.whl")]
    return wheels[0] if wheels else None


main()
