"""What docs/ci.md, the action and the hooks promise exists."""

import json
import re
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import INTEGER

from kindsl.frontends.cli.lint import main
from kindsl.frontends.cli.main import main as kindsl
from kindsl.frontends.cli.output import FORMATS

ROOT = Path(__file__).parents[2]
RECIPES = {
    name: (ROOT / name).read_text()
    for name in ("docs/ci.md", "action.yml", ".pre-commit-hooks.yaml")
}


@pytest.mark.parametrize("name", RECIPES)
def test_options_that_recipes_name_exist(name: str, capfd: pytest.CaptureFixture[str]) -> None:
    text = RECIPES[name]
    with pytest.raises(SystemExit):
        main(["--help"])
    with pytest.raises(SystemExit):
        kindsl(["review", "--help"])
    known = capfd.readouterr().out + " --check --quiet --disable-pip-version-check "
    for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", text):
        assert option in known
    for named in re.findall(r"output-format[= :]+([a-z]+)\b", text):
        assert named in (*FORMATS, "description")


def test_json_example_is_what_comes_out(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "models").mkdir()
    (folder / "models" / "arm.kindsl").write_text(INTEGER)
    (found,) = json.loads(kdsl_lint("--output-format", "json").out)
    written = re.search(r"```json\n(.*?)```", RECIPES["docs/ci.md"], re.DOTALL)
    assert written is not None
    shown = json.loads(written[1])
    installed = "kindsl/docs/rules/kd005.md"
    assert shown.pop("url").endswith(installed)
    assert found.pop("url").endswith(installed.removeprefix("kindsl/"))
    assert _without_offsets(shown) == _without_offsets(found)


def _without_offsets(value: object) -> object:
    """Return plain data with all offsets zero: the example's depend on the rest of its document."""
    if isinstance(value, dict):
        return {k: 0 if k == "offset" else _without_offsets(v) for k, v in value.items()}
    return [_without_offsets(v) for v in value] if isinstance(value, list) else value
