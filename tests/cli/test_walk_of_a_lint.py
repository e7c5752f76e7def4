"""A run of the linter goes down through the house; the climbs are counted as those of a drag."""

import json
import subprocess
import sys
from pathlib import Path

from tests.preview.test_walk_of_a_drag import HOUSE, Walk

from kindsl.frontends.cli import lint

ARM = Path(__file__).parents[1] / "fixtures" / "robots" / "arm.kindsl"
CONFIGURATION = """[parameters]
reach = 0.1
gone = 1.0
"""
MOST_CLIMBS = 7


def tell_walk() -> None:
    """Print the files of the walk and its climbs; the linter prints its findings before them."""
    arguments, walk = [ARM.name], Walk()
    for thing in (arguments, *arguments):
        walk.follow(thing)
    sys.setprofile(walk.see)
    try:
        lint.main(arguments)
    finally:
        sys.setprofile(None)
    files = {Path(file).relative_to(HOUSE).as_posix() for file, _ in walk.functions}
    print(json.dumps([sorted(files), list(walk.climbs())]))


def test_a_run_goes_down(tmp_path: Path) -> None:
    """With a configuration and findings; in a process that has computed nothing before."""
    (tmp_path / ARM.name).write_bytes(ARM.read_bytes())
    (tmp_path / "kindsl.toml").write_text(CONFIGURATION)
    program = (
        f"import sys; sys.path.insert(0, {str(ARM.parents[3])!r}); "
        f"from {__name__} import tell_walk; tell_walk()"
    )
    run = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    files, climbs = json.loads(run.stdout.splitlines()[-1])
    assert "KD" in run.stdout
    assert {
        "frontends/cli/linter/one_document.py", "judgement/config/discovery.py",
        "judgement/analysis/analysis.py", "language/syntax/document.py",
    } <= set(files)  # fmt: skip
    assert len(climbs) <= MOST_CLIMBS, climbs
