"""The pictures of text say what the programs say today."""

import re
import subprocess
import sys
from html import unescape
from pathlib import Path

ROOT = Path(__file__).parents[2]
# What stands in the picture around the linter's lines: its title and the command.
AROUND = "kdsl-lint$kdsl-lintexamples/broken_arm.kindsl"


def test_the_picture_of_the_linter_shows_what_it_prints() -> None:
    command = [str(Path(sys.executable).with_name("kdsl-lint")), "examples/broken_arm.kindsl"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    picture = (ROOT / "docs" / "images" / "lint.svg").read_text(encoding="utf-8")
    texts = re.findall(r"<text [^>]*>(.*?)</text>", picture, re.DOTALL)
    shown = "".join("".join(map(unescape, texts)).split()).removeprefix(AROUND)
    assert shown
    assert "".join(run.stdout.split()).startswith(shown)
