"""Limbs of a URDF that are attached otherwise than their counterparts."""

import pytest
from tests.analysis.test_urdf_in_place import joint, link, robot

from kindsl.judgement.analysis.analysis import analyse

LEGS = ("LF", "RF", "LH", "RH")


def legs() -> str:
    links = (link(f"{leg}_{part}") for leg in LEGS for part in ("hip", "thigh", "shank"))
    joints = (
        joint(f"{leg}_{name}", "base" if part == "hip" else f"{leg}_{above}", f"{leg}_{part}")
        for leg in LEGS
        for name, above, part in (
            ("HAA", "", "hip"), ("HFE", "hip", "thigh"), ("KFE", "thigh", "shank"),
        )
    )  # fmt: skip
    return robot(*links, *joints)


CARRIED = '<parent link="RF_thigh"/><child link="RF_shank"/>'
ELSEWHERE = CARRIED.replace("RF_thigh", "LF_thigh")
CROSSED = legs().replace("RF_HFE", "X").replace("RF_KFE", "RF_HFE").replace("X", "RF_KFE")


@pytest.mark.parametrize(
    ("text", "code", "place", "message"),
    [
        (
            legs().replace(CARRIED, ELSEWHERE),
            "KD208",
            "LF_thigh",
            "link 'RF_shank' is a child of 'LF_thigh', by its twins of 'RF_thigh'",
        ),
        (
            CROSSED,
            "KD209",
            "RF_KFE",
            "link 'RF_thigh' moves by joint 'RF_KFE', by its twins by 'RF_HFE'",
        ),
    ],
)
def test_links_attached_unlike_their_twins_are_told_at_the_name(
    text: str, code: str, place: str, message: str
) -> None:
    (found,) = (each for each in analyse(text).findings if each.code.startswith("KD2"))
    assert (found.code, found.message) == (code, message)
    assert text[found.start : found.end] == place
    assert found.related and all(text[r.start : r.end][:2] in LEGS for r in found.related)


def test_legs_that_are_alike_have_no_such_finding() -> None:
    assert [each.code for each in analyse(legs()).findings] == []


SEGMENT = 'ixx="5.44698e-05" ixy="-1.6668e-06" ixz="0" iyy="0.00010235" iyz="0" izz="9.79711e-05"'
PLACE = '<origin xyz="-0.0437798 0.000863947 0"/>'


def snake(tensor: str = SEGMENT, place: str = PLACE) -> str:
    """Return a row of links of which the third one is otherwise."""
    others = {3: (tensor, "0.140009", place)}
    usual = SEGMENT, "0.140009", PLACE
    links = (link(f"segment{n}", *others.get(n, usual)) for n in range(1, 6))
    above = ("base", *(f"segment{n}" for n in range(1, 6)))
    return robot(*links, *(joint(f"j{n}", above[n - 1], above[n]) for n in range(1, 6)))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("-1.6668e-06", "1.6668e-06", ["moments of 'segment3' differ from its twins"]),
        ("-0.0437798", "0.0437798", ["CoM of 'segment3' differs from its twins"]),
        ("0.000863947 0", "0 0.000863947", ["CoM of 'segment3' differs from its twins"]),
        ("-0.0437798", "-0.0437798", []),
    ],
)
def test_a_part_is_compared_with_its_like_in_a_row(old: str, new: str, told: list[str]) -> None:
    text = snake(SEGMENT.replace(old, new), PLACE.replace(old, new))
    found = analyse(text).findings
    assert [each.message for each in found] == told
    assert [(each.code, len(each.related)) for each in found] == [("KD509", 4)] * len(told)
    assert all("segment3" in text[: each.start].splitlines()[-2] for each in found)


def test_a_part_is_compared_beside_one_whose_inertia_is_explained() -> None:
    text = snake(place=PLACE.replace("-0.0437798", "0.0437798"))
    hand = link("hand", SEGMENT.replace("0.00010235", "0.0010235"), "0.140009", PLACE)
    wrist = joint("wrist", "segment5", "hand")
    found = analyse(text.replace("</robot>", f"{hand}{wrist}</robot>")).findings
    assert [each.code for each in found] == ["KD509", "KD302", "KD308"]
