"""The linter's modules in one file: there after a run, and never of another version."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.cli.samples import GOOD, INTEGER

import kindsl

RUN = "from kindsl.frontends.cli.lint import main; main()"
# A run says where the module came from that does the work.
SHOWN = f"""
import atexit, os, sys
leave = os._exit
def tell(status):
    print(type(sys.modules["kindsl.frontends.cli.linter.command"].__loader__).__name__)
    sys.stdout.flush()
    leave(status)
os._exit = tell
{RUN}
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A copy of the package, and two documents beside it."""
    source = Path(str(kindsl.__file__)).parent
    shutil.copytree(source, tmp_path / "kindsl", ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "good.kindsl").write_text(GOOD)
    (tmp_path / "bad.kindsl").write_text(INTEGER)
    return tmp_path / "kindsl"


def linted(package: Path, document: str = "good.kindsl", **environment: str) -> list[str]:
    """Return the lines of a run, the last of which names the loader."""
    inherited = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    found = subprocess.run(
        [sys.executable, "-c", SHOWN, document],
        cwd=package.parent,
        env=inherited | {"PYTHONPATH": str(package.parent)} | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert "Traceback" not in found.stderr
    return found.stdout.splitlines()


def test_modules_come_from_the_bundle_of_the_run_before_and_say_the_same(package: Path) -> None:
    expected = linted(package, "bad.kindsl")
    assert expected[-1] == "SourceFileLoader"
    assert linted(package)[-1] == "SourceFileLoader"
    assert linted(package)[-1] == "_Loader"
    assert linted(package, "bad.kindsl") == [*expected[:-1], "_Loader"]


def test_a_bundle_of_other_sources_is_made_anew(package: Path) -> None:
    linted(package)
    changed = package / "frontends" / "cli" / "linter" / "summary.py"
    changed.write_text(changed.read_text() + "\n")
    assert linted(package)[-1] == "SourceFileLoader"
    assert linted(package)[-1] == "_Loader"
    (bundle,) = package.rglob("*.bundle")
    bundle.write_bytes(bundle.read_bytes()[:1000])
    assert linted(package)[-1] == "SourceFileLoader"
    assert linted(package)[-1] == "_Loader"


def test_who_wants_no_byte_code_written_gets_none(package: Path) -> None:
    assert linted(package, PYTHONDONTWRITEBYTECODE="1")[-1] == "SourceFileLoader"
    assert list(package.rglob("*.bundle")) == []
