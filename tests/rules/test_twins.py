import pytest

from kindsl.rules.inertia.twins import mirrored_name, part_name


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("LF_hip", "RF_hip"),
        ("LH_upperleg", "RH_upperleg"),
        ("left_arm", "right_arm"),
        ("armLeft", "armRight"),
        ("wheel_l", "wheel_r"),
        ("FL_thigh", "FR_thigh"),
        ("LeftFoot", "RightFoot"),
        ("RF_hip", None),
        ("lower", None),
        ("flange", None),
        ("link1", None),
    ],
)
def test_left_parts_have_right_twins(left: str, right: str | None) -> None:
    assert mirrored_name(left) == right


@pytest.mark.parametrize(
    "names",
    [("LF_hip", "RH_hip"), ("segment1", "segment_2"), ("rightUpperLeg", "left_upper_leg")],
)
def test_sides_and_numbers_do_not_make_another_part(names: tuple[str, str]) -> None:
    assert part_name(names[0]) == part_name(names[1])


def test_other_words_make_another_part() -> None:
    assert part_name("LF_hip") != part_name("LF_thigh")
