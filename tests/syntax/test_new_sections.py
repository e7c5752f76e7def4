"""A section that is added to the grammar is read, ordered, laid out, offered, hovered and renamed.

What is generated from a changed grammar takes the place of the package's own in a process of its
own, so that no other file can have been touched.
"""

import ast
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from generating.constructs import AnnotationError
from generating.tables import sections, tables

import kindsl
from kindsl.language.syntax.grammars import grammar_text

_SECTIONS = """
color: "color" "=" vector                  //: only robcogen2; value dynamics
shine: "shine" "=" _expression             //: value dynamics lm
armour: "armour" "{" (thickness | plate)* "}"
thickness: "thickness" "=" _expression     //: value length m
plate: "plate" "=" vector                  //: value length m
secret: "secret" "=" INT                   //: neither KD006
"""
_PROCESS = """
import json, sys, types
sources, text, targets = json.load(sys.stdin)
for name, source in sources.items():
    module = sys.modules[name] = types.ModuleType(name)
    exec(source, module.__dict__)
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.frontends.features.completion.completion import completions
from kindsl.frontends.features.completion.item import without_placeholders
from kindsl.language.formatting import format_document
from kindsl.language.text.edits import apply_edits
from kindsl.frontends.features.hover.hover import hover
from kindsl.frontends.features.rename import rename
from kindsl.frontends.features.signature_help import signature_help
cursor = text.find("$0")
text = text.replace("$0", "")
analysis = analyse(text, settings=Settings(targets=frozenset(targets)))
answer = {"findings": [], "fixed": text}
for found in analysis.findings:
    answer["findings"].append([found.code, found.message])
    if found.fix is not None:
        answer["fixed"] = apply_edits(text, found.fix.edits)
if cursor >= 0:
    items = completions(analysis, cursor).items
    answer["offered"] = {item.label: without_placeholders(item.text) for item in items}
    shown, signature = hover(analysis, cursor), signature_help(analysis, cursor)
    answer["hover"] = shown.markdown if shown else ""
    answer["signature"] = signature.label if signature else ""
    answer["renamed"] = len(getattr(rename(analysis, cursor, "other"), "edits", ()))
elif not any(island.problems for island in analysis.syntax.islands):
    answer["formatted"] = apply_edits(text, format_document(analysis.syntax))
answer["parameters"] = [str(parameter.name) for parameter in analysis.model.parameters]
link = analysis.model.links[0]
answer["color"] = link.color and [component.text for component in link.color.components]
thickness = link.armour and link.armour.thickness
answer["thickness"] = thickness and thickness.text
print(json.dumps(answer))
"""
_LINK = """Robot Lamp {

RobotBase ground {
    children {
        arm via turn
    }
}

link arm {
    id = 1
    inertia_params {
        mass = 1.0
        CoM = (0.0, 0.0, 0.1)
        Ix = 0.02
        Iy = 0.02
        Iz = 0.01
        Ixy = 0.0
        Ixz = 0.0
        Iyz = 0.0
    }
%s    children {}
}

r_joint turn {
    ref_frame {
        translation = (0.0, 0.0, 0.2)
        rotation = (0.0, 0.0, 0.0)
    }
}
}
"""
_COLOR, _SHINE = "    color = (0.1, 0.2, 0.3)\n", "    shine = 0.5\n"
_PLATE = "        plate = (1.0, 1.0, 1.0)\n"
_ARMOUR = f"    armour {{\n        thickness = 0.1\n{_PLATE}    }}\n"
_ALL = _COLOR + _SHINE + _ARMOUR


@pytest.fixture(scope="module")
def source() -> dict[str, str]:
    """Return what is generated with a vector, a scalar, a block and a refused section."""
    grammar = grammar_text("kindsl.lark")
    link = "//: order id inertia? children frames?\n"
    assert grammar.count(link) == 1
    new = "//: order id inertia? color? shine? armour? secret? children frames?\n"
    grammar = grammar.replace(link, new)
    known = "\n_section: id | inertia"
    grammar = grammar.replace(known, f"{known} | color | shine | armour | secret") + _SECTIONS
    armour = 'armour: "armour"'
    grammar = grammar.replace(armour, f"//: order thickness plate\n{armour}")
    return {
        "kindsl.language.syntax.tables": tables(grammar),
        "kindsl.language.semantics.sections": sections(grammar),
    }


def asked(source: dict[str, str], text: str, *targets: str) -> Any:
    question = json.dumps((source, text, targets))
    command = [sys.executable, "-c", _PROCESS]
    run = subprocess.run(command, input=question, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(run.stdout)


def test_new_sections_are_right_where_they_belong(source: dict[str, str]) -> None:
    answer = asked(source, _LINK % _ALL)
    assert answer["findings"] == []
    assert answer["formatted"] == _LINK % _ALL


def test_without_them_the_document_is_as_it_was(source: dict[str, str]) -> None:
    assert asked(source, _LINK % "", "robcogen2")["findings"] == []


@pytest.mark.parametrize(
    ("written", "message", "fixed"),
    [
        (_SHINE + _COLOR, "'color' stands after 'shine'", _COLOR + _SHINE),
        (_ARMOUR + _SHINE, "'shine' stands after 'armour'", _SHINE + _ARMOUR),
        (_SHINE + _SHINE, "link 'arm' has a second 'shine'", _SHINE),
        (_ARMOUR.replace(_PLATE, ""), "'armour' has no 'plate'", _ARMOUR.replace(_PLATE, "")),
    ],
)
def test_they_are_ordered(source: dict[str, str], written: str, message: str, fixed: str) -> None:
    answer = asked(source, _LINK % written)
    assert [told for _, told in answer["findings"]] == [message]
    assert answer["fixed"] == _LINK % fixed


def test_one_target_takes_a_section_alone(source: dict[str, str]) -> None:
    ground = (_LINK % _COLOR).split("link arm")[1].split("    color")[0].split("id = 1\n")[1]
    text = (_LINK % _COLOR).replace("ground {\n", f"ground {{\n{ground}", 1)
    assert asked(source, text, "robcogen2")["findings"] == []
    answer = asked(source, text, "robcogen")
    assert answer["findings"] == [["KD601", "robcogen does not take 'color'"]]
    assert answer["fixed"] == text.replace(_COLOR, "")


def test_what_is_in_a_refused_section_is_not_told_besides(source: dict[str, str]) -> None:
    text = _LINK % _COLOR.replace("0.1", "1.0e-1")
    told = [message for _, message in asked(source, text, "robcogen")["findings"]]
    assert "robcogen does not take 'color'" in told
    assert not any("1.0e-1" in message for message in told)


@pytest.mark.parametrize(
    "section", [_SHINE.replace("0.5", "5.0e-1"), _ARMOUR.replace("0.1", "1.0e-1")]
)
def test_a_value_is_rewritten_for_both(source: dict[str, str], section: str) -> None:
    answer = asked(source, _LINK % section, "robcogen")
    written = "5.0e-1" if "shine" in section else "1.0e-1"
    message = f"robcogen does not take the form of '{written}'"
    assert ["KD601", message] in answer["findings"]
    assert answer["fixed"] == _LINK % section.replace(written, str(float(written)))


def test_a_value_that_neither_takes_is_told(source: dict[str, str]) -> None:
    (finding,) = asked(source, _LINK % _SHINE.replace("0.5", "0x5"))["findings"]
    assert finding == ["KD005", "'0x5' is not a number"]


def test_neither_takes_a_section(source: dict[str, str]) -> None:
    answer = asked(source, _LINK % "    secret = 3\n")
    assert answer["findings"] == [["KD006", "no generator takes 'secret'"]]
    assert answer["fixed"] == _LINK % ""


def test_each_stands_on_a_line_of_its_own(source: dict[str, str]) -> None:
    flat = " ".join((_LINK % _ALL).split())
    assert f"\n{_ALL}    children" in asked(source, flat)["formatted"]


def test_each_is_offered_where_it_may_stand(source: dict[str, str]) -> None:
    offered = asked(source, _LINK % (_SHINE + "    $0\n"))["offered"]
    assert {"armour", "secret"} <= offered.keys()
    assert not {"color", "shine", "id"} & offered.keys()
    assert offered["armour"] == "armour {\n    thickness = 0.0\n    plate = (0.0, 0.0, 0.0)\n}"
    inner = asked(source, _LINK % "    armour {\n        $0\n    }\n")["offered"]
    assert inner.keys() >= {"thickness", "plate"}
    assert inner["plate"] == "plate = (0.0, 0.0, 0.0)"


@pytest.mark.parametrize("half", ["    shine\n", "    shine =\n", "    color = (0.1, 0.2\n"])
def test_half_a_section_is_one_finding_and_the_rest_is_read(
    source: dict[str, str], half: str
) -> None:
    answer = asked(source, _LINK % half)
    assert len(answer["findings"]) == 1, answer["findings"]
    assert answer["findings"][0][0] == "KD001"


def test_they_are_read(source: dict[str, str]) -> None:
    answer = asked(source, _LINK % _ALL)
    assert answer["color"] == ["0.1", "0.2", "0.3"]
    assert answer["thickness"] == "0.1"
    assert asked(source, _LINK % "")["color"] is None


@pytest.mark.parametrize(
    ("written", "label"),
    [
        (_COLOR.replace("0.2", "hu$0e"), "color y of link `arm`"),
        (_SHINE.replace("0.5", "hu$0e"), "shine of link `arm`"),
        (_ARMOUR.replace("0.1", "hu$0e"), "thickness of link `arm`"),
    ],
)
def test_a_parameter_in_one_is_known_everywhere(
    source: dict[str, str], written: str, label: str
) -> None:
    answer = asked(source, _LINK % written)
    assert answer["parameters"] == ["hue"]
    assert [code for code, _ in answer["findings"]] == ["KD401"]
    assert f"{label}: not known, the parameter `hue` has no value" in answer["hover"]
    assert answer["renamed"] == 1


def test_the_component_at_the_cursor_is_shown(source: dict[str, str]) -> None:
    typed = asked(source, _LINK % "    color = (0.1, $0")
    assert typed["signature"] == "color = (x, y, z)"


def test_a_section_of_values_has_a_class() -> None:
    grammar = grammar_text("kindsl.lark").replace("//: value dynamics kg\n", "\n")
    with pytest.raises(AnnotationError, match="'mass' lacks its '//: value CLASS UNIT'"):
        tables(grammar)


def test_kinds_of_values_are_told_apart_exhaustively() -> None:
    """A table by kinds has no entry for a new one, and only fails when it is asked for it.

    `match` with `assert_never` fails mypy instead.
    """
    for path in Path(kindsl.__file__).parent.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        if "ValueKind." not in text:
            continue
        tree = ast.parse(text)
        by_kind = _tables_by_kind(tree)
        for node in ast.walk(tree):
            if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name):
                assert node.value.id not in by_kind, path


def _tables_by_kind(tree: ast.AST) -> set[str]:
    return {
        ast.unparse(node.targets[0] if isinstance(node, ast.Assign) else node.target)
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign | ast.AnnAssign)
        and isinstance(node.value, ast.Dict)
        and any(key and ast.unparse(key).startswith("ValueKind.") for key in node.value.keys)
    }
