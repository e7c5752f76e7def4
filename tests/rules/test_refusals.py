"""What robcogen2 refuses to load, and what it takes though a rule speaks of it."""

import pytest
from tests.support.examples import link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.refusals import refused_by

ONE, TWO = "arm via elbow", "arm via elbow hand via wrist"


def refusals(target: str, text: str, *targets: str) -> list[str]:
    analysis = analyse(text, Settings(frozenset(targets)))
    found = refused_by(target, analysis.model, analysis.context)
    return [f.message for f in found if f.message.startswith("not supported by")]


def arms(base: str, arm: str = "", hand: str = "", joints: str = "elbow wrist") -> str:
    return robot(link("arm", 1, arm), link("hand", 2, hand), base=base, joints=joints)


@pytest.mark.parametrize(
    ("text", "refused"),
    [
        (arms(TWO), ""),
        # A link that is its own child is taken where nothing else carries it; a longer loop is not.
        (arms(ONE, hand="hand via wrist"), ""),
        (arms(TWO, arm="arm via neck", joints="elbow wrist neck"), "arm"),
        (arms(ONE, "hand via wrist", "arm via neck", "elbow wrist neck"), "loop"),
        # So is a child that is listed twice, but not by another joint.
        (arms(f"{TWO} {ONE}"), ""),
        (arms(f"{TWO} arm via neck", joints="elbow wrist neck"), "arm"),
        (arms(f"{TWO} ground via neck", joints="elbow wrist neck"), "ground"),
    ],
)
def test_robcogen2_takes_what_it_can_load(text: str, refused: str) -> None:
    found = refusals("robcogen2", text, "robcogen2")
    assert len(found) == bool(refused)
    for message in found:
        assert message.startswith("not supported by robcogen2: ")
        assert refused in message
    assert refusals("robcogen2", text) == []
    assert refusals("robcogen2", text, "robcogen") == []


FRAMES = " frames { tool { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }"


@pytest.mark.parametrize(
    ("n_frames", "is_used", "refused"), [(1, True, False), (2, True, True), (2, False, False)]
)
def test_robcogen2_looks_for_a_frame_among_those_of_all_links(
    n_frames: int, is_used: bool, refused: bool
) -> None:
    arm, hand = link("arm", 1), link("hand", 2)
    if is_used:
        arm = arm.replace("Iyz=0.0\n", "Iyz=0.0 ref_frame = tool\n")
    arm, hand = (text.rstrip().removesuffix("}") for text in (arm, hand))
    links = f"{arm}{FRAMES} }}\n", f"{hand}{FRAMES if n_frames == 2 else ''} }}\n"
    text = robot(*links, base=TWO, joints="elbow wrist")
    expected = ["not supported by robcogen2: 2 frames have the name 'tool'"] * refused
    assert refusals("robcogen2", text, "robcogen2") == expected
    assert refusals("robcogen", text, "robcogen", "robcogen2") == []


def test_robcogen_stops_at_the_base_as_a_child_alone() -> None:
    text = arms(f"{TWO} ground via neck", joints="elbow wrist neck")
    assert len(refusals("robcogen", text, "robcogen")) == 1
    loop = arms(ONE, "hand via wrist", "arm via neck", "elbow wrist neck")
    assert refusals("robcogen", loop, "robcogen") == []
