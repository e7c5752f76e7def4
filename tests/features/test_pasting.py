"""Pasting what another program says writes what the fix of the pasted text would."""

import pytest
from tests.analysis.test_pasted_urdf import ARM, ELBOW, FOREARM, INERTIAL
from tests.cad.test_reports import EXPECTED, REPORTS
from tests.cad.test_sentences import ON_AXIS

import kindsl
from kindsl.frontends.features.pasting import Pasting, pastings
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.text.edits import apply_edits

NEW = "link hand {\n    id = 2\n    $0\n    children {}\n}\n"
IN_LINES = {
    "on a line of its own": NEW,
    "at a line's beginning": NEW.replace("    $0", "$0"),
    "behind a section": NEW.replace("\n    $0", "$0"),
    "before a section": NEW.replace("$0\n    ", "$0"),
    "over what is selected": NEW.replace("$0", "$0// to do$1"),
}


def pasted(source: str, text: str) -> tuple[Analysis, tuple[Pasting, ...]]:
    start = source.index("$0")
    end = source.index("$1") - 2 if "$1" in source else start
    analysis = analyse(source.replace("$0", "").replace("$1", ""))
    return analysis, pastings(analysis, start, end, text)


def only(found: tuple[Analysis, tuple[Pasting, ...]]) -> Analysis:
    analysis, (way,) = found
    assert way.is_certain
    return analyse(apply_edits(analysis.text, way.edits))


@pytest.mark.parametrize("place", IN_LINES)
@pytest.mark.parametrize("name", EXPECTED)
def test_a_report_becomes_the_inertia(name: str, place: str) -> None:
    after = only(pasted(ARM.replace("r_joint", IN_LINES[place] + "r_joint"), REPORTS[name]))
    hand = after.model.links[-1]
    assert not [island for island in after.model.islands if island.problems]
    assert hand.inertia is not None and hand.inertia.mass is not None
    assert hand.inertia.mass.text == kindsl.mass_properties(REPORTS[name]).mass


def test_an_unproved_sign_leaves_a_choice() -> None:
    _, ways = pasted(ARM.replace("r_joint", NEW + "r_joint"), ON_AXIS.format(notation=""))
    assert [way.is_certain for way in ways] == [False, False]


def test_elements_of_urdf_become_blocks() -> None:
    elements = ELBOW.format(axis="0 1 0") + FOREARM.format(yaw="0")
    after = only(pasted(ARM.replace("r_joint", "$0\nr_joint"), elements))
    assert [str(link.name) for link in after.model.links] == ["upper", "forearm"]
    assert after.findings == ()


def test_an_inertial_becomes_the_inertia() -> None:
    after = only(pasted(ARM.replace("r_joint", NEW + "r_joint"), INERTIAL.format(yaw="0")))
    assert "mass = 2.345" in after.text


@pytest.mark.parametrize("text", ["", "link hand { id = 2 children {} }", "mass = 1.0", "<a/>"])
def test_other_texts_are_pasted_as_they_are(text: str) -> None:
    assert pasted(ARM.replace("r_joint", "$0r_joint"), text)[1] == ()


def test_a_contradiction_is_pasted_as_it_is() -> None:
    wrong = ON_AXIS.format(notation="").replace("Iyx = 0", "Iyx = 1")
    assert pasted(ARM.replace("r_joint", NEW + "r_joint"), wrong)[1] == ()
