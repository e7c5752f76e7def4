"""What is loaded before the answer to `initialize`: the protocol, not the language."""

import subprocess
import sys

LATER = ("numpy", "lark", "tornado", "meshcat", "kindsl.syntax.tables", "kindsl.analysis.analysis")


def test_the_language_loads_after_the_answer_to_initialize() -> None:
    code = (
        f"import sys, kindsl.lsp.server, kindsl.lsp.run; print(set({LATER!r}) & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"
