"""What edits that are no fixes leave as it is: formatting, refactorings, gestures.

None loses a remark or a block or makes an error. What each may do to numbers stands here.
"""

import random
import re

import pytest
from tests.features.samples import PARAMETRIC
from tests.support import robots
from tests.support.amount import usually
from tests.support.kept import changed_at_their_values, errors
from tests.support.models import LAYOUTS, Style, random_model
from tests.support.spoilt import spoilt_robot
from tests.support.walkers import walker

from kindsl.frontends.features.actions.code_actions import refactorings
from kindsl.frontends.features.manipulation.additions import add_child, add_frame
from kindsl.frontends.features.manipulation.gesture import Gesture
from kindsl.frontends.features.manipulation.mirror_leg import mirror_leg
from kindsl.frontends.features.manipulation.pose_as_zero import pose_as_zero
from kindsl.frontends.features.manipulation.set_component import ComponentChange, set_component
from kindsl.frontends.features.manipulation.things import Thing
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.proof import effect
from kindsl.language.formatting import FormattingRefusedError, format_document
from kindsl.language.text.edits import TextEdit

PARTS = range(5)
# What an action may do to numbers, by the beginning of its title: a pattern of all that changes.
ALLOWED = {
    "Extract to a parameter": None,
    "Inline the parameter": None,
    "Sort the links": None,
    "Renumber the links": r"\(.*'id'\): ",
    "Give the inertia of": r"\(.*('com'|'I\w+')|gained: .*'frame'",
    "Add ": "gained: ",
}


def robot(generator: random.Random) -> str:
    """Return a robot, mostly sound, with remarks."""
    style = Style(layout=generator.choice(LAYOUTS))
    made = generator.choice(
        (
            lambda: random_model(generator.randint(1, 5), generator.randrange(10**6), style),
            lambda: spoilt_robot(generator),
            lambda: walker(generator),
            lambda: generator.choice((robots.ARM, robots.LIFT, robots.STUB, PARAMETRIC)),
        )
    )()
    lines = made.split("\n")
    for _ in range(3):
        at = generator.randrange(len(lines))
        if "//" not in lines[at]:
            lines[at] += f" // remark {generator.randrange(10**6)}"
    return "\n".join(lines)


def assert_whole(before: Analysis, edits: tuple[TextEdit, ...], title: str) -> Analysis:
    after = before.edited(edits)
    assert effect(before.syntax, after.syntax).is_whole, title
    # A body that is impossible but for rounding is so for certain with all its digits.
    is_impossible = any("KD300" < finding.code < "KD309" for finding in before.findings)
    if not (is_impossible and title.startswith("Give the inertia")):
        assert errors(after).total() <= errors(before).total(), title
    return after


def each_time(part: int, usual: int, thorough: int) -> list[tuple[Analysis, random.Random]]:
    generator = random.Random(f"kept {part}")
    count = usually(usual, thoroughly=thorough)
    return [(analyse(robot(generator)), generator) for _ in range(count)]


@pytest.mark.parametrize("part", PARTS)
def test_formatting_keeps_everything(part: int) -> None:
    for analysis, _ in each_time(part, 10, 200):
        try:
            edits = tuple(format_document(analysis.syntax))
        except FormattingRefusedError:
            continue
        after = assert_whole(analysis, edits, "format")
        assert effect(analysis.syntax, after.syntax).is_kept


@pytest.mark.parametrize("part", PARTS)
def test_refactorings_change_the_numbers_that_they_are_about(part: int) -> None:
    for analysis, generator in each_time(part, 6, 100):
        for _ in range(12):
            at = generator.randrange(len(analysis.text))
            for action in refactorings(analysis, at, at):
                after = assert_whole(analysis, action.edits, action.title)
                told = changed_at_their_values(analysis, after)
                (allowed,) = (ALLOWED[key] for key in ALLOWED if action.title.startswith(key))
                unexpected = [t for t in told if allowed is None or not re.match(allowed, t)]
                assert not unexpected, action.title


@pytest.mark.parametrize("part", PARTS)
def test_gestures_change_the_numbers_that_they_are_about(part: int) -> None:
    for analysis, generator in each_time(part, 6, 100):
        link = generator.choice([str(body.name) for body in analysis.model.bodies] or [""])
        angles = {str(joint.name): 0.25 for joint in analysis.model.joints}
        gestures = {
            "gained: ": add_child(analysis, link, (0.1, 0.0, 0.2)),
            "gained: .*'frame'": add_frame(analysis, link, (0.1, 0.0, 0.2)),
            "gained: .*": mirror_leg(analysis, link),
            r"\('joint'.*('rotation'|'translation')": pose_as_zero(analysis, angles),
        }
        for allowed, done in gestures.items():
            if isinstance(done, Gesture):
                after = assert_whole(analysis, done.edits, done.title)
                told = changed_at_their_values(analysis, after)
                assert not [t for t in told if not re.match(allowed, t)], done.title


@pytest.mark.parametrize("part", PARTS)
def test_a_drag_changes_one_number(part: int) -> None:
    for analysis, generator in each_time(part, 6, 100):
        joints = [str(joint.name) for joint in analysis.model.joints]
        if not joints or len(set(joints)) < len(joints):
            continue
        joint = generator.choice(joints)
        change = set_component(analysis, Thing("joint", joint), "y", 7.125)
        if isinstance(change, ComponentChange) and change.edits:
            after = assert_whole(analysis, change.edits, "drag")
            told = changed_at_their_values(analysis, after)
            shared = re.search(r"\w\[|<", analysis.text)
            assert len(told) == 1 or shared, told
