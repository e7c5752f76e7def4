"""What an editor asks for at every keystroke must not wait for NumPy."""

import subprocess
import sys

FEATURES = [
    "code_actions",
    "code_lenses",
    "completion",
    "definition",
    "document_symbols",
    "hover",
    "inlay_hints",
    "rename",
    "semantic_tokens",
    "signature_help",
    "workspace_symbols",
]


def test_no_feature_needs_numpy_or_the_protocol():
    names = "".join(f"import kindsl.features.{name}\n" for name in FEATURES)
    heavy = "[m for m in ('numpy', 'lark', 'pygls', 'lsprotocol', 'tornado') if m in sys.modules]"
    script = f"import sys\n{names}print({heavy})"
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
