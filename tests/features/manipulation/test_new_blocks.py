"""Where gestures put new things: laid out like what is around them, under names that are free."""

import pytest
from tests.features.manipulation.made import changed

from kindsl.frontends.features.manipulation.additions import add_child, add_frame
from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.judgement.analysis.analysis import analyse

ROBOT = """\
Robot R {
RobotBase b {
    children {
        k via j // the leg
    }
}

link k {
    id = 4
    children {}
}

r_joint j {
    ref_frame {
        translation = (0.0, 0.0, 0.0)
        rotation = (0.0, 0.0, 0.0)
    }
}

}
"""
CHILD = "link1 via joint1"
POINT = (0.1, -0.25, 0.0)
WRITTEN = "translation = (0.1, -0.25, 0.0)"


def with_child(text: str, parent: str, kind: str = "revolute") -> str:
    return changed(text, add_child(analyse(text), parent, POINT, kind)).text


@pytest.mark.parametrize(("kind", "word"), [("revolute", "r_joint"), ("prismatic", "p_joint")])
def test_a_child_is_a_link_and_a_joint_behind_the_others(kind: str, word: str) -> None:
    text = with_child(ROBOT, "k", kind)
    link = "    }\n}\n\nlink link1 {\n    id = 5\n"
    joint = f"    }}\n}}\n\n{word} joint1 {{\n    ref_frame {{\n        {WRITTEN}\n"
    for before, after in ((link, "r_joint j {"), (joint, "\n}\n")):
        assert before in text
        assert after in text[text.index(before) + len(before) :]
    assert f"    id = 4\n    children {{\n        {CHILD}\n    }}\n}}\n" in text


def test_a_child_is_listed_last_and_leaves_comments_beside_the_others() -> None:
    text = with_child(ROBOT, "b")
    assert f"        k via j // the leg\n        {CHILD}\n    }}\n" in text


@pytest.mark.parametrize(
    ("children", "new"),
    [
        ("    children {\n    }\n", f"    children {{\n        {CHILD}\n    }}\n"),
        ("    children { }\n", f"    children {{\n        {CHILD}\n    }}\n"),
        ("    children { // none\n    }\n", f"    children {{ // none\n        {CHILD}\n    }}\n"),
        ("    children {/* none */}\n", f"    children {{ {CHILD} /* none */}}\n"),
        ("    children { l via m }\n", f"    children {{ l via m {CHILD} }}\n"),
        ("    children { l via m}\n", f"    children {{ l via m {CHILD} }}\n"),
        ("    children {\n  l via m\n    }\n", f"    children {{\n  l via m\n  {CHILD}\n    }}\n"),
        ("    /* c */ children {}\n", f"    /* c */ children {{ {CHILD} }}\n"),
    ],
)
def test_a_child_is_laid_out_like_its_section(children: str, new: str) -> None:
    assert new in with_child(ROBOT.replace("    children {}\n", children), "k")


def test_a_name_that_only_a_list_of_children_has_is_taken() -> None:
    """The new link would be carried twice."""
    text = ROBOT.replace("// the leg", "link1 via joint2")
    new = with_child(text, "k")
    assert "link2 via joint1" in new
    assert "KD202" not in {finding.code for finding in analyse(new).findings}


def test_lines_of_new_things_end_like_the_others() -> None:
    for newline in ("\r\n", "\r"):
        text = ROBOT.replace("\n", newline)
        for parent in "bk":
            assert with_child(text, parent) == with_child(ROBOT, parent).replace("\n", newline)


@pytest.mark.parametrize("text", [ROBOT, ROBOT[: ROBOT.index("r_joint")] + "}\n"])
def test_what_is_added_first_has_no_predecessor(text: str) -> None:
    """The first joint goes behind the links."""
    moved = changed(text, add_child(analyse(text), "k", POINT))
    assert [str(link.name) for link in moved.model.links] == ["k", "link1"]
    assert str(moved.model.joints[-1].name) == "joint1"
    assert not [f for f in moved.findings if f.code.startswith("KD00") and f.code != "KD008"]


def test_a_base_alone_takes_its_first_child() -> None:
    text = "Robot R {\n\nRobotBase b {\n    children {}\n}\n\n}\n"
    moved = changed(text, add_child(analyse(text), "b", POINT))
    assert not [f for f in moved.findings if f.severity == "error"]
    assert [str(link.name) for link in moved.model.links] == ["link1"]
    assert moved.model.links[0].id == 1


def test_a_document_may_begin_with_the_link_that_something_is_added_to() -> None:
    text = "\n// of a robot\nlink k { children {} }"
    new = changed(text, add_frame(analyse(text), "k", POINT)).text
    assert new.startswith("\n// of a robot\nlink k { children {} frames { frame1 { ")
    moved = changed(text, add_child(analyse(text), "k", POINT))
    assert moved.text.startswith(f"\n// of a robot\nlink k {{ children {{ {CHILD} }} }}\n\nlink")
    assert moved.model.links[1].id == 1


def test_a_link_whose_keyword_is_misspelt_takes_things_too() -> None:
    """It stands in the piece of text that the block before it begins."""
    text = ROBOT.replace("link k", "ink k")
    for made in (add_frame, add_child):
        new = changed(text, made(analyse(text), "k", POINT)).text
        assert new == changed(ROBOT, made(analyse(ROBOT), "k", POINT)).text.replace(
            "link k", "ink k"
        )


def test_edits_are_in_the_order_of_the_text_wherever_the_parent_stands() -> None:
    base, rest = ROBOT.index("RobotBase"), ROBOT.index("link k")
    behind = ROBOT[:base] + ROBOT[rest:].replace("}\n\n}\n", "}\n\n" + ROBOT[base:rest] + "}\n")
    assert CHILD in with_child(behind, "b")


@pytest.mark.parametrize(
    ("text", "parent", "kind", "reason"),
    [
        (ROBOT, "j", "revolute", "there is no link 'j'"),
        (ROBOT, "k", "helical", "'helical' is neither revolute nor prismatic"),
        (ROBOT.replace("    children {}\n", ""), "k", "revolute",
         "'k' has no section of children to add to"),
        (ROBOT.replace("children {}", "children }"), "k", "revolute",
         "'k' has no section of children to add to"),
    ],
)  # fmt: skip
def test_what_takes_no_child(text: str, parent: str, kind: str, reason: str) -> None:
    assert add_child(analyse(text), parent, POINT, kind) == Refusal(reason)


@pytest.mark.parametrize("taken", ["link k", "r_joint j", "frame", "parameter"])
def test_new_names_are_free(taken: str) -> None:
    """A name must differ from all others; one that is lower and free is taken again."""
    text = ROBOT.replace("children {}", "children {} frames { f { translation = (x, 0.0, 0.0) } }")
    old = {"link k": "k", "r_joint j": "j", "frame": "f {", "parameter": "(x"}[taken]
    for names in (("link", "link"), ("joint", "joint"), ("frame", "frame")):
        stem, _ = names
        new = {"k": f"{stem}1", "j": f"{stem}1", "f {": f"{stem}1 {{", "(x": f"({stem}1"}[old]
        other = text.replace(f"{old} ", f"{new} ") if old in "kj" else text.replace(old, new)
        parent = f"{stem}1" if old == "k" else "k"
        gestures = (
            add_child(analyse(other), parent, POINT),
            add_frame(analyse(other), parent, POINT),
        )
        found = [name for gesture in gestures for name in gesture.names]
        assert found == [f"{s}{2 if s == stem else 1}" for s in ("link", "joint", "frame")]


@pytest.mark.parametrize(
    ("frames", "new"),
    [
        ("", "    children {}\n    frames {\n        frame1 {\n            translation"),
        ("    frames {\n    }\n", "    frames {\n        frame1 {\n            translation"),
        (
            "    frames { }\n",
            f"    frames {{ frame1 {{ {WRITTEN} rotation = (0.0, 0.0, 0.0) }} }}\n",
        ),
        ("    frames {\n        f {}\n    }\n", "        f {}\n        frame1 {\n"),
        ("    frames { f {} g {} }\n", f"    frames {{ f {{}} g {{}} frame1 {{ {WRITTEN} rot"),
    ],
)
def test_a_frame_is_laid_out_like_its_section(frames: str, new: str) -> None:
    text = ROBOT.replace("    children {}\n", f"    children {{}}\n{frames}")
    moved = changed(text, add_frame(analyse(text), "k", POINT))
    assert new in moved.text
    assert [c.value({}) for c in moved.model.frames[-1].pose.translation.components] == [*POINT]
    assert [c.text for c in moved.model.frames[-1].pose.rotation.components] == ["0.0"] * 3


@pytest.mark.parametrize(
    ("text", "link", "reason"),
    [
        (ROBOT, "j", "there is no link 'j'"),
        (ROBOT.replace("link k {", "link k"), "k", "link 'k' is not whole"),
    ],
)
def test_what_takes_no_frame(text: str, link: str, reason: str) -> None:
    assert add_frame(analyse(text), link, POINT) == Refusal(reason)
