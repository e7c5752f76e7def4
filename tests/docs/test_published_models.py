"""The page on published models is what its command makes."""

import subprocess
import sys
from pathlib import Path

from tests.support.published import published

ROOT = Path(__file__).parents[2]
COMMAND = [sys.executable, str(ROOT / "docs" / "pictures" / "published_models.py"), "--check"]


def check(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*COMMAND, *arguments], capture_output=True, encoding="utf-8", timeout=120, check=False
    )


@published
def test_page_is_up_to_date() -> None:
    run = check()
    assert run.returncode == 0, run.stderr or "run python docs/pictures/published_models.py"


def test_page_is_told_from_others(tmp_path: Path) -> None:
    header = "file\torigin\tpath\tdate\tA\tB\n"
    (tmp_path / "SOURCES.tsv").write_text(
        f"{header}arm.kindsl\twe\tarm.kindsl\t2026\taccept\treject\n"
    )
    (tmp_path / "arm.kindsl").write_text("Robot Arm {}\n")
    assert check(str(tmp_path)).returncode == 1


def test_missing_models_are_told(tmp_path: Path) -> None:
    run = check(str(tmp_path))
    assert run.returncode == 2
    assert "no SOURCES.tsv there" in run.stderr
