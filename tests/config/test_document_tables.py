"""Tables of one document that are written into a configuration file."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.judgement.config.configuration_reading import configuration_of
from kindsl.judgement.config.document_tables import with_joints, with_pose
from kindsl.language.semantics.parameters import JointProperties

ELBOW = JointProperties(minimum=-1.0, maximum=2.0)


def test_joints_that_are_told_stay_and_the_others_get_a_table(tmp_path):
    file, document = str(tmp_path / "kindsl.toml"), str(tmp_path / "arm.kindsl")
    text = "[joints.wrist]\nmin = -3.0\n"
    written = with_joints(file, text, document, {"wrist": ELBOW, "elbow": ELBOW})
    assert written is not None and written.startswith(text)
    told = configuration_of(file, written).settings_for(document).joints
    assert told["elbow"] == ELBOW
    assert told["wrist"] == JointProperties(minimum=-3.0)
    assert with_joints(file, written, document, {"wrist": ELBOW, "elbow": ELBOW}) == written


NUMBER = st.none() | st.floats(0.0, 1e300)
OWN = st.tuples(NUMBER, NUMBER, NUMBER, NUMBER, NUMBER, NUMBER, NUMBER).map(
    lambda n: JointProperties(None if n[0] is None else -n[0], *n[1:])
)
NAME = st.from_regex(r"[^\W\d]\w{,3}", fullmatch=True)
FILE_NAME = st.text("aZ9 .-_*?[]!#\\\"'\u00e9", min_size=1, max_size=8).filter(
    lambda name: name.strip(" .") and name[0] != " "
)


@given(st.dictionaries(NAME, OWN, min_size=1, max_size=3), FILE_NAME)
def test_what_is_written_is_read_of_that_document_alone(joints, name):
    written = with_joints("kindsl.toml", "", f"{name}.kindsl", joints)
    assert written is not None and written.startswith("[[document]]\n")
    configuration = configuration_of("kindsl.toml", written)
    assert configuration.settings_for(f"{name}.kindsl").joints == joints
    assert not configuration.settings_for(f"{name}x.kindsl").joints


@pytest.mark.parametrize(("before", "between"), [("x = 1", "\n\n"), ("x = 1\n\n\n", "\n\n")])
def test_an_empty_line_stands_before_a_table(before, between):
    text = before.replace("x = 1", 'ignore = ["KD7"]')
    written = with_joints("kindsl.toml", text, "arm.kindsl", {"elbow": ELBOW})
    assert written is not None
    assert written.startswith(f'ignore = ["KD7"]{between}[[document]]')


@pytest.mark.parametrize(
    ("text", "document"), [("document = []\n", "arm.kindsl"), ("", " arm.kindsl")]
)
def test_a_file_that_takes_no_table_of_the_document_is_left_alone(text, document):
    assert with_joints("kindsl.toml", text, document, {"elbow": ELBOW}) is None


POSE = {"wrist": 0.5, "elbow": -1.25}


@pytest.mark.parametrize(
    ("before", "header"),
    [
        ("", '[[document]]\npath = "arm.kindsl"\n[document.poses.stand]\n'),
        ("[joints.wrist]\nmax = 3.0\n", "\n[document.poses.stand]\n"),
        ('[[document]]\npath = "arm.kindsl"\n\n\n', '"arm.kindsl"\n\n[document.poses.stand]\n'),
        ('[[document]]\npath = "leg.kindsl"\n', 'path = "arm.kindsl"\n[document.poses.stand]\n'),
        ('[[document]]\npath = "arm.kindsl"\n[poses.sit]\nwrist = 1.0', "\n[document.poses.stand]"),
        ("[poses.stand]\nwrist = 1.0\n", "\n[document.poses.stand]\n"),
    ],
)
def test_a_pose_is_added_behind_what_is_told(tmp_path, before, header):
    file, document = str(tmp_path / "kindsl.toml"), str(tmp_path / "arm.kindsl")
    old = configuration_of(file, before).settings_for(document)
    written = with_pose(file, before, document, "stand", POSE)
    assert written is not None
    assert written.startswith(before.rstrip("\n")) and header in written
    new = configuration_of(file, written)
    assert new.settings_for(document) == old._replace(poses={**old.poses, "stand": POSE})
    leg = str(tmp_path / "leg.kindsl")
    assert new.settings_for(leg) == configuration_of(file, before).settings_for(leg)
    again = with_pose(file, written, document, "stand", {"wrist": 2.0})
    assert again is not None and len(again) < len(written)
    assert configuration_of(file, again).settings_for(document).poses["stand"] == {"wrist": 2.0}


def test_a_pose_that_is_told_is_replaced_with_its_comments_left(tmp_path):
    file, document = str(tmp_path / "kindsl.toml"), str(tmp_path / "arm.kindsl")
    head = '[[document]]\npath = "arm.kindsl"\n[document.poses.stand] # low\n'
    tail = '\n[[document]]\npath = "leg.kindsl"\n# the end\n'
    text = f"{head}wrist = 1.0  # measured\nhip = 2.0\n{tail}"
    written = with_pose(file, text, document, "stand", POSE)
    assert written == f"{head}wrist = 0.5  # measured\nelbow = -1.25\n{tail}"


@pytest.mark.parametrize("name", ["a b", 'the "tall" one', "a\\b", "stand.2", "Übung", ""])
def test_any_name_is_a_key(tmp_path, name):
    file, document = str(tmp_path / "kindsl.toml"), str(tmp_path / "arm.kindsl")
    written = with_pose(file, "", document, name, POSE)
    assert written is not None
    assert configuration_of(file, written).settings_for(document).poses == {name: POSE}


def test_line_ends_stay_and_a_pyproject_keeps_its_table(tmp_path):
    document = str(tmp_path / "arm.kindsl")
    written = with_pose(
        str(tmp_path / "kindsl.toml"), "[parameters]\r\na = 1.0\r\n", document, "s", POSE
    )
    assert written is not None and "\n" not in written.replace("\r\n", "")
    project = with_pose(
        str(tmp_path / "pyproject.toml"),
        '[tool.kindsl]\ntarget = "robcogen"\n',
        document,
        "s",
        POSE,
    )
    assert project is not None and "[tool.kindsl.document.poses.s]" in project
