"""A shape on a line of a link is one finding, whose fix writes its inertia."""

import pytest
from tests.support.cursor import at_cursor
from tests.support.examples import robot

from kindsl.frontends.features.completion.completion import completions
from kindsl.frontends.features.completion.item import without_placeholders
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

LINK = "link upper {\n    id = 1\n    %s\n    children {}\n}\n"


def document(inertia: str) -> str:
    return robot(LINK % inertia, base="upper via shoulder", joints="shoulder")


@pytest.mark.parametrize(
    "around", ["%s", "inertia_params {\n    %s\n    }", "inertia_params { %s }"]
)
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_its_inertia_is_written(around: str, newline: str) -> None:
    text = document(around % "box(0.04, 0.04, 0.3, density = 2700)").replace("\n", newline)
    (finding,) = analyse(text).findings
    assert finding.code == "KD011" and finding.fix is not None
    after = analyse(apply_edits(text, finding.fix.edits))
    assert after.findings == () and f"mass = 1.296{newline}" in after.text
    assert after.text.count("\r") == after.text.count("\n") * (newline != "\n")


@pytest.mark.parametrize(
    ("shape", "said"),
    [
        ("box(1, 2, mass = 3)", "a box needs x, y, z and 'mass =' or 'density ='"),
        ("sphere(0.1, 3)", "a sphere needs radius"),
        ("sphere(x, mass = 3)", "'x' is not a number"),
        ("sphere(-1, mass = 3)", "not positive"),
    ],
)
def test_what_is_no_shape_is_told(shape: str, said: str) -> None:
    (finding,) = analyse(document(shape)).findings
    assert finding.fix is None and said in finding.message


@pytest.mark.parametrize("place", ["inertia_params {\n    $0\n    }", "inertia_params { $0 }"])
def test_each_shape_that_is_offered_can_be_written(place: str) -> None:
    analysis, offset = at_cursor(document(place))
    offered = [i for i in completions(analysis, offset).items if " of a " in i.label]
    assert len(offered) == 10
    for item in offered:
        (finding,) = analyse(document(without_placeholders(item.text))).findings
        assert finding.code == "KD011" and finding.fix is not None


def test_none_is_offered_where_there_is_an_inertia() -> None:
    inertia = "inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0)"
    analysis, offset = at_cursor(document(f"{inertia} $0 }}"))
    assert not [i for i in completions(analysis, offset).items if " of a " in i.label]
