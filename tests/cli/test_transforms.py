"""Transforms documents in the linter and in generated code."""

from pathlib import Path

import lark
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.cli.conftest import Runner
from tests.cli.samples import arm
from tests.codegen.compiling import COMPILERS, build, needs_compiler, run_tests

import kindsl
from kindsl.language.syntax.transforms_text import read_transforms
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.products.codegen.wanted import wanted_pairs
from kindsl.robots.mechanism.bodies import bodies_of

GRAMMAR = (Path(__file__).parents[2] / "grammar" / "dtdsl.lark").read_text(encoding="utf-8")
GOOD = """\
Robot arm // a comment
Frames { fr_base, fr_upper, fr_lower, tip }
Transforms {
    base=fr_base, target=fr_lower
    base=tip, target=fr_upper
}
Jacobians {
    base=fr_base, target=tip  /* another */
    base=tip, target=fr_base
}
"""
WORDS = ["Robot", "arm", "Frames", "Transforms", "Jacobians", "{", "}", ",", "base", "target", "=",
         "fr_base", "tip", "fr_base, tip", "base=a, target=b", "<-", "->", "1",
         "// x\n", ";"]  # fmt: skip


@pytest.fixture
def beside(folder: Path) -> Path:
    """The name of a transforms document beside a model."""
    (folder / "arm.kindsl").write_text(arm(floating=True))
    return folder / "arm.dtdsl"


def test_nothing_is_wrong(kdsl_lint: Runner, beside: Path) -> None:
    beside.write_text(GOOD)
    told = kdsl_lint("arm.dtdsl")
    assert (told.status, told.out) == (0, "")


def test_a_link_with_the_name_of_a_joints_frame_does_not_hide_it() -> None:
    text = arm().replace("lower via", "fr_elbow via").replace("link lower", "link fr_elbow")
    document = kindsl.parse(text)
    robot = robot_of(bodies_of(document.skeleton()))
    listed = "Robot arm Frames { fr_base, fr_elbow, fr_fr_elbow } Transforms { %s }"
    pairs = "base=fr_base, target=fr_elbow base=fr_base, target=fr_fr_elbow"
    joint, link = (
        pair[1] for pair in wanted_pairs(listed % pairs, document.model, robot).transforms
    )
    assert (joint.name, joint.body, joint.r) == ("fr_elbow", 1, robot.joint_frame(2).r)
    assert (link.name, link.body, link.r) == ("fr_fr_elbow", 2, [0.0, 0.0, 0.0])
    told = [finding.message for finding in document.findings if finding.code == "KD113"]
    assert told == ["'fr_elbow' is already the name of the frame of joint 'elbow'"]


@pytest.mark.parametrize(
    ("old", "new", "place", "code"),
    [
        ("fr_lower\n", "fr_lowr\n", "4:26", "KD801"),
        ("fr_lower, tip }", "tip }", "4:26", "KD802"),
        ("base=tip, target=fr_upper", "base=fr_base, target=fr_lower", "5:10", "KD803"),
        ("fr_base, fr_upper", "fr_base, tip, fr_upper", "2:44", "KD803"),
        ("Robot arm", "Robot leg", "1:7", "KD804"),
        ("base=tip, ", "base tip, ", "5:10", "KD800"),
        ("base=tip, target=fr_upper", "fr_base <- fr_lower", "5:5", "KD803"),
        ("base=tip, target=fr_upper", "fr_lower -> fr_base", "5:5", "KD803"),
        ("base=tip, target=fr_upper", "tip <- fr_uper", "5:12", "KD801"),
    ],
)
def test_what_is_wrong(
    old: str, new: str, place: str, code: str, kdsl_lint: Runner, beside: Path
) -> None:
    beside.write_text(GOOD.replace(old, new, 1))
    told = kdsl_lint("arm.dtdsl")
    lines = [line for line in told.out.splitlines() if line.startswith("arm.dtdsl:")]
    assert any(line.startswith(f"arm.dtdsl:{place}: ") and f"[{code}]" in line for line in lines)
    assert kdsl_lint("arm.dtdsl", "--ignore", "KD8").out == ""


def test_an_unknown_frame_is_an_error_only_where_a_pair_needs_it(
    kdsl_lint: Runner, kindsl: Runner, beside: Path
) -> None:
    beside.write_text(GOOD.replace("tip }", "tip, nose }"))
    message = "arm.dtdsl:2:44: warning[KD801] the robot has no frame 'nose'"
    assert message in kdsl_lint("arm.dtdsl").out
    done = kindsl("generate", "arm.kindsl", "--language", "python", "-o", "out")
    assert (done.status, done.err) == (0, f"{message}\nout: 2 files written\n")
    beside.write_text(GOOD.replace("tip }", "tip, nose }").replace("base=tip", "base=nose"))
    assert "arm.dtdsl:2:44: error[KD801]" in kdsl_lint("arm.dtdsl").out
    done = kindsl("generate", "arm.kindsl", "--language", "python", "-o", "out")
    assert done.status == 1 and "arm.dtdsl:2:44: error: the robot has no frame 'nose'" in done.err
    beside.write_text(GOOD.replace("base=tip", "base=lower"))
    done = kindsl("generate", "arm.kindsl", "--language", "python", "-o", "out")
    assert "the robot has no frame 'lower'; did you mean 'fr_lower'?" in done.err


def test_a_frame_listed_again_is_told_once_each_time(kdsl_lint: Runner, beside: Path) -> None:
    beside.write_text(GOOD.replace("tip }", "tip, tip, tip }"))
    message = "warning[KD803] frame 'tip' is already listed"
    lines = [line for line in kdsl_lint("arm.dtdsl").out.splitlines() if "arm.dtdsl:" in line]
    assert lines == [f"arm.dtdsl:2:{column}: {message}" for column in (44, 49)]


def test_a_model_that_is_not_there_is_no_matter(kdsl_lint: Runner, folder: Path) -> None:
    (folder / "lonely.dtdsl").write_text(GOOD)
    assert kdsl_lint("lonely.dtdsl").out == ""


@needs_compiler
def test_code_for_the_pairs(kindsl: Runner, beside: Path, folder: Path) -> None:
    beside.write_text(GOOD)
    options = ("--language", "c", "--quantities", "poses", "-o", "out")
    told = kindsl("generate", "arm.kindsl", *options)
    assert told.status == 0, told.err
    header = (folder / "out" / "arm.h").read_text()
    assert "void arm_pose_fr_lower_in_fr_base(" in header
    assert "ok jacobian_fr_base_in_tip: J" in run_tests(
        build(COMPILERS[0], folder / "out", [], "t")
    )
    assert kindsl("generate", "arm.kindsl", "--check", "out").status == 0
    beside.write_text(GOOD.replace("base=tip", "base=top"))
    told = kindsl("generate", "arm.kindsl", *options)
    assert told.status == 1
    assert told.err == (
        "arm.dtdsl:5:10: error: the robot has no frame 'top'; did you mean 'tip'?\n"
    )


@pytest.mark.parametrize("named", [(), ("--transforms", "named.dtdsl")])
def test_code_no_longer_fits_when_its_transforms_document_changed(
    named: tuple[str, ...], kindsl: Runner, beside: Path, folder: Path
) -> None:
    beside.write_text(GOOD)
    used = folder / "named.dtdsl" if named else beside
    used.write_text(GOOD.replace("base=tip, target=fr_upper", ""))
    options = ("--language", "python", "--quantities", "poses", "-o", "out")
    assert kindsl("generate", "arm.kindsl", *options, *named).status == 0
    check = ("generate", "arm.kindsl", "--check", "out")
    used.write_text(used.read_text() + "// a comment\n")
    assert kindsl(*check).status == 0
    used.write_text(GOOD)
    told = kindsl(*check)
    message = "the transforms document has changed since 'out' was generated"
    assert (told.status, told.err) == (1, f"arm.kindsl: error: {message}\n")
    used.unlink()
    assert kindsl(*check).status == 0


@settings(max_examples=300, deadline=None, derandomize=True)
@given(st.lists(st.sampled_from(WORDS), max_size=12))
def test_what_is_accepted_is_what_the_grammar_says(words: list[str]) -> None:
    _compare(" ".join(words))
    _compare("Robot arm Frames { a } Transforms { " + " ".join(words) + " }")


def test_the_example_is_accepted() -> None:
    assert not read_transforms(GOOD).defects
    assert len(read_transforms(GOOD).jacobians) == 2
    _compare(GOOD)


_ORDERED = GRAMMAR.replace("(frames | transforms | jacobians)*", "frames? transforms? jacobians?")
_PARSER = lark.Lark(_ORDERED, start="document", parser="lalr")


def _compare(text: str) -> None:
    try:
        _PARSER.parse(text)
        is_right = True
    except lark.exceptions.LarkError:
        is_right = False
    assert (not read_transforms(text).defects) is is_right, text


def test_a_folder_brings_them_too(kdsl_lint: Runner, kindsl: Runner, beside: Path) -> None:
    beside.write_text(GOOD.replace("Robot arm", "Robot leg"))
    assert "arm.dtdsl:1:7" in kdsl_lint(".").out
    kindsl("format", ".")
    assert beside.read_text() == GOOD.replace("Robot arm", "Robot leg")
