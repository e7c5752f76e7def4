"""No address is invented: what a publisher must know is asked for in docs/releasing.md."""

import subprocess
from pathlib import Path

import pytest

from kindsl.judgement.rules.registry import all_rules, page_address

ROOT = Path(__file__).parents[2]
INVENTED = ("kindsl." + "github.io", "github.com/" + "kindsl", "kindsl/" + "kindsl@")


@pytest.mark.parametrize("address", INVENTED)
def test_no_file_names_an_address_that_does_not_exist(address: str) -> None:
    command = ["git", "grep", "-lF", address]
    found = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert not found.stdout


def test_every_rule_s_page_is_a_file() -> None:
    for rule in all_rules():
        address = page_address(rule.code)
        assert address is not None
        assert address == (ROOT / "docs" / "rules" / f"{rule.code.lower()}.md").as_uri()


def test_the_pages_travel_with_the_package() -> None:
    build = (ROOT / "pyproject.toml").read_text()
    assert '"docs/rules" = "kindsl/docs/rules"' in build
    bundle = (ROOT / "vscode-extension" / "scripts" / "bundle.mjs").read_text()
    assert '"../docs/rules", path.join(libs, "kindsl/docs/rules")' in bundle


def test_pages_that_were_not_installed_have_no_address() -> None:
    assert page_address("KD999") is None
