"""Draws docs/images/lint.svg: what kdsl-lint says of the broken example, on a terminal."""

import os
import re
import subprocess
import sys
from io import StringIO
from pathlib import Path

from rich.console import Console
from rich.text import Text

ROOT = Path(__file__).parents[2]
LINES = 36


def main() -> None:
    """Run the linter with colour and write its first lines as a picture."""
    command = [str(Path(sys.executable).with_name("kdsl-lint")), "examples/broken_arm.kindsl"]
    environment = {**os.environ, "FORCE_COLOR": "1", "NO_COLOR": ""}
    run = subprocess.run(
        command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    lines = run.stdout.splitlines()[:LINES]
    console = Console(record=True, width=118, file=StringIO())
    console.print(Text("$ kdsl-lint examples/broken_arm.kindsl", style="bold"))
    console.print(Text.from_ansi("\n".join(lines)))
    svg = console.export_svg(title="kdsl-lint")
    # Fonts would be fetched from elsewhere; the reader's own monospace will do.
    svg = re.sub(r"@font-face \{.*?\}", "", svg, flags=re.DOTALL)
    (ROOT / "docs/images/lint.svg").write_text(svg)


if __name__ == "__main__":
    main()
