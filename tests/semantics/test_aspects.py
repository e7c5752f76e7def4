"""Which facts of a document hold after an edit: those of what the edit leaves equal."""

import pytest
from tests.support.models import Style, random_model

from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.model import Model
from kindsl.language.syntax.document import parse
from kindsl.language.text.edits import TextEdit

TEXT = """Robot Arm {
RobotBase ground { children { upper via shoulder } }
link upper { id = 1
    inertia_params {
        mass = 2.0 CoM = (0.0, 0.0, load) Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }
    children { }
    frames { tip { translation = (0.0, 0.0, 0.5) rotation = (0.0, 0.0, 0.0) } }
}
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.3) rotation = (0.0, reach, 0.0) } }
}
"""
ONE_BY_ONE = list(Aspect)


def differing(old: str, new: str, text: str = TEXT) -> Aspect:
    """Return of which aspects the facts are other ones after an edit."""
    before = parse(text)
    known = {aspect: Model(before).edition.facts(aspect) for aspect in ONE_BY_ONE}
    at = text.index(old)
    after = Model(before.edited([TextEdit(at, at + len(old), new)])).edition
    found = Aspect.NOTHING
    for aspect, facts in known.items():
        found |= Aspect.NOTHING if after.facts(aspect) is facts else aspect
    return found


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        ("mass = 2.0", "mass = 2.5", Aspect.MASSES),
        ("0.3", "0.4", Aspect.PLACES),
        ("0.5", "0.4", Aspect.PLACES),
        ("load", "cargo", Aspect.MASSES | Aspect.SYMBOLS),
        ("reach", "1.5", Aspect.PLACES | Aspect.SYMBOLS),
        ("id = 1", "id = 1 // the first", Aspect.LAYOUT),
        ("mass = 2.0", "mass  =  2.0", Aspect.LAYOUT),
        ("id = 1", "id = 2", Aspect.STRUCTURE),
        ("tip", "top", Aspect.STRUCTURE),
        ("r_joint", "p_joint", Aspect.STRUCTURE),
        ("mass = 2.0", "mass = 2.0", Aspect.NOTHING),
    ],
)
def test_an_edit_changes_the_aspects_that_it_is_of(old: str, new: str, found: Aspect) -> None:
    assert differing(old, new) == found


def test_a_number_typed_in_a_broken_block_leaves_names_equal() -> None:
    broken = TEXT.replace("CoM = (0.0,", "CoM = 0.0,")
    assert Aspect.STRUCTURE not in differing("mass = 2.0", "mass = 3.0", broken)
    assert Aspect.STRUCTURE in differing("children { }", "children { lower }", broken)


def test_an_island_more_is_another_document() -> None:
    assert differing("r_joint", "link lower { id = 2 }\nr_joint") == Aspect.ALL


def test_facts_of_several_aspects_go_with_each_of_them() -> None:
    before = parse(random_model(5, 1, Style()))
    both = Aspect.STRUCTURE | Aspect.MASSES
    facts = Model(before).edition.facts(both)
    at = before.text.index("mass = ") + len("mass = ")
    assert Model(before).edition.facts(both) is facts
    assert Model(before.edited([TextEdit(at, at, "1")])).edition.facts(both) is not facts
