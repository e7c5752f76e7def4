"""What an editor asks for at every keystroke must not wait for NumPy."""

import subprocess
import sys

SCRIPT = """
import pkgutil, sys
import kindsl.frontends.features
features = kindsl.frontends.features
found = [m.name for m in pkgutil.walk_packages(features.__path__, f"{features.__name__}.")]
for name in found:
    __import__(name)
heavy = [m for m in ("numpy", "lark", "pygls", "lsprotocol", "tornado") if m in sys.modules]
print(len(found) > 40, heavy)
"""


def test_no_feature_needs_numpy_or_the_protocol():
    command = [sys.executable, "-c", SCRIPT]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "True []"
