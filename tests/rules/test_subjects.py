"""The thing that each finding is about."""

import ast
from pathlib import Path

import pytest
from tests.support.example_documents import examples_of
from tests.support.examples import Example

import kindsl
from kindsl.judgement.rules.registry import rule_named

ROOT = Path(kindsl.__file__).parent

ARM = """Robot Arm {
RobotBase base { children { upper via shoulder } }
link upper {
    id = 1
    inertia_params { mass = -1.0 CoM = (0.0, 0.0, 0.1)
        Ix = 0.1 Iy = 0.1 Iz = 0.1 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }
    children {}
    frames { class { translation = (reach, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
r_joint shoulder { ref_frame { translation = (1, 0.0, 0.0) rotation = (0.0, 0.0, 90.0) } }
link loose { id = 2 children {} }
}
"""


def subjects(text: str) -> dict[str, tuple[str, str]]:
    return {
        finding.code: (finding.subject.kind.value, finding.subject.name)
        for finding in kindsl.parse(text).findings
    }


@pytest.mark.parametrize(
    ("code", "kind", "name"),
    [
        ("KD303", "link", "upper"),
        ("KD203", "link", "loose"),
        ("KD113", "frame", "class"),
        ("KD005", "joint", "shoulder"),
        ("KD501", "joint", "shoulder"),
        ("KD401", "parameter", "reach"),
    ],
)
def test_a_finding_names_what_it_is_about(code: str, kind: str, name: str) -> None:
    assert subjects(ARM)[code] == (kind, name)


@pytest.mark.parametrize("code", ["KD208", "KD209"])
def test_a_link_attached_wrongly_is_the_subject_not_what_carries_it(code: str) -> None:
    rule = rule_named(code)
    assert rule is not None
    example = examples_of(rule).bad[0]
    text = example.text if isinstance(example, Example) else example
    found = [f for f in kindsl.parse(text).findings if f.code == code]
    assert found
    assert all(f"link '{f.subject.name}' " in f.message for f in found)


def test_the_base_is_a_link() -> None:
    assert subjects("Robot r { RobotBase class { children {} } }")["KD113"] == ("link", "class")


def test_a_finding_about_no_thing_is_about_the_document() -> None:
    assert set(subjects("").values()) <= {("document", "")}


# A message is shown, compared as a whole, or made part of another.
ENGLISH = {"split", "partition", "rpartition", "rsplit", "find", "index", "startswith", "endswith"}


def reads_english(tree: ast.AST) -> bool:
    """Return whether anything is looked for in the words of a message."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            owner = node.func.value
            if node.func.attr in ENGLISH and _is_message(owner):
                return True
        is_membership = isinstance(node, ast.Compare) and isinstance(
            node.ops[0], ast.In | ast.NotIn
        )
        if is_membership and _is_message(node.comparators[0]):
            return True
    return False


def _is_message(node: ast.AST) -> bool:
    name = node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")
    return name in ("message", "sentence")


def test_no_english_is_parsed() -> None:
    sources = sorted(ROOT.rglob("*.py"))
    found = [str(p.relative_to(ROOT)) for p in sources if reads_english(ast.parse(p.read_text()))]
    assert found == []


def test_that_test_sees_it() -> None:
    assert reads_english(ast.parse('name = finding.message.split("\'")[1]'))
    assert reads_english(ast.parse("if 'it' in found.message: pass"))
