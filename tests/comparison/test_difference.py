"""What `kindsl diff` says of one change at a time."""

from math import pi
from pathlib import Path

import pytest

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.robots.comparison.difference import Difference, difference
from kindsl.robots.mechanism.linkage import Linkage

ARM = (Path(__file__).parents[2] / "examples" / "industrial_arm.kindsl").read_text()


def skeleton(text: str) -> Linkage:
    return kindsl.parse(text, Settings(bindings={"tool_length": Binding(0.1)})).skeleton()


def changed(old: str, new: str) -> Difference:
    assert old in ARM
    return difference(skeleton(ARM), skeleton(ARM.replace(old, new)))


def test_nothing() -> None:
    assert difference(skeleton(ARM), skeleton(ARM)).is_empty
    assert changed("mass = 8.058", "mass = 8.0580").is_empty


def test_mass() -> None:
    found = changed("mass = 8.058", "mass = 9.058")
    (change,) = found.masses
    assert change.link == "upper_arm"
    assert change.mass == (8.058, 9.058)
    assert found.total_mass[1] - found.total_mass[0] == pytest.approx(1.0)
    assert not found.joint_frames and not found.is_empty


def test_a_moved_joint_moves_what_it_carries() -> None:
    found = changed("(-0.425, 0.0, 0.0)", "(-0.435, 0.0, 0.0)")
    (move,) = found.joint_frames
    assert (move.name, move.distance) == ("elbow", pytest.approx(0.01))
    names = {move.name for move in found.zero_poses}
    assert "tool" in names and "upper_arm" not in names
    assert found.reach[1] - found.reach[0] == pytest.approx(0.01)


def test_a_turned_joint() -> None:
    found = changed("rotation = (-PI/2.0, 0.0, 0.0)", "rotation = (PI/2.0, 0.0, 0.0)")
    assert [(move.name, move.angle) for move in found.joint_frames] == [
        ("wrist_3", pytest.approx(pi))
    ]


def test_renamed_link_is_not_removed_and_added() -> None:
    found = changed("wrist_2_link", "wrist_b")
    (pair,) = found.renamed_links
    assert (pair.old, pair.new) == ("wrist_2_link", "wrist_b")
    assert not found.added_links and not found.removed_links and not found.reparented
    assert not found.zero_poses


def test_joint_kind() -> None:
    (change,) = changed("r_joint elbow", "p_joint elbow").joint_kinds
    assert (change.joint, change.old, change.new) == ("elbow", "revolute", "prismatic")


def test_reparented() -> None:
    text = ARM.replace("wrist_3_link via wrist_3", "").replace(
        "wrist_2_link via wrist_2", "wrist_2_link via wrist_2\n        wrist_3_link via wrist_3"
    )
    (moved,) = difference(skeleton(ARM), skeleton(text)).reparented
    assert (moved.link, moved.old_parent, moved.new_parent) == (
        "wrist_3_link",
        "wrist_2_link",
        "wrist_1_link",
    )


def test_frames_and_base() -> None:
    found = changed("flange", "mount")
    assert (found.added_frames, found.removed_frames) == (("mount",), ("flange",))
    assert changed("RobotBase base {", "RobotBase base floating {").base_kind == (
        "fixed",
        "floating",
    )
