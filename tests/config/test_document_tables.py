"""Tables of joints that are written into a configuration file."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.config.configuration_reading import configuration_of
from kindsl.config.document_tables import with_joints
from kindsl.semantics.parameters import JointProperties

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
    ("text", "document"),
    [("document = []\n", "arm.kindsl"), ("", " arm.kindsl")],
)
def test_a_file_that_takes_no_table_of_the_document_is_left_alone(text, document):
    assert with_joints("kindsl.toml", text, document, {"elbow": ELBOW}) is None
