"""What is loaded before the answer to `initialize`: the protocol, not the language."""

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest
from tests.support.lsp import RawClient

from kindsl.frontends.lsp.session.warm_up import FIRST
from kindsl.frontends.lsp.session.warm_up import LATER as AFTERWARDS

LATER = (
    "numpy",
    "lark",
    "tornado",
    "meshcat",
    "kindsl.language.syntax.tables",
    "kindsl.judgement.analysis.analysis",
)


def test_the_language_loads_after_the_answer_to_initialize() -> None:
    code = "import sys, kindsl.frontends.lsp.server, kindsl.frontends.lsp.run;"
    code += f"print(set({LATER!r}) & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


@pytest.mark.parametrize("module", [*FIRST, *AFTERWARDS])
def test_what_is_loaded_beforehand_is_there(module: str) -> None:
    assert find_spec(module) is not None


def test_what_needs_more_says_what_to_install() -> None:
    code = "import sys; sys.modules['numpy'] = None; "
    code += "from kindsl.frontends.cli.language_server import main; main()"
    client = RawClient([sys.executable, "-c", code])
    client.initialize()
    uri = "file:///quadruped.kindsl"
    client.open(uri, (Path(__file__).parents[2] / "examples" / "quadruped.kindsl").read_text())
    asked = {"command": "kindsl.compute", "arguments": [uri]}
    error = client.refusal("workspace/executeCommand", asked)
    assert "needs numpy; install with" in error["message"]
    assert error["data"] == {"missing": ["numpy"]}
    client.kill()
