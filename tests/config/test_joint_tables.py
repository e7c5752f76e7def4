"""Tables of joints that are written into a configuration file."""

from kindsl.config.configuration_reading import configuration_of
from kindsl.config.joint_tables import with_joints
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
