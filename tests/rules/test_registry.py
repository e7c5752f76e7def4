"""All rules are found, wherever they are kept."""

import subprocess
import sys
import zipfile
from pathlib import Path

import kindsl
from kindsl.judgement.rules.registry import OF_XML, all_rules, checking_rules

PACKAGE = Path(kindsl.__file__).parent


def test_rules_are_found_in_a_zip(tmp_path):
    archive = tmp_path / "site.zip"
    with zipfile.ZipFile(archive, "w") as site:
        for file in PACKAGE.rglob("*.py"):
            site.write(file, file.relative_to(PACKAGE.parent))
    code = (
        f"import sys; sys.path.insert(0, {str(archive)!r});"
        "from kindsl.judgement.rules import registry as r;"
        "print(r.__file__, *(rule.code for rule in r.all_rules()))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    place, *codes = run.stdout.split()
    assert place.startswith(str(archive))
    assert codes == [rule.code for rule in all_rules()]


def test_the_rules_that_look_at_a_document_are_those_with_a_check_but_for_those_of_xml_alone():
    checks = [r for r in all_rules() if r.check_document or r.check_body or r.check_island]
    assert list(checking_rules()) == [rule for rule in checks if rule.code not in OF_XML]
