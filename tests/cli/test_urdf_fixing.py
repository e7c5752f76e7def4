"""A URDF that is fixed where it stands."""

import json
from pathlib import Path

from tests.analysis.test_urdf_fixes import LEGS, spoilt
from tests.cli.conftest import Runner


def test_lines_comments_and_marks_stay(kdsl_lint: Runner, tmp_path: Path) -> None:
    """The file has a mark, line ends of Windows, tabs, and a comment in the element."""
    whole = LEGS.replace("<inertial>", "<inertial>\t<!-- \u03b1 <b> -->", 1)
    whole = "\ufeff" + whole.replace("\n", "\r\n")
    path = tmp_path / "legs.urdf"
    bad = spoilt('value="1.152"', 'value="1152"', whole).encode()
    path.write_bytes(bad)
    assert "Convert the mass to kg (--fix --unsafe-fixes)" in kdsl_lint("--fix", str(path)).out
    assert path.read_bytes() == bad
    assert kdsl_lint("--fix", "--unsafe-fixes", str(path)).status == 0
    assert path.read_bytes() == whole.encode()


def test_reports_carry_the_edits(kdsl_lint: Runner, tmp_path: Path) -> None:
    path = tmp_path / "legs.urdf"
    path.write_text(spoilt('value="1.152"', 'value="1152"'))
    (found,) = json.loads(kdsl_lint("--output-format", "json", str(path)).out)
    assert [edit["text"] for edit in found["fix"]["edits"]] == ["1.152"]
    sarif = json.loads(kdsl_lint("--output-format", "sarif", str(path)).out)
    (result,) = sarif["runs"][0]["results"]
    (change,) = result["fixes"][0]["artifactChanges"]
    assert change["replacements"][0]["insertedContent"]["text"] == "1.152"
