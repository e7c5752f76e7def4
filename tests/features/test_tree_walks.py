"""What hangs on a link, where it is at zero, and the tree one step at a time: whole and broken."""

import numpy as np
import pytest
from tests.support.cursor import at_cursor
from tests.support.documents import ROOT
from tests.support.mechanisms import matrix
from tests.support.models import Style, random_model

from kindsl.frontends.features.code_lenses import code_lenses
from kindsl.frontends.features.navigation import hierarchy_items, predecessors, successors
from kindsl.frontends.features.outline import kinematic_outline
from kindsl.frontends.features.subtree import subtree_of
from kindsl.frontends.features.zero_configuration import body_pose, frame_pose, joint_pose, own_pose
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.semantics.unknown import Unknown
from kindsl.mechanics.rigid.body import principal_moments_about_com
from kindsl.robots.mechanism.link_inertia import link_inertia
from kindsl.robots.mechanism.reading import reachable_linkage
from kindsl.robots.mechanism.total_mass import Weight, own_mass

QUADRUPED = (ROOT / "examples" / "quadruped.kindsl").read_text()
MOMENTS = "Ix=1.0 Iy=2.0 Iz=3.0 Ixy=0.0 Ixz=0.0 Iyz=0.0"
INERTIA = f"inertia_params {{{{ mass = {{}} CoM = (0.1, 0.0, 0.0) {MOMENTS} {{}} }}}}"
POSE = "ref_frame {{ translation = ({}, 0.0, 0.0) rotation = (0.0, 0.0, PI/2.0) }}"
TREE = f"""\
Robot R {{
RobotBase base {{ {INERTIA.format(1.0, "")} children {{ a via ja nobody via jn c via jc }} }}
link a {{ id = 1 {INERTIA.format(2.0, "ref_frame = f")} children {{ b via jb }}
    frames {{ f {{ translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, PI/2.0) }} }} }}
link b {{ id = 2 {INERTIA.format(4.0, "")} children {{}} }}
link c {{ id = 3 {INERTIA.format("m", "")} children {{ d via nothing }} }}
link d {{ id = 4 children {{}}
    frames {{ g {{ translation = (y, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }} }}
link loose {{ id = 5 {INERTIA.format(8.0, "ref_frame = lost")} children {{ e via je }} }}
link e {{ id = 6 {INERTIA.format("", "")} children {{ e2 via je2 }} }}
link e2 {{ children {{ e via je }} }}
r_joint ja {{ {POSE.format(0.1)} }}
p_joint jb {{ {POSE.format(0.2)} }}
r_joint jc {{ {POSE.format("x")} }}
r_joint jn {{ {POSE.format(0.0)} }}
r_joint je {{ {POSE.format(0.3)} }}
r_joint je2 {{ {POSE.format(0.3)} }}
r_joint unused {{ {POSE.format(0.3)} }}
}}
"""
ANALYSIS = analyse(TREE)


@pytest.mark.parametrize(
    ("name", "weight", "dof"),
    [
        ("base", Weight(6.0, 3, Unknown("there is no link `nobody`")), 4),
        ("a", Weight(6.0), 1),
        ("b", Weight(4.0), 0),
        ("c", Weight(0.0, 2, Unknown("the parameter `m` has no value")), 1),
        ("d", Weight(0.0, 1, Unknown("link `d` has no mass")), 0),
    ],
)
def test_a_link_weighs_what_it_carries(name: str, weight: Weight, dof: int) -> None:
    """What is named there and is not known is missing; a fixed base adds nothing."""
    for analysis in (ANALYSIS, analyse(TREE)):
        found = subtree_of(analysis, analysis.model.body_named[name])
        assert found == (weight, dof)


def test_links_that_carry_each_other_weigh_nothing_known() -> None:
    for name in ("loose", "e", "e2"):
        assert not subtree_of(ANALYSIS, ANALYSIS.model.body_named[name]).weight.is_whole


def test_each_link_is_weighed_once() -> None:
    """Or else a chain takes the square of its length."""
    analysis = analyse(TREE)
    b, base = (analysis.model.body_named[name] for name in ("b", "base"))
    first, whole = subtree_of(analysis, b), subtree_of(analysis, base)
    assert subtree_of(analysis, b) is first
    assert subtree_of(analysis, base) is whole


@pytest.mark.parametrize(
    ("name", "mass"),
    [
        ("base", 1.0),
        ("c", Unknown("the parameter `m` has no value")),
        ("d", Unknown("link `d` has no mass")),
    ],
)
def test_a_link_s_own_mass_is_what_is_written(name: str, mass: float | Unknown) -> None:
    values = ANALYSIS.context.values
    assert own_mass(ANALYSIS.model.body_named[name], values) == mass
    text = "link q { inertia_params { CoM = (0.0, 0.0, 0.0) } }"
    assert own_mass(analyse(text).model.links[0], {}) == Unknown("link `q` has no mass")


@pytest.mark.parametrize(
    "text",
    [QUADRUPED, *(random_model(12, seed, Style(has_expressions=False)) for seed in range(3))],
)
def test_poses_at_zero_are_those_that_are_drawn(text: str) -> None:
    analysis = analyse(text)
    skeleton = reachable_linkage(analysis.model, analysis.context.values)
    drawn = {skeleton.base_name: np.eye(4)}
    names = skeleton.body_names
    model = analysis.model
    for link, parent in skeleton.links():
        drawn[names[link]] = drawn[names[parent]] @ matrix(skeleton.placements[link - 1])
        joint = joint_pose(analysis, model.joint_named[skeleton.joint_names[link - 1]])
        np.testing.assert_allclose(matrix(joint), drawn[names[link]], atol=1e-12)
    for body in reversed(model.bodies):
        pose = body_pose(analysis, body)
        np.testing.assert_allclose(matrix(pose), drawn[str(body.name)], atol=1e-12)
    for frame in model.frames:
        wanted = drawn[frame.link] @ matrix(own_pose(analysis, frame))
        np.testing.assert_allclose(matrix(frame_pose(analysis, frame)), wanted, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("c", "the parameter `x` has no value"),
        ("d", "there is no joint `nothing`"),
        ("loose", "`loose` has no parent"),
        ("e", "`loose` has no parent"),
        ("e2", "`loose` has no parent"),
    ],
)
def test_where_a_link_is_may_not_be_known(name: str, reason: str) -> None:
    for analysis in (ANALYSIS, analyse(TREE)):
        assert body_pose(analysis, analysis.model.body_named[name]) == Unknown(reason)


def test_in_a_loop_nothing_has_a_place() -> None:
    links = "link a { children { b via j } } link b { children { a via k c via j } } link c { }"
    joints = f"r_joint j {{ {POSE.format(0.1)} }} r_joint k {{ {POSE.format(0.1)} }}"
    for first in "abc":
        analysis = analyse(links + joints)
        found = body_pose(analysis, analysis.model.body_named[first])
        assert isinstance(found, Unknown) and "is part of a kinematic loop" in found.reason


def test_where_a_joint_or_frame_is_may_not_be_known() -> None:
    model = ANALYSIS.model
    joints = {"unused": "no link is connected via `unused`", "jc": "the parameter `x` has no value",
              "je": "`loose` has no parent"}  # fmt: skip
    for name, reason in joints.items():
        assert joint_pose(ANALYSIS, model.joint_named[name]) == Unknown(reason)
    frames = {str(frame.name): frame for frame in model.frames}
    assert frame_pose(ANALYSIS, frames["g"]) == Unknown("there is no joint `nothing`")
    assert own_pose(ANALYSIS, frames["g"]) == Unknown("the parameter `y` has no value")
    pose = frame_pose(ANALYSIS, frames["f"])
    assert pose.translation == pytest.approx((0.1, 0.5, 0.0))


@pytest.mark.parametrize(
    ("name", "com", "moments"),
    [
        ("base", (0.1, 0.0, 0.0), (1.0, 1.99, 2.99)),
        # The frame is 0.5 along x and a quarter turn about z.
        ("a", (0.5, 0.1, 0.0), (1.0, 1.98, 2.98)),
    ],
)
def test_an_inertia_is_seen_from_the_link_s_frame(name: str, com: object, moments: object) -> None:
    body = link_inertia(ANALYSIS.model.body_named[name], {})
    assert not isinstance(body, Unknown)
    assert body.com == pytest.approx(com)
    assert principal_moments_about_com(body) == pytest.approx(moments)


def test_an_inertia_in_a_frame_of_another_name_is_not_known() -> None:
    named = ANALYSIS.model.body_named
    assert link_inertia(named["d"], {}) == Unknown("it has no inertia section")
    assert link_inertia(named["c"], {}) == Unknown("the parameter `m` has no value")
    assert link_inertia(named["loose"], {}) == Unknown("it has no frame `lost`")
    text = TREE.replace("f { translation = (0.5", "f { translation = (z").replace(
        "link a", "link q"
    )
    assert link_inertia(analyse(text).model.body_named["q"], {}) == Unknown(
        "the parameter `z` has no value"
    )
    unnamed = analyse(TREE.replace("ref_frame = lost", "ref_frame = "))
    loose = unnamed.model.body_named["loose"]
    assert link_inertia(loose, {}) == Unknown("its frame has no name")
    two = TREE.replace("frames { f {", "frames { h {} f {")
    assert link_inertia(analyse(two).model.body_named["a"], {}).com == pytest.approx(
        (0.5, 0.1, 0.0)
    )


def calls(found: object) -> list[tuple[str, str, str]]:
    return [
        (call.item.name, call.item.detail, TREE[call.place.start : call.place.end])
        for call in found
    ]


def test_each_step_of_the_tree_tells_where_it_is_written() -> None:
    assert calls(successors(ANALYSIS, "base")) == [
        ("a", "via ja (revolute)", "a via ja"),
        ("c", "via jc (revolute)", "c via jc"),
    ]
    assert calls(successors(ANALYSIS, "c")) == [("d", "link", "d via nothing")]
    assert calls(predecessors(ANALYSIS, "a")) == [("base", "base", "a via ja")]
    assert calls(predecessors(ANALYSIS, "b")) == [("a", "via ja (revolute)", "b via jb")]
    above_e = [("loose", "link", "e via je"), ("e2", "via je2 (revolute)", "e via je")]
    assert calls(predecessors(ANALYSIS, "e")) == above_e
    for name in ("nobody", "ja", ""):
        assert predecessors(ANALYSIS, name) == successors(ANALYSIS, name) == ()


@pytest.mark.parametrize(
    ("place", "name"),
    [("link b", "b"), ("b via jb", "b"), ("p_joint jb", "b"), ("r_joint unused", None),
     ("R {", None),
     ("RobotBase base", "base"), ("nobody via", None), ("nothing", None), ("r_joint jn", None),
     ("f { tr", None), ("m CoM", None), ("id = 1", None)],
)  # fmt: skip
def test_the_tree_opens_at_the_name_of_a_link_or_of_its_joint(place: str, name: str | None) -> None:
    head, _, last = place.rpartition(" ") if place.split(" ")[0] in (
        "link", "p_joint", "r_joint", "RobotBase") else ("", "", place)  # fmt: skip
    marked = TREE.replace(place, f"{head} $0{last}" if head else f"$0{place}", 1)
    found = hierarchy_items(*at_cursor(marked))
    assert [item.name for item in found] == ([] if name is None else [name])


def shown(symbol: object) -> object:
    below = [shown(child) for child in symbol.children]
    entry = f"{symbol.name}: {symbol.detail}"
    return (entry, below) if below else entry


def test_the_outline_of_a_broken_tree_has_everything_once() -> None:
    b = ("b: via jb (prismatic), id 2", ["jb: prismatic"])
    a = ("a: via ja (revolute), id 1", ["ja: revolute", b, "f: frame"])
    c = ("c: via jc (revolute), id 3", ["jc: revolute", ("d: via nothing, id 4", ["g: frame"])])
    e2 = ("e2: via je2 (revolute)", ["je2: revolute"])
    e = ("e: via je (revolute), id 6", ["je: revolute", e2])
    assert [shown(symbol) for symbol in kinematic_outline(ANALYSIS)] == [
        ("base: base", [a, c]), ("loose: id 5", [e]), "jn: revolute", "unused: revolute",
    ]  # fmt: skip


def test_a_link_that_nothing_carries_is_shown_below_its_parent_wherever_it_stands() -> None:
    analysis = analyse("link k { } link p { children { k via j } } link q { children { p via i } }")
    assert [symbol.name for symbol in kinematic_outline(analysis)] == ["q"]


def test_a_parameter_or_frame_with_a_joint_s_name_opens_no_link() -> None:
    text = TREE.replace("(y, 0.0", "(jb, 0.0").replace("g {", "ja {")
    for place in ("jb, 0.0", "ja { tr"):
        assert hierarchy_items(*at_cursor(text.replace(place, f"$0{place}"))) == ()


def test_a_joint_that_two_links_use_is_shown_once() -> None:
    text = TREE.replace("c via jc", "c via ja")
    names = []

    def walk(symbols: object) -> None:
        for symbol in symbols:
            names.append(symbol.name)
            walk(symbol.children)

    walk(kinematic_outline(analyse(text)))
    assert len(names) == len(set(names))


def lenses(analysis: Analysis) -> list[tuple[str, str, str, list[str]]]:
    text = analysis.text
    return [
        (text[s.start : s.end], s.kind, s.title, [text[p.start : p.end] for p in s.places])
        for s in code_lenses(analysis)
    ]


def test_lenses_count_places_and_what_is_carried() -> None:
    found = lenses(ANALYSIS)
    assert [each[2] for each in found if each[0] == "R"] == ["▶ Preview"]
    assert [each[2] for each in found if each[1] == "subtree"][:3] == [
        "carries 4 joints, at least 6 kg",
        "carries 1 joint, 6 kg with itself",
        "carries 1 joint, mass unknown",
    ]
    counts = {each[0]: (each[2], each[3]) for each in found if each[1] == "references"}
    assert counts["a"] == ("1 reference", ["a"])
    assert counts["e"] == ("2 references", ["e", "e"])
    assert counts["loose"] == counts["unused"] == ("0 references", [])
    assert counts["je"] == ("2 references", ["je", "je"])
    assert "base" not in counts
    assert [each[0] for each in found] == sorted((e[0] for e in found), key=lambda n: found.index(
        next(e for e in found if e[0] == n)))  # fmt: skip
    assert lenses(analyse("RobotBase b {}")) == []
