from pathlib import Path

from generating.rule_pages import main, pages

from kindsl.judgement.rules.registry import all_rules

DOCS = Path(__file__).parents[2] / "docs" / "rules"


def test_pages_in_the_docs_are_those_of_the_rules() -> None:
    assert main(["--check", str(DOCS)]) == 0


def test_every_rule_has_a_page_and_is_listed() -> None:
    written = pages()
    for rule in all_rules():
        assert written[f"{rule.code.lower()}.md"].startswith(f"# {rule.code} {rule.name}\n")
        assert f"| {rule.name} |" in written["README.md"]


def test_check_finds_what_is_stale(tmp_path: Path) -> None:
    assert main(["--check", str(tmp_path)]) == 1
    assert main([str(tmp_path)]) == 0
    assert main(["--check", str(tmp_path)]) == 0
    (tmp_path / "kd999.md").write_text("no such rule")
    assert main(["--check", str(tmp_path)]) == 1
    assert main([str(tmp_path)]) == 0
    assert not (tmp_path / "kd999.md").exists()
