"""What passes on a quiet machine passes where server, worker or frames are late."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from tests.support.amount import usually

ROOT = Path(__file__).parents[2]
PAGES = ("preview/test_handles.py", "preview/test_page_hands.py", "preview/test_following.py")
USUALLY = [("worker", 1, ("lsp/test_manipulating.py",))]
THOROUGHLY = [
    (who, seed, files)
    for who, files in (
        ("server", ("lsp", *PAGES)),
        ("worker", ("lsp",)),
        ("frames", PAGES),
        ("messages", PAGES),
    )
    for seed in (1, 2)
]


@pytest.mark.timeout(7200)
@pytest.mark.parametrize(("who", "seed", "files"), usually(USUALLY, THOROUGHLY))
def test_nothing_fails_that_is_late(who: str, seed: int, files: tuple[str, ...]) -> None:
    places = [str(Path("tests", file)) for file in files]
    command = [sys.executable, "-m", "pytest", "-q", "--no-header", *places]
    late = {**os.environ, "KINDSL_DELAYS": f"{who}:{seed}", "KINDSL_THOROUGH": ""}
    done = subprocess.run(
        command, cwd=ROOT, env=late, text=True, capture_output=True, timeout=7000, check=False
    )
    assert done.returncode == 0, done.stdout[-8000:]
