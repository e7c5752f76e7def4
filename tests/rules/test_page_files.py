"""Where a rule's page is found: in the installed package, or in the checkout around it."""

from pathlib import Path

import pytest

from kindsl.judgement.rules import registry


@pytest.mark.parametrize("folder", ["server/kindsl/docs/rules", "docs/rules"])
def test_pages_are_in_the_package_or_in_the_checkout(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, folder: str
) -> None:
    module = tmp_path / "server" / "kindsl" / "judgement" / "rules" / "registry.py"
    monkeypatch.setattr(registry, "__file__", str(module))
    address = registry.page_address.__wrapped__
    page = tmp_path / folder / "kd301.md"
    assert address("KD301") is None
    page.parent.mkdir(parents=True)
    page.write_text("# KD301")
    assert address("KD301") == page.as_uri()
    assert address("KD999") is None
